//! Figures as SVG: text stays text, units on every axis, readable by the colour-blind and in grey print.

mod assess;
mod axis;
mod chain;
mod chain_histories;
mod demand;
mod frame;
mod frame_histories;
mod identification;
mod ink;
mod modal;
mod motion;
mod plot;
mod scene;
mod shapes;
mod stack;
mod stack_directions;
mod stack_histories;
mod stack_limits;
mod stack_view;

pub use assess::{VariantDot, load_factor_distribution, variants_compared};
pub use chain::{centroid_effect, chain_elevation, stiffness_limits};
pub use chain_histories::chain_histories;
pub use demand::design_spectrum;
pub use frame::frame_sketch;
pub use frame_histories::frame_histories;
pub use identification::{Figure, identification};
pub(crate) use identification::{letter, measured_modes, solution_shapes};
pub use modal::{sensor_shapes, singular_values, stabilization};
pub use motion::motion_figures;
pub use shapes::{ShapePanel, mode_shapes};
pub use stack::{stack_after, stack_view};
pub use stack_directions::stack_directions;
pub use stack_histories::stack_histories;
pub(crate) use stack_limits::above_words;
pub use stack_limits::{stack_capacity, stack_governing};
