//! Raw files in a folder next to the database.

use crate::error::StoreError;
use crate::raw::{Kept, RawFiles, hash_of_bytes, lost, packed, refuse_no_hash, unpacked};
use dolmen_words::said_by_system;
use dolmen_work::kept::StoreFault;
use std::fs;
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Ending of an unfinished file.
const PART: &str = ".part";
/// Ending of a finished file.
const ENDING: &str = ".z";

/// The folder of the raw files.
#[derive(Clone, Debug)]
pub(crate) struct RawFolder(PathBuf);

/// Number of new attempts if another process removes an unfinished file.
const TRIES: usize = 20;

/// Number of files written by this process.
static PARTS: AtomicUsize = AtomicUsize::new(0);

fn folder_fault(path: &Path, why: &std::io::Error) -> StoreError {
    match why.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => StoreFault::DiskFull,
        ErrorKind::ReadOnlyFilesystem => StoreFault::ReadOnly,
        _ => StoreFault::Folder {
            shown: path.display().to_string(),
            why: said_by_system(why),
        },
    }
    .into()
}

/// The folder of a store that has no files.
#[cfg(test)]
pub(crate) fn no_files() -> std::sync::Arc<dyn RawFiles> {
    std::sync::Arc::new(RawFolder(std::env::temp_dir().join("dolmen-no-files")))
}

impl RawFolder {
    pub(crate) fn new(path: PathBuf) -> Self {
        RawFolder(path)
    }

    /// Two digits of the hash name the folder, so that no folder holds too many files.
    fn path(&self, hash: &str) -> Result<PathBuf, StoreError> {
        refuse_no_hash(hash)?;
        Ok(self.0.join(&hash[..2]).join(format!("{}{ENDING}", &hash[2..])))
    }

    fn part_then_rename(&self, packed: &[u8], path: &Path) -> std::io::Result<()> {
        let number = PARTS.fetch_add(1, Ordering::Relaxed);
        let part = self.0.join(format!("{}-{number}{PART}", std::process::id()));
        let written = fs::File::create(&part).and_then(|mut file| {
            let _ = file.try_lock(); // the lock tells processes that clear the folder that this file is being written; some file systems have no locks
            file.write_all(packed)?;
            file.sync_all()?;
            fs::rename(&part, path)
        });
        if written.is_err() {
            let _ = fs::remove_file(&part); // the unfinished file, if it exists
        }
        written
    }
}

impl RawFiles for RawFolder {
    fn keep(&self, bytes: &[u8]) -> Result<Kept, StoreError> {
        let hash = hash_of_bytes(bytes);
        let path = self.path(&hash)?;
        let kept = |is_new| Kept {
            hash: hash.clone(),
            bytes: bytes.len() as u64,
            is_new,
        };
        let folder = path.parent().unwrap_or(&self.0);
        if path.exists() {
            // the process that wrote it may have been killed before the name was on disk
            sync(folder).map_err(|why| folder_fault(folder, &why))?;
            return Ok(kept(false));
        }
        let is_new_folder = !folder.exists();
        fs::create_dir_all(folder).map_err(|why| folder_fault(folder, &why))?;
        let packed = packed(bytes);
        // again: until it is locked, another process may take the unfinished file for one left behind and remove it
        let mut written = self.part_then_rename(&packed, &path);
        for _ in 0..TRIES {
            match &written {
                Err(why) if why.kind() == ErrorKind::NotFound => {
                    written = self.part_then_rename(&packed, &path);
                }
                _ => break,
            }
        }
        written.map_err(|why| folder_fault(&path, &why))?;
        sync(folder).map_err(|why| folder_fault(folder, &why))?;
        if is_new_folder {
            sync(&self.0).map_err(|why| folder_fault(&self.0, &why))?;
        }
        Ok(kept(true))
    }

    fn read(&self, hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError> {
        let path = self.path(hash)?;
        let packed = fs::read(&path).map_err(|why| match why.kind() {
            ErrorKind::NotFound => lost(hash),
            _ => folder_fault(&path, &why),
        })?;
        unpacked(&packed, hash, bytes)
    }

    fn is_there(&self, hash: &str) -> Result<bool, StoreError> {
        Ok(self.path(hash)?.exists())
    }

    fn count(&self) -> Result<u64, StoreError> {
        let mut count = 0;
        for folder in entries(&self.0)? {
            if folder.is_dir() {
                let files = entries(&folder)?;
                let is_ours = |path: &&PathBuf| path.to_string_lossy().ends_with(ENDING);
                count += files.iter().filter(is_ours).count() as u64;
            }
        }
        Ok(count)
    }

    fn prepare(&self) -> Result<(), StoreError> {
        fs::create_dir_all(&self.0).map_err(|why| folder_fault(&self.0, &why))?;
        for path in entries(&self.0)? {
            let is_part = path.to_string_lossy().ends_with(PART);
            if is_part && fs::File::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
                let _ = fs::remove_file(&path); // if it cannot be removed it stays, and does no harm
            }
        }
        Ok(())
    }
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, StoreError> {
    let read = match fs::read_dir(folder) {
        Err(why) if why.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        read => read.map_err(|why| folder_fault(folder, &why))?,
    };
    let path = |entry: std::io::Result<fs::DirEntry>| entry.map(|entry| entry.path());
    read.map(path)
        .collect::<Result<_, _>>()
        .map_err(|why| folder_fault(folder, &why))
}

/// Syncs the folder, which puts a name on disk.
#[cfg(unix)]
fn sync(folder: &Path) -> std::io::Result<()> {
    fs::File::open(folder)?.sync_all()
}

#[cfg(not(unix))]
fn sync(_folder: &Path) -> std::io::Result<()> {
    Ok(())
}
