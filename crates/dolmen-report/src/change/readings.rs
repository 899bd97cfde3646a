//! Tilts and inspections of two surveys, side by side.

use super::quantities::plus;
use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use crate::engineer::named_damage;
use dolmen_project::date_of;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::answer::CompareAnswer;
use dolmen_work::compared_readings::{ComparedItem, ComparedTilt, ItemCourse};

messages! {
    /// Tilts and inspections of two surveys.
    pub(crate) enum Readings in "change.readings" {
        NoModes { surveys: Vec<String> } => {
            en: "No frequencies of both surveys are known (none in {surveys}): tilts and inspections alone are compared.",
            ko: "고유진동수가 없는 조사가 있어({surveys}) 기울기와 점검 결과만 비교하였다.",
        },
        TiltsGrew { from: String, to: String, each: Vec<Sentence> } => {
            en: "From survey {from} to {to} it leans further: {each}. Two readings cannot tell this from their own error: read again, at the same marks.",
            ko: "{from} 조사에서 {to} 조사까지 기울기가 커졌다: {each}. 두 번의 측정만으로는 측정 오차와 구별할 수 없으므로 같은 기준점에서 다시 잰다.",
        },
        TiltsGrewOfMany { from: String, to: String, each: Vec<Sentence>, readings: usize } => {
            en: "From survey {from} to {to} it leans further: {each}. Two readings cannot tell this from their own error; «`dolmen watch`|the review of all surveys» tests all {readings}.",
            ko: "{from} 조사에서 {to} 조사까지 기울기가 커졌다: {each}. 두 번의 측정만으로는 측정 오차와 구별할 수 없다. «`dolmen watch`|장기 변화 검토»는 측정 {readings}회를 모두 써서 검정한다.",
        },
        Tilts { from: String, to: String, each: Vec<Sentence> } => {
            en: "From survey {from} to {to} no tilt grew: {each}.",
            ko: "{from} 조사에서 {to} 조사까지 커진 기울기는 없다: {each}.",
        },
        Tilt { direction: String, before: String, after: String, sign: String, change: Quantity } => {
            en: "{direction} {before} to {after} ({sign}{change})",
            ko: "{direction} {before} → {after}({sign}{change})",
        },
        TiltsTurned { from: String, to: String, each: Vec<Sentence> } => {
            en: "From survey {from} to {to} the sign of a tilt turned at about its size: {each}. A structure does not lean over to the other side so: is it the same side that counts as positive in both?",
            ko: "{from} 조사에서 {to} 조사까지 기울기의 크기는 비슷한데 부호가 바뀌었다: {each}. 구조물이 이렇게 반대쪽으로 기울지는 않는다. 두 조사의 양(+)의 방향이 같은가?",
        },
        OtherDatum { from: String, to: String } => {
            en: "Surveys {from} and {to} refer to different marks (datum): their tilts are not compared.",
            ko: "{from} 조사와 {to} 조사의 측정 기준점(datum)이 달라 기울기를 비교하지 않았다.",
        },
        TiltsOfOne { directions: Vec<String> } => {
            en: "The tilt along {directions} was read in one of the two surveys alone.",
            ko: "{directions} 방향 기울기는 두 조사 중 하나에만 있다.",
        },
        Worse { from: String, to: String, each: Vec<Sentence> } => {
            en: "From inspection {from} to {to}, worse or new: {each}.",
            ko: "{from} 점검 이후 {to} 점검까지 악화되거나 새로 나타난 손상: {each}.",
        },
        NotWorse { from: String, to: String, count: usize } => {
            en: "Inspections {from} and {to}: nothing new and nothing larger ({count} compared).",
            ko: "{from} 점검과 {to} 점검: 새로 생기거나 커진 것이 없다(비교한 것 {count}건).",
        },
        NotAgain { to: String, each: Vec<Sentence> } => {
            en: "Not in inspection {to}, mended or not looked for: {each}.",
            ko: "{to} 점검에 없는 것(보수하였거나 살피지 않음): {each}.",
        },
        Item { part: String, what: Sentence } => { en: "{what} of “{part}”", ko: "‘{part}’ {what}" },
        New { part: String, what: Sentence } => { en: "{what} of “{part}” (new)", ko: "‘{part}’ {what}(신규)" },
        Grew { part: String, what: Sentence, before: Quantity, after: Quantity } => {
            en: "{what} of “{part}” ({before} to {after})",
            ko: "‘{part}’ {what}({before} → {after})",
        },
        More { part: String, what: Sentence, before: usize, after: usize } => {
            en: "{what} of “{part}” ({before} of them, now {after})",
            ko: "‘{part}’ {what}({before}곳에서 {after}곳으로)",
        },
        TiltTable => { en: "Tilts of the two surveys.", ko: "두 조사의 기울기." },
        ItemTable => { en: "What the two inspections found.", ko: "두 점검의 결과." },
        Direction => { en: "Direction", ko: "방향" },
        Part => { en: "Part", ko: "부재" },
        Damage => { en: "Damage", ko: "손상" },
        Course => { en: "Course", ko: "경과" },
        Before => { en: "before", ko: "이전" },
        After => { en: "after", ko: "이후" },
        Change => { en: "change", ko: "변화" },
        IsNew => { en: "new", ko: "신규" },
        IsNotAgain => { en: "not found again", ko: "이번에는 없음" },
        IsLarger => { en: "larger", ko: "커짐" },
        IsSmaller => { en: "smaller", ko: "작아짐" },
        IsSame => { en: "as before", ko: "변화 없음" },
        IsOfNoSize => { en: "in both, no size", ko: "양쪽에 있음, 크기 없음" },
        AreSeveral { before: usize, after: usize } => { en: "{before} before, {after} now", ko: "이전 {before}곳, 현재 {after}곳" },
    }
}

fn slope(ratio: f64) -> Quantity {
    let unit = Unit {
        symbol: "mm/m".to_owned(),
        factor: 1e3,
    };
    Quantity::new(ratio, unit, Digits::Fixed(2))
}

fn size(metres: f64) -> Quantity {
    let unit = Unit {
        symbol: "mm".to_owned(),
        factor: 1e3,
    };
    Quantity::new(metres, unit, Digits::Trimmed(3))
}

/// Findings on tilts and inspections.
pub(super) fn findings(answer: &CompareAnswer) -> Vec<Finding> {
    let readings = &answer.readings;
    let (from, to) = (&answer.from, &answer.to);
    let mut all = Vec::new();
    all.extend(tilts(answer));
    all.extend(items(&readings.items, from, to));
    if !readings.without_modes.is_empty() {
        let surveys = readings.without_modes.clone();
        all.push(Finding::key(Tone::Unknown, Readings::NoModes { surveys }));
    }
    all
}

fn tilts(answer: &CompareAnswer) -> Vec<Finding> {
    let readings = &answer.readings;
    let (from, to) = (answer.from.clone(), answer.to.clone());
    let mut all = Vec::new();
    if !readings.tilts.is_empty() && readings.other_datum {
        all.push(Finding::key(Tone::Unknown, Readings::OtherDatum { from, to }));
    } else if !readings.tilts.is_empty() {
        let (turned, straight): (Vec<_>, Vec<_>) = readings.tilts.iter().partition(|tilt| has_turned(tilt));
        if !turned.is_empty() {
            let said = Readings::TiltsTurned {
                from: from.clone(),
                to: to.clone(),
                each: turned.into_iter().map(tilt).collect(),
            };
            all.push(Finding::key(Tone::Warn, said));
        }
        let has_grown = straight.iter().any(|tilt| tilt.has_grown());
        let each: Vec<Sentence> = straight.into_iter().map(tilt).collect();
        match (each.is_empty(), has_grown) {
            (true, _) => {}
            (false, true) => all.push(Finding::key(Tone::Warn, grew(answer, each))),
            (false, false) => all.push(Finding::key(Tone::Plain, Readings::Tilts { from, to, each })),
        }
    }
    if !readings.tilts_of_one.is_empty() {
        let directions = readings.tilts_of_one.clone();
        all.push(Finding::key(Tone::Unknown, Readings::TiltsOfOne { directions }));
    }
    all
}

/// Fewest readings of a tilt that `watch` tests.
const TESTED_LEAST: usize = 3;

/// Finding that tilts grew, and how this is distinguished from their error.
fn grew(answer: &CompareAnswer, each: Vec<Sentence>) -> Readings {
    let (from, to) = (answer.from.clone(), answer.to.clone());
    let dated = answer
        .project
        .surveys
        .iter()
        .filter(|survey| date_of(&survey.name).is_some());
    let readings = answer.readings.tilts.iter().map(|tilt| {
        let own = dated
            .clone()
            .filter(|survey| survey.tilt.contains_key(&tilt.direction));
        own.count()
    });
    match readings.max().unwrap_or(0) {
        readings if readings >= TESTED_LEAST => Readings::TiltsGrewOfMany {
            from,
            to,
            each,
            readings,
        },
        _ => Readings::TiltsGrew { from, to, each },
    }
}

/// Largest ratio of two tilts of opposite signs that count as one tilt with a reversed sign. Our choice.
const ONE_SIZE: f64 = 1.5;

/// Whether a tilt reversed its sign at about the same size.
fn has_turned(tilt: &ComparedTilt) -> bool {
    let ratio = -tilt.to.ratio / tilt.from.ratio;
    (1.0 / ONE_SIZE..=ONE_SIZE).contains(&ratio)
}

fn tilt(tilt: &ComparedTilt) -> Sentence {
    Readings::Tilt {
        direction: tilt.direction.clone(),
        before: tilt.from.written.clone(),
        after: tilt.to.written.clone(),
        sign: plus(tilt.change()),
        change: slope(tilt.change()),
    }
    .into()
}

fn items(all: &[ComparedItem], from: &str, to: &str) -> Vec<Finding> {
    if all.is_empty() {
        return Vec::new();
    }
    let (from, to) = (from.to_owned(), to.to_owned());
    let worse: Vec<Sentence> = all
        .iter()
        .filter(|item| item.course.is_worse())
        .map(item)
        .collect();
    let gone: Vec<Sentence> = all
        .iter()
        .filter(|item| item.course == ItemCourse::NotFoundAgain)
        .map(item)
        .collect();
    let first = match worse.is_empty() {
        false => Finding::key(
            Tone::Warn,
            Readings::Worse {
                from,
                to: to.clone(),
                each: worse,
            },
        ),
        true => Finding::key(
            Tone::Plain,
            Readings::NotWorse {
                from,
                to: to.clone(),
                count: all.len() - gone.len(),
            },
        ),
    };
    let gone = (!gone.is_empty()).then(|| Finding::key(Tone::Unknown, Readings::NotAgain { to, each: gone }));
    std::iter::once(first).chain(gone).collect()
}

fn item(of: &ComparedItem) -> Sentence {
    let (part, what) = (of.part.clone(), named_damage(&of.what, of.name.as_deref()));
    match &of.course {
        ItemCourse::New { .. } => Readings::New { part, what },
        ItemCourse::NotFoundAgain | ItemCourse::NoSize => Readings::Item { part, what },
        ItemCourse::Sized { from, to } => Readings::Grew {
            part,
            what,
            before: size(from.value),
            after: size(to.value),
        },
        ItemCourse::Several { before, after } => Readings::More {
            part,
            what,
            before: *before,
            after: *after,
        },
    }
    .into()
}

/// Tables of tilts and inspections.
pub(super) fn section(document: &mut Document<'_>, answer: &CompareAnswer) {
    let readings = &answer.readings;
    if !readings.tilts.is_empty() && !readings.other_datum {
        document.put(Block::Table(tilt_table(&readings.tilts)));
    }
    if !readings.items.is_empty() {
        document.put(Block::Table(item_table(&readings.items)));
    }
}

fn tilt_table(tilts: &[ComparedTilt]) -> Table {
    let words = |text: &str| Cell::words(Sentence::of_symbol(text));
    let unit = || slope(0.0).unit;
    Table {
        caption: vec![Readings::TiltTable.into()],
        columns: vec![
            Column::words(Readings::Direction),
            Column::numbers(Readings::Before, unit()),
            Column::numbers(Readings::After, unit()),
            Column::numbers(Readings::Change, unit()),
        ],
        rows: tilts
            .iter()
            .map(|tilt| {
                vec![
                    words(&tilt.direction),
                    Cell::number(slope(tilt.from.ratio)),
                    Cell::number(slope(tilt.to.ratio)),
                    match tilt.has_grown() {
                        true => Cell::Bad(slope(tilt.change())),
                        false => Cell::number(slope(tilt.change())),
                    },
                ]
            })
            .collect(),
    }
}

fn item_table(items: &[ComparedItem]) -> Table {
    let unit = || size(0.0).unit;
    Table {
        caption: vec![Readings::ItemTable.into()],
        columns: vec![
            Column::words(Readings::Part),
            Column::words(Readings::Damage),
            Column::words(Readings::Course),
            Column::numbers(Readings::Before, unit()),
            Column::numbers(Readings::After, unit()),
        ],
        rows: items.iter().map(item_row).collect(),
    }
}

fn item_row(of: &ComparedItem) -> Vec<Cell> {
    let (before, after) = match &of.course {
        ItemCourse::Sized { from, to } => (Some(from.value), Some(to.value)),
        ItemCourse::New { size } => (None, size.as_ref().map(|size| size.value)),
        _ => (None, None),
    };
    let course = match &of.course {
        ItemCourse::New { .. } => Readings::IsNew,
        ItemCourse::NotFoundAgain => Readings::IsNotAgain,
        ItemCourse::NoSize => Readings::IsOfNoSize,
        ItemCourse::Sized { from, to } if to.value > from.value => Readings::IsLarger,
        ItemCourse::Sized { from, to } if to.value < from.value => Readings::IsSmaller,
        ItemCourse::Sized { .. } => Readings::IsSame,
        ItemCourse::Several { before, after } => Readings::AreSeveral {
            before: *before,
            after: *after,
        },
    };
    vec![
        Cell::words(Sentence::of_symbol(&of.part)),
        Cell::words(named_damage(&of.what, of.name.as_deref())),
        match of.course.is_worse() {
            true => Cell::BadWords(course.into()),
            false => Cell::words(course),
        },
        Cell::Number(before.map(size)),
        Cell::Number(after.map(size)),
    ]
}
