//! The motion that acted.

use crate::document::{Block, Cell, Column, Document, Table};
use crate::processing::step;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Processing;
use dolmen::signal::{Component, GroundMotion};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::motion::MotionAnswer;

messages! {
    /// The motion of the ground.
    pub(crate) enum Motion in "simulated.motion" {
        Caption { name: String } => { en: "Motion {name}.", ko: "지진동 {name}." },
        Sampled { samples: usize, step: Quantity, rate: Quantity, length: Quantity } => {
            en: "{samples} samples every {step} ({rate}), {length}.",
            ko: "표본 {samples}개, 표본 간격 {step}({rate}), 지속시간 {length}.",
        },
        Then { first: Sentence, next: Sentence } => { en: "{first}; {next}", ko: "{first}, {next}" },
        Done { steps: Sentence } => { en: "Done to it: {steps}.", ko: "처리: {steps}." },
        Component => { en: "Component", ko: "성분" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Together => { en: "x and y together", ko: "x·y 합성" },
        File => { en: "file", ko: "파일" },
        PeakRead => { en: "peak as read", ko: "원기록 최대" },
        Peak => { en: "peak as it acts", ko: "적용 최대" },
        Drifts { component: String, away: Quantity } => {
            en: "{component} ends {away} away, near its largest displacement: the base line drifts, or the ground moved for good; take it off with --baseline or --high-pass.",
            ko: "{component} 성분의 변위가 {away}에서 끝나며 이는 최대 변위에 가깝다. 기선이 표류하였거나 지반이 영구 이동한 기록이다. 기선 표류라면 --baseline 또는 --high-pass로 제거한다.",
        },
    }
}

/// The motion, and what to know of its base line.
pub(crate) fn motion_section(document: &mut Document<'_>, answer: &MotionAnswer) {
    document.put(Block::Table(motion_table(answer)));
    for (component, away_m) in answer.drifting_m() {
        document.note(drift(component.name(), away_m));
    }
}

/// What to know of a component whose base line drifts.
pub(crate) fn drift(component: &str, away_m: f64) -> Motion {
    Motion::Drifts {
        component: component.to_owned(),
        away: Quantity::new(away_m, Unit::si("m"), Digits::Fixed(3)),
    }
}

/// The components, their files and peaks, and what was done to them.
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
        Motion::Caption {
            name: motion.name().to_owned(),
        }
        .into(),
        Motion::Sampled {
            samples: motion.length(),
            step: short(motion.time_step_s(), "s"),
            rate: short(1.0 / motion.time_step_s(), "Hz"),
            length: Quantity::new(motion.duration_s(), Unit::si("s"), Digits::Fixed(2)),
        }
        .into(),
    ];
    if let Some(steps) = steps_of(motion.history()) {
        caption.push(Motion::Done { steps }.into());
    }
    caption
}

/// The largest horizontal acceleration where both components are given.
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
    Cell::words(Motion::Name {
        name: name.to_owned(),
    })
}

/// What was done to it, step after step; `None` if nothing was.
pub(crate) fn steps_of(history: &[Processing]) -> Option<Sentence> {
    let steps = history.iter().map(step);
    steps.reduce(|first, next| Motion::Then { first, next }.into())
}
