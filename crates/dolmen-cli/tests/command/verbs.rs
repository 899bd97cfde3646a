// SOURCE     DESIGN: verbs, exit codes, messages.
// GOAL       Each verb does on the shipped examples what its help says; bad input ends with status 2 and a sentence.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A folder of its own that is removed at the end.
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    pub(crate) fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("dolmen-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        Scratch(folder)
    }

    /// With a copy of the repository's `examples/` in it.
    pub(crate) fn with_examples(name: &str) -> Self {
        let scratch = Self::new(name);
        for example in fs::read_dir(root().join("examples"))
            .unwrap()
            .map(|e| e.unwrap().path())
        {
            let target = scratch.path().join("examples").join(example.file_name().unwrap());
            fs::create_dir_all(&target).unwrap();
            for file in fs::read_dir(example).unwrap().map(|e| e.unwrap().path()) {
                fs::copy(&file, target.join(file.file_name().unwrap())).unwrap();
            }
        }
        scratch
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn path_with_dolmen(&self) -> std::ffi::OsString {
        let own = Path::new(env!("CARGO_BIN_EXE_dolmen"))
            .parent()
            .unwrap()
            .to_owned();
        let others = std::env::var_os("PATH").unwrap_or_default();
        std::env::join_paths(std::iter::once(own).chain(std::env::split_paths(&others))).unwrap()
    }

    /// Runs `dolmen` with these words in this folder.
    pub(crate) fn dolmen(&self, words: &str) -> Answer {
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(words.split_whitespace())
            .current_dir(&self.0)
            .output()
            .unwrap();
        Answer::of(&output)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// What a run of the command printed, and its exit status.
pub(crate) struct Answer {
    pub(crate) status: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Answer {
    fn of(output: &Output) -> Self {
        Answer {
            status: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

/// An error whose reader has gone (`2>&1 | head`) still ends with its own status.
#[test]
fn holds_an_error_nobody_reads_keeps_its_status() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let status = std::process::Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args(["check", "there/is/no/such/file.toml"])
        .stderr(writer)
        .status()
        .unwrap();
    assert_eq!(status.code(), Some(2));
}

#[test]
fn holds_new_makes_a_project_and_never_overwrites() {
    let scratch = Scratch::new("new");
    for kind in ["flagpole", "gate", "survey"] {
        let made = scratch.dolmen(&format!("new {kind} {kind}"));
        assert_eq!(made.status, 0, "{}", made.stderr);
        assert!(scratch.path().join(kind).join("project.toml").is_file());
        let again = scratch.dolmen(&format!("new {kind} {kind}"));
        assert_eq!(again.status, 2);
        assert!(again.stderr.contains("is not empty"), "{}", again.stderr);
    }
}

#[test]
fn refuses_an_unknown_code_with_the_nearest() {
    let answer = Scratch::new("explain").dolmen("explain unsafe_criterion");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("Did you mean unsafe-criterion?"),
        "{}",
        answer.stderr
    );
}

#[test]
fn holds_completions_and_manual_name_every_verb() {
    let scratch = Scratch::new("man");
    let script = scratch.dolmen("completions bash").stdout;
    assert_eq!(scratch.dolmen("man pages").status, 0);
    let verbs = [
        "new",
        "check",
        "identify",
        "compare",
        "simulate",
        "report",
        "demo",
        "validate",
        "explain",
        "schema",
        "completions",
        "doctor",
    ];
    for verb in verbs {
        assert!(
            script.contains(&format!("dolmen__{verb}")) || script.contains(verb),
            "{verb}"
        );
        assert!(
            scratch.path().join(format!("pages/dolmen-{verb}.1")).is_file(),
            "{verb}"
        );
    }
}
