//! Reads one new file: recognises it or identifies its modes, and keeps its bytes.

use crate::clock::now_s;
use crate::wrong::Said;
use dolmen_folder::{Access, Look, read};
use dolmen_records::{FileError, RECORD_BYTES_MOST};
use dolmen_store::{Keeper, Kept, StoreError, StoredFiles, hash_of_bytes};
use dolmen_words::message::Both;
use dolmen_work::follow::{Pattern, RecordFile, Taken};
use dolmen_work::{WorkError, told_both};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// Result of reading a file.
pub(crate) enum ReadFile {
    /// The file changed or disappeared in the meantime; it is tried again later.
    Later,
    /// A survey already has this record; its hash.
    Known(String),
    /// It cannot be read with the settings of the structure's records.
    Unreadable(Both),
    /// A record, and its bytes in the store.
    Record(Box<(Taken, Kept)>),
    /// The store cannot keep its bytes.
    NotKept(StoreError),
}

/// Reads files, from any thread.
pub(crate) struct Reader<'a> {
    pub(crate) access: Access,
    pub(crate) pattern: &'a Pattern,
    pub(crate) files: &'a StoredFiles,
    pub(crate) known: &'a BTreeMap<String, String>,
    pub(crate) keeper: &'a Keeper,
}

/// A file name that is safe to print and store.
pub(crate) fn name_of(path: &Path) -> String {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
    let signs = name.unwrap_or_default();
    signs
        .chars()
        .map(|sign| if sign.is_control() { '?' } else { sign })
        .collect()
}

impl Reader<'_> {
    pub(crate) fn read(&self, path: &Path, look: Look) -> ReadFile {
        let bytes = match read(path, self.access.most(RECORD_BYTES_MOST)) {
            Ok(bytes) => bytes,
            Err(FileError::Unreadable { .. }) if Look::at(path).is_none() => return ReadFile::Later,
            Err(why) => return ReadFile::Unreadable(told_both(&WorkError::from(why))),
        };
        if Look::at(path) != Some(look) || bytes.len() as u64 != look.bytes {
            return ReadFile::Later;
        }
        let hash = hash_of_bytes(&bytes);
        if self.known.contains_key(&hash) {
            return ReadFile::Known(hash);
        }
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
        let file = RecordFile {
            name: &name.unwrap_or_default(),
            bytes: &bytes,
            modified_s: look.modified_s(),
        };
        // a panic on one file must not stop the watch over all others
        let taken = catch_unwind(AssertUnwindSafe(|| self.pattern.take(&file, self.files, now_s())));
        match taken {
            Ok(Ok(taken)) => match self.keeper.keep(&bytes) {
                Ok(kept) => ReadFile::Record(Box::new((taken, kept))),
                Err(fault) => ReadFile::NotKept(fault),
            },
            Ok(Err(why)) => ReadFile::Unreadable(told_both(&why)),
            Err(_) => ReadFile::Unreadable(Said::OwnFault.into()),
        }
    }
}
