//! Standard deviation of poles, from the scatter of the correlations between blocks of time (first order).
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | dG | `beside` | Y⁺ Y⁻ᵀ of one block's deviation: the Hankel matrix of its lags | m × r br, m = l br |
//! | X | `x` | U = (Y⁺ Y⁻ᵀ) X: V S⁻¹, of the data-driven method L⁻ᵀ V S⁻¹ | r br × N |
//! | D | `d` | dG X | m × N |
//! | ↑, ↓ | `up`, `down` | without the last, the first block row | m - l rows |
//! | E, F, G | `e`, `f`, `g` | Uᵀ D, Qᵀ D↓, Qᵀ D↑ | N × N |
//! | J, K | `j`, `k` | D↑ᵀ U↓, D↑ᵀ U↑ | N × N |
//! | χ, φ | `left`, `right` | left and right eigenvectors of A, χᵀφ = 1 | n |

use super::hankel::side_by_side;
use super::ssi::{Pole, Subspace, back_substitute, state};
use crate::modal::ModalError;
use crate::modal::indicators::largest;
use dolmen_linalg::{Complex64, ComplexMatrix, Matrix, eigen};
use std::f64::consts::PI;

/// Standard deviations of one pole.
#[derive(Clone, Debug, PartialEq)]
pub struct PoleDeviation {
    /// Of the frequency, Hz.
    pub frequency_sd_hz: f64,
    /// Change of the frequency by each block of time, Hz: the squares sum to the square of `frequency_sd_hz`.
    pub frequency_changes_hz: Vec<f64>,
    /// Of the damping ratio.
    pub damping_ratio_sd: f64,
    /// Of the modulus of each shape component; 0 for the component that is set to 1. Empty where the method gives none.
    pub shape_sd: Vec<f64>,
}

/// Who knows how far the poles of one analysis scatter.
pub(crate) trait Deviations {
    /// Standard deviation of the frequency of a pole, Hz.
    fn frequency_sd_hz(&mut self, pole: &Pole) -> Result<f64, ModalError>;
    /// Standard deviations of a pole.
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
/// dλ = χᵀ dA φ;   dφ = Σ φ_k χ_kᵀ dA φ / (λ - λ_k)
/// var(f) = b/(b-1) Σ df²                                over the b blocks of time
/// ```
/// Everything of a block that any order needs are five N × N matrices, N the highest order: no Kronecker product is
/// formed and no block's Hankel matrix either. Of the data-driven method the change of L turns V and moves U within its
/// span, but for the part that noise alone holds: to first order D is the same expression with its own X.
///
/// # Limits
/// First order: it holds where the standard deviation is small beside the distance to the next pole of like shape.
/// Blocks must be long beside the correlation time 1/(2πζf).
///
/// # Source
/// Reynders, Pintelon & De Roeck (2008) Mech. Syst. Signal Process. 22:948-969; Döhler & Mevel (2013) Mech. Syst.
/// Signal Process. 38:346-366. Differs from the sources: matrix–vector products for the poles asked, not the
/// covariance of A; the shape is set to 1 at its largest component before its deviation is taken.
pub struct Propagation<'a> {
    subspace: &'a Subspace,
    blocks: Vec<Block>,
    /// State matrices decomposed so far, by order.
    orders: Vec<Option<Order>>,
}

impl<'a> Propagation<'a> {
    /// Projects every block's deviation: the work that all poles share.
    pub fn new(subspace: &'a Subspace) -> Self {
        let of_lags = subspace.correlations.deviations.iter();
        let of_lags = of_lags.map(|lags| Block::new(subspace, &changes(subspace, lags)));
        let of_setups = subspace.moved.iter().map(|d| Block::new(subspace, d));
        Propagation {
            subspace,
            blocks: of_lags.chain(of_setups).collect(),
            orders: (0..=subspace.order_most).map(|_| None).collect(),
        }
    }

    /// Standard deviation of the frequency of a pole of this subspace, Hz.
    ///
    /// # Errors
    /// [`ModalError::Linalg`].
    pub fn frequency_sd_hz(&mut self, pole: &Pole) -> Result<f64, ModalError> {
        let (order, blocks, subspace) = self.order(pole)?;
        let index = nearest(&order.values, pole.eigenvalue);
        let changes = blocks.iter().map(|b| {
            let d_lambda = order.along(index, &order.state_change(subspace, b, index));
            frequency_and_damping(pole, d_lambda, subspace.sampling_rate_hz)[0]
        });
        let sum: f64 = changes.map(|d| d * d).sum();
        Ok((correction(blocks.len()) * sum).sqrt())
    }

    /// Standard deviations of a pole of this subspace.
    ///
    /// # Errors
    /// [`ModalError::Linalg`].
    pub fn deviation(&mut self, pole: &Pole) -> Result<PoleDeviation, ModalError> {
        let (order, blocks, subspace) = self.order(pole)?;
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

    fn order(&mut self, pole: &Pole) -> Result<(&Order, &[Block], &'a Subspace), ModalError> {
        let slot = &mut self.orders[pole.order];
        let order = match slot {
            Some(order) => order,
            None => {
                let a = state(&self.subspace.upper.r, &self.subspace.shifted, pole.order);
                slot.insert(Order::of(&a)?)
            }
        };
        Ok((order, &self.blocks, self.subspace))
    }
}

/// Of a sum of squares over blocks of time whose mean is their own.
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

/// Change of a shape whose largest component is held at 1.
fn unit_shape_change(shape: &[Complex64], change: &[Complex64]) -> Vec<Complex64> {
    let m = largest(shape).unwrap_or(0);
    let (top, d_top) = (shape[m], change[m]);
    let pairs = shape.iter().zip(change);
    pairs.map(|(x, d)| d / top - x * d_top / (top * top)).collect()
}

/// What one block of time changes, projected.
struct Block {
    e: Matrix,
    f: Matrix,
    g: Matrix,
    j: Matrix,
    k: Matrix,
    /// First block row of D.
    top: Matrix,
}

impl Block {
    fn new(s: &Subspace, d: &Matrix) -> Self {
        let (l, m, n) = (s.correlations.channels, s.u.rows(), s.order_most);
        let (up, down) = (d.block(0, 0, m - l, n), d.block(l, 0, m - l, n));
        let (u_up, u_down) = (s.u.block(0, 0, m - l, n), s.u.block(l, 0, m - l, n));
        Block {
            e: s.u.transpose_times(d),
            f: s.upper.q.transpose_times(&down),
            g: s.upper.q.transpose_times(&up),
            j: up.transpose_times(&u_down),
            k: up.transpose_times(&u_up),
            top: d.block(0, 0, l, n),
        }
    }
}

/// D = dG X, block row by block row.
fn changes(s: &Subspace, lags: &[f64]) -> Matrix {
    let (l, r, br) = (s.correlations.channels, s.references.len(), s.block_rows);
    let beside = side_by_side(lags, l, &s.references, br);
    let mut d = Matrix::zeros(l * br, s.order_most);
    for i in 0..br {
        let row = &beside.block(0, i * r, l, r * br) * &s.x;
        for j in 0..s.order_most {
            d.column_mut(j)[i * l..(i + 1) * l].copy_from_slice(row.column(j));
        }
    }
    d
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

/// Which of the eigenvalues is nearest.
pub(crate) fn nearest(values: &[Complex64], to: Complex64) -> usize {
    let apart = |k: usize| (values[k] - to).norm_sqr();
    (0..values.len())
        .reduce(|best, k| if apart(k) < apart(best) { k } else { best })
        .unwrap_or(0)
}

/// First `rows` rows and as many columns of `m` as `x` is long, times `x`.
fn leading_times(m: &Matrix, rows: usize, x: &[Complex64]) -> Vec<Complex64> {
    // real and imaginary parts apart, for the processor's wide registers
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
