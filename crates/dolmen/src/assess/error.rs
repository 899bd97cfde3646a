use super::fragility::FragilityBound;
use crate::modal::ModalError;
use crate::numeric::NumericError;
use crate::stability::StabilityError;
use crate::structure::StructureError;
use crate::structure::stack::StackError;

/// Why a structure cannot be assessed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AssessError {
    /// The structure or its stiffness is refused.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// Stability cannot be assessed.
    #[error(transparent)]
    Stability(#[from] StabilityError),
    /// The stack is refused.
    #[error(transparent)]
    Stack(#[from] StackError),
    /// A number is refused.
    #[error(transparent)]
    Numeric(#[from] NumericError),
    /// Modes are refused.
    #[error(transparent)]
    Modal(#[from] ModalError),
    /// A survey has no modes to compare.
    #[error("survey {survey} has no modes, so that nothing can be compared")]
    NothingToCompare {
        /// Name of the survey.
        survey: String,
    },
    /// Too few surveys, or too small a range of temperatures, for fitting a temperature coefficient.
    #[error(
        "{surveys} surveys with a temperature, {spread_c} °C apart, but a coefficient needs {least} and {spread_least_c} °C: measure in \
         other seasons, or give the coefficient"
    )]
    TemperatureFit {
        /// Surveys with a temperature and the mode.
        surveys: usize,
        /// Surveys needed.
        least: usize,
        /// Difference between the warmest and the coldest survey, °C.
        spread_c: f64,
        /// Smallest allowed difference, °C.
        spread_least_c: f64,
    },
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] dolmen_linalg::LinalgError),
    /// A factor of the score is refused.
    #[error("{factor} is {given}, but must be {allowed}")]
    Factor {
        /// Name of the factor.
        factor: &'static str,
        /// Its value.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A factor of the score lies outside the training range.
    #[error(
        "{factor} is {}, but the score was trained from {} to {}: simulate this pagoda, or allow extrapolation, which is \
         marked",
        digits(*given), digits(*least), digits(*most)
    )]
    OutsideTraining {
        /// Name of the factor.
        factor: &'static str,
        /// Its value.
        given: f64,
        /// Smallest value in the training.
        least: f64,
        /// Largest value in the training.
        most: f64,
    },
    /// A ranking is not possible.
    #[error(
        "{candidates} structures and {draws} draws, but a ranking needs 1 structure and 20 draws or more"
    )]
    NothingToRank {
        /// Number of structures.
        candidates: usize,
        /// Requested number of draws.
        draws: usize,
    },
    /// Too few designs to train a score.
    #[error("{given} designs, but the score needs {least} and more: simulate more")]
    TooFewDesigns {
        /// Number of designs.
        given: usize,
        /// Smallest number of designs.
        least: usize,
    },
    /// A site class for which the code gives no numbers.
    #[error(
        "site class S6 is site-specific: the code gives no factors for it; have the site studied and give its spectrum as \
         a table"
    )]
    SiteSpecific,
    /// A return period that the code does not have.
    #[error(
        "return_period_years is {given}, but the code has 50, 100, 200, 500, 1000, 2400 and 4800: take the next longer, for 2475 years 2400"
    )]
    ReturnPeriod {
        /// The period given, years.
        given: u32,
    },
    /// A row of a spectrum table is missing or invalid.
    #[error(
        "row {row} of the spectrum is missing or refused: give 2 or more rows of period_s, rising, and \
         acceleration_m_s2, none negative"
    )]
    SpectrumTable {
        /// Number of the row, from 1.
        row: usize,
    },
    /// A period outside the range of a table.
    #[error("a period of {} s is outside the table, {least_s} to {most_s} s: extend it", (period_s * 1e4).round() / 1e4)]
    OutsideTable {
        /// The period, s.
        period_s: f64,
        /// First period of the table, s.
        least_s: f64,
        /// Last period of the table, s.
        most_s: f64,
    },
    /// A damping ratio other than that of a table.
    #[error("damping_ratio is {given}, but the table holds for {of_table}: give a table for that damping")]
    TableDamping {
        /// Requested damping ratio.
        given: f64,
        /// Damping ratio of the table.
        of_table: f64,
    },
    /// A scale of a scan is refused.
    #[error("scale is {given}, but must be a positive number")]
    Scale {
        /// The scale given.
        given: f64,
    },
    /// A value of a trend that is not a number.
    #[error("a value of a trend is {given}: leave runs without a result out")]
    Trend {
        /// The value given.
        given: f64,
    },
    /// A parameter of a fragility curve is refused.
    #[error("{parameter} of a fragility curve is {given}, but must be a positive number")]
    FragilityParameter {
        /// Its name.
        parameter: &'static str,
        /// The value given.
        given: f64,
    },
    /// An observation is refused.
    #[error("observation {number} has {given}, but must have {allowed}")]
    Observation {
        /// Number of the observation, from 1.
        number: usize,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Too few motions for a fragility curve.
    #[error("{given} motions are too few for a fragility curve: give 3 or more, and 22 or more to rank with")]
    TooFewMotions {
        /// Number of motions.
        given: usize,
    },
    /// Too few motions to decide whether a measure of shaking is sufficient.
    #[error(
        "{given} motions are too few to tell whether a measure of shaking is sufficient: give {least} or more"
    )]
    TooFewForSufficiency {
        /// Number of motions.
        given: usize,
        /// Smallest number of motions.
        least: usize,
    },
    /// Too many scans do not bracket the size of shaking at which a state began.
    #[error(
        "{without} of {scans} scans do not say between what sizes the state began, and those are the strongest and the weakest: scan smaller and \
         larger sizes"
    )]
    CapacitiesOpen {
        /// Number of scans without a bracket.
        without: usize,
        /// Number of all scans.
        scans: usize,
    },
    /// The predictor of the residuals does not vary.
    #[error(
        "it is {value} for every motion, so that nothing can depend on it: give motions of different earthquakes"
    )]
    SameForEveryMotion {
        /// The value.
        value: f64,
    },
    /// The observations give only a bound, not a fragility curve.
    #[error("{}", no_fragility(.0))]
    NoFragility(FragilityBound),
    /// The most likely curve of the observations does not rise.
    #[error(
        "the state is reached no more often at high intensities than at low ones: no fragility curve rises through these \
         observations; is the intensity measure the right one?"
    )]
    FragilityFalls,
    /// A hazard curve is refused.
    #[error("{what} of the hazard is {given}, but must be {allowed}")]
    Hazard {
        /// The fault.
        what: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
}

impl AssessError {
    /// Whether the error is an iteration that ended before convergence: the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Structure(why) => why.did_not_converge(),
            Self::Stability(why) => why.did_not_converge(),
            Self::Modal(why) => why.did_not_converge(),
            Self::Linalg(why) => why.did_not_converge(),
            Self::Stack(_)
            | Self::Numeric(_)
            | Self::NothingToCompare { .. }
            | Self::TemperatureFit { .. }
            | Self::Factor { .. }
            | Self::OutsideTraining { .. }
            | Self::NothingToRank { .. }
            | Self::TooFewDesigns { .. }
            | Self::SiteSpecific
            | Self::ReturnPeriod { .. }
            | Self::SpectrumTable { .. }
            | Self::OutsideTable { .. }
            | Self::TableDamping { .. }
            | Self::Scale { .. }
            | Self::Trend { .. }
            | Self::FragilityParameter { .. }
            | Self::Observation { .. }
            | Self::TooFewMotions { .. }
            | Self::TooFewForSufficiency { .. }
            | Self::SameForEveryMotion { .. }
            | Self::CapacitiesOpen { .. }
            | Self::NoFragility(_)
            | Self::FragilityFalls
            | Self::Hazard { .. } => false,
        }
    }
}

fn no_fragility(bound: &FragilityBound) -> String {
    match bound {
        FragilityBound::NoneReached {
            intensity,
            motions,
            probability_most,
        } => format!(
            "none of {motions} motions reached the state: no curve can be fitted. With 95 % confidence its probability at an intensity of \
             {intensity:.4} is at most {probability_most:.3}; try stronger shaking"
        ),
        FragilityBound::AllReached {
            intensity,
            motions,
            probability_least,
        } => format!(
            "all of {motions} motions reached the state: no curve can be fitted. With 95 % confidence its probability at an intensity of \
             {intensity:.4} is at least {probability_least:.3}; try weaker shaking"
        ),
        FragilityBound::Separated { survived, reached } if survived == reached => format!(
            "every motion reaches the state at an intensity of {reached:.4}: its scatter is smaller than the steps tell, and no curve can be \
             fitted; try more motions, or finer steps"
        ),
        FragilityBound::Middle { above, at_most } => {
            let known = match (*above > 0.0, at_most.is_finite()) {
                (true, true) => format!("half of the capacities lie between {above:.4} and {at_most:.4}"),
                (true, false) => format!("half of the capacities lie above {above:.4}"),
                (false, true) => format!("half of the capacities lie at or below {at_most:.4}"),
                (false, false) => "nothing is known of the middle capacity".to_owned(),
            };
            format!("{known}, too little for a curve: add intensities or motions")
        }
        FragilityBound::Separated { survived, reached } => format!(
            "nothing reached the state up to an intensity of {survived:.4} and everything from {reached:.4} on: its scatter is smaller than the \
             steps tell, and no curve can be fitted; try finer steps between"
        ),
    }
}

/// A number to four significant digits, without zeros at its end.
fn digits(value: f64) -> String {
    let whole = value.abs().max(f64::MIN_POSITIVE).log10().floor() as i32 + 1;
    let decimals = (4 - whole).clamp(0, 12) as usize;
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
