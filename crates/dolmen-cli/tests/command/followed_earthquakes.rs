// SOURCE     docs/earthquakes.md.
// GOAL       A record that holds an earthquake is stored apart from the ambient surveys, alarms by itself once, stays open over restarts and
//            is answered by an inspection; the ambient records around it are judged as if it had not come.
// TOLERANCE  none: words, rows, exit statuses.

use super::followed::{FOLLOW, STORE, gate, made_record, put};
use super::stores::{good, json};
use super::verbs::Scratch;
use std::fs;

/// The record with a strong shaking of all channels, 0.35 m/s² and more, from 60 to 75 s.
fn shaken(record: &str) -> String {
    let mut lines = record.lines();
    let mut text = lines.next().unwrap().to_owned() + "\n";
    let mut state = 11u64;
    for (row, line) in lines.enumerate() {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let noise = (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
        let t = row as f64 / 100.0 - 60.0;
        let strong = match t {
            t if !(0.0..40.0).contains(&t) => 0.0,
            t if t < 15.0 => 2500.0,
            t => 2500.0 * (-(t - 15.0) / 3.0).exp(),
        };
        let moved = strong * (noise + 0.4 * (11.0 * t).sin() * (0.9 * t).cos());
        let numbers = line.split(',').map(|number| number.parse::<f64>().unwrap());
        let all: Vec<String> = numbers.map(|number| format!("{:.4}", number + moved)).collect();
        text += &(all.join(",") + "\n");
    }
    text
}

#[cfg(unix)]
#[test]
fn holds_an_earthquake_is_an_alarm_of_its_own_and_no_survey() {
    use std::os::unix::fs::PermissionsExt as _;
    let scratch = Scratch::new("follow-earthquake");
    gate(&scratch);
    let path = scratch.path().join("call");
    let note =
        "printf '%s|%s|%s\\n' \"$DOLMEN_ALARM_KIND\" \"$DOLMEN_ALARM_DATE\" \"$DOLMEN_ALARMS\" >> called";
    fs::write(&path, format!("#!/bin/sh\n{note}\n")).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    let called = || fs::read_to_string(scratch.path().join("called")).unwrap_or_default();
    let into = |day: usize, record: String| {
        put(&scratch.path().join(format!("in/2026-01-{day:02}.csv")), record);
    };
    for day in 2..14 {
        into(day, made_record(2.0, 6000, day as u64));
    }
    let words = format!("{FOLLOW} --on-alarm ./call --metrics m.prom");
    good(scratch.briefly(&words));
    into(14, shaken(&made_record(2.0, 20_000, 14)));
    let alarm = scratch.briefly(&words);
    assert_eq!(alarm.status, 1, "{}{}", alarm.stdout, alarm.stderr);
    assert!(
        alarm.stdout.starts_with("EARTHQUAKE: 2026-01-14 "),
        "{}",
        alarm.stdout
    );
    assert!(
        alarm.stdout.contains("stored apart from the ambient surveys"),
        "{}",
        alarm.stdout
    );
    assert_eq!(called(), "earthquake|2026-01-14|1\n");
    let metrics = fs::read_to_string(scratch.path().join("m.prom")).unwrap();
    assert!(
        metrics.contains("kind=\"earthquake\"} 1") && metrics.contains("kind=\"structure\"} 0"),
        "{metrics}"
    );
    // the next ambient records are as predicted, the alarm stays open and calls no more
    into(15, made_record(2.0, 6000, 15));
    let next = scratch.briefly(&format!("{words} --json"));
    let line: serde_json::Value = serde_json::from_str(next.stdout.trim()).unwrap();
    assert_eq!(
        (next.status, &line["verdict"]),
        (1, &"as_predicted".into()),
        "{line}"
    );
    assert_eq!(called().lines().count(), 1);
    let all = json(&scratch, &format!("watch --all {STORE}"));
    assert_eq!(all["structures"][0]["history"]["open_alarms"], 1, "{all}");
    // by hand: its record gives modes of the part after it, and the same alarm; an inspection answers it
    good(scratch.briefly(&format!("survey export Gate -o out {STORE}")));
    let file = scratch.path().join("out/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    assert!(text.contains("earthquake = { peak = "), "{text}");
    let watched = json(&scratch, "watch out");
    assert_eq!(
        watched["earthquakes"][0]["survey"], "2026-01-14",
        "{}",
        watched["earthquakes"]
    );
    assert_eq!(watched["earthquakes"][0]["answered"], false);
    let works = "\n[watch]\nworks = [{ date = \"2026-01-15\", kind = \"inspection\", what = \"looked at after the earthquake\" }]\n";
    fs::write(&file, text + works).unwrap();
    let watched = json(&scratch, "watch out");
    assert_eq!(
        (&watched["earthquakes"][0]["answered"], &watched["open_alarms"]),
        (&true.into(), &0.into())
    );
    let told = scratch.briefly("watch out --full");
    assert!(
        told.stdout.contains("An earthquake on 2026-01-14"),
        "{}",
        told.stdout
    );
}
