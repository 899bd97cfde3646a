//! Arguments of `dolmen watch --follow`.

use crate::cli_language::positive;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(next_help_heading = "Records as they come")]
pub(crate) struct Follow {
    /// Watch this folder for record files until Ctrl-C or SIGTERM: identify each with the settings of the structure's latest survey, store
    /// it once, and judge it against the history
    #[arg(long, value_name = "DIR", group = "from_store", conflicts_with = "all")]
    pub(crate) follow: Option<PathBuf>,
    /// The structure in the store; not needed if the store has only one
    #[arg(long, value_name = "NAME", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) structure: Option<String>,
    /// Process the files that are there and stop, as for cron
    #[arg(long, requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) once: bool,
    /// Interval between looks at the folder, s
    #[arg(long, value_name = "S", requires = "follow", conflicts_with_all = ["project", "all"], default_value_t = 10.0, value_parser = positive)]
    pub(crate) every: f64,
    /// Read a file once its size and time have not changed for this long, s; choose more than the longest pause of the program that writes it
    #[arg(long, value_name = "S", requires = "follow", conflicts_with_all = ["project", "all"], default_value_t = 10.0, value_parser = positive)]
    pub(crate) rest: f64,
    /// Move stored files into this folder; by default they stay where they are
    #[arg(long, value_name = "DIR", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) taken: Option<PathBuf>,
    /// Move files that cannot be read into this folder, each with a text that gives the reason [default: DIR/quarantine]
    #[arg(long, value_name = "DIR", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) quarantine: Option<PathBuf>,
    /// Log of the air temperature, TOA5 or CSV with a time and values in each row: its value at the time of a record becomes the survey's
    /// temperature_c; read again each time
    #[arg(long, value_name = "FILE", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) temperature: Option<PathBuf>,
    /// Column of the air temperature, if the log has several
    #[arg(long, value_name = "NAME", requires = "temperature")]
    pub(crate) temperature_column: Option<String>,
    /// After each look at the folder, write frequencies, alarms and counts into this text file for Prometheus
    #[arg(long, value_name = "FILE", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) metrics: Option<PathBuf>,
}
