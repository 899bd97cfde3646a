// SOURCE     Closed form: a linear building reaches a drift d at a_i = d/drift_i of each motion; the most likely lognormal of capacities
//            that are all known has the mean and the standard deviation (with 1/n) of ln a_i.
// GOAL       A study gives the curve and the risk of the allowable drift that `check` judges by, of a building and of a frame.
// TOLERANCE  1e-6 of the fitted curve, the accuracy of its search; equal numbers for equal limits.

use super::studies::rows;
use super::verbs::{Answer, Scratch};
use std::collections::BTreeMap;
use std::fs;

const BUILDING: &str = r#"schema = 1
kind = "building"
name = "Hall"
units = { mass = "t", stiffness = "kN/mm" }
floors = [{ mass = 150, sides = [16, 10], height = 4.5, stiffness = { x = 20, y = 20, rotation = "2000 MN*m/rad", centre = [0, 0] } }]
damping.ratio = 0.05
"#;

const FRAME: &str = r#"schema = 1
kind = "frame"
name = "Gate"
units = { mass = "t", stiffness = "kN/mm" }
storeys = [{ mass = 60, height = 4.2 }, { mass = 45, height = 3.6 }]
[direction.x]
stiffness = [1.0, 0.7]
damping_ratio = 0.05
"#;

const SITE: &str = r#"
[site]
code = "KDS 17 10 00"
zone = "I"
return_period_years = 1000
soil = "S3"
"#;

fn studied(name: &str, model: &str, limit: &str, study: &str) -> (Answer, Scratch) {
    let scratch = Scratch::new(name);
    let limits = format!("[limits]\nstorey_drift = \"{limit}\"\nsource = \"test\"\n");
    let text = format!("{model}{SITE}{limits}[study.s]\n{study}\n");
    fs::write(scratch.path().join("p.toml"), text).unwrap();
    let answer = scratch.dolmen("study p.toml -o out");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    (answer, scratch)
}

type Row = BTreeMap<String, String>;

fn number(row: &Row, key: &str) -> f64 {
    row[key].parse().unwrap_or_else(|_| panic!("{key}: {row:?}"))
}

fn state<'r>(all: &'r [Row], name: &str) -> &'r Row {
    all.iter().find(|row| row["state"] == name).unwrap()
}

#[test]
fn exact_the_allowable_drift_of_a_linear_building_has_the_curve_of_its_capacities() {
    let study = "artificial = { count = 5, duration_s = 6, strong_s = 2, rise_s = 1 }\npeak = [\"0.2 g\", \"2 g\"]\nrefine = 0\ndrift_limits = [0.002, 0.005, 0.02, 0.1]";
    let (answer, scratch) = studied("allowed-drift-building", BUILDING, "0.5 %", study);
    let scans = rows(&scratch.path().join("out/s/capacities.csv"));
    let ln: Vec<f64> = scans
        .iter()
        .map(|row| number(row, "first_beyond_allowed_drift_m_s2").ln())
        .collect();
    // by hand, from the drift of the largest run of each scan
    let runs = rows(&scratch.path().join("out/s/runs.csv"));
    for (scan, ln) in scans.iter().zip(&ln) {
        let own = runs.iter().filter(|run| run["motion"] == scan["motion"]);
        let largest = own
            .max_by(|a, b| number(a, "scale").total_cmp(&number(b, "scale")))
            .unwrap();
        let peak_m_s2 = number(largest, "peak_ground_acceleration_m_s2");
        let exact = 0.005 / number(largest, "peak_corner_drift_ratio") * peak_m_s2;
        assert!((ln - exact.ln()).abs() < 1e-12, "{scan:?}");
    }
    let mean = ln.iter().sum::<f64>() / ln.len() as f64;
    let sd = (ln.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / ln.len() as f64).sqrt();
    let curves = rows(&scratch.path().join("out/s/fragility.csv"));
    let allowed = state(&curves, "allowed drift");
    assert!(
        (number(allowed, "theta_pga_m_s2") / mean.exp() - 1.0).abs() < 1e-6,
        "{allowed:?}"
    );
    assert!(
        (number(allowed, "beta_pga") / sd - 1.0).abs() < 1e-6,
        "{allowed:?}"
    );
    // the second limit of the study is the same drift
    let second = state(&curves, "limit 2");
    for key in [
        "theta_pga_m_s2",
        "beta_pga",
        "annual_rate",
        "probability_in_50_years",
    ] {
        assert_eq!(allowed[key], second[key], "{key}");
        assert!(number(allowed, key) > 0.0);
    }
    for said in [
        "By the curve fitted to them (lognormal) half exceed it at",
        "in 50 years",
        "drift 0.5 %",
        "allowed drift 0.5 %",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
}

#[test]
fn holds_the_allowable_drift_of_a_frame_is_a_state_like_the_drift_at_which_its_runs_end() {
    let study = "artificial = { count = 4, duration_s = 6, strong_s = 2, rise_s = 1 }\npeak = { from = \"0.05 g\", to = \"2 g\", steps = 16, spacing = \"logarithmic\" }\nrefine = 1";
    // a run ends at 10 %
    let (_, scratch) = studied("allowed-drift-frame", FRAME, "10 %", study);
    let curves = rows(&scratch.path().join("out/s/fragility.csv"));
    let (allowed, ends) = (state(&curves, "allowed drift"), state(&curves, "drift limit"));
    for key in ["reached", "theta_pga_m_s2", "beta_pga", "annual_rate"] {
        assert_eq!(allowed[key], ends[key], "{key}");
    }
    // a smaller one is exceeded earlier
    let (answer, scratch) = studied("allowed-drift-frame-2", FRAME, "2 %", study);
    let curves = rows(&scratch.path().join("out/s/fragility.csv"));
    let allowed = state(&curves, "allowed drift");
    assert!(
        number(allowed, "theta_pga_m_s2") < number(ends, "theta_pga_m_s2"),
        "{allowed:?}"
    );
    let json = scratch.dolmen("study p.toml -o out --json").stdout;
    assert!(json.contains("\"allowed drift\""), "{json}");
    assert!(answer.words().contains("allowed drift 2 %"), "{}", answer.stdout);
}

#[test]
fn holds_a_list_ranks_a_building_whose_study_has_the_curve_of_its_allowable_drift() {
    let scratch = Scratch::new("allowed-drift-ranked");
    let study = "artificial = { count = 3, duration_s = 6, strong_s = 2, rise_s = 1 }\npeak = [\"0.2 g\", \"2 g\"]\nrefine = 0";
    let limits = "[limits]\nstorey_drift = \"0.5 %\"\nsource = \"test\"\n";
    fs::create_dir_all(scratch.path().join("hall")).unwrap();
    let text = format!("{BUILDING}{SITE}{limits}[study.s]\n{study}\n");
    fs::write(scratch.path().join("hall/project.toml"), text).unwrap();
    let studied = scratch.dolmen("study hall");
    assert_eq!(studied.status, 0, "{}{}", studied.stdout, studied.stderr);
    let ranked = scratch.dolmen("rank .");
    assert_eq!(ranked.status, 0, "{}{}", ranked.stdout, ranked.stderr);
    assert!(ranked.stdout.contains("hall"), "{}", ranked.stdout);
}
