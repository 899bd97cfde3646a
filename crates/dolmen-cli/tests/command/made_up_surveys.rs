// SOURCE     The shipped flagpole, whose frequencies nobody measured, and a gate with a survey that contradicts its model.
// GOAL       The headline of every verb names a survey that was not measured, and such a survey is no evidence for or against a model.
// TOLERANCE  none: printed words.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

#[test]
fn holds_every_headline_names_a_survey_that_nobody_measured() {
    let scratch = Scratch::with_examples("made_up_headline");
    for verb in ["check", "identify"] {
        let answer = scratch.briefly(&format!("{verb} examples/naju_flagpole"));
        let words = answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            words.contains("made up, not measured: survey demonstration"),
            "{verb}: {}",
            answer.stdout
        );
        let korean = scratch.briefly(&format!("{verb} examples/naju_flagpole --language ko"));
        let korean = korean.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            korean.contains("실측이 아닌 가상 조사: demonstration"),
            "{verb}: {korean}"
        );
    }
    let found: Value =
        serde_json::from_str(&scratch.dolmen("--json identify examples/naju_flagpole").stdout).unwrap();
    assert_eq!(found["made_up_surveys"], serde_json::json!(["demonstration"]));
    // many are counted
    for verb in ["check", "watch"] {
        let answer = scratch.dolmen(&format!("{verb} examples/flagpole_over_the_years"));
        let words = answer.words();
        assert!(
            words.contains("made up, not measured: 25 surveys, 2014-05-12 to 2026-05-12"),
            "{verb}: {words}"
        );
    }
    let shaken = scratch.dolmen("simulate examples/inspected_flagpole --motion el-centro-1940-ns");
    let words = shaken.words();
    assert!(words.contains("assumed inputs: 25 of 25"), "{words}");
    // a measured survey is not named
    let gate = scratch.briefly("identify examples/heunginjimun_gate");
    assert!(!gate.stdout.contains("made up"), "{}", gate.stdout);
}

#[test]
fn holds_what_nobody_measured_contradicts_no_model() {
    let scratch = Scratch::with_examples("made_up_evidence");
    let path = scratch.path().join("examples/free_columns/project.toml");
    let whole = fs::read_to_string(&path).unwrap();
    let evidence = |of: &str| {
        fs::write(
            &path,
            format!("{whole}\n[survey.2026-05-01]\n{of}frequencies = {{ x = [{{ value = 9.5, source = \"measured\" }}] }}\n"),
        )
        .unwrap();
        let answer = scratch.briefly("check examples/free_columns");
        assert!(answer.stderr.is_empty(), "{}", answer.stderr);
        answer.stdout
    };
    let measured = evidence("");
    assert!(measured.contains("contradicts"), "{measured}");
    let made_up = evidence("made_up = true\n");
    assert!(
        !made_up.contains("contradicts") && made_up.contains("made up, not measured"),
        "{made_up}"
    );
}
