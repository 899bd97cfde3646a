//! Reads `[watch.log.NAME]`.

use super::limit_slips::judge_limit;
use super::watch::{LogKind, LogPart};
use super::watch_file::{LogKindRaw, LogRaw};
use crate::error::Fault;
use crate::file_number::{At, NumberRaw};
use crate::measure::{Bound, Measure};
use crate::names::names;
use crate::reader::Reader;
use crate::units::is_angle;
use crate::wrong::WrongLog;
use dolmen_words::message::Both;
use std::collections::BTreeMap;

/// Largest tilt of a zero and of a limit. Our choice: no structure stands at 1/4.
const TILT_MOST: f64 = 0.25;
/// Largest width of a watched crack, m, and the least limit of a width or tilt. Our choice.
const WIDTH_MOST_M: f64 = 1.0;
const LIMIT_LEAST: f64 = 1e-5;
/// Spellings of the one unit of temperature.
const CELSIUS: [&str; 4] = ["°C", "C", "degC", "℃"];

/// The quantities of loggers, by name.
pub(super) fn logs(reader: &mut Reader, raw: Option<&BTreeMap<String, At<LogRaw>>>) -> Vec<LogPart> {
    let each = raw.into_iter().flatten();
    let logs: Vec<LogPart> = each
        .filter_map(|(name, given)| log(reader, name, given))
        .collect();
    let mut temperatures = logs.iter().filter(|log| log.kind == LogKind::Temperature);
    if let (Some(first), Some(second)) = (temperatures.next(), temperatures.next()) {
        let at = raw.and_then(|raw| raw.get(&second.name));
        let wrong = WrongLog::SecondTemperature {
            path: format!("watch.log.{}", second.name),
            first: first.name.clone(),
        };
        let span = at.map_or(0..0, |given| given.span.clone());
        let fault = Fault::new(span, &format!("watch.log.{}", second.name), wrong);
        reader.fault(fault.allowed(WrongLog::OneTemperature));
    }
    for (at, log) in logs.iter().enumerate() {
        let same = |other: &&LogPart| other.file == log.file && other.column == log.column;
        if let Some(first) = logs[..at].iter().find(same) {
            let span = raw
                .and_then(|raw| raw.get(&log.name))
                .map_or(0..0, |given| given.span.clone());
            let path = format!("watch.log.{}", log.name);
            let wrong = WrongLog::SameColumn {
                path: path.clone(),
                first: first.name.clone(),
            };
            reader.fault(Fault::new(span, &path, wrong).allowed(WrongLog::OwnColumn));
        }
    }
    logs
}

fn log(reader: &mut Reader, name: &str, given: &At<LogRaw>) -> Option<LogPart> {
    let (raw, path) = (&given.value, format!("watch.log.{name}"));
    let file = needed(
        reader,
        given,
        &path,
        "file",
        raw.file.as_ref(),
        WrongLog::NeedsFile,
    )?;
    let kind = needed(
        reader,
        given,
        &path,
        "kind",
        raw.kind.as_ref(),
        WrongLog::NeedsKind,
    )?;
    let (kind, measure, most) = match kind.value {
        LogKindRaw::Tilt => {
            let allowed = WrongLog::NeedsDirection;
            let direction = needed(reader, given, &path, "direction", raw.direction.as_ref(), allowed)?;
            let direction = direction.value.clone();
            (LogKind::Tilt { direction }, Some(Measure::Tilt), TILT_MOST)
        }
        LogKindRaw::Crack => (LogKind::Crack, Some(Measure::Length), WIDTH_MOST_M),
        LogKindRaw::Temperature => (LogKind::Temperature, None, 0.0),
    };
    refuse_others(reader, raw, &path, &kind);
    let (unit, factor) = match measure {
        Some(measure) => unit(reader, given, &path, measure)?,
        None => (celsius(reader, raw, &path)?, 1.0),
    };
    let mut size = |key: &str, at: Option<&At<NumberRaw>>, bound: Bound, least: f64| {
        let (at, measure, path) = (at?, measure?, format!("{path}.{key}"));
        let value = reader.plain(Some(at), &path, measure, bound)?;
        if (least..=most).contains(&value) {
            return Some(value);
        }
        let wrong = WrongLog::OutOfBounds { path: path.clone() };
        let allowed = match measure {
            Measure::Tilt => WrongLog::TiltWithin,
            _ => WrongLog::WidthWithin,
        };
        reader.fault(Fault::new(at.span.clone(), &path, wrong).allowed(allowed));
        None
    };
    let limit = size("limit", raw.limit.as_ref(), Bound::Positive, LIMIT_LEAST);
    let zero = size("zero", raw.zero.as_ref(), Bound::Any, -most);
    if let (Some(limit), Some(Measure::Tilt)) = (limit, measure) {
        judge_limit(reader, &format!("{path}.limit"), limit);
    }
    Some(LogPart {
        zero,
        limit,
        name: name.to_owned(),
        label: raw.label.clone().map(names),
        file: file.value.clone(),
        column: raw.column.as_ref().map(|column| column.value.clone()),
        is_angle: measure == Some(Measure::Tilt) && is_angle(&unit),
        kind,
        unit,
        factor,
    })
}

/// Rejects keys that have no meaning for a kind of log.
fn refuse_others(reader: &mut Reader, raw: &LogRaw, path: &str, kind: &LogKind) {
    let is_temperature = *kind == LogKind::Temperature;
    let is_tilt = matches!(kind, LogKind::Tilt { .. });
    let others = [
        ("zero", raw.zero.as_ref().map(|at| &at.span), is_temperature),
        ("limit", raw.limit.as_ref().map(|at| &at.span), is_temperature),
        ("direction", raw.direction.as_ref().map(|at| &at.span), !is_tilt),
    ];
    for (key, span, is_other) in others {
        if let (Some(span), true) = (span, is_other) {
            let path = format!("{path}.{key}");
            let wrong = WrongLog::SaysNothing { path: path.clone() };
            reader.fault(Fault::new(span.clone(), &path, wrong).allowed(WrongLog::LeaveItOut));
        }
    }
}

/// The unit of readings, and its size in SI units.
fn unit(reader: &mut Reader, given: &At<LogRaw>, path: &str, measure: Measure) -> Option<(String, f64)> {
    let allowed = match measure {
        Measure::Tilt => WrongLog::NeedsUnitOfTilt,
        _ => WrongLog::NeedsUnitOfWidth,
    };
    let written = needed(reader, given, path, "unit", given.value.unit.as_ref(), allowed)?;
    let path = format!("{path}.unit");
    let unit = reader.unit(&written.value, &written.span, &path, measure, &path)?;
    Some((written.value.trim().to_owned(), unit.factor))
}

fn celsius(reader: &mut Reader, raw: &LogRaw, path: &str) -> Option<String> {
    let given = raw.unit.as_ref();
    let other = given.filter(|unit| !CELSIUS.contains(&unit.value.trim()));
    let Some(other) = other else {
        return Some(CELSIUS[0].to_owned());
    };
    let path = format!("{path}.unit");
    let wrong = WrongLog::NotCelsius {
        path: path.clone(),
        written: other.value.clone(),
    };
    reader.fault(Fault::new(other.span.clone(), &path, wrong).allowed(WrongLog::MustBeCelsius));
    None
}

/// A required key.
fn needed<'a, T>(
    reader: &mut Reader,
    given: &At<LogRaw>,
    path: &str,
    key: &str,
    value: Option<&'a T>,
    allowed: impl Into<Both>,
) -> Option<&'a T> {
    let path = format!("{path}.{key}");
    // a wrong one has been reported
    if value.is_none() && !reader.is_reported(&path) {
        let wrong = WrongLog::IsMissing { path: path.clone() };
        reader.fault(Fault::new(given.span.clone(), &path, wrong).allowed(allowed));
    }
    value
}
