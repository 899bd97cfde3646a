// SOURCE     The shipped stacks; Kim, Koo & Hong (2018), eqs 9 and 16.
// GOAL       What a user reads of a stack is what the science computed, quickly, and the exit status follows the verdict.
// TOLERANCE  none: printed digits. Time: 30 ms of processor time for the whole process, the mean of ten.

use super::verbs::Scratch;
use std::fs;

#[test]
fn exact_p10_rocks_at_its_known_threshold_and_slides_first_where_it_is_smooth() {
    let scratch = Scratch::with_examples("p10");
    let answer = scratch.dolmen("check examples/p10");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    // above block 4: half of 1.1 m over the height of the centroid of what stands on it
    assert!(
        answer
            .words()
            .contains("First what stands on block 4 rocks towards -y, at 0.324 g"),
        "{}",
        answer.stdout
    );
    let json = scratch.dolmen("check examples/p10 --json");
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let of = |state: &serde_json::Value| {
        let first = &state["check"]["stack"]["governing"];
        (
            first["kind"].clone(),
            first["threshold"]["acceleration_g"].as_f64().unwrap(),
        )
    };
    let (kind, at_g) = of(&value["state"]);
    // the ten blocks by hand: weights 2.88 … of blocks 5 to 10 over their height
    let blocks = [
        (1.1, 1.1),
        (1.9, 0.5),
        (1.0, 0.45),
        (1.65, 0.45),
        (0.85, 0.40),
        (1.4, 0.40),
    ];
    let (mut base, mut volume, mut moment) = (0.0, 0.0, 0.0);
    for (width, height) in blocks {
        let own: f64 = width * width * height;
        volume += own;
        moment += own * (base + 0.5 * height);
        base += height;
    }
    assert_eq!(kind, "uplift");
    assert!((at_g - 0.55 * volume / moment).abs() < 1e-12, "{at_g}");
    let (kind, at_g) = of(&value["variants"][0]["state"]);
    assert_eq!((kind.as_str(), (at_g * 1e9).round()), (Some("sliding"), 0.3e9));
}

#[test]
fn refuses_a_stack_that_overhangs_with_status_1_and_says_where() {
    let scratch = Scratch::with_examples("overhang");
    let project = scratch.path().join("examples/p10/project.toml");
    let text = fs::read_to_string(&project).unwrap();
    let text = text.replace(
        "{ name = \"block 6\", width = 1.9,",
        "{ name = \"block 6\", offset = [0.7, 0], width = 1.9,",
    );
    fs::write(&project, text).unwrap();
    let answer = scratch.dolmen("check examples/p10");
    assert_eq!(answer.status, 1, "{}{}", answer.stdout, answer.stderr);
    assert!(
        answer.stdout.contains("VERDICT Own weight: unstable")
            && answer
                .words()
                .contains("above block 5 the resultant leaves the joint by 0.150 m"),
        "{}",
        answer.stdout
    );
}

#[test]
fn refuses_samples_that_are_not_there_yet() {
    let scratch = Scratch::with_examples("not_yet");
    let answer = scratch.dolmen("check examples/p10 --samples 10");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    assert!(answer.stderr.contains("stack"), "{}", answer.stderr);
}

#[test]
fn holds_a_new_pagoda_can_be_checked_at_once_and_its_variants_stand_side_by_side() {
    let scratch = Scratch::new("new_pagoda");
    let made = scratch.dolmen("new pagoda tower");
    assert_eq!(made.status, 0, "{}", made.stderr);
    let answer = scratch.dolmen("check tower --sensitivity");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "Variants compared",
        "displaced",
        "Friction 0.4",
        "Sensitivity of acceleration of first motion",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    // what has no elasticity, a place of 0, stands behind what has one
    let table = answer
        .stdout
        .split("Sensitivity of acceleration of first motion")
        .nth(1)
        .unwrap();
    let first = table
        .lines()
        .find(|line| line.contains("width") || line.contains("height"))
        .unwrap();
    assert!(first.contains("body 1 width"), "{table}");
}

#[test]
fn exact_measured_frequencies_contradict_the_springs_and_say_their_factor() {
    let scratch = Scratch::with_examples("frequencies");
    let project = scratch.path().join("examples/p10/project.toml");
    let text = fs::read_to_string(&project).unwrap();
    let survey = "[survey.2019]\nfrequencies = { x = [6.0], y = [5.9], weak = [3.0] }\n\n[variant.";
    fs::write(&project, text.replace("[variant.", survey)).unwrap();
    let answer = scratch.dolmen("check examples/p10");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    // ω² is proportional to k, (6.0 · 5.9)/4.7043² = 1.5996, but for 7e-5, as stiffer springs settle less; both modes then have
    // √(6.0 · 5.9)
    let said = [
        "Survey 2019 measured 6.000 Hz in direction x; this model has 4.704 Hz. Its stiffness or mass is not that of the structure \
         measured, and the verdict is on the model.",
        "Natural frequencies on the springs of its joints.",
        "no finding until a survey measures them.",
        "Survey 2019: every joint 1.5997 times as stiff fits its frequencies best (x 6.000 Hz measured, 5.950 Hz then and y 5.900 Hz \
         measured, 5.950 Hz then).",
        "Survey 2019: the frequencies in direction weak are not compared: a stack sways along x and y.",
    ];
    let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    for said in said {
        assert!(
            flat(&answer.stdout).contains(&flat(said)),
            "{said}: {}",
            answer.stdout
        );
    }
    let json = scratch.dolmen("check examples/p10 --json");
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let sway_hz = value["state"]["check"]["stack"]["frequencies"]["sway_y_hz"]
        .as_f64()
        .unwrap();
    let factor = value["state"]["spring_fits"][0]["factor"].as_f64().unwrap();
    assert!((sway_hz - 4.7043).abs() < 5e-5, "{sway_hz}");
    let more = factor / (6.0 * 5.9 / (sway_hz * sway_hz)) - 1.0;
    assert!((5e-5..1e-4).contains(&more), "{factor}");
}

#[test]
fn holds_a_stack_that_falls_has_no_frequencies() {
    let scratch = Scratch::with_examples("falls_without_frequencies");
    let project = scratch.path().join("examples/p10/project.toml");
    let text = fs::read_to_string(&project).unwrap();
    let overhang = "name = \"block 6\", offset = [0.7, 0],";
    fs::write(&project, text.replace("name = \"block 6\",", overhang)).unwrap();
    let answer = scratch.dolmen("check examples/p10");
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    assert!(
        !answer.stdout.contains("Natural frequencies"),
        "{}",
        answer.stdout
    );
}
