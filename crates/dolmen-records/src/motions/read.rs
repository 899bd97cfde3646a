//! Motions of several components from files of one channel each.

use super::options::Lengths;
use super::{ComponentReading, MotionError, MotionOptions, Orientation, read_component};
use crate::records::{Break, Unit};
use dolmen::signal::{Component, GroundMotion, Processing, Quantity};

/// Share by which two time steps may differ and still be one: printed digits, no more. Chosen here.
const STEP_TOLERANCE: f64 = 1e-6;

/// Share of a time step by which components may begin apart. Chosen here: half of it decides which sample is meant.
const START_STEPS: f64 = 0.5;

/// Format of a motion file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionFormat {
    /// Of the PEER databases.
    At2,
    /// COSMOS V1 or V2, format 1.20.
    Cosmos,
    /// V1 or V2 of the Californian program before it.
    Csmip,
    /// K-NET or KiK-net ASCII.
    KNet,
    /// ESM ASCII.
    Esm,
    /// SAC, binary.
    Sac,
    /// SAC, alphanumeric.
    SacText,
    /// miniSEED 2.
    MiniSeed,
    /// Text in columns.
    Text,
}

impl MotionFormat {
    /// "at2", "cosmos", "csmip", "k-net", "esm", "sac", "sac (text)", "miniseed", "csv".
    pub fn name(self) -> &'static str {
        match self {
            MotionFormat::At2 => "at2",
            MotionFormat::Cosmos => "cosmos",
            MotionFormat::Csmip => "csmip",
            MotionFormat::KNet => "k-net",
            MotionFormat::Esm => "esm",
            MotionFormat::Sac => "sac",
            MotionFormat::SacText => "sac (text)",
            MotionFormat::MiniSeed => "miniseed",
            MotionFormat::Text => "csv",
        }
    }
}

/// What each format yields: numbers as printed.
pub(crate) struct Raw {
    pub(crate) format: MotionFormat,
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) samples: Vec<f64>,
    pub(crate) time_step_s: f64,
    /// As the file says.
    pub(crate) unit: Option<Unit>,
    pub(crate) orientation: Option<Orientation>,
    pub(crate) begins_s: Option<f64>,
    /// Where the samples go on after a gap.
    pub(crate) breaks: Vec<Break>,
    /// Whether the numbers have an offset by the definition of the format.
    pub(crate) subtract_mean: bool,
    /// What is measured, if the file says it without a unit.
    pub(crate) quantity: Option<Quantity>,
    /// Largest absolute value by the header, in the unit of the file.
    pub(crate) stated_peak: Option<f64>,
}

impl Raw {
    /// Nothing known but this.
    pub(super) fn new(format: MotionFormat, time_step_s: f64) -> Self {
        Raw {
            format,
            name: String::new(),
            title: String::new(),
            samples: Vec::new(),
            time_step_s,
            unit: None,
            orientation: None,
            begins_s: None,
            breaks: Vec::new(),
            subtract_mean: false,
            quantity: None,
            stated_peak: None,
        }
    }
}

pub(super) fn same_step(a: f64, b: f64) -> bool {
    (a - b).abs() <= STEP_TOLERANCE * a.abs()
}

/// A motion from one file a component. Its history begins with how each was read.
///
/// # Errors
/// [`MotionError::Component`] around what [`read_component`] says; [`MotionError::TimeSteps`]; [`MotionError::Lengths`]
/// unless [`MotionOptions::lengths`] allows it.
///
/// # Limits
/// The signs of the files are taken as those of x, y and z, whatever direction they state; [`read_oriented`](super::read_oriented)
/// turns them. Files that say when they begin must agree in it; AT2 files and texts do not say it, and must.
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
    motion_of(name, read, options)
}

/// A motion from channels that are known to point along x, y or z.
pub(super) fn motion_of(
    name: &str,
    read: Vec<(Component, ComponentReading)>,
    options: &MotionOptions,
) -> Result<GroundMotion, MotionError> {
    let Some((first, reference)) = read.first() else {
        return Err(MotionError::NoFile);
    };
    let length = reference.acceleration_m_s2.len();
    let time_step_s = reference.time_step_s;
    let mut shortest = length;
    for (component, one) in &read {
        agree((*first, reference), (*component, one), options)?;
        shortest = shortest.min(one.acceleration_m_s2.len());
    }
    let was_cut = read.iter().any(|(_, one)| one.acceleration_m_s2.len() > shortest);
    let mut steps: Vec<Processing> = Vec::new();
    for (_, one) in &read {
        steps.push(Processing::Read {
            format: one.format.name().to_owned(),
            unit: one.unit.symbol().to_owned(),
        });
    }
    if options.factor != 1.0 {
        steps.push(Processing::Scaled {
            factor: options.factor,
        });
    }
    if read.iter().any(|(_, one)| one.mean_subtracted_m_s2.is_some()) {
        steps.push(Processing::Detrend { degree: 0 });
    }
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

/// Refuses a component whose step, length or start is not that of the first.
fn agree(
    (first, reference): (Component, &ComponentReading),
    (second, one): (Component, &ComponentReading),
    options: &MotionOptions,
) -> Result<(), MotionError> {
    let (first, second) = (first.name(), second.name());
    let (first_s, second_s) = (reference.time_step_s, one.time_step_s);
    if !same_step(first_s, second_s) {
        return Err(MotionError::TimeSteps {
            first,
            first_s,
            second,
            second_s,
        });
    }
    if let (Some(a), Some(b)) = (reference.begins_s, one.begins_s)
        && (b - a).abs() > START_STEPS * first_s
    {
        return Err(MotionError::Starts {
            first,
            second,
            later_s: b - a,
        });
    }
    let (first_samples, second_samples) = (reference.acceleration_m_s2.len(), one.acceleration_m_s2.len());
    if options.lengths == Lengths::Same && first_samples != second_samples {
        return Err(MotionError::Lengths {
            first,
            first_samples,
            second,
            second_samples,
        });
    }
    Ok(())
}
