//! Measured and computed modes of a stack, and why some are not used.

use crate::document::{Cell, Column, Table};
use dolmen::blocks::{PairedBy, PairedMode, StackMotion, UnusedMode, WhyUnused};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::FactorsAnswer;

messages! {
    /// Modes of a stack, measured and computed.
    pub(crate) enum Modes in "identification.joint-modes" {
        One => { en: "the 1 measured mode", ko: "계측 모드 1개" },
        Several(count: usize) => { en: "the {count} measured modes", ko: "계측 모드 {count}개" },
        AlongX(number: usize) => { en: "x {number}", ko: "x 방향 {number}차" },
        AlongY(number: usize) => { en: "y {number}", ko: "y 방향 {number}차" },
        Torsion(number: usize) => { en: "torsion {number}", ko: "비틀림 {number}차" },
        X => { en: "along x", ko: "x 방향" },
        Y => { en: "along y", ko: "y 방향" },
        Twist => { en: "of torsion", ko: "비틀림" },
        Caption => { en: "Measured modes and those of the stack.", ko: "계측 모드와 계산 모드." },
        Meaning => {
            en: "Mode: the sway along x or y, or torsion, that it is taken for, counted from the lowest. File, common, best: with the springs of the file, with the common factor, and with the factors that fit best.",
            ko: "모드는 짝지은 x, y 방향 병진 또는 비틀림 모드의 차수이다. 파일, 공통, 최적은 각각 파일의 강성, 공통 배율, 가장 잘 맞는 배율에서의 고유진동수이다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        By => { en: "paired", ko: "짝지은 근거" },
        ByOrder => { en: "by order", ko: "순서" },
        ByShape => { en: "by shape", ko: "모드형상" },
        Measured => { en: "measured", ko: "계측" },
        File => { en: "file", ko: "파일" },
        CommonHead => { en: "common", ko: "공통" },
        Best => { en: "best", ko: "최적" },
        Points => { en: "points", ko: "측점" },
        AssumedSd => {
            en: "A frequency without a standard deviation is taken as known to 0.5 %: give its standard deviation.",
            ko: "표준편차를 입력하지 않은 고유진동수는 표준편차를 0.5 %로 보았다.",
        },
        NoneMissed => {
            en: "Modes paired by order are taken as the lowest of their direction, with none missed below; if the survey missed one, every factor is wrong.",
            ko: "순서로 짝지은 모드는 그 방향의 가장 낮은 모드부터 빠짐없이 계측한 것으로 보았다. 빠진 모드가 있으면 모든 배율이 틀린다.",
        },
        FromRecord => {
            en: "Directions without stated modes take those that the records show.",
            ko: "모드가 적혀 있지 않은 방향은 기록에서 찾은 모드를 썼다.",
        },
        Unused { survey: String, frequency: Quantity, motion: Sentence, why: Sentence } => {
            en: "Survey {survey}: the mode at {frequency} {motion} is not used. {why}",
            ko: "{survey} 조사: {frequency} {motion} 모드는 쓰지 않았다. {why}",
        },
        TooMany(computed: usize) => {
            en: "The stack has only {computed} such modes.",
            ko: "적층 구조의 해당 모드는 {computed}개뿐이다.",
        },
        Between { counted: Quantity, nearest: Quantity } => {
            en: "Counted from the lowest it would be the one at {counted}, but it is nearer to the one at {nearest}. Measure its shape.",
            ko: "순서로는 {counted} 모드이나 진동수는 {nearest} 모드에 더 가깝다. 모드형상을 계측해야 한다.",
        },
        Alike { one: Quantity, other: Quantity } => {
            en: "Its shape is as like one computed mode as another (MAC {one} and {other}). Measure more points.",
            ko: "모드형상이 두 계산 모드와 비슷하게 닮았다(MAC {one}, {other}). 측점을 늘려야 한다.",
        },
        Unlike(assurance: Quantity) => {
            en: "Its shape is like no computed mode (largest MAC {assurance}). Check heights and signs of its points.",
            ko: "모드형상이 어느 계산 모드와도 닮지 않았다(최대 MAC {assurance}). 측점의 높이와 부호를 확인해야 한다.",
        },
        Taken(assurance: Quantity) => {
            en: "Its shape is like the computed mode that a lower one is taken for (MAC {assurance}).",
            ko: "모드형상이 더 낮은 계측 모드와 짝지은 계산 모드와 닮았다(MAC {assurance}).",
        },
        After => {
            en: "It is counted from a lower mode that is not used. Measure its shape.",
            ko: "쓰지 않은 더 낮은 모드 다음의 모드여서 순서를 정할 수 없다. 모드형상을 계측해야 한다.",
        },
    }
}

impl Modes {
    /// "the 2 measured modes".
    pub(super) fn counted(count: usize) -> Sentence {
        match count {
            1 => Modes::One,
            count => Modes::Several(count),
        }
        .into()
    }

    /// "x 1".
    pub(super) fn short(mode: &PairedMode) -> Sentence {
        let number = mode.number;
        match mode.motion {
            StackMotion::X => Modes::AlongX(number),
            StackMotion::Y => Modes::AlongY(number),
            StackMotion::Torsion => Modes::Torsion(number),
        }
        .into()
    }
}

/// A frequency with its deviation, if it has one.
pub(super) fn hertz(frequency_hz: f64, sd_hz: f64) -> Quantity {
    Quantity {
        sd_si: Some(sd_hz).filter(|sd| *sd > 0.0),
        ..Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(4))
    }
}

/// Every input mode, and the computed mode it is paired with.
pub(super) fn table(answer: &FactorsAnswer) -> Table {
    let computed = |hz: f64| Cell::number(hertz(hz, 0.0));
    let row = |mode: &PairedMode| {
        let by = match mode.paired_by {
            PairedBy::Order => Modes::ByOrder,
            PairedBy::Shape => Modes::ByShape,
        };
        let points = Quantity::new(mode.shape_points as f64, Unit::ratio(), Digits::Fixed(0));
        let assurance = |mac| Quantity::new(mac, Unit::ratio(), Digits::Fixed(2));
        vec![
            Cell::words(Modes::short(mode)),
            Cell::words(by),
            Cell::number(hertz(mode.measured_hz, mode.measured_sd_hz)),
            computed(mode.drawn_hz),
            computed(mode.common_hz),
            mode.best_hz.map_or(Cell::Number(None), computed),
            Cell::number(points),
            Cell::Number(mode.assurance.map(assurance)),
        ]
    };
    let hz = || Unit::si("Hz");
    Table {
        caption: vec![Modes::Caption.into(), Modes::Meaning.into()],
        columns: vec![
            Column::words(Modes::Mode),
            Column::words(Modes::By),
            Column::numbers(Modes::Measured, hz()),
            Column::numbers(Modes::File, hz()),
            Column::numbers(Modes::CommonHead, hz()),
            Column::numbers(Modes::Best, hz()),
            Column::numbers(Modes::Points, Unit::ratio()),
            Column::numbers(Sentence::of_symbol("MAC"), Unit::ratio()),
        ],
        rows: answer.found.modes.iter().map(row).collect(),
    }
}

/// The basis of the pairing.
pub(super) fn notes(answer: &FactorsAnswer) -> Vec<Modes> {
    let modes = &answer.found.modes;
    let mut all = Vec::new();
    if modes.iter().any(|mode| mode.paired_by == PairedBy::Order) {
        all.push(Modes::NoneMissed);
    }
    if answer.is_from_record {
        all.push(Modes::FromRecord);
    }
    if modes.iter().any(|mode| mode.is_sd_assumed) {
        all.push(Modes::AssumedSd);
    }
    all
}

/// Why a mode is not used.
pub(super) fn unused(survey: &str, one: &UnusedMode) -> Modes {
    let mac = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Fixed(2));
    let why = match one.why {
        WhyUnused::TooMany { computed } => Modes::TooMany(computed),
        WhyUnused::BetweenModes {
            counted_hz,
            nearest_hz,
        } => Modes::Between {
            counted: hertz(counted_hz, 0.0),
            nearest: hertz(nearest_hz, 0.0),
        },
        WhyUnused::ShapesAlike {
            assurance: [best, second],
        } => Modes::Alike {
            one: mac(best),
            other: mac(second),
        },
        WhyUnused::ShapeUnlike { assurance } => Modes::Unlike(mac(assurance)),
        WhyUnused::ShapeTaken { assurance } => Modes::Taken(mac(assurance)),
        WhyUnused::AfterUnused => Modes::After,
    };
    let motion = match one.motion {
        StackMotion::X => Modes::X,
        StackMotion::Y => Modes::Y,
        StackMotion::Torsion => Modes::Twist,
    };
    Modes::Unused {
        survey: survey.to_owned(),
        frequency: hertz(one.measured_hz, 0.0),
        motion: motion.into(),
        why: why.into(),
    }
}
