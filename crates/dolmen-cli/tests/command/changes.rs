// SOURCE     The made-up gate through the seasons; ten minutes of Palisaden cut into two setups of four sensors.
// GOAL       `dolmen compare` and several setups: intervals contain the true changes, and doubts are stated.
// TOLERANCE  the 95 % intervals of the answer; printed words.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const GATE: &str = "examples/gate_through_the_seasons/project.toml";

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    assert_eq!(answer.status, 0, "{command}: {}{}", answer.stdout, answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn holds_true_changes_lie_in_their_intervals_once_the_weather_is_out() {
    let scratch = Scratch::with_examples("changes");
    let found = json(&scratch, &format!("compare {GATE} -o out"));
    assert_eq!(found["temperature"], "corrected");
    let modes = found["modes"].as_array().unwrap();
    for (mode, truth) in modes.iter().zip([-0.022, -0.006, -0.002]) {
        let frequency = &mode["frequency"];
        let off = (frequency["relative"].as_f64().unwrap() - truth).abs();
        assert!(
            off < frequency["evidence"]["half_width_95"].as_f64().unwrap(),
            "{mode}"
        );
    }
    assert_eq!(
        (found["changed"].as_u64(), found["tested"].as_u64()),
        (Some(1), Some(3))
    );
    assert!(
        fs::read_to_string(scratch.path().join("out/change.svg"))
            .unwrap()
            .contains("2.140 Hz")
    );

    // without the temperature correction all three seem to have changed, and the answer states the doubt
    let text = fs::read_to_string(scratch.path().join(GATE)).unwrap();
    fs::write(
        scratch.path().join("blind.toml"),
        text.replace("temperature = \"fitted\"", ""),
    )
    .unwrap();
    let blind = json(&scratch, "compare blind.toml");
    assert_eq!(
        (blind["changed"].as_u64(), blind["may_be_the_weather"].as_bool()),
        (Some(3), Some(true))
    );

    // a given coefficient with its deviation
    let known = "temperature_coefficient_per_c = -0.0011\ntemperature_coefficient_sd_per_c = 0.0002";
    fs::write(
        scratch.path().join("known.toml"),
        text.replace("temperature = \"fitted\"", known),
    )
    .unwrap();
    let known = json(&scratch, "compare known.toml");
    let explained = known["modes"][0]["explained_by_temperature"].as_f64().unwrap();
    assert!((explained + 0.0121).abs() < 1e-12, "{explained}");
    assert_eq!(
        (known["temperature"].as_str(), known["changed"].as_u64()),
        (Some("corrected"), Some(1))
    );
}

#[test]
fn holds_the_report_says_what_changed_and_what_could_be_missed() {
    let scratch = Scratch::with_examples("changes-report");
    for (language, words) in [
        (
            "en",
            [
                "What changed",
                "1 of 3 frequencies changed beyond chance",
                "is no proof that nothing changed",
            ],
        ),
        (
            "ko",
            [
                "조사 사이의 변화",
                "고유진동수 3개 중 1개가 유의하게",
                "변화가 없다는 증명이 아니다",
            ],
        ),
    ] {
        let made = scratch.dolmen(&format!("report {GATE} --language {language} -o {language}.html"));
        assert_eq!(made.status, 0, "{}", made.stderr);
        let page = fs::read_to_string(scratch.path().join(format!("{language}.html"))).unwrap();
        for words in words {
            assert!(page.contains(words), "{language}: {words}");
        }
    }
}

#[test]
fn holds_two_setups_of_four_sensors_show_what_one_of_six_shows() {
    let scratch = Scratch::with_examples("setups");
    let of = |file: &str| json(&scratch, &format!("identify examples/palisaden/{file}"));
    let (whole, cut) = (of("project.toml"), of("setups.toml"));
    let whole = &whole["surveys"][0]["records"]["modes"];
    let setups = &cut["surveys"][0]["setups"];
    assert_eq!(setups["references"], serde_json::json!(["ch1", "ch2"]));
    assert_eq!(setups["records"].as_array().unwrap().len(), 2);
    let number = |mode: &Value, key: &str| mode[key].as_f64().unwrap();
    for i in 0..3 {
        let (a, b) = (&whole["modes"][i], &setups["modes"]["modes"][i]);
        let apart = (number(a, "frequency_hz") - number(b, "frequency_hz")).abs();
        let sd = number(a, "frequency_sd_hz").hypot(number(b, "frequency_sd_hz"));
        assert!(apart < 2.0 * sd, "{a} {b}");
        let shape = |mode: &Value| -> Vec<f64> {
            mode["shape"]
                .as_array()
                .unwrap()
                .iter()
                .map(|z| z[0].as_f64().unwrap())
                .collect()
        };
        let (a, b) = (shape(a), shape(b));
        assert_eq!(a.len(), 6);
        let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
        let mac = dot(&a, &b).powi(2) / (dot(&a, &a) * dot(&b, &b));
        assert!(mac > 0.98, "mode {i}: {mac}");
    }
    let partial = setups["partial"].as_array().unwrap();
    assert!(!partial.is_empty(), "{setups}"); // not all modes show in five minutes of four sensors
}

#[test]
fn holds_two_setups_identified_as_one_show_what_one_record_shows() {
    let scratch = Scratch::with_examples("setups-as-one");
    let file = scratch.path().join("examples/palisaden/setups.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        text.replace("[survey.ambient]", "[survey.ambient]\nmerge = \"preger\""),
    )
    .unwrap();
    let found = json(&scratch, "identify examples/palisaden/setups.toml");
    let joint = &found["surveys"][0]["setups"]["joint"];
    assert_eq!(joint["references"], serde_json::json!(["ch1", "ch2"]));
    assert!(
        (joint["strength"][1].as_f64().unwrap() - 1.0).abs() < 0.1,
        "{joint}"
    );
    // published, of 90 minutes: 1.882, 2.421, 2.687 Hz
    for (mode, published) in joint["modes"]["modes"]
        .as_array()
        .unwrap()
        .iter()
        .zip([1.882, 2.421, 2.687])
    {
        let of = |key: &str| mode[key].as_f64().unwrap();
        let apart = (of("frequency_hz") - published).abs();
        assert!(apart < 2.0 * of("frequency_sd_hz"), "{mode}");
        assert_eq!(mode["shape"].as_array().unwrap().len(), 6);
    }
    let text = scratch.dolmen("identify examples/palisaden/setups.toml").stdout;
    assert!(text.contains("6 sensors; in every setup: ch1 and ch2;"), "{text}");
    let page = scratch.dolmen("report examples/palisaden/setups.toml -o as-one.html");
    assert_eq!(page.status, 0, "{}", page.stderr);
    let page = fs::read_to_string(scratch.path().join("as-one.html")).unwrap();
    let (_, section) = page
        .split_once("Setups identified as one")
        .unwrap_or_else(|| panic!("the report has their section"));
    // other notes follow those of the identification
    let notes = joint["notes"].as_array().unwrap();
    assert!(!notes.is_empty(), "{joint}");
    assert!(
        section.matches("class=\"note\"").count() >= notes.len(),
        "{joint}"
    );
    assert_eq!(joint["settings"]["references"], serde_json::json!(["ch1", "ch2"]));
    assert!(!text.contains("holds the setups together"), "{text}");
}

#[test]
fn holds_one_sensor_that_alone_holds_setups_together_is_said() {
    let scratch = Scratch::with_examples("one-reference");
    let file = scratch.path().join("examples/palisaden/setups.toml");
    let text = fs::read_to_string(&file).unwrap();
    let second = text.rfind("  { column = 2,").unwrap();
    let end = second + text[second..].find('\n').unwrap() + 1;
    fs::write(&file, format!("{}{}", &text[..second], &text[end..])).unwrap();
    let found = scratch.dolmen("identify examples/palisaden/setups.toml");
    assert!(
        found
            .stdout
            .contains("One sensor alone, \"ch1\", holds the setups together:"),
        "{}",
        found.stdout
    );
}

#[test]
fn refuses_surveys_that_cannot_be_compared() {
    let scratch = Scratch::with_examples("changes-refused");
    let one = scratch.dolmen("compare examples/palisaden");
    assert_eq!(one.status, 2);
    assert!(
        one.stderr
            .contains("name them with --from and --to (it has ambient)"),
        "{}",
        one.stderr
    );
    let none = scratch.dolmen(&format!("compare {GATE} --from 1999"));
    assert!(
        none.stderr.contains("there is no survey \"1999\""),
        "{}",
        none.stderr
    );
}

/// Two surveys of a pole by their frequencies, Hz.
fn surveys(name: &str, before: &str, after: &str) -> String {
    let scratch = Scratch::new(name);
    let hz = |list: &str| -> String {
        let each = list.split(' ').map(|hz| format!("{{ value = {hz}, sd = 0.01 }}"));
        each.collect::<Vec<_>>().join(", ")
    };
    let text = format!(
        "schema = 1\nkind = \"survey\"\nname = {{ en = \"Pole\" }}\n[survey.2020]\nfrequencies.x = [{}]\n[survey.2024]\nfrequencies.x = [{}]\n",
        hz(before),
        hz(after)
    );
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen("compare project.toml");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    answer.words()
}

/// Checks that the line beginning with these words precedes the other.
fn comes_first(text: &str, line: &str, other: &str) {
    let at = |words: &str| text.find(words).unwrap_or_else(|| panic!("{words}: {text}"));
    assert!(at(line) < at(other), "{text}");
}

#[test]
fn holds_a_pairing_with_more_pairs_is_said_before_no_change() {
    let text = surveys("more-pairs", "1.00 1.10", "0.90 1.00");
    comes_first(
        &text,
        "Which mode is which is not sure: more of them find a partner by 1.000 Hz → 0.9000 Hz (−10.0 %) and 1.100 Hz → 1.000 Hz (−9.1 %)",
        "no change was shown in 1 of 2 frequencies",
    );
    assert!(!surveys("one-pairing", "1.00 1.10", "0.99 1.09").contains("not sure"));
}

#[test]
fn holds_what_moved_too_far_to_be_paired_is_said_first_with_what_it_may_be() {
    let text = surveys("moved-far", "1.1 2.9", "0.7 1.8");
    // 0.7/1.1 - 1 = -36 %, (0.7/1.1)² - 1 = -60 %
    assert!(
        text.contains(
            "The lowest mode (1.100 Hz) was not found again and is not compared. A new one lies at 0.7000 Hz: if it is the same mode, it fell by 36 % (60 % of stiffness)"
        ),
        "{text}"
    );
    assert_eq!(text.matches("1.100").count(), 1, "named once: {text}");
    assert!(
        text.contains("A mode that is not found again may have moved further than pairs"),
        "{text}"
    );
    let text = surveys("one-lost", "1.0 2.9", "2.91");
    comes_first(
        &text,
        "The lowest mode (1.000 Hz) was not found again",
        "no change was shown in 1 of 2",
    );
}
