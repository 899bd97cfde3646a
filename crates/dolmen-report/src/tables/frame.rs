//! Histories of a frame as CSV: one row per sample, SI units in the column names; slips one per row.

use dolmen_work::frame::FrameSimulation;
use std::fmt::Write as _;

/// Displacement, velocity and absolute acceleration of each level, drift and forces of each storey.
pub fn frame_histories_csv(simulation: &FrameSimulation) -> String {
    let history = &simulation.history;
    let levels = history.displacement_m.len();
    let mut out = String::from("time_s");
    for level in 1..=levels {
        let _ = write!(
            out,
            ",level_{level}_displacement_m,level_{level}_velocity_m_s,level_{level}_acceleration_m_s2"
        );
    }
    for storey in 1..=levels {
        let _ = write!(
            out,
            ",storey_{storey}_drift_m,storey_{storey}_force_n,storey_{storey}_friction_force_n"
        );
    }
    out.push('\n');
    let drifts: Vec<Vec<f64>> = (0..levels).map(|i| history.drift_m(i)).collect();
    let forces: Vec<Vec<f64>> = (0..levels).map(|i| simulation.storey_force_n(i)).collect();
    for (sample, time) in history.time_s.iter().enumerate() {
        let _ = write!(out, "{time}");
        for level in 0..levels {
            let _ = write!(
                out,
                ",{},{},{}",
                history.displacement_m[level][sample],
                history.velocity_m_s[level][sample],
                history.acceleration_m_s2[level][sample]
            );
        }
        for storey in 0..levels {
            let _ = write!(
                out,
                ",{},{},{}",
                drifts[storey][sample], forces[storey][sample], history.friction_force_n[storey][sample]
            );
        }
        out.push('\n');
    }
    out
}

/// Times in which sliders slipped.
pub fn frame_slips_csv(simulation: &FrameSimulation) -> String {
    let mut out = String::from("storey,from_s,to_s,slip_m\n");
    for slip in &simulation.history.slips {
        let _ = writeln!(
            out,
            "{},{},{},{}",
            slip.storey + 1,
            slip.from_s,
            slip.to_s,
            slip.slip_m
        );
    }
    out
}

/// Balance of energy.
pub fn frame_energy_csv(simulation: &FrameSimulation) -> String {
    let mut out = String::from("time_s,input_j,kinetic_j,stored_j,friction_j,damping_j,left_over_j\n");
    let history = &simulation.history;
    for (time, energy) in history.time_s.iter().zip(&history.energy) {
        let _ = writeln!(
            out,
            "{time},{},{},{},{},{},{}",
            energy.input_j,
            energy.kinetic_j,
            energy.stored_j,
            energy.friction_j,
            energy.damping_j,
            energy.left_over_j()
        );
    }
    out
}
