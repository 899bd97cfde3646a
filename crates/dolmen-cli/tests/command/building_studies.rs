// SOURCE     The twisting floor under El Centro 1940 and noise.
// GOAL       A study of a building: each row equals a single run; drift limits become states; a cut journal continues to the same bits.
// TOLERANCE  1e-12 of a single run (its motion is scaled in another order); bytes exactly.

use super::studies::rows;
use super::verbs::Scratch;
use std::fs;

const STUDY: &str = r#"
[study.shaken]
variants = ["damped"]
vary = { "variant.damped.damper.tmd.damping_ratio" = [0.05, 0.1273] }
motions = ["el-centro"]
artificial = { count = 2, duration_s = 10 }
peak = ["0.05 g", "0.1 g", "0.4 g"]
refine = 1
drift_limits = [0.001, 0.003, 0.006, 0.012]
"#;

fn floor(name: &str) -> Scratch {
    let scratch = Scratch::with_examples(name);
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    let tight = text.replace("direction = \"y\"\n", "direction = \"y\"\nstroke = \"0.1 m\"\n");
    let study = STUDY.replace("variant.damped.damper", "damper");
    fs::write(&file, tight + &study).unwrap();
    scratch
}

#[test]
fn agrees_each_row_of_a_building_is_a_single_run() {
    let scratch = floor("study_building");
    let answer = scratch.dolmen("study examples/twisting_floor --study shaken -o out");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    for said in [
        "drift 0.1 %",
        "drifts beyond the last limit",
        "drift limits 0.1, 0.3, 0.6, 1.2 %",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    let stdout = answer.words();
    let all = rows(&scratch.path().join("out/shaken/runs.csv"));
    let number = |row: &std::collections::BTreeMap<String, String>, key: &str| -> f64 {
        row.get(key)
            .unwrap_or_else(|| panic!("no {key}: {row:?}"))
            .parse()
            .unwrap()
    };
    let own: Vec<_> = all
        .iter()
        .filter(|row| row["motion"] == "el-centro" && row["damper_tmd_damping_ratio"] == "0.1273")
        .collect();
    let row = own
        .iter()
        .find(|row| (number(row, "scale") - 1.0).abs() < 1e-9)
        .unwrap();
    let answer =
        scratch.dolmen("--json simulate examples/twisting_floor --variant damped --motion el-centro");
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let peak = |key: &str| json["peaks"][key]["value"].as_f64().unwrap().abs();
    let same = |found: f64, expected: f64| {
        assert!((found - expected).abs() <= 1e-12 * expected, "{found} {expected}")
    };
    same(number(row, "base_shear_y_n"), peak("base_shear_y_n"));
    same(number(row, "base_torque_n_m"), peak("base_torque_n_m"));
    same(
        number(row, "peak_stroke_m"),
        json["peaks"]["strokes_m"][0]["value"].as_f64().unwrap().abs(),
    );
    let drift = json["drift_ratio"].as_f64().unwrap();
    same(number(row, "peak_corner_drift_ratio"), drift);
    assert!(drift > 0.003 && drift < 0.006);
    assert_eq!(number(row, "damage_state"), 2.0);
    // linear: everything is proportional, and beyond the last limit it "fell"
    for other in &own {
        let scale = number(other, "scale");
        assert!((number(other, "peak_corner_drift_ratio") / (scale * drift) - 1.0).abs() < 1e-9);
        let fell = scale * drift >= 0.012;
        assert_eq!(other["outcome"] == "fell", fell, "{other:?}");
    }
    assert!(own.iter().any(|row| row["outcome"] == "fell"));
    // so the limits are known between the steps of the scan
    let scans = rows(&scratch.path().join("out/shaken/capacities.csv"));
    let scan = scans
        .iter()
        .find(|row| row["motion"] == "el-centro" && row["damper_tmd_damping_ratio"] == "0.1273")
        .unwrap();
    let peak_m_s2 = number(row, "peak_ground_acceleration_m_s2");
    for (key, limit) in [
        ("first_ds1_m_s2", 0.001),
        ("first_ds2_m_s2", 0.003),
        ("first_fall_m_s2", 0.012),
    ] {
        let found = number(scan, key);
        assert!(
            (found / (limit / drift * peak_m_s2) - 1.0).abs() < 1e-9,
            "{key}: {found}"
        );
    }
    // the mass has a room of 100 mm: runs beyond it are counted, from the lowest such peak
    let beyond = all
        .iter()
        .filter(|row| number(row, "peak_stroke_m") > 0.1)
        .count();
    let said = format!("In {beyond} of {} runs a damper needs more room", all.len());
    assert!(beyond > 0 && stdout.contains(&said), "{said}: {stdout}");
}

#[test]
fn holds_a_study_that_shakes_along_one_axis_says_so() {
    let scratch = floor("study_building_one_axis");
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    let said = "every motion shakes along one axis, 0 deg from x, and across it nothing is studied";
    let noise = text.replace("motions = [\"el-centro\"]\n", "");
    fs::write(&file, &noise).unwrap();
    let answer = scratch.dolmen("study examples/twisting_floor --study shaken -o out");
    assert!(answer.words().contains(said), "{}", answer.stdout);
    let both = noise.replace(
        "refine = 1\n",
        "refine = 1\ndirections = [\"0 deg\", \"90 deg\"]\n",
    );
    fs::write(&file, both).unwrap();
    let answer = scratch.dolmen("study examples/twisting_floor --study shaken -o both");
    assert!(!answer.words().contains(said), "{}", answer.stdout);
}

#[test]
fn holds_a_cut_journal_of_a_building_goes_on_to_the_same_bits() {
    let scratch = floor("study_building_cut");
    assert_eq!(
        scratch
            .dolmen("study examples/twisting_floor --study shaken -o whole")
            .status,
        0
    );
    assert_eq!(
        scratch
            .dolmen("study examples/twisting_floor --study shaken -o cut")
            .status,
        0
    );
    let (whole, cut) = (
        scratch.path().join("whole/shaken"),
        scratch.path().join("cut/shaken"),
    );
    let journal = cut.join("journal.tsv");
    let text = fs::read_to_string(&journal).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    fs::write(&journal, lines[..lines.len() / 2].join("\n") + "\n").unwrap();
    fs::remove_file(cut.join("runs.csv")).unwrap();
    let answer = scratch.dolmen("study examples/twisting_floor --study shaken -o cut");
    assert!(
        answer.stderr.contains("runs are kept from before"),
        "{}",
        answer.stderr
    );
    assert_eq!(
        fs::read(whole.join("runs.csv")).unwrap(),
        fs::read(cut.join("runs.csv")).unwrap()
    );
}

#[test]
fn refuses_limits_that_are_none_and_keys_of_other_kinds() {
    let scratch = floor("study_building_bad");
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    for (from, to, said) in [
        (
            "[0.001, 0.003, 0.006, 0.012]",
            "[0.1, 0.3, 0.6, 1.2]",
            "must be 4, rising, 0.0001 to 0.1",
        ),
        (
            "[0.001, 0.003, 0.006, 0.012]",
            "[0.001, 0.003]",
            "must be 4, rising",
        ),
        (
            "refine = 1",
            "refine = 1\nrelease = \"10 mm\"",
            "release is for frames, but this file has a building",
        ),
        (
            "refine = 1",
            "refine = 1\nlaw = \"springs\"",
            "law is for stacks, but this file has a building",
        ),
        (
            "refine = 1",
            "refine = 1\npoints = 16",
            "points is for stacks, but this file has a building",
        ),
    ] {
        fs::write(&file, text.replace(from, to)).unwrap();
        let answer = scratch.dolmen("study examples/twisting_floor --study shaken -o out");
        assert_eq!(answer.status, 2, "{said}");
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}
