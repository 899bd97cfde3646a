// SOURCE     Made-up histories: yearly inspections, two directions read at different times, surveys without a temperature, exchanged marks.
// GOAL       The words explain the exit status and `watch --all`, and contain no value that nobody read.
// TOLERANCE  none: words and exit statuses.

use super::stores::{good, json};
use super::verbs::Scratch;
use dolmen_work::date_text;
use std::fmt::Write as _;
use std::fs;

/// A project with one survey per line: its day and its entries.
fn project(more: &str, surveys: &[(f64, String)]) -> String {
    let mut text =
        format!("schema = 1\nkind = \"survey\"\nname = \"Pole\"\n[watch]\ntilt_limit = \"1/150\"\n{more}\n");
    for (day, keys) in surveys {
        writeln!(text, "[survey.\"{}\"]\n{keys}", date_text(*day)).unwrap();
    }
    text
}

fn noise(survey: usize) -> f64 {
    0.06 * (((survey * 7) % 11) as f64 / 11.0 - 0.45)
}

/// Exit status, words, JSON, and the line of `watch --all`.
fn watched(name: &str, text: &str) -> (i32, String, serde_json::Value, serde_json::Value) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly("watch project.toml");
    good(scratch.briefly("survey add project.toml --store s.db"));
    let list = json(&scratch, "watch --all --store s.db");
    let words = format!("{}{}", answer.words(), answer.stderr);
    (answer.status, words, json(&scratch, "watch project.toml"), list)
}

#[test]
fn holds_a_yearly_inspection_is_forecast_from_what_was_read() {
    let read = |i: usize| {
        let day = 16_100.0 + 365.25 * i as f64 + ((i * 3) % 7) as f64 - 3.0;
        (
            day,
            format!("tilt.x = \"{:.2} mm/m\"", 2.0 + 0.2 * i as f64 + noise(i)),
        )
    };
    let surveys: Vec<_> = (0..13).map(read).collect();
    let (status, words, all, list) = watched("yearly", &project("", &surveys));
    assert_eq!(status, 0, "{words}");
    let left = all["tilts"][0]["years_to_limit"].as_f64().unwrap();
    assert!((left - (1000.0 / 150.0 - 4.4) / 0.2).abs() < 1.0, "{left}");
    let now = all["tilts"][0]["now"].as_f64().unwrap();
    assert!((now - 4.4e-3).abs() < 5e-5, "{now}");
    assert_eq!(list["alarming"], 0, "{list}");
}

#[test]
fn holds_a_lean_beyond_its_limit_is_in_the_words_wherever_it_counts() {
    // x is read only in every fourth survey, y in each
    let read = |i: usize| {
        let x = 5.0 + 0.2 * i as f64 / 4.0 + noise(i);
        let own = if i.is_multiple_of(4) {
            format!("tilt = {{ x = \"{x:.2} mm/m\", y = \"-1.00 mm/m\" }}")
        } else {
            format!("tilt.y = \"{:.2} mm/m\"", -1.0 + noise(i))
        };
        (16_100.0 + 91.0 * i as f64, own)
    };
    let surveys: Vec<_> = (0..45).map(read).collect();
    let (status, words, all, list) = watched("beyond-together", &project("", &surveys));
    assert_eq!(
        (status, &all["leans"][0]["is_beyond"]),
        (1, &true.into()),
        "{words}"
    );
    assert!(words.contains("beyond its limit of 6.67 mm/m"), "{words}");
    let bad = words.lines().filter(|line| line.contains('✕')).count();
    assert_eq!((bad, &list["alarming"]), (1, &1.into()), "{words}");
}

#[test]
fn holds_surveys_without_a_temperature_do_not_vanish() {
    let read = |i: usize| {
        let warm = 12.0 - 13.0 * (i as f64 * 1.57).cos() + 40.0 * noise(i + 3);
        let fell = if i >= 34 { 0.95 } else { 1.0 };
        let hz = 2.0 * (1.0 - 0.0015 * (warm - 12.0)) * fell * (1.0 + 0.03 * noise(i));
        let known = if i >= 34 {
            String::new()
        } else {
            format!("temperature_c = {warm:.1}\n")
        };
        let own = format!("{known}frequencies.x = [{{ value = {hz:.4}, sd = 0.003 }}]");
        (16_100.0 + 91.0 * i as f64, own)
    };
    let surveys: Vec<_> = (0..40).map(read).collect();
    let (_, words, all, list) = watched("without-temperature", &project("", &surveys));
    assert!(words.contains("2.0") && words.contains("changed by −"), "{words}");
    assert!(words.contains("Surveys without a temperature: 6"), "{words}");
    assert!(
        !words.contains("No lasting change") && !words.contains('●'),
        "{words}"
    );
    let change = all["modes"][0]["temperature_of_season"].as_array().unwrap().len();
    assert_eq!((change, &list["to_watch"]), (6, &1.into()), "{list}");
}

#[test]
fn holds_a_new_mark_a_turned_sign_and_a_work_in_time_are_said() {
    let of = |name: &str, more: &str, keys: &dyn Fn(usize, f64) -> String| {
        let surveys: Vec<_> = (0..40)
            .map(|i| (16_100.0 + 91.0 * i as f64, keys(i, 91.0 * i as f64 / 365.25)))
            .collect();
        watched(name, &project(more, &surveys)).1
    };
    let tilt = |i: usize, size: f64| format!("tilt.x = \"{:.3} mm/m\"", size + noise(i));
    let marked = of("new-mark", "", &|i, years| {
        let (mark, less) = if i >= 38 { ("m2", 2.0) } else { ("m1", 0.0) };
        format!("datum = \"{mark}\"\n{}", tilt(i, 2.0 + 0.4 * years - less))
    });
    assert!(marked.contains("of the mark before"), "{marked}");
    let turned = of("turned-sign", "", &|i, years| {
        tilt(i, (2.0 + 0.3 * years) * if i >= 38 { -1.0 } else { 1.0 })
    });
    assert!(
        turned.contains("was the sign written the other way round?"),
        "{turned}"
    );
    assert!(
        turned.contains("in 5.8 years") || turned.contains("in 5.9 years"),
        "{turned}"
    );
    let event = "works = [{ date = \"2019-01-20\", kind = \"event\", what = \"quake\" }]";
    let jumped = of("event-beside", event, &|i, years| {
        tilt(i, 2.0 + 0.1 * years + if i >= 20 { 1.5 } else { 0.0 })
    });
    assert!(jumped.contains("(quake)"), "{jumped}");
}
