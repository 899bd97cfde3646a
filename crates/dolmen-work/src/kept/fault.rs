//! Why a store cannot answer.

/// Why a store cannot answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StoreFault {
    /// No store is named.
    Unnamed,
    /// There is no file.
    NoStore {
        /// Its path.
        shown: String,
    },
    /// A folder, a device or a pipe.
    NotAFile {
        /// Its path.
        shown: String,
    },
    /// A database of another program.
    Foreign {
        /// Its path.
        shown: String,
    },
    /// A file that is no database.
    NotADatabase,
    /// A later version of Dolmen made it.
    Later {
        /// The number of its schema.
        found: usize,
        /// The last one known.
        known: usize,
    },
    /// Another process is writing.
    Locked,
    /// It may only be read.
    ReadOnly,
    /// The file cannot be opened.
    Unopenable,
    /// There is no room.
    DiskFull,
    /// Its bytes are not those that were written.
    Damaged {
        /// What is wrong.
        why: String,
    },
    /// A raw file cannot be had as it was kept.
    Raw {
        /// Its hash.
        hash: String,
    },
    /// The folder of raw files cannot be read or written.
    Folder {
        /// The file or folder.
        shown: String,
        /// What the system says.
        why: String,
    },
    /// There is no structure of that name.
    NoStructure {
        /// The name.
        name: String,
        /// One that is alike.
        nearest: Option<String>,
    },
    /// There is no such survey.
    NoSurvey {
        /// The name.
        name: String,
        /// The last ones that are there.
        known: String,
    },
    /// A name that cannot be kept.
    Name {
        /// "structure", "path", "who".
        what: &'static str,
        /// It, what steers a terminal left out.
        shown: String,
    },
    /// Two projects of one name that are not of one kind.
    OtherKind {
        /// The structure.
        name: String,
        /// Its kind so far.
        kept: String,
        /// The kind of the project.
        given: String,
    },
    /// Something else went wrong.
    Failed {
        /// What the database says.
        why: String,
    },
}
