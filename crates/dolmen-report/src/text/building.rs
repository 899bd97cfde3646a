//! `dolmen check` of a building as text.

use super::{GROWN, Table};
use dolmen_project::{BuiltDamper, strokes_of};
use dolmen_words::number::{beside_one, significant, significant_beside};
use dolmen_work::building::{
    BuildingAnswer, BuildingSpectral, DampedSpectral, MINOR_RATIO, StandingBuilding,
};
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Storeys, modes, dampers, response to the spectrum of the site.
pub(super) fn building_text(answer: &BuildingAnswer) -> String {
    let mut out = storeys_text(answer);
    if let Some(standing) = &answer.stands {
        out += &modes_text(standing);
        out += &dampers_text(&standing.dampers);
        if let Some(spectral) = &standing.spectral {
            out += &spectral_text(answer, spectral, standing);
        }
        if let Some(why) = &standing.spectral_refused {
            let _ = writeln!(
                out,
                "\nResponse to the spectrum of the site: NOT COMPUTED: {why}. Give the modes damping that the spectrum is for, or `dolmen simulate` a motion"
            );
        }
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
        "kind",
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
    let mut table = Table::new(&heads, 2);
    let none = || "none".to_owned();
    for damper in dampers {
        let [cos, sin] = damper.direction.unit();
        let [own_hz, own_ratio] = damper.own().map_or([none(), none()], |[hz, ratio]| {
            [significant(hz, 5), format!("{:.3}", 100.0 * ratio)]
        });
        let tuned = damper.tuned_to;
        table.row(vec![
            damper.name.clone(),
            damper.word().to_owned(),
            damper.floor.to_string(),
            format!("{:.3}", damper.place_m[0]),
            format!("{:.3}", damper.place_m[1]),
            format!("{:.0} deg", sin.atan2(cos).to_degrees() + 0.0),
            tuned.map_or_else(none, |tuned| tuned.mode.to_string()),
            tuned.map_or_else(none, |tuned| significant(tuned.mass_ratio, 4)),
            tuned.map_or_else(none, |_| significant(1e-3 * damper.kind.mass_kg(), 4)),
            own_hz,
            own_ratio,
            damper.tuning.map_or("given", |tuning| tuning.name()).to_owned(),
        ]);
    }
    let mut out = format!(
        "\nDampers: mass over the modal mass at their place; damping on their own frequency\n{}",
        table.text()
    );
    for damper in dampers.iter().filter(|damper| !damper.rest().is_empty()) {
        let _ = writeln!(out, "  {}: {}", damper.name, damper.rest());
    }
    out
}

fn spectral_text(
    answer: &BuildingAnswer,
    spectral: &BuildingSpectral,
    standing: &StandingBuilding,
) -> String {
    let without = match standing.dampers.is_empty() {
        true => "",
        false => " WITHOUT ITS DAMPERS",
    };
    let mut out = format!(
        "\nResponse to the spectrum of the site{without}, all modes; shaking along x and y together by the root of the sum of squares\n"
    );
    let mut table = Table::new(&["base shear, kN", "along x", "along y"], 1);
    for (word, [x, y]) in ["absolute sum", "SRSS", "CQC"]
        .into_iter()
        .zip(spectral.base_shear_n)
    {
        table.row(vec![
            word.to_owned(),
            significant_beside(1e-3 * x, 1e-3 * y, 5),
            significant_beside(1e-3 * y, 1e-3 * x, 5),
        ]);
    }
    out += &table.text();
    let _ = writeln!(
        out,
        "  what the walls of the lowest storey carry; torque about the vertical through the centre of all mass {} kN·m (CQC, as all below)",
        significant_beside(
            1e-3 * spectral.base_torque_n_m,
            1e-3 * most(spectral.base_shear_n[2]),
            5
        )
    );
    let [x, y] = spectral.least_favourable;
    let _ = writeln!(
        out,
        "  least favourable direction, the weaker component {MINOR_RATIO} of the stronger (CQC3): x {} kN with the stronger at {:.0} deg, y {} kN at {:.0} deg",
        significant_beside(1e-3 * x.largest, 1e-3 * y.largest, 5),
        x.direction_degrees,
        significant_beside(1e-3 * y.largest, 1e-3 * x.largest, 5),
        y.direction_degrees
    );
    out += &moved_text(
        answer,
        &spectral.displacement_m,
        &spectral.edge_drift_m,
        &spectral.points_m,
    );
    if let Some(damped) = &standing.damped {
        out += &damped_text(answer, damped, standing);
    }
    if let Some(why) = &standing.damped_refused {
        let _ = writeln!(
            out,
            "\nThe same with the dampers: NOT COMPUTED: {why}. `dolmen simulate` has it under a motion"
        );
        for stroke in strokes_of(&standing.dampers) {
            if stroke.room_m.is_some() {
                let _ = writeln!(
                    out,
                    "  whether damper {} has room enough is not known",
                    stroke.name
                );
            }
        }
    }
    out
}

fn most(of: [f64; 2]) -> f64 {
    of[0].abs().max(of[1].abs())
}

/// With the dampers, whose modes are complex.
fn damped_text(answer: &BuildingAnswer, damped: &DampedSpectral, standing: &StandingBuilding) -> String {
    let largest_n = most(damped.base_shear_n);
    let [x, y] = damped
        .base_shear_n
        .map(|n| significant_beside(1e-3 * n, 1e-3 * largest_n, 5));
    let mut out = format!(
        "\nResponse to the spectrum of the site with its dampers: complex modes by CQC\n  base shear x {x} kN, y {y} kN; torque {} kN·m\n",
        significant_beside(1e-3 * damped.base_torque_n_m, 1e-3 * largest_n, 5)
    );
    out += &moved_text(
        answer,
        &damped.displacement_m,
        &damped.edge_drift_m,
        &damped.points_m,
    );
    for of in standing.against_without().iter().filter(|of| of.ratio > GROWN) {
        let _ = writeln!(
            out,
            "MORE THAN WITHOUT DAMPERS: {} is {} of what it would be",
            of.what[0],
            significant(of.ratio, 4)
        );
    }
    for (stroke, stroke_m) in strokes_of(&standing.dampers).iter().zip(&damped.strokes_m) {
        let _ = writeln!(out, "  damper {}: stroke {:.2} mm", stroke.name, 1e3 * stroke_m);
    }
    for beyond in standing.beyond_room() {
        let _ = writeln!(
            out,
            "BEYOND ITS ROOM: damper {} needs {:.1} mm each way under the spectrum of the site and has {:.1} mm",
            beyond.name,
            1e3 * beyond.stroke_m,
            1e3 * beyond.room_m
        );
    }
    out
}

fn moved_text(
    answer: &BuildingAnswer,
    displacement_m: &[[f64; 2]],
    edge_drift_m: &[Option<[f64; 2]>],
    points_m: &[(String, [f64; 2])],
) -> String {
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
        let [x, y] = displacement_m[i];
        let mut row = vec![
            answer.floors[i].clone(),
            format!("{:.3}", 1e3 * x),
            format!("{:.3}", 1e3 * y),
        ];
        row.extend(match edge_drift_m[i] {
            Some([x, y]) => [1e3 * x, 1e3 * y, 100.0 * x.max(y) / storey.height_m].map(|v| format!("{v:.3}")),
            None => ["unknown", "unknown", "no outline"].map(str::to_owned),
        });
        table.row(row);
    }
    let mut out = table.text();
    for (name, [x, y]) in points_m {
        let _ = writeln!(out, "  point {name}: x {:.3} mm, y {:.3} mm", 1e3 * x, 1e3 * y);
    }
    out
}
