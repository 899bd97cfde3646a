// SOURCE     Statics of a gate of two storeys by hand; the shipped gate on free columns in a storm.
// GOAL       The headline includes wind and static loads of frames; every verb counts them or says that it does not; columns without ties are
//            the same structure everywhere.
// TOLERANCE  1e-9: the numbers follow from the input in closed form.

use super::verbs::Scratch;
use serde_json::Value;
use std::f64::consts::{PI, TAU};
use std::fs;

const GATE: &str = r#"schema = 1
kind = "frame"
name = "Gate"
units = { mass = "t", force = "kN", stiffness = "kN/mm" }
storeys = [{ name = "hall", mass = 60, height = 5 }, { name = "loft", mass = 40, height = 4 }]
direction.x = { stiffness = [8, 5], damping_ratio = 0.02 }
"#;
const WIND: &str = "wind = { pressure = \"0.6 kPa\", means = \"gust\", force_coefficient = 1.3, areas = [{ part = \"hall\", area = 20 }, { part = \"loft\", area = 10 }, { part = \"loft\", area = 30, height = 10.5, force_coefficient = 1.0 }] }\n";

fn written(scratch: &Scratch, text: &str) {
    fs::write(scratch.path().join("gate.toml"), text).unwrap();
}

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr))
}

fn storeys(whole: &Value, combination: usize) -> &Vec<Value> {
    let of = &whole["state"]["loads"]["combinations"][combination];
    of["directions"][0]["storeys"]
        .as_array()
        .unwrap_or_else(|| panic!("{of}"))
}

fn near(value: &Value, wanted: f64) {
    let value = value.as_f64().unwrap_or_else(|| panic!("{value}"));
    assert!((value / wanted - 1.0).abs() < 1e-9, "{value} {wanted}");
}

#[test]
fn exact_a_gate_of_two_storeys_in_a_gust() {
    let scratch = Scratch::new("frame_gust");
    written(&scratch, &format!("{GATE}{WIND}"));
    let whole = json(&scratch, "check gate.toml");
    let q = 600.0;
    // half the force on the columns of a storey acts at its top, half at the level below; the roof's force acts at the top
    let [low, high] = [q * 1.3 * 20.0, q * 1.3 * 10.0];
    let roof = q * 30.0;
    let shears = [low / 2.0 + high + roof, high / 2.0 + roof];
    let g: f64 = 9.80665;
    let kappas = [8e6 - 100e3 * g / 5.0, 5e6 - 40e3 * g / 4.0];
    for ((storey, (shear, kappa)), height) in storeys(&whole, 0)
        .iter()
        .zip(shears.into_iter().zip(kappas))
        .zip([5.0, 4.0])
    {
        near(&storey["under"]["shear_n"], shear);
        near(&storey["under"]["drift_m"], shear / kappa);
        near(&storey["under"]["factor"], 0.1 * height * kappa / shear);
    }
    let least = (0.5 * kappas[0] / shears[0]).min(0.4 * kappas[1] / shears[1]);
    near(&whole["state"]["loads"]["load_factor"], least);
    assert_eq!(whole["state"]["verdict"], "stable");
    assert_eq!(
        whole["judgement"]["versions"][0]["wind"]["word"], "not asked",
        "{}",
        whole["judgement"]
    );
}

#[test]
fn holds_a_storm_that_a_gate_does_not_bear_is_in_the_headline() {
    let scratch = Scratch::new("frame_storm");
    let soft = GATE.replace("[8, 5]", "[0.4, 0.3]");
    written(&scratch, &format!("{soft}{WIND}"));
    let calm = scratch.dolmen("check gate.toml");
    assert_eq!(calm.status, 0, "{}{}", calm.stdout, calm.stderr);
    // a side load of a hundred kilonewtons, in a direction that the wind adds to
    let pulled = format!("{soft}{WIND}loads = [{{ name = \"cable\", at = \"loft\", force = -100 }}]\n");
    written(&scratch, &pulled);
    let storm = scratch.dolmen("check gate.toml");
    assert_eq!(storm.status, 1, "{}", storm.stdout);
    assert!(
        storm.words().contains("unstable under wind and static loads"),
        "{}",
        storm.stdout
    );
    assert!(
        storm.words().contains("does not bear it in direction x"),
        "{}",
        storm.stdout
    );
    let korean = scratch.dolmen("check gate.toml --language ko");
    assert!(korean.words().contains("견디지 못한다"), "{}", korean.stdout);
    // the worse of the two wind directions
    let whole = json(&scratch, "check gate.toml");
    let shear = storeys(&whole, 0)[1]["under"]["shear_n"].as_f64().unwrap();
    let wind = 600.0 * (1.3 * 5.0 + 30.0);
    assert!((shear / (-100e3 - wind) - 1.0).abs() < 1e-9, "{shear}");
    assert_eq!(storeys(&whole, 0)[1]["wind_reversed"], true);
    // a combination without wind
    written(&scratch, &format!("{pulled}[combination.calm]\nloads = 0.1\n"));
    let calm = scratch.dolmen("check gate.toml");
    assert_eq!(calm.status, 0, "{}", calm.stdout);
    assert!(
        calm.words().contains("no combination has a factor on it"),
        "{}",
        calm.stdout
    );
}

#[test]
fn holds_drifts_in_wind_are_held_against_the_limit_of_the_file() {
    let scratch = Scratch::new("frame_drift_limit");
    let with = |limits: &str, more: &str| written(&scratch, &format!("{GATE}{WIND}{more}{limits}"));
    with("[limits]\nstorey_drift = \"0.05 %\"\n", "");
    let beyond = scratch.dolmen("check gate.toml");
    assert!(beyond.words().contains("beyond its limits"), "{}", beyond.stdout);
    assert!(
        beyond
            .words()
            .contains("of its height in direction x, and 0.0500 % is allowed"),
        "{}",
        beyond.stdout
    );
    assert_eq!(beyond.status, 1, "{}", beyond.stdout);
    with("[limits]\nstorey_drift = \"0.5 %\"\n", "");
    let within = scratch.dolmen("check gate.toml");
    assert!(within.words().contains("within its limits"), "{}", within.stdout);
    assert_eq!(within.status, 0, "{}", within.stdout);
    // a surveyed lean reduces the margin
    let lean = "[survey.2025-04-02]\ntilt.x = \"1/250\"\n";
    with("[limits]\nstorey_drift = \"0.5 %\"\n", lean);
    let leaning = scratch.dolmen("check gate.toml");
    assert!(
        leaning.words().contains("beyond its limits"),
        "{}",
        leaning.stdout
    );
    // gust response of a soft frame is not covered
    let soft = GATE.replace("[8, 5]", "[0.9, 0.8]");
    written(
        &scratch,
        &format!("{soft}{WIND}[limits]\nstorey_drift = \"5 %\"\n"),
    );
    let swings = scratch.dolmen("check gate.toml");
    assert!(!swings.words().contains("within its limits"), "{}", swings.stdout);
    // a limit of a code is for earthquakes
    with(
        "[limits]\ncode = \"KDS 41 17 00\"\nimportance = \"special\"\n",
        "",
    );
    let code = scratch.dolmen("check gate.toml");
    assert!(!code.words().contains("its limits"), "{}", code.stdout);
}

#[test]
fn holds_every_verb_counts_what_hangs_on_a_frame_or_says_that_it_does_not() {
    let scratch = Scratch::new("frame_hangs");
    let snow = "loads = [{ name = \"snow\", at = \"loft\", weight = 100 }, { name = \"cable\", at = \"loft\", force = 5 }]\n";
    let survey = "[survey.2025-04-02]\nmodes.x = [{ frequency = 1.5 }]\n";
    written(&scratch, &format!("{GATE}{snow}{survey}"));
    let whole = json(&scratch, "check gate.toml");
    let g: f64 = 9.80665;
    let factors = [8e6 * 5.0 / (100e3 * g + 100e3), 5e6 * 4.0 / (40e3 * g + 100e3)];
    let least = factors[0].min(factors[1]);
    let direction = &whole["state"]["check"]["frame"][0]["check"];
    near(&direction["stability"]["load_factor"], least);
    // modes of the two masses
    let [m1, m2] = [60e3, 40e3 + 100e3 / g];
    let [c1, c2] = [8e6 - (100e3 * g + 100e3) / 5.0, 5e6 - (40e3 * g + 100e3) / 4.0];
    let (sum, product) = (c1 / m1 + c2 / m1 + c2 / m2, c1 * c2 / (m1 * m2));
    let lowest = 2.0 * product / (sum + (sum * sum - 4.0 * product).sqrt());
    near(&direction["modes"][0]["frequency_hz"], lowest.sqrt() / TAU);
    let check = scratch.dolmen("check gate.toml");
    assert!(
        check.words().contains("hold what the static loads weigh, 100 kN"),
        "{}",
        check.stdout
    );
    let run = scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 0.1g");
    assert!(
        run.words()
            .contains("carries the weight of its static loads, 100 kN"),
        "{}",
        run.stdout
    );
    assert!(run.words().contains("do not act in this run"), "{}", run.stdout);
    let found = scratch.dolmen("identify gate.toml");
    assert!(
        found
            .words()
            .contains("100 kN of static loads, was taken to hang there"),
        "{}",
        found.stdout
    );
    let sensors = scratch.dolmen("sensors gate.toml");
    assert_eq!(sensors.status, 0, "{}{}", sensors.stdout, sensors.stderr);
    written(
        &scratch,
        &format!("{GATE}{snow}{WIND}[study.a]\nmotions = [\"el-centro-1940-ns\"]\npeak = [\"0.1 g\"]\n"),
    );
    let study = scratch.dolmen("study gate.toml --output out");
    assert!(
        study.words().contains("moves with it, with its mass"),
        "{}",
        study.stdout
    );
    assert!(
        study.words().contains("the wind of the file does not act"),
        "{}",
        study.stdout
    );
    assert!(
        study
            .words()
            .contains("forces and moments of static loads do not act"),
        "{}",
        study.stdout
    );
    let report = scratch.dolmen("report gate.toml --output report.html");
    assert_eq!(report.status, 0, "{}{}", report.stdout, report.stderr);
    let page = fs::read_to_string(scratch.path().join("report.html")).unwrap();
    assert!(page.contains("Resistance of a storey against drift"));
}

#[test]
fn holds_static_forces_take_their_part_of_the_allowable_drift() {
    let scratch = Scratch::new("frame_static");
    let limits = "[limits]\nstorey_drift = \"2 %\"\n";
    let run = |loads: &str| {
        written(&scratch, &format!("{GATE}{loads}{limits}"));
        let found = json(
            &scratch,
            "simulate gate.toml --motion el-centro-1940-ns --peak 0.1g",
        );
        found["simulations"][0]["limits"]["parts"][0].clone()
    };
    let free = run("");
    let pulled = run("loads = [{ name = \"cable\", at = \"hall\", force = 100 }]\n");
    let taken = 100e3 / (8e6 - 100e3 * 9.80665 / 5.0) / 5.0;
    assert_eq!(free["demand"], pulled["demand"], "{free} {pulled}");
    let capacity = |of: &Value| of["capacity"].as_f64().unwrap_or_else(|| panic!("{of}"));
    assert!(
        (capacity(&free) - capacity(&pulled) - taken).abs() < 1e-12,
        "{free} {pulled}"
    );
}

#[test]
fn holds_columns_without_ties_are_one_structure_everywhere() {
    let scratch = Scratch::with_examples("frame_no_ties");
    let path = "examples/free_columns/wind.toml";
    let whole = json(&scratch, &format!("check {path}"));
    let variant = &whole["variants"][0]["state"];
    let direction = &variant["check"]["frame"][0];
    let beds = 2.0 * 4.0 * 4e8 * PI * 0.5_f64.powi(4) / 64.0 / 16.0;
    let weight = 32e3 * 9.80665 + 40e3;
    near(
        &direction["check"]["stability"]["load_factor"],
        beds * 4.0 / weight,
    );
    let hertz = ((beds - weight / 4.0) / (weight / 9.80665)).sqrt() / TAU;
    near(&direction["check"]["modes"][0]["frequency_hz"], hertz);
    assert_eq!(direction["columns"][0]["springs_n_m"], 0.0);
    // the storm exceeds the resistance
    assert_eq!(variant["verdict"], "unstable", "{}", variant["loads"]);
    let alone = scratch.dolmen(&format!(
        "simulate {path} --variant no_ties --motion el-centro-1940-ns --peak 0.02g"
    ));
    assert!(
        alone.words().contains("no foot lifts off"),
        "{}{}",
        alone.stdout,
        alone.stderr
    );
    let run = json(
        &scratch,
        &format!("simulate {path} --variant no_ties --motion el-centro-1940-ns --peak 0.5g"),
    );
    // beyond the drift of maximum force the springs are not defined: the storey has fallen
    assert_eq!(
        run["simulations"][0]["outcome"]["kind"], "drift_limit",
        "{}",
        run["simulations"][0]["outcome"]
    );
    let text = fs::read_to_string(scratch.path().join(path)).unwrap();
    let surveyed = text
        .replace("stiffness = [0.887]", "stiffness = [0]")
        .replace("direction.x.stiffness = [0]", "direction.x.stiffness = [0.9]")
        + "[survey.2025-04-02]\nmodes.x = [{ frequency = 0.7 }]\n";
    fs::write(scratch.path().join("alone.toml"), surveyed).unwrap();
    let found = scratch.dolmen("identify alone.toml");
    assert!(
        found
            .words()
            .contains("nothing but the beds of its columns holds it"),
        "{}",
        found.stdout
    );
}
