//! Many runs at once, side by side in the lanes of the vector registers.

mod batch;
mod bodies;
mod joints;
mod lanes;
mod queue;
mod springs_many;
mod watches;

pub use queue::StackRun;
pub use springs_many::simulate_springs_many;
