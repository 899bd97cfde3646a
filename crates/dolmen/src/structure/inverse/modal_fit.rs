//! Difference between a structure with given stiffness and measured modes, with exact derivatives.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_i | `x` | ln k_i | |
//! | L | `lower` | M = L Lᵀ | |
//! | q_j, λ_j | | eigenvector and eigenvalue of L⁻¹ K L⁻ᵀ, φ_j = L⁻ᵀ q_j | , (rad/s)² |
//! | ĉ_i | `springs` | L⁻¹ b_i | |
//! | ẑ_p | `Shape::sensors` | L⁻¹ c(z_p) | |
//! | w, v | `Shape::measured`, `computed` | measured and computed shape, each over its sd | |
//! | a | `scale` | scale of the shape, (vᵀw)/(vᵀv) | |

use super::{SpringModel, Sprung};
use crate::numeric::Residuals;
use crate::structure::{MeasuredMode, StructureError};
use dolmen_linalg::{Matrix, cholesky, solve, symmetric_eigen};

/// Standard deviations assumed for modes without any.
#[derive(Clone, Copy)]
pub(super) struct StandIn {
    /// Relative to the frequency.
    pub(super) frequency: f64,
    /// Relative to the largest displacement of the mode.
    pub(super) shape: f64,
}

struct Shape {
    sensors: Vec<Vec<f64>>,
    measured: Vec<f64>,
    sd: Vec<f64>,
}

struct Target {
    /// ln ω².
    ln_omega_squared: f64,
    /// sd of ln f.
    sd: f64,
    /// Whether this follows from a standard deviation given in Hz.
    is_stated: bool,
    /// Changes of ln f by each block of time, over sd.
    changes: Vec<f64>,
    shape: Option<Shape>,
}

pub(super) struct ModalFit {
    springs: Vec<Vec<f64>>,
    /// L⁻¹ K_0 L⁻ᵀ: the stiffness without the springs.
    rest: Matrix,
    targets: Vec<Target>,
}

impl ModalFit {
    pub(super) fn new(
        structure: &impl Sprung,
        model: &SpringModel,
        modes: &[MeasuredMode],
        stand_in: StandIn,
    ) -> Result<Self, StructureError> {
        let lower = cholesky(&model.mass)?;
        let reduce = |v: &[f64]| -> Result<Vec<f64>, StructureError> {
            Ok(solve(&lower, &Matrix::from_column(v))?.column(0).to_vec())
        };
        let half = solve(&lower, &model.rest)?;
        let springs = (0..model.parts()).map(|i| reduce(model.springs.column(i)));
        let targets = modes.iter().map(|mode| -> Result<Target, StructureError> {
            let given = mode.frequency_sd_hz / mode.frequency_hz;
            let changes = mode.frequency_changes_hz.iter();
            Ok(Target {
                ln_omega_squared: 2.0 * (std::f64::consts::TAU * mode.frequency_hz).ln(),
                sd: if given > 0.0 { given } else { stand_in.frequency },
                is_stated: given > 0.0,
                changes: match given > 0.0 {
                    true => changes.map(|d| d / mode.frequency_sd_hz).collect(),
                    false => Vec::new(),
                },
                shape: shape(structure, mode, stand_in.shape, &reduce)?,
            })
        });
        Ok(ModalFit {
            springs: springs.collect::<Result<_, _>>()?,
            rest: solve(&lower, &half.transpose())?,
            targets: targets.collect::<Result<_, _>>()?,
        })
    }

    /// Number of independent data: a shape of p points has p − 1, because its scale is free.
    pub(super) fn data(&self) -> usize {
        let shapes = self.targets.iter().filter_map(|target| target.shape.as_ref());
        self.targets.len() + shapes.map(|shape| shape.measured.len() - 1).sum::<usize>()
    }

    /// Correlations of the data: frequencies with common blocks of time are correlated; 1 on the diagonal.   shape: data × data
    pub(super) fn correlations(&self) -> Matrix {
        let mut rows = Vec::new(); // where each frequency stands
        let mut count = 0;
        for target in &self.targets {
            rows.push(count);
            count += 1 + target.shape.as_ref().map_or(0, |shape| shape.measured.len());
        }
        let mut all = Matrix::identity(count);
        for (a, one) in rows.iter().zip(&self.targets) {
            for (b, other) in rows.iter().zip(&self.targets) {
                if a != b && one.changes.len() == other.changes.len() {
                    all[(*a, *b)] = dot(&one.changes, &other.changes).clamp(-1.0, 1.0);
                }
            }
        }
        all
    }

    /// Largest difference of the shape of each mode, relative to its largest displacement; `None` for a mode without a shape.
    pub(super) fn shapes_off(&self, x: &[f64]) -> Vec<Option<f64>> {
        let Some(at) = self.residuals(x) else {
            return vec![None; self.targets.len()];
        };
        let mut rows = at.residual.iter();
        let each = self.targets.iter().map(|target| {
            rows.next(); // the frequency
            let shape = target.shape.as_ref()?;
            let (mut difference, mut largest) = (0.0_f64, 0.0_f64);
            for ((w, sd), r) in shape.measured.iter().zip(&shape.sd).zip(rows.by_ref()) {
                difference = difference.max((r * sd).abs());
                largest = largest.max((w * sd).abs());
            }
            Some(difference / largest)
        });
        each.collect()
    }

    /// ω² of all modes, ascending.
    pub(super) fn omega_squared(&self, x: &[f64]) -> Option<Vec<f64>> {
        Some(symmetric_eigen(&self.reduced_stiffness(x)).ok()?.values)
    }

    /// Mean of ln ω²_measured − ln ω²_computed over the measured modes; `None` if the structure is unstable.
    pub(super) fn mean_log_frequency_short(&self, x: &[f64]) -> Option<f64> {
        let values = self.omega_squared(x).filter(|values| values[0] > 0.0)?;
        let each = self.targets.iter().zip(&values);
        let sum: f64 = each
            .map(|(target, value)| target.ln_omega_squared - value.ln())
            .sum();
        Some(sum / self.targets.len() as f64)
    }

    fn reduced_stiffness(&self, x: &[f64]) -> Matrix {
        let n = x.len();
        let mut a = self.rest.clone();
        for (c, x) in self.springs.iter().zip(x) {
            let k = x.exp();
            for j in 0..n {
                for i in 0..n {
                    a[(i, j)] += k * c[i] * c[j];
                }
            }
        }
        a
    }

    /// Residuals with given frequencies in Hz, so that equal differences above and below a measured frequency count equally.
    ///
    /// ```text
    /// r = (f/f_measured − 1)/sd,   from r' = ln(f/f_measured)/sd and dr'/dx
    /// ```
    pub(super) fn residuals_as_stated(&self, x: &[f64]) -> Option<Residuals> {
        let mut all = self.residuals(x)?;
        let mut row = 0;
        for target in &self.targets {
            if target.is_stated {
                let ratio = (all.residual[row] * target.sd).exp();
                all.residual[row] = (ratio - 1.0) / target.sd;
                (0..x.len()).for_each(|i| all.jacobian[(row, i)] *= ratio);
            }
            row += 1 + target.shape.as_ref().map_or(0, |shape| shape.measured.len());
        }
        let is_finite = all.residual.iter().all(|r| r.is_finite());
        is_finite.then_some(all)
    }

    /// Residuals (computed − measured)/sd with frequencies as logarithms, and their derivatives d/dx; `None` if the structure is
    /// unstable.
    ///
    /// ```text
    /// d ln f_j / dx_i = k_i (ĉ_iᵀ q_j)² / 2 λ_j
    /// dq_j / dx_i = Σ_{m≠j} q_m k_i (ĉ_iᵀ q_m)(ĉ_iᵀ q_j) / (λ_j − λ_m)
    /// shape: r = a v − w,  dr = a (I − v vᵀ/vᵀv) dv − v (dvᵀ r)/(vᵀv)        variable projection
    /// ```
    pub(super) fn residuals(&self, x: &[f64]) -> Option<Residuals> {
        let n = x.len();
        let eigen = symmetric_eigen(&self.reduced_stiffness(x)).ok()?;
        if eigen.values[0] <= 0.0 {
            return None;
        }
        let turn = Matrix::from_fn(n, n, |i, j| dot(&self.springs[i], eigen.vectors.column(j)));
        let mut rows: Vec<(f64, Vec<f64>)> = Vec::new();
        for (j, target) in self.targets.iter().enumerate() {
            let lambda = eigen.values[j];
            let slope = |i: usize| 0.5 * x[i].exp() * turn[(i, j)].powi(2) / lambda / target.sd;
            let off = 0.5 * (lambda.ln() - target.ln_omega_squared) / target.sd;
            rows.push((off, (0..n).map(slope).collect()));
            let Some(shape) = &target.shape else { continue };
            let seen = |q: &[f64]| -> Vec<f64> {
                let points = shape.sensors.iter().zip(&shape.sd);
                points.map(|(z, sd)| dot(z, q) / sd).collect()
            };
            let all: Vec<Vec<f64>> = (0..n).map(|m| seen(eigen.vectors.column(m))).collect();
            let v = &all[j];
            let square = dot(v, v).max(f64::MIN_POSITIVE);
            let scale = dot(v, &shape.measured) / square;
            let off: Vec<f64> = v
                .iter()
                .zip(&shape.measured)
                .map(|(v, w)| scale * v - w)
                .collect();
            let first = rows.len();
            rows.extend(off.iter().map(|&r| (r, vec![0.0; n])));
            for i in 0..n {
                let mut dv = vec![0.0; v.len()];
                for m in (0..n).filter(|&m| m != j) {
                    let gap = lambda - eigen.values[m];
                    let share = x[i].exp() * turn[(i, m)] * turn[(i, j)] / gap;
                    dv.iter_mut().zip(&all[m]).for_each(|(dv, u)| *dv += share * u);
                }
                let (along, across) = (dot(v, &dv) / square, dot(&dv, &off) / square);
                for (p, (_, row)) in rows[first..].iter_mut().enumerate() {
                    row[i] = scale * (dv[p] - v[p] * along) - v[p] * across;
                }
            }
        }
        if rows
            .iter()
            .any(|(r, row)| !r.is_finite() || row.iter().any(|d| !d.is_finite()))
        {
            return None; // two equal eigenvalues: the shape has no derivative there
        }
        Some(Residuals {
            jacobian: Matrix::from_fn(rows.len(), n, |i, j| rows[i].1[j]),
            residual: rows.into_iter().map(|(r, _)| r).collect(),
        })
    }
}

/// Standard deviation of the point that sets the scale of a shape, which has no scatter, as a fraction of the smallest of the others.
/// Small enough to fix the scale, large enough for a well-conditioned problem. Our choice.
const EXACT_SHARE: f64 = 1e-3;
/// A standard deviation below this share of the largest displacement is 0 with rounding.
const ROUNDING: f64 = 1e-12;

/// The points of a mode, each over its sd; `None` with fewer than 2, because the scale is free.
fn shape(
    structure: &impl Sprung,
    mode: &MeasuredMode,
    stand_in: f64,
    reduce: &impl Fn(&[f64]) -> Result<Vec<f64>, StructureError>,
) -> Result<Option<Shape>, StructureError> {
    if mode.shape.len() < 2 {
        return Ok(None);
    }
    let largest = mode
        .shape
        .iter()
        .fold(0.0_f64, |most, point| most.max(point.displacement.abs()));
    let mut shape = Shape {
        sensors: Vec::new(),
        measured: Vec::new(),
        sd: Vec::new(),
    };
    let given = mode.shape.iter().map(|point| point.displacement_sd);
    let least = given
        .filter(|&sd| sd > ROUNDING * largest)
        .fold(f64::INFINITY, f64::min);
    let exact = if least.is_finite() {
        EXACT_SHARE * least
    } else {
        stand_in * largest
    };
    for point in &mode.shape {
        let sd = if point.displacement_sd > ROUNDING * largest {
            point.displacement_sd
        } else {
            exact
        };
        shape.sensors.push(reduce(&structure.sensor(point.height_m)?)?);
        shape.measured.push(point.displacement / sd);
        shape.sd.push(sd);
    }
    Ok(Some(shape))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Chain, Inertia, Link, ShapePoint, SideSupport};

    #[test]
    fn exact_derivatives_of_frequencies_and_shapes() {
        let link = |mass_kg: f64, length_m: f64| Link {
            mass_kg,
            length_m,
            centroid_m: 0.45 * length_m,
            inertia: Inertia::ThinRod,
            bed_width_m: None,
        };
        let support = SideSupport {
            height_m: 2.0,
            stiffness_n_m: 3e4,
            gap_m: 0.0,
        };
        let chain = Chain::new(vec![link(900.0, 1.5), link(500.0, 1.2), link(300.0, 0.9)], 9.81).unwrap();
        let chain = chain.with_side_support(support).unwrap();
        let point = |height_m: f64, displacement: f64| ShapePoint {
            height_m,
            displacement,
            displacement_sd: 0.05,
        };
        let mode = |frequency_hz: f64, last: f64| MeasuredMode {
            frequency_hz,
            frequency_sd_hz: 0.1,
            frequency_changes_hz: Vec::new(),
            shape: vec![point(1.0, 0.3), point(2.2, 0.5), point(3.6, last)],
        };
        let stand_in = StandIn {
            frequency: 1.0,
            shape: 1.0,
        };
        let fit = ModalFit::new(
            &chain,
            &chain.model().unwrap(),
            &[mode(1.0, 1.1), mode(4.0, -0.7)],
            stand_in,
        )
        .unwrap();
        let x = [11.5, 10.8, 10.1];
        let at = fit.residuals(&x).unwrap();
        assert_eq!((at.residual.len(), fit.data()), (8, 6));
        const STEP: f64 = 1e-5; // central difference: error of order STEP² against rounding of 1e-16 / STEP
        for i in 0..3 {
            let moved = |by: f64| {
                let mut x = x;
                x[i] += by;
                fit.residuals(&x).unwrap().residual
            };
            let (ahead, behind) = (moved(STEP), moved(-STEP));
            for p in 0..8 {
                let slope = (ahead[p] - behind[p]) / (2.0 * STEP);
                let exact = at.jacobian[(p, i)];
                assert!(
                    (slope - exact).abs() < 1e-7 * (1.0 + exact.abs()),
                    "datum {p}, joint {i}: {slope} {exact}"
                );
            }
        }
    }
}
