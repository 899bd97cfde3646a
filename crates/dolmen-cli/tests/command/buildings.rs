// SOURCE     The shipped buildings and El Centro 1940 north-south.
// GOAL       The text on a building with torsion, its output files and the exit status follow from the computation.
// TOLERANCE  none: printed words. Histories against the peaks beside them: printed digits.

use super::verbs::Scratch;
use std::fs;

#[test]
fn holds_a_floor_that_twists_is_checked() {
    let scratch = Scratch::with_examples("building_check");
    let answer = scratch.dolmen("check examples/twisting_floor");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in ["−23.378", "1.84707", "2.28210", "3.60553", "–      –", "CQC"] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let headline =
        "VERDICT Own weight: stable · Earthquake KDS 17 10 00, 2400 y: not decided (no limit is known)";
    assert!(answer.words().contains(headline), "{}", answer.stdout);
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
    assert!(
        answer.stdout.contains("VERDICT Own weight: unstable"),
        "{}",
        answer.stdout
    );
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
        "The largest drift at a corner",
        "Of what it would move",
        "Points of the file.",
        "Linear, mode by mode",
        "What the dampers do.",
        "left end",
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
    // peaks lie between steps: at least the largest sample, and at most π²/2n² larger for n = 170 steps per period, and fewer for the others
    let same = |a: f64, b: f64| assert!(b >= a * (1.0 - 4e-16) && b < 1.002 * a, "{a} {b}");
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
        "top-y",
        "rotation",
        "base-shear",
        "strokes",
        "point-1",
        "point-2",
        "acceleration-1",
        "acceleration-2",
    ] {
        assert!(text(&format!("{figure}.svg")).starts_with("<svg"), "{figure}");
    }
    // a quarter turn leaves nothing along x, and a constant line gets no figure
    assert!(!out.join("top-x.svg").exists());
    assert_eq!(most("floor_1_displacement_x_m"), 0.0);
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
    assert_eq!(json["dampers_across_the_motion"], serde_json::json!([]));
}

#[test]
fn holds_a_damper_that_the_ground_shakes_across_is_named() {
    let scratch = Scratch::with_examples("building_across");
    let run = "simulate examples/twenty_storeys --motion el-centro-1940-ns --duration 1";
    let answer = scratch.dolmen(run);
    assert_eq!(answer.status, 3, "{}", answer.stderr); // it ends before its motion
    let said = "The ground shakes across damper top, which moves along y";
    assert!(answer.stdout.contains(said), "{}", answer.stdout);
    // nearly across is not across: part of the motion is along it
    let answer = scratch.dolmen(&format!("{run} --turn 1"));
    assert!(!answer.stdout.contains("shakes across"), "{}", answer.stdout);
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

const PULSE: &str = r#"schema = 1
kind = "building"
name = "pulse"
p_delta = false
floors = [
  { mass = 1e5, sides = [10, 8], height = 30, stiffness = { x = 4e5, y = 4e5, rotation = 1e7, centre = [-1, 0] } },
]
"#;

#[test]
fn regress_a_building_swings_on_after_a_short_motion() {
    let scratch = Scratch::new("building_pulse");
    let mut motion = "time,acc (m/s2)\n0.00,0\n".to_owned();
    for i in 1..=30 {
        motion += &format!("{:.2},3\n", f64::from(i) / 100.0);
    }
    fs::write(scratch.path().join("pulse.csv"), motion + "0.31,0\n").unwrap();
    fs::write(scratch.path().join("pulse.toml"), PULSE).unwrap();
    let answer = scratch.dolmen("--json simulate pulse.toml --motion-file y=pulse.csv");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let y = json["peaks"]["floors"][0]["displacement_y_m"]["value"]
        .as_f64()
        .unwrap();
    assert!((y.abs() - 0.413_268).abs() < 2e-5, "{y}");
    assert_eq!(json["grows_at_the_end"], false);
    let answer = scratch.dolmen("simulate pulse.toml --motion-file y=pulse.csv --duration 0.31");
    assert!(answer.stdout.contains("and may grow on"), "{}", answer.stdout);
    for (option, said) in [
        ("--step 0", "must be a positive number"),
        ("--step nan", "must be a positive number"),
        ("--law rigid", "--law is for stacks"),
        ("--points 4", "--points is for stacks"),
        ("--rotations small", "--rotations is for chains"),
        ("--direction x", "--direction names a direction of a frame"),
        ("--to-the-end", "--to-the-end is for stacks"),
        ("--duration 0.001", "end_s is 0.001"),
    ] {
        let answer = scratch.dolmen(&format!("simulate pulse.toml --motion-file y=pulse.csv {option}"));
        assert_eq!(answer.status, 2, "{option}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{option}: {}", answer.stderr);
    }
}

#[test]
fn regress_edges_without_outline_are_unknown_and_the_walls_of_p_delta_carry_the_drift() {
    let scratch = Scratch::new("building_edges");
    let text = r#"schema = 1
kind = "building"
name = "no outline"
floors = [
  { mass = 1e5, centre = [0, 0], gyration = 4, height = 3, stiffness = { x = 1e6, y = 1e6, rotation = 6e7, centre = [0, 0] } },
]
[site]
code = "KDS 17 10 00"
zone = "I"
return_period_years = 2400
soil = "S4"
"#;
    fs::write(scratch.path().join("b.toml"), text).unwrap();
    let answer = scratch.dolmen("simulate b.toml --motion el-centro-1940-ns");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "The largest drift of a centre of mass",
        "sides or outline",
        "the floor has no outline",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let answer = scratch.dolmen("--json simulate b.toml --motion el-centro-1940-ns");
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let floor = &json["peaks"]["floors"][0];
    assert!(floor["edge_drift_x_m"].is_null());
    assert_eq!(json["drift_at"], "centre_of_mass");
    let value = |peak: &serde_json::Value| peak["value"].as_f64().unwrap().abs();
    let shear = value(&json["peaks"]["base_shear_x_n"]);
    assert!(
        (shear / (1e6 * value(&floor["drift_x_m"])) - 1.0).abs() < 1e-9,
        "{shear}"
    );
    let answer = scratch.dolmen("check b.toml");
    assert!(answer.stdout.contains("has no outline"), "{}", answer.stdout);
    // the answer says that a spectrum is not defined for this damping
    let low = text.replace(
        "name = \"no outline\"",
        "name = \"no outline\"\ndamping.ratio = 0.004",
    );
    fs::write(scratch.path().join("b.toml"), low).unwrap();
    let answer = scratch.dolmen("check b.toml");
    assert!(answer.stdout.contains("is not computed"), "{}", answer.stdout);
}

#[test]
fn regress_the_base_shear_of_a_spectrum_has_both_directions() {
    // one wall turned by 45 degrees: shaking along y gives nearly as much shear along x as shaking along x
    let scratch = Scratch::new("building_shear");
    let text = r#"schema = 1
kind = "building"
name = "shear"
p_delta = false
floors = [
  { mass = 1e5, sides = [10, 8], height = 3, walls = [
    { x = 0, y = 0, stiffness_x = 4e7, stiffness_y = 1e7, angle = "45 deg", stiffness_rotation = 4e8 },
  ] },
]
[site]
code = "table"
periods_s = [0, 10]
accelerations = [0.5, 0.5]
unit = "g"
"#;
    fs::write(scratch.path().join("s.toml"), text).unwrap();
    let answer = scratch.dolmen("--json check s.toml");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let spectral = &json["state"]["check"]["building"]["standing"]["spectral"];
    let x = spectral["base_shear_n"]["cqc"][0].as_f64().unwrap();
    assert!((x - 490.33e3).abs() < 10.0, "{x}");
    // 349.91 kN under x and 343.5 kN under y by another program; both modes are as strong: the larger along x, 0.85 of it along y
    let worst = &spectral["base_shear_least_favourable"][0];
    let by_hand = 349.91e3_f64.hypot(0.85 * 343.5e3);
    assert!(
        (worst["base_shear_n"].as_f64().unwrap() - by_hand).abs() < 50.0,
        "{worst}"
    );
    assert!(
        worst["direction_degrees"].as_f64().unwrap().abs() < 1e-6,
        "{worst}"
    );
}

#[test]
fn holds_dampers_of_every_kind_through_check_simulate_and_report() {
    let scratch = Scratch::with_examples("several_dampers");
    let answer = scratch.dolmen("check examples/several_dampers");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "pair-1",
        "pair-2",
        "tlcd",
        "tlcmd",
        "link",
        "2.0000 kN·s/m to the ground",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let answer = scratch.dolmen("simulate examples/several_dampers --motion el-centro -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "What the dampers do.",
        "swing liquid  ",
        "by the matrix exponential",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let text = fs::read_to_string(scratch.path().join("out/simulation.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["peaks"]["strokes_m"].as_array().unwrap().len(), 6);
    assert_eq!(json["method"], "matrix_exponential");
    assert!(json["against_without"].as_array().unwrap().len() >= 3);
    let file = scratch.path().join("examples/several_dampers/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replace("stroke = \"600 mm\"", "stroke = \"3 mm\"")).unwrap();
    let answer = scratch.dolmen("simulate examples/several_dampers --motion el-centro");
    // in the headline, and in the exit status
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    let (said, moved) = (
        answer.stdout.find("Damper pair-1 is beyond its room"),
        answer.stdout.find("The largest drift"),
    );
    assert!(said.is_some() && said < moved, "{}", answer.stdout);
    let answer = scratch.dolmen("report examples/several_dampers --motion el-centro -o page.html");
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
    let findings = page.split("What was given").next().unwrap_or_default();
    assert!(
        findings.contains("damper pair-1 is beyond its room: it needs"),
        "the findings say it"
    );
    // the liquid of a column on a spring has its own room
    let tank = |mm: f64| {
        let roomy = format!("liquid_share = 0.5\nliquid_stroke = \"{mm} mm\"");
        fs::write(&file, text.replace("liquid_share = 0.5", &roomy)).unwrap();
        scratch.dolmen("--json simulate examples/several_dampers --motion el-centro")
    };
    let liquid_mm = 1e3 * json["peaks"]["strokes_m"][5]["value"].as_f64().unwrap().abs();
    let answer = tank(0.99 * liquid_mm);
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    let beyond: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(beyond["beyond_room"][0]["damper"], "swing liquid");
    assert_eq!(tank(1.01 * liquid_mm).status, 0);
}

#[test]
fn exact_the_force_of_a_dashpot_is_its_coefficient_times_the_rate_of_its_stroke() {
    let scratch = Scratch::with_examples("dashpot_force");
    let answer = scratch.dolmen("--json simulate examples/several_dampers --motion el-centro");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let rate = |k: usize| json["peaks"]["stroke_rates_m_s"][k]["value"].as_f64().unwrap();
    let force = |k: usize| json["dashpot_forces_n"][k]["value"].as_f64();
    let damper = |k: usize, key: &str| json["dampers"][k][key].as_f64().unwrap();
    let names: Vec<&str> = (0..5)
        .map(|k| json["dampers"][k]["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["pair-1", "pair-2", "tank", "swing", "dashpot"]);
    for k in [0, 1, 3] {
        let own = std::f64::consts::TAU * damper(k, "frequency_hz");
        let coefficient = 2.0 * damper(k, "damping_ratio") * damper(k, "mass_kg") * own;
        assert!(
            (force(k).unwrap() / (coefficient * rate(k)) - 1.0).abs() < 1e-12,
            "{k}"
        );
    }
    assert_eq!(force(2), None, "a liquid column has no dashpot");
    assert!((force(4).unwrap() / (2000.0 * rate(4)) - 1.0).abs() < 1e-12);
    let answer = scratch.dolmen("simulate examples/several_dampers --motion el-centro");
    assert!(
        answer.stdout.contains("force of the dashpot"),
        "{}",
        answer.stdout
    );
}

#[test]
fn holds_dampers_are_in_the_spectrum_of_a_site_and_their_rooms_too() {
    let scratch = Scratch::with_examples("damped_spectrum");
    let answer = scratch.dolmen("--json check examples/twisting_floor");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let standing = &json["variants"][0]["state"]["check"]["building"]["standing"];
    let with = &standing["spectral_with_dampers"];
    let shear = |of: &serde_json::Value| of[1].as_f64().unwrap();
    let (damped, bare) = (
        shear(&with["base_shear_n"]),
        shear(&standing["spectral"]["base_shear_n"]["cqc"]),
    );
    assert!(damped < 0.7 * bare, "{damped} {bare}");
    let stroke_mm = 1e3 * with["strokes_m"][0].as_f64().unwrap();
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    let room = |mm: f64| {
        let roomy = text.replace("mass = 5.125", &format!("mass = 5.125\nstroke = \"{mm} mm\""));
        fs::write(&file, roomy).unwrap();
        scratch.dolmen("check examples/twisting_floor")
    };
    let answer = room((0.99 * stroke_mm).round());
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    assert!(
        answer.stdout.contains("Damper tmd is beyond its room"),
        "{}",
        answer.stdout
    );
    let answer = room((1.01 * stroke_mm).round());
    assert_eq!(answer.status, 0, "{}", answer.stderr);
}

#[test]
fn holds_a_plan_of_sensors_names_the_dampers_that_it_leaves_out() {
    let scratch = Scratch::with_examples("planned-dampers");
    let answer = scratch.dolmen("sensors examples/several_dampers");
    assert!(
        answer.words().contains("without its dampers (pair"),
        "{}",
        answer.stdout
    );
    let plain = scratch.dolmen("sensors examples/twisting_floor");
    assert!(!plain.words().contains("without its dampers"), "{}", plain.stdout);
}
