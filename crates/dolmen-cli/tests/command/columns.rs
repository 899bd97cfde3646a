// SOURCE     The shipped gate on free columns; the theory of columns that roll on their beds.
// GOAL       The check says what the columns hold, counts their beds once, and changes no verdict; simulations say they leave them out.
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
    // the frequency is that of the stiffness given, columns or not
    let hertz = ((0.887e6 - weight / 4.0) / 32e3).sqrt() / (2.0 * PI);
    let mode = &direction["check"]["modes"][0]["frequency_hz"];
    assert!((mode.as_f64().unwrap() / hertz - 1.0).abs() < 1e-9);
    // and so are small swings on columns and springs together
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
    // beds stiffer than the storey that stands on them
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
