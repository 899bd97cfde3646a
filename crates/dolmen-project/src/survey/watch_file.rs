//! The table `[watch]` as written.

use crate::file_number::{At, NumberRaw};
use schemars::JsonSchema;

/// How many surveys are watched, for `dolmen watch`.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WatchRaw {
    /// Mean time between false alarms, years; 10 if not given.
    pub(super) years_between_false_alarms: Option<At<f64>>,
    /// Tilt that must not be reached: "1/150", a ratio, or text with a unit.
    pub(super) tilt_limit: Option<At<NumberRaw>>,
    /// What was done to the structure, or befell it.
    pub(super) works: Option<Vec<At<WorkRaw>>>,
}

/// Something that was done to the structure, or befell it.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WorkRaw {
    /// When: "2018", "2018-05" or "2018-05-10".
    #[schemars(required)]
    pub(super) date: Option<At<String>>,
    /// What.
    pub(super) what: Option<String>,
    /// Repairs begin a new level; repairs and inspections answer alarms.
    #[schemars(required)]
    pub(super) kind: Option<At<WorkKindRaw>>,
}

/// Of what kind a work is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum WorkKindRaw {
    /// The structure was changed on purpose.
    Repair,
    /// Somebody looked at it.
    Inspection,
    /// Sensors were exchanged or moved.
    Sensors,
    /// An earthquake, a storm, a collision.
    Event,
}
