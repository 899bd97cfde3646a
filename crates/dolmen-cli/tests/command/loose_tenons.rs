// SOURCE     The shipped gate whose tenons have slack, and El Centro 1940 north-south.
// GOAL       Text and JSON of check and simulate on tenons follow from the file; impossible values are refused.
// TOLERANCE  none: printed words; sums by hand to 1e-12.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const FILE: &str = "examples/heunginjimun_gate/loose_tenons.toml";

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn holds_the_check_rests_on_the_stiffness_within_the_slack() {
    let scratch = Scratch::with_examples("tenons_check");
    let found = json(&scratch, &format!("check {FILE}"));
    let direction = &found["state"]["check"]["frame"][0];
    let tenons = &direction["tenons"];
    let lower = &tenons["storeys"][0];
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap_or_else(|| panic!("{key}: {value}"));
    // 4 mm/m of 5.84 m; 14 and 20 kN/mm; 500 kN on 20 kN/mm beyond the slack
    assert!((number(lower, "slack_m") - 0.004 * 5.84).abs() < 1e-12);
    assert!((number(lower, "bearing_n_m") - 34e6).abs() < 1e-3);
    assert!((number(lower, "crushing_drift_m") - (0.004 * 5.84 + 0.025)).abs() < 1e-12);
    let drift = 0.02 * 5.84;
    let secant = 14e6 + 500e3 / drift;
    assert!((number(lower, "secant_n_m") / secant - 1.0).abs() < 1e-12);
    let within = number(&direction["check"]["modes"][0], "frequency_hz");
    let bearing = number(&tenons["bearing"]["modes"][0], "frequency_hz");
    assert!(within < bearing, "{within} {bearing}");
    let tight = scratch.dolmen(&format!("check {FILE}"));
    assert!(
        tight
            .stdout
            .contains("bear only after a slack, of 0.40 % of the height"),
        "{}",
        tight.stdout
    );
    let korean = scratch.dolmen(&format!("check {FILE} --language ko"));
    assert!(korean.stdout.contains("장부는 유격"), "{}", korean.stdout);
}

#[test]
fn holds_the_run_balances_and_says_what_crushed() {
    let scratch = Scratch::with_examples("tenons_run");
    let answer = scratch.dolmen(&format!("simulate {FILE} --motion el-centro -o out"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer.stdout.contains("the tenons of ‘lower storey’ crush"),
        "{}",
        answer.stdout
    );
    let text = fs::read_to_string(scratch.path().join("out/weak/simulation.json")).unwrap();
    let run: Value = serde_json::from_str(&text).unwrap();
    let energy = |key: &str| run["energy"][key].as_f64().unwrap();
    let taken = energy("kinetic_j")
        + energy("stored_j")
        + energy("friction_j")
        + energy("crushing_j")
        + energy("damping_j");
    assert!(
        (taken / energy("input_j") - 1.0).abs() < 1e-9,
        "{}",
        run["energy"]
    );
    assert!(energy("left_over_ratio") < 1e-9 && energy("crushing_j") > 0.0);
    // the crushing energy is the crushing force times the plastic deformation of both faces of each storey
    let mut crushed_j = 0.0;
    for storey in run["storeys"].as_array().unwrap() {
        let tenons = &storey["tenons"];
        for face in tenons["faces_at_end"].as_array().unwrap() {
            let depth_m = face["crushed_m"].as_f64().unwrap();
            crushed_j += tenons["crushing_force_n"].as_f64().unwrap() * depth_m;
            let left = tenons["stiffness_n_m"].as_f64().unwrap() / (1.0 + depth_m / 0.02);
            assert!(
                (face["stiffness_n_m"].as_f64().unwrap() / left - 1.0).abs() < 1e-9,
                "{face}"
            );
        }
    }
    assert!((crushed_j / energy("crushing_j") - 1.0).abs() < 1e-9);
}

#[test]
fn refuses_tenons_that_the_file_contradicts() {
    let scratch = Scratch::with_examples("tenons_refused");
    let path = scratch.path().join(FILE);
    let whole = fs::read_to_string(&path).unwrap();
    for (from, to, said, korean) in [
        (
            "slack = [\"4 mm/m\", \"4 mm/m\"]\n",
            "slack = [0.4, 0.004]\n",
            "slack[1] = 0.4",
            "회전각",
        ),
        (
            "slack = [\"4 mm/m\", \"4 mm/m\"]\n",
            "",
            "has no \"slack\"",
            "slack",
        ),
        (
            "crushing_force = [\"500 kN\", \"400 kN\"]\n",
            "",
            "but no crushing_force",
            "압괴가 일어나지",
        ),
        (
            "stiffness = [20, 30]\n",
            "stiffness = [20]\n",
            "tenons.stiffness",
            "tenons.stiffness",
        ),
    ] {
        assert!(whole.contains(from), "{from}");
        fs::write(&path, whole.replacen(from, to, 1)).unwrap();
        let answer = scratch.dolmen(&format!("check {FILE}"));
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
        let answer = scratch.dolmen(&format!("check {FILE} --language ko"));
        assert!(answer.stderr.contains(korean), "{korean}: {}", answer.stderr);
    }
}
