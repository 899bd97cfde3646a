// SOURCE     docs/project-file.md, files that outputs replace.
// GOAL       On a disk that is full every writer says so and ends with status 2; what was there before stays as it was, and nothing half written is left.
// PARAMETERS a file system of 4 MiB in memory, of which 8 KiB are free.
// TOLERANCE  none: bytes, names and exit statuses.

use super::store_disks::Small;
use super::verbs::Scratch;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write as _;
use std::path::Path;

/// All files of a folder and below, hidden ones too, by name.
fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut left = vec![folder.to_owned()];
    while let Some(next) = left.pop() {
        for path in fs::read_dir(next).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                left.push(path);
            } else {
                found.insert(path.display().to_string(), fs::read(&path).unwrap());
            }
        }
    }
    found
}

/// Takes the room of the disk but for so many bytes.
fn fill(folder: &Path, free: usize) {
    let rest = folder.join("rest");
    let mut file = fs::OpenOptions::new()
        .create(true)
        .append(true)
        .open(&rest)
        .unwrap();
    while file.write_all(&[0; 4096]).is_ok() {}
    drop(file);
    let length = fs::metadata(&rest).unwrap().len();
    let file = fs::OpenOptions::new().write(true).open(&rest).unwrap();
    file.set_len(length.saturating_sub(free as u64)).unwrap();
}

#[test]
fn refuses_a_full_disk_whatever_writes_and_keeps_the_whole_file_that_was_there() {
    let scratch = Scratch::with_examples("full-disk");
    let Some(_small) = Small::of(&scratch, "4m") else {
        return;
    };
    let folder = scratch.path().join("small");
    let pole = fs::read_to_string(scratch.path().join("examples/naju_flagpole/project.toml")).unwrap();
    let study = "[study.s]\nvariants = [\"loose\", \"wedged\"]\nmotions = [\"el-centro-1940-ns\"]\npeak = [\"0.1 g\", \"0.2 g\"]\nrefine = 0\n";
    let short = format!("{}\n{study}", pole.split("[study").next().unwrap());
    fs::write(scratch.path().join("short.toml"), short).unwrap();
    let report =
        |ending: &str| format!("report examples/naju_flagpole --date 2026-05-12 -o small/answer.{ending}");
    let mut commands: Vec<String> = ["html", "docx", "xlsx", "hwpx"].map(report).to_vec();
    if cfg!(feature = "pdf") {
        commands.push(report("pdf"));
    }
    commands.extend(
        [
            "motion --motion el-centro-1940-ns --convert small/answer.csv",
            "motion --motion el-centro-1940-ns --convert small/answer.at2",
            "draw examples/three_storey_pagoda -o small/answer.svg",
            "identify examples/palisaden -o small/identified",
            "simulate examples/naju_flagpole/published_criterion.toml --motion el-centro-1940-ns -o small/simulated",
            "study short.toml -o small/studied",
        ]
        .map(str::to_owned),
    );
    for command in commands {
        for entry in fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            match entry.is_dir() {
                true => fs::remove_dir_all(entry).unwrap(),
                false => fs::remove_file(entry).unwrap(),
            }
        }
        // one file replaces an earlier one of ours; a folder is new
        let is_file = command.contains("small/answer.");
        if is_file {
            let first = scratch.dolmen(&command);
            assert!(first.status < 2, "{command}: {}", first.stderr);
        }
        fill(&folder, 8192);
        let before = content(&folder);
        let answer = scratch.dolmen(&command);
        assert_eq!(answer.status, 2, "{command}: {}{}", answer.stdout, answer.stderr);
        assert!(
            answer.stderr.contains("cannot write small/")
                && answer.stderr.contains("No space left on device"),
            "{command}: {}",
            answer.stderr
        );
        let after = content(&folder);
        // the list of our files names what was to come as well
        let is_list = |name: &str| name.ends_with(".dolmen-files");
        for (name, bytes) in before.iter().filter(|(name, _)| !is_list(name)) {
            assert!(
                after.get(name) == Some(bytes),
                "{command}: {name} is not what it was"
            );
        }
        for name in after
            .keys()
            .filter(|name| !before.contains_key(*name) && !is_list(name))
        {
            assert!(!is_file && !name.contains(".part"), "{command}: {name} is left");
        }
        // with room again the same command goes on, and needs no --force
        fs::remove_file(folder.join("rest")).unwrap();
        let again = scratch.dolmen(&command);
        assert!(
            again.status < 2 || again.status == 3,
            "{command}: {}",
            again.stderr
        );
    }
}
