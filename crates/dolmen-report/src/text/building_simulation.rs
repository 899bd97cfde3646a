//! A simulated motion of a building, as text.

use super::Table;
use super::building::dampers_text;
use super::grown::GROWN;
use dolmen::dynamics::HistoryMethod;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_project::strokes_of;
use dolmen_words::number::{significant, significant_beside, trimmed};
use dolmen_work::building::{Against, BuildingSimulation};
use std::fmt::Write as _;

/// How it moved: base, floors, storeys, dampers, points.
pub fn building_simulation_text(simulation: &BuildingSimulation) -> String {
    let mut out = format!("\n{}\n", building_outcome_text(simulation));
    out += &dampers_text(&simulation.dampers);
    out += &floors_text(simulation);
    out += &base_text(simulation);
    let peaks = &simulation.history.peaks;
    let forces = simulation.dashpot_forces_n();
    for (k, (of, stroke)) in strokes_of(&simulation.dampers)
        .iter()
        .zip(&peaks.strokes_m)
        .enumerate()
    {
        let force = match forces.get(k).copied().flatten() {
            Some(force) => format!(
                "; force of its dashpot {} kN at {:.3} s",
                significant(1e-3 * force.value.abs(), 4),
                force.at_s
            ),
            None => String::new(),
        };
        let _ = writeln!(
            out,
            "Damper {}: stroke {:.2} mm at {:.3} s{force}",
            of.name,
            1e3 * stroke.value.abs(),
            stroke.at_s
        );
    }
    for damper in simulation.across_the_motion() {
        let [cos, sin] = damper.direction.unit();
        let _ = writeln!(
            out,
            "note: the ground shakes across damper {} (it moves along {} deg): this run does not show what it does; turn the motion (--turn)",
            damper.name,
            trimmed(sin.atan2(cos).to_degrees(), 4)
        );
    }
    for point in &simulation.points {
        let [x, y] = point
            .along
            .each_ref()
            .map(|along| along.displacement_peak_m.value.abs());
        let [a_x, a_y] = point
            .along
            .each_ref()
            .map(|along| along.acceleration_peak_m_s2.value.abs());
        let _ = writeln!(
            out,
            "Point {} (floor {}, {:.3}, {:.3} m): x {:.3} mm, y {:.3} mm; acceleration with the ground x {:.4} g, y {:.4} g",
            point.name,
            point.floor,
            point.place_m[0],
            point.place_m[1],
            1e3 * x,
            1e3 * y,
            a_x / STANDARD_GRAVITY_M_S2,
            a_y / STANDARD_GRAVITY_M_S2
        );
    }
    let history = &simulation.history;
    let method = match history.method {
        HistoryMethod::ComplexModes => "mode by mode",
        HistoryMethod::MatrixExponential => "by the matrix exponential",
    };
    let _ = writeln!(
        out,
        "Run: exact {method}, {} steps of {} s, to {:.2} s; peaks are looked for between the steps",
        history.length() - 1,
        history.time_step_s,
        history.time_s(history.length() - 1)
    );
    if history.grows_at_the_end() {
        out += "STILL GROWING: a displacement is largest where the run ends, and may grow on: give a longer --duration\n";
    }
    out
}

/// How it moved, in one sentence that begins with a fixed word; and what dampers make more, a line each.
pub fn building_outcome_text(simulation: &BuildingSimulation) -> String {
    let drift = simulation.drift();
    let name = simulation
        .floors
        .get(drift.storey.saturating_sub(1))
        .map_or("", String::as_str);
    let place = if drift.at_corner {
        "at a corner"
    } else {
        "of a centre of mass"
    };
    let mut out = match simulation.ended_before_the_motion_s() {
        Some(end_s) => simulation.motion.cut_words(end_s) + "\n",
        None => String::new(),
    };
    for beyond in simulation.beyond_room() {
        let _ = writeln!(
            out,
            "BEYOND ITS ROOM: damper {} needs {:.1} mm each way and has {:.1} mm: it would meet its stops, which this run does not have, so that \
             all below is too good",
            beyond.name,
            1e3 * beyond.stroke_m,
            1e3 * beyond.room_m
        );
    }
    let _ = write!(
        out,
        "MOVED: the largest drift {place} is {} % of the height of the storey below floor {name}, {:.0}° from x",
        significant(100.0 * drift.ratio, 3),
        drift.drift.direction_degrees + 0.0
    );
    if !drift.at_corner {
        out += " (its outline is not known: corners drift more where it twists; give sides or outline)";
    }
    let against = simulation.against_without();
    let top: Vec<String> = against
        .iter()
        .filter(|of| of.what[0].starts_with("the top"))
        .map(|of| format!("{} {}", of.what[0], significant(of.ratio, 3)))
        .collect();
    if !top.is_empty() {
        let _ = write!(out, "; {} of what it would move without dampers", top.join(", "));
    }
    let more: Vec<&Against> = against.iter().filter(|of| of.ratio > GROWN).collect();
    let drifts: Vec<&&Against> = more.iter().filter(|of| of.is_drift()).collect();
    let worst = drifts.iter().max_by(|a, b| a.ratio.total_cmp(&b.ratio));
    for of in more.iter().filter(|of| !of.is_drift()).chain(worst.copied()) {
        let _ = write!(
            out,
            "\nMORE THAN WITHOUT DAMPERS: {} is {} of what it would be",
            of.what[0],
            significant(of.ratio, 4)
        );
        if of.is_drift() && drifts.len() > 1 {
            let _ = write!(out, ", and {} other drifts are more by less", drifts.len() - 1);
        }
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
        "corner drift, mm",
        "of the height, %",
    ];
    let mut table = Table::new(&heads, 1);
    let peaks = &simulation.history.peaks;
    let storeys = simulation.building.building().storeys();
    for (i, storey) in storeys.iter().enumerate().rev() {
        let (floor, drift) = (&peaks.floors[i], &peaks.storeys[i]);
        let edges = drift.edge_drift_x_m.zip(drift.edge_drift_y_m);
        let mut row = vec![
            simulation.floors[i].clone(),
            format!("{:.3}", 1e3 * floor.displacement_x_m.value.abs()),
            format!("{:.3}", 1e3 * floor.displacement_y_m.value.abs()),
            format!("{:.4}", 1e3 * floor.rotation_rad.value.abs()),
            format!("{:.3}", 1e3 * drift.drift_x_m.value.abs()),
            format!("{:.3}", 1e3 * drift.drift_y_m.value.abs()),
        ];
        row.extend(match edges {
            Some((x, y)) => {
                let corner = drift.resultant.size_m;
                let milli = [x.value.abs(), y.value.abs(), corner].map(|value| 1e3 * value);
                let [x, y, corner] = milli.map(|value| format!("{value:.3}"));
                [
                    x,
                    y,
                    corner,
                    format!("{:.3}", 100.0 * drift.resultant.size_m / storey.height_m),
                ]
            }
            None => ["unknown", "unknown", "unknown", "no outline"].map(str::to_owned),
        });
        table.row(row);
    }
    format!(
        "\nLargest displacement of the centres of mass relative to the ground, drift of the storey below each floor there, at its edges\nalong x and along y, and at its corners in any direction\n{}",
        table.text()
    )
}

fn base_text(simulation: &BuildingSimulation) -> String {
    let peaks = &simulation.history.peaks;
    let weight_n = simulation.building.building().mass_kg() * 9.806_65;
    let [x, y] = peaks.base_shear_n;
    let largest_n = x.value.abs().max(y.value.abs());
    let beside = |value: f64, factor: f64, digits| {
        significant_beside(factor * value.abs(), factor * largest_n, digits)
    };
    format!(
        "Shear in the walls of the lowest storey: x {} kN at {:.3} s, y {} kN at {:.3} s ({} and {} % of the weight); torque about the vertical through the centre of all mass {} kN·m at {:.3} s\n",
        beside(x.value, 1e-3, 5),
        x.at_s,
        beside(y.value, 1e-3, 5),
        y.at_s,
        beside(x.value, 100.0 / weight_n, 3),
        beside(y.value, 100.0 / weight_n, 3),
        beside(peaks.base_torque_n_m.value, 1e-3, 5),
        peaks.base_torque_n_m.at_s
    )
}
