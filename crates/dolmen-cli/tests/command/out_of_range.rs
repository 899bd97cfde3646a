// SOURCE     Values that no real structure has: extreme steps, counts, scales and turns, and unknown names.
// GOAL       Each is refused with the allowed range before any work; similar names are suggested.
// TOLERANCE  none: words and exit statuses.

use super::untrusted::refused;
use super::verbs::Scratch;
use std::fs;

#[test]
fn refuses_runs_that_would_not_end() {
    let scratch = Scratch::new("runs");
    assert_eq!(scratch.dolmen("new pagoda p").status, 0);
    let run = "simulate p --motion el-centro-1940-ns --duration 0.3";
    for (flags, why) in [
        (
            "--law rigid --output-step 1e300",
            "no longer than the run, or 1 s",
        ),
        ("--output-step 1e300", "no longer than the run, or 1 s"),
        (
            "--step 1e-300",
            "steps of 1.000e-300 s, but at most 2e7 are computed",
        ),
        (
            "--law rigid --step 1e-9",
            "steps of 1.000e-9 s, but at most 2e7 are computed",
        ),
        ("--output-step 1e-300", "but at most"),
        ("--output-step 1e-300 --yes", "but at most"),
        ("--law rigid --step 1e-300 --yes", "but at most"),
    ] {
        refused(&scratch.dolmen(&format!("{run} {flags}")), why);
    }
    refused(
        &scratch.dolmen("simulate p --motion el-centro-1940-ns --duration 1e300"),
        "but at most",
    );
    assert_eq!(scratch.dolmen("new gate g").status, 0);
    let day = "simulate g --variant soft_below --motion el-centro-1940-ns --duration 1e9 --output-step 1e6";
    refused(
        &scratch.dolmen(day),
        "duration_s is 1000000000, but must be at most 100 000 s",
    );
    for kind in ["flagpole", "building"] {
        assert_eq!(scratch.dolmen(&format!("new {kind} {kind}")).status, 0);
        for flags in [
            "--duration 1e300",
            "--output-step 1e-300",
            "--output-step 1e300",
            "--duration 1e9 --output-step 1e6",
        ] {
            let answer = scratch.dolmen(&format!("simulate {kind} --motion el-centro-1940-ns {flags}"));
            assert!(answer.status != 101, "{kind} {flags}: {}", answer.stderr);
        }
    }
}

#[test]
fn refuses_ground_that_stands_still_or_moves_as_none_has() {
    let scratch = Scratch::new("acting");
    assert_eq!(scratch.dolmen("new pagoda p").status, 0);
    let run = "simulate p --motion el-centro-1940-ns --duration 0.3";
    for flags in ["--scale 1000", "--peak 30g"] {
        refused(&scratch.dolmen(&format!("{run} {flags}")), "at most 10 g");
    }
    for (flags, why) in [
        (
            "--scale -1",
            "--scale is -1, but must be above 0: a record is turned about by --turn 180",
        ),
        ("--scale 0", "--scale is 0, but must be above 0"),
        ("--turn 1e300", "--turn is 1e300°, but must be -360° to 360°"),
        ("--turn nan", "--turn is NaN°, but must be -360° to 360°"),
        ("--scale nan", "--scale is NaN, but must be above 0"),
        ("--peak 0", "has no unit: write \"0 g\""),
        (
            "--peak 0g",
            "--peak is 0g, but must be above 0, and of a motion that acts at most 10 g",
        ),
        ("--peak=-0.1g", "--peak is -0.1g, but must be above 0"),
    ] {
        refused(&scratch.dolmen(&format!("{run} {flags}")), why);
        if flags != "--peak 0" {
            let allowed = match flags.starts_with("--turn") {
                true => "but must be -360° to 360°",
                false => "but must be above 0",
            };
            refused(
                &scratch.dolmen(&format!("motion --motion el-centro-1940-ns {flags}")),
                allowed,
            );
        }
    }
    assert_eq!(
        scratch.dolmen(&format!("{run} --turn 180")).status,
        3,
        "turned about; the run ends before its motion"
    );
    refused(&scratch.dolmen("study p --study nope"), "the file has none");
    refused(
        &scratch.dolmen("motion --make sine --peak 0.1g --period -1"),
        "--period is -1 s, but must be 0.08 s to 100000 s, 8 to 10 million time steps",
    );
}

#[test]
fn refuses_counts_that_would_not_end_with_their_range() {
    let scratch = Scratch::new("counts");
    assert_eq!(scratch.dolmen("new pagoda p").status, 0);
    let file = scratch.path().join("p/project.toml");
    let own = fs::read_to_string(&file).unwrap();
    let peaks = "motions = [\"el-centro-1940-ns\"]\npeak = { from = \"0.1 g\", to = \"1 g\", steps = 10 }\n";
    let range = "study.s.vary.density.steps";
    for (study, why) in [
        (
            "motions = [\"el-centro-1940-ns\"]\npeak = { from = \"0.1 g\", to = \"1 g\", steps = 1000000000 }".to_owned(),
            "error: study.s.peak.steps = 1000000000 is outside its range",
        ),
        (
            "motions = [\"el-centro-1940-ns\"]\npeak = { from = \"0.1 g\", to = \"1 g\", steps = 1 }".to_owned(),
            "error: study.s.peak.steps = 1 is outside its range",
        ),
        (format!("{peaks}vary = {{ density = {{ from = 2000, to = 3000, steps = 1e9 }} }}"), range),
        (format!("{peaks}vary = {{ density = {{ from = 2000, to = 3000, steps = 1_000_000_000 }} }}"), range),
        (format!("{peaks}vary = {{ density = {{ from = 2000, to = 3000, steps = -4 }} }}"), range),
        (format!("{peaks}vary = {{ density = {{ from = 2000, to = 3000, steps = 2.5 }} }}"), range),
    ] {
        fs::write(&file, format!("{own}\n[study.s]\n{study}\n")).unwrap();
        let answer = scratch.dolmen("study p -o out");
        refused(&answer, why);
        assert!(answer.stderr.contains("must be 2 to 10000"), "{}", answer.stderr);
        assert!(!answer.stderr.contains("does not rise"), "{}", answer.stderr);
    }
    // each count is allowed, and their product is not
    let product = "vary = { density = { from = 2000, to = 3000, steps = 10000 }, \"joint.friction\" = { from = 0.3, to = 0.6, steps = 5000 } }";
    fs::write(&file, format!("{own}\n[study.s]\n{peaks}{product}\n")).unwrap();
    refused(
        &scratch.dolmen("study p -o out"),
        "the study has 50000000 scans, but at most 10000000 are run",
    );
    assert_eq!(scratch.dolmen("new gate g").status, 0);
    let file = scratch.path().join("g/project.toml");
    let own = fs::read_to_string(&file).unwrap();
    let map = "variants = [\"soft_below\"]\nharmonic = { frequency = { from = \"0.25 Hz\", to = \"6 Hz\", steps = 10000 }, acceleration = { from = \"0.01 g\", to = \"0.3 g\", steps = 10000 } }";
    fs::write(&file, format!("{own}\n[study.s]\n{map}\n")).unwrap();
    refused(
        &scratch.dolmen("study g --study s -o out"),
        "the maps have 100000000 points, but at most 1000000 are computed",
    );
}

#[test]
fn refuses_a_project_that_is_not_there_with_the_nearest_name() {
    let scratch = Scratch::new("nearest-path");
    assert_eq!(scratch.dolmen("new pagoda p").status, 0);
    for (path, near) in [
        (
            "p/projekt.toml",
            "p/projekt.toml does not exist: did you mean p/project.toml?",
        ),
        ("p/Project.toml", "did you mean p/project.toml?"),
        (
            "nothing/like/it",
            "nothing/like/it does not exist: name a project file",
        ),
    ] {
        refused(&scratch.dolmen(&format!("check {path}")), near);
    }
    fs::create_dir(scratch.path().join("dabotap")).unwrap();
    refused(&scratch.dolmen("check dabotab"), "did you mean dabotap?");
}

#[test]
fn holds_a_harmonic_map_says_how_exact_it_is() {
    let scratch = Scratch::new("map-accuracy");
    assert_eq!(scratch.dolmen("new gate g").status, 0);
    let file = scratch.path().join("g/project.toml");
    let own = fs::read_to_string(&file).unwrap();
    let map =
        "variants = [\"soft_below\"]\nharmonic = { frequency = [\"2 Hz\"], acceleration = [\"0.01 g\"] }";
    fs::write(&file, format!("{own}\n[study.s]\n{map}\n")).unwrap();
    let answer = scratch.dolmen("study g --study s -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer
            .words()
            .contains("to 1e-4 of their value where viscous damping is 5 % or more"),
        "{}",
        answer.stdout
    );
    let json = fs::read_to_string(scratch.path().join("out/s/study.json")).unwrap();
    assert!(json.contains("to 1e-4 of their value"), "{json}");
}
