// SOURCE     the same lean written on every block: a block's own tilt rotates it about its base, and the next stands on its top.
// GOAL       In check, simulate and study, the tilt of a survey leans a stack as the same lean of its parts does.
// TOLERANCE  1e-9 of the first motion; histories are as sensitive as rocking is, so 1e-6 of their peaks.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const STONES: [(&str, f64, f64); 4] = [
    ("base", 1.2, 0.4),
    ("body", 0.7, 1.3),
    ("roof", 1.1, 0.3),
    ("top", 0.5, 0.6),
];

/// A tower with the lean on each block, or in a survey.
fn project(tilt_on_blocks: bool, more: &str) -> String {
    let lean = if tilt_on_blocks {
        ", tilt = { x = \"1/40\", y = \"-1/60\" }"
    } else {
        ""
    };
    let blocks: String = STONES
        .iter()
        .map(|(name, width, height)| {
            format!("  {{ name = \"{name}\", width = {width}, height = {height}{lean} }},\n")
        })
        .collect();
    let survey = match tilt_on_blocks {
        true => "",
        false => "[survey.2025-09-10]\ntilt = { x = \"1/40\", y = \"-1/60\" }\n",
    };
    format!(
        "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = 2600\n{more}joint = {{ friction = 0.7 }}\nblocks = [\n{blocks}]\n{survey}\
         [study.height]\nvary = {{ \"joint.friction\" = [0.6, 0.8] }}\nmotions = [\"el-centro-1940-ns\"]\nscale = [0.5, 1.5]\n"
    )
}

fn json(scratch: &Scratch, words: &str) -> Value {
    let answer = scratch.dolmen(words);
    serde_json::from_str(&answer.stdout).unwrap_or_else(|error| panic!("{words}: {error}: {}", answer.stderr))
}

#[test]
fn exact_a_surveyed_tilt_is_the_same_lean_on_every_block() {
    let scratch = Scratch::new("surveyed-lean");
    fs::write(scratch.path().join("survey.toml"), project(false, "")).unwrap();
    fs::write(scratch.path().join("blocks.toml"), project(true, "")).unwrap();
    fs::write(
        scratch.path().join("none.toml"),
        project(false, "as_surveyed = \"none\"\n"),
    )
    .unwrap();
    let number = |found: &Value, path: &str| found.pointer(path).and_then(Value::as_f64).unwrap();
    let capacity = |file: &str| {
        let found = json(&scratch, &format!("check {file} --json"));
        number(&found, "/state/check/stack/capacity/acceleration_g")
    };
    let (surveyed, on_blocks, upright) = (
        capacity("survey.toml"),
        capacity("blocks.toml"),
        capacity("none.toml"),
    );
    assert!((surveyed - on_blocks).abs() < 1e-9, "{surveyed} {on_blocks}");
    assert!(upright > surveyed + 0.02, "{upright} {surveyed}");
    let peaks = |file: &str| {
        let found = json(
            &scratch,
            &format!("simulate {file} --motion el-centro-1940-ns --keep-first 3 --json"),
        );
        let joints = found["joints"].as_array().unwrap().clone();
        joints
            .iter()
            .map(|joint| joint["peak_opening_m"].as_f64().unwrap())
            .collect::<Vec<_>>()
    };
    for (a, b) in peaks("survey.toml").iter().zip(peaks("blocks.toml")) {
        assert!((a - b).abs() <= 1e-6 * b.max(1e-3), "{a} {b}");
    }
    let survived = |file: &str| {
        let found = json(
            &scratch,
            &format!("study {file} --study height --json --quiet -o {file}-runs"),
        );
        let levels = found["levels"].as_array().unwrap().clone();
        assert!(!levels.is_empty());
        levels
    };
    assert_eq!(survived("survey.toml"), survived("blocks.toml"));
}

#[test]
fn holds_a_surveyed_tilt_is_said_or_why_it_is_left_out() {
    let scratch = Scratch::new("surveyed-lean-said");
    let said = |more: &str, from: &str, to: &str| {
        let text = project(false, more).replace(from, to);
        fs::write(scratch.path().join("p.toml"), text).unwrap();
        let answer = scratch.dolmen("check p.toml");
        format!("{}{}", answer.words(), answer.stderr)
    };
    let leans = said("", "", "");
    assert!(
        leans.contains("leans as survey 2025-09-10 found it, tilt x 1/40, y -1/60"),
        "{leans}"
    );
    assert!(!said("as_surveyed = \"none\"\n", "", "").contains("found it"));
    let own = said("", "name = \"top\",", "name = \"top\", offset = [\"5 mm\", 0],");
    assert!(
        own.contains("not added to the model: its blocks carry their own"),
        "{own}"
    );
    let steep = said("", "x = \"1/40\"", "x = \"1/11\"");
    assert!(
        steep.contains("leans the stack by 5.3° on level ground") && steep.contains("as_surveyed"),
        "{steep}"
    );
    assert!(said("", "x = \"1/40\"", "x = \"1/12\"").contains("found it, tilt x 1/12"));
    let turned = said("", "x = \"1/40\"", "east = \"1/40\"");
    assert!(
        turned.contains("\"east\" is neither") && turned.contains("must be x or y"),
        "{turned}"
    );
    for date in ["2025.09.10", "20250910", "2025년 9월 10일", "2025. 9. 10. 정기"] {
        let dated = said("", "[survey.2025-09-10]", &format!("[survey.\"{date}\"]"));
        assert!(dated.contains("found it, tilt x 1/40"), "{dated}");
    }
    let unknown = said("as_surveyed = \"2024\"\n", "", "");
    assert!(
        unknown.contains("must be one of \"latest\", \"none\", \"2025-09-10\""),
        "{unknown}"
    );
    // a survey without a date counts only if the file names it
    let undated = said("", "[survey.2025-09-10]", "[survey.before-the-repair]");
    assert!(!undated.contains("found it"), "{undated}");
    assert!(
        undated.contains("is not in this model") && undated.contains("as_surveyed names another"),
        "{undated}"
    );
}

/// A leaning pole of two stones.
fn pole(tilt: &str, more: &str) -> String {
    format!(
        "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = {{ force = \"kN\", stiffness = \"kN*m/rad\" }}\n{more}damping_ratio = 0.05\nlinks = [\n\
         {{ name = \"lower\", weight = 30, length = 3, centroid = 1.4, bed_width = 0.9 }},\n\
         {{ name = \"upper\", weight = 12, length = 2.5, centroid = 1.2, bed_width = 0.7 }},\n]\n\
         joints = [{{ stiffness = 4000 }}, {{ stiffness = 1500 }}]\n[survey.2025-09-10]\ntilt = {tilt}\n\
         [motion.weak]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.01 g\"\n"
    )
}

#[test]
fn holds_a_chain_that_overturns_as_surveyed_falls_in_simulate_too() {
    let scratch = Scratch::new("surveyed-lean-chain");
    let run = |name: &str, tilt: &str, more: &str| {
        fs::write(scratch.path().join(name), pole(tilt, more)).unwrap();
        let check = scratch.dolmen(&format!("check {name}"));
        let run = scratch.dolmen(&format!("simulate {name} --motion weak"));
        (check.status, run.status, run.words())
    };
    let steep = "{ x = \"1/12\", y = \"1/5\" }";
    let (check, simulate, words) = run("steep.toml", steep, "");
    assert_eq!((check, simulate), (1, 1), "{words}");
    assert!(
        words.contains("It leans as survey 2025-09-10 found it, tilt x 1/12, y 1/5"),
        "{words}"
    );
    let (_, simulate, words) = run("none.toml", steep, "as_surveyed = \"none\"\n");
    assert_eq!(simulate, 0, "{words}");
    assert!(words.contains("The run starts plumb"), "{words}");
    let (_, simulate, words) = run("little.toml", "{ x = \"1/200\" }", "");
    assert_eq!(simulate, 0, "{words}");
}

#[test]
fn exact_at_rest_a_leaning_chain_carries_what_the_check_says_its_tilt_adds() {
    // moments of the tilt in check come from linear statics; here from the run's first sample
    let scratch = Scratch::new("surveyed-lean-moment");
    let more = "loads = [{ name = \"sign\", at = \"upper\", force = 0.001 }]\n";
    fs::write(
        scratch.path().join("pole.toml"),
        pole("{ x = \"1/200\", y = \"1/300\" }", more),
    )
    .unwrap();
    let check = json(&scratch, "check pole.toml --json");
    let joints = check
        .pointer("/state/loads/combinations/0/under/joints")
        .unwrap_or_else(|| panic!("{check:#}"));
    let answer = scratch.dolmen("simulate pole.toml --motion weak --keep-first 1 --rotations small -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let rows = super::studies::rows(&scratch.path().join("out/histories.csv"));
    for (i, joint) in joints.as_array().unwrap().iter().enumerate() {
        let tilt = joint["tilt_moment_n_m"].as_f64().unwrap();
        let first: f64 = rows[0][&format!("joint_{}_moment_n_m", i + 1)].parse().unwrap();
        // the check takes the tangent of 0.006 as the angle: 1.2e-5
        assert!((first / tilt - 1.0).abs() < 1.5e-5, "{i}: {first} {tilt}");
    }
}
