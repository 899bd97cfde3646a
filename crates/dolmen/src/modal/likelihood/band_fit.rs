//! Maximum likelihood fit of the modes in one band of the spectrum.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | z | `product` (mean of z z*) | Fourier sums of the channels, projected on the shapes | r |
//! | S | `Band::expected` | expected contribution of the modes, other modes and all other motion | r × r |
//! | F | | Fisher information | free parameters, squared |

use super::band::{Band, Free};
use super::band_motion::{Recorded, Spectra};
use super::hermitian::{adjoint, behind, lower, plus, real, scaled, times, whitened};
use dolmen_linalg::{ComplexMatrix, Matrix, cholesky, solve, solve_lower, solve_lower_transposed};

/// Neighbouring lines with the same expected spectrum.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub(super) frequency_hz: f64,
    pub(super) lines: f64,
    /// Mean of z z* over the lines.
    pub(super) product: ComplexMatrix,
    /// Contribution of the modes of other bands.
    pub(super) others: ComplexMatrix,
}

#[derive(Clone, Debug)]
pub(super) struct BandFit {
    pub(super) band: Band,
    free: Vec<Free>,
    /// Inverse of the information.   shape: free × free
    covariance: Matrix,
    recorded: Recorded,
    log_likelihood: f64,
}

/// Largest number of steps of the search; ten are usual.
const STEPS_MOST: usize = 200;
/// Damping of the search above which no step can increase the likelihood: its maximum is outside the possible values.
const DAMP_MOST: f64 = 1e9;
/// Expected gain of a step in log-likelihood, a hundredth of a standard deviation, at which a search ends.
pub(super) const PROMISE_LEAST: f64 = 1e-4;

/// Where a search ends.
pub(super) struct Maximum {
    pub(super) log_likelihood: f64,
    band: Band,
    free: Vec<Free>,
    /// F.   shape: free × free
    information: Matrix,
}

/// The band with the highest likelihood, starting from `start`; `None` if the search finds no maximum or the maximum is flat.
pub(super) fn fit(cells: &[Cell], start: Band, recorded: Recorded) -> Option<BandFit> {
    let found = maximum(cells, start, recorded, &|_| PROMISE_LEAST)?;
    Some(BandFit {
        band: found.band,
        free: found.free,
        covariance: inverse(&found.information)?,
        recorded,
        log_likelihood: found.log_likelihood,
    })
}

/// The highest likelihood, starting from `start`: the search ends when the expected gain of a step in log-likelihood is below
/// `promise_least` of the log-likelihood that it has reached. `None` if it finds no maximum.
///
/// ```text
/// ln L = - Σ n (ln det S + tr S⁻¹ zz*),   step (F + λ diag F) δ = g
/// g_a = Σ n tr(S⁻¹ ∂_a S S⁻¹ (zz* - S)),  F_ab = Σ n tr(S⁻¹ ∂_a S S⁻¹ ∂_b S)       one largest component of each shape is fixed
/// ```
///
/// # Source
/// Whittle (1953) Ark. Mat. 2:423-434, with the expected periodogram in place of the spectrum (Sykulski et al. 2019 Biometrika 106:251-266). With
/// flat priors it is the most probable value of Au (2011) Mech. Syst. Signal Process. 26:201-217.
pub(super) fn maximum(
    cells: &[Cell],
    start: Band,
    recorded: Recorded,
    promise_least: &dyn Fn(f64) -> f64,
) -> Option<Maximum> {
    let free = start.free();
    let mut band = start;
    let mut log_likelihood = likelihood_of(cells, &band, recorded)?;
    let mut damp = 1e-3;
    for _ in 0..STEPS_MOST {
        let (gradient, information) = derivatives(cells, &band, &free, recorded)?;
        if inner(&gradient, &step(&gradient, &information, 0.0)?) < promise_least(log_likelihood) {
            return Some(Maximum {
                log_likelihood,
                band,
                free,
                information,
            });
        }
        loop {
            let step = step(&gradient, &information, damp)?;
            let moved = band.moved(&free, &step);
            let found = likelihood_of(cells, &moved, recorded).filter(|new| *new > log_likelihood);
            if let Some(new) = found {
                (band, log_likelihood) = (moved, new);
                damp *= 0.1;
                break;
            }
            if damp > DAMP_MOST {
                return None;
            }
            damp *= 10.0;
        }
    }
    None
}

/// Solution δ of (F + λ diag F) δ = g, scaled for each free parameter.
fn step(gradient: &[f64], information: &Matrix, damp: f64) -> Option<Vec<f64>> {
    let n = gradient.len();
    let scale: Vec<f64> = (0..n).map(|i| 1.0 / information[(i, i)].sqrt()).collect();
    let damped = Matrix::from_fn(n, n, |i, j| {
        scale[i] * information[(i, j)] * scale[j] + if i == j { damp } else { 0.0 }
    });
    let scaled: Vec<f64> = gradient.iter().zip(&scale).map(|(g, s)| g * s).collect();
    let step = solve(&damped, &Matrix::from_column(&scaled)).ok()?;
    Some(step.column(0).iter().zip(&scale).map(|(x, s)| x * s).collect())
}

/// Inverse of a positive definite matrix, with each row scaled first.
fn inverse(a: &Matrix) -> Option<Matrix> {
    let n = a.rows();
    let scale: Vec<f64> = (0..n).map(|i| 1.0 / a[(i, i)].sqrt()).collect();
    let scaled = Matrix::from_fn(n, n, |i, j| scale[i] * a[(i, j)] * scale[j]);
    let lower = cholesky(&scaled).ok()?;
    let half = solve_lower(&lower, Matrix::identity(n)).ok()?;
    let whole = solve_lower_transposed(&lower, half).ok()?;
    Some(Matrix::from_fn(n, n, |i, j| scale[i] * whole[(i, j)] * scale[j]))
}

impl BandFit {
    /// Logarithm of the likelihood.
    pub(super) fn log_likelihood(&self) -> f64 {
        self.log_likelihood
    }

    /// Difference between the recorded and the expected power, in its standard deviations: 0 ± 1 for a true model, more for an incomplete model.
    ///
    /// ```text
    /// t = Σ (Σ n tr S⁻¹ zz* - n r)² / (n r)     over parts of the band of `PART` lines or more, as many as its degrees of freedom; (t - ν)/√2ν
    /// ```
    pub(super) fn misfit(&self, cells: &[Cell]) -> Option<f64> {
        const PART: f64 = 24.0;
        let spectra = self.spectra();
        let (mut parts, mut sum, mut lines) = (Vec::new(), 0.0, 0.0);
        for cell in cells {
            let d = spectra.at(cell.frequency_hz);
            let lower = lower(&plus(&self.band.expected(&d, cell.frequency_hz), &cell.others))?;
            let white = whitened(&lower, &cell.product);
            let r = white.rows();
            sum += cell.lines * (0..r).map(|i| white[(i, i)].re - 1.0).sum::<f64>();
            lines += cell.lines;
            if lines >= PART {
                parts.push(sum / (lines * r as f64).sqrt());
                (sum, lines) = (0.0, 0.0);
            }
        }
        let freedom = parts.len() as f64;
        Some((inner(&parts, &parts) - freedom) / (2.0 * freedom).sqrt())
    }

    /// Variances of the frequency, Hz², and of the damping ratio of each mode, from the information matrix.
    pub(super) fn variances(&self) -> Vec<[f64; 2]> {
        let of = |i: usize| self.covariance[(i, i)];
        (0..self.band.oscillators.len())
            .map(|i| [of(2 * i), of(2 * i + 1)])
            .collect()
    }

    /// Part of S due to the modes. `across` holds their shapes in the coordinates of the result.
    pub(super) fn motion(
        &self,
        spectra: &Spectra,
        across: &ComplexMatrix,
        frequency_hz: f64,
    ) -> ComplexMatrix {
        let motion = self.band.under_forces(&spectra.at(frequency_hz));
        scaled(
            &times(&times(across, &motion), &adjoint(across)),
            self.band.risen(frequency_hz),
        )
    }

    pub(super) fn spectra(&self) -> Spectra {
        Spectra::new(&self.band.oscillators, self.recorded)
    }

    /// Matrices W of a line, for each frequency and each damping ratio: the line contributes z* W z minus its mean to the estimate.
    pub(super) fn influence(
        &self,
        spectra: &Spectra,
        frequency_hz: f64,
        others: &ComplexMatrix,
    ) -> Option<Vec<ComplexMatrix>> {
        let (r, m) = (self.band.noise.rows(), self.band.oscillators.len());
        let d = spectra.at(frequency_hz);
        let lower = lower(&plus(&self.band.expected(&d, frequency_hz), others))?;
        let mut sums = vec![ComplexMatrix::zeros(r, r); 2 * m];
        for (a, free) in self.free.iter().enumerate() {
            let slope = self.band.derivative(*free, spectra, frequency_hz, &d);
            let turned = behind(&lower, &whitened(&lower, &slope));
            for (t, sum) in sums.iter_mut().enumerate() {
                for j in 0..r {
                    for i in 0..r {
                        sum[(i, j)] += self.covariance[(t, a)] * turned[(i, j)];
                    }
                }
            }
        }
        Some(sums)
    }
}

fn likelihood_of(cells: &[Cell], band: &Band, recorded: Recorded) -> Option<f64> {
    if !band.possible() {
        return None;
    }
    let spectra = Spectra::new(&band.oscillators, recorded);
    let mut sum = band.log_prior()?;
    for cell in cells {
        let s = plus(
            &band.expected(&spectra.at(cell.frequency_hz), cell.frequency_hz),
            &cell.others,
        );
        let lower = lower(&s)?;
        let white = whitened(&lower, &cell.product);
        let each = (0..s.rows()).map(|i| 2.0 * lower[(i, i)].re.ln() + white[(i, i)].re);
        sum -= cell.lines * each.sum::<f64>();
    }
    sum.is_finite().then_some(sum)
}

fn derivatives(cells: &[Cell], band: &Band, free: &[Free], recorded: Recorded) -> Option<(Vec<f64>, Matrix)> {
    let spectra = Spectra::new(&band.oscillators, recorded);
    let mut gradient = vec![0.0; free.len()];
    let mut information = Matrix::zeros(free.len(), free.len());
    for cell in cells {
        let d = spectra.at(cell.frequency_hz);
        let s = plus(&band.expected(&d, cell.frequency_hz), &cell.others);
        let lower = lower(&s)?;
        let white = whitened(&lower, &cell.product);
        let r = s.rows();
        let left = real(&ComplexMatrix::from_fn(r, r, |i, j| {
            white[(i, j)] - f64::from(u8::from(i == j))
        }));
        let slopes: Vec<Vec<f64>> = free
            .iter()
            .map(|free| {
                real(&whitened(
                    &lower,
                    &band.derivative(*free, &spectra, cell.frequency_hz, &d),
                ))
            })
            .collect();
        for (a, slope) in slopes.iter().enumerate() {
            gradient[a] += cell.lines * inner(slope, &left);
            for (b, other) in slopes.iter().enumerate().take(a + 1) {
                information[(a, b)] += cell.lines * inner(slope, other);
            }
        }
    }
    for a in 0..free.len() {
        for b in a + 1..free.len() {
            information[(a, b)] = information[(b, a)];
        }
    }
    band.add_prior(free, &mut gradient, &mut information)?;
    Some((gradient, information))
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::super::band::Tilt;
    use super::super::band_motion::{CrossSpectrum, Oscillator};
    use super::*;
    use dolmen_linalg::Complex64;

    const RECORDED: Recorded = Recorded {
        derivatives: 2,
        duration_s: 600.0,
    };

    fn oscillator(frequency_hz: f64, damping_ratio: f64) -> Oscillator {
        Oscillator {
            frequency_hz,
            damping_ratio,
        }
    }

    fn matrix(of: [[(f64, f64); 2]; 2]) -> ComplexMatrix {
        ComplexMatrix::from_fn(2, 2, |i, j| Complex64::new(of[i][j].0, of[i][j].1))
    }

    /// Two modes 2 % apart under coherent forces that increase with frequency.
    fn pair() -> Band {
        Band {
            oscillators: vec![oscillator(1.5, 0.01), oscillator(1.53, 0.013)],
            shapes: matrix([[(1.0, 0.0), (0.2, 0.1)], [(-0.1, 0.05), (1.0, 0.0)]]),
            forces: matrix([[(2.0, 0.0), (0.5, 0.2)], [(0.5, -0.2), (1.0, 0.0)]]),
            noise: matrix([[(0.5, 0.0), (0.1, 0.0)], [(0.1, 0.0), (0.7, 0.0)]]),
            range_hz: [1.2, 1.8],
            rise: 1.5,
            independent: false,
            tilt: None,
        }
    }

    /// Cells with exactly the expected spectrum of the band.
    fn exact(band: &Band) -> Vec<Cell> {
        let spectra = Spectra::new(&band.oscillators, RECORDED);
        let [low, high] = band.range_hz;
        let r = band.noise.rows();
        (0..300)
            .map(|i| {
                let frequency_hz = low + (high - low) * (f64::from(i) + 0.5) / 300.0;
                Cell {
                    frequency_hz,
                    lines: RECORDED.duration_s * (high - low) / 300.0,
                    product: band.expected(&spectra.at(frequency_hz), frequency_hz),
                    others: ComplexMatrix::zeros(r, r),
                }
            })
            .collect()
    }

    #[test]
    fn exact_expected_spectra_give_their_band_back() {
        let truth = pair();
        let mut start = truth.clone();
        start.oscillators = vec![oscillator(1.497, 0.014), oscillator(1.534, 0.010)];
        start.shapes = matrix([[(1.0, 0.0), (0.0, 0.0)], [(0.0, 0.0), (1.0, 0.0)]]);
        start.forces = matrix([[(3.0, 0.0), (0.0, 0.0)], [(0.0, 0.0), (2.0, 0.0)]]);
        start.noise = matrix([[(1.0, 0.0), (0.0, 0.0)], [(0.0, 0.0), (1.0, 0.0)]]);
        start.rise = 0.0;
        let found = fit(&exact(&truth), start, RECORDED).unwrap().band;
        // the search ends within a hundredth of a standard deviation of the maximum
        for (found, truth) in found.oscillators.iter().zip(&truth.oscillators) {
            assert!(
                (found.frequency_hz / truth.frequency_hz - 1.0).abs() < 2e-5,
                "{found:?}"
            );
            assert!(
                (found.damping_ratio / truth.damping_ratio - 1.0).abs() < 2e-3,
                "{found:?}"
            );
        }
        assert!(
            (found.forces[(0, 1)] - truth.forces[(0, 1)]).norm() < 0.01,
            "{found:?}"
        );
        assert!((found.rise - truth.rise).abs() < 0.05, "{}", found.rise);
    }

    #[test]
    fn agrees_deviations_of_a_mode_alone_with_the_floor_of_long_records() {
        let (f, zeta) = (1.5, 0.01);
        let one = |x: f64| ComplexMatrix::from_fn(1, 1, |_, _| x.into());
        let band = Band {
            oscillators: vec![oscillator(f, zeta)],
            shapes: one(1.0),
            forces: one(1.0),
            noise: one(1e-4),
            range_hz: [0.6, 2.4],
            rise: 0.0,
            independent: false,
            tilt: None,
        };
        let found = fit(&exact(&band), band.clone(), RECORDED).unwrap();
        let [frequency, damping] = found.variances()[0];
        let turns = std::f64::consts::TAU * f * RECORDED.duration_s;
        let over = [
            frequency.sqrt() / (f * (zeta / turns).sqrt()),
            damping.sqrt() / (zeta / turns).sqrt(),
        ];
        // Au (2014): both ratios are 1 in an infinite band; a band of 60 half-power widths and the variable force density increase them
        assert!(over.iter().all(|x| (1.0..1.12).contains(x)), "{over:?}");
    }

    #[test]
    fn exact_influence_of_a_cell_is_what_the_estimate_moves_by() {
        let truth = pair();
        let mut cells = exact(&truth);
        let still = fit(&cells, truth.clone(), RECORDED).unwrap();
        let spectra = still.spectra();
        let (cell, by) = (140, 1e-3);
        let weights = still
            .influence(&spectra, cells[cell].frequency_hz, &cells[cell].others)
            .unwrap();
        let expected: Vec<f64> = weights
            .iter()
            .map(|w| {
                let product = times(w, &cells[cell].product);
                by * cells[cell].lines * (0..2).map(|i| product[(i, i)].re).sum::<f64>()
            })
            .collect();
        cells[cell].product = scaled(&cells[cell].product, 1.0 + by);
        let (gradient, information) = derivatives(&cells, &truth, &still.free, RECORDED).unwrap();
        let step = solve(&information, &Matrix::from_column(&gradient)).unwrap();
        for (a, expected) in expected.iter().enumerate() {
            assert!(
                (step[(a, 0)] - expected).abs() < 1e-6 * expected.abs(),
                "{a} {expected}"
            );
        }
    }

    #[test]
    fn exact_slopes_are_those_of_the_likelihood() {
        let truth = pair();
        let cells = exact(&truth);
        let free = truth.free();
        let mut off = truth.clone();
        off.oscillators[0].frequency_hz *= 1.003;
        off.noise[(0, 0)] *= 1.3;
        let (gradient, information) = derivatives(&cells, &off, &free, RECORDED).unwrap();
        for a in 0..free.len() {
            let by = 1e-4 / information[(a, a)].sqrt();
            let at = |sign: f64| {
                let mut step = vec![0.0; free.len()];
                step[a] = sign * by;
                likelihood_of(&cells, &off.moved(&free, &step), RECORDED).unwrap()
            };
            let slope = (at(1.0) - at(-1.0)) / (2.0 * by);
            let scale = information[(a, a)].sqrt();
            assert!(
                (slope - gradient[a]).abs() < 1e-4 * scale,
                "{:?} {slope} {}",
                free[a],
                gradient[a]
            );
        }
    }

    #[test]
    fn holds_a_band_with_a_mode_unseen_does_not_fit() {
        let truth = pair();
        let cells = exact(&truth);
        let found = fit(&cells, truth.clone(), RECORDED).unwrap();
        assert!(found.misfit(&cells).unwrap() < 0.0);
        let one = |m: &ComplexMatrix| ComplexMatrix::from_fn(1, 1, |i, j| m[(i, j)]);
        let seen: Vec<Cell> = cells
            .iter()
            .map(|cell| Cell {
                product: one(&cell.product),
                others: one(&cell.others),
                ..cell.clone()
            })
            .collect();
        let alone = Band {
            oscillators: vec![oscillator(1.6, 0.01)],
            shapes: one(&truth.shapes),
            forces: one(&truth.forces),
            noise: one(&truth.noise),
            ..truth
        };
        let mut far = seen;
        // another mode at 1.35 Hz, a tenth as strong
        let other = CrossSpectrum::new(oscillator(1.35, 0.01), oscillator(1.35, 0.01), RECORDED);
        for cell in &mut far {
            cell.product[(0, 0)] += 0.2 * other.at(cell.frequency_hz);
        }
        let found = fit(&far, alone, RECORDED).unwrap();
        assert!(found.misfit(&far).unwrap() > 10.0, "{:?}", found.misfit(&far));
    }
    /// A mode that fills its band leaves nothing of the noise to see: without a prior the search drives its density below zero and finds no maximum.
    #[test]
    fn holds_a_band_without_noise_is_fitted() {
        let one = |x: f64| ComplexMatrix::from_fn(1, 1, |_, _| x.into());
        let truth = Band {
            oscillators: vec![oscillator(1.5, 0.01)],
            shapes: one(1.0),
            forces: one(1.0),
            noise: one(1e-7),
            independent: false,
            range_hz: [1.3, 1.7],
            rise: -2.0,
            tilt: None,
        };
        let cells: Vec<Cell> = exact(&truth)
            .into_iter()
            .enumerate()
            .map(|(i, cell)| Cell {
                // what a record of finite length shows
                product: scaled(&cell.product, 1.0 + 0.4 * (2.399 * i as f64).sin()),
                ..cell
            })
            .collect();
        let start = |quiet: f64| Band {
            oscillators: vec![oscillator(1.503, 0.014)],
            noise: one(0.01),
            rise: 0.0,
            tilt: Some(Tilt {
                exponent: 0.0,
                quiet: one(quiet),
            }),
            ..truth.clone()
        };
        let found = fit(&cells, start(1e-3), RECORDED).unwrap().band;
        let off = found.oscillators[0].damping_ratio / 0.01 - 1.0;
        assert!(off.abs() < 0.1 && found.noise[(0, 0)].re > 0.0, "{found:?}");
    }

    #[test]
    fn exact_independent_forces_stay_so() {
        let truth = Band {
            forces: matrix([[(2.0, 0.0), (0.0, 0.0)], [(0.0, 0.0), (1.0, 0.0)]]),
            independent: true,
            ..pair()
        };
        let mut start = truth.clone();
        start.oscillators[0].damping_ratio = 0.013;
        let found = fit(&exact(&truth), start, RECORDED).unwrap();
        assert_eq!(found.free.len() + 2, pair().free().len());
        assert_eq!(found.band.coherence(), 0.0);
        let damping = found.band.oscillators[0].damping_ratio;
        assert!((damping / 0.01 - 1.0).abs() < 2e-3, "{damping}");
    }
}
