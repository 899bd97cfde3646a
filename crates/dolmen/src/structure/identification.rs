//! Stiffness from measured modes: what goes in and what comes out, the same for chains and frames.

use super::{NaturalMode, StiffnessNote, StructureError};

/// Lateral displacement of one point in a measured mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapePoint {
    /// Height above the ground (lowest joint), m.
    pub height_m: f64,
    /// Displacement, any scale that all points of the mode share.
    pub displacement: f64,
    /// Standard deviation of it, same scale; 0 if taken as exact, as at the point where the scale was set.
    pub displacement_sd: f64,
}

/// One measured mode.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredMode {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of it, Hz; 0 if taken as exact.
    pub frequency_sd_hz: f64,
    /// Changes of the frequency, Hz, by each block of time of the record that gave all modes (`Mode::frequency_changes_hz`): products with
    /// another mode's sum to their covariance. Empty: this frequency is independent of the others.
    pub frequency_changes_hz: Vec<f64>,
    /// Measured points of the shape; empty if only the frequency is known.
    pub shape: Vec<ShapePoint>,
}

/// Range of each stiffness while every frequency stays within a half-width of its measured value.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StiffnessRange {
    /// Half-width of each frequency, Hz, by frequency.
    pub half_width_hz: Vec<f64>,
    /// Smallest stiffness, lowest joint or storey first.
    pub lower: Vec<f64>,
    /// Largest stiffness.
    pub upper: Vec<f64>,
    /// Whether this solution exists over all of the range. If not, it meets another one and vanishes inside, and the
    /// range holds only the part where it exists.
    pub exists_throughout: bool,
}

/// How far one stiffness can lie from the best fit, both ends of a 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StiffnessBounds {
    /// Smallest stiffness; `None` if the data allow any.
    pub lower: Option<f64>,
    /// Largest stiffness; `None` if the data allow more than 10,000 times the fitted one, or that is as if rigid.
    pub upper: Option<f64>,
}

/// One set of stiffnesses that explains the measured modes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StiffnessSolution {
    /// Stiffness of each joint (N m/rad) or storey (N/m), lowest first.
    pub stiffness: Vec<f64>,
    /// Standard deviation of each, same unit, from the modes' own; `None` if the modes carry none, the
    /// stiffness is not determined, or a deviation exceeds 50 %, where a linear interval would reach below 0.
    pub stiffness_sd: Option<Vec<f64>>,
    /// Range of each while every frequency moves by √3 of its standard deviation, the half-width of a rounding that has
    /// it (±0.05 Hz has 0.0289); `None` if the modes carry none, or where it was not computed.
    pub stiffness_range: Option<StiffnessRange>,
    /// Where a deviation exceeds 50 % of the stiffness, by deviations given or assumed: what the data allow of each
    /// stiffness, by the profile of the misfit. The stiffness itself is then one point of a wide valley.
    pub stiffness_bounds: Option<Vec<StiffnessBounds>>,
    /// All natural modes of the structure with this stiffness, by frequency.
    pub modes: Vec<NaturalMode>,
    /// Root of the weighted mean square of (computed − measured)/sd over all data, with an assumed sd for data without one. For
    /// frequencies alone without sd: of the relative differences.
    pub misfit: f64,
    /// Whether the structure stands with this stiffness (smallest ω² positive).
    pub stands: bool,
}

impl StiffnessSolution {
    /// Each stiffness for a stability verdict: the lower bound if the data only bound it, otherwise the fitted value. This is
    /// conservative, because stiffer springs make overturning by gravity less likely. `None` if some stiffness has no lower bound.
    pub fn stiffness_least(&self) -> Option<Vec<f64>> {
        match &self.stiffness_bounds {
            None => Some(self.stiffness.clone()),
            Some(bounds) => bounds.iter().map(|bound| bound.lower).collect(),
        }
    }
}

/// Selection of the true solution by the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Choice {
    /// One solution explains the data. Any other found has a misfit that is not accepted, or (data with standard
    /// deviations, given or assumed) a chi-squared beyond the best by more than 10.83, 99.9 % of one degree of freedom.
    One,
    /// One solution explains the data, but some stiffness is known only between wide bounds, or from one side
    /// (`StiffnessSolution::stiffness_bounds`): its fitted value is no answer.
    Bounded,
    /// The data do not choose among several solutions, or two that meet in the one listed: shapes are needed.
    Indistinguishable,
    /// Fewer data than unknowns: the solutions are points of a continuous family.
    Underdetermined,
    /// No real stiffness explains the data.
    Impossible,
}

/// Which stiffnesses the sensors see: singular values of the Jacobian d(data)/d(ln k), data in units of their sd
/// (given or assumed; relative for frequencies alone without sd).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Visibility {
    /// Singular values, descending; as many as unknowns (zeros where there are fewer data).
    pub singular_values: Vec<f64>,
    /// For each stiffness, the share of its direction that the data determine: 1 fully, 0 not at all.
    pub seen: Vec<f64>,
    /// Number of directions that stay free.
    pub free_directions: usize,
}

/// Every solution found, and properties of all of them.
#[derive(Clone, Debug, PartialEq)]
pub struct StiffnessSolutions {
    /// Best misfit first; within equal misfit by the first stiffness.
    pub solutions: Vec<StiffnessSolution>,
    /// Selection of a solution by the data.
    pub choice: Choice,
    /// Sensitivity of the data to the stiffnesses, at the first solution; `None` if there is none.
    pub visibility: Option<Visibility>,
    /// Starting points tried (1 for a closed form).
    pub starts: usize,
    /// Notes: why no solution exists, what was left out, what was assumed.
    pub notes: Vec<StiffnessNote>,
}

/// Refuses modes that cannot be those of a structure of `most` parts.
///
/// # Errors
/// [`StructureError::ModesMissing`], [`StructureError::ModesMost`], [`StructureError::Mode`],
/// [`StructureError::FrequencyOrder`].
pub(super) fn check_modes(
    modes: &[MeasuredMode],
    most: usize,
    parts: &'static str,
) -> Result<(), StructureError> {
    let given = modes.len();
    if given == 0 {
        return Err(StructureError::ModesMissing);
    }
    if given > most {
        return Err(StructureError::ModesMost { given, most, parts });
    }
    for (i, mode) in modes.iter().enumerate() {
        let refuse = |quantity, given: f64, allowed, holds: bool| match holds && given.is_finite() {
            true => Ok(()),
            false => Err(StructureError::Mode {
                mode: i + 1,
                quantity,
                given,
                allowed,
            }),
        };
        let (positive, not_negative) = ("a positive number", "0 (exact) or a positive number");
        let MeasuredMode {
            frequency_hz,
            frequency_sd_hz,
            frequency_changes_hz,
            shape,
        } = mode;
        refuse("frequency_hz", *frequency_hz, positive, *frequency_hz > 0.0)?;
        refuse(
            "frequency_sd_hz",
            *frequency_sd_hz,
            not_negative,
            *frequency_sd_hz >= 0.0,
        )?;
        for change in frequency_changes_hz {
            refuse("frequency_changes_hz", *change, "a finite number", true)?;
        }
        for point in shape {
            refuse(
                "displacement of a shape point",
                point.displacement,
                "a finite number",
                true,
            )?;
            let sd = point.displacement_sd;
            refuse("displacement_sd of a shape point", sd, not_negative, sd >= 0.0)?;
        }
        if !shape.is_empty() && shape.iter().all(|point| point.displacement == 0.0) {
            refuse(
                "largest displacement of the shape",
                0.0,
                "other than 0: leave the shape out",
                false,
            )?;
        }
        if let Some(before) = i.checked_sub(1).map(|before| modes[before].frequency_hz)
            && mode.frequency_hz <= before
        {
            return Err(StructureError::FrequencyOrder {
                mode: i + 1,
                given: mode.frequency_hz,
                before,
            });
        }
    }
    Ok(())
}
