//! Stiffness of a chain's joints from measured modes: all solutions found, their uncertainty, and what the sensors do not determine.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | M_i | `necessary_n_m_rad` | Σ_{j≥i} G_j, the least stiffness of joint i if the others are rigid | N m/rad |
//! | J | | d(data over sd)/d(ln k) | |

use super::Chain;
use crate::structure::inverse::{
    FrequencyRoots, SpringModel, Sprung, StiffnessSearch, roots_by_continuation, stiffness_from_modes,
};
use crate::structure::{
    MeasuredMode, NaturalMode, Proportion, Spring, StiffnessNote, StiffnessSolutions, StructureError,
};
use dolmen_linalg::Matrix;

/// Options of the search for joint stiffness.
pub type ChainStiffness = StiffnessSearch;

/// Joint stiffnesses that explain measured modes.
///
/// ```text
/// min over ln k of Σ ((ln f_j(k) − ln f_j)/sd)² + Σ ((a_j c(z_p)ᵀ φ_j(k) − u_pj)/sd)²       a_j free
/// cov(ln k) = J⁺ C J⁺ᵀ       J: data × joints over sd, exact derivatives; C: correlations of the data, (JᵀJ)⁻¹ without any
/// ```
///
/// With as many frequencies as joints, there are n polynomials of degrees 1 to n in k. They have at most n! solutions (Bézout), and every real
/// solution is stable, because K is then positive definite. Up to five joints, all complex solutions are followed, so none is missed. Otherwise
/// damped Gauss–Newton starts from many points: the solution of the linear equations K(k) φ = ω² M φ if the points of a mode determine its whole
/// shape, stiffnesses in proportion to M_i, and a low-discrepancy sequence. For the flagpole of Choi (2021) five frequencies leave 4 solutions if
/// stiffness is in proportion to M_i, 40 if the joints are equal, and up to all 5! = 120 if the upper joints are stiffer.
///
/// With fewer data than joints, the result is the solution whose stiffnesses are nearest to a common multiple of M_i (least squares of ln k).
/// `choice` is then [`Choice::Underdetermined`](crate::structure::Choice), and the notes say what is not determined.
///
/// # Input
/// * `modes` -- the **lowest** modes of one direction, ascending, without gaps. Displacements are those of points at heights above the lowest
///   joint.
///
/// # Errors
/// [`StructureError::ModesMissing`], [`StructureError::ModesMost`] for more modes than links,
/// [`StructureError::FrequencyOrder`], [`StructureError::Mode`], [`StructureError::Height`] for a sensor above the
/// top, [`StructureError::Option`].
///
/// # Limits
/// Above five joints, and with shapes, "every solution" means every solution found: the search starts from many points and may miss one. Standard
/// deviations are linearised: above about 30 % of k they give only the order of magnitude. Rotations are small, links are rigid, and masses are
/// known.
///
/// # Source
/// Choi (2021), sec. 5, announces this as future work; damped Gauss–Newton with variable projection (Golub & Pereyra 1973 SIAM J. Numer. Anal.
/// 10:413-432) and exact derivatives of simple modes (Fox & Kapoor 1968 AIAA J. 6:2426-2429).
///
/// # Example
/// ```
/// use dolmen::structure::{Chain, ChainStiffness, Choice, Inertia, Link, MeasuredMode, chain_stiffness};
/// let link = Link {
///     mass_kg: 1000.0,
///     length_m: 3.0,
///     centroid_m: 1.5,
///     inertia: Inertia::ThinRod,
///     bed_width_m: None,
/// };
/// let chain = Chain::new(vec![link], 9.81)?;
/// let measured = MeasuredMode {
///     frequency_hz: 2.0,
///     frequency_sd_hz: 0.02,
///     frequency_changes_hz: vec![],
///     shape: vec![],
/// };
/// let found = chain_stiffness(&chain, &[measured], &ChainStiffness::default())?;
/// let k = (std::f64::consts::TAU * 2.0).powi(2) * 3000.0 + 1000.0 * 9.81 * 1.5; // ω² I + m g l
/// assert_eq!(found.choice, Choice::One);
/// assert!((found.solutions[0].stiffness[0] / k - 1.0).abs() < 1e-12);
/// # Ok::<(), dolmen::structure::StructureError>(())
/// ```
pub fn chain_stiffness(
    chain: &Chain,
    modes: &[MeasuredMode],
    options: &ChainStiffness,
) -> Result<StiffnessSolutions, StructureError> {
    stiffness_from_modes(chain, modes, options)
}

/// Largest number of joints for which every solution is followed: 120 paths take 0.2 s, 720 about 2.5 s.
const JOINTS_FOLLOWED_MOST: usize = 5;

impl Sprung for Chain {
    const PARTS: &'static str = "links";
    const SPRING: Spring = Spring::Joint;

    fn model(&self) -> Result<SpringModel, StructureError> {
        let n = self.links().len();
        let springs = Matrix::from_fn(n, n, |row, i| match row {
            _ if row == i => 1.0,
            _ if row + 1 == i => -1.0,
            _ => 0.0,
        });
        // the stiffness with unit joints minus that of their springs leaves gravity and the side support
        let rest = &self.stiffness_matrix(&vec![1.0; n])? - &(&springs * &springs.transpose());
        Ok(SpringModel {
            mass: self.mass_matrix(),
            rest,
            springs,
        })
    }

    fn sensor(&self, height_m: f64) -> Result<Vec<f64>, StructureError> {
        self.lever_m_rad(height_m)
    }

    fn proportion(&self) -> Vec<f64> {
        self.necessary_n_m_rad()
    }

    fn proportion_to(&self) -> Proportion {
        Proportion::WeightMoment
    }

    fn natural_modes_with(&self, stiffness: &[f64]) -> Result<Vec<NaturalMode>, StructureError> {
        self.natural_modes(stiffness)
    }

    fn roots(&self, frequencies_hz: &[f64]) -> Result<Option<FrequencyRoots>, StructureError> {
        if self.links().len() > JOINTS_FOLLOWED_MOST {
            return Ok(None);
        }
        let lambda: Vec<f64> = frequencies_hz
            .iter()
            .map(|f| (std::f64::consts::TAU * f).powi(2))
            .collect();
        Ok(Some(roots_by_continuation(&self.model()?, &lambda)?))
    }

    fn assumptions(&self) -> Vec<StiffnessNote> {
        let mut notes = Vec::new();
        if self.assumes_thin_rods() {
            notes.push(StiffnessNote::ThinRods);
        }
        let supports = self.side_supports();
        if supports.iter().any(|support| support.acts_linearly()) {
            notes.push(StiffnessNote::SideSupportTaken);
        }
        if supports.iter().any(|support| !support.acts_linearly()) {
            notes.push(StiffnessNote::SideSupportWithGap);
        }
        notes
    }
}
