//! Frames under lateral forces.

use super::{Case, ValidationError};
use crate::stability::{FootSection, FramePush, FreeColumns, frame_under_loads};
use crate::structure::{Convention, Frame, Storey};

const SOURCE: &str = "By hand: a storey in its leaning shape";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    let storeys = [(5.0, 500e3), (4.0, 200e3)].map(|(height_m, axial_n)| Storey {
        mass_kg: 30e3,
        height_m,
        axial_n,
    });
    let gate = Frame::new(storeys.to_vec(), Convention::Drift)?;
    let push = FramePush {
        forces_n: &[10e3, 20e3],
        columns: &[None, None],
        tilt: 0.01,
        drift_ratio_most: 0.1,
    };
    let found = frame_under_loads(&gate, &[1100e3, 850e3], &push)?;
    let hand = [
        ("lower", 30e3 / (1100e3 - 100e3)),
        ("upper", 20e3 / (850e3 - 50e3)),
    ];
    for ((name, published), storey) in hand.into_iter().zip(&found.storeys) {
        cases.push(Case {
            source: SOURCE,
            what: format!("drift of the {name} storey of two under 10 and 20 kN, k 1100 and 850 kN/m"),
            unit: "m",
            published,
            computed: storey.drift_m.unwrap_or(f64::NAN),
            tolerance: 1e-12,
            corrected: None,
            note: "δ = V/(k − N/l): the weight pushes on as it leans; a lean of 1/100 adds none of it.",
        });
    }
    cases.push(Case {
        source: SOURCE,
        what: "factor on these forces at which the upper storey counts as fallen".to_owned(),
        unit: "",
        published: ((850e3 - 50e3) * 0.09 * 4.0 - 200e3 * 0.01) / 20e3,
        computed: found.factor,
        tolerance: 1e-12,
        corrected: None,
        note: "((k − N/l)(0.1 − τ) l − N τ)/V.",
    });
    let section = FootSection::Rectangle {
        width_m: 0.5,
        breadth_m: 0.5,
    };
    let column = FreeColumns::new(1, section, 4.0, 200e3, None)?;
    let alone = Frame::new(vec![storeys[1].clone()], Convention::Drift)?;
    let push = FramePush {
        forces_n: &[10e3],
        columns: &[Some(column)],
        tilt: 0.0,
        drift_ratio_most: 0.1,
    };
    cases.push(Case {
        source: SOURCE,
        what: "factor on 10 kN that a rigid column of 0.5 m by 4 m bears under 200 kN".to_owned(),
        unit: "",
        published: 200e3 * 0.125 / 10e3,
        computed: frame_under_loads(&alone, &[0.0], &push)?.factor,
        tolerance: 1e-12,
        corrected: None,
        note: "N (b/h)/V: rigid stones.",
    });
    Ok(cases)
}
