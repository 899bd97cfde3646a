//! Times of actions, as text.

use dolmen_records::time_text;

/// "2026-11-24 19:51" (UTC).
pub(super) fn moment(seconds: f64) -> String {
    const TO_THE_MINUTE: usize = 16;
    time_text(seconds).chars().take(TO_THE_MINUTE).collect()
}
