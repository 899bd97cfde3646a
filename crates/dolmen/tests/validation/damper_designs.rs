// SOURCE     The floors of dampers.rs; exact tunings of one mode (tuned_mass.rs).
// GOAL       Plans give the results of the assembled matrices; designs for one mode are exact; for a twisting floor, no neighbour of a design or map
//            is better.
// PARAMETERS as in dampers.rs; one mode as a floor that moves along y only.
// TOLERANCE  1e-5 between maps and Lyapunov (lightest damping, far from the prepared frequencies), 1e-6 from exact tunings; designs: no neighbour 1 %
//            away is better.

use crate::dampers::{second_floor, twisting_floor, white_y, with_modal_damping, y_at};
use dolmen::damper::{
    Aim, AttachedDamper, DamperError, DamperKind, DamperProblem, DamperSite, Design, DesignEnd,
    DesignOptions, Detuned, Freedom, Goal, MapTuning, Place, PlacedDamper, Plan, PlanOptions,
    PositionMapOptions, SingleMode, TogetherOptions, TuningRule, cost_of, design, goal_cost, optimal_tuning,
    position_map, robustness, rule_tuning, tune_together,
};
use dolmen::dynamics::{LinearSystem, RandomInput, RandomLoad, Spectrum};
use dolmen_linalg::Matrix;
use std::f64::consts::TAU;

fn site() -> DamperSite {
    DamperSite {
        first_degree_of_freedom: 0,
        reference_m: [0.0, 0.0],
        corners_m: vec![[-5.0, -4.0], [5.0, -4.0], [5.0, 4.0], [-5.0, 4.0]],
    }
}

fn edges(structure: LinearSystem) -> DamperProblem {
    DamperProblem {
        structure,
        loads: vec![white_y()],
        points: vec![y_at(-5.0), y_at(5.0)],
        sites: vec![site()],
        fixed: Vec::new(),
    }
}

/// The paper's damper at a place.
fn start(structure: &LinearSystem, place_m: [f64; 2]) -> PlacedDamper {
    let modes = structure.modes().unwrap();
    let tuning = rule_tuning(TuningRule::DenHartog, 0.05, 0.0).unwrap();
    PlacedDamper {
        site: 0,
        place_m,
        direction_degrees: 90.0,
        mass_kg: 0.05 / modes.shapes[(1, 0)].powi(2),
        frequency_hz: tuning.frequency_ratio * modes.angular_frequency_rad_s[0] / TAU,
        damping_ratio: tuning.damping_ratio,
        length_ratio: 1.0,
    }
}

fn plan(structure: LinearSystem) -> (Plan, PlacedDamper) {
    let start = start(&structure, [0.25, 0.0]);
    (
        Plan::new(edges(structure), &[start], &PlanOptions::default()).unwrap(),
        start,
    )
}

fn close(given: f64, expected: f64, tolerance: f64) {
    assert!((given - expected).abs() <= tolerance, "{given} {expected}");
}

/// A floor whose first mode moves along y only, at 1 rad/s, far below the others.
fn one_mode(zeta: f64, base: bool) -> DamperProblem {
    let k = Matrix::from_diagonal(&[900.0, 1.0, 9000.0]);
    let input = match base {
        true => RandomInput::Base(vec![0.0, 1.0, 0.0]),
        false => RandomInput::Force(y_at(0.0)),
    };
    DamperProblem {
        structure: with_modal_damping(Matrix::from_diagonal(&[1.0, 1.0, 10.0]), k, zeta),
        loads: vec![RandomLoad {
            input,
            spectrum: Spectrum::unit_white(),
        }],
        points: vec![y_at(0.0)],
        sites: vec![site()],
        fixed: Vec::new(),
    }
}

#[test]
fn exact_designs_of_one_mode() {
    for (base, goal, aim) in [
        (false, Goal::LargestRms, Aim::ForceRandom),
        (true, Goal::MeanSquare, Aim::BaseRandom),
        (false, Goal::LargestPeak, Aim::ForceHarmonic),
        (true, Goal::LargestPeak, Aim::BaseHarmonic),
    ] {
        let mode = SingleMode {
            mass_ratio: 0.05,
            structure_damping_ratio: 0.02,
        };
        let damper = PlacedDamper {
            site: 0,
            place_m: [0.0, 0.0],
            direction_degrees: 90.0,
            mass_kg: 0.05,
            frequency_hz: 0.93 / TAU,
            damping_ratio: 0.17,
            length_ratio: 1.0,
        };
        let plan = Plan::new(one_mode(0.02, base), &[damper], &PlanOptions::default()).unwrap();
        let options = DesignOptions {
            goal,
            place: Place::Kept,
            ..DesignOptions::default()
        };
        let found = design(&plan, &[damper], &options).unwrap();
        assert_eq!(found.end, DesignEnd::Optimum);
        let exact = optimal_tuning(&mode, aim).unwrap();
        close(
            found.dampers[0].frequency_hz * TAU,
            exact.tuning.frequency_ratio,
            1e-6,
        );
        close(found.dampers[0].damping_ratio, exact.tuning.damping_ratio, 1e-6);
        let cost = if goal == Goal::LargestPeak {
            exact.cost
        } else {
            exact.cost.sqrt()
        };
        close(found.cost / cost, 1.0, 1e-6);
    }
}

#[test]
fn holds_place_and_tuning_together_leave_nothing_better_beside_them() {
    let (plan, start) = plan(second_floor());
    let along_x = DesignOptions {
        place: Place::AlongX,
        ..DesignOptions::default()
    };
    // three starting places give the same design
    let found: Vec<Design> = [-4.0, 0.25, 4.0]
        .into_iter()
        .map(|x| {
            let from = PlacedDamper {
                place_m: [x, 0.0],
                ..start
            };
            design(&plan, &[from], &along_x).unwrap()
        })
        .collect();
    let best = &found[0];
    for other in &found {
        assert_eq!(other.end, DesignEnd::Optimum);
        close(other.cost / best.cost, 1.0, 1e-9);
    }
    let damper = best.dampers[0];
    let omega = plan.mode_frequency_hz(0).unwrap();
    // here: 2.0314 at x = 0.445 m, against 2.0664 of the fixed tuning at x = 0.13 m and 4.5851 of the rule's point
    close(damper.place_m[0], 0.4447, 5e-5);
    close(damper.frequency_hz / omega, 0.977_345, 5e-6);
    close(damper.damping_ratio, 0.116_530, 5e-6);
    close(best.judged.point_rms[0], 2.031_440, 5e-6);
    close(best.judged.point_rms[1], 2.031_440, 5e-6);
    let rule = PlacedDamper {
        place_m: [-5.0, 0.0],
        ..start
    };
    close(
        goal_cost(&plan, &[rule], Goal::LargestRms).unwrap() / plan.without()[1],
        1.0481,
        5e-5,
    );
    let larger = |damper: PlacedDamper| {
        let rms = plan.exact(&[damper]).unwrap().point_rms;
        rms[0].max(rms[1])
    };
    for (dx, df, dz) in [
        (0.05, 1.0, 1.0),
        (-0.05, 1.0, 1.0),
        (0.0, 1.005, 1.0),
        (0.0, 0.995, 1.0),
        (0.0, 1.0, 1.03),
        (0.0, 1.0, 0.97),
        (0.05, 1.002, 1.01),
        (-0.05, 0.998, 0.99),
        (0.05, 0.998, 1.0),
        (-0.05, 1.002, 1.0),
    ] {
        let other = PlacedDamper {
            place_m: [damper.place_m[0] + dx, 0.0],
            frequency_hz: damper.frequency_hz * df,
            damping_ratio: damper.damping_ratio * dz,
            ..damper
        };
        assert!(larger(other) > best.cost * (1.0 + 1e-9), "{dx} {df} {dz}");
    }
}

#[test]
fn holds_maps_judge_as_assembled_matrices_do() {
    for structure in [twisting_floor(), second_floor()] {
        let (plan, start) = plan(structure);
        let mut options = PositionMapOptions::over_site(&plan, 0, 9, 5).unwrap();
        for tuning in [
            MapTuning::Kept,
            MapTuning::Rule {
                rule: TuningRule::WarburtonForce,
                mode: 0,
                structure_damping_ratio: 0.02,
            },
            MapTuning::Best,
        ] {
            options.tuning = tuning;
            let map = position_map(&plan, &start, &options).unwrap();
            let cells: Vec<_> = map.cells.iter().flatten().collect();
            assert_eq!(cells.len(), 45);
            for cell in &cells {
                let near = cell.damper.frequency_hz < 1.3 * start.frequency_hz;
                let exact = plan.exact(&[cell.damper]).unwrap().point_rms;
                for (a, b) in exact.iter().zip(&cell.point_rms) {
                    close(a / b, 1.0, if near { 1e-5 } else { 1e-3 });
                }
                assert_eq!(cell.cost, cell.point_rms[0].max(cell.point_rms[1]));
            }
            if tuning == MapTuning::Best {
                // a design from the best cell stays near it, and is a little better
                let best = map.best().unwrap();
                let kept = DesignOptions {
                    place: Place::Kept,
                    ..DesignOptions::default()
                };
                let again = design(&plan, &[best.damper], &kept).unwrap();
                close(again.cost / best.cost, 1.0, 1e-6);
            }
        }
    }
}

#[test]
fn holds_more_dampers_of_the_same_mass_do_better_and_share_it() {
    let (plan, start) = plan(twisting_floor());
    let one = design(&plan, &[start], &DesignOptions::default()).unwrap();
    let half = |place_m: [f64; 2], factor: f64| PlacedDamper {
        mass_kg: 0.5 * start.mass_kg,
        frequency_hz: factor * start.frequency_hz,
        damping_ratio: 0.07,
        place_m,
        ..start
    };
    let two = design(
        &plan,
        &[half([4.0, 0.0], 0.93), half([3.0, 0.0], 1.07)],
        &DesignOptions::default(),
    )
    .unwrap();
    assert!(two.cost < one.cost, "{} {}", two.cost, one.cost);
    let sum: f64 = two.dampers.iter().map(|damper| damper.mass_kg).sum();
    close(sum / start.mass_kg, 1.0, 1e-12);
    for (a, b) in two
        .judged
        .point_rms
        .iter()
        .zip(plan.judge(&two.dampers).unwrap().point_rms)
    {
        close(a / b, 1.0, 1e-6);
    }
}

#[test]
fn holds_a_stroke_limit_and_a_detuning_are_kept_to() {
    let (plan, start) = plan(twisting_floor());
    let kept = DesignOptions {
        place: Place::Kept,
        ..DesignOptions::default()
    };
    let free = design(&plan, &[start], &kept).unwrap();
    let limit = 0.7 * free.judged.stroke_rms_m[0];
    let limited = DesignOptions {
        stroke_rms_most_m: Some(limit),
        ..kept.clone()
    };
    let short = design(&plan, &[start], &limited).unwrap();
    assert!(short.judged.stroke_rms_m[0] <= limit * (1.0 + 1e-5), "{short:?}");
    assert!(short.judged.stroke_rms_m[0] > limit * 0.999); // and used up
    assert!(short.cost > free.cost);
    let tolerant = DesignOptions {
        detuning_ratio: 0.1,
        ..kept
    };
    let robust = design(&plan, &[start], &tolerant).unwrap();
    let worst = |of: &Design| {
        let points = robustness(
            &plan,
            &of.dampers,
            Goal::LargestRms,
            Detuned::Frequency,
            &[0.9, 1.0, 1.1],
        )
        .unwrap();
        points.iter().map(|point| point.cost).fold(0.0, f64::max)
    };
    assert!(
        worst(&robust) < worst(&free),
        "{} {}",
        worst(&robust),
        worst(&free)
    );
    assert!(robust.cost.is_finite() && robust.dampers[0].damping_ratio > free.dampers[0].damping_ratio);
}

#[test]
fn refuses_dampers_that_cannot_do_what_is_asked() {
    let (plan, start) = plan(twisting_floor());
    let outside = PlacedDamper {
        place_m: [6.0, 0.0],
        ..start
    };
    let fault = plan.judge(&[outside]).unwrap_err().to_string();
    assert_eq!(
        fault,
        "the damper at x = 6 m, y = 0 m stands 1.000 m outside its floor: move it inside the outline"
    );
    // mode 2 moves along x only: it does not move a damper along y
    let fault = plan.modal_mass_kg(1, &start).unwrap_err();
    assert!(matches!(fault, DamperError::ModeStill { mode: 2, .. }));
    assert!(fault.to_string().contains("it moves only in x here"), "{fault}");
    // the centre of mode 3 lies on the floor
    let centre = PlacedDamper {
        place_m: [0.584_592_635_5, 0.0],
        ..start
    };
    let fault = plan.modal_mass_kg(2, &centre).unwrap_err().to_string();
    assert!(fault.contains("its centre lies here"), "{fault}");
    let options = DesignOptions {
        goal: Goal::LargestPeak,
        detuning_ratio: 0.1,
        ..DesignOptions::default()
    };
    let fault = design(&plan, &[start], &options).unwrap_err().to_string();
    assert!(fault.starts_with("detuning_ratio is 0.1"), "{fault}");
    let options = DesignOptions {
        frequency: Freedom::Kept,
        weights: vec![1.0],
        ..DesignOptions::default()
    };
    assert!(design(&plan, &[start], &options).is_err());
}

#[test]
fn holds_no_tuning_of_a_fine_grid_is_better_than_that_of_the_map() {
    // at good and bad places of the damper, each place alone and as part of a map
    for structure in [twisting_floor(), second_floor()] {
        let (plan, start) = plan(structure);
        let options = PositionMapOptions::over_site(&plan, 0, 11, 3).unwrap();
        let map = position_map(&plan, &start, &options).unwrap();
        for cell in map.cells.iter().flatten().step_by(5) {
            let mut least = (f64::INFINITY, [0.0; 2]);
            for i in 0..31 {
                for j in 0..13 {
                    let factor = 0.5 * 4.0_f64.powf(f64::from(i) / 30.0);
                    let damper = PlacedDamper {
                        place_m: cell.damper.place_m,
                        frequency_hz: factor * start.frequency_hz,
                        damping_ratio: 0.01 * 200.0_f64.powf(f64::from(j) / 12.0),
                        ..start
                    };
                    let rms = plan.judge(&[damper]).unwrap().point_rms;
                    let cost = rms[0].max(rms[1]);
                    if cost < least.0 {
                        least = (cost, [factor, damper.damping_ratio]);
                    }
                }
            }
            assert!(
                cell.cost < least.0 * (1.0 + 1e-6),
                "{:?} {} {least:?}",
                cell.damper,
                cell.cost
            );
        }
    }
}

#[test]
fn agrees_several_dampers_of_all_kinds_tuned_together_leave_nothing_better_beside_them() {
    let structure = twisting_floor();
    let (plan, start) = plan(structure);
    let frequency_hz = start.frequency_hz;
    let given = [
        AttachedDamper {
            kind: start.kind(),
            row: y_at(4.0),
        },
        AttachedDamper {
            kind: DamperKind::LiquidColumn {
                liquid_mass_kg: start.mass_kg,
                length_ratio: 0.7,
                frequency_hz: 1.02 * frequency_hz,
                damping_ratio: 0.1,
            },
            row: y_at(-4.0),
        },
        AttachedDamper {
            kind: DamperKind::LiquidColumnMass {
                container_mass_kg: 0.2 * start.mass_kg,
                liquid_mass_kg: 0.3 * start.mass_kg,
                length_ratio: 0.6,
                frequency_hz: 1.9 * frequency_hz,
                damping_ratio: 0.1,
                liquid_frequency_hz: 1.9 * frequency_hz,
                liquid_damping_ratio: 0.1,
            },
            row: y_at(5.0),
        },
    ];
    let options = TogetherOptions::default();
    let found = tune_together(&plan, &given, &options).unwrap();
    let before = cost_of(&plan.exact_attached(&given).unwrap(), Goal::LargestRms);
    assert!(found.cost < before);
    // compared with assembled matrices: 1e-5 is the accuracy of the prepared frequencies
    for k in 0..3 {
        for (df, dz) in [(1.01, 1.0), (0.99, 1.0), (1.0, 1.05), (1.0, 0.95)] {
            let mut other = found.dampers.clone();
            match &mut other[k].kind {
                DamperKind::TunedMass {
                    frequency_hz,
                    damping_ratio,
                    ..
                }
                | DamperKind::LiquidColumn {
                    frequency_hz,
                    damping_ratio,
                    ..
                } => {
                    *frequency_hz *= df;
                    *damping_ratio *= dz;
                }
                DamperKind::LiquidColumnMass {
                    liquid_frequency_hz,
                    liquid_damping_ratio,
                    ..
                } => {
                    *liquid_frequency_hz *= df;
                    *liquid_damping_ratio *= dz;
                }
                DamperKind::Viscous { .. } => panic!(),
            }
            let cost = cost_of(&plan.exact_attached(&other).unwrap(), Goal::LargestRms);
            assert!(
                cost > found.cost * (1.0 - 1e-5),
                "{k} {df} {dz}: {cost} {}",
                found.cost
            );
        }
    }
}

#[test]
fn agrees_dampers_that_stay_are_part_of_the_structure() {
    // a column and a dashpot to the ground are fixed, and a mass is judged: prepared frequencies against assembled matrices
    for base in [false, true] {
        let mut problem = edges(twisting_floor());
        if base {
            problem.loads[0].input = RandomInput::Base(vec![0.3, 1.0, 0.0]);
        }
        let mass = start(&problem.structure, [3.0, 1.0]);
        problem.fixed = vec![
            AttachedDamper {
                kind: DamperKind::LiquidColumn {
                    liquid_mass_kg: 0.03,
                    length_ratio: 0.8,
                    frequency_hz: mass.frequency_hz,
                    damping_ratio: 0.07,
                },
                row: y_at(-3.0),
            },
            AttachedDamper::link(0.05, &y_at(5.0), &[0.0; 3]),
        ];
        let plan = Plan::new(problem, &[mass], &PlanOptions::default()).unwrap();
        let (exact, near) = (plan.exact(&[mass]).unwrap(), plan.judge(&[mass]).unwrap());
        for (a, b) in exact.point_rms.iter().zip(&near.point_rms) {
            close(a / b, 1.0, 1e-6);
        }
        close(exact.stroke_rms_m[0] / near.stroke_rms_m[0], 1.0, 1e-6);
        // all three as additional dampers on a plan without dampers
        let bare = Plan::new(
            DamperProblem {
                fixed: Vec::new(),
                ..plan.problem().clone()
            },
            &[mass],
            &PlanOptions::default(),
        )
        .unwrap();
        let mut all = plan.problem().fixed.clone();
        all.push(mass.attached(&plan.problem().sites, 3).unwrap());
        let together = bare.exact_attached(&all).unwrap();
        for (a, b) in together.point_rms.iter().zip(&exact.point_rms) {
            close(a / b, 1.0, 1e-12);
        }
        assert_eq!(together.stroke_rms_m.len(), 3);
        let apart = bare.judge_attached(&all).unwrap();
        for (a, b) in apart.stroke_rms_m.iter().zip(&together.stroke_rms_m) {
            close(a / b, 1.0, 1e-6);
        }
    }
}
