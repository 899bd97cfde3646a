//! Packs the parts of a document.

use super::PaperFault;
use std::borrow::Cow;
use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// A part of the archive: its name and content.
pub(crate) type Part<'a> = (String, Cow<'a, [u8]>);

/// Packs these parts in this order; the same parts give the same bytes.
pub(crate) fn pack(parts: &[Part<'_>]) -> Result<Vec<u8>, PaperFault> {
    let fault = |fault: &dyn std::fmt::Display| PaperFault::Archive(fault.to_string());
    // fixed date: the archive format begins in 1980
    let packed = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default());
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in parts {
        // pictures are compressed already; the type entry must be readable in place
        let is_plain = [".png", ".jpg"].iter().any(|end| name.ends_with(end)) || name == "mimetype";
        let options = match is_plain {
            true => packed.compression_method(CompressionMethod::Stored),
            false => packed,
        };
        archive.start_file(name, options).map_err(|e| fault(&e))?;
        archive.write_all(bytes).map_err(|e| fault(&e))?;
    }
    Ok(archive.finish().map_err(|e| fault(&e))?.into_inner())
}
