// SOURCE     docs/project-file.md, files that outputs replace.
// GOAL       On a full or read-only disk every writer gives the reason in both languages and ends with status 2; existing files stay
//            as they were, and no partial file remains.
// PARAMETERS a file system of 4 MiB in memory, of which 8 KiB are free.
// TOLERANCE  none: bytes, names and exit statuses.

use super::folders::files;
use super::store_disks::Small;
use super::verbs::Scratch;
use std::fs;
use std::io::Write as _;
use std::path::Path;

/// Fills the disk except for this many bytes.
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
fn refuses_a_full_or_read_only_disk_whatever_writes_and_keeps_what_was_there() {
    let scratch = Scratch::with_examples("full-disk");
    let Some(small) = Small::of(&scratch, "8m") else {
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
        // a single file replaces an earlier output; a folder is new
        let is_file = command.contains("small/answer.");
        if is_file {
            let first = scratch.dolmen(&command);
            assert!(first.status < 2, "{command}: {}", first.stderr);
        }
        fill(&folder, 8192);
        let before = files(&folder);
        let answer = scratch.dolmen(&command);
        assert_eq!(answer.status, 2, "{command}: {}{}", answer.stdout, answer.stderr);
        assert!(
            answer.stderr.contains("cannot write small/")
                && answer.stderr.contains("No space left on device"),
            "{command}: {}",
            answer.stderr
        );
        let korean = scratch.dolmen(&format!("{command} --language ko")).stderr;
        assert!(
            korean.contains("쓸 수 없다: 디스크가 가득 찼다") && !korean.contains("No space"),
            "{command}: {korean}"
        );
        let after = files(&folder);
        // the list of our files also names files that were not written yet
        let is_list = |name: &Path| name.ends_with(".dolmen-files");
        for (name, bytes) in before.iter().filter(|(name, _)| !is_list(name)) {
            assert!(
                after.get(name) == Some(bytes),
                "{command}: {} is not what it was",
                name.display()
            );
        }
        for name in after
            .keys()
            .filter(|name| !before.contains_key(*name) && !is_list(name))
            .map(|name| name.display().to_string())
        {
            assert!(!is_file && !name.contains(".part"), "{command}: {name} is left");
        }
        // with free space again, the same command continues without --force
        fs::remove_file(folder.join("rest")).unwrap();
        let again = scratch.dolmen(&command);
        assert!(
            again.status < 2 || again.status == 3,
            "{command}: {}",
            again.stderr
        );
        let whole = files(&folder);
        small.remount("remount,ro");
        let answer = scratch.dolmen(&command);
        let korean = scratch.dolmen(&format!("{command} --language ko")).stderr;
        small.remount("remount,rw");
        assert!(
            answer.status == 2 && answer.stderr.contains("Read-only file system"),
            "{command}: {}",
            answer.stderr
        );
        assert!(
            korean.contains("수 없다: 읽기 전용 디스크이다"),
            "{command}: {korean}"
        );
        assert!(files(&folder) == whole, "{command}");
    }
}
