//! Options of `follow`.

use dolmen_folder::Access;
use dolmen_store::Place;
use std::path::PathBuf;
use std::time::Duration;

/// Options of `follow`.
#[derive(Clone, Debug)]
pub struct Follow {
    /// The watched folder.
    pub folder: PathBuf,
    /// The store.
    pub store: Place,
    /// How long to wait while another process writes to the store.
    pub wait: Duration,
    /// Name of the person that the log of the store shows.
    pub who: String,
    /// Which files may be read.
    pub access: Access,
    /// The structure in the store; `None` if the store has only one.
    pub structure: Option<String>,
    /// Process the existing files, then stop.
    pub once: bool,
    /// Interval between looks at the folder.
    pub every: Duration,
    /// How long a file must be unchanged before it is read.
    pub rest: Duration,
    /// Folder to which stored files are moved; `None` leaves them where they are.
    pub taken: Option<PathBuf>,
    /// Folder for files that cannot be read; `None` means `quarantine` in the watched folder.
    pub quarantine: Option<PathBuf>,
    /// A log of the air temperature.
    pub temperature: Option<PathBuf>,
    /// The column of the air temperature, if the log has several.
    pub temperature_column: Option<String>,
    /// A text file of metrics for Prometheus.
    pub metrics: Option<PathBuf>,
    /// A program to run for each alarm.
    pub on_alarm: Option<PathBuf>,
}
