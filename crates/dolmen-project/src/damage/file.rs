//! The keys of a damage's effect on the model.

use crate::file_number::At;
use schemars::JsonSchema;

/// The side of a bed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(crate) enum SideRaw {
    /// Towards x.
    #[serde(rename = "x+")]
    XPlus,
    /// Away from x.
    #[serde(rename = "x-")]
    XMinus,
    /// Towards y.
    #[serde(rename = "y+")]
    YPlus,
    /// Away from y.
    #[serde(rename = "y-")]
    YMinus,
}

/// What a damage means for the model: one of these.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct InModelRaw {
    /// kind = "stack" or "chain": share of the width of the bed below the part that no longer bears, 0.2 for a fifth.
    pub(crate) bed_lost: Option<At<f64>>,
    /// The side from which it is lost, with bed_lost: "x+", "x-", "y+" or "y-".
    pub(crate) side: Option<At<SideRaw>>,
    /// kind = "chain", "frame" or "stack": what is left of the stiffness of the joint below the link or stone, or of the storey, 0.7 for seven tenths.
    pub(crate) stiffness_left: Option<At<f64>>,
    /// kind = "stack": true where the dowels and clamps between the part and what it stands on are broken.
    pub(crate) ties_broken: Option<At<bool>>,
    /// kind = "stack": true where the part is gone.
    pub(crate) lost: Option<At<bool>>,
    /// true where what an earlier inspection said of the model was mended since.
    pub(crate) mended: Option<At<bool>>,
}
