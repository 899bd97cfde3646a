//! Dampers of structures: tuned masses and liquid columns, their tuning and placement.

mod assembled;
mod attached;
mod building_motion;
mod comparison;
mod damped_modes;
mod damped_spectrum;
mod damper_coupling;
mod damper_slopes;
mod design;
mod displaced_centres;
mod error;
mod floors;
mod goal_cost;
mod gust_history;
mod gust_motion;
mod gust_rms;
mod gust_row;
mod gust_strokes;
mod head_loss;
mod judged;
mod modal_synthesis;
mod plan;
mod position_map;
mod robustness;
mod single_damper;
mod single_mode;
mod site;
mod together;
mod tuning;

pub use assembled::DampedSystem;
pub use attached::{AttachedDamper, DamperKind};
pub use building_motion::damped_building_history;
pub use comparison::{Choice, Compared, Comparison, ComparisonOptions, TuningRow, compare};
pub use damped_modes::{DampedMode, damped_modes, lowest_seen};
pub use damped_spectrum::{DampedSpectralAnalysis, damped_spectral_analysis};
pub use design::{Design, DesignEnd, DesignOptions, Freedom, Goal, Place, design};
pub use displaced_centres::{DisplacedBuilding, DisplacedCase, displaced_responses};
pub use error::DamperError;
pub use floors::{FloorComparison, FloorDesign, FloorSite, compare_floors};
pub use goal_cost::{goal_cost, point_values};
pub use gust_history::{GustHistory, gust_history, gust_times};
pub use gust_motion::{GustMotion, GustPeak, gust_motion};
pub use gust_row::{GustQuantity, GustRow};
pub use head_loss::{
    ColumnHistory, ColumnRun, EquivalentColumn, HeadLossColumn, equivalent_column, simulate_column,
};
pub use judged::{Judged, judge};
pub use modal_synthesis::ModalSynthesis;
pub use plan::{DamperProblem, Plan, PlanOptions};
pub use position_map::{MapCell, MapTuning, PositionMap, PositionMapOptions, position_map};
pub use robustness::{Detuned, RobustnessPoint, robustness};
pub use single_mode::{Aim, OptimalTuning, SingleMode, optimal_tuning};
pub use site::{DamperSite, PlacedDamper};
pub use together::{Together, TogetherOptions, cost_of, tune_together};
pub use tuning::{ColumnAsMass, Tuning, TuningRule, rule_tuning};
