// SOURCE     docs/store.md.
// GOAL       An acknowledged survey stays in the store exactly once, whatever happens to the process; a busy store, or a file that is not a
//            store, is refused.
// TOLERANCE  none: bytes, rows, words and exit statuses.

use super::stores::{FILE, below, content, database, good, json, project, refused};
use super::verbs::Scratch;
use rusqlite::Connection;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// Starts `dolmen survey add` on these projects; it prints a line of JSON for each stored one.
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

/// Names of the acknowledged structures.
pub(crate) fn acknowledged(stdout: &[u8]) -> Vec<String> {
    acknowledged_of(stdout, "structure")
}

/// Values of a key in the complete lines of JSON.
pub(crate) fn acknowledged_of(stdout: &[u8], key: &str) -> Vec<String> {
    let lines = String::from_utf8_lossy(stdout).into_owned();
    let whole = lines.split_inclusive('\n').filter(|line| line.ends_with('\n'));
    whole
        .map(|line| {
            let said: Value = serde_json::from_str(line).unwrap();
            said[key].as_str().unwrap().to_owned()
        })
        .collect()
}

/// Number of moments at which a process is killed: `few`, or DOLMEN_KILLS if set.
pub(crate) fn moments(few: usize) -> usize {
    match std::env::var_os("DOLMEN_KILLS") {
        Some(_) => 50,
        None => few,
    }
}

/// Kills `add` at random moments, and checks that acknowledged projects are stored exactly once.
pub(crate) fn kill_at_random_moments(scratch: &Scratch, store: &str, moments: usize) {
    const SURVEYS: usize = 2;
    let projects: Vec<String> = (0..4).map(|at| format!("p{at}")).collect();
    projects.iter().for_each(|name| project(scratch, name, SURVEYS));
    let (mut seed, mut killed, mut whole_us) = (7, 0, 0);
    // two undisturbed ones first
    for moment in 0..moments + 2 {
        // new bytes each time: a new state of every project
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
            // undisturbed: creates the store, then measures how long adding takes
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
    // once more, to the end: nothing is stored twice
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
            SURVEYS + moments + 2,
            "{structure}"
        );
    }
    content(scratch, store);
}

#[cfg(unix)]
#[test]
fn holds_a_killed_add_loses_nothing_that_was_acknowledged_and_stores_nothing_twice() {
    kill_at_random_moments(&Scratch::new("store-kill"), FILE, 50);
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
    // reading still works
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
