//! The natural modes of a building: shares of sway and torsion, and centres of rotation.

use super::words::{fixed, number, significant};
use crate::document::{Block, Cell, Column, Document, Figure, Table, table_series};
use crate::figures::building_plan;
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::building::StandingBuilding;
use std::f64::consts::TAU;

messages! {
    /// Natural modes.
    pub(crate) enum Modes in "building.modes" {
        Head => { en: "Natural modes", ko: "고유모드" },
        Plan => { en: "Where the top floor turns in each mode.", ko: "각 모드에서 최상층이 회전하는 중심." },
        PlanMeaning => {
            en: "A mode whose centre is far away sways; one whose centre lies on the floor twists. An arrow points to a centre beyond the picture. Walls are drawn as long as they are stiff.",
            ko: "중심이 멀면 횡변위가, 평면 안에 있으면 비틀림이 지배한다. 화살표는 그림 밖의 중심을 가리킨다. 벽체의 길이는 강성에 비례하여 그렸다.",
        },
        Caption { shown: usize, all: usize } => {
            en: "Modes without dampers, {shown} of {all}.",
            ko: "감쇠기가 없는 상태의 모드, 전체 {all}개 중 {shown}개.",
        },
        CaptionMeaning => {
            en: "The centre is where the top floor turns about, – if it moves without turning.",
            ko: "중심은 최상층이 회전하는 점이다(–: 회전이 없음).",
        },
        Shares => { en: "Shares of the effective mass and of the kinetic energy.", ko: "유효질량비와 운동에너지 비율." },
        SharesMeaning => {
            en: "θ is rotation about the vertical; its effective mass is a share of the moment of inertia.",
            ko: "θ는 연직축에 대한 회전이며, 그 유효질량비는 회전관성에 대한 비이다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        Repeated { number: usize } => { en: "{number}*", ko: "{number}*" },
        Frequency => { en: "f", ko: "진동수 f" },
        Period => { en: "T", ko: "주기 T" },
        Damping => { en: "damping", ko: "감쇠비" },
        Mass { axis: Sentence } => { en: "mass {axis}", ko: "유효질량 {axis}" },
        Energy { axis: Sentence } => { en: "energy {axis}", ko: "에너지 {axis}" },
        Centre => { en: "centre x", ko: "중심 x" },
        Together { x: Quantity, y: Quantity, turning: Quantity } => {
            en: "The modes of the table hold {x} of the mass along x, {y} along y and {turning} of the moment of inertia.",
            ko: "표에 보인 모드의 유효질량 합은 x 방향 {x}, y 방향 {y}, 회전관성은 {turning}이다.",
        },
        RepeatedMeaning => {
            en: "* Two modes of one frequency: their shapes are one choice of many.",
            ko: "* 진동수가 같은 두 모드이며, 그 형상은 가능한 여러 선택 중 하나이다.",
        },
    }
}

/// The centres of rotation, and a table of the modes.
pub(super) fn section<'a>(document: &mut Document<'a>, standing: &'a StandingBuilding) {
    document.heading(Modes::Head);
    let modes = &standing.modes;
    let shown = || modes.modes.iter().take(standing.shown());
    let caption = vec![Modes::Plan.into(), Modes::PlanMeaning.into()];
    let plan = Figure::drawn(caption, |language| building_plan(standing, language));
    document.charted(plan.with_series(|| table_series(&table(standing))));
    document.put(Block::Table(table(standing)));
    if shown().any(|mode| mode.repeated) {
        document.note(Modes::RepeatedMeaning);
    }
    document.put(Block::Table(shares(standing)));
    let sum = |axis: usize| {
        let share: f64 = shown()
            .map(|mode| mode.effective_mass[axis] / modes.total_mass[axis])
            .sum();
        fixed(share, Unit::percent(), 1)
    };
    document.paragraph(Modes::Together {
        x: sum(0),
        y: sum(1),
        turning: sum(2),
    });
}

fn table(standing: &StandingBuilding) -> Table {
    let all = &standing.modes;
    let row = |j: usize| {
        let mode = &all.modes[j];
        let centre = mode.centres.last().copied().flatten();
        let metres = |value: Option<f64>| Cell::Number(value.map(|x| fixed(x, Unit::si("m"), 3)));
        let given =
            |value: f64, symbol: &str, digits| Cell::number(significant(value, Unit::si(symbol), digits));
        vec![
            mode_cell(standing, j),
            given(mode.frequency_hz, "Hz", 5),
            given(mode.period_s(), "s", 5),
            given(TAU * mode.frequency_hz, "rad/s", 6),
            Cell::number(fixed(standing.damping_ratios[j], Unit::percent(), 3)),
            metres(centre.map(|c| c.x_m)),
            metres(centre.map(|c| c.y_m)),
        ]
    };
    let shown = standing.shown();
    let caption = Modes::Caption {
        shown,
        all: all.modes.len(),
    };
    Table {
        caption: vec![caption.into(), Modes::CaptionMeaning.into()],
        columns: vec![
            Column::words(Modes::Mode),
            Column::numbers(Modes::Frequency, Unit::si("Hz")),
            Column::numbers(Modes::Period, Unit::si("s")),
            Column::numbers(Sentence::of_symbol("ω"), Unit::si("rad/s")),
            Column::numbers(Modes::Damping, Unit::percent()),
            Column::numbers(Modes::Centre, Unit::si("m")),
            Column::numbers(Sentence::of_symbol("y"), Unit::si("m")),
        ],
        rows: (0..shown).map(row).collect(),
    }
}

fn shares(standing: &StandingBuilding) -> Table {
    let all = &standing.modes;
    let row = |j: usize| {
        let mode = &all.modes[j];
        let share = |value: f64| Cell::number(fixed(value, Unit::percent(), 2));
        let mass = |axis: usize| share(mode.effective_mass[axis] / all.total_mass[axis]);
        let mut cells = vec![mode_cell(standing, j)];
        cells.extend([0, 1, 2].map(mass));
        cells.extend(mode.energy_shares.map(share));
        cells
    };
    let axes = ["x", "y", "θ"].map(Sentence::of_symbol);
    let percent = |head: Modes| Column::numbers(head, Unit::percent());
    let mut columns = vec![Column::words(Modes::Mode)];
    columns.extend(axes.clone().map(|axis| percent(Modes::Mass { axis })));
    columns.extend(axes.map(|axis| percent(Modes::Energy { axis })));
    Table {
        caption: vec![Modes::Shares.into(), Modes::SharesMeaning.into()],
        columns,
        rows: (0..standing.shown()).map(row).collect(),
    }
}

/// Its number, marked if its shape is not unique.
fn mode_cell(standing: &StandingBuilding, j: usize) -> Cell {
    match standing.modes.modes[j].repeated {
        true => Cell::words(Modes::Repeated { number: j + 1 }),
        false => Cell::words(number(j + 1)),
    }
}
