// SOURCE     equilibrium and energy
// GOAL       Loose stones come to rest on the ground, not in it, and create no energy; the same under both contact laws.
// PARAMETERS bumpy stones made by noise on icospheres (bumpy_rubble.rs): 320 facets, radii 0.12 to 0.35 m, bumps of 5 %
// TOLERANCE  1 mm: springs of 1e11 Pa/m deform by less under such a stone; a thousandth of the height lost as energy

use super::bumpy_rubble::{loose, rubble};
use dolmen::blocks::{ContactLaw, LooseEnding, LooseStones, Rigid, Springs, settle_loose};
use dolmen::structure::stack::JointMaterial;

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
fn lowest_m(found: &LooseStones, block: usize) -> f64 {
    found.stack.blocks()[block].solid.bounds_m()[0][2]
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
            let low = lowest_m(&found, 0);
            assert!(low.abs() < 1e-3, "{seed} {name}: {low}");
            let made = found.energy_made_ratio();
            assert!(made < 1e-3, "{seed} {name}: {made}");
        }
    }
}
