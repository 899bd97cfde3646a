//! A project with the text it was read from.

use crate::error::WorkError;
use crate::surveyed::SurveyAnswer;
use dolmen_project::{Project, parse_project_with};
use dolmen_records::Files;
use std::sync::Arc;

/// A project, its text, and the name of its file.
#[derive(Clone, Debug)]
pub struct Opened {
    /// The project.
    pub project: Arc<Project>,
    /// The text of the file, from which cases of a study are parsed.
    pub text: String,
    /// The file name for the user.
    pub file: String,
    /// Earlier results of surveys, for the stiffness identified from them.
    pub identified: Vec<SurveyAnswer>,
}

impl Opened {
    /// Parses the text of a project file; `files` provides the files that it names.
    ///
    /// # Errors
    /// [`WorkError::Project`], which holds every fault with its line.
    pub fn read(text: String, file: String, files: &dyn Files) -> Result<Self, WorkError> {
        let project = Arc::new(parse_project_with(&text, &file, files)?);
        Ok(Opened {
            project,
            text,
            file,
            identified: Vec::new(),
        })
    }
}
