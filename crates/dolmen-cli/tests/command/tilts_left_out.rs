// SOURCE     Our own judgement: drift and lean add up at worst, so of an allowable drift d a tilt t leaves (1 − t/d).
// GOAL       A measured tilt that a model or a run lacks makes no earthquake "above demand" that it could take, and direction and share are right.
// TOLERANCE  none: words and exit status.

use super::verbs::{Answer, Scratch};
use std::fs;

fn asked(name: &str, file: &str, words: &str) -> Answer {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("p.toml"), file).unwrap();
    scratch.briefly(words)
}

/// A building of two storeys; its limits and surveys follow.
const HALL: &str = r#"
schema = 1
kind = "building"
name = "hall"
units = { length = "m", mass = "t", stiffness = "kN/mm" }
floors = [
  { name = "f1", mass = 120, sides = [12, 8], height = 4, walls = [
    { name = "w1", x = 0, y = -4, stiffness_x = 60 },
    { name = "w2", x = 0, y = 4, stiffness_x = 20 },
    { name = "w3", x = -6, y = 0, stiffness_y = 50 },
    { name = "w4", x = 6, y = 0, stiffness_y = 30 },
  ] },
]
damping = { ratio = 0.05 }
[site]
code = "KDS 17 10 00"
zone = "I"
return_period_years = 1000
soil = "S3"
[limits]
storey_drift = "1.5 %"
source = "test"
[motion.m]
built_in = "el-centro-1940-ns"
peak = "0.1 g"
"#;

#[test]
fn holds_a_building_that_leans_beyond_its_drift_is_red_and_one_that_may_is_not_decided() {
    for (tilt, status, words) in [
        ("1/50", 1, "Tilt: beyond its limit"),
        ("1/70", 0, "not decided (capacity/demand"),
        ("1/900", 0, "above demand"),
    ] {
        let file = format!("{HALL}[survey.2026-01-01]\ntilt = {{ x = \"{tilt}\" }}\n");
        for verb in ["check p.toml", "simulate p.toml --motion m"] {
            let answer = asked("left-out-hall", &file, verb);
            let text = answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
            assert_eq!(answer.status, status, "{verb}, {tilt}: {text}{}", answer.stderr);
            assert!(text.contains(words), "{verb}, {tilt}: {text}");
            assert_eq!(
                text.contains("above demand"),
                tilt == "1/900",
                "{verb}, {tilt}: {text}"
            );
        }
    }
}

/// A frame of one storey; its directions, limits and surveys follow.
const GATE: &str = r#"
schema = 1
kind = "frame"
name = "gate"
units = { force = "kN", mass = "t", stiffness = "kN/mm" }
storeys = [{ name = "low", mass = 60, height = 4.2 }]
[site]
code = "KDS 17 10 00"
zone = "I"
return_period_years = 1000
soil = "S3"
[limits]
storey_drift = "1/50"
source = "test"
[motion.m]
built_in = "el-centro-1940-ns"
peak = "0.1 g"
[direction.x]
stiffness = [3.0]
damping_ratio = 0.05
"#;

#[test]
fn holds_a_run_without_an_undated_tilt_says_so_in_its_headline() {
    let file = format!("{GATE}[survey.old]\ntilt = {{ x = \"1/60\" }}\n");
    for verb in ["check p.toml", "simulate p.toml --motion m"] {
        let answer = asked("left-out-gate", &file, verb);
        let text = answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains("not in it: tilt x 1/60"), "{verb}: {text}");
        assert!(!text.contains("above demand"), "{verb}: {text}");
    }
}

#[test]
fn holds_the_lean_of_a_frame_is_named_by_its_direction_and_its_size() {
    let file = format!("{GATE}[survey.2026-01-01]\ntilt = {{ y = \"1/30\" }}\n");
    let answer = asked("left-out-size", &file, "check p.toml --full");
    let text = answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("its lean of 3.50 %"), "{text}");
    assert!(
        text.contains("leaning by 1/30.0 in direction x, from survey 2026-01-01"),
        "{text}"
    );
    assert!(!text.contains("measured in direction x"), "{text}");
}

#[test]
fn holds_a_direction_that_the_spectrum_does_not_reach_hides_no_other() {
    let file = format!(
        "{}[direction.y]\nstiffness = [3.0]\ndamping_ratio = 0.5\n",
        GATE.replace("[3.0]", "[0.2]")
    );
    let answer = asked("left-out-damping", &file, "check p.toml");
    let text = answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(answer.status, 1, "{text}");
    assert!(text.contains("below demand"), "{text}");
    assert!(text.contains("Direction y is not compared"), "{text}");
    assert!(!text.contains("?."), "{text}");
}

/// A pole whose survey has no date.
const POLE: &str = r#"
schema = 1
kind = "chain"
name = "pole"
units = { length = "m", force = "kN", stiffness = "kN*m/rad" }
links = [
  { name = "a", weight = 30, length = 3, centroid = 1.4, breadth = 0.6 },
  { name = "b", weight = 10, length = 2, centroid = 0.9, breadth = 0.4 },
]
joints = [{ stiffness = 900, bed_width = 0.6 }, { stiffness = 90, bed_width = 0.4 }]
damping_ratio = 0.02
[motion.m]
built_in = "el-centro-1940-ns"
peak = "0.02 g"
"#;

#[test]
fn holds_a_tilt_without_a_date_that_the_beds_are_checked_for_is_in_the_headline() {
    for survey in ["old", "2026-01-01"] {
        let file = format!("{POLE}[survey.{survey}]\ntilt = {{ x = \"1/12\" }}\n");
        let answer = asked("undated-pole", &file, "check p.toml");
        let text = answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        let said = format!("leaning as surveyed ({survey}: x 1/12)");
        assert!(text.contains(&said), "{said}: {text}");
    }
    // the run of the same file starts plumb, and says so alone
    let file = format!("{POLE}[survey.old]\ntilt = {{ x = \"1/12\" }}\n");
    let answer = asked("undated-pole-run", &file, "simulate p.toml --motion m");
    assert!(
        answer.stdout.contains("not in it: tilt x 1/12"),
        "{}",
        answer.stdout
    );
    assert!(
        !answer.stdout.contains("leaning as surveyed"),
        "{}",
        answer.stdout
    );
}
