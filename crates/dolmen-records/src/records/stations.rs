//! One record from several files.

use super::{Reading, RecordError};
use dolmen::signal::{Join, Piece, Processing, Record, join};

/// One of several files of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// Name of the file, which comes before the names of its channels if another file has the same names.
    pub file: String,
    /// Its contents.
    pub reading: Reading,
    /// Time of its first sample, s in a common clock, if the file does not state it.
    pub begins_s: Option<f64>,
}

/// All channels of several files as [one record](dolmen::signal::join).
///
/// # Errors
/// [`RecordError::TwoStarts`] if a start is given for a file with its own; as [`join`].
pub fn join_stations(stations: Vec<Station>, options: &Join) -> Result<Reading, RecordError> {
    let mut pieces: Vec<(String, Piece)> = Vec::new();
    let mut steps: Vec<Processing> = Vec::new();
    let mut layouts = Vec::new();
    for station in stations {
        let begins_s = match (station.reading.begins_s, station.begins_s) {
            (Some(_), Some(_)) => return Err(RecordError::TwoStarts { file: station.file }),
            // the given start is that of the file, whose first samples may have been cut
            (own, given) => own.or(given.map(|at| at + kept_from_s(&station.reading.record))),
        };
        let record = station.reading.record;
        for step in record.history() {
            if !steps.contains(step) {
                steps.push(step.clone());
            }
        }
        for (j, channel) in record.channels().iter().enumerate() {
            let piece = Piece {
                channel: channel.clone(),
                samples: record.samples(j).to_vec(),
                sampling_rate_hz: record.sampling_rate_hz(),
                begins_s,
            };
            pieces.push((stem(&station.file).to_owned(), piece));
        }
        layouts.push(station.reading.layout);
    }
    let names: Vec<String> = pieces
        .iter()
        .map(|(_, piece)| piece.channel.name.clone())
        .collect();
    for (stem, piece) in &mut pieces {
        if names.iter().filter(|name| **name == piece.channel.name).count() > 1 {
            piece.channel.name = format!("{stem} {}", piece.channel.name);
        }
    }
    let joined = join(pieces.into_iter().map(|(_, piece)| piece).collect(), options)?;
    let mut record = Record::new(
        joined.record.channels().to_vec(),
        (0..joined.record.channels().len())
            .map(|j| joined.record.samples(j).to_vec())
            .collect(),
        joined.record.sampling_rate_hz(),
    )?;
    steps.extend(joined.record.history().iter().cloned());
    steps.into_iter().for_each(|step| record.note(step));
    Ok(Reading {
        record,
        begins_s: joined.begins_s,
        layout: super::Layout::Stations(layouts),
    })
}

/// Time of the first sample of a record, s from the first of its file.
fn kept_from_s(record: &Record) -> f64 {
    let of = |step: &Processing| match step {
        Processing::LongestSpan { from_s, .. } => Some(*from_s),
        _ => None,
    };
    record.history().iter().find_map(of).unwrap_or(0.0)
}

/// A file name without folder and ending.
fn stem(file: &str) -> &str {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}
