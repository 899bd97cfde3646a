//! Closed forms and published numbers in plain `f64`, with none of our types: what tests, `dolmen validate` and
//! the docs compare with, so that a mistake in a type cannot hide in the reference.

mod bisection;
pub mod choi_2021;
pub mod columns;
pub mod dry_friction;
pub mod overturning;
pub mod park_min_2010;
pub mod pendulum;
pub mod rocking;
pub mod sliding;
pub mod twisting;
