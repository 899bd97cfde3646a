//! Simulated motions of a building in the report.

use super::building::{dampers, floor_words};
use super::finding::{Finding, Tone};
use super::frame_simulation::variant_words;
use super::simulation::motion_table;
use super::stack_notes::capitalised;
use super::table::{Cell, figure, table};
use crate::figures::building_histories;
use crate::text::GROWN;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_project::strokes_of;
use dolmen_words::Language;
use dolmen_words::number::{percent, significant, significant_beside};
use dolmen_work::building::{Against, BuildingSimulation};
use maud::{Markup, html};

/// Motion below this part of the largest is round-off.
const NOTHING: f64 = 1e-9;

/// How each moved, as findings.
pub(super) fn findings(simulations: &[&BuildingSimulation], language: Language) -> Vec<Finding> {
    let each = simulations.iter().map(|simulation| {
        let motion = simulation.motion.motion.name();
        let of = match variant_words(&simulation.variant, &simulation.variant_title, language) {
            None => String::new(),
            Some(variant) => format!("{variant}, "),
        };
        let lead = language.pick(format!("Under {motion}, {of}"), format!("{of}{motion} 작용 시: "));
        let grown = simulation.against_without().iter().any(|of| of.ratio > GROWN);
        let tone = if grown { Tone::Warn } else { Tone::Plain };
        let mut own: Vec<Finding> = beyond_room(simulation, language)
            .into_iter()
            .map(|beyond| Finding::new(Tone::Bad, lead.clone() + &beyond))
            .collect();
        own.push(Finding::new(tone, lead + &moved(simulation, language)));
        own
    });
    each.flatten().collect()
}

/// Dampers that need more room than they have, a sentence each.
fn beyond_room(simulation: &BuildingSimulation, language: Language) -> Vec<String> {
    let each = simulation.beyond_room().into_iter().map(|beyond| {
        let (needed, room) = (
            significant(1e3 * beyond.stroke_m, 4),
            significant(1e3 * beyond.room_m, 4),
        );
        language.pick(
            format!("damper {} is beyond its room: it needs {needed} mm each way and has {room} mm. It would meet its stops, which this run does not have.", beyond.name),
            format!("제진장치 {}의 행정 {needed} mm가 여유 {room} mm를 넘는다. 이 해석은 스토퍼 충돌을 고려하지 않으므로 결과를 그대로 쓸 수 없다.", beyond.name),
        )
    });
    each.collect()
}

/// How it moved, in a sentence.
fn moved(simulation: &BuildingSimulation, language: Language) -> String {
    let drift = simulation.drift();
    let name = simulation
        .floors
        .get(drift.storey.saturating_sub(1))
        .map_or("", String::as_str);
    let ratio = percent(drift.ratio, 3);
    let (place, place_ko) = match drift.at_corner {
        true => ("at a corner", "모서리"),
        false => (
            "of a centre of mass (its outline is not known)",
            "질량 중심, 평면 외곽선 없음",
        ),
    };
    let mut text = language.pick(
        format!(
            "the largest drift {place} is {ratio} of the height of the storey below floor {}.",
            floor_words(name, language)
        ),
        format!(
            "최대 층간변위({place_ko})는 {} 바닥 아래에서 층고의 {ratio}이다.",
            floor_words(name, language)
        ),
    );
    let against = simulation.against_without();
    let pick = |of: &Against| language.pick(of.what[0].clone(), of.what[1].clone());
    let top: Vec<String> = against
        .iter()
        .filter(|of| of.what[0].starts_with("the top"))
        .map(|of| format!("{} {}", pick(of), percent(of.ratio, 3)))
        .collect();
    if !top.is_empty() {
        let list = top.join(", ");
        text += &language.pick(
            format!(" Of what it would move without dampers: {list}."),
            format!(" 제진장치가 없을 때에 대한 비: {list}."),
        );
    }
    let grown: Vec<String> = against
        .iter()
        .filter(|of| of.ratio > GROWN)
        .map(|of| format!("{} {}", pick(of), percent(of.ratio, 4)))
        .collect();
    if !grown.is_empty() {
        let list = grown.join(", ");
        text += &language.pick(
            format!(" More than without dampers: {list}."),
            format!(" 제진장치가 없을 때보다 큰 값: {list}."),
        );
    }
    text
}

/// One section a simulation.
pub(super) fn sections(simulations: &[&BuildingSimulation], language: Language) -> Markup {
    html! { @for simulation in simulations { (section(simulation, language)) } }
}

fn section(simulation: &BuildingSimulation, language: Language) -> Markup {
    let variant = variant_words(&simulation.variant, &simulation.variant_title, language);
    html! {
        h2 { (language.pick("Simulated earthquake", "지진응답 시뮬레이션")) @if let Some(variant) = variant { ": " (variant) } }
        @for beyond in beyond_room(simulation, language) { p { b { (capitalised(&beyond)) } } }
        p { b { (moved(simulation, language)) } }
        (motion_table(&simulation.motion, language))
        (dampers(&simulation.dampers, language))
        (strokes_table(simulation, language))
        (floors_table(simulation, language))
        @for found in building_histories(simulation, language) {
            (figure(&found.svg, &caption(&found.name, simulation, language)))
        }
        (points_table(simulation, language))
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
            let (kind, number) = other.rsplit_once('-').unwrap_or((other, ""));
            let number = number.parse::<usize>().ok();
            let point = number.and_then(|n| simulation.points.get(n.checked_sub(1)?));
            let name = point.map_or(other, |point| point.name.as_str());
            if kind == "acceleration" {
                return language.pick(
                    format!("Acceleration of point {name}. With that of the ground: what stands there feels it."),
                    format!("{name} 지점의 가속도. 지반 가속도를 포함한 절대가속도."),
                );
            }
            return language.pick(
                format!("Displacement of point {name}. Relative to the ground."),
                format!("{name} 지점의 변위. 지반에 대한 값."),
            );
        }
    };
    text.to_owned()
}

/// Strokes of the dampers with the room that each has, and the forces of their dashpots.
fn strokes_table(simulation: &BuildingSimulation, language: Language) -> Markup {
    if simulation.dampers.is_empty() {
        return html! {};
    }
    let head = [
        language.pick("Damper", "제진장치"),
        language.pick("stroke (mm)", "행정 (mm)"),
        language.pick("room (mm)", "여유 (mm)"),
        language.pick("force of the dashpot (kN)", "감쇠력 (kN)"),
    ]
    .map(String::from);
    let peaks = &simulation.history.peaks;
    let forces = simulation.dashpot_forces_n();
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for (k, (of, stroke)) in strokes_of(&simulation.dampers)
        .into_iter()
        .zip(&peaks.strokes_m)
        .enumerate()
    {
        let room_m = of.room_m;
        let stroke_m = stroke.value.abs();
        let text = significant(1e3 * stroke_m, 4);
        let none = || "–".to_owned();
        rows.push(vec![
            of.name.into(),
            match room_m {
                Some(room_m) if stroke_m > room_m => Cell::bad(text),
                _ => text.into(),
            },
            room_m
                .map_or_else(none, |room_m| significant(1e3 * room_m, 4))
                .into(),
            forces
                .get(k)
                .copied()
                .flatten()
                .map_or_else(none, |force| significant(1e-3 * force.value.abs(), 4))
                .into(),
        ]);
    }
    let caption = language.pick(
        "What the dampers do. Largest travel each way from the place at rest, the room that each has, and the largest force of its dashpot.",
        "제진장치의 거동. 정지 위치에서의 한쪽 최대 행정, 주어진 여유 공간과 감쇠기의 최대 감쇠력.",
    );
    let across: Vec<&str> = simulation
        .across_the_motion()
        .iter()
        .map(|damper| damper.name.as_str())
        .collect();
    let names = across.join(", ");
    html! {
        (table(caption, 1, &head, &rows))
        @if !across.is_empty() {
            p { (language.pick(
                format!("The ground shakes across the direction of {names}: this run does not show what it does."),
                format!("지진동이 {names}의 작동 방향과 직각이므로 이 해석은 그 효과를 보여 주지 않는다."),
            )) }
        }
    }
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
        language
            .pick("corner drift (mm)", "모서리 층간변위 (mm)")
            .to_owned(),
        language.pick("of the height", "층고에 대한 비").to_owned(),
    ];
    let peaks = &simulation.history.peaks;
    let storeys = simulation.building.building().storeys();
    let moved = peaks
        .floors
        .iter()
        .flat_map(|floor| [floor.displacement_x_m.value, floor.displacement_y_m.value]);
    let most = moved.map(f64::abs).fold(0.0, f64::max);
    let rows: Vec<Vec<Cell>> = (0..storeys.len())
        .rev()
        .map(|i| {
            let (floor, storey) = (&peaks.floors[i], &peaks.storeys[i]);
            let milli = |value: f64| match value.abs() > NOTHING * most {
                true => significant(1e3 * value.abs(), 3),
                false => "0".to_owned(),
            };
            let edges = storey.edge_drift_x_m.zip(storey.edge_drift_y_m);
            let mut row: Vec<Cell> = vec![
                simulation.floors[i].clone().into(),
                milli(floor.displacement_x_m.value).into(),
                milli(floor.displacement_y_m.value).into(),
                milli(floor.rotation_rad.value).into(),
            ];
            row.extend(match edges {
                Some((x, y)) => {
                    let corner = storey.resultant.size_m;
                    [
                        milli(x.value),
                        milli(y.value),
                        milli(corner),
                        percent(corner / storeys[i].height_m, 3),
                    ]
                    .map(Cell::from)
                }
                None => ["–", "–", "–", "–"].map(|none| none.to_owned().into()),
            });
            row
        })
        .collect();
    let caption = language.pick(
        "Largest motion of each floor. Displacement of its centre of mass relative to the ground; drift of the storey below it at its edges along x and along y, and at its corners in any direction.",
        "각 층의 최대 거동. 질량 중심의 지반에 대한 변위와, 그 아래 층의 단부(x, y 방향)와 모서리(방향 무관) 층간변위.",
    );
    table(caption, 1, &head, &rows)
}

fn points_table(simulation: &BuildingSimulation, language: Language) -> Markup {
    if simulation.points.is_empty() {
        return html! {};
    }
    let head = [
        language.pick("Point", "지점").to_owned(),
        language.pick("floor", "층").to_owned(),
        language.pick("x (mm)", "변위 x (mm)").to_owned(),
        "y (mm)".to_owned(),
        language.pick("acceleration x (g)", "절대가속도 x (g)").to_owned(),
        "y (g)".to_owned(),
    ];
    let rows: Vec<Vec<Cell>> = simulation
        .points
        .iter()
        .map(|point| {
            let moved = point
                .along
                .each_ref()
                .map(|along| along.displacement_peak_m.value.abs());
            let felt = point
                .along
                .each_ref()
                .map(|along| along.acceleration_peak_m_s2.value.abs());
            let beside = |of: [f64; 2], along: usize, factor: f64| {
                significant_beside(factor * of[along], factor * of[0].max(of[1]), 3)
            };
            vec![
                point.name.clone().into(),
                point.floor.to_string().into(),
                beside(moved, 0, 1e3).into(),
                beside(moved, 1, 1e3).into(),
                beside(felt, 0, 1.0 / STANDARD_GRAVITY_M_S2).into(),
                beside(felt, 1, 1.0 / STANDARD_GRAVITY_M_S2).into(),
            ]
        })
        .collect();
    let caption = language.pick(
        "Points of the file. Largest displacement relative to the ground, and acceleration with that of the ground: what stands there feels it.",
        "입력한 지점. 지반에 대한 최대 변위와 지반 가속도를 포함한 절대가속도.",
    );
    table(caption, 1, &head, &rows)
}

fn run(simulation: &BuildingSimulation, language: Language) -> String {
    let history = &simulation.history;
    let (steps, step) = (history.length() - 1, history.time_step_s);
    language.pick(
        format!("Linear, exact between the samples of the motion; {steps} steps of {step} s, peaks between the steps."),
        format!("선형 해석이며 지진파 표본 사이에서 엄밀해이다. {step}초 간격 {steps}단계, 최대값은 단계 사이까지 찾은 값이다."),
    )
}
