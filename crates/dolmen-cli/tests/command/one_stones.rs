// SOURCE     The flagpole of Choi (2021) with its stone, Fig. 8.
// GOAL       The check compares a pole with a single stone, says how loose it is, and refuses a stone that no pole has.
// TOLERANCE  1e-9 between numbers of one answer; tests of the library check the frequencies against other methods.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const POLE: &str = "examples/naju_flagpole/one_stone.toml";

fn numbers(value: &Value) -> Vec<f64> {
    let all = value.as_array().unwrap();
    all.iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn holds_a_pole_on_joints_is_below_one_stone_in_every_mode() {
    let scratch = Scratch::with_examples("one_stone");
    let answer = scratch.dolmen(&format!("--json check {POLE}"));
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let whole: Value = serde_json::from_str(&answer.stdout).unwrap();
    let chain = &whole["state"]["check"]["chain"];
    let one = &chain["one_stone"];
    let of = |key: &str| numbers(&one[key]);
    let (bends, shears, jointed) = (of("bernoulli_euler_hz"), of("timoshenko_hz"), of("jointed_hz"));
    assert_eq!([bends.len(), shears.len(), jointed.len()], [5; 3]);
    for (i, ratio) in of("ratios").iter().enumerate() {
        let rigid = chain["modes"][i]["frequency_hz"].as_f64().unwrap();
        assert!((rigid / shears[i] / ratio - 1.0).abs() < 1e-9);
        assert!(jointed[i] < shears[i] && shears[i] < bends[i]);
    }
    // joints a hundred times as stiff give ten times the joint frequency, and less where the stones bend
    let tight = &whole["variants"][0]["state"]["check"]["chain"]["one_stone"];
    let tight_ratio = numbers(&tight["ratios"])[0];
    assert!(tight_ratio > 9.0 * of("ratios")[0], "{tight_ratio}");
    assert!(numbers(&tight["jointed_hz"])[0] < shears[0]);
    // with unknown joints only the single stone remains
    let path = scratch.path().join(POLE);
    let text = fs::read_to_string(&path).unwrap();
    let (before, rest) = text.split_once("joints = [").unwrap();
    let (_, after) = rest.split_once("]\ncap").unwrap();
    let (after, _) = after.split_once("# The same pole without").unwrap();
    fs::write(&path, format!("{before}joints = \"unknown\"\ncap{after}")).unwrap();
    let answer = scratch.dolmen(&format!("--json check {POLE}"));
    let unknown: Value = serde_json::from_str(&answer.stdout).unwrap();
    let one = &unknown["state"]["check"]["chain"]["one_stone"];
    assert_eq!(numbers(&one["timoshenko_hz"]), shears);
    assert!(numbers(&one["jointed_hz"]).is_empty() && numbers(&one["ratios"]).is_empty());
    assert!(
        scratch
            .dolmen(&format!("check {POLE}"))
            .words()
            .contains("As one uncracked stone its lowest frequency would be")
    );
}

#[test]
fn holds_the_answer_reads_in_both_languages() {
    let scratch = Scratch::with_examples("one_stone_words");
    let english = scratch.dolmen(&format!("check {POLE}"));
    for said in [
        "of the lowest frequency that it would have as one uncracked stone",
        "Frequencies on its joints and as one stone, Hz.",
        "The shafts that the links are taken as, m.",
    ] {
        assert!(english.words().contains(said), "{said}: {}", english.stdout);
    }
    let korean = scratch.dolmen(&format!("check {POLE} --language ko"));
    for said in ["균열 없는 한 돌", "한 돌로 된 기둥과의 비교"] {
        assert!(korean.words().contains(said), "{said}: {}", korean.stdout);
    }
}

#[test]
fn refuses_a_stone_that_no_pole_has() {
    let scratch = Scratch::with_examples("one_stone_refused");
    let path = scratch.path().join(POLE);
    let text = fs::read_to_string(&path).unwrap();
    let refused = |from: &str, to: &str, said: &[&str]| {
        assert!(text.contains(from), "{from}");
        fs::write(&path, text.replace(from, to)).unwrap();
        let answer = scratch.dolmen(&format!("check {POLE}"));
        assert_eq!(answer.status, 2, "{to}: {}{}", answer.stdout, answer.stderr);
        for said in said {
            assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
        }
    };
    refused(
        "\"40 GPa\"",
        "\"40 MPa\"",
        &["stone.elastic_modulus", "0.5 to 250 GPa"],
    );
    refused("\"2570 kg/m3\"", "2.57", &["stone.density", "300 to 9000 kg/m3"]);
    refused(
        "value = 0.2, source",
        "value = 0.7, source",
        &["stone.poisson_ratio", "0.5"],
    );
    refused(
        "density = \"2570 kg/m3\"",
        "",
        &["stone has no stone.density", "granite"],
    );
    refused(
        "length = 1.37, centroid = 0.66",
        "length = 1.37, centroid = 0.2",
        &["links[5].centroid", "0.25 to 0.75 of the length"],
    );
}
