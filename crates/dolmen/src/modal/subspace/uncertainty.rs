//! Standard deviation of poles, from the scatter of the correlations between blocks of time (first order).
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | dG | | Y⁺ Y⁻ᵀ for the deviation of one block: the Hankel matrix of its lags | m × r br, m = l br |
//! | X | `x` | U = (Y⁺ Y⁻ᵀ) X: V S⁻¹, or L⁻ᵀ V S⁻¹ for the data-driven method | r br × N |
//! | D | `d` | dG X | m × N |
//! | ↑, ↓ | `up`, `down` | without the last, without the first block row | m - l rows |
//! | E, F, G | `e`, `f`, `g` | Uᵀ D, Qᵀ D↓, Qᵀ D↑ | N × N |
//! | J, K | `j`, `k` | D↑ᵀ U↓, D↑ᵀ U↑ = Gᵀ R | N × N |
//! | χ, φ | `left`, `right` | left and right eigenvectors of A, χᵀφ = 1 | n |

use super::block_change::{Block, Rows};
use super::block_hankel::BlockHankel;
use super::ssi::{Pole, Subspace, back_substitute, state};
use crate::modal::ModalError;
use crate::modal::correlations::wide;
use crate::modal::indicators::largest;
use dolmen_linalg::{Complex64, ComplexMatrix, Matrix, eigen};
use std::f64::consts::PI;

/// Standard deviations of one pole.
#[derive(Clone, Debug, PartialEq)]
pub struct PoleDeviation {
    /// Standard deviation of the frequency, Hz.
    pub frequency_sd_hz: f64,
    /// Change of the frequency by each block of time, Hz: the sum of their squares is the square of `frequency_sd_hz`.
    pub frequency_changes_hz: Vec<f64>,
    /// Standard deviation of the damping ratio.
    pub damping_ratio_sd: f64,
    /// Standard deviation of the modulus of each shape component; 0 for the component that is scaled to 1. Empty if the
    /// method gives none.
    pub shape_sd: Vec<f64>,
}

/// Source of the standard deviations of the poles of one analysis.
pub(crate) trait Deviations {
    /// Standard deviation of the frequency of a pole, Hz.
    fn frequency_sd_hz(&mut self, pole: &Pole) -> Result<f64, ModalError>;
    fn deviation(&mut self, pole: &Pole) -> Result<PoleDeviation, ModalError>;
}

impl Deviations for Propagation<'_> {
    fn frequency_sd_hz(&mut self, pole: &Pole) -> Result<f64, ModalError> {
        Propagation::frequency_sd_hz(self, pole)
    }
    fn deviation(&mut self, pole: &Pole) -> Result<PoleDeviation, ModalError> {
        Propagation::deviation(self, pole)
    }
}

/// First-order propagation from the correlations of each block of time to the poles of one [`Subspace`].
///
/// ```text
/// dU = (I - U Uᵀ) D                                     the part inside span(U) turns U and A alike: no pole moves
/// dA φ = R⁻¹ [(F - λ G) φ - (Qᵀ U↓ - λ R) E φ] + (RᵀR)⁻¹ (J - λ K) φ      leading n × n blocks; shape: n × 1
/// dλ = χᵀ dA φ = wᵀ (F - λ G) φ + vᵀ (J - λ K) φ,   w = R⁻ᵀ χ,   v = R⁻¹ w
/// dφ = Σ φ_k χ_kᵀ dA φ / (λ - λ_k)
/// var(f) = b/(b-1) Σ df²                                over the b blocks of time
/// ```
/// In dλ the middle term of dA φ is zero: χᵀ R⁻¹ (Qᵀ U↓ - λ R) = χᵀ (A - λ) = 0.
///
/// For each block all orders need only five N × N matrices, with N the highest order; neither a Kronecker product nor
/// the Hankel matrix of a block is formed. In the data-driven method, a change of L rotates V and moves U only within
/// its span, except for the part due to noise. So to first order D is the same expression, with the X of that method.
///
/// # Limits
/// First order: valid if the standard deviation is small compared with the distance to the next pole with a similar
/// shape. Blocks must be long compared with the correlation time 1/(2πζf).
///
/// # Source
/// Reynders, Pintelon & De Roeck (2008) Mech. Syst. Signal Process. 22:948-969; Döhler & Mevel (2013) Mech. Syst.
/// Signal Process. 38:346-366. Differs from the sources: matrix–vector products for the requested poles instead of the
/// covariance of A; the shape is scaled to 1 at its largest component before its standard deviation is computed.
pub struct Propagation<'a> {
    subspace: &'a Subspace,
    blocks: Vec<Block>,
    /// State matrices decomposed so far, by order.
    orders: Vec<Option<OrderSensitivity>>,
}

/// One order, and the change of its eigenvalues by each block of time.
struct OrderSensitivity {
    order: Order,
    /// dλ of the eigenvalues in the upper half plane, 0 for the others: eigenvalues in rows, blocks in columns.
    moves: ComplexMatrix,
}

impl<'a> Propagation<'a> {
    /// Projects the deviation of every block, which all poles need.
    pub fn new(subspace: &'a Subspace) -> Self {
        let (l, br) = (subspace.correlations.channels, subspace.block_rows);
        let size = [l, subspace.correlations.columns.len()];
        let places = subspace.correlations.places(&subspace.references);
        let (mut x, mut rows) = (None, None);
        let of_lags = subspace.correlations.deviations.iter().map(|lags| {
            let hankel = BlockHankel::new(&wide(lags), size, &places, br);
            let x = x.get_or_insert_with(|| hankel.transformed(&subspace.x));
            let rows = rows.get_or_insert_with(|| {
                Rows::of((&subspace.u, &subspace.upper), l, &(0..l).collect::<Vec<_>>())
            });
            rows.block(&hankel.times_transformed(x))
        });
        Propagation {
            subspace,
            blocks: of_lags.chain(subspace.moved.iter().cloned()).collect(),
            orders: (0..=subspace.order_most).map(|_| None).collect(),
        }
    }

    /// Standard deviation of the frequency of a pole of this subspace, Hz.
    ///
    /// # Errors
    /// [`ModalError::Linalg`].
    pub fn frequency_sd_hz(&mut self, pole: &Pole) -> Result<f64, ModalError> {
        let (known, blocks, subspace) = self.order(pole)?;
        let index = nearest(&known.order.values, pole.eigenvalue);
        let rate_hz = subspace.sampling_rate_hz;
        let changes = (0..blocks.len()).map(|b| known.moves[(index, b)]);
        let changes = changes.map(|d_lambda| frequency_and_damping(pole, d_lambda, rate_hz)[0]);
        let sum: f64 = changes.map(|d| d * d).sum();
        Ok((correction(blocks.len()) * sum).sqrt())
    }

    /// Standard deviations of a pole of this subspace.
    ///
    /// # Errors
    /// [`ModalError::Linalg`].
    pub fn deviation(&mut self, pole: &Pole) -> Result<PoleDeviation, ModalError> {
        let (OrderSensitivity { order, .. }, blocks, subspace) = self.order(pole)?;
        let index = nearest(&order.values, pole.eigenvalue);
        let shape = leading_times(&subspace.u, pole.shape.len(), order.right.column(index));
        let (mut z2, mut s2) = (0.0, vec![0.0; pole.shape.len()]);
        let mut changes_hz = Vec::with_capacity(blocks.len());
        let share = correction(blocks.len()).sqrt();
        for block in blocks {
            let d_a_phi = order.state_change(subspace, block, index);
            let d_lambda = order.along(index, &d_a_phi);
            let [df, dz] = frequency_and_damping(pole, d_lambda, subspace.sampling_rate_hz);
            changes_hz.push(share * df);
            z2 += dz * dz;
            let d_shape = order.shape_change(subspace, block, index, &d_a_phi);
            for (c, d) in unit_shape_change(&shape, &d_shape).into_iter().enumerate() {
                let phi = pole.shape[c];
                let along = if phi.norm() > 0.0 {
                    (phi.conj() * d).re / phi.norm()
                } else {
                    d.norm()
                };
                s2[c] += along * along;
            }
        }
        let sd = |sum: f64| (correction(blocks.len()) * sum).sqrt();
        Ok(PoleDeviation {
            frequency_sd_hz: changes_hz.iter().map(|d| d * d).sum::<f64>().sqrt(),
            frequency_changes_hz: changes_hz,
            damping_ratio_sd: sd(z2),
            shape_sd: s2.into_iter().map(sd).collect(),
        })
    }

    fn order(&mut self, pole: &Pole) -> Result<(&OrderSensitivity, &[Block], &'a Subspace), ModalError> {
        let slot = &mut self.orders[pole.order];
        let known = match slot {
            Some(known) => known,
            None => {
                let a = state(&self.subspace.upper.r, &self.subspace.shifted, pole.order);
                let order = Order::of(&a)?;
                let moves = order.moves(self.subspace, &self.blocks);
                slot.insert(OrderSensitivity { order, moves })
            }
        };
        Ok((known, &self.blocks, self.subspace))
    }
}

/// Correction of a sum of squares of blocks of time about their own mean.
pub(crate) fn correction(blocks: usize) -> f64 {
    blocks as f64 / (blocks as f64 - 1.0)
}

/// Changes of frequency, Hz, and of damping ratio, for a change of the discrete eigenvalue.
pub(crate) fn frequency_and_damping(pole: &Pole, d_lambda: Complex64, rate_hz: f64) -> [f64; 2] {
    let mu = pole.eigenvalue.ln() * rate_hz;
    let omega = mu.norm();
    let d_mu = d_lambda / pole.eigenvalue * rate_hz;
    let d_omega = (mu.conj() * d_mu).re / omega;
    [
        d_omega / (2.0 * PI),
        -d_mu.re / omega + mu.re * d_omega / (omega * omega),
    ]
}

/// Change of a shape whose largest component is scaled to 1.
fn unit_shape_change(shape: &[Complex64], change: &[Complex64]) -> Vec<Complex64> {
    let m = largest(shape).unwrap_or(0);
    let (top, d_top) = (shape[m], change[m]);
    let pairs = shape.iter().zip(change);
    pairs.map(|(x, d)| d / top - x * d_top / (top * top)).collect()
}

/// Eigenvalues and vectors of the state matrix of one order.
pub(crate) struct Order {
    n: usize,
    pub(crate) values: Vec<Complex64>,
    pub(crate) right: ComplexMatrix,
    /// Left eigenvector k in column k, scaled so that χ_kᵀ φ_k = 1.
    pub(crate) left: ComplexMatrix,
}

impl Order {
    pub(crate) fn of(a: &Matrix) -> Result<Self, ModalError> {
        let n = a.rows();
        let (e, mut mirrored) = (eigen(a)?, eigen(&a.transpose())?);
        let mut left = ComplexMatrix::zeros(n, n);
        for k in 0..n {
            let from = nearest(&mirrored.values, e.values[k]);
            mirrored.values[from] = Complex64::new(f64::INFINITY, 0.0); // taken
            let (chi, phi) = (mirrored.vectors.column(from), e.vectors.column(k));
            let scale: Complex64 = chi.iter().zip(phi).map(|(x, y)| x * y).sum();
            for i in 0..n {
                left[(i, k)] = chi[i] / scale;
            }
        }
        Ok(Order {
            n,
            values: e.values,
            right: e.vectors,
            left,
        })
    }

    /// First-order changes dλ of the eigenvalues in the upper half plane by the deviation of each block, computed
    /// together.
    fn moves(&self, s: &Subspace, blocks: &[Block]) -> ComplexMatrix {
        let n = self.n;
        let upper: Vec<usize> = (0..n).filter(|&k| self.values[k].im > 0.0).collect();
        let p = upper.len();
        // real and imaginary parts side by side
        let phi = Matrix::from_fn(n, 2 * p, |i, j| {
            let z = self.right[(i, upper[j % p])];
            if j < p { z.re } else { z.im }
        });
        let weights = upper.iter().map(|&k| {
            let mut w = self.left.column(k).to_vec();
            forward_substitute(&s.upper.r, &mut w);
            let mut v = w.clone();
            back_substitute_complex(&s.upper.r, &mut v);
            [w, v]
        });
        let weights: Vec<[Vec<Complex64>; 2]> = weights.collect();
        let mut moves = ComplexMatrix::zeros(n, blocks.len());
        for (b, block) in blocks.iter().enumerate() {
            let [f, g, j, k] = [&block.f, &block.g, &block.j, &block.k].map(|m| &m.block(0, 0, n, n) * &phi);
            let along = |weight: &[Complex64], m: &Matrix, at: usize| -> Complex64 {
                let (re, im) = (m.column(at), m.column(p + at));
                let parts = re.iter().zip(im).map(|(re, im)| Complex64::new(*re, *im));
                weight.iter().zip(parts).map(|(w, m)| w * m).sum()
            };
            for (at, (&index, [w, v])) in upper.iter().zip(&weights).enumerate() {
                let lambda = self.values[index];
                moves[(index, b)] = along(w, &f, at) - lambda * along(w, &g, at) + along(v, &j, at)
                    - lambda * along(v, &k, at);
            }
        }
        moves
    }

    /// dA φ of the pole at `index` for one block's deviation.
    fn state_change(&self, s: &Subspace, block: &Block, index: usize) -> Vec<Complex64> {
        let (n, lambda, phi) = (self.n, self.values[index], self.right.column(index));
        let difference = |a: &Matrix, b: &Matrix, x: &[Complex64]| -> Vec<Complex64> {
            let (ax, bx) = (leading_times(a, n, x), leading_times(b, n, x));
            ax.iter().zip(&bx).map(|(a, b)| a - lambda * b).collect()
        };
        let moved = difference(&block.f, &block.g, phi);
        let turned = difference(&s.shifted, &s.upper.r, &leading_times(&block.e, n, phi));
        let mut second = difference(&block.j, &block.k, phi);
        forward_substitute(&s.upper.r, &mut second);
        let mut sum: Vec<Complex64> = (0..n).map(|i| moved[i] - turned[i] + second[i]).collect();
        back_substitute_complex(&s.upper.r, &mut sum);
        sum
    }

    /// χ_kᵀ x.
    fn along(&self, k: usize, x: &[Complex64]) -> Complex64 {
        self.left.column(k).iter().zip(x).map(|(chi, x)| chi * x).sum()
    }

    /// Change of the first block row of U φ.
    fn shape_change(
        &self,
        s: &Subspace,
        block: &Block,
        index: usize,
        d_a_phi: &[Complex64],
    ) -> Vec<Complex64> {
        let (n, l, phi) = (self.n, block.top.rows(), self.right.column(index));
        let mut d_phi: Vec<Complex64> = leading_times(&block.e, n, phi).iter().map(|e| -e).collect();
        for k in (0..n).filter(|&k| k != index) {
            let weight = self.along(k, d_a_phi) / (self.values[index] - self.values[k]);
            for (d, phi) in d_phi.iter_mut().zip(self.right.column(k)) {
                *d += weight * phi;
            }
        }
        let (inside, outside) = (leading_times(&s.u, l, &d_phi), leading_times(&block.top, l, phi));
        inside.iter().zip(&outside).map(|(a, b)| a + b).collect()
    }
}

/// Index of the nearest eigenvalue.
pub(crate) fn nearest(values: &[Complex64], to: Complex64) -> usize {
    let apart = |k: usize| (values[k] - to).norm_sqr();
    (0..values.len())
        .reduce(|best, k| if apart(k) < apart(best) { k } else { best })
        .unwrap_or(0)
}

/// The first `rows` rows of `m`, as many columns as `x` has, times `x`.
fn leading_times(m: &Matrix, rows: usize, x: &[Complex64]) -> Vec<Complex64> {
    // real and imaginary parts separately, for vector instructions
    let (mut re, mut im) = (vec![0.0; rows], vec![0.0; rows]);
    for (j, xj) in x.iter().enumerate() {
        let column = &m.column(j)[..rows];
        for ((re, im), m) in re.iter_mut().zip(&mut im).zip(column) {
            *re += xj.re * m;
            *im += xj.im * m;
        }
    }
    let parts = re.into_iter().zip(im);
    parts.map(|(re, im)| Complex64::new(re, im)).collect()
}

/// x ← R_n⁻¹ x.
fn back_substitute_complex(r: &Matrix, x: &mut [Complex64]) {
    let mut part: [Vec<f64>; 2] = [x.iter().map(|z| z.re).collect(), x.iter().map(|z| z.im).collect()];
    part.iter_mut().for_each(|p| back_substitute(r, p));
    for (i, z) in x.iter_mut().enumerate() {
        *z = Complex64::new(part[0][i], part[1][i]);
    }
}

/// x ← R_n⁻ᵀ x.
pub(crate) fn forward_substitute(r: &Matrix, x: &mut [Complex64]) {
    for i in 0..x.len() {
        let sum: Complex64 = r.column(i)[..i].iter().zip(&x[..i]).map(|(r, x)| x * r).sum();
        x[i] = (x[i] - sum) / r[(i, i)];
    }
}
