//! Any bytes are readings of a logger at times that rise, or an error, whichever column is wanted.

use dolmen_records::read_log;

pub(super) fn run(bytes: &[u8]) {
    for column in [None, Some("Tilt"), Some("2")] {
        if let Ok(log) = read_log(bytes, column) {
            assert!(log.times_s.len() == log.values.len());
            assert!(log.times_s.iter().all(|time_s| time_s.is_finite()));
        }
    }
}
