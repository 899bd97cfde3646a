//! Why a store cannot answer.

/// Why a store cannot answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum StoreFault {
    /// No store is named.
    #[error("no store is named")]
    Unnamed,
    /// There is no file.
    #[error("there is no store {shown}")]
    NoStore {
        /// Its path.
        shown: String,
    },
    /// A folder, a device or a pipe.
    #[error("{shown} is no regular file")]
    NotAFile {
        /// Its path.
        shown: String,
    },
    /// A database of another program.
    #[error("{shown} is no store of Dolmen")]
    Foreign {
        /// Its path.
        shown: String,
    },
    /// A file that is no database.
    #[error("the file is no database")]
    NotADatabase,
    /// A later version of Dolmen made it.
    #[error("schema {found} is later than {known}")]
    Later {
        /// The number of its schema.
        found: usize,
        /// The last one known.
        known: usize,
    },
    /// Another process is writing.
    #[error("another process is writing")]
    Locked,
    /// It may only be read.
    #[error("the store may only be read")]
    ReadOnly,
    /// The file cannot be opened.
    #[error("the file cannot be opened")]
    Unopenable,
    /// There is no room.
    #[error("the disk is full")]
    DiskFull,
    /// Its bytes are not those that were written.
    #[error("damaged: {why}")]
    Damaged {
        /// What is wrong.
        why: String,
    },
    /// A raw file cannot be had as it was kept.
    #[error("the raw file {hash} is missing or changed")]
    Raw {
        /// Its hash.
        hash: String,
    },
    /// The folder of raw files cannot be read or written.
    #[error("cannot use {shown}: {why}")]
    Folder {
        /// The file or folder.
        shown: String,
        /// What the system says.
        why: String,
    },
    /// There is no structure of that name.
    #[error("no structure {name}")]
    NoStructure {
        /// The name.
        name: String,
        /// One that is alike.
        nearest: Option<String>,
    },
    /// There is no such survey.
    #[error("no survey {name}")]
    NoSurvey {
        /// The name.
        name: String,
        /// The last ones that are there.
        known: String,
    },
    /// A name that cannot be kept.
    #[error("{what} {shown} cannot be kept")]
    Name {
        /// "structure", "path", "who".
        what: &'static str,
        /// It, what steers a terminal left out.
        shown: String,
    },
    /// Two projects of one name that are not of one kind.
    #[error("{name} is kept as a {kept}, not as a {given}")]
    OtherKind {
        /// The structure.
        name: String,
        /// Its kind so far.
        kept: String,
        /// The kind of the project.
        given: String,
    },
    /// Something else went wrong.
    #[error("{why}")]
    Failed {
        /// What the database says.
        why: String,
    },
}
