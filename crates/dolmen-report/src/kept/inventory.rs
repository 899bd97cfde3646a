//! Many structures over the years, one line each.

use super::formats::{line, number, quoted, text as text_cell};
use crate::as_json;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text};
use crate::limits::part_words;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::inventory::{ExplainingPart, History, InventoryLine};
use dolmen_work::watch_doubts::NotKnown;
use serde_json::Value;

/// Rows on a terminal without --full.
const ROWS_MOST: usize = 12;

messages! {
    /// The list of structures that are watched.
    pub(crate) enum Watched in "store.watched" {
        Caption { alarming: usize, structures: usize, to_watch: usize } => {
            en: "Structures with an open alarm or a tilt or crack beyond its limit: {alarming} of {structures}, the worst first. Without an alarm, but changed or off in the last survey, and nobody looked since: {to_watch}; measure these again soon. A change is the strongest lasting one of any mode; off is how far the last survey lies from what those before it predict.",
            ko: "조치되지 않은 경보가 있거나 기울기 또는 균열 폭이 한계를 넘은 구조물: {structures}기 중 {alarming}기, 나쁜 것부터. 경보는 아니나 변화하였거나 마지막 조사가 예측을 벗어났고 이후 보수나 점검이 없는 구조물: {to_watch}기, 곧 다시 계측한다. 변화는 모든 모드 중 가장 뚜렷한 지속적 변화이고, 이탈은 마지막 조사가 이전 조사의 예측에서 벗어난 정도이다.",
        },
        NotKnown { count: usize } => {
            en: "NOT KNOWN TO BE SOUND though nothing was found: {count}; the column “not known” says why.",
            ko: "이상이 발견되지 않았으나 건전하다고 볼 수 없는 구조물: {count}기. 이유는 ‘미확인’ 열에 있다.",
        },
        NotKnownHead => { en: "not known", ko: "미확인" },
        NotJudged => { en: "not judged", ko: "판정 못 함" },
        ModesMissing => { en: "modes missing", ko: "모드 누락" },
        SurveysLeftOut => { en: "surveys left out", ko: "조사 제외" },
        SeesLittle => { en: "sees little", ko: "검출력 부족" },
        Each(each: Vec<Sentence>) => { en: "{each}", ko: "{each}" },
        Structure => { en: "structure", ko: "구조물" },
        Text(text: String) => { en: "{text}", ko: "{text}" },
        Alarms => { en: "alarms", ko: "경보" },
        Change => { en: "change", ko: "변화" },
        Off => { en: "off", ko: "이탈" },
        After => { en: "changed after", ko: "변화 시점(이후)" },
        Tilt => { en: "tilt", ko: "기울기" },
        Years => { en: "tilt limit in", ko: "기울기 한계까지" },
        Last => { en: "last survey", ko: "최근 조사" },
        LeftOut { structure: String, why: Both } => {
            en: "{structure} was not watched: {why}",
            ko: "{structure}: 경년 변화를 검토하지 못하였다. {why}",
        },
        OnePart { structure: String, part: Sentence, factor: Quantity, low: Quantity, high: Quantity } => {
            en: "{structure}: if the model is right and one part alone changed, it is {part}: {factor} of its stiffness is left (95 %: {low} to {high}).",
            ko: "{structure}: 모델이 옳고 한 부위만 변하였다면 {part}이며 강성은 이전의 {factor}이다(95 % 구간 {low}–{high}).",
        },
        SeveralParts { structure: String, parts: Vec<Sentence>, more: Sentence } => {
            en: "{structure}: if the model is right and one part alone changed, it cannot be told which of these: {parts}{more}.",
            ko: "{structure}: 모델이 옳고 한 부위만 변하였다면 다음 중 어느 부위인지 구별되지 않는다: {parts}{more}.",
        },
        AndMore(count: usize) => { en: ", and {count} more", ko: " 외 {count}곳" },
        NoMore => { en: "", ko: "" },
        Along { part: Sentence, direction: String } => { en: "{part} (direction {direction})", ko: "{part}({direction} 방향)" },
        MoreLeftOut(count: usize) => {
            en: "{count} more were not watched: --full, --csv and --json say why.",
            ko: "그 밖에 {count}기를 검토하지 못하였다. 이유는 --full, --csv, --json으로 본다.",
        },
        More(count: usize) => {
            en: "{count} more below: --full, --csv and --json give all.",
            ko: "나머지 {count}기는 --full, --csv, --json으로 본다.",
        },
        Nothing => { en: "No structure is in the store.", ko: "저장소에 구조물이 없다." },
    }
}

fn words(text: &str) -> Cell {
    Cell::words(Watched::Text(text.to_owned()))
}

/// Why a structure is not known to be sound.
fn not_known(history: &History) -> Cell {
    let word = |why: &NotKnown| -> Sentence {
        match why {
            NotKnown::NotJudged => Watched::NotJudged,
            NotKnown::ModesMissing => Watched::ModesMissing,
            NotKnown::SurveysLeftOut => Watched::SurveysLeftOut,
            NotKnown::SeesLittle => Watched::SeesLittle,
        }
        .into()
    };
    match history.not_known.is_empty() {
        true => words("–"),
        false => Cell::words(Watched::Each(history.not_known.iter().map(word).collect())),
    }
}

fn row(structure: &str, history: &History, is_full: bool) -> Vec<Cell> {
    let ratio = |value: f64, unit, digits| Quantity::new(value, unit, digits);
    let count = ratio(history.open_alarms as f64, Unit::ratio(), Digits::Fixed(0));
    let change = history.change.as_ref();
    let tilt = history.tilt.as_ref();
    let mut cells = vec![
        words(structure),
        match history.open_alarms > 0 {
            true => Cell::Bad(count),
            false => Cell::number(count),
        },
        Cell::Number(change.map(|change| ratio(change.ratio, Unit::percent(), Digits::Fixed(2)))),
        match history
            .last_off
            .map(|off| ratio(off.ratio, Unit::percent(), Digits::Fixed(2)))
        {
            Some(off) => Cell::Bad(off),
            None => Cell::Number(None),
        },
        match (tilt, history.is_tilt_beyond) {
            (Some(tilt), true) => Cell::Bad(ratio(1000.0 * tilt.now, Unit::si("mm/m"), Digits::Fixed(1))),
            _ => Cell::Number(tilt.map(|tilt| ratio(1000.0 * tilt.now, Unit::si("mm/m"), Digits::Fixed(1)))),
        },
        words(&history.last_survey),
        not_known(history),
    ];
    if is_full {
        cells.extend([
            words(change.map_or("–", |change| &change.after)),
            Cell::Number(
                tilt.and_then(|tilt| tilt.years_to_limit)
                    .map(|years| ratio(years, Unit::si("a"), Digits::Fixed(0))),
            ),
        ]);
    }
    cells
}

fn columns(is_full: bool) -> Vec<Column> {
    let mut columns = vec![
        Column::words(Watched::Structure),
        Column::numbers(Watched::Alarms, Unit::ratio()),
        Column::numbers(Watched::Change, Unit::percent()),
        Column::numbers(Watched::Off, Unit::percent()),
        Column::numbers(Watched::Tilt, Unit::si("mm/m")),
        Column::words(Watched::Last),
        Column::words(Watched::NotKnownHead),
    ];
    if is_full {
        columns.extend([
            Column::words(Watched::After),
            Column::numbers(Watched::Years, Unit::si("a")),
        ]);
    }
    columns
}

/// Number of parts listed; others are counted.
const PARTS_LISTED: usize = 4;

/// The part that explains the strongest change, in one direction.
fn explained(structure: &str, parts: &[ExplainingPart]) -> Watched {
    let structure = structure.to_owned();
    let named = |of: &ExplainingPart| -> Sentence {
        let part = part_words(&of.part);
        match &of.direction {
            None => part,
            Some(direction) => Watched::Along {
                part,
                direction: direction.clone(),
            }
            .into(),
        }
    };
    let share = |of: f64| Quantity::new(of, Unit::percent(), Digits::Fixed(0));
    match parts {
        [one] => Watched::OnePart {
            structure,
            part: named(one),
            factor: share(one.stiffness_left),
            low: share(one.stiffness_left_lower),
            high: share(one.stiffness_left_upper),
        },
        several => Watched::SeveralParts {
            structure,
            parts: several.iter().take(PARTS_LISTED).map(named).collect(),
            more: match several.len().saturating_sub(PARTS_LISTED) {
                0 => Watched::NoMore,
                count => Watched::AndMore(count),
            }
            .into(),
        },
    }
}

/// The structures as text, in the given order: watched ones as a table, the others with the reason.
pub fn inventory_text(lines: &[InventoryLine], style: TextStyle) -> String {
    let mut document = Document::default();
    if lines.is_empty() {
        document.paragraph(Watched::Nothing);
        return document_text(&document, style);
    }
    let most = if style.is_full { usize::MAX } else { ROWS_MOST };
    let watched: Vec<(&InventoryLine, &History)> = lines
        .iter()
        .filter_map(|line| Some((line, line.history.as_ref()?)))
        .collect();
    let table = Table {
        caption: vec![
            Watched::Caption {
                alarming: lines.iter().filter(|line| line.is_alarming()).count(),
                structures: lines.len(),
                to_watch: lines.iter().filter(|line| line.is_to_watch()).count(),
            }
            .into(),
        ],
        columns: columns(style.is_full),
        rows: watched
            .iter()
            .take(most)
            .map(|(line, history)| row(&line.structure, history, style.is_full))
            .collect(),
    };
    let count = lines.iter().filter(|line| line.is_not_known()).count();
    if count > 0 {
        document.put(Block::Warning(Watched::NotKnown { count }.into()));
    }
    document.put(Block::Table(table));
    let left = watched.len().saturating_sub(most);
    if left > 0 {
        document.note(Watched::More(left));
    }
    for (line, history) in watched.iter().take(most) {
        let parts = history
            .change
            .as_ref()
            .map_or(&[][..], |change| change.explained_by.as_slice());
        for along in parts.chunk_by(|a, b| a.direction == b.direction) {
            document.note(explained(&line.structure, along));
        }
    }
    let not: Vec<(&str, &Both)> = lines
        .iter()
        .filter_map(|line| Some((line.structure.as_str(), line.not_watched.as_ref()?)))
        .collect();
    let told = if style.is_full { usize::MAX } else { 3 };
    for (structure, why) in not.iter().take(told) {
        document.note(Watched::LeftOut {
            structure: (*structure).to_owned(),
            why: (*why).clone(),
        });
    }
    if not.len() > told {
        document.note(Watched::MoreLeftOut(not.len() - told));
    }
    document_text(&document, style)
}

/// The structures as JSON.
pub fn inventory_json(lines: &[InventoryLine]) -> Value {
    let alarming = lines.iter().filter(|line| line.is_alarming()).count();
    let to_watch = lines.iter().filter(|line| line.is_to_watch()).count();
    let not_known = lines.iter().filter(|line| line.is_not_known()).count();
    as_json!({ "structures": lines, "alarming": alarming, "to_watch": to_watch, "not_known": not_known })
}

/// The structures as a table (CSV), with the byte order mark by which Excel recognises UTF-8.
pub fn inventory_csv(lines: &[InventoryLine]) -> String {
    let head = "\u{feff}structure,open_alarms,is_tilt_beyond,change_ratio,change_sd,frequency_hz,change_after,change_before,\
                tilt_direction,tilt,tilt_limit,years_to_limit,surveys,last_survey,not_watched,open_sensor_alarms,cracks_beyond,is_change_open,last_off_ratio,last_off_score,\
                changed_parts,stiffness_left,stiffness_left_lower,stiffness_left_upper,not_known\r\n";
    let each = lines.iter().map(|of| {
        let history = of.history.as_ref();
        let change = history.and_then(|history| history.change.as_ref());
        let tilt = history.and_then(|history| history.tilt.as_ref());
        let parts = change.map_or(&[][..], |change| change.explained_by.as_slice());
        let names: Vec<&str> = parts.iter().map(|of| of.part.name()).collect();
        let best = parts.first();
        let not_known = history.map_or(&[][..], |history| history.not_known.as_slice());
        let not_known: Vec<&str> = not_known.iter().map(NotKnown::key).collect();
        let whole = |value: Option<usize>| value.map_or_else(String::new, |value| value.to_string());
        line(&[
            quoted(&of.structure),
            whole(history.map(|history| history.open_alarms)),
            history.map_or_else(String::new, |history| history.is_tilt_beyond.to_string()),
            number(change.map(|change| change.ratio)),
            number(change.map(|change| change.sd)),
            number(change.map(|change| change.frequency_hz)),
            text_cell(change.map(|change| change.after.as_str())),
            text_cell(change.map(|change| change.before.as_str())),
            text_cell(tilt.map(|tilt| tilt.direction.as_str())),
            number(tilt.map(|tilt| tilt.now)),
            number(tilt.and_then(|tilt| tilt.limit)),
            number(tilt.and_then(|tilt| tilt.years_to_limit)),
            whole(history.map(|history| history.surveys)),
            text_cell(history.map(|history| history.last_survey.as_str())),
            text_cell(of.not_watched.as_ref().map(|why| why.english.as_str())),
            whole(history.map(|history| history.open_sensor_alarms)),
            whole(history.map(|history| history.cracks_beyond)),
            history.map_or_else(String::new, |history| history.is_change_open.to_string()),
            number(history.and_then(|history| Some(history.last_off?.ratio))),
            number(history.and_then(|history| Some(history.last_off?.score))),
            text_cell((!names.is_empty()).then(|| names.join(" | ")).as_deref()),
            number(best.map(|of| of.stiffness_left)),
            number(best.map(|of| of.stiffness_left_lower)),
            number(best.map(|of| of.stiffness_left_upper)),
            text_cell((!not_known.is_empty()).then(|| not_known.join(" | ")).as_deref()),
        ])
    });
    head.to_owned() + &each.collect::<String>()
}
