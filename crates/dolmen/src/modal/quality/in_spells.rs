//! A mode that is visible only in some periods, for example while somebody walks.

/// A mode that is visible only in some periods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InSpells {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// Ratio of its power to that of its surroundings, in the whole record.
    pub stands_out: f64,
    /// The same ratio in the quieter half of the record.
    pub stands_out_quiet: f64,
}

impl std::fmt::Display for InSpells {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{:.3} Hz ({:.1} times what is beside it, {:.1} in quiet times)",
            self.frequency_hz, self.stands_out, self.stands_out_quiet
        )
    }
}
