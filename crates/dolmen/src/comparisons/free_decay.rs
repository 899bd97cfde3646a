//! A free decay with known poles, and the lower bound of their scatter under noise.

use super::{Case, ValidationError};
use crate::modal::{Era, era};
use crate::numeric::Random;
use crate::signal::{Channel, Record};
use std::f64::consts::PI;

const SOURCE: &str = "Closed form";
const EXACT: &str = "Free decay of 2 Hz and 3 %, 6 s at 100 Hz: what went in, by eigensystem realization (Juang & Pappa 1985).";
const BOUND: &str = "Free decay of 5 Hz and 0.5 %, 40 s at 100 Hz, white noise of 1 %: the Cramér–Rao bound 4 σ √(α³ Δt)/2π, α = ζω, beside the deviation stated \
                     with the noise estimated from what is left: known to 1.1 %, three times that is allowed.";

fn decay(f: f64, zeta: f64, seconds: f64, noise: f64) -> Result<Record, ValidationError> {
    let mut random = Random::new(1, 0);
    let omega = 2.0 * PI * f;
    let y = (0..(100.0 * seconds) as usize).map(|i| {
        let t = 0.01 * i as f64;
        (-zeta * omega * t).exp() * (omega * (1.0 - zeta * zeta).sqrt() * t).cos() + noise * random.normal()
    });
    Ok(Record::new(vec![Channel::named("y")], vec![y.collect()], 100.0)?)
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let first = |record: &Record| -> Result<[f64; 3], ValidationError> {
        let found = era(record, &Era::default())?;
        let mode = found.modes.modes.first();
        Ok(mode.map_or([f64::NAN; 3], |m| {
            [
                m.frequency_hz,
                m.damping_ratio.unwrap_or(f64::NAN),
                m.frequency_sd_hz.unwrap_or(f64::NAN),
            ]
        }))
    };
    let [frequency_hz, damping_ratio, _] = first(&decay(2.0, 0.03, 6.0, 0.0)?)?;
    let [.., sd_hz] = first(&decay(5.0, 0.005, 40.0, 0.01)?)?;
    let alpha = 0.005 * 2.0 * PI * 5.0;
    let bound_hz = 4.0 * 0.01 * (alpha.powi(3) * 0.01).sqrt() / (2.0 * PI);
    let case = |what: &str, unit, published: f64, computed: f64, tolerance: f64, note| Case {
        source: SOURCE,
        what: what.to_owned(),
        unit,
        published,
        computed,
        tolerance,
        corrected: None,
        note,
    };
    Ok(vec![
        case("free decay: frequency", "Hz", 2.0, frequency_hz, 1e-9, EXACT),
        case("free decay: damping ratio", "", 0.03, damping_ratio, 1e-9, EXACT),
        case(
            "free decay in noise: deviation of the frequency",
            "Hz",
            bound_hz,
            sd_hz,
            0.034 * bound_hz,
            BOUND,
        ),
    ])
}
