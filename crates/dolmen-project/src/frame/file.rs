//! Frames as they are written.

use crate::file_number::{At, OrUnknown, QuantityRaw};
use schemars::JsonSchema;

/// One storey.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StoreyRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// Mass at its top; or weight.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Weight at its top, a force; or mass.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Column height.
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// Axial force as axial says; from the masses if none is given; 0 leaves P-delta out.
    pub(super) axial_force: Option<At<QuantityRaw>>,
    /// Columns that stand free on foot stones, all alike.
    pub(super) columns: Option<At<ColumnsRaw>>,
}

/// Columns of a storey that stand free, as high as the storey: square, rectangular or round.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ColumnsRaw {
    /// How many; they share the axial force alike.
    #[schemars(required)]
    pub(super) count: Option<At<i64>>,
    /// Width of foot and head in the direction of motion; or diameter.
    pub(super) width: Option<At<QuantityRaw>>,
    /// Width across it, in a frame of one direction; that of width without it.
    pub(super) breadth: Option<At<QuantityRaw>>,
    /// Diameter of foot and head; or width.
    pub(super) diameter: Option<At<QuantityRaw>>,
    /// Pressure over indentation of what foot and head press on; rigid without it.
    pub(super) bed_stiffness: Option<At<QuantityRaw>>,
}

/// What axial_force is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum AxialRaw {
    /// The force in the columns of the storey: its own level and all above.
    Storey,
    /// The load added at its top.
    Level,
}

/// What the stiffness acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum ConventionRaw {
    /// The storey drift.
    Drift,
    /// The displacement relative to the ground.
    Grounded,
}

/// One horizontal direction of a frame.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DirectionRaw {
    /// Lateral stiffness of each storey, lowest first, "unknown", or "identified" from the modes of a survey; 0 where columns that stand free are all that holds it.
    #[schemars(required)]
    pub(super) stiffness: Option<At<OrUnknown<QuantityRaw>>>,
    /// The component of motions along it, "x" or "y"; that of its name without it.
    pub(super) along: Option<At<AlongRaw>>,
    /// Viscous damping, as a ratio, in every mode: for `dolmen simulate`.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
    /// Dry friction of the storeys: for `dolmen simulate`.
    pub(super) friction: Option<At<FrictionRaw>>,
    /// Tenons that bear only after a slack, beside stiffness and friction: for `dolmen check` and `dolmen simulate`.
    pub(super) tenons: Option<At<TenonsRaw>>,
}

/// A component of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum AlongRaw {
    /// x.
    X,
    /// y.
    Y,
}

/// Dry friction in a direction of a frame: a coefficient of the axial force, or a slip force for each storey.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct FrictionRaw {
    /// "coulomb" (a slider beside the spring; the default) or "jenkins" (a slider in series with part of the spring).
    pub(super) law: Option<At<FrictionLawRaw>>,
    /// Slip force over the axial force of the storey while it slips.
    pub(super) coefficient: Option<At<QuantityRaw>>,
    /// The same before it slips; that of coefficient without it.
    pub(super) static_coefficient: Option<At<QuantityRaw>>,
    /// Slip force of each storey, lowest first, in place of a coefficient.
    pub(super) force: Option<At<Vec<At<QuantityRaw>>>>,
    /// law = "jenkins": what is left of the stiffness of each storey while its slider slips, lowest first.
    pub(super) slipping_stiffness: Option<At<Vec<At<QuantityRaw>>>>,
    /// "drift" (the default), or "displacement" as eq. 11 of Park and Min (2010) is printed.
    pub(super) acts_on: Option<At<FrictionActsOnRaw>>,
}

/// Tenons with slack in a direction of a frame, all of a storey taken together.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct TenonsRaw {
    /// Rotation of the columns before the tenons bear, to either side, each storey, lowest first: 0.004, "4 mm/m".
    #[schemars(required)]
    pub(super) slack: Option<At<Vec<At<QuantityRaw>>>>,
    /// Stiffness of the tenons of each storey once they bear, beside that of the direction, lowest first; 0 for a storey without.
    #[schemars(required)]
    pub(super) stiffness: Option<At<Vec<At<QuantityRaw>>>>,
    /// Force at which the faces of the tenons of each storey crush, lowest first; without it they never do.
    pub(super) crushing_force: Option<At<Vec<At<QuantityRaw>>>>,
    /// Crushed depth, as drift, at which a face has half of its stiffness left; without it a face keeps all of it.
    pub(super) half_stiffness_depth: Option<At<QuantityRaw>>,
}

/// The law of a slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum FrictionLawRaw {
    /// Beside the storey's spring.
    Coulomb,
    /// In series with a spring of its own, beside the storey's.
    Jenkins,
}

/// What a slider acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum FrictionActsOnRaw {
    /// The storey drift.
    Drift,
    /// The displacement relative to the ground.
    Displacement,
}
