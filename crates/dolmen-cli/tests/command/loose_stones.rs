// SOURCE     examples/rubble, made from a seed by its make_rubble.py; two cubes by hand
// GOAL       Loose stones come to rest, the same under both laws; other verbs and keys that need joints refuse them by name.
// TOLERANCE  none: words and exit statuses; 1e-3 mm on a drop of 1 mm

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

/// Cubes of 0.2 m with these lowest corners, the second named "upper".
fn cubes(places_m: &[[f64; 3]], more: &str) -> String {
    let blocks = places_m.iter().zip(["lower", "upper"]).map(|([x, y, z], name)| {
        let corner = |i: usize| {
            let part = |bit: usize| if i & bit == 0 { 0.0 } else { 0.2 };
            format!("[{:.4}, {:.4}, {:.4}]", x + part(1), y + part(2), z + part(4))
        };
        let points: Vec<String> = (0..8).map(corner).collect();
        format!(
            "{{ name = \"{name}\", shape = \"points\", coordinates = \"site\", points = [{}] }}",
            points.join(", ")
        )
    });
    let blocks: Vec<String> = blocks.collect();
    format!(
        "schema = 1\nkind = \"stack\"\nname = \"Cubes\"\ndensity = 2600\nloose = true\n{more}blocks = [{}]\n",
        blocks.join(", ")
    )
}

fn answer(name: &str, text: &str, words: &str) -> (i32, String, String) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen(words);
    (answer.status, answer.stdout.clone(), answer.stderr)
}

#[test]
fn exact_two_cubes_drawn_1_mm_apart_close() {
    let text = cubes(&[[0.0, 0.0, 0.001], [0.0, 0.0, 0.202]], "");
    let (status, stdout, stderr) = answer("loose-cubes", &text, "check project.toml --json");
    assert_eq!(status, 0, "{stdout}{stderr}");
    let value: Value = serde_json::from_str(&stdout).unwrap();
    assert_eq!(value["laws_differ"], false, "{stdout}");
    for run in value["runs"].as_array().unwrap() {
        let stones = run["settled"]["stones"].as_array().unwrap();
        for (stone, exact_m) in stones.iter().zip([1e-3, 2e-3]) {
            let dropped_m = stone["dropped_m"].as_f64().unwrap();
            assert!((dropped_m - exact_m).abs() < 1e-6, "{run}");
        }
    }
}

#[test]
fn holds_a_cube_that_nothing_carries_leaves_its_place() {
    let text = cubes(&[[0.0, 0.0, 0.0], [0.15, 0.0, 0.201]], "");
    for verb in ["check", "simulate"] {
        let (status, stdout, stderr) = answer("loose-cube-falls", &text, &format!("{verb} project.toml"));
        assert_eq!(status, 1, "{stdout}{stderr}");
        assert!(
            stdout.contains("leave") && stdout.contains("'upper'"),
            "{stdout}{stderr}"
        );
    }
}

#[test]
fn refuses_what_needs_joints() {
    let placed = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.201]];
    let tied = cubes(
        &placed,
        "soil = { shear_modulus = \"40 MPa\", poisson_ratio = 0.35 }\n",
    );
    let (status, _, stderr) = answer("loose-soil", &tied, "check project.toml");
    assert_eq!(status, 2, "{stderr}");
    assert!(
        stderr.contains("soil has no meaning with loose = true"),
        "{stderr}"
    );
    let overlapping = cubes(&[[0.0, 0.0, 0.0], [0.05, 0.0, 0.18]], "");
    let (status, _, stderr) = answer("loose-overlap", &overlapping, "check project.toml");
    assert_eq!(status, 2, "{stderr}");
    assert!(stderr.contains("'upper' and 'lower' overlap"), "{stderr}");
    let study = "[study.a]\nmotions = [\"el-centro-1940-ns\"]\nscale = [1]\n";
    let studied = format!("{}{study}", cubes(&placed, ""));
    let (status, _, stderr) = answer("loose-study", &studied, "study project.toml");
    assert_eq!(status, 2, "{stderr}");
    assert!(stderr.contains("the stones are loose"), "{stderr}");
}

#[test]
fn holds_a_report_of_loose_stones_shows_where_they_come_to_rest() {
    let scratch = Scratch::new("loose-report");
    let placed = [[0.0, 0.0, 0.001], [0.0, 0.0, 0.202]];
    fs::write(scratch.path().join("project.toml"), cubes(&placed, "")).unwrap();
    // both cubes close their gaps of 1 mm
    for (language, said) in [
        (
            "en",
            [
                "Own weight: stable",
                "With springs between the stones all 2 stones come to rest where they lie; 'upper' moves farthest, by 2.000",
                "With rigid stones all 2 stones come to rest",
                "as drawn",
                "at rest, rigid stones",
            ],
        ),
        (
            "ko",
            [
                "자중: 안정",
                "접촉 스프링 해석: 돌 2개가 모두 제자리에 안착한다. 가장 많이 움직인 ‘upper’의 이동은 2.000",
                "강체 접촉 해석: 돌 2개가 모두 제자리에 안착한다.",
                "입력한 자리",
                "안착 위치, 강체 접촉",
            ],
        ),
    ] {
        let report = scratch.dolmen(&format!("report . -o {language}.html --language {language}"));
        assert_eq!(report.status, 0, "{}", report.stderr);
        let page = fs::read_to_string(scratch.path().join(format!("{language}.html"))).unwrap();
        for said in said {
            assert!(page.contains(said), "{said}: {page}");
        }
    }
    let drawn = scratch.dolmen("draw . -o drawn.svg");
    assert_eq!(drawn.status, 0, "{}", drawn.stderr);
}

#[test]
fn holds_the_rubble_of_the_example_stands_by_both_laws() {
    let scratch = Scratch::with_examples("rubble");
    let answer = scratch.dolmen("simulate examples/rubble --json");
    let value: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert_eq!(value["laws_differ"], false, "{value}");
    for run in value["runs"].as_array().unwrap() {
        assert_eq!(run["settled"]["outcome"]["kind"], "stood", "{run}");
    }
}

#[test]
fn holds_every_variant_of_loose_stones_settles_and_the_worse_one_is_named() {
    let stands = cubes(&[[0.0, 0.0, 0.001], [0.0, 0.0, 0.202]], "");
    let falls = cubes(&[[0.0, 0.0, 0.0], [0.15, 0.0, 0.201]], "");
    let blocks = falls.split_once("blocks = ").unwrap().1;
    let text = format!("{stands}[variant.shifted]\nblocks = {blocks}");
    let (status, stdout, stderr) = answer("loose-variant", &text, "check project.toml");
    assert_eq!(status, 1, "{stdout}{stderr}");
    let words = stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    for said in [
        "Own weight: stable",
        "Variant “shifted”: Own weight: unstable",
        "Variant “shifted”: With rigid stones 'upper' leaves its place",
    ] {
        assert!(words.contains(said), "{said}: {stdout}");
    }
    let (_, json, _) = answer("loose-variant-json", &text, "check project.toml --json");
    let value: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(value["simulations"][1]["variant"], "shifted", "{json}");
    let (status, _, stderr) = answer(
        "loose-variant-placed",
        &format!("{stands}[variant.placed]\nloose = false\n"),
        "check project.toml",
    );
    assert_eq!(status, 2, "{stderr}");
    assert!(stderr.contains("\"placed\""), "{stderr}");
}
