//! Distinguishes a gust from an earthquake if all sensors are on the structure: does the motion come from the ground?
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | f_1, φ | `mode` | frequency and shape of the lowest mode at rest | Hz, – |
//! | S_ck | `with` | cross spectrum of channel c with the strongest channel k, summed over 0.25 to 0.5 f_1 | |
//! | r_c | `follows` | Re S_ck / S_kk | – |

use super::losses::Losses;
use super::part::part_of;
use super::shaking::Shaking;
use crate::modal::{Mode, Modes};
use crate::signal::{Channel, Record};
use dolmen_linalg::Complex64;
use realfft::RealFftPlanner;
use std::f64::consts::PI;

/// Frequency range of the test, relative to the lowest mode. Below that mode a ground motion moves all floors equally, but wind moves each floor
/// in proportion to its flexibility.
const BELOW: [f64; 2] = [0.25, 0.5];
/// Least cosine between two parallel sensors.
const ALONG: f64 = 0.99;
/// Largest φ_c/φ_k for which the two cases can be distinguished.
const APART: f64 = 0.75;
const LINES_LEAST: usize = 4;

/// Cause of a strong motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cause {
    /// The ground moves the structure.
    Ground,
    /// A force on the structure, such as wind.
    Force,
    /// The record cannot decide.
    Unclear,
}

/// Whether the ground drives the structure, or a force such as wind. Far below the lowest mode, a force moves the channels in proportion to the
/// mode shape, a ground motion moves them equally.
///
/// ```text
/// carried by the ground   r_c = (1 + Γ φ_c h) / (1 + Γ φ_k h),  h = (f/f_1)² / (1 − (f/f_1)²) ≤ 1/3
/// pushed by wind          r_c = φ_c / φ_k
/// ```
pub(super) fn cause((record, losses): (&Record, &Losses), shaking: &Shaking, modes: &Modes) -> Cause {
    let decided = || -> Option<Cause> {
        let mode = modes.modes.first()?;
        let [low_hz, high_hz] = BELOW.map(|of| of * mode.frequency_hz);
        let span_s = losses.whole_within([shaking.arrival_s, shaking.strong_to_s]);
        let part = part_of(record, span_s)?;
        let (strongest, others) = alike(&modes.channels, mode)?;
        let place = |c: usize| {
            part.channels()
                .iter()
                .position(|of| of.name == modes.channels[c].name)
        };
        let lines =
            |c: usize| place(c).map(|at| lines(part.samples(at), part.sampling_rate_hz(), [low_hz, high_hz]));
        let own = lines(strongest)?;
        if own.len() < LINES_LEAST {
            return None;
        }
        let power: f64 = own.iter().map(|line| line.norm_sqr()).sum();
        let (mut carried, mut pushed) = (0.0, 0.0);
        for c in others {
            let with: f64 = lines(c)?.iter().zip(&own).map(|(a, b)| (a * b.conj()).re).sum();
            let (follows, shape) = (with / power, mode.shape[c].re / mode.shape[strongest].re);
            carried += (follows - 1.0).powi(2);
            pushed += (follows - shape).powi(2);
        }
        Some(match pushed < carried {
            true => Cause::Force,
            false => Cause::Ground,
        })
    };
    decided().unwrap_or(Cause::Unclear)
}

/// The channel with the largest motion in a mode, and the parallel channels with much smaller motion, which make the two cases differ; `None` if
/// there are none.
fn alike(channels: &[Channel], mode: &Mode) -> Option<(usize, Vec<usize>)> {
    let size = |c: &usize| mode.shape[*c].norm();
    let strongest = (0..channels.len()).max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let along = |c: usize| match (channels[c].direction, channels[strongest].direction) {
        (Some(a), Some(b)) => {
            let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
            dot(a, b) / (dot(a, a) * dot(b, b)).sqrt() >= ALONG
        }
        (None, None) => true,
        _ => false,
    };
    let ratio = |c: usize| mode.shape[c].re / mode.shape[strongest].re;
    let others = (0..channels.len()).filter(|c| *c != strongest && along(*c) && ratio(*c) <= APART);
    let others: Vec<usize> = others.collect();
    (!others.is_empty()).then_some((strongest, others))
}

fn lines(part: &[f64], rate_hz: f64, band_hz: [f64; 2]) -> Vec<Complex64> {
    let n = part.len() as f64;
    let mean = part.iter().sum::<f64>() / n;
    let window = |(t, x): (usize, &f64)| (x - mean) * (PI * (t as f64 + 0.5) / n).sin().powi(2);
    let mut windowed: Vec<f64> = part.iter().enumerate().map(window).collect();
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(part.len());
    let mut all = transform.make_output_vec();
    // the buffers have the required lengths
    let _ = transform.process(&mut windowed, &mut all);
    let [low, high] = band_hz.map(|hz| hz * n / rate_hz);
    let own = (low.ceil() as usize)..(high.floor() as usize + 1).min(all.len());
    own.map(|at| Complex64::new(all[at].re, all[at].im)).collect()
}
