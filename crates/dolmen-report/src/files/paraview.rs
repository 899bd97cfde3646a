//! A simulated stack as a series for ParaView.

use super::named::NamedFile;
use dolmen::blocks::Pose;
use dolmen_records::meshes::{BlockPose, PoseError, SeriesFile, series_pvd, stack_vtu};
use dolmen_work::stack::StackSimulation;

/// Time between the files of a series, s: 20 per second. Our choice.
const PARAVIEW_STEP_S: f64 = 0.05;

/// A series for ParaView, each [`PARAVIEW_STEP_S`].
pub(super) fn paraview(simulation: &StackSimulation) -> Result<Vec<NamedFile>, PoseError> {
    let mut files = Vec::new();
    let mut series: Vec<SeriesFile> = Vec::new();
    for (sample, &time_s) in simulation.history.time_s.iter().enumerate() {
        let due = series
            .last()
            .is_none_or(|last| time_s - last.time_s >= PARAVIEW_STEP_S * (1.0 - 1e-6));
        if !due && sample + 1 != simulation.samples() {
            continue;
        }
        let poses: Vec<BlockPose> = simulation.poses(sample).iter().map(block_pose).collect();
        let file = format!("{:05}.vtu", series.len());
        let bytes = stack_vtu(&simulation.stack, &poses)?;
        let file = NamedFile::new(&file, bytes).within("paraview");
        series.push(SeriesFile {
            time_s,
            file: file.name.clone(),
        });
        files.push(file);
    }
    files.push(NamedFile::new("paraview.pvd", series_pvd(&series)));
    Ok(files)
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
