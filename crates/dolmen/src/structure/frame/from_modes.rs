//! Storey stiffness of a frame from measured modes: all solutions, their uncertainty, and the parts that the sensors cannot
//! determine.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | K_0 | `rest` | K_ties − K_G: stiffness without the storey springs | N/m |
//! | b_i | `springs` | e_i − e_{i−1} (drift), e_i (grounded) | – |
//! | h_i | | height of level i above the ground | m |

use super::from_frequencies::{STOREYS_EXHAUSTIVE_MOST, stiffness_from_frequencies};
use super::storeys::{Convention, Frame};
use crate::structure::inverse::{FrequencyRoots, SpringModel, Sprung, StiffnessSearch, stiffness_from_modes};
use crate::structure::{
    MeasuredMode, NaturalMode, Proportion, Spring, StiffnessNote, StiffnessSolutions, StructureError,
};
use dolmen_linalg::Matrix;

/// Options of the search for storey stiffness.
pub type FrameStiffness = StiffnessSearch;

/// Storey stiffnesses that explain the measured modes of one direction.
///
/// ```text
/// min over ln k of Σ ((ln f_j(k) − ln f_j)/sd)² + Σ ((a_j c(z_p)ᵀ φ_j(k) − u_pj)/sd)²       a_j free
/// cov(ln k) = (JᵀJ)⁻¹        J: data × storeys, exact derivatives
/// ```
///
/// If there are as many frequencies as storeys, up to n! solutions exist, and all are returned (as by
/// [`stiffness_from_frequencies`]). Frequencies alone cannot select one of them; one measured shape can. With fewer data than
/// storeys the result is the solution nearest to a fixed proportion between the storeys, and `choice` is
/// [`Choice::Underdetermined`](crate::structure::Choice::Underdetermined).
///
/// # Input
/// * `modes` -- the **lowest** modes of this direction, without torsion, ascending, with none left out between them. The
///   displacements belong to points at heights above the ground; between levels the shape is linear.
///
/// # Errors
/// [`StructureError::ModesMissing`], [`StructureError::ModesMost`] for more modes than storeys,
/// [`StructureError::FrequencyOrder`], [`StructureError::Mode`], [`StructureError::Height`] for a sensor above the top.
///
/// # Limits
/// Standard deviations are linearised: above about 30 % of k they give only the order of magnitude. `stiffness_range` is not
/// linearised; it is available for up to four storeys. Above six storeys the search starts from many points and may miss a
/// solution. Masses and axial forces are taken as known.
///
/// # Source
/// Park & Min (2010), sec. 3.2. Tested by `park_min_2010` and `stiffness_covariance`. Differs from the source: returns every
/// solution, with intervals, and uses shapes to select one.
///
/// # Example
/// ```
/// use dolmen::structure::{Choice, Convention, Frame, FrameStiffness, MeasuredMode, ShapePoint, Storey, frame_stiffness};
/// let storeys = vec![
///     Storey { mass_kg: 290e3, height_m: 5.84, axial_n: 5919e3 },
///     Storey { mass_kg: 314e3, height_m: 7.69, axial_n: 3077e3 },
/// ];
/// let gate = Frame::new(storeys, Convention::Drift)?;
/// let mode = |frequency_hz, shape| MeasuredMode { frequency_hz, frequency_sd_hz: 0.0, frequency_changes_hz: vec![], shape };
/// let modes = [mode(1.1, vec![]), mode(4.2, vec![])];
/// let found = frame_stiffness(&gate, &modes, &FrameStiffness::default())?;
/// assert_eq!((found.choice, found.solutions.len()), (Choice::Indistinguishable, 2));
///
/// let point = |height_m, displacement| ShapePoint { height_m, displacement, displacement_sd: 0.0 };
/// let modes = [mode(1.1, vec![point(5.84, 0.84), point(13.53, 1.0)]), mode(4.2, vec![])];
/// let found = frame_stiffness(&gate, &modes, &FrameStiffness::default())?;
/// assert_eq!((found.choice, found.solutions.len()), (Choice::One, 1));
/// # Ok::<(), dolmen::structure::StructureError>(())
/// ```
pub fn frame_stiffness(
    frame: &Frame,
    modes: &[MeasuredMode],
    options: &FrameStiffness,
) -> Result<StiffnessSolutions, StructureError> {
    stiffness_from_modes(frame, modes, options)
}

impl Sprung for Frame {
    const PARTS: &'static str = "storeys";
    const SPRING: Spring = Spring::Storey;

    fn model(&self) -> Result<SpringModel, StructureError> {
        let n = self.storeys().len();
        let drift = self.convention() == Convention::Drift;
        Ok(SpringModel {
            mass: self.mass_matrix(),
            rest: self.stiffness_matrix(&vec![0.0; n])?,
            springs: Matrix::from_fn(n, n, |row, i| match row {
                _ if row == i => 1.0,
                _ if row + 1 == i && drift => -1.0,
                _ => 0.0,
            }),
        })
    }

    /// The displacement of a point between levels is interpolated between the levels below and above.
    fn sensor(&self, height_m: f64) -> Result<Vec<f64>, StructureError> {
        // Heights in a file are sums of rounded lengths: a micrometre above the top counts as the top.
        const ROUNDING_M: f64 = 1e-6;
        let levels = self.level_heights_m();
        let top_m = levels.iter().fold(0.0_f64, |most, h| most.max(*h));
        if !(height_m >= 0.0 && height_m <= top_m + ROUNDING_M) {
            return Err(StructureError::Height {
                quantity: "height_m",
                given: height_m,
                top_m,
            });
        }
        let mut row = vec![0.0; levels.len()];
        let storey = levels
            .iter()
            .position(|&h| height_m <= h)
            .unwrap_or(levels.len() - 1);
        let below_m = if storey == 0 { 0.0 } else { levels[storey - 1] };
        let part = ((height_m - below_m) / (levels[storey] - below_m)).min(1.0);
        row[storey] = part;
        if storey > 0 {
            row[storey - 1] = 1.0 - part;
        }
        Ok(row)
    }

    /// Drift: κ_i = ω² Σ_{j≥i} m_j φ_j / (φ_i − φ_{i−1}) for a straight shape, φ_i = h_i. Grounded: the mass of the storey
    /// and all above, so that no two uncoupled storeys have the same frequency.
    fn proportion(&self) -> Vec<f64> {
        let drift = self.convention() == Convention::Drift;
        let mut sum = 0.0;
        let parts = self.storeys().iter().zip(self.level_heights_m()).rev();
        let mut proportion: Vec<f64> = parts
            .map(|(storey, height_m)| {
                if drift {
                    sum += storey.mass_kg * height_m;
                    sum / storey.height_m
                } else {
                    sum += storey.mass_kg;
                    sum
                }
            })
            .collect();
        proportion.reverse();
        proportion
    }

    fn proportion_to(&self) -> Proportion {
        match self.convention() {
            Convention::Drift => Proportion::MassMomentOverHeight,
            Convention::Grounded => Proportion::MassAbove,
        }
    }

    fn natural_modes_with(&self, stiffness: &[f64]) -> Result<Vec<NaturalMode>, StructureError> {
        self.natural_modes(stiffness)
    }

    fn roots(&self, frequencies_hz: &[f64]) -> Result<Option<FrequencyRoots>, StructureError> {
        if self.storeys().len() > STOREYS_EXHAUSTIVE_MOST {
            return Ok(None);
        }
        Ok(Some(stiffness_from_frequencies(self, frequencies_hz)?))
    }

    fn assumptions(&self) -> Vec<StiffnessNote> {
        let mut notes = Vec::new();
        if self.storeys().iter().all(|storey| storey.axial_n == 0.0) {
            notes.push(StiffnessNote::NoAxialForce);
        }
        if !self.ties().is_empty() {
            notes.push(StiffnessNote::TiesTaken);
        }
        notes
    }
}
