//! Stiffness of a chain's joints from measured modes: every solution found, its uncertainty, and what the sensors
//! do not see.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | M_i | `necessary_n_m_rad` | Σ_{j≥i} G_j, the exact limit of joint i with the others rigid | N m/rad |
//! | J | | d(data over sd)/d(ln k) | |

use super::Chain;
use super::modal_fit::{ModalFit, StandIn};
use super::search::{Search, rank, singular_values};
use crate::structure::identification::check_modes;
use crate::structure::{MeasuredMode, StiffnessSolutions, StructureError};

/// How stiffness is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainStiffness {
    /// Starting points scattered over the stiffnesses. Default 1000, our choice: with five frequencies of the flagpole
    /// of Choi (2021) it finds what 10,000 find for stiffness in proportion to M_i and for equal joints.
    pub starts: usize,
    /// Most solutions listed; how many more were found is noted. Default 64, our choice.
    pub solutions_most: usize,
    /// Largest misfit of a solution where the modes carry standard deviations, in those. Default 2, our choice.
    pub misfit_most: f64,
    /// Largest misfit where they carry none, relative. Default 0.01, our choice: frequencies of monuments repeat to
    /// about that between seasons.
    pub difference_most: f64,
    /// Relative standard deviation taken for a frequency without one when other data have theirs. Default 0.005, our
    /// choice.
    pub frequency_sd_assumed: f64,
    /// Standard deviation taken for a shape point without one when other data have theirs, relative to the largest
    /// displacement of the mode. Default 0.02, our choice.
    pub shape_sd_assumed: f64,
}

impl Default for ChainStiffness {
    fn default() -> Self {
        ChainStiffness {
            starts: 1000,
            solutions_most: 64,
            misfit_most: 2.0,
            difference_most: 0.01,
            frequency_sd_assumed: 0.005,
            shape_sd_assumed: 0.02,
        }
    }
}

/// Joint stiffnesses that explain measured modes.
///
/// ```text
/// min over ln k of Σ ((ln f_j(k) − ln f_j)/sd)² + Σ ((a_j c(z_p)ᵀ φ_j(k) − u_pj)/sd)²       a_j free
/// cov(ln k) = (JᵀJ)⁻¹        J: data × joints, exact derivatives
/// ```
///
/// Damped Gauss–Newton from many starts: the solution of the linear equations K(k) φ = ω² M φ where a mode's points
/// give its whole shape, stiffnesses in proportion to M_i, and a low-discrepancy scatter.
///
/// Frequencies alone have many solutions. As many frequencies as joints are n polynomials of degrees 1 to n in k: at
/// most n! solutions (Bézout), and every real one stands, since K is then positive definite. Complex ones come in
/// pairs, so the number of real ones is even for two joints or more; while it is odd, the search goes on. On the
/// flagpole of Choi (2021) five frequencies leave 4 solutions if stiffness goes with M_i, 40 if the joints are equal,
/// and up to all 5! = 120 if the upper joints are the stiffer ones.
///
/// With fewer data than joints, the solution given is the one whose stiffnesses are nearest to a common multiple of
/// M_i (least squares of ln k); `choice` is [`Choice::Underdetermined`] and the notes say what stays free.
///
/// # Input
/// * `modes` -- the **lowest** modes of one direction, ascending, none left out between them. Displacements are those
///   of points at heights above the lowest joint.
///
/// # Errors
/// [`StructureError::ModesMissing`], [`StructureError::ModesMost`] for more modes than links,
/// [`StructureError::FrequencyOrder`], [`StructureError::Mode`], [`StructureError::Height`] for a sensor above the
/// top.
///
/// # Limits
/// "Every solution" is every solution found: many starts are no proof. Standard deviations are linear: above some 30 %
/// of k they are only an order of magnitude. Small rotations, rigid links, a known mass.
///
/// # Source
/// The future work announced by Choi (2021), sec. 5; damped Gauss–Newton with variable projection (Golub & Pereyra
/// 1973 SIAM J. Numer. Anal. 10:413-432) and exact derivatives of simple modes (Fox & Kapoor 1968 AIAA J. 6:2426-2429).
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
    check_modes(modes, chain.links().len(), "links")?;
    let weighting = Weighting::of(modes);
    let fit = ModalFit::new(chain, modes, weighting.stand_in(options))?;
    let mut search = Search {
        chain,
        modes,
        options,
        fit,
        weighting,
        independent: 0,
    };
    let prior = search.prior();
    if let Some(at) = search.fit.residuals(&prior) {
        search.independent = rank(&singular_values(&at.jacobian)?);
    }
    if search.independent < chain.links().len() {
        search.nearest_to_the_prior(&prior)
    } else {
        search.many_starts(&prior)
    }
}

/// Whether the data are weighted by standard deviations.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Weighting {
    /// None has one: relative differences.
    Relative,
    /// All have.
    Given,
    /// Some have; the others get an assumed one.
    PartlyAssumed,
}

impl Weighting {
    fn of(modes: &[MeasuredMode]) -> Self {
        let all = modes.iter().flat_map(|mode| {
            let points = mode.shape.iter().map(|point| point.displacement_sd);
            points.chain([mode.frequency_sd_hz])
        });
        let (given, count) = all.fold((0, 0), |(given, count), sd| {
            (given + usize::from(sd > 0.0), count + 1)
        });
        match given {
            0 => Weighting::Relative,
            given if given == count => Weighting::Given,
            _ => Weighting::PartlyAssumed,
        }
    }

    fn stand_in(self, options: &ChainStiffness) -> StandIn {
        match self {
            Weighting::Relative => StandIn {
                frequency: 1.0,
                shape: 1.0,
            },
            _ => StandIn {
                frequency: options.frequency_sd_assumed,
                shape: options.shape_sd_assumed,
            },
        }
    }
}
