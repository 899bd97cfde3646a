//! Closed forms and published numbers in plain `f64`, without our types: references of tests, `dolmen validate`
//! and the docs. A mistake in a type cannot hide in such a reference.

mod bisection;
pub mod choi_2021;
pub mod columns;
pub mod displaced_centre;
pub mod dry_friction;
pub mod gap_spring;
pub mod hwang_min_hong;
pub mod liquid_column;
pub mod overturning;
pub mod park_min_2010;
pub mod pendulum;
pub mod rocking;
pub mod sliding;
pub mod tuned_mass;
pub mod twisting;

/// Standard acceleration of gravity, m/s² (3rd General Conference on Weights and Measures, 1901).
pub const STANDARD_GRAVITY_M_S2: f64 = 9.806_65;
