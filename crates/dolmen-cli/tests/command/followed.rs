// SOURCE     docs/watch.md, "Records as they come".
// GOAL       A record in the watched folder becomes a survey, once, as if added by hand; unreadable files are put aside and nothing is lost.
// TOLERANCE  none: words, rows, files, exit statuses.

use super::store_processes::{acknowledged_of, moments};
use super::stores::{below, content, good, json, refused};
use super::verbs::{Answer, Scratch};
use serde_json::Value;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, SystemTime};

pub(super) const STORE: &str = "--store s.db";
/// Files in the tests are old, so they are complete; files written during the test are not.
pub(super) const FOLLOW: &str = "watch --follow in --store s.db --once --quiet";

/// Three channels of an oscillator of 2 % damping under noise, 100 Hz, by its difference equation.
pub(crate) fn made_record(frequency_hz: f64, samples: usize, seed: u64) -> String {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(1);
    let mut noise = move || {
        let mut sum = -6.0;
        for _ in 0..12 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            sum += (state >> 11) as f64 / (1u64 << 53) as f64;
        }
        sum
    };
    let (zeta, step) = (0.02, 0.01);
    let omega = std::f64::consts::TAU * frequency_hz;
    let decay = (-zeta * omega * step).exp();
    let [one, two] = [
        2.0 * decay * (omega * (1.0 - zeta * zeta).sqrt() * step).cos(),
        -decay * decay,
    ];
    let mut text = "low,high,mid\n".to_owned();
    let (mut last, mut before) = (0.0, 0.0);
    for _ in 0..samples {
        let now: f64 = one * last + two * before + noise();
        (before, last) = (last, now);
        let [low, high, mid] = [0.5, 1.0, 0.8].map(|part| part * now + 0.3 * noise());
        text += &format!("{low:.4},{high:.4},{mid:.4}\n");
    }
    text
}

/// Writes a file with an old date.
pub(crate) fn put(path: &Path, content: impl AsRef<[u8]>) {
    fs::write(path, content).unwrap();
    let file = fs::File::options().write(true).open(path).unwrap();
    file.set_modified(SystemTime::now() - Duration::from_secs(3600))
        .unwrap();
}

pub(super) const HEAD: &str = "schema = 1\nkind = \"survey\"\nname = { en = \"Gate\" }\n";
pub(super) const RECORDS: &str = "sampling_rate = \"100 Hz\"\nunit = \"mg\"\nchannels = [{ column = \"low\", direction = \"x\", position = [0, 0, 1] }, \
     { column = \"high\", direction = \"x\", position = [0, 0, 3] }, { column = \"mid\", direction = \"x\", position = [0, 0, 2] }]\n";

/// Stores a gate with one survey, and creates an empty watched folder.
pub(super) fn gate(scratch: &Scratch) {
    gate_in(scratch, STORE);
}

/// The same in the store that these arguments name.
pub(super) fn gate_in(scratch: &Scratch, store: &str) {
    fs::create_dir_all(scratch.path().join("p")).unwrap();
    fs::create_dir_all(scratch.path().join("in")).unwrap();
    fs::write(scratch.path().join("p/first.csv"), made_record(2.0, 6000, 1)).unwrap();
    let text = format!("{HEAD}[survey.2026-01-01.records]\nfile = \"first.csv\"\n{RECORDS}");
    fs::write(scratch.path().join("p/project.toml"), text).unwrap();
    good(scratch.briefly(&format!("survey add p {store}")));
}

/// The printed result of each record.
fn lines(answer: &Answer) -> Vec<Value> {
    assert!(answer.status <= 1, "{}{}", answer.stdout, answer.stderr);
    answer
        .stdout
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

fn names(scratch: &Scratch) -> Vec<String> {
    names_in(scratch, STORE)
}

pub(super) fn names_in(scratch: &Scratch, store: &str) -> Vec<String> {
    let kept = json(scratch, &format!("survey show Gate {store}"));
    let surveys = kept["surveys"].as_array().unwrap();
    surveys
        .iter()
        .map(|survey| survey["name"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn holds_records_that_came_say_what_a_project_with_them_says() {
    let scratch = Scratch::new("follow-same");
    gate(&scratch);
    let mut by_hand = fs::read_to_string(scratch.path().join("p/project.toml")).unwrap();
    fs::create_dir_all(scratch.path().join("hand")).unwrap();
    fs::copy(
        scratch.path().join("p/first.csv"),
        scratch.path().join("hand/first.csv"),
    )
    .unwrap();
    // the last two days have several records, and the last day has changed
    for (at, name) in [
        "2026-01-02",
        "2026-01-03",
        "2026-01-04 09h30",
        "2026-01-04 12h00",
        "2026-01-04 18h00",
    ]
    .iter()
    .enumerate()
    {
        let record = made_record(2.0, 6000, at as u64 + 2);
        put(&scratch.path().join(format!("in/gate {name}.csv")), &record);
        fs::write(scratch.path().join(format!("hand/{at}.csv")), record).unwrap();
        let survey = match name.split_once(' ') {
            Some((day, time)) => format!("{day}T{}:00", time.replace('h', ":")),
            None => (*name).to_owned(),
        };
        by_hand += &format!("[survey.\"{survey}\"]\nrecords.file = \"{at}.csv\"\n");
        by_hand += &RECORDS
            .lines()
            .map(|line| format!("records.{line}\n"))
            .collect::<String>();
    }
    fs::write(scratch.path().join("hand/project.toml"), by_hand).unwrap();
    let said = lines(&scratch.briefly(&format!("{FOLLOW} --json")));
    let surveys: Vec<&str> = said.iter().map(|line| line["survey"].as_str().unwrap()).collect();
    assert_eq!(
        surveys,
        [
            "2026-01-02",
            "2026-01-03",
            "2026-01-04T09:30:00",
            "2026-01-04T12:00:00",
            "2026-01-04T18:00:00"
        ]
    );
    assert!(
        said.iter()
            .all(|line| line["date_from"] == "file_name" && line["modes"][0]["frequency_hz"].is_number())
    );
    let of = |folder: &str| json(&scratch, &format!("watch {folder}"));
    good(scratch.briefly(&format!("survey export Gate -o out {STORE}")));
    let (mut by_hand, mut exported) = (of("hand"), of("out"));
    assert_eq!(exported["surveys"].as_array().unwrap().len(), 4, "{exported}");
    assert_eq!(exported["several_of_one_day"][0]["surveys"], 3);
    for answer in [&mut by_hand, &mut exported] {
        answer["project"] = Value::Null;
    }
    assert_eq!(by_hand, exported);
    // the store alone gives the same
    let all = json(&scratch, &format!("watch --all {STORE}"));
    assert_eq!(all["structures"][0]["history"]["surveys"], 4);
    let before = content(&scratch, STORE);
    assert_eq!(
        lines(&scratch.briefly(&format!("{FOLLOW} --json"))),
        Vec::<Value>::new()
    );
    assert_eq!(before, content(&scratch, STORE));
    // an exported project can be added again: the same surveys
    good(scratch.briefly(&format!("survey add out {STORE}")));
    assert_eq!(names(&scratch).len(), 6);
    let listed = json(&scratch, &format!("survey list {STORE}"));
    assert_eq!(listed["structures"][0]["surveys"], 6);
    assert_eq!(listed["structures"][0]["last_survey"], "2026-01-04");
    // and another store can import all of it
    good(scratch.briefly("survey import s.db --store copy.db"));
    assert_eq!(content(&scratch, STORE), content(&scratch, "--store copy.db"));
}

#[test]
fn holds_what_cannot_be_read_goes_to_quarantine_and_what_grows_is_left_alone() {
    let scratch = Scratch::new("follow-quarantine");
    gate(&scratch);
    let inbox = scratch.path().join("in");
    let hostile = [
        "$(touch shell) `touch shell` \"a\" 'b'.csv",
        "; touch shell;\n.csv",
        "--store.csv",
        "a..csv",
    ];
    for (at, name) in hostile.iter().enumerate() {
        put(&inbox.join(name), made_record(2.0, 6000, at as u64 + 2));
    }
    put(&inbox.join("broken.csv"), "low,other\n1,2\n");
    put(&inbox.join("binary"), [0u8, 159, 146, 150, 255, 0]);
    let growing = inbox.join("growing.csv");
    let whole = made_record(2.0, 6000, 9);
    fs::write(&growing, &whole[..whole.len() / 2]).unwrap();
    // it grows while the command waits once for new files
    let (path, rest) = (growing.clone(), whole[whole.len() / 2..].to_owned());
    let writer = std::thread::spawn(move || {
        let mut file = fs::File::options().append(true).open(&path).unwrap();
        for piece in rest.as_bytes().chunks(rest.len() / 100) {
            std::thread::sleep(Duration::from_millis(40));
            file.write_all(piece).unwrap();
        }
    });
    let answer = scratch.briefly(&format!("{FOLLOW} --rest 2 --metrics in/m.prom --json"));
    let said = lines(&answer);
    writer.join().unwrap();
    assert_eq!(
        said.iter().filter(|line| line["survey"].is_string()).count(),
        hostile.len(),
        "{said:?}"
    );
    assert!(said.iter().all(|line| line["file"] != "growing.csv"), "{said:?}");
    let names: Vec<&str> = said.iter().filter_map(|line| line["file"].as_str()).collect();
    assert!(names.iter().all(|name| !name.contains('\n')), "{names:?}");
    let aside = |name: &str| fs::read(inbox.join("quarantine").join(name)).unwrap();
    assert_eq!(aside("broken.csv"), b"low,other\n1,2\n");
    let why = String::from_utf8(aside("broken.csv.why.txt")).unwrap();
    assert!(why.contains("high"), "{why}");
    assert_eq!(aside("binary"), [0u8, 159, 146, 150, 255, 0]);
    let metrics = fs::read_to_string(inbox.join("m.prom")).unwrap();
    assert!(
        metrics.contains("dolmen_quarantined_files{structure=\"Gate\"} 2"),
        "{metrics}"
    );
    assert!(!inbox.join("shell").exists() && !scratch.path().join("shell").exists());
    // a processed file lies where it was, byte for byte
    for (at, name) in hostile.iter().enumerate() {
        assert_eq!(
            fs::read_to_string(inbox.join(name)).unwrap(),
            made_record(2.0, 6000, at as u64 + 2)
        );
    }
    // once complete, it is stored whole; files in quarantine stay there
    put(&growing, &whole);
    put(&inbox.join("broken.csv"), "low,other\n3,4\n");
    let korean = scratch.briefly(&format!("{FOLLOW} --language ko --metrics in/m.prom"));
    assert!(
        korean.status <= 1 && korean.stdout.lines().count() == 2,
        "{}{}",
        korean.stdout,
        korean.stderr
    );
    assert!(
        korean.stdout.contains("읽을 수 없어") && korean.stdout.contains("2-broken.csv"),
        "{}",
        korean.stdout
    );
    content(&scratch, STORE);
    good(scratch.briefly(&format!("survey export Gate -o out {STORE}")));
    let exported = fs::read_dir(scratch.path().join("out/followed")).unwrap();
    assert_eq!(exported.count(), hostile.len() + 1);
}

/// Kills `watch --follow` at random moments, and checks that acknowledged records are stored exactly once, and at the end all.
pub(super) fn kill_follow_at_random_moments(scratch: &Scratch, store: &str, moments: usize) {
    const FILES: usize = 5;
    gate_in(scratch, store);
    let follow = format!("watch --follow in {store} --once --quiet --json");
    let (mut seed, mut killed, mut whole_us, mut told) = (11, 0, 0, Vec::new());
    for moment in 0..=moments {
        for file in 0..FILES {
            let name = format!("in/2026-02-{:02}T{file:02}00.csv", moment + 1);
            put(
                &scratch.path().join(name),
                made_record(2.0, 6000, (moment * FILES + file) as u64 + 2),
            );
        }
        let begun = std::time::Instant::now();
        let mut child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(follow.split_whitespace())
            .current_dir(scratch.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        if moment > 0 {
            std::thread::sleep(Duration::from_micros(below(&mut seed, whole_us)));
            child.kill().unwrap();
        }
        let output = child.wait_with_output().unwrap();
        if moment == 0 {
            whole_us = begun.elapsed().as_micros() as u64;
            assert_eq!(acknowledged_of(&output.stdout, "survey").len(), FILES);
        }
        killed += usize::from(output.status.code().is_none());
        told.extend(acknowledged_of(&output.stdout, "survey"));
        content(scratch, store);
        let there = names_in(scratch, store);
        for name in &told {
            assert_eq!(
                there.iter().filter(|kept| *kept == name).count(),
                1,
                "{name}: {there:?}"
            );
        }
    }
    assert!(
        killed * 2 > moments,
        "{killed} of {moments} were killed before their end"
    );
    lines(&scratch.briefly(&follow));
    let mut there = names_in(scratch, store);
    assert_eq!(there.len(), 1 + (moments + 1) * FILES);
    there.sort();
    there.dedup();
    assert_eq!(there.len(), 1 + (moments + 1) * FILES);
    assert!(!scratch.path().join("in/quarantine").exists());
}

#[cfg(unix)]
#[test]
fn holds_a_killed_follow_loses_nothing_that_was_acknowledged_and_stores_nothing_twice() {
    kill_follow_at_random_moments(&Scratch::new("follow-kill"), STORE, moments(20));
}

#[test]
fn holds_a_log_gives_the_temperature_of_each_record() {
    let scratch = Scratch::new("follow-temperature");
    gate(&scratch);
    let inbox = scratch.path().join("in");
    let toa5 = "\"TOA5\",\"gate\",\"CR1000\"\n\"TIMESTAMP\",\"RECORD\",\"Air_Avg\",\"Tilt\"\n\"TS\",\"RN\",\"Deg C\",\"deg\"\n\"\",\"\",\"Avg\",\"Avg\"\n\
        \"2026-01-02 06:00:00\",1,2.0,0\n\"2026-01-02 18:00:00\",2,5.04,0\n\"2026-01-03 09:30:00\",3,-7.26,0\n\"2026-01-03 10:10:00\",4,\"NAN\",0\n";
    fs::write(inbox.join("air.dat"), toa5).unwrap();
    // a day, a time with a temperature nearby, a time without one
    for (at, name) in ["2026-01-02", "2026-01-03T10-00-00", "2026-01-05T10-00-00"]
        .iter()
        .enumerate()
    {
        put(
            &inbox.join(format!("{name}.csv")),
            made_record(2.0, 6000, at as u64 + 2),
        );
    }
    let words = format!("{FOLLOW} --temperature in/air.dat --quarantine aside");
    refused(
        &scratch.briefly(&words),
        "the log has several columns: name one of Air_Avg, Tilt",
    );
    refused(
        &scratch.briefly(&format!("{words} --temperature-column Air")),
        "no column \"Air\"",
    );
    let taken = scratch.briefly(&format!("{words} --temperature-column Air_Avg"));
    assert!(
        taken.status <= 1 && taken.stdout.lines().count() == 3,
        "{}{}",
        taken.stdout,
        taken.stderr
    );
    let kept = json(&scratch, &format!("survey show Gate {STORE}"));
    let surveys = kept["surveys"].as_array().unwrap();
    let temperatures: Vec<&Value> = surveys.iter().map(|survey| &survey["temperature_c"]).collect();
    assert_eq!(
        temperatures,
        [&Value::Null, &3.5.into(), &(-7.3).into(), &Value::Null]
    );
    content(&scratch, STORE);
}

#[cfg(unix)]
#[test]
fn holds_a_follow_takes_what_comes_until_it_is_terminated() {
    let scratch = Scratch::new("follow-wait");
    gate(&scratch);
    let child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args([
            "watch", "--follow", "in", "--store", "s.db", "--every", "0.1", "--rest", "0.3", "--taken",
            "done",
        ])
        .args(["--metrics", "m.prom", "--json"])
        .current_dir(scratch.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    fs::write(
        scratch.path().join("in/2026-03-01.csv"),
        made_record(2.0, 6000, 5),
    )
    .unwrap();
    let begun = std::time::Instant::now();
    while !scratch.path().join("done/2026-03-01.csv").exists() {
        assert!(begun.elapsed() < Duration::from_secs(60));
        std::thread::sleep(Duration::from_millis(20));
    }
    let sent = Command::new("kill")
        .args(["-TERM", &child.id().to_string()])
        .status()
        .unwrap();
    assert!(sent.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert_eq!(acknowledged_of(&output.stdout, "survey"), ["2026-03-01"]);
    let metrics = fs::read_to_string(scratch.path().join("m.prom")).unwrap();
    assert!(
        metrics.contains("dolmen_open_alarms{structure=\"Gate\",kind=\"structure\"} 0"),
        "{metrics}"
    );
    assert!(!scratch.path().join("in/2026-03-01.csv").exists());
}

#[cfg(unix)]
#[test]
fn holds_a_broken_file_that_cannot_be_moved_does_not_hold_up_the_others() {
    let scratch = Scratch::new("follow-stuck");
    gate(&scratch);
    put(&scratch.path().join("in/a.csv"), "low,other\n1,2\n");
    put(
        &scratch.path().join("in/2026-01-02.csv"),
        made_record(2.0, 6000, 2),
    );
    // a file has the name of the folder to create
    fs::write(scratch.path().join("aside"), "").unwrap();
    let answer = scratch.briefly(&format!("{FOLLOW} --quarantine aside"));
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    assert!(
        answer.stderr.contains("cannot make the folder aside"),
        "{}",
        answer.stderr
    );
    assert!(answer.stdout.contains("2026-01-02") && scratch.path().join("in/a.csv").exists());
    assert_eq!(names(&scratch).len(), 2);
}

#[test]
fn refuses_a_folder_a_store_and_a_structure_that_are_not_there() {
    let scratch = Scratch::new("follow-refused");
    gate(&scratch);
    refused(
        &scratch.briefly("watch --follow none --store s.db --once"),
        "none is no folder",
    );
    refused(
        &scratch.briefly("watch --follow in --store none.db --once"),
        "no store",
    );
    assert!(!scratch.path().join("none.db").exists());
    refused(&scratch.briefly(&format!("{FOLLOW} --structure Gat")), "Gate");
    refused(
        &scratch.briefly("watch --all --follow in --store s.db"),
        "cannot be used with",
    );
    refused(&scratch.briefly("watch --once p"), "cannot be used with");
    refused(
        &scratch.briefly("watch --once --all --store s.db"),
        "cannot be used with",
    );
    fs::write(
        scratch.path().join("p/project.toml"),
        format!("{HEAD}[survey.2026]\nfrequencies.x = [2.0]\n").replace("Gate", "Bare"),
    )
    .unwrap();
    good(scratch.briefly(&format!("survey add p {STORE}")));
    refused(&scratch.briefly(FOLLOW), "the store has 2 (Bare, Gate)");
    refused(
        &scratch.briefly(&format!("{FOLLOW} --structure Bare")),
        "no survey of the project has its vibration record in one file",
    );
}

/// The same with a second mode of 5 Hz, and the upper sensor optionally reversed.
fn two_modes(seed: u64, turned: bool) -> String {
    let (one, two) = (
        made_record(2.0, 12_000, seed),
        made_record(5.0, 12_000, seed + 1000),
    );
    let numbers = |line: &str| -> Vec<f64> { line.split(',').map(|cell| cell.parse().unwrap()).collect() };
    let mut text = "low,high,mid\n".to_owned();
    for (a, b) in one.lines().zip(two.lines()).skip(1) {
        let (a, b) = (numbers(a), numbers(b));
        let sign = if turned { -1.0 } else { 1.0 };
        let (low, high, mid) = (a[0] + 2.0 * b[0], sign * (a[1] - 0.8 * b[1]), a[2] + 0.2 * b[2]);
        text += &format!("{low:.4},{high:.4},{mid:.4}\n");
    }
    text
}

#[test]
fn holds_a_copy_and_a_sensor_that_was_turned_round_are_named() {
    let scratch = Scratch::new("follow-turned");
    fs::create_dir_all(scratch.path().join("p")).unwrap();
    fs::create_dir_all(scratch.path().join("in")).unwrap();
    let mut text = HEAD.to_owned();
    for day in 1..=8 {
        let file = format!("{day}.csv");
        fs::write(scratch.path().join("p").join(&file), two_modes(day, false)).unwrap();
        text += &format!("[survey.2026-01-0{day}.records]\nfile = \"{file}\"\n{RECORDS}");
    }
    fs::write(scratch.path().join("p/project.toml"), text).unwrap();
    good(scratch.briefly(&format!("survey add p {STORE}")));
    put(
        &scratch.path().join("in/gate 2026-01-09.csv"),
        two_modes(9, false),
    );
    let sound = scratch.briefly("watch --follow in --store s.db --once");
    assert!(
        sound.stdout.contains("2026-01-09") && !sound.stdout.contains("polarity"),
        "{}",
        sound.stdout
    );
    put(
        &scratch.path().join("in/gate 2026-01-10.csv"),
        two_modes(10, true),
    );
    put(&scratch.path().join("in/copy.csv"), two_modes(9, false));
    let answer = scratch.briefly("watch --follow in --store s.db --once");
    assert!(
        answer
            .stdout
            .contains("its shapes are not those of the surveys before it"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
    assert!(
        answer
            .stderr
            .contains("copy.csv holds the same bytes as gate 2026-01-09.csv"),
        "{}",
        answer.stderr
    );
    // a record stored under its own name is no copy of itself
    assert!(
        !answer.stderr.contains("gate 2026-01-09.csv holds"),
        "{}",
        answer.stderr
    );
}
