//! Raw files: compressed, under the hash of their bytes, written once and never changed.

use crate::error::StoreError;
use dolmen_work::kept::StoreFault;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use std::fmt::Debug;

/// Level of compression, 0 to 10. Our choice: higher ones gain 2 % on records and take twice as long.
const LEVEL: u8 = 6;
/// Number of digits of a hash.
const HASH_DIGITS: usize = 64;

/// A raw file that is on disk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kept {
    /// BLAKE3 of its bytes.
    pub hash: String,
    /// Its size.
    pub bytes: u64,
    /// Whether it is new.
    pub is_new: bool,
}

/// State of the file with the name of a raw file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Standing {
    Sound,
    Missing,
    Changed,
}

/// Storage of raw files, for several threads.
pub(crate) trait RawFiles: Debug + Send + Sync {
    /// Stores bytes; they are on disk when this returns.
    fn keep(&self, bytes: &[u8]) -> Result<Kept, StoreError>;

    /// The bytes of a file of known size.
    fn read(&self, hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError>;

    /// Whether a file of this hash exists, without a check of its bytes.
    fn is_there(&self, hash: &str) -> Result<bool, StoreError>;

    /// Number of files, without unfinished ones.
    fn count(&self) -> Result<u64, StoreError>;

    /// Prepares the storage, and removes unfinished files of processes that were killed.
    fn prepare(&self) -> Result<(), StoreError>;

    /// Whether a file exists and its bytes have this hash.
    fn standing(&self, hash: &str, bytes: u64) -> Result<Standing, StoreError> {
        if !is_hash(hash) || !self.is_there(hash)? {
            return Ok(Standing::Missing);
        }
        match self.read(hash, bytes) {
            Ok(_) => Ok(Standing::Sound),
            Err(StoreError::Fault(StoreFault::Raw { .. })) => Ok(Standing::Changed),
            Err(other) => Err(other),
        }
    }
}

/// Whether a text has the form of our hashes; no other text becomes part of a path.
pub(crate) fn is_hash(text: &str) -> bool {
    let is_digit = |sign: u8| sign.is_ascii_digit() || (b'a'..=b'f').contains(&sign);
    text.len() == HASH_DIGITS && text.bytes().all(is_digit)
}

/// Refuses a text that is not a hash.
pub(crate) fn refuse_no_hash(text: &str) -> Result<(), StoreError> {
    match is_hash(text) {
        true => Ok(()),
        false => {
            let why = "a name of a raw file that is no hash".to_owned();
            Err(StoreFault::Damaged { why }.into())
        }
    }
}

/// The hash under which bytes are kept.
pub fn hash_of_bytes(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

/// The fault of a file that is missing or changed.
pub(crate) fn lost(hash: &str) -> StoreError {
    StoreFault::Raw {
        hash: hash.to_owned(),
    }
    .into()
}

/// Compresses bytes for storage.
pub(crate) fn packed(bytes: &[u8]) -> Vec<u8> {
    compress_to_vec_zlib(bytes, LEVEL)
}

/// Unpacks the bytes of a file of known size, and never more.
pub(crate) fn unpacked(packed: &[u8], hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError> {
    let limit = usize::try_from(bytes).map_err(|_| lost(hash))?;
    let whole = decompress_to_vec_zlib_with_limit(packed, limit).map_err(|_| lost(hash))?;
    match whole.len() == limit && hash_of_bytes(&whole) == hash {
        true => Ok(whole),
        false => Err(lost(hash)),
    }
}
