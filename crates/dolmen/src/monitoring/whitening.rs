//! Whitens a series of readings with independent noise and a disturbance whose correlation decays in time, by a Kalman filter.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | n | `at.len()` | number of surveys | - |
//! | t_i | `at` | time of a survey, in units of the usual interval between surveys | - |
//! | σ_i | `noise_sd` | standard deviation stated by the survey | as y |
//! | s | `sd` | standard deviation of the disturbance | as y |
//! | φ | `correlation` | correlation of the disturbance over one interval | - |
//! | V | | Cov e = diag(σ_i²) + s² φ^|t_i − t_j| | |
//! | L | | V = L Lᵀ | |

/// The disturbance of a series: the effect of moisture, crowds and temperature inside the stone, in addition to the noise of a reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disturbance {
    /// Standard deviation of the disturbance, relative.
    pub sd: f64,
    /// Correlation of the disturbance over the usual interval between two surveys.
    pub correlation: f64,
}

/// Largest correlation over one interval in the search; beyond it, the level and the disturbance cannot be separated. Our choice.
pub(super) const CORRELATION_MOST: f64 = 0.95;
/// Correlation from which the search is at its end. Our choice.
const AT_END_FROM: f64 = 0.94;

impl Disturbance {
    /// Whether its correlation is at the end of the search, so that the true one may be larger: it lasts so long that the probabilities of false
    /// alarms and of false changes do not hold.
    pub fn is_at_end(&self) -> bool {
        self.sd > 0.0 && self.correlation >= AT_END_FROM
    }
}

/// Filter coefficients at one survey.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gains {
    /// 1/√F.
    pub(super) scale: f64,
    /// ρ_{i+1} (1 − K_i): weight of the current prediction in the next one.
    pub(super) keeps: f64,
    /// ρ_{i+1} K_i: weight of the current reading in the next prediction.
    pub(super) learns: f64,
}

/// Kalman filter that computes its coefficients survey by survey.
///
/// ```text
/// F_i = P_i + σ_i²,   K_i = P_i/F_i,   P_{i+1} = ρ² P_i (1 − K_i) + s² (1 − ρ²)
/// ```
pub(super) struct Filter {
    variance: f64,
    predicted: f64,
    rho: f64,
}

impl Filter {
    pub(super) fn new(of: Disturbance) -> Self {
        let variance = of.sd * of.sd;
        Filter {
            variance,
            predicted: variance,
            rho: 0.0,
        }
    }

    /// Coefficients and F at a survey whose reading has the variance `noise`. `fades` is φ^Δt until the next survey, if there is one.
    pub(super) fn step(&mut self, noise: f64, fades: Option<f64>) -> (Gains, f64) {
        let total = self.predicted + noise;
        let gain = self.predicted / total;
        let rho = fades.unwrap_or(self.rho);
        self.rho = rho;
        self.predicted = rho * rho * self.predicted * (1.0 - gain) + self.variance * (1.0 - rho * rho);
        let gains = Gains {
            scale: 1.0 / total.sqrt(),
            keeps: rho * (1.0 - gain),
            learns: rho * gain,
        };
        (gains, total)
    }
}

/// Whitening of a series by a Kalman filter with precomputed coefficients.
///
/// ```text
/// x_i = ρ_i x_{i−1} + w_i,   ρ_i = φ^(t_i − t_{i−1}),   var x = s²,        z_i = x_i + v_i,   var v_i = σ_i²
/// e_i = z_i − a_i,   (L⁻¹ z)_i = e_i/√F_i,   a_{i+1} = ρ (a_i + K_i e_i)        F and K: [`Filter`]
/// ```
/// The filter is linear in z. Its computing time is proportional to n.
#[derive(Clone, Debug)]
pub(super) struct Whitening {
    gains: Vec<Gains>,
    pub(super) ln_determinant: f64,
}

impl Whitening {
    pub(super) fn new(at: &[f64], noise_sd: &[f64], of: Disturbance) -> Self {
        let mut filter = Filter::new(of);
        let mut whitening = Whitening {
            gains: Vec::with_capacity(at.len()),
            ln_determinant: 0.0,
        };
        let (mut last_gap, mut fades) = (f64::NAN, 0.0);
        for (i, noise_sd) in noise_sd.iter().enumerate() {
            let gap = at.get(i + 1).map(|next| next - at[i]);
            if let Some(gap) = gap
                && gap != last_gap
            {
                (last_gap, fades) = (gap, of.correlation.powf(gap));
            }
            let (gains, total) = filter.step(noise_sd * noise_sd, gap.map(|_| fades));
            whitening.gains.push(gains);
            whitening.ln_determinant += total.ln();
        }
        whitening
    }

    /// Whitened series L⁻¹ z.
    pub(super) fn white(&self, z: &[f64]) -> Vec<f64> {
        let mut predicted = 0.0;
        let mut white = Vec::with_capacity(z.len());
        for (z, gains) in z.iter().zip(&self.gains) {
            white.push(gains.scale * (z - predicted));
            predicted = gains.keeps * predicted + gains.learns * z;
        }
        white
    }

    /// L⁻ᵀ w. For w = L⁻¹ z this is V⁻¹ z.
    pub(super) fn adjoint(&self, white: &[f64]) -> Vec<f64> {
        let n = white.len();
        let mut out = vec![0.0; n];
        let mut carried = 0.0;
        for i in (0..n).rev() {
            let gains = self.gains[i];
            let scaled = gains.scale * white[i];
            out[i] = scaled + gains.learns * carried;
            carried = gains.keeps * carried - scaled;
        }
        out
    }

    /// For each survey τ, the value |L⁻¹ c|² of two changes c that begin there: a step (0 before τ, 1 from τ on) and a slope (max(0, t − t_τ)).
    ///
    /// From each survey on, the remaining squared length is a quadratic form in the prediction a and in α, β of c = α + β t. Its coefficients are
    /// computed backwards from the end.
    pub(super) fn energies(&self, at: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = at.len();
        let (mut steps, mut slopes) = (vec![0.0; n], vec![0.0; n]);
        // coefficients of a², aα, aβ, α², αβ, β²
        let mut q = [0.0_f64; 6];
        for i in (0..n).rev() {
            let Gains {
                scale,
                keeps: keep,
                learns: learn,
            } = self.gains[i];
            let (g, t) = (scale * scale, at[i]);
            let [aa, a_alpha, a_beta, alpha_alpha, alpha_beta, beta_beta] = q;
            q = [
                g + aa * keep * keep,
                -g + aa * keep * learn + a_alpha * keep,
                -g * t + aa * keep * learn * t + a_beta * keep,
                g + aa * learn * learn + 2.0 * a_alpha * learn + alpha_alpha,
                g * t + aa * learn * learn * t + a_alpha * learn * t + a_beta * learn + alpha_beta,
                g * t * t + aa * learn * learn * t * t + 2.0 * a_beta * learn * t + beta_beta,
            ];
            steps[i] = q[3];
            slopes[i] = q[5] - 2.0 * t * q[4] + t * t * q[3];
        }
        (steps, slopes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_linalg::{Matrix, solve};

    fn made() -> (Vec<f64>, Vec<f64>, Disturbance) {
        let at = vec![0.0, 1.0, 2.0, 2.5, 6.0, 7.0, 9.0];
        let noise = vec![0.3, 0.1, 0.2, 0.4, 0.1, 0.3, 0.2];
        let of = Disturbance {
            sd: 0.5,
            correlation: 0.6,
        };
        (at, noise, of)
    }

    fn dense(at: &[f64], noise: &[f64], of: Disturbance) -> Matrix {
        Matrix::from_fn(at.len(), at.len(), |i, j| {
            let noise = if i == j { noise[i] * noise[i] } else { 0.0 };
            noise + of.sd * of.sd * of.correlation.powf((at[i] - at[j]).abs())
        })
    }

    #[test]
    fn agrees_with_the_dense_inverse_of_the_covariance() {
        let (at, noise, of) = made();
        let v = dense(&at, &noise, of);
        let whitening = Whitening::new(&at, &noise, of);
        let z = [1.0, -0.4, 0.3, 2.0, -1.0, 0.2, 0.7];
        let by_filter = whitening.adjoint(&whitening.white(&z));
        let by_matrix = solve(&v, &Matrix::from_column(&z)).unwrap();
        for (a, b) in by_filter.iter().zip(by_matrix.column(0)) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
        let (steps, slopes) = whitening.energies(&at);
        for start in 0..at.len() {
            let square = |c: Vec<f64>| -> f64 {
                let solved = solve(&v, &Matrix::from_column(&c)).unwrap();
                c.iter().zip(solved.column(0)).map(|(c, s)| c * s).sum()
            };
            let step = (0..at.len()).map(|i| f64::from(u8::from(i >= start))).collect();
            let slope = at.iter().map(|t| (t - at[start]).max(0.0)).collect();
            assert!((steps[start] - square(step)).abs() < 1e-11);
            assert!((slopes[start] - square(slope)).abs() < 1e-10);
        }
        let eigenvalues = dolmen_linalg::symmetric_eigenvalues(&v).unwrap();
        let ln_det: f64 = eigenvalues.iter().map(|l| l.ln()).sum();
        assert!((whitening.ln_determinant - ln_det).abs() < 1e-12);
    }
}
