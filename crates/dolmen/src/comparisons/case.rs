/// One number of a source, or of a second method of this crate, compared with our result.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Author and year.
    pub source: &'static str,
    /// Description of the number.
    pub what: String,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// The number of the source.
    pub published: f64,
    /// The quantity computed by this crate, by the definition of the source.
    pub computed: f64,
    /// Largest difference that the digits of the source allow, in the same unit.
    pub tolerance: f64,
    /// The correct number, if the definition of the source is wrong.
    pub corrected: Option<f64>,
    /// Note: why the published number is wrong, or the reason for the tolerance. May be empty.
    pub note: &'static str,
}

impl Case {
    /// computed − published.
    pub fn difference(&self) -> f64 {
        self.computed - self.published
    }

    /// Whether the difference lies within the tolerance.
    pub fn agrees(&self) -> bool {
        self.difference().abs() <= self.tolerance
    }
}
