//! Matrices of a structure with unknown springs.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | K_0 | `rest` | stiffness without the unknown springs: known stiffness minus the reduction by gravity |
//! | b_i | `springs` | b_iᵀ φ is the deformation of spring i in a shape φ |

use dolmen_linalg::{Matrix, SymmetricEigen, generalized_symmetric_eigen};

/// Matrices of a structure with a known stiffness and one unknown spring for each part.
///
/// ```text
/// K(k) = K_0 + Σ k_i b_i b_iᵀ,   K φ = ω² M φ                                          n × n
/// ```
pub(crate) struct SpringModel {
    pub(crate) mass: Matrix,
    pub(crate) rest: Matrix,
    /// b_i in column i.
    pub(crate) springs: Matrix,
}

impl SpringModel {
    pub(crate) fn parts(&self) -> usize {
        self.springs.columns()
    }

    /// ω² ascending and shapes with φᵀ M φ = 1; `None` if they cannot be computed.
    pub(crate) fn modes(&self, stiffness: &[f64]) -> Option<SymmetricEigen> {
        let mut k = self.rest.clone();
        for (i, stiffness) in stiffness.iter().enumerate() {
            let b = self.springs.column(i);
            for (column, b_column) in b.iter().enumerate().filter(|(_, b)| **b != 0.0) {
                for (row, b_row) in b.iter().enumerate() {
                    k[(row, column)] += stiffness * b_row * b_column;
                }
            }
        }
        generalized_symmetric_eigen(&k, &self.mass).ok()
    }

    /// b_iᵀ φ.
    pub(crate) fn extension(&self, i: usize, shape: &[f64]) -> f64 {
        self.springs.column(i).iter().zip(shape).map(|(b, y)| b * y).sum()
    }
}
