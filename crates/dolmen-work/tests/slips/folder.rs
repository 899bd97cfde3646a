//! The files of an example.

use dolmen_records::{FileError, Files};
use std::path::{Path, PathBuf};

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub(crate) struct Folder(pub(crate) PathBuf);

impl Files for Folder {
    fn read(&self, name: &str, _most_bytes: u64) -> Result<Vec<u8>, FileError> {
        std::fs::read(self.0.join(name)).map_err(|why| FileError::Unreadable {
            shown: name.to_owned(),
            why: why.to_string().into(),
        })
    }

    fn today(&self) -> Option<[u32; 3]> {
        Some([2026, 11, 27])
    }
}
