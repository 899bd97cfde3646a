//! Raw files in rows of a server, compressed and in pieces, so that client and server need memory for only one piece in addition
//! to the file.

use super::address::Address;
use super::link::Link;
use crate::database::{Access, Value};
use crate::error::StoreError;
use crate::raw::{Kept, RawFiles, hash_of_bytes, lost, packed, refuse_no_hash, unpacked};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Largest number of bytes in a piece. Our choice: a server keeps a few copies of each value, and refuses a value of 1 GiB.
const PIECE_BYTES_MOST: usize = 4 << 20;

/// Raw files on a server. They use a separate connection, because they are read together with rows, and stored before rows refer
/// to them.
#[derive(Debug)]
pub(crate) struct Pieces(Mutex<Link>);

impl Pieces {
    pub(crate) fn new(address: &Address, access: Access, wait: Duration) -> Self {
        Pieces(Mutex::new(Link::new(address, access, wait)))
    }

    fn link(&self) -> MutexGuard<'_, Link> {
        let mut link = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if link.is_in_transaction() {
            link.leave();
        }
        link
    }
}

fn pieces_of(link: &mut Link, hash: &str) -> Result<Option<i64>, StoreError> {
    let mut pieces = None;
    let named = [Value::Text(hash.to_owned())];
    link.query(
        "select pieces from raw_file where hash = $1",
        &named,
        &mut |row| {
            if let [Value::Whole(number)] = row.as_slice() {
                pieces = Some(*number);
            }
            Ok(())
        },
    )?;
    Ok(pieces)
}

/// Stores a file; returns whether it is new.
fn put(link: &mut Link, hash: &str, packed: &[u8]) -> Result<bool, StoreError> {
    let pieces = packed.chunks(PIECE_BYTES_MOST);
    let head = [Value::Text(hash.to_owned()), Value::Whole(pieces.len() as i64)];
    let sql = "insert into raw_file (hash, pieces) values ($1, $2) on conflict do nothing";
    if link.execute(sql, &head)? == 0 {
        return Ok(false);
    }
    for (at, piece) in pieces.enumerate() {
        let sql = "insert into raw_piece (hash, position, bytes) values ($1, $2, $3)";
        link.execute_with_bytes(sql, (hash, at as i64 + 1), piece)?;
    }
    Ok(true)
}

impl RawFiles for Pieces {
    fn keep(&self, bytes: &[u8]) -> Result<Kept, StoreError> {
        let hash = hash_of_bytes(bytes);
        let kept = |is_new| Kept {
            hash: hash.clone(),
            bytes: bytes.len() as u64,
            is_new,
        };
        let is_there = pieces_of(&mut self.link(), &hash)?.is_some();
        if is_there {
            return Ok(kept(false));
        }
        let packed = packed(bytes); // compressed before the connection is locked, so that others can use it
        let mut link = self.link();
        let put = link.begin("begin").and_then(|()| put(&mut link, &hash, &packed));
        match put {
            Ok(is_new) => link.end("commit").map(|()| kept(is_new)),
            Err(fault) => {
                let _ = link.end("rollback"); // the first fault is the one to report
                Err(fault)
            }
        }
    }

    fn read(&self, hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError> {
        refuse_no_hash(hash)?;
        // incompressible bytes grow by less than this
        let most = bytes.saturating_add(bytes / 64).saturating_add(4096);
        let mut packed = Vec::new();
        let mut link = self.link();
        let Some(pieces) = pieces_of(&mut link, hash)? else {
            return Err(lost(hash));
        };
        let (named, mut found) = ([Value::Text(hash.to_owned())], 0);
        let sql = "select bytes from raw_piece where hash = $1 order by position";
        link.rows(sql, &named, &mut |row| {
            let piece: &[u8] = row.try_get(0).map_err(|_| lost(hash))?;
            found += 1;
            packed.extend_from_slice(piece);
            match packed.len() as u64 > most {
                true => Err(lost(hash)),
                false => Ok(()),
            }
        })?;
        drop(link);
        match found == pieces {
            true => unpacked(&packed, hash, bytes),
            false => Err(lost(hash)),
        }
    }

    fn is_there(&self, hash: &str) -> Result<bool, StoreError> {
        Ok(pieces_of(&mut self.link(), hash)?.is_some())
    }

    fn count(&self) -> Result<u64, StoreError> {
        let mut count = 0;
        self.link()
            .query("select count(*) from raw_file", &[], &mut |row| {
                if let [Value::Whole(number)] = row.as_slice() {
                    count = u64::try_from(*number).unwrap_or(0);
                }
                Ok(())
            })?;
        Ok(count)
    }

    fn prepare(&self) -> Result<(), StoreError> {
        Ok(()) // the tables exist, and unfinished work of a process is rolled back
    }
}
