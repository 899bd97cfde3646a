//! Single blocks that rock, under every motion of a folder scaled step by step: the table of `docs/fragility.md`.
//!
//! `single_block_ida [FOLDER]`: files of two columns, seconds and g, as `scripts/data --far-field` writes them; default
//! `data/cache/far-field`.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::disallowed_methods,
    reason = "a measurement that fails loudly and reads its own files"
)]

use dolmen::assess::{Observation, ScaleTrial, Trial, capacity, fit_fragility, next_in_bracket};
use dolmen::dynamics::{Rocking, RockingBlock, RockingOutcome, TimeFunction, rock_block};
use dolmen::signal::{Component, GroundMotion, intensity_measures};

const GRAVITY_M_S2: f64 = 9.81;
/// The scan: from the acceleration at which the block lifts off in steps of a tenth of it, to this many times.
const STEPS: u32 = 200;
const STEP: f64 = 0.1;
const HALVINGS: u32 = 6;

fn main() {
    let folder = std::env::args().nth(1).unwrap_or("data/cache/far-field".into());
    let motions = read(&folder);
    println!(
        "{} motions of {folder}; θ by the likeliest lognormal curve",
        motions.len()
    );
    println!("block          fell  θ of PGA  β      θ of PGV   β      θ of p·PGV/(g tan α)  survived above");
    for (width_m, height_m) in [(0.5, 2.0), (1.0, 3.0)] {
        let block = RockingBlock::rectangle(width_m, height_m, GRAVITY_M_S2).unwrap();
        let (mut pga, mut pgv, mut above) = (Vec::new(), Vec::new(), 0);
        for motion in &motions {
            let measures = intensity_measures(motion, Component::X).unwrap();
            let lift_off = block.slenderness_rad.tan() * GRAVITY_M_S2 / measures.peak_acceleration_m_s2;
            let found = scan(&block, motion, lift_off);
            above += usize::from(!found.survived_above.is_empty());
            let seen = |measure: f64| match found.first_fall {
                Some(scale) => Observation::Between(found.survived_below * measure, scale * measure),
                None => Observation::Above(found.largest_tried * measure),
            };
            pga.push(seen(measures.peak_acceleration_m_s2 / GRAVITY_M_S2));
            pgv.push(seen(measures.peak_velocity_m_s));
        }
        let by_pga = fit_fragility(&pga).unwrap();
        let by_pgv = fit_fragility(&pgv).unwrap();
        let normalised = block.frequency_parameter_rad_s / (GRAVITY_M_S2 * block.slenderness_rad.tan());
        println!(
            "{width_m} × {height_m} m   {:3}   {:.3} g  {:.3}  {:.3} m/s  {:.3}  {:.3}                 {above} of {}",
            by_pga.reached,
            by_pga.curve.theta(),
            by_pga.curve.beta(),
            by_pgv.curve.theta(),
            by_pgv.curve.beta(),
            by_pgv.curve.theta() * normalised,
            motions.len()
        );
    }
}

/// The first overturning of a block, every step of the scan tried and its bracket halved.
fn scan(block: &RockingBlock, motion: &GroundMotion, lift_off: f64) -> dolmen::assess::Capacity {
    let run = |scale: f64| {
        let scaled = motion.clone().scaled(scale).unwrap();
        let ground = TimeFunction::of_motion(&scaled, Component::X);
        let options = Rocking {
            rest_s: 5.0,
            ..Rocking::default()
        };
        let history = rock_block(block, &ground, &TimeFunction::Zero, &options).unwrap();
        let trial = match history.outcome {
            RockingOutcome::Fell { .. } => Trial::Fell,
            RockingOutcome::Stood | RockingOutcome::Rocked => Trial::Survived,
            _ => Trial::Unknown,
        };
        ScaleTrial { scale, trial }
    };
    let grid: Vec<f64> = (0..STEPS)
        .map(|i| lift_off * (1.0 + STEP * f64::from(i)))
        .collect();
    let mut tried: Vec<ScaleTrial> = grid.iter().map(|&scale| run(scale)).collect();
    while let Some(scale) = next_in_bracket(&grid, &tried, HALVINGS).unwrap() {
        tried.push(run(scale));
    }
    capacity(&tried).unwrap()
}

fn read(folder: &str) -> Vec<GroundMotion> {
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .unwrap_or_else(|fault| panic!("{folder}: {fault}; run scripts/data --far-field first"))
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    let motion = |path: &std::path::PathBuf| {
        let text = std::fs::read_to_string(path).unwrap();
        let rows: Vec<(f64, f64)> = text.lines().skip(1).map(pair).collect();
        let step_s = (rows[rows.len() - 1].0 - rows[0].0) / (rows.len() - 1) as f64;
        let ground = rows.iter().map(|row| row.1 * GRAVITY_M_S2).collect();
        GroundMotion::new(path.display().to_string(), step_s, vec![(Component::X, ground)]).unwrap()
    };
    paths.iter().map(motion).collect()
}

fn pair(line: &str) -> (f64, f64) {
    let (time, value) = line.split_once(',').unwrap();
    (time.parse().unwrap(), value.parse().unwrap())
}
