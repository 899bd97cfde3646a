// SOURCE     Park and Min (2010): the gate in plan; Hwang, Min & Hong, Table 1; closed forms.
// GOAL       What `identify` and `check` report about the stiffness of a building in plan.
// TOLERANCE  closed forms 1e-9; the centre of rigidity 4e-4 m, the effect of the printed digits of Table 1.

use super::verbs::Scratch;
use serde_json::Value;
use std::f64::consts::TAU;
use std::fs;

const GATE: &str = "examples/gate_in_plan/project.toml";

fn gate(name: &str, change: impl Fn(String) -> String) -> Scratch {
    let scratch = Scratch::with_examples(name);
    let path = scratch.path().join(GATE);
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, change(text)).unwrap();
    scratch
}

fn plan(scratch: &Scratch) -> Value {
    let answer = scratch.dolmen("--json identify examples/gate_in_plan");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    json["surveys"][0]["plan"].clone()
}

#[test]
fn exact_the_gate_in_plan_has_one_accepted_stiffness_of_six() {
    let scratch = gate("plan_gate", |text| text);
    let plan = plan(&scratch);
    assert_eq!(plan["solutions"].as_array().unwrap().len(), 6);
    assert_eq!(plan["accepted"], 1);
    let own = |f: f64| 604e3 * (TAU * f).powi(2) + 604e3 * 9.80665 / 5.84;
    let k = |at: usize| plan["solutions"][0]["stiffness"][at].as_f64().unwrap();
    for (at, known) in [(0, own(1.5)), (1, own(1.1)), (2, 6.455 * 6.455 * own(1.3))] {
        assert!((k(at) / known - 1.0).abs() < 1e-3, "{at}: {} {known}", k(at));
    }
    let answer = scratch.dolmen("identify examples/gate_in_plan");
    let said = answer.words();
    for wanted in [
        "3 frequencies do not tell where the centre of rigidity is",
        "B is not accepted: its mode at",
        "The centre of rigidity is taken as the file has it.",
    ] {
        assert!(said.contains(wanted), "{wanted}: {}", answer.stdout);
    }
    assert!(
        answer.stdout.lines().all(|line| line.chars().count() <= 80),
        "{}",
        answer.stdout
    );
}

#[test]
fn holds_check_contradicts_the_first_guess_and_agrees_with_what_was_found() {
    let scratch = gate("plan_check", |text| text);
    let said = scratch.dolmen("check examples/gate_in_plan").words();
    assert!(said.contains("measured 1.500 Hz in direction x"), "{said}");
    let plan = plan(&scratch);
    let k = |at: usize| plan["solutions"][0]["stiffness"][at].as_f64().unwrap();
    let path = scratch.path().join(GATE);
    let found = fs::read_to_string(&path)
        .unwrap()
        .replace("x = { value = 40,", &format!("x = {{ value = {},", k(0) / 1e6))
        .replace("y = { value = 40,", &format!("y = {{ value = {},", k(1) / 1e6));
    fs::write(&path, &found).unwrap();
    let said = scratch.dolmen("check examples/gate_in_plan").words();
    assert!(
        !said.contains("in direction x") && !said.contains("in direction y"),
        "{said}"
    );
    // a model with other torsional stiffness is contradicted too
    fs::write(&path, found.replace("1700 MN*m/rad", "3000 MN*m/rad")).unwrap();
    let said = scratch.dolmen("check examples/gate_in_plan").words();
    assert!(said.contains("measured 1.300 Hz in direction torsion"), "{said}");
}

#[test]
fn refuses_two_frequencies_and_says_what_stays_free() {
    let no_torsion = |text: String| {
        let lines = text.lines().filter(|line| !line.starts_with("torsion ="));
        lines.collect::<Vec<_>>().join("\n")
    };
    let scratch = gate("plan_few", no_torsion);
    let answer = scratch.briefly("identify examples/gate_in_plan");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let said = answer.words();
    assert!(
        said.contains("A floor has 3 modes, and 2 of them measured leave k_θ free"),
        "{said}"
    );
    assert!(
        said.contains("determined in part, with the centre of rigidity where the file has it: k_x"),
        "{said}"
    );
    // with an eccentricity no stiffness is determined alone
    let off = gate("plan_few_off", |text| {
        no_torsion(text).replace("centre = [0, 0]", "centre = [1, 0.5]")
    });
    let said = off.briefly("identify examples/gate_in_plan").words();
    assert!(said.contains("leave k_x, k_y and k_θ free"), "{said}");
}

#[test]
fn published_table_1_gives_back_the_centre_of_rigidity() {
    let scratch = Scratch::with_examples("plan_table_1");
    let path = scratch.path().join("examples/twisting_floor/project.toml");
    let survey = format!(
        "{}\n[survey.table]\n[[survey.table.modes.x]]\nfrequency = {}\ntwist = 0\n[[survey.table.modes.y]]\nfrequency = {}\ntwist = {}\n\
         [[survey.table.modes.y]]\nfrequency = {}\nkind = \"torsion\"\n",
        fs::read_to_string(&path).unwrap(),
        2.2821 / TAU,
        1.8471 / TAU,
        (164.0_f64 / 12.0).sqrt() / 23.378,
        3.6056 / TAU,
    );
    fs::write(&path, survey).unwrap();
    let answer = scratch.dolmen("--json identify examples/twisting_floor");
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let plan = &json["surveys"][0]["plan"];
    assert_eq!(plan["eccentricity_from"], "twists");
    assert_eq!(plan["accepted"], 1);
    let e = plan["solutions"][0]["eccentricity_m"][0].as_f64().unwrap();
    assert!((e + 1.5).abs() < 4e-4, "{e}");
}

#[test]
fn refuses_several_floors_in_plain_words() {
    let scratch = Scratch::with_examples("plan_floors");
    let path = scratch.path().join("examples/twenty_storeys/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text + "\n[survey.s.frequencies]\nx = [0.5]\n").unwrap();
    let said = scratch.briefly("identify examples/twenty_storeys").words();
    assert!(said.contains("the building has 20 floors"), "{said}");
}

const HALL: &str = r#"schema = 1
kind = "building"
name = "Hall"
units = { mass = "t", stiffness = "MN/m" }
floors = [ { name = "hall", mass = 120, sides = [12, 7], height = 4.0, stiffness = { x = 60, y = 42, rotation = { value = 900, unit = "MN*m/rad" }, centre = ["1.2 m", "-0.8 m"] } } ]
damping.ratio = 0.03
[survey.2026-05-01]
modes.x = [{ frequency = { value = 3.3530, sd = 0.005 }, twist = -0.5384, twist_sd = 0.01, sideways = -0.591 }]
modes.y = [{ frequency = { value = 2.4559, sd = 0.005 }, twist = -0.6244, twist_sd = 0.01, sideways = 0.239 }]
modes.torsion = [{ frequency = { value = 3.9985, sd = 0.005 } }]
[limits]
storey_drift = "1/200"
"#;

const MASS: &str = r#"kind = "tmd"
floor = 1
place = [-4, 0]
direction = "y"
mass_ratio = 0.03
tuning = "den_hartog"
"#;

fn hall(name: &str, more: &str) -> Scratch {
    let scratch = Scratch::with_examples(name);
    fs::write(scratch.path().join("hall.toml"), format!("{HALL}{more}")).unwrap();
    scratch
}

/// The survey is of the floor with its tuned mass, by numpy's complex modes: nothing is written for the floor alone, and the check compares
/// the whole.
#[test]
fn holds_a_tuned_mass_is_counted_in_the_check_and_stiffness_is_not_sought_with_it() {
    let scratch = hall("plan_damped", &format!("[damper.t]\n{MASS}"));
    let answer = scratch.dolmen("identify hall.toml");
    let said = answer.words();
    assert!(said.contains("puts dampers on the floor (t)"), "{said}");
    assert!(said.contains("Survey with the dampers blocked"), "{said}");
    assert!(!said.contains("k_x"), "{said}");
    assert!(
        scratch
            .dolmen("identify hall.toml --language ko")
            .words()
            .contains("감쇠기(t)")
    );
    let said = scratch.dolmen("check hall.toml").words();
    assert!(
        said.contains("direction y 2.456 Hz (2.696 Hz without dampers)"),
        "{said}"
    );
    assert!(
        said.contains("direction y 2.456 ± 0.005 Hz, model 2.456 Hz"),
        "{said}"
    );
    assert!(!said.contains("83.0 %"), "{said}");
    // dampers of a variant do not belong to the surveyed floor
    let scratch = hall("plan_blocked", &format!("[variant.damped.damper.t]\n{MASS}"));
    let said = scratch.dolmen("identify hall.toml").words();
    assert!(said.contains("k_x"), "{said}");
}

#[test]
fn holds_bounds_say_whether_they_hold_the_scatter_of_the_frequencies() {
    let modes = |sd: &str| {
        let mode = |hz: f64| format!("[{{ frequency = {{ value = {hz}{sd} }} }}]");
        let [x, y, torsion] = [3.35296, 2.69593, 3.99298].map(mode);
        let (head, _) = HALL.split_once("modes.x").unwrap();
        let head = head.replace(r#", centre = ["1.2 m", "-0.8 m"]"#, r#", centre = [0, 0]"#);
        format!("{head}modes.x = {x}\nmodes.y = {y}\nmodes.torsion = {torsion}\n")
    };
    let scratch = Scratch::with_examples("plan_bounds");
    let said = |sd: &str| {
        fs::write(scratch.path().join("hall.toml"), modes(sd)).unwrap();
        scratch.dolmen("identify hall.toml").words()
    };
    let (with, without) = (said(", sd = 0.15"), said(""));
    assert!(
        with.contains("over frequencies within 1.96 standard deviations, k_x lies between"),
        "{with}"
    );
    assert!(
        without.contains("were the frequencies exact (their scatter is not given)"),
        "{without}"
    );
}
