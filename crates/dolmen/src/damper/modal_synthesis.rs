//! Response of a structure with dampers in modal coordinates at each frequency: eqs 4 to 9 of Hwang, Min & Hong, with damping.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | η | result of eq. 8 | modal coordinates | k |
//! | Φ | `shapes` | modes with unit modal mass | n × k |
//! | D | rows of the dampers | z₀ = Dᵀ x, displacements of the places of the dampers | n × q |
//! | K(ω) | `stiffness` | dynamic stiffness of the dampers, diagonal: λ = K z₀ | q |
//! | G(ω) | `receptance` | (K̄ + iωC̄ − ω²M̄)⁻¹ | k × k |
//! | Q | `modal_load` | load on the modes | k |

use super::assembled::check_row;
use super::{AttachedDamper, DamperError, DamperKind};
use crate::dynamics::{DynamicsError, LinearSystem, RandomInput};
use crate::numeric::complex_solve;
use dolmen_linalg::{Complex64, Matrix};

/// A structure in modal coordinates, to which dampers can be attached.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalSynthesis {
    omega_rad_s: Vec<f64>,
    shapes: Matrix,
    damping: Matrix,
    classical: bool,
    modal_mass: Matrix, // ΦᵀM, k × n
    fixed: Vec<Tied>,
}

/// A fixed damper, in modal coordinates.
#[derive(Clone, Debug, PartialEq)]
struct Tied {
    kind: DamperKind,
    row: Vec<f64>,
    modal: Vec<f64>,
}

/// Off-diagonal modal damping below this fraction of the largest value is rounding.
const CLASSICAL: f64 = 1e-12;

impl ModalSynthesis {
    /// The first `modes` modes of a structure; the result is exact with all modes.
    ///
    /// # Errors
    /// [`DamperError::Dynamics`] if the modes cannot be computed; [`DamperError::Argument`] if the structure has fewer modes.
    pub fn new(structure: &LinearSystem, modes: usize) -> Result<Self, DamperError> {
        let n = structure.degrees_of_freedom();
        if modes == 0 || modes > n {
            return Err(DamperError::Argument {
                argument: "modes",
                given: modes as f64,
                allowed: "between 1 and the degrees of freedom of the structure",
            });
        }
        let all = structure.modes()?;
        let shapes = all.shapes.block(0, 0, n, modes);
        let damping = all.damping.block(0, 0, modes, modes);
        let most = (0..modes).map(|i| damping[(i, i)].abs()).fold(0.0, f64::max);
        let classical =
            (0..modes).all(|i| (0..modes).all(|j| i == j || damping[(i, j)].abs() <= CLASSICAL * most));
        Ok(ModalSynthesis {
            omega_rad_s: all.angular_frequency_rad_s[..modes].to_vec(),
            modal_mass: shapes.transpose_times(structure.mass()),
            shapes,
            damping,
            classical,
            fixed: Vec::new(),
        })
    }

    /// The synthesis with fixed dampers, which become part of the structure.
    ///
    /// # Errors
    /// [`DamperError::Row`] for a row of the wrong length, [`DamperError::Argument`] for a damper out of its range.
    pub fn with_fixed(mut self, dampers: &[AttachedDamper]) -> Result<Self, DamperError> {
        for (i, damper) in dampers.iter().enumerate() {
            check_row(i + 1, &damper.row, self.degrees_of_freedom())?;
            damper.kind.check()?;
            self.fixed.push(Tied {
                kind: damper.kind,
                row: damper.row.clone(),
                modal: self.in_modes(&damper.row),
            });
        }
        Ok(self)
    }

    /// Degrees of freedom of the structure, n.
    pub fn degrees_of_freedom(&self) -> usize {
        self.shapes.rows()
    }

    /// Angular frequencies of the modes, rad/s.
    pub(super) fn omega_rad_s(&self) -> &[f64] {
        &self.omega_rad_s
    }

    /// Mode shapes with unit modal mass, n × k.
    pub(super) fn shapes(&self) -> &Matrix {
        &self.shapes
    }

    /// ΦᵀCΦ of the structure without dampers, 1/s.
    pub(super) fn damping(&self) -> &Matrix {
        &self.damping
    }

    /// Whether damping does not couple the modes.
    pub(super) fn is_classical(&self) -> bool {
        self.classical
    }

    /// Φᵀ a: a row over the structure, in modal coordinates.
    pub(super) fn in_modes(&self, row: &[f64]) -> Vec<f64> {
        (0..self.shapes.columns())
            .map(|k| self.shapes.column(k).iter().zip(row).map(|(p, a)| p * a).sum())
            .collect()
    }

    /// Q of a unit load: Φᵀ f, or −Φᵀ M e.
    pub(super) fn modal_load(&self, input: &RandomInput) -> Vec<f64> {
        match input {
            RandomInput::Force(force) => self.in_modes(force),
            RandomInput::Base(influence) => self.modal_mass.times(influence).iter().map(|q| -q).collect(),
        }
    }

    /// G(ω) times a real modal load, with the fixed dampers.
    pub(super) fn receptance(&self, w: f64, load: &[f64]) -> Result<Vec<Complex64>, DamperError> {
        let free = self.bare_receptance(w, load)?;
        self.with_forces(w, free, |_| 0.0)
    }

    /// Modal motion under a unit load, with the fixed dampers.
    pub(super) fn loaded(&self, w: f64, input: &RandomInput) -> Result<Vec<Complex64>, DamperError> {
        self.loaded_by(w, input, &self.modal_load(input))
    }

    /// The same for a load whose [`modal_load`](Self::modal_load) is known.
    pub(super) fn loaded_by(
        &self,
        w: f64,
        input: &RandomInput,
        modal_load: &[f64],
    ) -> Result<Vec<Complex64>, DamperError> {
        let free = self.bare_receptance(w, modal_load)?;
        self.with_forces(w, free, |tied| match input {
            RandomInput::Force(_) => 0.0,
            RandomInput::Base(e) => tied.row.iter().zip(e).map(|(a, e)| a * e).sum(),
        })
    }

    /// Adds the forces of the fixed dampers: λ_i − K_i Σ_j g_ij λ_j = K_i z_i − m_a,i e_i.
    fn with_forces(
        &self,
        w: f64,
        mut eta: Vec<Complex64>,
        base: impl Fn(&Tied) -> f64,
    ) -> Result<Vec<Complex64>, DamperError> {
        if self.fixed.is_empty() {
            return Ok(eta);
        }
        let along =
            |row: &[f64], eta: &[Complex64]| -> Complex64 { row.iter().zip(eta).map(|(a, x)| x * *a).sum() };
        let each: Vec<Vec<Complex64>> = self
            .fixed
            .iter()
            .map(|tied| self.bare_receptance(w, &tied.modal))
            .collect::<Result<_, _>>()?;
        let mut a = Vec::with_capacity(self.fixed.len());
        let mut lambda = Vec::with_capacity(self.fixed.len());
        for (i, tied) in self.fixed.iter().enumerate() {
            let stiffness = tied.kind.stiffness(w);
            let mut row: Vec<Complex64> = each
                .iter()
                .map(|eta| -stiffness * along(&tied.modal, eta))
                .collect();
            row[i] += 1.0;
            a.push(row);
            lambda.push(stiffness * along(&tied.modal, &eta) - tied.kind.apparent_mass(w) * base(tied));
        }
        if !complex_solve(&mut a, &mut lambda) {
            return Err(DamperError::Dynamics(DynamicsError::Unstable));
        }
        for (force, column) in lambda.iter().zip(&each) {
            for (x, g) in eta.iter_mut().zip(column) {
                *x += force * g;
            }
        }
        Ok(eta)
    }

    /// G(ω) times a real modal load, for the structure alone.
    fn bare_receptance(&self, w: f64, load: &[f64]) -> Result<Vec<Complex64>, DamperError> {
        let k = load.len();
        if self.classical {
            return Ok((0..k)
                .map(|j| {
                    let omega = self.omega_rad_s[j];
                    load[j] / Complex64::new(omega * omega - w * w, w * self.damping[(j, j)])
                })
                .collect());
        }
        let mut a: Vec<Vec<Complex64>> = (0..k)
            .map(|i| {
                (0..k)
                    .map(|j| {
                        let omega = self.omega_rad_s[j];
                        let real = if i == j { omega * omega - w * w } else { 0.0 };
                        Complex64::new(real, w * self.damping[(i, j)])
                    })
                    .collect()
            })
            .collect();
        let mut x: Vec<Complex64> = load.iter().map(|q| Complex64::new(*q, 0.0)).collect();
        match complex_solve(&mut a, &mut x) {
            true => Ok(x),
            false => Err(DamperError::Dynamics(DynamicsError::Unstable)),
        }
    }

    /// z_g of eq. 9: motion of each of `rows` per unit load at one frequency, with the dampers.
    ///
    /// ```text
    /// z₀ = [I − DᵀΦGΦᵀD K]⁻¹ (DᵀΦG Q − …)      eq. 7
    /// η  = G ΦᵀD λ + G Q,  λ = K z₀ − m_a e      eq. 8
    /// z_g = D_gᵀΦ η                              eq. 9
    /// ```
    /// Under a base acceleration, the acceleration at a damper is that of its place plus that of the base, which is e for its row: −m_a
    /// e with the apparent mass m_a = K/ω².
    ///
    /// # Errors
    /// [`DamperError::Row`] for a row of the wrong length; [`DamperError::Dynamics`] at an undamped resonance.
    pub fn response(
        &self,
        angular_frequency_rad_s: f64,
        input: &RandomInput,
        dampers: &[AttachedDamper],
        rows: &[Vec<f64>],
    ) -> Result<Vec<Complex64>, DamperError> {
        let (w, q) = (angular_frequency_rad_s, dampers.len());
        let n = self.degrees_of_freedom();
        for (i, damper) in dampers.iter().enumerate() {
            check_row(i + 1, &damper.row, n)?;
        }
        let tied: Vec<Vec<f64>> = dampers.iter().map(|damper| self.in_modes(&damper.row)).collect();
        let free = self.loaded(w, input)?; // G Q
        let each: Vec<Vec<Complex64>> = tied
            .iter()
            .map(|row| self.receptance(w, row))
            .collect::<Result<_, _>>()?; // G ΦᵀD
        let along =
            |row: &[f64], eta: &[Complex64]| -> Complex64 { row.iter().zip(eta).map(|(a, x)| x * *a).sum() };
        let base: Vec<f64> = dampers
            .iter()
            .map(|damper| match input {
                RandomInput::Force(_) => 0.0,
                RandomInput::Base(e) => damper.row.iter().zip(e).map(|(a, e)| a * e).sum(),
            })
            .collect();
        // λ_i − K_i Σ_j g_ij λ_j = K_i z₀_i(free) − m_a,i e_i
        let mut a = vec![vec![Complex64::ZERO; q]; q];
        let mut lambda = vec![Complex64::ZERO; q];
        for (i, damper) in dampers.iter().enumerate() {
            let stiffness = damper.kind.stiffness(w);
            for j in 0..q {
                a[i][j] = -stiffness * along(&tied[i], &each[j]);
            }
            a[i][i] += 1.0;
            lambda[i] = stiffness * along(&tied[i], &free) - damper.kind.apparent_mass(w) * base[i];
        }
        if !complex_solve(&mut a, &mut lambda) {
            return Err(DamperError::Dynamics(DynamicsError::Unstable));
        }
        let mut eta = free;
        for (force, column) in lambda.iter().zip(&each) {
            for (x, g) in eta.iter_mut().zip(column) {
                *x += force * g;
            }
        }
        Ok(rows.iter().map(|row| along(&self.in_modes(row), &eta)).collect())
    }
}
