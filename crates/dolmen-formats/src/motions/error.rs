//! Why a motion cannot be read.

use crate::records::RecordError;
use dolmen::signal::SignalError;

/// Why the bytes of a file are no ground motion. Each variant says where in the file and what to do. Lines are counted from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// No file.
    #[error("no file is given: a motion needs at least one component")]
    NoFile,
    /// One component is refused.
    #[error("the {component} component: {fault}")]
    Component {
        /// Which: "x", "y", "z".
        component: &'static str,
        /// Why.
        fault: Box<MotionError>,
    },
    /// The unit of the numbers is not known.
    #[error(
        "the unit of the accelerations is not known: the file does not say it; give unit = g, gal or m/s2"
    )]
    NoUnit,
    /// The unit measures something else.
    #[error(
        "the unit \"{given}\" is not one of acceleration: give g, gal, m/s2, cm/s2, mm/s2 or mg, and a file of accelerations"
    )]
    NotAcceleration {
        /// The unit.
        given: String,
    },
    /// The unit given is not that of the file.
    #[error("unit is \"{given}\", but the file says \"{found}\": correct it, or leave it out")]
    UnitDisagrees {
        /// The unit given.
        given: &'static str,
        /// The unit of the file.
        found: &'static str,
    },
    /// The peak is none of an earthquake.
    #[error(
        "the peak is {peak_g:.3e} g, but must be {least_g} to {most_g} g: {}; if the motion is truly so, widen \
         plausible_peak_m_s2",
        if suggested.is_empty() {
            format!("check the unit {unit} and the numbers")
        } else {
            format!("is the unit {} instead of {unit}?", suggested.join(" or "))
        }
    )]
    Peak {
        /// The peak read, g.
        peak_g: f64,
        /// The smallest allowed, g.
        least_g: f64,
        /// The largest allowed, g.
        most_g: f64,
        /// The unit it was read in.
        unit: &'static str,
        /// Units in which it would be that of an earthquake.
        suggested: Vec<&'static str>,
    },
    /// The header of an AT2 file does not say how many samples and how far apart.
    #[error(
        "line {line}: \"{text}\" does not give NPTS and DT: it must read like \"NPTS= 4000, DT= .0100 SEC\" or \
         \"4000 0.0100 NPTS, DT\"; download the file again"
    )]
    At2Header {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
    },
    /// An AT2 file of velocities or displacements.
    #[error("line {line}: the file holds {what}, not accelerations: take the file that ends in AT2")]
    At2Quantity {
        /// The line.
        line: usize,
        /// "velocities", "displacements".
        what: &'static str,
    },
    /// A unit the header of an AT2 file names is not known.
    #[error(
        "line {line}: the unit \"{text}\" is not known: give unit = g, gal or m/s2 if you know which is meant"
    )]
    At2Unit {
        /// The line.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A value is no number.
    #[error("line {line}: \"{text}\" is not a finite number: correct it, or download the file again")]
    NotANumber {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
    },
    /// Not as many samples as the header says.
    #[error(
        "the header says {stated} samples, but {found} follow: the file was cut short or edited; download it again"
    )]
    Count {
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// The time step given is not that of the file.
    #[error("time_step_s is {given}, but the file says {found}: correct it, or leave it out")]
    StepDisagrees {
        /// The step given, s.
        given: f64,
        /// That of the file, s.
        found: f64,
    },
    /// The time step given is no step.
    #[error("time_step_s is {given}, but must be a positive number of seconds")]
    Step {
        /// The step given, s.
        given: f64,
    },
    /// Several columns beside the time.
    #[error("the file has {} columns of numbers ({}): name the one to read as column", names.len(), names.join(", "))]
    Columns {
        /// Their names.
        names: Vec<String>,
    },
    /// Two components are sampled differently.
    #[error(
        "the {first} component has a step of {first_s} s, the {second} of {second_s} s: resample one before"
    )]
    TimeSteps {
        /// One component.
        first: &'static str,
        /// Its step, s.
        first_s: f64,
        /// Another.
        second: &'static str,
        /// Its step, s.
        second_s: f64,
    },
    /// Two components are not equally long.
    #[error(
        "the {first} component has {first_samples} samples, the {second} {second_samples}: if they begin at the same \
         time, say lengths = shortest to cut all to the shortest"
    )]
    Lengths {
        /// One component.
        first: &'static str,
        /// Its samples.
        first_samples: usize,
        /// Another.
        second: &'static str,
        /// Its samples.
        second_samples: usize,
    },
    /// The text in columns is refused.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// The samples make no motion.
    #[error(transparent)]
    Signal(#[from] SignalError),
}

/// As much of a text of the file as fits into a message.
pub(super) fn excerpt(text: &[u8]) -> String {
    const CHARACTERS: usize = 80;
    String::from_utf8_lossy(text)
        .trim()
        .chars()
        .take(CHARACTERS)
        .collect()
}
