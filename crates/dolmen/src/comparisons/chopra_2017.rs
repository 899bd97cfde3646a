//! Chopra (2017): five storeys under El Centro, by response spectrum and in time; correlation of modes.

use super::{Case, ValidationError};
use crate::dynamics::{
    BuildingRun, DirectionalCombination, ModalCombination, VibratingBuilding, building_history,
    correlation_coefficient, spectral_analysis,
};
use crate::signal::{Component, GroundMotion, response_spectrum};
use crate::structure::Building;
use crate::structure::building::{BuildingDamping, Floor, PDelta, Storey, StoreyStiffness};

const SOURCE: &str = "Chopra (2017)";
/// g in in/s²; all units here are kip, inch and second.
const GRAVITY_IN_S2: f64 = 386.4;
const STIFFNESS_KIP_IN: f64 = 31.54;
const PERIODS_S: [f64; 5] = [1.99963, 0.68504, 0.43456, 0.33828, 0.29659];
const FORCES: &str = "The spectrum is computed from the record, 1560 samples of 0.02 s; peaks between samples are counted. The tolerance is \
                      0.02 %.";
/// Number of parts of a sample step at which the history is evaluated.
const CUT: usize = 8;
const HISTORY: &str =
    "Looked at 8 times a sample; at the samples alone it is 73.09. The tolerance is 0.02 %.";
const CORRELATION: &str =
    "Lower mode 2 %, higher 5 %. With the damping of the two modes swapped it would be 0.0763.";

/// The record in the repository, g.
const EL_CENTRO: &str = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");

fn el_centro() -> Result<GroundMotion, ValidationError> {
    let rows = EL_CENTRO.lines().skip(1);
    let samples = rows.filter_map(|row| row.split_once(',')?.1.trim().parse::<f64>().ok());
    let samples: Vec<f64> = samples.map(|g| g * GRAVITY_IN_S2).collect();
    Ok(GroundMotion::new(
        "El Centro 1940 NS",
        0.02,
        vec![(Component::X, samples)],
    )?)
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let floor = Floor {
        mass_kg: 100.0 / GRAVITY_IN_S2,
        centre_m: [0.0, 0.0],
        gyration_m: 100.0,
        outline: None,
    };
    // so stiff along y and in torsion that it moves only along x
    let stiffness = StoreyStiffness::at_centre(
        STIFFNESS_KIP_IN,
        1e2 * STIFFNESS_KIP_IN,
        1e6 * STIFFNESS_KIP_IN,
        [0.0; 2],
    );
    let storey = Storey {
        height_m: 144.0,
        stiffness,
    };
    let building = Building::new(vec![floor; 5], vec![storey; 5], PDelta::LeftOut)?;
    let vibrating = VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.05]), Vec::new())?;
    let along_x = vibrating
        .modes()
        .modes
        .iter()
        .filter(|mode| mode.energy_shares[0] > 0.5);
    let mut cases: Vec<Case> = along_x
        .zip(PERIODS_S)
        .enumerate()
        .map(|(j, (mode, published))| Case {
            source: SOURCE,
            what: format!("section 13.8.2: period {} of five storeys", j + 1),
            unit: "s",
            published,
            computed: mode.period_s(),
            tolerance: 0.6e-5,
            corrected: None,
            note: "",
        })
        .collect();
    let motion = el_centro()?;
    let read = |period_s: f64, zeta: f64| -> Result<[f64; 2], ValidationError> {
        let ordinate = response_spectrum(&motion, Component::X, &[period_s], zeta)?;
        Ok([
            ordinate
                .first()
                .map_or(f64::NAN, |o| o.pseudo_acceleration_m_s2()),
            0.0,
        ])
    };
    let analysis = spectral_analysis(&vibrating, read)?;
    let mut shear = vec![0.0; vibrating.building().coordinates()];
    shear[0] = STIFFNESS_KIP_IN;
    let mut force = |what: &str, published: f64, computed: f64, note| {
        cases.push(Case {
            source: SOURCE,
            what: format!("section 13.8.2: base shear of five storeys under El Centro, {what}"),
            unit: "kip",
            published,
            computed,
            tolerance: 2e-4 * published,
            corrected: None,
            note,
        });
    };
    for (what, modal, published) in [
        ("absolute sum", ModalCombination::AbsoluteSum, 98.32),
        ("SRSS", ModalCombination::Srss, 65.99),
        ("CQC", ModalCombination::Cqc, 66.43),
    ] {
        let computed = analysis.largest(&shear, modal, DirectionalCombination::XAlone);
        force(what, published, computed, FORCES);
    }
    let history = building_history(
        &vibrating,
        &motion,
        &BuildingRun {
            steps_per_sample: CUT,
            end_s: None,
            ..BuildingRun::default()
        },
    )?;
    force(
        "in time",
        73.15,
        history.peaks.base_shear_n[0].value.abs(),
        HISTORY,
    );
    cases.push(Case {
        source: SOURCE,
        what: "eq. 13.7.10: correlation of modes at a frequency ratio of 0.8".into(),
        unit: "",
        published: 0.083_974_9,
        computed: correlation_coefficient([0.8, 0.02], [1.0, 0.05]),
        tolerance: 0.5e-7,
        corrected: None,
        note: CORRELATION,
    });
    Ok(cases)
}
