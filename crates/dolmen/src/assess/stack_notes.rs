//! Notes on the check of a stack, and the result of its run under its own weight.

use crate::blocks::BlocksError;
use crate::structure::stack::{Body, Sliver, Stack};
use std::fmt;

/// Result of a run of a stack under its own weight.
#[derive(Clone, Debug, PartialEq)]
pub enum SettleRun {
    /// The stack settled and stood.
    Stood {
        /// Settlement of the highest stone on the joint springs, m.
        settlement_m: f64,
        /// Length of the run, s.
        length_s: f64,
    },
    /// A stone fell.
    Fell {
        /// Index of the first one among the stack's blocks.
        block: usize,
    },
    /// The run found no position of rest, or stones still moved at the end.
    NoRest {
        /// Reason if the run was refused; `None` if stones kept moving.
        why: Option<BlocksError>,
    },
    /// The stack has too many stones for a run.
    TooMany {
        /// Number of its stones.
        stones: usize,
    },
}

impl SettleRun {
    /// Largest number of stones for a run in a check. Our choice: it takes a second or two.
    pub const STONES_MOST: usize = 200;
}

/// Treatment of joints that are drawn with a gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gaps {
    /// Closed: with open gaps, a stone would have no support, or the capacity would be larger.
    Closed,
    /// Closed, although with open gaps the stack does not stand.
    FallsOpen,
    /// Open, as drawn.
    Open {
        /// Acceleration with closed gaps, over gravity.
        closed_g: Option<f64>,
    },
}

/// A note on the check of a stack. `Display` gives an English sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StackNote {
    /// Stones share their load: the single joints give an upper bound, and limit analysis decides.
    SharedLoad,
    /// The limit analysis gives less than the single joints: parts move together, twist, or slide and open.
    AnalysisLower {
        /// Acceleration by the single joints, over gravity; `None` if they have no limit.
        joints_g: Option<f64>,
        /// Acceleration by the limit analysis, over gravity.
        analysis_g: f64,
    },
    /// The limit analysis, which decides, gives only an interval for the least acceleration of all directions.
    AnalysisBetween {
        /// Lower bound: balanced in every direction, over gravity.
        at_least_g: f64,
        /// Upper bound: not balanced in one direction, over gravity.
        analysis_g: f64,
    },
    /// By the single joints the stack stands, by the limit analysis it does not.
    AnalysisFalls,
    /// Static loads press on stones, but have no mass that an earthquake shakes.
    LoadsWithoutMass {
        /// Acceleration at which the stack begins to move with the static loads, over gravity; `None` without limit.
        with_g: Option<f64>,
        /// The same without them.
        without_g: Option<f64>,
    },
    /// Equilibrium is possible, but only with friction. Slipping joints may take other forces, so only a run under its own
    /// weight shows whether the stack stands.
    FrictionCarries,
    /// Friction carries the stack, and it stood in a run under its own weight.
    FrictionStood,
    /// Friction carries the stack, and in a run under its own weight a stone fell.
    FrictionFell {
        /// Index of the first one among the stack's blocks.
        block: usize,
    },
    /// Friction carries the stack, and a run under its own weight found no rest.
    FrictionNoRest,
    /// Friction carries the stack, and it has too many stones for a run under its own weight.
    FrictionNotRun {
        /// Number of stones.
        stones: usize,
        /// Largest number of stones for a run.
        most: usize,
    },
    /// The limit analysis approximates the capacity of joints with finite strength from below: conservative, by a few per
    /// cent at most.
    StrengthFromInside,
    /// Associated friction would give a larger capacity: it makes sliding joints rise, which real joints do not.
    WithoutDilatancy {
        /// Capacity of that case, over gravity.
        dilating_g: f64,
        /// Capacity if joints slide without rising, over gravity.
        without_g: f64,
    },
    /// Joints slide while others open, and no limit without dilation was found, or they hold only by sliding: an upper bound.
    UpperBound,
    /// The stack stands only with the bond of its joints.
    BondCarries,
    /// Joints are drawn with a gap.
    Gaps {
        /// The body below the widest gap.
        lower: Body,
        /// The block above this gap.
        upper: usize,
        /// Width of this gap, m.
        gap_m: f64,
        /// Number of such joints.
        joints: usize,
        /// Treatment of these joints.
        gaps: Gaps,
    },
    /// Contacts too narrow to be known from the drawing are left out.
    SliversLeftOut {
        /// The body below the widest of them.
        lower: Body,
        /// The block above it.
        upper: usize,
        /// Its width, m.
        width_m: f64,
        /// Number of such contacts.
        contacts: usize,
    },
    /// Stones do not stand without contacts too narrow to be known from the drawing.
    SliversCarry {
        /// The body below the narrowest of them.
        lower: Body,
        /// The block above it.
        upper: usize,
        /// Its width, m.
        width_m: f64,
        /// Number of such contacts.
        contacts: usize,
    },
    /// A mesh shows only the corners of a bed that decides the capacity, so that nothing shows how exact they are.
    OnlyCorners {
        /// The body below the bed.
        lower: Body,
        /// The block above it.
        upper: usize,
        /// Assumed error of the corners of all such beds, m.
        off_m: f64,
        /// Relative reduction of the capacity by this error.
        change: f64,
    },
    /// Acceleration at which stones that share their load begin to move with the kinetic friction in every joint.
    KineticShared {
        /// The acceleration, over gravity.
        moves_at_g: f64,
    },
    /// With the kinetic friction in every joint, the stack does not stand.
    KineticFalls,
    /// Side supports are left out.
    SideSupportsLeftOut,
    /// Cohesion counts fully in every joint at the same time, although bonds are brittle and break one after the other.
    CohesionCounted,
    /// The tensile strength of joints is left out.
    TensionLeftOut,
    /// The kinetic friction is smaller than the static friction.
    KineticLess {
        /// Acceleration at which it would slide with the kinetic friction, over gravity.
        slides_at_g: f64,
    },
    /// The capacity does not include ties; the thresholds with ties are listed separately.
    TiesLeftOut,
    /// The spectrum for the demand has no value at the first period.
    PeriodUnknown,
}

impl StackNote {
    /// Notes on contacts too narrow to be known.
    pub(super) fn of_slivers(stack: &Stack) -> impl Iterator<Item = StackNote> {
        let by_width = |a: &&Sliver, b: &&Sliver| a.width_m.total_cmp(&b.width_m);
        let (left_out, carry) = (stack.slivers_left_out(), stack.slivers_that_carry());
        let widest = left_out
            .iter()
            .max_by(by_width)
            .map(|widest| StackNote::SliversLeftOut {
                lower: widest.lower,
                upper: widest.upper,
                width_m: widest.width_m,
                contacts: left_out.len(),
            });
        let narrowest = carry
            .iter()
            .min_by(by_width)
            .map(|narrowest| StackNote::SliversCarry {
                lower: narrowest.lower,
                upper: narrowest.upper,
                width_m: narrowest.width_m,
                contacts: carry.len(),
            });
        widest.into_iter().chain(narrowest)
    }
}

impl fmt::Display for StackNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StackNote::SharedLoad => write!(
                f,
                "stones share their load, so the joints one by one give an upper bound; the limit analysis decides"
            ),
            StackNote::AnalysisLower {
                joints_g: Some(joints_g),
                analysis_g,
            } => write!(
                f,
                "the limit analysis finds {analysis_g:.3} g, less than the {joints_g:.3} g of the joints one by one: parts move \
                 together, twist, or slide and open"
            ),
            StackNote::AnalysisLower { analysis_g, .. } => {
                write!(f, "only the limit analysis gives a limit: {analysis_g:.3} g")
            }
            StackNote::AnalysisBetween {
                at_least_g,
                analysis_g,
            } => write!(
                f,
                "the limit analysis found balance in every direction up to {at_least_g:.3} g, and none at {analysis_g:.3} g in one: \
                 the lower counts"
            ),
            StackNote::AnalysisFalls => write!(
                f,
                "joint by joint it seems to stand, but no forces in the joints balance its weight and static loads"
            ),
            StackNote::LoadsWithoutMass { .. } => write!(
                f,
                "static loads press on stones, but have no mass in an earthquake"
            ),
            StackNote::FrictionCarries => write!(
                f,
                "an admissible state exists, with friction: that is necessary, and only a run under its own weight shows that it \
                 stands"
            ),
            StackNote::FrictionStood => write!(
                f,
                "friction carries it: an admissible state exists, and a run under its own weight on the springs of its joints stood"
            ),
            StackNote::FrictionFell { block } => write!(
                f,
                "an admissible state exists, with friction, but in a run under its own weight on the springs of its joints stone {} fell",
                block + 1
            ),
            StackNote::FrictionNoRest => write!(
                f,
                "an admissible state exists, with friction, but a run under its own weight on the springs of its joints found no rest"
            ),
            StackNote::FrictionNotRun { stones, most } => write!(
                f,
                "an admissible state exists, with friction: that is necessary, and no run under its own weight was made of {stones} \
                 stones, more than {most}"
            ),
            StackNote::StrengthFromInside => write!(
                f,
                "the limit analysis takes what joints of finite strength bear from inside, which is on the safe side"
            ),
            StackNote::SideSupportsLeftOut => write!(
                f,
                "side supports are left out of all thresholds; what they hold is not counted, which is on the safe side"
            ),
            StackNote::CohesionCounted => write!(
                f,
                "cohesion counts against sliding in full in every joint at once; a bond breaks brittle and one joint after the \
                 other, so this is on the unsafe side"
            ),
            StackNote::TensionLeftOut => write!(
                f,
                "the tensile strength of joints is left out of all thresholds, which is on the safe side"
            ),
            StackNote::KineticLess { slides_at_g } => write!(
                f,
                "sliding is found with the static friction; a joint that moves once has the kinetic one, and with that in every \
                 joint sliding begins at {slides_at_g:.3} g"
            ),
            StackNote::WithoutDilatancy {
                dilating_g,
                without_g,
            } => write!(
                f,
                "friction that lets sliding joints rise would hold {dilating_g:.3} g; joints may slide without rising from \
                 {without_g:.3} g on"
            ),
            StackNote::UpperBound => write!(
                f,
                "joints slide while others open: the limit analysis, which lets sliding joints rise, gives an upper bound"
            ),
            StackNote::BondCarries => write!(
                f,
                "held by bond: without the cohesion of its joints it does not stand"
            ),
            StackNote::Gaps {
                gap_m, joints, gaps, ..
            } => write!(
                f,
                "{joints} joints are drawn with a gap, the widest of {gap_m:.4} m: {}",
                match gaps {
                    Gaps::Closed => "taken as closed",
                    Gaps::FallsOpen => "taken as closed; open it does not stand",
                    Gaps::Open { .. } => "left open",
                }
            ),
            StackNote::SliversLeftOut {
                width_m, contacts, ..
            } => write!(
                f,
                "{contacts} contacts are narrower than the drawing is accurate, the widest {width_m:e} m, and carry nothing"
            ),
            StackNote::SliversCarry {
                width_m, contacts, ..
            } => write!(
                f,
                "stones do not stand without {contacts} contacts narrower than the drawing is accurate, the narrowest {width_m:e} m"
            ),
            StackNote::OnlyCorners {
                lower,
                upper,
                off_m,
                change,
            } => write!(
                f,
                "the mesh shows only the corners of the bed of stone {} on {}, which decides: an error of {off_m} m of them changes the \
                 acceleration by up to {:.2} %",
                upper + 1,
                match lower {
                    Body::Ground => "the ground".to_owned(),
                    Body::Block(block) => format!("stone {}", block + 1),
                },
                100.0 * change
            ),
            StackNote::KineticShared { moves_at_g } => write!(
                f,
                "with the kinetic friction in every joint it begins to move at {moves_at_g:.3} g"
            ),
            StackNote::KineticFalls => {
                write!(f, "with the kinetic friction in every joint it does not stand")
            }
            StackNote::TiesLeftOut => write!(
                f,
                "ties are left out of the capacity, which is on the safe side; thresholds with ties at their strength stand \
                 beside it"
            ),
            StackNote::PeriodUnknown => write!(
                f,
                "the first period is not known, so what elastic joints add to the shaking is not in the comparison"
            ),
        }
    }
}
