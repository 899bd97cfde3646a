//! Faults of a store.

use dolmen_words::message::Both;

/// Why a store fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StoreFault {
    /// The user named no store.
    Unnamed,
    /// The file does not exist.
    NoStore {
        /// Its path.
        shown: String,
    },
    /// The path is a folder, a device or a pipe.
    NotAFile {
        /// Its path.
        shown: String,
    },
    /// The file is a database of another program.
    Foreign {
        /// Its path.
        shown: String,
    },
    /// The file is not a database.
    NotADatabase,
    /// The store was made by a later version of Dolmen.
    Later {
        /// The number of its schema.
        found: usize,
        /// The last one that this version knows.
        known: usize,
    },
    /// Another process is writing.
    Locked,
    /// The store is read-only.
    ReadOnly,
    /// The file cannot be opened.
    Unopenable,
    /// The disk is full.
    DiskFull,
    /// The file is damaged.
    Damaged {
        /// The fault.
        why: String,
    },
    /// A raw file is missing or changed.
    Raw {
        /// Its hash.
        hash: String,
    },
    /// The folder of raw files cannot be read or written.
    Folder {
        /// The file or folder.
        shown: String,
        /// The system's error.
        why: Both,
    },
    /// There is no structure with that name.
    NoStructure {
        /// The name.
        name: String,
        /// A similar name.
        nearest: Option<String>,
    },
    /// There is no such survey.
    NoSurvey {
        /// The name.
        name: String,
        /// Names of the last ones.
        known: String,
    },
    /// A name that is not allowed.
    Name {
        /// "structure", "path", "who".
        what: &'static str,
        /// The name without control characters.
        shown: String,
    },
    /// Two projects with the same name but different kinds.
    OtherKind {
        /// The structure.
        name: String,
        /// The kind in the store.
        kept: String,
        /// The kind of the project.
        given: String,
    },
    /// The address of a server in a build without servers.
    NoPostgres,
    /// The address of a server cannot be read.
    ServerUrl {
        /// The unreadable part: "port", or the name of a parameter; never a value, which may be a password.
        part: String,
    },
    /// The address asks for encryption.
    ServerTls {
        /// The requested encryption mode.
        mode: String,
    },
    /// The server is another machine, and the address does not allow an unencrypted connection.
    ServerClear {
        /// The machine.
        host: String,
    },
    /// No server answers, or the answer is not from a PostgreSQL server.
    ServerDown {
        /// The address without its password.
        shown: String,
        /// The system's error.
        why: String,
    },
    /// The server refuses the role or its password.
    ServerRefused {
        /// The address without its password.
        shown: String,
    },
    /// The server asks for a password, and none is given.
    ServerPassword {
        /// The address without its password.
        shown: String,
    },
    /// The server has no such database.
    ServerDatabase {
        /// The address without its password.
        shown: String,
    },
    /// The server accepts no more connections.
    ServerFull {
        /// The address without its password.
        shown: String,
    },
    /// The encoding of the database lacks characters.
    ServerEncoding {
        /// The address without its password.
        shown: String,
        /// The encoding.
        encoding: String,
    },
    /// The database has no store.
    ServerEmpty {
        /// The address without its password.
        shown: String,
    },
    /// The schema "dolmen" of the database belongs to another program.
    ServerForeign {
        /// The address without its password.
        shown: String,
    },
    /// The role lacks a right, or the server is read-only.
    ServerRights {
        /// The address without its password.
        shown: String,
    },
    /// The connection ended while it was used.
    ServerGone {
        /// The address without its password.
        shown: String,
    },
    /// A text with a zero byte, which PostgreSQL cannot store.
    ZeroByte {
        /// The text without control characters.
        shown: String,
    },
    /// Another error.
    Failed {
        /// The database's error.
        why: String,
    },
}
