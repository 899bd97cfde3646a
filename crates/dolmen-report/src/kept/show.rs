//! One structure of a store: its surveys, the states of its project, who did what.

use super::list::earthquake;
use super::moment::moment;
use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text, heading_text};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::kept::{KeptMode, KeptStructure, KeptSurvey};

/// Number of frequencies of a survey in a row.
const FREQUENCIES_MOST: usize = 4;
/// Number of digits of a hash that distinguish states.
const HASH_SHOWN: usize = 12;

messages! {
    /// One structure of a store.
    pub(crate) enum Shown in "store.show" {
        Name => { en: "name", ko: "이름" },
        Both(name: Both) => { en: "{name}", ko: "{name}" },
        Kind => { en: "kind", ko: "종류" },
        Text(text: String) => { en: "{text}", ko: "{text}" },
        Place => { en: "place", ko: "위치" },
        At { latitude: Quantity, longitude: Quantity } => {
            en: "{latitude} N, {longitude} E",
            ko: "북위 {latitude}, 동경 {longitude}",
        },
        Stored => { en: "last stored", ko: "최종 저장" },
        By { at: String, who: String } => { en: "{at} UTC by {who}", ko: "{at} UTC, 담당 {who}" },
        OutOfUse => {
            en: "It is out of use: `dolmen survey remove --undo` takes it back.",
            ko: "사용이 중지된 구조물이다. `dolmen survey remove --undo`로 되돌린다.",
        },
        Surveys(count: usize) => {
            en: "{count} surveys; frequencies ± standard deviation, of the latest analysis or else as stated.",
            ko: "계측 조사 {count}건. 고유진동수 ± 표준편차는 최근 식별 결과, 없으면 기재값이다.",
        },
        Survey => { en: "survey", ko: "계측 조사" },
        From => { en: "from", ko: "근거" },
        Identified { method: String, version: String } => {
            en: "{method}, Dolmen {version}",
            ko: "{method}, Dolmen {version} 식별",
        },
        IdentifiedAndAccepted { method: String, version: String, accepted: Values } => {
            en: "{method}, Dolmen {version}; accepted by the user: {accepted}",
            ko: "{method}, Dolmen {version} 식별. 사용자 채택: {accepted}",
        },
        Stated => { en: "stated", ko: "기재값" },
        MadeUp(of: Sentence) => { en: "{of}; made up, not measured", ko: "{of}(가상, 실측 아님)" },
        Inspection => { en: "inspection", ko: "점검" },
        Entries { all: usize, severe: usize } => { en: "{all} entries, {severe} severe", ko: "{all}건(심함 {severe}건)" },
        Nothing => { en: "–", ko: "–" },
        Earthquake => { en: "earthquake", ko: "지진" },
        Tilt => { en: "tilt", ko: "기울기" },
        Records => { en: "records", ko: "기록" },
        Analyses => { en: "analyses", ko: "식별" },
        Air => { en: "air", ko: "기온" },
        Frequency(number: usize) => { en: "f{number}", ko: "f{number}" },
        States(count: usize) => { en: "{count} states of the project, the latest first.", ko: "프로젝트 판본 {count}개, 최신순." },
        State => { en: "state", ko: "판본" },
        When => { en: "stored (UTC)", ko: "저장 시각(UTC)" },
        Who => { en: "by", ko: "담당" },
        Version => { en: "Dolmen", ko: "Dolmen 버전" },
        Files => { en: "files", ko: "파일" },
        Log => { en: "Who did what, the latest first.", ko: "작업 이력, 최신순." },
        Line { at: String, who: String, verb: String, detail: String } => {
            en: "{at} {who}: {verb} ({detail})",
            ko: "{at} {who}: {verb} ({detail})",
        },
    }
}

fn words(text: &str) -> Cell {
    Cell::words(Shown::Text(text.to_owned()))
}

fn whole(value: f64) -> Cell {
    Cell::number(Quantity::new(value, Unit::ratio(), Digits::Fixed(0)))
}

/// A structure for people.
pub fn structure_text(kept: &KeptStructure, style: TextStyle) -> String {
    let head = heading_text(&kept.structure.name);
    if !style.is_full {
        let mut brief = BriefText::new(style);
        brief.block(facts(kept));
        if kept.structure.is_removed {
            brief.block(Block::Warning(Shown::OutOfUse.into()));
        }
        let mut latest = kept.surveys.clone();
        latest.reverse();
        brief.table(&surveys(&latest), latest.len());
        return head + &brief.finish();
    }
    let mut document = Document::default();
    document.put(facts(kept));
    if kept.structure.is_removed {
        document.put(Block::Warning(Shown::OutOfUse.into()));
    }
    document.put(Block::Table(surveys(&kept.surveys)));
    document.put(Block::Table(states(kept)));
    document.paragraph(Shown::Log);
    let line = |log: &dolmen_work::kept::KeptLog| {
        Shown::Line {
            at: moment(log.at_s),
            who: log.who.clone(),
            verb: log.verb.clone(),
            detail: log.detail.clone(),
        }
        .into()
    };
    document.put(Block::List(kept.log.iter().map(line).collect()));
    head + &document_text(&document, style)
}

fn facts(kept: &KeptStructure) -> Block<'static> {
    let structure = &kept.structure;
    let name = Both {
        english: structure.english.clone(),
        korean: structure.korean.clone(),
    };
    let mut rows = vec![
        (Shown::Name.into(), Cell::words(Shown::Both(name))),
        (Shown::Kind.into(), words(&structure.kind)),
    ];
    if let (Some(latitude), Some(longitude)) = (structure.latitude_deg, structure.longitude_deg) {
        let degrees = |value| Quantity::new(value, Unit::si("°"), Digits::Fixed(4));
        let place = Shown::At {
            latitude: degrees(latitude),
            longitude: degrees(longitude),
        };
        rows.push((Shown::Place.into(), Cell::words(place)));
    }
    let stored = Shown::By {
        at: moment(structure.stored_s),
        who: structure.who.clone(),
    };
    rows.push((Shown::Stored.into(), Cell::words(stored)));
    Block::KeyValues(rows)
}

/// The modes of the latest analysis, or those that the file states.
fn modes(survey: &KeptSurvey) -> (&[KeptMode], Shown) {
    match survey.analyses.first() {
        Some(analysis) => {
            let (method, version) = (analysis.method.clone(), analysis.version.clone());
            let accepted = analysis.modes.iter().filter(|mode| mode.accepted);
            let accepted =
                accepted.map(|mode| Quantity::new(mode.frequency_hz, Unit::si("Hz"), Digits::Significant(4)));
            let accepted: Vec<Quantity> = accepted.collect();
            let of = match accepted.is_empty() {
                true => Shown::Identified { method, version },
                false => Shown::IdentifiedAndAccepted {
                    method,
                    version,
                    accepted: Values(accepted),
                },
            };
            (&analysis.modes, of)
        }
        None if survey.stated_modes.is_empty() => (&[], Shown::Nothing),
        None => (&survey.stated_modes, Shown::Stated),
    }
}

fn surveys(kept: &[KeptSurvey]) -> Table {
    let shown = kept.iter().map(|survey| modes(survey).0.len()).max().unwrap_or(0);
    let shown = shown.min(FREQUENCIES_MOST);
    let any = kept.iter().any(|survey| survey.earthquake.is_some());
    let are_inspected = kept.iter().any(|survey| !survey.inspections.is_empty());
    let row = |survey: &KeptSurvey| {
        let (modes, from) = modes(survey);
        let tilts: Vec<String> = survey
            .tilts
            .iter()
            .map(|tilt| format!("{} {}", tilt.direction, tilt.written))
            .collect();
        let air = survey
            .temperature_c
            .map(|value| Quantity::new(value, Unit::si("°C"), Digits::Trimmed(3)));
        let mut row = vec![
            words(&survey.name),
            Cell::words(match survey.is_made_up {
                true => Shown::MadeUp(from.into()),
                false => from,
            }),
            match tilts.is_empty() {
                true => Cell::words(Shown::Nothing),
                false => words(&tilts.join(", ")),
            },
            whole(survey.records.len() as f64),
            whole(survey.analyses.len() as f64),
            Cell::Number(air),
        ];
        if any {
            let of = &survey.earthquake;
            row.push(earthquake(of.is_some(), of.as_ref().and_then(|of| of.peak_m_s2)));
        }
        if are_inspected {
            row.push(Cell::words(inspection(survey)));
        }
        row.extend((0..shown).map(|at| {
            Cell::Number(modes.get(at).map(|mode| Quantity {
                sd_si: mode.frequency_sd_hz.filter(|sd| *sd > 0.0),
                ..Quantity::new(mode.frequency_hz, Unit::si("Hz"), Digits::Significant(4))
            }))
        }));
        row
    };
    let mut columns = vec![
        Column::words(Shown::Survey),
        Column::words(Shown::From),
        Column::words(Shown::Tilt),
        Column::numbers(Shown::Records, Unit::ratio()),
        Column::numbers(Shown::Analyses, Unit::ratio()),
        Column::numbers(Shown::Air, Unit::si("°C")),
    ];
    if any {
        columns.push(Column::words(Shown::Earthquake));
    }
    if are_inspected {
        columns.push(Column::words(Shown::Inspection));
    }
    columns.extend((1..=shown).map(|number| Column::numbers(Shown::Frequency(number), Unit::si("Hz"))));
    Table {
        caption: vec![Shown::Surveys(kept.len()).into()],
        columns,
        rows: kept.iter().map(row).collect(),
    }
}

/// Number of entries in its inspection.
fn inspection(survey: &KeptSurvey) -> Shown {
    let of = &survey.inspections;
    let severe = of
        .iter()
        .filter(|entry| entry.severity.as_deref() == Some("severe"));
    match of.len() {
        0 => Shown::Nothing,
        all => Shown::Entries {
            all,
            severe: severe.count(),
        },
    }
}

fn states(kept: &KeptStructure) -> Table {
    let row = |state: &dolmen_work::kept::KeptState| {
        vec![
            words(&state.hash.chars().take(HASH_SHOWN).collect::<String>()),
            words(&moment(state.stored_s)),
            words(&state.who),
            words(&state.dolmen),
            whole(state.files as f64),
        ]
    };
    Table {
        caption: vec![Shown::States(kept.states.len()).into()],
        columns: vec![
            Column::words(Shown::State),
            Column::words(Shown::When),
            Column::words(Shown::Who),
            Column::words(Shown::Version),
            Column::numbers(Shown::Files, Unit::ratio()),
        ],
        rows: kept.states.iter().map(row).collect(),
    }
}
