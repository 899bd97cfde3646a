// SOURCE     The shipped pile of three blocks under 22 made motions; KDS 17 10 00.
// GOAL       Fragility and risk of a study follow from its runs, say what they rest on, and refuse what cannot be said.
// TOLERANCE  fits 1e-9 against the library given the same scans; everything else printed words.

use super::studies::rows;
use super::verbs::Scratch;
use dolmen::assess::{Hazard, Observation, annual_risk, fit_fragility};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;

const PILE: &str = "examples/piled_blocks/damage.toml";

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    assert_eq!(answer.status, 0, "{command}: {}{}", answer.stdout, answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn holds_curves_and_rates_are_those_of_the_runs() {
    let scratch = Scratch::with_examples("fragility");
    let answer = json(&scratch, &format!("study {PILE} -o out"));
    let folder = scratch.path().join("out/fragility");
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    // DS3 by hand from the runs: of each motion the first peak with it, and the one below
    let runs = rows(&folder.join("runs.csv"));
    let mut motions: BTreeMap<String, Vec<(f64, f64)>> = BTreeMap::new();
    for run in &runs {
        let of = motions.entry(run["motion"].clone()).or_default();
        of.push((
            number(run, "peak_ground_acceleration_m_s2"),
            number(run, "damage_state"),
        ));
    }
    assert_eq!(motions.len(), 22);
    let seen = motions.values().map(|runs| {
        let first = runs.iter().position(|(_, state)| *state >= 3.0).unwrap();
        Observation::Between(runs[first - 1].0, runs[first].0)
    });
    let fit = fit_fragility(&seen.collect::<Vec<_>>()).unwrap();
    let table = rows(&folder.join("fragility.csv"));
    let ds3 = table.iter().find(|row| row["state"] == "DS3").unwrap();
    assert!(
        (number(ds3, "theta_pga_m_s2") / fit.curve.theta() - 1.0).abs() < 1e-9,
        "{ds3:?}"
    );
    assert!(
        (number(ds3, "beta_pga") / fit.curve.beta() - 1.0).abs() < 1e-9,
        "{ds3:?}"
    );
    // the hazard of zone I on S2: 1.4 F_a up to .2 g, where it falls to 1.37 at .22 g
    let hazard = answer["hazard"].as_array().unwrap();
    let points: Vec<[f64; 2]> = hazard
        .iter()
        .map(|point| ["peak_acceleration_m_s2", "annual_rate"].map(|key| point[key].as_f64().unwrap()))
        .collect();
    assert!((points[3][0] / (0.11 * 1.4 * 9.80665) - 1.0).abs() < 1e-12 && points[3][1] == 1.0 / 500.0);
    let risk = annual_risk(&Hazard::of_points(&points).unwrap(), &fit.curve);
    assert!((number(ds3, "annual_rate") / risk.annual_rate - 1.0).abs() < 1e-9);
    // it never falls: a bound and no curve, and DS3 decides
    let states = answer["fragility"][0]["states"].as_array().unwrap();
    let falls = states.last().unwrap();
    assert_eq!(falls["state"], "falls");
    let why = falls["by_peak_acceleration_m_s2"]["why_not"].as_str().unwrap();
    assert!(why.starts_with("none of 22 motions reached the state"), "{why}");
    assert!(falls["annual_rate"].is_null() && states[2]["annual_rate"].is_number());
    assert!(
        fs::read_to_string(folder.join("fragility-1.svg"))
            .unwrap()
            .contains("DS3")
    );
    let text = scratch.dolmen(&format!("study {PILE} -o out")).stdout;
    for said in [
        "at 2.000: P < 0.13",
        "nobody gave it",
        "KDS 17 10 00, 50 to 2400 years",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
    // and the report has it, in both languages
    let file = scratch.path().join(PILE);
    let studies = file.parent().unwrap().join("studies");
    fs::create_dir_all(&studies).unwrap();
    fs::rename(&folder, studies.join("fragility")).unwrap();
    for (language, said) in [("en", "Fragility and risk"), ("ko", "취약도와 위험도")] {
        let answer = scratch.dolmen(&format!("report {PILE} -o page.html --language {language}"));
        assert_eq!(
            answer.status, 1,
            "below demand: {}{}",
            answer.stdout, answer.stderr
        );
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        assert!(page.contains(said), "{said}");
    }
}

#[test]
fn refuses_curves_of_two_motions_and_hazards_that_do_not_fall() {
    let scratch = Scratch::with_examples("fragility_refused");
    let file = scratch.path().join(PILE);
    let whole = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        whole
            .replace("count = 22", "count = 2")
            .replace("steps = 13", "steps = 2"),
    )
    .unwrap();
    let answer = scratch.dolmen(&format!("study {PILE} -o few"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let said = "No fragility curves: 2 usable scans a combination of inputs, 3 or more are needed";
    assert!(answer.stdout.contains(said), "{}", answer.stdout);
    for (hazard, said) in [
        (
            "{ peaks = [\"0.05 g\", \"0.11 g\"], return_periods_years = [475, 475] }",
            "must be below the one before it: stronger shaking is rarer",
        ),
        (
            "{ peaks = [\"0.11 g\", \"0.05 g\"], return_periods_years = [95, 475] }",
            "above the one before it",
        ),
        (
            "{ peaks = [\"0.11 g\"], return_periods_years = [475] }",
            "one peak alone tells no slope",
        ),
        (
            "{ peaks = [\"0.11 g\", \"0.2 g\"], return_periods_years = [475] }",
            "2 peaks, but 1 return periods",
        ),
        (
            "{ peaks = [\"0.05 g\", \"0.11 g\"], return_periods_years = [95, 475], k = 2 }",
            "k goes with one peak alone",
        ),
        (
            "{ peaks = [\"0.11 g\"], return_periods_years = [475], k = -2 }",
            "k of the hazard is -2",
        ),
    ] {
        fs::write(
            &file,
            whole.replace("soil = \"S2\"", &format!("soil = \"S2\"\nhazard = {hazard}")),
        )
        .unwrap();
        let answer = scratch.dolmen(&format!("check {PILE}"));
        assert_eq!(answer.status, 2, "{hazard}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
    let own = "hazard = { peaks = [\"0.05 g\", \"0.11 g\"], return_periods_years = [95, 475] }";
    fs::write(
        &file,
        whole
            .replace("soil = \"S2\"", &format!("soil = \"S2\"\n{own}"))
            .replace("steps = 13", "steps = 6"),
    )
    .unwrap();
    let answer = scratch.dolmen(&format!("study {PILE} -o own"));
    assert!(
        answer
            .stdout
            .contains("by the hazard of the file, 0.050 to 0.110 g"),
        "{}",
        answer.stdout
    );
}
