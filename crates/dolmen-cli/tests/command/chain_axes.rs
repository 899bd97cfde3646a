// SOURCE     Statics and dynamics of one and two rigid links on oblong beds, closed forms written out here.
// GOAL       A chain whose beds have a depth is judged along (x), across (y) and between, in every answer; without values across nothing changes.
//
//        N·0.35 ┌───────┐          λ = k/(m g l),  ω² = (k − m g l)/(m (l² + (b² + L²)/12))
//               │   ·   │ N·0.15   tilt at which it stands on its edge: N b/2 / (m g l k/(k − m g l))
//               └───────┘
//
// PARAMETERS a stone of 100 kN, 6 m; beds 0.7 m by 0.3 m.
// TOLERANCE  1e-9 of closed forms; the same bits where two runs are the same run.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const N: f64 = 100e3;
const G: f64 = 9.80665;
const LENGTH: f64 = 6.0;
/// m g l of the stone.
const MGL: f64 = N * 0.5 * LENGTH;
const K: f64 = 9e6;

fn stone(link: &str, joint: &str, rest: &str) -> String {
    format!(
        "schema = 1\nkind = \"chain\"\nname = \"Pole\"\n{rest}\n\
         links = [{{ name = \"pole\", weight = \"100 kN\", length = 6, centroid = 3{link} }}]\n\
         joints = [{{ stiffness = \"9 MN*m/rad\"{joint} }}]\n"
    )
}

const OBLONG: &str = ", bed_width = 0.7, bed_depth = 0.3";

fn with_survey(text: &str, survey: &str) -> String {
    format!("{text}[survey.2026-01-01]\n{survey}\n")
}

fn scratch(name: &str, text: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    scratch
}

fn json(name: &str, text: &str, words: &str) -> Value {
    let answer = scratch(name, text).dolmen(&format!("{words} --json"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}{}", answer.stdout, answer.stderr))
}

fn number(value: &Value, path: &str) -> f64 {
    value
        .pointer(path)
        .and_then(Value::as_f64)
        .unwrap_or_else(|| panic!("{path} in {value}"))
}

fn is_near(found: f64, expected: f64) -> bool {
    let near = (found / expected - 1.0).abs() < 1e-9;
    assert!(near, "{found} {expected}");
    near
}

#[test]
fn exact_a_tilt_across_is_held_against_the_depth_of_the_bed() {
    let across = ", stiffness_across = \"9 MN*m/rad\"";
    let text = |tilt: &str| {
        with_survey(
            &stone("", &format!("{OBLONG}{across}"), ""),
            &format!("tilt = {{ {tilt} }}"),
        )
    };
    let edge = |half: f64| N * half / (MGL * K / (K - MGL));
    for (tilt, expected, status, headline) in [
        ("x = \"1/15\"", vec![("x", 0.35)], 0, "Own weight: stable"),
        (
            "y = \"1/15\"",
            vec![("y", 0.15)],
            1,
            "Own weight: unstable in direction y",
        ),
        // towards 45° the resultant leaves the long side first
        (
            "x = \"1/30\", y = \"1/30\"",
            vec![("x", 0.35), ("y", 0.15), ("x+y", 0.15 * 2.0_f64.sqrt())],
            0,
            "in direction y",
        ),
    ] {
        let value = json("axes-tilt", &text(tilt), "check project.toml");
        let tilts = value["state"]["tilts"]
            .as_array()
            .unwrap_or_else(|| panic!("{value}"));
        for (direction, half) in expected {
            let of = tilts.iter().find(|of| of["direction"] == direction).unwrap();
            is_near(number(of, "/uplift_tilt"), edge(half));
        }
        let answer = scratch("axes-tilt-said", &text(tilt)).briefly("check project.toml");
        assert_eq!(answer.status, status, "{}", answer.stdout);
        assert!(answer.words().contains(headline), "{}", answer.words());
    }
}

#[test]
fn exact_load_factor_and_frequency_across_are_their_own() {
    let (breadth, depth) = (0.8, 0.4);
    let link = format!(", breadth = {breadth}, depth = {depth}");
    let of = |joint: &str| json("axes-modes", &stone(&link, joint, ""), "check project.toml");
    let hz = |k: f64, side: f64| {
        let inertia = N / G * (9.0 + (side * side + LENGTH * LENGTH) / 12.0);
        ((k - MGL) / inertia).sqrt() / std::f64::consts::TAU
    };
    let chain = "/state/check/chain";
    for (joint, k) in [
        (", stiffness_across = \"3 MN*m/rad\"", 3e6),
        // no value given: springs under the whole bed
        (OBLONG, K * (0.3_f64 / 0.7).powi(2)),
        // and never stiffer than along
        (", bed_width = 0.3, bed_depth = 0.7", K),
    ] {
        let value = of(joint);
        is_near(number(&value, &format!("{chain}/stability/load_factor")), K / MGL);
        is_near(
            number(&value, &format!("{chain}/modes/0/frequency_hz")),
            hz(K, breadth),
        );
        is_near(
            number(&value, &format!("{chain}/across/stability/load_factor")),
            k / MGL,
        );
        is_near(
            number(&value, &format!("{chain}/across/modes/0/frequency_hz")),
            hz(k, depth),
        );
        let taken = value.pointer(&format!("{chain}/across/taken")).unwrap();
        assert_eq!(
            taken.as_array().unwrap().is_empty(),
            joint.contains("stiffness_across")
        );
    }
    let said = scratch("axes-taken", &stone(&link, OBLONG, ""))
        .briefly("check project.toml")
        .words();
    assert!(
        said.contains("How stiff joints 1 are across is not given, and was assumed"),
        "{said}"
    );
    // the softer direction decides, and the headline names it
    let weak = stone("", ", stiffness_across = \"280 kN*m/rad\"", "");
    let answer = scratch("axes-weak", &weak).briefly("check project.toml");
    assert_eq!(answer.status, 1);
    assert!(
        answer.words().contains("Own weight: unstable in direction y"),
        "{}",
        answer.words()
    );
}

#[test]
fn holds_two_links_across_have_the_frequencies_of_their_own_two_by_two() {
    let text = "schema = 1\nkind = \"chain\"\nname = \"Two\"\n\
        links = [{ mass = 4000, length = 3, centroid = 1.4, inertia = 2500, inertia_across = 3100 },\n\
                 { mass = 1500, length = 2, centroid = 0.9, inertia = 500, inertia_across = 620 }]\n\
        joints = [{ stiffness = \"2 MN*m/rad\", stiffness_across = \"1.1 MN*m/rad\" },\n\
                  { stiffness = \"500 kN*m/rad\", stiffness_across = \"210 kN*m/rad\" }]\n";
    let value = json("axes-two", text, "check project.toml");
    for (path, inertia, k) in [
        ("/state/check/chain/modes", [2500.0, 500.0], [2e6, 5e5]),
        ("/state/check/chain/across/modes", [3100.0, 620.0], [1.1e6, 2.1e5]),
    ] {
        let m = [
            4000.0 * 1.4 * 1.4 + 9.0 * 1500.0 + inertia[0],
            3.0 * 1500.0 * 0.9,
            1500.0 * 0.81 + inertia[1],
        ];
        let g = [G * (4000.0 * 1.4 + 3.0 * 1500.0), G * 1500.0 * 0.9];
        let s = [k[0] + k[1] - g[0], -k[1], k[1] - g[1]];
        // det(K − ω² M) = 0
        let a = m[0] * m[2] - m[1] * m[1];
        let b = s[0] * m[2] + s[2] * m[0] - 2.0 * s[1] * m[1];
        let c = s[0] * s[2] - s[1] * s[1];
        let root = (b * b - 4.0 * a * c).sqrt();
        for (i, square) in [(b - root) / (2.0 * a), (b + root) / (2.0 * a)]
            .into_iter()
            .enumerate()
        {
            let hz = square.sqrt() / std::f64::consts::TAU;
            is_near(number(&value, &format!("{path}/{i}/frequency_hz")), hz);
        }
    }
}

#[test]
fn exact_wind_is_tried_from_every_side() {
    // q = 1 kPa, C_f = 1: along on the depth of 0.4 m, across on the breadth of 0.8 m, both over 6 m at 3 m
    let joint = format!("{OBLONG}, stiffness_across = \"6 MN*m/rad\"");
    let wind = "wind = { pressure = 1000, means = \"gust\", force_coefficient = 1 }";
    let text = stone(", breadth = 0.8, depth = 0.4", &joint, wind);
    let value = json("axes-wind", &text, "check project.toml");
    let combination = "/state/loads/combinations/0";
    let moment = |side: f64, k: f64| 1000.0 * side * LENGTH * 3.0 * k / (k - MGL);
    let factors = [N * 0.35 / moment(0.4, K), N * 0.15 / moment(0.8, 6e6)];
    assert!(factors[1] < factors[0]);
    is_near(number(&value, &format!("{combination}/load_factor")), factors[1]);
    is_near(
        number(&value, &format!("{combination}/across/wind_towards_deg")),
        90.0,
    );
    is_near(
        number(&value, &format!("{combination}/across/under/joints/0/moment_n_m")),
        moment(0.8, 6e6),
    );
    // a force along does not reduce the resistance of a bed that does not crush to wind across; a tilt across does
    let pushed = text.replace(
        "joints",
        "loads = [{ name = \"sign\", at = \"pole\", force = [\"1 kN\", \"0.5 kN\"] }]\njoints",
    );
    let value = json("axes-pushed", &pushed, "check project.toml");
    let of_push = 500.0 * LENGTH * 6e6 / (6e6 - MGL);
    is_near(
        number(&value, &format!("{combination}/load_factor")),
        N * 0.15 / (moment(0.8, 6e6) + of_push),
    );
    let tilted = with_survey(&text, "tilt = { y = \"1/100\" }");
    let value = json("axes-wind-tilt", &tilted, "check project.toml");
    let of_tilt = MGL * 0.01 * 6e6 / (6e6 - MGL);
    is_near(
        number(&value, &format!("{combination}/load_factor")),
        (N * 0.15 - of_tilt) / moment(0.8, 6e6),
    );
    let said = scratch("axes-wind-said", &text)
        .briefly("check project.toml")
        .words();
    assert!(said.contains("The worst wind blows towards +y"), "{said}");
}

#[test]
fn exact_a_site_asks_of_each_direction_by_its_own_period() {
    let site =
        "[site]\ncode = \"table\"\nperiods_s = [0.0, 10.0]\naccelerations = [3.0, 3.0]\nunit = \"m/s2\"\n";
    let joint = format!("{OBLONG}, stiffness_across = \"6 MN*m/rad\"");
    let text = stone("", &joint, "damping_ratio = 0.05") + site;
    let value = json("axes-site", &text, "check project.toml");
    let parts = value
        .pointer("/state/demand/limits/parts")
        .and_then(Value::as_array)
        .unwrap_or_else(|| panic!("{value}"));
    // m l S_a k/(k − m g l): the moment under a flat spectrum, with gravity, does not depend on the period
    for (direction, half, k) in [("x", 0.35, K), ("y", 0.15, 6e6)] {
        let of = parts
            .iter()
            .find(|of| of["direction"] == direction)
            .unwrap_or_else(|| panic!("{parts:?}"));
        let inertia = N / G * (9.0 + LENGTH * LENGTH / 12.0);
        let rotation = N / G * 3.0 * 3.0 / inertia / ((k - MGL) / inertia);
        is_near(number(of, "/demand"), k * rotation);
        is_near(number(of, "/capacity"), N * half);
    }
}

#[test]
fn holds_nothing_given_across_answers_as_one_direction_and_equal_sides_as_it() {
    let plain = stone(
        "",
        ", bed_width = 0.5",
        "wind = { pressure = 500, means = \"gust\", force_coefficient = 1 }",
    );
    let survey = "tilt = { y = \"1/40\" }";
    let value = json("axes-plain", &with_survey(&plain, survey), "check project.toml");
    assert!(value.pointer("/state/check/chain/across").is_none(), "{value}");
    let same = plain.replace("bed_width = 0.5", "bed_width = 0.5, bed_depth = 0.5");
    let square = json("axes-square", &with_survey(&same, survey), "check project.toml");
    for path in [
        "/state/check/chain/stability/load_factor",
        "/state/check/chain/modes/0/frequency_hz",
        "/state/tilts/0/uplift_tilt",
    ] {
        is_near(number(&square, path), number(&value, path));
    }
    let across = "/state/check/chain/across/stability/load_factor";
    is_near(
        number(&square, across),
        number(&value, "/state/check/chain/stability/load_factor"),
    );
}

#[test]
fn holds_a_survey_is_held_against_its_direction_and_identified_in_it() {
    let joint = ", stiffness_across = \"3 MN*m/rad\"";
    let text = stone("", joint, "");
    let value = json("axes-truth", &text, "check project.toml");
    let hz = |path: &str| number(&value, &format!("/state/check/chain/{path}modes/0/frequency_hz"));
    let (along, across) = (hz(""), hz("across/"));
    let survey = |x: f64, y: f64| {
        let frequencies = format!(
            "frequencies.x = [{{ value = {x}, sd = 0.001 }}]\nfrequencies.y = [{{ value = {y}, sd = 0.001 }}]"
        );
        with_survey(&text, &frequencies)
    };
    let agrees = scratch("axes-agrees", &survey(along, across)).dolmen("check project.toml --json");
    let agrees: Value = serde_json::from_str(&agrees.stdout).unwrap();
    assert_eq!(
        agrees["judgement"]["versions"][0]["evidence"]["word"], "agrees",
        "{}",
        agrees["judgement"]
    );
    let swapped = scratch("axes-swapped", &survey(across, along)).dolmen("check project.toml --json");
    let swapped: Value = serde_json::from_str(&swapped.stdout).unwrap();
    assert_eq!(
        swapped["judgement"]["versions"][0]["evidence"]["word"],
        "contradicted"
    );
    // identified in each direction, and written to each key
    let scratch = scratch("axes-identify", &survey(1.02 * along, 1.03 * across));
    let answer = scratch.dolmen("identify project.toml --write --json");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let written = fs::read_to_string(scratch.path().join("project.toml")).unwrap();
    assert!(written.contains("stiffness_across = {"), "{written}");
    let again: Value = serde_json::from_str(&scratch.dolmen("check project.toml --json").stdout).unwrap();
    let found = |path: &str| number(&again, &format!("/state/check/chain/{path}modes/0/frequency_hz"));
    assert!((found("") / (1.02 * along) - 1.0).abs() < 1e-5);
    assert!((found("across/") / (1.03 * across) - 1.0).abs() < 1e-5);
}

/// Two records with a step of 0.02 s, m/s².
fn records(scratch: &Scratch, x: &dyn Fn(f64) -> f64, y: &dyn Fn(f64) -> f64) {
    for (name, of) in [("x.csv", x), ("y.csv", y)] {
        let rows = (0..400).map(|i| {
            let t = 0.02 * f64::from(i);
            format!("{t:.2},{}\n", of(t))
        });
        let text = format!("time_s,acceleration_m_s2\n{}", rows.collect::<String>());
        fs::write(scratch.path().join(name), text).unwrap();
    }
}

fn shaken(name: &str, text: &str, files: &str, records_of: [&dyn Fn(f64) -> f64; 2]) -> (Value, String, i32) {
    let text = format!("{text}[motion.shake]\nfiles = {{ {files} }}\nunit = \"m/s2\"\n");
    let scratch = scratch(name, &text);
    records(&scratch, records_of[0], records_of[1]);
    let answer = scratch.dolmen("simulate project.toml --motion shake --rotations small --json");
    let value = serde_json::from_str(&answer.stdout).unwrap_or(Value::Null);
    (value, answer.stderr, answer.status)
}

#[test]
fn holds_two_components_on_linear_joints_are_two_runs_and_turn_with_the_motion() {
    let first = |t: f64| 0.3 * (5.0 * t).sin();
    let second = |t: f64| 0.2 * (3.1 * t + 0.4).sin();
    let held = ", stiffness_across = \"6 MN*m/rad\", opening = \"held\"";
    let text = stone("", held, "");
    let (both, why, _) = shaken(
        "axes-both",
        &text,
        "x = \"x.csv\", y = \"y.csv\"",
        [&first, &second],
    );
    let runs = both["simulations"]
        .as_array()
        .unwrap_or_else(|| panic!("{both}{why}"));
    assert_eq!(
        (&runs[0]["direction"], &runs[1]["direction"]),
        (&"x".into(), &"y".into())
    );
    // one component acts in each direction separately
    for (run, file) in [(0, "x = \"x.csv\""), (1, "x = \"y.csv\"")] {
        let (alone, why, _) = shaken("axes-alone", &text, file, [&first, &second]);
        let alone = &alone["simulations"].as_array().unwrap_or_else(|| panic!("{why}"))[run];
        assert_eq!(runs[run]["top_peak_m"], alone["top_peak_m"]);
        assert_eq!(
            runs[run]["links"][0]["peak_rotation_rad"],
            alone["links"][0]["peak_rotation_rad"]
        );
    }
    // a square pole: the same motion from another side gives the same displacement
    let square = stone("", ", opening = \"held\"", "");
    let slanted = |sign: f64| move |t: f64| (first(t) + sign * second(t)) / 2.0_f64.sqrt();
    let files = "x = \"x.csv\", y = \"y.csv\"";
    let (straight, why, _) = shaken("axes-0", &square, files, [&first, &second]);
    assert!(straight.is_object(), "{why}");
    let (slanted, ..) = shaken("axes-45", &square, files, [&slanted(-1.0), &slanted(1.0)]);
    let top = |of: &Value| number(of, "/simulations/1/together/top_peak_m");
    is_near(top(&slanted), top(&straight));
    let lean = |of: &Value| number(of, "/simulations/1/together/peak_rotation_rad");
    is_near(lean(&slanted), lean(&straight));
}

#[test]
fn refuses_two_components_where_the_planes_are_not_apart() {
    let wave = |t: f64| 0.3 * (5.0 * t).sin();
    let across = |t: f64| 0.3 * (5.0 * t).cos();
    let files = "x = \"x.csv\", y = \"y.csv\"";
    for (joint, said) in [
        (", bed_width = 0.7", "give its bed_depth across"),
        (
            ", opening = \"held\", friction_moment = \"5 kN*m\"",
            "which acts against the turn of both together",
        ),
        (
            ", bed_width = 0.7, bed_depth = 0.5, strength = \"4 MPa\"",
            "bears less towards its corners",
        ),
    ] {
        let (_, stderr, status) = shaken("axes-refused", &stone("", joint, ""), files, [&wave, &across]);
        let words = stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(status, 2, "{words}");
        assert!(words.contains(said), "{words}");
    }
    for (link, joint, rest, said) in [
        (", depth = 0.4", "", "", "nothing in the direction of motion"),
        (
            ", breadth = 0.4, depth = 0.4, inertia_across = 5",
            "",
            "",
            "has both inertia_across and depth",
        ),
        (
            "",
            "",
            "side_supports = [{ height = 2, stiffness = \"1 kN/mm\", direction = \"z\" }]",
            "is neither \"x\" nor \"y\"",
        ),
        (
            "",
            "",
            "loads = [{ name = \"sign\", at = \"pole\", force = [\"1 kN\", \"1 kN\"] }]",
            "two, [x, y], where the chain has something of its own across",
        ),
    ] {
        let answer = scratch("axes-wrong", &stone(link, joint, rest)).dolmen("check project.toml");
        let words = format!("{}{}", answer.stdout, answer.stderr);
        let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, 2, "{words}");
        assert!(words.contains(said), "{words}");
    }
}

#[test]
fn holds_a_study_counts_the_worse_direction() {
    let wave = |t: f64| 1.2 * (4.0 * t).sin();
    let study = "[study.two]\nmotions = [\"shake\"]\nscale = [0.4]\n[motion.shake]\nfiles = { x = \"x.csv\" }\nunit = \"m/s2\"\n";
    let rows = |joint: &str| {
        let scratch = scratch("axes-study", &(stone("", joint, "damping_ratio = 0.05") + study));
        records(&scratch, &wave, &wave);
        let answer = scratch.dolmen("study project.toml --study two --json");
        let value: Value =
            serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}", answer.stderr));
        value
    };
    // some 25 kN m at the foot: more than N · 0.15 m, less than N · 0.35 m
    let both = rows(&format!("{OBLONG}, stiffness_across = \"9 MN*m/rad\""));
    let narrow = rows(", bed_width = 0.3");
    let wide = rows(", bed_width = 0.7");
    let opened = |of: &Value| of["outcomes"]["uplifted"].as_u64();
    assert_eq!((opened(&both), opened(&narrow)), (Some(1), Some(1)), "{both}");
    assert_eq!(wide["outcomes"]["stood"].as_u64(), Some(1), "{wide}");
}

#[test]
fn holds_posts_hold_in_their_direction_and_are_drawn() {
    let posts =
        |direction: &str| format!("side_supports = [{{ height = 5, stiffness = \"4 kN/mm\"{direction} }}]");
    let factor =
        |of: &Value, path: &str| number(of, &format!("/state/check/chain/{path}stability/load_factor"));
    let along = json(
        "axes-posts-x",
        &stone("", "", &posts(", direction = \"x\"")),
        "check project.toml",
    );
    let across = json(
        "axes-posts-y",
        &stone("", "", &posts(", direction = \"y\"")),
        "check project.toml",
    );
    assert!(factor(&along, "") > 1.05 * factor(&along, "across/"));
    is_near(factor(&along, ""), factor(&across, "across/"));
    is_near(factor(&along, "across/"), factor(&across, ""));
    is_near(factor(&across, ""), K / MGL);
    let drawn = |rest: &str| {
        let scratch = scratch("axes-drawn", &stone(", breadth = 0.7, depth = 0.4", "", rest));
        let answer = scratch.dolmen("draw project.toml -o drawing.svg");
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        fs::read_to_string(scratch.path().join("drawing.svg")).unwrap()
    };
    let (without, with) = (drawn(""), drawn(&posts("")));
    assert!(
        !without.contains("side posts") && with.contains("side posts"),
        "{with}"
    );
    // two more posts and two more wedges, in one of two views
    assert_eq!(
        with.matches("<polygon").count(),
        without.matches("<polygon").count() + 2
    );
    assert!(with.contains("side (y across)"));
}
