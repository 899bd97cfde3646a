//! The motion that acted.

use crate::document::{Block, Cell, Column, Document, Table};
use crate::processing::step;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Processing;
use dolmen::signal::{Component, GroundMotion};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::motion::{MotionAnswer, MotionDoubt};

messages! {
    /// The motion of the ground.
    pub(crate) enum Motion in "simulated.motion" {
        Caption(name: String) => { en: "Motion {name}.", ko: "지반운동 {name}." },
        Sampled { samples: usize, step: Quantity, rate: Quantity, length: Quantity } => {
            en: "{samples} samples every {step} ({rate}), {length}.",
            ko: "표본 {samples}개, 표본 간격 {step}({rate}), 지속시간 {length}.",
        },
        Then { first: Sentence, next: Sentence } => { en: "{first}; {next}", ko: "{first}, {next}" },
        Done(steps: Sentence) => { en: "Done to it: {steps}.", ko: "처리: {steps}." },
        Component => { en: "Component", ko: "성분" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Together => { en: "x and y together", ko: "x·y 합성" },
        File => { en: "file", ko: "파일" },
        PeakRead => { en: "peak as read", ko: "원기록 최대" },
        Peak => { en: "peak as it acts", ko: "적용 최대" },
        ReadStrong { component: String, peak: Quantity, by_gravity: Quantity, by_gal: Quantity } => {
            en: "PROBABLY A SLIP: {component} is read with a peak of {peak}, which hardly any record has. In m/s² the file would have {by_gravity}, in gal {by_gal}: give its unit with --unit.",
            ko: "입력 오류 의심: {component} 성분을 최대 {peak}(으)로 읽었으며 이런 기록은 거의 없다. 파일이 m/s² 단위라면 {by_gravity}, gal 단위라면 {by_gal}이다. --unit으로 단위를 준다.",
        },
        ReadWeak { component: String, peak: Quantity, by_metres: Quantity, by_gal: Quantity } => {
            en: "PROBABLY A SLIP: {component} is read with a peak of {peak}, which nobody would feel. If the numbers read as gal are m/s², it is {by_metres}, if they are g, {by_gal}: give their unit with --unit.",
            ko: "입력 오류 의심: {component} 성분을 최대 {peak}(으)로 읽었으며 이는 느낄 수 없는 크기이다. gal로 읽은 값이 m/s²라면 {by_metres}, g라면 {by_gal}이다. --unit으로 단위를 준다.",
        },
        ActsStrong(peak: Quantity) => {
            en: "PROBABLY A SLIP: a motion of {peak} acts, more than in nearly all records ever made. Is the factor or the unit of the peak right (1 g is 9.81 m/s² or 981 gal)?",
            ko: "입력 오류 의심: 최대 {peak}의 지반운동이 작용하며 이는 거의 모든 계측 기록보다 크다. 배율 또는 최대값의 단위(1 g = 9.81 m/s² = 981 gal)가 맞는가?",
        },
        ActsWeak(peak: Quantity) => {
            en: "PROBABLY A SLIP: a motion of only {peak} acts, which nobody would feel. Is the factor or the unit of the peak right (1 g is 9.81 m/s² or 981 gal)?",
            ko: "입력 오류 의심: 최대 {peak}의 지반운동만 작용하며 이는 느낄 수 없는 크기이다. 배율 또는 최대값의 단위(1 g = 9.81 m/s² = 981 gal)가 맞는가?",
        },
        Step { component: String, step: Quantity, swings: Quantity } => {
            en: "PROBABLY A SLIP: with a step of {step} {component} swings at {swings} on average, and earthquakes swing at 0.5 to 25 Hz. Is the step in s, and not a rate in Hz or in ms?",
            ko: "입력 오류 의심: 표본 간격 {step}에서 {component} 성분은 평균 {swings}(으)로 진동하며 지반운동은 0.5~25 Hz이다. 표본 간격이 초 단위가 맞는가(표본화 진동수 Hz 또는 ms가 아닌가)?",
        },
        Offset { component: String, away: Quantity } => {
            en: "PROBABLY A SLIP: with {component} the ground ends {away} away, farther than in any earthquake. Its acceleration has an offset: take it off with --baseline or --high-pass.",
            ko: "입력 오류 의심: {component} 성분에서 지반이 {away} 떨어진 곳에서 멈추며 어떤 지진에서도 이만큼 이동하지 않는다. 가속도 기록에 영점 오차가 있으므로 --baseline 또는 --high-pass로 제거한다.",
        },
        TakenOff { peak: Quantity, arias: Quantity } => {
            en: "Cuts, base line, filters and tapers took off {peak} of the largest acceleration and {arias} of the Arias intensity: the answer is about the motion that is left.",
            ko: "구간 자르기, 기선 보정, 필터, 테이퍼로 최대가속도의 {peak}, 아리아스 강도의 {arias}이(가) 줄었다. 결과는 남은 지반운동에 대한 것이다.",
        },
        TurnRadians { degrees: Quantity, meant: Quantity } => {
            en: "PROBABLY A SLIP: it is turned by {degrees}°, a round part of π. If that is in radians, write {meant}.",
            ko: "입력 오류 의심: {degrees}° 회전하였으며 이는 π의 배수이다. 라디안이라면 {meant}°로 적는다.",
        },
        Drifts { component: String, away: Quantity } => {
            en: "{component} ends {away} away, near its largest displacement: the base line drifts, or the ground moved for good; take it off with --baseline or --high-pass.",
            ko: "{component} 성분의 변위가 {away}에서 끝나며 이는 최대 변위에 가깝다. 기선이 표류하였거나 지반이 영구 이동한 기록이다. 기선 표류라면 --baseline 또는 --high-pass로 제거한다.",
        },
    }
}

/// The motion and notes on its baseline.
pub(crate) fn motion_section(document: &mut Document<'_>, answer: &MotionAnswer) {
    document.put(Block::Table(motion_table(answer)));
    let doubts = answer.doubts();
    for (component, away_m) in answer.drifting_m() {
        let is_doubted = |doubt: &MotionDoubt| matches!(doubt, MotionDoubt::Offset { component: of, .. } if *of == component);
        if !doubts.iter().any(is_doubted) {
            document.note(drift(component.name(), away_m));
        }
    }
    for doubt in doubts {
        document.note(doubted(&doubt));
    }
}

/// A probable mistake in a motion, and the likely fix.
pub(crate) fn doubted(doubt: &MotionDoubt) -> Motion {
    doubted_of(doubt, None)
}

/// The same for a series with its own name.
pub(crate) fn doubted_of(doubt: &MotionDoubt, series: Option<&str>) -> Motion {
    let in_g = |peak_g: f64| {
        let unit = Unit {
            symbol: "g".to_owned(),
            factor: 1.0,
        };
        Quantity::new(peak_g, unit, Digits::Significant(3))
    };
    let name = |component: Component| series.unwrap_or(component.name()).to_owned();
    match *doubt {
        MotionDoubt::ReadStrong { component, peak_g } => Motion::ReadStrong {
            component: name(component),
            peak: in_g(peak_g),
            by_gravity: in_g(peak_g / STANDARD_GRAVITY_M_S2),
            by_gal: in_g(peak_g / (100.0 * STANDARD_GRAVITY_M_S2)),
        },
        MotionDoubt::ReadWeak { component, peak_g } => Motion::ReadWeak {
            component: name(component),
            peak: in_g(peak_g),
            by_metres: in_g(peak_g * 100.0),
            by_gal: in_g(peak_g * 100.0 * STANDARD_GRAVITY_M_S2),
        },
        MotionDoubt::ActsStrong { peak_g } => Motion::ActsStrong(in_g(peak_g)),
        MotionDoubt::ActsWeak { peak_g } => Motion::ActsWeak(in_g(peak_g)),
        MotionDoubt::Step {
            component,
            step_s,
            swings_hz,
        } => Motion::Step {
            component: name(component),
            step: Quantity::new(step_s, Unit::si("s"), Digits::Significant(3)),
            swings: Quantity::new(swings_hz, Unit::si("Hz"), Digits::Significant(3)),
        },
        MotionDoubt::Offset { component, away_m } => Motion::Offset {
            component: name(component),
            away: Quantity::new(away_m, Unit::si("m"), Digits::Significant(3)),
        },
        MotionDoubt::TakenOff(off) => {
            let percent = |share: f64| Quantity::new(share, Unit::percent(), Digits::Fixed(0));
            Motion::TakenOff {
                peak: percent(off.peak.max(0.0)),
                arias: percent(off.arias_intensity.max(0.0)),
            }
        }
        MotionDoubt::TurnRadians { degrees } => Motion::TurnRadians {
            degrees: Quantity::ratio(degrees, 4),
            meant: Quantity::ratio(degrees.to_degrees(), 3),
        },
    }
}

/// Note on a component with a drifting baseline.
pub(crate) fn drift(component: &str, away_m: f64) -> Motion {
    Motion::Drifts {
        component: component.to_owned(),
        away: Quantity::new(away_m, Unit::si("m"), Digits::Fixed(3)),
    }
}

/// The components, their files and peaks, and their processing.
pub(crate) fn motion_table(answer: &MotionAnswer) -> Table {
    let motion = &answer.motion;
    let in_g = Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / STANDARD_GRAVITY_M_S2,
    };
    let per_s2 = Unit::si("m/s²");
    let peak = |peak_m_s2: f64, unit: &Unit| {
        Cell::number(Quantity::new(peak_m_s2, unit.clone(), Digits::Significant(4)))
    };
    let row = |component: Component| {
        let file = answer.files.iter().find(|(of, _)| *of == component);
        let read = answer.peaks_read_m_s2.iter().find(|(of, _)| *of == component);
        let acting_m_s2 = motion.component_peak_m_s2(component);
        vec![
            named(component.name()),
            file.map_or(Cell::Number(None), |(_, file)| named(file)),
            read.map_or(Cell::Number(None), |(_, read_m_s2)| peak(*read_m_s2, &in_g)),
            peak(acting_m_s2, &in_g),
            peak(acting_m_s2, &per_s2),
        ]
    };
    let given = Component::ALL
        .into_iter()
        .filter(|component| motion.has(*component));
    let mut rows: Vec<Vec<Cell>> = given.map(row).collect();
    rows.extend(together_m_s2(motion).map(|both_m_s2| {
        vec![
            Cell::words(Motion::Together),
            Cell::Number(None),
            Cell::Number(None),
            peak(both_m_s2, &in_g),
            peak(both_m_s2, &per_s2),
        ]
    }));
    Table {
        caption: caption(motion),
        columns: vec![
            Column::words(Motion::Component),
            Column::words(Motion::File),
            Column::numbers(Motion::PeakRead, in_g.clone()),
            Column::numbers(Motion::Peak, in_g.clone()),
            Column::numbers(Motion::Peak, per_s2.clone()),
        ],
        rows,
    }
}

fn caption(motion: &GroundMotion) -> Vec<Sentence> {
    let short = |value: f64, unit| Quantity::new(value, Unit::si(unit), Digits::Trimmed(6));
    let mut caption = vec![
        Motion::Caption(motion.name().to_owned()).into(),
        Motion::Sampled {
            samples: motion.length(),
            step: short(motion.time_step_s(), "s"),
            rate: short(1.0 / motion.time_step_s(), "Hz"),
            length: Quantity::new(motion.duration_s(), Unit::si("s"), Digits::Fixed(2)),
        }
        .into(),
    ];
    if let Some(steps) = steps_of(motion.history()) {
        caption.push(Motion::Done(steps).into());
    }
    caption
}

/// The largest vertical acceleration; `None` for a motion without z.
pub(crate) fn vertical_peak(motion: &GroundMotion) -> Option<Quantity> {
    let in_g = Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / STANDARD_GRAVITY_M_S2,
    };
    let peak_m_s2 = motion.component_peak_m_s2(Component::Z);
    let has_vertical = motion.has(Component::Z);
    has_vertical.then(|| Quantity::new(peak_m_s2, in_g, Digits::Significant(3)))
}

/// The largest horizontal acceleration if both components are given.
fn together_m_s2(motion: &GroundMotion) -> Option<f64> {
    let both = [Component::X, Component::Y];
    if !both.iter().all(|component| motion.has(*component)) {
        return None;
    }
    let [x, y] = both.map(|component| motion.acceleration_m_s2(component));
    let sizes = x.iter().zip(y).map(|(x, y)| x.hypot(*y));
    Some(sizes.fold(0.0, f64::max))
}

fn named(name: &str) -> Cell {
    Cell::words(Motion::Name(name.to_owned()))
}

/// The processing, step by step; `None` if there was none. Identical steps of the components appear once.
pub(crate) fn steps_of(history: &[Processing]) -> Option<Sentence> {
    let mut steps: Vec<Sentence> = history.iter().map(step).collect();
    steps.dedup();
    steps
        .into_iter()
        .reduce(|first, next| Motion::Then { first, next }.into())
}
