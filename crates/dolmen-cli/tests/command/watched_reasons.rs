// SOURCE     Surveys without noise, whose frequency is a stated function of date and temperature.
// GOAL       What a history leaves out or cannot judge is said with its reason; a structure stored twice is asked about.
// TOLERANCE  none: words.

use super::verbs::Scratch;
use std::fs;

/// Monthly surveys of one frequency, which falls by 3 % from the 21st on; `temperature` of a survey, if it has one.
fn monthly(surveys: usize, temperature: impl Fn(usize) -> Option<f64>) -> String {
    let mut text = String::new();
    for i in 0..surveys {
        let (year, month) = (2020 + i / 12, 1 + i % 12);
        let warmth = 10.0 - 9.0 * (std::f64::consts::TAU * i as f64 / 12.0).cos();
        let scatter = [0.4, -0.7, 0.1, 0.9, -0.5, -0.2, 0.6][(3 * i + i / 5) % 7];
        let step = if i < 20 { 1.0 } else { 0.97 };
        let hz = 3.0 * step * (1.0 - 0.0012 * (warmth - 10.0) + 0.0006 * scatter);
        text += &format!("[survey.{year}-{month:02}-05]\n");
        if let Some(temperature_c) = temperature(i) {
            text += &format!("temperature_c = {temperature_c:.1}\n");
        }
        text += &format!("frequencies.x = [{{ value = {hz:.5}, sd = 0.003 }}]\n");
    }
    text
}

fn watched(name: &str, head: &str, surveys: &str) -> String {
    let scratch = Scratch::new(name);
    let text = format!("schema = 1\nkind = \"survey\"\nname = \"Tower\"\n{head}{surveys}");
    fs::write(scratch.path().join("p.toml"), text).unwrap();
    scratch.dolmen("watch p.toml").words()
}

fn season_c(i: usize) -> Option<f64> {
    Some(10.0 - 9.0 * (std::f64::consts::TAU * i as f64 / 12.0).cos())
}

#[test]
fn holds_repairs_too_close_for_any_alarm_are_named_as_the_reason() {
    let each = (0..34).step_by(3).map(|i| {
        let (year, month) = (2020 + i / 12, 1 + i % 12);
        format!("{{ date = \"{year}-{month:02}-20\", kind = \"repair\" }}")
    });
    let works: Vec<String> = each.collect();
    let head = format!("watch = {{ works = [{}] }}\n", works.join(", "));
    let words = watched("repairs", &head, &monthly(34, season_c));
    let said = "NOTHING CAN RAISE AN ALARM: no survey was judged, since repairs (11) begin a new level each, of 3 surveys at most";
    assert!(words.contains(said), "{words}");
    let words = watched("none", "", &monthly(34, season_c));
    assert!(
        words.contains("ALARM:") && !words.contains("NOTHING CAN"),
        "{words}"
    );
}

#[test]
fn holds_temperatures_too_few_to_use_are_counted() {
    let half = |i: usize| season_c(i).filter(|_| i.is_multiple_of(2));
    let words = watched("half", "", &monthly(30, half));
    assert!(
        words.contains("A temperature is known of 15 of 30 surveys: too few"),
        "{words}"
    );
    let words = watched("none", "", &monthly(30, |_| None));
    assert!(words.contains("Temperatures are not known"), "{words}");
}

#[test]
fn holds_a_name_that_differs_in_case_alone_is_asked_about() {
    let scratch = Scratch::new("twice");
    let add = |name: &str, surveys: usize| {
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"{name}\"\n{}",
            monthly(surveys, season_c)
        );
        fs::write(scratch.path().join("p.toml"), text).unwrap();
        scratch.dolmen("survey add p.toml --store s.db").words()
    };
    assert!(!add("Tower 3", 6).contains("one structure?"));
    let alike = add("tower 3", 6);
    assert!(
        alike.contains("where Tower 3 has the same name but for case or spaces. Are they one structure?"),
        "{alike}"
    );
    assert!(!add("Tower 3", 7).contains("same name but for"));
    assert!(!add("Tower 4", 4).contains("one structure?"));
}
