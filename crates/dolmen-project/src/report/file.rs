//! The keys of the report's own contents, which Dolmen does not compute.

use crate::file_names::NamesRaw;
use crate::file_number::{At, QuantityRaw};
use schemars::JsonSchema;

/// What a report says beside the computation: given by the engineer, never computed. Every text is text, or { en = "…", ko = "…" }.
#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ReportRaw {
    /// Title of the report.
    pub(super) title: Option<At<NamesRaw>>,
    /// Number of the document.
    pub(super) number: Option<At<NamesRaw>>,
    /// For whom it is made.
    pub(super) client: Option<At<NamesRaw>>,
    /// Who makes it.
    pub(super) organisation: Option<At<NamesRaw>>,
    /// Address of the organisation.
    pub(super) address: Option<At<NamesRaw>>,
    /// Date of the report: "2026-11-23"; --date goes before it.
    pub(super) date: Option<At<String>>,
    /// Who took part, each with a row to sign in.
    pub(super) authors: Option<Vec<At<AuthorRaw>>>,
    /// What it is for.
    pub(super) purpose: Option<At<NamesRaw>>,
    /// Where the structure stands.
    pub(super) location: Option<At<LocationRaw>>,
    /// Photographs; the first stands on the cover.
    pub(super) photos: Option<Vec<At<PhotoRaw>>>,
    /// Drawings, as images.
    pub(super) drawings: Option<Vec<At<PhotoRaw>>>,
    /// Tests on stone or timber that break nothing.
    pub(super) material_tests: Option<Vec<At<MaterialTestRaw>>>,
    /// Sensors with which the surveys were made.
    pub(super) sensors: Option<Vec<At<SensorRaw>>>,
    /// What the engineer holds of it: a paragraph each.
    pub(super) opinion: Option<Vec<At<NamesRaw>>>,
    /// What should be done: a point each.
    pub(super) recommendations: Option<Vec<At<NamesRaw>>>,
    /// How it is looked after: a point each.
    pub(super) maintenance: Option<Vec<At<NamesRaw>>>,
    /// The grade that the engineer gives.
    pub(super) grade: Option<At<GradeRaw>>,
}

/// Who took part.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AuthorRaw {
    /// Name.
    #[schemars(required)]
    pub(super) name: Option<At<NamesRaw>>,
    /// What for: "engineer in charge".
    pub(super) role: Option<At<NamesRaw>>,
    /// Qualification and number of the licence.
    pub(super) licence: Option<At<NamesRaw>>,
}

/// Where the structure stands.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LocationRaw {
    /// Address.
    pub(super) address: Option<At<NamesRaw>>,
    /// Latitude, degrees, north positive; needs longitude.
    pub(super) latitude: Option<At<f64>>,
    /// Longitude, degrees, east positive; needs latitude.
    pub(super) longitude: Option<At<f64>>,
}

/// A photograph or drawing.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PhotoRaw {
    /// JPEG or PNG, relative to the project file.
    #[schemars(required)]
    pub(super) file: Option<At<String>>,
    /// What it shows.
    pub(super) caption: Option<At<NamesRaw>>,
    /// The part that it shows, by its name.
    pub(super) of: Option<At<String>>,
}

/// How material is tested.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum MaterialMethodRaw {
    /// Velocity of ultrasonic pulses.
    Ultrasonic,
    /// Rebound of a hammer.
    Rebound,
}

/// One test of material.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MaterialTestRaw {
    /// "ultrasonic" or "rebound".
    #[schemars(required)]
    pub(super) method: Option<At<MaterialMethodRaw>>,
    /// The part that was tested, by its name.
    pub(super) part: Option<At<String>>,
    /// Day of the test: "2026-04-02".
    pub(super) date: Option<At<String>>,
    /// method = "ultrasonic": velocity of the pulse, m/s.
    pub(super) velocity_m_s: Option<At<f64>>,
    /// method = "rebound": mean rebound number.
    pub(super) rebound_number: Option<At<f64>>,
    /// Compressive strength that the tester derived from it.
    pub(super) strength: Option<At<QuantityRaw>>,
    /// Anything to add.
    pub(super) note: Option<At<NamesRaw>>,
}

/// A sensor.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SensorRaw {
    /// What it is: "accelerometer".
    #[schemars(required)]
    pub(super) name: Option<At<NamesRaw>>,
    /// Maker and model.
    pub(super) model: Option<At<NamesRaw>>,
    /// Serial number.
    pub(super) serial: Option<At<NamesRaw>>,
    /// Day of its calibration: "2026-01-15".
    pub(super) calibrated: Option<At<String>>,
    /// Number of the certificate, or who calibrated it.
    pub(super) certificate: Option<At<NamesRaw>>,
}

/// A grade.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct GradeRaw {
    /// "A" to "F" of the Korean periodic inspection, or a word of the scale given.
    #[schemars(required)]
    pub(super) value: Option<At<NamesRaw>>,
    /// The scale; the Korean periodic inspection (A to F) if not given.
    pub(super) scale: Option<At<NamesRaw>>,
    /// Why.
    #[schemars(required)]
    pub(super) reason: Option<At<NamesRaw>>,
}
