//! Stiffness from measured modes: input and results, common to chains and frames.

use super::{NaturalMode, StiffnessNote, StructureError};

/// Lateral displacement of one point in a measured mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapePoint {
    /// Height above the ground (lowest joint), m.
    pub height_m: f64,
    /// Displacement, on a scale common to all points of the mode.
    pub displacement: f64,
    /// Standard deviation of the displacement, on the same scale; 0 if exact, for example at the point that sets the scale.
    pub displacement_sd: f64,
}

/// One measured mode.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredMode {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of the frequency, Hz; 0 if exact.
    pub frequency_sd_hz: f64,
    /// Changes of the frequency, Hz, by each time block of the record that gave all modes (`Mode::frequency_changes_hz`). The covariance
    /// of two modes is the sum of the products of their changes. Empty: this frequency is independent of the others.
    pub frequency_changes_hz: Vec<f64>,
    /// Measured points of the shape; empty if only the frequency is known.
    pub shape: Vec<ShapePoint>,
}

/// Range of each stiffness while every frequency stays within its half-width.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StiffnessRange {
    /// Half-width of each frequency, Hz, in the order of the frequencies.
    pub half_width_hz: Vec<f64>,
    /// Smallest stiffness, lowest joint or storey first.
    pub lower: Vec<f64>,
    /// Largest stiffness.
    pub upper: Vec<f64>,
    /// Whether this solution exists in the whole range. If not, it meets another solution inside the range and disappears; the range then
    /// holds only the part in which it exists.
    pub exists_throughout: bool,
}

/// 95 % interval of one stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StiffnessBounds {
    /// Smallest stiffness; `None` if the data allow any.
    pub lower: Option<f64>,
    /// Largest stiffness; `None` if the data allow more than 10,000 times the fitted value, or if that value is practically rigid.
    pub upper: Option<f64>,
}

/// One set of stiffnesses that explains the measured modes.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StiffnessSolution {
    /// Stiffness of each joint (N m/rad) or storey (N/m), lowest first.
    pub stiffness: Vec<f64>,
    /// Standard deviation of each stiffness, in the same unit, from those of the modes. `None` if the modes have none, if the stiffness is
    /// not determined, or if a deviation exceeds 50 %, because a linear interval would then reach below 0.
    pub stiffness_sd: Option<Vec<f64>>,
    /// Range of each stiffness while every frequency moves by √3 of its standard deviation: this is the half-width of a rounding interval
    /// with that deviation (±0.05 Hz has 0.0289). `None` if the modes have no deviation, or if the range was not computed.
    pub stiffness_range: Option<StiffnessRange>,
    /// Bounds of each stiffness from the profile of the misfit, if a deviation (given or assumed) exceeds 50 % of the stiffness. The
    /// fitted stiffness is then only one point of a wide minimum.
    pub stiffness_bounds: Option<Vec<StiffnessBounds>>,
    /// All natural modes of the structure with this stiffness, in order of frequency.
    pub modes: Vec<NaturalMode>,
    /// Root of the weighted mean square of (computed − measured)/sd over all data, with an assumed sd for data without one. If there are
    /// only frequencies without sd: root mean square of the relative differences.
    pub misfit: f64,
    /// Whether the structure stands with this stiffness (smallest ω² positive).
    pub stands: bool,
}

impl StiffnessSolution {
    /// Each stiffness for a stability verdict: the lower bound if the data only bound the stiffness, otherwise the fitted value. This is
    /// conservative, because stiffer springs are more stable under gravity. `None` if some stiffness has no lower bound.
    pub fn stiffness_least(&self) -> Option<Vec<f64>> {
        match &self.stiffness_bounds {
            None => Some(self.stiffness.clone()),
            Some(bounds) => bounds.iter().map(|bound| bound.lower).collect(),
        }
    }
}

/// Whether the data select one solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Choice {
    /// One solution explains the data. Every other solution has an unacceptable misfit, or (data with standard deviations, given or
    /// assumed) a chi-squared that exceeds the best by more than 10.83, the 99.9 % quantile for one degree of freedom.
    One,
    /// One solution explains the data, but some stiffness is known only between wide bounds, or from one side
    /// (`StiffnessSolution::stiffness_bounds`). Its fitted value is then no result.
    Bounded,
    /// The data do not choose between several solutions, or the listed solution is two that meet: shapes are needed.
    Indistinguishable,
    /// There are fewer data than unknowns: the solutions belong to a continuous family.
    Underdetermined,
    /// No real stiffness explains the data.
    Impossible,
}

/// Sensitivity of the data to the stiffnesses: singular values of the Jacobian d(data)/d(ln k), with data in units of their sd (given or
/// assumed; relative for frequencies alone without sd).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Visibility {
    /// Singular values, descending; as many as unknowns (zeros if there are fewer data).
    pub singular_values: Vec<f64>,
    /// Share of each stiffness direction that the data determine: 1 fully, 0 not at all.
    pub seen: Vec<f64>,
    /// Number of directions that the data do not determine.
    pub free_directions: usize,
}

/// All solutions found, and their common properties.
#[derive(Clone, Debug, PartialEq)]
pub struct StiffnessSolutions {
    /// Solutions by ascending misfit; with equal misfit by the first stiffness.
    pub solutions: Vec<StiffnessSolution>,
    /// Whether the data select one solution.
    pub choice: Choice,
    /// Sensitivity of the data to the stiffnesses, at the first solution; `None` if there is none.
    pub visibility: Option<Visibility>,
    /// Number of starting points (1 for a closed form).
    pub starts: usize,
    /// Notes: why no solution exists, what was left out or assumed.
    pub notes: Vec<StiffnessNote>,
}

/// Checks that modes can be those of a structure with `most` parts.
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
