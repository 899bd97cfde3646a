//! Histories of a building in the wind as CSV: SI units in the column names.

use dolmen_project::strokes_of;
use dolmen_work::building::{InTime, MotionInTime, WindSimulation};
use std::fmt::Write as _;

/// A motion with its name: "along_x_without_dampers".
fn motions(run: &WindSimulation) -> Vec<(String, &MotionInTime)> {
    let mut all = Vec::new();
    for (along, axis) in run.along.iter().zip(["x", "y"]) {
        all.push((format!("along_{axis}_without_dampers"), &along.without));
        if let Some(with) = &along.with {
            all.push((format!("along_{axis}_with_dampers"), with));
        }
    }
    all
}

/// Every value of a motion with its name.
fn values<'a>(run: &WindSimulation, motion: &'a MotionInTime) -> Vec<(String, &'a InTime)> {
    let mut all = vec![("top_displacement_m".to_owned(), &motion.top_displacement_m)];
    let drifts = motion.drifts_m.iter().enumerate();
    all.extend(drifts.map(|(i, drift)| (format!("edge_drift_{}_m", i + 1), drift)));
    all.push(("top_acceleration_m_s2".to_owned(), &motion.top_acceleration_m_s2));
    all.push(("corner_m_s2".to_owned(), &motion.corner_m_s2));
    all.push(("base_shear_n".to_owned(), &motion.base_shear_n));
    all.push(("base_torque_n_m".to_owned(), &motion.base_torque_n_m));
    let strokes = strokes_of(&run.dampers).into_iter().zip(&motion.strokes_m);
    all.extend(
        strokes.map(|(of, stroke)| (format!("damper_{}_stroke_m", of.name.replace(' ', "_")), stroke)),
    );
    all
}

/// The first history: one row per step, the wind along x and along y side by side.
pub fn wind_histories_csv(run: &WindSimulation) -> String {
    let mut out = "time_s".to_owned();
    let mut columns: Vec<&[f64]> = Vec::new();
    for (of, motion) in motions(run) {
        for (name, value) in values(run, motion) {
            let _ = write!(out, ",{of}_{name}");
            columns.push(&value.first);
        }
    }
    out.push('\n');
    let steps = columns.iter().map(|column| column.len()).min().unwrap_or(0);
    for step in 0..steps {
        let _ = write!(out, "{}", step as f64 * run.time_step_s);
        for column in &columns {
            let _ = write!(out, ",{}", column[step]);
        }
        out.push('\n');
    }
    out
}

/// The largest size of each value in each history: one row per value and seed.
pub fn wind_peaks_csv(run: &WindSimulation) -> String {
    let mut out = "wind,value,seed,peak\n".to_owned();
    for (of, motion) in motions(run) {
        for (name, value) in values(run, motion) {
            for (seed, peak) in run.seeds.iter().zip(&value.peaks) {
                let _ = writeln!(out, "{of},{name},{seed},{peak}");
            }
        }
    }
    out
}
