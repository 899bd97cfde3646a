//! Modes on a fixed base, identified from records of a frame on flexible ground.

use super::{Case, ValidationError};
use crate::modal::{Identify, MadeOnGround, Method, identify};

const SOURCE: &str = "Closed form";
const NOTE: &str = "Two storeys on a footing in soft ground, shaken by waves for 30 s, 1 % of noise: frequencies of the frame on a held base, by observer/Kalman \
                    filter identification (Juang et al. 1993). With its ground the first is 9 % lower. Two deviations stated are allowed.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let made = MadeOnGround {
        seed: 0,
        duration_s: 150.0,
        waves_kn: 60.0,
        quake_s: Some(30.0),
        wind_kn: 0.3,
        noise: 0.01,
    };
    let found = identify(
        &made.make()?,
        &Identify {
            method: Method::Okid,
            inputs: vec![0],
            ..Identify::default()
        },
    )?;
    let mut cases = Vec::new();
    for (number, hz) in MadeOnGround::held_hz().into_iter().enumerate() {
        let mode = found.modes.nearest(hz, 0.1 * hz)?;
        cases.push(Case {
            source: SOURCE,
            what: format!("frame on soft ground: frequency {} on a held base", number + 1),
            unit: "Hz",
            published: hz,
            computed: mode.frequency_hz,
            tolerance: 2.0 * mode.frequency_sd_hz.unwrap_or(0.0),
            corrected: None,
            note: NOTE,
        });
    }
    Ok(cases)
}
