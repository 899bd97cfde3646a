//! Standard deviation of one pole, from the scatter of the correlations between blocks of time (first order).
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | dH | `hankel_times` | Hankel matrix of one block's deviation | m × m, m = l br |
//! | P | `off_subspace` | I - U Uᵀ, U the first n left singular vectors | m × m |
//! | w | `w` | V S⁻¹ φ | m |
//! | r | `residual` | (O↓ - λ O↑) φ | m - l |
//! | χ | `left` | left eigenvector, χᵀ A = λ χᵀ | n |

use super::ModalError;
use super::indicators::largest;
use super::ssi_cov::{Pole, Subspace, back_substitute, state};
use dolmen_linalg::{Complex64, ComplexMatrix, Matrix, eigen};
use std::f64::consts::PI;

/// Standard deviations of one pole.
#[derive(Clone, Debug, PartialEq)]
pub struct PoleDeviation {
    /// Of the frequency, Hz.
    pub frequency_sd_hz: f64,
    /// Of the damping ratio.
    pub damping_ratio_sd: f64,
    /// Of the modulus of each shape component; 0 for the component that is set to 1.
    pub shape_sd: Vec<f64>,
}

/// Standard deviations of `pole`, by first-order propagation from the correlations of each block of time.
///
/// ```text
/// dU = P dH V S⁻¹                                       the part inside span(U) turns U and A alike: no pole moves
/// dA φ = O↑⁺ (dU↓ φ - λ dU↑ φ) + (O↑ᵀO↑)⁻¹ dU↑ᵀ r         shape: n × 1
/// dλ = χᵀ dA φ / χᵀφ;   dφ = Σ φ_k χ_kᵀ dA φ / (λ - λ_k) χ_kᵀφ_k
/// var(f) = b/(b-1) Σ df²                                 over the b blocks of time
/// ```
/// Only matrix–vector products for each block: no Kronecker product is formed, no block's Hankel matrix kept.
///
/// # Errors
/// [`ModalError::Linalg`].
///
/// # Limits
/// First order: it holds where the standard deviation is small beside the distance to the next pole of like shape.
/// Blocks must be long beside the correlation time 1/(2πζf).
///
/// # Source
/// Reynders, Pintelon & De Roeck (2008) Mech. Syst. Signal Process. 22:948-969; Döhler & Mevel (2013) Mech. Syst.
/// Signal Process. 38:346-366. Differs from the sources: products for the poles asked, not a covariance of A.
pub fn deviation(subspace: &Subspace, pole: &Pole) -> Result<PoleDeviation, ModalError> {
    let local = Local::new(subspace, pole)?;
    let blocks = &subspace.correlations.deviations;
    let correction = blocks.len() as f64 / (blocks.len() as f64 - 1.0);
    let (mut f2, mut z2, mut s2) = (0.0, 0.0, vec![0.0; pole.shape.len()]);
    let mu = pole.eigenvalue.ln() * subspace.sampling_rate_hz;
    let omega = mu.norm();
    for block in blocks {
        let (d_lambda, d_shape) = local.change(block);
        let d_mu = d_lambda / pole.eigenvalue * subspace.sampling_rate_hz;
        let d_omega = (mu.conj() * d_mu).re / omega;
        let d_zeta = -d_mu.re / omega + mu.re * d_omega / (omega * omega);
        f2 += (d_omega / (2.0 * PI)).powi(2);
        z2 += d_zeta.powi(2);
        for ((s2, phi), d) in s2.iter_mut().zip(&pole.shape).zip(d_shape) {
            let along = if phi.norm() > 0.0 {
                (phi.conj() * d).re / phi.norm()
            } else {
                d.norm()
            };
            *s2 += along * along;
        }
    }
    Ok(PoleDeviation {
        frequency_sd_hz: (correction * f2).sqrt(),
        damping_ratio_sd: (correction * z2).sqrt(),
        shape_sd: s2.into_iter().map(|s| (correction * s).sqrt()).collect(),
    })
}

/// What the propagation needs of one pole, the same for all blocks.
struct Local<'a> {
    subspace: &'a Subspace,
    n: usize,
    index: usize,
    values: Vec<Complex64>,
    right: ComplexMatrix,
    /// Left eigenvector k in column k, scaled so that χ_kᵀ φ_k = 1.
    left: ComplexMatrix,
    w: Split,
    /// P [r; 0].
    residual: Split,
    /// First block row of U φ.
    shape: Vec<Complex64>,
}

/// A complex vector as real and imaginary parts: products with real matrices stay real.
#[derive(Clone)]
struct Split {
    re: Vec<f64>,
    im: Vec<f64>,
}

impl Split {
    fn zeros(n: usize) -> Self {
        Split {
            re: vec![0.0; n],
            im: vec![0.0; n],
        }
    }

    fn of(z: &[Complex64]) -> Self {
        Split {
            re: z.iter().map(|z| z.re).collect(),
            im: z.iter().map(|z| z.im).collect(),
        }
    }

    fn at(&self, i: usize) -> Complex64 {
        Complex64::new(self.re[i], self.im[i])
    }

    fn mapped(&self, f: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        Split {
            re: f(&self.re),
            im: f(&self.im),
        }
    }
}

impl<'a> Local<'a> {
    fn new(subspace: &'a Subspace, pole: &Pole) -> Result<Self, ModalError> {
        let (n, l) = (pole.order, subspace.correlations.channels);
        let a = state(&subspace.upper.r, &subspace.shifted, n);
        let (e, mut mirrored) = (eigen(&a)?, eigen(&a.transpose())?);
        let nearest = |values: &[Complex64], to: Complex64| {
            (0..n).reduce(|best, k| {
                if (values[k] - to).norm_sqr() < (values[best] - to).norm_sqr() {
                    k
                } else {
                    best
                }
            })
        };
        let mut left = ComplexMatrix::zeros(n, n);
        for k in 0..n {
            let from = nearest(&mirrored.values, e.values[k]).unwrap_or(k);
            mirrored.values[from] = Complex64::new(f64::INFINITY, 0.0); // taken
            let (chi, phi) = (mirrored.vectors.column(from), e.vectors.column(k));
            let scale: Complex64 = chi.iter().zip(phi).map(|(x, y)| x * y).sum();
            for i in 0..n {
                left[(i, k)] = chi[i] / scale;
            }
        }
        let index = nearest(&e.values, pole.eigenvalue).unwrap_or(0);
        let (lambda, phi) = (e.values[index], Split::of(e.vectors.column(index)));
        let times = |m: &Matrix, x: &Split| x.mapped(|x| leading_times(m, x));
        let modal = times(&subspace.u, &phi); // U φ
        let mut residual = Split::zeros(modal.re.len());
        for i in 0..modal.re.len() - l {
            let r = modal.at(i + l) - lambda * modal.at(i);
            (residual.re[i], residual.im[i]) = (r.re, r.im);
        }
        Ok(Local {
            subspace,
            n,
            index,
            w: times(&subspace.v_over_s, &phi),
            residual: residual.mapped(|x| off_subspace(&subspace.u, n, x)),
            shape: (0..l).map(|c| modal.at(c)).collect(),
            values: e.values,
            right: e.vectors,
            left,
        })
    }

    /// Change of the eigenvalue and of the normalised shape for one block's deviation of the correlations.
    fn change(&self, block: &[f64]) -> (Complex64, Vec<Complex64>) {
        let (s, n, l) = (self.subspace, self.n, self.shape.len());
        let lambda = self.values[self.index];
        // dU φ = P dH w
        let d_modal = self
            .w
            .mapped(|w| off_subspace(&s.u, n, &hankel_times(block, l, w)));
        let mut fit = Split::zeros(d_modal.re.len() - l);
        for i in 0..fit.re.len() {
            let z = d_modal.at(i + l) - lambda * d_modal.at(i);
            (fit.re[i], fit.im[i]) = (z.re, z.im);
        }
        // O↑⁺ (dU↓ φ - λ dU↑ φ) = R⁻¹ Qᵀ (…)
        let first = fit.mapped(|z| {
            let mut x = leading_transposed_times(&s.upper.q, n, z);
            back_substitute(&s.upper.r, &mut x);
            x
        });
        // (RᵀR)⁻¹ S⁻¹ Vᵀ dHᵀ P [r; 0]
        let second = self.residual.mapped(|p| {
            let mut x = leading_transposed_times(&s.v_over_s, n, &hankel_transposed_times(block, l, p));
            forward_substitute(&s.upper.r, &mut x);
            back_substitute(&s.upper.r, &mut x);
            x
        });
        let d_a_phi: Vec<Complex64> = (0..n).map(|i| first.at(i) + second.at(i)).collect();
        let along = |k: usize| -> Complex64 {
            let chi = self.left.column(k);
            chi.iter().zip(&d_a_phi).map(|(x, y)| x * y).sum()
        };
        let mut d_phi = vec![Complex64::ZERO; n];
        for k in (0..n).filter(|&k| k != self.index) {
            let weight = along(k) / (lambda - self.values[k]);
            for (d, phi) in d_phi.iter_mut().zip(self.right.column(k)) {
                *d += weight * phi;
            }
        }
        let d_shape: Vec<Complex64> = (0..l)
            .map(|c| d_modal.at(c) + (0..n).map(|k| d_phi[k] * s.u[(c, k)]).sum::<Complex64>())
            .collect();
        let m = largest(&self.shape).unwrap_or(0);
        let (top, d_top) = (self.shape[m], d_shape[m]);
        let unit = self.shape.iter().zip(&d_shape);
        let normalized = unit.map(|(x, d)| d / top - x * d_top / (top * top)).collect();
        (along(self.index), normalized)
    }
}

/// First n columns of `m` times `x` of length n.
fn leading_times(m: &Matrix, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; m.rows()];
    for (j, xj) in x.iter().enumerate() {
        for (y, m) in y.iter_mut().zip(m.column(j)) {
            *y += m * xj;
        }
    }
    y
}

/// First n columns of `m`, transposed, times `x`.
fn leading_transposed_times(m: &Matrix, n: usize, x: &[f64]) -> Vec<f64> {
    (0..n)
        .map(|j| m.column(j).iter().zip(x).map(|(m, x)| m * x).sum())
        .collect()
}

fn off_subspace(u: &Matrix, n: usize, x: &[f64]) -> Vec<f64> {
    let inside = leading_times(u, &leading_transposed_times(u, n, x));
    x.iter().zip(inside).map(|(x, y)| x - y).collect()
}

/// x ← R_n⁻ᵀ x.
fn forward_substitute(r: &Matrix, x: &mut [f64]) {
    for i in 0..x.len() {
        let sum: f64 = r.column(i)[..i].iter().zip(&x[..i]).map(|(r, x)| r * x).sum();
        x[i] = (x[i] - sum) / r[(i, i)];
    }
}

/// [R_(i+j+1)] x, from the lags alone.
fn hankel_times(lags: &[f64], l: usize, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; x.len()];
    for (i, y) in y.chunks_exact_mut(l).enumerate() {
        for (j, x) in x.chunks_exact(l).enumerate() {
            let r = &lags[(i + j + 1) * l * l..(i + j + 2) * l * l];
            for (y, row) in y.iter_mut().zip(r.chunks_exact(l)) {
                *y += row.iter().zip(x).map(|(r, x)| r * x).sum::<f64>();
            }
        }
    }
    y
}

/// [R_(i+j+1)]ᵀ x, from the lags alone.
fn hankel_transposed_times(lags: &[f64], l: usize, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; x.len()];
    for (j, y) in y.chunks_exact_mut(l).enumerate() {
        for (i, x) in x.chunks_exact(l).enumerate() {
            let r = &lags[(i + j + 1) * l * l..(i + j + 2) * l * l];
            for (row, x) in r.chunks_exact(l).zip(x) {
                for (y, r) in y.iter_mut().zip(row) {
                    *y += r * x;
                }
            }
        }
    }
    y
}
