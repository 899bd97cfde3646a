// SOURCE     Answers that looked safe to engineers in their first days with the command, but were not known.
// GOAL       The command reports or refuses each.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use std::fs;

const TOWER: &str = "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
    blocks = [{ name = \"base\", width = 1.2, height = 0.4 }, { name = \"body\", width = 0.6, height = 1.4 }, \
    { name = \"roof\", width = 1.1, height = 0.3 }]\n";

/// One stone on a bed of 0.6 m: 20 kN at 1.5 m.
const POLE: &str = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\ndamping_ratio = 0.02\n\
    links = [{ name = \"shaft\", weight = 20, length = 3.0, centroid = 1.5, breadth = 0.6, bed_width = 0.6 }]\njoints = [{ stiffness = 3000 }]\n";

fn said(name: &str, text: &str, words: &str) -> (i32, String) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen(words);
    (answer.status, format!("{}{}", answer.words(), answer.stderr))
}

#[test]
fn refuses_an_angle_where_a_ratio_stands() {
    for friction in [
        "{ value = 31, unit = \"deg\" }",
        "\"31 deg\"",
        "\"31 °\"",
        "\"0.54 rad\"",
    ] {
        let text = TOWER.replace("friction = 0.6", &format!("friction = {friction}"));
        let (status, words) = said("angle-for-ratio", &text, "check project.toml");
        assert_eq!(status, 2, "{words}");
        assert!(
            words.contains("is an angle") && words.contains("tangent of the angle of friction"),
            "{words}"
        );
    }
    let (status, _) = said(
        "ratio-in-percent",
        &TOWER.replace("friction = 0.6", "friction = \"60 %\""),
        "check project.toml",
    );
    assert_eq!(status, 0);
}

#[test]
fn holds_a_pole_that_stood_on_its_edge_is_near_what_was_asked() {
    // 20 kN under a quarter of g gives a moment of N b/2 = 6 kN m; a tenth of that is far from it
    let shaken = |peak: &str| {
        said(
            "pole-on-edge",
            POLE,
            &format!("simulate project.toml --motion el-centro-1940-ns --peak {peak}g"),
        )
    };
    let (status, words) = shaken("0.5");
    assert!(
        status == 0
            && words.contains(
                "VERDICT Earthquake el-centro-1940-ns: near demand (a bed stood on its edge: shaft)"
            ),
        "{words}"
    );
    let (_, words) = shaken("0.02");
    assert!(words.contains("above demand"), "{words}");
}

#[test]
fn holds_a_run_that_was_cut_has_no_verdict_from_what_is_left() {
    let whole = "simulate project.toml --motion el-centro-1940-ns --scale 2 --law springs";
    // a stone that slides far: friction is low, and at the cut it still moves
    let slippery = TOWER.replace("friction = 0.6", "friction = 0.12");
    let (_, words) = said("whole-run", &slippery, whole);
    assert!(words.contains("below demand (severe damage, DS3)"), "{words}");
    let (status, words) = said("cut-run", &slippery, &format!("{whole} --duration 5"));
    assert_eq!(status, 3, "{words}");
    assert!(words.contains("not decided"), "{words}");
    // the largest rocking of a joint is not undone later
    let (_, words) = said("cut-rocking", TOWER, &format!("{whole} --duration 5"));
    assert!(words.contains("below demand (severe damage, DS3)"), "{words}");
}

#[test]
fn holds_samples_count_wind_and_say_where_there_is_nothing_to_draw() {
    let (status, words) = said("nothing-drawn", POLE, "check project.toml --samples 100");
    assert!(status == 0 && words.contains("no input carries a cov"), "{words}");
    // N b/2 = 6 kN m, less the moment of the lean under the load: 4 kN at 1.5 m are 6 kN m
    let loaded = POLE.replace("weight = 20", "weight = { value = 20, cov = 0.1 }")
        + "loads = [{ name = \"rope\", at = \"shaft\", height = 1.47, force = 4 }]\n";
    let (_, words) = said("loads-drawn", &loaded, "check project.toml --samples 400");
    assert!(
        words.contains("Wind and static loads bring a joint to its limit"),
        "{words}"
    );
    let share = words
        .split("or more, in ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next())
        .unwrap();
    let count: usize = share.parse().unwrap();
    assert!(
        (100..=300).contains(&count),
        "{count} of 400: at the limit about half"
    );
}

#[test]
fn holds_severe_damage_and_a_tilt_beyond_its_limit_are_findings_of_a_check() {
    let more = "[watch]\ntilt_limit = \"1/150\"\n[survey.2026-03-10]\ntilt = { x = \"1/160\", y = \"1/160\" }\n\
        inspections = [{ part = \"body\", what = \"crack\", severity = \"severe\" }, { part = \"roof\", what = \"growth\", severity = \"slight\" }]\n";
    let (_, words) = said("damaged", &format!("{TOWER}{more}"), "check project.toml");
    assert!(
        words.contains("severe damage that is not in the model: “body”: crack."),
        "{words}"
    );
    assert!(
        words.contains("not in it: severe damage found (“body”: crack)"),
        "{words}"
    );
    assert!(
        words.contains("1/113 by all directions together, is beyond the limit of 1/150"),
        "{words}"
    );
    let (_, words) = said(
        "not-beyond",
        &format!("{TOWER}{}", more.replace("1/160", "1/250")),
        "check project.toml",
    );
    assert!(!words.contains("is beyond the limit"), "{words}");
    let (_, words) = said(
        "damaged-report",
        &format!("{TOWER}{more}"),
        "report project.toml -o r.html",
    );
    assert!(words.contains("r.html"), "{words}");
}

#[test]
fn holds_a_drawing_shows_the_heights_of_the_file_although_the_model_leans() {
    let leaning = format!("{TOWER}[survey.2026-03-10]\ntilt = {{ x = \"30 mm/m\" }}\n");
    let heights = |text: &str| {
        let scratch = Scratch::new("drawn-upright");
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        let drawn = scratch.dolmen("draw project.toml").stdout;
        ["0.4", "1.4", "0.3", "2.1"].map(|height| drawn.contains(&format!(">{height}<")))
    };
    assert_eq!(heights(TOWER), [true; 4]);
    assert_eq!(heights(&leaning), [true; 4]);
}

fn years(frequency: impl Fn(usize) -> String, tilt: impl Fn(usize) -> String) -> String {
    let surveys: String = (0..5)
        .map(|year| {
            format!(
                "[survey.{}-04-10]\n{}{}",
                2022 + year,
                frequency(year),
                tilt(year)
            )
        })
        .collect();
    format!("schema = 1\nkind = \"survey\"\nname = \"Pagoda\"\n[watch]\ntilt_limit = \"1/150\"\n{surveys}")
}

#[test]
fn holds_five_surveys_whose_last_is_four_per_cent_lower_point_at_it() {
    let read = |year: usize| {
        let hz = [5.00, 5.01, 4.99, 5.00, 4.80][year];
        format!("frequencies.x = [{{ value = {hz}, sd = 0.01 }}]\n")
    };
    let (status, words) = said("apart", &years(read, |_| String::new()), "watch project.toml");
    assert_eq!(status, 0, "{words}");
    assert!(
        words.contains(
            "2026-04-10, has 4.800 Hz: −4.0 % from the median of those before it, 5.000 Hz, and 14 times"
        ),
        "{words}"
    );
    let near = |year: usize| read(year).replace("4.8,", "4.98,");
    let (_, words) = said("not-apart", &years(near, |_| String::new()), "watch project.toml");
    assert!(!words.contains("from the median"), "{words}");
}

#[test]
fn holds_tilts_alone_are_watched() {
    let tilt = |year: usize| format!("tilt.x = \"{} mm/m\"\n", [4.0, 4.5, 5.1, 5.5, 6.1][year]);
    let (status, words) = said(
        "tilts-alone",
        &years(|_| String::new(), tilt),
        "watch project.toml",
    );
    assert_eq!(status, 0, "{words}");
    // a line of least squares through 4.0 … 6.1 over four years: 0.52 a year
    assert!(
        words.contains("changes by 0.52") && words.contains("reaches its limit of 6.67 mm/m"),
        "{words}"
    );
    assert!(!words.contains("no mode was found"), "{words}");
    let (status, words) = said(
        "too-few-tilts",
        &years(|_| String::new(), |year| tilt(year).repeat(usize::from(year > 2))),
        "watch project.toml",
    );
    assert!(
        status == 2 && words.contains("2 surveys of the file have modes, a tilt or an inspection"),
        "{words}"
    );
}

/// Three stones with 30 kN on top; by hand, it supports 0.35 times its weight and the load's.
const LAMP: &str = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\ndamping_ratio = 0.02\n\
    loads = [{ name = \"lamp\", at = \"top\", LOAD }]\nlinks = [\
    { name = \"low\", weight = 30, length = 3.0, centroid = 1.4, breadth = 0.7, bed_width = 0.7 },\
    { name = \"middle\", weight = 18, length = 2.5, centroid = 1.2, breadth = 0.55, bed_width = 0.55 },\
    { name = \"top\", weight = 9, length = 2.0, centroid = 0.95, breadth = 0.4, bed_width = 0.4 }]\njoints = [JOINTS]\n";

fn lamp(load: &str, factor: f64) -> String {
    let joints = [250.0, 150.0, 60.0].map(|k| format!("{{ stiffness = {} }}", k * factor));
    LAMP.replace("LOAD", load).replace("JOINTS", &joints.join(", "))
}

#[test]
fn holds_what_a_pole_carries_swings_with_it_and_what_makes_it_fall_is_no_green_run() {
    let push = "simulate project.toml --push 0.001rad";
    // the damping ratio of a mode is undefined for a pole that falls
    let falls = lamp("weight = 30", 1.0).replace("damping_ratio = 0.02\n", "");
    let (status, words) = said("lamp-falls", &falls, push);
    assert!(
        status == 1 && words.contains("Weight and loads: unstable"),
        "{words}"
    );
    // the frequency of the run is that of the pole with a stone of the lamp's weight at its top: 3 kN of 0.2 m
    let first_hz = |text: &str| {
        let (_, words) = said("lamp-swings", text, &format!("{push} --json"));
        let answer: serde_json::Value = serde_json::from_str(words.trim()).unwrap();
        answer["first_frequency_hz"].as_f64().unwrap()
    };
    let (with, without) = (
        first_hz(&lamp("weight = 3", 10.0)),
        first_hz(&lamp("weight = 0", 10.0)),
    );
    assert!(with < 0.95 * without, "{with} {without}");
    let (_, words) = said(
        "lamp-checked",
        &lamp("weight = 3", 10.0),
        "check project.toml --json",
    );
    let checked: serde_json::Value = serde_json::from_str(words.trim()).unwrap();
    let of_check = checked["state"]["loads"]["with_their_weight"]["frequency_hz"]
        .as_f64()
        .unwrap();
    assert!((of_check / with - 1.0).abs() < 1e-9, "{of_check} {with}");
    let (status, words) = said("lamp-pushes", &lamp("force = 0.1", 10.0), push);
    assert!(
        status == 0
            && words.contains("Forces and moments of static loads")
            && words.contains("do not act in this run"),
        "{words}"
    );
}

#[test]
fn holds_a_load_without_mass_holds_no_stone_in_an_earthquake() {
    let pillar = |loads: &str| {
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\nunits = {{ force = \"kN\" }}\ndensity = 2600\njoint = {{ friction = 0.6 }}\n{loads}\
            blocks = [{{ name = \"base\", width = 1.2, depth = 0.8, height = 0.4 }}, {{ name = \"pillar\", width = 0.5, depth = 0.4, height = 2.5 }}]\n\
            [site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 1000\nsoil = \"S2\"\n"
        )
    };
    let (bare, plain) = said("pillar-bare", &pillar(""), "check project.toml");
    assert!(bare == 1 && plain.contains("below demand"), "{plain}");
    let snow = pillar("loads = [{ name = \"snow\", at = \"pillar\", height = 2.9, force = [0, 0, -50] }]\n");
    let (status, words) = said("pillar-snow", &snow, "check project.toml");
    assert!(status == 1 && words.contains("below demand"), "{words}");
    assert!(words.contains("without those that hold it at 0.160 g"), "{words}");
}

#[test]
fn holds_loads_that_no_combination_counts_are_not_in_the_word() {
    let text = format!("{}[combination.x]\nweight = 1.35\n", lamp("force = 0.5", 100.0));
    let (_, words) = said("loads-in-none", &text, "check project.toml");
    assert!(
        words.contains("VERDICT Own weight: stable") && !words.contains("Weight and loads: stable"),
        "{words}"
    );
}

#[test]
fn holds_tilts_of_two_directions_are_held_together_against_the_edge() {
    // the edge of the bed is at N b/2 over N h = 0.3/1.5: 1/5; 1/6.5 along each axis is 1/4.6 together
    let text = format!(
        "{POLE}[survey.2026-04-02]\ntilt = {{ x = \"1/6.5\", y = \"1/6.5\" }}\nas_surveyed = \"none\"\n"
    );
    let text = text
        .replace("as_surveyed = \"none\"\n", "")
        .replace("damping_ratio", "as_surveyed = \"none\"\ndamping_ratio");
    let (status, words) = said("tilts-together", &text, "check project.toml");
    assert!(
        status == 1 && words.contains("Own weight: unstable") && words.contains("x+y"),
        "{words}"
    );
    let (status, words) = said(
        "tilt-alone",
        &text.replace(", y = \"1/6.5\"", ""),
        "check project.toml",
    );
    assert!(status == 0 && !words.contains("x+y"), "{words}");
}

/// A smooth ellipsoid of 0.5 × 0.4 × 0.3 m that stands on the ground, as an OBJ file: rings about the x axis.
fn boulder() -> String {
    let (rings, around) = (24, 32);
    let mut text = String::new();
    for ring in 0..=rings {
        let (sin, cos) = (std::f64::consts::PI * f64::from(ring) / f64::from(rings)).sin_cos();
        let last = if ring == 0 || ring == rings { 1 } else { around };
        for place in 0..last {
            let (s, c) = (std::f64::consts::TAU * f64::from(place) / f64::from(around)).sin_cos();
            text += &format!(
                "v {:.6} {:.6} {:.6}\n",
                0.25 * cos,
                0.2 * sin * c,
                0.15 * (1.0 + sin * s)
            );
        }
    }
    let at = |ring: i32, place: i32| match ring {
        0 => 1,
        _ if ring == rings => 2 + (rings - 1) * around,
        _ => 2 + (ring - 1) * around + place % around,
    };
    for (ring, place) in (0..rings).flat_map(|ring| (0..around).map(move |place| (ring, place))) {
        let [a, b, c, d] = [
            at(ring, place),
            at(ring + 1, place),
            at(ring + 1, place + 1),
            at(ring, place + 1),
        ];
        if ring > 0 {
            text += &format!("f {a} {c} {d}\n");
        }
        if ring == 0 || ring + 1 < rings {
            text += &format!("f {a} {b} {c}\n");
        }
    }
    text
}

#[test]
fn refuses_a_boulder_on_its_crown() {
    let scratch = Scratch::new("boulder-on-its-crown");
    fs::write(scratch.path().join("boulder.obj"), boulder()).unwrap();
    let text = "schema = 1\nkind = \"stack\"\nname = \"Boulder\"\ndensity = 2600\n\
                blocks = [{ name = \"boulder\", shape = \"mesh\", file = \"boulder.obj\", coordinates = \"site\" }]\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    for (language, said) in [
        ("en", "'boulder' rests on a rounded face (radius of curvature 0."),
        (
            "ko",
            "'지면' 위의 'boulder': 'boulder'가 접합면이 아니라 둥근 면(곡률 반지름 0.",
        ),
    ] {
        let answer = scratch.dolmen(&format!("check project.toml --language {language}"));
        assert_eq!(answer.status, 2, "{}{}", answer.stdout, answer.stderr);
        assert!(answer.stderr.contains(said), "{}", answer.stderr);
    }
}
