// SOURCE     DESIGN: verbs, exit codes, messages.
// GOAL       On the shipped examples, each verb does what its help says; bad input gives status 2 and a sentence.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A temporary folder that is removed at the end.
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    pub(crate) fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("dolmen-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        Scratch(folder)
    }

    /// A folder with a copy of the repository's `examples/`.
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

    /// Copies a record with slightly different bytes: each take rounds the last value differently.
    pub(crate) fn copy_as_take(&self, take: u8, from: &str, to: &str) {
        let mut bytes = std::fs::read(self.path().join(from)).unwrap();
        let last = bytes.len() - 8;
        bytes[last] ^= take;
        std::fs::write(self.path().join(to), bytes).unwrap();
    }

    pub(crate) fn path_with_dolmen(&self) -> std::ffi::OsString {
        let own = Path::new(env!("CARGO_BIN_EXE_dolmen"))
            .parent()
            .unwrap()
            .to_owned();
        let others = std::env::var_os("PATH").unwrap_or_default();
        std::env::join_paths(std::iter::once(own).chain(std::env::split_paths(&others))).unwrap()
    }

    /// Runs `dolmen` with these arguments in this folder, with the full answer.
    pub(crate) fn dolmen(&self, words: &str) -> Answer {
        self.briefly(&format!("{words} --full"))
    }

    /// Runs `dolmen` with these arguments in this folder.
    pub(crate) fn briefly(&self, words: &str) -> Answer {
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(words.split_whitespace())
            .current_dir(&self.0)
            .env("LC_ALL", "C.UTF-8")
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
    pub(crate) fn of(output: &Output) -> Self {
        Answer {
            status: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    /// The printed text without line breaks.
    pub(crate) fn words(&self) -> String {
        let words: Vec<&str> = self.stdout.split_whitespace().collect();
        words.join(" ")
    }
}

/// After a closed pipe (`2>&1 | head`) an error still ends with its own status.
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
fn holds_a_bare_project_has_nothing_of_another_structure() {
    let kinds = [
        "flagpole",
        "gate",
        "pagoda",
        "arch",
        "wall",
        "tower",
        "trilithon",
        "vault",
        "dome",
        "building",
        "survey",
    ];
    let scratch = Scratch::new("bare");
    for kind in kinds {
        let made = scratch.dolmen(&format!("new {kind} {kind} --bare"));
        assert_eq!(made.status, 0, "{}", made.stderr);
        let file = scratch.path().join(kind).join("project.toml");
        let text = std::fs::read_to_string(file).unwrap();
        for inherited in ["\nsource", "\ndescription", "\n[variant", "\n[study", "\n[motion"] {
            assert!(!text.contains(inherited), "{kind}: {inherited}");
        }
        let answer = scratch.dolmen(&format!("check {kind}"));
        assert_eq!(answer.status, 0, "{kind}: {}", answer.stderr);
        // the survey in a remark is a readable one
        let survey: String = text
            .lines()
            .map(|line| match line.strip_prefix("# ") {
                Some(rest) if rest.starts_with(['[', 't']) => format!("{rest}\n"),
                _ => format!("{line}\n"),
            })
            .collect();
        if kind != "survey" {
            assert!(survey.contains("\n[survey.2026-04-02]"), "{kind}");
            std::fs::write(scratch.path().join("measured.toml"), survey).unwrap();
            let answer = scratch.dolmen("check measured.toml");
            assert!(answer.status < 2, "{kind}: {}", answer.stderr);
        }
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
        "watch",
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

#[test]
fn refuses_a_record_in_place_of_a_project_in_a_few_lines() {
    let scratch = Scratch::new("record-for-project");
    let rows: String = (0..5000)
        .map(|i| format!("{:.2},{}\n", f64::from(i) / 100.0, i % 7))
        .collect();
    fs::write(scratch.path().join("roof.csv"), format!("time,x\n{rows}")).unwrap();
    for verb in ["identify", "compare", "check"] {
        let said = scratch.dolmen(&format!("{verb} roof.csv"));
        assert_eq!(said.status, 2, "{verb}: {}", said.stderr);
        assert!(
            said.stderr.contains("roof.csv is a record, not a project file")
                && said.stderr.lines().count() < 12,
            "{verb}: {}",
            said.stderr
        );
    }
}

#[test]
fn holds_sensors_that_point_along_neither_axis_are_the_reason_why_no_stiffness_is_sought() {
    let scratch = Scratch::new("sensors-at-45");
    // motion of two floors: noise through a resonator at 2 Hz, ten minutes at 50 Hz
    let (mut state, mut y) = (1_u64, [0.0_f64; 2]);
    let omega = 2.0 * std::f64::consts::PI * 2.0 / 50.0;
    let mut rows = String::from("time,a,b\n");
    for i in 0..30_000 {
        let mut noise = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
        };
        let next = 1.98 * omega.cos() * y[0] - 0.98 * y[1] + noise();
        y = [next, y[0]];
        rows += &format!(
            "{:.2},{:.5},{:.5}\n",
            f64::from(i) / 50.0,
            next + noise(),
            0.6 * next + noise()
        );
    }
    fs::write(scratch.path().join("pole.csv"), rows).unwrap();
    let project = |direction: &str| {
        format!(
            "schema = 1\nkind = \"chain\"\nname = {{ en = \"Pole\" }}\nevidence = \"literature\"\njoints = \"unknown\"\nlinks = [\n\
             {{ weight = \"20 kN\", length = 3, centroid = 1.5 }},\n{{ weight = \"10 kN\", length = 2, centroid = 1 }},\n]\n\
             [survey.one.records]\nfile = \"pole.csv\"\nchannels = [\n\
             {{ column = \"a\", position = [0, 0, 5], direction = {direction} }},\n\
             {{ column = \"b\", position = [0, 0, 3], direction = {direction} }},\n]\n"
        )
    };
    let said = |direction: &str| {
        fs::write(scratch.path().join("pole.toml"), project(direction)).unwrap();
        let answer = scratch.dolmen("identify pole.toml");
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let words = "No stiffness is sought: no sensor points within 15° of x or y (a and b do not)";
    let turned = said("[1, 1, 0]");
    assert!(turned.contains(words), "{turned}");
    for (language, words) in [
        ("en", "No sensor points within 15°"),
        ("ko", "15° 이내를 향하는 센서가 없어(a, b)"),
    ] {
        let words = words.replace("No sensor", "No stiffness is sought: no sensor");
        let report = scratch.dolmen(&format!(
            "report pole.toml --samples 0 --language {language} -o pole.html"
        ));
        assert!(report.status < 2, "{}", report.stderr);
        let page = fs::read_to_string(scratch.path().join("pole.html")).unwrap();
        assert!(page.contains(&words), "{language}");
    }
    let along = said("\"x\"");
    assert!(!along.contains("no stiffness is sought"), "{along}");
}
