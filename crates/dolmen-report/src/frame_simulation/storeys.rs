//! The storeys of a simulated frame and their response.

use super::friction::{friction, kilonewtons_a_millimetre};
use crate::document::{Cell, Column, Table};
use crate::simulated::{left, milli, millimetres, seconds};
use dolmen::dynamics::{FrameResultant, StoreyFriction};
use dolmen::structure::Storey;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::frame::FrameSimulation;

messages! {
    /// Tables of storeys.
    pub(crate) enum Storeys in "frame.simulation.storeys" {
        Model => { en: "What the storeys are.", ko: "층별 모델." },
        ModelMeaning => {
            en: "The spring acts all the time and the friction beside it; with the law of Jenkins the friction acts through a spring of the stiffness named.",
            ko: "스프링은 항상 작용하고 마찰은 이와 병렬로 작용한다. 젠킨스 모델의 고착 강성은 마찰과 직렬인 스프링의 강성이다.",
        },
        Caption => { en: "What each storey did.", ko: "층별 응답." },
        CaptionMeaning => {
            en: "Peaks between the samples too; the displacement is that of its top against the ground; drift left is where it comes to rest if nothing slips any more.",
            ko: "표본 사이까지 포함한 최댓값이며, 변위는 층 상단의 지반에 대한 값이고, 잔류 층간변위는 더 미끄러지지 않을 때의 값이다.",
        },
        Storey => { en: "Storey", ko: "층" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Friction => { en: "friction", ko: "마찰" },
        Spring => { en: "spring", ko: "스프링" },
        Drift => { en: "drift", ko: "층간변위" },
        OfHeight => { en: "of height", ko: "층고 대비" },
        At => { en: "at", ko: "발생 시각" },
        Level => { en: "displacement", ko: "변위" },
        Slipped => { en: "slipped", ko: "누적 미끄러짐" },
        OfTheTime => { en: "of the time", ko: "미끄러진 시간" },
        Together => { en: "Both directions together.", ko: "두 방향의 합성." },
        TogetherMeaning => {
            en: "The largest resultant drift of each storey, and its parts at that moment.",
            ko: "층별 최대 합성 층간변위와 그때의 방향별 값.",
        },
        Along(direction: String) => { en: "along {direction}", ko: "{direction} 방향" },
        Resultant => { en: "resultant", ko: "합성" },
        DriftLeft => { en: "drift left", ko: "잔류 층간변위" },
    }
}

fn name(name: &str) -> Cell {
    Cell::words(Storeys::Name(name.to_owned()))
}

/// Friction and springs.
pub(super) fn model(simulation: &FrameSimulation) -> Table {
    let unit = kilonewtons_a_millimetre();
    let frame = &simulation.frame;
    let mut sliders = frame.friction().iter();
    let slides = sliders
        .any(|slider| *slider != StoreyFriction::None)
        .then_some(Storeys::ModelMeaning);
    let each = simulation.storeys.iter().zip(frame.friction());
    let row = |((storey, slider), spring): ((&String, &StoreyFriction), &f64)| {
        let spring = Quantity::new(*spring, unit.clone(), Digits::Trimmed(6));
        vec![name(storey), Cell::words(friction(slider)), Cell::number(spring)]
    };
    Table {
        caption: std::iter::once(Storeys::Model)
            .chain(slides)
            .map(Sentence::from)
            .collect(),
        columns: vec![
            Column::words(Storeys::Storey),
            Column::words(Storeys::Friction),
            Column::numbers(Storeys::Spring, unit.clone()),
        ],
        rows: each.zip(frame.stiffness_n_m()).map(row).collect(),
    }
}

/// The largest resultant drifts, one row per storey; empty for one component.
pub(super) fn together(simulation: &FrameSimulation) -> Option<Table> {
    let together = simulation.together_once()?;
    let heights = simulation.frame.frame().storeys().iter();
    let each = simulation.storeys.iter().zip(&together.storeys).zip(heights);
    let row = |((storey, of), height): ((&String, &FrameResultant), &Storey)| {
        vec![
            name(storey),
            Cell::number(millimetres(of.parts_m[0])),
            Cell::number(millimetres(of.parts_m[1])),
            Cell::number(millimetres(of.drift_m)),
            Cell::number(Quantity::percent(of.drift_m / height.height_m, 3)),
            Cell::number(seconds(of.at_s)),
        ]
    };
    let along = |place: usize| {
        let direction = together.directions[place].clone();
        Column::numbers(Storeys::Along(direction), milli("m"))
    };
    Some(Table {
        caption: vec![Storeys::Together.into(), Storeys::TogetherMeaning.into()],
        columns: vec![
            Column::words(Storeys::Storey),
            along(0),
            along(1),
            Column::numbers(Storeys::Resultant, milli("m")),
            Column::numbers(Storeys::OfHeight, Unit::percent()),
            Column::numbers(Storeys::At, Unit::si("s")),
        ],
        rows: each.map(row).collect(),
    })
}

/// Peaks and residuals, one row per storey.
pub(super) fn response(simulation: &FrameSimulation) -> Table {
    let history = &simulation.history;
    let heights = simulation.frame.frame().storeys();
    let row = |(i, storey): (usize, &String)| {
        let peak = history.drift_peaks[i];
        let below_m = i.checked_sub(1).map_or(0.0, |below| history.rest_m[below]);
        let share = peak.value_m.abs() / heights[i].height_m;
        let slipping = history.slipping_share(i);
        let rest_m = history.rest_m[i] - below_m;
        vec![
            name(storey),
            Cell::number(millimetres(peak.value_m)),
            Cell::number(Quantity::percent(share, 3)),
            Cell::number(seconds(peak.at_s)),
            Cell::number(millimetres(history.displacement_peaks[i].value_m)),
            Cell::number(millimetres(history.slipped_way_m(i))),
            Cell::number(Quantity::new(slipping, Unit::percent(), Digits::Fixed(1))),
            Cell::number(left(rest_m, peak.value_m, milli("m"))),
        ]
    };
    Table {
        caption: vec![Storeys::Caption.into(), Storeys::CaptionMeaning.into()],
        columns: vec![
            Column::words(Storeys::Storey),
            Column::numbers(Storeys::Drift, milli("m")),
            Column::numbers(Storeys::OfHeight, Unit::percent()),
            Column::numbers(Storeys::At, Unit::si("s")),
            Column::numbers(Storeys::Level, milli("m")),
            Column::numbers(Storeys::Slipped, milli("m")),
            Column::numbers(Storeys::OfTheTime, Unit::percent()),
            Column::numbers(Storeys::DriftLeft, milli("m")),
        ],
        rows: simulation.storeys.iter().enumerate().map(row).collect(),
    }
}
