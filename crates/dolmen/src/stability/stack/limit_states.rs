//! What is known of a stack's limits, cut by cut.

use super::half_plane::HalfPlane;
use super::{Cut, Standing, Threshold};
use crate::stability::{StabilityError, Verdict};
use crate::structure::stack::Polygon;

/// Tipping over one edge of a contact, or over the line within it about which the stone crushes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeLimit {
    /// A point of the line it turns about, m.
    pub pivot_m: [f64; 3],
    /// Unit vector along that line, m.
    pub axis: [f64; 3],
    /// From the static resultant to the line, in the plane of the joint, m; negative if it lies beyond.
    pub distance_m: f64,
    /// Height of the centroid above the line, m.
    pub height_m: f64,
    /// Acceleration at which the part turns about it.
    pub uplift: Threshold,
}

/// Limits of what lies above one cut.
#[derive(Clone, Debug, PartialEq)]
pub struct CutLimits {
    /// The blocks above and the joints below them.
    pub cut: Cut,
    /// Its bodies below, as words: "'body 1'", "the ground".
    pub above: String,
    /// Weight of the blocks above, N, with vertical acceleration.
    pub weight_n: f64,
    /// Their centroid, m.
    pub centroid_m: [f64; 3],
    /// Origin of the contact's plane, m.
    pub origin_m: [f64; 3],
    /// Unit vectors of the plane: two in it, then its normal, upwards.
    pub axes: [[f64; 3]; 3],
    /// Convex hull of the patches, in that plane, m.
    pub contact: Polygon,
    /// Where the resultant of weight and static loads crosses the plane, in its coordinates, m.
    pub resultant_m: [f64; 2],
    /// How far that lies inside the nearest edge of the contact, m; negative outside.
    pub depth_m: f64,
    /// What is left of the way from the contact's centroid to the edge, 1 where the resultant is centred, 0 where it
    /// reaches the edge; and of friction, 1 where nothing shears, 0 where it slides: the lesser.
    pub gravity_margin: f64,
    /// Every line about which it can tip; none if it does not stand.
    pub edges: Vec<EdgeLimit>,
    /// How far inside the edge of the contact the line lies about which it tips soonest, because the edge crushes, m; `None` without a
    /// strength, or if it does not stand.
    pub crushed_m: Option<f64>,
    /// Tipping, where it begins soonest; ties are not yet pulled. `None` if it does not stand.
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
    /// Acceleration at which it tips when shaken in one direction (the direction of inertia forces), m/s²; `None` if it
    /// does not stand.
    ///
    /// ```text
    /// a(u) = min over lines with l·u > 0 of s / (l·u)
    /// ```
    ///
    /// # Errors
    /// [`StabilityError::Direction`] unless the direction has a length.
    ///
    /// # Limits
    /// With a compressive strength the limit is a curve; chords of it are taken, which are never too high and on a square
    /// contact at most 1 % too low.
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

/// What begins first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum LimitKind {
    /// A joint opens: what is above rocks.
    Uplift,
    /// What is above slides.
    Sliding,
}

/// What begins first, where and when.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Governing {
    /// Uplift or sliding.
    pub kind: LimitKind,
    /// Which cut, an index into [`StackLimitStates::cuts`].
    pub cut: usize,
    /// At what acceleration, in what direction.
    pub threshold: Threshold,
}

/// The limits of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackLimitStates {
    /// Cut by cut, lowest first.
    pub cuts: Vec<CutLimits>,
    /// Whether it stands without shaking: the worst of all cuts.
    pub standing: Standing,
    /// Least [`CutLimits::gravity_margin`]; `None` if there is no cut.
    pub gravity_margin: Option<f64>,
    /// stable, marginal, unstable, without shaking; unknown if it seems to stand but is not statically determinate.
    pub verdict: Verdict,
    /// First uplift of all cuts; `None` if the stack does not stand. An upper bound unless statically determinate.
    pub uplift: Option<Governing>,
    /// First sliding of all cuts; `None` if the stack does not stand. An upper bound unless statically determinate.
    pub sliding: Option<Governing>,
    /// The sooner of both; `None` if the stack does not stand, or is not statically determinate: then these cuts do not
    /// say what governs.
    pub governing: Option<Governing>,
    /// The sooner of both with ties at their strength, under the same conditions.
    pub governing_with_ties: Option<Governing>,
    /// By how much a turning soil lowers every threshold: 1 − W h / K, 1 on rigid ground.
    pub soil_factor: f64,
    /// Horizontal acceleration that the soil's rotation under static loads adds to every part, m/s².
    pub soil_offset_m_s2: [f64; 2],
    /// Groups of blocks that rest on joints of different planes and are not judged here.
    pub undecided: Vec<Vec<usize>>,
    /// Whether equilibrium alone gives the force in each joint. If not, every threshold here is an upper bound, and
    /// a limit analysis decides.
    pub statically_determinate: bool,
}
