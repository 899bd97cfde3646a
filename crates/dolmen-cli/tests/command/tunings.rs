// SOURCE     The shipped floors: Hwang, Min & Hong's, and one on which their rule fails.
// GOAL       What a user reads of a damper, the files it writes, and what is refused.
// TOLERANCE  half a unit of the fourth digit of ratios computed apart.

use super::verbs::Scratch;
use std::fs;

fn ratios(choice: &serde_json::Value) -> Vec<f64> {
    let list = choice["point_rms_ratio"].as_array().unwrap();
    list.iter().map(|ratio| ratio.as_f64().unwrap()).collect()
}

fn close(given: &[f64], expected: &[f64]) {
    assert_eq!(given.len(), expected.len());
    for (a, b) in given.iter().zip(expected) {
        assert!((a - b).abs() < 6e-5, "{given:?} {expected:?}");
    }
}

#[test]
fn published_the_rule_makes_an_edge_worse_and_every_file_says_so() {
    let scratch = Scratch::with_examples("tune_far");
    let answer = scratch.dolmen("tune examples/far_from_the_centre --map 12 -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "WORSE THAN NO DAMPER: the rule: farthest from the centre of mode 1, left end moves 1.0430",
        "placed and tuned best",
        "Den Hartog (1956)",
        "What the goal grows by when the damper is out of tune",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let out = scratch.path().join("out/tmd");
    let text = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text("tune.json")).unwrap();
    let choices = json["choices"].as_array().unwrap();
    let names: Vec<&str> = choices
        .iter()
        .map(|row| row["choice"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["given", "rule", "tuned_best", "placed_best", "best"]);
    close(&ratios(&choices[1]), &[1.0430, 0.3708]);
    assert_eq!(choices[1]["worse_than_none"], true);
    close(&ratios(&choices[4]), &[0.5642, 0.4621]);
    assert_eq!(choices[4]["end"], "optimum");
    let place = choices[4]["damper"]["place_m"][0].as_f64().unwrap();
    assert!((place - 0.4447).abs() < 5e-4, "{place}");
    assert_eq!(json["map"]["cells"].as_array().unwrap().len(), 144);
    for figure in ["position", "plan", "robustness"] {
        assert!(text(&format!("{figure}.svg")).starts_with("<svg"), "{figure}");
    }
}

#[test]
fn published_ratios_of_the_twisting_floor() {
    let scratch = Scratch::with_examples("tune_floor");
    let answer = scratch.dolmen("--json tune examples/twisting_floor --map 4");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let damper = &json["dampers"][0];
    assert_eq!(damper["variant"], "damped");
    close(&ratios(&damper["choices"][0]), &[0.5019, 0.4897]);
    let centre = damper["mode"]["centre_m"][0].as_f64().unwrap();
    assert!((centre + 23.378).abs() < 1e-3, "{centre}");
}

#[test]
fn refuses_what_has_no_damper_to_tune() {
    let scratch = Scratch::with_examples("tune_refused");
    let answer = scratch.dolmen("tune examples/naju_flagpole");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("only buildings have dampers to tune"),
        "{}",
        answer.stderr
    );
    let path = scratch.path().join("examples/far_from_the_centre/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    let tune = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        fs::write(&path, text.replace(from, to)).unwrap();
        let answer = scratch.dolmen("tune examples/far_from_the_centre --map 4");
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        answer.stderr
    };
    let said = tune("place = [0, 0]", "place = [6, 0]");
    assert!(said.contains("outside"), "{said}");
    let said = tune("direction = \"y\"", "direction = \"x\"");
    assert!(said.contains("moves only in y here"), "{said}");
    let said = tune("mass = 10.0", "mass = 1000.0");
    assert!(said.contains("mass ratio"), "{said}");
    fs::write(&path, &text).unwrap();
    let answer = scratch.dolmen("tune examples/far_from_the_centre --damper none");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("there is no damper \"none\""),
        "{}",
        answer.stderr
    );
}
