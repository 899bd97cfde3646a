// SOURCE     docs/earthquakes.md.
// GOAL       A record with an earthquake is stored separately from ambient surveys; it alarms once, the alarm stays open after restarts until
//            an inspection, and the ambient records around it are judged as if it did not exist.
// TOLERANCE  none: words, rows, exit statuses.

use super::followed::{FOLLOW, HEAD, RECORDS, STORE, gate, made_record, put};
use super::stores::{good, json};
use super::verbs::{Scratch, root};
use std::fs;

/// The record with strong shaking of all channels, at least 0.35 m/s², from 60 to 75 s.
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
    // the next ambient records are as predicted; the alarm stays open but does not call again
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
    // by hand: its record gives the modes after the earthquake, and the same alarm; an inspection closes it
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

#[test]
fn holds_an_earthquake_of_a_stored_project_is_what_every_verb_says() {
    let scratch = Scratch::new("stored-earthquake");
    let folder = |name: &str| scratch.path().join(name);
    for name in ["p", "in"] {
        fs::create_dir_all(folder(name)).unwrap();
    }
    fs::write(folder("p/1.csv"), made_record(2.0, 6000, 1)).unwrap();
    fs::write(folder("p/14.csv"), shaken(&made_record(2.0, 20_000, 14))).unwrap();
    let survey =
        |day: &str, file: &str| format!("[survey.2026-01-{day}.records]\nfile = \"{file}\"\n{RECORDS}");
    let text = format!("{HEAD}{}{}", survey("14", "14.csv"), survey("01", "1.csv"));
    fs::write(folder("p/project.toml"), &text).unwrap();
    let by_hand = json(&scratch, "watch p")["earthquakes"].clone();
    assert_eq!(
        (&by_hand[0]["survey"], by_hand[0]["answered"].as_bool()),
        (&"2026-01-14".into(), Some(false))
    );
    let peak = by_hand[0]["peak_acceleration_m_s2"].as_f64().unwrap();
    assert!((10.0..40.0).contains(&peak), "{peak}");
    // adding it reports the earthquake, each time
    let said = good(scratch.briefly(&format!("survey add p {STORE}"))).stdout;
    assert!(
        said.contains("EARTHQUAKE: the record of survey 2026-01-14"),
        "{said}"
    );
    let added = json(&scratch, &format!("survey add p {STORE}"));
    assert_eq!(added["new_analyses"], 0);
    assert_eq!(
        (
            &added["earthquakes"][0]["survey"],
            added["earthquakes"][0]["peak_m_s2"].as_f64()
        ),
        (&"2026-01-14".into(), Some(peak))
    );
    // the same alarm from the store
    let all = scratch.briefly(&format!("watch --all {STORE} --json --quiet"));
    let structures: serde_json::Value = serde_json::from_str(&all.stdout).unwrap();
    assert_eq!(
        (all.status, &structures["structures"][0]["history"]["open_alarms"]),
        (1, &1.into()),
        "{structures}"
    );
    let list = good(scratch.briefly(&format!("survey list --surveys --csv {STORE}"))).stdout;
    assert!(list.contains(",has_earthquake,earthquake_peak_m_s2"), "{list}");
    assert!(
        list.contains(&format!("true,{peak}")) && list.contains("false,\r\n"),
        "{list}"
    );
    let shown = json(&scratch, &format!("survey show Gate {STORE}"));
    // by date, whatever the order in the file
    let [calm, shaken] = [0, 1].map(|at| &shown["surveys"][at]);
    assert_eq!(shaken["earthquake"]["peak_m_s2"].as_f64(), Some(peak));
    assert!(calm["earthquake"].is_null() && shaken["analyses"][0]["modes"][0].is_object());
    for words in ["survey list --surveys", "survey show Gate"] {
        let said = good(scratch.briefly(&format!("{words} {STORE}"))).stdout;
        assert!(said.contains("earthquake") && said.contains("m/s²"), "{said}");
    }
    put(&folder("in/2026-01-15.csv"), made_record(2.0, 6000, 15));
    let followed = scratch.briefly(&format!("{FOLLOW} --metrics m.prom"));
    assert_eq!(followed.status, 1, "{}", followed.stdout);
    let metrics = fs::read_to_string(folder("m.prom")).unwrap();
    assert!(metrics.contains("kind=\"earthquake\"} 1"), "{metrics}");
    // exported as a folder and as a store
    good(scratch.briefly(&format!("survey export Gate -o out {STORE}")));
    assert_eq!(json(&scratch, "watch out")["earthquakes"], by_hand);
    good(scratch.briefly(&format!("survey export -o copy.db {STORE}")));
    let copied = json(&scratch, "watch --all --store copy.db");
    assert_eq!(copied["structures"][0]["history"]["open_alarms"], 1, "{copied}");
    // an inspection closes the alarm in every copy
    let works = "[watch]\nworks = [{ date = \"2026-01-15\", kind = \"inspection\", what = \"looked at\" }]\n";
    fs::write(folder("p/project.toml"), text + works).unwrap();
    let said = good(scratch.briefly(&format!("survey add p {STORE}"))).stdout;
    assert!(!said.contains("EARTHQUAKE"), "{said}");
    let all = json(&scratch, &format!("watch --all {STORE}"));
    assert_eq!(all["structures"][0]["history"]["open_alarms"], 0, "{all}");
}

#[test]
fn holds_a_check_says_that_nobody_looked_after_a_stated_earthquake() {
    let scratch = Scratch::new("stated-earthquake");
    let path = scratch.path().join("project.toml");
    let pole = fs::read_to_string(root().join("examples/naju_flagpole/project.toml")).unwrap();
    let felt = "\n[survey.2026-09-12]\nearthquake = { peak = \"0.06 g\" }\n";
    let checked = |text: &str| {
        fs::write(&path, text).unwrap();
        scratch.briefly("check . --full").stdout
    };
    let said = checked(&format!("{pole}{felt}"));
    assert!(
        said.contains("Survey 2026-09-12 states an earthquake (peak acceleration 0.588 m/s²)"),
        "{said}"
    );
    let work = "[watch]\nworks = [{ date = \"2026-09-13\", kind = \"inspection\", what = \"looked at\" }]\n";
    assert!(!checked(&format!("{pole}{felt}{work}")).contains("states an earthquake"));
}
