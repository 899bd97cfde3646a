// SOURCE     Small pagodas under six short made motions.
// GOAL       A small training study of the score: after a kill it resumes and gives the same table, and the table gives a score.
// TOLERANCE  none: bytes of tables.

use super::verbs::Scratch;
use std::fmt::Write as _;
use std::fs;

const DESIGNS: usize = 42;

/// Designs that cover heights, slenderness and taper; scales that overturn them.
fn project() -> String {
    let mut text = r#"
schema = 1
kind = "stack"
name = "Training"
density = 2600
joint = { friction = 0.6 }
pagoda = { storeys = 3, body_height = 2, body_slenderness = 3, taper = "6 deg", body_base_height_ratio = 2 }

[study.small]
artificial = { count = 6, duration_s = 2, strong_s = 0.7, rise_s = 0.3 }
peak = ["0.7 g", "1.0 g", "1.4 g"]
refine = 0
points = 4
vary.pagoda = [
"#
    .to_owned();
    for i in 0..DESIGNS {
        let part = |k: f64| (0.5 + i as f64 * k).fract();
        let _ = writeln!(
            text,
            "  {{ storeys = {}, body_height = {:.2}, body_slenderness = {:.2}, taper = \"{:.1} deg\", body_base_height_ratio = {:.2} }},",
            2 + i % 2,
            1.0 + part(0.857),
            2.5 + part(0.734),
            4.0 + 3.0 * part(0.629),
            1.5 + part(0.539)
        );
    }
    text + "]\n"
}

#[test]
fn holds_a_small_training_killed_and_gone_on_with_gives_the_same_score() {
    let scratch = Scratch::new("training");
    fs::write(scratch.path().join("project.toml"), project()).unwrap();
    let whole = scratch.dolmen("study . -o whole");
    assert_eq!(whole.status, 0, "{}{}", whole.stdout, whole.stderr);
    let train = |from: &str, to: &str| {
        let answer = scratch.dolmen(&format!("score . --train small --from {from} -o {to}"));
        assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
        fs::read(scratch.path().join(to)).unwrap()
    };
    let designs = train("whole", "whole.csv");
    let rows = String::from_utf8(designs.clone()).unwrap();
    assert_eq!(
        rows.lines().filter(|line| !line.starts_with('#')).count(),
        DESIGNS + 1
    );
    assert!(rows.starts_with("# motions "));

    // killed in the middle of a line: complete lines are kept, the rest is run
    let journal = fs::read(scratch.path().join("whole/small/journal.tsv")).unwrap();
    let folder = scratch.path().join("killed/small");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("journal.tsv"), &journal[..journal.len() * 3 / 5]).unwrap();
    let unfinished = scratch.dolmen("score . --train small --from killed -o part.csv");
    assert!(
        fs::read(scratch.path().join("part.csv")).unwrap().len() < designs.len(),
        "{}",
        unfinished.stderr
    );
    let resumed = scratch.dolmen("study . -o killed");
    assert_eq!(resumed.status, 0);
    assert!(
        resumed.stderr.contains("runs are kept from before"),
        "{}",
        resumed.stderr
    );
    let lines = |path: &str| {
        fs::read_to_string(scratch.path().join(path))
            .unwrap()
            .lines()
            .count()
    };
    assert_eq!(
        lines("killed/small/journal.tsv"),
        lines("whole/small/journal.tsv")
    );
    assert!(train("killed", "killed.csv") == designs, "the tables differ");

    let score = scratch.dolmen("score . --designs killed.csv --extrapolate");
    assert_eq!(score.status, 0, "{}", score.stderr);
    assert!(
        score.stdout.contains("against 42 simulated pagodas"),
        "{}",
        score.stdout
    );
}
