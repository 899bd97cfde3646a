// SOURCE     equilibrium and energy
// GOAL       Loose stones come to rest on the ground, not in it, and create no energy; the same under both contact laws.
// PARAMETERS bumpy stones made by noise on icospheres (bumpy_rubble.rs): 320 facets, radii 0.12 to 0.35 m, bumps of 5 %
// TOLERANCE  1 mm: springs of 1e11 Pa/m deform by less under such a stone; a thousandth of the height lost as energy

use super::bumpy_rubble::{loose, rubble};
use dolmen::blocks::{ContactLaw, LooseEnding, Rigid, SettledStones, Springs, settle_loose};
use dolmen::structure::stack::{JointMaterial, Stack};
use glam::{DQuat, DVec3};

fn laws() -> [ContactLaw; 2] {
    [
        ContactLaw::Springs(Springs::default()),
        ContactLaw::Rigid(Rigid::default()),
    ]
}

fn hard() -> JointMaterial {
    JointMaterial {
        normal_stiffness_pa_m: 1e11,
        shear_stiffness_pa_m: 4e10,
        ..JointMaterial::default()
    }
}

/// Height of the lowest corner of a stone at the end, m.
fn lowest_m(stack: &Stack, found: &SettledStones, block: usize) -> f64 {
    let solid = &stack.blocks()[block].solid;
    let pose = found.history.pose(found.history.time_s.len() - 1, block);
    let [w, x, y, z] = pose.rotation;
    let turn = DQuat::from_xyzw(x, y, z, w);
    let corners = solid.vertices_m().iter();
    let heights = corners
        .map(|at| (turn * (DVec3::from(*at) - DVec3::from(solid.centroid_m()))).z + pose.centroid_m[2]);
    heights.fold(f64::INFINITY, f64::min)
}

#[test]
fn holds_a_boulder_comes_to_rest_on_the_ground_and_not_in_it() {
    for seed in 0..3 {
        let stack = loose(&rubble(seed, 0.05, 1e-3, 2)[..1], hard()).unwrap();
        for law in laws() {
            let found = settle_loose(&stack, &law, &mut |_| true).unwrap();
            let name = law.name();
            assert!(
                matches!(found.ending, LooseEnding::Stood | LooseEnding::Fell),
                "{seed} {name}: {:?}",
                found.ending
            );
            assert!(found.end_s() < 60.0, "{seed} {name}: {}", found.end_s());
            let low = lowest_m(&stack, &found, 0);
            assert!(low.abs() < 1e-3, "{seed} {name}: {low}");
            let made = found.history.energy_made_ratio();
            assert!(made < 1e-3, "{seed} {name}: {made}");
        }
    }
}
