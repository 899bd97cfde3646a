//! Complex modes of a building with tuned masses; each mode has a separate first-order equation.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | η_j | `modal` | coordinate of mode j of the building alone |
//! | z_d | | displacement of mass d along its direction, relative to the ground |
//! | λ_k, φ_k | `lambda` | complex modes: η and z move as φ_k e^(λ_k t) |
//! | α_k | | φᵀ (2 λ M + C) φ |
//! | f | | −Γ of the modes, −m e of the masses: load of a unit acceleration of the ground |
//! | y_k | | y′ = λ_k y + p_k a,  p_k = φᵀ f/α_k;  displacements are Σ φ_k y_k + its conjugate |

use super::secular::{Root, Secular, null_vector};
use super::stepping::{Ground, Stepping};
use super::vibrating::VibratingBuilding;
use dolmen_linalg::{Complex64, Matrix};

/// Relative tolerance for the acceleration at the first instant, and for zero velocity, as a sum of modes. Modes with a larger error are not
/// used, because the results of a run could have the same error. Our choice.
const COMPLETE: f64 = 1e-11;

/// All complex modes of the upper half-plane.
pub(super) struct ComplexModes {
    pub(super) lambda: Vec<Complex64>,
    /// p_k for the ground along x and y.
    pub(super) load: [Vec<Complex64>; 2],
    /// Displacements u, v, θ of the floors and strokes of the masses, each 2 Re Σ (re, im): (3N + D) × 2K.
    pub(super) outputs: Matrix,
}

struct Mode {
    lambda: Complex64,
    modal: Vec<(usize, Complex64)>,
    strokes: Vec<Complex64>,
    load: [Complex64; 2],
}

/// `None` if the modes do not represent the motion: two of them coincide, or some do not oscillate.
pub(super) fn complex_modes(building: &VibratingBuilding) -> Option<ComplexModes> {
    let omegas = building.modes().omegas_rad_s();
    let zetas = building.damping_ratios();
    let oscillators = building.oscillators();
    let secular = Secular::new(&omegas, zetas, oscillators)?;
    let gammas: Vec<[f64; 2]> = building
        .modes()
        .modes
        .iter()
        .map(|mode| [mode.participation[0], mode.participation[1]])
        .collect();
    let mut modes = Vec::with_capacity(omegas.len() + oscillators.len());
    let mut is_touched = vec![false; omegas.len()];
    secular.touched.iter().for_each(|&j| is_touched[j] = true);
    for j in (0..omegas.len()).filter(|&j| !is_touched[j]) {
        let lambda = secular.poles[j];
        let alpha = Complex64::new(0.0, 2.0 * lambda.im);
        modes.push(Mode {
            lambda,
            modal: vec![(j, Complex64::ONE)],
            strokes: vec![Complex64::ZERO; oscillators.len()],
            load: gammas[j].map(|gamma| -gamma / alpha),
        });
    }
    if !oscillators.is_empty() {
        for root in secular.roots()? {
            modes.push(coupled(&secular, root, (&omegas, zetas), &gammas));
        }
    }
    is_complete(&modes, &gammas, building).then(|| assembled(&modes, building))
}

fn coupled(
    secular: &Secular<'_>,
    root: Root,
    (omegas, zetas): (&[f64], &[f64]),
    gammas: &[[f64; 2]],
) -> Mode {
    let oscillators = secular.oscillators;
    let count = oscillators.len();
    let s = secular.value(root);
    let w = match count {
        1 => vec![Complex64::ONE],
        _ => null_vector(secular.matrix(root), count),
    };
    let forces: Vec<Complex64> = (0..count).map(|d| secular.force(s, d) * w[d]).collect();
    let mut modal = Vec::with_capacity(secular.touched.len());
    let mut alpha = Complex64::ZERO;
    let mut load = [Complex64::ZERO; 2];
    for &j in &secular.touched {
        let [near, far] = secular.off_pole(root, j);
        let pushed: Complex64 = (0..count).map(|d| oscillators[d].row[j] * forces[d]).sum();
        let eta = -pushed / (near * far);
        alpha += 2.0 * (s + zetas[j] * omegas[j]) * eta * eta;
        for (load, gamma) in load.iter_mut().zip(gammas[j]) {
            *load -= gamma * eta;
        }
        modal.push((j, eta));
    }
    let mut strokes = Vec::with_capacity(count);
    for (d, own) in oscillators.iter().enumerate() {
        let z = (own.damping * s + own.stiffness) * w[d];
        let stroke = -own.mass * s * s * w[d];
        alpha += 2.0 * s * own.mass * z * z + own.damping * stroke * stroke;
        for (load, unit) in load.iter_mut().zip(own.unit) {
            *load -= own.mass * unit * z;
        }
        strokes.push(stroke);
    }
    Mode {
        lambda: s,
        modal,
        strokes,
        load: load.map(|load| load / alpha),
    }
}

/// Checks the initial state under a unit acceleration: Σ φ p = 0 and Σ λ φ p = M⁻¹ f.
fn is_complete(modes: &[Mode], gammas: &[[f64; 2]], building: &VibratingBuilding) -> bool {
    let oscillators = building.oscillators();
    let n = gammas.len();
    for axis in 0..2 {
        let mut still = vec![0.0; n + oscillators.len()];
        let mut begins = still.clone();
        let mut sizes = [0.0_f64; 2];
        for mode in modes {
            let p = mode.load[axis];
            let each = mode.modal.iter().copied();
            let strokes = mode
                .strokes
                .iter()
                .enumerate()
                .map(|(d, &stroke)| (n + d, stroke));
            for (i, phi) in each.chain(strokes) {
                let moved = 2.0 * phi * p;
                still[i] += moved.re;
                begins[i] += (moved * mode.lambda).re;
                sizes[0] = sizes[0].max(moved.norm_sqr());
                sizes[1] = sizes[1].max((moved * mode.lambda).norm_sqr());
            }
        }
        for (j, gamma) in gammas.iter().enumerate() {
            begins[j] += gamma[axis];
        }
        // a stroke is z − z0: both are relative to the ground
        let unit = |d: usize| {
            let own = &oscillators[d];
            let place: f64 = own.row.iter().zip(gammas).map(|(b, gamma)| b * gamma[axis]).sum();
            own.unit[axis] - place
        };
        for d in 0..oscillators.len() {
            begins[n + d] += unit(d);
        }
        let bounded = |values: &[f64], size: f64| values.iter().all(|value| value.abs() <= COMPLETE * size);
        if !bounded(&still, sizes[0].sqrt()) || !bounded(&begins, sizes[1].sqrt()) {
            return false;
        }
    }
    true
}

fn assembled(modes: &[Mode], building: &VibratingBuilding) -> ComplexModes {
    let (n, count) = (building.modes().modes.len(), building.oscillators().len());
    let k = modes.len();
    let mut modal = Matrix::zeros(n, 2 * k);
    for (column, mode) in modes.iter().enumerate() {
        for &(j, eta) in &mode.modal {
            modal[(j, column)] = 2.0 * eta.re;
            modal[(j, k + column)] = -2.0 * eta.im;
        }
    }
    let floors = &building.modes().shapes * &modal;
    let mut outputs = Matrix::zeros(n + count, 2 * k);
    for column in 0..2 * k {
        outputs.column_mut(column)[..n].copy_from_slice(floors.column(column));
    }
    for (column, mode) in modes.iter().enumerate() {
        for (d, stroke) in mode.strokes.iter().enumerate() {
            outputs[(n + d, column)] = 2.0 * stroke.re;
            outputs[(n + d, k + column)] = -2.0 * stroke.im;
        }
    }
    ComplexModes {
        lambda: modes.iter().map(|mode| mode.lambda).collect(),
        load: [0, 1].map(|axis| modes.iter().map(|mode| mode.load[axis]).collect()),
        outputs,
    }
}

/// One step of each complex mode as coefficients: y ← E y + Σ_axes (A a + B b), a and b the accelerations at both ends.
///
/// ```text
/// E = e^(λh)   A + B = p h φ_1   B = p h φ_2   φ_1 = (e^z − 1)/z   φ_2 = (φ_1 − 1)/z   z = λh
/// ```
pub(super) struct Steps<'a> {
    modes: &'a ComplexModes,
    count: usize,
    /// Re E, Im E.
    decay: [Vec<f64>; 2],
    /// By axis: Re A, Im A, Re B, Im B.
    ground: [[Vec<f64>; 4]; 2],
}

impl<'a> Steps<'a> {
    pub(super) fn new(modes: &'a ComplexModes, h: f64) -> Self {
        let mut decay = [Vec::new(), Vec::new()];
        let mut ground: [[Vec<f64>; 4]; 2] = Default::default();
        for (k, &lambda) in modes.lambda.iter().enumerate() {
            let z = lambda * h;
            let e = z.exp();
            decay[0].push(e.re);
            decay[1].push(e.im);
            let [first, second] = quotients(z);
            for (lists, load) in ground.iter_mut().zip(&modes.load) {
                let p = load[k] * h;
                let (a, b) = (p * (first - second), p * second);
                for (list, value) in lists.iter_mut().zip([a.re, a.im, b.re, b.im]) {
                    list.push(value);
                }
            }
        }
        Steps {
            modes,
            count: modes.lambda.len(),
            decay,
            ground,
        }
    }
}

impl Stepping for Steps<'_> {
    fn outputs(&self) -> &Matrix {
        &self.modes.outputs
    }

    // Σ c_re Re y + c_im Im y = Re Σ (c_re − i c_im) y
    fn rate_row(&self, row: &[f64]) -> Vec<f64> {
        let (re, im) = row.split_at(self.count);
        let pairs = re.iter().zip(im).zip(&self.modes.lambda);
        let rates: Vec<Complex64> = pairs
            .map(|((re, im), lambda)| Complex64::new(*re, -im) * lambda)
            .collect();
        let real = rates.iter().map(|rate| rate.re);
        real.chain(rates.iter().map(|rate| -rate.im)).collect()
    }

    fn ground_of_row(&self, row: &[f64]) -> [f64; 2] {
        let (re, im) = row.split_at(self.count);
        [0, 1].map(|axis| {
            let pairs = re.iter().zip(im).zip(&self.modes.load[axis]);
            pairs.map(|((re, im), p)| re * p.re + im * p.im).sum()
        })
    }

    #[inline(always)]
    fn advance(&self, from: &[f64], to: &mut [f64], ground: Ground) {
        let n = self.count;
        let (re, im) = from.split_at(n);
        let (to_re, to_im) = to.split_at_mut(n);
        let (e_re, e_im) = (&self.decay[0][..n], &self.decay[1][..n]);
        let (re, im, to_re, to_im) = (&re[..n], &im[..n], &mut to_re[..n], &mut to_im[..n]);
        let mut started = false;
        for ([a_re, a_im, b_re, b_im], [a, b]) in self.ground.iter().zip(ground) {
            if a == 0.0 && b == 0.0 {
                continue;
            }
            let (a_re, a_im, b_re, b_im) = (&a_re[..n], &a_im[..n], &b_re[..n], &b_im[..n]);
            if started {
                for k in 0..n {
                    to_re[k] += a_re[k] * a + b_re[k] * b;
                    to_im[k] += a_im[k] * a + b_im[k] * b;
                }
                continue;
            }
            started = true;
            for k in 0..n {
                to_re[k] = e_re[k] * re[k] - e_im[k] * im[k] + (a_re[k] * a + b_re[k] * b);
                to_im[k] = e_re[k] * im[k] + e_im[k] * re[k] + (a_im[k] * a + b_im[k] * b);
            }
        }
        if !started {
            for k in 0..n {
                to_re[k] = e_re[k] * re[k] - e_im[k] * im[k];
                to_im[k] = e_re[k] * im[k] + e_im[k] * re[k];
            }
        }
    }
}

/// φ_1 and φ_2; by their series where the quotients lose digits.
fn quotients(z: Complex64) -> [Complex64; 2] {
    const SMALL: f64 = 0.5; // 20 terms then leave less than 1e-25
    const TERMS: i32 = 20;
    if z.norm() >= SMALL {
        let first = (z.exp() - 1.0) / z;
        return [first, (first - 1.0) / z];
    }
    // φ_2 = Σ zⁿ/(n + 2)!, φ_1 = 1 + z φ_2
    let second = (0..TERMS)
        .rev()
        .fold(Complex64::ZERO, |sum, n| (sum * z + 1.0) / f64::from(n + 2));
    [1.0 + z * second, second]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_quotients_join_where_the_series_ends() {
        let near = Complex64::from_polar(0.499_999_999, 1.1);
        let far = Complex64::from_polar(0.500_000_001, 1.1);
        for (a, b) in quotients(near).iter().zip(quotients(far)) {
            assert!((a - b).norm() < 2e-9, "{a} {b}");
        }
        let z = Complex64::new(-0.1, 0.3);
        let first = (z.exp() - 1.0) / z;
        let second = (z.exp() - 1.0 - z) / (z * z);
        let [a, b] = quotients(z);
        assert!((a - first).norm() < 1e-14 && (b - second).norm() < 1e-14);
    }
}
