// SOURCE     docs/project-file.md, files that outputs replace; docs/store.md, what a store bears.
// GOAL       Killed at any of its system calls that write, every writer leaves each file either old or complete. The same command then
//            finishes the work without --force and leaves no hidden file.
// PARAMETERS strace kills at call N of its kind, at the first and the last of each kind, for some writers. DOLMEN_KILLS: number of
//            kills for each kind of call, spread over all calls, for every writer.
// TOLERANCE  none: bytes and names.

use super::folders::files;
use super::verbs::{Answer, Scratch};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write as _;
use std::os::unix::process::ExitStatusExt as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// System calls that write to a disk.
const CALLS: [&str; 12] = [
    "openat",
    "write",
    "pwrite64",
    "rename",
    "renameat2",
    "linkat",
    "unlink",
    "mkdir",
    "rmdir",
    "fsync",
    "fdatasync",
    "ftruncate",
];

/// A command that writes into `out`, over the files that `before` wrote.
struct Writer {
    before: String,
    command: String,
}

fn writer(before: &str, command: &str) -> Writer {
    Writer {
        before: before.to_owned(),
        command: command.to_owned(),
    }
}

fn put_back(folder: &Path, files: &BTreeMap<PathBuf, Vec<u8>>) {
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder).unwrap();
    for (name, bytes) in files {
        let target = folder.join(name);
        fs::create_dir_all(target.parent().unwrap()).unwrap();
        fs::write(target, bytes).unwrap();
    }
}

/// Hidden files: our list, and files that are not renamed yet.
fn is_hidden(name: &Path) -> bool {
    name.file_name().unwrap().to_string_lossy().starts_with('.')
}

struct Traced<'a>(&'a Scratch);

impl Traced<'_> {
    fn run(&self, options: &[&str], words: &str) -> std::process::Output {
        Command::new("strace")
            .args(["-f", "-qq"])
            .args(options)
            .arg(env!("CARGO_BIN_EXE_dolmen"))
            .args(words.split_whitespace())
            .current_dir(self.0.path())
            .env("LC_ALL", "C.UTF-8")
            .output()
            .unwrap()
    }

    /// For each call, the number made by the thread that makes it most often; for calls that open files, which ones create or change a file.
    fn calls(&self, words: &str) -> BTreeMap<String, Vec<usize>> {
        let log = self.0.path().join("trace");
        let trace = format!("trace={}", CALLS.join(","));
        self.run(&["-o", log.to_str().unwrap(), "-e", &trace], words);
        let text = fs::read_to_string(&log).unwrap();
        let mut counts: BTreeMap<(String, String), usize> = BTreeMap::new();
        let mut found: BTreeMap<String, BTreeSet<usize>> = BTreeMap::new();
        for line in text.lines() {
            let Some((thread, call)) = line.split_once(' ') else {
                continue;
            };
            let Some((name, rest)) = call.trim_start().split_once('(') else {
                continue;
            };
            let count = counts.entry((thread.to_owned(), name.to_owned())).or_default();
            *count += 1;
            let changes = match name {
                "openat" => rest.contains("O_CREAT"),
                // to the terminal
                "write" => !rest.starts_with("1,") && !rest.starts_with("2,"),
                _ => true,
            };
            if changes {
                found.entry(name.to_owned()).or_default().insert(*count);
            }
        }
        found
            .into_iter()
            .map(|(name, at)| (name, at.into_iter().collect()))
            .collect()
    }

    /// Whether the process was killed before it ended.
    fn killed(&self, words: &str, call: &str, at: usize) -> bool {
        let inject = format!("inject={call}:signal=KILL:when={at}");
        let output = self.run(
            &["-o", "/dev/null", "-e", &format!("trace={call}"), "-e", &inject],
            words,
        );
        output.status.signal() == Some(9) || output.status.code() == Some(128 + 9)
    }
}

/// At most `most` of them, including the first and the last.
fn spread(all: &[usize], most: usize) -> Vec<usize> {
    match all.len() <= most {
        true => all.to_vec(),
        false => (0..most)
            .map(|k| all[k * (all.len() - 1) / (most - 1).max(1)])
            .collect(),
    }
}

fn can_trace() -> bool {
    let tried = Command::new("strace")
        .args(["-qq", "-o", "/dev/null", "true"])
        .status();
    let can = tried.is_ok_and(|status| status.success());
    if !can {
        let _ = writeln!(
            std::io::stderr(),
            "SKIPPED: kills at each system call are not tried; install strace (apt-get install strace)"
        );
    }
    can
}

fn asked() -> Option<usize> {
    std::env::var("DOLMEN_KILLS").ok()?.parse().ok()
}

fn kills_of_each() -> usize {
    asked().unwrap_or(2)
}

/// Kills `writer` at each of its calls in turn, and returns the number of kills. `compare` tells which files must be complete.
fn kill_at_each_call(scratch: &Scratch, writer: &Writer, compare: impl Fn(&Path) -> bool) -> usize {
    let (out, traced) = (scratch.path().join("out"), Traced(scratch));
    let ends = |words: &str| -> Answer {
        let answer = scratch.briefly(words);
        assert!(
            answer.status < 2 || answer.status == 3,
            "{words}: {}",
            answer.stderr
        );
        answer
    };
    put_back(&out, &BTreeMap::new());
    if !writer.before.is_empty() {
        ends(&writer.before);
    }
    let before = files(&out);
    let calls = traced.calls(&writer.command);
    let whole = files(&out);
    let mut kills = 0;
    for (call, at) in &calls {
        for &at in &spread(at, kills_of_each()) {
            let context = format!("{}: killed at {call} {at}", writer.command);
            put_back(&out, &before);
            kills += usize::from(traced.killed(&writer.command, call, at));
            let left = files(&out);
            for (name, bytes) in left.iter().filter(|(name, _)| !is_hidden(name) && compare(name)) {
                let is_old = before.get(name) == Some(bytes);
                let is_new = whole.get(name) == Some(bytes);
                assert!(
                    is_old || is_new,
                    "{context}: {} is neither whole nor as it was",
                    name.display()
                );
            }
            for name in before.keys() {
                assert!(left.contains_key(name), "{context}: {} is gone", name.display());
            }
            // a complete folder is not started again
            if !(writer.command.starts_with("new ") && left == whole) {
                ends(&writer.command);
            }
            let after = files(&out);
            for (name, bytes) in whole.iter().filter(|(name, _)| !is_hidden(name) && compare(name)) {
                assert!(
                    after.get(name) == Some(bytes),
                    "{context}, then again: {}",
                    name.display()
                );
            }
            let parts: Vec<&PathBuf> = after
                .keys()
                .filter(|name| name.to_string_lossy().contains(".part"))
                .collect();
            assert!(parts.is_empty(), "{context}, then again: {parts:?} is left");
        }
    }
    kills
}

#[test]
fn holds_whole_files_whatever_system_call_a_writer_is_killed_at() {
    if !can_trace() {
        return;
    }
    let scratch = Scratch::with_examples("killed");
    let pole = fs::read_to_string(scratch.path().join("examples/naju_flagpole/project.toml")).unwrap();
    let study = "[study.s]\nvariants = [\"loose\", \"wedged\"]\nmotions = [\"el-centro-1940-ns\"]\npeak = [\"0.1 g\", \"0.2 g\"]\nrefine = 0\n";
    let short = format!("{}\n{study}", pole.split("[study").next().unwrap());
    fs::write(scratch.path().join("short.toml"), short).unwrap();
    let report = |ending: &str| {
        let of = |date: &str| format!("report examples/naju_flagpole --date {date} -o out/answer.{ending}");
        writer(&of("2026-05-12"), &of("2026-06-13"))
    };
    let convert = |ending: &str| {
        let of = |scale: &str| {
            format!("motion --motion el-centro-1940-ns --scale {scale} --convert out/answer.{ending}")
        };
        writer(&of("1"), &of("0.5"))
    };
    let simulate = |scale: &str| {
        let pole = "examples/naju_flagpole/published_criterion.toml";
        format!("simulate {pole} --motion el-centro-1940-ns --scale {scale} -o out/simulated")
    };
    let mut writers = vec![
        report("html"),
        convert("csv"),
        writer(&simulate("1"), &simulate("0.5")),
        writer("", "study short.toml -o out/studied"),
        writer("", "new flagpole out/pole"),
    ];
    if asked().is_some() {
        writers.extend(["docx", "xlsx", "hwpx"].map(report));
        if cfg!(feature = "pdf") {
            writers.push(report("pdf"));
        }
        writers.extend([
            convert("at2"),
            writer("", "draw examples/three_storey_pagoda -o out/answer.svg"),
            writer("", "identify examples/palisaden -o out/identified"),
        ]);
    }
    let kills: usize = writers
        .iter()
        .map(|writer| {
            // a study records how long each run took
            kill_at_each_call(&scratch, writer, |name| {
                !name.to_string_lossy().contains("studied")
            })
        })
        .sum();
    assert!(kills > 30, "{kills}");
    if asked().is_some() {
        let _ = writeln!(std::io::stderr(), "{kills} kills of {} writers", writers.len());
    }
}

/// SQLite writes pages in place, so its file has more than two states; it must verify, and nothing may be lost.
#[test]
fn holds_a_store_verifies_whatever_system_call_an_import_is_killed_at() {
    if !can_trace() {
        return;
    }
    let scratch = Scratch::new("killed-store");
    let survey = |date: &str, hz: &str| {
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"x\"\n[survey.\"{date}\"]\nfrequencies = {{ x = [\"{hz} Hz\"] }}\n"
        );
        let folder = scratch.path().join(date);
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("project.toml"), text).unwrap();
        format!("survey add {date} --store out/s.db")
    };
    let (first, second) = (survey("2024-05-01", "2.0"), survey("2025-05-01", "1.9"));
    let (out, traced) = (scratch.path().join("out"), Traced(&scratch));
    put_back(&out, &BTreeMap::new());
    assert_eq!(scratch.briefly(&first).status, 0);
    let before = files(&out);
    let calls = traced.calls(&second);
    let list = "survey list --store out/s.db";
    let whole = scratch.briefly(list).stdout;
    let mut kills = 0;
    for (call, at) in &calls {
        for &at in &spread(at, kills_of_each()) {
            put_back(&out, &before);
            kills += usize::from(traced.killed(&second, call, at));
            let verified = scratch.briefly("survey verify --store out/s.db");
            assert_eq!(
                verified.status, 0,
                "{call} {at}: {}{}",
                verified.stdout, verified.stderr
            );
            let again = scratch.briefly(&second);
            assert_eq!(again.status, 0, "{call} {at}: {}", again.stderr);
            assert_eq!(scratch.briefly(list).stdout, whole, "{call} {at}");
        }
    }
    assert!(kills > 8, "{kills}");
}
