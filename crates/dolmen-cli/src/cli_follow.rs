//! Arguments of `dolmen watch --follow`.

use crate::cli_language::positive;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(next_help_heading = "Records as they come")]
pub(crate) struct Follow {
    /// Take the record files that come into this folder: identify each as the latest survey of the structure was, store it once, judge it against the
    /// history; until Ctrl-C or SIGTERM
    #[arg(long, value_name = "DIR", group = "from_store", conflicts_with = "all")]
    pub(crate) follow: Option<PathBuf>,
    /// The structure of the store; may be left out where there is one
    #[arg(long, value_name = "NAME", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) structure: Option<String>,
    /// Take what is there and end, as for cron
    #[arg(long, requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) once: bool,
    /// Look at the folder so often, s
    #[arg(long, value_name = "S", requires = "follow", conflicts_with_all = ["project", "all"], default_value_t = 10.0, value_parser = positive)]
    pub(crate) every: f64,
    /// A file is finished once its size and time have not changed for so long, s: longer than the longest pause of what writes it
    #[arg(long, value_name = "S", requires = "follow", conflicts_with_all = ["project", "all"], default_value_t = 10.0, value_parser = positive)]
    pub(crate) rest: f64,
    /// Move files that are stored into this folder; without it they stay where they are
    #[arg(long, value_name = "DIR", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) taken: Option<PathBuf>,
    /// Move files that cannot be read into this folder, each with a text that says why; DIR/quarantine without it
    #[arg(long, value_name = "DIR", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) quarantine: Option<PathBuf>,
    /// Temperature of the air over time, TOA5 or CSV with a time and values in each row: that of a record's time becomes temperature_c of its survey; read
    /// again each time
    #[arg(long, value_name = "FILE", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) temperature: Option<PathBuf>,
    /// Its column, where it has several
    #[arg(long, value_name = "NAME", requires = "temperature")]
    pub(crate) temperature_column: Option<String>,
    /// Write frequencies, alarms and counts into this text file for Prometheus each time the folder was looked at
    #[arg(long, value_name = "FILE", requires = "follow", conflicts_with_all = ["project", "all"])]
    pub(crate) metrics: Option<PathBuf>,
}
