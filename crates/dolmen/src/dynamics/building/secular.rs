//! Roots of the secular equation of a classically damped structure with tuned masses, all at once.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | p_j, p̄_j | `poles` | roots of s² + 2ζ_jω_j s + ω_j², and of m s² + c s + k of each mass |
//! | λ_k | | roots sought, one near each pole: λ_k = p_o + δ_k |
//! | δ_k | `Root::shift` | kept instead of λ_k: a mode that hardly moves at the mass has its root next to its pole |
//! | δ_k | `Root::shift` | stored instead of λ_k: if a mode hardly moves at the mass, its root is very close to its pole |
//! | P_d | | m s² + c s + k |
//! | h_d | | (c s + k) m s² |
//! | W_de | | Σ_j b_dj b_ej/(s² + 2ζ_jω_j s + ω_j²) |
//! | F | | diag(P) + W diag(h): singular at the roots |

use super::vibrating::Oscillator;
use dolmen_linalg::Complex64;

/// Largest number of iterations; 5 to 12 are needed.
const ROUNDS_MOST: usize = 80;
/// Convergence of a root: its change is below this fraction of its shift, or of the root.
const SHIFT_FOUND: f64 = 1e-13;
const ROOT_FOUND: f64 = 2e-16;
/// Largest distance of a first guess from its pole, over the size of the pole.
const START_MOST: f64 = 0.2;
/// A mode whose modal mass ratio at every mass is below this is unaffected by the masses.
const UNTOUCHED: f64 = 1e-28;

/// λ = pole + shift, in the upper half-plane; its conjugate is a root too.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    /// Index of the pole: first the poles of the structure, then those of the masses.
    pub(super) origin: usize,
    pub(super) shift: Complex64,
}

/// Poles of structure and masses, and their coupling.
pub(super) struct Secular<'a> {
    pub(super) poles: Vec<Complex64>,
    pub(super) modes: usize,
    pub(super) oscillators: &'a [Oscillator],
    /// Modes that at least one mass affects.
    pub(super) touched: Vec<usize>,
}

/// F and its derivative, row by row, and the logarithmic derivative of ∏ (s² + 2ζω s + ω²).
struct Coupled {
    f: Vec<Complex64>,
    f_rate: Vec<Complex64>,
    log_of_poles: Complex64,
}

impl<'a> Secular<'a> {
    /// `None` if a pole is not in the upper half-plane: a mass with too much damping to oscillate.
    pub(super) fn new(omegas: &[f64], zetas: &[f64], oscillators: &'a [Oscillator]) -> Option<Self> {
        let pole = |omega: f64, zeta: f64| {
            (zeta < 1.0).then(|| Complex64::new(-zeta * omega, omega * (1.0 - zeta * zeta).sqrt()))
        };
        let mut poles = Vec::with_capacity(omegas.len() + oscillators.len());
        for (&omega, &zeta) in omegas.iter().zip(zetas) {
            poles.push(pole(omega, zeta)?);
        }
        for own in oscillators {
            let omega = (own.stiffness / own.mass).sqrt();
            poles.push(pole(omega, own.damping / (2.0 * own.mass * omega))?);
        }
        let touched = (0..omegas.len()).filter(|&j| {
            oscillators
                .iter()
                .any(|o| o.mass * o.row[j] * o.row[j] > UNTOUCHED)
        });
        Some(Secular {
            poles,
            modes: omegas.len(),
            touched: touched.collect(),
            oscillators,
        })
    }

    pub(super) fn value(&self, root: Root) -> Complex64 {
        self.poles[root.origin] + root.shift
    }

    /// (s − p_i) and (s − p̄_i) of a root.
    pub(super) fn off_pole(&self, root: Root, i: usize) -> [Complex64; 2] {
        let [own, other] = [self.poles[root.origin], self.poles[i]];
        [own - other + root.shift, own - other.conj() + root.shift]
    }

    /// P_d = m s² + c s + k, of mass d at a root.
    pub(super) fn own_polynomial(&self, root: Root, d: usize) -> Complex64 {
        let [near, far] = self.off_pole(root, self.modes + d);
        self.oscillators[d].mass * near * far
    }

    /// h_d = (c s + k) m s².
    pub(super) fn force(&self, s: Complex64, d: usize) -> Complex64 {
        let own = &self.oscillators[d];
        (own.damping * s + own.stiffness) * own.mass * s * s
    }

    fn coupled(&self, root: Root) -> Coupled {
        let count = self.oscillators.len();
        let s = self.value(root);
        let mut w = vec![Complex64::ZERO; count * count];
        let mut w_rate = vec![Complex64::ZERO; count * count];
        let mut log_derivative = Complex64::ZERO;
        for &j in &self.touched {
            let [near, far] = self.off_pole(root, j);
            let inverse = (near * far).inv();
            let rate = (near + far) * inverse;
            log_derivative += rate;
            for d in 0..count {
                let scaled = inverse * self.oscillators[d].row[j];
                for e in 0..count {
                    let term = scaled * self.oscillators[e].row[j];
                    w[d * count + e] += term;
                    w_rate[d * count + e] -= term * rate;
                }
            }
        }
        let mut f = vec![Complex64::ZERO; count * count];
        let mut f_rate = f.clone();
        for e in 0..count {
            let own = &self.oscillators[e];
            let h = self.force(s, e);
            let h_rate = own.mass * s * (3.0 * own.damping * s + 2.0 * own.stiffness);
            for d in 0..count {
                f[d * count + e] = w[d * count + e] * h;
                f_rate[d * count + e] = w_rate[d * count + e] * h + w[d * count + e] * h_rate;
            }
            let [near, far] = self.off_pole(root, self.modes + e);
            f[e * count + e] += own.mass * near * far;
            f_rate[e * count + e] += own.mass * (near + far);
        }
        Coupled {
            f,
            f_rate,
            log_of_poles: log_derivative,
        }
    }

    /// The logarithmic derivative of ∏ (s² + 2ζω s + ω²) det F; `None` where F is singular to the last bit.
    fn log_derivative(&self, root: Root) -> Option<Complex64> {
        let at = self.coupled(root);
        Some(at.log_of_poles + trace_of_quotient(at.f, at.f_rate, self.oscillators.len())?)
    }

    /// F at a root, row by row.
    pub(super) fn matrix(&self, root: Root) -> Vec<Complex64> {
        self.coupled(root).f
    }

    /// One root near each affected pole and each mass; `None` if they are not found, because some may be real.
    ///
    /// Aberth (1973) Math. Comp. 27:339-344, on ∏ (s² + 2ζω s + ω²) det F, whose roots come in conjugate pairs. Differences of roots are
    /// computed from their shifts.
    pub(super) fn roots(&self) -> Option<Vec<Root>> {
        let mut roots = self.starts();
        let mut found = vec![false; roots.len()];
        for _ in 0..ROUNDS_MOST {
            for k in 0..roots.len() {
                if found[k] {
                    continue;
                }
                let own = roots[k];
                let Some(log_derivative) = self.log_derivative(own) else {
                    found[k] = true;
                    continue;
                };
                let newton = log_derivative.inv();
                let mut repulsion =
                    (self.poles[own.origin] + own.shift - (self.poles[own.origin] + own.shift).conj()).inv();
                for (i, other) in roots.iter().enumerate() {
                    if i == k {
                        continue;
                    }
                    let [own_pole, other_pole] = [self.poles[own.origin], self.poles[other.origin]];
                    repulsion += (own_pole - other_pole + (own.shift - other.shift)).inv();
                    repulsion += (own_pole - other_pole.conj() + (own.shift - other.shift.conj())).inv();
                }
                let step = newton / (Complex64::ONE - newton * repulsion);
                if !step.is_finite() {
                    return None;
                }
                roots[k].shift -= step;
                let s = self.value(roots[k]);
                if s.im <= 0.0 {
                    return None;
                }
                found[k] = step.norm() <= SHIFT_FOUND * roots[k].shift.norm()
                    || step.norm() <= ROOT_FOUND * s.norm();
            }
            if found.iter().all(|&found| found) {
                return Some(roots);
            }
        }
        None
    }

    /// First guesses: the first-order effect of each mass alone on a pole.
    fn starts(&self) -> Vec<Root> {
        let mut roots = Vec::with_capacity(self.touched.len() + self.oscillators.len());
        for &origin in &self.touched {
            let p = self.poles[origin];
            let mut shift = Complex64::ZERO;
            for (d, own) in self.oscillators.iter().enumerate() {
                let here = Root {
                    origin,
                    shift: Complex64::ZERO,
                };
                let g = self.force(p, d) / self.own_polynomial(here, d);
                let mut rest = Complex64::ZERO;
                for &j in self.touched.iter().filter(|&&j| j != origin) {
                    let [near, far] = self.off_pole(here, j);
                    rest += own.row[j] * own.row[j] / (near * far);
                }
                let square = own.row[origin] * own.row[origin];
                shift -= g * square / ((p - p.conj()) * (1.0 + g * rest));
            }
            roots.push(self.limited(origin, shift));
        }
        for d in 0..self.oscillators.len() {
            let origin = self.modes + d;
            let p = self.poles[origin];
            let here = Root {
                origin,
                shift: Complex64::ZERO,
            };
            let mut w = Complex64::ZERO;
            for &j in &self.touched {
                let [near, far] = self.off_pole(here, j);
                let row = self.oscillators[d].row[j];
                w += row * row / (near * far);
            }
            let shift = -self.force(p, d) * w / (self.oscillators[d].mass * (p - p.conj()));
            roots.push(self.limited(origin, shift));
        }
        roots
    }

    /// A valid first guess: finite, different from the pole, and close to it.
    fn limited(&self, origin: usize, shift: Complex64) -> Root {
        let size = self.poles[origin].norm();
        let norm = shift.norm();
        let shift = if !shift.is_finite() {
            // different for each pole, so that no two guesses coincide
            Complex64::new(0.03, 0.07 / (origin as f64 + 1.0)) * size
        } else if norm == 0.0 {
            Complex64::new(-1e-3, 1e-3) * size
        } else if norm > START_MOST * size {
            shift * (START_MOST * size / norm)
        } else {
            shift
        };
        Root { origin, shift }
    }
}

/// tr(F⁻¹ F′) by elimination with row pivots; `None` if F is singular to the last bit.
fn trace_of_quotient(mut f: Vec<Complex64>, mut rate: Vec<Complex64>, n: usize) -> Option<Complex64> {
    if n == 1 {
        return (f[0] != Complex64::ZERO).then(|| rate[0] / f[0]);
    }
    for column in 0..n {
        let pivot =
            (column..n).max_by(|&a, &b| f[a * n + column].norm().total_cmp(&f[b * n + column].norm()))?;
        if f[pivot * n + column] == Complex64::ZERO {
            return None;
        }
        for i in 0..n {
            f.swap(column * n + i, pivot * n + i);
            rate.swap(column * n + i, pivot * n + i);
        }
        let inverse = f[column * n + column].inv();
        for i in 0..n {
            f[column * n + i] *= inverse;
            rate[column * n + i] *= inverse;
        }
        for row in (0..n).filter(|&row| row != column) {
            let factor = f[row * n + column];
            for i in 0..n {
                let (above, above_rate) = (f[column * n + i], rate[column * n + i]);
                f[row * n + i] -= factor * above;
                rate[row * n + i] -= factor * above_rate;
            }
        }
    }
    Some((0..n).map(|i| rate[i * n + i]).sum())
}

/// The null vector of a nearly singular matrix, by elimination with full pivots; its largest entry is 1.
pub(super) fn null_vector(mut f: Vec<Complex64>, n: usize) -> Vec<Complex64> {
    let mut order: Vec<usize> = (0..n).collect();
    for k in 0..n.saturating_sub(1) {
        let (mut best, mut largest) = ((k, k), -1.0);
        for i in k..n {
            for j in k..n {
                if f[i * n + j].norm() > largest {
                    largest = f[i * n + j].norm();
                    best = (i, j);
                }
            }
        }
        for i in 0..n {
            f.swap(k * n + i, best.0 * n + i);
        }
        for i in 0..n {
            f.swap(i * n + k, i * n + best.1);
        }
        order.swap(k, best.1);
        if largest <= 0.0 {
            break;
        }
        for i in k + 1..n {
            let factor = f[i * n + k] / f[k * n + k];
            for j in k..n {
                let above = f[k * n + j];
                f[i * n + j] -= factor * above;
            }
        }
    }
    let mut found = vec![Complex64::ZERO; n];
    found[n - 1] = Complex64::ONE;
    for i in (0..n - 1).rev() {
        let sum: Complex64 = (i + 1..n).map(|j| f[i * n + j] * found[j]).sum();
        found[i] = -sum / f[i * n + i];
    }
    let mut unscrambled = vec![Complex64::ZERO; n];
    for (position, &original) in order.iter().enumerate() {
        unscrambled[original] = found[position];
    }
    let largest = unscrambled.iter().fold(0.0_f64, |most, z| most.max(z.norm()));
    unscrambled.iter().map(|z| z / largest).collect()
}
