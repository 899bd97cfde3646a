//! Why a store cannot answer.

/// Why a store cannot answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StoreFault {
    /// The user names no store.
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
    /// The address of a server where this program knows none.
    NoPostgres,
    /// The address of a server cannot be read.
    ServerUrl {
        /// What cannot be read: "port", or the name of a parameter; never a value, which may be a password.
        part: String,
    },
    /// The address asks for encryption.
    ServerTls {
        /// What it asks for.
        mode: String,
    },
    /// The server is another machine, and the address does not say that what goes there may be read on the way.
    ServerClear {
        /// The machine.
        host: String,
    },
    /// Nothing answers, or nothing that could be talked to.
    ServerDown {
        /// The address without its password.
        shown: String,
        /// What the system says.
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
    /// The server takes no more connections.
    ServerFull {
        /// The address without its password.
        shown: String,
    },
    /// The database keeps text in an encoding that lacks signs.
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
    /// The role lacks a right, or the server only gives and takes nothing.
    ServerRights {
        /// The address without its password.
        shown: String,
    },
    /// The connection ended while it was used.
    ServerGone {
        /// The address without its password.
        shown: String,
    },
    /// A text with a zero byte, which PostgreSQL has no place for.
    ZeroByte {
        /// It, what steers a terminal left out.
        shown: String,
    },
    /// Something else went wrong.
    Failed {
        /// What the database says.
        why: String,
    },
}
