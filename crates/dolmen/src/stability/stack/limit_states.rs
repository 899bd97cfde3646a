//! Limit states of a stack: tipping and sliding of the part above each cut.

use super::half_plane::HalfPlane;
use super::{Cut, Standing, Threshold};
use crate::stability::{StabilityError, Verdict};
use crate::structure::stack::Polygon;

/// Tipping about one edge of a contact, or about the line inside the contact at which the stone crushes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeLimit {
    /// A point of the axis of rotation, m.
    pub pivot_m: [f64; 3],
    /// Unit vector along the axis.
    pub axis: [f64; 3],
    /// Distance from the static resultant to the axis, in the plane of the joint, m; negative if the resultant lies beyond.
    pub distance_m: f64,
    /// Height of the centroid above the axis, m.
    pub height_m: f64,
    /// Acceleration at which the part tips about this axis.
    pub uplift: Threshold,
}

/// Limit states of the part above one cut.
#[derive(Clone, Debug, PartialEq)]
pub struct CutLimits {
    /// The blocks above the cut and the joints below them.
    pub cut: Cut,
    /// The bodies below the cut, in words: "'body 1'", "the ground".
    pub above: String,
    /// Weight of the blocks above, including vertical acceleration, N.
    pub weight_n: f64,
    /// Force of weight and static loads that presses on the joint, N.
    pub normal_n: f64,
    /// Centroid of the blocks above, m.
    pub centroid_m: [f64; 3],
    /// Origin of the plane of the contact, m.
    pub origin_m: [f64; 3],
    /// Unit vectors of the plane: two in the plane, then its upward normal.
    pub axes: [[f64; 3]; 3],
    /// Convex hull of the contact patches, in the plane, m.
    pub contact: Polygon,
    /// Area of the contact patches, m²: the hull of two posts or of a ring is larger.
    pub area_m2: f64,
    /// Point where the resultant of weight and static loads crosses the plane, in coordinates of the plane, m.
    pub resultant_m: [f64; 2],
    /// Distance from this point to the nearest edge of the contact, m; negative outside.
    pub depth_m: f64,
    /// The smaller of two margins. The margin of the resultant is 1 at the centroid of the contact, 0 at its edge, and linear between them.
    /// The margin of friction is 1 without shear and 0 at sliding.
    pub gravity_margin: f64,
    /// Every axis about which the part can tip; empty if it does not stand.
    pub edges: Vec<EdgeLimit>,
    /// Distance between the edge of the contact and the axis about which the part tips first, m: the edge crushes. `None` without a
    /// compressive strength, or if the part does not stand.
    pub crushed_m: Option<f64>,
    /// First tipping, without ties. `None` if the part does not stand.
    pub uplift: Option<Threshold>,
    /// First tipping with every tie of the cut at its strength.
    pub uplift_with_ties: Option<Threshold>,
    /// Sliding against friction and cohesion. `None` if the part does not stand.
    pub sliding: Option<Threshold>,
    /// Sliding against friction, cohesion and the shear strength of every tie.
    pub sliding_with_ties: Option<Threshold>,
    /// Whether the part stands without shaking.
    pub standing: Standing,
    pub(super) tipping: Vec<HalfPlane>,
}

impl CutLimits {
    /// Acceleration at which the part tips under shaking in one direction (the direction of the inertia forces), m/s²; `None` if it does not
    /// stand.
    ///
    /// ```text
    /// a(u) = min over lines with l·u > 0 of s / (l·u)
    /// ```
    ///
    /// # Errors
    /// [`StabilityError::Direction`] if the direction has no length.
    ///
    /// # Limits
    /// With a compressive strength the limit is a curve. Chords replace it, which are never too high, and at most 1 % too low on a square
    /// contact.
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

/// Kind of the first motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum LimitKind {
    /// A joint opens: the part above rocks.
    Uplift,
    /// The part above slides.
    Sliding,
}

/// The first motion, with its cut and acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Governing {
    /// Uplift or sliding.
    pub kind: LimitKind,
    /// Index of the cut in [`StackLimitStates::cuts`].
    pub cut: usize,
    /// Acceleration and direction.
    pub threshold: Threshold,
}

/// Where a footing overturns on its soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootingLimit {
    /// The push at which the footing overturns, in the worst direction. No part of the stack has a larger threshold in that direction.
    pub overturns: Threshold,
    /// The same on rigid ground, where the stack tips about the edge of the footing, m/s².
    pub rigid_m_s2: f64,
}

impl FootingLimit {
    /// What the soil leaves of the push that overturns the footing on rigid ground.
    pub fn factor(&self) -> f64 {
        self.overturns.acceleration_m_s2 / self.rigid_m_s2
    }
}

/// Limit states of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackLimitStates {
    /// The limits of each cut, lowest cut first.
    pub cuts: Vec<CutLimits>,
    /// Whether the stack stands without shaking: the worst result of all cuts.
    pub standing: Standing,
    /// Smallest [`CutLimits::gravity_margin`]; `None` if there is no cut.
    pub gravity_margin: Option<f64>,
    /// Verdict without shaking: stable, marginal or unstable; unknown if the stack seems to stand but is not statically determinate.
    pub verdict: Verdict,
    /// First uplift of all cuts; `None` if the stack does not stand. An upper bound if the stack is not statically determinate.
    pub uplift: Option<Governing>,
    /// First sliding of all cuts; `None` if the stack does not stand. An upper bound if the stack is not statically determinate.
    pub sliding: Option<Governing>,
    /// The earlier of uplift and sliding. `None` if the stack does not stand or is not statically determinate: these cuts then do not show
    /// what governs.
    pub governing: Option<Governing>,
    /// The earlier of uplift and sliding with ties at their strength, under the same conditions.
    pub governing_with_ties: Option<Governing>,
    /// The footing on its soil; `None` on rigid ground, or if the footing does not stand.
    pub footing: Option<FootingLimit>,
    /// Groups of blocks on joints in different planes, which this method does not assess.
    pub undecided: Vec<Vec<usize>>,
    /// Whether equilibrium alone gives the force in each joint. If not, every threshold here is an upper bound, and only limit analysis gives
    /// the verdict.
    pub statically_determinate: bool,
}
