// SOURCE     Ways in which an unsafe structure could be made to look safe.
// GOAL       Each is said, changes the verdict, or is refused.
// TOLERANCE  none: words and exit statuses.

use super::verbs::{Answer, Scratch};
use std::fs;

const POLE: &str = "schema = 1\nkind = \"chain\"\nname = { en = \"Pole\" }\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\n\
    links = [{ weight = 20, length = 3.0, centroid = 1.5, breadth = 0.5, bed_width = 0.5 }, \
    { weight = 12, length = 2.5, centroid = 1.2, breadth = 0.4, bed_width = 0.4 }]\n\
    joints = [{ stiffness = 3000 }, { stiffness = 1000 }]\n";

fn check(name: &str, text: &str, more: &str) -> Answer {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    scratch.dolmen(&format!("check project.toml {more}"))
}

#[test]
fn holds_a_measured_tilt_beyond_the_bed_overturns_a_stiff_pole() {
    let upright = check("upright", POLE, "");
    assert!(
        upright.status == 0 && upright.stdout.contains("VERDICT stable"),
        "{}",
        upright.stdout
    );
    let leaning = check(
        "leaning",
        &format!("{POLE}[survey.now]\ntilt = {{ x = \"1/5\" }}\n"),
        "",
    );
    assert_eq!(leaning.status, 1, "{}", leaning.stdout);
    assert!(
        leaning.stdout.contains("VERDICT unstable") && leaning.stdout.contains("OVERTURNS"),
        "{}",
        leaning.stdout
    );
    let slight = check(
        "slight",
        &format!("{POLE}[survey.now]\ntilt = {{ x = \"1/200\" }}\n"),
        "",
    );
    assert!(
        slight.status == 0 && slight.stdout.contains("a bed is on its edge at 1/"),
        "{}",
        slight.stdout
    );
    let unknown = POLE
        .replace(", bed_width = 0.5", "")
        .replace(", bed_width = 0.4", "");
    let unchecked = check(
        "unchecked",
        &format!("{unknown}[survey.now]\ntilt = {{ x = \"1/5\" }}\n"),
        "",
    );
    assert!(
        unchecked.stdout.contains("not checked against overturning"),
        "{}",
        unchecked.stdout
    );
}

#[test]
fn holds_a_measured_frequency_that_the_model_does_not_have_is_said() {
    let text = format!("{POLE}[survey.now]\nfrequencies.x = [{{ value = 0.3, source = \"measured\" }}]\n");
    let answer = check("contradiction", &text, "");
    assert!(
        answer
            .stdout
            .contains("CONTRADICTION: survey now measured 0.3000 Hz"),
        "{}",
        answer.stdout
    );
}

const GATE: &str = "schema = 1\nkind = \"frame\"\nname = { en = \"Gate\" }\n\
    units = { force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }\naxial = \"storey\"\n";

#[test]
fn holds_a_direction_that_is_not_known_leaves_verdict_and_probability_unknown() {
    let text = format!(
        "{GATE}storeys = [{{ mass = 290, height = 5.84, axial_force = 5919 }}]\n\
         [direction.weak]\nstiffness = [{{ value = 30, cov = 0.2 }}]\n[direction.strong]\nstiffness = \"unknown\"\n"
    );
    let answer = check("direction", &text, "--samples 200");
    assert!(
        answer.stdout.contains("VERDICT unknown"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
    assert!(!answer.stdout.contains("Probability"), "{}", answer.stdout);
}

#[test]
fn holds_a_frame_without_gravity_load_is_not_called_stable() {
    let text = format!(
        "{GATE}storeys = [{{ mass = 290, height = 5.84, axial_force = 0 }}]\n[direction.weak]\nstiffness = [30]\n"
    );
    let answer = check("massless", &text, "");
    assert!(
        !answer.stdout.contains("VERDICT stable"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
}

#[test]
fn refuses_a_report_over_its_own_project() {
    let scratch = Scratch::new("own");
    fs::write(scratch.path().join("project.toml"), POLE).unwrap();
    let answer = scratch.dolmen("report project.toml -o project.toml");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("is the project file itself"),
        "{}",
        answer.stderr
    );
    assert_eq!(
        fs::read_to_string(scratch.path().join("project.toml")).unwrap(),
        POLE
    );
}
