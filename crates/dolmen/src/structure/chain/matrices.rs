//! Mass, damping and stiffness matrices of a chain in its link rotations.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | θ_i | | rotation of link i from the vertical | rad |
//! | S_i | `above_kg` | mass above link i | kg |
//! | k_i | `stiffness` | rotational spring of the joint below link i | N m/rad |
//! | d_i | `damping` | rotational dashpot of the joint below link i | N m s/rad |
//! | G_i | `gravity_moments` | gravity moment per rotation of link i, with all links above it | N m/rad |
//! | Γ_i | `base_influence` | G_i / g | kg m |
//! | c_j(z) | `lever` | displacement at height z per rotation of link j | m/rad |

use super::Chain;
use crate::structure::StructureError;
use dolmen_linalg::Matrix;

impl Chain {
    /// Mass above each link, S_i = Σ_{j>i} m_j, kg, lowest first.
    fn mass_above_kg(&self) -> Vec<f64> {
        let mut above = vec![0.0; self.links().len()];
        for i in (1..above.len()).rev() {
            above[i - 1] = above[i] + self.links()[i].mass_kg;
        }
        above
    }

    /// Γ_i, first moment of the mass that moves with link i about its lower joint, kg m, lowest first. A base
    /// acceleration a_g loads the chain with −Γ a_g.
    ///
    /// ```text
    /// Γ_i = m_i l_i + L_i Σ_{j>i} m_j        n values
    /// ```
    pub fn base_influence_kg_m(&self) -> Vec<f64> {
        let each = self.links().iter().zip(self.mass_above_kg());
        each.map(|(link, above_kg)| link.mass_kg * link.centroid_m + link.length_m * above_kg)
            .collect()
    }

    /// Gravity moment G_i = g Γ_i per rotation of link i, with all links above it, N m/rad, lowest first.
    ///
    /// # Source
    /// C_mg of Choi (2021), eq. 20.
    pub fn gravity_moments_n_m_rad(&self) -> Vec<f64> {
        let g = self.gravity_m_s2();
        self.base_influence_kg_m().iter().map(|gamma| g * gamma).collect()
    }

    /// M_i = Σ_{j≥i} G_j, moment of the weight above joint i if all links above it lean by 1 rad, N m/rad, lowest
    /// first. It is the least stiffness of joint i if all other joints are rigid.
    pub fn necessary_n_m_rad(&self) -> Vec<f64> {
        let mut sums = self.gravity_moments_n_m_rad();
        for i in (1..sums.len()).rev() {
            sums[i - 1] += sums[i];
        }
        sums
    }

    /// Mass matrix M, kg m²/rad.
    ///
    /// ```text
    /// M_ii = m_i l_i² + L_i² S_i + J_i
    /// M_ij = L_i (m_j l_j + L_j S_j)        i < j
    /// n × n, S_i = Σ_{j>i} m_j
    /// ```
    ///
    /// # Source
    /// Choi (2021) eqs 19, 30, with J about the centre of mass (eqs 15, 16). Tested by `choi_2021`.
    pub fn mass_matrix(&self) -> Matrix {
        let (links, above) = (self.links(), self.mass_above_kg());
        let gamma = self.base_influence_kg_m();
        Matrix::from_fn(links.len(), links.len(), |i, j| {
            if i == j {
                let link = &links[i];
                link.mass_kg * link.centroid_m.powi(2)
                    + link.length_m.powi(2) * above[i]
                    + link.inertia_kg_m2()
            } else {
                links[i.min(j)].length_m * gamma[i.max(j)]
            }
        })
    }

    /// Stiffness matrix of the springs alone, without gravity, N m/rad; positive definite. It includes side supports
    /// without a gap.
    ///
    /// ```text
    /// K_ii = k_i + k_{i+1},  K_{i,i+1} = −k_{i+1},  k_{n+1} = 0;  + s c cᵀ of each side support
    /// n × n
    /// ```
    ///
    /// # Errors
    /// [`StructureError::Count`] for a wrong number of joints, [`StructureError::NotPositive`] for the stiffness of a
    /// joint.
    pub fn elastic_stiffness_matrix(&self, stiffness_n_m_rad: &[f64]) -> Result<Matrix, StructureError> {
        self.check_stiffness(stiffness_n_m_rad)?;
        let mut k = joint_matrix(stiffness_n_m_rad);
        for support in self
            .side_supports()
            .iter()
            .filter(|support| support.acts_linearly())
        {
            let c = self.lever_m_rad(support.height_m)?;
            let s = support.stiffness_n_m;
            k = &k + &Matrix::from_fn(c.len(), c.len(), |i, j| s * c[i] * c[j]);
        }
        Ok(k)
    }

    /// Stiffness matrix K of springs and gravity, N m/rad. The chain stands if and only if K is positive definite.
    ///
    /// ```text
    /// K = K_springs − diag(G)        n × n
    /// ```
    ///
    /// # Errors
    /// As [`Chain::elastic_stiffness_matrix`].
    ///
    /// # Source
    /// Choi (2021) eqs 32–37.
    pub fn stiffness_matrix(&self, stiffness_n_m_rad: &[f64]) -> Result<Matrix, StructureError> {
        let mut k = self.elastic_stiffness_matrix(stiffness_n_m_rad)?;
        for (i, g) in self.gravity_moments_n_m_rad().iter().enumerate() {
            k[(i, i)] -= g;
        }
        Ok(k)
    }

    /// Damping matrix D of the dashpots in the joints, N m s/rad.
    ///
    /// ```text
    /// D_ii = d_i + d_{i+1},  D_{i,i+1} = −d_{i+1},  d_{n+1} = 0        n × n
    /// ```
    ///
    /// # Errors
    /// [`StructureError::Count`] for a wrong number of joints, [`StructureError::Negative`] for a negative dashpot.
    ///
    /// # Source
    /// Choi (2021) eq. 31.
    pub fn damping_matrix(&self, damping_n_m_s_rad: &[f64]) -> Result<Matrix, StructureError> {
        self.check_count("damping_n_m_s_rad", damping_n_m_s_rad.len())?;
        for (i, &given) in damping_n_m_s_rad.iter().enumerate() {
            if !(given >= 0.0 && given.is_finite()) {
                return Err(StructureError::Negative {
                    part: "joint",
                    number: i + 1,
                    quantity: "damping_n_m_s_rad",
                    given,
                });
            }
        }
        Ok(joint_matrix(damping_n_m_s_rad))
    }

    /// Lateral displacement c(z) at height z per rotation of each link, m/rad, lowest first.
    ///
    /// ```text
    /// u(z in link i) = Σ_{j<i} L_j θ_j + (z − z_i) θ_i = cᵀ θ        n values
    /// ```
    ///
    /// # Errors
    /// [`StructureError::Height`] if z is below the lowest joint or above the top.
    pub fn lever_m_rad(&self, height_m: f64) -> Result<Vec<f64>, StructureError> {
        // Heights in a file are sums of rounded lengths: a micrometre above the top counts as the top.
        const ROUNDING_M: f64 = 1e-6;
        let top_m = self.height_m();
        if !(height_m >= 0.0 && height_m <= top_m + ROUNDING_M) {
            return Err(StructureError::Height {
                quantity: "height_m",
                given: height_m,
                top_m,
            });
        }
        let each = self.links().iter().zip(self.joint_heights_m());
        Ok(each
            .map(|(link, joint_m)| (height_m - joint_m).clamp(0.0, link.length_m))
            .collect())
    }

    /// Refuses a wrong number of joint stiffnesses, and a stiffness that is not positive.
    ///
    /// # Errors
    /// [`StructureError::Count`] and [`StructureError::NotPositive`] in these cases.
    pub fn check_stiffness(&self, stiffness_n_m_rad: &[f64]) -> Result<(), StructureError> {
        self.check_count("stiffness_n_m_rad", stiffness_n_m_rad.len())?;
        match stiffness_n_m_rad
            .iter()
            .position(|&k| !(k > 0.0 && k.is_finite()))
        {
            None => Ok(()),
            Some(i) => Err(StructureError::NotPositive {
                part: "joint",
                number: i + 1,
                quantity: "stiffness_n_m_rad",
                given: stiffness_n_m_rad[i],
            }),
        }
    }

    pub(crate) fn check_count(&self, quantity: &'static str, given: usize) -> Result<(), StructureError> {
        let needed = self.links().len();
        if given == needed {
            return Ok(());
        }
        Err(StructureError::Count {
            quantity,
            given,
            kind: "chain",
            needed,
            parts: "joints",
        })
    }
}

/// Tridiagonal matrix Σ k_i b_i b_iᵀ with b_i = e_i − e_{i−1}.
fn joint_matrix(joints: &[f64]) -> Matrix {
    let n = joints.len();
    let next = |i: usize| joints.get(i + 1).copied().unwrap_or(0.0);
    Matrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => joints[i] + next(i),
        1 => -joints[i.max(j)],
        _ => 0.0,
    })
}
