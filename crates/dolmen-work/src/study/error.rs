//! Why a study cannot be run, or its runs cannot be used.

use dolmen_words::message::Both;

/// Why a study cannot be run, or its runs cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub enum StudyError {
    /// There is no such study.
    NoSuchStudy {
        /// The name.
        name: String,
        /// Those there are.
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
    /// What is to be studied falls by itself.
    StudyOfWhatFalls {
        /// λ.
        load_factor: f64,
    },
    /// A survey holds nothing to study.
    SurveyStudied,
    /// A study has no motion.
    StudyWithoutMotion,
    /// A study does not say how the shaking grows.
    StudyWithoutScan,
    /// A motion acts before the runs of a building.
    AfterOfBuilding,
    /// A motion acts before the runs of a study that shakes nothing.
    AfterWithoutScan,
    /// A study has too many scans.
    StudyTooLarge {
        /// How many.
        scans: usize,
        /// The largest number of scans.
        most: usize,
    },
    /// Maps of harmonic motions have too many points.
    MapsTooLarge {
        /// All of them.
        points: usize,
        /// The largest number.
        most: usize,
    },
    /// Samples are asked for, but nothing scatters.
    StudySamplesNothing {
        /// The samples asked for.
        samples: usize,
    },
    /// A map of harmonic motions is asked of what has none.
    HarmonicOfOther,
    /// The inputs of every run were refused.
    EveryRunRefused {
        /// Why those of the first were.
        why: Both,
    },
    /// A journal is of another study, or of another state of this one.
    OtherJournal {
        /// The journal.
        shown: String,
        /// What differs.
        difference: Both,
    },
    /// Journals hold one run with different results.
    RunTwice {
        /// The journals.
        shown: String,
        /// The scan, from 1.
        scan: usize,
        /// The factor on its motion.
        scale: f64,
    },
    /// A study for the score has no pagodas of six factors.
    StudyWithoutPagoda {
        /// The study.
        name: String,
    },
    /// A study that a table names has no results.
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
