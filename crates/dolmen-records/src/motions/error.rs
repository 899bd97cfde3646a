//! Why a motion cannot be read.

use crate::quoted::{listed, shown};
use crate::records::RecordError;
use crate::seismic::SeismicError;
use dolmen::signal::SignalError;

/// Why the bytes of a file are no ground motion. Each variant says where in the file and what to do. Lines are counted from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
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
        "the unit \"{given}\" is not one of acceleration: give g, gal, m/s2, cm/s2, mm/s2 or mg, and a file of accelerations",
        given = shown(given)
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
    #[error("the file has {} columns of numbers ({}): name the one to read as channel", names.len(), listed(names))]
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
    /// The factor is none.
    #[error("factor is {given}, but must be a finite number other than 0")]
    Factor {
        /// The value given.
        given: f64,
    },
    /// A sample is NaN or infinite.
    #[error(
        "channel \"{channel}\": sample {sample} (from 0) is not a finite number: cut the file there, or leave the channel out",
        channel = shown(channel)
    )]
    NotFinite {
        /// The channel.
        channel: String,
        /// The sample, from 0.
        sample: usize,
    },
    /// The peak of the samples is not the one that the header states.
    #[error(
        "channel \"{channel}\": the header says that the peak is {stated} {unit}, but that of the samples is {found:.6}: they \
         were damaged or changed; download the file again, or say stated_peak = ignore if you know why",
        channel = shown(channel)
    )]
    StatedPeak {
        /// The channel.
        channel: String,
        /// As the header says.
        stated: f64,
        /// As it is.
        found: f64,
        /// The unit of both.
        unit: &'static str,
    },
    /// A channel is to be chosen.
    #[error(
        "{}the file has {} channels ({}): name one, or give its number",
        given.as_ref().map(|name| format!("there is no channel \"{}\": ", shown(name))).unwrap_or_default(), names.len(), listed(names)
    )]
    Channels {
        /// The name asked for.
        given: Option<String>,
        /// The names there are.
        names: Vec<String>,
    },
    /// Two components do not begin at one time.
    #[error("the {second} component begins {later_s} s after the {first}: cut both to one time before")]
    Starts {
        /// One component.
        first: &'static str,
        /// Another.
        second: &'static str,
        /// How much later it begins, s.
        later_s: f64,
    },
    /// The channels do not point so that x, y and z follow.
    #[error("{why}: give files as x=FILE, y=FILE instead")]
    Orientation {
        /// What is missing.
        why: String,
    },
    /// The file of a station is refused.
    #[error(transparent)]
    Seismic(#[from] SeismicError),
    /// The text in columns is refused.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// The samples make no motion.
    #[error(transparent)]
    Signal(#[from] SignalError),
}
