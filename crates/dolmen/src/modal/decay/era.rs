//! Free decays after a blow or a release: eigensystem realization, then a least-squares fit to the samples.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | H₀, H₁ | `hankel` | H(i, j) = y(i + j), and one sample later | l p × q |
//! | U, S, V | `svd` | of H₀ | n columns |
//! | μ | `root` | continuous-time eigenvalue -ζω + iω√(1-ζ²) | rad/s |
//! | B, D | decay_fit.rs | the exponentials of every mode, and their derivatives | samples × 2K |

use super::decay_fit::significant;
use crate::modal::error::refused;
use crate::modal::{Method, ModalError, Modes};
use crate::signal::Record;
use dolmen_linalg::{Complex64, Matrix, Svd, eigen, svd};

/// Largest number of rows of a Hankel matrix; more rows take many seconds.
const ROWS_MOST: usize = 500;
/// Columns per row: later samples have mostly decayed.
const COLUMNS_A_ROW: usize = 3;
const SAMPLES_LEAST: usize = 32;

/// Options of [`era`].
#[derive(Clone, Debug, PartialEq)]
pub struct Era {
    /// Block rows p; `None` (default): two fifths of the samples, but at most 500 rows in total.
    pub block_rows: Option<usize>,
    /// Order of the model; `None` (default): number of singular values above the noise.
    pub order: Option<usize>,
    /// Largest damping ratio of a mode; default 0.3 (our choice).
    pub damping_ratio_most: f64,
    /// Least modal amplitude coherence, 0 to 1; default 0.9 (our choice; noise stays below 0.8).
    pub coherence_least: f64,
}

impl Default for Era {
    fn default() -> Self {
        Era {
            block_rows: None,
            order: None,
            damping_ratio_most: 0.3,
            coherence_least: 0.9,
        }
    }
}

/// Modes of a free decay.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeDecay {
    /// The modes, by frequency.
    pub modes: Modes,
    /// Energy of each mode over that of the noise, in the same order.
    pub energy: Vec<f64>,
    /// Explained fraction of the motion: 1 minus the power of the residual over that of the record.
    pub explained: f64,
    /// Standard deviation of the residual of each channel, in its unit.
    pub noise: Vec<f64>,
    /// Residual of each channel, in its unit: channels × samples.
    pub rest: Vec<Vec<f64>>,
    /// Factor on the standard deviations of each mode, relative to white noise of the same power. It exceeds 1 if the residual contains the frequency
    /// of the mode, because forces still act on the structure.
    pub over_white: Vec<f64>,
    /// Singular values of H₀, descending.
    pub singular_values: Vec<f64>,
    /// Order of the model.
    pub order: usize,
    /// Block rows.
    pub block_rows: usize,
}

/// Modes of one free decay. The record must begin after the last force has ended.
///
/// ```text
/// H₀ = U S Vᵀ,  A = S^-½ Uᵀ H₁ V S^-½,  μ = ln(λ(A)) f_s                     first n singular values
/// y(t) = Re Σ_k a_k e^(μ_k t)                                                 least squares in a and μ, from the μ above
/// cov μ = v (Σ_c Dᵀ(I - BB⁺)D/σ_c²)⁻¹                                         the Cramér–Rao bound, σ_c² from the residual
/// v ≥ 1: the residual near each mode is white noise plus the response of that mode to white forces, with the most likely powers
/// ```
/// The order is the number of singular values above the optimal threshold for white noise, ω(β) times their median. A pole is a mode if it
/// oscillates, has an allowed damping ratio, and is coherent: its time series in V equals its own exponential. Frequencies, damping ratios and
/// amplitudes are then fitted to all samples together, which removes the truncation error.
///
/// # Errors
/// [`ModalError::DecayTooShort`], [`ModalError::Option`], [`ModalError::NoDecay`] if no mode exceeds the noise; [`ModalError::Linalg`].
///
/// # Limits
/// The method is linear. If a joint moves more in strong motion, its frequency rises as the motion decays; this appears as a low `explained`. The
/// noise must be white, or be the response of the structure to stationary forces; the standard deviations are then correct within a third (docs).
/// Poles of exact decays are accurate to 1e-9. With white noise of 5 % of the first amplitude, the scatter of frequency and damping equals the lower
/// bound (a test).
///
/// # Source
/// Juang & Pappa (1985) J. Guid. Control Dyn. 8(5):620-627. Threshold: Gavish & Donoho (2014) IEEE Trans. Inf. Theory 60(8):5040-5053. Differs from
/// the source: the order is chosen automatically, and a fit to all samples follows (Golub & Pereyra 2003, variable projection).
///
/// # Example
/// ```
/// use dolmen::modal::{Era, era};
/// use dolmen::signal::{Channel, Record};
/// let (f, zeta) = (2.0_f64, 0.03_f64);
/// let omega = 2.0 * std::f64::consts::PI * f;
/// let y = |i: usize| {
///     let t = 0.01 * i as f64;
///     (-zeta * omega * t).exp() * (omega * (1.0 - zeta * zeta).sqrt() * t).cos()
/// };
/// let record = Record::new(vec![Channel::named("top")], vec![(0..600).map(y).collect()], 100.0)?;
/// let found = era(&record, &Era::default())?;
/// let mode = &found.modes.modes[0];
/// assert!((mode.frequency_hz - f).abs() < 1e-9);
/// assert!(mode.damping_ratio.is_some_and(|z| (z - zeta).abs() < 1e-9));
/// # Ok::<(), dolmen::modal::ModalError>(())
/// ```
pub fn era(record: &Record, options: &Era) -> Result<FreeDecay, ModalError> {
    let (l, samples) = (record.channels().len(), record.length());
    let p = check(record, options)?;
    let q = (samples - p).min(COLUMNS_A_ROW * p * l);
    let of = |later: usize| Matrix::from_fn(l * p, q, |row, j| record.samples(row % l)[row / l + j + later]);
    let svd = svd(&of(0))?;
    let order = match options.order {
        Some(order) => order.min(svd.s.len()),
        None => order_above_noise(&svd.s, l * p, q),
    };
    let roots = realized(&svd, &of(1), order, record.sampling_rate_hz(), options)?;
    let fit = significant(record, roots, order)?;
    let mut ordered: Vec<usize> = (0..fit.roots.len()).collect();
    ordered.sort_by(|a, b| fit.roots[*a].norm().total_cmp(&fit.roots[*b].norm()));
    let modes = ordered
        .iter()
        .map(|k| fit.mode(*k, record.duration_s(), order))
        .collect();
    Ok(FreeDecay {
        modes: Modes {
            modes,
            channels: record.channels().to_vec(),
            method: Method::Era,
            duration_s: record.duration_s(),
            history: record.history().to_vec(),
        },
        energy: ordered.iter().map(|k| fit.energy[*k]).collect(),
        explained: fit.explained,
        over_white: ordered.iter().map(|k| fit.over_white[*k]).collect(),
        noise: fit.noise,
        rest: fit.rest,
        singular_values: svd.s,
        order,
        block_rows: p,
    })
}

/// Block rows of a record that is long enough.
fn check(record: &Record, options: &Era) -> Result<usize, ModalError> {
    let (l, samples) = (record.channels().len(), record.length());
    if samples < SAMPLES_LEAST {
        return Err(ModalError::DecayTooShort {
            samples,
            least: SAMPLES_LEAST,
        });
    }
    if !(options.damping_ratio_most > 0.0 && options.damping_ratio_most < 1.0) {
        return refused(
            "damping_ratio_most",
            options.damping_ratio_most,
            "above 0 and below 1",
        );
    }
    if !(0.0..=1.0).contains(&options.coherence_least) {
        return refused("coherence_least", options.coherence_least, "between 0 and 1");
    }
    if options.order.is_some_and(|order| order < 2) {
        return refused("order", options.order.unwrap_or(0) as f64, "at least 2");
    }
    let p = options
        .block_rows
        .unwrap_or((2 * samples / 5).min(ROWS_MOST / l).max(2));
    if p < 2 || p > samples / 2 {
        return refused("block_rows", p as f64, "at least 2 and at most half the samples");
    }
    Ok(p)
}

/// Number of singular values that white noise does not explain, rounded to an even number.
fn order_above_noise(s: &[f64], rows: usize, columns: usize) -> usize {
    let beta = rows.min(columns) as f64 / rows.max(columns) as f64;
    let omega = 0.56 * beta.powi(3) - 0.95 * beta * beta + 1.82 * beta + 1.43; // Gavish & Donoho, eq. 5
    let median = s.get(s.len() / 2).copied().unwrap_or(0.0);
    let rounding = 10.0 * f64::EPSILON * rows.max(columns) as f64 * s.first().copied().unwrap_or(0.0);
    let above = s.iter().filter(|x| **x > (omega * median).max(rounding)).count();
    above.div_ceil(2) * 2
}

/// Roots of the realized system that are modes, rad/s, the upper one of each pair.
fn realized(
    svd: &Svd,
    shifted: &Matrix,
    order: usize,
    rate_hz: f64,
    options: &Era,
) -> Result<Vec<Complex64>, ModalError> {
    let n = order.min(svd.s.len());
    if n < 2 {
        return Ok(Vec::new());
    }
    let (u, v) = (
        svd.u.block(0, 0, svd.u.rows(), n),
        svd.v.block(0, 0, svd.v.rows(), n),
    );
    let inner = &u.transpose_times(shifted) * &v;
    let a = Matrix::from_fn(n, n, |i, j| inner[(i, j)] / (svd.s[i] * svd.s[j]).sqrt());
    let e = eigen(&a)?;
    let left = eigen(&a.transpose())?;
    let mut roots = Vec::new();
    for lambda in &e.values {
        if lambda.im <= 0.0 || lambda.norm() == 0.0 {
            continue;
        }
        let root = lambda.ln() * rate_hz;
        let zeta = -root.re / root.norm();
        // left eigenvector: its row of Ψ⁻¹ S^½ Vᵀ is the motion of this mode over the columns
        let nearest = (0..n).min_by(|i, j| {
            let apart = |i: &usize| (left.values[*i] - lambda).norm();
            apart(i).total_cmp(&apart(j))
        });
        let Some(other) = nearest else { continue };
        let weights: Vec<Complex64> = (0..n)
            .map(|i| left.vectors[(i, other)] * svd.s[i].sqrt())
            .collect();
        let coherent = coherence(&weights, &v, *lambda) >= options.coherence_least;
        if zeta > 0.0 && zeta <= options.damping_ratio_most && coherent {
            roots.push(root);
        }
    }
    Ok(roots)
}

/// Modal amplitude coherence: similarity of the motion of a mode over the columns to an exponential.
fn coherence(weights: &[Complex64], v: &Matrix, lambda: Complex64) -> f64 {
    let (mut inner, mut own, mut ideal) = (Complex64::ZERO, 0.0, 0.0);
    let mut power = Complex64::ONE;
    for j in 0..v.rows() {
        let motion: Complex64 = weights.iter().enumerate().map(|(i, w)| w * v[(j, i)]).sum();
        inner += power.conj() * motion;
        own += motion.norm_sqr();
        ideal += power.norm_sqr();
        power *= lambda;
    }
    if own > 0.0 {
        inner.norm() / (own * ideal).sqrt()
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::Mode;
    use crate::numeric::Random;
    use crate::signal::Channel;
    use std::f64::consts::PI;

    const TRUTH: [(f64, f64, [f64; 3]); 3] = [
        (1.3, 0.02, [1.0, 0.6, 0.2]),
        (3.9, 0.01, [-0.5, 0.8, 0.7]),
        (4.1, 0.03, [0.6, -0.7, 0.9]),
    ];

    /// Three channels of three modes, 10 s at 50 Hz, and white noise.
    fn decay(noise: f64, seed: u64) -> Record {
        let mut random = Random::new(seed, 0);
        let channel = |c: usize| -> Vec<f64> {
            (0..500)
                .map(|i| {
                    let t = 0.02 * f64::from(i);
                    let swing = |(f, zeta, shape): &(f64, f64, [f64; 3])| {
                        let omega = 2.0 * PI * f;
                        shape[c] * (-zeta * omega * t).exp() * (omega * (1.0 - zeta * zeta).sqrt() * t).sin()
                    };
                    TRUTH.iter().map(swing).sum::<f64>()
                })
                .collect()
        };
        let mut samples: Vec<Vec<f64>> = (0..3).map(channel).collect();
        for x in samples.iter_mut().flatten() {
            *x += noise * random.normal();
        }
        let names = (0..3).map(|c| Channel::named(format!("{c}"))).collect();
        Record::new(names, samples, 50.0).unwrap()
    }

    #[test]
    fn exact_decays_give_their_poles_and_shapes() {
        let found = era(&decay(0.0, 0), &Era::default()).unwrap();
        assert_eq!((found.modes.modes.len(), found.order), (3, 6));
        for (mode, (f, zeta, shape)) in found.modes.modes.iter().zip(TRUTH) {
            assert!((mode.frequency_hz / f - 1.0).abs() < 1e-9, "{mode:?}");
            assert!(
                (mode.damping_ratio.unwrap() / zeta - 1.0).abs() < 1e-9,
                "{mode:?}"
            );
            let truth: Vec<Complex64> = shape.map(|x| Complex64::new(x, 0.0)).to_vec();
            assert!(crate::modal::assurance(&mode.shape, &truth) > 1.0 - 1e-12);
        }
        assert!(found.explained > 1.0 - 1e-15);
    }

    #[test]
    fn holds_the_scatter_in_noise_is_that_of_the_bound_and_is_stated() {
        const RUNS: u64 = 100;
        let quick = Era {
            block_rows: Some(40),
            ..Era::default()
        };
        let runs: Vec<Vec<Mode>> = (0..RUNS)
            .map(|seed| era(&decay(0.05, 10 + seed), &quick).unwrap().modes.modes)
            .collect();
        assert!(
            runs.iter().all(|modes| modes.len() == 3),
            "every mode and no other"
        );
        let n = RUNS as f64;
        for (k, (f, zeta, _)) in TRUTH.iter().enumerate() {
            // square root of the mean squared error over the stated variance: 1 ± 0.07 for 100 runs
            let ratio = |off: &dyn Fn(&Mode) -> f64| {
                (runs.iter().map(|modes| off(&modes[k]).powi(2)).sum::<f64>() / n).sqrt()
            };
            let of_f = ratio(&|m| (m.frequency_hz - f) / m.frequency_sd_hz.unwrap());
            let of_zeta = ratio(&|m| (m.damping_ratio.unwrap() - zeta) / m.damping_ratio_sd.unwrap());
            assert!(
                (0.8..1.25).contains(&of_f) && (0.8..1.25).contains(&of_zeta),
                "{f} Hz: {of_f} {of_zeta}"
            );
        }
    }

    #[test]
    fn exact_bound_of_one_decay_in_noise() {
        // many cycles that decay completely within the record: Σ t² e^(-2αt) minus its projection on e^(-αt), halved for real samples: var ω = 16 σ²
        // α³ Δt / |a|²
        let (f, zeta, sigma) = (5.0, 0.02, 0.01);
        let omega = 2.0 * PI * f;
        let mut random = Random::new(1, 0);
        let y: Vec<f64> = (0..4000)
            .map(|i| {
                let t = 0.01 * f64::from(i);
                (-zeta * omega * t).exp() * (omega * (1.0 - zeta * zeta).sqrt() * t).cos()
                    + sigma * random.normal()
            })
            .collect();
        let record = Record::new(vec![Channel::named("y")], vec![y], 100.0).unwrap();
        let found = era(&record, &Era::default()).unwrap();
        assert_eq!(found.modes.modes.len(), 1);
        let alpha = zeta * omega;
        let sd = (16.0 * sigma * sigma * alpha.powi(3) * 0.01).sqrt() / (2.0 * PI);
        let stated = found.modes.modes[0].frequency_sd_hz.unwrap();
        assert!((stated / sd - 1.0).abs() < 0.06, "{stated:e} {sd:e}");
    }

    #[test]
    fn refuses_noise_and_what_is_too_short() {
        let mut random = Random::new(4, 0);
        let noise: Vec<f64> = (0..400).map(|_| random.normal()).collect();
        let record = |y: Vec<f64>| Record::new(vec![Channel::named("y")], vec![y], 50.0).unwrap();
        let message = era(&record(noise.clone()), &Era::default())
            .unwrap_err()
            .to_string();
        assert!(
            message.starts_with("nothing in the record decays as a mode does"),
            "{message}"
        );
        let message = era(&record(noise[..20].to_vec()), &Era::default())
            .unwrap_err()
            .to_string();
        assert!(
            message.starts_with("the decay has 20 samples, but needs 32"),
            "{message}"
        );
    }
}
