//! Capacities by value of each input.

use super::before::{Preceded, is_already};
use super::words::{Words, both, bounded, g, name, of_all, of_case, reached, state, unit_g};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::{AssessError, FragilityBound, FragilityFit, Reached};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::study::{LevelRow, SCANS_OF_TAILS, StudyAnswer, StudyKind, input_words};

/// Width of an interval, relative to its upper end, from which both ends are given: the step that a refined scan has. Our choice.
const WIDE: f64 = 0.1;

messages! {
    /// Capacities.
    pub(crate) enum Capacities in "study.capacities" {
        Milder { each: Vec<Sentence> } => {
            en: "Damage begins earlier. Peak of the ground at which half of the scans reach it: {each}.",
            ko: "손상은 그 전에 시작된다. 증분해석의 절반이 도달하는 최대지반가속도: {each}.",
        },
        MilderWeakest { each: Vec<Sentence> } => {
            en: "Damage begins earlier. Peak of the ground at which half of the scans of the weakest combination reach it: {each}.",
            ko: "손상은 그 전에 시작된다. 가장 약한 조합에서 증분해석의 절반이 도달하는 최대지반가속도: {each}.",
        },
        HalfFrom { state: Sentence, median: Quantity } => { en: "{state} at {median} or below", ko: "{state} {median} 이하" },
        HalfBefore { state: Sentence, motion: String } => {
            en: "{state} already in {motion} alone",
            ko: "{state} {motion}만으로 이미 도달",
        },
        HalfAt { state: Sentence, median: Quantity } => { en: "{state} at {median}", ko: "{state} {median}" },
        HalfBetween { state: Sentence, low: Quantity, median: Quantity } => {
            en: "{state} between {low} and {median}",
            ko: "{state} {low}~{median}",
        },
        WithCurve { half: Sentence, theta: Quantity } => {
            en: "{half} ({theta} by the fitted curve)",
            ko: "{half}(취약도 곡선의 중앙값 {theta})",
        },
        Stack => {
            en: "Peak acceleration of the ground at which a stone first falls.",
            ko: "부재가 처음 낙하하는 최대지반가속도.",
        },
        Chain => {
            en: "Peak acceleration of the ground at which the chain first falls.",
            ko: "처음 전도되는 최대지반가속도.",
        },
        Frame => {
            en: "Peak acceleration of the ground at which a storey first leans by more than 10 %.",
            ko: "층간변위가 처음 층고의 10 %를 넘는 최대지반가속도.",
        },
        FrameOnColumns => {
            en: "Peak acceleration of the ground at which it first falls: columns alone have no resistance left, or a storey leans by more than 10 %.",
            ko: "처음 전도되는 최대지반가속도. 기둥만으로 지지되는 층의 저항이 없어지거나 층간변위가 층고의 10 %를 넘는 경우이다.",
        },
        Building => {
            en: "Peak acceleration of the ground at which a storey first drifts beyond the last limit.",
            ko: "층간변위가 처음 최종 한계를 넘는 최대지반가속도.",
        },
        Meaning { scans: usize } => {
            en: "“>”: not up to the largest that was tried. 5 % and 95 % are said of {scans} scans and more.",
            ko: "‘>’는 시도한 최대 크기까지 일어나지 않은 경우이다. 5 %와 95 %는 증분해석 {scans}건 이상에서만 제시한다.",
        },
        StackStates => {
            en: "DS1 to DS3: medians, to a step of the scan; “≤”: reached at the least size that was tried.",
            ko: "DS1–DS3은 중앙값이며 증분해석의 간격까지 구하였다. ‘≤’는 시도한 최소 크기에서 이미 도달한 경우이다.",
        },
        OneState => {
            en: "The milder state is a median; “≤”: reached at the least size that was tried.",
            ko: "낮은 손상상태의 값은 증분해석의 중앙값이며, ‘≤’는 시도한 최소 크기에서 이미 도달한 경우이다.",
        },
        BuildingStates => {
            en: "A linear building drifts in proportion: limits are medians, exact up to the largest size that was tried; beyond yielding they say little.",
            ko: "선형 건물의 층간변위는 지반운동에 비례한다. 한계는 중앙값이며 시도한 최대 크기까지 정확하나, 항복 이후의 거동은 나타내지 못한다.",
        },
        NoSlip => {
            en: "Slips: no storey slipped before the frame leaned too far, so there is no such state.",
            ko: "골조가 한계를 넘기 전에 미끄러진 층이 없으므로 미끄러짐 상태는 없다.",
        },
        Scans => { en: "scans", ko: "증분해석" },
        Fell => { en: "fell", ko: "한계 도달" },
        Least => { en: "least", ko: "최소" },
        Low => { en: "5 %", ko: "5 %" },
        Median => { en: "median", ko: "중앙값" },
        High => { en: "95 %", ko: "95 %" },
        SurvivedAbove => { en: "survived above", ko: "더 큰 지반운동에서도 견딤" },
        Unusable => { en: "unusable", ko: "사용 불가" },
        Variant { value: Sentence } => { en: "variant {value}", ko: "대안 {value}" },
        At { input: Sentence, value: Sentence } => { en: "{input} = {value}", ko: "{input} = {value}" },
        All => { en: "all", ko: "전체" },
        FellAtLeast { at_once: usize, all: Sentence } => {
            en: "{at_once} of {all} fell at the least size that was asked for; what lies below was only halved, and falls there may have been passed over: scan smaller sizes.",
            ko: "{all} 중 {at_once}건이 요청한 최소 크기에서 한계에 이르렀다. 그 아래는 반씩 줄여 가며 확인하였을 뿐이므로 더 작은 크기에서 한계에 이른 경우를 지나쳤을 수 있다. 더 작은 크기부터 해석해야 한다.",
        },
        SurvivedLarger { above: usize, all: Sentence } => {
            en: "{above} of {all} survived a size of shaking above the first fall: one critical acceleration says little.",
            ko: "{all} 중 {above}건은 처음 한계에 이른 크기보다 더 큰 지반운동을 견뎠으므로, 임계가속도 하나로는 판단할 수 없다.",
        },
    }
}

/// The table and its basis.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    document.put(Block::Table(table(answer)));
    document.note(match answer.kind {
        StudyKind::Stack => Capacities::StackStates,
        StudyKind::Building => Capacities::BuildingStates,
        StudyKind::Frame if !answer.has_state(0) => Capacities::NoSlip,
        StudyKind::Frame | StudyKind::Chain => Capacities::OneState,
    });
}

/// Number of states milder than the last with columns.
fn milder(kind: StudyKind) -> usize {
    match kind {
        StudyKind::Stack | StudyKind::Building => 3,
        StudyKind::Frame | StudyKind::Chain => 1,
    }
}

fn table(answer: &StudyAnswer) -> Table {
    let in_g = |head: Sentence| Column::numbers(head, unit_g(answer));
    let plain = |head: Capacities| Column::numbers(head, Unit::ratio());
    let mut columns = vec![
        Column::words(Words::Input),
        plain(Capacities::Scans),
        plain(Capacities::Fell),
        in_g(Capacities::Least.into()),
        in_g(Capacities::Low.into()),
        in_g(Capacities::Median.into()),
        in_g(Capacities::High.into()),
    ];
    columns.extend((0..milder(answer.kind)).map(|of| in_g(state(answer, of))));
    columns.push(plain(Capacities::SurvivedAbove));
    let what = match answer.kind {
        StudyKind::Stack => Capacities::Stack,
        StudyKind::Chain => Capacities::Chain,
        StudyKind::Frame if answer.on_columns => Capacities::FrameOnColumns,
        StudyKind::Frame => Capacities::Frame,
        StudyKind::Building => Capacities::Building,
    };
    let scans = SCANS_OF_TAILS;
    let levels = answer.levels();
    Table {
        caption: vec![what.into(), Capacities::Meaning { scans }.into()],
        rows: levels
            .iter()
            .map(|level| row(answer, level, columns.len()))
            .collect(),
        columns,
    }
}

fn row(answer: &StudyAnswer, level: &LevelRow, columns: usize) -> Vec<Cell> {
    let (usable, all) = (level.usable(), level.scans.len());
    let mut row = vec![Cell::words(level_words(answer, level)), of_all(usable, all)];
    if usable == 0 {
        row.push(Cell::Number(None));
        row.push(Cell::BadWords(Capacities::Unusable.into()));
        row.resize(columns, Cell::Number(None));
        return row;
    }
    row.push(of_all(level.fell(), usable));
    row.push(match level.least_m_s2() {
        Some(Reached::At(least)) if answer.kind != StudyKind::Building && level.least_is_bound() => {
            Cell::words(bounded("≤", &g(answer, least)))
        }
        least => reached(answer, least),
    });
    row.extend([0.05, 0.5, 0.95].map(|p| reached(answer, level.quantile_m_s2(3, p))));
    row.extend((0..milder(answer.kind)).map(|of| match answer.has_state(of) {
        true if is_already(answer, &level.scans, of) => Cell::words(Preceded::Already),
        true => milder_median(answer, level.quantile_m_s2(of, 0.5)),
        false => Cell::Number(None),
    }));
    row.push(of_all(level.survived_above(), usable));
    row
}

/// The input with its value: as written, a bare number with its unit.
fn level_words(answer: &StudyAnswer, level: &LevelRow) -> Sentence {
    let value = name(&answer.level_shown(level));
    match (level.input, level.text.as_str()) {
        (Some(input), _) => {
            let input = both(|language| input_words(&answer.inputs[input].path, language));
            Capacities::At { input, value }.into()
        }
        (None, "all") => Capacities::All.into(),
        (None, _) if answer.study.variants.len() > 1 => Capacities::Variant { value }.into(),
        (None, _) => value,
    }
}

/// As [`reached`], marked if it is at or below the smallest peak tried.
fn milder_median(answer: &StudyAnswer, value_m_s2: Option<Reached>) -> Cell {
    match value_m_s2 {
        Some(Reached::At(value)) if is_least_tried(answer, value) => {
            Cell::words(bounded("≤", &g(answer, value)))
        }
        other => reached(answer, other),
    }
}

/// Whether the peaks at both ends of an interval differ so much that both are given.
pub(super) fn is_interval(low_m_s2: f64, high_m_s2: f64) -> bool {
    low_m_s2 < (1.0 - WIDE) * high_m_s2
}

/// Whether a peak is the smallest one tried, so that the true value may be lower.
fn is_least_tried(answer: &StudyAnswer, value_m_s2: f64) -> bool {
    const ROUNDING: f64 = 1e-9;
    let tried = answer.runs.iter().map(|run| run.peak_ground_acceleration_m_s2);
    let least = tried.fold(f64::INFINITY, f64::min);
    answer.kind != StudyKind::Building && value_m_s2 <= least * (1.0 + ROUNDING)
}

/// The same for several combinations: the one that reaches each state first.
fn milder_of_weakest(answer: &StudyAnswer) -> Option<Capacities> {
    let of_state = |of: usize| {
        let combinations = answer.fragilities().iter();
        let each = combinations.filter_map(|one| {
            let own = one.states.iter().find(|own| own.state == of)?;
            Some((half_m_s2(&own.by_acceleration)?, one.job))
        });
        let ([low, least], job) = each.min_by(|a, b| a.0[1].total_cmp(&b.0[1]))?;
        let state = of_case(answer, state(answer, of), job);
        Some(half(answer, state, [low, least]).into())
    };
    let states = (0..milder(answer.kind)).filter(|of| answer.has_state(*of));
    let each: Vec<Sentence> = states.filter_map(of_state).collect();
    (!each.is_empty()).then_some(Capacities::MilderWeakest { each })
}

/// The peaks between which half of the scans reach a state.
fn half(answer: &StudyAnswer, state: Sentence, [low_m_s2, median_m_s2]: [f64; 2]) -> Capacities {
    let median = g(answer, median_m_s2);
    if is_least_tried(answer, median_m_s2) {
        return Capacities::HalfFrom { state, median };
    }
    match is_interval(low_m_s2, median_m_s2) {
        true => Capacities::HalfBetween {
            state,
            low: g(answer, low_m_s2),
            median,
        },
        false => Capacities::HalfAt { state, median },
    }
}

/// The peaks between which half of the scans reach a state, m/s²: the median of the curve, or what is known of it.
fn half_m_s2(fit: &Result<FragilityFit, AssessError>) -> Option<[f64; 2]> {
    let bound = match fit {
        Ok(fit) => return Some([fit.curve.theta(); 2]),
        Err(AssessError::NoFragility(bound)) => bound,
        Err(_) => return None,
    };
    let ends = match bound {
        FragilityBound::NoneReached { .. } => return None,
        FragilityBound::AllReached { intensity, .. } => [0.0, *intensity],
        FragilityBound::Separated { survived, reached } => [*survived, *reached],
        FragilityBound::Middle { above, at_most } => [*above, *at_most],
    };
    ends[1].is_finite().then_some(ends)
}

/// Peaks at which half of the scans reach each state before the last, mildest first; `None` if none does.
pub(super) fn milder_states(answer: &StudyAnswer) -> Option<Capacities> {
    if answer.fragilities().len() > 1 {
        return milder_of_weakest(answer);
    }
    let levels = answer.levels();
    let all = levels
        .iter()
        .find(|level| level.input.is_none() && level.text == "all")?;
    let theta = |of: usize| {
        let [one] = answer.fragilities() else {
            return None;
        };
        let own = one.states.iter().find(|own| own.state == of)?;
        let fit = own
            .by_acceleration
            .as_ref()
            .ok()
            .filter(|_| own.fell_alone == 0)?;
        Some(g(answer, fit.curve.theta()))
    };
    let states = (0..milder(answer.kind)).filter(|of| answer.has_state(*of));
    let each = states.filter_map(|of| {
        if let Some(after) = answer
            .study
            .after
            .as_ref()
            .filter(|_| is_already(answer, &all.scans, of))
        {
            let (state, motion) = (state(answer, of), after.motion.clone());
            return Some(Capacities::HalfBefore { state, motion }.into());
        }
        let Reached::At(value) = all.quantile_m_s2(of, 0.5)? else {
            return None;
        };
        let low = all.median_not_yet_m_s2(of).unwrap_or(0.0);
        let half: Sentence = half(answer, state(answer, of), [low, value]).into();
        Some(match theta(of).filter(|_| !is_least_tried(answer, value)) {
            Some(theta) => Capacities::WithCurve { half, theta }.into(),
            None => half,
        })
    });
    let each: Vec<Sentence> = each.collect();
    (!each.is_empty()).then_some(Capacities::Milder { each })
}
