//! What files of channels yield, each sampled by itself, and how they become one record.

use super::csv::refuse_counts;
use super::lost_samples::{Break, keep_longest};
use super::options::RecordFormat;
use super::{Column, Layout, Reading, RecordError, RecordOptions, Unit};
use dolmen::signal::{Channel, Join, Piece, Processing, Quantity, Record, join, scale};
use std::collections::BTreeSet;

/// Share by which a rate that is given may differ from that of the file, as with time stamps.
const RATE_TOLERANCE: f64 = 1e-4;

/// What a file says of the unit of its numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum FileUnit {
    /// Nothing: the project may give it.
    Silent,
    /// A unit that is known here.
    Known(Unit),
    /// Something else, "V", "counts": a scale takes it to a unit.
    Other(String),
}

/// One channel as its file holds it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Series {
    pub(super) name: String,
    pub(super) samples: Vec<f64>,
    pub(super) sampling_rate_hz: Option<f64>,
    pub(super) unit: FileUnit,
    /// What is measured, if the file says it.
    pub(super) quantity: Option<Quantity>,
    /// First sample, s from 1 January 1970 in the clock of the file.
    pub(super) begins_s: Option<f64>,
    /// First sample, s from an origin that all channels of the file share.
    pub(super) offset_s: f64,
    /// Where it goes on after a gap.
    pub(super) breaks: Vec<Break>,
    pub(super) position_m: Option<[f64; 3]>,
    pub(super) direction: Option<[f64; 3]>,
}

impl Series {
    pub(super) fn new(name: impl Into<String>, samples: Vec<f64>) -> Self {
        Series {
            name: name.into(),
            samples,
            sampling_rate_hz: None,
            unit: FileUnit::Silent,
            quantity: None,
            begins_s: None,
            offset_s: 0.0,
            breaks: Vec::new(),
            position_m: None,
            direction: None,
        }
    }
}

impl Series {
    /// What gap number `i` is refused with.
    pub(super) fn gap(&self, i: usize) -> RecordError {
        let rate_hz = self.sampling_rate_hz.unwrap_or(f64::NAN);
        let mut before = Break { at: 0, begins_s: 0.0 };
        if let Some(last) = i.checked_sub(1).and_then(|i| self.breaks.get(i)) {
            before = *last;
        }
        let after = self.breaks.get(i).copied().unwrap_or(before);
        RecordError::Gap {
            channel: self.name.clone(),
            expected_s: before.begins_s + (after.at - before.at) as f64 / rate_hz,
            found_s: after.begins_s,
        }
    }

    /// Time of the sample that would come next, s from the first.
    pub(super) fn end_s(&self) -> f64 {
        let last = self
            .breaks
            .last()
            .copied()
            .unwrap_or(Break { at: 0, begins_s: 0.0 });
        last.begins_s + (self.samples.len() - last.at) as f64 / self.sampling_rate_hz.unwrap_or(f64::NAN)
    }
}

/// All channels of a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub(super) format: RecordFormat,
    pub(super) series: Vec<Series>,
    /// What else the file says or holds, sentences.
    pub(super) notes: Vec<String>,
}

/// How a file of channels was laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelsLayout {
    /// Its format.
    pub format: RecordFormat,
    /// All its channels, in order.
    pub channels: Vec<FoundChannel>,
    /// What else the file says or holds, sentences.
    pub notes: Vec<String>,
}

/// One channel of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundChannel {
    /// As the file names it.
    pub name: String,
    /// Its samples.
    pub samples: usize,
    /// Samples a second, Hz; `None` if the file does not say it.
    pub sampling_rate_hz: Option<f64>,
    /// What the file says of the unit.
    pub unit: FileUnit,
    /// The first sample, s from 1 January 1970 in the clock of the file, if it says it.
    pub begins_s: Option<f64>,
}

/// 1/step; the whole number of hertz that is within a share `digits` of it, where there is one: a step has lost its last digits.
pub(super) fn rate_of_step(step_s: f64, digits: f64) -> f64 {
    let rate = 1.0 / step_s;
    let whole = rate.round();
    if whole > 0.0 && (rate / whole - 1.0).abs() < digits {
        whole
    } else {
        rate
    }
}

/// One record of the channels wanted of a file, in SI.
pub(super) fn assembled(found: Found, options: &RecordOptions) -> Result<Reading, RecordError> {
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
    let Wanted {
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

/// The same record with the step of reading before its history.
fn reread(
    record: Record,
    format: &str,
    (unit, cut): (String, Option<Processing>),
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

/// What each channel that is read is multiplied by.
pub(super) fn factors(options: &RecordOptions, channels: usize) -> Vec<f64> {
    let of = |at: usize| options.picks.get(at).and_then(|pick| pick.scale);
    let shared = options.scale.unwrap_or(1.0);
    (0..channels).map(|at| of(at).unwrap_or(shared)).collect()
}

/// The channels wanted, named as the project names them.
struct Wanted {
    pieces: Vec<Piece>,
    /// The unit they were in, or their several units.
    unit: String,
    /// Whether they begin at times of a clock, not only beside one another.
    clocked: bool,
    /// What was cut for lost samples.
    cut: Option<Processing>,
}

fn wanted(mut found: Found, options: &RecordOptions) -> Result<Wanted, RecordError> {
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
    Ok(Wanted {
        pieces,
        unit: named(&units),
        clocked: all_begin,
        cut,
    })
}

/// "mg", or "mg and not given" where channels differ.
fn named(units: &BTreeSet<&'static str>) -> String {
    let words = units.iter().map(|unit| match *unit {
        "" if units.len() > 1 => "not given",
        unit => unit,
    });
    words.rev().collect::<Vec<_>>().join(" and ")
}

/// Which channels are read, in order.
fn chosen(found: &Found, options: &RecordOptions) -> Result<Vec<usize>, RecordError> {
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

/// The unit of a channel: that of the file, or the one given; never another's word against the file's.
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
        // a scale takes the numbers from what the file says to the unit given
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
