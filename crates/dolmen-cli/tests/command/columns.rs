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
    let simulated = scratch.dolmen("simulate examples/free_columns --motion el-centro-1940-ns --peak 0.1g");
    assert!(
        simulated.stdout.contains("restoring moment"),
        "{}",
        simulated.stdout
    );
    let korean =
        scratch.dolmen("simulate examples/free_columns --motion el-centro-1940-ns --peak 0.1g --language ko");
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
    // compliant beds: not run, and reported
    let beds = scratch.dolmen("simulate examples/free_columns --motion el-centro-1940-ns");
    assert!(beds.words().contains("only on rigid stones"), "{}", beds.stdout);
}
