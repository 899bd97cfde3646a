//! Any bytes are a ground motion or an error, whatever is known beforehand.
#![no_main]

use dolmen_formats::motions::{MotionOptions, read_component};
use dolmen_formats::records::Unit;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = read_component(bytes, &MotionOptions::default());
    let told = MotionOptions {
        unit: Some(Unit::Gal),
        time_step_s: Some(0.01),
        plausible_peak_m_s2: 0.0..=f64::MAX,
        ..Default::default()
    };
    if let Ok(read) = read_component(bytes, &told) {
        assert!(read.acceleration_m_s2.iter().all(|a| a.is_finite()));
    }
});
