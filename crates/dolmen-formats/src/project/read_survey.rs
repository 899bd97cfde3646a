//! Surveys and their records from what is written.

use super::error::Fault;
use super::file::{
    At, ChannelRaw, ColumnRaw, ConditioningRaw, ModalRaw, ModeKindRaw, ModeRaw, NumberRaw, QuantityRaw,
    RecordFormatRaw, RecordsRaw, ShapeRaw, SurveyRaw, WayRaw,
};
use super::reader::{Bound, Measure, Reader, short};
use super::records::{
    BandPass, ChannelSource, Column, Conditioning, Cut, LowPass, ModalChoice, RecordFormat, RecordSource,
};
use super::survey::{ModeKind, Survey, SurveyMode, Tilt};
use super::units::{Dimension, parse_unit, split_number};
use dolmen::structure::ShapePoint;
use std::collections::BTreeMap;
use std::ops::Range;

/// Air temperatures of surveys, °C, our choice: wider than any place where heritage stands.
const TEMPERATURE_C: (f64, f64) = (-60.0, 60.0);

/// Steepest tilt that a survey of a standing monument can hold, our choice: Pisa before its repair had 1/10.
const TILT_MOST: f64 = 0.25;

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

/// All surveys, in the order of the file.
pub(super) fn surveys(reader: &mut Reader, raw: Option<&BTreeMap<String, At<SurveyRaw>>>) -> Vec<Survey> {
    let mut listed: Vec<(&String, &At<SurveyRaw>)> = raw.into_iter().flatten().collect();
    listed.sort_by_key(|(_, survey)| survey.span.start);
    listed
        .into_iter()
        .map(|(name, survey)| self::survey(reader, name, survey))
        .collect()
}

fn survey(reader: &mut Reader, name: &str, raw: &At<SurveyRaw>) -> Survey {
    let path = format!("survey.{name}");
    let raw = &raw.value;
    let mut modes: BTreeMap<String, Vec<SurveyMode>> = BTreeMap::new();
    for (direction, frequencies) in raw.frequencies.iter().flatten() {
        let listed = modes.entry(direction.clone()).or_default();
        for (i, frequency) in frequencies.iter().enumerate() {
            let path = format!("{path}.frequencies.{direction}[{}]", i + 1);
            if let Some(frequency) =
                reader.quantity(Some(frequency), &path, Measure::Frequency, Bound::Positive)
            {
                listed.push(SurveyMode {
                    frequency,
                    damping_ratio: None,
                    shape: Vec::new(),
                    kind: ModeKind::Translation,
                });
            }
        }
    }
    for (direction, given) in raw.modes.iter().flatten() {
        if modes.get(direction).is_some_and(|listed| !listed.is_empty()) {
            let span = given.first().map_or(0..0, |mode| mode.span.clone());
            let path = format!("{path}.modes.{direction}");
            let fault = Fault::new(
                span,
                &path,
                format!("{path} and frequencies.{direction} are both given"),
            );
            reader.fault(fault.help("keep modes: each mode there has its own frequency"));
            continue;
        }
        let listed = modes.entry(direction.clone()).or_default();
        for (i, raw) in given.iter().enumerate() {
            listed.extend(mode(reader, raw, &format!("{path}.modes.{direction}[{}]", i + 1)));
        }
    }
    let mut tilt = BTreeMap::new();
    for (direction, raw) in raw.tilt.iter().flatten() {
        if let Some(read) = self::tilt(reader, raw, &format!("{path}.tilt.{direction}")) {
            tilt.insert(direction.clone(), read);
        }
    }
    let (coldest, hottest) = TEMPERATURE_C;
    Survey {
        name: name.to_owned(),
        note: raw.note.clone(),
        source: raw.source.clone(),
        temperature_c: reader.within(
            raw.temperature_c.as_ref(),
            &format!("{path}.temperature_c"),
            coldest,
            hottest,
        ),
        datum: raw.datum.clone(),
        tilt,
        modes,
        records: raw
            .records
            .as_ref()
            .and_then(|raw| records(reader, raw, &format!("{path}.records"))),
    }
}

fn mode(reader: &mut Reader, raw: &At<ModeRaw>, path: &str) -> Option<SurveyMode> {
    let raw = &raw.value;
    let frequency_path = format!("{path}.frequency");
    let frequency = reader.quantity(
        raw.frequency.as_ref(),
        &frequency_path,
        Measure::Frequency,
        Bound::Positive,
    );
    let damping_path = format!("{path}.damping_ratio");
    let damping_ratio = reader.quantity(
        raw.damping_ratio.as_ref(),
        &damping_path,
        Measure::Ratio,
        Bound::NotNegative,
    );
    let points = raw.shape.iter().flatten().enumerate();
    let shape: Vec<ShapePoint> = points
        .filter_map(|(i, raw)| shape_point(reader, raw, &format!("{path}.shape[{}]", i + 1)))
        .collect();
    if !shape.is_empty() && shape.iter().all(|point| point.displacement == 0.0) {
        let span = raw
            .shape
            .iter()
            .flatten()
            .next()
            .map_or(0..0, |point| point.span.clone());
        let path = format!("{path}.shape");
        let fault = Fault::new(span, &path, format!("{path} does not move at any point"));
        reader.fault(fault.allowed("at least one displacement must differ from 0"));
    }
    Some(SurveyMode {
        frequency: frequency?,
        damping_ratio,
        shape,
        kind: match raw.kind {
            None | Some(ModeKindRaw::Translation) => ModeKind::Translation,
            Some(ModeKindRaw::Torsion) => ModeKind::Torsion,
        },
    })
}

fn shape_point(reader: &mut Reader, raw: &At<ShapeRaw>, path: &str) -> Option<ShapePoint> {
    let raw = &raw.value;
    let height_path = format!("{path}.height");
    let height = reader.quantity(
        raw.height.as_ref(),
        &height_path,
        Measure::Length,
        Bound::NotNegative,
    );
    let mut finite = |number: Option<&At<f64>>, key: &str, bound| {
        let number = number?;
        let path = format!("{path}.{key}");
        reader.bounded(number.value, &short(number.value), &number.span, &path, bound)?;
        Some(number.value)
    };
    let displacement = finite(raw.displacement.as_ref(), "displacement", Bound::Any);
    let sd = finite(raw.sd.as_ref(), "sd", Bound::NotNegative);
    Some(ShapePoint {
        height_m: height?.value,
        displacement: displacement?,
        displacement_sd: sd.unwrap_or(0.0),
    })
}

/// "1/177", 0.0056, "0.3 deg", "5 mm/m".
fn tilt(reader: &mut Reader, raw: &At<NumberRaw>, path: &str) -> Option<Tilt> {
    let (ratio, written) = match &raw.value {
        NumberRaw::Number(ratio) => (Some(*ratio), short(*ratio)),
        NumberRaw::Text(text) => (tilt_ratio(text), text.trim().to_owned()),
    };
    let fault = |message: String| Fault::new(raw.span.clone(), path, message);
    match ratio {
        Some(ratio) if ratio.abs() <= TILT_MOST => Some(Tilt { ratio, written }),
        Some(_) => {
            let fault = fault(format!("{path} = {written} would have fallen"));
            reader.fault(
                fault
                    .allowed(format!("must be within ±{TILT_MOST}"))
                    .help("tilt is horizontal / vertical: \"1/177\", 0.00565, \"0.32 deg\" or \"5.65 mm/m\""),
            );
            None
        }
        None => {
            let fault = fault(format!("{path} = \"{written}\" is not a tilt"));
            reader.fault(
                fault.allowed("must be a ratio, or text such as \"1/177\", \"0.32 deg\", \"5.65 mm/m\""),
            );
            None
        }
    }
}

fn tilt_ratio(text: &str) -> Option<f64> {
    let (number, rest) = split_number(text)?;
    let ratio = match rest.strip_prefix('/') {
        Some(below) => match split_number(below)? {
            (below, "") => number / below,
            _ => return None,
        },
        None if rest.is_empty() => number,
        None => {
            let unit = parse_unit(rest)
                .ok()
                .filter(|unit| unit.dimension == Dimension::RATIO)?;
            let is_angle = ["deg", "rad", "mrad", "°"].contains(&rest);
            let value = number * unit.factor;
            if is_angle { value.tan() } else { value }
        }
    };
    ratio.is_finite().then_some(ratio)
}

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

fn way(reader: &mut Reader, raw: &At<WayRaw>, path: &str) -> Option<[f64; 3]> {
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

fn records(reader: &mut Reader, raw: &At<RecordsRaw>, path: &str) -> Option<RecordSource> {
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

/// The unit of samples must be one of an acceleration, a velocity or a displacement.
fn sample_unit(reader: &mut Reader, unit: &At<String>, path: &str) {
    let allowed = "must be an acceleration, a velocity or a length: m/s2, g, gal, mm/s, mm";
    let fault = Fault::new(
        unit.span.clone(),
        path,
        format!("{path} = \"{}\" is no unit of vibration", unit.value),
    );
    match parse_unit(&unit.value) {
        Ok(read)
            if [Dimension::ACCELERATION, Dimension::VELOCITY, Dimension::LENGTH]
                .contains(&read.dimension) => {}
        Ok(_) => reader.fault(fault.allowed(allowed)),
        Err(why) => reader.fault(fault.allowed(allowed).help(why.help())),
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
    let mut count = |raw: &Option<At<i64>>, key: &str, least| {
        reader.count(raw.as_ref(), &format!("{path}.{key}"), least, COUNT_MOST)
    };
    ModalChoice {
        frequency_low_hz,
        frequency_high_hz,
        order_most: count(&raw.order_most, "order_most", 2),
        block_rows: count(&raw.block_rows, "block_rows", 2),
        modes_wanted: count(&raw.modes_wanted, "modes_wanted", 1),
    }
}
