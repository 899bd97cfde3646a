//! A building in the wind of its file, over time.

use super::words::{axis_words, fixed, kilonewtons, millimetres, name, scaled, significant, stroke_words};
use crate::document::{Block, Cell, Column, Document, Figure, Table};
use crate::figures::{GustPlot, gust_profile, gust_series};
use crate::loads::as_given;
use dolmen::structure::wind::TurbulenceSpectrum;
use dolmen_project::{LoadsPart, strokes_of};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::{BuildingAnswer, BuildingWind, StandingBuilding, WindAlong, WindMotion};

messages! {
    /// The motion of a building in the wind.
    pub(crate) enum InWind in "building.wind" {
        Head => { en: "In the wind", ko: "풍응답" },
        Source(source: String) => { en: "Source of the wind: {source}.", ko: "풍하중의 출처: {source}." },
        Kaimal => {
            en: "Gusts along the wind with the spectrum of EN 1991-1-4, Annex B (Kaimal).",
            ko: "풍방향 난류의 스펙트럼은 EN 1991-1-4 부속서 B(Kaimal)이다.",
        },
        VonKarman => {
            en: "Gusts along the wind with von Kármán’s spectrum.",
            ko: "풍방향 난류의 스펙트럼은 von Kármán 식이다.",
        },
        Method => {
            en: "A peak is the mean and g σ in ten minutes (Davenport); gusts hang together by exp(−10 n (|Δy| + |Δz|)/V).",
            ko: "최댓값은 평균에 10분간의 g σ를 더한 값이며(Davenport), 난류의 공간 상관은 exp(−10 n (|Δy| + |Δz|)/V)로 고려하였다.",
        },
        OffTheMiddle(eccentricity: Quantity) => {
            en: "Edges, corners, torque and strokes are the worst of the wind at the middle of the breadth and all of it {eccentricity} of the breadth off either side; the rest is with the wind at the middle.",
            ko: "단부, 모서리, 비틀림모멘트, 행정은 풍력 전체가 폭의 중앙 또는 폭의 {eccentricity}만큼 양쪽으로 편심하여 작용할 때의 최댓값이고, 나머지는 중앙에 작용할 때의 값이다.",
        },
        AtTheMiddle => {
            en: "The wind acts at the middle of the breadth: no eccentricity, as the file says.",
            ko: "입력에 따라 편심 없이 폭의 중앙에 작용하는 것으로 하였다.",
        },
        LeftOut => {
            en: "Not in it: gusts and vortices across the wind, their torque, galloping, aerodynamic damping.",
            ko: "풍직각방향 난류·와류, 그 비틀림, 갤로핑, 공력감쇠는 포함하지 않았다.",
        },
        AlongAxis(axis: Sentence) => { en: "Wind along {axis}.", ko: "{axis} 방향 바람." },
        AlongWithout(axis: Sentence) => {
            en: "Wind along {axis}, without dampers.",
            ko: "{axis} 방향 바람(감쇠기 제외).",
        },
        AlongWith(axis: Sentence) => {
            en: "Wind along {axis}, with the dampers.",
            ko: "{axis} 방향 바람(감쇠기 포함).",
        },
        Meaning => {
            en: "V and I_u are those of the middle of what the floor takes; displacement and a are along the wind, the corner in its worst direction.",
            ko: "V와 I_u는 바닥이 부담하는 높이 중앙의 값이다. 변위와 가속도 a는 풍방향, 모서리는 가장 불리한 방향의 값이다.",
        },
        Floor => { en: "Floor", ko: "층" },
        Mean => { en: "mean", ko: "평균변위" },
        Peak => { en: "peak", ko: "최대변위" },
        EdgeDrift => { en: "edge drift", ko: "단부 층간변위" },
        OfHeight => { en: "of height", ko: "층고비" },
        Rms => { en: "σ of a", ko: "a의 표준편차" },
        PeakOfA => { en: "peak a", ko: "최대 a" },
        Corner => { en: "corner", ko: "모서리" },
        Base { axis: Sentence, mean: Quantity, peak: Quantity, torque: Quantity, rotation: Quantity } => {
            en: "Wind along {axis}: base shear {mean} in the mean, {peak} at its peak; torque about the centre of all mass up to {torque}; the top floor turns with σ {rotation}.",
            ko: "{axis} 방향 바람: 밑면전단력 평균 {mean}, 최대 {peak}, 전체 질량중심에 대한 최대 비틀림모멘트 {torque}, 최상층 회전가속도의 표준편차 {rotation}.",
        },
        Strokes => { en: "Strokes of the dampers in the wind.", ko: "바람에 대한 감쇠기의 행정." },
        StrokesMeaning => {
            en: "Each way from rest, the larger of both winds; ten minutes.",
            ko: "정지 위치에서 한쪽 방향의 값이며 두 풍향 중 큰 값이다(10분).",
        },
        Damper => { en: "Damper", ko: "감쇠기" },
        RmsStroke => { en: "σ", ko: "표준편차" },
        PeakStroke => { en: "peak", ko: "최대 행정" },
        Room => { en: "room", ko: "여유 공간" },
        Profile => { en: "Peak acceleration by height.", ko: "높이별 최대가속도." },
        ProfileMeaning => {
            en: "At the worst corner of each floor, the wind along x and along y.",
            ko: "각 층의 가장 불리한 모서리에서의 값이며 x·y 방향 바람을 나누어 나타냈다.",
        },
        ProfileDashed => { en: "Dashed without the dampers.", ko: "점선은 감쇠기가 없을 때이다." },
        Moved => { en: "Displacement by height.", ko: "높이별 변위." },
        MovedMeaning => {
            en: "Along the wind at the centre of mass: the mean and the peak.",
            ko: "질량중심의 풍방향 변위이며 평균과 최댓값이다.",
        },
    }
}

/// The effect of the wind, if the file gives one.
pub(super) fn section<'a>(
    document: &mut Document<'a>,
    answer: &'a BuildingAnswer,
    standing: &'a StandingBuilding,
    loads: &'a LoadsPart,
) {
    let Some(given) = loads.wind() else { return };
    document.heading(InWind::Head);
    document.paragraph(as_given(given));
    if let Some(source) = given.source.clone() {
        document.paragraph(InWind::Source(source));
    }
    if let Some(why) = super::wind_findings::wind_refused(standing) {
        document.put(Block::Warning(why.into()));
    }
    let Some(wind) = &standing.wind else { return };
    document.put(Block::Paragraph(vec![
        match wind.spectrum {
            TurbulenceSpectrum::Kaimal => InWind::Kaimal,
            TurbulenceSpectrum::VonKarman => InWind::VonKarman,
        }
        .into(),
        InWind::Method.into(),
        match wind.eccentricity > 0.0 {
            true => InWind::OffTheMiddle(Quantity::ratio(wind.eccentricity, 3)),
            false => InWind::AtTheMiddle,
        }
        .into(),
    ]));
    for (axis, along) in wind.along.iter().enumerate() {
        tables(document, answer, (axis, along));
    }
    if !standing.dampers.is_empty() {
        document.put(Block::Table(strokes(standing, wind)));
    }
    document.note(InWind::LeftOut);
    let heights_m = answer.elastic.floor_heights_m();
    for (plot, caption) in [
        (GustPlot::Acceleration, [InWind::Profile, InWind::ProfileMeaning]),
        (GustPlot::Displacement, [InWind::Moved, InWind::MovedMeaning]),
    ] {
        let (heights_m, of_series) = (heights_m.clone(), heights_m.clone());
        let dashed = matches!(plot, GustPlot::Acceleration) && !standing.dampers.is_empty();
        let dashed = dashed.then_some(InWind::ProfileDashed);
        let caption = caption.into_iter().chain(dashed).map(Sentence::from).collect();
        let drawn = Figure::drawn(caption, move |language| {
            gust_profile(plot, wind, &heights_m, language)
        });
        document.charted(drawn.with_series(move || gust_series(plot, wind, &of_series)));
    }
}

fn tables(document: &mut Document<'_>, answer: &BuildingAnswer, (axis, along): (usize, &WindAlong)) {
    let name = || axis_words(axis);
    let caption = match along.with {
        Some(_) => InWind::AlongWithout(name()),
        None => InWind::AlongAxis(name()),
    };
    document.put(Block::Table(table(answer, along, &along.without, caption)));
    document.paragraph(base(axis, &along.without));
    if let Some(with) = &along.with {
        document.put(Block::Table(table(
            answer,
            along,
            with,
            InWind::AlongWith(name()),
        )));
        document.paragraph(base(axis, with));
    }
}

/// A rotation below this, rad/s², is rounding: at the edge of a floor of 1 km it is less than 1 nm/s².
const ROUNDING_RAD_S2: f64 = 1e-12;

fn base(axis: usize, motion: &WindMotion) -> InWind {
    let [mean, peak] = [motion.base_shear_n.mean.abs(), motion.base_shear_n.peak()];
    let turning = motion
        .floors
        .last()
        .map_or(0.0, |floor| floor.rotation_rad_s2.rms);
    let is_rounding = turning.abs() < ROUNDING_RAD_S2;
    InWind::Base {
        axis: axis_words(axis),
        mean: significant(mean, kilonewtons(), 4),
        peak: significant(peak, kilonewtons(), 4),
        torque: significant(motion.base_torque_n_m.peak(), scaled("kN·m", 1e-3), 4),
        rotation: significant(if is_rounding { 0.0 } else { turning }, scaled("mrad/s²", 1e3), 3),
    }
}

fn table(answer: &BuildingAnswer, along: &WindAlong, motion: &WindMotion, caption: InWind) -> Table {
    let storeys = answer.elastic.storeys();
    let millimetre = |value: f64| Cell::number(significant(value, millimetres(), 4));
    let acceleration = |value: f64| Cell::number(significant(value, Unit::si("m/s²"), 3));
    let row = |i: usize| {
        let (met, floor) = (&along.met[i], &motion.floors[i]);
        let drift_m = floor.drift_m.peak();
        vec![
            Cell::words(name(&answer.floors[i])),
            Cell::number(fixed(met.wind.mean_speed_m_s, Unit::si("m/s"), 1)),
            Cell::number(fixed(met.wind.intensity, Unit::percent(), 1)),
            millimetre(floor.displacement_m.mean),
            millimetre(floor.displacement_m.peak()),
            millimetre(drift_m),
            Cell::number(Quantity::percent(drift_m / storeys[i].height_m, 3)),
            acceleration(floor.acceleration_m_s2.rms),
            acceleration(floor.acceleration_m_s2.peak()),
            acceleration(floor.corner_m_s2.peak()),
        ]
    };
    let numbers = |head: Sentence, unit: Unit| Column::numbers(head, unit);
    Table {
        caption: vec![caption.into(), InWind::Meaning.into()],
        columns: vec![
            Column::words(InWind::Floor),
            numbers(Sentence::of_symbol("V"), Unit::si("m/s")),
            numbers(Sentence::of_symbol("I_u"), Unit::percent()),
            numbers(InWind::Mean.into(), millimetres()),
            numbers(InWind::Peak.into(), millimetres()),
            numbers(InWind::EdgeDrift.into(), millimetres()),
            numbers(InWind::OfHeight.into(), Unit::percent()),
            numbers(InWind::Rms.into(), Unit::si("m/s²")),
            numbers(InWind::PeakOfA.into(), Unit::si("m/s²")),
            numbers(InWind::Corner.into(), Unit::si("m/s²")),
        ],
        rows: (0..storeys.len()).rev().map(row).collect(),
    }
}

fn strokes(standing: &StandingBuilding, wind: &BuildingWind) -> Table {
    let [x, y] = wind.motions();
    let millimetre = |value: f64| Quantity::new(value, millimetres(), Digits::Significant(4));
    let row = |(k, stroke): (usize, dolmen_project::Stroke)| {
        let [x, y] = [x.strokes_m[k], y.strokes_m[k]];
        let worse = if x.peak() >= y.peak() { x } else { y };
        let beyond = stroke.room_m.is_some_and(|room_m| worse.peak() > room_m);
        vec![
            Cell::words(stroke_words(&stroke.name)),
            Cell::number(millimetre(worse.rms)),
            match beyond {
                true => Cell::Bad(millimetre(worse.peak())),
                false => Cell::number(millimetre(worse.peak())),
            },
            Cell::Number(stroke.room_m.map(millimetre)),
        ]
    };
    Table {
        caption: vec![InWind::Strokes.into(), InWind::StrokesMeaning.into()],
        columns: vec![
            Column::words(InWind::Damper),
            Column::numbers(InWind::RmsStroke, millimetres()),
            Column::numbers(InWind::PeakStroke, millimetres()),
            Column::numbers(InWind::Room, millimetres()),
        ],
        rows: strokes_of(&standing.dampers)
            .into_iter()
            .enumerate()
            .map(row)
            .collect(),
    }
}
