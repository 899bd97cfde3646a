//! One file that came: read, known again or identified, its bytes kept.

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

/// What a file turned out to be.
pub(crate) enum ReadFile {
    /// It has changed or gone since: it is left for later.
    Later,
    /// A survey has this record already: its hash.
    Known(String),
    /// It cannot be read as the records of the structure are.
    Unreadable(Both),
    /// A record; its bytes are on disk in the store.
    Record(Box<(Taken, Kept)>),
    /// The store cannot keep its bytes.
    NotKept(StoreError),
}

/// What is needed to read files, from any thread.
pub(crate) struct Reader<'a> {
    pub(crate) access: Access,
    pub(crate) pattern: &'a Pattern,
    pub(crate) files: &'a StoredFiles,
    pub(crate) known: &'a BTreeMap<String, String>,
    pub(crate) keeper: &'a Keeper,
}

/// A name as it can be shown and stored.
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
        // one file that meets a fault of ours must not end the watch over all others
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
