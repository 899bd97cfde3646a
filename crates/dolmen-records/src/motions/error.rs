//! Why a motion cannot be read.

use crate::records::RecordError;
use crate::seismic::SeismicError;
use crate::sheet_error::SheetError;
use dolmen::signal::SignalError;
use dolmen_words::message::Both;

/// Why the bytes of a file are not a ground motion. Each variant gives the place in the file and the remedy. Lines are counted from 1.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionError {
    /// No file is given.
    NoFile,
    /// One component is refused.
    Component {
        /// "x", "y" or "z".
        component: &'static str,
        /// Reason.
        fault: Box<MotionError>,
    },
    /// One channel of a file of several is refused.
    Channel {
        /// Its name.
        channel: String,
        /// Reason.
        fault: Box<MotionError>,
    },
    /// The unit of the numbers is unknown.
    NoUnit,
    /// No response covers the channel at its time.
    NoResponse {
        /// The channel.
        channel: String,
        /// The channels with a response.
        known: Vec<String>,
    },
    /// A response and a factor, which both give the value of a count.
    ResponseAndFactor {
        /// The factor.
        factor: f64,
    },
    /// The unit is not one of acceleration.
    NotAcceleration {
        /// The unit.
        given: String,
    },
    /// The given unit contradicts the file.
    UnitDisagrees {
        /// The unit given.
        given: &'static str,
        /// The unit of the file.
        found: &'static str,
    },
    /// The peak is not that of an earthquake.
    Peak {
        /// The peak read, g.
        peak_g: f64,
        /// The smallest allowed, g.
        least_g: f64,
        /// The largest allowed, g.
        most_g: f64,
        /// The unit that was used.
        unit: &'static str,
        /// Units in which it would be plausible.
        suggested: Vec<&'static str>,
    },
    /// The given time step contradicts the file.
    StepDisagrees {
        /// The step given, s.
        given: f64,
        /// Time step in the file, s.
        found: f64,
    },
    /// Time stamps may be rounded, or a sample is lost.
    CoarseStamps {
        /// The line.
        line: usize,
        /// Its step, s.
        step_s: f64,
        /// The step before, s.
        step_before_s: f64,
        /// Value of the last printed digit, s.
        resolution_s: f64,
    },
    /// Time stamps scatter.
    Jitter {
        /// The line.
        line: usize,
        /// Its time stamp, s.
        stamp_s: f64,
        /// Its step, s.
        step_s: f64,
        /// The even step, s.
        even_step_s: f64,
    },
    /// Time stamps are refused, with advice on a sampling rate.
    OfRate {
        /// Reason.
        fault: Box<RecordError>,
    },
    /// The given time step is not allowed.
    Step {
        /// The step given, s.
        given: f64,
    },
    /// Two components are sampled differently.
    TimeSteps {
        /// One component.
        first: &'static str,
        /// Its step, s.
        first_s: f64,
        /// The other component.
        second: &'static str,
        /// Its step, s.
        second_s: f64,
    },
    /// Two components are not equally long.
    Lengths {
        /// One component.
        first: &'static str,
        /// Its samples.
        first_samples: usize,
        /// The other component.
        second: &'static str,
        /// Its samples.
        second_samples: usize,
    },
    /// The factor is not allowed.
    Factor {
        /// The value given.
        given: f64,
    },
    /// A sample is NaN or infinite.
    NotFinite {
        /// The channel.
        channel: String,
        /// The sample, from 0.
        sample: usize,
    },
    /// A sample has a code for a missing value.
    MissingCode {
        /// Its line, if the file has one for each sample.
        line: Option<usize>,
        /// Its time from the first sample, s.
        at_s: f64,
        /// The code, as written.
        value: f64,
        /// Number of samples with it.
        count: usize,
    },
    /// A single sample is several times beyond every other.
    Spike {
        /// Its line, if the file has one for each sample.
        line: Option<usize>,
        /// Its time from the first sample, s.
        at_s: f64,
        /// The sample, in the unit of the file.
        value: f64,
        /// Largest of the others.
        others: f64,
    },
    /// A vertical record is given for a horizontal direction.
    Vertical {
        /// "x" or "y".
        component: &'static str,
    },
    /// A record from a borehole is given to shake a structure.
    Borehole {
        /// "x", "y" or "z".
        component: &'static str,
    },
    /// Two components are of different stations or earthquakes.
    Origins {
        /// One component.
        first: &'static str,
        /// Its station or earthquake.
        first_of: String,
        /// The other component.
        second: &'static str,
        /// Its station or earthquake.
        second_of: String,
    },
    /// The columns of a table measure different quantities, or are in different units.
    ColumnsDiffer {
        /// One column.
        column: String,
        /// Its unit.
        found: &'static str,
        /// Another column.
        other: String,
        /// Its unit.
        unit: &'static str,
    },
    /// The peak of the samples contradicts the header.
    StatedPeak {
        /// The channel.
        channel: String,
        /// Peak in the header.
        stated: f64,
        /// Peak of the samples.
        found: f64,
        /// The unit of both.
        unit: &'static str,
    },
    /// No column of a text contains the time, and no step is given.
    NoStep {
        /// The columns there are.
        names: Vec<String>,
    },
    /// A channel must be chosen.
    Channels {
        /// The requested name.
        given: Option<String>,
        /// The names there are.
        names: Vec<String>,
    },
    /// Two components have different start times.
    Starts {
        /// One component.
        first: &'static str,
        /// The other component.
        second: &'static str,
        /// Delay of its start, s.
        later_s: f64,
    },
    /// The directions of the channels do not determine x, y and z.
    Orientation {
        /// What is missing.
        why: Both,
    },
    /// Two directions have the samples of one record.
    SameRecord {
        /// The direction given first.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// The file of a station is refused.
    Seismic(SeismicError),
    /// The workbook is refused.
    Workbook {
        /// Reason.
        why: SheetError,
    },
    /// The text in columns is refused.
    Record(RecordError),
    /// The samples do not form a valid motion.
    Signal(SignalError),
}
