//! Ground motions from what is written. Their files are opened when one is simulated.

use super::file::{LengthsRaw, MotionFilesRaw, MotionRaw};
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

/// Shortest and longest time that a motion may name, s.
const TIME_S: [f64; 2] = [1e-6, 1e5];

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
    let from = match (&given.files, &given.built_in) {
        (Some(files), None) => files_of(reader, files, &format!("{path}.files")),
        (None, Some(built_in)) => Some(MotionSource::BuiltIn(built_in.value.clone())),
        (Some(files), Some(_)) => {
            let fault = Fault::new(
                files.span.clone(),
                &path,
                WrongSite::HasBothFilesAnd {
                    path: path.to_string(),
                },
            );
            reader.fault(fault.help(Common::KeepOneOfThem));
            None
        }
        (None, None) => {
            let files_path = format!("{path}.files");
            if !reader.is_reported(&files_path) && !reader.is_reported(&format!("{path}.built_in")) {
                let fault = Fault::new(
                    raw.span.clone(),
                    &files_path,
                    WrongSite::HasNeitherFilesNor {
                        path: path.to_string(),
                    },
                );
                reader.fault(fault.help(WrongSite::WriteFilesXRecord));
            }
            None
        }
    };
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
    (reader.faults.len() == before).then_some(())?;
    Some(MotionPart {
        name: name.to_owned(),
        from: from?,
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
        source: given.source.clone(),
    })
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
            let fault = Fault::new(
                raw.span.clone(),
                path,
                Common::IsEmpty {
                    path: path.to_string(),
                },
            );
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
                Common::HasBothScaleAnd {
                    path: path.to_string(),
                },
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
