// SOURCE     examples/palisaden: peaks of its spectrum that tests refuse.
// GOAL       The user can follow the advice on a refused peak; the mode is then used and stays marked in every list.
// TOLERANCE  A frequency is within 3 % of the requested one.

use super::verbs::Scratch;
use serde_json::Value;

const PROJECT: &str = "examples/palisaden/project.toml";

fn with(scratch: &Scratch, added: &str) {
    let file = scratch.path().join(PROJECT);
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(file, text + added).unwrap();
}

fn modes(value: &Value) -> &Vec<Value> {
    value["surveys"][0]["records"]["modes"]["modes"]
        .as_array()
        .unwrap()
}

#[test]
fn holds_the_advice_on_a_refused_peak_can_be_followed_and_the_mode_keeps_its_mark() {
    let scratch = Scratch::with_examples("accepted_modes");
    let usual = scratch.dolmen(&format!("identify {PROJECT}"));
    let words = usual.words();
    let advice = "If you know one to be a mode, accept = [";
    let at = words.find(advice).unwrap_or_else(|| panic!("{words}")) + advice.len();
    let number = words[at..].split(']').next().unwrap();
    with(
        &scratch,
        &format!("\n[survey.ambient.records.modal]\naccept = [{number}, 40.912, 9]\n"),
    );

    let json = scratch.dolmen(&format!("identify {PROJECT} --json"));
    let value: Value = serde_json::from_str(&json.stdout).unwrap();
    let accepted: Vec<&Value> = modes(&value)
        .iter()
        .filter(|m| !m["accepted"].is_null())
        .collect();
    let asked: f64 = number.parse().unwrap();
    let of = |mode: &Value, key: &str| mode[key].as_f64();
    assert_eq!((modes(&value).len(), accepted.len()), (9, 2));
    assert!((of(accepted[0], "frequency_hz").unwrap() / asked - 1.0).abs() < 0.03);
    assert!(of(accepted[0], "frequency_sd_hz").is_some() && of(accepted[0], "damping_ratio").is_some());
    let refused = |mode: &Value| mode["accepted"]["refused"].as_str().unwrap().to_owned();
    assert!(refused(accepted[0]).contains("times its floor, at most 3.5"));
    // no pole has the frequency of a tone: it has no damping ratio, and the answer calls it narrow
    assert!(of(accepted[1], "damping_ratio").is_none());
    assert!(refused(accepted[1]).contains("narrower or steadier than a mode"));

    let english = scratch.dolmen(&format!("identify {PROJECT}"));
    let words = english.words();
    assert!(words.contains("7 modes were found in 10 minutes"), "{words}");
    assert!(
        words.contains("Accepted by the user, not found by the tests: 11.3"),
        "{words}"
    );
    assert!(
        words.contains("8 (accepted)") && words.contains("9 (accepted)"),
        "{words}"
    );
    assert!(
        words.contains("accept = [9] takes nothing")
            && words.contains("the nearest are at 7.015 and 10.999 Hz"),
        "{words}"
    );
    let korean = scratch.dolmen(&format!("identify {PROJECT} --language ko"));
    let words = korean.words();
    assert!(
        words.contains("8(채택)") && words.contains("사용자가 채택한 모드로"),
        "{words}"
    );
    assert!(words.contains("accept = [9]에 해당하는 것이 없다"), "{words}");

    scratch.dolmen(&format!("identify {PROJECT} -o out"));
    let file = |name: &str| std::fs::read_to_string(scratch.path().join("out").join(name)).unwrap();
    let rows: Vec<String> = file("ambient-modes.csv").lines().map(str::to_owned).collect();
    assert!(rows[0].contains(",accepted,") && rows[7].contains(",false,") && rows[8].contains(",true,"));
    assert!(file("ambient-modes.uff").contains("ambient mode 8 (accepted by the user)"));
}

#[test]
fn holds_a_comparison_names_what_was_accepted() {
    let scratch = Scratch::with_examples("accepted_compared");
    let file = scratch.path().join(PROJECT);
    let text = std::fs::read_to_string(&file).unwrap();
    let second =
        text[text.find("[survey.ambient]").unwrap()..].replace("survey.ambient", "survey.2026-02-01");
    let second = second.replace("record.npy", "second.npy");
    scratch.copy_as_take(
        1,
        "examples/palisaden/record.npy",
        "examples/palisaden/second.npy",
    );
    let first = text.replace("survey.ambient", "survey.2026-01-01");
    let all = format!("{first}\n{second}\n[survey.2026-02-01.records.modal]\naccept = [11.355]\n");
    std::fs::write(&file, all).unwrap();
    let said = scratch.dolmen(&format!("compare {PROJECT}"));
    let words = said.words();
    assert!(
        words.contains("Accepted by the user in the survey after, where no test found them: 11.31"),
        "{words} {}",
        said.stderr
    );
    let json = scratch.dolmen(&format!("compare {PROJECT} --json"));
    assert!(json.stdout.contains("\"accepted\": true"), "{}", json.stdout);
}

#[test]
fn refuses_a_frequency_that_is_none() {
    let scratch = Scratch::with_examples("accepted_refused");
    with(&scratch, "\n[survey.ambient.records.modal]\naccept = [-3.4]\n");
    let said = scratch.dolmen(&format!("identify {PROJECT}"));
    assert_ne!(said.status, 0);
    assert!(said.stderr.contains("modal.accept[0]"), "{}", said.stderr);
}
