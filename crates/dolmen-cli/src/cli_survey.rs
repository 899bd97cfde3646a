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
    /// The store: a file, made by the first add, with its raw files in FILE.files beside it; or a database, postgresql://ROLE@HOST/DATABASE; else
    /// DOLMEN_STORE
    #[arg(long, value_name = "FILE|URL", global = true)]
    pub(crate) store: Option<String>,
    /// Who does it, for the log; else the name of the user
    #[arg(long, value_name = "NAME", global = true)]
    pub(crate) who: Option<String>,
    /// How long to wait for another process that writes, s
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
    /// A structure as a project folder, or the whole store as a store of its own
    Export(Export),
    /// Take over all of another store
    Import(Import),
    /// Compare every file with its hash and every row with its name; exit status 1 where something is wrong
    Verify,
    /// Take a structure out of use: a mark, nothing is deleted
    Remove(Remove),
}

#[derive(Debug, Args)]
pub(crate) struct Add {
    /// Project files, or folders that hold project.toml
    #[arg(required = true)]
    pub(crate) projects: Vec<PathBuf>,
    /// Name of the structure in the store; that of the project without it
    #[arg(long, value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// Store only what was given: identify no modes
    #[arg(long)]
    pub(crate) without_modes: bool,
}

#[derive(Debug, Args)]
pub(crate) struct List {
    /// Part of a name, in any case; all without it
    pub(crate) words: Option<String>,
    /// One row a survey instead of a structure
    #[arg(long, conflicts_with = "geojson")]
    pub(crate) surveys: bool,
    /// A table (CSV)
    #[arg(long, conflicts_with = "geojson")]
    pub(crate) csv: bool,
    /// Points for a map (GeoJSON): the structures whose site has latitude_deg and longitude_deg
    #[arg(long)]
    pub(crate) geojson: bool,
    /// Those out of use as well
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
    /// The structure; the whole store without it
    pub(crate) name: Option<String>,
    /// Folder to make for the project; of a whole store, the file to make
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
    /// Why, for the log
    #[arg(long, value_name = "TEXT", default_value = "")]
    pub(crate) why: String,
    /// Take it back into use
    #[arg(long)]
    pub(crate) undo: bool,
}
