//! From paths to values: project files, and the records they name, conditioned as they say.

use crate::files;
use anyhow::{Context as _, Result, bail};
use dolmen::signal::{
    Channel, ChannelFault, Join, Processing, Record, SignalError, Trend, band_pass, cut, decimate, detrend,
    inspect, low_pass,
};
use dolmen_project::{ChannelSource, Column, Conditioning, Files, Project, RecordSource, parse_project_with};
use dolmen_records::records::{
    self, Delimiter, Pick, Reading, RecordOptions, Station, TimeColumn, Unit, join_stations, read_record,
};
use std::path::{Path, PathBuf};

/// A project and the file it came from.
pub(crate) struct Opened {
    pub(crate) project: Project,
    pub(crate) file: PathBuf,
}

/// Reads the project file that `path` means.
pub(crate) fn project(path: &Path) -> Result<Opened> {
    let file = files::project_file(path)?;
    refuse_record(&file)?;
    let text = files::read_text(&file)?;
    let folder = file.parent().unwrap_or(Path::new(".")).to_owned();
    let others =
        Files::from_loader(move |name| files::read(&folder.join(name)).map_err(|why| format!("{why:#}")));
    let project = parse_project_with(&text, &file.display().to_string(), &others)?;
    Ok(Opened { project, file })
}

/// Names what to do with a record that stands where a project file should.
fn refuse_record(file: &Path) -> Result<()> {
    const RECORDS: [&str; 18] = [
        "csv", "tsv", "npy", "mat", "wav", "uff", "unv", "saf", "gcf", "tdms", "mseed", "miniseed", "sac",
        "xls", "xlsx", "at2", "v2", "zip",
    ];
    let ending = file.extension().map(|e| e.to_string_lossy().to_lowercase());
    let is_record = ending.as_deref().is_some_and(|ending| RECORDS.contains(&ending));
    if is_record {
        let name = file
            .file_name()
            .map(|n| n.to_string_lossy().into_owned())
            .unwrap_or_default();
        bail!(
            "{} is a record, not a project file: write a file project.toml beside it that names it, and give that\n\n\
             schema = 1\nkind = \"survey\"\nname = {{ en = \"My survey\" }}\n[survey.one.records]\nfile = \"{name}\"\n\
             sampling_rate = \"100 Hz\"   # where the file does not say it",
            file.display()
        );
    }
    Ok(())
}

/// A record as it is to be used, and what it was when read.
pub(crate) struct OpenedRecord {
    pub(crate) record: Record,
    pub(crate) channels: usize,
    pub(crate) samples: usize,
    pub(crate) sampling_rate_hz: f64,
    pub(crate) unit: String,
    pub(crate) remarks: Vec<String>,
    pub(crate) faults: Vec<ChannelFault>,
}

/// Reads the record file of a survey, or its several files as one record, as [`record_of`] does.
pub(crate) fn record(source: &RecordSource, project_file: &Path) -> Result<OpenedRecord> {
    let folder = project_file.parent().unwrap_or(Path::new("."));
    let read = |source: &RecordSource| {
        let path = folder.join(&source.file);
        reading(&files::read(&path)?, source).with_context(|| path.display().to_string())
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

/// A record from the bytes of one file but for the channels to be left out (they may hold anything, NaN too); faulty channels
/// looked for, conditioned.
pub(crate) fn record_of(bytes: &[u8], source: &RecordSource) -> Result<OpenedRecord> {
    opened(reading(bytes, source)?, source)
}

fn reading(bytes: &[u8], source: &RecordSource) -> Result<Reading> {
    let mut reading = read_record(bytes, &options(source)?)?;
    let left_out: Vec<String> = source.channels.iter().filter(|c| c.leave_out).map(name).collect();
    if !left_out.is_empty() {
        reading.record.note(Processing::LeftOut { channels: left_out });
    }
    Ok(reading)
}

fn opened(reading: Reading, source: &RecordSource) -> Result<OpenedRecord> {
    let remarks = reading.remarks();
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
        remarks,
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

fn name(channel: &ChannelSource) -> String {
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

fn options(source: &RecordSource) -> Result<RecordOptions> {
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

fn condition(mut record: Record, steps: &Conditioning) -> Result<Record> {
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
