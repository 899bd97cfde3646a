// SOURCE     docs/watch.md, "Records as they come" and sensors.
// GOAL       An alarm calls once; a failed sensor raises its own alarm, and none for the structure.
// TOLERANCE  none: words, rows, exit statuses.

use super::followed::{FOLLOW, HEAD, RECORDS, STORE, gate, made_record, put};
use super::stores::{good, json};
use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

#[cfg(unix)]
#[test]
fn holds_an_alarm_calls_once_and_a_failed_call_is_made_again() {
    use std::os::unix::fs::PermissionsExt as _;
    let scratch = Scratch::new("follow-alarm");
    gate(&scratch);
    let put_day = |day: usize, frequency_hz: f64| {
        let name = format!("in/2026-01-{day:02}.csv");
        put(
            &scratch.path().join(name),
            made_record(frequency_hz, 6000, day as u64),
        );
    };
    (2..14).for_each(|day| put_day(day, 2.0));
    let program = |text: &str| {
        let path = scratch.path().join("call");
        fs::write(&path, format!("#!/bin/sh\n{text}\n")).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    };
    let note = "printf '%s|%s|%s|%s\\n' \"$DOLMEN_STRUCTURE\" \"$DOLMEN_ALARM_KIND\" \"$DOLMEN_ALARM_DATE\" \"$DOLMEN_ALARMS\" >> called";
    let called = || fs::read_to_string(scratch.path().join("called")).unwrap_or_default();
    program(note);
    let words = format!("{FOLLOW} --on-alarm ./call");
    let quiet = scratch.briefly(&words);
    assert_eq!(quiet.status, 0, "{}{}", quiet.stdout, quiet.stderr);
    assert_eq!(called(), "");
    program("exit 3");
    (14..18).for_each(|day| put_day(day, 1.8));
    let failed = scratch.briefly(&words);
    assert_eq!(failed.status, 1, "{}{}", failed.stdout, failed.stderr);
    assert!(failed.stdout.contains("ALARM: "), "{}", failed.stdout);
    assert!(
        failed.stderr.contains("--on-alarm ./call ended with"),
        "{}",
        failed.stderr
    );
    program(note);
    for day in 18..21 {
        put_day(day, 1.8);
        assert_eq!(scratch.briefly(&words).status, 1);
    }
    let once = called();
    assert_eq!(once.lines().count(), 1, "{once}");
    assert!(once.starts_with("Gate|structure|2026-01-1"), "{once}");
}

#[cfg(unix)]
#[test]
fn holds_a_sensor_that_fails_is_an_alarm_of_its_own_and_none_of_the_structure() {
    use std::os::unix::fs::PermissionsExt as _;
    let scratch = Scratch::new("follow-sensor");
    gate(&scratch);
    let path = scratch.path().join("call");
    let note =
        "printf '%s|%s|%s\\n' \"$DOLMEN_ALARM_KIND\" \"$DOLMEN_ALARM_DATE\" \"$DOLMEN_ALARMS\" >> called";
    fs::write(&path, format!("#!/bin/sh\n{note}\n")).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    let put_day = |day: usize, is_dead: bool| {
        let record = made_record(2.0, 6000, day as u64);
        let dead = |line: &str| match line.split_once(',') {
            Some((low, high)) if low != "low" => format!("0,{high}\n"),
            _ => format!("{line}\n"),
        };
        let record = if is_dead {
            record.lines().map(dead).collect()
        } else {
            record
        };
        put(&scratch.path().join(format!("in/2026-01-{day:02}.csv")), record);
    };
    for day in 2..=5 {
        put_day(day, day > 3);
    }
    let words = format!("{FOLLOW} --on-alarm ./call --metrics m.prom");
    let failing = scratch.briefly(&words);
    assert_eq!(failing.status, 0, "{}{}", failing.stdout, failing.stderr);
    assert!(
        failing.stdout.contains("\n  sensor: Channel \"low\" is dead"),
        "{}",
        failing.stdout
    );
    let called = || fs::read_to_string(scratch.path().join("called")).unwrap_or_default();
    assert_eq!(called(), "sensor|2026-01-04|0\n");
    let metrics = fs::read_to_string(scratch.path().join("m.prom")).unwrap();
    assert!(
        metrics.contains("kind=\"sensor\"} 1") && metrics.contains("kind=\"structure\"} 0"),
        "{metrics}"
    );
    let history = |all: &Value| all["structures"][0]["history"]["open_sensor_alarms"].clone();
    let all = json(&scratch, &format!("watch --all {STORE}"));
    assert_eq!((history(&all), &all["alarming"]), (1.into(), &0.into()));
    // the modes are those of the working sensor, and the file says that the other is left out
    let kept = json(&scratch, &format!("survey show Gate {STORE}"));
    let surveys = kept["surveys"].as_array().unwrap();
    assert!(
        surveys
            .iter()
            .all(|survey| survey["analyses"][0]["modes"][0]["frequency_hz"].is_number()),
        "{kept}"
    );
    good(scratch.briefly(&format!("survey export Gate -o out {STORE}")));
    let exported = fs::read_to_string(scratch.path().join("out/project.toml")).unwrap();
    assert_eq!(exported.matches("leave_out = true").count(), 2, "{exported}");
    assert_eq!(
        json(&scratch, "watch out")["surveys"].as_array().unwrap().len(),
        5
    );
    // it works again: no alarm and no call
    put_day(6, false);
    assert_eq!(scratch.briefly(&words).status, 0);
    assert_eq!(called().lines().count(), 1);
    let all = json(&scratch, &format!("watch --all {STORE}"));
    assert_eq!(history(&all), 0);
}

#[test]
fn holds_a_project_says_which_of_its_sensors_fail() {
    let scratch = Scratch::new("watch-sensor");
    let mut text = HEAD.to_owned();
    for day in 1..=4 {
        // the range of the logger ends at 20 from the third day on
        let most = if day > 2 { 20.0 } else { 1e9 };
        let clipped = |line: &str| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if let Ok(high) = cells[1].parse::<f64>() {
                cells[1] = high.clamp(-most, most).to_string();
            }
            cells.join(",") + "\n"
        };
        let record: String = made_record(2.0, 6000, day).lines().map(clipped).collect();
        fs::write(scratch.path().join(format!("{day}.csv")), record).unwrap();
        text += &format!("[survey.2026-01-0{day}.records]\nfile = \"{day}.csv\"\n{RECORDS}");
    }
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let alone = json(&scratch, "watch .");
    assert_eq!(
        (&alone["open_sensor_alarms"], &alone["open_alarms"]),
        (&1.into(), &0.into())
    );
    let alarm = &alone["alarms"][0];
    let told = ["kind", "channel", "fault", "since", "date"].map(|key| alarm[key].as_str().unwrap());
    assert_eq!(told, ["sensor", "high", "clipped", "2026-01-03", "2026-01-04"]);
    assert_eq!(
        (&alarm["records"], &alarm["answered"]),
        (&2.into(), &false.into())
    );
    let told = [
        ("en", "SENSOR: \"high\" is clipped since 2026-01-03 (records: 2)"),
        ("ko", "센서: \"high\" 포화(클리핑)(2026-01-03부터"),
    ];
    for (language, said) in told {
        let text = scratch.briefly(&format!("watch . --language {language}"));
        assert!(text.words().contains(said), "{}", text.stdout);
    }
}

#[test]
fn holds_a_project_with_a_dead_sensor_is_watched_without_it() {
    let scratch = Scratch::new("watch-dead");
    let mut text = HEAD.to_owned();
    for day in 1..=4 {
        let record = made_record(2.0, 6000, day);
        let dead = |line: &str| match line.split_once(',') {
            Some((low, high)) if low != "low" && day == 3 => format!("0,{high}\n"),
            _ => format!("{line}\n"),
        };
        let record: String = record.lines().map(dead).collect();
        fs::write(scratch.path().join(format!("{day}.csv")), record).unwrap();
        text += &format!(
            "[survey.2026-01-0{day}]\ntemperature_c = 5\nrecords = {{ file = \"{day}.csv\", sampling_rate = \"100 Hz\" }}\n"
        );
    }
    fs::write(scratch.path().join("gate.toml"), text).unwrap();
    let found = json(&scratch, "watch gate.toml");
    let left_out = serde_json::json!([{ "survey": "2026-01-03", "channels": ["low"] }]);
    assert_eq!(found["sensors_left_out"], left_out);
    assert_eq!(found["modes"][0]["found"], 4, "{}", found["modes"]);
    assert_eq!(found["alarms"][0]["channel"], "low", "{}", found["alarms"]);
    let said = good(scratch.dolmen("watch gate.toml")).words();
    assert!(
        said.contains("Survey 2026-01-03 was identified without sensors that failed: low."),
        "{said}"
    );
}
