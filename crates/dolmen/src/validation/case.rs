use super::{
    ValidationError, building_motion, choi_2021, chopra_2017, columns, dampers, dry_friction, fragility,
    free_decay, hwang_min_hong, joined, kim_koo_hong_2018, owen_prieur_2017, park_min_2010, pyoma2,
    rigid_blocks, second_methods, setups, survey_change,
};

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

/// All cases, source by source.
///
/// # Errors
/// [`ValidationError`] if one cannot be computed: a fault of this crate.
///
/// # Example
/// ```
/// let cases = dolmen::validation::cases()?;
/// assert!(cases.iter().all(|case| case.agrees()));
/// # Ok::<(), dolmen::validation::ValidationError>(())
/// ```
pub fn cases() -> Result<Vec<Case>, ValidationError> {
    let sources = [
        choi_2021::cases()?,
        columns::cases()?,
        park_min_2010::cases()?,
        kim_koo_hong_2018::cases()?,
        rigid_blocks::cases(),
        dry_friction::cases()?,
        hwang_min_hong::cases()?,
        chopra_2017::cases()?,
        building_motion::cases()?,
        dampers::cases()?,
        fragility::cases()?,
        owen_prieur_2017::cases()?,
        free_decay::cases()?,
        joined::cases()?,
        pyoma2::cases()?,
        setups::cases()?,
        survey_change::cases()?,
        second_methods::cases()?,
    ];
    Ok(sources.into_iter().flatten().collect())
}
