//! Stacks of stone: the joint that first opens or slides and its horizontal acceleration, thrust line, pressure.

mod blown;
mod chosen_toes;
mod contact;
mod cut_resistances;
mod cuts;
mod demand;
mod dilatancy;
mod driving_loads;
mod footing;
mod half_plane;
mod held_friction;
mod limit_acts;
mod limit_along;
mod limit_analysis;
mod limit_build;
mod limit_mechanism;
mod limit_near;
mod limit_options;
mod limit_pieces;
mod limit_programme;
mod limit_pushes;
mod limit_region;
mod limit_states;
mod limit_toes;
mod load_factor;
mod loads;
mod local_mechanism;
mod mechanism;
mod moved_contacts;
mod moved_supports;
mod movement_path;
mod movement_programme;
mod on_soil;
mod part;
mod possible_force;
mod pressure;
mod resistance;
mod rocking;
mod stack_limits;
mod stack_limits_options;
mod standing;
mod support_movement;
mod threshold;
mod thrust_line;
mod toe;
#[cfg(test)]
mod towers;
mod undilated_beds;
mod upright_slip;

pub use blown::{BlownBlock, WindArea, WindSurfaces, blown_blocks};
pub use cut_resistances::{CutResistance, cut_resistances};
pub(crate) use cuts::is_statically_determinate;
pub use cuts::{Cut, Cuts, cuts};
pub use demand::{
    Comparison, DemandComparison, DemandVerdict, SpectralDemand, StackDemand, compare_with_demand,
};
pub(crate) use dilatancy::ROUNDS;
#[cfg(test)]
pub(crate) use dilatancy::without_upright_friction;
pub use dilatancy::{Undilated, limit_analysis_undilated};
pub(crate) use driving_loads::{driving_shaken, driving_under_growth};
pub(crate) use limit_along::stands_by_limit_analysis;
pub use limit_analysis::limit_analysis;
pub use limit_options::{
    Holding, LimitAnalysis, LimitAnalysisResult, LimitAnalysisStatus, Shaking, SwayingForces,
};
pub use limit_states::{CutLimits, EdgeLimit, FootingLimit, Governing, LimitKind, StackLimitStates};
pub use load_factor::{LoadFactor, SteadyLoads, growth, load_factor};
pub use loads::{PointForce, StackLoads, Wind};
pub use local_mechanism::{LocalMechanism, RigidPart, local_mechanism, local_mechanisms};
pub use mechanism::{JointMotion, Mechanism, MovingJoint};
pub use moved_supports::{
    MovedStack, MovedSupports, MovementEnding, SupportJump, SupportMovementOptions, SupportReaction,
};
pub(crate) use on_soil::{OnSoil, turned_at_rest};
pub use pressure::{JointPressure, no_tension_pressure};
pub use resistance::Resistance;
pub use rocking::{
    PeriodCaveat, PeriodOfThumb, RockingBlock, period_of_thumb, published_critical_slenderness_2a,
    published_critical_slenderness_3, published_rocking_frequency_hz, rocking_blocks,
};
pub use stack_limits::stack_limits;
pub use stack_limits_options::StackLimits;
pub use standing::Standing;
pub use support_movement::follow_support_movement;
pub use threshold::Threshold;
pub use thrust_line::{ThrustPlace, ThrustPoint, thrust_line};
pub(crate) use toe::{beyond, toe};
pub(crate) use upright_slip::{smoother_starts, without_sliding_friction};
