//! A simulated motion of a chain: what the ground did, how the links leaned, loops of moment and rotation, openings, slips, energy.

use super::Figure;
use super::frame_histories::{ground, loops, rows_of_bands};
use super::stack_histories::{Series, plot};
use dolmen::dynamics::ChainEnergy;
use dolmen_words::Language;
use dolmen_work::chain::ChainSimulation;

/// The figures of a simulation: ground, rotations, one loop a joint, bands of opening and slipping, energy.
pub fn chain_histories(simulation: &ChainSimulation, language: Language) -> Vec<Figure> {
    let mut figures = Vec::new();
    let mut add = |name: String, svg: Option<String>| {
        if let Some(svg) = svg {
            figures.push(Figure { name, svg });
        }
    };
    let history = &simulation.history;
    let over_time = |values: &[f64], factor: f64| -> Vec<[f64; 2]> {
        let pairs = history.times_s.iter().zip(values);
        pairs.map(|(t, y)| [*t, factor * y]).collect()
    };
    if let Some((motion, component)) = &simulation.motion {
        let ground = ground(&motion.motion, *component);
        let title = language.pick("Acceleration of the ground", "지반 가속도");
        let name = language.pick("Acceleration (g)", "가속도 (g)");
        add("ground".to_owned(), plot(&[ground], name, language, title));
    }
    let links: Vec<Series> = (0..simulation.links.len())
        .map(|link| Series {
            name: simulation.link(link).to_owned(),
            points: over_time(&history.rotation_rad[link], 1e3),
        })
        .collect();
    let title = language.pick(
        "Rotation of the links from the vertical",
        "각 부재의 연직 기준 회전각",
    );
    let name = language.pick("Rotation (mrad)", "회전각 (mrad)");
    add("rotations".to_owned(), plot(&links, name, language, title));
    for joint in 0..simulation.links.len() {
        let across: Vec<f64> = history.across_rad(joint).iter().map(|x| 1e3 * x).collect();
        let moment: Vec<f64> = history.joint_moment_n_m[joint].iter().map(|x| 1e-3 * x).collect();
        let names = [
            language.pick("Rotation across the joint (mrad)", "접합면 회전각 (mrad)"),
            language.pick("Moment (kN·m)", "모멘트 (kN·m)"),
        ];
        let title = language.pick("Moment against rotation", "모멘트-회전각 이력곡선");
        let svg = loops(names, [&across, &moment], (joint, simulation.link(joint)), title);
        add(format!("loop-{}", joint + 1), Some(svg));
    }
    let end_s = simulation.duration_s();
    if !history.uplifts.is_empty() {
        let open: Vec<_> = history
            .uplifts
            .iter()
            .map(|u| (u.joint, [u.from_s, u.to_s]))
            .collect();
        let words = [
            language.pick("open", "벌어짐"),
            language.pick(
                "When the joint below each link was open",
                "부재 아래 접합면이 벌어진 시각",
            ),
        ];
        let svg = rows_of_bands(&simulation.links, &open, end_s, words, language);
        add("openings".to_owned(), Some(svg));
    }
    if !history.slips.is_empty() {
        let slips: Vec<_> = history
            .slips
            .iter()
            .map(|s| (s.joint, [s.from_s, s.to_s]))
            .collect();
        let words = [
            language.pick("turns", "회전"),
            language.pick(
                "When the joint below each link turned against its friction",
                "부재 아래 접합면이 마찰을 이기고 회전한 시각",
            ),
        ];
        let svg = rows_of_bands(&simulation.links, &slips, end_s, words, language);
        add("slips".to_owned(), Some(svg));
    }
    add("energy".to_owned(), energy(simulation, language));
    figures
}

fn energy(simulation: &ChainSimulation, language: Language) -> Option<String> {
    let history = &simulation.history;
    let part = |name: &str, value: fn(&ChainEnergy) -> f64| Series {
        name: name.to_owned(),
        points: history
            .times_s
            .iter()
            .zip(&history.energy)
            .map(|(t, energy)| [*t, 1e-3 * value(energy)])
            .collect(),
    };
    let mut parts = vec![
        part(language.pick("put in", "입력"), |e| e.input_j),
        part(language.pick("taken by dashpots", "점성 소산"), |e| {
            e.damping_j
        }),
        part(
            language.pick("moving, in springs and weight", "운동·탄성·위치"),
            |e| e.kinetic_j + e.springs_j + e.gravity_j,
        ),
    ];
    if simulation.model.has_friction() {
        parts.push(part(language.pick("taken by friction", "마찰 소산"), |e| {
            e.friction_j
        }));
    }
    let name = language.pick("Energy (kJ)", "에너지 (kJ)");
    let title = language.pick("Where the energy went", "에너지 수지");
    plot(&parts, name, language, title)
}
