//! Stiffness that the file leaves to the modes of a survey, and the result of its identification.

/// Stiffness that the file leaves to a survey: `"identified"`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sought {
    /// The survey; `None`: the latest that has records or frequencies.
    pub survey: Option<String>,
}

/// One accepted solution for the stiffness that the file leaves to its surveys.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FromSurveys {
    /// Each identified stiffness, in the order of the file.
    pub parts: Vec<FromSurvey>,
    /// Number of this solution, from 1.
    pub number: usize,
    /// Number of solutions that explain the modes; 0 if no stiffness is known.
    pub of: usize,
}

/// A stiffness to identify.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FromSurvey {
    /// Its path: `joints`, `direction.weak.stiffness`.
    pub path: String,
    /// The survey; `None` where the file has none for it.
    pub survey: Option<String>,
    /// Reason why it is unknown; `None` if it is known.
    pub unknown: Option<WhyNotIdentified>,
    /// Whether it fits by construction: frequencies alone, not more than unknown stiffnesses.
    pub is_unchecked: bool,
}

/// Why a survey does not give a stiffness that a verdict may rely on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhyNotIdentified {
    /// No survey has records or frequencies.
    NoSurvey,
    /// The survey has no modes in the direction, or its records give none.
    NoModes,
    /// The modes give only wide bounds.
    Bounded,
    /// Fewer modes than unknowns.
    Underdetermined,
    /// Two solutions coincide: neither has a deviation.
    Meet,
    /// No stiffness explains the modes.
    Impossible,
    /// A peak below the modes may be the first, or the sensors contradict the model.
    Doubted,
    /// Too many solutions to judge each.
    TooMany {
        /// Number of solutions.
        solutions: usize,
    },
}

impl FromSurveys {
    /// Whether every stiffness to identify is known.
    pub fn is_known(&self) -> bool {
        self.parts.iter().all(|part| part.unknown.is_none())
    }
}
