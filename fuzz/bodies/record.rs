//! Any bytes are a record or an error, in every format and whatever is known beforehand; and modes or an error.

use dolmen_records::records::{RecordFormat, RecordOptions, read_modes_uff, read_record};

pub(super) fn run(bytes: &[u8]) {
    let told = RecordOptions {
        sampling_rate_hz: Some(200.0),
        scale: Some(1.0),
        ..Default::default()
    };
    let formats = std::iter::once(None).chain(RecordFormat::ALL.map(Some));
    if let Ok(read) = read_modes_uff(bytes) {
        assert!(
            read.modes
                .iter()
                .all(|mode| mode.frequency_hz > 0.0 && mode.frequency_hz.is_finite())
        );
    }
    for format in formats {
        let options = RecordOptions {
            format,
            ..told.clone()
        };
        if let Ok(reading) = read_record(bytes, &options) {
            let record = reading.record;
            assert!((0..record.channels().len()).all(|j| record.samples(j).iter().all(|x| x.is_finite())));
        }
        let _ = read_record(
            bytes,
            &RecordOptions {
                format,
                ..Default::default()
            },
        );
    }
}
