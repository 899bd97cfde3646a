//! Histories of a chain as CSV: one row per sample, SI units in the column names; slips and openings one per row.

use dolmen_work::chain::ChainSimulation;
use std::fmt::Write as _;

/// Rotation and rate of each link; rotation across, moment and friction of each joint.
pub fn chain_histories_csv(simulation: &ChainSimulation) -> String {
    let history = &simulation.history;
    let links = history.rotation_rad.len();
    let mut out = String::from("time_s");
    for link in 1..=links {
        let _ = write!(out, ",link_{link}_rotation_rad,link_{link}_velocity_rad_s");
    }
    for joint in 1..=links {
        let _ = write!(
            out,
            ",joint_{joint}_rotation_rad,joint_{joint}_moment_n_m,joint_{joint}_friction_moment_n_m"
        );
    }
    for support in 1..=history.support_force_n.len() {
        let _ = write!(out, ",support_{support}_force_n");
    }
    out.push('\n');
    let across: Vec<Vec<f64>> = (0..links).map(|joint| history.across_rad(joint)).collect();
    for (sample, time) in history.times_s.iter().enumerate() {
        let _ = write!(out, "{time}");
        for link in 0..links {
            let _ = write!(
                out,
                ",{},{}",
                history.rotation_rad[link][sample], history.velocity_rad_s[link][sample]
            );
        }
        for (joint, across) in across.iter().enumerate() {
            let _ = write!(
                out,
                ",{},{},{}",
                across[sample],
                history.joint_moment_n_m[joint][sample],
                history.friction_moment_n_m[joint][sample]
            );
        }
        for forces in &history.support_force_n {
            let _ = write!(out, ",{}", forces[sample]);
        }
        out.push('\n');
    }
    out
}

/// Times in which joints turned against their friction.
pub fn chain_slips_csv(simulation: &ChainSimulation) -> String {
    let mut out = String::from("joint,from_s,to_s,slip_rad\n");
    for slip in &simulation.history.slips {
        let joint = slip.joint + 1;
        let _ = writeln!(out, "{joint},{},{},{}", slip.from_s, slip.to_s, slip.slip_rad);
    }
    out
}

/// Times in which joints were open.
pub fn chain_uplifts_csv(simulation: &ChainSimulation) -> String {
    let mut out = String::from("joint,from_s,to_s\n");
    for uplift in &simulation.history.uplifts {
        let _ = writeln!(out, "{},{},{}", uplift.joint + 1, uplift.from_s, uplift.to_s);
    }
    out
}

/// Balance of energy.
pub fn chain_energy_csv(simulation: &ChainSimulation) -> String {
    let mut out =
        String::from("time_s,input_j,kinetic_j,gravity_j,springs_j,friction_j,damping_j,left_over_j\n");
    let history = &simulation.history;
    for (time, energy) in history.times_s.iter().zip(&history.energy) {
        let _ = writeln!(
            out,
            "{time},{},{},{},{},{},{},{}",
            energy.input_j,
            energy.kinetic_j,
            energy.gravity_j,
            energy.springs_j,
            energy.friction_j,
            energy.damping_j,
            energy.left_over_j()
        );
    }
    out
}
