//! The response of a building to the spectrum of its site, with and without its dampers.

use super::findings::{beyond_room_said, more_with_dampers, refused};
use super::words::{beside, kilonewtons, millimetres, name, scaled, significant, stroke_words};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_project::strokes_of;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::{
    AccidentalTorsion, BuildingAnswer, BuildingSpectral, DampedSpectral, MINOR_RATIO, StandingBuilding,
};

messages! {
    /// Response to the spectrum of the site.
    pub(crate) enum Spectrum in "building.spectrum" {
        Head => { en: "Response to the spectrum of the site", ko: "부지 스펙트럼에 대한 응답" },
        Shear => { en: "Base shear, without dampers.", ko: "밑면전단력(감쇠기 제외)." },
        ShearMeaning => {
            en: "What the walls of the lowest storey carry; shaking along x and y together by the root of the sum of squares.",
            ko: "최하층 벽체가 부담하는 값이며, x·y 방향 지진은 제곱합의 제곱근으로 조합하였다.",
        },
        Combination => { en: "Modes by", ko: "모드 조합" },
        AbsoluteSum => { en: "absolute sum", ko: "절대합" },
        LeastFavourable => { en: "CQC3, least favourable direction", ko: "CQC3, 가장 불리한 방향" },
        AlongX => { en: "along x", ko: "x 방향" },
        AlongY => { en: "along y", ko: "y 방향" },
        Torque(torque: Quantity) => {
            en: "The torque about the vertical through the centre of all mass is {torque} (CQC, as all below).",
            ko: "전체 질량중심을 지나는 연직축에 대한 비틀림모멘트는 {torque}이다(이하 모두 CQC).",
        },
        Directions { minor: Quantity, x: Quantity, y: Quantity } => {
            en: "In the least favourable direction of shaking, with the weaker component {minor} of the stronger, the stronger one acts at {x}° from x for the base shear along x and at {y}° for that along y.",
            ko: "약한 성분을 강한 성분의 {minor}배로 볼 때, 밑면전단력이 최대가 되는 강한 성분의 방향은 x 방향 전단력의 경우 x축에서 {x}°, y 방향 전단력의 경우 {y}°이다.",
        },
        Largest => { en: "Largest elastic response, without dampers.", ko: "최대 탄성응답(감쇠기 제외)." },
        LargestMeaning => {
            en: "Modes by CQC with the damping of each, shaking along x and y by the root of the sum of squares.",
            ko: "모드는 각 감쇠비를 고려한 CQC로, x·y 방향 지진은 제곱합의 제곱근으로 조합하였다.",
        },
        Damped => { en: "Largest elastic response with the dampers.", ko: "감쇠기를 포함한 최대 탄성응답." },
        DampedMeaning => {
            en: "Complex modes by CQC for damping that couples them.",
            ko: "비고전감쇠 복소모드를 CQC로 조합하였다.",
        },
        Floor => { en: "Floor", ko: "층" },
        DisplacementX => { en: "x", ko: "변위 x" },
        EdgeDriftX => { en: "edge drift x", ko: "단부 층간변위 x" },
        OfHeight => { en: "of the height", ko: "층고에 대한 비" },
        OutlineUnknown => {
            en: "– : the floor has no outline, so that the drift at its edges is not known.",
            ko: "– : 바닥 외곽선이 없어 단부 층간변위를 알 수 없다.",
        },
        Points => { en: "Displacement of the points of the file, without dampers.", ko: "입력한 관측점의 변위(감쇠기 제외)." },
        PointsDamped => { en: "Displacement of the points of the file with the dampers.", ko: "감쇠기를 포함한 관측점의 변위." },
        Point => { en: "Point", ko: "관측점" },
        WithDampers { x: Quantity, y: Quantity, torque: Quantity } => {
            en: "With the dampers: base shear along x {x}, along y {y}, torque {torque}.",
            ko: "감쇠기 포함: 밑면전단력 x 방향 {x}, y 방향 {y}, 비틀림모멘트 {torque}.",
        },
        Strokes => { en: "Strokes of the dampers.", ko: "감쇠기의 행정." },
        StrokesMeaning => { en: "Each way from rest, beside the room there is.", ko: "정지 위치에서 한쪽 방향의 값이며 여유 공간과 비교하였다." },
        Torsion => { en: "Largest drift at an edge with accidental torsion.", ko: "우발비틀림을 고려한 최대 단부 층간변위." },
        TorsionMeaning => {
            en: "Every centre of mass is displaced by this share of the side of its floor: along y under shaking along x, along x under shaking along y; both directions of shaking by the root of the sum of squares. The worst row counts.",
            ko: "모든 질량중심을 바닥 변 길이에 대한 이 비율만큼 이동하였다. x 방향 지진에는 y 방향으로, y 방향 지진에는 x 방향으로 이동하며, 두 방향 지진은 제곱합의 제곱근으로 조합하였다. 가장 불리한 행이 판정에 쓰인다.",
        },
        DisplacedX => { en: "moved along x", ko: "x 방향 이동" },
        DisplacedY => { en: "along y", ko: "y 방향 이동" },
        DriftX => { en: "drift x / height", ko: "층간변위 x / 층고" },
        DriftY => { en: "drift y / height", ko: "층간변위 y / 층고" },
        TorsionNotAsked => {
            en: "Accidental torsion is not included, because no code that requires it decides here.« `accidental_eccentricity = 0.05` includes it.»",
            ko: "이를 요구하는 기준으로 판정하지 않으므로 우발비틀림을 고려하지 않았다.« `accidental_eccentricity = 0.05`로 입력하면 고려한다.»",
        },
        StrokeWithTorsion => { en: "with accidental torsion", ko: "우발비틀림 고려" },
        Damper => { en: "Damper", ko: "감쇠기" },
        Stroke => { en: "stroke", ko: "행정" },
        Room => { en: "room", ko: "여유 공간" },
        RoomUnknown(damper: Sentence) => {
            en: "Whether damper {damper} has room enough is not known.",
            ko: "감쇠기 {damper}의 여유 공간이 충분한지는 알 수 없다.",
        },
        Simulate => {
            en: "«`dolmen simulate`|A simulation in time» computes it under a motion.",
            ko: "지반운동에 대한 응답은 «`dolmen simulate`|지진응답 검토»로 계산할 수 있다.",
        },
        GiveDamping => {
            en: "Give the modes damping that the spectrum is for, or compute it under a motion with «`dolmen simulate`|a simulation in time».",
            ko: "스펙트럼의 적용 범위에 드는 모드 감쇠비를 입력하거나, «`dolmen simulate`|지진응답 검토»로 지반운동에 대한 응답을 계산한다.",
        },
    }
}

/// A floor's displacement, drifts, and the points of the file.
struct SpectralDisplacements<'a> {
    displacement_m: &'a [[f64; 2]],
    edge_drift_m: &'a [Option<[f64; 2]>],
    points_m: &'a [(String, [f64; 2])],
    /// Captions of the floors, and of the points.
    captions: ([Spectrum; 2], Spectrum),
}

/// Without the dampers, with them, and results that could not be computed.
pub(super) fn section(document: &mut Document<'_>, answer: &BuildingAnswer, standing: &StandingBuilding) {
    let refused = refused(standing);
    if standing.spectral.is_none() && refused.is_none() {
        return;
    }
    document.heading(Spectrum::Head);
    if let Some(spectral) = &standing.spectral {
        without_dampers(document, answer, spectral);
    }
    if let Some(damped) = &standing.damped {
        with_dampers(document, answer, (standing, damped));
    }
    torsion(document, answer, standing);
    if let Some(said) = refused {
        document.put(Block::Warning(said.into()));
    }
    match (&standing.spectral_refused, &standing.damped_refused) {
        (Some(_), _) => document.note(Spectrum::GiveDamping),
        (None, Some(_)) => document.note(Spectrum::Simulate),
        (None, None) => {}
    }
    if standing.damped_refused.is_some() {
        let strokes = strokes_of(&standing.dampers).into_iter();
        for stroke in strokes.filter(|stroke| stroke.room_m.is_some()) {
            document.note(Spectrum::RoomUnknown(stroke_words(&stroke.name)));
        }
    }
}

fn without_dampers(document: &mut Document<'_>, answer: &BuildingAnswer, spectral: &BuildingSpectral) {
    let largest_n = most(spectral.base_shear_n[2]);
    document.put(Block::Table(shear_table(spectral, largest_n)));
    let degrees = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Fixed(0));
    let [x, y] = spectral.least_favourable.map(|of| degrees(of.direction_degrees));
    let torque = beside(spectral.base_torque_n_m, largest_n, scaled("kN·m", 1e-3));
    document.put(Block::Paragraph(vec![
        Spectrum::Torque(torque).into(),
        Spectrum::Directions {
            minor: Quantity::ratio(MINOR_RATIO, 2),
            x,
            y,
        }
        .into(),
    ]));
    let moved = SpectralDisplacements {
        displacement_m: &spectral.displacement_m,
        edge_drift_m: &spectral.edge_drift_m,
        points_m: &spectral.points_m,
        captions: ([Spectrum::Largest, Spectrum::LargestMeaning], Spectrum::Points),
    };
    moved_tables(document, answer, moved);
}

fn with_dampers(
    document: &mut Document<'_>,
    answer: &BuildingAnswer,
    (standing, damped): (&StandingBuilding, &DampedSpectral),
) {
    let largest_n = most(damped.base_shear_n);
    let [x, y] = damped.base_shear_n.map(|n| beside(n, largest_n, kilonewtons()));
    let torque = beside(damped.base_torque_n_m, largest_n, scaled("kN·m", 1e-3));
    document.paragraph(Spectrum::WithDampers { x, y, torque });
    let moved = SpectralDisplacements {
        displacement_m: &damped.displacement_m,
        edge_drift_m: &damped.edge_drift_m,
        points_m: &damped.points_m,
        captions: (
            [Spectrum::Damped, Spectrum::DampedMeaning],
            Spectrum::PointsDamped,
        ),
    };
    moved_tables(document, answer, moved);
    document.put(Block::Table(strokes_table(standing, damped)));
    for said in beyond_room_said(standing) {
        document.put(Block::Warning(said.into()));
    }
    if let Some(said) = more_with_dampers(standing) {
        document.note(said);
    }
}

/// The largest drift with the centres of mass as they are and displaced.
fn torsion(document: &mut Document<'_>, answer: &BuildingAnswer, standing: &StandingBuilding) {
    let of = match &standing.accidental {
        AccidentalTorsion::Included(of) => of,
        AccidentalTorsion::NotAsked if standing.spectral.is_some() => {
            return document.note(Spectrum::TorsionNotAsked);
        }
        // findings
        AccidentalTorsion::NotAsked
        | AccidentalTorsion::LeftOut { .. }
        | AccidentalTorsion::NoOutline { .. }
        | AccidentalTorsion::Refused { .. } => return,
    };
    let percent = |value: f64| Cell::number(Quantity::percent(value, 3));
    let row = |signs: [f64; 2], drifts: &mut dyn Iterator<Item = [f64; 2]>| {
        let storeys = drifts.zip(answer.elastic.storeys());
        let largest = storeys.fold([0.0_f64; 2], |[x, y], (drift, storey)| {
            let [own_x, own_y] = drift.map(|m| m / storey.height_m);
            [x.max(own_x), y.max(own_y)]
        });
        let share = |value: f64| Cell::number(Quantity::new(value, Unit::percent(), Digits::Trimmed(2)));
        let displaced = signs.map(|sign| share(sign * of.fraction));
        displaced
            .into_iter()
            .chain(largest.map(percent))
            .collect::<Vec<_>>()
    };
    let edges = match (&standing.damped, &standing.spectral) {
        (Some(damped), _) => damped.edge_drift_m.as_slice(),
        (None, Some(alone)) => alone.edge_drift_m.as_slice(),
        (None, None) => return,
    };
    let mut rows = vec![row([0.0; 2], &mut edges.iter().copied().flatten())];
    let each = of.cases.iter();
    rows.extend(each.map(|case| row(case.signs, &mut case.edge_drift_m.iter().copied())));
    document.put(Block::Table(Table {
        caption: vec![Spectrum::Torsion.into(), Spectrum::TorsionMeaning.into()],
        columns: [
            Spectrum::DisplacedX,
            Spectrum::DisplacedY,
            Spectrum::DriftX,
            Spectrum::DriftY,
        ]
        .map(|head| Column::numbers(head, Unit::percent()))
        .into(),
        rows,
    }));
}

fn most([x, y]: [f64; 2]) -> f64 {
    x.abs().max(y.abs())
}

fn shear_table(spectral: &BuildingSpectral, largest_n: f64) -> Table {
    let row = |words: Sentence, values: [f64; 2]| {
        let [x, y] = values.map(|n| Cell::number(beside(n, largest_n, kilonewtons())));
        vec![Cell::words(words), x, y]
    };
    let [sum, srss, cqc] = spectral.base_shear_n;
    let worst = spectral.least_favourable.map(|of| of.largest);
    Table {
        caption: vec![Spectrum::Shear.into(), Spectrum::ShearMeaning.into()],
        columns: vec![
            Column::words(Spectrum::Combination),
            Column::numbers(Spectrum::AlongX, kilonewtons()),
            Column::numbers(Spectrum::AlongY, kilonewtons()),
        ],
        rows: vec![
            row(Spectrum::AbsoluteSum.into(), sum),
            row(Sentence::of_symbol("SRSS"), srss),
            row(Sentence::of_symbol("CQC"), cqc),
            row(Spectrum::LeastFavourable.into(), worst),
        ],
    }
}

/// Floors with the storeys below them, then points.
fn moved_tables(document: &mut Document<'_>, answer: &BuildingAnswer, moved: SpectralDisplacements<'_>) {
    let (caption, points) = moved.captions;
    let storeys = answer.elastic.storeys();
    let largest_m = moved
        .displacement_m
        .iter()
        .fold(0.0_f64, |largest, own| largest.max(most(*own)));
    let millimetre = |value: f64| Cell::number(beside(value, largest_m, millimetres()));
    let row = |i: usize| {
        let [x, y] = moved.displacement_m[i];
        let mut row = vec![Cell::words(name(&answer.floors[i])), millimetre(x), millimetre(y)];
        row.extend(match moved.edge_drift_m[i] {
            Some([x, y]) => {
                let share = Quantity::percent(x.max(y) / storeys[i].height_m, 3);
                [millimetre(x), millimetre(y), Cell::number(share)]
            }
            None => [(); 3].map(|()| Cell::Number(None)),
        });
        row
    };
    let numbers = |head: Sentence| Column::numbers(head, millimetres());
    document.put(Block::Table(Table {
        caption: caption.into_iter().map(Sentence::from).collect(),
        columns: vec![
            Column::words(Spectrum::Floor),
            numbers(Spectrum::DisplacementX.into()),
            numbers(Sentence::of_symbol("y")),
            numbers(Spectrum::EdgeDriftX.into()),
            numbers(Sentence::of_symbol("y")),
            Column::numbers(Spectrum::OfHeight, Unit::percent()),
        ],
        rows: (0..storeys.len()).rev().map(row).collect(),
    }));
    if moved.edge_drift_m.iter().any(Option::is_none) {
        document.note(Spectrum::OutlineUnknown);
    }
    if !moved.points_m.is_empty() {
        let row = |(point, [x, y]): &(String, [f64; 2])| {
            vec![Cell::words(name(point)), millimetre(*x), millimetre(*y)]
        };
        document.put(Block::Table(Table {
            caption: vec![points.into()],
            columns: vec![
                Column::words(Spectrum::Point),
                numbers(Sentence::of_symbol("x")),
                numbers(Sentence::of_symbol("y")),
            ],
            rows: moved.points_m.iter().map(row).collect(),
        }));
    }
}

fn strokes_table(standing: &StandingBuilding, damped: &DampedSpectral) -> Table {
    let strokes = strokes_of(&standing.dampers);
    let judged_m = standing.judged_strokes_m();
    let with_torsion = standing.accidental.included().is_some();
    let row = |((stroke, stroke_m), judged_m): ((&dolmen_project::Stroke, &f64), &f64)| {
        let millimetre = |value: f64| significant(value, millimetres(), 4);
        let compared = |stroke_m: f64| match stroke.room_m.is_some_and(|room_m| stroke_m > room_m) {
            true => Cell::Bad(millimetre(stroke_m)),
            false => Cell::number(millimetre(stroke_m)),
        };
        let mut row = vec![Cell::words(stroke_words(&stroke.name)), compared(*stroke_m)];
        row.extend(with_torsion.then(|| compared(*judged_m)));
        row.push(Cell::Number(stroke.room_m.map(millimetre)));
        row
    };
    let mut columns = vec![
        Column::words(Spectrum::Damper),
        Column::numbers(Spectrum::Stroke, millimetres()),
    ];
    columns.extend(with_torsion.then(|| Column::numbers(Spectrum::StrokeWithTorsion, millimetres())));
    columns.push(Column::numbers(Spectrum::Room, millimetres()));
    Table {
        caption: vec![Spectrum::Strokes.into(), Spectrum::StrokesMeaning.into()],
        columns,
        rows: strokes
            .iter()
            .zip(&damped.strokes_m)
            .zip(&judged_m)
            .map(row)
            .collect(),
    }
}
