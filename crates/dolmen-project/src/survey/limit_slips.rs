//! Limits of a tilt outside the usual range.

use crate::reader::Reader;
use crate::wrong::WrongSurvey;

/// Largest usual limit of a tilt; larger ones are questioned. Limits are 1/600 to 1/100, and a structure that leans by 1/50 is always
/// treated. 1/150 with a lost digit is 1/15.
const LIMIT_USUAL_MOST: f64 = 0.02;

/// Questions a limit of a tilt above the usual range: it would never raise an alarm.
pub(super) fn judge_limit(reader: &mut Reader, path: &str, ratio: f64) {
    if ratio > LIMIT_USUAL_MOST {
        let message = WrongSurvey::LimitIsLarge {
            path: path.to_owned(),
            inverse: format!("{:.0}", 1.0 / ratio),
        };
        reader.slip(path, message, WrongSurvey::LimitsAre);
    }
}
