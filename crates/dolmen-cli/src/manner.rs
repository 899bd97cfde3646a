//! What holds for every verb, whatever it does.

use crate::cli_language::size;
use clap::Args;

/// Flags of every verb.
#[derive(Clone, Debug, Args)]
pub(crate) struct Manner {
    /// Print results as JSON: keys are the fields' names, values in SI, units in the names
    #[arg(long, global = true)]
    pub(crate) json: bool,
    /// Print no progress and no notes, only results
    #[arg(long, short, global = true)]
    pub(crate) quiet: bool,
    /// Replace files that Dolmen did not write; those that are read or that a project names are never replaced
    #[arg(long, global = true)]
    pub(crate) force: bool,
    /// Let project files name files outside their folder; only for project files that you trust
    #[arg(long, global = true)]
    pub(crate) allow_outside: bool,
    /// Read files up to this size, as in "12 GB", instead of the limit of each kind
    #[arg(long, global = true, value_name = "SIZE", value_parser = size)]
    pub(crate) largest_file: Option<u64>,
    /// Do what is asked for however long it takes
    #[arg(long, global = true)]
    pub(crate) yes: bool,
}

impl Manner {
    /// Most bytes that are read of a file of some kind.
    pub(crate) fn most(&self, of_the_kind: u64) -> u64 {
        self.largest_file.unwrap_or(of_the_kind)
    }
}
