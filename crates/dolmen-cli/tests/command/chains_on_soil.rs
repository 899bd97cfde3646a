// SOURCE     A chain of one stone on soil: joint and soil in series, closed forms.
// GOAL       check and simulate include the soil of a file, and a stiffness from a survey is given for the bed alone.
// PARAMETERS one stone of 120 kN, 10 m; a round footing of 2 m on 40 MPa.
// TOLERANCE  1e-6 of stiffness.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const POLE: &str = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\n\
    links = [{ name = \"pole\", weight = \"120 kN\", length = 10, centroid = 5, breadth = 0.7 }]\n";
const SOIL: &str = "soil = { shear_modulus = \"40 MPa\", poisson_ratio = 0.3, diameter = 2.0 }\n";

/// 8 G R³ / (3 (1 − ν)), N m/rad.
const K_SOIL: f64 = 8.0 * 40e6 / (3.0 * 0.7);

fn json(name: &str, text: &str, words: &str) -> (Scratch, Value) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen(words);
    let value =
        serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr));
    (scratch, value)
}

#[test]
fn holds_soil_and_bed_act_in_series() {
    let bed = 60e6;
    let file = format!("{POLE}{SOIL}joints = [{{ stiffness = \"60 MN*m/rad\" }}]\n");
    let (_scratch, value) = json("soil", &file, "check project.toml --json");
    let together = 1.0 / (1.0 / bed + 1.0 / K_SOIL);
    let factor = value["state"]["check"]["chain"]["stability"]["load_factor"]
        .as_f64()
        .unwrap();
    assert!(
        (factor / (together / (120e3 * 5.0)) - 1.0).abs() < 1e-9,
        "{factor}"
    );
    // as a single joint
    let one = format!("{POLE}joints = [{{ stiffness = {together} }}]\n");
    let (_scratch, same) = json("one", &one, "check project.toml --json");
    assert_eq!(
        same["state"]["check"]["chain"]["stability"]["load_factor"]
            .as_f64()
            .map(|of| (of / factor - 1.0).abs() < 1e-12),
        Some(true)
    );
    let run = "simulate project.toml --push 0.5deg --duration 5 --json";
    let (_scratch, moved) = json("soil-run", &file, run);
    let (_scratch, alone) = json("one-run", &one, run);
    let first = |of: &Value| of["first_frequency_hz"].as_f64().unwrap();
    assert!((first(&moved) / first(&alone) - 1.0).abs() < 1e-9);
}

#[test]
fn exact_own_weight_is_judged_across_too_where_the_footing_is_softer_there() {
    let soil = "soil = { shear_modulus = \"0.3 MPa\", poisson_ratio = 0.3, along = 3, across = 1 }\n";
    let file = |soil: &str| format!("{POLE}{soil}joints = [{{ stiffness = \"60 MN*m/rad\" }}]\n");
    let (scratch, value) = json("soil-across", &file(soil), "check project.toml --json");
    // Pais & Kausel (1988), b = 0.5 m, L/B = 3: G b³/(1 − ν) [3.2 L/B + 0.8], in series with the bed, over 120 kN · 5 m
    let across = 0.3e6 * 0.125 / 0.7 * (3.2 * 3.0 + 0.8);
    let factor = 1.0 / (1.0 / 60e6 + 1.0 / across) / 600e3;
    let found = &value["state"]["check"]["chain"]["across"]["stability"]["load_factor"];
    assert!(
        (found.as_f64().unwrap() / factor - 1.0).abs() < 1e-9,
        "{found} {factor}"
    );
    let answer = scratch.briefly("check project.toml");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    let words = answer.words();
    assert!(
        words.contains("Own weight: unstable in direction y")
            && words.contains("Direction y, across: With this stiffness it falls"),
        "{words}"
    );
    let square = soil.replace("along = 3, across = 1", "along = 2, across = 2");
    let (_scratch, value) = json("soil-square", &file(&square), "check project.toml --json");
    assert!(value["state"]["check"]["chain"]["across"].is_null());
}

#[test]
fn holds_the_stiffness_of_a_survey_is_written_back_as_the_bed_alone() {
    let bed = 60e6;
    let file = format!("{POLE}{SOIL}joints = [{{ stiffness = \"60 MN*m/rad\" }}]\n");
    let (_scratch, value) = json("truth", &file, "check project.toml --json");
    let hz = value["state"]["check"]["chain"]["modes"][0]["frequency_hz"]
        .as_f64()
        .unwrap_or_else(|| panic!("{value}"));
    let measured = format!(
        "{POLE}{SOIL}joints = \"unknown\"\n[survey.2024-05-01]\nfrequencies.x = [{{ value = {hz}, sd = 0.01 }}]\n"
    );
    let (scratch, written) = json("written", &measured, "identify project.toml --write --json");
    let value = written["written"]["numbers"][0]["value"]
        .as_f64()
        .unwrap_or_else(|| panic!("{written}"));
    assert!((value / bed - 1.0).abs() < 1e-6, "{value}");
    let text = fs::read_to_string(scratch.path().join("project.toml")).unwrap();
    assert!(text.contains("identified"), "{text}");
    let again = scratch.dolmen("check project.toml --json");
    let again: Value = serde_json::from_str(&again.stdout).unwrap();
    let found = again["state"]["check"]["chain"]["modes"][0]["frequency_hz"]
        .as_f64()
        .unwrap();
    assert!((found / hz - 1.0).abs() < 1e-6, "{found} {hz}");
}

#[test]
fn holds_a_survey_stiffer_than_the_soil_contradicts_it() {
    let soft = SOIL.replace("40 MPa", "2 MPa");
    let file = format!(
        "{POLE}{soft}joints = \"unknown\"\n[survey.2024-05-01]\nfrequencies.x = [{{ value = 1.0, sd = 0.01 }}]\n"
    );
    let scratch = Scratch::new("soft");
    fs::write(scratch.path().join("project.toml"), &file).unwrap();
    let answer = scratch.dolmen("identify project.toml");
    assert!(
        answer
            .words()
            .contains("is no softer than the soil of the file alone"),
        "{}",
        answer.words()
    );
    assert!(!answer.words().contains("--write"), "{}", answer.words());
}

#[test]
fn holds_soil_without_a_footing_or_in_the_wrong_unit_is_asked_about() {
    for (soil, said) in [
        (
            "soil = { shear_modulus = \"40 MPa\", poisson_ratio = 0.3 }",
            "soil has no footing",
        ),
        (
            "soil = { shear_modulus = 40000, poisson_ratio = 0.3, diameter = 2 }",
            "but soil and rock have 0.3 MPa to 40 GPa",
        ),
        (
            "soil = { shear_modulus = \"40 MPa\", poisson_ratio = 0.3, along = 1000, across = 1200 }",
            "at most 40 m wide",
        ),
        (
            "soil = { shear_modulus = \"40 MPa\", poisson_ratio = 0.3, diameter = 0.2 }",
            "but the bed that stands on it is wider",
        ),
        (
            "soil = { shear_modulus = \"40 MPa\", poisson_ratio = 0.6, diameter = 2 }",
            "saturated clay nearly 0.5",
        ),
    ] {
        let scratch = Scratch::new("wrong-soil");
        fs::write(
            scratch.path().join("project.toml"),
            format!("{POLE}{soil}\njoints = \"unknown\"\n"),
        )
        .unwrap();
        let answer = scratch.dolmen("check project.toml");
        let words = format!("{}{}", answer.words(), answer.stderr);
        let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(said), "{words}");
    }
}
