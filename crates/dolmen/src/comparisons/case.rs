/// One number of a source, or of a second method of this crate, beside ours.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Author and year.
    pub source: &'static str,
    /// What the number is.
    pub what: String,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// The number of the source.
    pub published: f64,
    /// The same quantity computed by this crate, by the source's own definition.
    pub computed: f64,
    /// Largest difference that the digits of the source allow, same unit.
    pub tolerance: f64,
    /// The right number, where the source's definition is wrong.
    pub corrected: Option<f64>,
    /// What to know: why the published number is wrong, or why the tolerance is what it is. May be empty.
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
