// SOURCE     Simulated histories: forty surveys a quarter apart, of two modes and a tilt, with known changes.
// GOAL       The answer names a mistyped reading, which hides nothing; the forecast of a late drift uses its recent slope; a last survey with a large
//            difference comes first, as does a quantity at its limit; `compare` names events between two surveys.
// TOLERANCE  none: words, exit statuses; dates and years of the forecast as simulated.

use super::stores::json;
use super::verbs::Scratch;
use dolmen_work::date_text;
use std::fmt::Write as _;
use std::fs;

/// Surveys of two modes with a factor each, and of a tilt in mm/m.
fn history(surveys: usize, factor: impl Fn(usize) -> f64, tilt: impl Fn(usize) -> f64, more: &str) -> String {
    let mut text =
        format!("schema = 1\nkind = \"survey\"\nname = \"Pole\"\n[watch]\ntilt_limit = \"1/150\"\n{more}\n");
    for survey in 0..surveys {
        let date = date_text(15_000.0 + 91.0 * survey as f64);
        let warm = 10.0 + 8.0 * (survey as f64 * 1.57).sin();
        writeln!(text, "[survey.\"{date}\"]\ntemperature_c = {warm:.2}").unwrap();
        let noise = |of: usize| ((survey * 7 + of * 13) % 11) as f64 / 11.0 - 0.45;
        for (i, (direction, hz)) in [("x", 3.0), ("y", 3.4)].into_iter().enumerate() {
            let hz = hz * factor(survey) * (1.0 + 0.002 * noise(i));
            writeln!(
                text,
                "frequencies.{direction} = [{{ value = {hz:.5}, sd = {:.5} }}]",
                0.0015 * hz
            )
            .unwrap();
        }
        writeln!(text, "tilt.x = \"{:.4} mm/m\"", tilt(survey) + 0.06 * noise(5)).unwrap();
    }
    text
}

fn years(survey: usize) -> f64 {
    91.0 * survey as f64 / 365.25
}

fn watched(name: &str, text: &str) -> (i32, String, serde_json::Value) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly("watch project.toml");
    let words = format!("{}{}", answer.words(), answer.stderr);
    (answer.status, words, json(&scratch, "watch project.toml"))
}

#[test]
fn holds_a_slipped_tilt_is_named_with_date_and_value_and_hides_no_drift() {
    let drifting = |survey: usize| 2.0 + 0.4 * years(survey);
    let slipped = |survey: usize| drifting(survey) * if survey == 20 { -1.0 } else { 1.0 };
    let (status, words, all) = watched("slipped", &history(40, |_| 1.0, slipped, ""));
    assert_eq!(status, 0, "{words}");
    assert!(
        words.contains("was read as −3.98") && words.contains("on 2016-"),
        "{words}"
    );
    let tilt = &all["tilts"][0];
    assert_eq!(tilt["outliers"].as_array().unwrap().len(), 1, "{tilt}");
    let left = tilt["years_to_limit"].as_f64().unwrap();
    let truth = (1000.0 / 150.0 - drifting(39)) / 0.4;
    assert!((left - truth).abs() < 0.3, "{left} {truth}");
}

#[test]
fn holds_a_drift_that_begins_late_is_forecast_from_its_recent_slope() {
    let late = |survey: usize| 2.0 + (years(survey) - 8.0).max(0.0);
    let (_, words, all) = watched("late", &history(40, |_| 1.0, late, ""));
    assert!(
        words.contains("The slope of the tilt along x changed in about 201"),
        "{words}"
    );
    let tilt = &all["tilts"][0];
    let of = |key: &str| tilt[key].as_f64().unwrap();
    let truth = 1000.0 / 150.0 - late(39);
    assert!(
        of("years_to_limit_earliest") < truth && truth < of("years_to_limit_latest"),
        "{tilt}"
    );
}

#[test]
fn holds_a_limit_that_is_exceeded_stands_first() {
    let (status, words, _) = watched(
        "beyond",
        &history(40, |_| 1.0, |survey| if survey < 39 { 2.0 } else { 8.0 }, ""),
    );
    assert_eq!(status, 1, "{words}");
    let (bad, good) = (words.find('✕').unwrap(), words.find('●').unwrap_or(usize::MAX));
    assert!(bad < good, "{words}");
}

#[test]
fn holds_a_last_survey_far_off_is_said_first_and_counted_among_many() {
    for surveys in [13, 16] {
        let fell = |survey: usize| if survey + 1 == surveys { 0.95 } else { 1.0 };
        let text = history(surveys, fell, |_| 2.0, "");
        let (status, words, all) = watched("fell-last", &text);
        assert_eq!(status, 0, "{words}");
        let first = words.find('◆').unwrap();
        assert!(
            words[first..].starts_with("◆ The last survey, 20") && !words.contains('●'),
            "{surveys}: {words}"
        );
        assert!(!words.contains("wanders"), "{words}");
        let ratio = all["last_far_off"][0]["ratio"].as_f64().unwrap();
        assert!((ratio + 0.05).abs() < 0.004, "{surveys}: {ratio}");
        let scratch = Scratch::new("fell-last-all");
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        super::stores::good(scratch.briefly("survey add project.toml --store s.db"));
        let list = json(&scratch, "watch --all --store s.db");
        assert_eq!(
            (&list["alarming"], &list["to_watch"]),
            (&0.into(), &1.into()),
            "{list}"
        );
    }
}

#[test]
fn holds_compare_names_what_stands_between_two_surveys() {
    let more = "works = [{ date = \"2015-01-01\", kind = \"repair\", what = \"joints\" }]";
    let scratch = Scratch::new("between");
    fs::write(
        scratch.path().join("project.toml"),
        history(40, |_| 1.0, |_| 2.0, more),
    )
    .unwrap();
    let words = scratch.briefly("compare project.toml").words();
    assert!(words.contains("a repair on 2015-01-01 (joints)"), "{words}");
    let all = json(&scratch, "compare project.toml");
    assert_eq!(all["between"][0]["kind"], "repair");
}

#[test]
fn holds_a_survey_that_is_stored_over_another_says_what_was_there() {
    let scratch = Scratch::new("stored-over");
    let put = |factor: f64, surveys: usize| {
        let text = history(
            surveys,
            |survey| if survey == 5 { factor } else { 1.0 },
            |_| 2.0,
            "",
        );
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        scratch.briefly("survey add project.toml --store s.db").words()
    };
    let first = put(1.0, 12);
    assert!(!first.contains("same structure"), "{first}");
    let changed = put(1.02, 12);
    assert!(
        changed.contains("1 surveys that Pole had already have other content now"),
        "{changed}"
    );
    let gone = put(1.02, 11);
    assert!(
        gone.contains("1 surveys that Pole had are not in this file"),
        "{gone}"
    );
}
