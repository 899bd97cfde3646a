//! The place of a store, as a user names it.

use crate::error::StoreError;
#[cfg(feature = "postgres")]
use crate::server::Address;
use dolmen_work::kept::StoreFault;
use std::path::{Path, PathBuf};

/// Beginnings of a server's address.
const SCHEMES: [&str; 2] = ["postgresql://", "postgres://"];

/// An SQLite file, whose raw files lie in the folder of the same name with ".files" at its end; or a PostgreSQL database.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place(Location);

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Location {
    File(PathBuf),
    #[cfg(feature = "postgres")]
    Server(Address),
}

fn after_scheme(named: &str) -> Option<&str> {
    SCHEMES.iter().find_map(|scheme| named.strip_prefix(scheme))
}

#[cfg(feature = "postgres")]
fn server(after_scheme: &str) -> Result<Location, StoreFault> {
    Address::of(after_scheme).map(Location::Server)
}

#[cfg(not(feature = "postgres"))]
fn server(_after_scheme: &str) -> Result<Location, StoreFault> {
    Err(StoreFault::NoPostgres)
}

impl Place {
    /// Parses a user's place: a file, or an address that begins with "postgresql://" or "postgres://". Opens nothing.
    ///
    /// # Errors
    /// [`StoreFault::Unnamed`]; an address that cannot be read, asks for encryption or would need it; or an address without the feature
    /// `postgres`.
    pub fn of(named: &str) -> Result<Self, StoreError> {
        match (named, after_scheme(named)) {
            ("", _) => Err(StoreFault::Unnamed.into()),
            (_, Some(address)) => Ok(Place(server(address)?)),
            (file, None) => Ok(Place(Location::File(file.into()))),
        }
    }

    /// Whether it is a database of a server.
    pub fn is_server(named: &str) -> bool {
        after_scheme(named).is_some()
    }

    /// Adds a password if the address of a server has none: the given one, otherwise that of a file such as ~/.pgpass, which only its owner may
    /// be able to read.
    #[must_use]
    pub fn with_password(self, given: Option<String>, file: Option<&Path>) -> Self {
        match self.0 {
            #[cfg(feature = "postgres")]
            Location::Server(mut address) => {
                if address.password.is_none() {
                    let of_file = || {
                        address.password_in(
                            &std::fs::read_to_string(file.filter(|file| is_private(file))?).ok()?,
                        )
                    };
                    address.password = given.or_else(of_file);
                }
                Place(Location::Server(address))
            }
            Location::File(path) => {
                let _ = (given, file); // a file has no password
                Place(Location::File(path))
            }
        }
    }

    /// The files of the store itself, which may lie among others; a server has none.
    pub fn own_files(&self) -> Vec<PathBuf> {
        match &self.0 {
            Location::File(path) => ["", "-wal", "-shm", "-journal"]
                .map(|ending| with_ending(path, ending))
                .to_vec(),
            #[cfg(feature = "postgres")]
            Location::Server(_) => Vec::new(),
        }
    }

    pub(crate) fn place(&self) -> &Location {
        &self.0
    }
}

/// The folder of the raw files of a store in a file.
pub(crate) fn files_of(file: &Path) -> PathBuf {
    with_ending(file, ".files")
}

fn with_ending(file: &Path, ending: &str) -> PathBuf {
    let mut name = file.as_os_str().to_owned();
    name.push(ending);
    name.into()
}

#[cfg(all(unix, feature = "postgres"))]
fn is_private(file: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt as _;
    const OTHERS: u32 = 0o077;
    std::fs::metadata(file).is_ok_and(|about| about.is_file() && about.permissions().mode() & OTHERS == 0)
}

#[cfg(all(not(unix), feature = "postgres"))]
fn is_private(file: &Path) -> bool {
    file.is_file()
}
