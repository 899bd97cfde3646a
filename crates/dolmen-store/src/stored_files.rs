//! Files of a project in a store.

use crate::database::{Database, Value, all};
use crate::error::StoreError;
use crate::raw::RawFiles;
use crate::rows::ProjectFileRow;
use dolmen_records::{FileError, Files};
use dolmen_words::messages;
use std::collections::BTreeMap;
use std::sync::Arc;

messages! {
    /// Why a file cannot be read from a store.
    pub(crate) enum NotKept in "store.not-kept" {
        NotKept => { en: "it is not in the store", ko: "저장소에 없다" },
    }
}

/// Files of a project in a store, by the names in the project.
pub struct StoredFiles {
    raw: Arc<dyn RawFiles>,
    files: BTreeMap<String, (String, u64)>,
}

impl StoredFiles {
    /// Hash and size of each file, by its path.
    pub(crate) fn new(raw: Arc<dyn RawFiles>, files: BTreeMap<String, (String, u64)>) -> Self {
        StoredFiles { raw, files }
    }

    /// The files of one state of a project.
    pub(crate) fn of(
        database: &mut dyn Database,
        raw: &Arc<dyn RawFiles>,
        rows: Vec<ProjectFileRow>,
    ) -> Result<Self, StoreError> {
        let mut files = BTreeMap::new();
        for row in rows {
            let named = [Value::Text(row.hash.clone())];
            let bytes = all(database, "select bytes from raw where hash = $1", &named)?;
            if let Some([Value::Whole(bytes)]) = bytes.first().map(Vec::as_slice) {
                files.insert(row.path, (row.hash, u64::try_from(*bytes).unwrap_or(0)));
            }
        }
        let raw = raw.clone();
        Ok(StoredFiles::new(raw, files))
    }
}

impl Files for StoredFiles {
    fn read(&self, name: &str, most_bytes: u64) -> Result<Vec<u8>, FileError> {
        let shown = || name.to_owned();
        let Some((hash, bytes)) = self.files.get(name) else {
            return Err(FileError::Unreadable {
                shown: shown(),
                why: NotKept::NotKept.into(),
            });
        };
        if *bytes > most_bytes {
            return Err(FileError::TooLarge {
                shown: shown(),
                bytes: *bytes,
                most: most_bytes,
            });
        }
        let read = self.raw.read(hash, *bytes);
        read.map_err(|fault| FileError::Unreadable {
            shown: shown(),
            why: fault.fault().sentence().into(),
        })
    }
}
