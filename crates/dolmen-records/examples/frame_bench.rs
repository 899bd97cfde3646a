//! Frames with dry friction under El Centro 1940 NS: CPU time of the loop and its results, one line per case, for bench/frame.

#![allow(clippy::print_stdout, reason = "a measurement")]

use dolmen::dynamics::{
    FrameLoad, FrameRun, FrictionFrame, StoreyFriction, TimeFunction, ViscousDamping, simulate_frame,
};
use dolmen::structure::{Convention, Frame, Storey};

/// Runs are repeated for this time and their mean is printed: a hundred ticks of the kernel's clock.
const AT_LEAST_S: f64 = 0.4;

/// CPU seconds of this thread; some kernels update it only at ticks, up to 10 ms apart.
fn cpu_s() -> f64 {
    let stat = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = stat.split(' ').next().and_then(|n| n.parse::<f64>().ok());
    nanoseconds.unwrap_or(f64::NAN) * 1e-9
}

fn storeys(masses_kg: &[f64]) -> Vec<Storey> {
    let storey = |&mass_kg: &f64| Storey {
        mass_kg,
        height_m: 100.0,
        axial_n: 0.0,
    };
    masses_kg.iter().map(storey).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let text = std::fs::read_to_string("data/el_centro_1940_ns/el_centro_1940_ns.csv")?;
    let mut values = Vec::new();
    for line in text.lines().skip(1) {
        let (_, value) = line.split_once(',').ok_or("a line without a comma")?;
        values.push(9.81 * value.parse::<f64>()?);
    }
    let load = FrameLoad::of_ground(TimeFunction::Sampled {
        time_step_s: 0.02,
        values,
    });
    let gate = FrictionFrame::new(
        Frame::new(storeys(&[290e3, 314e3]), Convention::Drift)?,
        vec![184_170_010.214_826_73, 16_447_964.437_896_422],
        [5919e3, 3077e3]
            .map(|n| StoreyFriction::coulomb(0.03 * n))
            .to_vec(),
    )?;
    let n = 20;
    let tower = FrictionFrame::new(
        Frame::new(storeys(&vec![200e3; n]), Convention::Drift)?,
        (0..n).map(|i| 3e8 - 1e7 * i as f64).collect(),
        (0..n)
            .map(|i| StoreyFriction::coulomb(0.01 * 9.81 * 200e3 * (n - i) as f64))
            .collect(),
    )?;
    let damped = tower.clone().with_damping(ViscousDamping::Rayleigh {
        mass_per_s: 0.05,
        stiffness_s: 0.002,
    })?;
    let options = FrameRun {
        duration_s: Some(40.0),
        ..FrameRun::default()
    };
    for (name, frame) in [
        ("two_storeys", gate),
        ("twenty_storeys", tower),
        ("twenty_damped", damped),
    ] {
        let mut line = String::new();
        let (mut runs, mut taken_s) = (0, 0.0);
        let before = cpu_s();
        while runs < 5 || taken_s < AT_LEAST_S {
            let history = simulate_frame(&frame, &load, &options, &mut |_| true)?;
            taken_s = cpu_s() - before;
            runs += 1;
            let roof = history.displacement_peaks.last().ok_or("no storeys")?;
            line = format!(
                "peak_mm={:.6} residual_mm={:.8} events={} steps={} energy_left={:.1e}",
                1e3 * roof.value_m.abs(),
                1e3 * history.residual_m.last().ok_or("no storeys")?,
                history.events,
                history.steps,
                history.energy_left_over_ratio()
            );
        }
        println!("{name} loop_cpu_s={:.6} {line}", taken_s / f64::from(runs));
    }
    Ok(())
}
