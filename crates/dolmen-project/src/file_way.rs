//! The keys of directions.

use schemars::JsonSchema;

/// A direction: "x", "-y", "z", or a vector.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(extend("x-must-be" = "\"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" or three numbers"))]
pub(super) enum WayRaw {
    Axis(String),
    Vector(Vec<f64>),
}
