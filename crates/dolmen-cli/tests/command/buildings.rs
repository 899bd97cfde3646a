// SOURCE     The shipped buildings and El Centro 1940 north-south.
// GOAL       What a user reads of a building that twists, the files it writes and its exit status follow from what was computed.
// TOLERANCE  none: printed words. Histories against the peaks beside them: printed digits.

use super::verbs::Scratch;
use std::fs;

#[test]
fn holds_a_floor_that_twists_is_checked() {
    let scratch = Scratch::with_examples("building_check");
    let answer = scratch.dolmen("check examples/twisting_floor");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "VERDICT stable",
        "-23.378",
        "1.84707",
        "2.28210",
        "3.60553",
        "none    none",
        "CQC",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let answer = scratch.dolmen("--json check examples/twisting_floor");
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let modes = &json["state"]["check"]["building"]["standing"]["modes"];
    let radius = |mode: usize| modes[mode]["centres"][0]["r_x_m"].as_f64().unwrap();
    assert!((radius(0) * radius(2) + 164.0 / 12.0).abs() < 1e-8);
    assert!(modes[1]["centres"][0].is_null());
}

#[test]
fn holds_a_building_too_soft_for_its_weight_falls() {
    let scratch = Scratch::with_examples("building_falls");
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        text.replace("height = 30", "height = 2")
            .replace("p_delta = false", "p_delta = true"),
    )
    .unwrap();
    let answer = scratch.dolmen("check examples/twisting_floor");
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    assert!(answer.stdout.contains("VERDICT unstable"), "{}", answer.stdout);
    let answer = scratch.dolmen("simulate examples/twisting_floor --motion el-centro");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    assert!(
        answer.stderr.contains("falls under its own weight"),
        "{}",
        answer.stderr
    );
}

#[test]
fn holds_every_file_of_a_simulation_says_the_same() {
    let scratch = Scratch::with_examples("building_simulation");
    let answer =
        scratch.dolmen("simulate examples/twisting_floor --variant damped --motion el-centro -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "MOVED: the largest drift",
        "of what it would without dampers",
        "Damper tmd: stroke",
        "Point left end",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let out = scratch.path().join("out");
    let text = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text("simulation.json")).unwrap();
    let histories = text("histories.csv");
    let head: Vec<&str> = histories.lines().next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> = histories
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    let most = |name: &str| {
        let column = head.iter().position(|h| *h == name).unwrap();
        rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max)
    };
    let floor = &json["peaks"]["floors"][0];
    let value = |peak: &serde_json::Value| peak["value"].as_f64().unwrap().abs();
    // the reader of JSON may miss the last bit
    let same = |a: f64, b: f64| assert!((a - b).abs() <= 4e-16 * b, "{a} {b}");
    same(
        most("floor_1_displacement_y_m"),
        value(&floor["displacement_y_m"]),
    );
    same(most("damper_tmd_stroke_m"), value(&json["peaks"]["strokes_m"][0]));
    same(most("base_shear_y_n"), value(&json["peaks"]["base_shear_y_n"]));
    let end = json["points"][1]["peak_displacement_m"][1].as_f64().unwrap();
    same(most("right end_displacement_y_m"), end);
    assert!(
        end > most("left end_displacement_y_m"),
        "the soft side moves more"
    );
    let without = value(&json["peaks_without_dampers"]["floors"][0]["displacement_y_m"]);
    assert!(value(&floor["displacement_y_m"]) < 0.9 * without);
    for figure in [
        "ground",
        "top-x",
        "top-y",
        "rotation",
        "base-shear",
        "strokes",
        "point-1",
        "point-2",
    ] {
        assert!(text(&format!("{figure}.svg")).starts_with("<svg"), "{figure}");
    }
}

#[test]
fn holds_twenty_storeys_through_el_centro_in_steps_of_five_milliseconds() {
    let scratch = Scratch::with_examples("building_tall");
    let motion = "--motion el-centro-1940-ns --turn 90 --step 0.005 --duration 40";
    let answer = scratch.dolmen(&format!("--json simulate examples/twenty_storeys {motion}"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(
        (json["method"].as_str(), json["steps"].as_u64()),
        (Some("complex_modes"), Some(8000))
    );
    assert!(
        json["peaks"]["floors"][19]["displacement_y_m"]["value"]
            .as_f64()
            .unwrap()
            .abs()
            > 0.1
    );
}

#[test]
fn holds_new_and_report_know_buildings() {
    let scratch = Scratch::with_examples("building_new");
    let answer = scratch.dolmen("new building mine");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for (language, said) in [
        ("en", "Where the top floor turns in each mode"),
        ("ko", "모드 중심을 표시한 평면도"),
    ] {
        let answer = scratch.dolmen(&format!(
            "report mine --motion el-centro --language {language} -o {language}.html"
        ));
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join(format!("{language}.html"))).unwrap();
        assert!(page.contains(said), "{said}");
    }
}
