//! Chains as they are written.

use crate::file_number::{At, QuantityRaw};
use schemars::JsonSchema;

/// One rigid link.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LinkRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// Weight, a force; or mass.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Mass; or weight.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Length from joint to joint.
    #[schemars(required)]
    pub(super) length: Option<At<QuantityRaw>>,
    /// Height of the centre of mass above the link's lower joint.
    #[schemars(required)]
    pub(super) centroid: Option<At<QuantityRaw>>,
    /// Moment of inertia about the centre of mass; that of a thin rod if neither it nor breadth is given.
    pub(super) inertia: Option<At<QuantityRaw>>,
    /// The same about the other horizontal axis, for motion across; that of inertia if neither it nor depth is given.
    pub(super) inertia_across: Option<At<QuantityRaw>>,
    /// Breadth in the direction of motion: the inertia is then that of a box.
    pub(super) breadth: Option<At<QuantityRaw>>,
    /// Breadth across the direction of motion; that of breadth if not given.
    pub(super) depth: Option<At<QuantityRaw>>,
    /// Width of the bed below it in the direction of motion: for the uplift limit of its lower joint.
    pub(super) bed_width: Option<At<QuantityRaw>>,
}

/// The joint below a link.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct JointRaw {
    /// Rotational stiffness.
    #[schemars(required)]
    pub(super) stiffness: Option<At<QuantityRaw>>,
    /// Rotational stiffness across the direction of motion; if not given that of stiffness, on a rectangular bed less by its sides.
    pub(super) stiffness_across: Option<At<QuantityRaw>>,
    /// Rotational dashpot.
    pub(super) damping: Option<At<QuantityRaw>>,
    /// Width of the bed in the direction of motion; the same as bed_width of the link above it.
    pub(super) bed_width: Option<At<QuantityRaw>>,
    /// Width of the bed across the direction of motion; that of bed_width if not given. It makes the pole one of two directions.
    pub(super) bed_depth: Option<At<QuantityRaw>>,
    /// Compressive strength of the bed: the moment at which it stands on its edge is then N (b/2 - N/(2 f w)).
    pub(super) strength: Option<At<QuantityRaw>>,
    /// For `dolmen simulate`: "edge", at most half the width of its bed times the weight above it; "held", any moment. Without it "edge"
    /// where bed_width is known.
    pub(super) opening: Option<At<OpeningRaw>>,
    /// Moment of dry friction beside the spring, while the joint turns: for `dolmen simulate`.
    pub(super) friction_moment: Option<At<QuantityRaw>>,
    /// The same before it turns; that of friction_moment without it.
    pub(super) static_friction_moment: Option<At<QuantityRaw>>,
}

/// The stone of the links.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StoneRaw {
    /// Young's modulus: a stress.
    #[schemars(required)]
    pub(super) elastic_modulus: Option<At<QuantityRaw>>,
    /// Poisson's ratio, 0 to 0.5.
    #[schemars(required)]
    pub(super) poisson_ratio: Option<At<QuantityRaw>>,
    /// Density: with the weight of a link it gives its volume.
    #[schemars(required)]
    pub(super) density: Option<At<QuantityRaw>>,
}

/// Whether a joint opens.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum OpeningRaw {
    /// At the edge of its bed.
    Edge,
    /// Never.
    Held,
}

/// Whether the part at the very top is among the links.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(crate) enum CapRaw {
    /// There is none, or it is among the links.
    #[serde(rename = "included")]
    Included,
    /// It is left out: unconservative, and every result says so.
    #[serde(rename = "left out")]
    LeftOut,
}
