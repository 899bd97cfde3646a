// SOURCE     docs/store.md.
// GOAL       What goes into a store comes out as it was; what was acknowledged stays, whatever happens to the process; what is wrong is named.
// TOLERANCE  none: bytes, rows, words and exit statuses.

use super::verbs::{Answer, Scratch, root};
use rusqlite::Connection;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// Places of stores that the tests use in turn: a file, and a server where there is one.
pub(crate) const FILE: &str = "--store s.db";

pub(crate) fn good(answer: Answer) -> Answer {
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    answer
}

pub(crate) fn json(scratch: &Scratch, words: &str) -> Value {
    let answer = scratch.briefly(&format!("{words} --json --quiet"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|why| panic!("{words}: {why}: {}", answer.stderr))
}

fn refused(answer: &Answer, why: &str) {
    assert_eq!(answer.status, 2, "{}{}", answer.stdout, answer.stderr);
    assert!(answer.stderr.contains(why), "{}", answer.stderr);
    assert!(!answer.stderr.contains("panicked"), "{}", answer.stderr);
}

/// A project of so many surveys, each with a record of its own.
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

fn content(scratch: &Scratch, store: &str) -> String {
    let found = json(scratch, &format!("survey verify {store}"));
    assert_eq!(found["faults"].as_array().unwrap().len(), 0, "{found}");
    found["content"].as_str().unwrap().to_owned()
}

fn database(scratch: &Scratch) -> Connection {
    Connection::open(scratch.path().join("s.db")).unwrap()
}

/// Raw files of the store in the folder.
fn raw_files(scratch: &Scratch) -> Vec<std::path::PathBuf> {
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

    // other settings: another state and another analysis, the old ones stay
    let file = scratch.path().join("p/project.toml");
    let old = fs::read_to_string(&file).unwrap();
    fs::write(&file, format!("{old}\n[survey.2030-01-01]\ntemperature_c = 3\n")).unwrap();
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
    // back to the old text: it counts again
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
    // signs of a pattern are signs of a name
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
    // adding it again brings back what is missing
    good(scratch.briefly(&format!("survey add a {FILE} --without-modes")));
    let found = json(&scratch, &format!("survey verify {FILE}"));
    assert_eq!(found["faults"].as_array().unwrap().len(), 1);
    // a row that another program changed, and one that refers to nothing
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

/// Starts `dolmen survey add` of these projects; each that is acknowledged is a line of JSON.
pub(crate) fn adding(folder: &Path, store: &str, projects: &[String]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args([
            "survey",
            "add",
            "--without-modes",
            "--json",
            "--quiet",
            "--wait",
            "60",
        ])
        .args(store.split_whitespace())
        .args(projects)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Names that were acknowledged.
pub(crate) fn acknowledged(stdout: &[u8]) -> Vec<String> {
    let lines = String::from_utf8_lossy(stdout).into_owned();
    let whole = lines.split_inclusive('\n').filter(|line| line.ends_with('\n'));
    whole
        .map(|line| {
            serde_json::from_str::<Value>(line).unwrap()["structure"]
                .as_str()
                .unwrap()
                .to_owned()
        })
        .collect()
}

/// A number below `most` from a seed.
fn below(seed: &mut u64, most: u64) -> u64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
    (*seed >> 33) % most
}

/// Kills `add` at so many random moments, and holds that what was acknowledged is there, once.
pub(crate) fn kill_at_random_moments(scratch: &Scratch, store: &str, moments: usize) {
    const SURVEYS: usize = 2;
    let projects: Vec<String> = (0..4).map(|at| format!("p{at}")).collect();
    projects.iter().for_each(|name| project(scratch, name, SURVEYS));
    let (mut seed, mut killed, mut whole_us) = (7, 0, 0);
    for moment in 0..=moments {
        // each time other bytes: a new state of every project
        for name in &projects {
            let folder = scratch.path().join(name);
            let text = fs::read_to_string(folder.join("project.toml")).unwrap();
            let text = format!("{text}[survey.m{moment}]\ntemperature_c = {moment}\n");
            fs::write(folder.join("project.toml"), text).unwrap();
            fs::write(folder.join("record-0.csv"), format!("x\n{moment}\n{name}\n")).unwrap();
        }
        let start = std::time::Instant::now();
        let mut child = adding(scratch.path(), store, &projects);
        if moment >= 2 {
            std::thread::sleep(std::time::Duration::from_micros(below(&mut seed, whole_us)));
            child.kill().unwrap();
        }
        let output = child.wait_with_output().unwrap();
        let said = acknowledged(&output.stdout);
        if moment < 2 {
            // undisturbed: the store is made, then how long it takes
            whole_us = start.elapsed().as_micros() as u64;
            assert_eq!(said, projects, "{}", String::from_utf8_lossy(&output.stderr));
        }
        killed += usize::from(!output.status.success());
        let found = json(scratch, &format!("survey verify {store}"));
        assert_eq!(found["faults"].as_array().unwrap().len(), 0, "{found}");
        for name in said {
            let kept = json(scratch, &format!("survey show {name} --survey m{moment} {store}"));
            assert_eq!(kept["surveys"].as_array().unwrap().len(), 1, "{name} {moment}");
        }
    }
    assert!(
        killed * 2 > moments,
        "{killed} of {moments} were killed before their end"
    );
    // once more to the end: nothing is there twice
    let names = projects.join(" ");
    good(scratch.briefly(&format!("survey add {names} --without-modes {store}")));
    let listed = json(scratch, &format!("survey list {store}"));
    let listed = listed["structures"].as_array().unwrap();
    let names: Vec<&str> = listed
        .iter()
        .map(|structure| structure["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, projects);
    for structure in listed {
        assert_eq!(
            structure["surveys"].as_u64().unwrap() as usize,
            SURVEYS + moments + 1,
            "{structure}"
        );
    }
    content(scratch, store);
}

#[cfg(unix)]
#[test]
fn holds_a_killed_add_loses_nothing_that_was_acknowledged_and_stores_nothing_twice() {
    kill_at_random_moments(&Scratch::new("store-kill"), FILE, 51);
}

/// Four processes at once, one of them killed.
pub(crate) fn four_at_once(scratch: &Scratch, store: &str) {
    let groups: Vec<Vec<String>> = (0..4)
        .map(|g| (0..5).map(|at| format!("g{g}p{at}")).collect())
        .collect();
    groups.iter().flatten().for_each(|name| project(scratch, name, 2));
    let mut children: Vec<Child> = groups
        .iter()
        .map(|group| adding(scratch.path(), store, group))
        .collect();
    std::thread::sleep(std::time::Duration::from_millis(40));
    children[3].kill().unwrap();
    for (child, group) in children.into_iter().zip(&groups) {
        let output = child.wait_with_output().unwrap();
        let said = acknowledged(&output.stdout);
        for name in &said {
            json(scratch, &format!("survey show {name} {store}"));
        }
        if group[0] != "g3p0" {
            assert_eq!(&said, group, "{}", String::from_utf8_lossy(&output.stderr));
        }
    }
    content(scratch, store);
}

#[cfg(unix)]
#[test]
fn holds_four_processes_write_at_once_and_one_is_killed() {
    four_at_once(&Scratch::new("store-four"), FILE);
}

#[test]
fn refuses_a_store_that_another_process_writes_and_files_that_are_none() {
    let scratch = Scratch::new("store-locked");
    project(&scratch, "a", 1);
    good(scratch.briefly(&format!("survey add a {FILE} --without-modes")));
    let other = database(&scratch);
    other.execute_batch("begin immediate").unwrap();
    project(&scratch, "b", 1);
    refused(
        &scratch.briefly(&format!("survey add b {FILE} --without-modes --wait 0.2")),
        "Another process is writing",
    );
    // reading goes on
    good(scratch.briefly(&format!("survey list {FILE}")));
    other.execute_batch("rollback").unwrap();
    drop(other);
    let fresh = Connection::open(scratch.path().join("other.db")).unwrap();
    fresh.execute_batch("create table t (x)").unwrap();
    drop(fresh);
    let before = fs::read(scratch.path().join("other.db")).unwrap();
    refused(
        &scratch.briefly("survey add b --store other.db"),
        "a database of another program",
    );
    refused(
        &scratch.briefly("survey list --store other.db"),
        "a database of another program",
    );
    assert_eq!(before, fs::read(scratch.path().join("other.db")).unwrap());
    let text = fs::read(scratch.path().join("b/project.toml")).unwrap();
    refused(
        &scratch.briefly("survey add b --store b/project.toml"),
        "is no database",
    );
    assert_eq!(text, fs::read(scratch.path().join("b/project.toml")).unwrap());
    refused(&scratch.briefly("survey add b --store b"), "is no regular file");
    refused(
        &scratch.briefly("survey add b --store no/such/folder/s.db"),
        "cannot be opened",
    );
    database(&scratch)
        .execute_batch("pragma user_version = 99")
        .unwrap();
    refused(
        &scratch.briefly(&format!("survey list {FILE}")),
        "later version of Dolmen",
    );
}

/// A file system of its own, of so many bytes; `None` where none may be mounted.
#[cfg(target_os = "linux")]
struct Small<'a>(&'a Scratch);

#[cfg(target_os = "linux")]
impl<'a> Small<'a> {
    fn of(scratch: &'a Scratch, size: &str) -> Option<Self> {
        let folder = scratch.path().join("small");
        fs::create_dir_all(&folder).unwrap();
        let options = format!("size={size}");
        let mounted = Command::new("mount")
            .args(["-t", "tmpfs", "-o", &options, "none"])
            .arg(&folder)
            .output();
        match mounted.is_ok_and(|output| output.status.success()) {
            true => Some(Small(scratch)),
            false => {
                use std::io::Write as _;
                let _ = writeln!(
                    std::io::stderr(),
                    "SKIPPED: no file system may be mounted here, so a full and a read-only disk are not tried"
                );
                None
            }
        }
    }

    fn remount(&self, options: &str) {
        let done = Command::new("mount")
            .args(["-o", options])
            .arg(self.0.path().join("small"))
            .status();
        assert!(done.unwrap().success());
    }
}

#[cfg(target_os = "linux")]
impl Drop for Small<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.0.path().join("small")).status();
    }
}

#[cfg(target_os = "linux")]
#[test]
fn refuses_a_full_or_read_only_disk_and_keeps_what_was_there() {
    let scratch = Scratch::new("store-full");
    let store = "--store small/s.db";
    let Some(small) = Small::of(&scratch, "2m") else {
        return;
    };
    project(&scratch, "a", 2);
    good(scratch.briefly(&format!("survey add a {store} --without-modes")));
    let before = content(&scratch, store);
    // bytes that do not compress
    let mut seed = 3;
    let noise: Vec<u8> = (0..3_000_000).map(|_| below(&mut seed, 256) as u8).collect();
    project(&scratch, "b", 1);
    fs::write(scratch.path().join("b/record-0.csv"), &noise).unwrap();
    refused(
        &scratch.briefly(&format!("survey add b {store} --without-modes")),
        "The disk is full",
    );
    assert_eq!(before, content(&scratch, store));
    // the last bytes taken by something else: the database itself finds no room
    fs::write(scratch.path().join("small/rest"), vec![0; 64]).unwrap();
    let mut rest = fs::OpenOptions::new()
        .append(true)
        .open(scratch.path().join("small/rest"))
        .unwrap();
    while std::io::Write::write_all(&mut rest, &[0; 4096]).is_ok() {}
    drop(rest);
    project(&scratch, "c", 1);
    refused(
        &scratch.briefly(&format!("survey add c {store} --without-modes")),
        "The disk is full",
    );
    fs::remove_file(scratch.path().join("small/rest")).unwrap();
    assert_eq!(before, content(&scratch, store));
    small.remount("remount,ro");
    refused(
        &scratch.briefly(&format!("survey add c {store} --without-modes")),
        "may only be read",
    );
    assert_eq!(before, content(&scratch, store));
    good(scratch.briefly(&format!("survey export a -o back {store}")));
}

#[test]
fn refuses_names_and_paths_of_strangers_as_statements_and_ways_out() {
    let scratch = Scratch::new("store-hostile");
    let hostile = [
        "x'); drop table structure; --",
        "\" or 1=1 --",
        "$1",
        "../../../etc/passwd",
        "C:\\Windows",
        "%00",
        "a/b",
        "-o",
        "한글 '이름'",
    ];
    for (at, name) in hostile.iter().enumerate() {
        let quoted = format!("'''{name}'''");
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = {{ en = {quoted} }}\n[survey.{:?}]\nnote = {quoted}\n\
             records = {{ file = \"record.csv\", sampling_rate = \"50 Hz\" }}\n",
            format!("2020 {}", name.replace('\\', "/"))
        );
        fs::write(scratch.path().join("p.toml"), text).unwrap();
        fs::write(scratch.path().join("record.csv"), format!("x\n{at}\n")).unwrap();
        good(scratch.briefly(&format!("survey add p.toml {FILE} --without-modes")));
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["survey", "export", "--store", "s.db", "-o"])
            .arg(format!("back{at}"))
            .args(["--", name])
            .current_dir(scratch.path())
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{name}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        assert!(scratch.path().join(format!("back{at}/record.csv")).is_file());
    }
    content(&scratch, FILE);
    let listed = json(&scratch, &format!("survey list {FILE}"));
    assert_eq!(listed["structures"].as_array().unwrap().len(), hostile.len());
    // a record outside the folder is not stored
    fs::create_dir_all(scratch.path().join("in")).unwrap();
    fs::write(scratch.path().join("secret.csv"), "x\n1\n").unwrap();
    let text = "schema = 1\nkind = \"survey\"\nname = \"y\"\n[survey.a.records]\nfile = \"../secret.csv\"\nsampling_rate = \"50 Hz\"\n";
    fs::write(scratch.path().join("in/project.toml"), text).unwrap();
    refused(
        &scratch.briefly(&format!("survey add in {FILE}")),
        "lies outside the folder",
    );
    let outside = scratch.briefly(&format!("survey add in {FILE} --allow-outside --without-modes"));
    refused(&outside, "it must lie in the folder of the project");
    // a store from a stranger names a file outside: nothing is written there
    for path in ["../evil.csv", "/tmp/evil.csv", "a/../../evil.csv", "x\u{7}.csv"] {
        let other = database(&scratch);
        other.execute("update project_file set path = ?1 where project = (select project from adoption where structure = 'a/b')", [path]).unwrap();
        drop(other);
        refused(
            &scratch.briefly(&format!("survey export a/b -o out {FILE}")),
            "cannot be kept",
        );
        assert!(!scratch.path().join("out").exists() && !scratch.path().join("evil.csv").exists());
    }
    // and a hash that is a path
    let other = database(&scratch);
    other.execute_batch("pragma foreign_keys = off; update project_file set path = 'r.csv', hash = '../../../secret.csv' where project = \
                         (select project from adoption where structure = 'a/b'); \
                         insert into raw values ('../../../../../../../../../../../../../../../../../../../etc/pwd', 4, 0)").unwrap();
    drop(other);
    assert_eq!(
        scratch
            .briefly(&format!("survey export a/b -o out {FILE}"))
            .status,
        2
    );
    assert_eq!(scratch.briefly(&format!("survey verify {FILE}")).status, 1);
    let bad = Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args([
            "survey",
            "add",
            "p.toml",
            "--store",
            "t.db",
            "--name",
            "a\u{1b}[2Jb",
        ])
        .current_dir(scratch.path())
        .output()
        .unwrap();
    refused(&Answer::of(&bad), "without control characters");
    assert!(!String::from_utf8_lossy(&bad.stderr).contains('\u{1b}'));
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
        // the pipe holds it up: it lives until the last bytes are read
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
    // SQLite's own cache of pages is 2 MB at most; the list itself is 9 MB
    assert!(
        few > 0.0 && many < few + 4096.0,
        "{few} KiB for 2,000 surveys, {many} KiB for 60,000"
    );
}
