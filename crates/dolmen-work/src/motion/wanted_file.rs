//! The files of a motion, each with its component and column.

use super::error::MotionRequestError;
use super::request::GivenFile;
use crate::error::WorkError;
use dolmen::signal::Component;

/// A file of a motion.
pub(super) struct WantedFile {
    pub(super) component: Component,
    /// Its name in the project or from the user.
    pub(super) name: String,
    /// Its column or channel, if given.
    pub(super) channel: Option<String>,
    /// Its bytes, if given; otherwise they come from the project's files.
    pub(super) bytes: Option<Vec<u8>>,
}

/// The given files, each with its component.
pub(super) fn given_files(given: &[GivenFile]) -> Result<Vec<WantedFile>, WorkError> {
    let mut named: Vec<WantedFile> = Vec::new();
    for (position, file) in given.iter().enumerate() {
        let component = file.component.unwrap_or(Component::ALL[position.min(2)]);
        if named.iter().any(|other| other.component == component) {
            return Err(MotionRequestError::ComponentTwice { component }.into());
        }
        named.push(WantedFile {
            component,
            name: file.name.clone(),
            channel: None,
            bytes: Some(file.bytes.clone()),
        });
    }
    Ok(named)
}

pub(super) fn column_of(columns: &[(Component, String)], component: Component) -> Option<String> {
    let own = columns.iter().find(|(of, _)| *of == component);
    own.map(|(_, column)| column.clone())
}

/// The files, with columns from the request instead of those in the project file: for one file all components, for several one each.
pub(super) fn typed_columns(
    mut files: Vec<WantedFile>,
    columns: &[(Component, String)],
) -> Result<Vec<WantedFile>, WorkError> {
    if columns.is_empty() {
        return Ok(files);
    }
    let is_one = files.iter().all(|file| file.name == files[0].name);
    if is_one && !files.is_empty() {
        let file = files.swap_remove(0);
        let each = columns.iter().map(|(component, column)| WantedFile {
            component: *component,
            channel: Some(column.clone()),
            name: file.name.clone(),
            bytes: file.bytes.clone(),
        });
        return Ok(each.collect());
    }
    for (component, column) in columns {
        let Some(own) = files.iter_mut().find(|file| file.component == *component) else {
            return Err(MotionRequestError::ColumnWithoutFile {
                component: *component,
                column: column.clone(),
            }
            .into());
        };
        own.channel = Some(column.clone());
    }
    Ok(files)
}
