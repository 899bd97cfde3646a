//! Histories as CSV: one row per sample, SI units in the column names.

use dolmen::blocks::StackHistory;
use dolmen::structure::stack::Stack;
use dolmen_work::stack::{StackSimulation, SupportsRun, SupportsSimulation};
use std::fmt::Write as _;

/// Any name as one field of CSV.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Opening, slip and yaw of each joint over time.
pub fn joints_csv(simulation: &StackSimulation) -> String {
    let history = &simulation.history;
    let mut out = String::from("time_s");
    for joint in 0..history.joints.len() {
        let [upper, lower] = simulation.joint_names(joint);
        let name = format!("{upper} on {lower}");
        for what in ["opening_m", "slip_1_m", "slip_2_m", "yaw_rad"] {
            let _ = write!(out, ",{}", field(&format!("{name}: {what}")));
        }
    }
    out.push('\n');
    for (sample, time_s) in history.time_s.iter().enumerate() {
        let _ = write!(out, "{time_s}");
        for joint in &history.joints {
            let (opening, slip, yaw) = (
                joint.opening_m[sample],
                joint.slip_m[sample],
                joint.yaw_rad[sample],
            );
            let _ = write!(out, ",{opening:e},{:e},{:e},{yaw:e}", slip[0], slip[1]);
        }
        out.push('\n');
    }
    out
}

/// Position and rotation of each block over time, relative to the ground.
pub fn poses_csv(simulation: &StackSimulation) -> String {
    poses_of(&simulation.stack, &simulation.history)
}

fn poses_of(stack: &Stack, history: &StackHistory) -> String {
    let mut out = String::from("time_s");
    for block in stack.blocks() {
        for what in ["x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"] {
            let _ = write!(out, ",{}", field(&format!("{}: {what}", block.name)));
        }
    }
    out.push('\n');
    for (sample, time_s) in history.time_s.iter().enumerate() {
        let _ = write!(out, "{time_s}");
        for block in 0..history.blocks {
            let pose = history.pose(sample, block);
            for value in pose.centroid_m.iter().chain(&pose.rotation) {
                let _ = write!(out, ",{value}");
            }
        }
        out.push('\n');
    }
    out
}

/// Displacement of the supports over time: the factor on the movements, and the displacement of the one that moves farthest; then position
/// and rotation of each block.
pub(crate) fn supports_csv(of: &SupportsSimulation, run: &SupportsRun) -> String {
    let rows = poses_of(&of.stack, &run.moved.history);
    let mut out = String::new();
    for (line, row) in rows.lines().enumerate() {
        match line
            .checked_sub(1)
            .and_then(|sample| run.moved.history.time_s.get(sample))
        {
            None => out += "factor,support_movement_m",
            Some(time_s) => {
                let factor = run.moved.slow.ground.factor_at(*time_s);
                let _ = write!(out, "{factor},{}", of.length_m(factor));
            }
        }
        let _ = writeln!(out, ",{row}");
    }
    out
}

/// The energy balance over time, J.
pub fn energy_csv(simulation: &StackSimulation) -> String {
    let mut out =
        String::from("time_s,kinetic_j,potential_j,stored_j,input_j,friction_j,damping_j,clipping_j\n");
    let history = &simulation.history;
    for (time_s, e) in history.time_s.iter().zip(&history.energy) {
        let _ = writeln!(
            out,
            "{time_s},{:e},{:e},{:e},{:e},{:e},{:e},{:e}",
            e.kinetic_j, e.potential_j, e.stored_j, e.input_j, e.friction_j, e.damping_j, e.clipping_j
        );
    }
    out
}
