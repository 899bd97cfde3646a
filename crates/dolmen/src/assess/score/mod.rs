//! The six-factor score: capacity of a pagoda from six numbers, trained on simulated pagodas.

mod alike;
mod effects;
mod factors;
mod given;
mod held_out;
mod kriging;
mod model;
mod shapley;
mod shares;
mod stiffness;
mod surface;

pub use alike::{Unlike, UnlikeQuantity, unlike_trained};
pub use effects::{EffectVerdict, FactorEffect};
pub use factors::{Factor, SixFactors};
pub use given::{CapacityGiven, StiffnessDraws};
pub use held_out::{HeldOut, Ranking, held_out};
pub use kriging::SurfaceSettings;
pub use model::{OutsideFactor, PagodaScore, ScoreModel, TrainedDesign};
pub use shapley::shapley_shares;
pub use shares::{FactorShare, FactorShares, factor_shares};
pub use stiffness::{StiffnessDesign, StiffnessEffect};
