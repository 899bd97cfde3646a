//! A simulation as files: histories, figures, films, and what other programs read.

use crate::files;
use anyhow::Result;
use dolmen::blocks::Pose;
use dolmen_records::meshes::{
    BlockPose, SeriesFile, series_pvd, stack_3dec, stack_json, stack_obj, stack_vtu,
};
use dolmen_report::figures::{self, Figure, building_histories, chain_histories, frame_histories};
use dolmen_report::film::stack_film;
use dolmen_report::tables::{
    building_histories_csv, building_peaks_csv, chain_energy_csv, chain_histories_csv, chain_slips_csv,
    chain_uplifts_csv, energy_csv, frame_energy_csv, frame_histories_csv, frame_slips_csv, joints_csv,
    poses_csv,
};
use dolmen_words::Language;
use dolmen_work::simulation::Simulation;
use dolmen_work::stack::StackSimulation;
use serde_json::Value;
use std::path::Path;

/// Time between the files of a series for ParaView, s: 20 a second. Chosen here.
const PARAVIEW_STEP_S: f64 = 0.05;

/// What puts bytes under a name.
type Put<'a> = &'a dyn Fn(&str, &[u8]) -> Result<()>;

/// Everything of a simulation as files; each direction of a frame in a folder of its own.
pub(crate) fn write(simulation: &Simulation, json: &Value, folder: &Path, language: Language) -> Result<()> {
    let folder = match simulation {
        Simulation::Frame(run) => folder.join(&run.direction),
        Simulation::Chain(_) | Simulation::Stack(_) | Simulation::Building(_) => folder.to_owned(),
    };
    files::write_json(&folder.join("simulation.json"), json)?;
    let put = |name: &str, bytes: &[u8]| files::write(&folder.join(name), bytes);
    let figures: Vec<Figure> = match simulation {
        Simulation::Chain(run) => {
            put("histories.csv", chain_histories_csv(run).as_bytes())?;
            put("slips.csv", chain_slips_csv(run).as_bytes())?;
            put("openings.csv", chain_uplifts_csv(run).as_bytes())?;
            put("energy.csv", chain_energy_csv(run).as_bytes())?;
            chain_histories(run, language)
        }
        Simulation::Frame(run) => {
            put("histories.csv", frame_histories_csv(run).as_bytes())?;
            put("slips.csv", frame_slips_csv(run).as_bytes())?;
            put("energy.csv", frame_energy_csv(run).as_bytes())?;
            frame_histories(run, language)
        }
        Simulation::Stack(run) => {
            stack(run, &put)?;
            stack_figures(run, language, &put)?;
            figures::stack_histories(run, language)
        }
        Simulation::Building(run) => {
            put("histories.csv", building_histories_csv(run).as_bytes())?;
            put("peaks.csv", building_peaks_csv(run).as_bytes())?;
            building_histories(run, language)
        }
    };
    files::write_figures(&folder, &figures)
}

fn stack(simulation: &StackSimulation, put: Put<'_>) -> Result<()> {
    put("joints.csv", joints_csv(simulation).as_bytes())?;
    put("poses.csv", poses_csv(simulation).as_bytes())?;
    put("energy.csv", energy_csv(simulation).as_bytes())?;
    put("film.glb", &stack_film(simulation))?;
    let stack = &simulation.stack;
    put("stack.obj", stack_obj(stack).as_bytes())?;
    put("stack.json", stack_json(stack).as_bytes())?;
    put("stack.3ddat", stack_3dec(stack).as_bytes())?;
    paraview(simulation, put)
}

fn stack_figures(simulation: &StackSimulation, language: Language, put: Put<'_>) -> Result<()> {
    put("after.svg", figures::stack_after(simulation, language).as_bytes())?;
    let (limits, peak_g) = (&simulation.limits, Some(simulation.peak_horizontal_g()));
    let governing = figures::stack_governing(limits, peak_g, language);
    put("governing.svg", governing.as_bytes())?;
    let capacity = figures::stack_capacity(limits, peak_g, language);
    put("capacity.svg", capacity.as_bytes())
}

/// A series for ParaView, each [`PARAVIEW_STEP_S`].
fn paraview(simulation: &StackSimulation, put: Put<'_>) -> Result<()> {
    let mut series: Vec<SeriesFile> = Vec::new();
    for (sample, &time_s) in simulation.history.time_s.iter().enumerate() {
        let due = series
            .last()
            .is_none_or(|last| time_s - last.time_s >= PARAVIEW_STEP_S * (1.0 - 1e-6));
        if !due && sample + 1 != simulation.samples() {
            continue;
        }
        let poses: Vec<BlockPose> = simulation.poses(sample).iter().map(block_pose).collect();
        let file = format!("paraview/{:05}.vtu", series.len());
        put(&file, stack_vtu(&simulation.stack, &poses)?.as_bytes())?;
        series.push(SeriesFile { time_s, file });
    }
    put("paraview.pvd", series_pvd(&series).as_bytes())
}

/// Rows of the rotation of a unit quaternion, scalar first.
fn block_pose(pose: &Pose) -> BlockPose {
    let [w, x, y, z] = pose.rotation;
    let rotation = [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ];
    BlockPose {
        centroid_m: pose.centroid_m,
        rotation,
        velocity_m_s: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_quarter_turn_about_z_takes_x_to_y() {
        let half = 0.5_f64.sqrt();
        let pose = block_pose(&Pose {
            centroid_m: [0.0; 3],
            rotation: [half, 0.0, 0.0, half],
        });
        let x: Vec<f64> = pose.rotation.iter().map(|row| row[0]).collect();
        assert!(
            x[0].abs() < 1e-15 && (x[1] - 1.0).abs() < 1e-15 && x[2] == 0.0,
            "{x:?}"
        );
    }
}
