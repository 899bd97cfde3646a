//! Any bytes are a record or an error.

use dolmen_records::records::{RecordOptions, read_npy};

pub(super) fn run(bytes: &[u8]) {
    let options = RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    };
    if let Ok(reading) = read_npy(bytes, &options) {
        assert!(reading.record.length() * reading.record.channels().len() <= bytes.len());
    }
}
