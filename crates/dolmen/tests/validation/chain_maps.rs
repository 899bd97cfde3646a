// SOURCE     Den Hartog (1931): forced vibration with dry friction; the linear oscillator.
// GOAL       Maps of a chain over frequency and amplitude of a harmonic ground motion give its steady state, and the end of a run is
//            never guessed.
//
//        /θ     I θ'' + d θ' + (k − G) θ + q = −Γ a sin ωt,  |q| ≤ f;   I = m (L²/12 + c²), Γ = m c, G = Γ g
//     ==o==
//
// TOLERANCE  1e-6: with a damping ratio of 20 % the transient has decayed to e^-50 after 40 cycles, and the cubic between 40 samples
//            per cycle is accurate to 2e-6 of the peak; shares of time 1e-9.

use dolmen::dynamics::{
    ChainJoint, ChainModel, ChainOutcome, ChainRotations, ChainRun, JointFriction, JointOpening,
    TimeFunction, chain_harmonic_map, simulate_chain,
};
use dolmen::known::dry_friction::forced_amplitude;
use dolmen::structure::{Chain, Inertia, Link};
use std::f64::consts::TAU;

const G: f64 = 9.81;
const MASS_KG: f64 = 800.0;
const LENGTH_M: f64 = 2.0;
const CENTROID_M: f64 = 0.9;
/// Γ, I and G of the link.
const GAMMA: f64 = MASS_KG * CENTROID_M;
const INERTIA: f64 = MASS_KG * (LENGTH_M * LENGTH_M / 12.0 + CENTROID_M * CENTROID_M);
const WEIGHT: f64 = GAMMA * G;
/// k, three times the stiffness reduction by gravity.
const STIFFNESS: f64 = 3.0 * WEIGHT;

fn shaft(joint: ChainJoint) -> ChainModel {
    let link = Link {
        mass_kg: MASS_KG,
        length_m: LENGTH_M,
        centroid_m: CENTROID_M,
        inertia: Inertia::ThinRod,
        bed_width_m: Some(0.5),
    };
    let chain = Chain::new(vec![link], G).unwrap();
    ChainModel::new(chain, vec![joint], ChainRotations::Small).unwrap()
}

/// ω of the link, rad/s.
fn own_rad_s() -> f64 {
    ((STIFFNESS - WEIGHT) / INERTIA).sqrt()
}

#[test]
fn exact_map_of_a_damped_shaft() {
    let own = own_rad_s();
    let dashpot = 2.0 * 0.2 * own * INERTIA;
    let model = shaft(ChainJoint {
        damping_n_m_s_rad: dashpot,
        ..ChainJoint::spring(STIFFNESS)
    });
    let (frequencies, accelerations) = ([0.3, 1.0, 2.2].map(|g| g * own / TAU), [0.01, 0.3]);
    let map = chain_harmonic_map(&model, &frequencies, &accelerations, &mut |_| true).unwrap();
    assert_eq!(map.len(), 6);
    for point in &map {
        let omega = TAU * point.frequency_hz;
        let dynamic = (STIFFNESS - WEIGHT - omega * omega * INERTIA).hypot(omega * dashpot);
        let wanted = GAMMA * point.ground_acceleration_m_s2 / dynamic;
        let off = (point.deformation[0] / wanted - 1.0).abs();
        assert!(
            off < 2e-6 && point.steady && !point.fell,
            "{off:e} {point:?} {wanted}"
        );
        assert_eq!(point.moving_share, [0.0]);
    }
}

#[test]
fn exact_map_of_sticking_and_turning_against_friction() {
    let acceleration = 0.4;
    let model = shaft(ChainJoint {
        friction: JointFriction::coulomb(0.3 * GAMMA * acceleration),
        ..ChainJoint::spring(STIFFNESS)
    });
    let frequency_hz = 0.6 * own_rad_s() / TAU;
    let map = chain_harmonic_map(
        &model,
        &[frequency_hz],
        &[0.29 * acceleration, acceleration],
        &mut |_| true,
    )
    .unwrap();
    assert_eq!((map[0].deformation[0], map[0].moving_share[0]), (0.0, 0.0));
    assert!((map[1].moving_share[0] - 1.0).abs() < 1e-9, "{:?}", map[1]);
    let wanted = forced_amplitude(0.6, 0.3).unwrap() * GAMMA * acceleration / (STIFFNESS - WEIGHT);
    let off = (map[1].deformation[0] / wanted - 1.0).abs();
    assert!(off < 1e-3, "{off:e}"); // friction alone lets the free part die out slowly: 3e-4 are left after 40 cycles
}

#[test]
fn holds_the_share_of_opening_is_that_of_the_run() {
    // strong enough to open the bed in each cycle; damped, so that it neither falls nor drifts
    let model = shaft(ChainJoint {
        damping_n_m_s_rad: 2.0 * 0.2 * own_rad_s() * INERTIA,
        opening: JointOpening::AtBedEdge,
        ..ChainJoint::spring(20.0 * WEIGHT)
    });
    let (frequency_hz, acceleration) = (1.5, 3.0);
    let map = chain_harmonic_map(&model, &[frequency_hz], &[acceleration], &mut |_| true).unwrap();
    let point = &map[0];
    assert!(point.steady && !point.fell, "{point:?}");
    // the same for the last ten cycles of a run with twice as many
    let load = TimeFunction::Harmonic {
        amplitude: acceleration,
        frequency_hz,
        phase_rad: 0.0,
    };
    let (from_s, to_s) = (80.0 / frequency_hz, 90.0 / frequency_hz);
    let options = ChainRun {
        duration_s: Some(to_s),
        ..ChainRun::default()
    };
    let history = simulate_chain(&model, &load, &options, &mut |_| true).unwrap();
    let open_s: f64 = history
        .uplifts
        .iter()
        .map(|open| (open.to_s.min(to_s) - open.from_s.max(from_s)).max(0.0))
        .sum();
    let share = open_s / (to_s - from_s);
    assert!(share > 0.05 && share < 0.95, "{share}");
    assert!(
        (point.moving_share[0] - share).abs() < 1e-6,
        "{} {share}",
        point.moving_share[0]
    );
}

#[test]
fn holds_a_run_that_ends_on_the_way_down_is_no_verdict() {
    // half of the critical stiffness: the link falls by itself, from 1e-3 rad, as cosh with rate sqrt((G − k)/I)
    let model = shaft(ChainJoint::spring(0.5 * WEIGHT));
    let rate = (0.5 * WEIGHT / INERTIA).sqrt();
    let run = |duration_s: f64, start_rad: f64, model: &ChainModel| {
        let options = ChainRun {
            duration_s: Some(duration_s),
            start_rotation_rad: vec![start_rad],
            ..ChainRun::default()
        };
        simulate_chain(model, &TimeFunction::Zero, &options, &mut |_| true)
            .unwrap()
            .outcome
    };
    let falls_s = (std::f64::consts::FRAC_PI_3 / 1e-3).acosh() / rate;
    let ended = run(0.9 * falls_s, 1e-3, &model);
    assert!(
        matches!(ended, ChainOutcome::StillLeaning { link: 0, at_s } if (at_s - 0.9 * falls_s).abs() < 1e-9),
        "{ended:?}"
    );
    let ended = run(1.1 * falls_s, 1e-3, &model);
    assert!(
        matches!(ended, ChainOutcome::Fell { link: 0, at_s } if (at_s / falls_s - 1.0).abs() < 1e-9),
        "{ended:?}"
    );
    // an oscillating link leans outwards half of the time, as far as it did before
    let stands = shaft(ChainJoint::spring(STIFFNESS));
    for part in [0.6, 0.7, 1.3, 2.9, 7.45] {
        let ended = run(part * TAU / own_rad_s(), 1e-3, &stands);
        assert_eq!(ended, ChainOutcome::Stood, "{part}");
    }
}
