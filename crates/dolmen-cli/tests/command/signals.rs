// SOURCE     Signals of schedulers, terminals and shells: SIGTERM, SIGHUP, and SIGXFSZ of `ulimit -f`.
// GOAL       A run that receives a signal keeps its results; exceeding the file size limit is a write error, and the old file stays complete.
// TOLERANCE  none: words, files and exit statuses.

use super::verbs::{Answer, Scratch};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A stone under noise: 3 heights × 4 motions × 8 scales.
const STONE: &str = r#"
schema = 1
kind = "stack"
name = "A stone"
density = 2600
joint = { friction = 0.7 }
blocks = [{ name = "foot", width = 1.0, height = 0.3 }, { name = "stone", width = 0.3, height = 0.9 }]

[study.height]
vary = { "blocks[2].height" = [0.7, 0.9, 1.1] }
artificial = { count = 4, duration_s = 20, strong_s = 4 }
scale = { from = 1, to = 8, steps = 8 }
points = 16
"#;

/// Starts the study through a shell, which first runs `before`.
fn started(scratch: &Scratch, before: &str) -> Child {
    fs::write(scratch.path().join("project.toml"), STONE).unwrap();
    let dolmen = env!("CARGO_BIN_EXE_dolmen");
    Command::new("sh")
        .args([
            "-c",
            &format!("{before} exec '{dolmen}' study . -o cut --threads 1"),
        ])
        .current_dir(scratch.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn journal(scratch: &Scratch) -> PathBuf {
    scratch.path().join("cut/height/journal.tsv")
}

fn lines(journal: &Path) -> usize {
    fs::read_to_string(journal).map_or(0, |text| text.lines().count())
}

/// Waits until the journal has `wanted` lines, and sends a signal.
fn send(child: &Child, name: &str, journal: &Path, wanted: usize) {
    let begun = Instant::now();
    while lines(journal) < wanted {
        assert!(begun.elapsed() < Duration::from_secs(60));
        sleep(Duration::from_millis(1));
    }
    let sent = Command::new("kill")
        .args([&format!("-{name}"), &child.id().to_string()])
        .status()
        .unwrap();
    assert!(sent.success());
}

/// Whether this process, and so its children, ignores a hang-up, as under `nohup`.
fn hang_up_is_passed_over() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.is_none_or(|digits| u64::from_str_radix(digits.trim(), 16).is_ok_and(|mask| mask & 1 == 1))
}

#[test]
fn holds_a_terminated_study_keeps_what_is_done_and_goes_on() {
    for name in ["TERM", "HUP"] {
        if name == "HUP" && hang_up_is_passed_over() {
            continue;
        }
        let scratch = Scratch::new(&format!("ended-{name}"));
        let child = started(&scratch, "");
        send(&child, name, &journal(&scratch), 5);
        let ended = Answer::of(&child.wait_with_output().unwrap());
        assert_eq!(ended.status, 3, "{name}: {}{}", ended.stdout, ended.stderr);
        assert!(ended.stdout.contains("Not finished"), "{name}: {}", ended.stdout);
        let kept = lines(&journal(&scratch)) - 1;
        let resumed = scratch.dolmen("study . -o cut");
        let said = format!("{kept} runs are kept from before");
        assert!(
            resumed.status == 0 && kept >= 4 && resumed.stderr.contains(&said),
            "{name}, {kept}: {}",
            resumed.stderr
        );
    }
}

#[test]
fn holds_a_hang_up_that_is_passed_over_ends_nothing() {
    let scratch = Scratch::new("nohup");
    let child = started(&scratch, "trap '' HUP;");
    send(&child, "HUP", &journal(&scratch), 5);
    let ended = Answer::of(&child.wait_with_output().unwrap());
    assert_eq!(ended.status, 0, "{}{}", ended.stdout, ended.stderr);
}

#[test]
fn refuses_to_write_beyond_the_limit_of_the_system_and_leaves_the_old_file() {
    let scratch = Scratch::new("limit");
    assert_eq!(scratch.dolmen("new flagpole pole").status, 0);
    assert_eq!(scratch.dolmen("report pole -o page.html").status, 0);
    let old = fs::read(scratch.path().join("page.html")).unwrap();
    let dolmen = env!("CARGO_BIN_EXE_dolmen");
    let limited = |words: &str| {
        let shell = Command::new("sh")
            .args(["-c", &format!("ulimit -f 8; exec '{dolmen}' {words}")])
            .current_dir(scratch.path())
            .output();
        Answer::of(&shell.unwrap())
    };
    let answer = limited("report pole -o page.html");
    assert_eq!(answer.status, 2, "{}{}", answer.stdout, answer.stderr);
    assert!(
        answer
            .stderr
            .contains("bytes of page.html: the system allows no file as large"),
        "{}",
        answer.stderr
    );
    assert_eq!(fs::read(scratch.path().join("page.html")).unwrap(), old);
    let left: Vec<_> = fs::read_dir(scratch.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name())
        .filter(|name| name.to_string_lossy().ends_with(".part"))
        .collect();
    assert!(left.is_empty(), "{left:?}");
    let answer = limited("check pole --json > long.json");
    assert_eq!(answer.status, 2, "{}", answer.stderr);
    assert!(
        answer.stderr.contains("cannot write to standard output"),
        "{}",
        answer.stderr
    );
}
