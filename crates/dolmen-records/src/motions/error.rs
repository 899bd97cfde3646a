//! Why a motion cannot be read.

use crate::records::RecordError;
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
    /// A file of velocities or displacements.
    #[error(
        "{}the file holds {what}, not accelerations: take the file of accelerations (of PEER, the one that ends in AT2)",
        if *line > 0 { format!("line {line}: ") } else { String::new() }
    )]
    Quantity {
        /// The line; 0 in a file without lines.
        line: usize,
        /// "velocities", "displacements".
        what: &'static str,
    },
    /// A unit that a header names is not known.
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
    #[error("the file has {} columns of numbers ({}): name the one to read as channel", names.len(), names.join(", "))]
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
    /// A line is not what the format has there.
    #[error("line {line}: \"{text}\" is not {wanted}: the file was cut or edited; download it again")]
    Line {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
        /// What must stand there.
        wanted: &'static str,
    },
    /// The text ends within its header or between its parts.
    #[error("the file ends before line {line}, which must be {wanted}: it was cut short; download it again")]
    EndsEarly {
        /// The line that is missing.
        line: usize,
        /// What it must be.
        wanted: &'static str,
    },
    /// A header does not say something.
    #[error(
        "the header ({lines} lines) does not give {label}: the file was cut or edited; download it again"
    )]
    Missing {
        /// What is missing.
        label: &'static str,
        /// Lines that were looked through.
        lines: usize,
    },
    /// The file is not as long as its headers say.
    #[error(
        "the {format} file has {found} bytes, but its header says {stated}: it was cut short or edited; download it again"
    )]
    Bytes {
        /// The format.
        format: &'static str,
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// The header of a SAC file says something that is no motion.
    #[error("the SAC header says {found}, but {what}")]
    Sac {
        /// The field and what it must be.
        what: &'static str,
        /// Its value.
        found: f64,
    },
    /// A record of a miniSEED file is damaged.
    #[error("the miniSEED record at byte {at}: {what}; download the file again")]
    Damaged {
        /// Where the record begins, bytes from 0.
        at: u64,
        /// What is wrong.
        what: &'static str,
    },
    /// The samples of a miniSEED record are coded in a way that is not read.
    #[error(
        "the miniSEED record at byte {at} has encoding {encoding}, but only 16 and 32 bit integers (1, 3), floats (4, 5) and Steim \
         1 and 2 (10, 11) are read: convert it before"
    )]
    Encoding {
        /// Where the record begins, bytes from 0.
        at: u64,
        /// The code.
        encoding: u8,
    },
    /// Records of a channel do not follow one another.
    #[error(
        "channel {channel}: a record begins {found_s} s after the first, but the samples before it end at {expected_s} s: there \
         is a gap or an overlap; cut the file there"
    )]
    Gap {
        /// The channel.
        channel: String,
        /// Where it should begin, s.
        expected_s: f64,
        /// Where it begins, s.
        found_s: f64,
    },
    /// Raw counts of a recorder that the file does not convert.
    #[error(
        "line {line}: the numbers are raw counts of the recorder (V0): take the V1 or V2 file, which holds accelerations"
    )]
    Counts {
        /// The line.
        line: usize,
    },
    /// The factor is none.
    #[error("factor is {given}, but must be a finite number other than 0")]
    Factor {
        /// The value given.
        given: f64,
    },
    /// A sample is NaN or infinite.
    #[error(
        "channel \"{channel}\": sample {sample} (from 0) is not a finite number: cut the file there, or leave the channel out"
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
         were damaged or changed; download the file again, or say stated_peak = ignore if you know why"
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
        given.as_ref().map(|name| format!("there is no channel \"{name}\": ")).unwrap_or_default(), names.len(), names.join(", ")
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
