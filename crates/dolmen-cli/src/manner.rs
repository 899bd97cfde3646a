//! Flags of every verb.

use crate::cli_language::{Language as Chosen, size, user_language};
use anyhow::Result;
use clap::Args;
use dolmen_folder::{Access, Found};
use dolmen_report::TextStyle;
use dolmen_words::{Language, print_names};
use std::iter;
use std::path::Path;

/// Flags of every verb.
#[derive(Clone, Debug, Args)]
pub(crate) struct Manner {
    /// Print results as JSON: keys are names of fields, values are in SI, units are part of the names
    #[arg(long, global = true)]
    pub(crate) json: bool,
    /// Print the whole answer, not only the decisive part
    #[arg(long, global = true)]
    pub(crate) full: bool,
    /// Language of text and figures; by default that of DOLMEN_LANGUAGE or of the system
    #[arg(long, global = true, value_enum)]
    pub(crate) language: Option<Chosen>,
    /// Print no progress and no notes, only results
    #[arg(long, short, global = true)]
    pub(crate) quiet: bool,
    /// Replace files that Dolmen did not write; input files and files that a project names are never replaced
    #[arg(long, global = true)]
    pub(crate) force: bool,
    /// Allow project files to name files outside their folder; only for project files that you trust
    #[arg(long, global = true)]
    pub(crate) allow_outside: bool,
    /// Largest file to read, such as "12 GB"; replaces the limit of each file type
    #[arg(long, global = true, value_name = "SIZE", value_parser = size)]
    pub(crate) largest_file: Option<u64>,
    /// Run even if a simulation needs more than 2e7 steps or 1e6 samples of its history
    #[arg(long, global = true)]
    pub(crate) yes: bool,
}

/// Line width if no terminal gives one.
const COLUMNS: usize = 80;

impl Manner {
    /// The language of text and figures.
    pub(crate) fn language(&self) -> Language {
        match self.language {
            Some(Chosen::En) => Language::English,
            Some(Chosen::Ko) => Language::Korean,
            None => user_language(|name| std::env::var(name).ok()),
        }
    }

    /// Style of printed answers.
    pub(crate) fn style(&self) -> TextStyle {
        let size = console::Term::stdout().size_checked();
        TextStyle {
            language: self.language(),
            width: size.map_or(COLUMNS, |(_, columns)| usize::from(columns)),
            is_full: self.full,
        }
    }

    /// Opens a project, and sets for the whole process the language in which its names are printed, unless `--json` is given.
    pub(crate) fn open(&self, path: &Path) -> Result<Found> {
        let found = Found::open(path, self.access())?;
        if !self.json {
            let project = &found.opened.project;
            let variants = project.variants.iter().map(|variant| &variant.project);
            for of in iter::once(&**project).chain(variants) {
                print_names(&of.printed_names, self.language());
            }
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
