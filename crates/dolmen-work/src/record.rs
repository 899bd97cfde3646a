//! The record of a survey: read with the settings of the project file, checked for faulty channels, conditioned.

use crate::error::{Within as _, WorkError};
use crate::station_clocks::{ClockDoubt, clock_doubts};
use crate::wrong::FileRemark;
use dolmen::modal::{Losses, earthquakes_in};
use dolmen::signal::{
    Channel, ChannelFault, Join, Processing, Record, SignalError, Trend, band_pass, cut, decimate, detrend,
    inspect_apart, low_pass,
};
use dolmen_project::{ChannelSource, Column, Conditioning, RecordSource};
use dolmen_records::records::{
    self, Delimiter, LostSamples, Pick, Reading, RecordOptions, Station, TimeColumn, Unit, join_stations,
    read_record,
};
use dolmen_records::{Files, RECORD_BYTES_MOST};
use dolmen_words::message::Both;

/// A record ready for use, and its properties when read.
pub(crate) struct OpenedRecord {
    pub(crate) record: Record,
    pub(crate) channels: usize,
    pub(crate) samples: usize,
    pub(crate) sampling_rate_hz: f64,
    pub(crate) unit: String,
    /// Time of the first sample, s from 1 January 1970 in the clock of the file.
    pub(crate) begins_s: Option<f64>,
    pub(crate) remarks: Vec<Both>,
    pub(crate) unread_stamps: Vec<String>,
    /// Files whose dates contradict the given starts.
    pub(crate) clock_doubts: Vec<ClockDoubt>,
    pub(crate) faults: Vec<ChannelFault>,
    /// Its lost samples.
    pub(crate) losses: Losses,
    /// Whether it contains a strong motion that is excluded from the search for faults.
    pub(crate) is_shaken: bool,
}

/// Seconds before and after an earthquake that are also excluded from the search for faults.
const BEFORE_S: f64 = 1.0;
const BEHIND_S: f64 = 5.0;

/// Reads the record file of a survey, or its several files as one record, as [`record_of`] does.
pub(crate) fn record(source: &RecordSource, files: &dyn Files) -> Result<OpenedRecord, WorkError> {
    let mut composed: Vec<Both> = Vec::new();
    let mut read = |source: &RecordSource| {
        if files.is_composed_otherwise(&source.file) {
            let file = source.file.clone();
            composed.push(FileRemark::ComposedOtherwise { file }.into());
        }
        let bytes = files.read(&source.file, RECORD_BYTES_MOST)?;
        reading(&bytes, source).within(|| files.shown(&source.file))
    };
    if source.stations.is_empty() {
        let reading = read(source)?;
        return opened(reading, source, composed);
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
    let clock_doubts = clock_doubts(&stations, source.starts);
    let opened = opened(join_stations(stations, &options)?, source, composed)?;
    Ok(OpenedRecord {
        clock_doubts,
        ..opened
    })
}

/// As [`record`], but a record with an earthquake keeps the parts on both sides of its lost samples, so that its times count from its first
/// sample, and the part before the loss is available.
pub(crate) fn record_to_identify(
    source: &RecordSource,
    files: &dyn Files,
) -> Result<OpenedRecord, WorkError> {
    let read = record(source, files)?;
    let is_cut_short = |step: &Processing| matches!(step, Processing::LongestSpan { .. });
    let is_cut_short = read.record.history().iter().any(is_cut_short);
    let is_sought =
        source.stations.is_empty() && !source.modal.without_earthquake && source.conditioning.cut.is_none();
    if !is_cut_short || !is_sought {
        return Ok(read);
    }
    let all = RecordSource {
        lost_samples: LostSamples::Bridged,
        ..source.clone()
    };
    // lost samples that cannot be bridged leave the longest span
    let bridged = record(&all, files).ok().filter(|bridged| bridged.is_shaken);
    Ok(bridged.unwrap_or(read))
}

fn reading(bytes: &[u8], source: &RecordSource) -> Result<Reading, WorkError> {
    let mut reading = read_record(bytes, &options(source)?)?;
    let left_out: Vec<String> = source.channels.iter().filter(|c| c.leave_out).map(name).collect();
    if !left_out.is_empty() {
        reading.record.note(Processing::LeftOut { channels: left_out });
    }
    Ok(reading)
}

/// A record as it was read, with `remarks` on its files.
fn opened(
    reading: Reading,
    source: &RecordSource,
    mut remarks: Vec<Both>,
) -> Result<OpenedRecord, WorkError> {
    remarks.extend(reading.remarks());
    let unread_stamps = reading.unread_stamps();
    let begins_s = reading.begins_s;
    let record = reading.record;
    let left_out: usize = std::iter::once(source)
        .chain(&source.stations)
        .map(|source| source.channels.iter().filter(|c| c.leave_out).count())
        .sum();
    let (channels, samples) = (record.channels().len() + left_out, record.length());
    let sampling_rate_hz = record.sampling_rate_hz();
    let unit = unit_of(source, &record);
    let losses = Losses {
        lost_s: lost_s(&record),
        clipped: Vec::new(),
    };
    let shaken_s: Vec<[f64; 2]> = match source.modal.without_earthquake {
        true => Vec::new(),
        false => earthquakes_in(&record, &[], &losses.lost_s)
            .iter()
            .map(|of| [(of.arrival_s - BEFORE_S).max(0.0), of.end_s + BEHIND_S])
            .collect(),
    };
    let mut faults = inspect_apart(&record, &losses.lost_s, &shaken_s);
    let losses = Losses {
        clipped: clipped(&faults),
        ..losses
    };
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
        clock_doubts: Vec::new(),
        faults,
        is_shaken: !shaken_s.is_empty(),
        losses,
    })
}

/// Clipped channels.
fn clipped(faults: &[ChannelFault]) -> Vec<String> {
    let held = faults
        .iter()
        .filter(|fault| matches!(fault, ChannelFault::Clipped { .. }));
    held.map(|fault| fault.channel().to_owned()).collect()
}

/// Times of lost and bridged samples, s from the first sample.
fn lost_s(record: &Record) -> Vec<[f64; 2]> {
    let step_s = 1.0 / record.sampling_rate_hz();
    let (mut lost, mut gone_s) = (Vec::new(), 0.0);
    for step in record.history() {
        match step {
            Processing::Bridged { gaps } => {
                lost.extend(gaps.iter().map(|gap| [gap.at_s, gap.at_s + gap.lost_s + step_s]));
            }
            Processing::CommonTime { before_s, .. } => gone_s += before_s,
            _ => {}
        }
    }
    lost.iter()
        .map(|span: &[f64; 2]| span.map(|at_s| at_s - gone_s))
        .collect()
}

/// The unit from the project or the file.
fn unit_of(source: &RecordSource, record: &Record) -> String {
    let read = record.history().iter().find_map(|step| match step {
        Processing::Read { unit, .. } if !unit.is_empty() => Some(unit.clone()),
        _ => None,
    });
    source.unit.clone().or(read).unwrap_or_default()
}

/// Name of a channel.
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
