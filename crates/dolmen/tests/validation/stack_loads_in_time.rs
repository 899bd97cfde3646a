// SOURCE     W b/2 = F h + m a h/2; K u = W + F.
// GOAL       Static loads have the same effect in time as at rest, under the springs and the rigid law, and energy balances.
// PARAMETERS a block of 0.4 × 2 m on stiff springs; a force takes half of its edge moment; the ground accelerates slowly, in both
//            directions.
// TOLERANCE  10 % of the acceleration on either side of the limit, because the springs yield at the edge. 1e-8 of the settlement.

use crate::stack_loads::{DENSITY_KG_M3, GRAVITY_M_S2, boxes, near};
use dolmen::blocks::{ContactLaw, Outcome, Rigid, Springs, simulate_springs, simulate_stack};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{JointMaterial, StaticLoad};

/// Acceleration along x over gravity; it grows for a second and then stays constant.
fn slowly(peak_g: f64) -> GroundMotion {
    let step_s = 0.01;
    let along = (0..301).map(|i| peak_g * GRAVITY_M_S2 * (f64::from(i) * step_s).min(1.0));
    GroundMotion::new("slowly", step_s, vec![(Component::X, along.collect())]).unwrap()
}

#[test]
fn exact_a_block_with_a_static_load_lifts_where_both_together_reach_its_edge_under_both_laws() {
    // W b/2 = F h + m a h/2: if F at the top takes half of the edge moment, a = 0.5 g b/h in the direction of the load
    let (b, h) = (0.4, 2.0);
    let weight = DENSITY_KG_M3 * GRAVITY_M_S2 * b * b * h;
    let load = StaticLoad {
        block: 0,
        position_m: [0.0, 0.0, h],
        force_n: [0.5 * weight * b / 2.0 / h, 0.0, 0.0],
    };
    let stiff = JointMaterial {
        normal_stiffness_pa_m: 1e11,
        shear_stiffness_pa_m: 4e10,
        ..JointMaterial::with_friction(2.0)
    };
    let stack = boxes(&[([b, b, h], [0.0; 3])], 2.0)
        .with_material(0, stiff)
        .unwrap();
    let stack = stack.with_static_load(load).unwrap();
    let springs = ContactLaw::Springs(Springs::default());
    let rigid = ContactLaw::Rigid(Rigid::default());
    for law in [&springs, &rigid] {
        for (share, towards, opens) in [
            (0.9, -1.0, false),
            (1.1, -1.0, true),
            (1.4, 1.0, false),
            (1.6, 1.0, true),
        ] {
            // the ground accelerates against the load, so that inertia adds to it
            let of = match towards < 0.0 {
                true => 0.5 * share * b / h,
                false => share * b / h,
            };
            let motion = slowly(towards * of);
            let history = simulate_stack(&stack, Some(&motion), law, &mut |_| true).unwrap();
            let stood = history.outcome == Outcome::Stood;
            assert_eq!(
                stood, !opens,
                "{share} {towards}: {:?} {:?}",
                history.outcome, law
            );
        }
    }
}

#[test]
fn exact_a_static_load_settles_a_block_on_its_springs_and_its_energy_balances() {
    let (b, h, down) = (0.5, 1.0, 30e3);
    let stack = boxes(&[([b, b, h], [0.0; 3])], 0.7);
    let load = StaticLoad {
        block: 0,
        position_m: [0.0, 0.0, h],
        force_n: [0.0, 0.0, -down],
    };
    let stack = stack.with_static_load(load).unwrap();
    let motion = slowly(0.05);
    let history = simulate_springs(&stack, Some(&motion), &Springs::default(), &mut |_| true).unwrap();
    let weight = DENSITY_KG_M3 * GRAVITY_M_S2 * b * b * h;
    near(history.settlement_m, (weight + down) / (1e9 * b * b), 1e-8);
    let most = history
        .energy
        .iter()
        .map(|energy| energy.input_j.abs())
        .fold(0.0, f64::max);
    for energy in &history.energy {
        let taken = energy.kinetic_j + energy.potential_j + energy.stored_j + energy.friction_j;
        let left = energy.input_j - taken - energy.damping_j - energy.clipping_j;
        assert!(left.abs() < 1e-3 * most, "{energy:?}");
    }
}
