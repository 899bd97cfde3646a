//! P-delta of a building: reduction of the storey stiffness by the weight, and the load factor at which each storey becomes unstable.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | w_j | | weight of floor j, m_j g | N |
//! | k_s | | elastic stiffness of storey s against drift | N/m … |
//! | g_s | `geometric` | geometric stiffness: the reduction by the weight | N/m … |
//! | λ_s | `load_factor` | factor on the weight at which storey s becomes unstable | – |

use super::elements::moved;
use super::error::BuildingError;
use super::floors::{Floor, Storey};
use dolmen_linalg::{Matrix, generalized_symmetric_eigen};

/// Instability of a storey: its mode and its load factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoreyFall {
    /// The storey, from 1 at the bottom.
    pub storey: usize,
    /// Weight carried by the storey, N.
    pub weight_n: f64,
    /// Factor on the weight at which the storey becomes unstable.
    pub load_factor: f64,
    /// Drift in the mode of instability: u, v at the centre of the weight above, and ρθ, with the sum of squares 1; ρ is the radius
    /// of gyration of that weight.
    pub drift: [f64; 3],
}

impl StoreyFall {
    /// The storey with the smallest load factor.
    pub fn first(all: &[StoreyFall]) -> Option<&StoreyFall> {
        all.iter().min_by(|a, b| a.load_factor.total_cmp(&b.load_factor))
    }

    /// Kind of the mode: twist if the rotation is more than half of the squared drift.
    pub fn motion(&self) -> StoreyMotion {
        if self.drift[2] * self.drift[2] > 0.5 {
            StoreyMotion::Twists
        } else {
            StoreyMotion::Sways
        }
    }
}

/// Motion of an unstable storey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StoreyMotion {
    /// Sideways.
    Sways,
    /// About the vertical axis.
    Twists,
}

impl StoreyMotion {
    /// Name in answers: "sways" or "twists".
    pub fn name(self) -> &'static str {
        match self {
            StoreyMotion::Sways => "sways",
            StoreyMotion::Twists => "twists",
        }
    }
}

/// Geometric stiffness of each storey from the weight above, against u, v, θ at `about_m`.
///
/// ```text
/// g_s = 1/h_s Σ_(j ≥ s) w_j [1 0 −y; 0 1 x; −y x ρ² + x² + y²],   x, y of the centre of floor j from the point       3 × 3
/// ```
pub(super) fn geometric(
    floors: &[Floor],
    storeys: &[Storey],
    about_m: [f64; 2],
    gravity_m_s2: f64,
) -> Vec<[[f64; 3]; 3]> {
    let mut sums = vec![[[0.0; 3]; 3]; floors.len()];
    let mut above = [[0.0; 3]; 3];
    for (s, floor) in floors.iter().enumerate().rev() {
        let w = floor.mass_kg * gravity_m_s2;
        let own = [
            [w, 0.0, 0.0],
            [0.0, w, 0.0],
            [0.0, 0.0, w * floor.gyration_m * floor.gyration_m],
        ];
        let from = [about_m[0] - floor.centre_m[0], about_m[1] - floor.centre_m[1]];
        for (row, add) in above.iter_mut().zip(moved(&own, from)) {
            for (entry, add) in row.iter_mut().zip(add) {
                *entry += add;
            }
        }
        sums[s] = above.map(|row| row.map(|entry| entry / storeys[s].height_m));
    }
    sums
}

/// Load factor of each storey, lowest first. The storeys are independent, because the stiffness matrix is block-diagonal in storey
/// drifts.
///
/// ```text
/// det(k_s − λ_s g_s) = 0, the smallest λ_s > 0
/// ```
///
/// # Errors
/// [`BuildingError::Linalg`] for a storey that is unstable even without weight.
///
/// # Limits
/// Drifts are small and walls linear. The weight of a floor acts vertically at its centre of mass.
pub fn storey_falls(
    floors: &[Floor],
    storeys: &[Storey],
    gravity_m_s2: f64,
) -> Result<Vec<StoreyFall>, BuildingError> {
    let mut falls = Vec::with_capacity(storeys.len());
    for (s, storey) in storeys.iter().enumerate() {
        let above = &floors[s..];
        let mass: f64 = above.iter().map(|floor| floor.mass_kg).sum();
        let centre = [0, 1].map(|axis| {
            above
                .iter()
                .map(|floor| floor.mass_kg * floor.centre_m[axis])
                .sum::<f64>()
                / mass
        });
        let g = geometric(floors, storeys, centre, gravity_m_s2)[s];
        let k = storey.stiffness.matrix_about(centre);
        let rho = (g[2][2] / g[0][0]).sqrt();
        // ρθ instead of θ, so that all three are lengths
        let scale = [1.0, 1.0, 1.0 / rho];
        let of = |m: &[[f64; 3]; 3]| Matrix::from_fn(3, 3, |i, j| m[i][j] * scale[i] * scale[j]);
        let eigen = generalized_symmetric_eigen(&of(&g), &of(&k))?;
        let shape = eigen.vectors.column(2);
        let norm = shape.iter().map(|x| x * x).sum::<f64>().sqrt();
        falls.push(StoreyFall {
            storey: s + 1,
            weight_n: mass * gravity_m_s2,
            load_factor: 1.0 / eigen.values[2],
            drift: [shape[0] / norm, shape[1] / norm, shape[2] / norm],
        });
    }
    Ok(falls)
}
