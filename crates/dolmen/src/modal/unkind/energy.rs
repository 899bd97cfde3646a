//! How clearly a record can show a mode, from the densities of its simulation, independent of any method of
//! identification.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | R | `rest` | density of noise and of the modes that are known | channels × channels |
//! | ψ_k | `shapes` | shape of mode k in coordinates in which R is the unit matrix | r |
//! | d_k | | density of mode k along its shape | |
//! | F | `information` | Fisher information of the unknowns of the modes in the group | unknowns, squared |

use crate::modal::{MadeMode, ModalError};
use dolmen_linalg::{Matrix, cholesky, solve, solve_lower};

/// Modes whose distance is below this multiple of the sum of their half-power widths are unknown together; all others are known, which lowers the
/// bound.
const TOGETHER: f64 = 5.0;
/// Half-power widths on each side whose lines count. Wider bands change the bound of a lone mode by less than 2 %.
const REACH: f64 = 40.0;
/// Distance of frequencies over their distance from the nearest pole: the densities are nearly linear in between.
const STEP: f64 = 0.1;

/// Densities of the simulated motion.
pub(super) struct Densities<'a> {
    pub(super) modes: &'a [MadeMode],
    /// Density of mode k at a frequency, Hz, with its frequency and damping ratio multiplied by these factors.
    pub(super) of_mode: &'a dyn Fn(usize, f64, [f64; 2]) -> f64,
    /// Density of the noise of a channel at a frequency, Hz.
    pub(super) of_noise: &'a dyn Fn(usize, f64) -> f64,
    pub(super) channels: usize,
    pub(super) nyquist_hz: f64,
    pub(super) duration_s: f64,
}

impl Densities<'_> {
    /// Least relative standard deviation of the damping ratio of mode `j` for any unbiased estimator that knows the noise, the number of modes and
    /// the modes far from it, but neither frequencies, damping ratios, strengths nor shapes of this mode and its neighbours.
    ///
    /// ```text
    /// S = I + Σ d_k ψ_k ψ_kᵀ,   F_ab = T ∫ tr(S⁻¹ ∂_a S S⁻¹ ∂_b S) df,   sd = √(F⁻¹)_ζζ / ζ
    /// ```
    /// For a lone mode in little noise this is 1/√(2πζN_c) (Au 2014); two modes within one half-power band and with similar shapes have far more.
    ///
    /// # Errors
    /// [`ModalError::Linalg`] without noise.
    ///
    /// # Source
    /// Whittle (1953) Ark. Mat. 2:423-434; bound of Cramér and Rao.
    pub(super) fn least_damping_deviation(&self, j: usize) -> Result<f64, ModalError> {
        let own = &self.modes[j];
        let half_hz = |mode: &MadeMode| mode.damping_ratio * mode.frequency_hz;
        let is_near = |k: &usize| {
            let other = &self.modes[*k];
            (other.frequency_hz - own.frequency_hz).abs() <= TOGETHER * (half_hz(other) + half_hz(own))
        };
        let group: Vec<usize> = (0..self.modes.len()).filter(is_near).collect();
        let place = group.iter().position(|k| *k == j).unwrap_or(0);
        let shapes = self.shapes(&group, own.frequency_hz)?;
        let (r, m) = (shapes.rows(), group.len());
        let each = 2 + r; // frequency, damping ratio, strength, and the shape but for its largest component
        let mut information = Matrix::zeros(m * each, m * each);
        let reach_hz = REACH * half_hz(own);
        let end_hz = (own.frequency_hz + reach_hz).min(self.nyquist_hz);
        let mut hz = (own.frequency_hz - reach_hz).max(1.0 / self.duration_s);
        while hz < end_hz {
            let from = |k: &usize| (hz - self.modes[*k].frequency_hz).hypot(half_hz(&self.modes[*k]));
            let step_hz = STEP * group.iter().map(from).fold(f64::INFINITY, f64::min);
            self.add_lines(&group, &shapes, [hz, step_hz.min(end_hz - hz)], &mut information)?;
            hz += step_hz;
        }
        let n = information.rows();
        let scale: Vec<f64> = (0..n)
            .map(|i| information[(i, i)].max(f64::MIN_POSITIVE).sqrt().recip())
            .collect();
        let scaled = Matrix::from_fn(n, n, |a, b| scale[a] * information[(a, b)] * scale[b]);
        let unit = Matrix::from_fn(n, 1, |i, _| f64::from(u8::from(i == place * each + 1)));
        // information that is singular to rounding bounds nothing
        let Ok(lower) = cholesky(&scaled) else {
            return Ok(f64::INFINITY);
        };
        let half = solve_lower(&lower, unit)?;
        let variance: f64 = half.column(0).iter().map(|x| x * x).sum();
        Ok(variance.sqrt() * scale[place * each + 1])
    }

    /// Shapes of the group in orthonormal coordinates in which the density of all else is 1.   shape: r × group
    fn shapes(&self, group: &[usize], hz: f64) -> Result<Matrix, ModalError> {
        let l = self.channels;
        let known: Vec<(&MadeMode, f64)> = (0..self.modes.len())
            .filter(|k| !group.contains(k))
            .map(|k| (&self.modes[k], (self.of_mode)(k, hz, [1.0; 2])))
            .collect();
        let rest = Matrix::from_fn(l, l, |a, b| {
            let motion: f64 = known
                .iter()
                .map(|(mode, d)| d * mode.shape[a] * mode.shape[b])
                .sum();
            motion + if a == b { (self.of_noise)(a, hz) } else { 0.0 }
        });
        let lower = cholesky(&rest)?;
        let white = solve_lower(
            &lower,
            Matrix::from_fn(l, group.len(), |c, k| self.modes[group[k]].shape[c]),
        )?;
        let mut axes: Vec<Vec<f64>> = Vec::new();
        for k in 0..group.len() {
            let mut axis = white.column(k).to_vec();
            let size = inner(&axis, &axis).sqrt();
            for other in &axes {
                let along = inner(&axis, other);
                axis.iter_mut().zip(other).for_each(|(x, o)| *x -= along * o);
            }
            let left = inner(&axis, &axis).sqrt();
            if left > 1e-6 * size {
                axes.push(axis.iter().map(|x| x / left).collect());
            }
        }
        Ok(Matrix::from_fn(axes.len(), group.len(), |i, k| {
            inner(&axes[i], white.column(k))
        }))
    }

    /// Adds the information of the lines from `hz` over `width_hz`.
    fn add_lines(
        &self,
        group: &[usize],
        shapes: &Matrix,
        [hz, width_hz]: [f64; 2],
        information: &mut Matrix,
    ) -> Result<(), ModalError> {
        const BY: f64 = 1e-4;
        let (r, m) = (shapes.rows(), group.len());
        let hz = hz + 0.5 * width_hz;
        let density = |k: usize, by: [f64; 2]| (self.of_mode)(group[k], hz, by);
        let d: Vec<f64> = (0..m).map(|k| density(k, [1.0; 2])).collect();
        let s = Matrix::from_fn(r, r, |a, b| {
            let motion: f64 = (0..m).map(|k| d[k] * shapes[(a, k)] * shapes[(b, k)]).sum();
            motion + f64::from(u8::from(a == b))
        });
        let lower = cholesky(&s)?;
        // L⁻¹ ∂S L⁻ᵀ of every unknown
        let mut slopes: Vec<Matrix> = Vec::with_capacity(information.rows());
        let half = |x: Matrix| solve_lower(&lower, x);
        for k in 0..m {
            let psi = half(Matrix::from_column(shapes.column(k)))?;
            let along = |a: &[f64], b: &[f64], by: f64| {
                Matrix::from_fn(r, r, |i, j| by * (a[i] * b[j] + b[i] * a[j]))
            };
            let psi = psi.column(0);
            let width = self.modes[group[k]].damping_ratio;
            let slope = |up: [f64; 2], down: [f64; 2]| (density(k, up) - density(k, down)) / (2.0 * BY);
            // by the logarithm of each, but the frequency by half-power widths
            let of_frequency = slope([1.0 + BY * width, 1.0], [1.0 - BY * width, 1.0]);
            let of_damping = slope([1.0, 1.0 + BY], [1.0, 1.0 - BY]);
            slopes.extend([of_frequency, of_damping, d[k]].map(|by| along(psi, psi, 0.5 * by)));
            let norm = |i: &usize| shapes[(*i, k)].abs();
            let held = (0..r).max_by(|a, b| norm(a).total_cmp(&norm(b)));
            for i in (0..r).filter(|i| Some(*i) != held) {
                let unit = half(Matrix::from_fn(r, 1, |row, _| f64::from(u8::from(row == i))))?;
                slopes.push(along(unit.column(0), psi, d[k]));
            }
        }
        for (a, slope) in slopes.iter().enumerate() {
            for (b, other) in slopes.iter().enumerate() {
                information[(a, b)] += self.duration_s * width_hz * inner(slope.as_slice(), other.as_slice());
            }
        }
        Ok(())
    }
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Density of mode `j` over that of all other motion at its frequency, in the best combination of channels.
///
/// ```text
/// S = Σ_(k≠j) P_k φ_k φ_kᵀ + diag(noise),   max_w  P_j (wᵀφ_j)² / wᵀSw  =  P_j φ_jᵀ S⁻¹ φ_j
/// ```
///
/// # Errors
/// [`ModalError::Linalg`] without noise.
pub(super) fn signal_over_rest(
    modes: &[MadeMode],
    j: usize,
    density: &[f64],
    noise: &[f64],
) -> Result<f64, ModalError> {
    let l = noise.len();
    let rest = Matrix::from_fn(l, l, |a, b| {
        let others = modes.iter().zip(density).enumerate().filter(|(k, _)| *k != j);
        let motion: f64 = others
            .map(|(_, (mode, p))| p * mode.shape[a] * mode.shape[b])
            .sum();
        motion + if a == b { noise[a] } else { 0.0 }
    });
    let phi = &modes[j].shape;
    let weights = solve(&rest, &Matrix::from_column(phi))?;
    let along: f64 = weights.column(0).iter().zip(phi).map(|(w, x)| w * x).sum();
    Ok(density[j] * along)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bound for the first of these modes, in velocity of ten minutes under white forces, over that of a lone mode in a long record.
    fn bound(modes: &[MadeMode], noise: f64) -> f64 {
        let of_mode = |k: usize, hz: f64, [by_hz, by_damping]: [f64; 2]| {
            let (f, zeta) = (modes[k].frequency_hz * by_hz, modes[k].damping_ratio * by_damping);
            (hz * hz) / ((f * f - hz * hz).powi(2) + (2.0 * zeta * f * hz).powi(2))
        };
        let densities = Densities {
            modes,
            of_mode: &of_mode,
            of_noise: &|_, _| noise,
            channels: modes[0].shape.len(),
            nyquist_hz: 50.0,
            duration_s: 600.0,
        };
        let first = &modes[0];
        let cycles = first.frequency_hz * 600.0;
        densities.least_damping_deviation(0).unwrap()
            * (2.0 * std::f64::consts::PI * first.damping_ratio * cycles).sqrt()
    }

    #[test]
    fn agrees_the_bound_of_a_lone_mode_with_the_floor_of_long_records() {
        let mode = |frequency_hz: f64, shape: [f64; 2]| MadeMode {
            frequency_hz,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        // Au (2014): 1 without noise in an infinite band; the peak is 1/(4ζ²f²) = 2500
        let alone = bound(&[mode(1.0, [1.0, 1.0])], 1e-4);
        assert!((1.0..1.05).contains(&alone), "{alone}");
        // a fifth of the peak in each channel
        let noisy = bound(&[mode(1.0, [1.0, 1.0])], 500.0);
        assert!((1.8..1.95).contains(&noisy), "{noisy}");
        // a neighbour within the bandwidth costs little if its shape differs, much if it does not
        let across = bound(&[mode(1.0, [1.0, 1.0]), mode(1.005, [1.0, -1.0])], 1e-4);
        let alike = bound(&[mode(1.0, [1.0, 1.0]), mode(1.005, [1.0, 1.05])], 20.0);
        assert!(across < 1.1 && alike > 3.0, "{across} {alike}");
    }

    #[test]
    fn exact_a_lone_mode_over_white_noise_and_two_like_modes() {
        let mode = |shape: [f64; 2]| MadeMode {
            frequency_hz: 1.0,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        // P |φ|²/n
        let alone = signal_over_rest(&[mode([3.0, 4.0])], 0, &[2.0], &[0.5, 0.5]).unwrap();
        assert!((alone - 2.0 * 25.0 / 0.5).abs() < 1e-9);
        // a mode with the same shape counts as noise with its power; a mode with an orthogonal shape does not count
        let like = [mode([1.0, 0.0]), mode([1.0, 0.0])];
        let of = signal_over_rest(&like, 0, &[6.0, 2.0], &[1.0, 1.0]).unwrap();
        assert!((of - 6.0 / 3.0).abs() < 1e-9);
        let across = [mode([1.0, 0.0]), mode([0.0, 1.0])];
        assert!((signal_over_rest(&across, 0, &[6.0, 2.0], &[1.0, 1.0]).unwrap() - 6.0).abs() < 1e-9);
    }
}
