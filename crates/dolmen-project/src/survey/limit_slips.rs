//! Limits of a tilt beyond what limits are.

use crate::reader::Reader;
use crate::wrong::WrongSurvey;

/// A limit of a tilt that is asked about: limits are 1/600 to 1/100, and nothing that leans by 1/50 is left alone. A digit lost of 1/150 gives 1/15.
const LIMIT_USUAL_MOST: f64 = 0.02;

/// Asks about a limit of a tilt beyond what limits are: no alarm would ever be raised.
pub(super) fn judge_limit(reader: &mut Reader, path: &str, ratio: f64) {
    if ratio > LIMIT_USUAL_MOST {
        let message = WrongSurvey::LimitIsLarge {
            path: path.to_owned(),
            inverse: format!("{:.0}", 1.0 / ratio),
        };
        reader.slip(path, message, WrongSurvey::LimitsAre);
    }
}
