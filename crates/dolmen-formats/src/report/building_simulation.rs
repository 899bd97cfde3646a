//! Simulated motions of a building in the report.

use super::building::{dampers, floor_words};
use super::findings::{Finding, Tone};
use super::frame_simulation::variant_words;
use super::simulation::motion_table;
use super::table::{Cell, figure, table};
use crate::Language;
use crate::figures::building_histories;
use crate::number::{percent, significant};
use crate::simulation::BuildingSimulation;
use dolmen::dynamics::BuildingHistory;
use maud::{Markup, html};

/// How each moved, as findings.
pub(super) fn findings(simulations: &[BuildingSimulation], language: Language) -> Vec<Finding> {
    let each = simulations.iter().map(|simulation| {
        let motion = simulation.motion.motion.name();
        let of = match variant_words(&simulation.variant, &simulation.variant_title, language) {
            None => String::new(),
            Some(variant) => format!("{variant}, "),
        };
        let lead = language.pick(format!("Under {motion}, {of}"), format!("{of}{motion} 작용 시: "));
        Finding::new(Tone::Plain, lead + &moved(simulation, language))
    });
    each.collect()
}

/// How it moved, in a sentence.
fn moved(simulation: &BuildingSimulation, language: Language) -> String {
    let (storey, ratio) = simulation.drift_ratio();
    let name = simulation
        .floors
        .get(storey.saturating_sub(1))
        .map_or("", String::as_str);
    let ratio = percent(ratio, 3);
    let mut text = language.pick(
        format!(
            "the largest drift at an edge is {ratio} of the height of the storey below floor {}.",
            floor_words(name, language)
        ),
        format!(
            "최대 층간변위(단부)는 {} 바닥 아래에서 층고의 {ratio}이다.",
            floor_words(name, language)
        ),
    );
    if let Some(without) = &simulation.without_dampers {
        let top = |history: &BuildingHistory| {
            let peak = history.peaks.floors.last().copied().unwrap_or_default();
            peak.displacement_x_m.value.hypot(peak.displacement_y_m.value)
        };
        let share = percent(top(&simulation.history) / top(without), 3);
        text += &language.pick(
            format!(" The top moves {share} of what it would without dampers."),
            format!(" 최상층 변위는 제진장치가 없을 때의 {share}이다."),
        );
    }
    text
}

/// One section a simulation.
pub(super) fn sections(simulations: &[BuildingSimulation], language: Language) -> Markup {
    html! { @for simulation in simulations { (section(simulation, language)) } }
}

fn section(simulation: &BuildingSimulation, language: Language) -> Markup {
    let variant = variant_words(&simulation.variant, &simulation.variant_title, language);
    html! {
        h2 { (language.pick("Simulated earthquake", "지진응답 시뮬레이션")) @if let Some(variant) = variant { ": " (variant) } }
        p { b { (moved(simulation, language)) } }
        (motion_table(&simulation.motion, language))
        (dampers(&simulation.dampers, language))
        (floors_table(simulation, language))
        @for found in building_histories(simulation, language) {
            (figure(&found.svg, &caption(&found.name, simulation, language)))
        }
        p { (run(simulation, language)) }
    }
}

fn caption(name: &str, simulation: &BuildingSimulation, language: Language) -> String {
    let text = match name {
        "ground" => language.pick("Acceleration of the ground. As it acted.", "지반 가속도. 해석에 적용한 값."),
        "top-x" => language.pick(
            "Displacement of the top floor along x. Its centre of mass, relative to the ground.",
            "최상층 x 방향 변위. 질량 중심의 지반에 대한 변위.",
        ),
        "top-y" => language.pick(
            "Displacement of the top floor along y. Its centre of mass, relative to the ground.",
            "최상층 y 방향 변위. 질량 중심의 지반에 대한 변위.",
        ),
        "rotation" => language.pick(
            "Rotation of the top floor. Times the distance from the centre of mass it adds to the displacement.",
            "최상층의 회전. 질량 중심에서의 거리를 곱한 값이 변위에 더해진다.",
        ),
        "base-shear" => language.pick(
            "Base shear. What the walls of the lowest storey carry.",
            "밑면전단력. 최하층 벽체가 부담하는 힘.",
        ),
        "strokes" => language.pick(
            "Travel of the dampers. Relative to the floor: the room that they need.",
            "제진장치의 행정. 바닥에 대한 상대변위로서 필요한 여유 공간이다.",
        ),
        other => {
            let number = other.strip_prefix("point-").and_then(|n| n.parse::<usize>().ok());
            let point = number.and_then(|n| simulation.points.get(n.checked_sub(1)?));
            let name = point.map_or(other, |point| point.name.as_str());
            return language.pick(
                format!("Displacement of point {name}. Relative to the ground."),
                format!("{name} 지점의 변위. 지반에 대한 값."),
            );
        }
    };
    text.to_owned()
}

fn floors_table(simulation: &BuildingSimulation, language: Language) -> Markup {
    let head = [
        language.pick("Floor", "층").to_owned(),
        language.pick("x (mm)", "변위 x (mm)").to_owned(),
        "y (mm)".to_owned(),
        language.pick("rotation (mrad)", "회전 (mrad)").to_owned(),
        language
            .pick("edge drift x (mm)", "단부 층간변위 x (mm)")
            .to_owned(),
        "y (mm)".to_owned(),
        language.pick("of the height", "층고에 대한 비").to_owned(),
    ];
    let peaks = &simulation.history.peaks;
    let storeys = simulation.building.building().storeys();
    let rows: Vec<Vec<Cell>> = (0..storeys.len())
        .rev()
        .map(|i| {
            let (floor, storey) = (&peaks.floors[i], &peaks.storeys[i]);
            let milli = |value: f64| significant(1e3 * value.abs(), 3);
            let (x, y) = (
                storey.edge_drift_x_m.value.abs(),
                storey.edge_drift_y_m.value.abs(),
            );
            vec![
                simulation.floors[i].clone().into(),
                milli(floor.displacement_x_m.value).into(),
                milli(floor.displacement_y_m.value).into(),
                milli(floor.rotation_rad.value).into(),
                milli(x).into(),
                milli(y).into(),
                percent(x.max(y) / storeys[i].height_m, 3).into(),
            ]
        })
        .collect();
    let caption = language.pick(
        "Largest motion of each floor. Displacement of its centre of mass relative to the ground; drift of the storey below it at its edges.",
        "각 층의 최대 거동. 질량 중심의 지반에 대한 변위와, 그 아래 층의 단부 층간변위.",
    );
    table(caption, 1, &head, &rows)
}

fn run(simulation: &BuildingSimulation, language: Language) -> String {
    let history = &simulation.history;
    let (steps, step) = (history.length() - 1, history.time_step_s);
    language.pick(
        format!("Linear, exact between the samples of the motion; {steps} steps of {step} s, peaks at the steps."),
        format!("선형 해석이며 지진파 표본 사이에서 엄밀해이다. {step}초 간격 {steps}단계, 최대값은 각 단계에서의 값이다."),
    )
}
