//! Reads any record file; detects the format from its first bytes.

use super::assembled::{assembled, factors};
use super::series::FileSeries;
use super::{
    Reading, RecordError, RecordFormat, RecordOptions, gcf, mat, read_csv, read_npy, saf, seismic, tdms, uff,
    wav,
};
use crate::limits::head;
use crate::workbook::{is_workbook, workbook_as_csv};
use crate::wrong::Unread;
use dolmen::signal::scale;
use dolmen_words::message::Both;

/// A record from the bytes of a file: CSV, XLSX, NPY, UFF 58, WAV, MAT 5 and 7.3, SAF, GCF, TDMS, miniSEED, SAC, K-NET, ESM, COSMOS.
///
/// Channels of one file with different starts or rates are [joined](dolmen::signal::join).
///
/// # Errors
/// [`RecordError`], which says where in the file and what to do.
///
/// # Example
/// ```
/// use dolmen_records::records::{RecordOptions, Unit, read_record};
/// let text = "Time (s);roof x;roof y\n0,00;1,5;-2\n0,01;2,5;0\n0,02;1,0;3\n";
/// let options = RecordOptions { unit: Unit::MilliGravity, ..Default::default() };
/// let record = read_record(text.as_bytes(), &options)?.record;
/// assert_eq!(record.sampling_rate_hz(), 100.0);
/// assert_eq!(record.channels()[0].name, "roof x");
/// assert!((record.samples(0)[1] - 2.5e-3 * 9.80665).abs() < 1e-15);
/// # Ok::<(), dolmen_records::records::RecordError>(())
/// ```
pub fn read_record(bytes: &[u8], options: &RecordOptions) -> Result<Reading, RecordError> {
    let is_npy = bytes.starts_with(super::npy::MAGIC);
    // the numbers of an array may look like any header
    if !is_npy && let Some(found) = channels(bytes, options) {
        let found = found?;
        return match options.format {
            Some(format) if format != found.format => Err(not_of(
                format,
                Unread::FileOf(found.format.name().to_owned()).into(),
            )),
            _ => assembled(found, options),
        };
    }
    let reading = match options.format {
        None | Some(RecordFormat::Xlsx) if is_workbook(bytes) => {
            let table = workbook_as_csv(bytes).map_err(|why| RecordError::Workbook { why })?;
            read_csv(&table, options)?
        }
        None if is_npy => read_npy(bytes, options)?,
        Some(RecordFormat::Npy) => read_npy(bytes, options)?,
        None | Some(RecordFormat::Csv) if !is_npy => read_csv(bytes, options)?,
        format => return Err(not_of(format.unwrap_or(RecordFormat::Csv), sort(bytes))),
    };
    let factors = factors(options, reading.record.channels().len());
    if factors.iter().all(|factor| *factor == 1.0) {
        return Ok(reading);
    }
    Ok(Reading {
        record: scale(reading.record, &factors)?,
        ..reading
    })
}

/// The channels of a file that describes them; `None` for columns of numbers.
fn channels(bytes: &[u8], options: &RecordOptions) -> Option<Result<FileSeries, RecordError>> {
    if wav::is_wav(bytes) {
        Some(wav::read(bytes, options))
    } else if tdms::is_tdms(bytes) {
        Some(tdms::read(bytes))
    } else if mat::is_mat(bytes) {
        Some(mat::read(bytes))
    } else if saf::is_saf(bytes) {
        Some(saf::read(bytes))
    } else if uff::is_uff(bytes) {
        Some(uff::read(bytes))
    } else if let Some(found) = seismic::read(bytes) {
        Some(found)
    } else if options.format == Some(RecordFormat::Gcf) {
        // the header of a block identifies the format only weakly: without a valid block the file may be any, and no error quotes its numbers
        gcf::has_header(bytes).then(|| gcf::read(bytes))
    } else if options.format.is_none() && gcf::is_gcf(bytes) {
        Some(gcf::read(bytes))
    } else {
        None
    }
}

fn not_of(format: RecordFormat, begins: Both) -> RecordError {
    RecordError::NotOfFormat {
        format: format.name(),
        begins,
    }
}

/// Description of the beginning of a file of no other format.
fn sort(bytes: &[u8]) -> Both {
    let is_sign = |b: &u8| *b >= b' ' || b.is_ascii_whitespace();
    if bytes.starts_with(super::npy::MAGIC) {
        Unread::NpyFile
    } else if is_workbook(bytes) {
        Unread::WorkbookFile
    } else if head(bytes).iter().all(is_sign) {
        Unread::Text
    } else {
        Unread::BinaryFile
    }
    .into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_another_format_without_a_word_of_the_file() {
        let told = |format| RecordOptions {
            format: Some(format),
            sampling_rate_hz: Some(100.0),
            ..Default::default()
        };
        let said = |bytes: &[u8], format| read_record(bytes, &told(format)).unwrap_err().to_string();
        let secret = b"root:$y$j9T\nabc:19000:0:99999:7:::\n".repeat(60);
        for format in RecordFormat::ALL {
            let said = said(&secret, format);
            assert!(!said.contains("root") && !said.contains("19000"), "{said}");
        }
        for format in [RecordFormat::Gcf, RecordFormat::Saf, RecordFormat::Uff] {
            let name = format.name();
            assert_eq!(
                said(&secret, format),
                format!(
                    "the file is not of the format {name}: it begins like text; correct format, or leave it out"
                )
            );
        }
        assert!(said(b"\0\x01\x02", RecordFormat::Wav).contains("it begins like a binary file"));
        assert!(said(super::super::npy::MAGIC, RecordFormat::Csv).contains("it begins like an npy file"));
        let saf = b"SESAME ASCII data format (saf) v. 1\nSAMP_FREQ = 10\nCH0_ID = V\n####\n5\n-3\n4\n";
        assert!(said(saf, RecordFormat::Csv).contains("it begins like a saf file"));
    }
}
