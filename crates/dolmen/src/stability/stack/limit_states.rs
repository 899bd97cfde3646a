//! The limits of a stack, cut by cut.

use super::half_plane::HalfPlane;
use super::{Cut, Standing, Threshold};
use crate::stability::{StabilityError, Verdict};
use crate::structure::stack::Polygon;

/// Tipping over one edge of a contact, or over the line within it at which the stone crushes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeLimit {
    /// A point of the axis of rotation, m.
    pub pivot_m: [f64; 3],
    /// Unit vector along the axis, m.
    pub axis: [f64; 3],
    /// Distance from the static resultant to the axis, in the plane of the joint, m; negative if the resultant lies beyond.
    pub distance_m: f64,
    /// Height of the centroid above the axis, m.
    pub height_m: f64,
    /// Acceleration at which the part turns about it.
    pub uplift: Threshold,
}

/// Limits of the part above one cut.
#[derive(Clone, Debug, PartialEq)]
pub struct CutLimits {
    /// The blocks above and the joints below them.
    pub cut: Cut,
    /// The bodies below, in words: "'body 1'", "the ground".
    pub above: String,
    /// Weight of the blocks above, including vertical acceleration, N.
    pub weight_n: f64,
    /// Their centroid, m.
    pub centroid_m: [f64; 3],
    /// Origin of the contact's plane, m.
    pub origin_m: [f64; 3],
    /// Unit vectors of the plane: two in it, then its normal, upwards.
    pub axes: [[f64; 3]; 3],
    /// Convex hull of the patches, in that plane, m.
    pub contact: Polygon,
    /// Point where the resultant of weight and static loads crosses the plane, in its coordinates, m.
    pub resultant_m: [f64; 2],
    /// Its distance from the nearest edge of the contact, m; negative outside.
    pub depth_m: f64,
    /// The smaller of two margins: the remaining share of the way from the contact's centroid to the edge, 1 for a centred resultant, 0 at the
    /// edge; and that of friction, 1 without shear, 0 at sliding.
    pub gravity_margin: f64,
    /// Every axis about which it can tip; empty if it does not stand.
    pub edges: Vec<EdgeLimit>,
    /// Distance from the edge of the contact of the axis about which it tips first, because the edge crushes, m; `None` without a strength, or
    /// if it does not stand.
    pub crushed_m: Option<f64>,
    /// First tipping, without ties. `None` if it does not stand.
    pub uplift: Option<Threshold>,
    /// Tipping with every tie of the cut pulling at its strength.
    pub uplift_with_ties: Option<Threshold>,
    /// Sliding against friction and cohesion. `None` if it does not stand.
    pub sliding: Option<Threshold>,
    /// Sliding against friction, cohesion and the shear strength of every tie.
    pub sliding_with_ties: Option<Threshold>,
    /// Whether it stands without shaking.
    pub standing: Standing,
    pub(super) tipping: Vec<HalfPlane>,
}

impl CutLimits {
    /// Acceleration at which it tips under shaking in one direction (that of inertia forces), m/s²; `None` if it does not stand.
    ///
    /// ```text
    /// a(u) = min over lines with l·u > 0 of s / (l·u)
    /// ```
    ///
    /// # Errors
    /// [`StabilityError::Direction`] unless the direction has a length.
    ///
    /// # Limits
    /// With a compressive strength the limit is a curve; chords of it are used, which are never too high, and on a square contact at most 1 %
    /// too low.
    pub fn uplift_in_m_s2(&self, direction: [f64; 2]) -> Result<Option<f64>, StabilityError> {
        let length = direction[0].hypot(direction[1]);
        if !(length > 0.0 && length.is_finite()) {
            return Err(StabilityError::Direction {
                quantity: "direction of shaking",
                given: direction,
            });
        }
        if self.uplift.is_none() {
            return Ok(None);
        }
        let unit = [direction[0] / length, direction[1] / length];
        let reached = self.tipping.iter().map(|half_plane| half_plane.along(unit));
        Ok(Some(reached.fold(f64::INFINITY, f64::min)))
    }
}

/// The first motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum LimitKind {
    /// A joint opens: the part above rocks.
    Uplift,
    /// The part above slides.
    Sliding,
}

/// The first motion, its place and acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Governing {
    /// Uplift or sliding.
    pub kind: LimitKind,
    /// Index of the cut in [`StackLimitStates::cuts`].
    pub cut: usize,
    /// Its acceleration and direction.
    pub threshold: Threshold,
}

/// The limits of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackLimitStates {
    /// Cut by cut, lowest first.
    pub cuts: Vec<CutLimits>,
    /// Whether it stands without shaking: the worst of all cuts.
    pub standing: Standing,
    /// Smallest [`CutLimits::gravity_margin`]; `None` without a cut.
    pub gravity_margin: Option<f64>,
    /// stable, marginal, unstable, without shaking; unknown if it seems to stand but is not statically determinate.
    pub verdict: Verdict,
    /// First uplift of all cuts; `None` if the stack does not stand. An upper bound unless statically determinate.
    pub uplift: Option<Governing>,
    /// First sliding of all cuts; `None` if the stack does not stand. An upper bound unless statically determinate.
    pub sliding: Option<Governing>,
    /// The first of both; `None` if the stack does not stand, or is not statically determinate: these cuts then do not show what governs.
    pub governing: Option<Governing>,
    /// The first of both with ties at their strength, under the same conditions.
    pub governing_with_ties: Option<Governing>,
    /// Factor of a rotating soil on every threshold: 1 − W h / K, 1 on rigid ground.
    pub soil_factor: f64,
    /// Horizontal acceleration added to every part by the soil's rotation under static loads, m/s².
    pub soil_offset_m_s2: [f64; 2],
    /// Groups of blocks on joints of different planes, which are not judged here.
    pub undecided: Vec<Vec<usize>>,
    /// Whether equilibrium alone gives the force in each joint. If not, every threshold here is an upper bound, and
    /// a limit analysis decides.
    pub statically_determinate: bool,
}
