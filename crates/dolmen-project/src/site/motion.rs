//! Reads ground motions. Their files are opened only for a simulation.

use super::file::{LengthsRaw, MotionColumnsRaw, MotionFilesRaw, MotionRaw, StatedPeakRaw};
use super::part::{MotionPart, MotionSize, MotionSource};
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::{Common, WrongSite};
use dolmen::signal::{Component, Quantity};
use dolmen_records::records::Unit;
use std::collections::BTreeMap;

/// Shortest and longest time in a motion, s.
const TIME_S: [f64; 2] = [1e-6, 1e5];

/// Least and largest magnitude and distance, km, of the earthquake of a motion.
const MAGNITUDE: [f64; 2] = [0.0, 10.0];
const DISTANCE_KM: [f64; 2] = [0.1, 2e4];

/// The motions in the order of the file.
pub(crate) fn motions(reader: &mut Reader, raw: Option<&BTreeMap<String, At<MotionRaw>>>) -> Vec<MotionPart> {
    let mut listed: Vec<_> = raw.into_iter().flatten().collect();
    listed.sort_by_key(|(_, raw)| raw.span.start);
    let each = listed
        .into_iter()
        .filter_map(|(name, raw)| motion(reader, name, raw));
    each.collect()
}

fn motion(reader: &mut Reader, name: &str, raw: &At<MotionRaw>) -> Option<MotionPart> {
    let path = format!("motion.{name}");
    reader.mark(&path, &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let from = source(reader, raw, &path);
    let columns = columns(reader, given, &path);
    if let (Some(_), Some(from)) = (&given.built_in, &from) {
        refuse_idle(reader, given, from, &path);
    }
    let x_azimuth_deg = reader.within(
        given.x_azimuth_deg.as_ref(),
        &format!("{path}.x_azimuth_deg"),
        -360.0,
        360.0,
    );
    let factor = factor(reader, given.factor.as_ref(), &format!("{path}.factor"));
    let unit = unit(reader, given.unit.as_ref(), &format!("{path}.unit"));
    let mut seconds = |raw: &Option<At<f64>>, key: &str| {
        let path = format!("{path}.{key}");
        reader.within(raw.as_ref(), &path, TIME_S[0], TIME_S[1])
    };
    let sample_step_s = seconds(&given.sample_step_s, "sample_step_s");
    let keep_first_s = seconds(&given.keep_first_s, "keep_first_s");
    let taper_s = seconds(&given.taper_s, "taper_s");
    let turn_rad = reader.plain(
        given.turn.as_ref(),
        &format!("{path}.turn"),
        Measure::Angle,
        Bound::Any,
    );
    let size = size(reader, given, &path);
    let magnitude = reader.within(
        given.magnitude.as_ref(),
        &format!("{path}.magnitude"),
        MAGNITUDE[0],
        MAGNITUDE[1],
    );
    let distance_km = reader.within(
        given.distance_km.as_ref(),
        &format!("{path}.distance_km"),
        DISTANCE_KM[0],
        DISTANCE_KM[1],
    );
    (reader.faults.len() == before).then_some(())?;
    Some(MotionPart {
        name: name.to_owned(),
        from: from?,
        columns,
        x_azimuth_deg,
        factor,
        responses: response_files(given),
        ignores_stated_peak: given
            .stated_peak
            .as_ref()
            .is_some_and(|of| of.value == StatedPeakRaw::Ignore),
        unit,
        sample_step_s,
        cut_to_shortest: given
            .lengths
            .as_ref()
            .is_some_and(|of| of.value == LengthsRaw::Shortest),
        keep_first_s,
        taper_s,
        turn_rad,
        size,
        record: given.record.as_ref().map(|record| record.value.clone()),
        magnitude,
        distance_km,
        source: given.source.clone(),
    })
}

/// Its source: one of files, file and built_in.
fn source(reader: &mut Reader, raw: &At<MotionRaw>, path: &str) -> Option<MotionSource> {
    let given = &raw.value;
    let keys = [
        ("files", given.files.as_ref().map(|of| &of.span)),
        ("file", given.file.as_ref().map(|of| &of.span)),
        ("built_in", given.built_in.as_ref().map(|of| &of.span)),
    ];
    let said: Vec<_> = keys
        .iter()
        .filter_map(|(key, span)| Some((*key, span.as_ref()?)))
        .collect();
    match said.as_slice() {
        [] => {
            let is_reported = keys
                .iter()
                .any(|(key, _)| reader.is_reported(&format!("{path}.{key}")));
            if !is_reported {
                let problem = WrongSite::HasNeitherFilesNor(path.to_string());
                let fault = Fault::new(raw.span.clone(), &format!("{path}.files"), problem);
                reader.fault(fault.help(WrongSite::WriteFilesXRecord));
            }
            None
        }
        [_] => match (&given.files, &given.file, &given.built_in) {
            (Some(files), ..) => files_of(reader, files, &format!("{path}.files")),
            (None, Some(file), _) => Some(MotionSource::Files(of_one_file(given, &file.value))),
            (None, None, built_in) => Some(MotionSource::BuiltIn(built_in.as_ref()?.value.clone())),
        },
        [(first, span), (second, _), ..] => {
            let problem = WrongSite::HasBothFilesAnd {
                path: path.to_string(),
                first: (*first).to_owned(),
                second: (*second).to_owned(),
            };
            let fault = Fault::new(std::ops::Range::clone(span), path, problem);
            reader.fault(fault.help(Common::KeepOneOfThem));
            None
        }
    }
}

/// The components in one file: those in columns, else x.
fn of_one_file(given: &MotionRaw, file: &str) -> Vec<(Component, String)> {
    let named = given
        .columns
        .as_ref()
        .map_or_else(Vec::new, |raw| columns_named(&raw.value));
    match named.is_empty() {
        true => vec![(Component::X, file.to_owned())],
        false => named.into_iter().map(|(of, _)| (of, file.to_owned())).collect(),
    }
}

fn columns_named(raw: &MotionColumnsRaw) -> Vec<(Component, String)> {
    let each = [
        (Component::X, &raw.x),
        (Component::Y, &raw.y),
        (Component::Z, &raw.z),
    ];
    let named = each
        .into_iter()
        .filter_map(|(component, name)| Some((component, name.as_ref()?.value.name())));
    named.collect()
}

/// The columns of components with a file each.
fn columns(reader: &mut Reader, given: &MotionRaw, path: &str) -> Vec<(Component, String)> {
    let Some(raw) = &given.columns else {
        return Vec::new();
    };
    let path = format!("{path}.columns");
    let named = columns_named(&raw.value);
    let mut refuse = |problem: WrongSite, help: WrongSite| {
        reader.fault(Fault::new(raw.span.clone(), &path, problem).help(help));
    };
    if given.x_azimuth_deg.is_some() {
        refuse(
            WrongSite::ColumnsAndAzimuth(path.clone()),
            WrongSite::KeepColumnsOrAzimuth,
        );
    } else if named.is_empty() {
        refuse(WrongSite::ColumnsEmpty(path.clone()), WrongSite::WriteColumns);
    } else if let Some(files) = &given.files {
        let has = |component: &Component| match component {
            Component::X => files.value.x.is_some(),
            Component::Y => files.value.y.is_some(),
            Component::Z => files.value.z.is_some(),
        };
        if let Some((component, _)) = named.iter().find(|(component, _)| !has(component)) {
            let problem = WrongSite::ColumnWithoutFile {
                path: path.clone(),
                component: component.name().to_owned(),
            };
            refuse(problem, WrongSite::WriteFileOfColumns);
        }
    }
    named
}

fn response_files(given: &MotionRaw) -> Vec<String> {
    let files = given.response.iter().flatten();
    files.map(|file| file.value.clone()).collect()
}

/// Rejects keys for reading files of a motion without files.
fn refuse_idle(reader: &mut Reader, given: &MotionRaw, from: &MotionSource, path: &str) {
    let MotionSource::BuiltIn(name) = from else {
        return;
    };
    let keys = [
        ("columns", given.columns.as_ref().map(|of| &of.span)),
        ("x_azimuth_deg", given.x_azimuth_deg.as_ref().map(|of| &of.span)),
        ("factor", given.factor.as_ref().map(|of| &of.span)),
        (
            "response",
            given.response.iter().flatten().next().map(|of| &of.span),
        ),
        ("stated_peak", given.stated_peak.as_ref().map(|of| &of.span)),
    ];
    for (key, span) in keys {
        let Some(span) = span else { continue };
        let path = format!("{path}.{key}");
        let problem = WrongSite::OfFilesOnly {
            path: path.clone(),
            name: name.clone(),
        };
        reader
            .fault(Fault::new(std::ops::Range::clone(span), &path, problem).help(WrongSite::LeaveOfFilesOut));
    }
}

fn factor(reader: &mut Reader, raw: Option<&At<f64>>, path: &str) -> Option<f64> {
    let raw = raw?;
    if raw.value != 0.0 && raw.value.is_finite() {
        return Some(raw.value);
    }
    let problem = WrongSite::FactorCannotBe {
        path: path.to_string(),
        factor: short(raw.value),
    };
    let fault = Fault::new(raw.span.clone(), path, problem);
    reader.fault(fault.allowed(WrongSite::MustBeNumberOther));
    None
}

fn files_of(reader: &mut Reader, raw: &At<MotionFilesRaw>, path: &str) -> Option<MotionSource> {
    let files = &raw.value;
    let each = [
        (Component::X, &files.x),
        (Component::Y, &files.y),
        (Component::Z, &files.z),
    ];
    let named: Vec<(Component, String)> = each
        .into_iter()
        .filter_map(|(component, file)| Some((component, file.as_ref()?.value.clone())))
        .collect();
    if named.is_empty() {
        if !reader.is_reported(path) {
            let fault = Fault::new(raw.span.clone(), path, Common::IsEmpty(path.to_string()));
            reader.fault(
                fault
                    .allowed(WrongSite::NeedsXYOr)
                    .help(WrongSite::WriteXRecordAt2),
            );
        }
        return None;
    }
    Some(MotionSource::Files(named))
}

fn unit(reader: &mut Reader, raw: Option<&At<String>>, path: &str) -> Option<String> {
    let raw = raw?;
    match Unit::parse(&raw.value) {
        Ok(unit) if unit.quantity() == Quantity::Acceleration => Some(raw.value.clone()),
        _ => {
            let message = WrongSite::IsNoUnitOf {
                path: path.to_string(),
                unit: raw.value.to_string(),
            };
            let fault = Fault::new(raw.span.clone(), path, message);
            reader.fault(fault.allowed(WrongSite::MustBeGGal));
            None
        }
    }
}

fn size(reader: &mut Reader, given: &MotionRaw, path: &str) -> Option<MotionSize> {
    let peak = reader.plain(
        given.peak.as_ref(),
        &format!("{path}.peak"),
        Measure::GroundAcceleration,
        Bound::Positive,
    );
    match (&given.scale, &given.peak) {
        (Some(scale), Some(_)) => {
            let fault = Fault::new(
                scale.span.clone(),
                path,
                Common::HasBothScaleAnd(path.to_string()),
            );
            reader.fault(fault.help(Common::KeepOneOfThem));
            None
        }
        (Some(scale), None) if scale.value == 0.0 || !scale.value.is_finite() => {
            let message = WrongSite::ScaleCannotBe {
                path: path.to_string(),
                scale: short(scale.value),
            };
            let fault = Fault::new(scale.span.clone(), path, message);
            reader.fault(fault.allowed(WrongSite::MustBeNumberOther));
            None
        }
        (Some(scale), None) => Some(MotionSize::Scale(scale.value)),
        (None, _) => peak.map(MotionSize::Peak),
    }
}
