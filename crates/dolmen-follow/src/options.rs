//! What is followed.

use dolmen_folder::Access;
use dolmen_store::Place;
use std::path::PathBuf;
use std::time::Duration;

/// What is followed, and how.
#[derive(Clone, Debug)]
pub struct Follow {
    /// The folder into which files come.
    pub folder: PathBuf,
    /// The store.
    pub store: Place,
    /// How long another process may write before the store counts as busy.
    pub wait: Duration,
    /// Who stores.
    pub who: String,
    /// What may be read.
    pub access: Access,
    /// The structure of the store; may be left out where there is one.
    pub structure: Option<String>,
    /// Take what is there and end.
    pub once: bool,
    /// How often the folder is looked at.
    pub every: Duration,
    /// How long a file must not have changed.
    pub rest: Duration,
    /// Where files go that are stored; `None` leaves them.
    pub taken: Option<PathBuf>,
    /// Where files go that cannot be read; `quarantine` in the folder without it.
    pub quarantine: Option<PathBuf>,
    /// A log of the temperature of the air.
    pub temperature: Option<PathBuf>,
    /// Its column, where it has several.
    pub temperature_column: Option<String>,
    /// A text file for Prometheus.
    pub metrics: Option<PathBuf>,
    /// A program that is run for each alarm.
    pub on_alarm: Option<PathBuf>,
}
