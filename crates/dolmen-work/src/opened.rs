//! A project with the text it was read from.

use crate::error::WorkError;
use crate::surveyed::SurveyAnswer;
use dolmen_project::{Project, parse_project_with};
use dolmen_records::Files;
use std::sync::Arc;

/// A project, its text, and the name of its file.
#[derive(Clone, Debug)]
pub struct Opened {
    /// What the file says.
    pub project: Arc<Project>,
    /// The text of the file, from which the cases of a study are read.
    pub text: String,
    /// The file name for the user.
    pub file: String,
    /// Earlier results of surveys, for the stiffness that the file leaves to them.
    pub identified: Vec<SurveyAnswer>,
}

impl Opened {
    /// Reads the text of a project file; `files` gives what it names.
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
