// SOURCE     docs/store.md.
// GOAL       Data come out of a store unchanged; a fault gives its reason. store_processes, store_disks and store_strangers test processes,
//            disks and foreign data.
// TOLERANCE  none: bytes, rows, words and exit statuses.

use super::verbs::{Answer, Scratch, root};
use rusqlite::Connection;
use serde_json::Value;
use std::fs;
use std::process::{Command, Stdio};

/// The tests use both kinds of store in turn: a file, and a server if there is one.
pub(crate) const FILE: &str = "--store s.db";

pub(crate) fn good(answer: Answer) -> Answer {
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    answer
}

pub(crate) fn json(scratch: &Scratch, words: &str) -> Value {
    let answer = scratch.briefly(&format!("{words} --json --quiet"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|why| panic!("{words}: {why}: {}", answer.stderr))
}

pub(crate) fn refused(answer: &Answer, why: &str) {
    assert_eq!(answer.status, 2, "{}{}", answer.stdout, answer.stderr);
    assert!(answer.stderr.contains(why), "{}", answer.stderr);
    assert!(!answer.stderr.contains("panicked"), "{}", answer.stderr);
}

/// A project with this many surveys, each with its own record.
pub(crate) fn project(scratch: &Scratch, name: &str, surveys: usize) {
    let folder = scratch.path().join(name);
    fs::create_dir_all(&folder).unwrap();
    let mut text = format!("schema = 1\nkind = \"survey\"\nname = {{ en = \"{name}\" }}\n");
    for survey in 0..surveys {
        let (year, file) = (1950 + survey, format!("record-{survey}.csv"));
        text += &format!(
            "[survey.{year}]\ntemperature_c = {survey}\nrecords = {{ file = \"{file}\", sampling_rate = \"100 Hz\" }}\n"
        );
        let row = |i: usize| format!("{}\n", (i * i + 7 * survey + name.len()) % 1000);
        let rows: String = (0..2000).map(row).collect();
        fs::write(folder.join(file), format!("x of {name}\n{rows}")).unwrap();
    }
    fs::write(folder.join("project.toml"), text).unwrap();
}

pub(crate) fn content(scratch: &Scratch, store: &str) -> String {
    let found = json(scratch, &format!("survey verify {store}"));
    assert_eq!(found["faults"].as_array().unwrap().len(), 0, "{found}");
    found["content"].as_str().unwrap().to_owned()
}

pub(crate) fn database(scratch: &Scratch) -> Connection {
    Connection::open(scratch.path().join("s.db")).unwrap()
}

/// Raw files of the store in the folder.
pub(crate) fn raw_files(scratch: &Scratch) -> Vec<std::path::PathBuf> {
    let mut all = Vec::new();
    for folder in fs::read_dir(scratch.path().join("s.db.files")).unwrap() {
        let folder = folder.unwrap().path();
        if folder.is_dir() {
            all.extend(fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()));
        }
    }
    all.sort();
    all
}

#[test]
fn holds_an_exported_project_gives_the_answers_of_the_one_that_was_added() {
    let scratch = Scratch::with_examples("store-export");
    let examples = [
        "naju_flagpole",
        "palisaden",
        "three_storey_pagoda",
        "twisting_floor",
        "heunginjimun_gate",
        "gate_through_the_seasons",
    ];
    for (at, example) in examples.iter().enumerate() {
        good(scratch.briefly(&format!(
            "survey add examples/{example} {FILE} --without-modes --name s{at}"
        )));
        good(scratch.briefly(&format!("survey export s{at} -o back/{example} {FILE}")));
        let check = |folder: &str| {
            let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
                .args(["check", ".", "--json"])
                .current_dir(scratch.path().join(folder))
                .output()
                .unwrap();
            Answer::of(&output)
        };
        let (before, after) = (
            check(&format!("examples/{example}")),
            check(&format!("back/{example}")),
        );
        assert_eq!(
            (before.status, &before.stdout),
            (after.status, &after.stdout),
            "{example}"
        );
        let text = |of: &str| fs::read(scratch.path().join(of).join(example).join("project.toml")).unwrap();
        assert_eq!(text("examples"), text("back"));
    }
    let record = |of: &str| fs::read(scratch.path().join(of).join("palisaden/record.npy")).unwrap();
    assert_eq!(record("examples"), record("back"));
}

#[test]
fn holds_adding_again_adds_nothing_and_a_changed_project_is_another_state() {
    let scratch = Scratch::new("store-again");
    fs::create_dir_all(scratch.path().join("p")).unwrap();
    for file in ["project.toml", "record.npy"] {
        fs::copy(
            root().join("examples/palisaden").join(file),
            scratch.path().join("p").join(file),
        )
        .unwrap();
    }
    let first = json(&scratch, &format!("survey add p {FILE} --who kim"));
    assert_eq!(
        (first["new_surveys"].as_u64(), first["new_analyses"].as_u64()),
        (Some(1), Some(1)),
        "{first}"
    );
    assert_eq!(first["new_files"], 2, "{first}");
    let before = content(&scratch, FILE);
    let again = json(&scratch, &format!("survey add p {FILE}"));
    assert_eq!(again["is_new_state"], false);
    assert_eq!(before, content(&scratch, FILE));

    let name = first["structure"].as_str().unwrap().to_owned();
    fs::write(scratch.path().join("name"), &name).unwrap();
    let shown = |survey: &str| {
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["survey", "show", &name, "--store", "s.db", "--json"])
            .args(survey.split_whitespace())
            .current_dir(scratch.path())
            .output()
            .unwrap();
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    // the modes are those of `identify`
    let found = json(&scratch, "identify p");
    let kept = shown("");
    let modes = kept["surveys"][0]["analyses"][0]["modes"].as_array().unwrap();
    let identified: Vec<f64> = found["surveys"][0]["records"]["modes"]["modes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|mode| mode["frequency_hz"].as_f64().unwrap())
        .collect();
    let stored: Vec<f64> = modes
        .iter()
        .map(|mode| mode["frequency_hz"].as_f64().unwrap())
        .collect();
    assert_eq!(stored, identified);
    assert!(
        modes
            .iter()
            .all(|mode| mode["frequency_sd_hz"].as_f64().unwrap() > 0.0)
    );

    // other settings: another state and another analysis; the old ones stay
    let file = scratch.path().join("p/project.toml");
    let old = fs::read_to_string(&file).unwrap();
    fs::write(&file, format!("{old}\n[survey.2026-10-01]\ntemperature_c = 3\n")).unwrap();
    let changed = json(&scratch, &format!("survey add p {FILE} --who lee"));
    assert_eq!(
        (changed["is_new_state"].as_bool(), changed["new_surveys"].as_u64()),
        (Some(true), Some(1))
    );
    assert_eq!(
        (changed["new_files"].as_u64(), changed["new_analyses"].as_u64()),
        (Some(1), Some(0))
    );
    let kept = shown("");
    assert_eq!(kept["states"].as_array().unwrap().len(), 2);
    assert_eq!(
        (
            kept["states"][0]["who"].as_str(),
            kept["states"][1]["who"].as_str()
        ),
        (Some("lee"), Some("kim"))
    );
    assert_eq!(kept["surveys"][1]["temperature_c"], 3.0);
    // back to the old text: it is current again
    fs::write(&file, &old).unwrap();
    json(&scratch, &format!("survey add p {FILE}"));
    assert_eq!(shown("")["surveys"].as_array().unwrap().len(), 1);
    assert_eq!(shown("")["states"].as_array().unwrap().len(), 3);
    content(&scratch, FILE);
}

#[test]
fn holds_a_whole_store_is_taken_over_as_it_is() {
    let scratch = Scratch::with_examples("store-import");
    good(scratch.briefly(&format!(
        "survey add examples/palisaden examples/naju_flagpole examples/gate_through_the_seasons {FILE}"
    )));
    good(scratch.briefly(&format!("survey export -o copy.db {FILE}")));
    fs::create_dir_all(scratch.path().join("new")).unwrap();
    good(scratch.briefly("survey import copy.db --store new/t.db"));
    let own = content(&scratch, FILE);
    assert_eq!(own, content(&scratch, "--store copy.db"));
    assert_eq!(own, content(&scratch, "--store new/t.db"));
    let again = json(&scratch, "survey import copy.db --store new/t.db");
    assert_eq!(
        (again["new_rows"].as_u64(), again["new_files"].as_u64()),
        (Some(0), Some(0)),
        "{again}"
    );
    refused(
        &scratch.briefly(&format!("survey export -o copy.db {FILE}")),
        "is there already",
    );
}

#[test]
fn holds_places_names_and_removed_structures_are_listed() {
    let scratch = Scratch::new("store-list");
    for (name, site) in [
        (
            "Pagoda",
            "[site]\nlatitude_deg = 35.79\nlongitude_deg = 129.332\n",
        ),
        ("Gate 100%_sure", ""),
    ] {
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = {{ en = \"{name}\", ko = \"석탑\" }}\n{site}[survey.2020-05]\n[survey.2024-11-03]\n"
        );
        fs::write(scratch.path().join("p.toml"), text).unwrap();
        good(scratch.briefly(&format!("survey add p.toml {FILE}")));
    }
    let listed = json(&scratch, &format!("survey list {FILE}"));
    let [gate, pagoda] = [&listed["structures"][0], &listed["structures"][1]];
    assert_eq!(
        (gate["name"].as_str(), pagoda["name"].as_str()),
        (Some("Gate 100%_sure"), Some("Pagoda"))
    );
    assert_eq!(
        (pagoda["first_survey"].as_str(), pagoda["last_survey"].as_str()),
        (Some("2020-05"), Some("2024-11-03"))
    );
    let map: Value =
        serde_json::from_str(&good(scratch.briefly(&format!("survey list --geojson {FILE}"))).stdout)
            .unwrap();
    let features = map["features"].as_array().unwrap();
    assert_eq!(features.len(), 1);
    assert_eq!(features[0]["geometry"]["coordinates"][0], 129.332);
    let count = |words: &str| {
        json(&scratch, &format!("survey list {words} {FILE}"))["structures"]
            .as_array()
            .unwrap()
            .len()
    };
    // wildcards are ordinary characters in a name
    assert_eq!(
        [
            count("pAGO"),
            count("석탑"),
            count("%"),
            count("0%_s"),
            count("_"),
            count("!")
        ],
        [1, 2, 1, 1, 1, 0]
    );
    let surveys = good(scratch.briefly(&format!("survey list --surveys --csv {FILE}"))).stdout;
    assert_eq!(surveys.lines().count(), 5, "{surveys}");
    good(scratch.briefly(&format!("survey remove Pagoda {FILE} --why fallen")));
    assert_eq!([count(""), count("--removed")], [1, 2]);
    good(scratch.briefly(&format!("survey remove Pagoda {FILE} --undo")));
    assert_eq!(count(""), 2);
    refused(
        &scratch.briefly(&format!("survey show Pogoda {FILE}")),
        "did you mean \"Pagoda\"?",
    );
    refused(
        &scratch.briefly(&format!("survey show Pogoda {FILE} --language ko")),
        "저장소에 구조물 \"Pogoda\"가 없다",
    );
    refused(
        &scratch.briefly(&format!("survey show Pagoda --survey x {FILE}")),
        "the last ones are 2024-11-03, 2020-05",
    );
    refused(
        &scratch.briefly("survey list"),
        "give --store FILE, or set DOLMEN_STORE",
    );
    refused(
        &scratch.briefly("survey list --store none.db"),
        "There is no store none.db",
    );
    assert!(!scratch.path().join("none.db").exists());
}

#[test]
fn holds_what_was_changed_or_lost_is_named() {
    let scratch = Scratch::new("store-verify");
    project(&scratch, "a", 3);
    good(scratch.briefly(&format!("survey add a {FILE} --without-modes")));
    content(&scratch, FILE);
    let files = raw_files(&scratch);
    assert_eq!(files.len(), 4);
    let mut bytes = fs::read(&files[0]).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&files[0], &bytes).unwrap();
    fs::remove_file(&files[1]).unwrap();
    let unsound = scratch.briefly(&format!("survey verify --json {FILE}"));
    assert_eq!(unsound.status, 1);
    let found: Value = serde_json::from_str(&unsound.stdout).unwrap();
    let kinds: Vec<&str> = found["faults"]
        .as_array()
        .unwrap()
        .iter()
        .map(|f| f["fault"].as_str().unwrap())
        .collect();
    assert_eq!(kinds, ["changed", "missing"]);
    assert!(
        scratch
            .briefly(&format!("survey verify {FILE} --language ko"))
            .stdout
            .contains("변경됨")
    );
    let out = scratch.briefly(&format!("survey export a -o back {FILE}"));
    refused(&out, "is missing or was changed");
    // adding it again restores what is missing
    good(scratch.briefly(&format!("survey add a {FILE} --without-modes")));
    let found = json(&scratch, &format!("survey verify {FILE}"));
    assert_eq!(found["faults"].as_array().unwrap().len(), 1);
    // a row changed by another program, and a dangling reference
    let other = database(&scratch);
    other
        .execute_batch(
            "pragma foreign_keys = off; update project_file set path = 'x.csv' where path = 'record-0.csv'; \
                         delete from survey where name = '1951'",
        )
        .unwrap();
    drop(other);
    let found = json(&scratch, &format!("survey verify {FILE}"));
    let all = found["faults"].to_string();
    assert!(
        all.contains("\"table\":\"project\"") && all.contains("refers to one that is not there"),
        "{all}"
    );
}

/// A random number below `most`.
pub(crate) fn below(seed: &mut u64, most: u64) -> u64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
    (*seed >> 33) % most
}

#[cfg(target_os = "linux")]
#[test]
fn holds_memory_stays_flat_however_many_surveys_are_listed() {
    use std::io::Read as _;
    let scratch = Scratch::new("store-many");
    fs::write(
        scratch.path().join("p.toml"),
        "schema = 1\nkind = \"survey\"\nname = \"many\"\n[survey.2020]\n",
    )
    .unwrap();
    good(scratch.briefly(&format!("survey add p.toml {FILE}")));
    let most_kib = |rows: usize| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["survey", "list", "--surveys", "--json", "--store", "s.db"])
            .current_dir(scratch.path())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        // the pipe blocks it, so it runs until the last bytes are read
        let mut out = child.stdout.take().unwrap();
        let (mut bytes, mut buffer, mut most) = (0, [0; 65536], 0.0_f64);
        loop {
            let read = out.read(&mut buffer).unwrap();
            if read == 0 {
                break;
            }
            bytes += read;
            let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
            let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
            let kib = line.and_then(|line| line.trim().strip_suffix(" kB")?.trim().parse().ok());
            most = most.max(kib.unwrap_or(0.0));
        }
        assert!(child.wait().unwrap().success() && bytes > rows * 50, "{bytes}");
        most
    };
    let grow = |from: usize, to: usize| {
        let mut other = database(&scratch);
        let all = other.transaction().unwrap();
        let project: String = all
            .query_row("select hash from project", [], |row| row.get(0))
            .unwrap();
        for at in from..to {
            let hash = format!("{at:064}");
            all.execute(
                "insert into survey (hash, structure, name) values (?1, 'many', ?1)",
                [&hash],
            )
            .unwrap();
            all.execute(
                "insert into project_survey values (?1, ?2, ?3)",
                (&project, at as i64, &hash),
            )
            .unwrap();
        }
        all.commit().unwrap();
    };
    grow(2, 2_000);
    let few = most_kib(2_000);
    grow(2_000, 60_000);
    let many = most_kib(60_000);
    // SQLite's own page cache is 2 MB at most; the list itself is 9 MB
    assert!(
        few > 0.0 && many < few + 4096.0,
        "{few} KiB for 2,000 surveys, {many} KiB for 60,000"
    );
}

#[cfg(not(feature = "postgres"))]
#[test]
fn refuses_a_server_where_none_is_spoken() {
    let scratch = Scratch::new("store-no-server");
    for verb in [
        "survey add none --store",
        "survey import",
        "watch --all --store",
        "watch --follow none --store",
    ] {
        for (language, why) in [
            ("en", "was built without PostgreSQL, so nothing was done"),
            ("ko", "PostgreSQL 기능이 없어"),
        ] {
            let answer = scratch.briefly(&format!(
                "{verb} postgresql://kim:s3cr3t@h/d --language {language}"
            ));
            refused(&answer, why);
            assert!(!answer.stderr.contains("s3cr3t"), "{}", answer.stderr);
        }
    }
}
