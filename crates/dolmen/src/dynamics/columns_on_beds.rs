//! A rigid mass on free-standing columns whose feet and heads press on compliant beds, over time.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m, N | `mass_kg`, `axial_n` | mass above the columns, weight on them | kg, N |
//! | k_j | `joints_n_m` | stiffness of joints and walls beside the columns | N/m |
//! | θ, u, z | `rotation`, `drift` | rotation of the columns; displacement and rise of the mass | rad, m, m |
//! | V, e | – | horizontal resistance; distance of the resultants from the axis of a column | N, m |
//! | h, θ0 | `height_m`, `uplift_rad` | height of the columns, rotation at which feet lift off | m, rad |
//! | τ | `tilt` | lean at rest without stress, horizontal over vertical | – |
//! | ω0, ζ, c | – | frequency at small drift, damping ratio, 2 ζ ω0 m | rad/s, –, N s/m |

use super::DynamicsError;
use super::column_run::{ColumnHistory, ColumnOutcome, ColumnRun};
use super::columns_steps::Motion;
use super::excitation::TimeFunction;
use super::rocking_block::positive;
use crate::stability::FreeColumns;

/// Tolerances of successive runs, relative to rotations of lift-off and above. Our choice.
const TOLERANCES: [f64; 5] = [1e-6, 1e-8, 1e-10, 1e-12, 1e-14];
/// Largest accepted change of the peak from one tolerance to the next.
const CHANGE_MOST: f64 = 1e-3;

/// Motion of a mass on columns on compliant beds, with their force at any drift, and on linear joints beside them.
///
/// ```text
/// m (h² + 4 e²) θ″ + 4 m e e′ θ′² + c(θ) u_θ² θ′ + N z_θ = (N τ − m a_g − k_j u) u_θ
/// u_θ = h cos θ + 2 e sin θ,   z_θ = 2 e cos θ − h sin θ,   V = N z_θ/u_θ
/// c = 2 ζ ω0 m,   ω0² = (k_b + k_j − N/h)/m,   k_b = 2 n k_w I/h²
/// ```
///
/// In terms of the drift this is m u″ + c u′ + V(u) + k_j u = N τ − m a_g, with the inertia of the rise z. Steps of Dormand and Prince end at the
/// samples of the ground motion; the run is repeated with smaller tolerances until the peak changes by less than 0.1 %.
///
/// # Errors
/// [`DynamicsError::Argument`] for a rigid bed, columns that do not stand, or a motion or option out of range; [`DynamicsError::Columns`] if
/// a root is not found.
///
/// # Limits
/// Those of [`FreeColumns`], and no vertical shaking. Passing the upright position costs no energy: stiff beds approach the rigid block
/// of [`rock_block`](super::rock_block) with `velocity_ratio` 1, while a rigid block with its own ratio loses energy at each impact. So
/// on stiff beds drifts are on the safe side.
///
/// # Source
/// Equation of motion: Lagrange. Dashpots that do not act beyond the elastic range: Hall, J. F. (2006) Earthquake Eng. Struct. Dyn.
/// 35(5):525-545. Steps: Dormand, J. R. & Prince, P. J. (1980) J. Comput. Appl. Math. 6(1):19-26.
pub fn rock_on_beds(
    columns: &FreeColumns,
    ground_m_s2: &TimeFunction,
    run: &ColumnRun,
) -> Result<ColumnHistory, DynamicsError> {
    ground_m_s2.check("ground_m_s2")?;
    positive("mass_kg", run.mass_kg)?;
    positive("duration_s", run.duration_s)?;
    positive("output_step_s", run.output_step_s)?;
    let refuse = |argument, given, allowed| {
        Err(DynamicsError::Argument {
            argument,
            given,
            allowed,
        })
    };
    if !(run.damping_ratio >= 0.0 && run.damping_ratio.is_finite()) {
        return refuse("damping_ratio", run.damping_ratio, "0 or a positive number");
    }
    if !(run.joints_n_m >= 0.0 && run.joints_n_m.is_finite()) {
        return refuse("joints_n_m", run.joints_n_m, "0 or a positive number");
    }
    if run.drift_most_m.is_nan() || run.drift_most_m <= 0.0 {
        return refuse("drift_most_m", run.drift_most_m, "a positive number");
    }
    if !run.tilt.is_finite() {
        return refuse("tilt", run.tilt, "a number");
    }
    let Some(mut found) = Motion::of(columns, run)? else {
        return refuse(
            "bed_stiffness_n_m3",
            f64::NAN,
            "finite, and so large that the columns stand",
        );
    };
    if let Some(start_rad) = run.start_rad
        && (start_rad.is_nan() || start_rad.abs() >= found.falls_rad())
    {
        return refuse(
            "start_rad",
            start_rad,
            "less than the rotation of the fall to either side",
        );
    }
    let Some(start_rad) = found.start_rad(run)? else {
        return Ok(found.fallen(run));
    };
    let mut before: Option<ColumnHistory> = None;
    for tolerance in TOLERANCES {
        let mut now = found.follow(ground_m_s2, run, (start_rad, tolerance));
        if now.outcome == ColumnOutcome::NotConverged {
            return Ok(now);
        }
        if let Some(before) = &before {
            let fell = |of: &ColumnHistory| matches!(of.outcome, ColumnOutcome::Fell { .. });
            now.peak_change = match (fell(before), fell(&now)) {
                (true, true) => 0.0,
                (false, false) => {
                    (now.peak_drift_m - before.peak_drift_m).abs() / now.peak_drift_m.max(f64::MIN_POSITIVE)
                }
                _ => f64::INFINITY,
            };
            if now.peak_change <= CHANGE_MOST {
                return Ok(now);
            }
        }
        before = Some(now);
    }
    Ok(before.map_or_else(
        || found.fallen(run),
        |last| ColumnHistory {
            outcome: ColumnOutcome::NotConverged,
            ..last
        },
    ))
}

#[cfg(test)]
mod tests {
    use super::super::column_run::ColumnDashpots;
    use super::*;
    use crate::dynamics::{Rocking, RockingBlock, rock_block};
    use crate::stability::FootSection;
    use std::f64::consts::PI;

    const G: f64 = 9.80665;

    /// The gate of `examples/free_columns`: 32 t on 4 round columns of 0.5 × 4 m.
    fn gate(bed_n_m3: f64) -> FreeColumns {
        FreeColumns::new(
            4,
            FootSection::Circle { diameter_m: 0.5 },
            4.0,
            32e3 * G,
            Some(bed_n_m3),
        )
        .unwrap()
    }

    /// El Centro 1940 north-south from the repository, scaled to a peak in g.
    fn el_centro(peak_g: f64) -> TimeFunction {
        let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
        let rows = text.lines().filter_map(|line| line.split_once(','));
        let rows: Vec<(f64, f64)> = rows
            .filter_map(|(t, a)| Some((t.parse().ok()?, a.parse().ok()?)))
            .collect();
        let most = rows.iter().map(|(_, a)| a.abs()).fold(0.0, f64::max);
        TimeFunction::Sampled {
            time_step_s: rows[1].0 - rows[0].0,
            values: rows.iter().map(|(_, a)| a / most * peak_g * G).collect(),
        }
    }

    #[test]
    fn exact_small_motion_is_that_of_the_linear_oscillator() {
        // a step of the ground: u = −(a/ω²) (1 + exp(−π ζ/√(1 − ζ²))) at t = π/ω_d
        // springs of beds at foot and head, and of joints, rotate by the same angle: k = 2 n k_w I/h² + k_j − N/h
        let columns = gate(4e9);
        let (zeta, a) = (0.05_f64, 2e-2);
        let root = (1.0 - zeta * zeta).sqrt();
        let beds_n_m = 2.0 * 4.0 * 4e9 * (PI * 0.5_f64.powi(4) / 64.0) / 16.0;
        let cases = [ColumnDashpots::InBeds, ColumnDashpots::Constant].into_iter();
        for (dashpots, joints_n_m) in cases.flat_map(|of| [(of, 0.0), (of, 3e6)]) {
            let omega = ((beds_n_m + joints_n_m - 32e3 * G / 4.0) / 32e3).sqrt();
            let peak_m = a / omega.powi(2) * (1.0 + (-PI * zeta / root).exp());
            let run = ColumnRun {
                damping_ratio: zeta,
                joints_n_m,
                ..ColumnRun::of(32e3, 0.4)
            };
            let found = rock_on_beds(
                &columns,
                &TimeFunction::Constant(a),
                &ColumnRun { dashpots, ..run },
            )
            .unwrap();
            assert_eq!(found.outcome, ColumnOutcome::Stood);
            assert!(
                (found.peak_drift_m / peak_m - 1.0).abs() < 1e-5,
                "{} {peak_m}",
                found.peak_drift_m
            );
            assert!((found.peak_at_s * omega * root / PI - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn agrees_with_the_quadrature_of_a_free_swing() {
        let columns = gate(4e9);
        for rotation in [0.0002, 0.002, 0.02, 0.06] {
            let hz = columns.swing_frequency_hz(32e3, 0.0, rotation);
            let run = ColumnRun {
                start_rad: Some(rotation),
                output_step_s: 1e-3 / hz,
                ..ColumnRun::of(32e3, 3.0 / hz)
            };
            let found = rock_on_beds(&columns, &TimeFunction::Zero, &run).unwrap();
            // after three periods it is back where it was let go
            let [first, last] = [found.drift_m[0], *found.drift_m.last().unwrap()];
            assert!((last / first - 1.0).abs() < 2e-4, "{rotation}: {first} {last}");
            // and a quarter of a period later it passes through 0
            let quarter = found.drift_m[2250];
            assert!((quarter / first).abs() < 2e-3, "{rotation}: {quarter}");
        }
    }

    #[test]
    fn holds_the_ground_puts_in_what_is_stored_and_dissipated() {
        for (tilt, dashpots, joints_n_m) in [
            (0.0, ColumnDashpots::InBeds, 0.0),
            (0.01, ColumnDashpots::Constant, 0.0),
            (0.01, ColumnDashpots::InBeds, 3e5),
        ] {
            let run = ColumnRun {
                damping_ratio: 0.03,
                joints_n_m,
                tilt,
                dashpots,
                ..ColumnRun::of(32e3, 12.0)
            };
            let found = rock_on_beds(&gate(4e9), &el_centro(0.15), &run).unwrap();
            assert_eq!(found.outcome, ColumnOutcome::Rocked);
            let of = found.energy;
            let left_j = of.input_j - of.kinetic_j - of.stored_j - of.damping_j;
            assert!(left_j.abs() < 1e-4 * of.damping_j, "{of:?}");
        }
    }

    /// Largest drift by Runge-Kutta of order 4 in equal steps on m u″ + c u′ + V(u) = −m a_g, V interpolated in a table, without the
    /// inertia of the rise.
    fn by_runge_kutta(columns: &FreeColumns, ground: &TimeFunction, run: &ColumnRun, step_s: f64) -> f64 {
        let points = columns.curve(2000).unwrap();
        let per_m = columns.bed_stiffness_n_m().unwrap() - columns.axial_n() / columns.height_m();
        let c = 2.0 * run.damping_ratio * (per_m * run.mass_kg).sqrt();
        let force = |drift: f64| {
            let size = drift.abs();
            let after = points
                .partition_point(|point| point.drift_m <= size)
                .clamp(1, points.len() - 1);
            let (a, b) = (points[after - 1], points[after]);
            let share = (size - a.drift_m) / (b.drift_m - a.drift_m);
            (a.force_n + share * (b.force_n - a.force_n)).copysign(drift)
        };
        let rate = |t: f64, u: f64, v: f64| -ground.value(t) - (c * v + force(u)) / run.mass_kg;
        let (mut u, mut v, mut most) = (0.0_f64, 0.0_f64, 0.0_f64);
        for i in 0..(run.duration_s / step_s) as usize {
            let (t, half) = (i as f64 * step_s, 0.5 * step_s);
            let a1 = rate(t, u, v);
            let (v2, a2) = (v + half * a1, rate(t + half, u + half * v, v + half * a1));
            let (v3, a3) = (v + half * a2, rate(t + half, u + half * v2, v + half * a2));
            let (v4, a4) = (
                v + step_s * a3,
                rate(t + step_s, u + step_s * v3, v + step_s * a3),
            );
            u += step_s / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
            v += step_s / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
            most = most.max(u.abs());
        }
        most
    }

    #[test]
    fn agrees_with_a_second_integrator_under_el_centro() {
        // 46.1 and 36.7 mm by a third one, central differences, also without the inertia of the rise
        let stiff = FreeColumns::new(
            4,
            FootSection::Circle { diameter_m: 0.836 },
            4.04,
            8.48e3 * G,
            Some(14.0489e9),
        )
        .unwrap();
        for (columns, mass_kg, zeta, peak_g, third_mm) in [
            (gate(4e9), 32e3, 0.03, 0.2, 46.1),
            (stiff, 8.48e3, 0.02, 0.4, 36.7),
        ] {
            let run = ColumnRun {
                damping_ratio: zeta,
                dashpots: ColumnDashpots::Constant,
                ..ColumnRun::of(mass_kg, 12.0)
            };
            let ground = el_centro(peak_g);
            let second_mm = 1e3 * by_runge_kutta(&columns, &ground, &run, 4e-4);
            let found = rock_on_beds(&columns, &ground, &run).unwrap();
            assert!((second_mm / third_mm - 1.0).abs() < 2e-3, "{second_mm}");
            // the inertia of the rise: at most (V/N)² of that of the drift
            assert!(
                (1e3 * found.peak_drift_m / second_mm - 1.0).abs() < 0.01,
                "{found:?}"
            );
            assert!(found.peak_change <= 1e-3);
        }
    }

    #[test]
    fn agrees_with_scipy_beside_joints() {
        // DOP853 of SciPy 1.17 on the equation above, e of feet cut into 20 000 strips without tension: a hall of 10 t on 4 columns of
        // 0.4 × 0.4 × 3 m, beds 0.2 GPa/m, 1 kN/mm in all, 5 %; 1.1 Hz within a half sine of 8 s
        let section = FootSection::Rectangle {
            width_m: 0.4,
            breadth_m: 0.4,
        };
        let columns = FreeColumns::new(4, section, 3.0, 10e3 * G, Some(0.2e9)).unwrap();
        let run = ColumnRun {
            damping_ratio: 0.05,
            joints_n_m: 620_740.740_740_740_7,
            ..ColumnRun::of(10e3, 12.0)
        };
        for (scale, peak_mm) in [(0.3, 9.355_006), (0.5, 15.944_259), (1.0, 47.896_817)] {
            let values = (0..=400).map(|i| {
                let t = f64::from(i) * 0.02;
                1.5 * scale * (PI * t / 8.0).sin() * (2.0 * PI * 1.1 * t).sin()
            });
            let ground = TimeFunction::Sampled {
                time_step_s: 0.02,
                values: values.collect(),
            };
            let found = rock_on_beds(&columns, &ground, &run).unwrap();
            let off = 1e3 * found.peak_drift_m / peak_mm - 1.0;
            assert!(off.abs() < 2e-4, "{scale}: {off} {}", found.peak_drift_m);
            let lifts = if scale < 0.4 {
                ColumnOutcome::Stood
            } else {
                ColumnOutcome::Rocked
            };
            assert_eq!(found.outcome, lifts);
        }
    }

    #[test]
    fn holds_joints_hold_columns_that_do_not_stand_alone_up_to_the_drift_allowed() {
        let columns = gate(1e7); // a factor of 0.2 below the bed at which they would just stand
        let run = |joints_n_m| ColumnRun {
            joints_n_m,
            drift_most_m: 0.4,
            ..ColumnRun::of(32e3, 2.0)
        };
        let geometric_n_m = 32e3 * G / 4.0;
        let beds_n_m = columns.bed_stiffness_n_m().unwrap();
        let soft = 0.99 * (geometric_n_m - beds_n_m);
        assert!(rock_on_beds(&columns, &TimeFunction::Zero, &run(soft)).is_err());
        let found = rock_on_beds(&columns, &TimeFunction::Constant(0.01), &run(2.0 * geometric_n_m)).unwrap();
        assert_eq!(found.outcome, ColumnOutcome::Stood);
        assert!((found.falls_drift_m - 0.4).abs() < 1e-9, "{found:?}");
        let pushed = rock_on_beds(&columns, &TimeFunction::Constant(4.0), &run(2.0 * geometric_n_m)).unwrap();
        assert!(matches!(pushed.outcome, ColumnOutcome::Fell { .. }), "{pushed:?}");
    }

    #[test]
    fn holds_dashpots_in_the_beds_brake_less_where_feet_have_lifted_off() {
        let run = ColumnRun {
            damping_ratio: 0.03,
            ..ColumnRun::of(32e3, 12.0)
        };
        let peak_m = |dashpots, peak_g| {
            let run = ColumnRun { dashpots, ..run };
            rock_on_beds(&gate(4e9), &el_centro(peak_g), &run)
                .unwrap()
                .peak_drift_m
        };
        let [beds, constant] = [ColumnDashpots::InBeds, ColumnDashpots::Constant];
        // without lift-off they are alike
        assert!((peak_m(beds, 0.01) / peak_m(constant, 0.01) - 1.0).abs() < 1e-6);
        assert!(peak_m(beds, 0.2) > 1.1 * peak_m(constant, 0.2));
    }

    #[test]
    fn agrees_with_the_rigid_block_without_losses_as_beds_stiffen() {
        let alpha = (0.5_f64 / 4.0).atan();
        let block = RockingBlock {
            velocity_ratio: 1.0,
            ..RockingBlock::frame_on_columns(0.5, 4.0, f64::INFINITY, G).unwrap()
        };
        let options = Rocking {
            start_rad: 0.5 * alpha,
            duration_s: Some(2.0),
            ..Rocking::default()
        };
        let rigid = rock_block(&block, &TimeFunction::Zero, &TimeFunction::Zero, &options).unwrap();
        let first_s = rigid.impacts[0].at_s;
        let mut errors = Vec::new();
        for bed in [1e11, 1e13] {
            let run = ColumnRun {
                start_rad: Some(0.5 * alpha),
                output_step_s: 1e-4,
                ..ColumnRun::of(32e3, 2.0)
            };
            let found = rock_on_beds(&gate(bed), &TimeFunction::Zero, &run).unwrap();
            let passes = found.drift_m.iter().position(|drift| *drift < 0.0).unwrap();
            errors.push(found.time_s[passes] / first_s - 1.0);
        }
        assert!(errors[0] > errors[1] && errors[1].abs() < 5e-3, "{errors:?}");
    }

    #[test]
    fn holds_a_lean_starts_in_balance_and_falls_where_the_force_is_spent() {
        let columns = gate(4e9);
        let standing = columns.standing().unwrap().unwrap();
        let most = standing.greatest.force_n / columns.axial_n();
        let run = |tilt| ColumnRun {
            tilt,
            damping_ratio: 0.05,
            ..ColumnRun::of(32e3, 5.0)
        };
        let leaning = rock_on_beds(&columns, &TimeFunction::Zero, &run(0.9 * most)).unwrap();
        assert_eq!(leaning.outcome, ColumnOutcome::Rocked);
        assert!(
            (leaning.peak_drift_m / leaning.rest_drift_m - 1.0).abs() < 1e-6,
            "{leaning:?}"
        );
        let force_n = columns.restoring_n(columns.rotation_at_rad(leaning.rest_drift_m).unwrap());
        assert!((force_n / (0.9 * most * columns.axial_n()) - 1.0).abs() < 1e-6);
        let beyond = rock_on_beds(&columns, &TimeFunction::Zero, &run(-1.01 * most)).unwrap();
        assert_eq!(beyond.outcome, ColumnOutcome::Fell { at_s: 0.0 });
        let pushed = rock_on_beds(&columns, &TimeFunction::Constant(0.12 * G), &run(0.0)).unwrap();
        assert!(matches!(pushed.outcome, ColumnOutcome::Fell { at_s } if at_s > 0.0));
    }

    #[test]
    fn refuses_rigid_beds_and_columns_that_do_not_stand() {
        let rigid =
            FreeColumns::new(4, FootSection::Circle { diameter_m: 0.5 }, 4.0, 32e3 * G, None).unwrap();
        for columns in [rigid, gate(1e7)] {
            let why = rock_on_beds(&columns, &TimeFunction::Zero, &ColumnRun::of(32e3, 1.0)).unwrap_err();
            assert!(
                matches!(
                    why,
                    DynamicsError::Argument {
                        argument: "bed_stiffness_n_m3",
                        ..
                    }
                ),
                "{why}"
            );
        }
        let run = ColumnRun {
            start_rad: Some(0.2),
            ..ColumnRun::of(32e3, 1.0)
        };
        assert!(rock_on_beds(&gate(4e9), &TimeFunction::Zero, &run).is_err());
    }
}
