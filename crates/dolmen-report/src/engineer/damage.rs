//! Results of inspections: the damage map, a list, and counts.

use super::photos::Pictures;
use super::words::{cell, verbatim};
use crate::document::{Block, Cell, Column, Document, Figure, Photo, Table, table_series};
use crate::figures::{DamageMark, damage_map};
use dolmen_project::{DamageKind, InModel, Inspection, Project, Severity, Survey, date_of};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use std::collections::BTreeMap;

messages! {
    /// Results of inspections.
    pub(crate) enum Damage in "engineer.damage" {
        Head(survey: String) => { en: "Inspection {survey}", ko: "{survey} 점검" },
        Map => { en: "Damage map.", ko: "외관조사망도." },
        MapMeaning => {
            en: "Numbers as in the list; a full mark is severe, a half-dark one moderate, a light one slight or not rated.",
            ko: "번호는 아래 표와 같다. 표지의 색이 짙을수록 손상이 심하며, 옅은 것은 경미하거나 등급이 없는 것이다.",
        },
        List(survey: String) => { en: "What the inspection of {survey} found.", ko: "{survey} 점검 결과." },
        EarlierHead => { en: "Earlier inspections", ko: "이전 점검" },
        Earlier { inspections: usize, first: String, last: String } => {
            en: "What {inspections} inspections from {first} to {last} found.",
            ko: "{first}부터 {last}까지 점검 {inspections}회의 결과.",
        },
        Inspection => { en: "Inspection", ko: "점검" },
        Counts => { en: "How many of each kind, by severity.", ko: "손상 종류와 정도별 수." },
        Number => { en: "No.", ko: "번호" },
        Part => { en: "Part", ko: "부재" },
        What => { en: "Damage", ko: "손상" },
        SeverityHead => { en: "Severity", ko: "정도" },
        Size => { en: "Size", ko: "크기" },
        Note => { en: "Note", ko: "비고" },
        Model => { en: "In the model", ko: "모델 반영" },
        Bed(share: Quantity) => { en: "bed less {share}", ko: "접합면 {share} 손실" },
        BedAt { share: Quantity, side: String } => { en: "bed less {share} at {side}", ko: "접합면 {side} 쪽 {share} 손실" },
        Stiffness(left: Quantity) => { en: "{left} of the stiffness", ko: "강성 {left}로 저하" },
        Ties => { en: "ties broken", ko: "연결재 파단" },
        Gone => { en: "stone gone", ko: "결실" },
        Mended => { en: "mended", ko: "보수" },
        Photo { number: usize, part: String, what: Sentence } => { en: "{number}: {part}, {what}", ko: "{number}: {part}, {what}" },
        Crack => { en: "crack", ko: "균열" },
        Spalling => { en: "spalling", ko: "박락" },
        Exfoliation => { en: "exfoliation", ko: "박리" },
        OpenJoint => { en: "open joint", ko: "이격" },
        Tilt => { en: "tilt", ko: "기울기" },
        Settlement => { en: "settlement", ko: "침하" },
        Loss => { en: "loss", ko: "결손" },
        Growth => { en: "growth of plants", ko: "생물오염" },
        Named { what: Sentence, name: String } => { en: "{what} {name}", ko: "{what} {name}" },
        Other(what: Both) => { en: "{what}", ko: "{what}" },
        Slight => { en: "slight", ko: "경미" },
        Moderate => { en: "moderate", ko: "보통" },
        Severe => { en: "severe", ko: "심함" },
        Unrated => { en: "not rated", ko: "미분류" },
        All => { en: "all", ko: "합계" },
    }
}

/// Number of inspections above which only the last has a section of its own: their maps would fill a page each.
const DETAILED_MOST: usize = 3;

/// A section for each survey with an inspection; if there are many, one for the last, and one table for the others.
pub(crate) fn damage<'a>(project: &'a Project, pictures: Pictures<'a>) -> Document<'a> {
    let mut document = Document::default();
    let surveys = project.surveys.iter();
    let mut inspected: Vec<&Survey> = surveys.filter(|survey| !survey.inspections.is_empty()).collect();
    inspected.sort_by_key(|survey| date_of(&survey.name).unwrap_or_default());
    let (earlier, detailed) = match inspected.len() {
        all if all > DETAILED_MOST => inspected.split_at(all - 1),
        _ => inspected.split_at(0),
    };
    for survey in detailed {
        of_survey(&mut document, project, survey, pictures);
    }
    if let ([first, ..], Some(last)) = (earlier, earlier.last()) {
        document.heading(Damage::EarlierHead);
        let (inspections, first, last) = (earlier.len(), first.name.clone(), last.name.clone());
        document.put(Block::Table(list(
            Damage::Earlier {
                inspections,
                first,
                last,
            },
            earlier,
        )));
        let photos: Vec<Photo<'a>> = earlier
            .iter()
            .flat_map(|survey| photos(survey, pictures))
            .collect();
        if !photos.is_empty() {
            document.put(Block::Photos(photos));
        }
    }
    document
}

fn of_survey<'a>(
    document: &mut Document<'a>,
    project: &'a Project,
    survey: &'a Survey,
    pictures: Pictures<'a>,
) {
    document.heading(Damage::Head(survey.name.clone()));
    let marks: Vec<DamageMark> = survey.inspections.iter().map(mark).collect();
    // without the damage that was found later
    let structure = match project.earlier_model(&survey.name) {
        Some(earlier) => &earlier.structure,
        None => &project.structure,
    };
    if damage_map(structure, &marks, dolmen_words::Language::English).is_some() {
        let map = Figure::drawn(
            vec![Damage::Map.into(), Damage::MapMeaning.into()],
            move |language| damage_map(structure, &marks, language).unwrap_or_default(),
        );
        document.charted(map.with_series(move || table_series(&list_of(survey))));
    }
    document.put(Block::Table(list_of(survey)));
    document.put(Block::Table(counts(&survey.inspections)));
    let photos = photos(survey, pictures);
    if !photos.is_empty() {
        document.put(Block::Photos(photos));
    }
}

fn list_of(survey: &Survey) -> Table {
    let caption = Damage::List(survey.name.clone());
    list(caption, &[survey])
}

fn photos<'a>(survey: &'a Survey, pictures: Pictures<'a>) -> Vec<Photo<'a>> {
    let numbered = (1..).zip(&survey.inspections);
    numbered
        .filter_map(|(number, found)| {
            let caption = Damage::Photo {
                number,
                part: found.part.clone(),
                what: named(&found.what, found.name.as_deref()),
            };
            let photo = pictures.photo(found.photo.as_ref()?);
            Some(Photo {
                caption: vec![caption.into()],
                ..photo
            })
        })
        .collect()
}

fn mark(found: &Inspection) -> DamageMark {
    DamageMark {
        part: found.part.clone(),
        at_m: found.at,
        severity: found.severity,
    }
}

/// The damage in words.
pub(crate) fn what(kind: &DamageKind) -> Sentence {
    match kind {
        DamageKind::Crack => Damage::Crack,
        DamageKind::Spalling => Damage::Spalling,
        DamageKind::Exfoliation => Damage::Exfoliation,
        DamageKind::OpenJoint => Damage::OpenJoint,
        DamageKind::Tilt => Damage::Tilt,
        DamageKind::Settlement => Damage::Settlement,
        DamageKind::Loss => Damage::Loss,
        DamageKind::Growth => Damage::Growth,
        DamageKind::Other(other) => Damage::Other(Both {
            english: other.english.clone(),
            korean: other.korean.clone(),
        }),
    }
    .into()
}

/// The damage in words, with the name that inspections give it.
pub(crate) fn named(kind: &DamageKind, name: Option<&str>) -> Sentence {
    match name {
        None => what(kind),
        Some(name) => Damage::Named {
            what: what(kind),
            name: name.to_owned(),
        }
        .into(),
    }
}

pub(crate) fn severity_words(of: Option<Severity>) -> Sentence {
    severity(of).into()
}

fn severity(of: Option<Severity>) -> Damage {
    match of {
        Some(Severity::Slight) => Damage::Slight,
        Some(Severity::Moderate) => Damage::Moderate,
        Some(Severity::Severe) => Damage::Severe,
        None => Damage::Unrated,
    }
}

/// The entries of inspections; if there are several, each with its inspection.
fn list(caption: Damage, surveys: &[&Survey]) -> Table {
    let millimetres = Unit {
        symbol: "mm".to_owned(),
        factor: 1e3,
    };
    let found = || {
        surveys
            .iter()
            .flat_map(|survey| survey.inspections.iter().enumerate())
    };
    let words = |head: Damage, cell: &dyn Fn(usize, &Inspection) -> Cell| {
        let cells = found().map(|(at, one)| cell(at, one));
        (Column::words(head), cells.collect::<Vec<Cell>>())
    };
    let sizes = found().map(|(_, one)| {
        let size = one.size.as_ref().map(|size| size.value);
        Cell::Number(size.map(|size| Quantity::new(size, millimetres.clone(), Digits::Trimmed(3))))
    });
    let rated = |one: &Inspection| match one.severity {
        Some(Severity::Severe) => Cell::BadWords(severity(one.severity).into()),
        _ => Cell::words(severity(one.severity)),
    };
    let dates = surveys.iter().flat_map(|survey| {
        survey
            .inspections
            .iter()
            .map(|_| Cell::words(verbatim(&survey.name)))
    });
    let dates = (surveys.len() > 1).then(|| (Column::words(Damage::Inspection), dates.collect()));
    let is_modelled = found().any(|(_, one)| one.model.is_some());
    let models = is_modelled.then(|| {
        words(Damage::Model, &|_, one| {
            one.model.map_or_else(|| Cell::words(verbatim("")), in_model)
        })
    });
    let columns = [
        words(Damage::Number, &|at, _| {
            Cell::words(verbatim(&(at + 1).to_string()))
        }),
        words(Damage::Part, &|_, one| Cell::words(verbatim(&one.part))),
        words(Damage::What, &|_, one| {
            Cell::words(named(&one.what, one.name.as_deref()))
        }),
        words(Damage::SeverityHead, &|_, one| rated(one)),
        words(Damage::Note, &|_, one| cell(one.note.as_ref())),
        (
            Column::numbers(Damage::Size, millimetres.clone()),
            sizes.collect(),
        ),
    ];
    super::words::table_of(caption, dates.into_iter().chain(columns).chain(models).collect())
}

/// The effect of a damage on the model.
fn in_model(effect: InModel) -> Cell {
    Cell::words(match effect {
        InModel::BedLost { share, side } => {
            let share = Quantity::percent(share, 2);
            match side {
                None => Damage::Bed(share),
                Some(side) => Damage::BedAt {
                    share,
                    side: side.word().to_owned(),
                },
            }
        }
        InModel::StiffnessLeft(left) => Damage::Stiffness(Quantity::percent(left, 2)),
        InModel::TiesBroken => Damage::Ties,
        InModel::Lost => Damage::Gone,
        InModel::Mended => Damage::Mended,
    })
}

/// One row per kind, one column per severity, without empty ones.
fn counts(found: &[Inspection]) -> Table {
    const SEVERITIES: [Option<Severity>; 4] = [
        Some(Severity::Severe),
        Some(Severity::Moderate),
        Some(Severity::Slight),
        None,
    ];
    let mut kinds: BTreeMap<&DamageKind, Vec<Option<Severity>>> = BTreeMap::new();
    for one in found {
        kinds.entry(&one.what).or_default().push(one.severity);
    }
    let count = |of: usize| Cell::number(Quantity::new(of as f64, Unit::ratio(), Digits::Fixed(0)));
    let of = |each: &[Option<Severity>], severity| each.iter().filter(|one| **one == severity).count();
    let mut columns = vec![(
        Column::words(Damage::What),
        kinds.keys().map(|kind| Cell::words(what(kind))).collect(),
    )];
    for rated in SEVERITIES {
        if found.iter().any(|one| one.severity == rated) {
            let cells = kinds.values().map(|each| count(of(each, rated))).collect();
            columns.push((Column::numbers(severity(rated), Unit::ratio()), cells));
        }
    }
    let all = kinds.values().map(|each| count(each.len())).collect();
    columns.push((Column::numbers(Damage::All, Unit::ratio()), all));
    super::words::table_of(Damage::Counts, columns)
}
