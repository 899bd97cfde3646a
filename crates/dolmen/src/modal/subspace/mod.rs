//! Modes from stochastic subspaces: decompositions, poles of all orders, their standard deviations, and
//! clusters.

mod block_change;
mod block_hankel;
mod clusters;
mod decomposed;
mod hankel;
mod ssi;
mod ssi_options;
mod stabilization;
mod uncertainty;

pub(super) use block_change::Rows;
pub(super) use block_hankel::{BlockHankel, FuturePast};
pub use clusters::{Cluster, Clustering, Fate, clusters};
pub(super) use clusters::{group_poles, share_in_plane};
pub(super) use decomposed::{of_operator, of_product};
pub(super) use hankel::HANKEL_ROWS_MOST;
pub use ssi::{Pole, Subspace, ssi_cov, ssi_data};
pub(super) use ssi::{RANK_LEAST, check_ssi, poles_of, state, subspace};
pub use ssi_options::Ssi;
pub(super) use stabilization::{AllOrders, HALF_WIDTH_LEAST, judge_poles};
pub use stabilization::{Criteria, JudgedPole, Stability, Stabilization};
pub(super) use uncertainty::{
    Deviations, Order, correction, forward_substitute, frequency_and_damping, nearest,
};
pub use uncertainty::{PoleDeviation, Propagation};
