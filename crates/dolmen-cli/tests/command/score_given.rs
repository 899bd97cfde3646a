//! The score of a pagoda with a measured frequency.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

fn pagoda(survey: &str) -> String {
    let top = "schema = 1\nkind = \"stack\"\nname = \"Five storeys\"\ndensity = 2600\n\
               joint = { friction = 0.6, normal_stiffness = 1e9, shear_stiffness = 4e8 }\n\
               pagoda = { storeys = 5, body_height = 6.0, body_slenderness = 3.74, taper = \"8 deg\", body_base_height_ratio = 3 }\n";
    format!("{top}[survey.2026-04-02]\n{survey}\n")
}

#[test]
fn holds_softer_joints_make_damage_more_probable_and_stiffer_ones_less() {
    let scratch = Scratch::new("score_given");
    let of = |hz: f64| -> Value {
        let survey = format!("frequencies.x = [{{ value = {hz}, sd = 0.05 }}]");
        fs::write(scratch.path().join("five.toml"), pagoda(&survey)).unwrap();
        let answer = scratch.dolmen("score five.toml --given 2026-04-02 --json");
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        serde_json::from_str(&answer.stdout).unwrap()
    };
    let ds3 = |answer: &Value, key: &str| {
        let own = &answer["given"]["states"][1];
        assert_eq!(own["state"], "ds3");
        own["probability"][1][key].as_f64().unwrap()
    };
    let (soft, stiff) = (of(1.4), of(5.6));
    let unknown = ds3(&soft, "stiffness_unknown");
    assert_eq!(unknown, ds3(&stiff, "stiffness_unknown"));
    assert!(ds3(&soft, "frequency_given") > unknown && unknown > ds3(&stiff, "frequency_given"));
    // f is proportional to the root of the stiffness
    let given = &stiff["given"];
    let ratio = 5.6 / given["frequency_on_joints_of_designs_hz"].as_f64().unwrap();
    let found = given["stiffness_ratio"].as_f64().unwrap();
    assert!((found / (ratio * ratio) - 1.0).abs() < 0.01, "{found}");
    assert!(given["effective_draws"].as_f64().unwrap() > 200.0);
}

#[test]
fn refuses_a_survey_that_tells_no_frequency_or_an_impossible_one() {
    let scratch = Scratch::new("score_given_faults");
    let told = |survey: &str, arguments: &str| {
        fs::write(scratch.path().join("five.toml"), pagoda(survey)).unwrap();
        let answer = scratch.dolmen(&format!("score five.toml {arguments}"));
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        let words: Vec<&str> = answer.stderr.split_whitespace().collect();
        words.join(" ")
    };
    let given = "--given 2026-04-02";
    assert!(told("frequencies.x = [30]", given).contains("allow 0.99 Hz to 8.10 Hz"));
    assert!(
        told("frequencies.x = [30]", "--given 2026-04-02 --language ko").contains("0.99~8.10 Hz이어야 한다")
    );
    assert!(told("note = \"seen\"", given).contains("no measured frequency of swaying"));
    assert!(told("frequencies.x = [2]", "--given 2025").contains("there is no survey \"2025\""));
    assert!(told("frequencies.x = [2]", "").contains("dolmen score --given SURVEY"));
    // nobody measured it
    assert!(told("made_up = true\nfrequencies.x = [2]", given).contains("no measured frequency of swaying"));
}

#[test]
fn refuses_damage_and_crushing_edges_which_no_design_of_the_score_has() {
    let scratch = Scratch::new("score_damaged");
    let lost = "inspections = [{ part = \"storey 1 body\", what = \"loss\", model = { bed_lost = 0.3, side = \"x+\" } }]";
    let measured = "frequencies.x = [{ value = 2.0, sd = 0.05 }]\n";
    let said = |text: String, words: &str| {
        fs::write(scratch.path().join("five.toml"), text).unwrap();
        let answer = scratch.dolmen(words);
        (answer.status, answer.stdout + &answer.stderr)
    };
    let damaged = pagoda(&format!("{measured}{lost}"));
    for words in ["score five.toml", "score five.toml --given 2026-04-02"] {
        let (status, words) = said(damaged.clone(), words);
        assert_eq!(status, 2, "{words}");
        assert!(words.contains("one damage found by inspection"), "{words}");
    }
    let crushed = pagoda("").replace(
        "shear_stiffness = 4e8",
        "shear_stiffness = 4e8, strength = \"1 MPa\"",
    );
    let (status, words) = said(crushed, "score five.toml");
    assert!(
        status == 2 && words.contains("crush at 1.000 MPa"),
        "{status} {words}"
    );
    // forced: the joints are those of the undamaged pagoda with this frequency, so that damage makes nothing safer
    let forced = |text: String| -> Value {
        let (_, words) = said(
            text,
            "score five.toml --given 2026-04-02 --extrapolate --json --quiet",
        );
        serde_json::from_str(&words).unwrap()
    };
    let [sound, damaged] = [pagoda(measured), damaged].map(|text| forced(text)["given"].clone());
    assert_eq!(sound["stiffness_ratio"], damaged["stiffness_ratio"]);
}
