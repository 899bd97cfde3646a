//! Reads records of a survey.

use super::file::{ChannelRaw, ColumnRaw, RecordsRaw, StartsRaw, StationRaw};
use super::read_conditioning::{conditioning, modal};
use super::records::{ChannelSource, Column, Conditioning, ModalChoice, RecordFormat, RecordSource};
use crate::direction_vector::direction_vector;
use crate::error::Fault;
use crate::file_number::{At, NumberRaw, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::said;
use crate::wrong::{Common, WrongRecords};
use dolmen::signal::Starts;
use dolmen_records::motions::start_of_text;
use dolmen_records::records::{LostSamples, Unit};
use std::collections::BTreeMap;
use std::ops::Range;

/// Largest number of a column that a project may name.
const COLUMN_MOST: usize = 10_000;

fn column(reader: &mut Reader, raw: &At<ColumnRaw>, path: &str) -> Option<Column> {
    match &raw.value {
        ColumnRaw::Name(name) => Some(Column::Name(name.clone())),
        ColumnRaw::Number(number) => {
            let number = At {
                span: raw.span.clone(),
                value: *number,
            };
            reader
                .count(Some(&number), path, 1, COLUMN_MOST)
                .map(Column::Number)
        }
    }
}

fn channel(reader: &mut Reader, raw: &At<ChannelRaw>, path: &str) -> Option<ChannelSource> {
    let raw = &raw.value;
    let column = raw
        .column
        .as_ref()
        .and_then(|raw| column(reader, raw, &format!("{path}.column")));
    let position_m = raw
        .position
        .as_ref()
        .and_then(|raw| position(reader, raw, &format!("{path}.position")));
    let direction = raw
        .direction
        .as_ref()
        .and_then(|raw| direction_vector(reader, raw, &format!("{path}.direction")));
    Some(ChannelSource {
        column: column?,
        name: raw.name.as_ref().map(|name| name.value.clone()),
        position_m,
        direction,
        scale: factor(reader, raw.scale.as_ref(), &format!("{path}.scale")),
        leave_out: raw.leave_out.unwrap_or(false),
    })
}

fn position(reader: &mut Reader, raw: &At<Vec<At<QuantityRaw>>>, path: &str) -> Option<[f64; 3]> {
    if raw.value.len() != 3 {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            Common::HasNumbers {
                path: path.to_string(),
                count: raw.value.len().to_string(),
            },
        );
        reader.fault(fault.allowed(WrongRecords::MustBeXRight));
        return None;
    }
    let mut position_m = [0.0; 3];
    for (i, (place, raw)) in position_m.iter_mut().zip(&raw.value).enumerate() {
        let path = format!("{path}[{}]", i + 1);
        *place = reader
            .quantity(Some(raw), &path, Measure::Length, Bound::Any)?
            .value;
    }
    Some(position_m)
}

/// The keys of one file, for a record or a station.
struct FileKeys<'a> {
    file: Option<&'a At<String>>,
    format: Option<&'a At<RecordFormat>>,
    begins: Option<&'a At<NumberRaw>>,
    sampling_rate: Option<&'a At<QuantityRaw>>,
    unit: Option<&'a At<String>>,
    scale: Option<&'a At<f64>>,
    delimiter: Option<&'a At<String>>,
    time_column: Option<&'a At<ColumnRaw>>,
    lost_samples: Option<&'a At<LostSamples>>,
    channels: &'a [At<ChannelRaw>],
}

pub(super) fn records(reader: &mut Reader, raw: &At<RecordsRaw>, path: &str) -> Option<RecordSource> {
    let span = &raw.span;
    let raw = &raw.value;
    let conditioning = raw
        .conditioning
        .as_ref()
        .map(|raw| conditioning(reader, raw, &format!("{path}.conditioning")))
        .unwrap_or_default();
    let modal = raw
        .modal
        .as_ref()
        .map(|raw| modal(reader, raw, &format!("{path}.modal")))
        .unwrap_or_default();
    let keys = FileKeys {
        file: raw.file.as_ref(),
        format: raw.format.as_ref(),
        begins: None,
        sampling_rate: raw.sampling_rate.as_ref(),
        unit: raw.unit.as_ref(),
        scale: raw.scale.as_ref(),
        delimiter: raw.delimiter.as_ref(),
        time_column: raw.time_column.as_ref(),
        lost_samples: raw.lost_samples.as_ref(),
        channels: raw.channels.as_deref().unwrap_or_default(),
    };
    let listed = raw.stations.as_deref().unwrap_or_default();
    if listed.is_empty() {
        judge_one_file(reader, raw, span, path);
        return one_file(reader, &keys, path).map(|source| RecordSource {
            conditioning,
            modal,
            ..source
        });
    }
    refuse_beside_stations(reader, &keys, path);
    let stations: Vec<RecordSource> = listed
        .iter()
        .enumerate()
        .filter_map(|(i, raw)| station(reader, &raw.value, &format!("{path}.stations[{}]", i + 1)))
        .collect();
    if stations.len() < listed.len() {
        return None;
    }
    let files: Vec<&str> = stations.iter().map(|station| station.file.as_str()).collect();
    Some(RecordSource {
        file: files.join(", "),
        format: None,
        starts: match raw.starts.as_ref().map(|starts| starts.value) {
            Some(StartsRaw::Together) => Starts::Together,
            None | Some(StartsRaw::Stated) => Starts::Stated,
        },
        begins_s: None,
        sampling_rate_hz: None,
        unit: shared_unit(&stations),
        scale: None,
        delimiter: None,
        time_column: None,
        lost_samples: LostSamples::default(),
        channels: Vec::new(),
        conditioning,
        modal,
        stations,
    })
}

/// A record of one file names the file, and has one start.
fn judge_one_file(reader: &mut Reader, raw: &RecordsRaw, span: &Range<usize>, path: &str) {
    if raw.file.is_none() {
        let fault = Fault::new(span.clone(), path, WrongRecords::NamesNoFile(path.to_string()));
        reader.fault(
            fault
                .allowed(WrongRecords::FileIsMissing)
                .help(WrongRecords::WriteFileRecordCsv),
        );
    }
    if let Some(starts) = &raw.starts {
        let path = format!("{path}.starts");
        let fault = Fault::new(
            starts.span.clone(),
            &path,
            WrongRecords::StandsWithoutStations(path.to_string()),
        );
        reader.fault(fault.help(WrongRecords::OneFileHasOne));
    }
}

/// Rejects keys of a file beside stations, each of which has its own.
fn refuse_beside_stations(reader: &mut Reader, keys: &FileKeys<'_>, path: &str) {
    let own = [
        ("file", keys.file.map(|k| &k.span)),
        ("format", keys.format.map(|k| &k.span)),
        ("sampling_rate", keys.sampling_rate.map(|k| &k.span)),
        ("unit", keys.unit.map(|k| &k.span)),
        ("scale", keys.scale.map(|k| &k.span)),
        ("delimiter", keys.delimiter.map(|k| &k.span)),
        ("time_column", keys.time_column.map(|k| &k.span)),
        ("lost_samples", keys.lost_samples.map(|k| &k.span)),
        ("channels", keys.channels.first().map(|k| &k.span)),
    ];
    for (key, span) in own {
        if let Some(span) = span {
            let message = WrongRecords::StandsBesideStations {
                path: path.to_string(),
                key: key.to_string(),
            };
            let fault = Fault::new(span.clone(), &format!("{path}.{key}"), message);
            reader.fault(fault.help(WrongRecords::WriteItWithEach));
        }
    }
}

/// The unit, if it is the same for all stations.
fn shared_unit(stations: &[RecordSource]) -> Option<String> {
    let first = stations.first()?.unit.clone()?;
    let all = stations
        .iter()
        .all(|station| station.unit.as_ref() == Some(&first));
    all.then_some(first)
}

fn station(reader: &mut Reader, raw: &StationRaw, path: &str) -> Option<RecordSource> {
    let keys = FileKeys {
        file: raw.file.as_ref(),
        format: raw.format.as_ref(),
        begins: raw.begins.as_ref(),
        sampling_rate: raw.sampling_rate.as_ref(),
        unit: raw.unit.as_ref(),
        scale: raw.scale.as_ref(),
        delimiter: raw.delimiter.as_ref(),
        time_column: raw.time_column.as_ref(),
        lost_samples: raw.lost_samples.as_ref(),
        channels: raw.channels.as_deref().unwrap_or_default(),
    };
    one_file(reader, &keys, path)
}

/// Seconds, or a date and time.
fn begins(reader: &mut Reader, raw: &At<NumberRaw>, path: &str) -> Option<f64> {
    let (found, written) = match &raw.value {
        NumberRaw::Number(seconds) => (Some(*seconds).filter(|s| s.is_finite()), short(*seconds)),
        NumberRaw::Text(text) => (start_of_text(text), text.clone()),
    };
    if found.is_none() {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            WrongRecords::IsNoTime {
                path: path.to_string(),
                written: format!("{:?}", written),
            },
        );
        reader.fault(fault.allowed(WrongRecords::MustBeTimeSuch));
    }
    found
}

/// A factor: finite and not 0.
fn factor(reader: &mut Reader, raw: Option<&At<f64>>, path: &str) -> Option<f64> {
    let raw = raw?;
    if raw.value.is_finite() && raw.value != 0.0 {
        return Some(raw.value);
    }
    let fault = Fault::new(
        raw.span.clone(),
        path,
        WrongRecords::IsNoScale {
            path: path.to_string(),
            given: short(raw.value),
        },
    );
    reader.fault(fault.allowed(WrongRecords::MustBeFiniteNumber));
    None
}

fn one_file(reader: &mut Reader, raw: &FileKeys<'_>, path: &str) -> Option<RecordSource> {
    let rate_path = format!("{path}.sampling_rate");
    let sampling_rate = reader.quantity(raw.sampling_rate, &rate_path, Measure::Frequency, Bound::Positive);
    if let Some(unit) = raw.unit {
        sample_unit(reader, unit, &format!("{path}.unit"));
    }
    let scale = factor(reader, raw.scale, &format!("{path}.scale"));
    let begins_s = raw
        .begins
        .and_then(|raw| begins(reader, raw, &format!("{path}.begins")));
    let delimiter = raw
        .delimiter
        .and_then(|raw| delimiter(reader, raw, &format!("{path}.delimiter")));
    let time_column = raw
        .time_column
        .and_then(|raw| column(reader, raw, &format!("{path}.time_column")));
    let listed = raw.channels.iter().enumerate();
    let channels: Vec<ChannelSource> = listed
        .filter_map(|(i, raw)| channel(reader, raw, &format!("{path}.channels[{}]", i + 1)))
        .collect();
    distinct(reader, raw.channels, path);
    let file = raw.file?;
    let format = format(reader, raw.format, file, path)?;
    if format == Some(RecordFormat::Npy) && raw.sampling_rate.is_none() {
        let fault = Fault::new(
            file.span.clone(),
            &rate_path,
            WrongRecords::HoldsNoTimeStamps(file.value.to_string()),
        );
        reader.fault(
            fault
                .allowed(WrongRecords::SamplingRateIsMissing)
                .help(WrongRecords::WriteSamplingRateHz),
        );
    }
    Some(RecordSource {
        file: file.value.clone(),
        stations: Vec::new(),
        starts: Starts::Stated,
        begins_s,
        format,
        sampling_rate_hz: sampling_rate.map(|rate| rate.value),
        unit: raw.unit.map(|unit| unit.value.trim().to_owned()),
        scale,
        delimiter,
        time_column,
        lost_samples: raw.lost_samples.map(|raw| raw.value).unwrap_or_default(),
        channels,
        conditioning: Conditioning::default(),
        modal: ModalChoice::default(),
    })
}

/// Extensions of workbooks that no reader of records supports.
const WORKBOOKS: [&str; 3] = ["xlsb", "xls", "ods"];

/// The given format, or that of the extension; texts are inspected, because many formats end in .txt.
fn format(
    reader: &mut Reader,
    raw: Option<&At<RecordFormat>>,
    file: &At<String>,
    path: &str,
) -> Option<Option<RecordFormat>> {
    if let Some(raw) = raw {
        return Some(Some(raw.value));
    }
    let ending = file.value.rsplit_once('.').map_or("", |(_, ending)| ending);
    match RecordFormat::of_ending(ending) {
        Some(RecordFormat::Csv) => Some(None),
        Some(format) => Some(Some(format)),
        None => {
            let path = format!("{path}.file");
            let message = WrongRecords::FormatOfIsNot(file.value.to_string());
            let names: Vec<String> = RecordFormat::ALL
                .iter()
                .map(|format| format!("\"{}\"", format.name()))
                .collect();
            let fault = Fault::new(file.span.clone(), &path, message);
            let is_workbook = WORKBOOKS.iter().any(|of| ending.eq_ignore_ascii_case(of));
            reader.fault(fault.help(match is_workbook {
                true => WrongRecords::SaveAsXlsx,
                false if may_lie_outside(&file.value) => WrongRecords::CopyItAndWriteFormat(names.join(", ")),
                false => WrongRecords::WriteFormatOneOf(names.join(", ")),
            }));
            None
        }
    }
}

/// Whether a path may lead outside the project folder, where files are read only with permission.
fn may_lie_outside(file: &str) -> bool {
    let path = std::path::Path::new(file);
    let mut parts = path.components();
    path.has_root()
        || parts.any(|part| {
            matches!(
                part,
                std::path::Component::ParentDir | std::path::Component::Prefix(_)
            )
        })
}

/// Checks that the readers of records know the unit of samples.
fn sample_unit(reader: &mut Reader, unit: &At<String>, path: &str) {
    if let Err(why) = Unit::parse(&unit.value) {
        let message = WrongRecords::IsNoUnitOf {
            path: path.to_string(),
            unit: unit.value.trim().to_string(),
        };
        let fault = Fault::new(unit.span.clone(), path, message);
        reader.fault(fault.allowed(Common::UnknownUnit).help(said(&why)));
    }
}

fn delimiter(reader: &mut Reader, raw: &At<String>, path: &str) -> Option<char> {
    let mut characters = raw.value.chars();
    match (characters.next(), characters.next()) {
        (Some(one), None) => Some(one),
        _ => {
            let fault = Fault::new(
                raw.span.clone(),
                path,
                WrongRecords::IsNotOneCharacter {
                    path: path.to_string(),
                    given: format!("{:?}", raw.value),
                },
            );
            reader.fault(fault.allowed(WrongRecords::MustBeOneCharacter));
            None
        }
    }
}

/// Channels must have names and columns of their own.
fn distinct(reader: &mut Reader, channels: &[At<ChannelRaw>], path: &str) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for (i, channel) in channels.iter().enumerate() {
        let mut twice = |what: &str, value: String, span: &Range<usize>| {
            let first = *seen.entry(format!("{what} {value}")).or_insert(i);
            if first != i {
                let path = format!("{path}.channels[{}].{what}", i + 1);
                let message = WrongRecords::IsThatOfChannels {
                    path: path.to_string(),
                    value: value.to_string(),
                    first: (first + 1).to_string(),
                };
                reader.fault(Fault::new(span.clone(), &path, message).allowed(WrongRecords::MustDiffer));
            }
        };
        if let Some(name) = &channel.value.name {
            twice("name", format!("\"{}\"", name.value), &name.span);
        }
        match &channel.value.column {
            Some(At {
                span,
                value: ColumnRaw::Number(number),
            }) => twice("column", number.to_string(), span),
            Some(At {
                span,
                value: ColumnRaw::Name(name),
            }) => twice("column", format!("\"{name}\""), span),
            None => {}
        }
    }
}
