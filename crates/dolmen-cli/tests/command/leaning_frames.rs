// SOURCE     docs/frame.md: the surveyed lean uses up part of the allowable drift, and of the 10 % at which a storey has fallen.
// GOAL       Samples, studies and runs of a leaning frame include its lean, as `check` and `simulate` do.
// TOLERANCE  none for counts; the 95 % interval of a share of samples contains the closed form

use super::stores::json;
use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const WEIGHT_N: f64 = 65e3 * 9.80665;
const HEIGHT_M: f64 = 4.2;

fn frame(stiffness: &str, tilt: &str, more: &str) -> String {
    format!(
        "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = {{ length = \"m\", force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }}\n\
         storeys = [{{ name = \"low\", mass = 65, height = 4.2 }}]\n[direction.x]\nstiffness = [{stiffness}]\ndamping_ratio = 0.03\n\
         [survey.2026-05-01]\ntilt = {{ x = \"{tilt}\" }}\n{more}"
    )
}

/// The standard normal distribution, by Simpson's rule.
fn normal(z: f64) -> f64 {
    let n = 4000;
    let h = (z + 12.0) / f64::from(n);
    let density = |i: i32| (-0.5 * (-12.0 + f64::from(i) * h).powi(2)).exp();
    let weight = |i: i32| match i {
        0 => 1.0,
        i if i == n => 1.0,
        i if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=n).map(|i| weight(i) * density(i)).sum::<f64>() * h / 3.0 / (2.0 * std::f64::consts::PI).sqrt()
}

fn at<'a>(value: &'a Value, pointer: &str) -> &'a Value {
    value
        .pointer(pointer)
        .unwrap_or_else(|| panic!("{pointer}: {value}"))
}

#[test]
fn agrees_samples_fall_where_their_lean_at_rest_comes_to_a_tenth() {
    let scratch = Scratch::new("leaning-samples");
    let (tilt, mean, cov) = (1.0 / 30.0, 0.30e6, 0.45);
    let text = frame("{ value = 0.30, cov = 0.45 }", "1/30", "");
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let found = json(&scratch, "check . --samples 2000");
    // τ k/(k − N/l) = 0.1
    let falls_below = WEIGHT_N / HEIGHT_M / (1.0 - 10.0 * tilt);
    let sigma = f64::sqrt((cov * cov + 1.0_f64).ln());
    let share = normal(((falls_below / mean).ln() + 0.5 * sigma * sigma) / sigma);
    let upright = normal(((WEIGHT_N / HEIGHT_M / mean).ln() + 0.5 * sigma * sigma) / sigma);
    let of = at(&found, "/state/sampled/unstable");
    let (lower, upper) = (of["lower"].as_f64().unwrap(), of["upper"].as_f64().unwrap());
    assert!(lower < share && share < upper, "{share} {of}");
    assert!(upright < lower, "{upright} {of}");
}

#[test]
fn exact_a_study_counts_samples_that_lean_to_their_fall_as_fallen_by_themselves() {
    let scratch = Scratch::new("leaning-study");
    let more = "[study.s]\nartificial = { count = 2, duration_s = 6, strong_s = 3 }\npeak = [\"0.02 g\", \"0.05 g\"]\nsamples = 8\n";
    fs::write(
        scratch.path().join("project.toml"),
        frame("{ value = 0.1585, cov = 0.005 }", "1/170", more),
    )
    .unwrap();
    let found = json(&scratch, "study .");
    let states = at(&found, "/fragility/0/states").as_array().unwrap().clone();
    let falls = states.last().unwrap();
    assert_eq!(falls["scans_fell_by_themselves"], 16, "{falls}");
}

#[test]
fn agrees_a_study_takes_the_lean_off_the_allowable_drift_as_simulate_does() {
    let scratch = Scratch::new("leaning-limit");
    let more = "[limits]\nstorey_drift = \"1/60\"\nsource = \"assumed\"\n[motion.e]\nbuilt_in = \"el-centro-1940-ns\"\n\
                [study.z]\nmotions = [\"e\"]\npeak = [\"0.02 g\", \"0.14 g\"]\n";
    let allowed = |tilt: &str| {
        fs::write(scratch.path().join("project.toml"), frame("3.0", tilt, more)).unwrap();
        let found = json(&scratch, "study . --restart");
        let moved = json(&scratch, "simulate . --motion e --peak 0.14g");
        (at(&found, "/allowed_drift").clone(), moved)
    };
    for tilt in ["1/100000", "1/90"] {
        let (study, simulated) = allowed(tilt);
        let of_limit = at(&simulated, "/simulations/0/limits/parts/0/demand_over_capacity")
            .as_f64()
            .unwrap();
        let beyond = u64::from(of_limit > 1.0);
        assert_eq!(study["beyond"], beyond, "{tilt}: {study} {of_limit}");
    }
    let (upright, leaning) = (allowed("1/100000").0, allowed("1/90").0);
    assert_eq!((&upright["beyond"], &leaning["beyond"]), (&0.into(), &1.into()));
    assert!(
        (leaning["lean"].as_f64().unwrap() * 90.0 - 1.0).abs() < 1e-9,
        "{leaning}"
    );
}

#[test]
fn holds_a_storey_falls_where_drift_and_lean_come_to_a_tenth() {
    let scratch = Scratch::new("leaning-falls");
    fs::write(scratch.path().join("project.toml"), frame("3.0", "1/30", "")).unwrap();
    let moved = json(&scratch, "simulate . --motion el-centro-1940-ns --peak 3g");
    assert_eq!(
        at(&moved, "/simulations/0/outcome/kind"),
        "drift_limit",
        "{moved}"
    );
    let peak = at(&moved, "/simulations/0/storeys/0/peak_drift_m")
        .as_f64()
        .unwrap()
        .abs();
    // to rounding of the crossing
    assert!((peak / HEIGHT_M - (0.1 - 1.0 / 30.0)).abs() < 1e-9, "{peak}");
    let said = scratch
        .dolmen("simulate . --motion el-centro-1940-ns --peak 3g")
        .stdout;
    assert!(
        said.contains("lean as surveyed came to more than 10 % of its height"),
        "{said}"
    );
}

#[test]
fn refuses_a_motion_along_x_after_one_along_x_and_y() {
    let scratch = Scratch::new("after-other-components");
    let text = "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = { length = \"m\", force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }\n\
                storeys = [{ name = \"low\", mass = 40, height = 4.2 }]\n[direction.x]\nstiffness = [3.0]\ndamping_ratio = 0.03\n\
                [direction.y]\nstiffness = [3.0]\ndamping_ratio = 0.03\n[motion.e]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.2 g\"\nturn = \"35 deg\"\n\
                [study.a]\nafter = { motion = \"e\", peak = [\"0.2 g\"] }\nartificial = { count = 2, duration_s = 6, strong_s = 3 }\n\
                peak = [\"0.1 g\", \"0.2 g\"]\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let done = scratch.dolmen("study .");
    assert_eq!(done.status, 2, "{}", done.stdout);
    assert!(done.stderr.contains("components"), "{}", done.stderr);
}

#[test]
fn exact_a_lean_across_leaves_more_of_the_drift_than_one_along() {
    let scratch = Scratch::new("leaning-across");
    // the lean along y at rest is 1/100 × λ/(λ − 1), λ = k h/W
    let gate = |tilt: &str| {
        format!(
            "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = {{ mass = \"t\", stiffness = \"kN/mm\" }}\n\
             storeys = [{{ mass = 14.5, height = 3.9 }}]\ndirection.x.stiffness = [1.08]\ndirection.y.stiffness = [0.6676]\n\
             site = {{ code = \"KDS 17 10 00\", zone = \"I\", return_period_years = 1000, soil = \"S3\" }}\n\
             limits = {{ storey_drift = \"1/50\" }}\n[survey.2026-05-02]\ntilt = {tilt}\n"
        )
    };
    let capacities = |tilt: &str| {
        fs::write(scratch.path().join("project.toml"), gate(tilt)).unwrap();
        let found = json(&scratch, "check .");
        [0, 1].map(|part| {
            at(&found, &format!("/state/demand/limits/parts/{part}/capacity"))
                .as_f64()
                .unwrap()
        })
    };
    let lambda = 0.6676e6 * 3.9 / (14.5e3 * 9.80665);
    let lean = 0.01 * lambda / (lambda - 1.0);
    let [x, y] = capacities("{ y = \"1/100\" }");
    assert!((x / (4e-4_f64 - lean * lean).sqrt() - 1.0).abs() < 1e-9, "{x}");
    assert!((y / (0.02 - lean) - 1.0).abs() < 1e-9, "{y}");
    // the sign is unknown: it counts along both
    let [x, y] = capacities("{ overall = \"1/100\" }");
    assert!((y / (0.02 - lean) - 1.0).abs() < 1e-9, "{y}");
    let stiffer = 1.08 / 0.6676 * lambda;
    assert!(
        (x / (0.02 - 0.01 * stiffer / (stiffer - 1.0)) - 1.0).abs() < 1e-9,
        "{x}"
    );
}
