// SOURCE     Small stacks, a pole and a frame under El Centro 1940, twice.
// GOAL       A second motion acts on the structure as the first left it: both runs equal one run of a record joined by hand. Every scan, table
//            and headline of a study after a motion says that it does not describe the present structure.
// TOLERANCE  1e-9 of the largest value: the same equations on the same samples; bytes if nothing differs.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const MOTIONS: &str = r#"
[motion.main]
built_in = "el-centro-1940-ns"
peak = "0.5 g"
keep_first_s = 12
taper_s = 1

[motion.aftershock]
built_in = "el-centro-1940-ns"
scale = -1.3
keep_first_s = 8
taper_s = 1
"#;

const STACK: &str = r#"
schema = 1
kind = "stack"
name = "Three blocks"
density = 2600
joint = { friction = 0.25, normal_stiffness = "1e9 Pa/m", shear_stiffness = "4e8 Pa/m", damping_ratio = 0.3 }
blocks = [
  { name = "one", width = 0.3, depth = 0.2, height = 0.1 },
  { name = "two", width = 0.3, depth = 0.2, height = 0.1 },
  { name = "three", width = 0.3, depth = 0.2, height = 0.1 },
]
"#;

const POLE: &str = r#"
schema = 1
kind = "chain"
name = "Pole"
links = [{ name = "pole", length = 5.0, centroid = 2.5, weight = "20 kN", bed_width = 0.6 }]
damping_ratio = 0.05
joints = [{ stiffness = "900 kN*m/rad", friction_moment = "1 kN*m" }]
"#;

const FRAME: &str = r#"
schema = 1
kind = "frame"
name = "Gate"
storeys = [{ name = "columns", height = 3.0, weight = "50 kN" }, { name = "roof", height = 1.5, weight = "120 kN" }]
[direction.x]
stiffness = ["2 MN/m", "4 MN/m"]
damping_ratio = 0.05
friction = { force = ["15 kN", "40 kN"] }
"#;

fn with(name: &str, text: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text.to_owned() + MOTIONS).unwrap();
    scratch
}

fn json(scratch: &Scratch, command: &str) -> Value {
    let done = scratch.dolmen(command);
    assert!(done.status <= 1, "{command}: {}{}", done.stdout, done.stderr);
    serde_json::from_str(&done.stdout).unwrap()
}

/// The acceleration samples of a motion, as `dolmen motion` writes them.
fn samples(scratch: &Scratch, name: &str) -> Vec<f64> {
    let file = format!("{name}-as-it-acts.csv");
    let flags = match name {
        "main" => "--keep-first 12 --taper 1 --peak 0.5g",
        _ => "--keep-first 8 --taper 1 --turn 180 --scale 1.3",
    };
    let done = scratch.dolmen(&format!(
        "motion --motion el-centro-1940-ns {flags} --convert {file}"
    ));
    assert_eq!(done.status, 0, "{}", done.stderr);
    let text = fs::read_to_string(scratch.path().join(file)).unwrap();
    let numbers = text.lines().filter_map(|line| {
        let cells: Vec<f64> = line
            .split(',')
            .filter_map(|cell| cell.trim().parse().ok())
            .collect();
        (cells.len() == 2).then(|| cells[1])
    });
    numbers.collect()
}

/// Writes a file of both motions with a still interval between them.
fn by_hand(scratch: &Scratch, still_s: f64) {
    let (main, aftershock) = (samples(scratch, "main"), samples(scratch, "aftershock"));
    let still = (still_s / 0.02).round() as usize;
    let all: Vec<f64> = main
        .into_iter()
        .chain(std::iter::repeat_n(0.0, still - 1))
        .chain(aftershock)
        .collect();
    let lines = all
        .iter()
        .enumerate()
        .map(|(i, a)| format!("{},{a:.17e}\n", i as f64 * 0.02));
    let text = "time_s,acceleration_m_s2\n".to_owned() + &lines.collect::<String>();
    fs::write(scratch.path().join("both.csv"), text).unwrap();
}

fn numbers(csv: &str) -> Vec<Vec<f64>> {
    let rows = csv.lines().skip(1);
    rows.map(|line| line.split(',').filter_map(|cell| cell.parse().ok()).collect())
        .collect()
}

/// Largest difference of two tables, relative to the largest number, over the rows of the shorter.
fn difference(one: &str, other: &str) -> f64 {
    let (one, other) = (numbers(one), numbers(other));
    assert!(
        one.len() > 100 && other.len() > 100,
        "{} {}",
        one.len(),
        other.len()
    );
    let columns = one[0].len();
    let mut worst = 0.0_f64;
    for column in 1..columns {
        let largest = one.iter().map(|row| row[column].abs()).fold(1e-6, f64::max);
        for (a, b) in one.iter().zip(&other) {
            worst = worst.max((a[column] - b[column]).abs() / largest);
        }
    }
    worst
}

fn history(scratch: &Scratch, folder: &str, file: &str) -> String {
    let path = scratch.path().join(folder);
    let found = [path.join(file), path.join("x").join(file)];
    let found = found.iter().find(|path| path.exists());
    fs::read_to_string(found.unwrap_or_else(|| panic!("no {file} in {folder}"))).unwrap()
}

/// Compares the sequence with the first motion alone, and with a record joined by hand.
fn sequence(name: &str, text: &str, flags: &str, file: &str) -> Value {
    let scratch = with(name, text);
    let both = json(
        &scratch,
        &format!("simulate . --motion main --then aftershock{flags} --json -o both"),
    );
    let after = &both["after"];
    assert_eq!(after["began_at_rest"], true, "{after}");
    let still_s = after["still_s"].as_f64().unwrap();
    assert!(after["speed_at_rest_m_s"].as_f64().unwrap() <= 1e-3);
    by_hand(&scratch, still_s);
    json(
        &scratch,
        &format!("simulate . --motion-file both.csv{flags} --json -o hand"),
    );
    json(
        &scratch,
        &format!("simulate . --motion main{flags} --json -o alone"),
    );
    let [sequence, hand, alone] = ["both", "hand", "alone"].map(|folder| history(&scratch, folder, file));
    let apart = difference(&sequence, &hand);
    assert!(apart < 1e-9, "{name} by hand: {apart:e}");
    // they agree until the first alone ends
    let apart = difference(&sequence, &alone);
    assert!(apart < 1e-9, "{name} alone: {apart:e}");
    both
}

#[test]
fn agrees_a_stack_under_two_motions_with_one_record_put_together_by_hand() {
    let both = sequence("after-stack", STACK, " --law springs --repeats 1", "poses.csv");
    let left = |of: &str| both["after"][of][0]["left"]["residual_slip_m"].as_f64().unwrap();
    assert!(left("after_first") > 1e-3, "{}", left("after_first"));
    assert!((left("after_second") - left("after_first")).abs() > 1e-4);
    let headline = both["judgement"]["headline"].as_str().unwrap();
    assert!(
        headline.contains("Earthquake aftershock after main"),
        "{headline}"
    );
}

#[test]
fn agrees_a_chain_under_two_motions_with_one_record_put_together_by_hand() {
    let both = sequence("after-chain", POLE, "", "histories.csv");
    assert!(
        both["after"]["after_first"][0]["left"]["slipped_rad"]
            .as_f64()
            .unwrap()
            > 0.0,
        "{both}"
    );
}

#[test]
fn agrees_a_frame_under_two_motions_with_one_record_put_together_by_hand() {
    let both = sequence("after-frame", FRAME, "", "histories.csv");
    assert!(
        both["after"]["after_first"][0]["left"]["slipped_way_m"]
            .as_f64()
            .unwrap()
            > 0.0,
        "{both}"
    );
}

#[test]
fn holds_what_fell_is_not_shaken_again() {
    let slender = STACK.replace(
        "width = 0.3, depth = 0.2, height = 0.1",
        "width = 0.05, depth = 0.2, height = 0.4",
    );
    let scratch = with("after-fall", &slender);
    let done = scratch.dolmen("simulate . --motion main --then aftershock --law springs");
    assert_eq!(done.status, 1, "{}", done.stderr);
    assert!(
        done.stdout
            .contains("aftershock did not act: the structure fell in main"),
        "{}",
        done.stdout
    );
    assert!(!done.stdout.contains("aftershock after main"), "{}", done.stdout);
}

#[test]
fn refuses_a_second_motion_without_a_first_and_of_a_building() {
    let scratch = with("after-refused", POLE);
    let said = |command: &str| {
        let done = scratch.dolmen(command);
        assert_eq!(done.status, 2, "{command}: {}", done.stdout);
        done.stderr
    };
    let without = said("simulate . --push 1e-3rad --then aftershock");
    assert!(without.contains("there is no first"), "{without}");
    let long = said("simulate . --motion main --then aftershock --duration 60");
    assert!(long.contains("--duration"), "{long}");
    let korean = said("simulate . --motion main --then aftershock --duration 60 --language ko");
    assert!(
        korean.contains("둘째") || korean.contains("지반운동이 둘"),
        "{korean}"
    );
}

const STUDY: &str = r#"
[site]
code = "KDS 17 10 00"
zone = "I"
return_period_years = 2400
soil = "S2"

[study.left]
after = { motion = "main", peak = ["0 g", "0.3 g", "0.6 g"] }
artificial = { count = 4, duration_s = 6, strong_s = 2, rise_s = 1 }
peak = { from = "0.1 g", to = "1 g", steps = 4 }
refine = 1
expect = [{ input = "after.peak", trend = "falling" }]

[study.intact]
artificial = { count = 4, duration_s = 6, strong_s = 2, rise_s = 1 }
peak = { from = "0.1 g", to = "1 g", steps = 4 }
refine = 1
"#;

#[test]
fn holds_a_study_after_a_motion_is_of_what_that_motion_leaves() {
    let scratch = with("after-study", &format!("{STACK}{STUDY}"));
    let done = scratch.dolmen("study . --study left -o out");
    assert_eq!(done.status, 0, "{}{}", done.stdout, done.stderr);
    assert!(done.stdout.contains("AFTER main"), "{}", done.stdout);
    let study = fs::read_to_string(scratch.path().join("out/left/study.json")).unwrap();
    let study: Value = serde_json::from_str(&study).unwrap();
    let states = study["after"]["states"].as_array().unwrap();
    assert_eq!(states.len(), 3);
    let peaks: Vec<f64> = states
        .iter()
        .map(|of| of["peak_ground_acceleration_m_s2"].as_f64().unwrap())
        .collect();
    for (peak, exact) in peaks.iter().zip([0.0, 0.3 * 9.80665, 0.6 * 9.80665]) {
        assert!((peak - exact).abs() < 1e-9, "{peaks:?}");
    }
    assert!(states[2]["damage_state"].as_u64() >= states[1]["damage_state"].as_u64());
    assert!(states[2]["measures"]["residual_slip_m"].as_f64().unwrap() > 0.0);
    // the hazard of the site applies to the structure as it is now
    assert!(study["hazard"].is_null());
    // without an earlier motion the study is that of the structure as it is now, to the last bit
    let done = scratch.dolmen("study . --study intact -o out");
    assert_eq!(done.status, 0, "{}", done.stderr);
    let rows = |study: &str| super::studies::rows(&scratch.path().join(format!("out/{study}/runs.csv")));
    let (left, intact) = (rows("left"), rows("intact"));
    let unshaken: Vec<_> = left.iter().filter(|row| row["case"] == "1").collect();
    assert!(unshaken.len() == intact.len() && !intact.is_empty());
    for (a, b) in unshaken.iter().zip(&intact) {
        for (name, value) in b {
            assert_eq!(&a[name], value, "{name}");
        }
    }
    // every run after the first motion includes its residual
    let first = states[2]["measures"]["peak_slip_m"].as_f64().unwrap();
    for row in left.iter().filter(|row| row["case"] == "3") {
        assert!(
            row["peak_slip_m"].parse::<f64>().unwrap() >= first - 1e-9,
            "{row:?}"
        );
        assert_eq!(row["after"], "main");
    }
    let nrml = fs::read_dir(scratch.path().join("out/left")).unwrap();
    let named: Vec<String> = nrml
        .map(|of| of.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".xml"))
        .collect();
    for name in named {
        let text = fs::read_to_string(scratch.path().join("out/left").join(&name)).unwrap();
        assert!(text.contains("AFTER main"), "{name}");
    }
}

#[test]
fn holds_a_kept_study_knows_the_motion_before() {
    let scratch = with("after-kept", &format!("{STACK}{STUDY}"));
    let one = "peak = [\"0 g\", \"0.3 g\", \"0.6 g\"]";
    let path = scratch.path().join("project.toml");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(
        &path,
        text.replace(one, "peak = [\"0.3 g\"]")
            .replace("count = 4", "count = 1")
            .replace("expect = [{ input = \"after.peak\", trend = \"falling\" }]\n", ""),
    )
    .unwrap();
    let run = || scratch.dolmen("study . --study left -o out");
    assert_eq!(run().status, 0);
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replace("keep_first_s = 12", "keep_first_s = 11")).unwrap();
    let refused = run();
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    let text = fs::read_to_string(&path).unwrap();
    let changed = text
        .replace("keep_first_s = 11", "keep_first_s = 12")
        .replace("\"0.3 g\"]", "\"0.31 g\"]");
    fs::write(&path, changed).unwrap();
    assert_eq!(run().status, 2);
}
