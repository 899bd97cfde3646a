//! Errors of studies.

use dolmen_words::message::Both;

/// Why a study cannot be run, or its results cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub enum StudyError {
    /// There is no such study.
    NoSuchStudy {
        /// The name.
        name: String,
        /// Names of the known ones.
        known: String,
    },
    /// There is no such study in a file.
    NoStudyIn {
        /// The name.
        name: String,
        /// The file.
        file: String,
    },
    /// The file has no study.
    NoStudy,
    /// The structure falls by itself.
    StudyOfWhatFalls {
        /// λ.
        load_factor: f64,
    },
    /// A study of a survey, which has no model.
    SurveyStudied,
    /// A study has no motion.
    StudyWithoutMotion,
    /// A study without sizes of shaking.
    StudyWithoutScan,
    /// An earlier motion in a study of buildings.
    AfterOfBuilding,
    /// An earlier motion in a study without shaking.
    AfterWithoutScan,
    /// A study has too many scans.
    StudyTooLarge {
        /// Their number.
        scans: usize,
        /// The largest number of scans.
        most: usize,
    },
    /// The maps of harmonic motions have too many points.
    MapsTooLarge {
        /// Their number.
        points: usize,
        /// The largest number.
        most: usize,
    },
    /// Samples were requested without uncertain inputs.
    StudySamplesNothing {
        /// The samples asked for.
        samples: usize,
    },
    /// A map of harmonic motions was requested for a kind without one.
    HarmonicOfOther,
    /// The inputs of every run were refused.
    EveryRunRefused {
        /// The reason for the first run.
        why: Both,
    },
    /// A journal is of another study, or of another state of this one.
    OtherJournal {
        /// The journal.
        shown: String,
        /// The difference.
        difference: Both,
    },
    /// Journals contain the same run with different results.
    RunTwice {
        /// The journals.
        shown: String,
        /// The scan, from 1.
        scan: usize,
        /// The factor on its motion.
        scale: f64,
    },
    /// A study for the score without pagodas of six factors.
    StudyWithoutPagoda {
        /// The study.
        name: String,
    },
    /// A study named in a table that has no results.
    StudyNotRun {
        /// The study.
        study: String,
        /// The project file.
        file: String,
    },
    /// A project has results of several studies.
    SeveralStudies {
        /// The studies.
        names: String,
    },
}
