// SOURCE     EN 1998-1:2004, 4.3.2 and 4.3.3.5.1; KDS 41 17 00: S_D1 = 2/3 · 0.22 g · 1.58. A floor of 20 × 8 m by the closed form of two coupled
//            modes (dolmen::known::displaced_centre).
// GOAL       A building is judged by these codes with their accidental torsion, 5 % of the side across the shaking; where it is left out or
//            cannot be included, the answer says so and no sufficient capacity is green by it.
// TOLERANCE  drifts: 1e-9 of the closed form; words and exit statuses exactly.

use super::verbs::{Answer, Scratch};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::known::displaced_centre::DisplacedFloor;
use serde_json::Value;
use std::fs;

const FLOOR: &str = r#"schema = 1
kind = "building"
name = "Core building"
units = { mass = "t", stiffness = "kN/mm" }
floors = [ { name = "f1", mass = 60, sides = [20, 8], height = 4.2, walls = [
    { x = 0, y = -3, stiffness_x = 3 }, { x = 0, y = 3, stiffness_x = 3 },
    { x = -3, y = 0, stiffness_y = 2 }, { x = 3, y = 0, stiffness_y = 2 } ] } ]
damping.ratio = 0.05
"#;
const LIMITS: &str = "[limits]\ncode = \"KDS 41 17 00\"\nimportance = \"I\"\n";
const KDS_41: &str = "[site]\ncode = \"KDS 41 17 00\"\nzone = \"I\"\nsoil = \"S3\"\n";
const KDS_17: &str =
    "[site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 2400\nsoil = \"S3\"\n";

fn run(scratch: &Scratch, words: &str, text: &str) -> Answer {
    fs::write(scratch.path().join("p.toml"), text).unwrap();
    scratch.dolmen(words)
}

fn json(scratch: &Scratch, text: &str) -> Value {
    let answer = run(scratch, "check p.toml --json", text);
    serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr))
}

/// The same floor by hand: all periods are on the 1/T branch of the spectrum.
fn by_hand() -> DisplacedFloor {
    DisplacedFloor {
        mass_kg: 60e3,
        gyration_m: ((400.0_f64 + 64.0) / 12.0).sqrt(),
        stiffness: [6e6, 4e6, 9.0 * 6e6 + 9.0 * 4e6],
        weight_over_height_n_m: 60e3 * STANDARD_GRAVITY_M_S2 / 4.2,
        damping_ratio: 0.05,
        acceleration_times_period_m_s: 2.0 / 3.0 * 0.22 * 1.58 * STANDARD_GRAVITY_M_S2,
    }
}

#[test]
fn exact_the_code_judges_with_its_accidental_torsion() {
    let scratch = Scratch::new("accidental-torsion");
    let text = format!("{FLOOR}{LIMITS}{KDS_41}");
    let whole = json(&scratch, &text);
    let parts = &whole["state"]["demand"]["limits"]["parts"];
    let expected = by_hand().edge_drifts_m([1.0, 0.4], [10.0, 4.0]);
    for axis in [0, 1] {
        let demand = parts[axis]["demand"].as_f64().unwrap();
        let by_hand = expected[axis] / 4.2;
        assert!(
            (demand / by_hand - 1.0).abs() < 1e-9,
            "{axis}: {demand} {by_hand}"
        );
    }
    let torsion = &whole["state"]["check"]["building"]["standing"]["accidental_torsion"];
    assert_eq!(
        (&torsion["state"], &torsion["code"]),
        (&"included".into(), &"KDS 41 17 00".into())
    );
    assert_eq!(torsion["cases"].as_array().map(Vec::len), Some(4));
    assert_eq!(torsion["centre_displaced_m"][0], serde_json::json!([1.0, 0.4]));
    let brief = scratch.briefly("check p.toml");
    assert_eq!(brief.status, 1, "{}", brief.stdout);
    for said in [
        "Earthquake KDS 41 17 00: below demand (capacity/demand 0.",
        "the largest elastic drift at an edge is 1.07 % of the storey height",
        "With the accidental torsion of KDS 41 17 00, each centre of mass 5 % of the side",
    ] {
        assert!(brief.words().contains(said), "{said}: {}", brief.stdout);
    }
}

#[test]
fn holds_what_is_left_out_is_said_and_what_is_missing_is_not_green() {
    let scratch = Scratch::new("torsion-left-out");
    let none = format!("accidental_eccentricity = 0\n{FLOOR}{LIMITS}{KDS_41}");
    let answer = run(&scratch, "check p.toml", &none);
    assert_eq!(answer.status, 0, "{}", answer.stdout);
    for said in [
        "above demand (capacity/demand 1.40)",
        "is left out: the file has accidental_eccentricity = 0",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    // without sides the eccentricity is unknown: the drift of the centre of mass decides nothing
    let open = FLOOR.replace("sides = [20, 8]", "centre = [0, 0], gyration = \"6.218 m\"");
    let answer = run(&scratch, "check p.toml", &format!("{open}{LIMITS}{KDS_41}"));
    for said in [
        "not decided (capacity/demand 1.40 without accidental torsion)",
        "a floor has neither sides nor outline",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    // too little stays too little
    let weak = open.replace("stiffness_y = 2", "stiffness_y = 1");
    let answer = run(&scratch, "check p.toml", &format!("{weak}{LIMITS}{KDS_41}"));
    assert!(answer.words().contains("below demand"), "{}", answer.stdout);
    // a centre of mass that would lie beyond its floor
    let edge = FLOOR.replace("sides = [20, 8]", "sides = [20, 8], centre = [9.5, 0]");
    let answer = run(
        &scratch,
        "check p.toml",
        &format!("{edge}{LIMITS}{KDS_41}").replace("stiffness_y = 2", "stiffness_y = 200"),
    );
    assert!(
        answer.words().contains("Accidental torsion is not included"),
        "{}",
        answer.stdout
    );
}

#[test]
fn holds_only_codes_that_require_it_include_it_unless_the_file_asks() {
    let scratch = Scratch::new("torsion-asked");
    let own = "[limits]\nstorey_drift = \"1.5 %\"\n";
    let answer = run(&scratch, "check p.toml", &format!("{FLOOR}{own}{KDS_17}"));
    assert!(
        answer.words().contains("no code that requires it decides here"),
        "{}",
        answer.stdout
    );
    let state = |text: &str| {
        let of = json(&scratch, text);
        let of = &of["state"]["check"]["building"]["standing"]["accidental_torsion"];
        (of["state"].clone(), of["eccentricity"].clone())
    };
    let asked = format!("accidental_eccentricity = \"10 %\"\n{FLOOR}{own}{KDS_17}");
    assert_eq!(state(&asked), ("included".into(), 0.1.into()));
    // the allowable drift of a code on the spectrum of another
    assert_eq!(
        state(&format!("{FLOOR}{LIMITS}{KDS_17}")),
        ("included".into(), 0.05.into())
    );
    for (given, message) in [
        ("5", "must be at most 0.5"),
        ("-0.05", "accidental_eccentricity = -0.05 cannot be"),
    ] {
        let answer = run(
            &scratch,
            "check p.toml",
            &format!("accidental_eccentricity = {given}\n{FLOOR}{KDS_41}"),
        );
        assert_eq!(answer.status, 2, "{given}: {}", answer.stdout);
        assert!(answer.stderr.contains(message), "{given}: {}", answer.stderr);
    }
}

#[test]
fn holds_a_motion_says_that_it_has_no_accidental_torsion() {
    let scratch = Scratch::new("torsion-in-time");
    let mut motion = "t_s,x_m_s2\n".to_owned();
    for i in 0..200 {
        let t = 0.02 * f64::from(i);
        motion.push_str(&format!("{t:.2},{:.6}\n", (6.0 * t).sin()));
    }
    fs::write(scratch.path().join("pulse.csv"), motion).unwrap();
    let said = "the accidental torsion that KDS 41 17 00 requires is not in this run";
    for (limits, is_said) in [(LIMITS, true), ("[limits]\nstorey_drift = \"1.5 %\"\n", false)] {
        let answer = run(
            &scratch,
            "simulate p.toml --motion-file pulse.csv",
            &format!("{FLOOR}{limits}{KDS_41}"),
        );
        assert_eq!(
            answer.words().contains(said),
            is_said,
            "{}{}",
            answer.stdout,
            answer.stderr
        );
    }
}
