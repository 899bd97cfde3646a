//! Reads any seismic file; the first bytes identify the format, or the rows for alphanumeric SAC.

use super::lines::refuse_long_lines;
use super::{Raw, SeismicError, at2, cosmos, csmip, esm, knet, miniseed, sac};
use crate::limits::head;
use crate::quoted::shown;

/// A format with its detector and its reader.
type Text = (fn(&[u8]) -> bool, fn(&[u8]) -> Result<Vec<Raw>, SeismicError>);

/// Formats of text.
const TEXTS: [Text; 4] = [
    (knet::is_knet, knet::read),
    (cosmos::is_cosmos, cosmos::read),
    (csmip::is_csmip, csmip::read),
    (esm::is_esm, esm::read),
];

/// The numbers of each channel, for formats that vibration records and ground motions share; `None` for other files.
pub(crate) fn raw_channels(bytes: &[u8]) -> Option<Result<Vec<Raw>, SeismicError>> {
    let read = if miniseed::is_miniseed(bytes) {
        miniseed::read(bytes)
    } else if sac::is_binary(bytes) {
        sac::read_binary(bytes)
    } else {
        let (_, read) = TEXTS.iter().find(|(is_it, _)| is_it(head(bytes)))?;
        text(bytes, read)
    };
    Some(read.and_then(printable))
}

/// The numbers of each channel of a ground motion without gaps; `None` for other files and for text in columns.
pub(crate) fn motion_channels(bytes: &[u8], unit_is_given: bool) -> Option<Result<Vec<Raw>, SeismicError>> {
    if let Some(read) = raw_channels(bytes) {
        return Some(read.and_then(miniseed::whole));
    }
    let read = if sac::is_alphanumeric(head(bytes)) {
        text(bytes, sac::read_alphanumeric)
    } else if at2::is_at2(head(bytes)) {
        text(bytes, |bytes| at2::read(bytes, unit_is_given))
    } else {
        return None;
    };
    Some(read.and_then(printable))
}

fn text(
    bytes: &[u8],
    read: impl Fn(&[u8]) -> Result<Vec<Raw>, SeismicError>,
) -> Result<Vec<Raw>, SeismicError> {
    refuse_long_lines(bytes)?;
    read(bytes)
}

/// The channels, with printable names and titles.
fn printable(channels: Vec<Raw>) -> Result<Vec<Raw>, SeismicError> {
    let printable = |mut raw: Raw| {
        (raw.name, raw.title) = (shown(&raw.name), shown(&raw.title));
        raw
    };
    Ok(channels.into_iter().map(printable).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(bytes: &[u8]) -> String {
        let read = motion_channels(bytes, true);
        read.map_or_else(String::new, |read| {
            read.map_or_else(|fault| fault.to_string(), |_| "read".to_owned())
        })
    }

    #[test]
    fn refuses_a_line_of_megabytes_in_each_format_of_text() {
        for first in [
            "Origin Time       2018/01/24 19:51:00",
            "Corrected acceleration    (Format v01.20 with 13 text lines)",
            "Uncorrected Accelerogram Data",
            "SAMPLING_INTERVAL_S: 0.005000",
            "NPTS=   5372, DT=   .0100 SEC",
        ] {
            let text = format!("{first}\n{}", "1 ".repeat(1_000_000));
            assert!(
                said(text.as_bytes()).starts_with("line 2 has 2000000 bytes, but at most 1048576"),
                "{first}"
            );
        }
    }

    /// A title of a megabyte would be repeated in thousands of channels without samples.
    #[test]
    fn refuses_more_channels_than_a_station_has() {
        let series = "0 Accelerogram points at 100 pts/sec in units of g. (8f9.6)\n";
        let title = format!("Station No. {}\n", "x".repeat(1_000_000));
        let text = format!("Uncorrected Accelerogram Data\n{title}{}", series.repeat(5000));
        assert!(said(text.as_bytes()).starts_with("the csmip file holds more than 4096 channels"));
        let read = raw_channels(format!("Uncorrected Accelerogram Data\n{title}{series}").as_bytes());
        assert_eq!(read.unwrap().unwrap()[0].title.chars().count(), 200);
        let record = |number: u32| {
            let mut record = vec![0; 128];
            record[..8].copy_from_slice(b"000001D ");
            record[8..20].copy_from_slice(format!("{number:05}     XX").as_bytes());
            for (at, word) in [
                (20, 2020u16),
                (22, 5),
                (30, 1),
                (32, 100),
                (34, 1),
                (44, 64),
                (46, 48),
                (48, 1000),
            ] {
                record[at..at + 2].copy_from_slice(&word.to_be_bytes());
            }
            record[39] = 1;
            record[52..55].copy_from_slice(&[3, 1, 7]);
            record
        };
        let bytes: Vec<u8> = (0..5000).flat_map(record).collect();
        assert!(
            said(&bytes).starts_with("the miniseed file holds more than 4096 channels"),
            "{}",
            said(&bytes)
        );
    }
}
