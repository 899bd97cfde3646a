//! The drawing of a structure as a file.

use super::named::NamedFile;
use crate::figures::drawing;
use dolmen_project::Project;
use dolmen_words::Language;

/// The structure as entered, as an SVG with the mark; `None` for a survey alone.
pub fn drawing_file(project: &Project, language: Language) -> Option<NamedFile> {
    Some(NamedFile::svg("drawing", &drawing(project, language)?))
}
