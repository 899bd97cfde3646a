// SOURCE     Statics and dynamics of one storey, written out here; V(u) of rectangular feet from the thrust line of theory page "frame".
// GOAL       Nothing of a file is dropped without a word in studies and runs of gates: components of a motion, its scale, crushed tenons, beds
//            that soften beside joints, wind on joints that slip.
// PARAMETERS in each test.
// TOLERANCE  1e-9 of a number that has a closed form; two runs of the same model agree to the last digit.

use super::verbs::Scratch;
use serde_json::Value;
use std::f64::consts::{PI, TAU};
use std::fs;

const G: f64 = 9.80665;

fn scratch(name: &str, project: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    // x, y and z: 1 to 2 Hz under a window, y half of x at another frequency, z a fifth
    let rows: Vec<String> = (0..=400)
        .map(|i| {
            let t = f64::from(i) * 0.02;
            let window = (PI * t / 8.0).sin();
            let [x, y, z] = [(1.1, 100.0), (1.7, 50.0), (4.0, 20.0)]
                .map(|(hz, peak): (f64, f64)| peak * window * (TAU * hz * t).sin());
            format!("{t:.2},{x},{y},{z}")
        })
        .collect();
    let text = format!("time_s,x (gal),y (gal),z (gal)\n{}\n", rows.join("\n"));
    fs::write(scratch.path().join("station.csv"), text).unwrap();
    scratch
}

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr))
}

fn number(value: &Value, pointer: &str) -> f64 {
    let found = value.pointer(pointer).and_then(Value::as_f64);
    found.unwrap_or_else(|| panic!("{pointer}: {value}"))
}

/// A gate of one storey of 10 t and 3 m with two directions.
fn gate(more: &str) -> String {
    format!(
        r#"schema = 1
kind = "frame"
name = "Gate"
evidence = "assumed"
storeys = [{{ name = "hall", mass = "10 t", height = 3 }}]
[direction.long]
along = "x"
stiffness = ["1 kN/mm"]
damping_ratio = 0.05
[direction.short]
along = "y"
stiffness = ["0.7 kN/mm"]
damping_ratio = 0.05
[motion.station]
file = "station.csv"
columns = {{ x = "x", y = "y", z = "z" }}
scale = 1.5
[motion.x_alone]
file = "station.csv"
columns = {{ x = "x" }}
scale = 1.5
[motion.y_alone]
file = "station.csv"
columns = {{ x = "y" }}
scale = 1.5
{more}"#
    )
}

/// The drifts of the runs of a study of one scan.
fn drifts(scratch: &Scratch, study: &str) -> Vec<f64> {
    let answer = scratch.dolmen(&format!("study project.toml --study {study} -o out"));
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let table = fs::read_to_string(scratch.path().join(format!("out/{study}/runs.csv"))).unwrap();
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let heads = rows.next().unwrap();
    let at = heads.iter().position(|head| *head == "peak_drift_m").unwrap();
    rows.map(|row| row[at].parse().unwrap()).collect()
}

#[test]
fn holds_a_study_of_one_direction_is_shaken_by_the_component_along_it_and_names_the_other() {
    let study = |name: &str, motion: &str, direction: &str| {
        format!(
            "[study.{name}]\nmotions = [\"{motion}\"]\ndirection = \"{direction}\"\nscale = [1, 2]\nrefine = 0\n"
        )
    };
    let more = [
        study("short", "station", "short"),
        study("short_alone", "y_alone", "short"),
        study("long", "station", "long"),
        study("long_alone", "x_alone", "long"),
    ];
    let scratch = scratch("gates_across", &gate(&more.concat()));
    assert_eq!(drifts(&scratch, "short"), drifts(&scratch, "short_alone"));
    assert_eq!(drifts(&scratch, "long"), drifts(&scratch, "long_alone"));
    for (study, acts, left_out) in [("short", "y", "x"), ("long", "x", "y")] {
        let said = scratch.dolmen(&format!("study project.toml --study {study} -o out"));
        let expected = format!(
            "of station only component {acts} acts, in direction {study}; component {left_out} does not"
        );
        assert!(said.words().contains(&expected), "{}", said.stdout);
        // 20 gal of z beside 100 gal of x, whatever acts
        assert!(said.words().contains("vertical components"), "{}", said.stdout);
    }
    let alone = scratch.dolmen("study project.toml --study long_alone -o out");
    assert!(!alone.words().contains("only component"), "{}", alone.stdout);
}

#[test]
fn exact_a_typed_scale_multiplies_that_of_the_file_as_levels_of_a_study_do() {
    let more = "[study.twice]\nmotions = [\"x_alone\"]\ndirection = \"long\"\nscale = [2]\nrefine = 0\n";
    let scratch = scratch("gates_scale", &gate(more));
    let run = |flags: &str| {
        json(
            &scratch,
            &format!("simulate project.toml --direction long --motion x_alone {flags}"),
        )["simulations"][0]
            .clone()
    };
    let [once, twice] = ["", "--scale 2"].map(run);
    assert!((number(&once, "/motion/scale_factor") - 1.5).abs() < 1e-12);
    assert!((number(&twice, "/motion/scale_factor") - 3.0).abs() < 1e-12);
    let drift = |run: &Value| number(run, "/storeys/0/peak_drift_m").abs();
    assert!((drift(&twice) / drift(&once) - 2.0).abs() < 1e-9);
    // runs of a study are sampled twice as far apart, peaks are true ones
    assert!((drifts(&scratch, "twice")[0] / drift(&twice) - 1.0).abs() < 1e-9);
    let peak = run("--peak 0.2g");
    assert!((number(&peak, "/motion/components/0/peak_acceleration_m_s2") / (0.2 * G) - 1.0).abs() < 1e-12);
}

#[test]
fn holds_runs_say_the_vertical_component_that_does_not_act_with_its_peak() {
    let scratch = scratch("gates_vertical", &gate(""));
    let said = scratch.dolmen("simulate project.toml --motion station");
    // 20 gal × 1.5 at the largest sample
    assert!(
        said.words().contains("z, with a peak of 0.030"),
        "{}",
        said.stdout
    );
    let korean = scratch.dolmen("simulate project.toml --motion station --language ko");
    assert!(
        korean.words().contains("연직 성분 z(최대 0.030"),
        "{}",
        korean.stdout
    );
}

#[test]
fn holds_a_study_counts_crushed_tenons_as_a_run_does() {
    let scratch = Scratch::with_examples("gates_tenons");
    let file = "examples/heunginjimun_gate/loose_tenons.toml";
    let path = scratch.path().join(file);
    let study = "\n[study.growth]\nmotions = [\"el-centro\"]\nscale = [0.02, 1]\nrefine = 0\n";
    let text = fs::read_to_string(&path).unwrap();
    // nothing rubs: only tenons are damaged
    let text = text.replace("coefficient = 0.01", "coefficient = 0.0");
    fs::write(&path, text + study).unwrap();
    let run = json(&scratch, &format!("simulate {file} --motion el-centro"));
    let storeys = run["simulations"][0]["storeys"].as_array().unwrap().clone();
    let faces = storeys.iter().flat_map(|storey| {
        let faces = storey["tenons"]["faces_at_end"].as_array().unwrap().clone();
        faces.into_iter().map(|face| number(&face, "/crushed_m"))
    });
    let deepest = faces.fold(0.0, f64::max);
    assert!(deepest > 0.0);
    let answer = scratch.dolmen(&format!("study {file} --study growth -o out"));
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let text = fs::read_to_string(scratch.path().join("out/growth/study.json")).unwrap();
    let found: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(found["crushed_tenons"]["crushed"], 1);
    assert!((number(&found, "/crushed_tenons/depth_most_m") / deepest - 1.0).abs() < 1e-9);
    assert!((number(&found, "/crushed_tenons/least_m_s2") / (0.3 * G) - 1.0).abs() < 1e-9);
    let said = answer.words();
    assert!(
        said.contains("In 1 of 1 scan tenons crush, the weakest at 0.300 g"),
        "{said}"
    );
    let runs = fs::read_to_string(scratch.path().join("out/growth/runs.csv")).unwrap();
    let mut rows = runs.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let heads = rows.next().unwrap();
    let column = |name: &str| heads.iter().position(|head| *head == name).unwrap();
    let states: Vec<&str> = rows.map(|row| row[column("damage_state")]).collect();
    assert_eq!(states, ["0", "1"]);
}

/// Columns of 0.4 × 0.4 × 3 m, four of them, under a hall of 10 t; beds and joints share 1 kN/mm, as the beds given say.
fn shared(more: &str) -> String {
    gate(more)
        .replace(
            "height = 3 }",
            "height = 3, columns = { count = 4, width = 0.4, bed_stiffness = \"0.2 GPa/m\" } }",
        )
        .replace(
            "[direction.short]\nalong = \"y\"\nstiffness = [\"0.7 kN/mm\"]\ndamping_ratio = 0.05\n",
            "",
        )
}

/// The same without beds given: how beds and joints share the stiffness is not known.
fn unshared(more: &str) -> String {
    shared(more).replace(", bed_stiffness = \"0.2 GPa/m\"", "")
}

/// k_b of those beds, N/m.
fn beds_given_n_m() -> f64 {
    2.0 * 4.0 * 0.2e9 * (0.4_f64.powi(4) / 12.0) / 9.0
}

#[test]
fn agrees_beds_given_beside_joints_move_as_scipy_has_it_and_the_range_goes() {
    // the largest drifts of SciPy's DOP853, as in the test of the science, mm
    let limits = "[limits]\nstorey_drift = \"0.4 %\"\nsource = \"assumed\"\n";
    let scratch = scratch("gates_given", &shared(limits));
    for (scale, peak_mm, outcome) in [(0.3, 9.355_006, "stood"), (0.5, 15.944_259, "rocked")] {
        let command = format!("simulate project.toml --motion x_alone --scale {scale}");
        let run = json(&scratch, &command)["simulations"][0].clone();
        let beside = &run["beds_beside_joints"];
        assert_eq!(beside["outcome"], outcome, "{beside}");
        assert_eq!(run["all_stiffness_in_beds"], Value::Null);
        let off = 1e3 * number(beside, "/peak_drift_m") / peak_mm - 1.0;
        assert!(off.abs() < 2e-4, "{off}");
        // 2 N/(k_w B b²) h, less than 1e-4 of rolling
        let lifts_m = 3.0 * 2.0 * (10e3 * G / 4.0) / (0.2e9 * 0.4_f64.powi(3));
        assert!((number(beside, "/lift_off_drift_m") / lifts_m - 1.0).abs() < 1e-3);
        assert!((number(beside, "/bed_stiffness_n_m") / beds_given_n_m() - 1.0).abs() < 1e-9);
        assert!((number(beside, "/joint_stiffness_n_m") / (1e6 - beds_given_n_m()) - 1.0).abs() < 1e-9);
        // one drift decides: the larger
        let springs = number(&run, "/storeys/0/peak_drift_m").abs();
        let larger = springs.max(number(beside, "/peak_drift_m"));
        let demand = number(&run, "/limits/parts/0/demand");
        match outcome {
            "stood" => assert!((demand - springs / 3.0).abs() < 1e-12),
            _ => assert!((demand - larger / 3.0).abs() < 1e-12),
        }
        let said = scratch.dolmen(&command).words();
        assert!(
            !said.contains("is assumed, since") && !said.contains("is not in this motion"),
            "{said}"
        );
        assert!(said.contains("as bed_stiffness gives it"), "{said}");
    }
    // beyond the limit it is so, not "not decided"
    let answer = scratch.dolmen("simulate project.toml --motion x_alone --scale 0.5");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
}

#[test]
fn holds_beds_stiffer_than_the_storey_are_named_with_both_numbers_and_the_range_stands() {
    let scratch = scratch("gates_too_stiff", &shared("").replace("0.2 GPa/m", "2 GPa/m"));
    let said = scratch
        .dolmen("simulate project.toml --motion x_alone --scale 0.5")
        .words();
    assert!(
        said.contains("alone would have 3.79 MN/m, more than the 1.00 MN/m of the whole storey"),
        "{said}"
    );
    assert!(said.contains("is assumed, since"), "{said}");
    let checked = scratch.dolmen("check project.toml").words();
    assert!(checked.contains("less than the beds"), "{checked}");
}

#[test]
fn holds_both_components_move_each_direction_on_its_beds_and_name_what_is_shared_once() {
    let two = |text: &str| {
        let short = "[direction.short]\nalong = \"y\"\nstiffness = [\"0.7 kN/mm\"]\ndamping_ratio = 0.05\n";
        text.replace("[motion.station]", &format!("{short}[motion.station]"))
    };
    let limits = "[limits]\nstorey_drift = \"5 %\"\nsource = \"assumed\"\n";
    let runs = |name: &str, text: &str| {
        let scratch = scratch(name, &two(text));
        let both = json(&scratch, "simulate project.toml --motion station")["simulations"].clone();
        let alone = ["long --motion x_alone", "short --motion y_alone"].map(|how| {
            json(&scratch, &format!("simulate project.toml --direction {how}"))["simulations"][0].clone()
        });
        let said = scratch.dolmen("simulate project.toml --motion station").words();
        (both, alone, said)
    };
    let (both, alone, said) = runs("gates_plan_given", &shared(limits));
    let peak = |run: &Value, key: &str| {
        let springs = number(run, "/storeys/0/peak_drift_m").abs();
        springs.max(number(&run[key], "/peak_drift_m"))
    };
    // each direction as under its own component alone; the resultant of both counts
    for at in [0, 1] {
        assert_eq!(both[at]["beds_beside_joints"], alone[at]["beds_beside_joints"]);
    }
    let [x, y] = [0, 1].map(|at| peak(&both[at], "beds_beside_joints"));
    let resultant = number(&both[1], "/together/drift_with_lift_off_m");
    assert!((resultant / x.hypot(y) - 1.0).abs() < 1e-12);
    let demand = number(&both[1], "/limits/parts/1/demand");
    assert!(
        (demand / (resultant / 3.0) - 1.0).abs() < 1e-12,
        "{}",
        both[1]["limits"]
    );
    assert!(
        said.contains("each direction was followed under its own component"),
        "{said}"
    );
    // the vertical component is named once, for both directions
    assert_eq!(
        said.matches("vertical component of the motion").count(),
        1,
        "{said}"
    );
    assert!(
        said.contains("Directions long and short: The vertical component"),
        "{said}"
    );
    let (both, alone, said) = runs("gates_plan_free", &unshared(limits));
    for at in [0, 1] {
        assert_eq!(
            both[at]["all_stiffness_in_beds"],
            alone[at]["all_stiffness_in_beds"]
        );
    }
    let [x, y] = [0, 1].map(|at| peak(&both[at], "all_stiffness_in_beds"));
    let resultant = number(&both[1], "/together/drift_all_in_beds_m");
    assert!((resultant / x.hypot(y) - 1.0).abs() < 1e-12);
    assert!(
        said.contains("with all of the stiffness in the beds: each direction"),
        "{said}"
    );
    // the check says what the columns of both hold once
    let scratch = scratch("gates_plan_check", &two(&shared(limits)));
    let checked = scratch.dolmen("check project.toml").words();
    assert!(
        checked.contains("Directions long and short: the columns of storey 1"),
        "{checked}"
    );
    assert_eq!(
        checked.matches("the columns of storey 1 (4").count(),
        1,
        "{checked}"
    );
}

#[test]
fn holds_storeys_whose_softening_is_not_followed_are_named() {
    // a second storey of 2 t, without columns
    let two = |text: &str| {
        text.replace(" }]\n", " }, { name = \"roof\", mass = \"2 t\", height = 2 }]\n")
            .replace(
                "stiffness = [\"1 kN/mm\"]",
                "stiffness = [\"1 kN/mm\", \"1 kN/mm\"]",
            )
    };
    let said = |name: &str, text: &str, command: &str| {
        let scratch = scratch(name, text);
        (scratch.dolmen(command).words(), json(&scratch, command))
    };
    let simulate = "simulate project.toml --motion x_alone --scale";
    let (words, run) = said("gates_two", &two(&shared("")), &format!("{simulate} 0.7"));
    assert!(
        words.contains("the columns of ‘hall’ lift off at a drift of")
            && words.contains("with several storeys"),
        "{words}"
    );
    let named = run.pointer("/simulations/0/softening_not_followed/0").unwrap();
    assert_eq!(named["is_bed_stiffness_given"], true);
    // 12 t on it: θ0 = 2 N/(k_w B b²)
    let lifts = 2.0 * (12e3 * G / 4.0) / (0.2e9 * 0.4_f64.powi(3));
    assert!(
        (number(named, "/lift_off_drift") / lifts - 1.0).abs() < 1e-3,
        "{named}"
    );
    let (words, _) = said("gates_two_free", &two(&unshared("")), &format!("{simulate} 0.7"));
    assert!(
        words.contains("No range of the drift was run with several storeys"),
        "{words}"
    );
    let (words, _) = said("gates_two_calm", &two(&unshared("")), &format!("{simulate} 0.01"));
    assert!(!words.contains("No range of the drift"), "{words}");
    let rubs = shared("").replace(
        "damping_ratio = 0.05\n",
        "damping_ratio = 0.05\nfriction = { law = \"coulomb\", force = [\"1 kN\"] }\n",
    );
    let (words, _) = said("gates_rubs", &rubs, &format!("{simulate} 1"));
    assert!(
        words.contains("not followed where joints rub or have slack"),
        "{words}"
    );
    let site = "[site]\ncode = \"table\"\nperiods_s = [0.01, 10]\naccelerations = [0.1, 0.1]\nunit = \"g\"\nsource = \"made up\"\n";
    let (words, found) = said("gates_two_site", &two(&unshared(site)), "check project.toml");
    assert!(words.contains("No range of the drift was computed"), "{words}");
    assert!(
        found
            .pointer("/state/demand/softening_not_followed/0/storey")
            .is_some()
    );
}

#[test]
fn holds_a_study_counts_the_worse_of_springs_and_beds_given_beside_joints() {
    let study = "[study.s]\nmotions = [\"x_alone\"]\ndirection = \"long\"\nscale = [0.5]\nrefine = 0\n";
    let scratch = scratch("gates_study_given", &shared(study));
    // SciPy, as above
    let found = drifts(&scratch, "s")[0];
    assert!((1e3 * found / 15.944_259 - 1.0).abs() < 2e-4, "{found}");
}

#[test]
fn exact_under_a_flat_spectrum_beds_given_and_joints_balance_its_force() {
    let acceleration = 0.2;
    let site = format!(
        "[site]\ncode = \"table\"\nperiods_s = [0.01, 10]\naccelerations = [{acceleration}, {acceleration}]\n\
         unit = \"g\"\nsource = \"made up\"\n[limits]\nstorey_drift = \"5 %\"\nsource = \"assumed\"\n"
    );
    let scratch = scratch("gates_balance", &shared(&site));
    let found = json(&scratch, "check project.toml");
    let split = found.pointer("/state/demand/stiffness_shared/0").unwrap().clone();
    assert_eq!(split["is_bed_stiffness_given"], true, "{split}");
    let (mass, weight) = (10e3, 10e3 * G);
    // V(u) + k_j u = m a, by bisection on the rotation
    let joints = 1e6 - beds_given_n_m();
    let (mut low, mut high) = (0.0, 0.06);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let (force, drift) = column(middle, weight, 0.2e9);
        match force + joints * drift < mass * acceleration * G {
            true => low = middle,
            false => high = middle,
        }
    }
    let (_, drift) = column(low, weight, 0.2e9);
    let softened = number(&split, "/drift_with_lift_off");
    assert!(
        (softened / (drift / 3.0) - 1.0).abs() < 1e-4,
        "{softened} {}",
        drift / 3.0
    );
    let linear = mass * acceleration * G / (1e6 - weight / 3.0) / 3.0;
    assert!(softened > 1.005 * linear, "{softened} {linear}");
    // one answer: the larger drift is held against the limit, and nothing is open
    let demand = number(&found, "/state/demand/limits/parts/0/demand");
    assert!((demand / softened - 1.0).abs() < 1e-12);
    let said = scratch.dolmen("check project.toml");
    assert!(!said.words().contains("not decided"), "{}", said.stdout);
}

#[test]
fn holds_beds_not_given_beside_joints_give_the_drift_of_both_extremes() {
    // k_w of beds that give all of 1 kN/mm: k h²/(2 n I)
    let bed = 1e6 * 9.0 / (2.0 * 4.0 * 0.4_f64.powi(4) / 12.0);
    let limits = "[limits]\nstorey_drift = \"2.2 %\"\nsource = \"assumed\"\n";
    let file = unshared(limits);
    let alone = shared(limits)
        .replace("0.2 GPa/m", &format!("{bed} Pa/m"))
        .replace("stiffness = [\"1 kN/mm\"]", "stiffness = [0]");
    let run = |name: &str, text: &str, scale: &str| {
        let scratch = scratch(name, text);
        let command = format!("simulate project.toml --motion x_alone --scale {scale}");
        let said = scratch.dolmen(&command);
        (json(&scratch, &command), said)
    };
    let (shared_run, said) = run("gates_shared", &file, "0.5");
    let (alone_run, _) = run("gates_alone", &alone, "0.5");
    let of = |run: &Value, key: &str| run["simulations"][0][key].clone();
    let beds = of(&shared_run, "all_stiffness_in_beds");
    assert_eq!(beds["outcome"], "rocked", "{beds}");
    assert_eq!(beds, of(&alone_run, "columns_alone"));
    let joints = number(&of(&shared_run, "storeys"), "/0/peak_drift_m").abs();
    let softer = number(&beds, "/peak_drift_m");
    assert!(softer > 1.1 * joints, "{softer} {joints}");
    assert!(
        said.words()
            .contains("how beds and joints share the stiffness of the storey is assumed"),
        "{}",
        said.stdout
    );
    for drift in [joints, softer] {
        let length = format!("{:.2} mm", 1e3 * drift);
        assert!(said.words().contains(&length), "{length}: {}", said.stdout);
    }
    // between the two drifts the limit decides nothing: amber; above both it is met
    let limit = |ratio: f64| file.replace("2.2 %", &format!("{} %", 100.0 * ratio));
    let word = |name: &str, ratio: f64| {
        let (_, said) = run(name, &limit(ratio), "0.5");
        said.words()
    };
    let between = word("gates_between", 0.5 * (joints + softer) / 3.0);
    assert!(
        between.contains("not decided (how beds and joints share the stiffness is assumed)"),
        "{between}"
    );
    let above = word("gates_above", 1.3 * softer / 3.0);
    assert!(
        above.contains("above demand") && above.contains("is assumed, since"),
        "{above}"
    );
    // too small for any foot to lift off: it does not matter, and nothing warns
    let (_, calm) = run("gates_calm", &file, "0.01");
    assert!(calm.words().contains("no foot lifts off"), "{}", calm.stdout);
}

/// V and u of one rotation of a column of 0.4 × 0.4 × 3 m on beds of k_w under a force, n columns together carrying `weight`.
fn column(rotation: f64, weight: f64, bed: f64) -> (f64, f64) {
    let (count, width, height) = (4.0, 0.4, 3.0);
    let own = weight / count;
    let lever = |theta: f64| match theta <= 2.0 * own / (bed * width * width * width) {
        true => bed * width.powi(4) * theta / 12.0 / own,
        false => width / 2.0 - (2.0 * own / (bed * width * theta)).sqrt() / 3.0,
    };
    // u = h sin θ + 2 ∫ e sin θ dθ, by Simpson's rule
    let parts = 20_000;
    let step = rotation / f64::from(parts);
    let each = (0..=parts).map(|i| {
        let theta = f64::from(i) * step;
        let weight = match i {
            0 => 1.0,
            i if i == parts => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * lever(theta) * theta.sin()
    });
    let integral: f64 = each.sum::<f64>() * step / 3.0;
    let psi = (2.0 * lever(rotation) / height).atan();
    (
        weight * (psi - rotation).tan(),
        height * rotation.sin() + 2.0 * integral,
    )
}

#[test]
fn exact_under_a_flat_spectrum_the_drift_with_all_stiffness_in_the_beds_balances_its_force() {
    // at a constant acceleration a the secant stiffness asks for u = a m/(V/u): in balance V(u) = m a
    let acceleration = 0.075;
    let site = |limit: &str| {
        format!(
            "[site]\ncode = \"table\"\nperiods_s = [0.01, 10]\naccelerations = [{acceleration}, {acceleration}]\n\
             unit = \"g\"\nsource = \"made up\"\n[limits]\nstorey_drift = \"{limit}\"\nsource = \"assumed\"\n"
        )
    };
    let scratch = scratch("gates_spectrum", &unshared(&site("5 %")));
    let found = json(&scratch, "check project.toml");
    let range = found.pointer("/state/demand/stiffness_shared/0").unwrap().clone();
    let (mass, weight) = (10e3, 10e3 * G);
    let linear = mass * acceleration * G / (1e6 - weight / 3.0) / 3.0;
    assert!(
        (number(&range, "/drift_linear") / linear - 1.0).abs() < 1e-9,
        "{range}"
    );
    let bed = 1e6 * 9.0 / (2.0 * 4.0 * 0.4_f64.powi(4) / 12.0);
    let lifts = 2.0 * (weight / 4.0) / (bed * 0.4_f64.powi(3));
    let (_, lifts) = column(lifts, weight, bed);
    assert!(
        (number(&range, "/lift_off_drift") / (lifts / 3.0) - 1.0).abs() < 1e-6,
        "{range}"
    );
    // bisection on the rotation
    let (mut low, mut high) = (lifts / 3.0, 0.06);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match column(middle, weight, bed).0 < mass * acceleration * G {
            true => low = middle,
            false => high = middle,
        }
    }
    let (_, drift) = column(low, weight, bed);
    let in_beds = number(&range, "/drift_with_lift_off");
    assert!(
        (in_beds / (drift / 3.0) - 1.0).abs() < 1e-4,
        "{in_beds} {}",
        drift / 3.0
    );
    assert!(in_beds > 1.1 * linear, "{in_beds} {linear}");
    // a limit between both
    let limit = format!("{} %", 50.0 * (in_beds + linear));
    fs::write(scratch.path().join("project.toml"), unshared(&site(&limit))).unwrap();
    let said = scratch.dolmen("check project.toml");
    assert!(
        said.words()
            .contains("not decided (how beds and joints share the stiffness is assumed)"),
        "{}",
        said.stdout
    );
    assert_eq!(said.status, 0, "{}", said.stdout);
}

#[test]
fn holds_the_wind_on_joints_that_slip_is_that_of_a_frame_of_their_stiffness() {
    let wind = "[wind]\nspeed = 30\nmeans = \"10 min\"\ncode = \"EN 1991-1-4\"\nterrain = \"II\"\nforce_coefficient = 1.3\n\
                areas = [{ part = \"hall\", area = 20 }]\n";
    let slips = |force: &str| {
        format!(
            "friction = {{ law = \"jenkins\", force = [\"{force}\"], slipping_stiffness = [\"0.3 kN/mm\"] }}\n"
        )
    };
    let file = |stiffness: &str, friction: &str| {
        gate(wind)
            .replace(
                "[direction.short]\nalong = \"y\"\nstiffness = [\"0.7 kN/mm\"]\ndamping_ratio = 0.05\n",
                "",
            )
            .replace("\"1 kN/mm\"", stiffness)
            .replace(
                "damping_ratio = 0.05\n",
                &format!("damping_ratio = 0.05\n{friction}"),
            )
    };
    let along = |name: &str, text: &str| {
        let scratch = scratch(name, text);
        (
            json(&scratch, "check project.toml"),
            scratch.dolmen("check project.toml").words(),
        )
    };
    let (slipping, said) = along("gates_wind_slips", &file("\"1 kN/mm\"", &slips("1 kN")));
    let (stuck, _) = along("gates_wind_stuck", &file("\"1 kN/mm\"", ""));
    let (soft, _) = along("gates_wind_soft", &file("\"0.3 kN/mm\"", ""));
    let wind = |of: &Value| of.pointer("/state/loads/wind_along/0").unwrap().clone();
    let of_slipping = wind(&slipping)["slipping"]["met"].clone();
    assert_eq!(of_slipping, wind(&soft)["met"]);
    assert_eq!(wind(&slipping)["met"], wind(&stuck)["met"]);
    let [softer, stiffer] = [&of_slipping, &wind(&stuck)["met"]].map(|met| number(met, "/force_n"));
    assert!(softer > 1.02 * stiffer, "{softer} {stiffer}");
    // the drift is that of the soft frame
    let drift = |of: &Value| {
        number(
            of,
            "/state/loads/combinations/0/directions/0/storeys/0/under/drift_m",
        )
    };
    assert!((drift(&slipping) / drift(&soft) - 1.0).abs() < 1e-12);
    assert!(said.contains("the gust slips joints"), "{said}");
    // joints that no gust slips keep their frequency
    let (held, said) = along("gates_wind_held", &file("\"1 kN/mm\"", &slips("1 MN")));
    assert_eq!(wind(&held)["slipping"], Value::Null);
    assert!(!said.contains("the gust slips joints"), "{said}");
}
