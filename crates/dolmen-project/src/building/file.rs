//! The keys of a building: floors with the storey below each, damping, dampers, points.

use crate::file_number::{At, QuantityRaw};
use schemars::JsonSchema;

/// A corner in plan, [x, y].
type CornerRaw = Vec<At<QuantityRaw>>;

/// One floor, with the storey below it.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FloorRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// So many floors like this, one on the other; 1 if not given.
    pub(super) count: Option<At<i64>>,
    /// Mass; or weight.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Weight, a force; or mass.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Sides of a rectangle along x and y about the origin of the plan: [10, 8]. Or outline.
    pub(super) sides: Option<At<Vec<At<QuantityRaw>>>>,
    /// Corners in order: [[-5, -4], [5, -4], …]. Or sides.
    pub(super) outline: Option<At<Vec<At<CornerRaw>>>>,
    /// Centre of mass in plan, [x, y]; that of the area if not given.
    pub(super) centre: Option<At<Vec<At<QuantityRaw>>>>,
    /// Radius of gyration about the centre of mass; that of the area if not given.
    pub(super) gyration: Option<At<QuantityRaw>>,
    /// Moment of inertia about the centre of mass, in place of gyration.
    pub(super) inertia: Option<At<QuantityRaw>>,
    /// Height of the storey below it.
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// Walls and columns of the storey below it. Or stiffness.
    pub(super) walls: Option<At<Vec<At<WallRaw>>>>,
    /// Stiffness of the storey below it as a whole. Or walls.
    pub(super) stiffness: Option<At<StoreyStiffnessRaw>>,
}

/// A wall, column, core or brace in plan.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WallRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// Its place in plan.
    #[schemars(required)]
    pub(super) x: Option<At<QuantityRaw>>,
    /// Its place in plan.
    #[schemars(required)]
    pub(super) y: Option<At<QuantityRaw>>,
    /// Lateral stiffness along x, or along its own first axis if it is turned; 0 if not given.
    pub(super) stiffness_x: Option<At<QuantityRaw>>,
    /// Lateral stiffness along y, or along its own second axis; 0 if not given.
    pub(super) stiffness_y: Option<At<QuantityRaw>>,
    /// Its own stiffness against turning, a moment; 0 if not given: thin walls and columns.
    pub(super) stiffness_rotation: Option<At<QuantityRaw>>,
    /// How far it is turned from x, counterclockwise: "30 deg".
    pub(super) angle: Option<At<QuantityRaw>>,
}

/// Stiffness of a storey as a whole: x, y, rotation about a centre; or a matrix.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct StoreyStiffnessRaw {
    /// Lateral stiffness along x.
    pub(super) x: Option<At<QuantityRaw>>,
    /// Lateral stiffness along y.
    pub(super) y: Option<At<QuantityRaw>>,
    /// Stiffness against turning about the centre of rigidity, a moment.
    pub(super) rotation: Option<At<QuantityRaw>>,
    /// Centre of rigidity in plan, [x, y]; of a matrix the point that it is about.
    #[schemars(required)]
    pub(super) centre: Option<At<Vec<At<QuantityRaw>>>>,
    /// In place of x, y, rotation: stiffness against u, v, θ of the point centre, 3 × 3 in SI: N/m, N/rad, N·m/rad.
    pub(super) matrix: Option<At<Vec<Vec<f64>>>>,
}

/// How the modes of a building are damped: one of its keys.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DampingRaw {
    /// The same damping ratio for every mode.
    pub(super) ratio: Option<At<QuantityRaw>>,
    /// A damping ratio for each mode, lowest first; the last holds for all that follow.
    pub(super) ratios: Option<At<Vec<At<QuantityRaw>>>>,
    /// Mass and stiffness in proportion, with the ratios of two frequencies.
    pub(super) rayleigh: Option<At<Vec<At<AnchorRaw>>>>,
    /// Caughey's series through the ratios of the lowest modes.
    pub(super) caughey: Option<At<Vec<At<QuantityRaw>>>>,
}

/// A frequency with its damping ratio.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct AnchorRaw {
    /// The frequency.
    #[schemars(required)]
    pub(super) frequency: Option<At<QuantityRaw>>,
    /// The damping ratio there.
    #[schemars(required)]
    pub(super) ratio: Option<At<QuantityRaw>>,
}

/// A damper: a tuned mass or a liquid column on a floor, a dashpot between floors.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DamperRaw {
    /// "tmd", "tlcd", "tlcmd" or "link".
    #[schemars(required)]
    pub(super) kind: Option<At<DamperKindRaw>>,
    /// Its floor, from 1 at the bottom.
    #[schemars(required)]
    pub(super) floor: Option<At<i64>>,
    /// Its place in plan, [x, y].
    #[schemars(required)]
    pub(super) place: Option<At<Vec<At<QuantityRaw>>>>,
    /// "x", "y", or an angle from x ("30 deg").
    #[schemars(required)]
    pub(super) direction: Option<At<String>>,
    /// All of its mass, of a tlcd that of the liquid; or mass_ratio.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Its mass over the modal mass of its mode, the shape 1 at its place along its direction.
    pub(super) mass_ratio: Option<At<QuantityRaw>>,
    /// The mode that it is for, from 1; 1 if not given.
    pub(super) mode: Option<At<i64>>,
    /// Frequency on its own spring, of a tlcd that of the liquid; or frequency_ratio, length, or tuning.
    pub(super) frequency: Option<At<QuantityRaw>>,
    /// The same over the frequency of its mode.
    pub(super) frequency_ratio: Option<At<QuantityRaw>>,
    /// Damping ratio on its own frequency, c/(2 m ω); or tuning.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
    /// Frequency and damping ratio by a closed form from its mass ratio.
    pub(super) tuning: Option<At<TuningRaw>>,
    /// Room that it has to move, each way; a run that needs more is reported.
    pub(super) stroke: Option<At<QuantityRaw>>,
    /// Of a tmd: the masses that it is made of, their shares adding up to 1.
    pub(super) masses: Option<At<Vec<At<MassRaw>>>>,
    /// Of a tlcd or tlcmd: horizontal length of the column over its total length.
    pub(super) length_ratio: Option<At<QuantityRaw>>,
    /// Of a tlcd or tlcmd: total length L of the column, which sets the liquid's frequency √(2g/L)/2π.
    pub(super) length: Option<At<QuantityRaw>>,
    /// Of a tlcmd: the liquid's part of its mass.
    pub(super) liquid_share: Option<At<QuantityRaw>>,
    /// Of a tlcmd: the liquid's frequency; or length.
    pub(super) liquid_frequency: Option<At<QuantityRaw>>,
    /// Of a tlcmd: the liquid's damping ratio.
    pub(super) liquid_damping_ratio: Option<At<QuantityRaw>>,
    /// Of a tlcmd: room that the liquid has to rise and sink, each way.
    pub(super) liquid_stroke: Option<At<QuantityRaw>>,
    /// Of a link: force per velocity, "500 kN*s/m".
    pub(super) coefficient: Option<At<QuantityRaw>>,
    /// Of a link: floor of its other end, 0 for the ground; the floor below if not given.
    pub(super) to_floor: Option<At<i64>>,
    /// Of a link: place of its other end, [x, y]; under its own if not given.
    pub(super) to_place: Option<At<Vec<At<QuantityRaw>>>>,
}

/// One of several masses of a damper.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MassRaw {
    /// Its part of the damper's mass.
    #[schemars(required)]
    pub(super) share: Option<At<QuantityRaw>>,
    /// Its place in plan, [x, y]; that of the damper if not given.
    pub(super) place: Option<At<Vec<At<QuantityRaw>>>>,
    /// Its frequency; that of the damper if not given.
    pub(super) frequency: Option<At<QuantityRaw>>,
    /// The same over the frequency of the damper's mode.
    pub(super) frequency_ratio: Option<At<QuantityRaw>>,
    /// Its damping ratio; that of the damper if not given.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
}

/// What a damper is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum DamperKindRaw {
    /// A mass on a spring and a dashpot.
    Tmd,
    /// Liquid in a U-shaped tube.
    Tlcd,
    /// Such a tube on a spring and a dashpot.
    Tlcmd,
    /// A dashpot to another floor or the ground.
    Link,
}

/// A closed form of tuning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(super) enum TuningRaw {
    /// Least peak under a harmonic force, undamped structure.
    DenHartog,
    /// The same exactly.
    NishiharaAsami,
    /// Least variance under a white force.
    WarburtonForce,
    /// Least variance under a white base acceleration.
    WarburtonBase,
    /// Least peak under a harmonic base acceleration.
    WarburtonBaseHarmonic,
    /// Both modes that it makes of one equally damped.
    Sadek,
    /// In resonance, the mean damping of both modes.
    Villaverde,
    /// As Hwang, Min & Hong print it, on the damper's own frequency.
    HwangMinHong,
}

/// A point of a floor whose motion is reported.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WatchedRaw {
    /// What it is called.
    #[schemars(required)]
    pub(super) name: Option<At<String>>,
    /// Its floor, from 1 at the bottom.
    #[schemars(required)]
    pub(super) floor: Option<At<i64>>,
    /// Its place in plan, [x, y].
    #[schemars(required)]
    pub(super) place: Option<At<Vec<At<QuantityRaw>>>>,
}
