//! JSON without silent gaps: a number that is not finite is `null`, and the object that contains it says under `not_finite` which it is, and
//! whether it is infinite or not a number: `"margin": null, "not_finite": { "margin": "infinite" }`.
//!
//! `serde_json` alone writes both as `null`, the same as a value that is stated as absent.

mod object;
mod search;

pub use object::{JsonObject, json_value};
