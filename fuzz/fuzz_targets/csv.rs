//! Any bytes are a record or an error, whatever is known beforehand.
#![no_main]

use dolmen_formats::records::{RecordOptions, read_csv};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = read_csv(bytes, &RecordOptions::default());
    let rate_known = RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    };
    if let Ok(reading) = read_csv(bytes, &rate_known) {
        assert!(reading.record.length() >= 2);
    }
});
