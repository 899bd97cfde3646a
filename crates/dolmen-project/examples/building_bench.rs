//! Twenty storeys with a tuned mass through El Centro 1940 NS: the loop's CPU time, for bench/building.

#![allow(clippy::print_stdout, reason = "a measurement")]

use dolmen::dynamics::{BuildingRun, Histories, building_history};
use dolmen::signal::{Component, GroundMotion};
use dolmen_project::{Quantity, Structure, parse_project};

/// Runs are repeated for so long and their mean is given.
const AT_LEAST_S: f64 = 0.4;

/// Processor seconds of this thread, as the kernel counts them.
fn cpu_s() -> f64 {
    let stat = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = stat.split(' ').next().and_then(|n| n.parse::<f64>().ok());
    nanoseconds.unwrap_or(f64::NAN) * 1e-9
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let text = std::fs::read_to_string("data/el_centro_1940_ns/el_centro_1940_ns.csv")?;
    let mut values = Vec::new();
    for line in text.lines().skip(1) {
        let (_, value) = line.split_once(',').ok_or("a line without a comma")?;
        values.push(9.80665 * value.parse::<f64>()?);
    }
    let motion = GroundMotion::new("El Centro", 0.02, vec![(Component::Y, values)])?;
    let project = parse_project(
        &std::fs::read_to_string("bench/building/project.toml")?,
        "project.toml",
    )?;
    let Structure::Building(part) = &project.structure else {
        return Err("no building".into());
    };
    let alone = part.as_written().ok_or("it falls under its weight")?;
    let dampers = part.dampers(alone, &mut Quantity::nominal)?;
    let masses: Option<Vec<_>> = dampers.iter().map(|damper| damper.tuned_mass()).collect();
    let vibrating = alone
        .clone()
        .with_tuned_masses(masses.ok_or("not all dampers are masses")?)?;
    let run = BuildingRun {
        steps_per_sample: 4,
        end_s: Some(40.0),
        histories: Histories::PeaksAlone,
        ..BuildingRun::default()
    };
    let (start, mut runs, mut top) = (cpu_s(), 0, 0.0);
    while runs == 0 || cpu_s() - start < AT_LEAST_S {
        let history = building_history(&vibrating, &motion, &run)?;
        top = history
            .peaks
            .floors
            .last()
            .map_or(f64::NAN, |floor| floor.displacement_y_m.value);
        runs += 1;
    }
    let loop_s = (cpu_s() - start) / f64::from(runs);
    println!("dolmen y_mm={:.5} loop_s={loop_s:.6}", 1e3 * top.abs());
    Ok(())
}
