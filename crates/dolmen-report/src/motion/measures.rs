//! The measures of a motion.

use crate::document::{Cell, Column, Table};
use crate::simulated::doubted_of;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::IntensityMeasures;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::motion::{MotionDoubt, MotionSeries, base_line_drifts};

messages! {
    /// Measures.
    pub(crate) enum Measured in "motion.measures" {
        Caption => { en: "Measures.", ko: "지반운동의 세기 지표." },
        Measure => { en: "measure", ko: "지표" },
        UnitHead => { en: "unit", ko: "단위" },
        Series { name: String } => { en: "{name}", ko: "{name}" },
        PeakAcceleration => { en: "PGA", ko: "최대지반가속도(PGA)" },
        PeakVelocity => { en: "PGV", ko: "최대지반속도(PGV)" },
        PeakDisplacement => { en: "PGD", ko: "최대지반변위(PGD)" },
        LastVelocity => { en: "velocity at the end", ko: "종료 시 속도" },
        LastDisplacement => { en: "displacement at the end", ko: "종료 시 변위" },
        Arias => { en: "Arias intensity", ko: "아리아스 강도" },
        AbsoluteVelocity => { en: "CAV", ko: "누적절대속도(CAV)" },
        Housner => { en: "Housner intensity", ko: "하우스너 강도" },
        Duration => { en: "duration 5–95 %", ko: "지속시간(5–95 %)" },
        MeanPeriod => { en: "mean period", ko: "평균주기" },
        PredominantPeriod => { en: "predominant period", ko: "탁월주기" },
        Drifts { name: String, away: Quantity } => {
            en: "{name} ends {away} away, near its largest displacement: the base line drifts, or the ground moved for good; take it off with --baseline or --high-pass.",
            ko: "{name} 성분의 변위가 {away}에서 끝나며 이는 최대 변위에 가깝다. 기선이 표류하였거나 지반이 영구 이동한 기록이다. 기선 표류라면 --baseline 또는 --high-pass로 제거한다.",
        },
    }
}

type Value = fn(&IntensityMeasures) -> Option<f64>;

/// One row per measure, one column per series.
pub(super) fn table(series: &[MotionSeries]) -> Table {
    let rows: [(Measured, &str, Value); 11] = [
        (Measured::PeakAcceleration, "g", |of| {
            Some(of.peak_acceleration_m_s2 / STANDARD_GRAVITY_M_S2)
        }),
        (Measured::PeakVelocity, "m/s", |of| Some(of.peak_velocity_m_s)),
        (Measured::PeakDisplacement, "m", |of| Some(of.peak_displacement_m)),
        (Measured::LastVelocity, "m/s", |of| Some(of.last_velocity_m_s)),
        (Measured::LastDisplacement, "m", |of| Some(of.last_displacement_m)),
        (Measured::Arias, "m/s", |of| Some(of.arias_intensity_m_s)),
        (Measured::AbsoluteVelocity, "m/s", |of| {
            Some(of.cumulative_absolute_velocity_m_s)
        }),
        (Measured::Housner, "m", |of| of.housner_intensity_m),
        (Measured::Duration, "s", |of| Some(of.significant_duration_s)),
        (Measured::MeanPeriod, "s", |of| of.mean_period_s),
        (Measured::PredominantPeriod, "s", |of| of.predominant_period_s),
    ];
    let mut columns = vec![
        Column::words(Measured::Measure),
        Column::words(Measured::UnitHead),
    ];
    columns.extend(series.iter().map(|one| {
        let name = one.name.clone();
        Column::numbers(Measured::Series { name }, Unit::ratio())
    }));
    let row = |(measure, unit, value): (Measured, &str, Value)| {
        let mut cells = vec![Cell::words(measure), Cell::words(Sentence::of_symbol(unit))];
        cells.extend(series.iter().map(|one| number(value(&one.measures))));
        cells
    };
    Table {
        caption: vec![Measured::Caption.into()],
        columns,
        rows: rows.into_iter().map(row).collect(),
    }
}

fn number(value: Option<f64>) -> Cell {
    Cell::Number(value.map(|value| Quantity::new(value, Unit::ratio(), Digits::Fixed(4))))
}

/// Notes on series with a wrong step, an offset or a drifting baseline.
pub(super) fn drifts(series: &[MotionSeries]) -> Vec<Sentence> {
    let mut all = Vec::new();
    for one in series {
        let doubts = one.doubts();
        let doubted = doubts.iter().map(|doubt| doubted_of(doubt, Some(&one.name)));
        all.extend(doubted.map(Sentence::from));
        let is_offset = |doubt: &MotionDoubt| matches!(doubt, MotionDoubt::Offset { .. });
        let of = &one.measures;
        if !doubts.iter().any(is_offset) && base_line_drifts([of.last_displacement_m, of.peak_displacement_m])
        {
            let drifting = Measured::Drifts {
                name: one.name.clone(),
                away: Quantity::new(of.last_displacement_m, Unit::si("m"), Digits::Fixed(3)),
            };
            all.push(drifting.into());
        }
    }
    all
}
