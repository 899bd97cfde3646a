//! A linear structure as its three matrices: M ẍ + C ẋ + K x = f.

use super::DynamicsError;
use dolmen_linalg::{Complex64, Matrix, eigen, generalized_symmetric_eigen, solve};

/// Mass, damping and stiffness of a stable linear structure. The constructor checks that they are symmetric, with positive definite
/// mass and stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearSystem {
    mass: Matrix,
    damping: Matrix,
    stiffness: Matrix,
}

/// Natural modes of a linear system.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemModes {
    /// Natural frequencies without damping, ascending, rad/s.
    pub angular_frequency_rad_s: Vec<f64>,
    /// Mode shapes in columns, each with modal mass 1: ΦᵀMΦ = I.
    pub shapes: Matrix,
    /// ΦᵀCΦ; diagonal for classical damping.
    pub damping: Matrix,
}

/// A damped natural frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pole {
    /// |λ|, rad/s.
    pub angular_frequency_rad_s: f64,
    /// −Re λ / |λ|; 1 for a mode that does not oscillate.
    pub damping_ratio: f64,
}

/// Largest asymmetry of an assembled matrix due to rounding, relative to its largest entry.
const SYMMETRY: f64 = 1e-9;

impl LinearSystem {
    /// Builds the system from M, C and K, all n × n.
    ///
    /// # Errors
    /// [`DynamicsError::Matrix`] if a matrix has a wrong size or is not symmetric, or if M or K is not positive definite.
    pub fn new(mass: Matrix, damping: Matrix, stiffness: Matrix) -> Result<Self, DynamicsError> {
        let n = mass.rows();
        for (matrix, name) in [(&mass, "mass"), (&damping, "damping"), (&stiffness, "stiffness")] {
            let refused = |needed| DynamicsError::Matrix { matrix: name, needed };
            if matrix.rows() != n || matrix.columns() != n || n == 0 {
                return Err(refused("square and of the size of the mass matrix"));
            }
            let largest = matrix
                .as_slice()
                .iter()
                .fold(0.0_f64, |most, x| most.max(x.abs()));
            for i in 0..n {
                for j in 0..n {
                    let (a, b) = (matrix[(i, j)], matrix[(j, i)]);
                    if !a.is_finite() {
                        return Err(refused("of finite numbers"));
                    }
                    if (a - b).abs() > SYMMETRY * largest {
                        return Err(refused("symmetric"));
                    }
                }
            }
        }
        for (matrix, name) in [(&mass, "mass"), (&stiffness, "stiffness")] {
            dolmen_linalg::cholesky(matrix).map_err(|_| DynamicsError::Matrix {
                matrix: name,
                needed: "positive definite: every motion must meet mass and stiffness",
            })?;
        }
        Ok(LinearSystem {
            mass,
            damping,
            stiffness,
        })
    }

    /// Number of degrees of freedom, n.
    pub fn degrees_of_freedom(&self) -> usize {
        self.mass.rows()
    }

    /// M, n × n.
    pub fn mass(&self) -> &Matrix {
        &self.mass
    }

    /// C, n × n.
    pub fn damping(&self) -> &Matrix {
        &self.damping
    }

    /// K, n × n.
    pub fn stiffness(&self) -> &Matrix {
        &self.stiffness
    }

    /// Solves (K + iωC − ω²M) x = load for the n values of x.
    ///
    /// # Errors
    /// [`DynamicsError::Entries`] if `load` has a wrong length; [`DynamicsError::Linalg`] at an undamped resonance.
    pub fn frequency_response(
        &self,
        angular_frequency_rad_s: f64,
        load: &[f64],
    ) -> Result<Vec<Complex64>, DynamicsError> {
        let n = self.degrees_of_freedom();
        fits("load", load, n)?;
        let w = angular_frequency_rad_s;
        // real and imaginary parts as one system of 2n
        let a = Matrix::from_fn(2 * n, 2 * n, |i, j| {
            let (row, column) = (i % n, j % n);
            match (i < n, j < n) {
                (true, true) | (false, false) => {
                    self.stiffness[(row, column)] - w * w * self.mass[(row, column)]
                }
                (true, false) => -w * self.damping[(row, column)],
                (false, true) => w * self.damping[(row, column)],
            }
        });
        let b = Matrix::from_fn(2 * n, 1, |i, _| if i < n { load[i] } else { 0.0 });
        let x = solve(&a, &b)?;
        Ok((0..n).map(|i| Complex64::new(x[(i, 0)], x[(n + i, 0)])).collect())
    }

    /// State matrix A of ẏ = A y with y = (x, ẋ), 2n × 2n.
    ///
    /// # Errors
    /// [`DynamicsError::Linalg`] if the mass matrix is singular to rounding.
    pub fn state_matrix(&self) -> Result<Matrix, DynamicsError> {
        let n = self.degrees_of_freedom();
        let (k, c) = (
            solve(&self.mass, &self.stiffness)?,
            solve(&self.mass, &self.damping)?,
        );
        Ok(Matrix::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, true) => 0.0,
            (true, false) => {
                if j - n == i {
                    1.0
                } else {
                    0.0
                }
            }
            (false, true) => -k[(i - n, j)],
            (false, false) => -c[(i - n, j - n)],
        }))
    }

    /// Natural modes without damping, and the damping in their coordinates.
    ///
    /// # Errors
    /// [`DynamicsError::Linalg`] if the decomposition fails.
    pub fn modes(&self) -> Result<SystemModes, DynamicsError> {
        let e = generalized_symmetric_eigen(&self.stiffness, &self.mass)?;
        let damping = e.vectors.transpose_times(&(&self.damping * &e.vectors));
        Ok(SystemModes {
            angular_frequency_rad_s: e.values.iter().map(|v| v.max(0.0).sqrt()).collect(),
            shapes: e.vectors,
            damping,
        })
    }

    /// Damped natural frequencies, ascending; one of each conjugate pair.
    ///
    /// # Errors
    /// [`DynamicsError::Linalg`] if the decomposition fails.
    pub fn poles(&self) -> Result<Vec<Pole>, DynamicsError> {
        let e = eigen(&self.state_matrix()?)?;
        let mut poles: Vec<Pole> = e
            .values
            .iter()
            .filter(|value| value.im >= 0.0)
            .map(|value| Pole {
                angular_frequency_rad_s: value.norm(),
                damping_ratio: -value.re / value.norm(),
            })
            .collect();
        poles.sort_by(|a, b| a.angular_frequency_rad_s.total_cmp(&b.angular_frequency_rad_s));
        Ok(poles)
    }
}

/// Checks that a list has one finite entry for each degree of freedom.
pub(crate) fn fits(argument: &'static str, list: &[f64], needed: usize) -> Result<(), DynamicsError> {
    if list.len() != needed {
        return Err(DynamicsError::Entries {
            argument,
            given: list.len(),
            needed,
        });
    }
    match list.iter().find(|x| !x.is_finite()) {
        Some(&given) => Err(DynamicsError::Argument {
            argument,
            given,
            allowed: "of finite numbers",
        }),
        None => Ok(()),
    }
}
