// SOURCE     Made-up histories: forty surveys of one structure, of which the last show a change in quantities without a survey verdict.
// GOAL       A mode too low to be found, today's logger reading, and a loosening after a repair are not reported as good.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use dolmen_work::date_text;
use std::fmt::Write as _;
use std::fs;

/// Forty surveys, three months apart, of three modes; `of` gives the factor on the frequency of a mode in a survey, or `None` if not found.
fn history(of: impl Fn(usize, usize) -> Option<f64>, more: &str) -> String {
    let mut text = format!("schema = 1\nkind = \"survey\"\nname = \"Pole\"\n{more}");
    for survey in 0..40 {
        let date = date_text(15_000.0 + 91.0 * survey as f64);
        writeln!(
            text,
            "[survey.\"{date}\"]\ntemperature_c = {}",
            10.0 + 8.0 * (survey as f64 * 1.57).sin()
        )
        .unwrap();
        for (direction, modes) in [("x", vec![0, 2]), ("y", vec![1])] {
            let listed = modes.into_iter().filter_map(|mode| {
                // scatter of 0.1 %, always the same
                let scatter = ((survey * 7 + mode * 13) % 11) as f64 / 11.0 - 0.5;
                let hz = [3.0, 3.4, 8.0][mode] * of(mode, survey)? * (1.0 + 0.003 * scatter);
                Some(format!("{{ value = {hz:.5}, sd = {:.5} }}", 0.0015 * hz))
            });
            let listed: Vec<String> = listed.collect();
            if !listed.is_empty() {
                writeln!(text, "frequencies.{direction} = [{}]", listed.join(", ")).unwrap();
            }
        }
    }
    text
}

fn watched(name: &str, text: &str) -> (i32, String) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly("watch project.toml");
    (answer.status, format!("{}{}", answer.words(), answer.stderr))
}

#[test]
fn holds_modes_that_fall_out_of_reach_are_an_alarm() {
    for from in [28, 38, 39] {
        let (status, words) = watched(
            "fell",
            &history(|_, survey| Some(if survey >= from { 0.8 } else { 1.0 }), ""),
        );
        assert!(
            status == 1 && words.contains("✕ ALARM: not found since"),
            "{from}: {words}"
        );
        assert!(!words.contains('●'), "{from}: {words}");
    }
    let (status, words) = watched("same", &history(|_, _| Some(1.0), ""));
    assert!(status == 0 && words.contains("● No open alarm"), "{words}");
}

#[test]
fn holds_a_mode_that_vanished_is_an_alarm_once_that_is_no_chance() {
    let of = |from: usize| move |mode: usize, survey: usize| (mode != 0 || survey < from).then_some(1.0);
    let (status, words) = watched("gone", &history(of(36), ""));
    assert!(
        status == 1 && words.contains("not found since") && words.contains("found before in 36 of 36"),
        "{words}"
    );
    assert!(!words.contains("SLIP"), "{words}");
    let (status, words) = watched("once", &history(of(39), ""));
    assert!(
        status == 0 && words.contains("◆ Not found since") && !words.contains('●'),
        "{words}"
    );
    // a mode that is missed now and then
    let seldom = |mode: usize, survey: usize| (mode != 0 || !survey.is_multiple_of(3)).then_some(1.0);
    let (status, words) = watched("seldom", &history(seldom, ""));
    assert!(status == 0 && !words.contains("ALARM"), "{words}");
    // with an inspection
    let looked = format!(
        "[watch]\nworks = [{{ date = \"{}\", kind = \"inspection\" }}]\n",
        date_text(15_000.0 + 91.0 * 39.0 + 3.0)
    );
    let (status, words) = watched("looked", &history(of(36), &looked));
    assert!(status == 0 && !words.contains("ALARM"), "{words}");
}

#[test]
fn holds_who_measured_the_other_direction_alone_misses_nothing() {
    let along_y = |mode: usize, survey: usize| (mode == 1 || survey < 36).then_some(1.0);
    let (status, words) = watched("along-y", &history(along_y, ""));
    assert!(status == 0 && !words.contains("ALARM"), "{words}");
    // the same directions under new names
    let renamed = history(|_, _| Some(1.0), "");
    let at = renamed.find(&date_text(15_000.0 + 91.0 * 30.0)).unwrap();
    let (before, after) = renamed.split_at(at);
    let after = after
        .replace("frequencies.x", "frequencies.ns")
        .replace("frequencies.y", "frequencies.ew");
    let (status, words) = watched("renamed", &format!("{before}{after}"));
    assert!(status == 1 && words.contains("not found since"), "{words}");
}

#[test]
fn holds_a_repair_that_loosens_stands_first() {
    let repair = format!(
        "[watch]\nworks = [{{ date = \"{}\", kind = \"repair\" }}]\n",
        date_text(15_000.0 + 91.0 * 19.0 + 3.0)
    );
    let (_, words) = watched(
        "loosened",
        &history(|_, survey| Some(if survey >= 20 { 0.98 } else { 1.0 }), &repair),
    );
    assert!(
        words.contains("◆ With the repair of") && words.contains("changed by −") && !words.contains('●'),
        "{words}"
    );
}

#[test]
fn holds_several_steps_are_no_good_news() {
    let steps = |_: usize, survey: usize| Some(0.98_f64.powi((survey / 14) as i32));
    let repeated = format!(
        "[watch]\nworks = [{{ date = \"{}\", kind = \"inspection\" }}]\n",
        date_text(15_000.0 + 91.0 * 40.0)
    );
    let (_, words) = watched("steps", &history(steps, &repeated));
    assert!(!words.contains("● No lasting change"), "{words}");
}

#[test]
fn holds_a_survey_without_its_temperature_is_no_good_news() {
    let text = history(|_, survey| Some(if survey >= 34 { 0.95 } else { 1.0 }), "");
    let at = text.find(&date_text(15_000.0 + 91.0 * 34.0)).unwrap();
    let (before, after) = text.split_at(at);
    let kept = after.lines().filter(|line| !line.starts_with("temperature_c"));
    let (_, words) = watched(
        "no-temperature",
        &format!("{before}{}", kept.collect::<Vec<_>>().join("\n")),
    );
    assert!(
        !words.contains('●') && words.contains("changed by −5.0") && words.contains("temperature: 6, from"),
        "{words}"
    );
}

/// Three years of daily tilt readings, 3 mm/m with a seasonal variation, except as `of` says.
fn logged(name: &str, of: impl Fn(usize) -> Option<f64>) -> (i32, String) {
    let scratch = Scratch::new(name);
    let head = "schema = 1\nkind = \"survey\"\nname = \"Pole\"\n[watch.log.tx]\nfile = \"log.csv\"\nkind = \"tilt\"\n\
        direction = \"x\"\nunit = \"mm/m\"\nlimit = \"6.67 mm/m\"\n";
    let mut rows = "Time,Tilt\n".to_owned();
    for day in 0..1095 {
        let season = 0.2 * (day as f64 / 58.1).sin() + 0.02 * ((day * 7) % 11) as f64;
        let value = of(day).unwrap_or(3.0 + season);
        writeln!(rows, "{} 12:00,{value:.4}", date_text(19_000.0 + day as f64)).unwrap();
    }
    fs::write(scratch.path().join("project.toml"), head).unwrap();
    fs::write(scratch.path().join("log.csv"), rows).unwrap();
    let answer = scratch.briefly("watch project.toml");
    (answer.status, format!("{}{}", answer.words(), answer.stderr))
}

#[test]
fn holds_what_a_sensor_reads_today_is_held_against_the_limit() {
    for from in [1094, 1092, 1065] {
        let (status, words) = logged("today", |day| (day >= from).then_some(7.5));
        assert!(
            status == 1 && words.contains("✕ tx: 7.50 mm/m, beyond its limit"),
            "{from}: {words}"
        );
    }
    let (status, words) = logged("was", |day| (500..530).contains(&day).then_some(7.5));
    assert!(
        status == 0 && words.contains("or beyond; days: 30") && !words.contains('●'),
        "{words}"
    );
    let (status, words) = logged("quiet", |_| None);
    assert!(status == 0 && words.contains("● tx: no trend"), "{words}");
}
