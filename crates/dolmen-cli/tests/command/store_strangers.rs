// SOURCE     docs/store.md.
// GOAL       Names and paths from strangers never act as SQL statements and never lead out of a folder.
// TOLERANCE  none: bytes, rows, words and exit statuses.

use super::stores::{FILE, content, database, good, json, refused};
use super::verbs::{Answer, Scratch};
use std::fs;
use std::process::Command;

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
    // a foreign store names a file outside: nothing is written there
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
