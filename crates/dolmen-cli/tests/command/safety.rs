// SOURCE     Ways to make an unsafe structure look safe.
// GOAL       The answer names each, its verdict changes, or Dolmen refuses the input.
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
        upright.status == 0 && upright.stdout.contains("VERDICT Own weight: stable"),
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
        leaning.stdout.contains("VERDICT Own weight: unstable")
            && leaning.words().contains("it overturns, whatever the load factor"),
        "{}",
        leaning.stdout
    );
    let slight = check(
        "slight",
        &format!("{POLE}[survey.now]\ntilt = {{ x = \"1/200\" }}\n"),
        "",
    );
    assert!(
        slight.status == 0 && slight.words().contains("at which a bed stands on its edge"),
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
        unchecked.words().contains("not checked against overturning"),
        "{}",
        unchecked.stdout
    );
}

#[test]
fn holds_a_measured_frequency_that_the_model_does_not_have_is_said() {
    let text = format!("{POLE}[survey.now]\nfrequencies.x = [{{ value = 0.3, source = \"measured\" }}]\n");
    let answer = check("contradiction", &text, "");
    assert!(
        answer.words().contains("Survey now measured 0.3000 Hz"),
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
        answer.stdout.contains("VERDICT Own weight: unknown"),
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
        !answer.stdout.contains("VERDICT Own weight: stable"),
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
        answer.stderr.contains("it is never replaced"),
        "{}",
        answer.stderr
    );
    assert_eq!(
        fs::read_to_string(scratch.path().join("project.toml")).unwrap(),
        POLE
    );
}

/// A frame of two storeys with sliders; the numbers of its springs during slip follow.
const HALL: &str = "schema = 1\nkind = \"frame\"\nname = { en = \"Hall\" }\nunits = { force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }\n\
    storeys = [{ mass = 60, height = 4.2 }, { mass = 45, height = 3.6 }]\n[direction.weak]\n";

fn simulated(name: &str, text: &str, more: &str) -> Answer {
    let scratch = Scratch::with_examples(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    scratch.dolmen(&format!("simulate project.toml {more}"))
}

#[test]
fn holds_a_run_shorter_than_its_motion_has_no_verdict_of_any_kind() {
    let hall = format!("{HALL}stiffness = [8.1, 5.2]\ndamping_ratio = 0.03\n");
    let twisting = fs::read_to_string("../../examples/twisting_floor/project.toml").unwrap();
    for (name, text) in [
        ("short-pole", POLE),
        ("short-hall", &hall),
        ("short-floor", &twisting),
    ] {
        let short = simulated(name, text, "--motion el-centro-1940-ns --duration 1");
        assert_eq!(short.status, 3, "{name}: {}{}", short.stdout, short.stderr);
        let said = "ended before the motion: 1.00 of its 31.18 s were run; no verdict";
        let printed = short.words().to_lowercase().replace("1.00 s of", "1.00 of");
        assert!(printed.contains(said), "{name}: {}", short.stdout);
    }
    let whole = simulated("whole-hall", &hall, "--motion el-centro-1940-ns --duration 31.18");
    assert!(
        whole.status == 0 && !whole.stdout.contains("ended before"),
        "{}",
        whole.stdout
    );
}

#[test]
fn holds_joints_that_cannot_open_are_named_with_the_bed_that_each_would_need() {
    let unknown = POLE
        .replace(", bed_width = 0.5", "")
        .replace(", bed_width = 0.4", "");
    let answer = simulated("no-beds", &unknown, "--motion el-centro-1940-ns");
    for said in [
        "It stands and its joints were taken as unable to open",
        "* 2 of 2 joints have no bed that can open",
        "‘link 1’ ",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let known = simulated("beds", POLE, "--motion el-centro-1940-ns --scale 0.02");
    assert!(
        known.stdout.contains("It stands and no bed comes to its edge")
            && !known.stdout.contains("no bed that can open"),
        "{}",
        known.stdout
    );
}

#[test]
fn holds_a_motion_that_ends_far_away_is_said_where_it_acts() {
    let scratch = Scratch::new("offset");
    fs::write(scratch.path().join("project.toml"), POLE).unwrap();
    let mut rows = String::from("time (s),acc (m/s2)\n");
    for i in 0..200 {
        let t = 0.01 * f64::from(i);
        rows += &format!("{t:.2},{:.6}\n", 0.05 + 0.2 * (6.0 * t).sin());
    }
    fs::write(scratch.path().join("offset.csv"), rows).unwrap();
    let answer = scratch.dolmen("simulate project.toml --motion-file offset.csv");
    assert!(
        answer.stdout.contains("* x ends 0.") && answer.stdout.contains("the base line drifts"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
    let level = scratch.dolmen("simulate project.toml --motion el-centro-1940-ns");
    assert!(!level.stdout.contains("note: x ends"), "{}", level.stdout);
}

#[test]
fn holds_a_vertical_motion_does_not_act_on_a_frame_and_that_is_said() {
    let scratch = Scratch::with_examples("vertical");
    let hall = format!("{HALL}stiffness = [8.1, 5.2]\ndamping_ratio = 0.03\n");
    fs::write(scratch.path().join("project.toml"), hall).unwrap();
    for (file, peak) in [("x.csv", 0.2), ("z.csv", 0.1)] {
        let rows: String = (0..200)
            .map(|i| {
                format!(
                    "{:.2},{:.6}\n",
                    0.01 * f64::from(i),
                    peak * (0.1 * f64::from(i)).sin()
                )
            })
            .collect();
        fs::write(scratch.path().join(file), format!("time (s),acc (m/s2)\n{rows}")).unwrap();
    }
    let answer = scratch.dolmen("simulate project.toml --motion-file x=x.csv --motion-file z=z.csv");
    // 0.1 m/s²
    assert!(
        answer
            .words()
            .contains("z, with a peak of 0.0102 g, does not act"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
}

#[test]
fn holds_the_verdict_says_what_decided_it() {
    // min k l/N during slip: 0.1 kN/mm × 4.2 m / (105 t g) = 0.408
    let slips = format!(
        "{HALL}stiffness = [8.1, 5.2]\ndamping_ratio = 0.03\n\
         friction = {{ law = \"jenkins\", coefficient = 0.1, slipping_stiffness = [0.1, 0.05] }}\n"
    );
    let answer = check("slips", &slips, "");
    assert!(
        answer.stdout.contains("VERDICT Own weight: unstable")
            && answer
                .words()
                .contains("While every joint slips, the load factor is 0.4079"),
        "{}",
        answer.stdout
    );
    let leaning = check(
        "leans",
        &format!("{POLE}[survey.now]\ntilt = {{ x = \"1/5\" }}\n"),
        "",
    );
    assert!(
        leaning.words().contains("it overturns, whatever the load factor"),
        "{}",
        leaning.stdout
    );
    let tilted = format!("{HALL}stiffness = [8.1, 5.2]\n[survey.now]\ntilt = {{ weak = \"1/20\" }}\n");
    let tilted = check("tilted", &tilted, "");
    assert!(
        tilted
            .words()
            .contains("measured in direction weak (survey now) is not used: storeys start plumb"),
        "{}",
        tilted.stdout
    );
}

#[test]
fn holds_a_chance_of_falling_stands_beside_the_verdict() {
    let loose = POLE.replace(
        "{ stiffness = 1000 }",
        "{ stiffness = { value = 25, cov = 0.4 } }",
    );
    let answer = check("loose", &loose, "--samples 400");
    assert!(
        answer
            .words()
            .contains("With the scatter given for the inputs it falls under its own weight alone"),
        "{}",
        answer.stdout
    );
    // k l/N during slip: 0.55 × 4.2 m/1030 kN = 2.2 and 0.3 × 3.6/441 = 2.4 at the mean: below 1 in about one of ten
    let frame = format!(
        "{HALL}stiffness = [21, 14]\nfriction = {{ law = \"jenkins\", coefficient = 0.08, slipping_stiffness = \
         [{{ value = 0.5, cov = 0.5 }}, {{ value = 0.3, cov = 0.5 }}] }}\n"
    );
    let answer = check("slipping-draws", &frame, "--samples 400");
    let percent: f64 = answer
        .words()
        .split("of 400 samples: ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next())
        .and_then(|share| share.parse().ok())
        .unwrap_or(0.0);
    // an independent draw of 200 000: 14.6 %
    assert!((9.0..21.0).contains(&percent), "{percent} {}", answer.stdout);
}

#[test]
fn holds_a_load_factor_far_above_all_others_is_asked_about() {
    let stiff = POLE.replace("3000", "3000000").replace("1000 }", "1000000 }");
    let answer = check("stiff", &stiff, "");
    assert!(
        answer
            .words()
            .contains("is far above what timber frames and stone poles have"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
    assert!(!check("usual", POLE, "").stdout.contains("[unit-slip]"));
}

#[test]
fn refuses_a_study_of_what_falls_by_itself() {
    let scratch = Scratch::with_examples("falls");
    let soft = POLE.replace("{ stiffness = 1000 }", "{ stiffness = 5 }");
    let text = format!("{soft}[study.s]\nmotions = [\"el-centro-1940-ns\"]\npeak = [\"0.1 g\", \"0.2 g\"]\n");
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen("study project.toml");
    assert_eq!(answer.status, 2, "{}", answer.stdout);
    assert!(
        answer
            .stderr
            .contains("it does not stand under its own weight (load factor 0."),
        "{}",
        answer.stderr
    );
}

const STELE: &str = "schema = 1\nkind = \"stack\"\nname = { en = \"Stele\" }\ndensity = 2600\njoint = { friction = 0.6 }\n\
    blocks = [{ name = \"base\", width = 1.0, height = 0.5 }, { name = \"stele\", width = 0.4, height = 1.6 }]\n";

#[test]
fn refuses_a_tie_or_side_support_nowhere_near_what_it_holds() {
    let tie = |position: &str| {
        format!(
            "{STELE}ties = [{{ lower = \"base\", upper = \"stele\", position = {position}, shear_stiffness = \"20 kN/mm\", shear_strength = \"15 kN\" }}]\n"
        )
    };
    let near = check("tie-near", &tie("[0, 0, 0.5]"), "");
    assert_eq!(near.status, 0, "{}", near.stderr);
    // the last lies above the base, but 0.28 m off the stele
    for position in ["[0, 0, 3]", "[5, 0, 0.5]", "[0.48, 0, 0.5]"] {
        let far = check("tie-far", &tie(position), "");
        assert_eq!(far.status, 2, "{position}: {}", far.stdout);
        assert!(far.stderr.contains("a tie"), "{}", far.stderr);
    }
    let support = format!(
        "{STELE}side_supports = [{{ block = \"stele\", position = [0.2, 0, 5.0], direction = \"x\", gap = \"20 mm\", stiffness = \"5 kN/mm\" }}]\n"
    );
    let far = check("support-far", &support, "");
    assert!(
        far.status == 2 && far.stderr.contains("a side support"),
        "{}{}",
        far.stdout,
        far.stderr
    );
}

#[test]
fn holds_an_arch_that_does_not_stand_its_movement_is_unstable() {
    let arch = |movement: &str| {
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"Arch\"\ndensity = 2600\njoint = {{ friction = 0.8 }}\n\
             arch = {{ span = 1.85, thickness = 0.15, depth = 0.5, voussoirs = 10 }}\n\
             support_movement = [{{ on = \"voussoir 10\", {movement} }}]\n"
        )
    };
    // it falls at 109.2 mm
    for (movement, status, said) in [
        ("x = \"20 mm\"", 0, "It stands under that, and up to 5.4"),
        ("x = \"80 mm\"", 0, "VERDICT Own weight: marginal"),
        ("x = \"120 mm\"", 1, "beyond 0.910 of it"),
    ] {
        let answer = check("spreading", &arch(movement), "");
        let printed = answer.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, status, "{movement}: {printed}{}", answer.stderr);
        assert!(printed.contains(said), "{movement}: {printed}");
    }
    // the headline of a run holds what the check says of the loads in the file
    let loaded = arch("x = \"20 mm\"")
        + "loads = [{ name = \"q\", at = \"voussoir 3\", force = [0, 0, \"-1 kN\"] }]\n\
        [combination.more]\nloads = 1.5\n";
    for verb in ["check project.toml", "simulate project.toml --law rigid"] {
        let scratch = Scratch::with_examples("spreading-loaded");
        fs::write(scratch.path().join("project.toml"), &loaded).unwrap();
        let answer = scratch.briefly(verb);
        assert!(
            answer
                .words()
                .contains("VERDICT Weight and loads: unknown under combination more"),
            "{verb}: {}{}",
            answer.stdout,
            answer.stderr
        );
    }
    let answer = check(
        "spreading-refused",
        &arch("x = \"1 mm\"").replace("voussoir 10\"", "keystone\""),
        "",
    );
    assert_eq!(answer.status, 2, "{}", answer.stdout);
}

#[test]
fn holds_a_study_whose_least_size_fells_says_so() {
    let scratch = Scratch::with_examples("least-fells");
    let study = "[study.s]\nlaw = \"rigid\"\nmotions = [\"el-centro-1940-ns\"]\npeak = [\"3 g\", \"4 g\"]\n";
    fs::write(scratch.path().join("project.toml"), format!("{STELE}{study}")).unwrap();
    let answer = scratch.dolmen("study project.toml");
    assert!(
        answer.words().contains("1 of 1 scan fell at the least size"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
}

/// No level between .2 and .4 g, or .4 and .8 g, was tried: the answer gives both ends of the step.
#[test]
fn exact_a_state_that_begins_between_two_levels_is_said_with_both() {
    let scratch = Scratch::with_examples("levels-apart");
    let study = "[study.s]\nartificial = { count = 3, seed = 3, duration_s = 8 }\npeak = [\"0.2 g\", \"0.4 g\", \"0.8 g\"]\nrefine = 0\n";
    let pillar = "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\ndensity = 2400\n\
        joint = { friction = 0.6, normal_stiffness = 5e9, shear_stiffness = 2e9 }\n\
        blocks = [{ name = \"base\", width = 1.5, height = 0.5 }, { name = \"pillar\", width = 0.5, height = 1.5 }]\n";
    fs::write(scratch.path().join("project.toml"), format!("{pillar}{study}")).unwrap();
    let words = scratch.briefly("study project.toml").words();
    for said in [
        "“falls”, the weakest between 0.400 g and 0.800 g",
        "DS1 between 0.200 g and 0.400 g",
    ] {
        assert!(words.contains(said), "{said}: {words}");
    }
}

#[test]
fn exact_turning_a_motion_leaves_its_strength() {
    let scratch = Scratch::with_examples("turned");
    fs::write(scratch.path().join("project.toml"), STELE).unwrap();
    let answer = scratch.dolmen(
        "simulate project.toml --motion el-centro-1940-ns --peak 0.02g --turn 45 --keep-first 4 --law rigid",
    );
    // 0.02 cos 45° along each, 0.02 together
    for said in [" 0.01414 ", "x and y together – – 0.02000 "] {
        assert!(
            answer.words().contains(said),
            "{said}: {}{}",
            answer.stdout,
            answer.stderr
        );
    }
}
