// SOURCE     Moments about edges, by hand; the shipped wall and arch.
// GOAL       Wind, static loads and combinations in a file of stones determine its verdict, its first motion and its runs.
// TOLERANCE  1e-6 relative: the tolerance of the conic solver.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

/// A block of 0.5 × 0.5 × 2 m, 2600 kg/m³: W = 12.753 kN, edge moment 3.18825 kN m.
const BLOCK: &str = r#"schema = 1
kind = "stack"
name = "block"
units = { force = "kN" }
gravity = 9.81
density = 2600
joint = { friction = 0.9, normal_stiffness = "1e11 Pa/m", shear_stiffness = "4e10 Pa/m", damping_ratio = 0.3 }
blocks = [{ name = "stone", width = 0.5, height = 2.0 }]
"#;
const EDGE_KN_M: f64 = 2.6 * 9.81 * 0.5 * 0.25;

fn with(scratch: &Scratch, name: &str, lines: &str) -> String {
    let path = format!("{name}.toml");
    fs::write(scratch.path().join(&path), format!("{BLOCK}{lines}\n")).unwrap();
    path
}

fn json(scratch: &Scratch, run: &str) -> Value {
    let answer = scratch.dolmen(&format!("{run} --json"));
    serde_json::from_str(&answer.stdout)
        .unwrap_or_else(|why| panic!("{why}: {} {}", answer.stdout, answer.stderr))
}

fn near(found: f64, exact: f64) {
    assert!((found / exact - 1.0).abs() < 1e-6, "{found} against {exact}");
}

#[test]
fn exact_a_block_in_wind_is_judged_by_the_moment_about_its_edge() {
    let scratch = Scratch::new("stack_wind");
    // q = 0.625 v²: C_f 2.0 on 0.5 × 2 m at 1 m
    for (speed, status, said) in [
        (30.0, 0, "stable"),
        (50.0, 0, "marginal in wind"),
        (60.0, 1, "unstable in wind"),
    ] {
        let wind = format!("wind = {{ speed = {speed}, means = \"gust\", force_coefficient = 2.0 }}");
        let file = with(&scratch, "windy", &wind);
        let answer = scratch.briefly(&format!("check {file}"));
        assert_eq!(answer.status, status, "{}", answer.stdout);
        assert!(answer.words().contains(said), "{speed}: {}", answer.stdout);
        let found = json(&scratch, &format!("check {file}"));
        let of = &found["state"]["loads"]["combinations"][0];
        let exact = EDGE_KN_M * 1e3 / (0.625 * speed * speed * 2.0);
        near(of["load_factor"].as_f64().unwrap(), exact);
        near(of["blown"][0]["area_m2"].as_f64().unwrap(), 1.0);
        assert_eq!(of["grows"], "all");
    }
    let full = scratch.dolmen("check windy.toml");
    for said in ["Wind and static loads", "What the wind meets", "towards +x"] {
        assert!(full.words().contains(said), "{said}: {}", full.stdout);
    }
    let korean = scratch.briefly("check windy.toml --language ko");
    assert!(
        korean.words().contains("석재가 견디지 못한다"),
        "{}",
        korean.stdout
    );
}

#[test]
fn exact_static_loads_take_their_part_of_the_first_motion() {
    let scratch = Scratch::new("stack_static");
    // a force at the top along x of half the edge moment: the first motion along x is at half of b/h
    let push = EDGE_KN_M / 2.0 / 2.0;
    let file = with(
        &scratch,
        "pushed",
        &format!("loads = [{{ name = \"cable\", at = \"stone\", force = [{push}, 0, 0] }}]"),
    );
    let found = json(&scratch, &format!("check {file}"));
    let first = &found["state"]["check"]["stack"]["governing"]["threshold"];
    near(first["acceleration_g"].as_f64().unwrap(), 0.5 * 0.25);
    near(first["direction"][0].as_f64().unwrap(), 1.0);
    near(found["state"]["loads"]["load_factor"].as_f64().unwrap(), 2.0);
    // a load beyond the edge overturns it, and the answer says so
    let over = format!(
        "loads = [{{ name = \"cable\", at = \"stone\", force = [{}, 0, 0] }}]",
        2.1 * push
    );
    let file = with(&scratch, "over", &over);
    let answer = scratch.briefly(&format!("check {file}"));
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    assert!(answer.words().contains("does not stand"), "{}", answer.stdout);
    assert!(
        answer
            .words()
            .contains("VERDICT Weight and loads: unstable under its static loads"),
        "{}",
        answer.stdout
    );
    let run = scratch.dolmen(&format!("simulate {file} --motion el-centro-1940-ns"));
    assert_eq!(run.status, 1, "{} {}", run.stdout, run.stderr);
}

#[test]
fn exact_the_worst_combination_is_judged_and_named() {
    let scratch = Scratch::new("stack_combinations");
    let lines = r#"wind = { pressure = "1 kPa", means = "gust", force_coefficient = 2.0 }
loads = [{ name = "roof", at = "stone", force = [0, 0, -10] }]
[combination.all]
wind = 1.0
loads = 1.0
[combination.storm]
weight = 0.9
wind = 1.5
"#;
    let file = with(&scratch, "combined", lines);
    let found = json(&scratch, &format!("check {file}"));
    let of = |i: usize| &found["state"]["loads"]["combinations"][i];
    // downward loads may be absent in a storm
    near(of(0)["load_factor"].as_f64().unwrap(), EDGE_KN_M / 2.0);
    near(of(1)["load_factor"].as_f64().unwrap(), 0.9 * EDGE_KN_M / 3.0);
    assert_ne!(of(0)["grows"], "all");
    let answer = scratch.briefly(&format!("check {file}"));
    assert_eq!(answer.status, 1);
    assert!(
        answer.words().contains("unstable under combination storm"),
        "{}",
        answer.stdout
    );
    // downward loads have no mass in an earthquake
    assert!(
        scratch
            .dolmen(&format!("check {file}"))
            .words()
            .contains("have no mass in an earthquake")
    );
}

#[test]
fn holds_a_banner_and_given_areas_are_met_where_they_are() {
    let scratch = Scratch::new("stack_areas");
    let wind = |areas: &str| {
        let lines = format!(
            "wind = {{ pressure = \"0.5 kPa\", means = \"gust\", force_coefficient = 2.0, areas = [{areas}] }}"
        );
        let file = with(&scratch, "areas", &lines);
        let found = json(&scratch, &format!("check {file}"));
        found["state"]["loads"]["load_factor"].as_f64().unwrap()
    };
    // 0.4 m² at 1.8 m with C_f 1.2, and 1 m² at 1 m with 2.0
    near(
        wind("{ part = \"stone\", area = 0.4, height = 1.8, force_coefficient = 1.2 }"),
        EDGE_KN_M / (1.0 + 0.5 * 1.2 * 0.4 * 1.8),
    );
    near(wind("{ part = \"stone\", area = 0.6 }"), EDGE_KN_M / 0.6);
}

#[test]
fn holds_static_loads_act_in_time_under_both_laws_and_the_wind_is_said_to_be_left_out() {
    let scratch = Scratch::new("stack_loads_in_time");
    let push = EDGE_KN_M / 2.0 / 2.0;
    let file = with(
        &scratch,
        "pushed",
        &format!(
            "loads = [{{ name = \"cable\", at = \"stone\", force = [{push}, 0, 0] }}]\nwind = {{ speed = 20, means = \"gust\", \
             force_coefficient = 2.0 }}"
        ),
    );
    let still = with(&scratch, "still", "");
    // it lifts at 0.25 g without the cable, at 0.125 g with it
    let mut lines = String::from("a\n");
    for i in 0..200 {
        let a: f64 = -0.18 * 9.81 * (f64::from(i) / 100.0).min(1.0);
        lines.push_str(&format!("{a}\n"));
    }
    fs::write(scratch.path().join("ramp.csv"), lines).unwrap();
    for law in ["springs", "rigid"] {
        let run = |file: &str| {
            scratch.dolmen(&format!(
                "simulate {file} --motion-file ramp.csv --sample-step 0.01 --unit m/s2 --law {law}"
            ))
        };
        let (pushed, alone) = (run(&file), run(&still));
        assert!(
            alone.words().contains("no joint opened"),
            "{law}: {} {}",
            alone.stdout,
            alone.stderr
        );
        assert!(
            !pushed.words().contains("no joint opened"),
            "{law}: {}",
            pushed.stdout
        );
        assert!(
            pushed
                .words()
                .contains("static loads of the file act all the time"),
            "{}",
            pushed.stdout
        );
        assert!(
            pushed.words().contains("does not blow during the motion"),
            "{}",
            pushed.stdout
        );
    }
    let sliding = scratch.dolmen(&format!(
        "simulate {file} --motion-file ramp.csv --sample-step 0.01 --unit m/s2 --law sliding"
    ));
    assert_ne!(sliding.status, 0);
    assert!(
        sliding.stderr.contains("it carries a static load"),
        "{}",
        sliding.stderr
    );
}

#[test]
fn holds_the_shipped_wall_and_arch_say_what_they_bear() {
    let scratch = Scratch::with_examples("stack_loads_examples");
    let wall = scratch.briefly("check examples/wall/wind.toml");
    assert!(
        wall.words().contains("under combination storm"),
        "{}",
        wall.stdout
    );
    assert!(
        wall.words().contains("times the load is borne"),
        "{}",
        wall.stdout
    );
    let found = json(&scratch, "check examples/wall/wind.toml");
    let storm = &found["state"]["loads"]["combinations"][1];
    assert!(storm["wind_to"][0].as_f64().unwrap().abs() < 1e-9, "{storm}");
    let arch = scratch.briefly("check examples/arch/load.toml");
    assert!(arch.words().contains("joints open at"), "{}", arch.stdout);
}
