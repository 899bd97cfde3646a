// SOURCE     Statics of a building of three storeys by hand.
// GOAL       From the user's file to the answer: drifts at the worst corner, combinations with wind and earthquake, headline and exit
//            status by the limit of the file, refusals in both languages.
// TOLERANCE  1e-9: drifts follow from the input in closed form, and combinations are sums.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

/// k_θ = 2000 kN·m/mrad about the middle of floors of 12 by 10 m.
const TOWER: &str = r#"schema = 1
kind = "building"
name = "Three storeys"
units = { length = "m", mass = "t", stiffness = "kN/mm", force = "kN" }
p_delta = false
damping = { ratio = 0.05 }
floors = [
  { name = "first", mass = 100, sides = [12, 10], height = 4, stiffness = { x = 60, y = 40, rotation = "2000000 kN*m/rad", centre = [0, 0] } },
  { count = 2, mass = 100, sides = [12, 10], height = 3, stiffness = { x = 50, y = 30, rotation = "2000000 kN*m/rad", centre = [0, 0] } },
]
"#;
const LOADS: &str = r#"loads = [
  { name = "bridge", at = "first", force = [0, 90], position = [5, 0] },
  { name = "crane", at = "3", force = [-60, 0], torque = "-120 kN*m" },
]
"#;

fn written(scratch: &Scratch, text: &str) {
    fs::write(scratch.path().join("tower.toml"), text).unwrap();
}

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr))
}

fn near(value: &Value, wanted: f64) {
    let value = value.as_f64().unwrap_or_else(|| panic!("{value}"));
    assert!(
        (value - wanted).abs() <= 1e-9 * wanted.abs().max(1e-9),
        "{value} {wanted}"
    );
}

#[test]
fn exact_drifts_at_the_worst_corner_by_hand() {
    let scratch = Scratch::new("building_loads");
    written(&scratch, &format!("{TOWER}{LOADS}"));
    let whole = json(&scratch, "check tower.toml");
    let of = &whole["state"]["loads"]["combinations"][0];
    // torque in the first storey 5 · 90 − 120, above −120 kN·m
    let storeys = of["storeys"].as_array().unwrap();
    let [first, second] = [330e3 / 2e9, -120e3 / 2e9];
    near(&storeys[0]["loads_m"][0], 60e3 / 60e6 + 5.0 * first);
    near(&storeys[0]["loads_m"][1], 90e3 / 40e6 + 6.0 * first);
    near(&storeys[1]["loads_m"][0], 60e3 / 50e6 + 5.0 * 120e3 / 2e9);
    near(&storeys[1]["loads_m"][1], 6.0 * 120e3 / 2e9);
    near(&storeys[2]["rotation_rad"], first + 2.0 * second);
    near(&storeys[2]["displacement_m"][0], -1e-3 - 2.0 * 1.2e-3);
    near(&storeys[0]["drift_ratio"][1], (90e3 / 40e6 + 6.0 * first) / 4.0);
    near(
        &of["largest_drift"]["drift_ratio"],
        (90e3 / 40e6 + 6.0 * first) / 4.0,
    );
    assert_eq!(of["largest_drift"]["floor"], "first");
    // without a limit: said so, and not decided
    assert_eq!(whole["judgement"]["versions"][0]["wind"]["word"], "not decided");
    assert_eq!(
        whole["judgement"]["versions"][0]["wind"]["reasons"][0]["moved_by"],
        "loads"
    );
    let said = scratch.dolmen("check tower.toml");
    assert!(said.words().contains("Own weight: stable"), "{}", said.stdout);
    assert!(
        said.words().contains("The file gives no limit for it"),
        "{}",
        said.stdout
    );
}

#[test]
fn holds_a_drift_limit_decides_headline_and_exit_status() {
    let scratch = Scratch::new("building_loads_limit");
    let ratio = (90e3 / 40e6 + 6.0 * 330e3 / 2e9) / 4.0;
    let with = |limit: f64| {
        written(
            &scratch,
            &format!("{TOWER}{LOADS}[limits]\nstorey_drift = {limit}\n"),
        );
        scratch.dolmen("check tower.toml")
    };
    let within = with(1.01 * ratio);
    assert_eq!(within.status, 0, "{}", within.stdout);
    assert!(
        within.words().contains("Static loads: within its limits"),
        "{}",
        within.stdout
    );
    let beyond = with(0.99 * ratio);
    assert_eq!(beyond.status, 1, "{}", beyond.stdout);
    assert!(
        beyond.words().contains("Static loads: beyond its limits"),
        "{}",
        beyond.stdout
    );
    assert!(
        beyond.words().contains("below floor ‘first’ is beyond its limit"),
        "{}",
        beyond.stdout
    );
    let korean = scratch.dolmen("check tower.toml --language ko");
    assert!(
        korean.words().contains("허용값") && korean.words().contains("‘first’ 바닥 아래"),
        "{}",
        korean.stdout
    );
    // the worst of two combinations decides
    let two = format!(
        "{TOWER}{LOADS}[combination.half]\nloads = 0.5\n[combination.double]\nloads = 2.0\n[limits]\nstorey_drift = {}\n",
        1.5 * ratio
    );
    written(&scratch, &two);
    let worst = scratch.dolmen("check tower.toml");
    assert_eq!(worst.status, 1, "{}", worst.stdout);
    assert!(
        worst.words().contains("Combination double: the storey"),
        "{}",
        worst.stdout
    );
}

/// The wind, the site and both combinations; `p_delta` on.
fn moved(weight: &str) -> String {
    let tower = TOWER.replace("p_delta = false", "p_delta = true");
    format!(
        "{tower}{LOADS}wind = {{ speed = 27, means = \"10 min\", code = \"EN 1991-1-4\", terrain = \"II\", force_coefficient = 1.3 }}\n\
         [site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 1000\nsoil = \"S4\"\n\
         [combination.storm]\nweight = {weight}\nwind = 1.5\nloads = 1.0\n[combination.quake]\nloads = 0.5\nearthquake = 1.0\n"
    )
}

#[test]
fn holds_combinations_are_sums_of_loads_wind_and_earthquake() {
    let scratch = Scratch::new("building_combinations");
    written(&scratch, &moved("1"));
    let whole = json(&scratch, "check tower.toml");
    let state = &whole["state"];
    let standing = &state["check"]["building"]["standing"];
    let [storm, quake] = [0, 1].map(|i| &state["loads"]["combinations"][i]["storeys"][2]);
    for (axis, along) in ["along_x", "along_y"].into_iter().enumerate() {
        let peak = &standing["wind"][along]["without_dampers"]["floors"][2]["edge_drift_m"]["peak"];
        near(&storm["wind_m"][axis], 1.5 * peak.as_f64().unwrap());
        let shaken = &standing["spectral"]["edge_drift_m"][2][axis];
        near(&quake["earthquake_m"][axis], shaken.as_f64().unwrap());
        let parts =
            |of: &Value| ["loads_m", "wind_m", "earthquake_m"].map(|part| of[part][axis].as_f64().unwrap());
        for of in [storm, quake] {
            near(&of["drift_ratio"][axis], parts(of).iter().sum::<f64>() / 3.0);
        }
        near(&quake["loads_m"][axis], 0.5 * parts(storm)[0]);
    }
    assert_eq!(
        (&storm["earthquake_m"][0], &quake["wind_m"][0]),
        (&0.0.into(), &0.0.into())
    );
    // a combination with more weight drifts further, by P-delta
    written(&scratch, &moved("2"));
    let heavy = json(&scratch, "check tower.toml");
    let [heavier, before] = [&heavy, &whole].map(|of| &of["state"]["loads"]["combinations"][0]["storeys"][0]);
    for part in ["loads_m", "wind_m"] {
        let [more, less] = [heavier, before].map(|of| of[part][1].as_f64().unwrap());
        assert!(more > 1.005 * less && more < 1.1 * less, "{part}: {more} {less}");
    }
    // a limit of a code holds for the earthquake alone
    written(
        &scratch,
        &format!(
            "{}[limits]\ncode = \"KDS 41 17 00\"\nimportance = \"I\"\n",
            moved("1")
        ),
    );
    let limited = json(&scratch, "check tower.toml");
    let of = &limited["state"]["loads"]["combinations"];
    assert_eq!(
        (&of[0]["drift_limit"], &of[1]["drift_limit"]),
        (&Value::Null, &0.015.into())
    );
}

#[test]
fn refuses_what_a_floor_does_not_take() {
    let scratch = Scratch::new("building_loads_wrong");
    let cases = [
        ("at = \"3\", force = 60", "one number", "두 방향 성분"),
        ("at = \"4\", force = [60, 0]", "\"1\" to \"3\"", "\"1\"~\"3\""),
        (
            "at = \"3\", force = [60, 0], height = 2",
            "a load acts on a floor",
            "하중은 바닥에 작용한다",
        ),
        ("at = \"3\", weight = 20", "belongs to the mass", "mass에 포함"),
        ("at = \"3\", moment = \"20 kN*m\"", "torque = …", "torque = …"),
        ("at = \"3\"", "no force or torque", "force도 torque도 없다"),
        (
            "at = \"3\", force = [60, 0], position = [8, 0]",
            "beside floor 3",
            "벗어나 있다",
        ),
    ];
    for (load, english, korean) in cases {
        written(
            &scratch,
            &format!("{TOWER}loads = [{{ name = \"a\", {load} }}]\n"),
        );
        let refused = scratch.dolmen("check tower.toml");
        assert_eq!(refused.status, 2, "{load}: {}{}", refused.stdout, refused.stderr);
        let said = refused.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains(english), "{load}: {said}");
        let refused = scratch.dolmen("check tower.toml --language ko");
        let said = refused.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains(korean), "{load}: {said}");
    }
    written(
        &scratch,
        &format!("{TOWER}{LOADS}[combination.quake]\nearthquake = 1\n"),
    );
    let refused = scratch.dolmen("check tower.toml");
    assert!(
        refused.stderr.contains("but the file has no site"),
        "{}",
        refused.stderr
    );
}
