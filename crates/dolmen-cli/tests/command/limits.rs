// SOURCE     KDS 41 17 00, table 8.2-4: 1.0, 1.5, 2.0 %; a frame of one storey, a chain of one link, S_a/ω² by hand.
// GOAL       Storeys are compared with their allowable drift in check and simulate, joints with the edges of their beds; a drift above 10 % is
//            a fall; text, judgement and exit status agree.
// TOLERANCE  none: printed digits, words, exit statuses.

use super::verbs::{Answer, Scratch};
use serde_json::Value;
use std::fs;

const GATE: &str = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { mass = \"t\", force = \"kN\", stiffness = \"kN/mm\" }\naxial = \"storey\"\n\
    storeys = [{ name = \"lower\", mass = 100, height = 4.0, axial_force = 981 }]\n";
const SITE: &str =
    "[site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 2400\nsoil = \"S4\"\n";

fn limits(grade: &str) -> String {
    format!("[limits]\ncode = \"KDS 41 17 00\"\nimportance = \"{grade}\"\n")
}

fn gate(stiffness: f64, more: &str) -> String {
    format!("{GATE}{more}[direction.weak]\nstiffness = [{stiffness}]\ndamping_ratio = 0.02\n")
}

fn run(scratch: &Scratch, words: &str, text: &str) -> Answer {
    fs::write(scratch.path().join("p.toml"), text).unwrap();
    scratch.dolmen(words)
}

#[test]
fn exact_a_storey_is_held_against_its_allowable_drift_by_the_spectrum() {
    let scratch = Scratch::new("drift-limit");
    // k 3 kN/mm less 981/4 kN/m; ω² 27.55, T 1.197 s; S_a = 0.748 g · 0.57647/1.197 at 5 %, times (6.42/(1.42 + 2))^0.48 at its own 2 %
    let drift = {
        let omega2: f64 = (3e6 - 981e3 / 4.0) / 1e5;
        let period = std::f64::consts::TAU / omega2.sqrt();
        let damped = (6.42_f64 / 3.42).powf(0.48);
        damped * 0.748 * 9.80665 * 0.576_470_588 / period / omega2 / 4.0
    };
    for (grade, allowed, word, status) in [
        ("special", 0.010, "below demand", 1),
        ("II", 0.020, "below demand", 1),
    ] {
        let text = gate(3.0, &format!("{SITE}{}", limits(grade)));
        let answer = run(&scratch, "check p.toml --json", &text);
        assert_eq!(answer.status, status, "{}", answer.stderr);
        let json: Value = serde_json::from_str(&answer.stdout).unwrap();
        let version = &json["judgement"]["versions"][0]["earthquake"];
        assert_eq!(version["word"], word);
        assert_eq!(version["reasons"][0]["decided_by"], "drift");
        assert_eq!(version["reasons"][0]["part"], "lower");
        let part = &json["state"]["demand"]["limits"]["parts"][0];
        let number = |key: &str| part[key].as_f64().unwrap();
        assert!(
            (number("demand") / drift - 1.0).abs() < 1e-6,
            "{} {drift}",
            number("demand")
        );
        assert_eq!(number("capacity"), allowed);
    }
    let text = gate(3.0, &format!("{SITE}{}", limits("II")));
    let answer = run(&scratch, "check p.toml", &text);
    for said in [
        "Earthquake KDS 17 10 00, 2400 y: below demand (capacity/demand 0.",
        "storey ‘lower’ (direction weak) drifts",
        "2.00 % is allowed (KDS 41 17 00, II)",
        "Drift of each storey against what is allowed by KDS 41 17 00, II.",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    // stiff enough for the strictest grade
    let text = gate(60.0, &format!("{SITE}{}", limits("special")));
    let answer = run(&scratch, "check p.toml", &text);
    assert_eq!(answer.status, 0, "{}", answer.stdout);
    assert!(
        answer.words().contains("above demand (capacity/demand "),
        "{}",
        answer.stdout
    );
    // without a limit there is no decision, and the answer says which key to add
    let answer = run(&scratch, "check p.toml", &gate(60.0, SITE));
    assert_eq!(answer.status, 0, "{}", answer.stdout);
    assert!(
        answer.words().contains("not decided (no limit is known)")
            && answer.words().contains("Write [limits]"),
        "{}",
        answer.stdout
    );
    // beyond ten per cent it falls, with or without a limit
    let low = gate(0.4, SITE).replace("height = 4.0", "height = 2.8");
    let answer = run(&scratch, "check p.toml", &low);
    assert_eq!(answer.status, 1, "{}{}", answer.stdout, answer.stderr);
    assert!(answer.words().contains("it falls"), "{}", answer.stdout);
}

/// A pole of one link of 1 t and 3 m on a bed of 0.6 m.
fn pole(joint: &str, more: &str) -> String {
    format!(
        "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = {{ mass = \"t\", force = \"kN\", stiffness = \"kN*m/rad\" }}\n\
         gravity = 9.8\nlinks = [{{ name = \"shaft\", mass = 1.0, length = 3.0, centroid = 1.5, inertia = 750 }}]\n\
         joints = [{{ stiffness = 200{joint} }}]\ncap = \"included\"\ndamping_ratio = 0.05\n{more}{SITE}"
    )
}

#[test]
fn exact_a_tilt_and_loads_take_from_what_a_bed_passes_before_the_shaking() {
    let scratch = Scratch::new("bed-left");
    let part = |text: &str| -> (Value, Answer) {
        let answer = run(&scratch, "check p.toml --json", text);
        let json: Value = serde_json::from_str(&answer.stdout)
            .unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr));
        (json["state"]["demand"].clone(), answer)
    };
    let bed = ", bed_width = 0.6";
    let limit = 0.5 * 9800.0 * 0.6;
    // K = k − m g l = 185.3 kN m/rad: a tilt t makes k (m g l t)/K, a force at the top k F L/K
    let tilted = "[survey.2024-01-01]\ntilt = { x = \"1/60\", y = \"1/80\" }\n";
    let taken = 200e3 / 185.3e3 * 14.7e3 * (1.0 / 60.0_f64.powi(2) + 1.0 / 80.0_f64.powi(2)).sqrt();
    let (demand, _) = part(&pole(bed, tilted));
    let of = demand["limits"]["parts"][0].clone();
    let number = |of: &Value, key: &str| of[key].as_f64().unwrap();
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    close(number(&of, "taken"), taken);
    // vertical shaking reduces the weight on the bed
    let left = |demand: &Value| {
        let peak = demand["peak_ground_acceleration_m_s2"].as_f64().unwrap();
        1.0 - 0.77 * peak / 9.8
    };
    close(number(&of, "capacity"), left(&demand) * limit - taken);
    // inertia about the joint 1000 · 1.5² + 750 = 3000 kg m²
    let omega2: f64 = 185.3e3 / 3000.0;
    close(
        number(&demand["spectral"][0], "period_s"),
        std::f64::consts::TAU / omega2.sqrt(),
    );
    let read = number(&demand["spectral"][0], "acceleration_m_s2");
    close(number(&of, "demand"), 200e3 * 1500.0 * read / 185.3e3);
    // loads have mass: 1 kN at the top
    let loads = "loads = [{ name = \"sign\", at = \"shaft\", height = 3.0, weight = 1.0, force = 0.2 }]\n";
    let (demand, _) = part(&pole(bed, loads));
    let (gravity, inertia): (f64, f64) = (14.7e3 + 1e3 * 3.0, 3000.0 + 1e3 / 9.8 * 9.0);
    let stiffness = 200e3 - gravity;
    close(
        number(&demand["spectral"][0], "period_s"),
        std::f64::consts::TAU / (stiffness / inertia).sqrt(),
    );
    let of = demand["limits"]["parts"][0].clone();
    close(number(&of, "taken"), 200e3 / stiffness * 200.0 * 3.0);
    let limit = 0.5 * 10.8e3 * 0.6;
    close(
        number(&of, "capacity"),
        left(&demand) * limit - number(&of, "taken"),
    );
}

#[test]
fn holds_what_is_not_known_of_a_chain_or_direction_is_not_decided_by_the_rest() {
    let scratch = Scratch::new("not-known");
    let said = |text: &str, words: &str| {
        let answer = run(&scratch, "check p.toml", text);
        assert!(
            answer.words().contains(words),
            "{words}: {}{}",
            answer.stdout,
            answer.stderr
        );
    };
    said(&pole("", ""), "not decided (the bed below ‘shaft’ is not known)");
    let unknown = pole("", "").replace("joints = [{ stiffness = 200 }]", "joints = \"unknown\"");
    said(&unknown, "not decided (the stiffness is not known)");
    let strong = format!(
        "{}{}[direction.strong]\nstiffness = \"unknown\"\n",
        gate(60.0, ""),
        SITE
    );
    let strong = strong.replace("[direction.weak]", &format!("{}[direction.weak]", limits("I")));
    said(
        &strong,
        "not decided (the stiffness of direction strong is not known)",
    );
    said(
        &strong,
        "Direction strong is not compared with the demand of the site",
    );
    // its slipping joints are less stiff than the weight requires: 981/4 kN/m
    let slipping = format!(
        "{}[direction.weak.friction]\nlaw = \"jenkins\"\ncoefficient = 0.1\nslipping_stiffness = [0.2]\n",
        gate(60.0, &format!("{SITE}{}", limits("I")))
    );
    said(&slipping, "falls under its own weight while its joints slip");
    said(&slipping, "not decided (it does not stand without shaking)");
}

#[test]
fn holds_a_simulated_storey_is_held_against_its_allowable_drift() {
    let scratch = Scratch::new("drift-run");
    let moved = "simulate p.toml --motion el-centro-1940-ns --keep-first 12";
    let stiff = run(&scratch, moved, &gate(60.0, &limits("I")));
    assert_eq!(stiff.status, 0, "{}{}", stiff.stdout, stiff.stderr);
    assert!(
        stiff
            .words()
            .contains("VERDICT Earthquake el-centro-1940-ns: above demand"),
        "{}",
        stiff.stdout
    );
    let soft = run(&scratch, moved, &gate(3.0, &limits("special")));
    assert_eq!(soft.status, 1, "{}{}", soft.stdout, soft.stderr);
    assert!(soft.words().contains("1.00 % is allowed"), "{}", soft.stdout);
    let without = run(&scratch, moved, &gate(3.0, ""));
    assert_eq!(without.status, 0, "{}{}", without.stdout, without.stderr);
    assert!(without.words().contains("not decided"), "{}", without.stdout);
}

#[test]
fn holds_a_building_that_drifts_beyond_ten_per_cent_falls() {
    let scratch = Scratch::with_examples("drift-building");
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replace("height = 30", "height = 10")).unwrap();
    let answer = scratch.dolmen("simulate examples/twisting_floor --motion el-centro --peak 6g");
    assert_eq!(answer.status, 1, "{}{}", answer.stdout, answer.stderr);
    assert!(answer.words().contains("it falls"), "{}", answer.stdout);
}

#[test]
fn holds_the_joints_of_a_chain_are_held_against_the_edges_of_their_beds() {
    let scratch = Scratch::new("bed-edge");
    let pole = |bed: f64| {
        format!(
            "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = {{ force = \"kN\", stiffness = \"kN*m/rad\" }}\n\
             links = [{{ name = \"pole\", weight = 20, length = 3.0, centroid = 1.5, breadth = {bed}, bed_width = {bed} }}]\n\
             joints = [{{ stiffness = 2000 }}]\n{SITE}"
        )
    };
    let narrow = run(&scratch, "check p.toml", &pole(0.5));
    assert_eq!(narrow.status, 1, "{}{}", narrow.stdout, narrow.stderr);
    assert!(
        narrow.words().contains("the joint below ‘pole’ has a moment of")
            && narrow.words().contains("its bed stands on its edge at 3.85 kN·m"),
        "{}",
        narrow.stdout
    );
    let wide = run(&scratch, "check p.toml", &pole(3.9));
    assert_eq!(wide.status, 0, "{}{}", wide.stdout, wide.stderr);
}

#[test]
fn refuses_limits_that_cannot_be() {
    let scratch = Scratch::new("limits-refused");
    for (limits, said) in [
        (
            "[limits]\ncode = \"KDS 41 17 00\"\n",
            "limits has no \"importance\"",
        ),
        (
            "[limits]\ncode = \"KDS 41 17 00\"\nimportance = \"IV\"\n",
            "this class is of another code",
        ),
        ("[limits]\nstorey_drift = 1.5\n", "did you mean per cent"),
        (
            "[limits]\nstorey_drift = \"1 %\"\ncode = \"EN 1998-1\"\n",
            "both code and storey_drift",
        ),
        ("[limits]\n", "neither code nor storey_drift"),
        (
            "[limits]\ncode = \"EN 1998-1\"\nimportance = \"II\"\nnon_structural = \"soft\"\n",
            "is not known",
        ),
    ] {
        let answer = run(&scratch, "check p.toml", &gate(3.0, limits));
        assert_eq!(answer.status, 2, "{limits}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{limits}: {}", answer.stderr);
    }
    let stack = "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = 2600\njoint = { friction = 0.7 }\n\
        blocks = [{ name = \"a\", width = 1, height = 1 }]\n[limits]\nstorey_drift = \"1 %\"\n";
    let answer = run(&scratch, "check p.toml", stack);
    assert_eq!(answer.status, 2);
    assert!(answer.stderr.contains("has no meaning here"), "{}", answer.stderr);
}
