//! Records of a survey from what is written.

use super::error::Fault;
use super::file_number::{At, QuantityRaw};
use super::file_survey::{
    ChannelRaw, ColumnRaw, ConditioningRaw, HarmonicsRaw, MethodRaw, ModalRaw, RecordFormatRaw, RecordsRaw,
    WayRaw,
};
use super::measure::{Bound, Measure};
use super::reader::{Reader, short};
use super::records::{
    BandPass, ChannelSource, Column, Conditioning, Cut, LowPass, ModalChoice, RecordFormat, RecordSource,
};
use crate::records::Unit;
use dolmen::modal::{Harmonics, Method};
use std::collections::BTreeMap;
use std::ops::Range;

/// Order of one filter pass if none is given, as is usual.
const FILTER_ORDER: usize = 4;
/// Largest order of one filter pass.
const FILTER_ORDER_MOST: usize = 10;
/// Largest factor of one decimation.
const DECIMATE_MOST: usize = 1000;
/// Largest count that a project may ask of the identification.
const COUNT_MOST: usize = 10_000;
/// Longest record and highest rate that a project may name, s and Hz.
const TIME_MOST_S: f64 = 1e8;
const RATE_MOST_HZ: f64 = 1e6;

fn column(reader: &mut Reader, raw: &At<ColumnRaw>, path: &str) -> Option<Column> {
    match &raw.value {
        ColumnRaw::Name(name) => Some(Column::Name(name.clone())),
        ColumnRaw::Number(number) => {
            let number = At {
                span: raw.span.clone(),
                value: *number,
            };
            reader
                .count(Some(&number), path, 1, COUNT_MOST)
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
        .and_then(|raw| way(reader, raw, &format!("{path}.direction")));
    Some(ChannelSource {
        column: column?,
        name: raw.name.as_ref().map(|name| name.value.clone()),
        position_m,
        direction,
        leave_out: raw.leave_out.unwrap_or(false),
    })
}

fn position(reader: &mut Reader, raw: &At<Vec<At<QuantityRaw>>>, path: &str) -> Option<[f64; 3]> {
    if raw.value.len() != 3 {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            format!("{path} has {} numbers", raw.value.len()),
        );
        reader.fault(fault.allowed("must be 3: x right, y away, z up"));
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

pub(super) fn way(reader: &mut Reader, raw: &At<WayRaw>, path: &str) -> Option<[f64; 3]> {
    let vector = match &raw.value {
        WayRaw::Axis(axis) => {
            let (sign, letter) = match axis.strip_prefix('-') {
                Some(letter) => (-1.0, letter),
                None => (1.0, axis.strip_prefix('+').unwrap_or(axis)),
            };
            match letter {
                "x" => Some([sign, 0.0, 0.0]),
                "y" => Some([0.0, sign, 0.0]),
                "z" => Some([0.0, 0.0, sign]),
                _ => None,
            }
        }
        WayRaw::Vector(numbers) => unit_vector(numbers),
    };
    if vector.is_none() {
        let fault = Fault::new(raw.span.clone(), path, format!("{path} is not a direction"));
        reader.fault(
            fault.allowed("must be \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\", or three numbers not all 0"),
        );
    }
    vector
}

fn unit_vector(numbers: &[f64]) -> Option<[f64; 3]> {
    let &[x, y, z] = numbers else {
        return None;
    };
    let length = (x * x + y * y + z * z).sqrt();
    (length > 0.0 && length.is_finite()).then(|| [x / length, y / length, z / length])
}

pub(super) fn records(reader: &mut Reader, raw: &At<RecordsRaw>, path: &str) -> Option<RecordSource> {
    let raw = &raw.value;
    let rate_path = format!("{path}.sampling_rate");
    let sampling_rate = reader.quantity(
        raw.sampling_rate.as_ref(),
        &rate_path,
        Measure::Frequency,
        Bound::Positive,
    );
    if let Some(unit) = &raw.unit {
        sample_unit(reader, unit, &format!("{path}.unit"));
    }
    let delimiter = raw
        .delimiter
        .as_ref()
        .and_then(|raw| delimiter(reader, raw, &format!("{path}.delimiter")));
    let time_column = raw
        .time_column
        .as_ref()
        .and_then(|raw| column(reader, raw, &format!("{path}.time_column")));
    let listed = raw.channels.iter().flatten().enumerate();
    let channels: Vec<ChannelSource> = listed
        .filter_map(|(i, raw)| channel(reader, raw, &format!("{path}.channels[{}]", i + 1)))
        .collect();
    distinct(reader, raw.channels.as_deref().unwrap_or_default(), path);
    let conditioning = raw
        .conditioning
        .as_ref()
        .map(|raw| conditioning(reader, raw, &format!("{path}.conditioning")));
    let modal = raw
        .modal
        .as_ref()
        .map(|raw| modal(reader, raw, &format!("{path}.modal")));
    let file = raw.file.as_ref()?;
    let ending = file
        .value
        .rsplit_once('.')
        .map(|(_, ending)| ending.to_ascii_lowercase());
    let format = match (raw.format.as_ref().map(|format| format.value), ending.as_deref()) {
        (Some(RecordFormatRaw::Csv), _) => RecordFormat::Csv,
        (Some(RecordFormatRaw::Npy), _) => RecordFormat::Npy,
        (None, Some("npy")) => RecordFormat::Npy,
        (None, Some("csv" | "txt" | "tsv" | "dat" | "asc")) => RecordFormat::Csv,
        (None, _) => {
            let path = format!("{path}.file");
            let fault = Fault::new(
                file.span.clone(),
                &path,
                format!("the format of {} is not clear", file.value),
            );
            reader.fault(fault.help("write format = \"csv\" or \"npy\" beside it"));
            return None;
        }
    };
    if format == RecordFormat::Npy && sampling_rate.is_none() && raw.sampling_rate.is_none() {
        let fault = Fault::new(
            file.span.clone(),
            &rate_path,
            format!("{} holds no time stamps", file.value),
        );
        reader.fault(
            fault
                .allowed("sampling_rate is missing")
                .help("write sampling_rate = \"200 Hz\" beside it"),
        );
    }
    Some(RecordSource {
        file: file.value.clone(),
        format,
        sampling_rate_hz: sampling_rate.map(|rate| rate.value),
        unit: raw.unit.as_ref().map(|unit| unit.value.trim().to_owned()),
        delimiter,
        time_column,
        channels,
        conditioning: conditioning.unwrap_or_default(),
        modal: modal.unwrap_or_default(),
    })
}

/// The unit of samples must be one that the readers of records know.
fn sample_unit(reader: &mut Reader, unit: &At<String>, path: &str) {
    if let Err(why) = Unit::parse(&unit.value) {
        let message = format!("{path} = \"{}\" is no unit of vibration", unit.value.trim());
        let fault = Fault::new(unit.span.clone(), path, message);
        reader.fault(fault.allowed("unknown unit").help(why.to_string()));
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
                format!("{path} = {:?} is not one character", raw.value),
            );
            reader.fault(fault.allowed("must be one character, such as \",\", \";\" or \"\\t\""));
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
                let message = format!("{path} = {value} is that of channels[{}] too", first + 1);
                reader.fault(Fault::new(span.clone(), &path, message).allowed("must differ"));
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

fn conditioning(reader: &mut Reader, raw: &ConditioningRaw, path: &str) -> Conditioning {
    let cut = raw.cut.as_ref().and_then(|raw| {
        let from_s = reader.within(
            raw.value.from_s.as_ref(),
            &format!("{path}.cut.from_s"),
            0.0,
            TIME_MOST_S,
        )?;
        let to_s = reader.within(
            raw.value.to_s.as_ref(),
            &format!("{path}.cut.to_s"),
            0.0,
            TIME_MOST_S,
        )?;
        ordered(
            reader,
            (from_s, to_s),
            &raw.span,
            &format!("{path}.cut"),
            ("from_s", "to_s"),
        )?;
        Some(Cut { from_s, to_s })
    });
    let order = |reader: &mut Reader, order: Option<&At<i64>>, path: String| match order {
        None => Some(FILTER_ORDER),
        given => reader.count(given, &path, 1, FILTER_ORDER_MOST),
    };
    let least_hz = f64::MIN_POSITIVE;
    let band_pass = raw.band_pass.as_ref().and_then(|raw| {
        let path = format!("{path}.band_pass");
        let low_hz = reader.within(
            raw.value.low_hz.as_ref(),
            &format!("{path}.low_hz"),
            least_hz,
            RATE_MOST_HZ,
        )?;
        let high_hz = reader.within(
            raw.value.high_hz.as_ref(),
            &format!("{path}.high_hz"),
            least_hz,
            RATE_MOST_HZ,
        )?;
        ordered(reader, (low_hz, high_hz), &raw.span, &path, ("low_hz", "high_hz"))?;
        Some(BandPass {
            low_hz,
            high_hz,
            order: order(reader, raw.value.order.as_ref(), format!("{path}.order"))?,
        })
    });
    let low_pass = raw.low_pass.as_ref().and_then(|raw| {
        let path = format!("{path}.low_pass");
        let corner = raw.value.corner_hz.as_ref();
        Some(LowPass {
            corner_hz: reader.within(corner, &format!("{path}.corner_hz"), least_hz, RATE_MOST_HZ)?,
            order: order(reader, raw.value.order.as_ref(), format!("{path}.order"))?,
        })
    });
    let mut count = |raw: &Option<At<i64>>, key: &str, least, most| {
        reader.count(raw.as_ref(), &format!("{path}.{key}"), least, most)
    };
    Conditioning {
        cut,
        detrend_degree: count(&raw.detrend_degree, "detrend_degree", 0, 1),
        band_pass,
        low_pass,
        decimate_factor: count(&raw.decimate_factor, "decimate_factor", 1, DECIMATE_MOST),
    }
}

fn ordered(
    reader: &mut Reader,
    pair: (f64, f64),
    span: &Range<usize>,
    path: &str,
    keys: (&str, &str),
) -> Option<()> {
    if pair.0 < pair.1 {
        return Some(());
    }
    let message = format!(
        "{path}: {} = {} is not below {} = {}",
        keys.0,
        short(pair.0),
        keys.1,
        short(pair.1)
    );
    reader.fault(Fault::new(span.clone(), path, message).allowed("nothing would be left"));
    None
}

fn modal(reader: &mut Reader, raw: &ModalRaw, path: &str) -> ModalChoice {
    let low = raw.frequency_low_hz.as_ref();
    let high = raw.frequency_high_hz.as_ref();
    let frequency_low_hz = reader.within(low, &format!("{path}.frequency_low_hz"), 0.0, RATE_MOST_HZ);
    let frequency_high_hz = reader.within(high, &format!("{path}.frequency_high_hz"), 0.0, RATE_MOST_HZ);
    if let (Some(low), Some(high), Some(raw)) = (frequency_low_hz, frequency_high_hz, high) {
        ordered(
            reader,
            (low, high),
            &raw.span,
            path,
            ("frequency_low_hz", "frequency_high_hz"),
        );
    }
    let picks = raw.pick_hz.iter().flatten().enumerate();
    let pick_hz = picks
        .filter_map(|(i, pick)| reader.within(Some(pick), &format!("{path}.pick_hz[{i}]"), 0.0, RATE_MOST_HZ))
        .collect();
    let mut count = |raw: &Option<At<i64>>, key: &str, least| {
        reader.count(raw.as_ref(), &format!("{path}.{key}"), least, COUNT_MOST)
    };
    ModalChoice {
        method: raw.method.map(|method| match method {
            MethodRaw::Fdd => Method::Fdd,
            MethodRaw::Efdd => Method::Efdd,
            MethodRaw::Fsdd => Method::Fsdd,
            MethodRaw::SsiCov => Method::SsiCov,
            MethodRaw::SsiData => Method::SsiData,
            MethodRaw::Era => Method::Era,
        }),
        references: raw
            .references
            .iter()
            .flatten()
            .map(|name| name.value.clone())
            .collect(),
        pick_hz,
        harmonics: raw.harmonics.map(|harmonics| match harmonics {
            HarmonicsRaw::Flag => Harmonics::Flag,
            HarmonicsRaw::Remove => Harmonics::Remove,
        }),
        frequency_low_hz,
        frequency_high_hz,
        order_most: count(&raw.order_most, "order_most", 2),
        block_rows: count(&raw.block_rows, "block_rows", 2),
        modes_wanted: count(&raw.modes_wanted, "modes_wanted", 1),
    }
}
