//! Recognises a free decay among records that are analysed as ambient vibration.

use super::era::{Era, era};
use crate::numeric::sum_of;
use crate::signal::Record;

/// Number of equal parts of the record, the largest ratio of the power of a part to that of the part before, and the least ratio of the first to the
/// last. Our choice: a record of ambient vibration or traffic hardly ever loses power in every eighth.
const PARTS: usize = 8;
const GROWTH_MOST: f64 = 1.2;
const FALL_LEAST: f64 = 10.0;
/// Least share of the motion that decaying modes explain. Our choice.
const EXPLAINED_LEAST: f64 = 0.9;

/// Share of the motion that modes explain which all decay from the beginning of the record; `None` if it is not a free decay.
///
/// # Limits
/// A record that begins long before the release, or has several blows, is not recognised.
pub(crate) fn explained_by_decay(record: &Record) -> Option<f64> {
    let length = record.length() / PARTS;
    let mut power = [0.0; PARTS];
    for c in 0..record.channels().len() {
        let (samples, mean) = (record.samples(c), record.mean(c));
        let of = |part: &[f64]| sum_of(part, |y| (y - mean) * (y - mean));
        let whole = of(samples).max(f64::MIN_POSITIVE);
        for (sum, part) in power.iter_mut().zip(samples.chunks_exact(length.max(1))) {
            *sum += of(part) / whole;
        }
    }
    let falls = power.windows(2).all(|pair| pair[1] <= GROWTH_MOST * pair[0]);
    if !falls || power[0] < FALL_LEAST * power[PARTS - 1] {
        return None;
    }
    let found = era(record, &Era::default()).ok()?;
    (found.explained >= EXPLAINED_LEAST).then_some(found.explained)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{MadeMode, MadeRecord};
    use crate::numeric::Random;
    use crate::signal::Channel;
    use std::f64::consts::TAU;

    #[test]
    fn holds_a_free_decay_is_recognised_and_ambient_vibration_is_not() {
        let mut random = Random::new(3, 0);
        let mut of = |shape: [f64; 2]| {
            let modes: [(f64, f64); 3] = [(1.0, 0.01), (1.03, 0.01), (3.2, 0.012)];
            let y = |t: f64| -> f64 {
                let each = modes.iter().enumerate().map(|(k, (hz, zeta))| {
                    shape[k % 2] * (-zeta * TAU * hz * t).exp() * (TAU * hz * t).cos()
                });
                each.sum()
            };
            (0..4000)
                .map(|i| y(0.01 * f64::from(i)) + 0.01 * random.normal())
                .collect()
        };
        let samples = vec![of([1.0, 0.4]), of([-0.5, 1.0])];
        let decays = Record::new(["x", "y"].map(Channel::named).to_vec(), samples, 100.0).unwrap();
        assert!(explained_by_decay(&decays).unwrap() > 0.99);
        let mode = |frequency_hz, shape: [f64; 2]| MadeMode {
            frequency_hz,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        for seed in 0..20 {
            let made = MadeRecord {
                modes: vec![mode(1.9, [0.6, 1.0]), mode(5.3, [1.0, -0.7])],
                duration_s: 60.0,
                seed,
                ..MadeRecord::default()
            };
            let ambient = made.make().unwrap();
            assert_eq!(explained_by_decay(&ambient), None);
            // nor is a gust that dies away
            let fades = |c: usize| {
                let each = ambient.samples(c).iter().enumerate();
                each.map(|(t, y)| y * (-4.0 * t as f64 / ambient.length() as f64).exp())
                    .collect()
            };
            let rate_hz = ambient.sampling_rate_hz();
            let gust = Record::new(ambient.channels().to_vec(), vec![fades(0), fades(1)], rate_hz).unwrap();
            assert_eq!(explained_by_decay(&gust), None);
        }
    }
}
