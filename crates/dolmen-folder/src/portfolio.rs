//! Several projects in a folder or a table.

use crate::files::likely_project;
use crate::wrong::{PathError, of_folders};
use crate::{Access, Found, journals_beside, read};
use anyhow::{Context as _, Result};
use dolmen_records::{FileError, TABLE_BYTES_MOST, stays_within};
use dolmen_words::message::Both;
use dolmen_work::portfolio::{
    FoundProject, PortfolioRow, PortfolioTable, Projects, RowSource, read_portfolio_sheet,
};
use dolmen_work::{WorkError, told_by};
use std::path::{Path, PathBuf};

/// Name of a project file.
const PROJECT: &str = "project.toml";

/// The structures of a table (XLSX, ODS, CSV; `sheet` chooses one of a workbook), or of the projects in a folder.
///
/// # Errors
/// If the table cannot be read, or the folder is itself a project or contains none.
pub fn portfolio(source: &Path, sheet: Option<&str>, access: Access) -> Result<PortfolioTable> {
    let shown = || source.display().to_string();
    if !source.is_dir() {
        let bytes = read(source, access.most(TABLE_BYTES_MOST))?;
        return read_portfolio_sheet(&bytes, &shown(), sheet).with_context(shown);
    }
    if let Some(sheet) = sheet {
        let (path, sheet) = (shown(), sheet.to_owned());
        return Err(PathError::SheetOfFolder { path, sheet }.into());
    }
    if source.join(PROJECT).is_file() {
        return Err(PathError::OneProject { path: shown() }.into());
    }
    let entries = std::fs::read_dir(source).map_err(|why| PathError::CannotOpen { path: shown(), why })?;
    let mut rows = Vec::new();
    for entry in entries {
        let path = entry?.path();
        // a folder with a file that may be meant is a row, so that it is refused with the reason
        let is_likely = || path.is_dir() && likely_project(&path).is_some();
        if path.join(PROJECT).is_file() || is_likely() {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
            rows.push(row(name.unwrap_or_default()));
        }
    }
    if rows.is_empty() {
        return Err(PathError::NoProjects { path: shown() }.into());
    }
    rows.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(PortfolioTable {
        rows,
        refused: Vec::new(),
        left_out: Vec::new(),
    })
}

fn row(name: String) -> PortfolioRow {
    PortfolioRow {
        line: 0,
        source: RowSource::Project {
            path: name.clone(),
            study: None,
        },
        name,
        hazard: None,
    }
}

/// The folder whose projects the portfolio contains: its own, or that of its table.
pub struct ProjectsBelow {
    folder: PathBuf,
    access: Access,
}

impl ProjectsBelow {
    /// The projects that `source`, a table or a folder, names.
    pub fn of(source: &Path, access: Access) -> Self {
        let folder = match source.is_dir() {
            true => source,
            false => source.parent().unwrap_or(Path::new(".")),
        };
        ProjectsBelow {
            folder: folder.to_owned(),
            access,
        }
    }
}

impl Projects for ProjectsBelow {
    fn open(&self, path: &str) -> Result<FoundProject, WorkError> {
        if !stays_within(path) && !self.access.allow_outside {
            let shown = path.to_owned();
            return Err(FileError::Outside { shown }.into());
        }
        let found = Found::open(&self.folder.join(path), self.access).map_err(|why| WorkError::Outside {
            why: Both::of(|language| told_by(why.as_ref(), language, &of_folders)),
        })?;
        Ok(FoundProject {
            journals: journals_beside(&found),
            opened: found.opened,
            files: Box::new(found.files),
        })
    }
}
