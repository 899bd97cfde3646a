//! What holds for every verb, whatever it does.

use crate::cli_language::{Language as Chosen, size, user_language};
use anyhow::Result;
use clap::Args;
use dolmen_folder::{Access, Found};
use dolmen_report::TextStyle;
use dolmen_words::{Language, print_names};
use std::path::Path;

/// Flags of every verb.
#[derive(Clone, Debug, Args)]
pub(crate) struct Manner {
    /// Print results as JSON: keys are the fields' names, values in SI, units in the names
    #[arg(long, global = true)]
    pub(crate) json: bool,
    /// Print all of an answer, not only what decides
    #[arg(long, global = true)]
    pub(crate) full: bool,
    /// Language of what is printed and drawn, else that of DOLMEN_LANGUAGE or of the system
    #[arg(long, global = true, value_enum)]
    pub(crate) language: Option<Chosen>,
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

/// Columns where no terminal says how many it has.
const COLUMNS: usize = 80;

impl Manner {
    /// The language of all that people read.
    pub(crate) fn language(&self) -> Language {
        match self.language {
            Some(Chosen::En) => Language::English,
            Some(Chosen::Ko) => Language::Korean,
            None => user_language(|name| std::env::var(name).ok()),
        }
    }

    /// How answers are printed.
    pub(crate) fn style(&self) -> TextStyle {
        let size = console::Term::stdout().size_checked();
        TextStyle {
            language: self.language(),
            width: size.map_or(COLUMNS, |(_, columns)| usize::from(columns)),
            is_full: self.full,
        }
    }

    /// A project; its names are printed in the language of the reader from now on, but for JSON.
    pub(crate) fn open(&self, path: &Path) -> Result<Found> {
        let found = Found::open(path, self.access())?;
        if !self.json {
            print_names(&found.opened.project.printed_names, self.language());
        }
        Ok(found)
    }

    /// What may be read and replaced.
    pub(crate) fn access(&self) -> Access {
        Access {
            allow_outside: self.allow_outside,
            largest_file: self.largest_file,
            force: self.force,
        }
    }
}
