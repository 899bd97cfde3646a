// SOURCE     Poles, pillars and a floor with hand-checkable answers; closed forms for some.
// GOAL       Everything in a file that matters enters the answer, and the answer names what does not: studies older than a survey, massless loads,
//            moving supports, motions from the same record, wind with too long steps or too short a duration.
// TOLERANCE  words as stated; half a per cent of the end of an interval, which the search finds to a third of a per cent.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

fn with(name: &str, text: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    scratch
}

fn pole(tilt: &str, more: &str) -> String {
    format!(
        "schema = 1\nkind = \"chain\"\nname = \"pole\"\nevidence = \"measured\"\n\
         units = {{ length = \"m\", force = \"kN\", stiffness = \"kN*m/rad\" }}\n\
         links = [{{ name = \"shaft\", weight = 30.0, length = 3.0, centroid = 1.4, breadth = 0.7 }}]\n\
         joints = [{{ stiffness = 300, bed_width = 0.5 }}]\ndamping_ratio = 0.03\n{more}\
         [survey.2020-01-01]\ntilt = {{ x = \"{tilt}\" }}\n\
         [motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\n\
         [study.s]\nmotions = [\"ec\"]\npeak = {{ from = \"0.2 g\", to = \"0.8 g\", steps = 4 }}\n"
    )
}

#[test]
fn refuses_runs_of_a_pole_that_leaned_otherwise() {
    let scratch = with("stale-lean", &pole("1/200", ""));
    let capacity = || -> f64 {
        let json = fs::read_to_string(scratch.path().join("out/s/study.json")).unwrap();
        let json: Value = serde_json::from_str(&json).unwrap();
        json["levels"][0]["first_fall_least_m_s2"].as_f64().unwrap()
    };
    let first = scratch.dolmen("study project.toml -o out");
    assert_eq!(first.status, 0, "{}", first.stderr);
    let upright = capacity();
    fs::write(scratch.path().join("project.toml"), pole("1/20", "")).unwrap();
    let stale = scratch.dolmen("study project.toml -o out");
    assert_eq!(stale.status, 2, "{}", stale.stdout);
    assert!(stale.stderr.contains("the structure as read"), "{}", stale.stderr);
    let fresh = scratch.dolmen("study project.toml -o out --restart");
    assert_eq!(fresh.status, 0, "{}", fresh.stderr);
    assert!(capacity() < 0.8 * upright, "{} {upright}", capacity());
    // a comment or a measured frequency changes no run
    let more = pole("1/20", "# a remark\n").replace("tilt =", "frequencies.x = [0.9]\ntilt =");
    fs::write(scratch.path().join("project.toml"), more).unwrap();
    let kept = scratch.dolmen("study project.toml -o out");
    assert_eq!(kept.status, 0, "{}", kept.stderr);
    assert!(kept.stderr.contains("kept from before") || kept.stdout.contains("kept from before"));
}

#[test]
fn holds_a_study_names_what_its_runs_leave_out_and_hold() {
    let more = "loads = [{ name = \"banner\", at = \"shaft\", force = 0.1 }, { name = \"lamp\", at = \"shaft\", weight = 0.5 }]\n\
                wind = { speed = \"20 m/s\", means = \"gust\", force_coefficient = 1.0 }\n";
    let scratch = with("study-names", &pole("1/200", more));
    let answer = scratch.dolmen("study project.toml -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let words = answer.words();
    for said in [
        "the wind of the file does not act in the runs",
        "forces and moments of static loads do not act in the runs",
        "the runs start leaning as survey 2020-01-01 found it (x 1/200)",
        "what hangs on it as static loads moves with it",
    ] {
        assert!(words.contains(said), "{said}: {words}");
    }
    let json = fs::read_to_string(scratch.path().join("out/s/study.json")).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["left_out_of_runs"].as_array().map(Vec::len), Some(2));
    let korean = scratch.dolmen("study project.toml -o ko --language ko");
    assert!(
        korean.words().contains("미반영: 해석에 파일의 바람을"),
        "{}",
        korean.stdout
    );
}

fn pillar(more: &str) -> String {
    format!(
        "schema = 1\nkind = \"stack\"\nname = \"pillar\"\nevidence = \"measured\"\ndensity = 2600\n\
         joint = {{ friction = 0.7 }}\nblocks = [{{ name = \"block\", width = 0.4, height = 1.4 }}]\n{more}\
         [motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\n\
         [study.s]\nmotions = [\"ec\"]\npeak = [\"0.3 g\", \"1.2 g\"]\nlaw = \"rigid\"\n"
    )
}

#[test]
fn refuses_capacities_of_stones_that_massless_loads_press_or_whose_supports_move() {
    for (name, more, why) in [
        (
            "pressed",
            "loads = [{ name = \"roof\", at = \"block\", force = [0, 0, \"-50 kN\"] }]\n",
            "static loads without mass press its stones together",
        ),
        (
            "moved",
            "support_movement = [{ on = \"block\", x = \"20 mm\" }]\n",
            "its supports move before the ground shakes",
        ),
    ] {
        let scratch = with(&format!("no-capacity-{name}"), &pillar(more));
        let answer = scratch.dolmen("study project.toml -o out");
        let said = answer.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains(why), "{name}: {said} {}", answer.stdout);
        assert!(!answer.words().contains("None of"), "{name}: {}", answer.stdout);
        assert_eq!(answer.status, 2, "{name}: {said}");
    }
}

#[test]
fn refuses_the_score_of_a_pagoda_with_loads_or_moving_supports() {
    let pagoda = "schema = 1\nkind = \"stack\"\nname = \"Pagoda\"\ndensity = 2600\n\
        joint = { friction = 0.6, normal_stiffness = 1e9, shear_stiffness = 4e8 }\n\
        pagoda = { storeys = 5, body_height = 6.0, body_slenderness = 3.74, taper = \"8 deg\", body_base_height_ratio = 3 }\n";
    let plain = with("score-plain", pagoda);
    assert_eq!(plain.briefly("score project.toml").status, 0);
    let load = "loads = [{ name = \"roof\", at = \"upper base\", force = [0, 0, \"-80 kN\"] }]\n";
    let movement = "support_movement = [{ on = \"lower base\", z = \"-5 mm\" }]\n";
    for (name, more, why) in [
        ("score-loads", load, "static loads act on it, trained without"),
        (
            "score-moved",
            movement,
            "its supports move, trained on supports at rest",
        ),
    ] {
        let scratch = with(name, &format!("{pagoda}{more}"));
        let answer = scratch.briefly("score project.toml");
        let said = answer.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            answer.status == 2 && said.contains(why),
            "{said} {}",
            answer.stdout
        );
    }
}

/// Oscillations of five periods from a seed, m/s².
fn shaking(seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut draw = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let swings = [0.2, 0.4, 0.7, 1.1, 1.8]
        .map(|period_s| [period_s * (0.7 + 0.6 * draw()), 0.3 + draw(), 6.3 * draw()]);
    let at = |k: usize| {
        let t = 0.01 * k as f64;
        let envelope = (t / 2.0).min(1.0) * (-(t - 2.0).max(0.0) / 2.0).exp();
        let each = swings
            .iter()
            .map(|[period_s, weight, phase]| weight * (std::f64::consts::TAU * t / period_s + phase).sin());
        envelope * each.sum::<f64>()
    };
    (0..1000).map(at).collect()
}

fn write(scratch: &Scratch, name: &str, samples: &[f64]) {
    let mut text = "time_s,acceleration_m_s2\n".to_owned();
    for (k, a) in samples.iter().enumerate() {
        text += &format!("{:.2},{a}\n", 0.01 * k as f64);
    }
    fs::write(scratch.path().join(name), text).unwrap();
}

#[test]
fn holds_copies_of_a_record_count_as_one_in_a_study_and_in_a_suite() {
    let motions = "[motion.a]\nfiles = { x = \"a.csv\" }\n[motion.b]\nfiles = { x = \"b.csv\" }\n[motion.c]\nfiles = { x = \"c.csv\" }\n\
                   [motion.other]\nfiles = { x = \"other.csv\" }\n";
    let text = pillar("").replace("[study.s]", &format!("{motions}[study.s]"));
    let text = text.replace("motions = [\"ec\"]", "motions = [\"a\", \"b\", \"c\", \"other\"]");
    let scratch = with("copies", &text);
    let a = shaking(3);
    let turned: Vec<f64> = a.iter().map(|x| -0.8 * x).collect();
    write(&scratch, "a.csv", &a);
    write(&scratch, "b.csv", &turned);
    write(&scratch, "c.csv", &a[2..]);
    write(&scratch, "other.csv", &shaking(4));
    let answer = scratch.dolmen("study project.toml -o out");
    let words = answer.words();
    assert!(
        words.contains("b is a again") && words.contains("c is a again"),
        "{words}"
    );
    assert!(!words.contains("other is"), "{words}");
    let json = fs::read_to_string(scratch.path().join("out/s/study.json")).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["copies"].as_array().map(Vec::len), Some(2));
    let states = json["fragility"][0]["states"].as_array().unwrap();
    let curve = |state: &Value| {
        state
            .pointer("/by_peak_acceleration_m_s2/theta")
            .is_some_and(Value::is_number)
    };
    assert!(!states.iter().any(curve), "two records give no curve: {states:?}");

    let folder = scratch.path().join("records");
    fs::create_dir_all(&folder).unwrap();
    for name in ["a.csv", "b.csv", "c.csv", "other.csv"] {
        fs::rename(scratch.path().join(name), folder.join(name)).unwrap();
    }
    let suite = scratch.dolmen(
        "motion --suite 3 --from records --unit m/s2 --zone I --years 2400 --site S4 --factors 0.05,20",
    );
    let said = suite.words() + &suite.stderr;
    assert!(said.contains("b.csv is") || suite.status == 2, "{said}");
    let suite = scratch.dolmen(
        "motion --suite 2 --from records --unit m/s2 --zone I --years 2400 --site S4 --factors 0.05,20",
    );
    let said = suite.words();
    assert!(
        said.contains("b.csv is") && said.contains("c.csv is"),
        "{said} {}",
        suite.stderr
    );
}

#[test]
fn exact_bounds_of_stiffness_are_those_of_a_frequency_as_it_was_stated_in_hz() {
    let scratch = with(
        "bounds-in-hz",
        "schema = 1\nkind = \"chain\"\nname = \"lamp post\"\nevidence = \"measured\"\n\
         units = { length = \"m\", force = \"kN\", stiffness = \"kN*m/rad\" }\n\
         links = [{ name = \"shaft\", weight = 10.0, length = 3.0, centroid = 1.5, breadth = 0.4, bed_width = 0.4 }]\n\
         joints = \"unknown\"\n[survey.2020-01-01]\nfrequencies.x = [{ value = 1.0, sd = 0.35 }]\n",
    );
    let answer = scratch.briefly("identify project.toml --json");
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let mut found = None;
    look_for(&json, "stiffness_bounds", &mut found);
    let bounds = found.unwrap()[0].clone();
    // k = (2πf)² I + W c, I of a box about its foot, f 1.96 standard deviations off
    let mass = 10_000.0 / 9.80665;
    let inertia = mass * ((3.0_f64.powi(2) + 0.4_f64.powi(2)) / 12.0 + 1.5_f64.powi(2));
    let expected = |sign: f64| {
        let hz = 1.0 + sign * 1.959_964 * 0.35;
        (std::f64::consts::TAU * hz).powi(2) * inertia + 10_000.0 * 1.5
    };
    for (key, sign) in [("lower", -1.0), ("upper", 1.0)] {
        let (own, exact) = (bounds[key].as_f64().unwrap(), expected(sign));
        assert!((own / exact - 1.0).abs() < 0.005, "{key}: {own} {exact}");
    }
}

fn look_for(value: &Value, key: &str, found: &mut Option<Value>) {
    match value {
        Value::Object(all) => {
            for (name, own) in all {
                match name == key && found.is_none() {
                    true => *found = Some(own.clone()),
                    false => look_for(own, key, found),
                }
            }
        }
        Value::Array(all) => all.iter().for_each(|own| look_for(own, key, found)),
        _ => {}
    }
}

#[test]
fn holds_a_tilt_beyond_its_drift_and_friction_of_no_weight_are_said() {
    let gate = "schema = 1\nkind = \"frame\"\nname = \"gate\"\nevidence = \"measured\"\n\
                units = { length = \"m\", force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }\n";
    let tilted = format!(
        "{gate}storeys = [{{ mass = 60, height = 4.0, columns = {{ count = 4, width = 0.35 }} }}]\n\
         [direction.x]\nstiffness = [2.0]\n[limits]\nstorey_drift = \"1/30\"\n\
         [survey.2024-01-01]\ntilt = {{ x = \"1/12\", y = \"1/20\" }}\n"
    );
    let answer = with("tilt-beyond-drift", &tilted).briefly("check project.toml --full");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    let words = answer.words();
    assert!(words.contains("Own weight: unstable"), "{words}");
    assert!(
        words.contains("is already beyond the storey drift of 1/30"),
        "{words}"
    );
    assert!(
        words.contains("a storey leans by as much as counts as fallen"),
        "{words}"
    );
    // the words for data that no model uses stay the same
    let undated = tilted.replace("2024-01-01", "first");
    let words = with("tilt-undated", &undated)
        .briefly("check project.toml --full")
        .words();
    assert!(
        words.contains("at which its free-standing columns alone fall"),
        "{words}"
    );
    let straight = tilted.replace("1/12", "1/100").replace("1/20", "1/200");
    let words = with("tilt-within-drift", &straight)
        .briefly("check project.toml --full")
        .words();
    assert!(!words.contains("beyond the storey drift"), "{words}");

    let light = format!(
        "{gate}axial = \"storey\"\nstoreys = [{{ mass = 60, height = 4.0, axial_force = 0 }}]\n\
         [direction.x]\nstiffness = [2.0]\nfriction = {{ coefficient = 0.3 }}\n"
    );
    let scratch = with("friction-of-no-weight", &light);
    let words = scratch.briefly("check project.toml").words();
    assert!(
        words.contains("so is the friction that direction.x.friction.coefficient takes from it"),
        "{words}"
    );
    let heavy = with(
        "friction-of-weight",
        &light.replace("axial_force = 0", "axial_force = 588"),
    );
    assert!(
        !heavy
            .briefly("check project.toml")
            .words()
            .contains("takes from it")
    );
}
