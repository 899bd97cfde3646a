//! The floors of a building, and the stiffness and stability of the storey below each.

use super::words::{fixed, name, significant};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::structure::building::StoreyMotion;
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::building::BuildingAnswer;

messages! {
    /// Floors and storeys.
    pub(crate) enum Storeys in "building.storeys" {
        Caption => { en: "Floors and the storey below each.", ko: "바닥과 그 아래층." },
        CaptionMeaning => {
            en: "Stiffness about its centre of rigidity, the eccentricity of that from the centre of mass; λ is the factor on the weight above at which the storey falls.",
            ko: "강성은 강성 중심에 대한 값이고 편심은 질량중심에서 강성 중심까지의 거리이다. λ는 그 층이 붕괴하는 상부 무게의 배수이다.",
        },
        Floor => { en: "Floor", ko: "층" },
        FallsBy => { en: "falls by", ko: "붕괴 형태" },
        Twist => { en: "twist", ko: "비틀림" },
        Sway => { en: "sway", ko: "횡변위" },
        Mass => { en: "mass", ko: "질량" },
        Rigidity => { en: "rigidity x", ko: "강성 중심 x" },
        Eccentricity => { en: "eccentricity x", ko: "편심 x" },
        LoadFactor => { en: "load factor λ", ko: "하중배율 λ" },
    }
}

/// One row per floor, the highest first.
pub(super) fn section(document: &mut Document<'_>, answer: &BuildingAnswer) {
    let building = &answer.elastic;
    let storeys = building.storeys().iter();
    let matrices: Vec<_> = storeys
        .map(|storey| {
            let at = storey.stiffness.centre_of_rigidity_m().unwrap_or([f64::NAN; 2]);
            (at, storey.stiffness.matrix_about(at))
        })
        .collect();
    let of = |i: usize| -> Vec<f64> { matrices.iter().map(|(_, k)| k[i][i]).collect() };
    let lateral = Unit::of(&[of(0), of(1)].concat(), "N/m");
    let turning = Unit::of(&of(2), "N·m/rad");
    let masses: Vec<f64> = building.floors().iter().map(|floor| floor.mass_kg).collect();
    let mass = Unit::of(&masses, "kg");
    let row = |i: usize| {
        let (at, k) = &matrices[i];
        let centre = building.floors()[i].centre_m;
        let fall = &answer.falls[i];
        let motion = match fall.motion() {
            StoreyMotion::Twists => Storeys::Twist,
            StoreyMotion::Sways => Storeys::Sway,
        };
        let metres = |value: f64| Cell::number(fixed(value, Unit::si("m"), 3));
        let stiffness = |value: f64, unit: &Unit| Cell::number(significant(value, unit.clone(), 4));
        let factor = Quantity::beside_one(fall.load_factor, 4);
        vec![
            Cell::words(name(&answer.floors[i])),
            Cell::words(motion),
            stiffness(masses[i], &mass),
            stiffness(k[0][0], &lateral),
            stiffness(k[1][1], &lateral),
            stiffness(k[2][2], &turning),
            metres(at[0]),
            metres(at[1]),
            metres(at[0] - centre[0]),
            metres(at[1] - centre[1]),
            match fall.load_factor > 1.0 {
                true => Cell::number(factor),
                false => Cell::Bad(factor),
            },
        ]
    };
    let symbol = |head: &str, unit: &Unit| Column::numbers(Sentence::of_symbol(head), unit.clone());
    let metre = Unit::si("m");
    document.put(Block::Table(Table {
        caption: vec![Storeys::Caption.into(), Storeys::CaptionMeaning.into()],
        columns: vec![
            Column::words(Storeys::Floor),
            Column::words(Storeys::FallsBy),
            Column::numbers(Storeys::Mass, mass.clone()),
            symbol("k x", &lateral),
            symbol("k y", &lateral),
            symbol("k θ", &turning),
            Column::numbers(Storeys::Rigidity, metre.clone()),
            symbol("y", &metre),
            Column::numbers(Storeys::Eccentricity, metre.clone()),
            symbol("y", &metre),
            Column::numbers(Storeys::LoadFactor, Unit::ratio()),
        ],
        rows: (0..matrices.len()).rev().map(row).collect(),
    }));
}
