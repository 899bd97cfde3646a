//! The files that a project names: their bytes come from a folder, an archive, a store or memory.

use dolmen_words::message::Both;
use std::collections::BTreeMap;

/// Gives the bytes of files by the names that a project file writes, relative to itself.
pub trait Files: Send + Sync {
    /// All bytes of the file `name`.
    ///
    /// # Errors
    /// [`FileError`] if there is no such file, it cannot be read, or it is larger than `most_bytes`.
    fn read(&self, name: &str, most_bytes: u64) -> Result<Vec<u8>, FileError>;

    /// Today's date, the latest anywhere on Earth; `None` without a clock.
    fn today(&self) -> Option<[u32; 3]> {
        None
    }

    /// Names of the files read so far, sorted; empty where nobody keeps them.
    fn names_read(&self) -> Vec<String> {
        Vec::new()
    }

    /// Whether the file `name` exists only under a name with another Unicode normalization (NFC, NFD).
    fn is_composed_otherwise(&self, _name: &str) -> bool {
        false
    }

    /// The file `name` in errors for the user.
    fn shown(&self, name: &str) -> String {
        name.to_owned()
    }
}

/// A file that is not available.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileError {
    /// Reading failed.
    Unreadable {
        /// The file, as a user would look for it.
        shown: String,
        /// Message of the operating system.
        why: Both,
    },
    /// It is larger than its kind allows.
    TooLarge {
        /// The file, as a user would look for it.
        shown: String,
        /// Its size.
        bytes: u64,
        /// The limit.
        most: u64,
    },
    /// It is outside the folder of the project, or may be.
    Outside {
        /// The file, as a user would look for it.
        shown: String,
    },
    /// It is a device, a pipe or a folder.
    NotAFile {
        /// The file, as a user would look for it.
        shown: String,
        /// Kind of the file: "a pipe".
        what: Both,
    },
    /// There is no file of this name.
    Absent {
        /// The file, as a user would look for it.
        shown: String,
    },
    /// There is no such file, and the name has backslashes as on Windows.
    Backslash {
        /// The file, as a user would look for it.
        shown: String,
        /// The path with forward slashes.
        slashes: String,
    },
    /// There is no file of this name, but one of a similar name.
    Misspelt {
        /// The file, as a user would look for it.
        shown: String,
        /// The similar name.
        near: String,
    },
    /// A line of a project file names an unavailable file.
    NamedIn {
        /// The project file.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// Why it is not available.
        why: Both,
    },
    /// Only text was given, without files.
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

/// Whether a name in a project file stays within the folder of the project: it does not begin at a root or a drive, and no part of it is `..`.
/// Links are not followed here; the code that opens the file checks them.
///
/// # Example
/// ```
/// use dolmen_records::stays_within;
/// assert!(stays_within("records/2009.csv") && stays_within("a..b.csv"));
/// assert!(!stays_within("../2009.csv") && !stays_within("/etc/passwd") && !stays_within(r"C:\x.csv"));
/// ```
pub fn stays_within(name: &str) -> bool {
    let mut parts = name.split(['/', '\\']);
    let begins_at_root = name.starts_with(['/', '\\']);
    // a drive, or an alternate stream of a file on Windows
    !begins_at_root && !name.contains([':', '\0']) && parts.all(|part| part != "..")
}

/// No files: a project that names one is refused.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn read(&self, _name: &str, _most_bytes: u64) -> Result<Vec<u8>, FileError> {
        Err(FileError::TextAlone)
    }
}

/// Largest size of a vibration record, bytes. Our choice: 64 channels of a day at 100 Hz as numbers of 8 bytes are 4.4 GB.
pub const RECORD_BYTES_MOST: u64 = 8 << 30;
/// Largest size of a ground motion, bytes. Our choice: three components of an hour at 200 Hz as text are 30 MB.
pub const MOTION_BYTES_MOST: u64 = 512 << 20;
/// Largest size of a mesh, bytes. Our choice: a scan of ten million triangles is 500 MB.
pub const MESH_BYTES_MOST: u64 = 2 << 30;
/// Largest size of a project file, bytes. Our choice: the longest shipped example has 25 kB.
pub const PROJECT_BYTES_MOST: u64 = 4 << 20;
/// Largest size of the journal of a study, bytes. Our choice: ten million runs of 100 bytes.
pub const JOURNAL_BYTES_MOST: u64 = 1 << 30;
/// Largest size of a table of a site (periods and accelerations, or rates), bytes.
pub const TABLE_BYTES_MOST: u64 = 64 << 20;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_names_that_could_leave_the_folder_do_not_stay_within() {
        for name in [
            "..",
            "../x",
            "a/../../x",
            "a/..",
            "/x",
            "\\x",
            "\\\\host\\x",
            "a\\..\\x",
            "C:x",
            "x\0.csv",
        ] {
            assert!(!stays_within(name), "{name:?}");
        }
        for name in [
            "x.csv",
            "a/b.csv",
            ".../x",
            "..a/b",
            "a/b../c",
            "조사/기록.npy",
            "./x.csv",
        ] {
            assert!(stays_within(name), "{name:?}");
        }
    }
}
