//! Any motion file: the format is found out from its content.

use super::options::Lengths;
use super::plausible::refuse_implausible;
use super::{MotionError, MotionOptions, at2, text};
use crate::records::Unit;
use dolmen::signal::{Component, GroundMotion, Processing, Quantity};

/// Share by which two time steps may differ and still be one: printed digits, no more. Chosen here.
const STEP_TOLERANCE: f64 = 1e-6;

/// Format of a motion file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MotionFormat {
    /// Of the PEER databases.
    At2,
    /// Text in columns.
    Text,
}

impl MotionFormat {
    /// "at2", "csv".
    pub fn name(self) -> &'static str {
        match self {
            MotionFormat::At2 => "at2",
            MotionFormat::Text => "csv",
        }
    }
}

/// One component as read.
#[derive(Clone, Debug, PartialEq)]
pub struct ComponentReading {
    /// Format of the file.
    pub format: MotionFormat,
    /// What the file calls itself: earthquake, station, direction; "" if it does not say.
    pub title: String,
    /// Acceleration, m/s².
    pub acceleration_m_s2: Vec<f64>,
    /// Between samples, s.
    pub time_step_s: f64,
    /// Unit of the numbers in the file.
    pub unit: Unit,
}

/// What each format yields: numbers as printed.
pub(super) struct Raw {
    pub(super) format: MotionFormat,
    pub(super) title: String,
    pub(super) samples: Vec<f64>,
    pub(super) time_step_s: f64,
    /// As the file says.
    pub(super) unit: Option<Unit>,
}

/// One component of a motion from the bytes of a file: AT2 of the PEER databases, or text in columns.
///
/// # Errors
/// [`MotionError`], which says where in the file and what to do: no unit, a unit or a step that contradicts the file, a peak
/// that no earthquake has, a value that is no number, fewer samples than the header says.
///
/// # Example
/// ```
/// use dolmen_formats::motions::{MotionOptions, read_component};
/// let text = "time_s,acceleration_g\n0,0\n0.02,0.1\n0.04,-0.3\n";
/// let read = read_component(text.as_bytes(), &MotionOptions::default())?;
/// assert!((read.acceleration_m_s2[2] + 0.3 * 9.80665).abs() < 1e-15 && read.time_step_s == 0.02);
/// # Ok::<(), dolmen_formats::motions::MotionError>(())
/// ```
pub fn read_component(bytes: &[u8], options: &MotionOptions) -> Result<ComponentReading, MotionError> {
    if let Some(given) = options.time_step_s
        && !(given > 0.0 && given.is_finite())
    {
        return Err(MotionError::Step { given });
    }
    let raw = if at2::is_at2(bytes) {
        at2::read(bytes, options.unit.is_some())?
    } else {
        text::read(bytes, options)?
    };
    let unit = match (options.unit, raw.unit) {
        (Some(given), Some(found)) if given != found => {
            return Err(MotionError::UnitDisagrees {
                given: given.symbol(),
                found: found.symbol(),
            });
        }
        (given, found) => given.or(found).ok_or(MotionError::NoUnit)?,
    };
    if unit.quantity() != Quantity::Acceleration {
        return Err(MotionError::NotAcceleration {
            given: unit.symbol().to_owned(),
        });
    }
    if let Some(given) = options.time_step_s
        && !same_step(given, raw.time_step_s)
    {
        return Err(MotionError::StepDisagrees {
            given,
            found: raw.time_step_s,
        });
    }
    let mut samples = raw.samples;
    samples.iter_mut().for_each(|a| *a *= unit.si());
    let peak_m_s2 = samples.iter().fold(0.0, |peak, a| f64::max(peak, a.abs()));
    refuse_implausible(peak_m_s2, unit, &options.plausible_peak_m_s2)?;
    Ok(ComponentReading {
        format: raw.format,
        title: raw.title,
        acceleration_m_s2: samples,
        time_step_s: raw.time_step_s,
        unit,
    })
}

fn same_step(a: f64, b: f64) -> bool {
    (a - b).abs() <= STEP_TOLERANCE * a.abs()
}

/// A motion from one file a component. Its history begins with how each was read.
///
/// # Errors
/// [`MotionError::Component`] around what [`read_component`] says; [`MotionError::TimeSteps`]; [`MotionError::Lengths`]
/// unless [`MotionOptions::lengths`] allows it.
///
/// # Limits
/// All files must begin at the same time and the signs must be those of x, y and z: AT2 files do not say when they begin.
pub fn read_motion(
    name: &str,
    files: &[(Component, &[u8])],
    options: &MotionOptions,
) -> Result<GroundMotion, MotionError> {
    let mut read = Vec::with_capacity(files.len());
    for (component, bytes) in files {
        let one = read_component(bytes, options).map_err(|fault| MotionError::Component {
            component: component.name(),
            fault: Box::new(fault),
        })?;
        read.push((*component, one));
    }
    let Some((first, reference)) = read.first() else {
        return Err(MotionError::NoFile);
    };
    let (time_step_s, length) = (reference.time_step_s, reference.acceleration_m_s2.len());
    let mut shortest = length;
    for (component, one) in &read {
        if !same_step(time_step_s, one.time_step_s) {
            return Err(MotionError::TimeSteps {
                first: first.name(),
                first_s: time_step_s,
                second: component.name(),
                second_s: one.time_step_s,
            });
        }
        let samples = one.acceleration_m_s2.len();
        if options.lengths == Lengths::Same && samples != length {
            return Err(MotionError::Lengths {
                first: first.name(),
                first_samples: length,
                second: component.name(),
                second_samples: samples,
            });
        }
        shortest = shortest.min(samples);
    }
    let was_cut = read.iter().any(|(_, one)| one.acceleration_m_s2.len() > shortest);
    let steps: Vec<Processing> = read
        .iter()
        .map(|(_, one)| Processing::Read {
            format: one.format.name().to_owned(),
            unit: one.unit.symbol().to_owned(),
        })
        .collect();
    let series = read.into_iter().map(|(component, one)| {
        let mut samples = one.acceleration_m_s2;
        samples.truncate(shortest);
        (component, samples)
    });
    let mut motion = GroundMotion::new(name, time_step_s, series.collect())?;
    steps.into_iter().for_each(|step| motion.note(step));
    if was_cut {
        motion.note(Processing::Cut {
            from_s: 0.0,
            to_s: motion.duration_s(),
        });
    }
    Ok(motion)
}
