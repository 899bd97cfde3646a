//! The motion before the runs of a study: the state of the structure after it, and the remaining capacity.

use super::words::{bounded, g, name, reached, state, unit_g};
use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use crate::simulated::{milli, seconds};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::simulation::SPEED_AT_REST_M_S;
use dolmen_work::study::{
    CapacityOf, LevelRow, RunMeasures, RunOutcome, StateBefore, StudyAnswer, StudyKind,
};

messages! {
    /// The motion before the runs.
    pub(crate) enum Preceded in "study.before" {
        After(motion: String) => {
            en: "AFTER {motion}: every run begins with it, and capacities are what is left of the structure, not those of the structure as it stands.",
            ko: "{motion} 이후: 모든 해석이 이 지반운동으로 시작하므로, 한계 지반운동은 현 상태가 아니라 그 뒤에 남은 구조물의 값이다.",
        },
        NoRates => {
            en: "No rates a year: how often the ground shakes after another earthquake is not the hazard of the site.",
            ko: "연간 초과율은 제시하지 않는다. 다른 지진 뒤에 지반이 흔들리는 빈도는 부지의 재해도가 아니다.",
        },
        FellIn { fell: usize, all: usize, motion: String } => {
            en: "{fell} of {all} cases fell in {motion}: their runs count as fallen at any size.",
            ko: "{all}개 경우 중 {fell}개가 {motion}에서 붕괴하였다. 그 해석은 모든 크기에서 붕괴한 것으로 센다.",
        },
        Head(motion: String) => { en: "After {motion}", ko: "{motion} 이후" },
        Caption(motion: String) => {
            en: "The state in which {motion} leaves the structure, and the peak acceleration of the ground at which half of the scans reach each state after it.",
            ko: "{motion}이(가) 남긴 상태와, 그 뒤 증분해석의 절반이 각 손상상태에 이르는 최대지반가속도.",
        },
        Meaning(bound: Quantity) => {
            en: "States, peaks and offsets count from the structure as it stood before both motions. Still: how long the ground stands still between them; speed: the largest of any part at its end, at most {bound} at rest. “already”: the motion before reached the state by itself.",
            ko: "손상상태, 최댓값, 잔류값은 두 지반운동 이전을 기준으로 한다. 정지: 두 지반운동 사이에 지반이 멈춘 시간, 속도: 그 끝에서 가장 빠른 부분의 속도(정지 기준 {bound} 이하). ‘도달’: 앞선 지반운동만으로 이미 이른 상태.",
        },
        Case => { en: "before the runs", ko: "앞선 지반운동" },
        AsItIs => { en: "as in the file", ko: "파일의 값" },
        Peak => { en: "peak before", ko: "앞선 최대 가속도" },
        Left => { en: "state", ko: "손상상태" },
        OffsetLeft => { en: "offset left", ko: "잔류 어긋남" },
        LeanLeft => { en: "lean left", ko: "잔류 기울기" },
        TopLeft => { en: "top left aside", ko: "최상부 잔류 변위" },
        Still => { en: "still", ko: "정지" },
        Speed => { en: "speed", ko: "속도" },
        Already => { en: "already", ko: "도달" },
        Unshaken => { en: "not shaken", ko: "작용 안 함" },
        Undamaged => { en: "undamaged", ko: "손상 없음" },
        Refused => { en: "no verdict", ko: "판정 불가" },
        InSamples(each: Vec<Sentence>) => { en: "{each}", ko: "{each}" },
        Times { state: Sentence, cases: usize } => { en: "{state} {cases} ×", ko: "{state} {cases}회" },
        More(more: usize) => { en: "And {more} more combinations.", ko: "그 밖의 조합 {more}개." },
    }
}

/// Combinations in the table. Our choice, as for fragility.
const SHOWN_MOST: usize = 8;

/// The main findings of a study after another motion; empty for other studies.
pub(super) fn findings(answer: &StudyAnswer) -> Vec<Finding> {
    let Some(after) = &answer.study.after else {
        return Vec::new();
    };
    let motion = after.motion.clone();
    let mut all = vec![Finding::key(Tone::Warn, Preceded::After(motion.clone()))];
    let fell = answer
        .before
        .iter()
        .filter(|of| of.outcome == RunOutcome::Fell)
        .count();
    if fell > 0 {
        let all_cases = answer.before.len();
        all.push(Finding::key(
            Tone::Bad,
            Preceded::FellIn {
                fell,
                all: all_cases,
                motion,
            },
        ));
    }
    all
}

/// The table of states and capacities.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let Some(after) = &answer.study.after else {
        return;
    };
    let motion = after.motion.clone();
    document.subheading(Preceded::Head(motion.clone()));
    for finding in findings(answer) {
        document.put(Block::Warning(finding.sentence));
    }
    let (table, more) = table(answer, motion);
    document.put(Block::Table(table));
    if more > 0 {
        document.note(Preceded::More(more));
    }
    document.note(Preceded::NoRates);
}

fn table(answer: &StudyAnswer, motion: String) -> (Table, usize) {
    let states: Vec<usize> = (0..4).filter(|state| answer.has_state(*state)).collect();
    let in_g = |head: Sentence| Column::numbers(head, unit_g(answer));
    let mut columns = vec![
        Column::words(Preceded::Case),
        in_g(Preceded::Peak.into()),
        Column::words(Preceded::Left),
        match answer.kind {
            StudyKind::Chain => Column::numbers(Preceded::LeanLeft, milli("rad")),
            StudyKind::Frame => Column::numbers(Preceded::TopLeft, milli("m")),
            StudyKind::Stack | StudyKind::Building => Column::numbers(Preceded::OffsetLeft, milli("m")),
        },
        Column::numbers(Preceded::Still, Unit::si("s")),
        Column::numbers(Preceded::Speed, milli("m/s")),
    ];
    columns.extend(states.iter().map(|of| in_g(state(answer, *of))));
    let samples = answer.study.samples.unwrap_or(1).max(1);
    let combinations: Vec<&[StateBefore]> = answer.before.chunks(samples).collect();
    let capacities = answer.capacities();
    let each = combinations.iter().enumerate().take(SHOWN_MOST);
    let rows = each.map(|(combination, own)| {
        let scans = capacities
            .iter()
            .filter(|scan| answer.combination_of(scan.job) == combination);
        let level = LevelRow {
            input: None,
            text: String::new(),
            value: None,
            scans: scans.cloned().collect(),
        };
        row(answer, own, &level, &states)
    });
    let bound = Quantity::new(SPEED_AT_REST_M_S, milli("m/s"), Digits::Significant(2));
    let table = Table {
        caption: vec![Preceded::Caption(motion).into(), Preceded::Meaning(bound).into()],
        rows: rows.collect(),
        columns,
    };
    (table, combinations.len().saturating_sub(SHOWN_MOST))
}

fn row(answer: &StudyAnswer, own: &[StateBefore], level: &LevelRow, states: &[usize]) -> Vec<Cell> {
    let job = level.scans.first().map(|scan| scan.job);
    let words = job.map(|job| answer.combination_words(job)).unwrap_or_default();
    let most = |of: fn(&StateBefore) -> f64| {
        let known = own.iter().map(of).filter(|value| !value.is_nan());
        known.reduce(f64::max)
    };
    let number = |value: Option<f64>, unit: Unit, digits| {
        Cell::Number(value.map(|value| Quantity::new(value, unit, digits)))
    };
    let unit = match answer.kind {
        StudyKind::Chain => milli("rad"),
        _ => milli("m"),
    };
    let mut cells = vec![
        match words.as_str() {
            "" => Cell::words(Preceded::AsItIs),
            words => Cell::words(name(words)),
        },
        Cell::Number(most(|of| of.peak_m_s2).map(|peak| g(answer, peak))),
        Cell::words(left(answer, own)),
        number(most(residual), unit, Digits::Significant(3)),
        Cell::Number(most(|of| of.still_s).map(seconds)),
        number(most(|of| of.speed_m_s), milli("m/s"), Digits::Significant(2)),
    ];
    let least_state = own.iter().map(|of| of.damage_state).min().unwrap_or(0);
    cells.extend(states.iter().map(|of| match usize::from(least_state) > *of {
        true => Cell::words(Preceded::Already),
        false => at_or_below(answer, level, *of),
    }));
    cells
}

/// Whether the motion before by itself brings at least half of the usable scans to a state.
pub(super) fn is_already(answer: &StudyAnswer, scans: &[CapacityOf], of: usize) -> bool {
    let usable = || scans.iter().filter(|scan| scan.verdict.is_usable());
    let reached = usable().filter(|scan| {
        let case = answer.case_of(scan.job);
        let before = answer.before.iter().find(|before| before.case == case);
        before.is_some_and(|before| usize::from(before.damage_state) > of)
    });
    let reached = reached.count();
    reached > 0 && 2 * reached >= usable().count()
}

/// The median of the scans, marked if it is at or below the smallest size tried.
fn at_or_below(answer: &StudyAnswer, level: &LevelRow, of: usize) -> Cell {
    let found = level.quantile_m_s2(of, 0.5);
    let least = answer.runs.iter().map(|run| run.peak_ground_acceleration_m_s2);
    let least = least.fold(f64::INFINITY, f64::min);
    match found {
        Some(at) if at.is_reached() && at.value() <= least => {
            Cell::words(bounded("≤", &g(answer, at.value())))
        }
        found => reached(answer, found),
    }
}

/// Residual displacement, m or rad.
fn residual(of: &StateBefore) -> f64 {
    match of.measures {
        RunMeasures::Stack(of) => of.residual_slip_m,
        RunMeasures::Frame(of) => of.residual_displacement_m,
        RunMeasures::Chain(of) => of.residual_rotation_rad,
        RunMeasures::Building(_) | RunMeasures::None => f64::NAN,
    }
}

/// The state after the first motion; with several samples, the number of samples in each state.
fn left(answer: &StudyAnswer, own: &[StateBefore]) -> Sentence {
    let words = |of: &StateBefore| -> Sentence {
        match (of.outcome, of.damage_state) {
            (RunOutcome::Refused | RunOutcome::Diverged | RunOutcome::StillMoving, _) => {
                Preceded::Refused.into()
            }
            _ if !of.why.english.is_empty() => Preceded::Refused.into(),
            (_, 0) if of.peak_m_s2 == 0.0 => Preceded::Unshaken.into(),
            (_, 0) => Preceded::Undamaged.into(),
            (_, reached) => state(answer, usize::from(reached) - 1),
        }
    };
    match own {
        [one] => words(one),
        several => {
            let mut each: Vec<(Sentence, usize)> = Vec::new();
            for of in several {
                let said = words(of);
                match each.iter_mut().find(|(known, _)| *known == said) {
                    Some((_, cases)) => *cases += 1,
                    None => each.push((said, 1)),
                }
            }
            let each = each.into_iter();
            let each = each.map(|(state, cases)| Preceded::Times { state, cases }.into());
            Preceded::InSamples(each.collect()).into()
        }
    }
}
