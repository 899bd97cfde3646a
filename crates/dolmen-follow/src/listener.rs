//! Who hears what comes of each file.

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
    /// What the file is called.
    pub file: &'a str,
    /// What it gave.
    pub taken: &'a Taken,
    /// What the history says of it.
    pub verdict: &'a Verdict,
    /// Open alarms of the structure.
    pub open_alarms: usize,
    /// That its shapes jumped while its frequencies did not: a sensor was turned, moved or exchanged.
    pub sensors: Option<&'a SensorChange>,
}

/// A file that cannot be read.
#[derive(Clone, Copy, Debug)]
pub struct Quarantined<'a> {
    /// What it is called.
    pub file: &'a str,
    /// Where it lies now.
    pub place: &'a str,
    /// Why.
    pub why: &'a Both,
}

/// Who hears what comes of each file: a terminal, a service.
pub trait Listener {
    /// Whether to end once what is under way is stored.
    fn is_asked_to_stop(&self) -> bool;

    /// A text beside a file in quarantine, in the language of the user.
    fn text_of(&self, why: &Both) -> String;

    /// Files of this folder are taken for the structure, with the settings of this survey.
    fn begins(&self, folder: &Path, structure: &str, survey: &str);

    /// A record was stored and judged.
    ///
    /// # Errors
    /// It cannot be said.
    fn record(&self, record: &FollowedRecord<'_>) -> Result<()>;

    /// A file holds the same bytes as a record that the structure has under another name.
    fn again(&self, file: &str, known_as: &str);

    /// A file cannot be read and was moved.
    ///
    /// # Errors
    /// It cannot be said.
    fn quarantined(&self, file: &Quarantined<'_>) -> Result<()>;

    /// Something failed, and the next round tries again.
    fn complain(&self, fault: &anyhow::Error);

    /// So many files were still being written at the end.
    fn still_written(&self, files: usize);
}
