//! SAF, the text format of the SESAME project for three components of ambient vibration.
//!
//! ```text
//! SESAME ASCII data format (saf) v. 1   (this line must not be modified)
//! STA_CODE = EPFL
//! START_TIME = 2003 2 12 10 0 0.25
//! SAMP_FREQ = 125
//! NDAT = 4
//! CH0_ID = S V
//! CH1_ID = S N
//! CH2_ID = S E
//! UNITS = count
//! ####---------------------------------
//! 12 -3 4
//! ```
//!
//! Source: SESAME (2004) *Guidelines for the implementation of the H/V spectral ratio technique*, deliverable D09.03, and the files
//! of the project.

use super::dialect::line_at;
use super::series::{FileSeries, Series};
use super::unit::unit_of_label;
use super::{FileUnit, RecordError, RecordFormat};
use crate::number::parse_number;
use crate::quoted::shown;
use crate::start::time_of;
use crate::wrong::{Expected, Remark};

const FORMAT: &str = "saf";
const FIRST: &[u8] = b"SESAME ASCII data format";
/// Largest number of channels; files of this format have fewer.
const CHANNELS_MOST: usize = 64;

pub(super) fn is_saf(bytes: &[u8]) -> bool {
    bytes.starts_with(FIRST)
}

/// Content of the header.
#[derive(Default)]
struct Header {
    station: String,
    begins_s: Option<f64>,
    rate_hz: Option<f64>,
    samples: Option<usize>,
    names: Vec<String>,
    unit: Option<String>,
}

pub(super) fn read(bytes: &[u8]) -> Result<FileSeries, RecordError> {
    let (header, mut at, mut number) = header(bytes)?;
    if header.names.is_empty() {
        return Err(RecordError::HeaderLacks {
            format: FORMAT,
            what: Expected::SafChannels.into(),
        });
    }
    let count = header.names.len();
    let mut samples = vec![Vec::new(); count];
    while let Some(line) = line_at(bytes, at, number)? {
        (at, number) = (line.next, number + 1);
        let cells: Vec<&[u8]> = line
            .text
            .split(u8::is_ascii_whitespace)
            .filter(|cell| !cell.is_empty())
            .collect();
        if cells.is_empty() {
            continue;
        }
        if cells.len() != count {
            return Err(RecordError::Ragged {
                line: line.number,
                found: cells.len(),
                expected: count,
                last: !line.ended,
            });
        }
        for ((cell, series), name) in cells.iter().zip(&mut samples).zip(&header.names) {
            match parse_number(cell).filter(|x| x.is_finite()) {
                Some(value) => series.push(value),
                None => {
                    return Err(RecordError::NotANumber {
                        line: line.number,
                        column: name.clone(),
                        text: String::from_utf8_lossy(cell).into_owned(),
                    });
                }
            }
        }
    }
    let found = samples[0].len();
    if let Some(stated) = header.samples
        && stated != found
    {
        return Err(RecordError::SampleCount {
            format: FORMAT,
            stated: stated as u64,
            found,
        });
    }
    let unit = header.unit.as_deref().map_or(FileUnit::Silent, unit_of_label);
    let series = header.names.iter().zip(samples).map(|(name, samples)| Series {
        sampling_rate_hz: header.rate_hz,
        unit: unit.clone(),
        begins_s: header.begins_s,
        ..Series::new(name.clone(), samples)
    });
    let note = (!header.station.is_empty()).then(|| Remark::StationName(shown(&header.station)).into());
    Ok(FileSeries {
        format: RecordFormat::Saf,
        series: series.collect(),
        notes: note.into_iter().collect(),
    })
}

/// Reads the header; returns also the byte offset and the line number at which the samples begin.
fn header(bytes: &[u8]) -> Result<(Header, usize, usize), RecordError> {
    let mut header = Header::default();
    let (mut at, mut number) = (0, 1);
    while let Some(line) = line_at(bytes, at, number)? {
        (at, number) = (line.next, number + 1);
        if line.text.starts_with(b"####") {
            return Ok((header, at, number));
        }
        let text = String::from_utf8_lossy(line.text);
        if text.starts_with('#') {
            continue;
        }
        let Some((key, value)) = text.split_once('=') else {
            continue;
        };
        let (key, value) = (key.trim(), value.trim());
        let refused = |wanted: Expected| RecordError::LineIsNot {
            format: FORMAT,
            line: line.number,
            text: value.chars().take(80).collect(),
            wanted: wanted.into(),
        };
        match key {
            "STA_CODE" => header.station = value.to_owned(),
            "UNITS" => header.unit = Some(value.to_owned()),
            "SAMP_FREQ" => {
                let rate = value.parse::<f64>().ok().filter(|f| *f > 0.0 && f.is_finite());
                header.rate_hz = Some(rate.ok_or_else(|| refused(Expected::SafRate))?);
            }
            "NDAT" => header.samples = Some(value.parse().map_err(|_| refused(Expected::NumberOfSamples))?),
            "START_TIME" => {
                let parts: Vec<f64> = value
                    .split_whitespace()
                    .filter_map(|part| part.parse().ok())
                    .collect();
                let begins = <[f64; 6]>::try_from(parts).ok().and_then(time_of);
                header.begins_s = Some(begins.ok_or_else(|| refused(Expected::SafTime))?);
            }
            key => {
                let channel = key.strip_prefix("CH").and_then(|key| key.strip_suffix("_ID"));
                if let Some(Ok(place)) = channel.map(str::parse::<usize>) {
                    if place != header.names.len() || place >= CHANNELS_MOST {
                        return Err(refused(Expected::SafNextChannel));
                    }
                    let words: Vec<&str> = value.split_whitespace().collect();
                    header.names.push(shown(&words.join(" ")));
                }
            }
        }
    }
    Err(RecordError::HeaderLacks {
        format: FORMAT,
        what: Expected::SafEnd.into(),
    })
}
