// SOURCE     What new users found reported as green, or not reported, though it was not known.
// GOAL       The command reports or refuses it.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use std::fs;

fn said(name: &str, text: &str, words: &str) -> (i32, String) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen(words);
    (answer.status, format!("{}{}", answer.words(), answer.stderr))
}

fn example(name: &str, words: &str) -> (i32, String) {
    let scratch = Scratch::new("fresh-example");
    let answer = scratch.dolmen(&words.replace("EXAMPLE", name));
    (answer.status, format!("{}{}", answer.words(), answer.stderr))
}

const SHAKEN: &str = "simulate project.toml --motion el-centro-1940-ns";

#[test]
fn holds_standing_on_beds_that_cannot_open_decides_nothing() {
    let pole = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\ndamping_ratio = 0.02\n\
        links = [{ name = \"shaft\", weight = 20, length = 3.0, centroid = 1.5, breadth = 0.6 }]\njoints = [{ stiffness = 3000 }]\n";
    let (status, words) = said("bed-unknown", pole, SHAKEN);
    assert!(
        status == 0 && words.contains("not decided (the bed below ‘shaft’ is not known)"),
        "{words}"
    );
    let soft = pole
        .replace("breadth = 0.6", "breadth = 0.6, bed_width = 0.6")
        .replace("3000", "20");
    let soft = soft.replace("damping_ratio = 0.02\n", "");
    let (status, words) = said("falls-alone", &soft, SHAKEN);
    assert!(
        status == 1 && words.contains("VERDICT Own weight: unstable · Earthquake"),
        "{words}"
    );
}

#[test]
fn holds_storeys_without_a_limit_are_not_decided_by_a_damper() {
    let dampers = include_str!("../../../../examples/several_dampers/project.toml");
    let (_, words) = said("no-limit", dampers, SHAKEN);
    assert!(
        words.contains("not decided (no limit is known)") && !words.contains('∞'),
        "{words}"
    );
}

#[test]
fn holds_the_worst_of_runs_with_small_differences_decides() {
    let pagoda = include_str!("../../../../examples/three_storey_pagoda/project.toml");
    let words = format!("{SHAKEN} --law springs --repeats 8");
    let (_, words) = said("repeats-decide", pagoda, &words);
    assert!(
        words.contains("near demand (offsets left, DS2 in") && words.contains("of 8 runs)"),
        "{words}"
    );
}

#[test]
fn refuses_names_that_look_like_dates_and_are_none() {
    let survey = |name: &str| {
        format!(
            "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n[survey.\"{name}\"]\nfrequencies = {{ x = [2.0] }}\n"
        )
    };
    for name in [
        "24-06-05",
        "24.06.05",
        "06/05/2024",
        "05.06.2024",
        "2024-13-05",
        "2024-06-31",
        "2023-02-29",
        "2202-05-11",
        "20240631",
    ] {
        let (status, words) = said("no-date", &survey(name), "identify project.toml");
        assert!(
            status == 2 && words.contains("looks like a date"),
            "{name}: {words}"
        );
    }
    for name in [
        "2024-06-05",
        "2024-02-29",
        "2019-04",
        "2024.6.5",
        "20240605",
        "2024년 6월 5일",
        "before",
        "setup-2",
        "2022-23",
        "3-2-1",
        "2019-1",
        "2011-restored",
        "2024-06-05T10:00",
    ] {
        let (status, words) = said("a-date", &survey(name), "identify project.toml");
        assert!(status == 0, "{name}: {words}");
    }
}

#[test]
fn holds_a_planned_repair_answers_no_alarm() {
    let years = include_str!("../../../../examples/pagoda_over_the_years/project.toml");
    let (status, words) = said("planned-not", years, "watch project.toml");
    assert_eq!(status, 1, "{words}");
    let works = years.find("works = [").unwrap();
    let planned = format!(
        "{}works = [\n  {{ date = \"2071\", what = \"repair\", kind = \"repair\" }},{}",
        &years[..works],
        &years[works + 9..]
    );
    let (status, words) = said("planned", &planned, "watch project.toml");
    assert_eq!(status, 1, "{words}");
    assert!(
        words.contains("ALARM") && words.contains("more than a year after the last survey"),
        "{words}"
    );
}

#[test]
fn refuses_a_motion_that_lost_samples() {
    let scratch = Scratch::new("lost-samples");
    let line = |at: usize| format!("{:.2},{:.4}\n", 0.02 * at as f64, (at as f64 * 0.3).sin());
    let with = |gap: std::ops::Range<usize>| -> String {
        let rows = (0..600).filter(|at| !gap.contains(at)).map(line);
        "time_s,acceleration_m_s2\n".to_owned() + &rows.collect::<String>()
    };
    fs::write(scratch.path().join("whole.csv"), with(0..0)).unwrap();
    fs::write(scratch.path().join("gap.csv"), with(400..450)).unwrap();
    assert_eq!(scratch.dolmen("motion whole.csv").status, 0);
    let answer = scratch.dolmen("motion gap.csv");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
}

#[test]
fn refuses_an_output_that_comes_back_to_an_input_through_a_folder_that_is_not_there() {
    let scratch = Scratch::new("comes-back");
    let line = |at: usize| format!("{:.2},{:.4}\n", 0.02 * at as f64, (at as f64 * 0.3).sin());
    let text = "time_s,acceleration_m_s2\n".to_owned() + &(0..300).map(line).collect::<String>();
    fs::write(scratch.path().join("e.csv"), &text).unwrap();
    for words in [
        "motion e.csv --convert ./nope/../e.csv",
        "motion e.csv --convert nope/deep/../../e.csv --force",
    ] {
        let answer = scratch.dolmen(words);
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        assert!(
            answer.stderr.contains("it is never replaced"),
            "{}",
            answer.stderr
        );
        assert_eq!(fs::read_to_string(scratch.path().join("e.csv")).unwrap(), text);
    }
}

#[test]
fn refuses_loads_and_sites_that_no_code_has() {
    let wall = include_str!("../../../../examples/wall/wind.toml");
    let pole = include_str!("../../../../examples/naju_flagpole/wind.toml");
    for (text, from, to, words) in [
        (
            pole,
            "force_coefficient = { value = 2.0",
            "force_coefficient = { value = 0.2",
            "outside what bodies have",
        ),
        (
            wall,
            "weight = 0.9",
            "weight = 9",
            "no code multiplies the weight so",
        ),
        (
            wall,
            "force = [0, 0.3, 0]",
            "force = [0, 1e6, 0]",
            "is no load of a structure",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        let (status, said) = said("no-code", &text.replacen(from, to, 1), "check project.toml");
        assert!(status == 2 && said.contains(words), "{from}: {said}");
    }
    let site = "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = \"25.5 kN/m3\"\njoint = { friction = 0.6 }\n\
        blocks = [{ name = \"body\", width = 0.6, height = 1.4 }]\n[site]\ncode = \"EN 1998-1\"\nspectrum_type = 2\nground = \"A\"\n";
    let with = |given: &str| said("site", &format!("{site}{given}"), "check project.toml");
    let (status, words) = with("ground_acceleration = \"0.08 g\"\n");
    assert!(status == 0 && words.contains("1.31 t"), "{words}"); // 25.5 kN/m³ on 0.504 m³
    let (status, words) = with("ground_acceleration = \"0.16 m/s2\"\n");
    assert!(status == 2 && words.contains("no map of a code has"), "{words}");
}

#[test]
fn holds_what_is_to_be_acted_on_is_never_left_out_for_what_is_well() {
    for language in ["en", "ko"] {
        let pole = include_str!("../../../../examples/inspected_flagpole/project.toml");
        let scratch = Scratch::new("brief-damage");
        let text = pole
            .lines()
            .filter(|line| !line.starts_with("photos"))
            .collect::<Vec<_>>()
            .join("\n");
        let text = text
            .replace(", photo = \"crack.png\"", "")
            .replace(", photo = \"joint.png\"", "");
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        let words = scratch
            .dolmen(&format!("check project.toml --language {language}"))
            .words();
        assert!(
            words.contains("severe damage") || words.contains("심한 손상"),
            "{words}"
        );
    }
    let (_, words) = example("gate", "new frame gate");
    assert!(!words.contains("error"), "{words}");
}

#[test]
fn holds_what_is_probably_a_slip_stands_before_studies_and_in_the_head_of_reports() {
    let scratch = Scratch::with_examples("slip_everywhere");
    let file = scratch.path().join("examples/naju_flagpole/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    let slip = text.replacen(
        "damping_ratio = { value = 0.02",
        "damping_ratio = { value = 0.2",
        1,
    );
    assert_ne!(slip, text);
    fs::write(&file, slip).unwrap();
    let study = scratch.dolmen("study missing examples/naju_flagpole --study growth");
    assert!(
        study.words().contains("PROBABLY A SLIP"),
        "{}{}",
        study.words(),
        study.stderr
    );
    scratch.dolmen("report examples/naju_flagpole -o page.html");
    let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
    let (head, _) = page.split_once("<h2").unwrap();
    assert!(head.contains("PROBABLY A SLIP"), "{head}");
}
