//! The record of a survey: read as the project file says, looked through for faulty channels, conditioned.

use crate::error::{Within as _, WorkError};
use dolmen::signal::{
    Channel, ChannelFault, Join, Processing, Record, SignalError, Trend, band_pass, cut, decimate, detrend,
    inspect, low_pass,
};
use dolmen_project::{ChannelSource, Column, Conditioning, RecordSource};
use dolmen_records::records::{
    self, Delimiter, Pick, Reading, RecordOptions, Station, TimeColumn, Unit, join_stations, read_record,
};
use dolmen_records::{Files, RECORD_BYTES_MOST};
use dolmen_words::message::Both;

/// A record as it is to be used, and what it was when read.
pub(crate) struct OpenedRecord {
    pub(crate) record: Record,
    pub(crate) channels: usize,
    pub(crate) samples: usize,
    pub(crate) sampling_rate_hz: f64,
    pub(crate) unit: String,
    /// The first sample, s from 1 January 1970 in the clock of the file.
    pub(crate) begins_s: Option<f64>,
    pub(crate) remarks: Vec<Both>,
    pub(crate) unread_stamps: Vec<String>,
    pub(crate) faults: Vec<ChannelFault>,
}

/// Reads the record file of a survey, or its several files as one record, as [`record_of`] does.
pub(crate) fn record(source: &RecordSource, files: &dyn Files) -> Result<OpenedRecord, WorkError> {
    let read = |source: &RecordSource| {
        let bytes = files.read(&source.file, RECORD_BYTES_MOST)?;
        reading(&bytes, source).within(|| files.shown(&source.file))
    };
    if source.stations.is_empty() {
        return opened(read(source)?, source);
    }
    let mut stations = Vec::with_capacity(source.stations.len());
    for station in &source.stations {
        stations.push(Station {
            file: station.file.clone(),
            reading: read(station)?,
            begins_s: station.begins_s,
        });
    }
    let options = Join {
        starts: source.starts,
        ..Join::default()
    };
    opened(join_stations(stations, &options)?, source)
}

fn reading(bytes: &[u8], source: &RecordSource) -> Result<Reading, WorkError> {
    let mut reading = read_record(bytes, &options(source)?)?;
    let left_out: Vec<String> = source.channels.iter().filter(|c| c.leave_out).map(name).collect();
    if !left_out.is_empty() {
        reading.record.note(Processing::LeftOut { channels: left_out });
    }
    Ok(reading)
}

fn opened(reading: Reading, source: &RecordSource) -> Result<OpenedRecord, WorkError> {
    let (remarks, unread_stamps) = (reading.remarks(), reading.unread_stamps());
    let begins_s = reading.begins_s;
    let record = reading.record;
    let left_out: usize = std::iter::once(source)
        .chain(&source.stations)
        .map(|source| source.channels.iter().filter(|c| c.leave_out).count())
        .sum();
    let (channels, samples) = (record.channels().len() + left_out, record.length());
    let sampling_rate_hz = record.sampling_rate_hz();
    let unit = unit_of(source, &record);
    let mut faults = inspect(&record);
    if source
        .conditioning
        .detrend_degree
        .is_some_and(|degree| degree > 0)
    {
        faults.retain(|fault| !matches!(fault, ChannelFault::Drifts { .. }));
    }
    let record = condition(record, &source.conditioning)?;
    Ok(OpenedRecord {
        record,
        channels,
        samples,
        sampling_rate_hz,
        unit,
        begins_s,
        remarks,
        unread_stamps,
        faults,
    })
}

/// The unit as the project or the file says it.
fn unit_of(source: &RecordSource, record: &Record) -> String {
    let read = record.history().iter().find_map(|step| match step {
        Processing::Read { unit, .. } if !unit.is_empty() => Some(unit.clone()),
        _ => None,
    });
    source.unit.clone().or(read).unwrap_or_default()
}

/// What a channel is called.
pub(crate) fn name(channel: &ChannelSource) -> String {
    match (&channel.name, &channel.column) {
        (Some(name), _) | (None, Column::Name(name)) => name.clone(),
        (None, Column::Number(number)) => format!("ch{number}"),
    }
}

fn column(column: &Column) -> records::Column {
    match column {
        Column::Number(number) => records::Column::Number(*number),
        Column::Name(name) => records::Column::Named(name.clone()),
    }
}

fn options(source: &RecordSource) -> Result<RecordOptions, WorkError> {
    let pick = |channel: &ChannelSource| {
        let sensor = Channel {
            position_m: channel.position_m,
            direction: channel.direction,
            ..Channel::named(name(channel))
        };
        Pick {
            scale: channel.scale,
            column: column(&channel.column),
            channel: sensor,
        }
    };
    let used = source.channels.iter().filter(|c| !c.leave_out);
    let picks: Vec<Pick> = used.map(pick).collect();
    if picks.is_empty() && !source.channels.is_empty() {
        return Err(SignalError::NothingLeft {
            channels: source.channels.len(),
        }
        .into());
    }
    Ok(RecordOptions {
        format: source.format,
        scale: source.scale,
        sampling_rate_hz: source.sampling_rate_hz,
        unit: match &source.unit {
            Some(unit) => Unit::parse(unit)?,
            None => Unit::default(),
        },
        picks,
        delimiter: source.delimiter.and_then(|sign| match sign {
            ',' => Some(Delimiter::Comma),
            ';' => Some(Delimiter::Semicolon),
            '\t' => Some(Delimiter::Tab),
            ' ' => Some(Delimiter::WhiteSpace),
            _ => None,
        }),
        time: source
            .time_column
            .as_ref()
            .map_or(TimeColumn::Detect, |given| TimeColumn::At(column(given))),
        lost_samples: source.lost_samples,
        ..RecordOptions::default()
    })
}

fn condition(mut record: Record, steps: &Conditioning) -> Result<Record, WorkError> {
    if let Some(part) = steps.cut {
        record = cut(record, part.from_s, part.to_s)?;
    }
    match steps.detrend_degree {
        None => {}
        Some(0) => record = detrend(record, Trend::Mean),
        Some(_) => record = detrend(record, Trend::Line),
    }
    if let Some(band) = steps.band_pass {
        record = band_pass(record, band.low_hz, band.high_hz, band.order)?;
    }
    if let Some(low) = steps.low_pass {
        record = low_pass(record, low.corner_hz, low.order)?;
    }
    if let Some(factor) = steps.decimate_factor {
        record = decimate(record, factor)?;
    }
    Ok(record)
}
