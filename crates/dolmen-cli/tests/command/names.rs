// SOURCE     names that were mistyped in use.
// GOAL       A name that is not there is answered with those there are and the one that was probably meant, at its own place; a flag
//            that would do nothing is refused.
// TOLERANCE  the words that help.

use super::verbs::Scratch;
use std::fs;

#[test]
fn holds_a_mistyped_name_is_answered_with_the_one_meant() {
    let scratch = Scratch::with_examples("names");
    for (words, meant) in [
        (
            "check examples/naju_flagpole --json --variant x",
            "check has no --variant",
        ),
        (
            "simulate examples/naju_flagpole --motion el-centro --variant wegded",
            "did you mean \"wedged\"?",
        ),
        (
            "simulate examples/naju_flagpole --motion el-cetnro",
            "did you mean \"el-centro",
        ),
        (
            "study examples/naju_flagpole --study grwoth",
            "did you mean \"growth\"?",
        ),
        (
            "motion --motion el-centro-1940-ms",
            "did you mean \"el-centro-1940-ns\"?",
        ),
    ] {
        let answer = scratch.dolmen(words);
        assert_eq!(answer.status, 2, "{words}");
        assert!(answer.stderr.contains(meant), "{words}: {}", answer.stderr);
    }
}

#[test]
fn holds_a_variant_of_a_study_is_missed_at_its_own_line() {
    let scratch = Scratch::with_examples("names-study");
    let file = scratch.path().join("examples/naju_flagpole/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    let study = "\n[study.lost]\nvariants = [\"loose\", \"wegded\"]\nmotions = [\"el-centro-1940-ns\"]\nscale = [1]\n";
    fs::write(&file, format!("{text}{study}")).unwrap();
    let line = text.lines().count() + 3;
    let answer = scratch.dolmen("check examples/naju_flagpole");
    assert_eq!(answer.status, 2);
    for words in [
        format!("project.toml:{line}:"),
        "did you mean \"wedged\"?".to_owned(),
    ] {
        assert!(answer.stderr.contains(&words), "{words}: {}", answer.stderr);
    }
}

#[test]
fn refuses_what_a_motion_without_a_match_would_ignore() {
    let scratch = Scratch::new("names-motion");
    for flag in [
        "--zone 2",
        "--years 500",
        "--site S3",
        "--ground-acceleration 0.2",
    ] {
        let answer = scratch.dolmen(&format!("motion --motion el-centro-1940-ns {flag}"));
        assert_eq!(answer.status, 2, "{flag}");
        assert!(answer.stderr.contains("--match"), "{flag}: {}", answer.stderr);
    }
    fs::write(
        scratch.path().join("a.csv"),
        "time_s,x_m_s2\n0,0\n0.01,1\n0.02,-1\n0.03,0\n",
    )
    .unwrap();
    let (plain, flagged) = (
        scratch.dolmen("motion a.csv"),
        scratch.dolmen("motion --motion-file a.csv"),
    );
    assert_eq!(
        (plain.status, &plain.stdout),
        (flagged.status, &flagged.stdout),
        "{}",
        flagged.stderr
    );
    assert!(
        plain.status == 0 && plain.stdout.contains("a.csv"),
        "{}{}",
        plain.stdout,
        plain.stderr
    );
}

#[test]
fn holds_a_restitution_that_springs_do_not_use_is_said() {
    let scratch = Scratch::new("names-restitution");
    let text = "schema = 1\nkind = \"stack\"\nname = \"Stone\"\ndensity = 2600\njoint = { friction = 0.6, restitution = 0.4 }\n\
                blocks = [{ name = \"stone\", width = 0.5, height = 1 }]\n";
    fs::write(scratch.path().join("p.toml"), text).unwrap();
    let run = |law: &str| {
        scratch.briefly(&format!(
            "simulate p.toml --motion el-centro-1940-ns --keep-first 1 --law {law}"
        ))
    };
    let said = "restitution given for the joints is not used";
    assert!(run("springs").words().contains(said), "{}", run("springs").stdout);
    assert!(!run("rigid").words().contains(said));
}
