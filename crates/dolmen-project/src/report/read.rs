//! `[report]` from what is written.

use super::date::is_day;
use super::file::{
    AuthorRaw, GradeRaw, LocationRaw, MaterialMethodRaw, MaterialTestRaw, PhotoRaw, ReportRaw, SensorRaw,
};
use super::part::{
    Author, Grade, GradeScale, Location, MaterialMethod, MaterialTest, PeriodicGrade, PhotoPart, ReportPart,
    SensorPart,
};
use super::parts_named::PartNames;
use crate::error::Fault;
use crate::file_names::NamesRaw;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::names::{Names, names};
use crate::reader::Reader;
use crate::wrong::{Common, WrongReport};
use dolmen_words::message::Both;
use dolmen_words::nearest;

/// Velocities of ultrasonic pulses, m/s, our choice: from decayed timber to sound rock.
const VELOCITY_M_S: (f64, f64) = (100.0, 8000.0);
/// Readings of a rebound hammer: its scale.
const REBOUND: (f64, f64) = (0.0, 100.0);

/// The contents given by the engineer; `parts` are the names that photographs and tests may use.
pub(crate) fn report(
    reader: &mut Reader,
    raw: Option<&At<ReportRaw>>,
    parts: &PartNames,
) -> Option<ReportPart> {
    let raw = &raw?.value;
    let text = |reader: &mut Reader, raw: &Option<At<NamesRaw>>, key: &str| {
        words(reader, raw.as_ref(), &format!("report.{key}"))
    };
    Some(ReportPart {
        title: text(reader, &raw.title, "title"),
        number: text(reader, &raw.number, "number"),
        client: text(reader, &raw.client, "client"),
        organisation: text(reader, &raw.organisation, "organisation"),
        address: text(reader, &raw.address, "address"),
        date: day(reader, raw.date.as_ref(), "report.date"),
        authors: each(reader, &raw.authors, "report.authors", author),
        purpose: text(reader, &raw.purpose, "purpose"),
        location: location(reader, raw.location.as_ref()),
        photos: each(reader, &raw.photos, "report.photos", |reader, raw, path| {
            photo(reader, raw, path, parts)
        }),
        drawings: each(reader, &raw.drawings, "report.drawings", |reader, raw, path| {
            photo(reader, raw, path, parts)
        }),
        material_tests: each(
            reader,
            &raw.material_tests,
            "report.material_tests",
            |reader, raw, path| material_test(reader, raw, path, parts),
        ),
        sensors: each(reader, &raw.sensors, "report.sensors", sensor),
        opinion: points(reader, &raw.opinion, "report.opinion"),
        recommendations: points(reader, &raw.recommendations, "report.recommendations"),
        maintenance: points(reader, &raw.maintenance, "report.maintenance"),
        grade: raw.grade.as_ref().and_then(|raw| grade(reader, raw)),
    })
}

/// Text in one or two languages; `None` where it is missing, or blank, which is reported.
pub(crate) fn words(reader: &mut Reader, raw: Option<&At<NamesRaw>>, path: &str) -> Option<Names> {
    let raw = raw?;
    reader.mark(path, &raw.span);
    let read = names(raw.value.clone());
    let given: Vec<&String> = [&read.en, &read.ko].into_iter().flatten().collect();
    if given.is_empty() || given.iter().any(|text| text.trim().is_empty()) {
        let fault = Fault::new(raw.span.clone(), path, Common::IsEmpty(path.to_string()));
        reader.fault(
            fault
                .allowed(WrongReport::NeedsTextOrEn)
                .help(WrongReport::WriteItOrTake),
        );
        return None;
    }
    Some(read)
}

/// Text that a form may leave empty.
fn words_or_none(reader: &mut Reader, raw: Option<&At<NamesRaw>>, path: &str) -> Option<Names> {
    let read = names(raw?.value.clone());
    let mut given = [&read.en, &read.ko].into_iter().flatten();
    match given.all(|text| text.trim().is_empty()) {
        true => None,
        false => words(reader, raw, path),
    }
}

/// Each element of a list with its path.
fn each<R, T>(
    reader: &mut Reader,
    raw: &Option<Vec<At<R>>>,
    path: &str,
    mut one: impl FnMut(&mut Reader, &At<R>, &str) -> Option<T>,
) -> Vec<T> {
    let listed = raw.iter().flatten().zip(1..);
    listed
        .filter_map(|(raw, number)| one(reader, raw, &format!("{path}[{number}]")))
        .collect()
}

fn points(reader: &mut Reader, raw: &Option<Vec<At<NamesRaw>>>, path: &str) -> Vec<Names> {
    each(reader, raw, path, |reader, raw, path| {
        words(reader, Some(raw), path)
    })
}

/// A day as "2026-11-23".
fn day(reader: &mut Reader, raw: Option<&At<String>>, path: &str) -> Option<String> {
    let raw = raw?;
    reader.mark(path, &raw.span);
    if is_day(&raw.value) {
        return Some(raw.value.clone());
    }
    let fault = Fault::new(
        raw.span.clone(),
        path,
        WrongReport::IsNotDay {
            path: path.to_string(),
            given: raw.value.to_string(),
        },
    );
    reader.fault(
        fault
            .allowed(WrongReport::MustBeDayOf)
            .help(WrongReport::WriteItAs),
    );
    None
}

/// The name of a part of the structure.
pub(crate) fn a_part(
    reader: &mut Reader,
    raw: Option<&At<String>>,
    path: &str,
    parts: &PartNames,
) -> Option<String> {
    let raw = raw?;
    reader.mark(path, &raw.span);
    let name = raw.value.trim();
    if parts.0.is_empty() && !name.is_empty() || parts.0.iter().any(|part| part == name) {
        return Some(name.to_owned());
    }
    let fault = Fault::new(
        raw.span.clone(),
        path,
        WrongReport::IsNoPartOf {
            path: path.to_string(),
            name: name.to_string(),
        },
    );
    let help: Both = match nearest(name, parts.0.iter().map(String::as_str)) {
        Some(near) => Common::DidYouMean(near.to_string()).into(),
        None => WrongReport::NamePartAsFile.into(),
    };
    reader.fault(
        fault
            .allowed(WrongReport::MustBeOneOf(listed(&parts.0)))
            .help(help),
    );
    None
}

/// The first few names.
fn listed(names: &[String]) -> Both {
    const SHOWN: usize = 12;
    let first: Vec<&str> = names.iter().take(SHOWN).map(String::as_str).collect();
    match names.len() {
        0 => WrongReport::PartsOfStructure.into(),
        count if count > SHOWN => WrongReport::AndMore {
            some: first.join(", "),
            count: (count - SHOWN).to_string(),
        }
        .into(),
        _ => first.join(", ").into(),
    }
}

fn author(reader: &mut Reader, raw: &At<AuthorRaw>, path: &str) -> Option<Author> {
    let raw = &raw.value;
    let role = words_or_none(reader, raw.role.as_ref(), &format!("{path}.role"));
    let licence = words_or_none(reader, raw.licence.as_ref(), &format!("{path}.licence"));
    let name = words(reader, raw.name.as_ref(), &format!("{path}.name"))?;
    Some(Author { name, role, licence })
}

fn location(reader: &mut Reader, raw: Option<&At<LocationRaw>>) -> Option<Location> {
    let path = "report.location";
    let At { value: raw, span } = raw?;
    let latitude = reader.within(raw.latitude.as_ref(), &format!("{path}.latitude"), -90.0, 90.0);
    let longitude = reader.within(
        raw.longitude.as_ref(),
        &format!("{path}.longitude"),
        -180.0,
        180.0,
    );
    if raw.latitude.is_some() != raw.longitude.is_some() {
        let message = WrongReport::HasOneOfLatitude(path.to_string());
        let fault = Fault::new(span.clone(), path, message);
        reader.fault(
            fault
                .allowed(WrongReport::NeedsBothOrNeither)
                .help(WrongReport::GiveBothInDegrees),
        );
    }
    Some(Location {
        address: words(reader, raw.address.as_ref(), &format!("{path}.address")),
        degrees: latitude
            .zip(longitude)
            .map(|(latitude, longitude)| [latitude, longitude]),
    })
}

fn photo(reader: &mut Reader, raw: &At<PhotoRaw>, path: &str, parts: &PartNames) -> Option<PhotoPart> {
    let raw = &raw.value;
    let file_path = format!("{path}.file");
    let caption = words(reader, raw.caption.as_ref(), &format!("{path}.caption"));
    let of = a_part(reader, raw.of.as_ref(), &format!("{path}.of"), parts);
    let file = raw.file.as_ref()?;
    reader.mark(&file_path, &file.span);
    if file.value.trim().is_empty() {
        let fault = Fault::new(
            file.span.clone(),
            &file_path,
            WrongReport::IsEmpty(file_path.to_string()),
        );
        reader.fault(fault.allowed(WrongReport::NeedsNameOfJpeg));
        return None;
    }
    Some(PhotoPart {
        file: file.value.clone(),
        caption,
        of,
        path: file_path,
    })
}

fn material_test(
    reader: &mut Reader,
    raw: &At<MaterialTestRaw>,
    path: &str,
    parts: &PartNames,
) -> Option<MaterialTest> {
    let At { value: raw, span } = raw;
    let (least, most) = VELOCITY_M_S;
    let velocity = reader.within(
        raw.velocity_m_s.as_ref(),
        &format!("{path}.velocity_m_s"),
        least,
        most,
    );
    let (least, most) = REBOUND;
    let rebound = reader.within(
        raw.rebound_number.as_ref(),
        &format!("{path}.rebound_number"),
        least,
        most,
    );
    let strength_path = format!("{path}.strength");
    let strength = reader.quantity(
        raw.strength.as_ref(),
        &strength_path,
        Measure::Stress,
        Bound::Positive,
    );
    let part = a_part(reader, raw.part.as_ref(), &format!("{path}.part"), parts);
    let date = day(reader, raw.date.as_ref(), &format!("{path}.date"));
    let note = words(reader, raw.note.as_ref(), &format!("{path}.note"));
    let method = raw.method.as_ref()?.value;
    let (own, other, foreign) = match method {
        MaterialMethodRaw::Ultrasonic => (
            "velocity_m_s",
            raw.velocity_m_s.is_some(),
            raw.rebound_number.as_ref(),
        ),
        MaterialMethodRaw::Rebound => (
            "rebound_number",
            raw.rebound_number.is_some(),
            raw.velocity_m_s.as_ref(),
        ),
    };
    if let Some(foreign) = foreign {
        let fault = Fault::new(
            foreign.span.clone(),
            path,
            WrongReport::HasReadingOfOther(path.to_string()),
        );
        reader.fault(
            fault
                .allowed(WrongReport::MustBe(own.into()))
                .help(WrongReport::ListEachTestBy),
        );
    } else if !other && raw.strength.is_none() {
        let fault = Fault::new(span.clone(), path, WrongReport::HasNoResult(path.to_string()));
        reader.fault(fault.allowed(WrongReport::NeedsStrengthOrBoth(own.into())));
    }
    Some(MaterialTest {
        method: match method {
            MaterialMethodRaw::Ultrasonic => MaterialMethod::Ultrasonic(velocity),
            MaterialMethodRaw::Rebound => MaterialMethod::Rebound(rebound),
        },
        part,
        date,
        strength,
        note,
    })
}

fn sensor(reader: &mut Reader, raw: &At<SensorRaw>, path: &str) -> Option<SensorPart> {
    let raw = &raw.value;
    let model = words(reader, raw.model.as_ref(), &format!("{path}.model"));
    let serial = words(reader, raw.serial.as_ref(), &format!("{path}.serial"));
    let calibrated = day(reader, raw.calibrated.as_ref(), &format!("{path}.calibrated"));
    let certificate = words(reader, raw.certificate.as_ref(), &format!("{path}.certificate"));
    Some(SensorPart {
        name: words(reader, raw.name.as_ref(), &format!("{path}.name"))?,
        model,
        serial,
        calibrated,
        certificate,
    })
}

fn grade(reader: &mut Reader, raw: &At<GradeRaw>) -> Option<Grade> {
    let raw = &raw.value;
    let path = "report.grade";
    let scale = words(reader, raw.scale.as_ref(), &format!("{path}.scale"));
    let reason = words(reader, raw.reason.as_ref(), &format!("{path}.reason"));
    let value_path = format!("{path}.value");
    let value = words(reader, raw.value.as_ref(), &value_path)?;
    let scale = match (scale, PeriodicGrade::of_letter(value.english())) {
        (Some(scale), _) => Some(GradeScale::Other(scale)),
        (None, letter) => letter.map(GradeScale::Periodic),
    };
    if scale.is_none() && raw.scale.is_none() {
        let message = WrongReport::IsNoGradeOf {
            value_path: value_path.to_string(),
            english: value.english().to_string(),
        };
        let fault = Fault::new(reader.place(&value_path), &value_path, message);
        reader.fault(
            fault
                .allowed(WrongReport::MustBeBC)
                .help(WrongReport::ForAnotherScaleWrite),
        );
        return None;
    }
    Some(Grade {
        value,
        scale: scale?,
        reason: reason?,
    })
}
