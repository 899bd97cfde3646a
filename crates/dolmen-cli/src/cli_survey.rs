//! Arguments of `dolmen survey`.

use crate::cli_language::positive;
use clap::{Args, Subcommand};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(crate) struct Survey {
    #[command(subcommand)]
    pub(crate) action: SurveyAction,
    #[command(flatten)]
    pub(crate) place: StoreWhere,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Store")]
pub(crate) struct StoreWhere {
    /// The store: a file, created by the first add, with its raw files in FILE.files beside it; or a database,
    /// postgresql://ROLE@HOST/DATABASE [default: DOLMEN_STORE]
    #[arg(long, value_name = "FILE|URL", global = true)]
    pub(crate) store: Option<String>,
    /// Name of the person, for the log; by default the user name
    #[arg(long, value_name = "NAME", global = true)]
    pub(crate) who: Option<String>,
    /// How long to wait while another process writes, s
    #[arg(long, value_name = "S", global = true, default_value_t = 10.0, value_parser = positive)]
    pub(crate) wait: f64,
}

#[derive(Debug, Subcommand)]
pub(crate) enum SurveyAction {
    /// Store projects with their surveys and record files, and the modes of the records
    Add(Add),
    /// Structures of the store, or their surveys
    List(List),
    /// A structure with its surveys, states and log
    Show(Show),
    /// A structure as a project folder, or the whole store as a separate store
    Export(Export),
    /// Copy everything from another store
    Import(Import),
    /// Compare every file with its hash and every row with its name; exit status 1 if something is wrong
    Verify,
    /// Mark a structure as out of use; nothing is deleted
    Remove(Remove),
}

#[derive(Debug, Args)]
pub(crate) struct Add {
    /// Project files, or folders that hold project.toml
    #[arg(required = true)]
    pub(crate) projects: Vec<PathBuf>,
    /// Name of the structure in the store; by default that of the project
    #[arg(long, value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// Store only the given files: identify no modes
    #[arg(long)]
    pub(crate) without_modes: bool,
}

#[derive(Debug, Args)]
pub(crate) struct List {
    /// Part of a name, ignoring case; by default all
    pub(crate) words: Option<String>,
    /// One row per survey instead of per structure
    #[arg(long, conflicts_with = "geojson")]
    pub(crate) surveys: bool,
    /// A table (CSV)
    #[arg(long, conflicts_with = "geojson")]
    pub(crate) csv: bool,
    /// Points for a map (GeoJSON): the structures whose site has latitude_deg and longitude_deg
    #[arg(long)]
    pub(crate) geojson: bool,
    /// Include structures out of use
    #[arg(long)]
    pub(crate) removed: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Show {
    /// The structure
    pub(crate) name: String,
    /// Only this survey
    #[arg(long, value_name = "NAME")]
    pub(crate) survey: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct Export {
    /// The structure; by default the whole store
    pub(crate) name: Option<String>,
    /// Folder to create for the project; for a whole store, the file to create
    #[arg(long, short, value_name = "DIR|FILE")]
    pub(crate) output: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct Import {
    /// The store to read: a file, or postgresql://…
    pub(crate) from: String,
}

#[derive(Debug, Args)]
pub(crate) struct Remove {
    /// The structure
    pub(crate) name: String,
    /// The reason, for the log
    #[arg(long, value_name = "TEXT", default_value = "")]
    pub(crate) why: String,
    /// Mark it as in use again
    #[arg(long)]
    pub(crate) undo: bool,
}
