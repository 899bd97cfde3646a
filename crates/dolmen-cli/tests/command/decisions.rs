// SOURCE     The shipped pile of three blocks under 22 made motions; KDS 17 10 00.
// GOAL       Fragility and risk of a study follow from its runs, give their basis, and refuse what the runs do not support.
// TOLERANCE  fits 1e-9 against the library given the same scans; everything else printed words.

use super::studies::rows;
use super::verbs::Scratch;
use dolmen::assess::{Hazard, Observation, annual_risk, fit_fragility};
use dolmen::signal::{Component, Noise, noise_motion, response_spectrum};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const PILE: &str = "examples/portfolio/piled_blocks.toml";

fn json(scratch: &Scratch, command: &str) -> Value {
    let answer = scratch.dolmen(&format!("--json {command}"));
    assert_eq!(answer.status, 0, "{command}: {}{}", answer.stdout, answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn holds_curves_and_rates_are_those_of_the_runs() {
    let scratch = Scratch::with_examples("fragility");
    let answer = json(&scratch, &format!("study {PILE} -o out"));
    let folder = scratch.path().join("out/fragility");
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    // DS3 by hand from the runs: for each motion the first peak with DS3, and the one below
    let runs = rows(&folder.join("runs.csv"));
    let mut motions: BTreeMap<String, Vec<(f64, f64)>> = BTreeMap::new();
    for run in &runs {
        let of = motions.entry(run["motion"].clone()).or_default();
        of.push((
            number(run, "peak_ground_acceleration_m_s2"),
            number(run, "damage_state"),
        ));
    }
    assert_eq!(motions.len(), 22);
    let seen = motions.values().map(|runs| {
        let first = runs.iter().position(|(_, state)| *state >= 3.0).unwrap();
        Observation::Between(runs[first - 1].0, runs[first].0)
    });
    let fit = fit_fragility(&seen.collect::<Vec<_>>()).unwrap();
    let table = rows(&folder.join("fragility.csv"));
    let ds3 = table.iter().find(|row| row["state"] == "DS3").unwrap();
    assert!(
        (number(ds3, "theta_pga_m_s2") / fit.curve.theta() - 1.0).abs() < 1e-9,
        "{ds3:?}"
    );
    assert!(
        (number(ds3, "beta_pga") / fit.curve.beta() - 1.0).abs() < 1e-9,
        "{ds3:?}"
    );
    measures_and_joints(&answer, &folder, &runs);
    // the hazard of zone I on S2: 1.4 F_a up to 0.2 g, then falling to 1.37 at 0.22 g
    let hazard = answer["hazard"].as_array().unwrap();
    let points: Vec<[f64; 2]> = hazard
        .iter()
        .map(|point| ["peak_acceleration_m_s2", "annual_rate"].map(|key| point[key].as_f64().unwrap()))
        .collect();
    assert!((points[3][0] / (0.11 * 1.4 * 9.80665) - 1.0).abs() < 1e-12 && points[3][1] == 1.0 / 500.0);
    let risk = annual_risk(&Hazard::of_points(&points).unwrap(), &fit.curve);
    assert!((number(ds3, "annual_rate") / risk.annual_rate - 1.0).abs() < 1e-9);
    // it never falls: a bound and no curve, and DS3 decides
    let states = answer["fragility"][0]["states"].as_array().unwrap();
    let falls = states.last().unwrap();
    assert_eq!(falls["state"], "falls");
    let why = falls["by_peak_acceleration_m_s2"]["why_not"].as_str().unwrap();
    assert!(why.starts_with("none of 22 motions reached the state"), "{why}");
    assert!(falls["annual_rate"].is_null() && states[2]["annual_rate"].is_number());
    assert!(
        fs::read_to_string(folder.join("fragility-1.svg"))
            .unwrap()
            .contains("DS3")
    );
    let text = scratch.dolmen(&format!("study {PILE} -o out")).words();
    for said in [
        "at 2.000: P < 0.13",
        "nobody gave it",
        "KDS 17 10 00, 50 to 2400 years",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
    // the report contains it, in both languages
    let file = scratch.path().join(PILE);
    let studies = file.parent().unwrap().join("studies");
    fs::create_dir_all(&studies).unwrap();
    fs::rename(&folder, studies.join("fragility")).unwrap();
    for (language, said) in [("en", "Fragility and risk"), ("ko", "취약도와 위험도")] {
        let answer = scratch.dolmen(&format!("report {PILE} -o page.html --language {language}"));
        assert_eq!(
            answer.status, 1,
            "below demand: {}{}",
            answer.stdout, answer.stderr
        );
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        assert!(page.contains(said), "{said}");
    }
}

/// Shaking measures and joint states, by hand from the runs.
fn measures_and_joints(answer: &Value, folder: &Path, runs: &[BTreeMap<String, String>]) {
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    // S_a over the peak of the first motion, which is made again here
    let made = Noise {
        duration_s: 20.0,
        rise_s: 2.0,
        strong_s: 8.0,
        time_step_s: 0.01,
        ..Noise::default()
    };
    let motion = noise_motion(&made, 1).unwrap();
    let ordinate = &response_spectrum(&motion, Component::X, &[0.5], 0.05).unwrap()[0];
    let over_peak = ordinate.pseudo_acceleration_m_s2() / motion.component_peak_m_s2(Component::X);
    let first = runs.iter().find(|run| run["motion"] == "noise 1").unwrap();
    let found = number(first, "sa_0.5_s_m_s2") / number(first, "peak_ground_acceleration_m_s2");
    assert!((found / over_peak - 1.0).abs() < 1e-9, "{found} {over_peak}");
    // PGA/(g tan α) along x: 300 mm wide, three of 100 mm over the lowest joint
    let ratio = number(first, "uplift_ratio") / number(first, "peak_ground_acceleration_m_s2");
    assert!((ratio * 9.80665 - 1.0).abs() < 1e-9, "{ratio}");
    let velocity = number(first, "velocity_ratio") / number(first, "peak_ground_velocity_m_s");
    // p = √(3g/4R), R of the half diagonal of 300 x 300 mm
    let p = (0.75 * 9.80665 / 0.15_f64.hypot(0.15)).sqrt();
    assert!((velocity * 9.80665 / p - 1.0).abs() < 1e-9, "{velocity}");
    // β by S_a(0.5 s) of DS3 by hand; the table gives the same
    let mut motions: BTreeMap<&str, Vec<&BTreeMap<String, String>>> = BTreeMap::new();
    for run in runs {
        motions.entry(&run["motion"]).or_default().push(run);
    }
    let fit_of = |measure: &str, reached: &dyn Fn(&BTreeMap<String, String>) -> bool| {
        let seen = motions.values().map(|runs| {
            let at = |place: usize| number(runs[place], measure);
            match runs.iter().position(|run| reached(run)) {
                Some(0) => Observation::Below(at(0)),
                Some(first) => Observation::Between(at(first - 1), at(first)),
                None => Observation::Above(at(runs.len() - 1)),
            }
        });
        fit_fragility(&seen.collect::<Vec<_>>()).unwrap()
    };
    let by_hand = fit_of("sa_0.5_s_m_s2", &|run| number(run, "damage_state") >= 3.0);
    let compared = answer["measures"].as_array().unwrap();
    let ds3 = compared.iter().find(|row| row["state"] == "DS3").unwrap();
    let beta = ds3["measures"]["sa_0.5_s_m_s2"]["beta"].as_f64().unwrap();
    assert!((beta / by_hand.curve.beta() - 1.0).abs() < 1e-9, "{beta}");
    // each joint has its own state; the pile has the worst of them
    let states = |run: &BTreeMap<String, String>| -> Vec<u8> {
        let words = run["joint_states"].split(' ');
        words.map(|word| word.parse().unwrap()).collect()
    };
    for run in runs {
        let worst = states(run).into_iter().max().unwrap();
        assert_eq!(worst.to_string(), run["damage_state"], "{run:?}");
        assert_eq!(states(run).len(), 3);
    }
    let joints = rows(&folder.join("joints.csv"));
    assert_eq!(joints.len(), 9);
    let lowest = joints
        .iter()
        .find(|row| row["joint"] == "1" && row["state"] == "DS2");
    let by_hand = fit_of("peak_ground_acceleration_m_s2", &|run| states(run)[0] >= 2);
    let theta = number(lowest.unwrap(), "theta_pga_m_s2");
    assert!((theta / by_hand.curve.theta() - 1.0).abs() < 1e-9, "{theta}");
    assert!(joints.iter().all(|row| row["gave_way"] == "0"));
}

/// Five samples of a slippery stone under four motions: the answer separates the scatter due to friction from that due to motions.
#[test]
fn holds_the_scatter_of_inputs_is_told_from_that_of_motions() {
    let scratch = Scratch::new("scatter");
    let text = r#"
schema = 1
kind = "stack"
name = "Plate"
density = 2600
joint = { friction = { value = 0.3, cov = 0.3 } }
blocks = [{ name = "plate", width = 1.0, height = 0.3 }]

[study.friction]
samples = 5
artificial = { count = 4, duration_s = 4, strong_s = 1, rise_s = 1 }
peak = { from = "0.15 g", to = "1 g", steps = 26, spacing = "logarithmic" }
refine = 0
rest_s = 0.2
"#;
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = json(&scratch, "study . -o out");
    let ds2 = &answer["fragility"][0]["states"][1];
    let of = |key: &str| ds2[key].as_f64().unwrap();
    // the plate slides when the ground acceleration exceeds friction: its ln scatters by √ln(1 + 0.3²) = 0.29, and five draws of seed 1 by
    let frictions: Vec<f64> = rows(&scratch.path().join("out/friction/runs.csv"))
        .iter()
        .step_by(4 * 26)
        .map(|row| row["drawn_joint_friction"].parse::<f64>().unwrap().ln())
        .collect();
    assert_eq!(frictions.len(), 5);
    let mean = frictions.iter().sum::<f64>() / 5.0;
    let drawn = (frictions.iter().map(|f| (f - mean).powi(2)).sum::<f64>() / 4.0).sqrt();
    // to one step of the scan, 0.08 in ln
    assert!((of("beta_of_inputs") / drawn - 1.0).abs() < 0.25, "{ds2} {drawn}");
    assert!(of("beta_of_motions") < 0.5 * of("beta_of_inputs"), "{ds2}");
    let text = scratch.dolmen("study . -o out").words();
    assert!(text.contains("from what is not known of the structure"), "{text}");
    // other periods only evaluate the runs differently: nothing is run again
    let other = fs::read_to_string(scratch.path().join("project.toml")).unwrap();
    let other = other.replace(
        "refine = 0",
        "refine = 0\nspectral_periods_s = [0.3]\ntitle = \"A plate\"",
    );
    fs::write(scratch.path().join("project.toml"), other).unwrap();
    let again = scratch.dolmen("study . -o out");
    assert!(
        again.stderr.contains("520 runs are kept from before"),
        "{}",
        again.stderr
    );
    assert!(again.stdout.contains("S_a(0.3 s)"), "{}", again.stdout);
}

/// A slender post falls from a plate: the plate's capacity beyond the fall is unknown, and the table gives a bracket.
#[test]
fn holds_a_fall_elsewhere_leaves_a_joint_open() {
    let scratch = Scratch::new("cut_short");
    let text = r#"
schema = 1
kind = "stack"
name = "Post on a plate"
density = 2600
joint = { friction = 0.6 }
blocks = [{ name = "plate", width = 0.6, height = 0.2 }, { name = "post", width = 0.15, height = 0.9 }]

[study.post]
artificial = { count = 5, duration_s = 6, strong_s = 2, rise_s = 1 }
peak = { from = "0.1 g", to = "2 g", steps = 8, spacing = "logarithmic" }
refine = 0
"#;
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = json(&scratch, "study . -o out");
    let runs = rows(&scratch.path().join("out/post/runs.csv"));
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    // by hand: in each scan the plate is known only below the first fall
    let mut scans: BTreeMap<String, Vec<(f64, u8, bool)>> = BTreeMap::new();
    for run in &runs {
        let state: u8 = run["joint_states"].split(' ').next().unwrap().parse().unwrap();
        let row = (
            number(run, "peak_ground_acceleration_m_s2"),
            state,
            run["outcome"] == "fell",
        );
        scans.entry(run["motion"].clone()).or_default().push(row);
    }
    assert!(scans.values().all(|scan| scan.iter().any(|(_, _, fell)| *fell)));
    let mut lower: Vec<f64> = Vec::new();
    for scan in scans.values() {
        let told = scan.iter().take_while(|(_, state, fell)| *state < 3 && !fell);
        lower.push(told.map(|row| row.0).fold(0.0, f64::max));
    }
    lower.sort_by(f64::total_cmp);
    let plate = &answer["joints"][0];
    assert_eq!(plate["name"], "plate on ground");
    let ds3 = &plate["states"][2];
    assert!(ds3["by_peak_acceleration_m_s2"].is_null(), "{ds3}");
    assert!(
        (ds3["median_above_m_s2"].as_f64().unwrap() / lower[2] - 1.0).abs() < 1e-12,
        "{ds3} {lower:?}"
    );
    // the post failed in every scan, the plate in none
    let gave_way: Vec<u64> = (0..2)
        .map(|joint| answer["joints"][joint]["gave_way"].as_u64().unwrap())
        .collect();
    assert_eq!(gave_way, [0, 5]);
}

/// The gate moves in one plane: motions with the same components in that plane have the same effect, whatever their component across.
#[test]
fn holds_the_size_of_a_motion_of_a_frame_is_that_of_the_plane() {
    let scratch = Scratch::with_examples("plane");
    let file = scratch.path().join("examples/heunginjimun_gate/project.toml");
    let mut columns = [
        String::from("time,acceleration (m/s2)\n"),
        String::from("time,acceleration (m/s2)\n"),
    ];
    for i in 0..400 {
        let t = 0.01 * f64::from(i);
        let x = (9.0 * t).sin() * (-0.5 * t).exp();
        columns[0] += &format!("{t:.2},{x:.6}\n");
        columns[1] += &format!("{t:.2},{:.6}\n", 3.0 * x);
    }
    for (name, text) in ["along.csv", "across.csv"].iter().zip(&columns) {
        fs::write(file.parent().unwrap().join(name), text).unwrap();
    }
    let mut text = fs::read_to_string(&file).unwrap();
    text += "\n[motion.plain]\nfiles = { x = \"along.csv\" }\n[motion.with]\nfiles = { x = \"along.csv\", y = \"across.csv\" }\n";
    text += "[study.plane]\ndirection = \"weak\"\nvariants = [\"soft_below\"]\nmotions = [\"plain\", \"with\"]\npeak = [\"0.05 g\"]\nrest_s = 1\nrefine = 0\n";
    fs::write(&file, text).unwrap();
    let answer = scratch.dolmen("study examples/heunginjimun_gate --study plane -o out");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let runs = rows(&scratch.path().join("out/plane/runs.csv"));
    assert_eq!(runs.len(), 2);
    for key in ["peak_drift_m", "scale", "peak_ground_velocity_m_s"] {
        assert_eq!(runs[0][key], runs[1][key], "{key}");
    }
}

/// The score does not cover a pagoda with other friction than the designs: it is refused, and marked if forced.
#[test]
fn refuses_a_score_of_a_pagoda_unlike_the_designs_and_marks_it_where_forced() {
    let scratch = Scratch::with_examples("unlike");
    let file = scratch.path().join("examples/pagodas_of_figure_19/project.toml");
    let whole = fs::read_to_string(&file).unwrap();
    fs::write(&file, whole.replace("friction = 0.6", "friction = 0.5")).unwrap();
    let refused = scratch.dolmen("score examples/pagodas_of_figure_19");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    assert!(
        refused.stderr.contains("friction is 0.5, trained 0.6"),
        "{}",
        refused.stderr
    );
    let forced = scratch.dolmen("score examples/pagodas_of_figure_19 --extrapolate");
    assert!(
        forced.stdout.contains("friction is 0.5, trained 0.6"),
        "{}",
        forced.stdout
    );
    let list = "name,project\nOther,examples/pagodas_of_figure_19\n";
    fs::write(scratch.path().join("list.csv"), list).unwrap();
    let refused = scratch.dolmen("rank list.csv");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    let forced = json(&scratch, "rank list.csv --extrapolate");
    let marks = &forced["structures"][0]["basis"]["unlike_the_designs"];
    assert!(
        marks.to_string().contains("friction is 0.5, trained 0.6"),
        "{forced}"
    );
}

/// Rates need the hazard of every site: if one is missing, the ranking is by capacity, and the answer begins with that.
#[test]
fn holds_a_list_that_lacks_a_hazard_says_that_rates_do_not_order_it() {
    let scratch = Scratch::with_examples("lacking_hazard");
    let ranked = |second: &str| {
        let list = format!(
            "name,storeys,body_height_m,body_slenderness,taper_deg,body_base_height_ratio,zone_factor_g,soil\n\
             First,5,6,3,9,2,0.11,S2\nSecond,3,5,3,8,2,{second}\n"
        );
        fs::write(scratch.path().join("list.csv"), list).unwrap();
        (
            scratch.dolmen("rank list.csv").stdout,
            json(&scratch, "rank list.csv"),
        )
    };
    let (text, found) = ranked(",");
    assert!(
        text.contains("NOT BY RATE: 1 of 2 has no hazard of its site (Second)"),
        "{text}"
    );
    assert_eq!(found["ranked_by"], "capacity");
    assert!(found["not_by_rate"].as_str().unwrap().contains("(Second)"));
    let (text, found) = ranked("0.07,S4");
    assert!(!text.contains("NOT BY RATE"), "{text}");
    assert_eq!(
        (&found["ranked_by"], &found["not_by_rate"]),
        (&"annual_rate".into(), &serde_json::Value::Null)
    );
}

/// A pagoda with severe damage that its model leaves out is scored as undamaged: the score and the ranking say so, and equal ones share a place.
#[test]
fn holds_severe_damage_that_a_score_leaves_out_is_said() {
    let scratch = Scratch::with_examples("severe_damage");
    let whole = "schema = 1\nkind = \"stack\"\nname = \"Five storeys\"\ndensity = 2600\n\
                 joint = { friction = 0.6, normal_stiffness = 1e9, shear_stiffness = 4e8 }\n\
                 pagoda = { storeys = 5, body_height = 6.0, body_slenderness = 3.74, taper = \"8 deg\", body_base_height_ratio = 3 }\n";
    let damaged = "[survey.2026-04-02]\ninspections = [{ part = \"storey 3 eave\", what = \"crack\", severity = \"severe\" }]\n";
    for (name, text) in [("a", whole.to_owned()), ("b", whole.to_owned() + damaged)] {
        let folder = scratch.path().join("fold").join(name);
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("project.toml"), text).unwrap();
    }
    let ranked = scratch.dolmen("rank fold").words();
    for said in [
        "DAMAGE LEFT OUT: inspections found severe damage at b, and their places are those of undamaged",
        "b (damaged) score",
    ] {
        assert!(ranked.contains(said), "{said} is missing in\n{ranked}");
    }
    let found = json(&scratch, "rank fold");
    for (place, damage) in [(0, 0), (1, 1)] {
        let of = &found["structures"][place];
        assert_eq!((&of["place"], &of["place_by_falls"]), (&1.into(), &1.into()));
        assert_eq!(of["severe_damage"].as_array().unwrap().len(), damage);
    }
    let scored = |name: &str| scratch.dolmen(&format!("score fold/{name}/project.toml")).words();
    let said = "DAMAGE LEFT OUT: survey 2026-04-02 found severe damage: crack of “storey 3 eave”.";
    assert!(scored("b").contains(said), "{}", scored("b"));
    assert!(!scored("a").contains("DAMAGE"));
}

/// Text, CSV and figure list unranked structures with the reason; impossible numbers are refused row by row.
#[test]
fn holds_structures_without_a_place_are_in_every_output() {
    let scratch = Scratch::with_examples("without_place");
    let list = "name,storeys,body_height_m,slenderness_angle,body_slenderness,taper_deg,body_base_height_ratio,zone_factor_g,soil\n\
                Good,5,5.6,,3.5,7.2,2.5,0.11,S2\nBoth,5,5.6,0.22,2.9,7.2,2.5,0.11,S2\nTenth,5,5.6,,3.5,7.2,2.5,0.011,S2\n\
                Wide,5,5.6,,3.5,0,2.5,0.11,S2\n";
    fs::write(scratch.path().join("list.csv"), list).unwrap();
    let answer = scratch.dolmen("rank list.csv -o ranked");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let text = &answer.words();
    for said in [
        "1 of 4 structures by the annual rate of DS3",
        "slenderness_angle 0.22 and body_slenderness 2.9 are not of one pagoda",
        "zone_factor_g is 0.011, but must be 0.05 or more, in g: the code has 0.11 (zone I) and 0.07 (zone II)",
        "taper, in degrees, is 0, but the score was trained from 3.1 to 9.9",
    ] {
        assert!(text.contains(said), "{said} is missing in\n{text}");
    }
    let csv = fs::read_to_string(scratch.path().join("ranked/ranking.csv")).unwrap();
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!(rows.len(), 5, "{csv}");
    assert!(rows[1].starts_with("1,") && rows[1].contains("Good"), "{csv}");
    for name in ["Both", "Tenth", "Wide"] {
        let row = rows.iter().find(|row| row.contains(name)).unwrap();
        assert!(row.starts_with(",,,") && row.len() > 60, "{row}");
    }
    let svg = fs::read_to_string(scratch.path().join("ranked/ranking.svg")).unwrap();
    assert!(svg.contains("3 without a place"), "{svg}");
    // nothing can be ranked: each with its reason
    let none = list.replace("Good,5,5.6,,3.5", "Good,5,5.6,0.22,2.9");
    fs::write(scratch.path().join("none.csv"), none).unwrap();
    let refused = scratch.dolmen("rank none.csv");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    let one = scratch.dolmen("rank examples/naju_flagpole");
    assert!(one.stderr.contains("is one project"), "{}", one.stderr);
}

#[test]
fn refuses_curves_of_two_motions_and_hazards_that_do_not_fall() {
    let scratch = Scratch::with_examples("fragility_refused");
    let file = scratch.path().join(PILE);
    let whole = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        whole
            .replace("count = 22", "count = 2")
            .replace("steps = 13", "steps = 2"),
    )
    .unwrap();
    let answer = scratch.dolmen(&format!("study {PILE} -o few"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let said = "No fragility curves: usable scans of 2 motions a combination of inputs, 3 motions or more are needed";
    assert!(answer.words().contains(said), "{}", answer.stdout);
    for (hazard, said) in [
        (
            "{ peaks = [\"0.05 g\", \"0.11 g\"], return_periods_years = [475, 475] }",
            "must be below the one before it: stronger shaking is rarer",
        ),
        (
            "{ peaks = [\"0.11 g\", \"0.05 g\"], return_periods_years = [95, 475] }",
            "above the one before it",
        ),
        (
            "{ peaks = [\"0.11 g\"], return_periods_years = [475] }",
            "one peak alone tells no slope",
        ),
        (
            "{ peaks = [\"0.11 g\", \"0.2 g\"], return_periods_years = [475] }",
            "2 peaks, but 1 return periods",
        ),
        (
            "{ peaks = [\"0.05 g\", \"0.11 g\"], return_periods_years = [95, 475], k = 2 }",
            "k goes with one peak alone",
        ),
        (
            "{ peaks = [\"0.11 g\"], return_periods_years = [475], k = -2 }",
            "k of the hazard is -2",
        ),
    ] {
        fs::write(
            &file,
            whole.replace("soil = \"S2\"", &format!("soil = \"S2\"\nhazard = {hazard}")),
        )
        .unwrap();
        let answer = scratch.dolmen(&format!("check {PILE}"));
        assert_eq!(answer.status, 2, "{hazard}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
    let own = "hazard = { peaks = [\"0.05 g\", \"0.11 g\"], return_periods_years = [95, 475] }";
    fs::write(
        &file,
        whole
            .replace("soil = \"S2\"", &format!("soil = \"S2\"\n{own}"))
            .replace("steps = 13", "steps = 6"),
    )
    .unwrap();
    let answer = scratch.dolmen(&format!("study {PILE} -o own"));
    assert!(
        answer
            .words()
            .contains("by the hazard of the file, its peaks taken as those at the surface (no soil factor is applied), 0.050 g to 0.110 g"),
        "{}",
        answer.stdout
    );
}
