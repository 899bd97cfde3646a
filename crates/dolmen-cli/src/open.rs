//! From paths to values: project files and the records they name.

use crate::files;
use anyhow::Result;
use dolmen_formats::project::{Project, parse_project};
use std::path::{Path, PathBuf};

/// A project and the file it came from.
pub(crate) struct Opened {
    pub(crate) project: Project,
    pub(crate) file: PathBuf,
}

/// Reads the project file that `path` means.
pub(crate) fn project(path: &Path) -> Result<Opened> {
    let file = files::project_file(path)?;
    let text = files::read_text(&file)?;
    let project = parse_project(&text, &file.display().to_string())?;
    Ok(Opened { project, file })
}
