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
        /// Names of the known ones.
        known: String,
    },
    /// There is no such built-in motion.
    NoBuiltInMotion {
        /// The name.
        name: String,
        /// Names of the known ones.
        known: String,
    },
    /// No motion was requested.
    NoMotion {
        /// Names of the known ones.
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
    /// The rotation angle on the command line exceeds a full turn.
    TurnTyped {
        /// The angle, degrees.
        given_deg: f64,
    },
    /// A rotation of channels whose directions are not given.
    TurnOfChannels {
        /// Number of channels.
        channels: usize,
    },
    /// A factor for all components that is not positive.
    ScaleTyped {
        /// The factor.
        given: f64,
    },
    /// A peak that is not positive.
    PeakTyped {
        /// The peak.
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
        /// The number.
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
    /// There are several channels, of which one must be chosen for a match.
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
        /// Number of files examined.
        files: usize,
    },
    /// No file of a suite is usable.
    NoneReadable {
        /// Number of files examined.
        files: usize,
        /// The first file.
        file: String,
        /// Reason of its refusal.
        why: Both,
    },
}
