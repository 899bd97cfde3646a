//! Stones of several pieces: steps carved below a roof stone, and a mast on a finial. The pieces move as one.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | V, c, S | | volume, centroid and ∫ (x − c)(x − c)ᵀ dV of a piece | m³, m, m⁵ |
//! | r | `density_ratio` | density of the mast over that of the stone | – |

use super::solid::positive;
use super::{Solid, StackError};
use glam::{DMat3, DVec3};

/// A stone with a mast: the mean density of both over that of the stone alone.
#[derive(Clone, Debug, PartialEq)]
pub struct WithMast {
    /// Both: the true volume; centroid and inertia are those of the masses.
    pub solid: Solid,
    /// Mass of both over their volume and the density of the stone.
    pub mean_density_ratio: f64,
}

impl Solid {
    /// One stone of pieces that stand on one another, lowest first, such as a roof stone on its steps (옥개받침).
    ///
    /// ```text
    /// V = Σ V_i,   V c = Σ V_i c_i,   S = Σ (S_i + V_i d_i d_iᵀ),   d_i = c_i − c
    /// ```
    /// Contact is that of the convex hull of all corners: its bed is the lowest face. The test `project_cornices` of dolmen-project compares
    /// mass, centroid and inertia with slices integrated numerically.
    ///
    /// # Errors
    /// [`StackError`] for no pieces, or pieces whose hull is flat.
    ///
    /// # Limits
    /// Pieces must not share volume; this is not checked.
    pub fn joined(pieces: &[Solid]) -> Result<Self, StackError> {
        let corners: Vec<[f64; 3]> = pieces.iter().flat_map(|of| of.vertices_m().to_vec()).collect();
        let hull = Solid::convex(&corners)?;
        let (volume, centroid, second) = summed(pieces.iter().map(|piece| (piece, 1.0)));
        let mut joined = hull.with_moments(volume, centroid, second);
        joined.pieces = pieces.to_vec();
        Ok(joined)
    }

    /// The stone with a mast (찰주) that stands on it and moves with it: mass, centroid, inertia and drawings have it, contact does not.
    ///
    /// # Errors
    /// [`StackError::Dimension`] unless the ratio of densities is positive.
    pub fn with_mast(&self, mast: &Solid, density_ratio: f64) -> Result<WithMast, StackError> {
        let ratio = positive("density_ratio", density_ratio)?;
        let (weighted, centroid, second) = summed([(self, 1.0), (mast, ratio)].into_iter());
        let volume = self.volume_m3() + mast.volume_m3();
        let mean = weighted / volume;
        let mut solid = self.clone().with_moments(volume, centroid, second * (1.0 / mean));
        solid.pieces = self.drawn().into_iter().chain([mast]).cloned().collect();
        Ok(WithMast {
            solid,
            mean_density_ratio: mean,
        })
    }

    /// The convex pieces to draw, lowest first: the stone itself where it has only one.
    pub fn drawn(&self) -> Vec<&Solid> {
        match self.pieces.is_empty() {
            true => vec![self],
            false => self.pieces.iter().collect(),
        }
    }
}

/// Volume, centroid and second moments of solids, each with a weight.
fn summed<'a>(all: impl Iterator<Item = (&'a Solid, f64)> + Clone) -> (f64, DVec3, DMat3) {
    let centre = |solid: &Solid| DVec3::from(solid.centroid_m());
    let bulk: f64 = all
        .clone()
        .map(|(solid, weight)| weight * solid.volume_m3())
        .sum();
    let first: DVec3 = all
        .clone()
        .map(|(solid, weight)| centre(solid) * (weight * solid.volume_m3()))
        .sum();
    let centroid = first / bulk;
    let second = all
        .map(|(solid, weight)| {
            let d = centre(solid) - centroid;
            (solid.second_m5() + DMat3::from_cols(d * d.x, d * d.y, d * d.z) * solid.volume_m3()) * weight
        })
        .fold(DMat3::ZERO, |sum, own| sum + own);
    (bulk, centroid, second)
}
