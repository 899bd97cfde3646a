//! Distinguishes a mode with a sine on it from a lightly damped mode, by the phases of the finest spectral lines.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | z_i | `lines` | transform of the whole record along the shape, lines 1/T apart, tapered over a twentieth at each end |
//! | s_i(ν) | `of_sine` | the same of a sine of unit amplitude at line ν |
//! | m_i | `model` | expected \|z_i\|²: a mode over white noise |
//! | A | `amplitude` | complex amplitude of the sine |
//! | Λ | `gain` | increase of the log-likelihood by a sine |

use super::one_mode::{MODE_OVER_NOISE, MODE_WIDE, OneMode, fitted, floored, lorentz};
use dolmen_linalg::Complex64;
use std::f64::consts::PI;

/// Share of the record over which both ends together are tapered.
const TAPERED: f64 = 0.1;
/// Half width of the narrowest mode, lines: the taper makes it no narrower.
const NARROWEST: f64 = 0.5;
/// Least half width of a second mode over that of the first: modes of one structure are damped alike.
const ALIKE: f64 = 0.5;
/// Number of lines that are tried as the place of the sine, and lines on each side that hold most of it.
const TRIED: usize = 3;
const LOBE: usize = 2;
/// Distances of the lines beside a mode from it, half widths.
const BESIDE_LEAST: f64 = 4.0;
pub(super) const BESIDE_MOST: f64 = 12.0;
/// Steps of the place of the sine, lines.
const STEP: f64 = 0.1;

/// Weight of the record at a place from 0 (begin) to 1 (end).
pub(super) fn taper(at: f64) -> f64 {
    let edge = (at.min(1.0 - at) / (0.5 * TAPERED)).min(1.0);
    0.5 * (1.0 - (PI * edge).cos())
}

/// A sine at line ν, with the mode and noise without it.
pub(super) struct Sine {
    /// ν, lines.
    pub(super) line: f64,
    /// Power of the sine over that of the mode.
    pub(super) strength: f64,
    /// Half width of the mode, lines.
    pub(super) half_width: f64,
    /// Λ.
    pub(super) gain: f64,
    /// Whether a mode remains near the sine.
    pub(super) mode_remains: bool,
    /// Powers of the lines without the sine.
    left: Vec<f64>,
}

impl Sine {
    /// Mean power of the lines within the half width of a mode, over the geometric mean of the medians of the lines beside them, without the sine.
    pub(super) fn leaves(&self, centre: f64, half_width: f64) -> f64 {
        let (mut own, mut beside) = (Vec::new(), [Vec::new(), Vec::new()]);
        let reach = half_width.max(1.0);
        for (i, p) in self.left.iter().enumerate() {
            let off = (i as f64 - centre) / reach;
            match off.abs() {
                ..=1.0 => own.push(*p),
                BESIDE_LEAST..=BESIDE_MOST => beside[usize::from(off > 0.0)].push(*p),
                _ => {}
            }
        }
        let [below, above] = beside.map(|mut side| {
            side.sort_by(f64::total_cmp);
            side.get(side.len() / 2).copied()
        });
        // a median is ln 2 of the mean
        let around = below
            .zip(above)
            .map(|(below, above)| (below * above).sqrt() / 2f64.ln());
        let own = own.iter().sum::<f64>() / own.len().max(1) as f64;
        around.map_or(f64::INFINITY, |around| own / around.max(f64::MIN_POSITIVE))
    }
}

/// The sine that the lines show best, and what is left without it.
///
/// ```text
/// Λ = min over one mode, or two, of Σ (ln m_i + |z_i|²/m_i)  −  min over one mode and a sine of Σ (ln m_i + |z_i − A s_i(ν)|²/m_i)
/// ```
///
/// # Source
/// Whittle (1953) Ark. Mat. 2:423-434: under random forces the z_i are independent complex normal variables with the variances m_i.
pub(super) fn best_sine(lines: &[Complex64]) -> Option<Sine> {
    let n = lines.len();
    let power = floored(lines.iter().map(|z| z.norm_sqr()).collect())?;
    let alone = fitted(&power, &[], NARROWEST);
    let excess = |i: &usize| power[*i] / alone.model[*i];
    let mut places: Vec<usize> = (LOBE + 1..n.checked_sub(LOBE + 1)?).collect();
    places.sort_by(|a, b| excess(b).total_cmp(&excess(a)));
    places.truncate(TRIED);
    places.extend((LOBE + 1..n - LOBE - 1).max_by(|a, b| power[*a].total_cmp(&power[*b])));
    let found = places
        .iter()
        .filter_map(|&place| with_sine(lines, &power, place))
        .min_by(|a, b| a.cost.total_cmp(&b.cost))?;
    let without = alone.cost.min(with_second(&power, &found));
    let rest = &found.rest;
    let is_mode = rest.over_noise >= MODE_OVER_NOISE
        && rest.half_width >= MODE_WIDE
        && (rest.centre - found.line).abs() <= 1.5 * rest.half_width;
    Some(Sine {
        line: found.line,
        strength: found.amplitude.norm_sqr() / (PI * rest.half_width * rest.top).max(f64::MIN_POSITIVE),
        half_width: rest.half_width,
        gain: without - found.cost,
        mode_remains: is_mode,
        left: found.left,
    })
}

struct WithSine {
    line: f64,
    amplitude: Complex64,
    rest: OneMode,
    left: Vec<f64>,
    cost: f64,
}

/// The most likely mode and sine near a line, fitted in turn.
fn with_sine(lines: &[Complex64], power: &[f64], place: usize) -> Option<WithSine> {
    const TURNS: usize = 3;
    let lobe: Vec<usize> = (place - LOBE..=place + LOBE).collect();
    let mut rest = fitted(power, &lobe, NARROWEST);
    let mut found = None;
    for _ in 0..TURNS {
        let (line, amplitude) = sine_in(lines, &rest.model, place);
        let left = lines.iter().enumerate().map(|(i, z)| {
            let rest = z - amplitude * of_sine(i as f64 - line);
            rest.norm_sqr()
        });
        let left = floored(left.collect())?;
        rest = fitted(&left, &[], NARROWEST);
        found = Some((line, amplitude, left));
    }
    let (line, amplitude, left) = found?;
    Some(WithSine {
        line,
        amplitude,
        left,
        cost: rest.cost,
        rest,
    })
}

/// Place and amplitude of the sine that lowers Σ |z − A s|²/m most.
fn sine_in(lines: &[Complex64], model: &[f64], place: usize) -> (f64, Complex64) {
    let (mut most, mut best) = (-1.0, (place as f64, Complex64::ZERO));
    let steps = (1.0 / STEP).round() as usize;
    for step in 0..=2 * steps {
        let line = place as f64 - 1.0 + step as f64 * STEP;
        let (mut along, mut size) = (Complex64::ZERO, 0.0);
        for (i, (z, m)) in lines.iter().zip(model).enumerate() {
            let s = of_sine(i as f64 - line);
            along += s.conj() * z / m;
            size += s.norm_sqr() / m;
        }
        let lowers = along.norm_sqr() / size;
        if lowers > most {
            (most, best) = (lowers, (line, along / size));
        }
    }
    best
}

/// Least cost of two modes, the second of them where the sine is.
fn with_second(power: &[f64], found: &WithSine) -> f64 {
    const TIMES: [f64; 5] = [1.0, 1.6, 2.5, 4.0, 6.0];
    let rest = &found.rest;
    let top = found.amplitude.norm_sqr();
    let mut least = f64::INFINITY;
    for times in TIMES {
        let half_width = (ALIKE * times * rest.half_width).max(NARROWEST);
        for shift in [-0.5, 0.0, 0.5] {
            let at = found.line + shift * half_width.min(2.0);
            let second: Vec<f64> = (0..power.len()).map(|i| lorentz(i, at, half_width)).collect();
            for step in 0..=16 {
                let size = top * 10f64.powf(-0.2 * f64::from(step));
                let each = power.iter().zip(&rest.model).zip(&second);
                let cost: f64 = each
                    .map(|((p, m), second)| {
                        let m = m + size * second;
                        m.ln() + p / m
                    })
                    .sum();
                least = least.min(cost);
            }
        }
    }
    least
}

/// Transform of the taper over its value at 0, `x` lines from the sine; the phase is that of a record that begins at time 0.
fn of_sine(x: f64) -> Complex64 {
    let flat = (1.0 - 0.5 * TAPERED) * PI * x;
    let sinc = if flat.abs() < 1e-9 { 1.0 } else { flat.sin() / flat };
    let edge = (TAPERED * x).abs();
    let edges = match (1.0 - edge).abs() < 1e-6 {
        true => 0.25 * PI,
        false => (0.5 * PI * edge).cos() / (1.0 - edge * edge),
    };
    Complex64::from_polar(1.0, -PI * x) * (sinc * edges)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    /// The sum over 2000 samples, and the limit of the closed form at its pole.
    #[test]
    fn exact_the_transform_of_the_taper_is_its_sum() {
        let n = 2000;
        let weight = |t: usize| taper((t as f64 + 0.5) / n as f64);
        let whole: f64 = (0..n).map(weight).sum();
        for x in [0.0, 0.3, 1.7, -4.6, 10.0, 13.2] {
            let each = (0..n).map(|t| {
                let turn = -2.0 * PI * x * (t as f64 + 0.5) / n as f64;
                Complex64::from_polar(weight(t), turn)
            });
            let sum = each.sum::<Complex64>() / whole;
            assert!((sum - of_sine(x)).norm() < 1e-6, "{x}: {sum} {}", of_sine(x));
        }
    }

    /// Lines of a mode of this half width, 20 dB above noise, and a sine of `power` times its peak at line 67.3 of 129.
    fn lines(half_width: f64, power: f64, seed: u64) -> Vec<Complex64> {
        let mut random = Random::new(seed, 0);
        let each = (0..129).map(|i| {
            let mode = if half_width > 0.0 {
                lorentz(i, 64.0, half_width)
            } else {
                0.0
            };
            let size = (0.5 * (mode + 0.01)).sqrt();
            let chance = Complex64::new(size * random.normal(), size * random.normal());
            chance + power.sqrt() * of_sine(i as f64 - 67.3)
        });
        each.collect()
    }

    fn found(power: f64, seed: u64) -> Option<Sine> {
        best_sine(&lines(9.0, power, seed)).filter(|sine| sine.mode_remains)
    }

    #[test]
    fn holds_nothing_is_left_of_a_sine_and_a_mode_beside_it_is() {
        for seed in 0..10 {
            let alone = best_sine(&lines(0.0, 66.0, seed)).unwrap();
            assert!(alone.leaves(65.5, 2.0) < 2.5, "{}", alone.leaves(65.5, 2.0));
            let beside = best_sine(&lines(2.0, 66.0, seed)).unwrap();
            assert!(beside.leaves(64.0, 2.0) > 5.0, "{}", beside.leaves(64.0, 2.0));
        }
    }

    #[test]
    fn holds_a_sine_is_found_and_none_where_none_is() {
        let seen: Vec<Sine> = (0..20).filter_map(|seed| found(66.0, seed)).collect();
        let clear: Vec<&Sine> = seen.iter().filter(|sine| sine.gain >= 12.0).collect();
        assert!(clear.len() >= 18, "{}", clear.len());
        for sine in clear {
            assert!((sine.line - 67.3).abs() < 0.25, "{}", sine.line);
            // 66 over π times 9 lines
            assert!((1.0..5.0).contains(&sine.strength), "{}", sine.strength);
        }
        let by_chance = (100..130).filter_map(|seed| found(0.0, seed));
        let most = by_chance.map(|sine| sine.gain).fold(0.0, f64::max);
        assert!(most < 12.0, "{most}");
    }
}
