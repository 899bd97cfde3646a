// SOURCE     docs/watch.md, docs/store.md.
// GOAL       Every structure of a store is watched as by its own project file, the worst first; one that cannot be watched gives the reason.
// TOLERANCE  none: words, rows, exit statuses; numbers as in `dolmen watch`.

use super::stores::{good, json};
use super::verbs::Scratch;
use std::fs;

const STORE: &str = "--store s.db";

/// A pagoda of the example under another name, with surveys up to that of `until`.
fn pagoda(scratch: &Scratch, folder: &str, until: &str) {
    let path = scratch.path().join("examples/pagoda_over_the_years/project.toml");
    let text = fs::read_to_string(path).unwrap();
    let end = text.find(&format!("[survey.{until}")).unwrap();
    let text = text[..end].replace("A pagoda over the years (made up)", folder);
    fs::create_dir_all(scratch.path().join(folder)).unwrap();
    fs::write(scratch.path().join(folder).join("project.toml"), text).unwrap();
}

#[test]
fn holds_every_structure_is_watched_and_the_worst_stands_first() {
    let scratch = Scratch::with_examples("watch-all");
    // before the earthquake of 2021: nothing has changed
    pagoda(&scratch, "quiet", "2021");
    good(scratch.briefly(&format!(
        "survey add examples/naju_flagpole quiet examples/pagoda_over_the_years {STORE}"
    )));
    let answer = scratch.briefly(&format!("watch --all {STORE}"));
    assert_eq!(answer.status, 1, "{}{}", answer.stdout, answer.stderr);
    let place = |words: &str| {
        answer
            .stdout
            .find(words)
            .unwrap_or_else(|| panic!("{words}: {}", answer.stdout))
    };
    assert!(place("A pagoda over") < place("quiet"), "{}", answer.stdout);
    assert!(
        answer.words().contains("flagpole was not watched:") && answer.words().contains("1 of 3"),
        "{}",
        answer.stdout
    );
    assert!(
        answer.stdout.lines().all(|line| line.chars().count() <= 80),
        "{}",
        answer.stdout
    );
    let all = json(&scratch, &format!("watch --all {STORE}"));
    let alone = json(&scratch, "watch examples/pagoda_over_the_years");
    let first = &all["structures"][0]["history"];
    assert_eq!(first["open_alarms"], alone["open_alarms"]);
    assert_eq!(first["modes"], alone["modes"].as_array().unwrap().len());
    let changes = alone["changes"].as_array().unwrap();
    assert!(
        changes
            .iter()
            .any(|change| change["change_ratio"] == first["change"]["ratio"])
    );
    assert_eq!(
        first["tilt"]["years_to_limit"],
        alone["tilts"][0]["years_to_limit"]
    );
    assert_eq!(all["alarming"], 1);
    let csv = good_or_alarm(&scratch, &format!("watch --all {STORE} --csv"));
    assert_eq!(csv.lines().count(), 4, "{csv}");
    assert!(csv.starts_with("\u{feff}structure,open_alarms"), "{csv}");
}

fn good_or_alarm(scratch: &Scratch, words: &str) -> String {
    let answer = scratch.briefly(words);
    assert!(answer.status <= 1, "{}{}", answer.stdout, answer.stderr);
    answer.stdout
}

#[test]
fn holds_modes_of_records_are_those_that_were_stored() {
    let scratch = Scratch::with_examples("watch-stored");
    let path = scratch.path().join("examples/palisaden/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    let (head, ambient) = text.split_at(text.find("[survey.ambient]").unwrap());
    let years: String = ["2019", "2020", "2021"]
        .map(|year| {
            let of_year = ambient.replace("survey.ambient", &format!("survey.{year}"));
            of_year.replace("record.npy", &format!("{year}.npy"))
        })
        .concat();
    for (year, take) in [("2019", 1), ("2020", 2), ("2021", 4)] {
        let file = format!("examples/palisaden/{year}.npy");
        scratch.copy_as_take(take, "examples/palisaden/record.npy", &file);
    }
    let years = head.to_owned() + &years;
    fs::write(&path, years).unwrap();
    good(scratch.briefly(&format!("survey add examples/palisaden {STORE}")));
    let alone = json(&scratch, "watch examples/palisaden");
    let all = json(&scratch, &format!("watch --all {STORE}"));
    let history = &all["structures"][0]["history"];
    let modes = alone["modes"].as_array().unwrap().len();
    assert!(modes >= 3, "{alone}");
    assert_eq!(history["modes"], modes);
    assert_eq!(history["surveys"], 3);
}

#[test]
fn refuses_a_store_without_all_and_a_project_with_it() {
    let scratch = Scratch::with_examples("watch-all-flags");
    for words in [
        "watch --store s.db examples/naju_flagpole",
        "watch --all examples/naju_flagpole --store s.db",
        "watch",
    ] {
        let answer = scratch.briefly(words);
        assert_eq!(answer.status, 2, "{words}: {}{}", answer.stdout, answer.stderr);
    }
    let answer = scratch.briefly("watch --all --store none.db");
    assert_eq!(answer.status, 2);
    assert!(answer.stderr.contains("no store"), "{}", answer.stderr);
}

#[test]
fn holds_a_tilt_to_the_other_side_alarms_as_little() {
    let scratch = Scratch::with_examples("watch-left");
    pagoda(&scratch, "left", "2016-08");
    let path = scratch.path().join("left/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    let right = scratch.briefly("watch left --json");
    assert_eq!(right.status, 0, "{}{}", right.stdout, right.stderr);
    fs::write(&path, text.replace("tilt.x = \"", "tilt.x = \"-")).unwrap();
    let left = scratch.briefly("watch left --json");
    assert_eq!(left.status, 0, "{}{}", left.stdout, left.stderr);
    let now = |answer: &str| -> f64 {
        let value: serde_json::Value = serde_json::from_str(answer).unwrap();
        value["tilts"][0]["now"].as_f64().unwrap()
    };
    assert!((now(&right.stdout) + now(&left.stdout)).abs() < 1e-9);
}

#[cfg(unix)]
#[test]
fn holds_an_alarm_runs_a_program_and_no_shell() {
    use std::os::unix::fs::PermissionsExt as _;
    let scratch = Scratch::new("on-alarm");
    let surveys: String = (0..4)
        .map(|i| {
            format!("[survey.202{i}-05-01]\ntilt = {{ x = \"1/250\", y = \"1/250\" }}\nfrequencies.x = [{{ value = 2.1{i}, cov = 0.01 }}]\n")
        })
        .collect();
    let project = |limit: &str| {
        format!(
            "schema = 1\nkind = \"survey\"\nname = \"a; touch shell $(touch shell) `touch shell`\"\n[watch]\ntilt_limit = \"{limit}\"\n{surveys}"
        )
    };
    fs::write(scratch.path().join("beyond.toml"), project("1/200")).unwrap();
    fs::write(scratch.path().join("within.toml"), project("1/150")).unwrap();
    let program = scratch.path().join("call");
    fs::write(&program, "#!/bin/sh\nprintf '%s|%s|%s|%s\\n' \"$DOLMEN_STRUCTURE\" \"$DOLMEN_SURVEY\" \"$DOLMEN_ALARMS\" \"$DOLMEN_TILT_BEYOND\" >> called\n").unwrap();
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
    let within = scratch.briefly("watch within.toml --on-alarm ./call");
    assert_eq!(within.status, 0, "{}{}", within.stdout, within.stderr);
    assert!(!scratch.path().join("called").exists());
    let beyond = scratch.briefly("watch beyond.toml --on-alarm ./call");
    assert_eq!(beyond.status, 1, "{}{}", beyond.stdout, beyond.stderr);
    assert!(
        beyond
            .words()
            .contains("Along x and y together it leans by 5.66 mm/m, beyond its limit of 5.00 mm/m"),
        "{}",
        beyond.stdout
    );
    let called = fs::read_to_string(scratch.path().join("called")).unwrap();
    assert_eq!(
        called,
        "a; touch shell $(touch shell) `touch shell`|2023-05-01|1|0.00566\n"
    );
    assert!(!scratch.path().join("shell").exists());
    let missing = scratch.briefly("watch beyond.toml --on-alarm ./none");
    assert_eq!(missing.status, 2);
    assert!(
        missing.stderr.contains("--on-alarm ./none could not be run"),
        "{}",
        missing.stderr
    );
}

#[test]
fn agrees_a_store_names_the_joint_that_the_project_names() {
    let scratch = Scratch::with_examples("watch-all-part");
    good(scratch.briefly(&format!("survey add examples/flagpole_over_the_years {STORE}")));
    let all = json(&scratch, &format!("watch --all {STORE}"));
    let alone = json(&scratch, "watch examples/flagpole_over_the_years");
    let change = &all["structures"][0]["history"]["change"];
    let [part] = change["explained_by"].as_array().unwrap().as_slice() else {
        panic!("{change}")
    };
    let fit = alone.pointer("/changed_parts/0/parts/0/fits/0").unwrap();
    for key in [
        "part",
        "stiffness_left",
        "stiffness_left_lower",
        "stiffness_left_upper",
    ] {
        assert_eq!(part[key], fit[key], "{part}");
    }
    assert_eq!(part["part"], "shaft 3");
    let words = scratch.briefly(&format!("watch --all {STORE}")).words();
    assert!(words.contains("it is the joint below ‘shaft 3’: 7"), "{words}");
    let korean = scratch
        .briefly(&format!("watch --all {STORE} --language ko"))
        .words();
    assert!(
        korean.contains("‘shaft 3’ 하부 접합면이며") || korean.contains("하부 접합면이며"),
        "{korean}"
    );
    let csv = scratch.briefly(&format!("watch --all --csv {STORE}")).stdout;
    assert!(csv.lines().nth(1).unwrap().contains(",\"shaft 3\",0.7"), "{csv}");
}
