//! Histories of a building as CSV: one row per step, SI units in the column names.

use dolmen::dynamics::Peak;
use dolmen_work::building::BuildingSimulation;
use std::fmt::Write as _;

/// Displacement and rotation of each floor, base shear and torque, stroke of each damper, displacement of each point.
pub fn building_histories_csv(simulation: &BuildingSimulation) -> String {
    let history = &simulation.history;
    let floors = simulation.floors.len();
    let mut out = String::from("time_s,base_shear_x_n,base_shear_y_n,base_torque_n_m");
    for floor in 1..=floors {
        let _ = write!(
            out,
            ",floor_{floor}_displacement_x_m,floor_{floor}_displacement_y_m,floor_{floor}_rotation_rad"
        );
    }
    for name in simulation.stroke_names() {
        let _ = write!(out, ",damper_{}_stroke_m", name.replace(' ', "_"));
    }
    for point in &simulation.points {
        let name = point.name.replace([',', '"', '\n'], "_");
        let _ = write!(
            out,
            ",{name}_displacement_x_m,{name}_displacement_y_m,{name}_acceleration_x_m_s2,{name}_acceleration_y_m_s2"
        );
    }
    out.push('\n');
    for step in 0..history.length() {
        let _ = write!(out, "{}", history.time_s(step));
        for value in history
            .base
            .column(step)
            .iter()
            .chain(history.coordinates.column(step))
        {
            let _ = write!(out, ",{value}");
        }
        for point in &simulation.points {
            for along in &point.along {
                let _ = write!(out, ",{}", along.displacement_m[step]);
            }
            for along in &point.along {
                let _ = write!(out, ",{}", along.acceleration_m_s2[step]);
            }
        }
        out.push('\n');
    }
    out
}

/// Largest values of each floor and the storey below it; drifts of edges and corners are empty if the outline of the floor is unknown.
pub fn building_peaks_csv(simulation: &BuildingSimulation) -> String {
    let mut out = String::from(
        "floor,displacement_x_m,displacement_y_m,rotation_rad,drift_x_m,drift_y_m,twist_rad,edge_drift_x_m,edge_drift_y_m,corner_drift_m\n",
    );
    let peaks = &simulation.history.peaks;
    for (i, (floor, storey)) in peaks.floors.iter().zip(&peaks.storeys).enumerate() {
        let values = [
            Some(floor.displacement_x_m),
            Some(floor.displacement_y_m),
            Some(floor.rotation_rad),
            Some(storey.drift_x_m),
            Some(storey.drift_y_m),
            Some(storey.twist_rad),
            storey.edge_drift_x_m,
            storey.edge_drift_y_m,
            storey.edge_drift_y_m.map(|_| Peak {
                value: storey.resultant.size_m,
                at_s: storey.resultant.at_s,
            }),
        ];
        let _ = write!(out, "{}", i + 1);
        for peak in values {
            let _ = write!(
                out,
                ",{}",
                peak.map_or(String::new(), |peak| peak.value.to_string())
            );
        }
        out.push('\n');
    }
    out
}
