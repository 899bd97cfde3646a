//! Files as they came: compressed, under the hash of their bytes, written once and never again.

use crate::error::StoreError;
use dolmen_work::kept::StoreFault;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use std::fmt::Debug;

/// Level of compression, 0 to 10. Chosen here: higher ones gain 2 % on records and take twice as long.
const LEVEL: u8 = 6;
/// Digits of a hash.
const HASH_DIGITS: usize = 64;

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

/// Where raw files are, for several threads.
pub(crate) trait RawFiles: Debug + Send + Sync {
    /// Keeps bytes; they are on disk when this returns.
    fn keep(&self, bytes: &[u8]) -> Result<Kept, StoreError>;

    /// The bytes of a file, which are known to be so many.
    fn read(&self, hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError>;

    /// Whether there is a file of this hash, whatever its bytes are.
    fn is_there(&self, hash: &str) -> Result<bool, StoreError>;

    /// How many files are there, files in the making left out.
    fn count(&self) -> Result<u64, StoreError>;

    /// Makes room for files, and takes out what processes that were killed have left in the making.
    fn prepare(&self) -> Result<(), StoreError>;

    /// Whether a file is there and has the bytes of its hash.
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

/// Whether it is a hash as we write it: nothing else ever becomes part of a path.
pub(crate) fn is_hash(text: &str) -> bool {
    let is_digit = |sign: u8| sign.is_ascii_digit() || (b'a'..=b'f').contains(&sign);
    text.len() == HASH_DIGITS && text.bytes().all(is_digit)
}

/// Refuses what is no hash.
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

/// Bytes as they are kept.
pub(crate) fn packed(bytes: &[u8]) -> Vec<u8> {
    compress_to_vec_zlib(bytes, LEVEL)
}

/// The bytes of a file, which are known to be so many: no more are ever unpacked.
pub(crate) fn unpacked(packed: &[u8], hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError> {
    let limit = usize::try_from(bytes).map_err(|_| lost(hash))?;
    let whole = decompress_to_vec_zlib_with_limit(packed, limit).map_err(|_| lost(hash))?;
    match whole.len() == limit && hash_of_bytes(&whole) == hash {
        true => Ok(whole),
        false => Err(lost(hash)),
    }
}
