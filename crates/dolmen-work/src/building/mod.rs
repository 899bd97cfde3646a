//! Buildings: rigid floors on walls that sway and twist, and their dampers.

mod accidental;
mod answer;
pub(crate) mod check;
pub(crate) mod limits;
pub(crate) mod loads;
mod plan_answer;
pub(crate) mod simulate;
mod simulation;
mod site_spectrum;
pub(crate) mod stiffness;
pub(crate) mod study;
pub(crate) mod tune;
mod tune_answer;
mod tune_floors;
mod tune_room;
mod tune_together;
mod tuned;
pub(crate) mod wind;
mod wind_answer;
pub(crate) mod wind_history;
mod wind_history_answer;
mod wind_rows;
mod wind_seen;

pub use accidental::{AccidentalTorsion, DisplacedCentres};
pub use answer::{
    BuildingAnswer, BuildingSpectral, DampedSpectral, MINOR_RATIO, StandingBuilding, stiffness_word,
};
pub use plan_answer::{FromRecord, PlanAnswer, Written};
pub use simulation::{Against, BeyondRoom, BuildingSimulation, LargestDrift, WatchedPoint};
pub use tune::tune;
pub use tune_answer::{
    RoomCheck, RowRun, RowStroke, TogetherAnswer, TogetherChoice, TogetherRow, TuneAnswer, TuneLoad,
    TunePoint, TunedFloors,
};
pub use tuned::{TuneFloors, TuneOptions};
pub use wind_answer::{BuildingWind, FloorInWind, FloorMet, WIND_DURATION_S, WindAlong, WindMotion};
pub use wind_history_answer::{DriftInTime, HistoriesAlong, InTime, MotionInTime, Struck, WindSimulation};
