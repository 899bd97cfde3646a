//! Whether a stack stands without shaking, in words.

use crate::stability::Verdict;
use std::fmt;

/// Whether the part above a joint stands without shaking. `Display` gives a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// The part stands.
    Stands,
    /// The resultant of weight and static loads lies outside the joint: the part tips.
    Leaves {
        /// The bodies below, in words.
        above: String,
        /// Distance outside the joint, m.
        distance_m: f64,
    },
    /// Weight and static loads exceed the shear resistance of the joint: the part slides.
    Slides {
        /// The bodies below, in words.
        above: String,
        /// Shear, N.
        shear_n: f64,
        /// Resistance of friction and cohesion, N.
        resistance_n: f64,
    },
    /// No force presses the joint together.
    Lifts {
        /// The bodies below, in words.
        above: String,
        /// Tension, N.
        pull_n: f64,
    },
    /// The resultant lies so close to an edge that the stone crushes.
    Crushes {
        /// The bodies below, in words.
        above: String,
        /// Distance beyond the line that the strength allows, m.
        distance_m: f64,
    },
    /// The force exceeds the strength, even if it is distributed over the whole joint.
    Overloaded {
        /// The bodies below, in words.
        above: String,
        /// Force over area, Pa.
        pressure_pa: f64,
        /// Compressive strength, Pa.
        strength_pa: f64,
    },
    /// Stones that share their load crush: no joint forces balance the weight with the strength, although they would without crushing.
    CrushesTogether {
        /// Smallest compressive strength of the joints, Pa.
        strength_pa: f64,
    },
    /// The base rotates on its soil without limit.
    SoilTurns {
        /// Rocking stiffness on the soil, N m/rad.
        stiffness_n_m_rad: f64,
        /// The required stiffness: Σ of weights and vertical loads times their heights, N m/rad.
        least_n_m_rad: f64,
    },
    /// Horizontal static loads overturn the footing on its soil.
    SoilOverturns {
        /// Their moment about the bed, N m.
        moment_n_m: f64,
        /// The largest moment that the footing bears, N m.
        bears_n_m: f64,
    },
}

impl Standing {
    /// Whether it stands.
    pub fn stands(&self) -> bool {
        *self == Standing::Stands
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Standing::Stands => write!(f, "it stands under its own weight and static loads"),
            Standing::Leaves { above, distance_m } => {
                write!(
                    f,
                    "above {above} the resultant leaves the joint by {distance_m:.2} m"
                )
            }
            Standing::Slides {
                above,
                shear_n,
                resistance_n,
            } => write!(
                f,
                "above {above} a shear of {shear_n:.0} N slides the joint, which bears {resistance_n:.0} N"
            ),
            Standing::Lifts { above, pull_n } => {
                write!(f, "above {above} static loads lift the blocks with {pull_n:.0} N")
            }
            Standing::Crushes { above, distance_m } => write!(
                f,
                "above {above} the stone crushes: the resultant lies {distance_m:.2} m beyond where its strength can \
                 bear it"
            ),
            Standing::Overloaded {
                above,
                pressure_pa,
                strength_pa,
            } => write!(
                f,
                "above {above} the stone crushes: {pressure_pa:.3e} Pa over the whole joint, and its strength is \
                 {strength_pa:.3e} Pa"
            ),
            Standing::CrushesTogether { strength_pa } => write!(
                f,
                "edges of stones that share their load crush: with a strength of {strength_pa:.3e} Pa no forces in the joints balance \
                 the weight"
            ),
            Standing::SoilTurns {
                stiffness_n_m_rad,
                least_n_m_rad,
            } => write!(
                f,
                "the soil turns away under the stack: its rocking stiffness is {stiffness_n_m_rad:.3e} N m/rad, and \
                 weights and loads times their heights are {least_n_m_rad:.3e}"
            ),
            Standing::SoilOverturns {
                moment_n_m,
                bears_n_m,
            } => write!(
                f,
                "static loads overturn the footing on its soil: their moment is {moment_n_m:.3e} N m, and it bears {bears_n_m:.3e}"
            ),
        }
    }
}

impl Verdict {
    /// Margin below which a standing stack is "marginal". Our choice: at one third of the way from the edge to the middle, a rectangular joint
    /// is in contact over half of its width.
    pub const MARGINAL_BELOW_MARGIN: f64 = 1.0 / 3.0;

    /// The verdict on a stack without shaking, from its smallest margin: the distance of the resultant from the edge relative to that of the
    /// middle, or the reserve of friction. 0 or less: unstable.
    pub fn of_gravity_margin(gravity_margin: f64) -> Self {
        if gravity_margin.is_nan() {
            Verdict::Unknown
        } else if gravity_margin <= 0.0 {
            Verdict::Unstable
        } else if gravity_margin < Self::MARGINAL_BELOW_MARGIN {
            Verdict::Marginal
        } else {
            Verdict::Stable
        }
    }
}
