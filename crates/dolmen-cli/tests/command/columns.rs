// SOURCE     The shipped gate on free columns; the theory of columns that roll on their beds.
// GOAL       The check gives the resistance of the columns, counts their beds once, and changes no verdict; simulations say that they
//            omit the columns.
// TOLERANCE  1e-9: the numbers follow from the input in closed form.

use super::verbs::Scratch;
use std::f64::consts::PI;
use std::fs;

fn json(scratch: &Scratch, command: &str) -> serde_json::Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr))
}

fn changed(scratch: &Scratch, from: &str, to: &str) {
    let path = scratch.path().join("examples/free_columns/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains(from), "{from}");
    fs::write(path, text.replace(from, to)).unwrap();
}

#[test]
fn exact_beds_are_counted_once() {
    let scratch = Scratch::with_examples("columns_once");
    let whole = json(&scratch, "check examples/free_columns");
    let direction = &whole["state"]["check"]["frame"][0];
    let columns = &direction["columns"][0];
    let of = |key: &str| columns[key].as_f64().unwrap();
    let weight = 32e3 * 9.80665;
    let beds = 2.0 * 4.0 * 4e8 * PI * 0.5_f64.powi(4) / 64.0 / 16.0;
    assert!((of("axial_n") / weight - 1.0).abs() < 1e-9);
    assert!((of("bed_stiffness_n_m") / beds - 1.0).abs() < 1e-9);
    assert!((of("springs_n_m") / (0.887e6 - beds) - 1.0).abs() < 1e-9);
    // the frequency is that of the given stiffness, with or without columns
    let hertz = ((0.887e6 - weight / 4.0) / 32e3).sqrt() / (2.0 * PI);
    let mode = &direction["check"]["modes"][0]["frequency_hz"];
    assert!((mode.as_f64().unwrap() / hertz - 1.0).abs() < 1e-9);
    // the same for small oscillations on columns and springs together
    let first = columns["swings"][0]["with_springs_hz"].as_f64().unwrap();
    assert!((first / hertz - 1.0).abs() < 1e-4, "{first} {hertz}");
    let most = columns["standing"]["greatest"]["force_n"].as_f64().unwrap();
    assert!(most > 0.05 * weight && most < 0.125 * weight, "{most}");
    let verdict = whole["state"]["verdict"].clone();
    changed(
        &scratch,
        ", columns = { count = 4, diameter = 0.5, bed_stiffness = \"0.4 GPa/m\" }",
        "",
    );
    assert_eq!(
        json(&scratch, "check examples/free_columns")["state"]["verdict"],
        verdict
    );
}

#[test]
fn holds_columns_that_do_not_stand_alone_are_a_finding() {
    let scratch = Scratch::with_examples("columns_soft");
    let stable = scratch.dolmen("check examples/free_columns");
    assert_eq!(stable.status, 0, "{}", stable.stderr);
    assert!(
        stable.stdout.contains("the columns of storey 1 (4, free"),
        "{}",
        stable.stdout
    );
    changed(&scratch, "0.4 GPa/m", "0.04 GPa/m");
    let soft = scratch.dolmen("check examples/free_columns");
    assert_eq!(soft.status, 0, "{}", soft.stderr);
    assert!(
        soft.stdout.contains("do not stand by their weight"),
        "{}",
        soft.stdout
    );
    let head = |text: &str| {
        text.lines()
            .find(|line| line.starts_with("VERDICT"))
            .map(str::to_owned)
    };
    assert_eq!(head(&soft.stdout), head(&stable.stdout));
    // beds stiffer than the storey above
    changed(&scratch, "0.04 GPa/m", "4 GPa/m");
    let stiff = scratch.dolmen("check examples/free_columns");
    assert!(stiff.stdout.contains("less than the beds"), "{}", stiff.stdout);
}

#[test]
fn holds_simulations_say_that_columns_are_left_out() {
    let scratch = Scratch::with_examples("columns_motion");
    let simulate = "simulate examples/free_columns/rigid_stones.toml --motion el-centro-1940-ns --peak 0.1g";
    let simulated = scratch.dolmen(simulate);
    assert!(
        simulated.stdout.contains("restoring moment"),
        "{}",
        simulated.stdout
    );
    let korean = scratch.dolmen(&format!("{simulate} --language ko"));
    assert!(korean.stdout.contains("복원모멘트"), "{}", korean.stdout);
}

#[test]
fn holds_a_frame_of_one_storey_moves_on_its_columns_alone() {
    let scratch = Scratch::with_examples("columns_alone");
    let simulate = |peak: &str| {
        let command = "simulate examples/free_columns/rigid_stones.toml --motion el-centro-1940-ns";
        json(&scratch, &format!("{command} --peak {peak}"))["simulations"][0].clone()
    };
    // b 0.5 m, h 4 m: feet lift off at g b/h, and not below
    let calm = &simulate("0.12g")["columns_alone"];
    let of = |columns: &serde_json::Value, key: &str| columns[key].as_f64().unwrap();
    assert!((of(calm, "uplift_m_s2") / (9.80665 * 0.125) - 1.0).abs() < 1e-9);
    assert_eq!(calm["outcome"], "stood");
    let rocks = &simulate("0.2g")["columns_alone"];
    assert_eq!(rocks["outcome"], "rocked");
    // massless columns: p̂² = g/2R, r = cos 2α
    let pull = 9.80665 / 4.0_f64.hypot(0.5);
    assert!((of(rocks, "frequency_parameter_rad_s").powi(2) / pull - 1.0).abs() < 1e-9);
    let kept = (4.0_f64.powi(2) - 0.25) / (4.0_f64.powi(2) + 0.25);
    assert!((of(rocks, "velocity_ratio") / kept - 1.0).abs() < 1e-9);
    let peak = of(rocks, "peak_rotation_rad");
    let drift = 4.0 * peak.sin() + 0.5 * (1.0 - peak.cos());
    assert!((of(rocks, "peak_drift_m") / drift - 1.0).abs() < 1e-9);
    let falls = &simulate("3g")["columns_alone"];
    assert_eq!(falls["outcome"], "fell");
    let command = "simulate examples/free_columns/rigid_stones.toml --motion el-centro-1940-ns --peak";
    let said = |end: &str, words: &str| {
        let answer = scratch.dolmen(&format!("{command} {end}"));
        assert!(answer.words().contains(words), "{words}: {}", answer.stdout);
    };
    said(
        "0.12g",
        "on its 4 columns alone, without joints and walls: no foot lifts off",
    );
    said("0.2g", "and rock without falling");
    said("3g", "Joints and walls must hold the frame");
    said("0.2g --language ko", "접합부와 벽체 없이 기둥 4개만으로는");
    let output = scratch.dolmen(&format!("{command} 0.2g --output alone"));
    assert_eq!(output.status, 0, "{}", output.stderr);
    let listed = fs::read_dir(scratch.path().join("alone/x")).unwrap();
    let names: Vec<String> = listed
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .collect();
    assert!(names.iter().any(|name| name.contains("columns")), "{names:?}");
    // the beds are not given: both extremes of what beds and joints share
    said("0.2g", "how beds and joints share the stiffness");
    // given beds share it as they say
    let beds = scratch.dolmen("simulate examples/free_columns --motion el-centro-1940-ns");
    assert!(
        beds.words()
            .contains("its beds have 614 kN/m, as bed_stiffness gives it"),
        "{}",
        beds.stdout
    );
}

/// The gate of the examples without ties, with beds of this stiffness; `more` goes to the end of the file.
fn without_ties(scratch: &Scratch, beds: &str, more: &str) {
    let text = format!(
        r#"schema = 1
kind = "frame"
name = "Gate without ties"
units = {{ mass = "t", stiffness = "kN/mm" }}
storeys = [{{ mass = 32, height = 4, columns = {{ count = 4, diameter = 0.5, bed_stiffness = "{beds}" }} }}]
[direction.x]
stiffness = [0]
damping_ratio = 0.03
{more}"#
    );
    fs::write(scratch.path().join("gate.toml"), text).unwrap();
}

const LIMIT: &str = "[limits]\nstorey_drift = \"2 %\"\n";

#[test]
fn holds_columns_without_ties_follow_their_own_curve_beyond_lift_off() {
    let scratch = Scratch::new("columns_curve");
    let simulate = |peak: &str| {
        let command = format!("simulate gate.toml --motion el-centro-1940-ns --peak {peak}");
        json(&scratch, &command)["simulations"][0].clone()
    };
    let of = |value: &serde_json::Value| value.as_f64().unwrap_or_else(|| panic!("{value}"));
    without_ties(&scratch, "4 GPa/m", LIMIT);
    // below lift-off the springs of the beds give the same
    let calm = simulate("0.01g");
    assert_eq!(calm["columns_alone"]["outcome"], "stood");
    let [springs, curve] =
        [&calm["storeys"][0], &calm["columns_alone"]].map(|run| of(&run["peak_drift_m"]).abs());
    assert!((springs / curve - 1.0).abs() < 2e-3, "{springs} {curve}");
    // beyond it they are too stiff; 31.9 mm against 81 mm, of which the worse decides
    let run = simulate("0.2g");
    let [springs, curve] =
        [&run["storeys"][0], &run["columns_alone"]].map(|run| of(&run["peak_drift_m"]).abs());
    assert_eq!(run["columns_alone"]["outcome"], "rocked", "{run}");
    assert!(curve > 2.0 * springs && curve > 0.07, "{springs} {curve}");
    assert!(
        (of(&run["limits"]["parts"][0]["demand"]) - curve / 4.0).abs() < 1e-9,
        "{}",
        run["limits"]
    );
    let answer = scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 0.2g");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    assert!(
        answer.words().contains("below demand") && answer.words().contains("the larger counts"),
        "{}",
        answer.stdout
    );
    let korean = scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 0.2g --language ko");
    assert!(korean.words().contains("하중-변위 곡선"), "{}", korean.stdout);
    // without an allowable drift nothing is decided
    without_ties(&scratch, "4 GPa/m", "");
    let answer = scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 0.2g");
    assert!(
        answer.words().contains("not decided (no limit is known)"),
        "{}",
        answer.stdout
    );
    // and a fall is a fall
    let answer = scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 1g");
    assert_eq!(answer.status, 1);
    assert!(
        answer.words().contains("the columns have fallen at"),
        "{}",
        answer.stdout
    );
}

#[test]
fn holds_springs_of_beds_decide_nothing_beyond_lift_off() {
    let scratch = Scratch::new("columns_undecided");
    let site = "[site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 2400\nsoil = \"S5\"\n";
    without_ties(&scratch, "40 GPa/m", &format!("{LIMIT}{site}"));
    let checked = scratch.dolmen("check gate.toml");
    let words = checked.words();
    assert!(
        words.contains("not decided (columns without ties lift off"),
        "{}",
        checked.stdout
    );
    assert!(
        words.contains("lift off their stones at a smaller drift than the spectrum asks for"),
        "{}",
        checked.stdout
    );
    assert!(!words.contains("above demand"), "{}", checked.stdout);
    // two storeys are not followed
    let path = scratch.path().join("gate.toml");
    let text = fs::read_to_string(&path).unwrap();
    let storey = "{ mass = 32, height = 4, columns";
    let two = text
        .replace(storey, &format!("{{ mass = 8, height = 3 }}, {storey}"))
        .replace("[0]", "[9, 0]");
    fs::write(&path, two).unwrap();
    let answer = scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 0.2g");
    assert!(
        answer
            .words()
            .contains("not decided (columns without ties lift off"),
        "{}",
        answer.stdout
    );
}

#[test]
fn holds_check_and_simulate_share_the_lean_at_which_columns_have_fallen() {
    let scratch = Scratch::new("columns_lean");
    let leans = |tilt: &str| {
        without_ties(
            &scratch,
            "0.4 GPa/m",
            &format!("[survey.2025-01-01]\ntilt = {{ x = \"{tilt}\" }}\n"),
        )
    };
    let calm = || scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 0.01g");
    // 1/40 pushes with 2.5 % of the weight, of which the columns hold 5.48 %
    leans("1/40");
    let checked = json(&scratch, "check gate.toml");
    assert_eq!(checked["state"]["verdict"], "stable");
    let stands = calm();
    assert!(
        stands.status == 0 && !stands.words().contains("fallen"),
        "{}",
        stands.stdout
    );
    assert!(
        scratch
            .dolmen("check gate.toml")
            .words()
            .contains("counts as fallen from 1/18.3")
    );
    // 1/17 pushes with 5.9 %
    leans("1/17");
    let checked = json(&scratch, "check gate.toml");
    assert_eq!(checked["state"]["verdict"], "unstable");
    assert_eq!(calm().status, 1, "{}", calm().stdout);
    // beyond the drift of the largest force the springs say so
    without_ties(&scratch, "0.4 GPa/m", "");
    let falls = scratch.dolmen("simulate gate.toml --motion el-centro-1940-ns --peak 0.5g");
    let words = falls.words();
    assert!(
        words.contains("where its columns resist most") && !words.contains("more than 10 %"),
        "{}",
        falls.stdout
    );
}

#[test]
fn holds_a_study_counts_the_worse_of_springs_and_columns() {
    let scratch = Scratch::new("columns_study");
    without_ties(
        &scratch,
        "4 GPa/m",
        "[study.s]\nmotions = [\"el-centro-1940-ns\"]\npeak = [\"0.2 g\"]\n",
    );
    let answer = scratch.dolmen("study gate.toml --study s --output out");
    assert!(answer.status < 2, "{}{}", answer.stdout, answer.stderr);
    let rows = fs::read_to_string(scratch.path().join("out/s/runs.csv")).unwrap();
    let mut lines = rows.lines();
    let place = lines
        .next()
        .unwrap()
        .split(',')
        .position(|name| name == "peak_drift_m")
        .unwrap();
    let drift: f64 = lines
        .next()
        .unwrap()
        .split(',')
        .nth(place)
        .unwrap()
        .parse()
        .unwrap();
    assert!(drift > 0.07, "{rows}");
}

#[test]
fn holds_maps_of_columns_without_ties_end_at_lift_off() {
    let scratch = Scratch::new("columns_maps");
    let study = |of: &str| {
        without_ties(&scratch, "0.4 GPa/m", &format!("[study.m]\n{of}\n"));
        let output = if of.contains("harmonic") {
            "out"
        } else {
            "out-release"
        };
        scratch.dolmen(&format!(
            "study gate.toml --study m --output {output} --force --restart"
        ))
    };
    let harmonic = "harmonic = { frequency = [\"0.5 Hz\"], acceleration = [\"0.001 g\", \"0.1 g\"] }";
    let answer = study(harmonic);
    assert!(answer.status < 2, "{}{}", answer.stdout, answer.stderr);
    let points = fs::read_to_string(scratch.path().join("out/m/harmonic.csv")).unwrap();
    let states: Vec<bool> = points
        .lines()
        .skip(1)
        .map(|line| line.contains("beyond the drift limit"))
        .collect();
    assert_eq!(states, [false, true], "{points}");
    let small = study("release = \"10 mm\"");
    assert!(small.status < 2, "{}{}", small.stdout, small.stderr);
    let refused = study("release = \"150 mm\"");
    assert!(
        refused.status > 1 && refused.stderr.contains("smaller displacement"),
        "{}{}",
        refused.stdout,
        refused.stderr
    );
}
