//! Files as they came: compressed, under the hash of their bytes, written once and never again.

use crate::error::StoreError;
use dolmen_work::kept::StoreFault;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use std::fs;
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Level of compression, 0 to 10. Chosen here: higher ones gain 2 % on records and take twice as long.
const LEVEL: u8 = 6;
/// Ending of a file in the making.
const PART: &str = ".part";
/// Ending of a file that is there.
const ENDING: &str = ".z";
/// Digits of a hash.
const HASH_DIGITS: usize = 64;

/// The folder of the raw files.
#[derive(Clone, Debug)]
pub(crate) struct RawFolder(PathBuf);

/// A raw file that is on disk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kept {
    /// BLAKE3 of its bytes.
    pub hash: String,
    /// Its size.
    pub bytes: u64,
    /// Whether it was not there before.
    pub is_new: bool,
}

/// What stands in the place of a raw file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Standing {
    Sound,
    Missing,
    Changed,
}

/// Files made by this process.
static PARTS: AtomicUsize = AtomicUsize::new(0);

/// Whether it is a hash as we write it: nothing else ever becomes part of a path.
pub(crate) fn is_hash(text: &str) -> bool {
    let is_digit = |sign: u8| sign.is_ascii_digit() || (b'a'..=b'f').contains(&sign);
    text.len() == HASH_DIGITS && text.bytes().all(is_digit)
}

fn told(path: &Path, why: &std::io::Error) -> StoreError {
    match why.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => StoreFault::DiskFull,
        ErrorKind::ReadOnlyFilesystem => StoreFault::ReadOnly,
        _ => StoreFault::Folder {
            shown: path.display().to_string(),
            why: why.to_string(),
        },
    }
    .into()
}

impl RawFolder {
    pub(crate) fn new(path: PathBuf) -> Self {
        RawFolder(path)
    }

    /// Two digits of the hash name the folder, so that none holds too many.
    fn path(&self, hash: &str) -> Result<PathBuf, StoreError> {
        if !is_hash(hash) {
            let why = "a name of a raw file that is no hash".to_owned();
            return Err(StoreFault::Damaged { why }.into());
        }
        Ok(self.0.join(&hash[..2]).join(format!("{}{ENDING}", &hash[2..])))
    }

    /// Keeps bytes; they are on disk when this returns.
    pub(crate) fn keep(&self, bytes: &[u8]) -> Result<Kept, StoreError> {
        let hash = blake3::hash(bytes).to_hex().to_string();
        let path = self.path(&hash)?;
        let kept = |is_new| Kept {
            hash: hash.clone(),
            bytes: bytes.len() as u64,
            is_new,
        };
        let folder = path.parent().unwrap_or(&self.0);
        if path.exists() {
            // the process that wrote it may have been killed before the name was on disk
            sync(folder).map_err(|why| told(folder, &why))?;
            return Ok(kept(false));
        }
        let is_new_folder = !folder.exists();
        fs::create_dir_all(folder).map_err(|why| told(folder, &why))?;
        let packed = compress_to_vec_zlib(bytes, LEVEL);
        // twice: before it is locked, another process may take the part for one that was left behind
        let written = match self.part_then_rename(&packed, &path) {
            Err(why) if why.kind() == ErrorKind::NotFound => self.part_then_rename(&packed, &path),
            written => written,
        };
        written.map_err(|why| told(&path, &why))?;
        sync(folder).map_err(|why| told(folder, &why))?;
        if is_new_folder {
            sync(&self.0).map_err(|why| told(&self.0, &why))?;
        }
        Ok(kept(true))
    }

    fn part_then_rename(&self, packed: &[u8], path: &Path) -> std::io::Result<()> {
        let number = PARTS.fetch_add(1, Ordering::Relaxed);
        let part = self.0.join(format!("{}-{number}{PART}", std::process::id()));
        let written = fs::File::create(&part).and_then(|mut file| {
            let _ = file.try_lock(); // who clears the folder sees that it is being written; some file systems have no locks
            file.write_all(packed)?;
            file.sync_all()?;
            fs::rename(&part, path)
        });
        if written.is_err() {
            let _ = fs::remove_file(&part); // what is left of it, if anything
        }
        written
    }

    /// The bytes of a file, which are known to be so many.
    pub(crate) fn read(&self, hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError> {
        let lost = || {
            StoreError::from(StoreFault::Raw {
                hash: hash.to_owned(),
            })
        };
        let path = self.path(hash)?;
        let packed = fs::read(&path).map_err(|why| match why.kind() {
            ErrorKind::NotFound => lost(),
            _ => told(&path, &why),
        })?;
        let limit = usize::try_from(bytes).map_err(|_| lost())?;
        let whole = decompress_to_vec_zlib_with_limit(&packed, limit).map_err(|_| lost())?;
        match whole.len() == limit && blake3::hash(&whole).to_hex().as_str() == hash {
            true => Ok(whole),
            false => Err(lost()),
        }
    }

    /// Whether a file is there and has the bytes of its hash.
    pub(crate) fn standing(&self, hash: &str, bytes: u64) -> Result<Standing, StoreError> {
        if !is_hash(hash) || !self.path(hash)?.exists() {
            return Ok(Standing::Missing);
        }
        match self.read(hash, bytes) {
            Ok(_) => Ok(Standing::Sound),
            Err(StoreError::Fault(StoreFault::Raw { .. })) => Ok(Standing::Changed),
            Err(other) => Err(other),
        }
    }

    /// How many files are there, files in the making left out.
    pub(crate) fn count(&self) -> Result<u64, StoreError> {
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

    /// Makes the folder, and takes out what processes that were killed have left in the making.
    pub(crate) fn prepare(&self) -> Result<(), StoreError> {
        fs::create_dir_all(&self.0).map_err(|why| told(&self.0, &why))?;
        for path in entries(&self.0)? {
            let is_part = path.to_string_lossy().ends_with(PART);
            if is_part && fs::File::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
                let _ = fs::remove_file(&path); // it stays where it may not be removed, and does no harm
            }
        }
        Ok(())
    }
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, StoreError> {
    let read = match fs::read_dir(folder) {
        Err(why) if why.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        read => read.map_err(|why| told(folder, &why))?,
    };
    let path = |entry: std::io::Result<fs::DirEntry>| entry.map(|entry| entry.path());
    read.map(path)
        .collect::<Result<_, _>>()
        .map_err(|why| told(folder, &why))
}

/// A name is on disk once its folder is.
#[cfg(unix)]
fn sync(folder: &Path) -> std::io::Result<()> {
    fs::File::open(folder)?.sync_all()
}

#[cfg(not(unix))]
fn sync(_folder: &Path) -> std::io::Result<()> {
    Ok(())
}
