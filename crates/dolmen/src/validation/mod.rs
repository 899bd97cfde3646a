//! Every number of others that this crate must reproduce: published beside computed, and where the published one is
//! wrong the right one beside it.

mod case;
mod choi_2021;
mod columns;
mod error;

pub use case::{Case, cases};
pub use choi_2021::naju_flagpole;
pub use error::ValidationError;
