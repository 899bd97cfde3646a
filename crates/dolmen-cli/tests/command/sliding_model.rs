// SOURCE     The block of Hwang & Kim (2002), 300 × 200 × 100 mm; a block on a ground that shakes as a sine and stops, exact event by event.
// GOAL       `--law sliding` gives slip, turn and mode of each bed beside the contact simulation, and says where the model does not hold.
// TOLERANCE  0.5 % of the exact slip: the sine is sampled every ms. 2 % against springs, which are not rigid.

use super::verbs::Scratch;
use serde_json::Value;
use std::f64::consts::TAU;
use std::fs;

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr))
}

/// 10 s of a sine of 0.5 g and 2 Hz, and 2 s of rest.
fn sine(scratch: &Scratch) {
    let mut text = String::from("time (s),acc (m/s2)\n");
    for i in 0..=12_000 {
        let t = f64::from(i) * 1e-3;
        let a = if t <= 10.0 {
            0.5 * 9.80665 * (2.0 * TAU * t).sin()
        } else {
            0.0
        };
        text.push_str(&format!("{t:.3},{a:.9}\n"));
    }
    fs::write(scratch.path().join("sine.csv"), text).unwrap();
}

#[test]
fn exact_slip_of_one_block_on_a_sine() {
    let scratch = Scratch::with_examples("sliding_model");
    sine(&scratch);
    let run = json(
        &scratch,
        "simulate examples/piled_blocks --motion-file x=sine.csv --law sliding",
    );
    let model = &run["sliding_model"];
    assert_eq!(model["outcome"], "slid");
    let bed = &model["beds"][0];
    assert_eq!(bed["mode"], "slide");
    let of = |key: &str| bed[key].as_f64().unwrap();
    // peak 24.48 mm, residual 0.42031 mm
    assert!((of("peak_slip_m") / 24.48e-3 - 1.0).abs() < 5e-3, "{bed}");
    assert!(
        (of("residual_slip_m") - 0.42031e-3).abs() < 5e-3 * 24.48e-3,
        "{bed}"
    );
    let lost = model["energy_error_j"].as_f64().unwrap() / model["friction_j"].as_f64().unwrap();
    assert!(lost < 1e-6, "{lost:e}");
    let springs = run["joints"][0]["peak_slip_m"].as_f64().unwrap();
    assert!((of("peak_slip_m") / springs - 1.0).abs() < 0.02, "{springs}");
}

#[test]
fn holds_words_of_the_sliding_model_and_where_it_does_not_hold() {
    let scratch = Scratch::with_examples("sliding_words");
    let said = |command: &str, words: &str| {
        let answer = scratch.dolmen(command);
        assert!(
            answer.words().contains(words),
            "{command}: {words}: {}{}",
            answer.stdout,
            answer.stderr
        );
    };
    let blocks = "simulate examples/piled_blocks --motion el-centro-1940-ns --keep-first 6 --law sliding";
    said(&format!("{blocks} --peak 0.2g"), "no bed lets go");
    said(
        &format!("{blocks} --peak 0.5g"),
        "1 of 1 beds let go, the one below ‘block 1’ most",
    );
    said(
        &format!("{blocks} --peak 0.5g"),
        "Beds by the sliding model, lowest first.",
    );
    said(&format!("{blocks} --peak 0.5g --language ko"), "미끄러짐 모델");
    // a slender stone rocks first
    let path = scratch.path().join("examples/piled_blocks/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(
        &path,
        text.replacen("depth = 200, height = 100", "depth = 200, height = 900", 1)
            .replace("friction = { value = 0.3", "friction = { value = 0.7"),
    )
    .unwrap();
    said(
        &format!("{blocks} --peak 0.5g"),
        "The sliding model does not hold here",
    );
    // an arch is no pile
    let refused =
        scratch.dolmen("simulate examples/arch --motion el-centro-1940-ns --keep-first 1 --law sliding");
    assert_eq!(refused.status, 2, "{}{}", refused.stdout, refused.stderr);
}
