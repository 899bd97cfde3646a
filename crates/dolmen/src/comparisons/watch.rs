//! Limits of the moving average with one false alarm in 500 surveys, compared with Lucas & Saccucci (1990).

use super::{Case, ValidationError};
use crate::monitoring::ewma_limit;

const SOURCE: &str = "Lucas & Saccucci (1990)";
const NOTE: &str = "Technometrics 32:1-12, table 3, schemes whose mean run length is 500: the limit of the alarm on surveys over the years.";
/// With 81 cells, the limits of the chain are accurate to two units of the third decimal, the last printed one.
const TOLERANCE: f64 = 0.003;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let published = [(0.4, 3.054), (0.25, 2.998), (0.2, 2.962), (0.1, 2.814)];
    let case = |(weight, limit): (f64, f64)| -> Result<Case, ValidationError> {
        Ok(Case {
            source: SOURCE,
            what: format!("limit of a moving average of weight {weight}"),
            unit: "",
            published: limit,
            computed: ewma_limit(weight, 500.0)?,
            tolerance: TOLERANCE,
            corrected: None,
            note: NOTE,
        })
    };
    published.into_iter().map(case).collect()
}
