//! The kinds of structures in studies.

/// The kind of structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StudyKind {
    /// A stack of stones.
    Stack,
    /// A frame with dry friction.
    Frame,
    /// A chain of links.
    Chain,
    /// A building of rigid floors.
    Building,
}

impl StudyKind {
    /// "stack", "frame", "chain" or "building".
    pub fn word(self) -> &'static str {
        match self {
            StudyKind::Stack => "stack",
            StudyKind::Frame => "frame",
            StudyKind::Chain => "chain",
            StudyKind::Building => "building",
        }
    }

    /// Name of a state in tables and JSON: one of [`Self::states`], or the allowable drift of the file behind them.
    pub fn state(self, state: usize) -> &'static str {
        self.states().get(state).copied().unwrap_or("allowed drift")
    }

    /// Names of the damage states of a run, the first state first.
    pub fn states(self) -> [&'static str; 4] {
        match self {
            StudyKind::Stack => ["DS1", "DS2", "DS3", "falls"],
            StudyKind::Frame => ["slips", "–", "–", "drift limit"],
            StudyKind::Chain => ["opens", "–", "–", "falls"],
            StudyKind::Building => ["limit 1", "limit 2", "limit 3", "limit 4"],
        }
    }
}
