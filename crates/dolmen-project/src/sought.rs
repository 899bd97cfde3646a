//! Stiffness that the file leaves to the modes of a survey, and what came of it.

/// Stiffness that the file leaves to a survey: `"identified"`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sought {
    /// The survey; `None`: the latest that has records or frequencies.
    pub survey: Option<String>,
}

/// One accepted solution of the stiffness that the file leaves to its surveys, of how many.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FromSurveys {
    /// Each stiffness that was sought, in the order of the file.
    pub parts: Vec<FromSurvey>,
    /// Number of this solution, from 1.
    pub number: usize,
    /// How many solutions explain the modes; 0 where no stiffness is known.
    pub of: usize,
}

/// A stiffness that was sought.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FromSurvey {
    /// Where it stands: `joints`, `direction.weak.stiffness`.
    pub path: String,
    /// The survey; `None` where the file has none to seek it in.
    pub survey: Option<String>,
    /// Why it is not known; `None` where it is.
    pub unknown: Option<WhyNotIdentified>,
}

/// Why a survey does not lead to a stiffness that a verdict may rest on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhyNotIdentified {
    /// No survey has records or frequencies.
    NoSurvey,
    /// The survey has no modes in the direction, or what it has leads to none.
    NoModes,
    /// The modes tell it between wide bounds alone.
    Bounded,
    /// Fewer modes than unknowns.
    Underdetermined,
    /// Two solutions meet: neither has a deviation.
    Meet,
    /// No stiffness explains the modes.
    Impossible,
    /// A peak below the modes may be the first, or the sensors contradict the model.
    Doubted,
    /// Too many solutions to judge each.
    TooMany {
        /// How many.
        solutions: usize,
    },
}

impl FromSurveys {
    /// Whether every stiffness that was sought is known.
    pub fn is_known(&self) -> bool {
        self.parts.iter().all(|part| part.unknown.is_none())
    }
}
