//! Bumpy rubble made from seeds, under its own weight by both laws of contact.
//!
//! `cargo run --release -p dolmen --example made_rubble [SEEDS] [BUMPS] [NOISE_MM] [STONES] [TIMES]` prints a row for each seed, of stones of
//! 20 × 4^TIMES triangles.

#![allow(clippy::print_stdout, reason = "a measurement")]

#[path = "../tests/validation/bumpy_rubble.rs"]
mod bumpy_rubble;

use bumpy_rubble::{loose, rubble};
use dolmen::blocks::{ContactLaw, LooseEnding, LooseStones, Rigid, Springs, settle_loose};
use dolmen::structure::stack::JointMaterial;

fn said(found: &LooseStones) -> String {
    let far = found.farthest();
    let stone = &found.stones[far];
    format!(
        "{:?} {:.2} s, stone {} moved {:.1} mm turned {:.1}, left {}, made {:.1e}",
        found.ending,
        found.end_s(),
        far + 1,
        1e3 * stone.moved_m,
        stone.turned_rad.to_degrees(),
        found.left().len(),
        found.energy_made_ratio(),
    )
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |at: usize, usual: f64| words.get(at).and_then(|word| word.parse().ok()).unwrap_or(usual);
    let (seeds, bumps, noise_m) = (number(0, 20.0) as u64, number(1, 0.05), 1e-3 * number(2, 1.0));
    let times = number(4, 1.0) as usize;
    let material = JointMaterial {
        normal_stiffness_pa_m: 1e11,
        shear_stiffness_pa_m: 4e10,
        ..JointMaterial::default()
    };
    for seed in 0..seeds {
        let meshes = rubble(seed, bumps, noise_m, times);
        let count = number(3, 12.0) as usize;
        let stack = match loose(&meshes[..count.min(meshes.len())], material) {
            Ok(stack) => stack,
            Err(why) => {
                println!("{seed} refused: {why}");
                continue;
            }
        };
        let mut endings = Vec::new();
        for law in [
            ContactLaw::Springs(Springs::default()),
            ContactLaw::Rigid(Rigid::default()),
        ] {
            match settle_loose(&stack, &law, &mut |_| true) {
                Ok(found) => {
                    println!("{seed} {}: {}", law.name(), said(&found));
                    endings.push(Some(found.ending));
                }
                Err(why) => {
                    println!("{seed} {}: {why}", law.name());
                    endings.push(None);
                }
            }
        }
        let agree = endings[0] == endings[1] && !endings.contains(&Some(LooseEnding::Unusable));
        println!("{seed} agree {agree}");
    }
}
