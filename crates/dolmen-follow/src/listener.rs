//! Receives the result of each file.

use anyhow::Result;
use dolmen::monitoring::SensorChange;
use dolmen_words::message::Both;
use dolmen_work::follow::{Taken, Verdict};
use std::path::Path;

/// A record that became a survey.
#[derive(Clone, Copy, Debug)]
pub struct FollowedRecord<'a> {
    /// The survey.
    pub survey: &'a str,
    /// Name of the file.
    pub file: &'a str,
    /// Result of reading and identifying it.
    pub taken: &'a Taken,
    /// Verdict of the history after this survey.
    pub verdict: &'a Verdict,
    /// Number of open alarms of the structure.
    pub open_alarms: usize,
    /// Set if the mode shapes changed but the frequencies did not: a sensor was turned, moved or
    /// exchanged.
    pub sensors: Option<&'a SensorChange>,
}

/// A file that cannot be read.
#[derive(Clone, Copy, Debug)]
pub struct Quarantined<'a> {
    /// Its name.
    pub file: &'a str,
    /// Its new path.
    pub place: &'a str,
    /// The reason.
    pub why: &'a Both,
}

/// Receives the result of each file: a terminal, a service.
pub trait Listener {
    /// Whether to stop after the current file is stored.
    fn is_asked_to_stop(&self) -> bool;

    /// The text to write beside a quarantined file, in the user's language.
    fn text_of(&self, why: &Both) -> String;

    /// Called once at the start: files of this folder become surveys of the structure, with the
    /// settings of this survey.
    fn begins(&self, folder: &Path, structure: &str, survey: &str);

    /// A record was stored and judged.
    ///
    /// # Errors
    /// If the result cannot be printed.
    fn record(&self, record: &FollowedRecord<'_>) -> Result<()>;

    /// A file has the same bytes as a stored record of the structure with another name.
    fn again(&self, file: &str, known_as: &str);

    /// A file cannot be read and was moved.
    ///
    /// # Errors
    /// If the result cannot be printed.
    fn quarantined(&self, file: &Quarantined<'_>) -> Result<()>;

    /// Something failed, and the next round tries again.
    fn complain(&self, fault: &anyhow::Error);

    /// Number of files that were still being written when following stopped.
    fn still_written(&self, files: usize);
}
