//! Where a store is: what a user names.

use crate::error::StoreError;
use dolmen_work::kept::StoreFault;
use std::path::{Path, PathBuf};

/// A file of SQLite; its raw files lie in the folder of the same name with ".files" behind it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place(PathBuf);

impl Place {
    /// The place that a user means.
    ///
    /// # Errors
    /// [`StoreFault::Unnamed`].
    pub fn of(named: &str) -> Result<Self, StoreError> {
        match named.is_empty() {
            true => Err(StoreFault::Unnamed.into()),
            false => Ok(Place(named.into())),
        }
    }

    /// The file.
    pub(crate) fn file(&self) -> &Path {
        &self.0
    }

    /// The folder of its raw files.
    pub(crate) fn files(&self) -> PathBuf {
        let mut name = self.0.as_os_str().to_owned();
        name.push(".files");
        name.into()
    }
}
