//! The files that a project names: where their bytes come from, a folder, an archive, a store or memory.

use std::collections::BTreeMap;
use thiserror::Error;

/// Gives the bytes of files by the names that a project file writes, relative to itself.
pub trait Files: Send + Sync {
    /// All bytes of the file `name`.
    ///
    /// # Errors
    /// [`FileError`] where there is no such file, it cannot be read, or it holds more than `most_bytes`.
    fn read(&self, name: &str, most_bytes: u64) -> Result<Vec<u8>, FileError>;

    /// The file `name` as a user would look for it.
    fn shown(&self, name: &str) -> String {
        name.to_owned()
    }
}

/// A file that could not be had.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum FileError {
    /// Reading failed.
    #[error("cannot read {shown}: {why}")]
    Unreadable {
        /// The file, as a user would look for it.
        shown: String,
        /// What the system says.
        why: String,
    },
    /// It is larger than an input of its kind may be.
    #[error(
        "{shown} holds {bytes} bytes, but at most {most} are read: cut it, or split it into several files"
    )]
    TooLarge {
        /// The file, as a user would look for it.
        shown: String,
        /// Its size.
        bytes: u64,
        /// The limit.
        most: u64,
    },
    /// There is none of this name.
    #[error("there is no {shown}")]
    Absent {
        /// The file, as a user would look for it.
        shown: String,
    },
    /// There are no files here, only text.
    #[error("no files are read here, only the text of the project")]
    TextAlone,
}

/// Files in memory, by name.
#[derive(Clone, Debug, Default)]
pub struct MemoryFiles {
    /// The bytes of each.
    pub files: BTreeMap<String, Vec<u8>>,
}

impl Files for MemoryFiles {
    fn read(&self, name: &str, most_bytes: u64) -> Result<Vec<u8>, FileError> {
        let shown = name.to_owned();
        let Some(bytes) = self.files.get(name) else {
            return Err(FileError::Absent { shown });
        };
        match bytes.len() as u64 {
            bytes if bytes > most_bytes => Err(FileError::TooLarge {
                shown,
                bytes,
                most: most_bytes,
            }),
            _ => Ok(bytes.clone()),
        }
    }
}

/// No files: a project that names one is refused.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn read(&self, _name: &str, _most_bytes: u64) -> Result<Vec<u8>, FileError> {
        Err(FileError::TextAlone)
    }
}

/// Most bytes of a vibration record. Chosen here: 64 channels of a day at 100 Hz as numbers of 8 bytes are 4.4 GB.
pub const RECORD_BYTES_MOST: u64 = 8 << 30;
/// Most bytes of a ground motion. Chosen here: three components of an hour at 200 Hz as text are 30 MB.
pub const MOTION_BYTES_MOST: u64 = 512 << 20;
/// Most bytes of a mesh. Chosen here: a scan of ten million triangles is 500 MB.
pub const MESH_BYTES_MOST: u64 = 2 << 30;
/// Most bytes of a table of a site: periods and accelerations, or rates.
pub const TABLE_BYTES_MOST: u64 = 64 << 20;
