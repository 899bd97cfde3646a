//! Any bytes are a record or an error, whatever is known beforehand.

use dolmen_records::records::{RecordOptions, read_csv};

pub(super) fn run(bytes: &[u8]) {
    let _ = read_csv(bytes, &RecordOptions::default());
    let rate_known = RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    };
    if let Ok(reading) = read_csv(bytes, &rate_known) {
        assert!(reading.record.length() >= 2);
    }
}
