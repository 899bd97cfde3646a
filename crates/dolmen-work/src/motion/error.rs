//! Errors of a requested motion.

use dolmen::signal::Component;
use dolmen_words::message::Both;

/// Why a requested motion is not available.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionRequestError {
    /// There is no such motion.
    NoSuchMotion {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// There is no such built-in motion.
    NoBuiltInMotion {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// No motion was requested.
    NoMotion {
        /// Those there are.
        known: String,
    },
    /// A flag for reading files with a built-in motion.
    OfFilesNotCarried {
        /// The flag, without the dashes.
        flag: &'static str,
        /// The motion.
        name: String,
    },
    /// A flag for reading files with a survey's motion, whose record the project describes.
    OfFilesNotSurvey {
        /// The flag, without the dashes.
        flag: &'static str,
        /// The motion.
        name: String,
    },
    /// A survey's motion was requested without a project.
    SurveyWithoutProject {
        /// The survey.
        name: String,
    },
    /// A survey without a record of the ground.
    NoMeasuredGround {
        /// The survey.
        survey: String,
    },
    /// An input of a survey's record that is not an acceleration along an axis.
    NoGroundAcceleration {
        /// The survey.
        survey: String,
        /// The channel.
        channel: String,
    },
    /// A flag for reading files with a made motion.
    OfFilesNotMade {
        /// The flag, without the dashes.
        flag: &'static str,
    },
    /// The motion after all changes is not possible for the ground.
    Acts {
        /// Its peak, g.
        peak_g: f64,
        /// The largest allowed, g.
        most_g: f64,
    },
    /// A turn that is typed turns more than once about.
    TurnTyped {
        /// It, degrees.
        given_deg: f64,
    },
    /// A factor for all components that is not positive.
    ScaleTyped {
        /// It.
        given: f64,
    },
    /// A peak that is not positive.
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
    /// Two files for one component.
    ComponentTwice {
        /// The component.
        component: Component,
    },
    /// A column for a component without a file.
    ColumnWithoutFile {
        /// The component.
        component: Component,
        /// The column.
        column: String,
    },
    /// A text that is not an acceleration.
    NoAcceleration {
        /// The text.
        given: String,
    },
    /// An acceleration without a unit.
    AccelerationWithoutUnit {
        /// The text.
        given: String,
        /// Its number.
        value: f64,
    },
    /// A site that is not a ground type of Eurocode 8.
    NoEurocodeGround {
        /// The text.
        given: String,
    },
    /// A site that is not one of KDS 17 10 00.
    NoKoreanSite {
        /// The text.
        given: String,
    },
    /// There is no channel to match.
    NothingToMatch,
    /// Several channels, of which one must be chosen for a match.
    SeveralToMatch,
    /// A range of periods that is not allowed.
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
    /// No file of a suite has a horizontal record.
    NoRecords {
        /// Files that were looked at.
        files: usize,
    },
    /// No file of a suite is usable.
    NoneReadable {
        /// Files that were looked at.
        files: usize,
        /// The first.
        file: String,
        /// Why it was refused.
        why: Both,
    },
}
