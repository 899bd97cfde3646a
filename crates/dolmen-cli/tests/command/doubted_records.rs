// SOURCE     Free decays made from the modes of a gate and of a floor with known stiffness, with sensors exchanged, reversed or misnamed.
// GOAL       `identify`, `compare` and `check` first name the error of sensors, axes or sampling rate that would explain the data, before
//            any number.
// TOLERANCE  stiffness 1 % and centres of rigidity 2 cm: the effect of noise of a thousandth on a decay of 20 s.

use super::verbs::Scratch;
use dolmen::numeric::Random;
use dolmen::structure::building::{Floor, PDelta, Storey as Below, StoreyStiffness};
use dolmen::structure::{Building, Convention, Frame, Storey};
use serde_json::Value;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;

/// Modes as frequency, Hz, and components of the channels.
type Decaying = Vec<(f64, Vec<f64>)>;

/// 20 s of a free decay with noise of a thousandth, as CSV; each take has different noise.
fn decay(modes: &Decaying, names: &[&str], take: u64) -> String {
    let rate_hz = 50.0;
    let mut text = names.join(",") + "\n";
    let mut random = Random::new(20261126, take);
    for sample in 0..(20.0 * rate_hz) as usize {
        let t = sample as f64 / rate_hz;
        let value = |channel: usize| {
            let each = modes.iter().enumerate().map(|(at, (f, shape))| {
                let omega = TAU * f;
                shape[channel] * (-0.01 * omega * t).exp() * (omega * t + 0.7 * at as f64).cos()
            });
            each.sum::<f64>()
        };
        let row: Vec<String> = (0..names.len())
            .map(|c| format!("{:.6e}", value(c) + 1e-3 * random.normal()))
            .collect();
        writeln!(text, "{}", row.join(",")).unwrap();
    }
    text
}

const GATE_CHANNELS: [&str; 4] = ["x1", "x2", "y1", "y2"];

/// x 30 and 18, y 45 and 30 MN/m.
fn gate_modes() -> Decaying {
    let storey = |mass_kg: f64, height_m: f64, above_kg: f64| Storey {
        mass_kg,
        height_m,
        axial_n: above_kg * 9.80665,
    };
    let storeys = vec![storey(180e3, 4.8, 300e3), storey(120e3, 4.1, 120e3)];
    let frame = Frame::new(storeys, Convention::Drift).unwrap();
    let along = |k: [f64; 2], at: usize| {
        let modes = frame.natural_modes(&k).unwrap();
        modes.into_iter().map(move |mode| {
            let mut shape = vec![0.0; 4];
            shape[at..at + 2].copy_from_slice(&mode.displacement);
            (mode.frequency_hz, shape)
        })
    };
    along([30e6, 18e6], 0).chain(along([45e6, 30e6], 2)).collect()
}

/// A survey: its name, level and direction of each channel, its sampling rate.
type Placed<'a> = (&'a str, [(usize, &'a str); 4], f64);

/// A gate with the given stiffness, and its record read with these positions: level and direction of each channel.
fn gate(stiffness: &str, surveys: &[Placed<'_>]) -> String {
    let mut text = format!(
        "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nevidence = \"measured\"\nunits = {{ length = \"m\", mass = \"t\", stiffness = \"kN/mm\" }}\n\
         storeys = [{{ name = \"low\", mass = 180, height = 4.8 }}, {{ name = \"high\", mass = 120, height = 4.1 }}]\n{stiffness}\n"
    );
    for (name, places, rate_hz) in surveys {
        let channel = |(column, (level, direction)): (&&str, &(usize, &str))| {
            let z = [4.8, 8.9][*level];
            format!("  {{ column = \"{column}\", position = [0, 0, {z}], direction = \"{direction}\" }},\n")
        };
        let channels: String = GATE_CHANNELS.iter().zip(places).map(channel).collect();
        write!(
            text,
            "[survey.{name}.records]\nfile = \"gate-{name}.csv\"\nsampling_rate = \"{rate_hz} Hz\"\nunit = \"m/s2\"\nchannels = [\n{channels}]\n\
             [survey.{name}.records.modal]\nmethod = \"era\"\n"
        )
        .unwrap();
    }
    text
}

const RIGHT: [(usize, &str); 4] = [(0, "x"), (1, "x"), (0, "y"), (1, "y")];
const UNKNOWN: &str = "direction.x.stiffness = \"unknown\"\ndirection.y.stiffness = \"unknown\"";

fn of_gate(name: &str, project: &str) -> Scratch {
    let scratch = Scratch::new(name);
    let files = project.lines().filter_map(|line| line.strip_prefix("file = \""));
    for (file, take) in files.zip(1..) {
        let text = decay(&gate_modes(), &GATE_CHANNELS, take);
        fs::write(scratch.path().join(file.trim_end_matches('"')), text).unwrap();
    }
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    scratch
}

fn json(scratch: &Scratch, words: &str) -> Value {
    let answer = scratch.briefly(&format!("{words} --json --quiet"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

fn chosen(of: &Value) -> Vec<bool> {
    let all = of["surveys"][0]["stiffness"].as_array().unwrap();
    let own = all.iter().filter(|one| one["convention"] == "drift");
    own.map(|one| one["is_chosen"].as_bool().unwrap()).collect()
}

#[test]
fn exact_a_gates_record_gives_its_stiffness_and_nothing_is_doubted() {
    let scratch = of_gate("doubt-none", &gate(UNKNOWN, &[("2025-04-02", RIGHT, 50.0)]));
    let found = json(&scratch, "identify project.toml");
    assert_eq!(chosen(&found), [true, true]);
    assert!(found["surveys"][0]["shape_doubt"].is_null());
    let k = found["surveys"][0]["stiffness"][0]["solutions"][0]["stiffness"][0]
        .as_f64()
        .unwrap();
    assert!((k / 30e6 - 1.0).abs() < 0.01, "{k}");
}

#[test]
fn holds_two_cables_exchanged_leave_nothing_green() {
    let mixed = [(0, "x"), (1, "y"), (0, "y"), (1, "x")];
    let scratch = of_gate("doubt-mixed", &gate(UNKNOWN, &[("2025-04-02", mixed, 50.0)]));
    assert!(!chosen(&json(&scratch, "identify project.toml")).contains(&true));
    let said = scratch.briefly("identify project.toml").words();
    assert!(
        said.contains("PROBABLY A SLIP") && said.contains("x2 and y2 exchanged"),
        "{said}"
    );
    assert!(!said.contains('●'), "{said}");
    let korean = scratch.briefly("identify project.toml --language ko").words();
    assert!(korean.contains("맞바꾸면") && !korean.contains('●'), "{korean}");
    let refused = scratch.briefly("identify project.toml --write");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    assert!(
        refused.stderr.contains("whose sensors are doubted"),
        "{}",
        refused.stderr
    );
}

#[test]
fn holds_a_sensor_turned_round_is_named_before_the_missing_root() {
    let turned = [(0, "x"), (1, "-x"), (0, "y"), (1, "y")];
    let scratch = of_gate("doubt-turned", &gate(UNKNOWN, &[("2025-04-02", turned, 50.0)]));
    let said = scratch.briefly("identify project.toml").words();
    assert!(said.contains("the sign of x2 changed"), "{said}");
    assert!(!said.contains('●'), "{said}");
}

#[test]
fn holds_found_stiffness_is_held_against_that_of_the_file() {
    let known = "direction.x.stiffness = [30, 18]\ndirection.y.stiffness = [45, 30]";
    let same = of_gate("doubt-file", &gate(known, &[("2025-04-02", RIGHT, 50.0)]));
    let said = same.briefly("identify project.toml").words();
    assert!(
        !said.contains("that of the file") && !said.contains("SLIP"),
        "{said}"
    );
    let axes = [(0, "y"), (1, "y"), (0, "x"), (1, "x")];
    let turned = of_gate("doubt-axes", &gate(known, &[("2025-04-02", axes, 50.0)]));
    let said = turned.briefly("identify project.toml").words();
    assert!(
        said.contains("PROBABLY A SLIP: survey 2025-04-02 finds in direction"),
        "{said}"
    );
    assert!(said.contains("the stiffness found is 1.5"), "{said}");
    let found = json(&turned, "identify project.toml");
    assert!(found["surveys"][0]["exchanged_directions"].is_array());
}

#[test]
fn holds_compare_names_exchanged_directions_before_a_change() {
    let axes = [(0, "y"), (1, "y"), (0, "x"), (1, "x")];
    let surveys = [("2025-04-02", RIGHT, 50.0), ("2026-04-02", axes, 50.0)];
    let scratch = of_gate("compare-axes", &gate(UNKNOWN, &surveys));
    let said = scratch.briefly("compare project.toml").words();
    let slip = said.find("directions x and y are exchanged in one of the surveys");
    assert!(slip.is_some(), "{said}");
    assert!(
        !said.contains("it fell by") && !said.contains("it rose by"),
        "{said}"
    );
    let same = of_gate(
        "compare-same",
        &gate(
            UNKNOWN,
            &[("2025-04-02", RIGHT, 50.0), ("2026-04-02", RIGHT, 50.0)],
        ),
    );
    assert!(!same.briefly("compare project.toml").words().contains("SLIP"));
}

#[test]
fn holds_compare_names_a_sampling_rate_that_explains_the_change() {
    for rate_hz in [49.0, 64.0] {
        let surveys = [("2025-04-02", RIGHT, 50.0), ("2026-04-02", RIGHT, rate_hz)];
        let scratch = of_gate(&format!("compare-rate-{rate_hz}"), &gate(UNKNOWN, &surveys));
        let said = scratch.briefly("compare project.toml").words();
        assert!(
            said.contains("the sampling rate of one survey is wrong"),
            "{rate_hz}: {said}"
        );
    }
}

const FLOOR_CHANNELS: [&str; 5] = ["ax", "ay", "bx", "by", "cy"];
const FLOOR_PLACES: [[f64; 2]; 5] = [[-7.0, -4.0], [-7.0, -4.0], [7.0, 4.0], [7.0, 4.0], [7.0, -4.0]];

/// k_x 130, k_y 90 MN/m, k_θ 8.2 GN·m/rad about (−2.67, −1.15) m from the centre of mass.
fn floor_modes() -> Decaying {
    let floor = Floor {
        mass_kg: 150e3,
        centre_m: [0.0, 0.0],
        gyration_m: ((256.0_f64 + 100.0) / 12.0).sqrt(),
        outline: None,
    };
    let below = Below {
        height_m: 4.5,
        stiffness: StoreyStiffness::at_centre(130e6, 90e6, 8.2e9, [-2.67, -1.15]),
    };
    let gravity_m_s2 = 9.80665;
    let building = Building::new(vec![floor], vec![below], PDelta::Weights { gravity_m_s2 }).unwrap();
    let modes = building.modes().unwrap().modes.into_iter();
    modes
        .map(|mode| {
            let [u, v, theta] = [0, 1, 2].map(|i| mode.shape[i] * 150e3_f64.sqrt());
            let seen =
                FLOOR_CHANNELS
                    .iter()
                    .zip(FLOOR_PLACES)
                    .map(|(name, [x, y])| match name.ends_with('x') {
                        true => u - theta * y,
                        false => v + theta * x,
                    });
            (mode.frequency_hz, seen.collect())
        })
        .collect()
}

/// `places` of the channels, `signs` of their directions.
fn floor(name: &str, places: &[[f64; 2]; 5], signs: &[&str; 5], survey: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(
        scratch.path().join("floor.csv"),
        decay(&floor_modes(), &FLOOR_CHANNELS, 1),
    )
    .unwrap();
    let channels: String = FLOOR_CHANNELS
        .iter()
        .zip(places.iter().zip(signs))
        .map(|(name, ([x, y], sign))| {
            let direction = &name[1..];
            format!("  {{ column = \"{name}\", position = [{x}, {y}, 4.5], direction = \"{sign}{direction}\" }},\n")
        })
        .collect();
    let text = format!(
        "schema = 1\nkind = \"building\"\nname = \"Hall\"\nevidence = \"measured\"\nunits = {{ length = \"m\", mass = \"t\", stiffness = \"kN/mm\" }}\n\
         floors = [{{ name = \"hall\", mass = 150, sides = [16, 10], height = 4.5, stiffness = {{ x = 100, y = 100, rotation = \"8000 MN*m/rad\", centre = [0, 0] }} }}]\n\
         damping.ratio = 0.02\n[survey.2025-04-02.records]\nfile = \"floor.csv\"\nsampling_rate = \"50 Hz\"\nunit = \"m/s2\"\nchannels = [\n{channels}]\n\
         [survey.2025-04-02.records.modal]\nmethod = \"era\"\n{survey}"
    );
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    scratch
}

const AS_IS: [&str; 5] = ["", "", "", "", ""];

#[test]
fn exact_a_floors_record_gives_stiffness_and_centre_of_rigidity() {
    // alone, and with the same frequencies also in the file: reported once
    let frequencies: Vec<f64> = floor_modes().into_iter().map(|(hz, _)| hz).collect();
    let [y, x, torsion] = frequencies[..] else {
        panic!("three modes")
    };
    let stated = format!(
        "[survey.2025-04-02.frequencies]\nx = [{{ value = {x:.3}, sd = 0.005 }}]\ny = [{{ value = {y:.3}, sd = 0.006 }}]\n\
         torsion = [{{ value = {torsion:.3}, sd = 0.007 }}]\n"
    );
    for (name, survey) in [("floor-record", String::new()), ("floor-stated", stated)] {
        let scratch = floor(name, &FLOOR_PLACES, &AS_IS, &survey);
        let found = json(&scratch, "identify project.toml");
        let plan = &found["surveys"][0]["plan"];
        assert_eq!(plan["eccentricity_from"], "twists", "{plan}");
        assert_eq!(plan["is_determined"], true, "{plan}");
        let one = &plan["solutions"][0];
        for (at, known) in [130e6, 90e6, 8.2e9].into_iter().enumerate() {
            let k = one["stiffness"][at].as_f64().unwrap();
            assert!((k / known - 1.0).abs() < 0.01, "{at}: {k} {known}");
        }
        for (at, known) in [-2.67, -1.15].into_iter().enumerate() {
            let e = one["eccentricity_m"][at].as_f64().unwrap();
            assert!((e - known).abs() < 0.02, "{at}: {e} {known}");
        }
        let said = scratch.briefly("identify project.toml").words();
        assert!(said.contains("● Stiffness from vibration"), "{said}");
        // the initial guess of the file differs
        assert!(said.contains("times those of the file"), "{said}");
        assert_eq!(scratch.briefly("identify project.toml --write").status, 0);
        let text = fs::read_to_string(scratch.path().join("project.toml")).unwrap();
        assert!(text.contains("centre = [\"-2.6"), "{text}");
    }
}

#[test]
fn holds_frequencies_alone_determine_no_stiffness_in_plan() {
    let frequencies: Vec<f64> = floor_modes().into_iter().map(|(hz, _)| hz).collect();
    let [y, x, torsion] = frequencies[..] else {
        panic!("three modes")
    };
    let scratch = Scratch::new("floor-alone");
    let text = format!(
        "schema = 1\nkind = \"building\"\nname = \"Hall\"\nevidence = \"measured\"\nunits = {{ length = \"m\", mass = \"t\", stiffness = \"kN/mm\" }}\n\
         floors = [{{ mass = 150, sides = [16, 10], height = 4.5, stiffness = {{ x = 100, y = 100, rotation = \"8000 MN*m/rad\", centre = [0, 0] }} }}]\n\
         damping.ratio = 0.02\n[survey.2025-04-02.frequencies]\nx = [{{ value = {x}, sd = 0.005 }}]\ny = [{{ value = {y}, sd = 0.006 }}]\n\
         torsion = [{{ value = {torsion}, sd = 0.007 }}]\n"
    );
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let said = scratch.briefly("identify project.toml").words();
    assert!(
        said.contains("3 frequencies do not tell where the centre of rigidity is"),
        "{said}"
    );
    assert!(!said.contains('●') && !said.contains("--write"), "{said}");
    let refused = scratch.briefly("identify project.toml --write");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    assert!(
        refused.stderr.contains("centre of rigidity"),
        "{}",
        refused.stderr
    );
    // the truth is within the bounds; the solution with the file's centre is 67 standard deviations off
    let found = json(&scratch, "identify project.toml");
    let bounds = &found["surveys"][0]["plan"]["bounds"]["stiffness"];
    for (at, known) in [130e6, 90e6, 8.2e9].into_iter().enumerate() {
        let [least, most] = [0, 1].map(|end| bounds[at][end].as_f64().unwrap());
        assert!(least < known && known < most, "{at}: {least} {known} {most}");
    }
}

#[test]
fn holds_stations_exchanged_or_turned_by_half_a_turn_are_named() {
    let [a, b, c] = [FLOOR_PLACES[0], FLOOR_PLACES[2], FLOOR_PLACES[4]];
    let moved = floor("floor-moved", &[b, b, a, a, c], &AS_IS, "");
    let said = moved.briefly("identify project.toml").words();
    assert!(
        said.contains("PROBABLY A SLIP") && said.contains("exchanged for"),
        "{said}"
    );
    assert!(
        said.contains("is no motion of a rigid floor") && !said.contains('●'),
        "{said}"
    );
    let turned = floor("floor-turned", &FLOOR_PLACES, &["-", "-", "", "", ""], "");
    let said = turned.briefly("identify project.toml").words();
    assert!(said.contains("is that station turned by 180°"), "{said}");
}

#[test]
fn holds_a_stack_that_no_factor_explains_has_no_green_line() {
    let scratch = Scratch::with_examples("stack-misses");
    let path = scratch.path().join("examples/three_storey_pagoda/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    let survey =
        "\n[survey.2024-01-01.frequencies]\nx = [{ value = 2, sd = 0.01 }]\ny = [{ value = 6, sd = 0.03 }]\n";
    fs::write(&path, text + survey).unwrap();
    let said = scratch
        .briefly("identify examples/three_storey_pagoda --survey 2024-01-01")
        .words();
    assert!(
        said.contains("no one factor for all springs of the file explains"),
        "{said}"
    );
    assert!(!said.contains('●'), "{said}");
}

#[test]
fn holds_check_says_how_near_measured_frequencies_are() {
    let survey = |hz: f64| {
        format!(
            "direction.x.stiffness = [30, 18]\n[survey.2025-04-02.frequencies]\nx = [{{ value = {hz}, sd = 0.005, source = \"measured\" }}]\n"
        )
    };
    let lowest = gate_modes()
        .into_iter()
        .map(|(hz, _)| hz)
        .fold(f64::INFINITY, f64::min);
    let off = of_gate("check-off", &gate(&survey(1.07 * lowest), &[]));
    let said = off.briefly("check project.toml").words();
    assert!(
        said.contains("counts as agreement (10 %), but is 7.0 % and")
            && said.contains("standard deviations off"),
        "{said}"
    );
    let near = of_gate("check-near", &gate(&survey(1.001 * lowest), &[]));
    let said = near.briefly("check project.toml").words();
    assert!(
        said.contains("The lowest measured frequencies agree with this model: direction x"),
        "{said}"
    );
}

#[test]
fn exact_more_modes_along_a_direction_than_storeys_choose_no_stiffness_and_name_each() {
    // a sensor on the column at x = 3 m sees torsion (0.9 Hz) along y, as the sway (1.2 Hz)
    let modes = vec![
        (0.9, vec![0.0, 1.5]),
        (1.2, vec![0.0, 1.0]),
        (1.5, vec![1.0, 0.0]),
    ];
    let scratch = Scratch::new("doubt-more-modes");
    fs::write(scratch.path().join("gate.csv"), decay(&modes, &["x", "y"], 1)).unwrap();
    let project = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"kN/mm\" }\n\
        storeys = [{ name = \"columns\", mass = 20, height = 4 }]\n\
        direction.x.stiffness = \"identified\"\ndirection.y.stiffness = \"identified\"\n\
        [survey.2024-03-05.records]\nfile = \"gate.csv\"\nsampling_rate = \"50 Hz\"\nunit = \"m/s2\"\nchannels = [\n\
        { column = \"x\", position = [3, 0, 4], direction = \"x\" },\n\
        { column = \"y\", position = [3, 0, 4], direction = \"y\" },\n]\n\
        [survey.2024-03-05.records.modal]\nmethod = \"era\"\n";
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    let found = json(&scratch, "identify project.toml");
    assert_eq!(chosen(&found), [true, false]);
    let all = found["surveys"][0]["stiffness"].as_array().unwrap();
    let along_y = |of: &&Value| of["direction"] == "y" && of["convention"] == "drift";
    let along_y = all.iter().find(along_y).unwrap();
    assert_eq!(along_y["doubted"]["of"], "more_modes");
    // k = m ω² + m g/h
    let k = |hz: f64| 20e3 * ((TAU * hz).powi(2) + 9.80665 / 4.0);
    let [own, other] = [&along_y["solutions"][0], &along_y["other_choices"][0]]
        .map(|of| of["stiffness"][0].as_f64().unwrap());
    assert!(
        (own / k(0.9) - 1.0).abs() < 0.01 && (other / k(1.2) - 1.0).abs() < 0.01,
        "{own} {other}"
    );
    let said = scratch.briefly("identify project.toml").words();
    assert!(
        said.contains("kN/m with 0.900 Hz and") && said.contains("MN/m with 1.200 Hz."),
        "{said}"
    );
    let said = scratch.briefly("check project.toml").words();
    assert!(said.contains("VERDICT Own weight: unknown"), "{said}");
}
