//! Joins the channels of a file, each with its own sampling, into one record.

use super::csv::refuse_counts;
use super::lost_samples::keep_longest;
use super::series::{FileSeries, Series};
use super::{ChannelsLayout, Column, FileUnit, FoundChannel, Layout, Reading, RecordError, RecordOptions};
use crate::limits::refuse_channels;
use crate::unit::Unit;
use dolmen::signal::{Channel, Join, Piece, Processing, Quantity, Record, join, scale};
use std::collections::BTreeSet;

/// Relative difference allowed between a given rate and that of the file, as with time stamps.
const RATE_TOLERANCE: f64 = 1e-4;

/// One record of the requested channels of a file, in SI units.
pub(super) fn assembled(found: FileSeries, options: &RecordOptions) -> Result<Reading, RecordError> {
    refuse_channels(found.format.name(), found.series.len())?;
    if options.picks.is_empty() {
        for one in &found.series {
            let channel = [Channel::named(one.name.clone())];
            refuse_counts(&one.samples, one.samples.len().max(1), &channel)?;
        }
    }
    let layout = ChannelsLayout {
        format: found.format,
        channels: found.series.iter().map(found_channel).collect(),
        notes: found.notes.clone(),
    };
    let RequestedChannels {
        pieces,
        unit,
        clocked,
        cut,
    } = wanted(found, options)?;
    let joined = join(pieces, &Join::default())?;
    let begins_s = joined.begins_s.filter(|_| clocked);
    let mut record = reread(joined.record, layout.format.name(), (unit, cut))?;
    let factors = factors(options, record.channels().len());
    if factors.iter().any(|factor| *factor != 1.0) {
        record = scale(record, &factors)?;
    }
    Ok(Reading {
        record,
        begins_s,
        layout: Layout::Channels(layout),
    })
}

/// The record, with the reading as the first step of its processing history.
fn reread(
    record: Record,
    format: &str,
    (unit, cut): (String, Vec<Processing>),
) -> Result<Record, RecordError> {
    let samples = (0..record.channels().len()).map(|j| record.samples(j).to_vec());
    let mut out = Record::new(
        record.channels().to_vec(),
        samples.collect(),
        record.sampling_rate_hz(),
    )?;
    out.note(Processing::Read {
        format: format.to_owned(),
        unit,
    });
    cut.into_iter()
        .chain(record.history().iter().cloned())
        .for_each(|step| out.note(step));
    Ok(out)
}

fn found_channel(series: &Series) -> FoundChannel {
    FoundChannel {
        name: series.name.clone(),
        samples: series.samples.len(),
        sampling_rate_hz: series.sampling_rate_hz,
        unit: series.unit.clone(),
        begins_s: series.begins_s.map(|at| at + series.offset_s),
    }
}

/// Factor of each channel.
pub(super) fn factors(options: &RecordOptions, channels: usize) -> Vec<f64> {
    let of = |at: usize| options.picks.get(at).and_then(|pick| pick.scale);
    let shared = options.scale.unwrap_or(1.0);
    (0..channels).map(|at| of(at).unwrap_or(shared)).collect()
}

/// The requested channels, with the names of the project.
struct RequestedChannels {
    pieces: Vec<Piece>,
    /// Unit of the columns in the file, or their units if they differ.
    unit: String,
    /// Whether the start times are clock times, not only relative to each other.
    clocked: bool,
    /// Parts that were cut off because of lost samples.
    cut: Vec<Processing>,
}

fn wanted(mut found: FileSeries, options: &RecordOptions) -> Result<RequestedChannels, RecordError> {
    let format = found.format.name();
    let chosen = chosen(&found, options)?;
    let mut units = BTreeSet::new();
    let all_begin = chosen.iter().all(|&at| found.series[at].begins_s.is_some());
    let mut picked: Vec<&mut Series> = found
        .series
        .iter_mut()
        .enumerate()
        .filter(|(at, _)| chosen.contains(at))
        .map(|(_, one)| one)
        .collect();
    let cut = keep_longest(&mut picked, all_begin, options.lost_samples)?;
    let mut pieces = Vec::with_capacity(chosen.len());
    let mut series: Vec<Option<Series>> = found.series.into_iter().map(Some).collect();
    for (k, &at) in chosen.iter().enumerate() {
        let Some(one) = series[at].take() else { continue };
        let scaled = options.scale.is_some() || options.picks.get(k).is_some_and(|pick| pick.scale.is_some());
        let unit = unit_of(&one, options.unit, scaled, format)?;
        units.insert(unit.symbol());
        let rate_hz = rate_of(&one, options.sampling_rate_hz, format)?;
        let mut samples = one.samples;
        samples.iter_mut().for_each(|x| *x *= unit.si());
        let mut channel = Channel::named(one.name);
        channel.position_m = one.position_m;
        channel.direction = one.direction;
        if let Some(pick) = options.picks.get(k) {
            channel = Channel {
                position_m: pick.channel.position_m.or(channel.position_m),
                direction: pick.channel.direction.or(channel.direction),
                ..pick.channel.clone()
            };
        }
        channel.quantity = unit.quantity();
        let origin_s = one.begins_s.filter(|_| all_begin).unwrap_or(0.0);
        pieces.push(Piece {
            channel,
            samples,
            sampling_rate_hz: rate_hz,
            begins_s: Some(origin_s + one.offset_s),
        });
    }
    Ok(RequestedChannels {
        pieces,
        unit: named(&units),
        clocked: all_begin,
        cut,
    })
}

/// Text for the units: "mg", or "mg and not given" if channels differ.
fn named(units: &BTreeSet<&'static str>) -> String {
    let words = units.iter().map(|unit| match *unit {
        "" if units.len() > 1 => "not given",
        unit => unit,
    });
    words.rev().collect::<Vec<_>>().join(" and ")
}

/// The channels to read, in order.
fn chosen(found: &FileSeries, options: &RecordOptions) -> Result<Vec<usize>, RecordError> {
    let names: Vec<&str> = found.series.iter().map(|s| s.name.as_str()).collect();
    if options.picks.is_empty() {
        return Ok((0..names.len()).collect());
    }
    let mut chosen: Vec<usize> = Vec::with_capacity(options.picks.len());
    for pick in &options.picks {
        let at = match &pick.column {
            Column::Number(n) if (1..=names.len()).contains(n) => n - 1,
            Column::Number(n) => {
                return Err(RecordError::ColumnNumber {
                    given: *n,
                    columns: names.len(),
                });
            }
            Column::Named(given) => match names.iter().filter(|name| *name == given).count() {
                1 => names.iter().position(|name| name == given).unwrap_or(0),
                0 => {
                    let near = |name: &&&str| strsim::jaro_winkler(name, given) > 0.8;
                    return Err(RecordError::UnknownColumn {
                        given: given.clone(),
                        nearest: names.iter().find(near).map(|name| (*name).to_owned()),
                        names: names.iter().map(|name| (*name).to_owned()).collect(),
                    });
                }
                count => {
                    return Err(RecordError::AmbiguousColumn {
                        given: given.clone(),
                        count,
                    });
                }
            },
        };
        if let Some(first) = chosen.iter().position(|c| *c == at) {
            return Err(RecordError::PickedTwice {
                column: names[at].to_owned(),
                first: options.picks[first].channel.name.clone(),
                second: pick.channel.name.clone(),
            });
        }
        chosen.push(at);
    }
    Ok(chosen)
}

/// The unit of a channel: that of the file, or the given one. A given unit never replaces that of the file.
fn unit_of(series: &Series, given: Unit, scaled: bool, format: &'static str) -> Result<Unit, RecordError> {
    if let Some(quantity) = series.quantity
        && given.quantity() != Quantity::Unknown
        && given.quantity() != quantity
    {
        return Err(RecordError::UnitDisagrees {
            channel: series.name.clone(),
            given: given.symbol(),
            found: match quantity {
                Quantity::Acceleration => "accelerations",
                Quantity::Velocity => "velocities",
                Quantity::Displacement => "displacements",
                Quantity::Unknown => "something else",
            },
        });
    }
    match (&series.unit, given) {
        // a scale converts the numbers from the unit of the file to the given one
        (FileUnit::Known(found), Unit::Unknown) => Ok(*found),
        (FileUnit::Known(found), given) if scaled || *found == given || found.symbol() == given.symbol() => {
            Ok(given)
        }
        (FileUnit::Known(found), given) => Err(RecordError::UnitDisagrees {
            channel: series.name.clone(),
            given: given.symbol(),
            found: found.symbol(),
        }),
        (FileUnit::Other(found), given) if given.quantity() != Quantity::Unknown && !scaled => {
            Err(RecordError::NoScale {
                format,
                channel: series.name.clone(),
                found: found.clone(),
                given: given.symbol(),
            })
        }
        (_, given) => Ok(given),
    }
}

fn rate_of(series: &Series, given: Option<f64>, format: &'static str) -> Result<f64, RecordError> {
    match (series.sampling_rate_hz, given) {
        (Some(found), Some(given)) if (given / found - 1.0).abs() > RATE_TOLERANCE => {
            Err(RecordError::FileRateDisagrees { given, found })
        }
        (Some(found), _) => Ok(found),
        (None, Some(given)) => Ok(given),
        (None, None) => Err(RecordError::NoRateHere { format }),
    }
}
