//! The keys of the table `[watch]`.

use crate::file_names::NamesRaw;
use crate::file_number::{At, NumberRaw};
use schemars::JsonSchema;
use std::collections::BTreeMap;

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
    /// What loggers read, by name: tilts, cracks, temperature.
    pub(super) log: Option<BTreeMap<String, At<LogRaw>>>,
}

/// A column of a logger's file.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LogRaw {
    /// Its file, TOA5 or CSV, relative to the project file: a time and values in each row.
    #[schemars(required)]
    pub(super) file: Option<At<String>>,
    /// What it reads.
    #[schemars(required)]
    pub(super) kind: Option<At<LogKindRaw>>,
    /// The column; needed where the file has several.
    pub(super) column: Option<At<String>>,
    /// The unit of the readings: "deg", "mm/m", "mm"; "°C" of a temperature if not given.
    pub(super) unit: Option<At<String>>,
    /// Of a tilt, the direction in which it leans where the reading grows.
    pub(super) direction: Option<At<String>>,
    /// What the structure has when the sensor reads 0: a tilt as "1/300", a width as "0.4 mm".
    pub(super) zero: Option<At<NumberRaw>>,
    /// What must not be reached: a tilt as "1/150", a width as "2 mm"; of a tilt with zero, tilt_limit if not given.
    pub(super) limit: Option<At<NumberRaw>>,
    /// What it is called.
    pub(super) label: Option<NamesRaw>,
}

/// What a logger reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum LogKindRaw {
    /// A tilt.
    Tilt,
    /// The width of a crack or joint, growing as it opens.
    Crack,
    /// Temperature: explains the others, and is that of surveys that have none.
    Temperature,
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
