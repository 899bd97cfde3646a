//! What fuzzing does with each input (`fuzz/bodies`), here with every file that fuzzing kept, the shipped files, and some thousand
//! that are made from them by seeded changes: read or refused, never a panic.

use std::path::{Path, PathBuf};

#[path = "../../../../fuzz/bodies/csv.rs"]
mod csv;
#[path = "../../../../fuzz/bodies/mesh.rs"]
mod mesh;
#[path = "../../../../fuzz/bodies/motion.rs"]
mod motion;
#[path = "../../../../fuzz/bodies/npy.rs"]
mod npy;
#[path = "../../../../fuzz/bodies/project.rs"]
mod project;
#[path = "../../../../fuzz/bodies/record.rs"]
mod record;

/// Files changed in so many ways each; `DOLMEN_FUZZ` in the environment asks for more.
const CHANGES: usize = 30;
/// Longer files are cut: a change far down the samples says nothing new.
const BYTES_MOST: usize = 6000;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn files(folder: &Path) -> Vec<Vec<u8>> {
    let listed = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = listed.map(|file| file.unwrap().path()).collect();
    paths.sort();
    let read = paths.iter().filter(|path| path.is_file());
    read.map(|path| std::fs::read(path).unwrap()).collect()
}

fn kept(corpus: &str) -> Vec<Vec<u8>> {
    let found = files(&root().join("fuzz/corpus").join(corpus));
    assert!(found.len() >= 10, "{corpus}: {} files", found.len());
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

/// What a writer may slip, a disk may lose, and a reader may trip over.
const PIECES: [&[u8]; 14] = [
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
];

fn changed(from: &[u8], other: &[u8], draw: &mut Draw) -> Vec<u8> {
    let mut bytes = from[..from.len().min(BYTES_MOST)].to_vec();
    for _ in 0..=draw.below(4) {
        let at = draw.below(bytes.len() + 1);
        let to = (at + draw.below(24)).min(bytes.len());
        match draw.below(5) {
            0 if at < bytes.len() => bytes[at] = draw.below(256) as u8,
            1 => drop(bytes.drain(at..to)),
            2 => drop(bytes.splice(at..to, PIECES[draw.below(PIECES.len())].iter().copied())),
            3 => bytes.truncate(at),
            _ => {
                let begin = draw.below(other.len() + 1);
                let end = (begin + draw.below(200)).min(other.len());
                drop(bytes.splice(at..at, other[begin..end].iter().copied()));
            }
        }
    }
    bytes
}

/// Each file, and what is made of it; returns how many inputs there were.
fn all(corpus: &[Vec<u8>], run: impl Fn(&[u8])) -> usize {
    let asked = std::env::var("DOLMEN_FUZZ")
        .ok()
        .and_then(|times| times.parse().ok());
    let times: usize = asked.unwrap_or(CHANGES);
    let mut draw = Draw(1);
    for (i, file) in corpus.iter().enumerate() {
        run(file);
        for _ in 0..times {
            let other = &corpus[draw.below(corpus.len())];
            let bytes = changed(file, other, &mut draw);
            let caught = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| run(&bytes)));
            if caught.is_err() {
                panic!("made of file {i}: {:?}", String::from_utf8_lossy(&bytes));
            }
        }
    }
    corpus.len() * (times + 1)
}

#[test]
fn holds_csv() {
    assert!(all(&kept("csv"), csv::run) > 1000);
}

#[test]
fn holds_npy() {
    assert!(all(&kept("npy"), npy::run) > 300);
}

#[test]
fn holds_mesh() {
    assert!(all(&kept("mesh"), mesh::run) > 300);
}

#[test]
fn holds_motions() {
    let mut corpus = kept("motion");
    corpus.extend(files(&root().join("crates/dolmen-records/tests/data/motions")));
    assert!(all(&corpus, motion::run) > 1000);
}

#[test]
fn holds_projects() {
    let mut corpus = files(&root().join("fuzz/corpus/project"));
    for example in std::fs::read_dir(root().join("examples")).unwrap() {
        let file = example.unwrap().path().join("project.toml");
        corpus.extend(std::fs::read(file).ok());
    }
    assert!(corpus.len() >= 7, "{}", corpus.len());
    let read = |bytes: &[u8]| project::run(&String::from_utf8_lossy(bytes));
    assert!(all(&corpus, read) > 200);
}

#[test]
fn holds_record() {
    let written = files(&root().join("crates/dolmen-records/tests/data/records"));
    assert!(all(&written, record::run) > 500);
}
