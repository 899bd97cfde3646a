//! `dolmen rank`: many structures in the order in which they should be looked at.

use crate::cli_portfolio::{Rank as Options, State};
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::say::{say, say_json};
use crate::score;
use crate::tools::told_both;
use crate::wrong::{CommandError, Noted};
use anyhow::{Context as _, Result};
use dolmen_folder::{Found, Outputs, journals_beside};
use dolmen_records::{FileError, TABLE_BYTES_MOST, stays_within};
use dolmen_report::files::ranking_files;
use dolmen_report::html::Imprint;
use dolmen_report::json::rank_json;
use dolmen_report::rank_text;
use dolmen_work::WorkError;
use dolmen_work::portfolio::{
    FoundProject, PortfolioRow, PortfolioTable, Projects, RankOptions, RowSource, rank, read_portfolio,
};
use std::path::{Path, PathBuf};

/// Projects below a folder.
struct Below<'a>(PathBuf, &'a Manner);

impl Projects for Below<'_> {
    fn open(&self, path: &str) -> Result<FoundProject, WorkError> {
        if !stays_within(path) && !self.1.allow_outside {
            let shown = path.to_owned();
            return Err(FileError::Outside { shown }.into());
        }
        let found = Found::open(&self.0.join(path), self.1.access()).map_err(|why| WorkError::Outside {
            why: told_both(why.as_ref()),
        })?;
        Ok(FoundProject {
            journals: journals_beside(&found),
            opened: found.opened,
            files: Box::new(found.files),
        })
    }
}

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    let table = rows(&options.source, manner)?;
    let designs = score::designs(options.designs.as_deref(), manner)?;
    let how = RankOptions {
        state: match options.state {
            State::Ds1 => 0,
            State::Ds2 => 1,
            State::Ds3 => 2,
            State::Falls => 3,
        },
        extrapolate: options.extrapolate,
        draws: usize::from(options.draws),
    };
    let folder = match options.source.is_dir() {
        true => options.source.as_path(),
        false => options.source.parent().unwrap_or(Path::new(".")),
    };
    let source = options.source.display().to_string();
    let answer = rank(source, table, &designs, &how, &Below(folder.to_owned(), manner))?;
    if manner.json {
        say_json(&rank_json(&answer))?;
    } else {
        say(&rank_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        let imprint = Imprint {
            program: concat!("dolmen ", env!("CARGO_PKG_VERSION")).to_owned(),
            date: None,
        };
        let files = ranking_files(&answer, manner.language(), &imprint);
        let designs = options.designs.iter();
        let outputs = designs.fold(
            Outputs::new(manner.access()).keeping(&options.source),
            |all, file| all.keeping(file),
        );
        outputs.folder(folder, &files)?;
        if !manner.quiet {
            note!(
                "{}",
                Noted::Ranking {
                    folder: folder.display().to_string()
                }
                .text(manner)
            );
        }
    }
    Ok(Outcome::Done)
}

/// The structures of a table, or of the projects in a folder.
fn rows(source: &Path, manner: &Manner) -> Result<PortfolioTable> {
    if !source.is_dir() {
        return read_portfolio(&dolmen_folder::read(
            source,
            manner.access().most(TABLE_BYTES_MOST),
        )?)
        .with_context(|| source.display().to_string());
    }
    if source.join("project.toml").is_file() {
        return Err(CommandError::OneProject {
            path: source.display().to_string(),
        }
        .into());
    }
    let mut rows = Vec::new();
    let entries = std::fs::read_dir(source).map_err(|why| CommandError::CannotRead {
        path: source.display().to_string(),
        why,
    })?;
    for entry in entries {
        let path = entry?.path();
        if path.join("project.toml").is_file() {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
            let name = name.unwrap_or_default();
            rows.push(PortfolioRow {
                line: 0,
                source: RowSource::Project {
                    path: name.clone(),
                    study: None,
                },
                name,
                hazard: None,
            });
        }
    }
    rows.sort_by(|a, b| a.name.cmp(&b.name));
    if rows.is_empty() {
        return Err(CommandError::NoProjects {
            path: source.display().to_string(),
        }
        .into());
    }
    Ok(PortfolioTable {
        rows,
        refused: Vec::new(),
    })
}
