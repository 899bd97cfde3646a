//! System time.

use std::time::{Duration, SystemTime, UNIX_EPOCH};

fn since_epoch() -> Duration {
    SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default()
}

/// Unix time, µs; 0 before 1970.
pub fn now_us() -> i64 {
    i64::try_from(since_epoch().as_micros()).unwrap_or(i64::MAX)
}

/// Unix time, s; 0 before 1970.
pub(crate) fn now_s() -> f64 {
    since_epoch().as_secs_f64()
}
