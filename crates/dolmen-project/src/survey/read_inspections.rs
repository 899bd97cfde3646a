//! Reads the findings of inspections.

use super::file::{InspectionRaw, SeverityRaw};
use super::inspection::{DamageKind, Inspection, OtherDamage, Severity};
use crate::damage::in_model;
use crate::doubted::Doubted;
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::names::Names;
use crate::reader::Reader;
use crate::report::{PartNames, PhotoPart, a_part, words};
use crate::usual_numbers::metres;
use crate::wrong::WrongSurvey;

/// Width of a crack, m, above which its unit is in doubt. Our choice.
const CRACK_MOST_M: f64 = 0.1;
/// The words for each kind, lower case.
const KINDS: [(DamageKind, &[&str]); 8] = [
    (DamageKind::Crack, &["crack", "균열"]),
    (DamageKind::Spalling, &["spalling", "박락"]),
    (DamageKind::Exfoliation, &["exfoliation", "박리"]),
    (DamageKind::OpenJoint, &["open joint", "gap", "이격", "벌어짐"]),
    (DamageKind::Tilt, &["tilt", "기울기", "기울어짐"]),
    (DamageKind::Settlement, &["settlement", "침하"]),
    (DamageKind::Loss, &["loss", "결손", "탈락"]),
    (DamageKind::Growth, &["growth", "생물 피복", "식생", "생물오염"]),
];

/// The findings, in the order of the file.
pub(super) fn inspections(
    reader: &mut Reader,
    raw: Option<&Vec<At<InspectionRaw>>>,
    path: &str,
    parts: &PartNames,
) -> Vec<Inspection> {
    let listed = raw.into_iter().flatten().zip(1..);
    listed
        .filter_map(|(raw, number)| inspection(reader, &raw.value, &format!("{path}[{number}]"), parts))
        .collect()
}

fn inspection(reader: &mut Reader, raw: &InspectionRaw, path: &str, parts: &PartNames) -> Option<Inspection> {
    let size_path = format!("{path}.size");
    let size = reader.quantity(raw.size.as_ref(), &size_path, Measure::Length, Bound::Positive);
    let limit_path = format!("{path}.limit");
    let limit = reader.quantity(raw.limit.as_ref(), &limit_path, Measure::Length, Bound::Positive);
    let name = name(reader, raw.name.as_ref(), &format!("{path}.name"));
    let at = at(reader, raw.at.as_ref(), &format!("{path}.at"));
    let note = words(reader, raw.note.as_ref(), &format!("{path}.note"));
    let photo_path = format!("{path}.photo");
    let photo = raw.photo.as_ref().map(|file| {
        reader.mark(&photo_path, &file.span);
        PhotoPart {
            file: file.value.clone(),
            caption: None,
            of: None,
            path: photo_path.clone(),
        }
    });
    let what = words(reader, raw.what.as_ref(), &format!("{path}.what")).map(|names| kind(&names));
    if let (Some(DamageKind::Crack), Some(size)) = (&what, &size)
        && size.value > CRACK_MOST_M
    {
        let doubted = Doubted::WideCrack {
            path: size_path.clone(),
            given: metres(size.value),
        };
        reader.doubt(&size_path, doubted);
    }
    let part = a_part(reader, raw.part.as_ref(), &format!("{path}.part"), parts);
    let model = in_model(reader, raw.model.as_ref(), &format!("{path}.model"));
    Some(Inspection {
        part: part?,
        what: what?,
        name,
        size,
        limit,
        severity: raw.severity.as_ref().map(|severity| match severity.value {
            SeverityRaw::Slight => Severity::Slight,
            SeverityRaw::Moderate => Severity::Moderate,
            SeverityRaw::Severe => Severity::Severe,
        }),
        at,
        photo,
        note,
        model,
    })
}

/// Most characters of a name. Our choice: longer text belongs into a note.
const NAME_MOST: usize = 40;

/// The name of an entry among others, not empty and short.
fn name(reader: &mut Reader, raw: Option<&At<String>>, path: &str) -> Option<String> {
    let raw = raw?;
    reader.mark(path, &raw.span);
    let name = raw.value.trim();
    let count = name.chars().count();
    if (1..=NAME_MOST).contains(&count) {
        return Some(name.to_owned());
    }
    let message = WrongSurvey::NameOfEntry {
        path: path.to_owned(),
        count,
    };
    let fault = Fault::new(raw.span.clone(), path, message);
    reader.fault(fault.allowed(WrongSurvey::NameOfEntryMustBe(NAME_MOST)));
    None
}

fn kind(names: &Names) -> DamageKind {
    let known = [names.english(), names.korean()].map(|name| name.trim().to_lowercase());
    let found = KINDS
        .iter()
        .find(|(_, words)| known.iter().any(|name| words.contains(&name.as_str())));
    found.map_or_else(
        || {
            DamageKind::Other(OtherDamage {
                english: names.english().trim().to_owned(),
                korean: names.korean().trim().to_owned(),
            })
        },
        |(kind, _)| kind.clone(),
    )
}

/// Three lengths.
fn at(reader: &mut Reader, raw: Option<&At<Vec<At<QuantityRaw>>>>, path: &str) -> Option<[f64; 3]> {
    let raw = raw?;
    reader.mark(path, &raw.span);
    let each = raw.value.iter().zip(1..);
    let read: Vec<Option<f64>> = each
        .map(|(raw, number)| {
            let path = format!("{path}[{number}]");
            let read = reader.quantity(Some(raw), &path, Measure::Length, Bound::Any);
            read.map(|length| length.value)
        })
        .collect();
    let [x, y, z] = read.as_slice() else {
        let message = WrongSurvey::HasLengths {
            path: path.to_string(),
            count: read.len().to_string(),
        };
        let fault = Fault::new(raw.span.clone(), path, message);
        reader.fault(fault.allowed(WrongSurvey::MustBeThreeX));
        return None;
    };
    Some([(*x)?, (*y)?, (*z)?])
}
