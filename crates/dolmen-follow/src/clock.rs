//! The clock.

use std::time::{Duration, SystemTime, UNIX_EPOCH};

fn since() -> Duration {
    SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default()
}

/// Microseconds since 1970 (UTC).
pub fn now_us() -> i64 {
    i64::try_from(since().as_micros()).unwrap_or(i64::MAX)
}

/// Seconds from 1 January 1970 (UTC).
pub(crate) fn now_s() -> f64 {
    since().as_secs_f64()
}
