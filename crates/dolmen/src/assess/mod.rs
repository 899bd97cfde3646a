//! Assessment: whole checks, sensitivities, probabilities.

mod capacity;
mod chain;
mod change;
mod damage;
pub mod demand;
mod error;
mod first_motion;
mod fragility;
mod frame;
mod intensity;
mod kinetic_friction;
mod least_motion;
mod least_pressed;
mod loads_on_soil;
mod one_stone;
mod only_corners;
mod portfolio;
mod probability;
mod risk;
mod score;
mod sensitivity;
mod settle_run;
mod stack;
mod stack_notes;
mod stack_on_soil;
mod stack_under_loads;
mod sufficiency;
mod trends;

pub use capacity::{
    Capacity, Reached, Reading, ScaleTrial, Trial, capacity, next_in_bracket, reached_quantile,
};
pub use chain::{
    CENTROID_CHANGE, ChainAcross, ChainCheck, JointOnSoil, LoadedChain, StiffnessTaken, centroid_effect,
    check_chain, check_chain_across,
};
pub use change::{
    ChangeNote, Difference, Evidence, ExchangedDirections, FACTOR_SOUGHT, FittedTemperature, FrequencyChange,
    HistoryEffect, ModeChange, NotCompared, PartFit, SurveyChange, SurveyChangeOptions, Surveyed,
    SwappedChannels, TEMPERATURE_SURVEYS_LEAST, TemperatureEffect, TemperatureKnowledge, TurnedChannel,
    WhichPart, survey_change, which_part,
};
pub use damage::{DamageState, DamageThresholds, JointDamage, StackDamage, stack_damage};
pub use error::AssessError;
pub use first_motion::first_motion_beside;
pub use fragility::{
    Crossing, Fragility, FragilityBand, FragilityBound, FragilityFit, Observation, OfSamples, ScatterSplit,
    bootstrap_fragility, bootstrap_fragility_of_motions, crossing, fit_fragility, fit_fragility_by_moments,
    fit_fragility_of_motions, motions_needed, scatter_split,
};
pub use frame::{FrameCheck, FrameNote, check_frame};
pub use intensity::{RockingScale, rocking_scale};
pub use least_pressed::LeastPressed;
pub use one_stone::{OneStoneCheck, check_one_stone};
pub use portfolio::{Candidate, Known, KnownCapacity, Place, Ranked, RankedBy, rank};
pub use probability::{Distribution, Probability, probability, sampled};
pub use risk::{AnnualRisk, Hazard, annual_risk};
pub use score::{
    CapacityGiven, EffectVerdict, Factor, FactorEffect, FactorShare, FactorShares, HeldOut, OutsideFactor,
    PagodaScore, Ranking, ScoreModel, SixFactors, StiffnessDesign, StiffnessDraws, StiffnessEffect,
    SurfaceSettings, TrainedDesign, Unlike, UnlikeQuantity, factor_shares, held_out, shapley_shares,
    unlike_trained,
};
pub use sensitivity::{CentroidEffect, NoElasticity, Sensitivity, elasticity};
pub use settle_run::with_settle_run;
pub use stack::{
    Crushing, MARGINAL_BELOW_G, StackCheck, StackCheckOptions, check_stack, check_stack_with_gaps,
};
pub use stack_notes::{Gaps, SettleRun, StackNote};
pub use stack_under_loads::{Grows, StackCombination, StackUnderLoads, StackWind, stack_under_loads};
pub use sufficiency::{SUFFICIENCY_MOTIONS_LEAST, Sufficiency, sufficiency};
pub use trends::{Direction, Trend, trend};
