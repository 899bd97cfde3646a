//! Any bytes are the channels of a ground motion or an error, whatever is known beforehand; what is read can be written.

use dolmen::signal::{Component, GroundMotion};
use dolmen_records::motions::{
    MotionOptions, StatedPeak, motion_at2, motion_csv, read_channels, read_component, read_oriented,
};
use dolmen_records::records::Unit;

pub(super) fn run(bytes: &[u8]) {
    let _ = read_component(bytes, &MotionOptions::default());
    let told = MotionOptions {
        unit: Some(Unit::Gal),
        plausible_peak_m_s2: 0.0..=f64::MAX,
        stated_peak: StatedPeak::Ignore,
        ..Default::default()
    };
    let stepped = MotionOptions {
        time_step_s: Some(0.01),
        ..told.clone()
    };
    for options in [told.clone(), MotionOptions { unit: None, ..told }, stepped] {
        let _ = read_oriented("", &[bytes], 30.0, &options);
        for read in read_channels(bytes, &options).unwrap_or_default() {
            assert!(read.acceleration_m_s2.iter().all(|a| a.is_finite()) && read.time_step_s > 0.0);
            let series = vec![(Component::X, read.acceleration_m_s2)];
            if let Ok(motion) = GroundMotion::new(read.name, read.time_step_s, series) {
                let _ = (motion_at2(&motion, Component::X), motion_csv(&motion));
            }
        }
    }
}
