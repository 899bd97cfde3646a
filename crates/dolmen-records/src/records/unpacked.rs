//! Unpacks deflate streams, up to the length that the file states.

use crate::wrong::Damage;
use miniz_oxide::inflate::TINFLStatus;
use miniz_oxide::inflate::core::inflate_flags::{
    TINFL_FLAG_COMPUTE_ADLER32, TINFL_FLAG_PARSE_ZLIB_HEADER, TINFL_FLAG_USING_NON_WRAPPING_OUTPUT_BUF,
};
use miniz_oxide::inflate::core::{DecompressorOxide, decompress};

/// A stream with a header and a checksum, as all readers here use.
const ZLIB: u32 = TINFL_FLAG_PARSE_ZLIB_HEADER | TINFL_FLAG_COMPUTE_ADLER32;
/// Window of deflate.
const WINDOW: usize = 1 << 15;

/// Unpacks one stream after another.
pub(super) struct Unpacker(Box<DecompressorOxide>);

impl Unpacker {
    pub(super) fn new() -> Self {
        Unpacker(Box::default())
    }

    /// The first bytes of a stream, up to a number.
    pub(super) fn head(&mut self, packed: &[u8], most: usize) -> Result<Vec<u8>, Damage> {
        let (head, _) = self.first(packed, most)?;
        Ok(head)
    }

    /// All bytes of a stream, up to a number.
    pub(super) fn whole(&mut self, packed: &[u8], most: usize) -> Result<Vec<u8>, Damage> {
        match self.first(packed, most)? {
            (whole, TINFLStatus::Done) => Ok(whole),
            _ => Err(Damage::ItHoldsMore),
        }
    }

    fn first(&mut self, packed: &[u8], most: usize) -> Result<(Vec<u8>, TINFLStatus), Damage> {
        self.0.init();
        let mut out = vec![0; most];
        let flags = ZLIB | TINFL_FLAG_USING_NON_WRAPPING_OUTPUT_BUF;
        let (status, _, written) = decompress(&mut self.0, packed, &mut out, 0, flags);
        out.truncate(written);
        match status {
            TINFLStatus::Done | TINFLStatus::HasMoreOutput => Ok((out, status)),
            other => Err(fault(other)),
        }
    }

    /// Verifies the checksum of a stream, up to a number of bytes, without keeping its contents.
    pub(super) fn verified(&mut self, packed: &[u8], most: usize) -> Result<(), Damage> {
        self.0.init();
        let mut window = vec![0; WINDOW];
        let (mut at, mut place, mut total) = (0, 0, 0);
        loop {
            let (status, read, written) = decompress(&mut self.0, &packed[at..], &mut window, place, ZLIB);
            at += read;
            place = (place + written) % WINDOW;
            total += written;
            match status {
                _ if total > most => return Err(Damage::ItHoldsMore),
                TINFLStatus::Done => return Ok(()),
                TINFLStatus::HasMoreOutput => {}
                other => return Err(fault(other)),
            }
        }
    }
}

fn fault(status: TINFLStatus) -> Damage {
    match status {
        TINFLStatus::Adler32Mismatch => Damage::WrongSum,
        TINFLStatus::FailedCannotMakeProgress | TINFLStatus::NeedsMoreInput => Damage::EndsTooEarly,
        _ => Damage::NoCodes,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::deflate::compress_to_vec_zlib;

    #[test]
    fn exact_what_was_packed_comes_out_and_no_more() {
        let bytes: Vec<u8> = (0..50_000u32).flat_map(|i| (i * i).to_le_bytes()).collect();
        let packed = compress_to_vec_zlib(&bytes, 6);
        let mut unpacker = Unpacker::new();
        assert_eq!(unpacker.head(&packed, 100).as_deref(), Ok(&bytes[..100]));
        assert_eq!(unpacker.whole(&packed, bytes.len()).as_deref(), Ok(&bytes[..]));
        assert_eq!(unpacker.verified(&packed, bytes.len()), Ok(()));
        let more = Err(Damage::ItHoldsMore);
        assert_eq!(unpacker.whole(&packed, bytes.len() - 1).map(drop), more);
        assert_eq!(unpacker.verified(&packed, bytes.len() - 1), more);
        let mut changed = packed.clone();
        let last = changed.len() - 1;
        changed[last] ^= 1;
        assert_eq!(unpacker.verified(&changed, bytes.len()), Err(Damage::WrongSum));
        assert_eq!(
            unpacker.whole(&changed, bytes.len()).map(drop),
            Err(Damage::WrongSum)
        );
        assert_eq!(
            unpacker.verified(&packed[..last], bytes.len()),
            Err(Damage::EndsTooEarly)
        );
        assert_eq!(unpacker.whole(&[0; 8], 10).map(drop), Err(Damage::NoCodes));
    }
}
