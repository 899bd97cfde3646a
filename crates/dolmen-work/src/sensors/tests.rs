use super::*;
use dolmen_records::NoFiles;

fn example(name: &str) -> Opened {
    let text = match name {
        "twisting_floor" => include_str!("../../../../examples/twisting_floor/project.toml"),
        "wall" => include_str!("../../../../examples/wall/project.toml"),
        "three_storey_pagoda" => include_str!("../../../../examples/three_storey_pagoda/project.toml"),
        "two_directions" => include_str!("../../../../examples/naju_flagpole/two_directions.toml"),
        "naju_flagpole" => include_str!("../../../../examples/naju_flagpole/project.toml"),
        other => panic!("no example {other}"),
    };
    of(text)
}

fn of(text: &str) -> Opened {
    Opened::read(text.to_owned(), "p".to_owned(), &NoFiles).unwrap()
}

fn plan(opened: &Opened, count: usize) -> SensorsAnswer {
    let options = SensorsOptions {
        count: Some(count),
        ..SensorsOptions::default()
    };
    sensors(opened, &options).unwrap()
}

/// A floor on springs along x and along y that also rotates: three sensors at its corners must measure all modes, and two along one
/// axis must distinguish them.
#[test]
fn holds_three_sensors_see_a_floor_sway_both_ways_and_turn() {
    let answer = plan(&example("twisting_floor"), 3);
    let axes: Vec<&Axis> = answer.sensors.iter().map(|sensor| &sensor.site.axes[0]).collect();
    let along = |axis: &Axis| axes.iter().filter(|of| **of == axis).count();
    assert_eq!(
        (
            along(&Axis::X) + along(&Axis::Y),
            along(&Axis::X).min(along(&Axis::Y))
        ),
        (3, 1)
    );
    assert!(
        answer
            .modes
            .iter()
            .all(|mode| mode.taken_for().is_none() && !mode.is_hardly_seen())
    );
    // one sensor measures at most one mode: every pair of the others looks alike
    let one = plan(&example("twisting_floor"), 1);
    assert!(
        one.modes
            .iter()
            .all(|mode| mode.is_hardly_seen() || mode.taken_for().is_some_and(|(_, mac)| mac > 0.999))
    );
}

/// The displacement of a place on a rigid floor, written independently: u − θ (y − y_c), v + θ (x − x_c).
#[test]
fn exact_corners_of_a_floor_move_as_it_turns() {
    let opened = example("twisting_floor");
    let found = model::model(&opened.project, 3, 1).unwrap();
    let dolmen_project::Structure::Building(part) = &opened.project.structure else {
        unreachable!("it is a building")
    };
    let modes = part.as_written().unwrap().building().modes().unwrap();
    let (floors, _) = part
        .floors_and_storeys(&mut dolmen_project::Quantity::nominal)
        .unwrap();
    let centre = floors[0].centre_m;
    assert_eq!(found.sites.len(), 8);
    for (site, channels) in found.sites.iter().zip(&found.rows) {
        for (mode, displacement) in modes.modes.iter().zip(&channels[0]) {
            let [x, y] = [site.position_m[0] - centre[0], site.position_m[1] - centre[1]];
            let expected = match site.axes[0] {
                Axis::X => mode.shape[0] - mode.shape[2] * y,
                _ => mode.shape[1] + mode.shape[2] * x,
            };
            assert!((displacement - expected).abs() < 1e-15 * expected.abs().max(1.0));
        }
    }
}

#[test]
fn holds_no_sensor_stands_in_a_joint_or_above_the_reach() {
    let opened = example("wall");
    let answer = plan(&opened, 6);
    let found = model::model(&opened.project, 6, 1).unwrap();
    // two leaves of stones, front and back, have free sides; ends are free only at the end of the wall, tops only in the last course
    let tops: Vec<&Site> = found.sites.iter().filter(|site| site.side == Side::Top).collect();
    let height = tops.iter().map(|site| site.position_m[2]).fold(0.0, f64::max);
    assert!(
        tops.iter().all(|site| (site.position_m[2] - height).abs() < 1e-9),
        "a top under a stone"
    );
    let width = found
        .sites
        .iter()
        .map(|site| site.position_m[0])
        .fold(0.0, f64::max);
    let ends = found
        .sites
        .iter()
        .filter(|site| matches!(site.side, Side::Left | Side::Right));
    assert!(
        ends.clone().count() > 0
            && ends
                .clone()
                .all(|site| (site.position_m[0].abs() - width).abs() < 1e-9)
    );
    assert!(answer.sites == found.sites.len());
    let low = SensorsOptions {
        count: Some(3),
        up_to_m: Some(0.7),
        ..SensorsOptions::default()
    };
    let low = sensors(&opened, &low).unwrap();
    assert!(low.sensors.iter().all(|sensor| sensor.site.position_m[2] <= 0.7));
}

#[test]
fn holds_references_stay_in_every_setup_and_see_every_mode_of_a_tower() {
    let how = SensorsOptions {
        count: Some(4),
        setups: 3,
        references: 2,
        modes: Some(2),
        ..SensorsOptions::default()
    };
    let answer = sensors(&example("three_storey_pagoda"), &how).unwrap();
    let setups: Vec<Option<usize>> = answer.sensors.iter().map(|sensor| sensor.setup).collect();
    assert_eq!(
        setups,
        [None, None, Some(0), Some(0), Some(1), Some(1), Some(2), Some(2)]
    );
    let axes: Vec<&Axis> = answer.sensors[..2]
        .iter()
        .map(|sensor| &sensor.site.axes[0])
        .collect();
    assert_ne!(axes[0], axes[1], "the first two modes sway along x and y");
    let heights: Vec<f64> = answer.sensors[2..]
        .iter()
        .map(|sensor| sensor.site.position_m[2])
        .collect();
    assert!(heights.windows(2).all(|pair| pair[0] >= pair[1]));
}

#[test]
fn holds_a_pole_without_stiffness_has_shapes_and_no_frequencies() {
    let answer = plan(&example("naju_flagpole"), 2);
    assert_eq!(answer.of, SensorsOf::EqualJoints);
    assert!(answer.modes.iter().all(|mode| mode.frequency_hz.is_none()));
    let top = answer
        .sensors
        .iter()
        .map(|sensor| sensor.site.position_m[2])
        .fold(0.0, f64::max);
    assert!(
        (top - 10.83).abs() < 1e-9,
        "the top moves most in every mode: {top}"
    );
}

#[test]
fn refuses_counts_that_do_not_go_together() {
    let pole = example("naju_flagpole");
    let refused = |how: SensorsOptions| sensors(&pole, &how).unwrap_err().to_string();
    let of = SensorsOptions::default;
    assert!(
        refused(SensorsOptions {
            count: Some(6),
            ..of()
        })
        .contains("6 sensors in all setups, but there are 5 places")
    );
    assert!(
        refused(SensorsOptions {
            count: Some(0),
            ..of()
        })
        .contains("--count is 0")
    );
    assert!(refused(SensorsOptions { axes: 4, ..of() }).contains("--axes is 4"));
    // a pole moves in one plane, a floor along x and y
    assert!(refused(SensorsOptions { axes: 2, ..of() }).contains("each place of the model moves, 1:"));
    let floor = sensors(&example("twisting_floor"), &SensorsOptions { axes: 3, ..of() });
    assert!(floor.unwrap_err().to_string().contains("give --axes 2;"));
    assert!(refused(SensorsOptions { setups: 2, ..of() }).contains("no sensor stays"));
    assert!(
        refused(SensorsOptions {
            setups: 2,
            references: 4,
            ..of()
        })
        .contains("less than --count, 4")
    );
    assert!(
        refused(SensorsOptions {
            references: 1,
            ..of()
        })
        .contains("one setup")
    );
    assert!(
        refused(SensorsOptions {
            up_to_m: Some(0.5),
            ..of()
        })
        .contains("below 0.5 m")
    );
    let survey = of_survey();
    assert!(
        sensors(&survey, &of())
            .unwrap_err()
            .to_string()
            .contains("surveys alone")
    );
}

fn of_survey() -> Opened {
    of("schema = 1\nkind = \"survey\"\nname = \"s\"\n[survey.\"2026\"]\nfrequencies = { x = [4.6] }\n")
}

/// A pole on oblong beds moves in two planes: its modes are those of both, computed one by one.
#[test]
fn agrees_a_chain_with_two_directions_is_planned_in_both() {
    let opened = example("two_directions");
    let dolmen_project::Structure::Chain(part) = &opened.project.structure else {
        unreachable!("it is a chain")
    };
    let frequencies = |axis: dolmen_project::ChainAxis| -> Vec<(f64, String)> {
        let pick = &mut dolmen_project::Quantity::nominal;
        let chain = part.build_loaded(axis, &opened.project.loads, pick).unwrap();
        let stiffness = part.stiffness_towards(axis, pick).unwrap();
        let modes = chain.natural_modes(&stiffness).unwrap().into_iter();
        modes
            .map(|mode| (mode.frequency_hz, axis.name().to_owned()))
            .collect()
    };
    let mut exact: Vec<(f64, String)> = part.axes().iter().flat_map(|axis| frequencies(*axis)).collect();
    exact.sort_by(|a, b| a.0.total_cmp(&b.0));
    let answer = plan(&opened, 4);
    let found: Vec<(f64, String)> = answer
        .modes
        .iter()
        .map(|mode| (mode.frequency_hz.unwrap(), mode.direction.clone().unwrap()))
        .collect();
    assert_eq!(found, exact[..found.len()]);
    let axes: std::collections::BTreeSet<&str> = answer
        .sensors
        .iter()
        .filter_map(|sensor| sensor.site.axes[0].key())
        .collect();
    assert_eq!(axes.into_iter().collect::<Vec<_>>(), ["x", "y"]);
    // two sensors of two axes each see every mode
    let options = SensorsOptions {
        count: Some(2),
        axes: 2,
        ..SensorsOptions::default()
    };
    assert!(
        sensors(&opened, &options)
            .unwrap()
            .modes
            .iter()
            .all(|mode| !mode.is_hardly_seen())
    );
}
