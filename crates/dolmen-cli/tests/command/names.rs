// SOURCE     names that were mistyped in use.
// GOAL       The error for an unknown name lists the known names and the one probably meant, in its own line; a flag without effect is refused.
// TOLERANCE  the helpful words.

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
fn holds_each_restitution_goes_where_it_is_used() {
    let scratch = Scratch::new("names-restitution");
    let write = |joint: &str| {
        let text = format!(
            "schema = 1\nkind = \"stack\"\nname = \"Stone\"\ndensity = 2600\njoint = {{ friction = 0.6, {joint} }}\n\
             blocks = [{{ name = \"stone\", width = 0.5, height = 1 }}]\n"
        );
        fs::write(scratch.path().join("p.toml"), text).unwrap();
    };
    let run = |law: &str| {
        scratch.briefly(&format!(
            "simulate p.toml --motion el-centro-1940-ns --keep-first 1 --law {law}"
        ))
    };
    let said = |law: &str, words: &str| {
        let run = run(law);
        assert_eq!(run.status, 0, "{}{}", run.stdout, run.stderr);
        (run.words() + &run.stderr).contains(words)
    };
    write("rocking_restitution = 0.8");
    assert!(said(
        "springs",
        "rocking_restitution is not used by contact springs"
    ));
    assert!(!said("rigid", "rocking_restitution is not used"));
    // 1 - 1.5 sin2(alpha) of this stone is 0.7
    assert!(said(
        "rigid",
        "rocking_restitution 0.800 below 'stone' is more than the 0.700"
    ));
    write("rocking_restitution = 0.65");
    assert!(!said("rigid", "is more than"));
    // the earlier name means that of falls
    write("restitution = 0.4");
    let full = scratch.briefly("check p.toml --full").words();
    assert!(
        full.contains("joint.restitution is read as normal_restitution"),
        "{full}"
    );
    let json = |joint: &str| {
        write(joint);
        let run = scratch.briefly("check p.toml --json");
        let value: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        value["state"]["check"]["stack"]["joints"][0].clone()
    };
    let (earlier, now) = (json("restitution = 0.4"), json("normal_restitution = 0.4"));
    assert_eq!(earlier, now);
    // exp(-z/sqrt(1-z^2) (pi - atan2(2 z sqrt(1-z^2), 1-2 z^2))) = 0.4
    assert!(
        (now["damping_ratio"].as_f64().unwrap() - 0.354_508).abs() < 1e-6,
        "{now}"
    );
    assert_eq!(
        json("normal_restitution = 0.4, damping_ratio = 0.1")["damping_ratio"],
        0.1
    );
    for (joint, words) in [
        ("rocking_restitution = 0", "must be above 0"),
        ("rocking_restitution = 80", "80"),
        ("normal_restitution = 1.2", "0 to 1"),
        ("normal_restitution = 0.4, restitution = 0.4", "which are one"),
    ] {
        write(joint);
        let run = run("rigid");
        assert!(
            run.status > 1 && run.stderr.contains(words),
            "{joint}: {}",
            run.stderr
        );
    }
}

/// 기록 composed as on Windows and Linux, and decomposed as on macOS.
const WHOLE: &str = "\u{ae30}\u{b85d}.csv";
const IN_PARTS: &str = "\u{1100}\u{1175}\u{1105}\u{1169}\u{11a8}.csv";

#[test]
fn refuses_a_file_that_is_not_there_with_its_line_and_the_nearest_name() {
    let scratch = Scratch::new("names-missing");
    let stack = "schema = 1\nkind = \"stack\"\nname = \"a\"\n# \"m2.csv\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
        blocks = [{ name = \"b\", width = 1, height = 1 }]\n\
        [motion.m]\nfiles = { x = \"m2.csv\" }\nunit = \"g\"\n\
        [survey.2024.records]\nfile = \"기럭.csv\"\nsampling_rate = \"50 Hz\"\n";
    fs::write(scratch.path().join("project.toml"), stack).unwrap();
    fs::write(scratch.path().join("m1.csv"), "1\n").unwrap();
    fs::write(scratch.path().join(IN_PARTS), "1\n").unwrap();
    let record = format!(
        "project.toml, line 12: there is no ./기럭.csv: did you mean \"{IN_PARTS}\", which lies beside it?"
    );
    for (words, said) in [
        ("identify .", record.as_str()),
        (
            "simulate . --motion m",
            "project.toml, line 9: there is no ./m2.csv: did you mean \"m1.csv\", which lies beside it?",
        ),
    ] {
        let answer = scratch.dolmen(words);
        assert_eq!(answer.status, 2, "{words}");
        assert!(answer.stderr.contains(said), "{words}: {}", answer.stderr);
        let korean = scratch.dolmen(&format!("{words} --language ko")).stderr;
        assert!(korean.contains("행: ") && !korean.contains("line"), "{korean}");
    }
}

#[test]
fn holds_a_record_whose_name_is_composed_otherwise_is_read_and_that_is_said() {
    let scratch = Scratch::new("names-composed");
    let survey = format!(
        "schema = 1\nkind = \"survey\"\nname = \"a\"\n[survey.2024.records]\nfile = \"{WHOLE}\"\nsampling_rate = \"50 Hz\"\n"
    );
    fs::write(scratch.path().join("project.toml"), survey).unwrap();
    // noise through one mode at 5 Hz
    let (mut seed, mut x) = (1_u64, [0.0_f64; 2]);
    let rows = (0..6000).map(|_| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let noise = (seed >> 40) as f64 / (1_u64 << 24) as f64 - 0.5;
        x = [1.6 * x[0] - 0.98 * x[1] + noise, x[0]];
        format!("{}\n", x[0])
    });
    fs::write(scratch.path().join(IN_PARTS), rows.collect::<String>()).unwrap();
    let said = format!(
        "composed otherwise on this disk (NFD, as macOS writes Hangul, for NFC, or the reverse): it was read as {WHOLE}"
    );
    let answer = scratch.dolmen("identify .");
    assert!(
        answer.words().contains(&said),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
    fs::rename(scratch.path().join(IN_PARTS), scratch.path().join(WHOLE)).unwrap();
    let answer = scratch.dolmen("identify .");
    assert!(
        !answer.words().contains("composed otherwise"),
        "{}",
        answer.stdout
    );
}
