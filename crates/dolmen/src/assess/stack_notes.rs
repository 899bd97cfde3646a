//! Notes on the check of a stack, and the result of its run under its own weight.

use crate::blocks::BlocksError;
use crate::structure::stack::Body;
use std::fmt;

/// Result of a run of a stack under its own weight.
#[derive(Clone, Debug, PartialEq)]
pub enum SettleRun {
    /// It settled and stayed.
    Stood {
        /// How far its highest stone settled on the springs of the joints, m.
        settlement_m: f64,
        /// Length of the run, s.
        length_s: f64,
    },
    /// A stone came down.
    Fell {
        /// The first, as an index of the stack's blocks.
        block: usize,
    },
    /// It found no rest, or had none at the end.
    NoRest {
        /// Why the run was refused; `None` if it was made and stones moved on.
        why: Option<BlocksError>,
    },
    /// It has too many stones.
    TooMany {
        /// Their number.
        stones: usize,
    },
}

impl SettleRun {
    /// Most stones of a stack that is run in a check. Our choice: they take a second or two.
    pub const STONES_MOST: usize = 200;
}

/// Treatment of joints that are drawn with a gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gaps {
    /// Taken as closed: otherwise a stone would have no support, or the capacity would be larger.
    Closed,
    /// Taken as closed, but with open gaps the stack does not stand.
    FallsOpen,
    /// Open, as drawn.
    Open {
        /// Acceleration with them closed, over gravity.
        closed_g: Option<f64>,
    },
}

/// A note on the check of a stack. `Display` gives an English sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StackNote {
    /// Stones share their load: the joints alone give an upper bound, the limit analysis decides.
    SharedLoad,
    /// The limit analysis finds less than the joints one by one: parts move together, twist or slide and open.
    AnalysisLower {
        /// Acceleration of the joints one by one, over gravity; `None` where they give none.
        joints_g: Option<f64>,
        /// Acceleration of the limit analysis, over gravity.
        analysis_g: f64,
    },
    /// The limit analysis, which decides, found the least acceleration of all directions between two numbers only.
    AnalysisBetween {
        /// Balanced in every direction, over gravity.
        at_least_g: f64,
        /// Not balanced in one, over gravity.
        analysis_g: f64,
    },
    /// The joints one by one find it standing, the limit analysis does not.
    AnalysisFalls,
    /// Static loads press on stones, but have no mass that an earthquake shakes.
    LoadsWithoutMass {
        /// Acceleration at which the stack begins to move with them, over gravity; `None` if it has no such limit.
        with_g: Option<f64>,
        /// And without them.
        without_g: Option<f64>,
    },
    /// Forces were found that balance it, but they need friction: joints that slip may choose others, so only a run under its
    /// own weight shows that it stands.
    FrictionCarries,
    /// The same, and a run under its own weight stood.
    FrictionStood,
    /// The same, but in a run under its own weight a stone fell.
    FrictionFell {
        /// The first, as an index of the stack's blocks.
        block: usize,
    },
    /// The same, but a run under its own weight found no rest.
    FrictionNoRest,
    /// As above, and the stack has too many stones for a run under its own weight.
    FrictionNotRun {
        /// Present number.
        stones: usize,
        /// Largest number in a run of a check.
        most: usize,
    },
    /// The limit analysis approximates the capacity of joints with finite strength from below: conservative, by a few per
    /// cent at most.
    StrengthFromInside,
    /// Friction that is taken as associated would hold more: it lets joints that slide rise, which real ones do not.
    WithoutDilatancy {
        /// Capacity of that case, over gravity.
        dilating_g: f64,
        /// Capacity without friction in the upright joints that slide, over gravity.
        without_g: f64,
    },
    /// Joints slide while others open, or hold only by sliding: the limit analysis gives an upper bound.
    UpperBound,
    /// It does not stand without the bond of its joints.
    BondCarries,
    /// Joints are drawn with a gap.
    Gaps {
        /// The body below the widest.
        lower: Body,
        /// The block above it.
        upper: usize,
        /// Its gap, m.
        gap_m: f64,
        /// Their number.
        joints: usize,
        /// Treatment of these joints.
        gaps: Gaps,
    },
    /// With the kinetic friction in every joint, stones that share their load begin to move here.
    KineticShared {
        /// Over gravity.
        moves_at_g: f64,
    },
    /// With the kinetic friction in every joint it does not stand.
    KineticFalls,
    /// Side supports are left out.
    SideSupportsLeftOut,
    /// Cohesion counts fully in every joint at the same time, although bonds are brittle and break one after the other.
    CohesionCounted,
    /// The tensile strength of joints is left out.
    TensionLeftOut,
    /// Friction of moving joints is less than of resting ones.
    KineticLess {
        /// Acceleration at which it would slide with the kinetic friction, over gravity.
        slides_at_g: f64,
    },
    /// Ties are left out of the capacity; the thresholds with ties stand beside it.
    TiesLeftOut,
    /// The demand lacks the spectrum at the first period.
    PeriodUnknown,
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
                 use the lower"
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
                "friction that lets sliding joints rise would hold {dilating_g:.3} g; without it in upright joints that slide \
                 {without_g:.3} g is held"
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
