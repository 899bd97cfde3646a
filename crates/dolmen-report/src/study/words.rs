//! Words and numbers that all sections of a study use.

use crate::document::Cell;
use dolmen::assess::Reached;
use dolmen_words::message::Run;
use dolmen_words::{Digits, Language, Quantity, Sentence, Unit, messages};
use dolmen_work::study::StudyAnswer;

/// Confidence of intervals.
pub(super) const CONFIDENCE: f64 = 0.95;

messages! {
    /// Counts and names.
    pub(crate) enum Words in "study.words" {
        OneScan => { en: "1 scan", ko: "증분해석 1건" },
        Scans { count: usize } => { en: "{count} scans", ko: "증분해석 {count}건" },
        OneCase => { en: "1 case", ko: "경우 1개" },
        Cases { count: usize } => { en: "{count} cases", ko: "경우 {count}개" },
        OneMotion => { en: "1 motion", ko: "입력지진 1개" },
        Motions { count: usize } => { en: "{count} motions", ko: "입력지진 {count}개" },
        OneDirection => { en: "1 direction", ko: "방향 1개" },
        Directions { count: usize } => { en: "{count} directions", ko: "방향 {count}개" },
        OneRun => { en: "1 simulation", ko: "1회" },
        Runs { count: usize } => { en: "{count} simulations", ko: "{count}회" },
        Of { some: usize, all: usize } => { en: "{some} of {all}", ko: "{some}/{all}" },
        Count { count: usize } => { en: "{count}", ko: "{count}" },
        Input => { en: "input", ko: "입력변수" },
        Case => { en: "case", ko: "경우" },
        OfCase { what: Sentence, case: Sentence } => { en: "{what} ({case})", ko: "{what}({case})" },
        On { upper: String, lower: String } => { en: "{upper} on {lower}", ko: "{upper} / {lower}" },
        OnGround(upper: String) => { en: "{upper} on ground", ko: "{upper} / 지반" },
        State => { en: "state", ko: "손상상태" },
        Interval { lower: Quantity, upper: Quantity } => { en: "{lower} – {upper}", ko: "{lower} – {upper}" },
        OpenInterval { lower: Quantity, upper: Quantity } => { en: "{lower} – > {upper}", ko: "{lower} – > {upper}" },
    }
}

/// Text from the file or the answer in both languages.
pub(super) fn both(of: impl Fn(Language) -> String) -> Sentence {
    let runs = |language| vec![Run::Text(of(language))];
    Sentence::of_runs("study.given", runs(Language::English), runs(Language::Korean))
}

/// A name of the file, as it is printed in each language.
pub(super) fn name(name: &str) -> Sentence {
    Sentence::of_argument(name)
}

/// The joint "upper on lower", "상부 / 하부".
pub(super) fn joint(name: &str) -> Sentence {
    let said = match name.rsplit_once(" on ") {
        None => return self::name(name),
        Some((upper, "ground")) => Words::OnGround(upper.to_owned()),
        Some((upper, lower)) => Words::On {
            upper: upper.to_owned(),
            lower: lower.to_owned(),
        },
    };
    said.into()
}

pub(super) fn scans(count: usize) -> Sentence {
    match count {
        1 => Words::OneScan.into(),
        count => Words::Scans { count }.into(),
    }
}

/// "3 of 5" in a column of numbers.
pub(super) fn of_all(some: usize, all: usize) -> Cell {
    Cell::words(Words::Of { some, all })
}

pub(super) fn count(count: usize) -> Cell {
    Cell::words(Words::Count { count })
}

/// Ditto mark in a column of words.
pub(super) fn same() -> Cell {
    Cell::words(Sentence::of_symbol(""))
}

/// A share as a number with this many digits after the point.
pub(super) fn fixed(value: f64, decimals: usize) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Fixed(decimals))
}

/// The project's gravity as a unit.
pub(super) fn unit_g(answer: &StudyAnswer) -> Unit {
    Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / answer.gravity_m_s2,
    }
}

/// An acceleration in g.
pub(super) fn g(answer: &StudyAnswer, value_m_s2: f64) -> Quantity {
    Quantity::new(value_m_s2, unit_g(answer), Digits::Fixed(3))
}

/// A peak at which something is reached; "> " if it is only known to be higher.
pub(super) fn reached(answer: &StudyAnswer, value_m_s2: Option<Reached>) -> Cell {
    match value_m_s2 {
        Some(Reached::At(value)) => Cell::number(g(answer, value)),
        Some(Reached::Above(value)) => Cell::words(bounded(">", &g(answer, value))),
        None => Cell::Number(None),
    }
}

/// "> 0.300" without its unit, which the column gives.
pub(super) fn bounded(sign: &str, value: &Quantity) -> Sentence {
    Sentence::of_symbol(&format!("{sign} {}", value.number()))
}

/// Name of a state.
pub(super) fn state(answer: &StudyAnswer, state: usize) -> Sentence {
    both(|language| answer.state_words(state, language))
}

/// The inputs of a scan, in the shortest form that distinguishes it.
pub(super) fn scan(answer: &StudyAnswer, job: usize) -> Sentence {
    let case = answer.case(job);
    let mut words: Vec<String> = case.variant.iter().cloned().collect();
    words.extend(answer.inputs_shown(job));
    if answer.motions.len() > 1 || words.is_empty() {
        words.push(answer.motion_of(job).to_owned());
    }
    if answer.study.turns_rad.len() > 1 {
        words.push(format!("{:.4}°", answer.turn_rad(job).to_degrees()));
    }
    name(&words.join(", "))
}

/// Some of many, evenly chosen, including both ends.
pub(super) fn some<T>(all: &[T]) -> Vec<&T> {
    const MOST: usize = 7;
    let last = all.len().saturating_sub(1);
    if last < MOST {
        return all.iter().collect();
    }
    (0..MOST).filter_map(|i| all.get(i * last / (MOST - 1))).collect()
}

/// A state or a joint with the inputs of its combination, if there are several.
pub(super) fn of_case(answer: &StudyAnswer, what: Sentence, job: usize) -> Sentence {
    labelled(what, &answer.combination_words(job))
}

/// The same with a case in words.
pub(super) fn labelled(what: Sentence, case: &str) -> Sentence {
    match case {
        "" => what,
        case => Words::OfCase {
            what,
            case: name(case),
        }
        .into(),
    }
}
