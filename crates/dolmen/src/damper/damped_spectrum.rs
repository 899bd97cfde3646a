//! Response of a building with dampers to a design spectrum: complex modes, because the dampers couple the modes, combined by CQC.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ_k, φ_k | | complex modes of building and dampers, upper half-plane | rad/s |
//! | ω_k, ζ_k | | \|λ_k\|, −Re λ_k/\|λ_k\| | rad/s, – |
//! | p_k | `loads` | load of the ground motion on mode k: y′ = λ_k y + p_k a | |
//! | q_k | | q″ + 2 ζ_k ω_k q′ + ω_k² q = −a: the oscillator of the spectrum | m |
//! | A_k, B_k | | response = Σ A_k q_k + B_k q′_k,  A = 2 Re(R λ̄), B = −2 Re R, R = (row · φ_k) p_k | 1/s, … |
//! | D_k | | S_a(T_k, ζ_k)/ω_k² | m |

use super::building_motion::in_modes;
use super::{AttachedDamper, DampedSystem, DamperError};
use crate::dynamics::{DirectionalCombination, SpectralMode, VibratingBuilding};
use dolmen_linalg::{Complex64, Matrix, eigen, solve};
use std::f64::consts::TAU;

/// A mode does not oscillate if the imaginary part of its λ is below this fraction of \|λ\|: damping above 0.999 995 of critical. Our choice.
const SWINGS: f64 = 3e-3;
/// Tolerances of the modal expansion: the sum of the modes must reproduce the initial ground acceleration to this fraction, and its terms may
/// cancel by at most this factor. Two coinciding modes fail both checks. Our choice.
const COMPLETE: f64 = 1e-9;
const CANCEL_MOST: f64 = 1e6;

/// Largest modal responses of a building with dampers, to be combined for any quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct DampedSpectralAnalysis {
    /// The complex modes in the spectrum, lowest first: period 2π/\|λ\| and damping ratio.
    pub modes: Vec<SpectralMode>,
    damped: DampedSystem,
    /// Mode shapes of the building alone, which transform rows over the building into rows over modes.
    building_shapes: Matrix,
    /// φ of each complex mode, in modal coordinates of the building and coordinates of the dampers.
    shapes: Vec<Vec<Complex64>>,
    lambda: Vec<Complex64>,
    loads: Vec<[Complex64; 2]>,
    /// Correlations under white noise: of q_i with q_n, of q_i with q′_n/ω_n, and of q′_i/ω_i with q′_n/ω_n.
    correlations: [Matrix; 3],
}

/// Evaluates a spectrum at every complex mode of a building with dampers: `acceleration_m_s2(period_s, damping_ratio)` gives S_a along x and y.
///
/// ```text
/// r² = ΣΣ D_i D_n [A_i A_n ρ_in + (A_i B_n ω_n σ_in + A_n B_i ω_i σ_ni) + B_i B_n ω_i ω_n τ_in]
///
/// with c = 2ζω:  E = (ω_i² − ω_n²)² + (c_i + c_n)(c_n ω_i² + c_i ω_n²)                     white noise, s = E[q_i q′_n] = −E[q′_i q_n]
/// E[q_i q_n] = (c_i + c_n)/E    s = (ω_i² − ω_n²)/E    E[q′_i q′_n] = (c_n ω_i² + c_i ω_n²)/E;   ρ, σ, τ: over the standard deviations
/// ```
/// Without dampers B = 0, and ρ is that of [`spectral_analysis`](crate::dynamics::spectral_analysis) to round-off.
///
/// # Errors
/// [`DamperError::Argument`] if a mode does not oscillate (the spectrum has no such oscillator) or two modes coincide. [`DamperError`] if a
/// damper is out of its range. Errors of the spectrum are passed on.
///
/// # Limits
/// The assumptions of CQC apply: wide-band shaking, and one ratio of peak to standard deviation for all modes, displacements and velocities.
/// Under white noise the standard deviations are exact to 1e-9. `docs/measured.md` compares them with time histories under noise. Dampers are
/// linear.
///
/// # Source
/// Igusa, Der Kiureghian & Sackman (1984) Earthquake Engng Struct. Dyn. 12:121-136; Zhou, Yu & Dong (2004) J. Struct. Eng. 130:663-672. Differs
/// from the source: the correlations are derived from Lyapunov's equation of two oscillators.
pub fn damped_spectral_analysis<E: From<DamperError>>(
    building: &VibratingBuilding,
    dampers: &[AttachedDamper],
    mut acceleration_m_s2: impl FnMut(f64, f64) -> Result<[f64; 2], E>,
) -> Result<DampedSpectralAnalysis, E> {
    let damped = in_modes(building, dampers)?;
    let Coupled {
        lambda,
        shapes,
        loads,
    } = coupled(building, &damped)?;
    let mut modes = Vec::with_capacity(lambda.len());
    for value in &lambda {
        let (period_s, damping_ratio) = (TAU / value.norm(), -value.re / value.norm());
        let acceleration = acceleration_m_s2(period_s, damping_ratio)?;
        if let Some(&given) = acceleration.iter().find(|a| !(**a >= 0.0 && a.is_finite())) {
            return Err(E::from(DamperError::Argument {
                argument: "spectral acceleration",
                given,
                allowed: "0 or a positive number",
            }));
        }
        modes.push(SpectralMode {
            period_s,
            damping_ratio,
            acceleration_m_s2: acceleration,
        });
    }
    let n = modes.len();
    let own: Vec<[f64; 2]> = lambda.iter().map(|l| [l.norm(), -2.0 * l.re]).collect();
    let of = |which: usize| Matrix::from_fn(n, n, |i, k| correlations(own[i], own[k])[which]);
    Ok(DampedSpectralAnalysis {
        modes,
        damped,
        building_shapes: building.modes().shapes.clone(),
        shapes,
        lambda,
        loads,
        correlations: [of(0), of(1), of(2)],
    })
}

/// ρ, σ, τ of two oscillators [ω, 2ζω].
fn correlations([omega_i, c_i]: [f64; 2], [omega_n, c_n]: [f64; 2]) -> [f64; 3] {
    let (square_i, square_n) = (omega_i * omega_i, omega_n * omega_n);
    let turned = c_n * square_i + c_i * square_n;
    let below = (square_i - square_n).powi(2) + (c_i + c_n) * turned;
    // standard deviations of q: 1/√(2 c ω²), of q′: ω times that
    let scale = 2.0 * (c_i * c_n).sqrt() * omega_i * omega_n;
    if below == 0.0 {
        return [1.0, 0.0, 1.0]; // one frequency, no damping
    }
    [
        scale * (c_i + c_n) / below,
        scale * (square_i - square_n) / (below * omega_n),
        scale * turned / (below * omega_i * omega_n),
    ]
}

struct Coupled {
    lambda: Vec<Complex64>,
    shapes: Vec<Vec<Complex64>>,
    loads: Vec<[Complex64; 2]>,
}

/// Complex modes of building and dampers, with the load of a ground motion along x and along y on each mode.
fn coupled(building: &VibratingBuilding, damped: &DampedSystem) -> Result<Coupled, DamperError> {
    let system = &damped.system;
    let size = system.degrees_of_freedom();
    let (k, c) = (
        solve(system.mass(), system.stiffness())?,
        solve(system.mass(), system.damping())?,
    );
    // velocities are scaled by a high frequency; otherwise rows of size ω² next to rows of size 1 lose digits
    let high = (0..size).map(|i| k[(i, i)].abs().sqrt()).fold(0.0, f64::max);
    let states = Matrix::from_fn(2 * size, 2 * size, |i, j| match (i < size, j < size) {
        (true, true) => 0.0,
        (true, false) => f64::from(u8::from(j - size == i)) * high,
        (false, true) => -k[(i - size, j)] / high,
        (false, false) => -c[(i - size, j - size)],
    });
    let found = eigen(&states)?;
    let mut order: Vec<usize> = (0..2 * size)
        .filter(|&i| found.values[i].im > SWINGS * found.values[i].norm())
        .collect();
    order.sort_by(|a, b| found.values[*a].norm().total_cmp(&found.values[*b].norm()));
    if order.len() != size {
        return Err(DamperError::Argument {
            argument: "the number of modes that swing with the dampers",
            given: order.len() as f64,
            allowed: "all of them: something is damped so much that a spectrum has no oscillator like it; lower its damping, or use a time \
                      history",
        });
    }
    // the initial ground acceleration, −e in the velocities, as Σ 2 Re (v p): columns Re v, Im v
    let parts = Matrix::from_fn(2 * size, 2 * size, |i, j| {
        let value = found.vectors[(i, order[j % size])];
        if j < size { value.re } else { value.im }
    });
    let modes = &building.modes().modes;
    let influences = [0, 1].map(|axis| {
        let gamma: Vec<f64> = modes.iter().map(|mode| mode.participation[axis]).collect();
        damped.influence(&gamma)
    });
    let push = Matrix::from_fn(2 * size, 2, |i, axis| match i.checked_sub(size) {
        None => 0.0,
        Some(i) => -influences[axis][i] / high,
    });
    let shares = solve(&parts, &push)?;
    let left = &(&parts * &shares) - &push;
    let largest = |of: &Matrix| of.as_slice().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let apart = largest(&left) / largest(&push);
    let cancel = largest(&shares) / largest(&push); // of vectors of length 1
    if !(apart <= COMPLETE && cancel <= CANCEL_MOST) {
        return Err(DamperError::Argument {
            argument: "the factor by which complex modes cancel",
            given: cancel,
            allowed: "at most a million: two of them have become one; change a damper's frequency or damping a little, or use a time history",
        });
    }
    Ok(Coupled {
        lambda: order.iter().map(|&i| found.values[i]).collect(),
        shapes: order
            .iter()
            .map(|&i| (0..size).map(|row| found.vectors[(row, i)]).collect())
            .collect(),
        loads: (0..size)
            .map(|j| [0, 1].map(|axis| 0.5 * Complex64::new(shares[(j, axis)], -shares[(size + j, axis)])))
            .collect(),
    })
}

impl DampedSpectralAnalysis {
    /// The largest response of the quantity that `row` defines on the coordinates of the building.
    pub fn largest(&self, row: &[f64], directional: DirectionalCombination) -> f64 {
        let shapes = &self.building_shapes;
        let along = |j: usize| -> f64 {
            let pairs = row.iter().zip(shapes.column(j));
            pairs.map(|(r, phi)| r * phi).sum()
        };
        let in_modes: Vec<f64> = (0..shapes.columns()).map(along).collect();
        let of_system = self.damped.row(&in_modes);
        directional.of(|axis| self.along(&of_system, axis))
    }

    /// The largest strokes of the dampers in order, m (relative displacement of a mass, rise of a liquid, elongation of a dashpot), then the
    /// liquid rises of columns on springs.
    pub fn largest_strokes_m(&self, directional: DirectionalCombination) -> Vec<f64> {
        let rows = self.damped.stroke_rows().into_iter();
        rows.map(|stroke| directional.of(|axis| self.along(&stroke, axis)))
            .collect()
    }

    fn along(&self, row: &[f64], axis: usize) -> f64 {
        let mut displaced = Vec::with_capacity(self.modes.len());
        let mut moving = Vec::with_capacity(self.modes.len());
        for (k, mode) in self.modes.iter().enumerate() {
            let lambda = self.lambda[k];
            let shape = row.iter().zip(&self.shapes[k]).map(|(r, phi)| r * phi);
            let part = shape.sum::<Complex64>() * self.loads[k][axis];
            let oscillator_m = mode.acceleration_m_s2[axis] / lambda.norm_sqr();
            // q is the response to −a, y the response to a
            displaced.push(2.0 * (part * lambda.conj()).re * oscillator_m);
            moving.push(-2.0 * part.re * lambda.norm() * oscillator_m);
        }
        let [rho, sigma, tau] = &self.correlations;
        let square = rho.form(&displaced, &displaced)
            + 2.0 * sigma.form(&displaced, &moving)
            + tau.form(&moving, &moving);
        square.max(0.0).sqrt()
    }
}
