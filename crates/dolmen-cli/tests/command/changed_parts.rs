// SOURCE     Natural modes of the changed structure from `dolmen check` of another project file, in which one joint or storey has less stiffness.
// GOAL       `compare` names the part that changed, its remaining stiffness, and the parts that cannot be distinguished.
// TOLERANCE  the printed interval, which follows from the stated standard deviation of 0.2 % of the frequencies

use super::stores::json;
use super::verbs::Scratch;
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;

fn pole(joints: [f64; 3], surveys: &str) -> String {
    let [low, middle, top] = joints;
    format!(
        "schema = 1\nkind = \"chain\"\nname = \"pole\"\nevidence = \"measured\"\n\
         units = {{ length = \"m\", force = \"kN\", stiffness = \"kN*m/rad\" }}\n\
         links = [\n{{ name = \"low\", weight = 40, length = 3.5, centroid = 1.7 }},\n\
         {{ name = \"middle\", weight = 18, length = 2.8, centroid = 1.3 }},\n\
         {{ name = \"top\", weight = 8, length = 2.0, centroid = 0.9 }},\n]\n\
         joints = [{{ stiffness = {low} }}, {{ stiffness = {middle} }}, {{ stiffness = {top} }}]\n{surveys}"
    )
}

const GIVEN: [f64; 3] = [3000.0, 900.0, 300.0];

fn frequencies_hz(scratch: &Scratch, joints: [f64; 3]) -> Vec<f64> {
    fs::write(scratch.path().join("project.toml"), pole(joints, "")).unwrap();
    let check = json(scratch, "check .");
    let modes = check
        .pointer("/state/check/chain/modes")
        .and_then(Value::as_array)
        .unwrap();
    modes
        .iter()
        .map(|mode| mode["frequency_hz"].as_f64().unwrap())
        .collect()
}

fn survey(date: &str, frequencies_hz: &[f64]) -> String {
    let mut text = format!("\n[survey.{date}]\ntemperature_c = 15\nfrequencies.x = [");
    for hz in frequencies_hz {
        write!(text, "{{ value = {hz:.6}, cov = 0.002 }}, ").unwrap();
    }
    text + "]\n"
}

#[test]
fn agrees_compare_names_the_joint_that_loosened() {
    let scratch = Scratch::new("changed-part");
    let before = frequencies_hz(&scratch, GIVEN);
    for (at, name) in ["low", "middle", "top"].into_iter().enumerate() {
        let mut joints = GIVEN;
        joints[at] *= 0.75;
        let after = frequencies_hz(&scratch, joints);
        let surveys = survey("2024-05-01", &before) + &survey("2026-05-01", &after);
        fs::write(scratch.path().join("project.toml"), pole(GIVEN, &surveys)).unwrap();
        let found = json(&scratch, "compare .");
        let part = found.pointer("/parts/0").unwrap();
        let best = &part["fits"][0];
        assert_eq!(
            (&best["part"], &part["candidates"]),
            (&name.into(), &1.into()),
            "{part}"
        );
        assert!(
            (best["stiffness_left"].as_f64().unwrap() / 0.75 - 1.0).abs() < 2e-3,
            "{best}"
        );
        assert!(best["stiffness_left_lower"].as_f64() < Some(0.75), "{best}");
        let said = scratch.briefly("compare .").stdout.replace("\n    ", " ");
        assert!(
            said.contains(&format!("it is the joint below ‘{name}’: 75 %")),
            "{said}"
        );
        let korean = scratch.briefly("compare . --language ko").stdout;
        assert!(korean.contains(&format!("‘{name}’ 하부 접합면")), "{korean}");
    }
}

#[test]
fn agrees_what_no_part_or_every_part_explains_is_said() {
    let scratch = Scratch::new("changed-parts");
    let before = frequencies_hz(&scratch, GIVEN);
    let alike = frequencies_hz(&scratch, GIVEN.map(|k| 0.85 * k));
    let said = |after: &[f64]| {
        let surveys = survey("2024-05-01", &before) + &survey("2026-05-01", after);
        fs::write(scratch.path().join("project.toml"), pole(GIVEN, &surveys)).unwrap();
        scratch.dolmen("compare .").stdout.replace("\n    ", " ")
    };
    let answer = said(&alike);
    assert!(
        answer.contains("No single part of the model explains"),
        "{answer}"
    );
    assert!(
        answer.contains("All parts alike explain the changes as well: 85 %"),
        "{answer}"
    );
    let odd = [0.97 * before[0], 1.03 * before[1], 0.97 * before[2]];
    let answer = said(&odd);
    assert!(
        answer.contains("No single part of the model explains"),
        "{answer}"
    );
    assert!(!answer.contains("All parts alike"), "{answer}");
    // nothing changed: no part is sought
    let answer = said(&before);
    assert!(
        !answer.contains("single part") && !answer.contains("alone changed"),
        "{answer}"
    );
}

/// Four stones, oblong in plan, one with its springs scaled by a factor.
fn pillar(factor: f64, surveys: &str) -> String {
    format!(
        "schema = 1\nkind = \"stack\"\nname = \"pillar\"\nevidence = \"measured\"\ndensity = 2600\n\
         joint = {{ normal_stiffness = \"1e9 Pa/m\", shear_stiffness = \"4e8 Pa/m\" }}\n\
         blocks = [\n{{ name = \"base\", width = 1.2, depth = 1.0, height = 0.5 }},\n\
         {{ name = \"drum\", width = 0.8, depth = 0.7, height = 1.0, joint = {{ normal_stiffness = \"{} Pa/m\", shear_stiffness = \"{} Pa/m\" }} }},\n\
         {{ name = \"neck\", width = 0.7, depth = 0.6, height = 0.9 }},\n\
         {{ name = \"cap\", width = 1.0, depth = 0.9, height = 0.3 }},\n]\n{surveys}",
        1e9 * factor,
        4e8 * factor
    )
}

/// The modes of a check: along x, along y and of torsion.
fn modes_hz(scratch: &Scratch, factor: f64) -> [Vec<f64>; 3] {
    fs::write(scratch.path().join("project.toml"), pillar(factor, "")).unwrap();
    let check = json(scratch, "check .");
    let modes = check
        .pointer("/state/check/stack/frequencies/modes")
        .and_then(Value::as_array);
    let mut all: [Vec<f64>; 3] = Default::default();
    for mode in modes.unwrap_or_else(|| panic!("{check}")) {
        let top = |row: usize| mode["shape"][3][row].as_f64().unwrap().abs();
        // the top of a torsional mode moves only by rounding
        let along = match (top(0).max(top(1)) < 1e-6 * top(5), top(1) > top(0)) {
            (true, _) => 2,
            (false, across) => usize::from(across),
        };
        all[along].push(mode["frequency_hz"].as_f64().unwrap());
    }
    all
}

#[test]
fn agrees_compare_names_the_joint_of_a_stack() {
    let scratch = Scratch::new("changed-joint");
    let survey = |date: &str, along: &[Vec<f64>; 3]| {
        let mut text = format!("\n[survey.{date}]\ntemperature_c = 15\n");
        for (direction, all) in ["x", "y", "torsion"].into_iter().zip(along) {
            let each = all.iter().map(|hz| format!("{{ value = {hz:.6}, cov = 0.002 }}"));
            if !all.is_empty() {
                let each = each.collect::<Vec<_>>().join(", ");
                writeln!(text, "frequencies.{direction} = [{each}]").unwrap();
            }
        }
        text
    };
    let surveys =
        survey("2024-05-01", &modes_hz(&scratch, 1.0)) + &survey("2026-05-01", &modes_hz(&scratch, 0.75));
    fs::write(scratch.path().join("project.toml"), pillar(1.0, &surveys)).unwrap();
    let found = json(&scratch, "compare .");
    let part = found.pointer("/parts/0").unwrap_or_else(|| panic!("{found}"));
    let best = &part["fits"][0];
    assert_eq!(
        (&best["part"], &part["direction"]),
        (&"drum".into(), &Value::Null),
        "{part}"
    );
    assert!(
        (best["stiffness_left"].as_f64().unwrap() / 0.75 - 1.0).abs() < 2e-3,
        "{best}"
    );
    assert_eq!(part["modes_hz"].as_array().unwrap().len(), 3, "{part}");
    let said = scratch.briefly("compare .").words();
    assert!(said.contains("the joint below ‘drum’"), "{said}");
}

/// A survey measured the structure as it was: before a damage, without it.
#[test]
fn agrees_a_survey_is_held_against_the_model_of_its_day() {
    let scratch = Scratch::new("model-of-its-day");
    let before = frequencies_hz(&scratch, GIVEN);
    let [low, middle, top] = GIVEN;
    let after = frequencies_hz(&scratch, [low, 0.6 * middle, top]);
    let found = "[[survey.2026-05-01.inspections]]\npart = \"middle\"\nwhat = \"open joint\"\n\
                 model = { stiffness_left = 0.6 }\n";
    let judged = |surveys: String| {
        fs::write(
            scratch.path().join("project.toml"),
            pole(GIVEN, &(surveys + found)),
        )
        .unwrap();
        json(&scratch, "check .")
            .pointer("/judgement/versions/0/evidence/word")
            .cloned()
    };
    let [agrees, contradicted] = ["agrees", "contradicted"].map(|word| Some(Value::from(word)));
    assert_eq!(judged(survey("2024-05-01", &before)), agrees);
    assert_eq!(
        judged(survey("2024-05-01", &before) + &survey("2026-05-02", &after)),
        agrees
    );
    assert_eq!(judged(survey("2026-05-02", &before)), contradicted);
    let words = scratch.briefly("check .").stdout.replace("\n    ", " ");
    assert!(!words.contains("without later damage"), "{words}");
    assert_eq!(judged(survey("2024-05-01", &before)), agrees);
    let words = scratch.briefly("check .").stdout.replace("\n    ", " ");
    assert!(words.contains("model without later damage"), "{words}");
    let surveys = survey("2024-05-01", &before) + &survey("2026-05-01", &after) + found;
    fs::write(scratch.path().join("project.toml"), pole(GIVEN, &surveys)).unwrap();
    let compared = json(&scratch, "compare .");
    let best = compared.pointer("/parts/0/fits/0").unwrap();
    assert_eq!(best["part"], "middle");
    assert!(
        (best["stiffness_left"].as_f64().unwrap() - 0.6).abs() < 0.01,
        "{best}"
    );
}
