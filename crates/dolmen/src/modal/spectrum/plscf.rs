//! Poly-reference least squares in the frequency domain: a right matrix fraction of every degree, fitted to half spectra.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | l, r, p | `channels`, `references`, `degree` | channels, reference channels, degree of the polynomials | |
//! | M, N | `lags` | longest lag; N = M + 1 lines on the whole circle | |
//! | S⁺ | `HalfSpectra` | half spectrum, e^(-βk) R_k transformed | l × r |
//! | A, B, λ | fraction_fit.rs | denominator, numerator, poles | r × r, l × r |

use super::fraction_fit::Fit;
use super::half_spectra::{HalfSpectra, Sums};
use super::plscf_options::Plscf;
use crate::modal::correlations::{Correlations, correlate_decimated};
use crate::modal::error::{at_least, references_of, refused};
use crate::modal::subspace::Pole;
use crate::modal::{Method, ModalError};
use crate::signal::Record;

/// Poles of every degree, with the data for their standard deviations.
#[derive(Clone, Debug)]
pub struct MatrixFraction {
    /// All oscillating poles whose windowed correlation decays, by order, then by frequency.
    pub poles: Vec<Pole>,
    /// The method of identification.
    pub method: Method,
    /// Reference channels, by index.
    pub references: Vec<usize>,
    /// Number of fitted lines.
    pub lines: usize,
    /// Highest order: reference channels × degree.
    pub order_most: usize,
    /// Sampling rate after decimation, Hz.
    pub sampling_rate_hz: f64,
    /// Duration of the record, s.
    pub duration_s: f64,
    pub(super) options: Plscf,
    pub(super) correlations: Correlations,
}

/// Poles of an ambient record from its half spectra, for all model orders up to `order_most`.
///
/// ```text
/// S⁺(ω) = ½ R_0 + Σ e^(-βk) R_k e^(-iωk),  k = 1 … M,  ω = 2πm/(M + 1)      shape: l × r
/// min Σ_ω |B(ω) - S⁺(ω) A(ω)|²,  A = I + Σ α_k z^k,  B = Σ β_k z^k,  z = e^(iω),  k ≤ p
/// det A(λ) = 0;  μ = (ln λ + β)/dt;  f = |μ|/2π;  ζ = -Re μ/|μ|;  shape = B(λ) v with A(λ) v = 0
/// ```
/// At these lines the sum up to lag M is a rational function of z for every mode (λ^(M+1) is the same at each line), so no window
/// causes leakage. The window reduces the noise of large lags, and β removes its decay from the damping. A constant in S⁺, such as
/// white sensor noise, becomes part of the numerator. The lowest coefficient is fixed to I; poles that fit noise are then outside
/// the unit circle, where they grow in time, and are left out.
///
/// # Errors
/// [`ModalError::Option`], [`ModalError::TooShort`], [`ModalError::Linalg`].
///
/// # Limits
/// The poles themselves weight the noise in linear least squares, so damping is biased, more for weak modes. For exact correlations
/// the poles are accurate to 1e-9 (a test); the book gives measured biases.
///
/// # Source
/// Peeters, Van der Auweraer, Guillaume & Leuridan (2004) Shock Vib. 11:395-409; Peeters & Van der Auweraer (2005) Proc. 1st IOMAC;
/// for the fixed coefficient: Cauberghe (2004) thesis, Vrije Universiteit Brussel. Differs from the sources: lines for which the
/// truncated correlations are exact; shapes from the numerator instead of a later fit of residues.
pub fn plscf(record: &Record, options: &Plscf) -> Result<MatrixFraction, ModalError> {
    let options = check(options, record)?;
    let lags = (options.lags, options.time_blocks);
    let all: Vec<usize> = (0..record.channels().len()).collect();
    let correlations = correlate_decimated(record, lags, (options.decimation, false), &all)?;
    fraction(correlations, options, record.duration_s())
}

pub(super) fn fraction(
    correlations: Correlations,
    options: Plscf,
    duration_s: f64,
) -> Result<MatrixFraction, ModalError> {
    let spectra = HalfSpectra::new(&correlations, &correlations.mean, &options);
    let degree_most = options.order_most / options.references.len();
    let sums = Sums::new(&spectra, degree_most);
    let mut poles = Vec::new();
    for degree in 1..=degree_most {
        let fit = Fit::new(&sums, degree)?;
        poles.extend(fit.poles(spectra.beta, correlations.step_s)?);
    }
    Ok(MatrixFraction {
        poles,
        method: Method::Plscf,
        references: options.references.clone(),
        lines: spectra.omega.len(),
        order_most: degree_most * options.references.len(),
        sampling_rate_hz: 1.0 / correlations.step_s,
        duration_s,
        options,
        correlations,
    })
}

pub(super) fn check(options: &Plscf, record: &Record) -> Result<Plscf, ModalError> {
    let channels = record.channels().len();
    let options = Plscf {
        references: references_of(&options.references, channels)?,
        ..options.clone()
    };
    at_least(&[
        ("lags", options.lags, 4, "at least 4"),
        ("decimation", options.decimation, 1, "at least 1"),
        ("time_blocks", options.time_blocks, 2, "at least 2"),
        (
            "order_most",
            options.order_most,
            options.references.len().max(2),
            "at least 2, and at least the reference channels",
        ),
    ])?;
    if !(options.window_end > 0.0 && options.window_end <= 1.0) {
        return refused("window_end", options.window_end, "above 0 and at most 1");
    }
    if !(options.frequency_low_hz >= 0.0 && options.frequency_low_hz < options.frequency_high_hz) {
        let allowed = "at least 0 and below frequency_high_hz";
        return refused("frequency_low_hz", options.frequency_low_hz, allowed);
    }
    let rate_hz = record.sampling_rate_hz() / options.decimation as f64;
    let degree = options.order_most / options.references.len();
    let lines = HalfSpectra::range(&options, rate_hz).len();
    // number of real values in the lines of one output, and of unknowns in its numerator and in the denominator
    let (held, unknown) = (
        2 * lines * options.references.len(),
        (2 * degree + 1) * options.references.len(),
    );
    if unknown > held {
        let allowed = "at most the lines of the spectrum less one, times the reference channels: raise lags or widen the range";
        return refused("order_most", options.order_most as f64, allowed);
    }
    Ok(options)
}

#[cfg(test)]
mod tests {
    use super::super::fraction_deviation::FractionScatter;
    use super::*;
    use crate::modal::subspace::Deviations;
    use std::f64::consts::PI;

    const STEP_S: f64 = 0.05;
    const MODES: [(f64, f64, [f64; 3]); 3] = [
        (1.0, 0.01, [1.0, 0.5, -0.2]),
        (2.5, 0.03, [0.3, -0.8, 1.0]),
        (2.55, 0.02, [0.9, 1.0, 0.4]),
    ];
    const LAGS: usize = 80;

    /// Σ φ φᵀ e^(-ζωτ) cos(ω_d τ), with damping ratios multiplied by `more`, and white sensor noise at lag 0.
    fn lags_of(more: f64) -> Vec<f64> {
        let entry = |k: usize, a: usize, b: usize| -> f64 {
            let of = MODES.iter().map(|(f, zeta, phi)| {
                let (omega, tau, zeta) = (2.0 * PI * f, k as f64 * STEP_S, zeta * more);
                let turn = omega * (1.0 - zeta * zeta).sqrt() * tau;
                phi[a] * phi[b] * (-zeta * omega * tau).exp() * turn.cos()
            });
            of.sum::<f64>() + if k == 0 && a == b { 0.3 } else { 0.0 }
        };
        (0..=LAGS)
            .flat_map(|k| (0..9).map(move |i| entry(k, i / 3, i % 3)))
            .collect()
    }

    fn correlations(mean: Vec<f64>, deviations: Vec<Vec<f64>>) -> Correlations {
        Correlations {
            channels: 3,
            columns: vec![0, 1, 2],
            step_s: STEP_S,
            mean,
            deviations: deviations
                .iter()
                .map(|of| of.iter().map(|x| *x as f32).collect())
                .collect(),
            ends: None,
            padded: None,
        }
    }

    fn options(references: &[usize], order_most: usize) -> Plscf {
        Plscf {
            lags: LAGS,
            order_most,
            references: references.to_vec(),
            ..Plscf::default()
        }
    }

    fn agree(poles: &[&Pole], tolerance: f64) {
        assert_eq!(poles.len(), 3, "{poles:?}");
        for (pole, (frequency_hz, zeta, phi)) in poles.iter().zip(MODES) {
            assert!(
                (pole.frequency_hz / frequency_hz - 1.0).abs() < tolerance,
                "{pole:?}"
            );
            assert!((pole.damping_ratio - zeta).abs() < tolerance, "{pole:?}");
            for (z, phi) in pole.shape.iter().zip(phi) {
                assert!((z - phi).norm() < 1e3 * tolerance, "{pole:?}");
            }
        }
    }

    #[test]
    fn exact_poles_and_shapes_of_exact_correlations_whatever_the_window_and_the_lines() {
        // three pairs of poles: degree 2 with three references, degree 3 with two
        for (references, window_end, high_hz) in [
            (vec![0, 1, 2], 0.01, f64::INFINITY),
            (vec![0, 1, 2], 1.0, f64::INFINITY),
            (vec![0, 2], 0.001, 8.0),
        ] {
            let options = Plscf {
                window_end,
                frequency_high_hz: high_hz,
                ..options(&references, 6)
            };
            let found = fraction(correlations(lags_of(1.0), Vec::new()), options, 100.0).unwrap();
            let at_six: Vec<&Pole> = found.poles.iter().filter(|p| p.order == 6).collect();
            agree(&at_six, 1e-9);
        }
    }

    #[test]
    fn exact_poles_of_a_model_larger_than_the_system_are_its_own_and_no_other_stays() {
        let found = fraction(
            correlations(lags_of(1.0), Vec::new()),
            options(&[0, 1, 2], 15),
            100.0,
        )
        .unwrap();
        for order in [9, 12, 15] {
            let all: Vec<&Pole> = found.poles.iter().filter(|p| p.order == order).collect();
            agree(&all, 1e-6);
        }
    }

    #[test]
    fn exact_scatter_of_blocks_whose_damping_differs() {
        // difference of the correlations when all damping ratios increase by the factor 1 + ε: dζ = ε ζ, and df = 0
        let (mean, epsilon) = (lags_of(1.0), 1e-4);
        let block = |sign: f64| -> Vec<f64> {
            let moved = lags_of(1.0 + sign * epsilon);
            moved.iter().zip(&mean).map(|(a, b)| a - b).collect()
        };
        let deviations = vec![block(1.0), block(-1.0)];
        let found = fraction(
            correlations(mean.clone(), deviations),
            options(&[0, 1, 2], 6),
            100.0,
        )
        .unwrap();
        let mut scatter = FractionScatter::new(&found);
        for (pole, (_, zeta, _)) in found.poles.iter().filter(|p| p.order == 6).zip(MODES) {
            // b/(b - 1) Σ = 2 × 2 (ε ζ)²
            let d = scatter.deviation(pole).unwrap();
            assert!(
                (d.damping_ratio_sd / (2.0 * epsilon * zeta) - 1.0).abs() < 1e-3,
                "{d:?} {zeta}"
            );
            assert!(
                d.frequency_sd_hz < 1e-3 * d.damping_ratio_sd * pole.frequency_hz,
                "{d:?}"
            );
            assert_eq!(scatter.frequency_sd_hz(pole).unwrap(), d.frequency_sd_hz);
        }
    }

    #[test]
    fn refuses_options_that_no_lines_can_hold() {
        use crate::signal::Channel;
        let record = Record::new(
            vec![Channel::named("a"), Channel::named("b")],
            vec![vec![0.0; 100], vec![1.0; 100]],
            20.0,
        )
        .unwrap();
        let refusal = |options: Plscf| plscf(&record, &options).unwrap_err().to_string();
        for (options, start) in [
            (options(&[], 1), "order_most is 1, but must be at least 2"),
            (options(&[2], 4), "references is 2"),
            (
                Plscf {
                    window_end: 0.0,
                    ..options(&[], 4)
                },
                "window_end is 0",
            ),
            (
                Plscf {
                    frequency_low_hz: 3.0,
                    frequency_high_hz: 2.0,
                    ..options(&[], 4)
                },
                "frequency_low_hz is 3",
            ),
            (
                Plscf {
                    frequency_high_hz: 1.0,
                    ..options(&[], 40)
                },
                "order_most is 40",
            ),
        ] {
            let fault = refusal(options);
            assert!(fault.starts_with(start), "{fault}");
        }
    }
}
