//! Random structures for simulated records: masts, storeyed buildings with torsion, and structures with random shapes.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | f₁ | `first_hz` | lowest frequency | Hz |
//! | s | `height` | height of a sensor over that of the structure | – |

use crate::modal::MadeMode;
use crate::numeric::Random;
use std::f64::consts::PI;

/// βL of the first modes of a cantilever (Blevins 1979, table 8-1); (2n − 1) π/2 from the fifth on.
const BETA: [f64; 4] = [1.875_104_07, 4.694_091_13, 7.854_757_44, 10.995_540_73];

/// Uniformly distributed value between two numbers.
pub(super) fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * random.uniform()
}

/// Value between two numbers with a uniformly distributed logarithm.
pub(super) fn log_between(random: &mut Random, low: f64, high: f64) -> f64 {
    between(random, low.ln(), high.ln()).exp()
}

pub(super) fn whole(random: &mut Random, low: usize, high: usize) -> usize {
    low + ((high + 1 - low) as f64 * random.uniform()) as usize
}

pub(super) fn chance(random: &mut Random, share: f64) -> bool {
    random.uniform() < share
}

/// Modes of a random structure, by frequency, at most `highest_hz`, with damping ratios of 0.05 to 8 %.
pub(super) fn structure(
    random: &mut Random,
    channels: usize,
    first_hz: f64,
    highest_hz: f64,
) -> Vec<MadeMode> {
    let damping = log_between(random, 0.0006, 0.06);
    let each = whole(random, 1, 4);
    let mut modes = match whole(random, 0, 2) {
        0 => swaying(random, (channels, each, first_hz), cantilever),
        1 => swaying(random, (channels, each, first_hz), storeyed),
        _ => of_any_shape(random, (channels, 2 * each, first_hz)),
    };
    for mode in &mut modes {
        mode.damping_ratio = (damping * log_between(random, 0.6, 1.7)).clamp(0.0005, 0.08);
    }
    modes.retain(|mode| mode.frequency_hz <= highest_hz);
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    modes
}

/// Frequency over that of the first mode, and deflection at height s, of mode n = 0, 1, … of a cantilever.
fn cantilever(n: usize, s: f64) -> (f64, f64) {
    let beta = BETA.get(n).copied().unwrap_or((n as f64 + 0.5) * PI);
    let sigma = (beta.sinh() - beta.sin()) / (beta.cosh() + beta.cos());
    let x = beta * s;
    (
        (beta / BETA[0]).powi(2),
        0.5 * (x.cosh() - x.cos() - sigma * (x.sinh() - x.sin())),
    )
}

/// The same for a shear building.
fn storeyed(n: usize, s: f64) -> (f64, f64) {
    let odd = (2 * n + 1) as f64;
    (odd, (0.5 * PI * odd * s).sin())
}

/// Pairs of modes along two axes, 0.5 to 30 % apart, rotated relative to the sensors, and torsion if a floor has three
/// sensors.
fn swaying(
    random: &mut Random,
    (channels, each, first_hz): (usize, usize, f64),
    bending: fn(usize, f64) -> (f64, f64),
) -> Vec<MadeMode> {
    let on_a_floor = if channels >= 6 && chance(random, 0.4) {
        3
    } else {
        2
    };
    let floors = channels.div_ceil(on_a_floor);
    let apart = log_between(random, 1.005, 1.3);
    let twist = between(random, 1.2, 2.2);
    let (sin, cos) = between(random, 0.0, 0.5 * PI).sin_cos();
    let corner = between(random, 0.6, 1.4);
    let mut modes = Vec::new();
    for n in 0..each {
        for axis in 0..on_a_floor {
            let factor = [1.0, apart, twist][axis];
            let shape = (0..channels).map(|c| {
                let height = (c / on_a_floor + 1) as f64 / floors as f64;
                // sensors on a floor: x and y at one corner, y at another
                let own = match (axis, c % on_a_floor) {
                    (0, 0) | (1, 1 | 2) => cos,
                    (0, _) => sin,
                    (1, _) => -sin,
                    (_, 0) => corner,
                    (_, 1) => -corner,
                    _ => corner,
                };
                bending(n, height).1 * own
            });
            modes.push(MadeMode {
                frequency_hz: first_hz * factor * bending(n, 1.0).0,
                damping_ratio: 0.01,
                shape: shape.collect(),
            });
        }
    }
    modes
}

/// Random frequencies and shapes, some frequencies 0.5 to 3 % apart: walls, arches, timber gates.
fn of_any_shape(random: &mut Random, (channels, count, first_hz): (usize, usize, f64)) -> Vec<MadeMode> {
    let mut frequency_hz = first_hz;
    (0..count)
        .map(|mode| {
            if mode > 0 {
                let close = chance(random, 0.2);
                frequency_hz *= if close {
                    log_between(random, 1.005, 1.03)
                } else {
                    log_between(random, 1.15, 2.5)
                };
            }
            MadeMode {
                frequency_hz,
                damping_ratio: 0.01,
                shape: (0..channels).map(|_| random.normal()).collect(),
            }
        })
        .collect()
}
