use crate::numeric::NumericError;
use crate::stability::StabilityError;
use crate::structure::StructureError;
use crate::structure::stack::StackError;

/// Why a structure cannot be assessed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AssessError {
    /// The structure or its stiffness is refused.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// Stability cannot be assessed.
    #[error(transparent)]
    Stability(#[from] StabilityError),
    /// A stack that cannot be.
    #[error(transparent)]
    Stack(#[from] StackError),
    /// A number is refused.
    #[error(transparent)]
    Numeric(#[from] NumericError),
    /// A site class for which the code gives no numbers.
    #[error(
        "site class S6 is site-specific: the code gives no factors for it; have the site studied and give its spectrum as \
         a table"
    )]
    SiteSpecific,
    /// A return period that the code does not have.
    #[error(
        "return_period_years is {given}, but the code has 50, 100, 200, 500, 1000, 2400 and 4800: take the next longer"
    )]
    ReturnPeriod {
        /// The period given, years.
        given: u32,
    },
    /// A row of a table is missing or makes no sense.
    #[error(
        "row {row} of the spectrum is missing or refused: give 2 or more rows of period_s, rising, and \
         acceleration_m_s2, none negative"
    )]
    SpectrumTable {
        /// Which, from 1.
        row: usize,
    },
    /// A period that a table does not reach.
    #[error("a period of {} s is outside the table, {least_s} to {most_s} s: extend it", (period_s * 1e4).round() / 1e4)]
    OutsideTable {
        /// The period, s.
        period_s: f64,
        /// First of the table, s.
        least_s: f64,
        /// Last of the table, s.
        most_s: f64,
    },
    /// A damping ratio that a table does not hold for.
    #[error("damping_ratio is {given}, but the table holds for {of_table}: give a table for that damping")]
    TableDamping {
        /// The ratio asked for.
        given: f64,
        /// That of the table.
        of_table: f64,
    },
    /// A scale of a scan that cannot be.
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
}
