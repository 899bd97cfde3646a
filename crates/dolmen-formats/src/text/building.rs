//! `dolmen check` of a building as text.

use super::Table;
use crate::building::{BuildingAnswer, BuildingSpectral, StandingBuilding};
use crate::number::{beside_one, significant};
use crate::project::BuiltDamper;
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Storeys, modes, dampers, response to the spectrum of the site.
pub(super) fn building_text(answer: &BuildingAnswer) -> String {
    let mut out = storeys_text(answer);
    if let Some(standing) = &answer.stands {
        out += &modes_text(standing);
        out += &dampers_text(&standing.dampers);
        out += &standing
            .spectral
            .as_ref()
            .map_or_else(String::new, |spectral| spectral_text(answer, spectral));
    }
    out
}

fn storeys_text(answer: &BuildingAnswer) -> String {
    let heads = [
        "storey below floor",
        "kx, kN/mm",
        "ky, kN/mm",
        "rotation, GN·m/rad",
        "rigidity x, m",
        "y, m",
        "from mass x, m",
        "y, m",
        "load factor",
        "falls by",
    ];
    let mut table = Table::new(&heads, 1);
    let building = &answer.elastic;
    for (i, storey) in building.storeys().iter().enumerate() {
        let centre = building.floors()[i].centre_m;
        let rigidity = storey.stiffness.centre_of_rigidity_m().unwrap_or([f64::NAN; 2]);
        let k = storey.stiffness.matrix_about(rigidity);
        let fall = &answer.falls[i];
        let motion = if fall.motion() == "twists" {
            "twist"
        } else {
            "sway"
        };
        let length = |x: f64| format!("{:.3}", x + 0.0);
        table.row(vec![
            answer.floors[i].clone(),
            significant(1e-6 * k[0][0], 5),
            significant(1e-6 * k[1][1], 5),
            significant(1e-9 * k[2][2], 5),
            length(rigidity[0]),
            length(rigidity[1]),
            length(rigidity[0] - centre[0]),
            length(rigidity[1] - centre[1]),
            beside_one(fall.load_factor, 4),
            motion.to_owned(),
        ]);
    }
    format!(
        "\nStoreys: stiffness about the centre of rigidity, its place in plan and from the centre of mass; factor on the weight above at \
         which each falls\n{}",
        table.text()
    )
}

fn modes_text(standing: &StandingBuilding) -> String {
    let heads = [
        "mode",
        "f, Hz",
        "T, s",
        "omega, rad/s",
        "damping, %",
        "mass x, %",
        "y, %",
        "turn, %",
        "energy x, %",
        "y, %",
        "twist, %",
        "centre x, m",
        "y, m",
    ];
    let mut table = Table::new(&heads, 1);
    let modes = &standing.modes;
    let shown = standing.shown();
    let mut sums = [0.0; 3];
    let mut repeated = false;
    for (j, mode) in modes.modes.iter().take(shown).enumerate() {
        let share = |axis: usize| 100.0 * mode.effective_mass[axis] / modes.total_mass[axis];
        (0..3).for_each(|axis| sums[axis] += share(axis));
        repeated |= mode.repeated;
        let centre = mode.centres.last().copied().flatten();
        let at = |value: Option<f64>| value.map_or("none".to_owned(), |x| format!("{:.3}", x + 0.0));
        table.row(vec![
            format!("{}{}", j + 1, if mode.repeated { "*" } else { "" }),
            significant(mode.frequency_hz, 5),
            significant(mode.period_s(), 5),
            significant(TAU * mode.frequency_hz, 6),
            format!("{:.3}", 100.0 * standing.damping_ratios[j]),
            format!("{:.2}", share(0)),
            format!("{:.2}", share(1)),
            format!("{:.2}", share(2)),
            format!("{:.2}", 100.0 * mode.energy_shares[0]),
            format!("{:.2}", 100.0 * mode.energy_shares[1]),
            format!("{:.2}", 100.0 * mode.energy_shares[2]),
            at(centre.map(|c| c.x_m)),
            at(centre.map(|c| c.y_m)),
        ]);
    }
    let mut out = format!(
        "\nModes, {shown} of {}: effective mass, shares of the kinetic energy, and where the top floor turns about (none: it moves without \
         turning)\n{}  together {:.1} % of the mass along x, {:.1} % along y, {:.1} % of the moment of inertia\n",
        modes.modes.len(),
        table.text(),
        sums[0],
        sums[1],
        sums[2]
    );
    if repeated {
        out += "  * two modes of one frequency: their shapes are one choice of many\n";
    }
    out
}

/// The dampers, every number worked out.
pub(super) fn dampers_text(dampers: &[BuiltDamper]) -> String {
    if dampers.is_empty() {
        return String::new();
    }
    let heads = [
        "damper",
        "floor",
        "x, m",
        "y, m",
        "direction",
        "for mode",
        "mass ratio",
        "mass, t",
        "f, Hz",
        "damping, %",
        "tuning",
    ];
    let mut table = Table::new(&heads, 1);
    for damper in dampers {
        let [cos, sin] = damper.tuned.direction.unit();
        table.row(vec![
            damper.name.clone(),
            damper.tuned.floor.to_string(),
            format!("{:.3}", damper.tuned.x_m),
            format!("{:.3}", damper.tuned.y_m),
            format!("{:.0} deg", sin.atan2(cos).to_degrees() + 0.0),
            damper.mode.to_string(),
            significant(damper.mass_ratio, 4),
            significant(1e-3 * damper.tuned.mass_kg, 4),
            significant(damper.tuned.frequency_hz, 5),
            format!("{:.3}", 100.0 * damper.tuned.damping_ratio),
            damper.tuning.map_or("given", |tuning| tuning.word()).to_owned(),
        ]);
    }
    format!(
        "\nDampers: mass over the modal mass at their place; damping on their own frequency\n{}",
        table.text()
    )
}

fn spectral_text(answer: &BuildingAnswer, spectral: &BuildingSpectral) -> String {
    let mut out = String::from("\nResponse to the spectrum of the site, without dampers, all modes\n");
    let mut table = Table::new(&["base shear, kN", "along x", "along y"], 1);
    for (word, [x, y]) in ["absolute sum", "SRSS", "CQC"]
        .into_iter()
        .zip(spectral.base_shear_n)
    {
        table.row(vec![
            word.to_owned(),
            significant(1e-3 * x, 5),
            significant(1e-3 * y, 5),
        ]);
    }
    out += &table.text();
    let _ = writeln!(
        out,
        "  base torque {} kN·m; below: CQC, x and y together by the root of the sum of squares",
        significant(1e-3 * spectral.base_torque_n_m, 5)
    );
    let heads = [
        "floor",
        "x, mm",
        "y, mm",
        "edge drift x, mm",
        "y, mm",
        "of the height, %",
    ];
    let mut table = Table::new(&heads, 1);
    for (i, storey) in answer.elastic.storeys().iter().enumerate().rev() {
        let ([x, y], [drift_x, drift_y]) = (spectral.displacement_m[i], spectral.edge_drift_m[i]);
        table.row(vec![
            answer.floors[i].clone(),
            format!("{:.3}", 1e3 * x),
            format!("{:.3}", 1e3 * y),
            format!("{:.3}", 1e3 * drift_x),
            format!("{:.3}", 1e3 * drift_y),
            format!("{:.3}", 100.0 * drift_x.max(drift_y) / storey.height_m),
        ]);
    }
    out += &table.text();
    for (name, [x, y]) in &spectral.points_m {
        let _ = writeln!(out, "  point {name}: x {:.3} mm, y {:.3} mm", 1e3 * x, 1e3 * y);
    }
    out
}
