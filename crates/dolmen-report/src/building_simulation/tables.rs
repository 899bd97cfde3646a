//! Response of the dampers, floors and points of a building.

use crate::building::{beside, kilonewtons, millimetres, name, number, stroke_words};
use crate::document::{Cell, Column, Table};
use crate::simulated::milli;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_project::strokes_of;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::{BuildingSimulation, WatchedPoint};

messages! {
    /// Tables of simulated buildings.
    pub(crate) enum Tables in "building-simulation.tables" {
        Dampers => { en: "What the dampers do.", ko: "감쇠기의 거동." },
        DampersMeaning => {
            en: "Largest travel each way from the place at rest, the room that each has, and the largest force of its dashpot; t is when each is reached.",
            ko: "정지 위치에서의 한쪽 최대 행정, 주어진 여유 공간과 감쇠기의 최대 감쇠력. t는 각 최댓값의 시각이다.",
        },
        Damper => { en: "Damper", ko: "감쇠기" },
        Stroke => { en: "stroke", ko: "행정" },
        Room => { en: "room", ko: "여유 공간" },
        Force => { en: "force of the dashpot", ko: "감쇠력" },
        Time => { en: "t", ko: "t" },
        Floors => { en: "Largest motion of each floor.", ko: "각 층의 최대 거동." },
        FloorsMeaning => {
            en: "Displacement of its centre of mass relative to the ground; drift of the storey below it there, at its edges along x and along y, and at its corners in any direction.",
            ko: "질량중심의 지반에 대한 변위와, 그 아래 층의 질량중심, 단부(x, y 방향), 모서리(방향 무관) 층간변위.",
        },
        NoOutline => { en: "–: the floor has no outline.", ko: "–: 바닥 외곽선이 없음." },
        Floor => { en: "Floor", ko: "층" },
        X => { en: "x", ko: "변위 x" },
        Y => { en: "y", ko: "변위 y" },
        Rotation => { en: "rotation", ko: "회전" },
        DriftX => { en: "drift x", ko: "층간변위 x" },
        DriftY => { en: "drift y", ko: "층간변위 y" },
        EdgeDriftX => { en: "edge drift x", ko: "단부 층간변위 x" },
        EdgeDriftY => { en: "edge drift y", ko: "단부 층간변위 y" },
        CornerDrift => { en: "corner drift", ko: "모서리 층간변위" },
        OfHeight => { en: "of the height", ko: "층고에 대한 비" },
        Points => { en: "Points of the file.", ko: "입력한 지점." },
        PointsMeaning => {
            en: "Largest displacement relative to the ground, and acceleration with that of the ground: what stands there feels it.",
            ko: "지반에 대한 최대 변위와 지반 가속도를 포함한 절대가속도.",
        },
        Point => { en: "Point", ko: "지점" },
        OnFloor => { en: "floor", ko: "층" },
        PlaceX => { en: "place x", ko: "위치 x" },
        PlaceY => { en: "place y", ko: "위치 y" },
        AccelerationX => { en: "acceleration x", ko: "절대가속도 x" },
        AccelerationY => { en: "acceleration y", ko: "절대가속도 y" },
    }
}

/// Strokes, their room, and the forces of dashpots; `None` without dampers.
pub(super) fn strokes(simulation: &BuildingSimulation) -> Option<Table> {
    let forces = simulation.dashpot_forces_n();
    let strokes = strokes_of(&simulation.dampers);
    let each = strokes
        .iter()
        .zip(&simulation.history.peaks.strokes_m)
        .enumerate();
    let rows: Vec<Vec<Cell>> = each
        .map(|(k, (of, stroke))| {
            let stroke_m = stroke.value.abs();
            let force = forces.get(k).copied().flatten();
            vec![
                Cell::words(stroke_words(&of.name)),
                match of.room_m {
                    Some(room_m) if stroke_m > room_m => Cell::Bad(four(stroke_m, millimetres())),
                    Some(_) | None => Cell::number(four(stroke_m, millimetres())),
                },
                time(stroke.at_s),
                Cell::Number(of.room_m.map(|room_m| four(room_m, millimetres()))),
                Cell::Number(force.map(|force| four(force.value.abs(), kilonewtons()))),
                force.map_or(Cell::Number(None), |force| time(force.at_s)),
            ]
        })
        .collect();
    let seconds = || Column::numbers(Tables::Time, Unit::si("s"));
    (!rows.is_empty()).then(|| Table {
        caption: vec![Tables::Dampers.into(), Tables::DampersMeaning.into()],
        columns: vec![
            Column::words(Tables::Damper),
            Column::numbers(Tables::Stroke, millimetres()),
            seconds(),
            Column::numbers(Tables::Room, millimetres()),
            Column::numbers(Tables::Force, kilonewtons()),
            seconds(),
        ],
        rows,
    })
}

fn time(at_s: f64) -> Cell {
    Cell::number(Quantity::new(at_s, Unit::si("s"), Digits::Fixed(3)))
}

fn four(value_si: f64, unit: Unit) -> Quantity {
    Quantity::new(value_si, unit, Digits::Significant(4))
}

/// Displacements of the floors and drifts of the storeys below them, the highest first.
pub(super) fn floors(simulation: &BuildingSimulation) -> Table {
    let mut caption: Vec<Sentence> = vec![Tables::Floors.into(), Tables::FloorsMeaning.into()];
    let storeys = &simulation.history.peaks.storeys;
    if storeys.iter().any(|storey| storey.edge_drift_x_m.is_none()) {
        caption.push(Tables::NoOutline.into());
    }
    let millimetres = |head: Tables| Column::numbers(head, millimetres());
    let count = simulation.building.building().storeys().len();
    Table {
        caption,
        columns: vec![
            Column::words(Tables::Floor),
            millimetres(Tables::X),
            millimetres(Tables::Y),
            Column::numbers(Tables::Rotation, milli("rad")),
            millimetres(Tables::DriftX),
            millimetres(Tables::DriftY),
            millimetres(Tables::EdgeDriftX),
            millimetres(Tables::EdgeDriftY),
            millimetres(Tables::CornerDrift),
            Column::numbers(Tables::OfHeight, Unit::percent()),
        ],
        rows: (0..count).rev().map(|i| floor_row(simulation, i)).collect(),
    }
}

fn floor_row(simulation: &BuildingSimulation, i: usize) -> Vec<Cell> {
    let peaks = &simulation.history.peaks;
    let moved = peaks
        .floors
        .iter()
        .flat_map(|floor| [floor.displacement_x_m.value, floor.displacement_y_m.value]);
    let most_m = moved.map(f64::abs).fold(0.0, f64::max);
    let cell = |value: f64, unit: &str| Cell::number(beside(value.abs(), most_m, milli(unit)));
    let (floor, storey) = (&peaks.floors[i], &peaks.storeys[i]);
    let mut row = vec![
        Cell::words(name(&simulation.floors[i])),
        cell(floor.displacement_x_m.value, "m"),
        cell(floor.displacement_y_m.value, "m"),
        cell(floor.rotation_rad.value, "rad"),
        cell(storey.drift_x_m.value, "m"),
        cell(storey.drift_y_m.value, "m"),
    ];
    match storey.edge_drift_x_m.zip(storey.edge_drift_y_m) {
        Some((x, y)) => {
            let corner_m = storey.resultant.size_m;
            let height_m = simulation.building.building().storeys()[i].height_m;
            row.extend([cell(x.value, "m"), cell(y.value, "m"), cell(corner_m, "m")]);
            row.push(Cell::number(Quantity::percent(corner_m / height_m, 3)));
        }
        None => row.extend([const { Cell::Number(None) }; 4]),
    }
    row
}

/// The points of the file; `None` if it has none.
pub(super) fn points(simulation: &BuildingSimulation) -> Option<Table> {
    let gravities = || Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / STANDARD_GRAVITY_M_S2,
    };
    let row = |point: &WatchedPoint| {
        let along = point.along.each_ref();
        let moved = along.map(|along| along.displacement_peak_m.value.abs());
        let felt = along.map(|along| along.acceleration_peak_m_s2.value.abs());
        let both = |values: [f64; 2], unit: Unit| {
            values.map(|value| Cell::number(beside(value, values[0].max(values[1]), unit.clone())))
        };
        let place = |value_m: f64| Cell::number(Quantity::new(value_m, Unit::si("m"), Digits::Fixed(3)));
        let mut row = vec![
            Cell::words(name(&point.name)),
            Cell::words(number(point.floor)),
            place(point.place_m[0]),
            place(point.place_m[1]),
        ];
        row.extend(both(moved, millimetres()));
        row.extend(both(felt, gravities()));
        row
    };
    (!simulation.points.is_empty()).then(|| Table {
        caption: vec![Tables::Points.into(), Tables::PointsMeaning.into()],
        columns: vec![
            Column::words(Tables::Point),
            Column::words(Tables::OnFloor),
            Column::numbers(Tables::PlaceX, Unit::si("m")),
            Column::numbers(Tables::PlaceY, Unit::si("m")),
            Column::numbers(Tables::X, millimetres()),
            Column::numbers(Tables::Y, millimetres()),
            Column::numbers(Tables::AccelerationX, gravities()),
            Column::numbers(Tables::AccelerationY, gravities()),
        ],
        rows: simulation.points.iter().map(row).collect(),
    })
}
