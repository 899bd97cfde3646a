//! A simulated motion of a building, as text.

use super::Table;
use super::building::dampers_text;
use crate::number::significant;
use crate::simulation::BuildingSimulation;
use dolmen::dynamics::{BuildingHistory, HistoryMethod};
use std::fmt::Write as _;

/// How it moved: base, floors, storeys, dampers, points.
pub fn building_simulation_text(simulation: &BuildingSimulation) -> String {
    let mut out = format!("\n{}\n", building_outcome_text(simulation));
    out += &dampers_text(&simulation.dampers);
    out += &floors_text(simulation);
    out += &base_text(simulation);
    let peaks = &simulation.history.peaks;
    for (damper, stroke) in simulation.dampers.iter().zip(&peaks.strokes_m) {
        let _ = writeln!(
            out,
            "Damper {}: stroke {:.2} mm at {:.3} s",
            damper.name,
            1e3 * stroke.value.abs(),
            stroke.at_s
        );
    }
    for point in &simulation.points {
        let [x, y] = point.displacement_m.each_ref().map(|values| largest(values));
        let _ = writeln!(
            out,
            "Point {} (floor {}, {:.3}, {:.3} m): x {:.3} mm, y {:.3} mm",
            point.name,
            point.floor,
            point.place_m[0],
            point.place_m[1],
            1e3 * x,
            1e3 * y
        );
    }
    let history = &simulation.history;
    let method = match history.method {
        HistoryMethod::ComplexModes => "mode by mode",
        HistoryMethod::MatrixExponential => "by the matrix exponential",
    };
    let _ = writeln!(
        out,
        "Run: exact {method}, {} steps of {} s; peaks are those at the steps",
        history.length() - 1,
        history.time_step_s
    );
    out
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// How it moved, in one sentence that begins with a fixed word.
pub fn building_outcome_text(simulation: &BuildingSimulation) -> String {
    let (storey, ratio) = simulation.drift_ratio();
    let name = simulation
        .floors
        .get(storey.saturating_sub(1))
        .map_or("", String::as_str);
    let mut out = format!(
        "MOVED: the largest drift at an edge is {} % of the height of the storey below floor {name}",
        significant(100.0 * ratio, 3)
    );
    if let Some(without) = &simulation.without_dampers {
        let top = |history: &BuildingHistory| {
            let peak = history.peaks.floors.last().copied().unwrap_or_default();
            peak.displacement_x_m.value.hypot(peak.displacement_y_m.value)
        };
        let _ = write!(
            out,
            "; the top moves {} of what it would without dampers",
            significant(top(&simulation.history) / top(without), 3)
        );
    }
    out
}

fn floors_text(simulation: &BuildingSimulation) -> String {
    let heads = [
        "floor",
        "x, mm",
        "y, mm",
        "turn, mrad",
        "drift x, mm",
        "y, mm",
        "edge drift x, mm",
        "y, mm",
        "of the height, %",
    ];
    let mut table = Table::new(&heads, 1);
    let peaks = &simulation.history.peaks;
    let storeys = simulation.building.building().storeys();
    for (i, storey) in storeys.iter().enumerate().rev() {
        let (floor, drift) = (&peaks.floors[i], &peaks.storeys[i]);
        let (edge_x, edge_y) = (drift.edge_drift_x_m.value.abs(), drift.edge_drift_y_m.value.abs());
        table.row(vec![
            simulation.floors[i].clone(),
            format!("{:.3}", 1e3 * floor.displacement_x_m.value.abs()),
            format!("{:.3}", 1e3 * floor.displacement_y_m.value.abs()),
            format!("{:.4}", 1e3 * floor.rotation_rad.value.abs()),
            format!("{:.3}", 1e3 * drift.drift_x_m.value.abs()),
            format!("{:.3}", 1e3 * drift.drift_y_m.value.abs()),
            format!("{:.3}", 1e3 * edge_x),
            format!("{:.3}", 1e3 * edge_y),
            format!("{:.3}", 100.0 * edge_x.max(edge_y) / storey.height_m),
        ]);
    }
    format!(
        "\nLargest displacement of the centres of mass relative to the ground, drift of the storey below each floor there and at its edges\n{}",
        table.text()
    )
}

fn base_text(simulation: &BuildingSimulation) -> String {
    let peaks = &simulation.history.peaks;
    let weight_n = simulation.building.building().mass_kg() * 9.806_65;
    let [x, y] = peaks.base_shear_n;
    format!(
        "Base shear: x {} kN at {:.3} s, y {} kN at {:.3} s ({} and {} % of the weight); torque {} kN·m at {:.3} s\n",
        significant(1e-3 * x.value.abs(), 5),
        x.at_s,
        significant(1e-3 * y.value.abs(), 5),
        y.at_s,
        significant(100.0 * x.value.abs() / weight_n, 3),
        significant(100.0 * y.value.abs() / weight_n, 3),
        significant(1e-3 * peaks.base_torque_n_m.value.abs(), 5),
        peaks.base_torque_n_m.at_s
    )
}
