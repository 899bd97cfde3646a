// SOURCE     Stiffness that one survey determines, from the file to the verdict; closed forms of one joint and one floor.
// GOAL       `identify --write` changes only the stiffness, and check, simulate and report use it.
// TOLERANCE  the digits written: a thousandth of a standard deviation.

use super::verbs::Scratch;
use std::fs;

/// One stone on one rotational joint: (2π f)² (I + m h²) = k − m g h.
const POLE: &str = "# as surveyed\nschema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\ngravity = 9.81\n\
    links = [{ name = \"shaft\", mass = \"2000 kg\", length = 3.0, centroid = 1.5, breadth = 0.6, bed_width = 0.6 }] # one stone\n\
    joints = [{ stiffness = { value = 3000, source = \"assumed\" } }] # first guess\n\n[survey.2026-04-02]\nfrequencies = { x = [{ value = 2.0, sd = 0.01, source = \"measured\" }] }\n";

#[test]
fn agrees_a_written_stiffness_with_the_closed_form_of_one_stone() {
    let scratch = Scratch::new("written-pole");
    let file = scratch.path().join("project.toml");
    fs::write(&file, POLE).unwrap();
    let before = scratch.dolmen("check project.toml");
    assert!(
        before.words().contains("contradicts it: 2.00"),
        "{}",
        before.words()
    );
    let answer = scratch.dolmen("identify project.toml --write");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer.words().contains("(before: 3000 kN*m/rad)"),
        "{}",
        answer.words()
    );
    let text = fs::read_to_string(&file).unwrap();
    let (head, rest) = text.split_once("stiffness = { value = ").unwrap();
    assert!(head.ends_with("# one stone\njoints = [{ "), "{head}");
    assert!(rest.contains("source = \"identified\", survey = \"2026-04-02\", note = \"before: 3000 kN*m/rad, assumed\" } }] # first guess\n\n[survey.2026-04-02]"), "{rest}");
    let value: f64 = rest.split(',').next().unwrap().parse().unwrap();
    // 2000 kg of 3.0 m by 0.6 m: I about the centre is m (3² + 0.6²)/12
    let inertia = 2000.0 * (9.0 + 0.36) / 12.0 + 2000.0 * 1.5 * 1.5;
    let omega = std::f64::consts::TAU * 2.0;
    let stiffness = omega * omega * inertia + 2000.0 * 9.81 * 1.5;
    assert!((value * 1e3 - stiffness).abs() < 1.0, "{value} {stiffness}");
    let after = scratch.dolmen("check project.toml");
    assert!(
        after
            .words()
            .contains("Model: not measured (calibrated to 2026-04-02)")
            && !after.words().contains("contradicts"),
        "{}",
        after.words()
    );
    // written again, nothing changes
    scratch.dolmen("identify project.toml --write");
    assert_eq!(fs::read_to_string(&file).unwrap(), text);
    // the survey contradicts a model that no longer agrees with it
    fs::write(&file, text.replace("\"2000 kg\"", "\"4000 kg\"")).unwrap();
    let edited = scratch.dolmen("check project.toml");
    assert!(
        edited.words().contains("contradicts it: 2.00"),
        "{}",
        edited.words()
    );
}

#[test]
fn holds_unknown_joints_and_directions_of_any_name_are_written() {
    let scratch = Scratch::new("written-unknown");
    let file = scratch.path().join("project.toml");
    let written = |text: &str| {
        fs::write(&file, text).unwrap();
        let answer = scratch.dolmen("identify project.toml --write");
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let json = scratch.dolmen("identify project.toml --write --json");
        let found: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
        assert_eq!(found["written"]["survey"], "2026-04-02");
        fs::read_to_string(&file).unwrap()
    };
    let first = "[{ stiffness = { value = 3000, source = \"assumed\" } }]";
    let chain = written(&POLE.replace(first, "\"unknown\""));
    assert!(
        chain.contains("joints = [\n  { stiffness = { value = 986.387, unit = \"kN*m/rad\", sd = 9.57,"),
        "{chain}"
    );
    let frame = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { stiffness = \"kN/mm\", length = \"m\", mass = \"t\" }\n\
        storeys = [{ mass = 290, height = 5.84 }]\n\n[survey.2026-04-02]\nfrequencies = { \"a b.c 강축\" = [{ value = 1.1, sd = 0.01, source = \"measured\" }] }\n";
    let alone = written(frame);
    assert!(
        alone.contains("\n[direction.\"a b.c 강축\"]\nstiffness = [\n  { value = "),
        "{alone}"
    );
    let unknown =
        written(&(frame.to_owned() + "[direction.\"a b.c 강축\"]\nstiffness = \"unknown\" # not yet\n"));
    assert!(
        unknown.contains("\n] # not yet\n") && unknown.matches("[direction.").count() == 1,
        "{unknown}"
    );
}

#[cfg(unix)]
#[test]
fn holds_who_may_read_and_write_stays_as_it_was() {
    use std::os::unix::fs::PermissionsExt as _;
    let scratch = Scratch::new("written-modes");
    let file = scratch.path().join("project.toml");
    fs::write(&file, POLE).unwrap();
    let mode = |mode: u32| fs::set_permissions(&file, fs::Permissions::from_mode(mode)).unwrap();
    mode(0o444);
    let answer = scratch.dolmen("identify project.toml --write");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    assert_eq!(fs::read_to_string(&file).unwrap(), POLE);
    mode(0o600);
    assert_eq!(scratch.dolmen("identify project.toml --write").status, 0);
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
}

#[test]
fn holds_a_floor_has_the_measured_frequencies_afterwards() {
    let scratch = Scratch::new("written-floor");
    assert_eq!(scratch.dolmen("new building own").status, 0);
    let gate = include_str!("../../../../examples/gate_in_plan/project.toml");
    let file = scratch.path().join("gate.toml");
    // its frequencies alone do not determine the centre of rigidity
    fs::write(&file, gate).unwrap();
    let refused = scratch.dolmen("identify gate.toml --write");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    assert!(
        refused
            .stderr
            .contains("a storey in plan whose centre of rigidity no mode tells"),
        "{}",
        refused.stderr
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), gate);
    let (above, _) = gate.split_once("[survey.ambient.frequencies]").unwrap();
    let mode = |direction: &str, hz: f64, more: &str| {
        format!("[[survey.ambient.modes.{direction}]]\nfrequency = {{ value = {hz}, sd = 0.029 }}\n{more}\n")
    };
    let sways = "twist = 0\ntwist_sd = 0.02\nsideways = 0";
    let modes = [
        mode("x", 1.5, sways),
        mode("y", 1.1, sways),
        mode("torsion", 1.3, "kind = \"torsion\""),
    ];
    fs::write(&file, above.to_owned() + &modes.concat()).unwrap();
    let answer = scratch.dolmen("identify gate.toml --write --language ko");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer.words().contains("주석과 나머지는 그대로 두었다"),
        "{}",
        answer.words()
    );
    let json = scratch.dolmen("check gate.toml --json");
    let found: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let text = json.stdout.clone();
    assert!(found["judgement"].is_object(), "{text}");
    let full = scratch.dolmen("check gate.toml").words();
    for frequency in ["1.1000", "1.3000", "1.5000"] {
        assert!(full.contains(frequency), "{frequency}: {full}");
    }
}

#[test]
fn refuses_to_write_what_no_survey_or_several_determine() {
    let scratch = Scratch::new("not-written");
    let file = scratch.path().join("project.toml");
    let refused = |text: &str, words: &str| {
        fs::write(&file, text).unwrap();
        let answer = scratch.dolmen("identify project.toml --write");
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        assert!(answer.stderr.contains(words), "{}", answer.stderr);
        assert_eq!(fs::read_to_string(&file).unwrap(), text);
    };
    let again = POLE.to_owned()
        + "[survey.2026-10-02]\nfrequencies = { x = [{ value = 2.1, sd = 0.01, source = \"measured\" }] }\n";
    refused(
        &again,
        "several surveys determine the stiffness (2026-04-02, 2026-10-02); name one with --survey",
    );
    refused(
        include_str!("../../../../examples/naju_flagpole/project.toml"),
        "no survey leads to one stiffness",
    );
    refused(
        &POLE.replace("source = \"assumed\"", "source = \"identified\""),
        "but from which survey is not said",
    );
    refused(
        &POLE.replace(
            "source = \"assumed\"",
            "source = \"identified\", survey = \"2019\"",
        ),
        "which the file does not have",
    );
    refused(
        include_str!("../../../../examples/five_storey_pagoda/project.toml"),
        "the springs of a stack are not written",
    );
    fs::write(&file, again).unwrap();
    assert_eq!(
        scratch
            .dolmen("identify project.toml --survey 2026-10-02 --write")
            .status,
        0
    );
    assert!(
        fs::read_to_string(&file)
            .unwrap()
            .contains("survey = \"2026-10-02\", note")
    );
}
