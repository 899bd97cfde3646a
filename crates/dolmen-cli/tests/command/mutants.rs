// SOURCE     fuzz/bodies: what is done with an input of each kind; fuzz/corpus, the examples and the test data: initial inputs.
// GOAL       A changed file is read or refused: no panic, no run of 10 s, and the process stays below 1 GiB.
// PARAMETERS DOLMEN_MUTANTS: mutants of each kind in place of 30 a file. Run one kind at a time (`mutants::holds_csv --exact`), so that its peak of
//            memory is its own; it is printed as a row of the table in docs/measured.md.
// TOLERANCE  none.

use super::verbs::Scratch;
use dolmen_project::parse_project_with;
use dolmen_records::MemoryFiles;
use dolmen_work::{CheckOptions, IdentifyOptions, Opened, Silent, check, identify};
use std::io::{Cursor, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

#[path = "../../../../fuzz/bodies/csv.rs"]
mod csv;
#[path = "../../../../fuzz/bodies/form.rs"]
mod form;
#[path = "../../../../fuzz/bodies/log.rs"]
mod log;
#[path = "../../../../fuzz/bodies/mesh.rs"]
mod mesh;
#[path = "../../../../fuzz/bodies/motion.rs"]
mod motion;
#[path = "../../../../fuzz/bodies/npy.rs"]
mod npy;
#[path = "../../../../fuzz/bodies/photo.rs"]
mod photo;
#[path = "../../../../fuzz/bodies/project.rs"]
mod project;
#[path = "../../../../fuzz/bodies/record.rs"]
mod record;
#[path = "../../../../fuzz/bodies/sheet.rs"]
mod sheet;
#[path = "../../../../fuzz/bodies/sites.rs"]
mod sites;
#[path = "../../../../fuzz/bodies/store.rs"]
mod store;

/// Default number of mutants of each file.
const OF_EACH: usize = 30;
/// Longer texts are cut: changes far down the samples test nothing new.
const TEXT_BYTES_MOST: usize = 6000;
/// Longest time for an input.
const SLOWEST_MOST: Duration = Duration::from_secs(10);
const MEMORY_MOST_MIB: u64 = 1024;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn files(folder: &str) -> Vec<Vec<u8>> {
    let folder = root().join(folder);
    let listed = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = listed.map(|file| file.unwrap().path()).collect();
    paths.sort();
    let read = paths.iter().filter(|path| path.is_file());
    read.map(|path| std::fs::read(path).unwrap()).collect()
}

fn kept(corpus: &str) -> Vec<Vec<u8>> {
    let found = files(&format!("fuzz/corpus/{corpus}"));
    assert!(found.len() >= 4, "{corpus}: {} files", found.len());
    found
}

/// Knuth's MMIX sequence.
struct Draw(u64);

impl Draw {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % most.max(1)
    }
}

/// Text that writers slip in, disks corrupt, or readers fail on.
const PIECES: [&[u8]; 16] = [
    b"-1",
    b"0",
    b"1e309",
    b"nan",
    b"99999999999999999999",
    b"",
    b"\xff\xfe",
    b"\"",
    b"[",
    b"}",
    b",,",
    b"\n\n",
    b"= \"unknown\"",
    b"\0\0\0\0",
    b"\xff\xff\xff\xff",
    b"\xff\xff\xff\x7f",
];

fn changed(from: &[u8], other: &[u8], draw: &mut Draw) -> Vec<u8> {
    let mut bytes = from.to_vec();
    for _ in 0..=draw.below(4) {
        let at = draw.below(bytes.len() + 1);
        let to = (at + draw.below(24)).min(bytes.len());
        match draw.below(6) {
            0 if at < bytes.len() => bytes[at] = draw.below(256) as u8,
            1 => drop(bytes.drain(at..to)),
            2 => drop(bytes.splice(at..to, PIECES[draw.below(PIECES.len())].iter().copied())),
            3 => bytes.truncate(at),
            // lengths and counts stay unchanged
            4 => {
                let piece = PIECES[draw.below(PIECES.len())];
                let end = (at + piece.len()).min(bytes.len());
                let length = end - at;
                bytes[at..end].copy_from_slice(&piece[..length]);
            }
            _ => {
                let begin = draw.below(other.len() + 1);
                let end = (begin + draw.below(200)).min(other.len());
                drop(bytes.splice(at..at, other[begin..end].iter().copied()));
            }
        }
    }
    bytes
}

/// The archive with one part changed and all checksums correct, so that it is not refused for a checksum.
fn changed_within(archive: &[u8], other: &[u8], draw: &mut Draw) -> Option<Vec<u8>> {
    let mut from = zip::ZipArchive::new(Cursor::new(archive)).ok()?;
    let changes = draw.below(from.len());
    let mut to = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for at in 0..from.len() {
        let mut part = from.by_index(at).ok()?;
        let mut bytes = Vec::new();
        part.read_to_end(&mut bytes).ok()?;
        if at == changes {
            bytes = changed(&bytes, other, draw);
        }
        let name = part.name().ok()?.into_owned();
        to.start_file(name, zip::write::SimpleFileOptions::default())
            .ok()?;
        to.write_all(&bytes).ok()?;
    }
    Some(to.finish().ok()?.into_inner())
}

/// One mutant; every second mutant of an archive is changed inside.
fn mutant(from: &[u8], other: &[u8], draw: &mut Draw) -> Vec<u8> {
    match from.starts_with(b"PK\x03\x04") && draw.below(2) == 0 {
        true => changed_within(from, other, draw).unwrap_or_else(|| changed(from, other, draw)),
        false => changed(from, other, draw),
    }
}

/// A number of kilobytes of this process from /proc by its name; `None` on other systems than Linux.
fn memory_kib(name: &str) -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with(name))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

/// Processor time of this process, to a hundredth of a second; `None` on other systems than Linux.
fn processor_time() -> Option<Duration> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    let (_, fields) = stat.rsplit_once(')')?;
    let mut ticks = fields.split_whitespace().skip(11);
    let [user, system] = [ticks.next()?, ticks.next()?].map(str::parse::<u64>);
    Some(Duration::from_millis(10 * (user.ok()? + system.ok()?)))
}

/// Runs each file and its mutants within the limits. Returns the number of inputs.
fn all(kind: &str, corpus: &[Vec<u8>], run: impl Fn(&[u8])) -> usize {
    let asked = std::env::var("DOLMEN_MUTANTS")
        .ok()
        .and_then(|count| count.parse::<usize>().ok());
    let of_each = asked.map_or(OF_EACH, |count| count.div_ceil(corpus.len()));
    let mut draw = Draw(1);
    let (mut panics, mut slowest) = (Vec::new(), Duration::ZERO);
    for (i, file) in corpus.iter().enumerate() {
        for round in 0..=of_each {
            let other = &corpus[draw.below(corpus.len())];
            let bytes = match round {
                0 => file.clone(),
                _ => mutant(file, other, &mut draw),
            };
            let (begun, before) = (Instant::now(), processor_time());
            let caught = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| run(&bytes)));
            let mut took = begun.elapsed();
            // on a busy machine only processor time is meaningful
            if took > SLOWEST_MOST
                && let (Some(before), Some(after)) = (before, processor_time())
            {
                took = after.saturating_sub(before);
            }
            slowest = slowest.max(took);
            if caught.is_err() || took > SLOWEST_MOST {
                let kept = std::env::temp_dir().join(format!("dolmen-mutant-{kind}-{i}-{round}"));
                std::fs::write(&kept, &bytes).unwrap();
                panics.push(format!("{} ({took:?})", kept.display()));
            }
        }
    }
    let runs = corpus.len() * (of_each + 1);
    if asked.is_some() {
        let peak_mib = memory_kib("VmHWM").map_or(0, |kib| kib / 1024);
        let row = format!(
            "| {kind} | {runs} | {} | {peak_mib} MiB | {:.3} s |",
            panics.len(),
            slowest.as_secs_f64()
        );
        let _ = writeln!(std::io::stderr(), "{row}");
        assert!(peak_mib < MEMORY_MOST_MIB, "{row}");
    }
    assert!(panics.is_empty(), "{kind}: {}", panics.join(", "));
    runs
}

/// Texts of limited length.
fn cut(corpus: Vec<Vec<u8>>) -> Vec<Vec<u8>> {
    let mut corpus = corpus;
    corpus.iter_mut().for_each(|file| file.truncate(TEXT_BYTES_MOST));
    corpus
}

#[test]
fn holds_csv() {
    assert!(all("csv", &cut(kept("csv")), csv::run) > 1000);
}

#[test]
fn holds_npy() {
    assert!(all("npy", &cut(kept("npy")), npy::run) > 300);
}

#[test]
fn holds_mesh() {
    assert!(all("mesh", &cut(kept("mesh")), mesh::run) > 300);
}

#[test]
fn holds_motions() {
    let mut corpus = kept("motion");
    corpus.extend(files("crates/dolmen-records/tests/data/motions"));
    assert!(all("motion", &cut(corpus), motion::run) > 1000);
}

#[test]
fn holds_projects() {
    let corpus: Vec<Vec<u8>> = projects().into_iter().map(|(text, _)| text).collect();
    let read = |bytes: &[u8]| project::run(&String::from_utf8_lossy(bytes));
    assert!(all("project", &cut(corpus), read) > 200);
}

#[test]
fn holds_record() {
    let mut written = files("crates/dolmen-records/tests/data/records");
    written.extend(files("crates/dolmen-records/tests/data/modes"));
    written.extend(kept("log").into_iter().filter(|file| file.starts_with(b"PK")));
    assert!(all("record", &written, record::run) > 500);
}

#[test]
fn holds_sheets() {
    assert!(all("sheet", &kept("sheet"), sheet::run) > 200);
}

#[test]
fn holds_photos() {
    assert!(all("photo", &kept("photo"), photo::run) > 200);
}

#[test]
fn holds_forms() {
    assert!(all("form", &kept("form"), form::run) > 100);
}

#[test]
fn holds_sites() {
    assert!(all("sites", &kept("sites"), sites::run) > 100);
}

#[test]
fn holds_logs() {
    assert!(all("log", &kept("log"), log::run) > 100);
}

#[test]
fn holds_stores() {
    let scratch = Scratch::new("mutants-store");
    let text = "schema = 1\nkind = \"survey\"\nname = \"x\"\n[survey.\"2024-05-01\".records]\nfile = \"r.csv\"\nsampling_rate = \"50 Hz\"\n";
    std::fs::write(scratch.path().join("project.toml"), text).unwrap();
    std::fs::write(scratch.path().join("r.csv"), "x\n1\n2\n3\n").unwrap();
    let made = scratch.briefly("survey add . --store s.db --without-modes");
    assert_eq!(made.status, 0, "{}", made.stderr);
    let file = std::fs::read(scratch.path().join("s.db")).unwrap();
    assert!(all("store", &[file], store::run) > 20);
}

/// The projects for fuzzing and of the examples, each with its other files.
fn projects() -> Vec<(Vec<u8>, MemoryFiles)> {
    let mut found: Vec<(Vec<u8>, MemoryFiles)> = files("fuzz/corpus/project")
        .into_iter()
        .map(|text| (text, MemoryFiles::default()))
        .collect();
    let mut examples: Vec<PathBuf> = std::fs::read_dir(root().join("examples"))
        .unwrap()
        .map(|example| example.unwrap().path())
        .collect();
    examples.sort();
    for example in examples {
        let mut beside = MemoryFiles::default();
        for file in std::fs::read_dir(&example)
            .unwrap()
            .map(|file| file.unwrap().path())
        {
            let name = file.file_name().unwrap().to_string_lossy().into_owned();
            if file.is_file() {
                beside.files.insert(name, std::fs::read(&file).unwrap());
            }
        }
        found.extend(
            std::fs::read(example.join("project.toml"))
                .ok()
                .map(|text| (text, beside)),
        );
    }
    found
}

/// Complete checks of changed projects.
#[test]
fn holds_whole_checks() {
    let projects = projects();
    let asked = std::env::var("DOLMEN_MUTANTS").is_ok();
    let texts: Vec<Vec<u8>> = projects.iter().map(|(text, _)| text.clone()).collect();
    // all files of all examples: no two records have the same name
    let mut beside = MemoryFiles::default();
    for (_, files) in projects {
        beside.files.extend(files.files);
    }
    let run = |bytes: &[u8]| {
        let text = String::from_utf8_lossy(bytes).into_owned();
        if let Ok(opened) = Opened::read(text, "fuzz".to_owned(), &beside) {
            let _ = check(&opened, &CheckOptions::default());
        }
    };
    match asked {
        true => assert!(all("check, whole", &texts, run) > 200),
        // these take seconds each: the corpus, and two mutants
        false => assert!(all("check, whole", &texts[..2], run) > 50),
    }
}

/// A record of a floor with modes at 2 and 5 Hz, as text, long enough to find the modes.
fn swaying() -> Vec<u8> {
    let mut draw = Draw(7);
    let mut text = "time_s,a,b\n".to_owned();
    let (mut states, step_s) = ([[0.0_f64; 2]; 2], 0.02);
    for i in 0..3000 {
        let push = draw.below(2001) as f64 / 1000.0 - 1.0;
        for (state, hz) in states.iter_mut().zip([2.0, 5.0]) {
            let omega = std::f64::consts::TAU * hz;
            state[1] += step_s * (push - omega * omega * state[0] - 0.04 * omega * state[1]);
            state[0] += step_s * state[1];
        }
        let [[a, _], [b, _]] = states;
        text += &format!("{:.2},{:.6},{:.6}\n", f64::from(i) * step_s, a + b, a - 0.7 * b);
    }
    text.into_bytes()
}

/// Whole identifications of changed records.
#[test]
fn holds_whole_identifications() {
    let text =
        "schema = 1\nkind = \"survey\"\nname = \"x\"\n[survey.\"2024-05-01\".records]\nfile = \"r.csv\"\n";
    let run = |bytes: &[u8]| {
        let mut beside = MemoryFiles::default();
        beside.files.insert("r.csv".to_owned(), bytes.to_vec());
        assert!(parse_project_with(text, "fuzz", &beside).is_ok());
        let opened = Opened::read(text.to_owned(), "fuzz".to_owned(), &beside).unwrap();
        let _ = identify(&opened, &IdentifyOptions::default(), &beside, &Silent);
    };
    // the unchanged record has modes
    let whole = swaying();
    let mut beside = MemoryFiles::default();
    beside.files.insert("r.csv".to_owned(), whole.clone());
    let opened = Opened::read(text.to_owned(), "fuzz".to_owned(), &beside).unwrap();
    let answer = identify(&opened, &IdentifyOptions::default(), &beside, &Silent);
    assert!(answer.is_ok(), "{answer:?}");
    assert!(all("identify, whole", &[whole], run) > 20);
}
