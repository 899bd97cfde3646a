//! The response spectra of a motion.

use crate::document::{Cell, Column, Table};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::motion::MotionSeries;

messages! {
    /// Spectra.
    pub(crate) enum Spectra in "motion.spectra" {
        Caption { damping: Quantity, periods: usize } => {
            en: "Response spectrum, damping {damping}, some of {periods} periods.",
            ko: "응답스펙트럼, 감쇠비 {damping}, 주기 {periods}개 중 일부.",
        },
        Symbols => {
            en: "Sd is the displacement relative to the ground, PSA the pseudo-acceleration.",
            ko: "Sd는 지반에 대한 상대변위, PSA는 의사가속도이다.",
        },
        Period => { en: "period", ko: "주기" },
        Displacement { series: String } => { en: "{series} Sd", ko: "{series} Sd" },
        Acceleration { series: String } => { en: "{series} PSA", ko: "{series} PSA" },
    }
}

/// One row for every `step`-th period; `None` without spectra.
pub(super) fn table(all: &[MotionSeries], step: usize) -> Option<Table> {
    let first = &all.first()?.spectrum;
    let caption = Spectra::Caption {
        damping: Quantity::new(first.first()?.damping_ratio, Unit::percent(), Digits::Trimmed(6)),
        periods: first.len(),
    };
    let (millimetres, gravities) = (scaled("mm", 1e3), scaled("g", 1.0 / STANDARD_GRAVITY_M_S2));
    let mut columns = vec![Column::numbers(Spectra::Period, Unit::si("s"))];
    columns.extend(all.iter().flat_map(|one| {
        let series = || one.name.clone();
        [
            Column::numbers(Spectra::Displacement { series: series() }, millimetres.clone()),
            Column::numbers(Spectra::Acceleration { series: series() }, gravities.clone()),
        ]
    }));
    let number =
        |value: f64, unit: &Unit, decimals| Quantity::new(value, unit.clone(), Digits::Fixed(decimals));
    let row = |at: usize| {
        let mut cells = vec![Cell::number(number(first[at].period_s, &Unit::si("s"), 4))];
        for ordinate in all.iter().map(|one| one.spectrum.get(at)) {
            cells.push(Cell::Number(
                ordinate.map(|of| number(of.displacement_m, &millimetres, 3)),
            ));
            cells.push(Cell::Number(
                ordinate.map(|of| number(of.pseudo_acceleration_m_s2(), &gravities, 4)),
            ));
        }
        cells
    };
    Some(Table {
        caption: vec![caption.into(), Spectra::Symbols.into()],
        columns,
        rows: (0..first.len()).step_by(step).map(row).collect(),
    })
}

fn scaled(symbol: &str, factor: f64) -> Unit {
    Unit {
        symbol: symbol.to_owned(),
        factor,
    }
}
