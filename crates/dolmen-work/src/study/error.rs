//! Why a study cannot be run, or its runs cannot be used.

use crate::known::known_beside;
use thiserror::Error;

/// Why a study cannot be run, or its runs cannot be used.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum StudyError {
    /// There is no such study.
    #[error("there is no study \"{name}\": the file has {}", known_beside(name, known))]
    NoSuchStudy {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// There is no such study in a file.
    #[error("there is no study \"{name}\" in {file}")]
    NoStudyIn {
        /// The name.
        name: String,
        /// The file.
        file: String,
    },
    /// The file has no study.
    #[error("the file has no study: write one as [study.NAME]; docs/study.md has its keys")]
    NoStudy,
    /// What is to be studied falls by itself.
    #[error(
        "it does not stand under its own weight (load factor {load_factor:.3}): no shaking is needed to fell it, and a capacity against \
         shaking would say nothing. `dolmen check` says what it lacks"
    )]
    StudyOfWhatFalls {
        /// λ.
        load_factor: f64,
    },
    /// A survey holds nothing to study.
    #[error("a survey holds no structure that could be studied: kind is stack, frame, chain or building")]
    SurveyStudied,
    /// A study has no motion.
    #[error(
        "the study names no motion: give motions = [\"el-centro-1940-ns\"] or artificial = {{ count = 22 }}"
    )]
    StudyWithoutMotion,
    /// A study does not say how the shaking grows.
    #[error("the study says not how the shaking grows: give scale or peak")]
    StudyWithoutScan,
    /// A study has too many scans.
    #[error("the study has more than {most} scans: vary less, or draw fewer samples")]
    StudyTooLarge {
        /// The largest number of scans.
        most: usize,
    },
    /// Samples are asked for, but nothing scatters.
    #[error(
        "samples is {samples}, but no input has a cov: all samples would be the same. Write joint.friction = {{ value = 0.6, cov = 0.1 }}, or \
         leave samples out"
    )]
    StudySamplesNothing {
        /// The samples asked for.
        samples: usize,
    },
    /// A map of harmonic motions is asked of what has none.
    #[error("harmonic and release are for frames and chains")]
    HarmonicOfOther,
    /// The inputs of every run were refused.
    #[error("the inputs of every run were refused: {why}")]
    EveryRunRefused {
        /// Why those of the first were.
        why: String,
    },
    /// A journal is of another study, or of another state of this one.
    #[error(
        "{shown} belongs to another state of this study: {difference}. Name another folder with -o, or give --restart to throw its runs away"
    )]
    OtherJournal {
        /// The journal.
        shown: String,
        /// What differs.
        difference: String,
    },
    /// Journals hold one run with different results.
    #[error(
        "{shown}: the run of scan {scan} at scale {scale} is there twice with different results: they come from programs that do not compute \
         alike; start anew with --restart"
    )]
    RunTwice {
        /// The journals.
        shown: String,
        /// The scan, from 1.
        scan: usize,
        /// The factor on its motion.
        scale: f64,
    },
    /// A study for the score has no pagodas of six factors.
    #[error("study \"{name}\" has no pagoda of six factors: write pagoda = {{ storeys = 5, … }}")]
    StudyWithoutPagoda {
        /// The study.
        name: String,
    },
    /// A study that a table names has no results.
    #[error(
        "study \"{study}\" of {file} has no results beside the project file, or they are of another state of it: run dolmen study"
    )]
    StudyNotRun {
        /// The study.
        study: String,
        /// The project file.
        file: String,
    },
    /// A project has results of several studies.
    #[error("it has results of several studies ({names}): name one in the column study")]
    SeveralStudies {
        /// The studies.
        names: String,
    },
}
