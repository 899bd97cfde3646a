//! The keys of the table `[limits]`.

use crate::file_number::{At, NumberRaw};
use schemars::JsonSchema;

/// The code of a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(crate) enum LimitCodeRaw {
    /// Korea, buildings.
    #[serde(rename = "KDS 41 17 00")]
    Kds41,
    /// Eurocode 8.
    #[serde(rename = "EN 1998-1")]
    Eurocode8,
}

/// Seismic grade or importance class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(crate) enum ImportanceRaw {
    /// KDS 41 17 00: 1.0 %.
    #[serde(rename = "special")]
    Special,
    /// KDS 41 17 00: 1.5 %; EN 1998-1.
    I,
    /// KDS 41 17 00: 2.0 %; EN 1998-1.
    #[serde(rename = "II")]
    Ii,
    /// EN 1998-1.
    #[serde(rename = "III")]
    Iii,
    /// EN 1998-1.
    #[serde(rename = "IV")]
    Iv,
}

/// Non-structural elements of EN 1998-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum NonStructuralRaw {
    /// 0.5 % on ν d_r.
    Brittle,
    /// 0.75 %.
    Ductile,
    /// 1.0 %.
    None,
}

/// kind = "frame" or "building": how far its storeys may drift under the design earthquake.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LimitsRaw {
    /// The code whose allowable drift holds; or storey_drift.
    pub(super) code: Option<At<LimitCodeRaw>>,
    /// KDS 41 17 00: seismic grade "special", "I" or "II"; EN 1998-1: importance class "I" to "IV".
    pub(super) importance: Option<At<ImportanceRaw>>,
    /// EN 1998-1: what could break first; "brittle" if not given.
    pub(super) non_structural: Option<At<NonStructuralRaw>>,
    /// Allowable drift over the height of the storey, "1.5 %" or "1/67"; or code.
    pub(super) storey_drift: Option<At<NumberRaw>>,
    /// Where storey_drift comes from.
    pub(super) source: Option<At<String>>,
}
