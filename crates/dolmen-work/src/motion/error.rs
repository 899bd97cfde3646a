//! Why a motion that is asked for cannot be had.

use dolmen::signal::Component;
use dolmen_words::message::Both;

/// Why a motion that is asked for cannot be had.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionRequestError {
    /// There is no such motion.
    NoSuchMotion {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// There is no such motion among those that Dolmen carries.
    NoBuiltInMotion {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// No motion is asked for.
    NoMotion {
        /// Those there are.
        known: String,
    },
    /// A flag that says how files are read, and there are none: the motion is carried along.
    OfFilesNotCarried {
        /// The flag, without the dashes.
        flag: &'static str,
        /// The motion.
        name: String,
    },
    /// A flag that says how files are read, and there are none: the motion is of a survey, whose record the project says how to read.
    OfFilesNotSurvey {
        /// The flag, without the dashes.
        flag: &'static str,
        /// The motion.
        name: String,
    },
    /// A survey's motion is asked for without its project.
    SurveyWithoutProject {
        /// The survey.
        name: String,
    },
    /// A survey has no record with a measured ground.
    NoMeasuredGround {
        /// The survey.
        survey: String,
    },
    /// An input of a survey's record is no acceleration along an axis.
    NoGroundAcceleration {
        /// The survey.
        survey: String,
        /// The channel.
        channel: String,
    },
    /// A flag that says how files are read, and there are none: the motion is made.
    OfFilesNotMade {
        /// The flag, without the dashes.
        flag: &'static str,
    },
    /// What is left after all changes is no ground motion.
    Acts {
        /// Its peak, g.
        peak_g: f64,
        /// The largest allowed, g.
        most_g: f64,
    },
    /// A factor that is typed for all components is not above 0.
    ScaleTyped {
        /// It.
        given: f64,
    },
    /// A peak that is typed is not above 0.
    PeakTyped {
        /// It.
        given: String,
    },
    /// A pulse is too short or too long for its time step.
    PeriodTyped {
        /// Its period, s.
        given_s: f64,
        /// The shortest, s.
        least_s: f64,
        /// The longest, s.
        most_s: f64,
    },
    /// Two files are of one component.
    ComponentTwice {
        /// The component.
        component: Component,
    },
    /// A column is of a component that has no file.
    ColumnWithoutFile {
        /// The component.
        component: Component,
        /// The column.
        column: String,
    },
    /// A text is no acceleration.
    NoAcceleration {
        /// The text.
        given: String,
    },
    /// An acceleration has no unit.
    AccelerationWithoutUnit {
        /// The text.
        given: String,
        /// Its number.
        value: f64,
    },
    /// A site is no ground of Eurocode 8.
    NoEurocodeGround {
        /// The text.
        given: String,
    },
    /// A site is none of KDS 17 10 00.
    NoKoreanSite {
        /// The text.
        given: String,
    },
    /// Nothing is there to be matched.
    NothingToMatch,
    /// Several channels could be matched.
    SeveralToMatch,
    /// A range of periods cannot be.
    Range {
        /// The shorter, s.
        least_s: f64,
        /// The longer, s.
        most_s: f64,
        /// The shortest allowed, s.
        allowed_least_s: f64,
        /// The longest allowed, s.
        allowed_most_s: f64,
    },
    /// No file of a suite holds a horizontal record.
    NoRecords {
        /// Files that were looked at.
        files: usize,
    },
    /// No file of a suite can be used.
    NoneReadable {
        /// Files that were looked at.
        files: usize,
        /// The first.
        file: String,
        /// Why it was refused.
        why: Both,
    },
}
