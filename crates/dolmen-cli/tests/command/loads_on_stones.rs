// SOURCE     Statics of blocks by hand, as in the comments; EN 1991-1-4 for the pressure of a gust, ρ v²/2.
// GOAL       Static loads on stones neither make an answer look safer than it is nor stand in numbers that do not count them.
// TOLERANCE  that of the printed digits.

use super::verbs::Scratch;
use std::fs;

fn said(name: &str, text: &str, words: &str) -> String {
    briefly(name, text, &format!("{words} --full"))
}

fn briefly(name: &str, text: &str, words: &str) -> String {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly(words);
    // lines of the terminal may break anywhere
    let all = format!("{}{}", answer.words(), answer.stderr);
    all.split_whitespace().collect::<Vec<_>>().join(" ")
}

const GATE: &str = "schema = 1\nkind = \"stack\"\nname = \"Gate\"\ndensity = 2600\njoint = { friction = 0.6 }\nblocks = [\
    { name = \"plinth\", width = 4, depth = 2, height = 0.4 },\
    { name = \"post a\", on = \"plinth\", at = [-1, 0], width = 0.3, depth = 1.0, height = 3.6 },\
    { name = \"post b\", on = \"plinth\", at = [1, 0], width = 0.3, depth = 1.0, height = 3.6 },\
    { name = \"lintel\", on = [\"post a\", \"post b\"], width = 2.6, depth = 1.0, height = 0.4 }]\n";

/// On tilted ground a load leans like the weights: posts of 0.3 × 3.6 m sway at tan 0.3/3.6, 4.76°, whatever rests on them. The acceleration
/// that they bear under 100 kN without mass is three times as much.
#[test]
fn holds_loads_give_no_tilt_of_the_ground() {
    let bare = said("gate-bare", GATE, "check project.toml");
    assert!(bare.contains("on ground that tilts by 4.76°"), "{bare}");
    let text = format!(
        "{GATE}loads = [{{ name = \"roof\", at = \"lintel\", height = 4.0, force = [0, 0, \"-100 kN\"] }}]\n"
    );
    for words in ["check project.toml", "check project.toml --language ko"] {
        let loaded = said("gate-loaded", &text, words);
        assert!(loaded.contains("0.237 g"), "{loaded}");
        assert!(!loaded.contains("tilt") && !loaded.contains('°'), "{loaded}");
    }
}

/// A pillar of 24.4 kN, 0.6 × 0.6 × 3 m, with a bracket of 3 kN, 1 m beyond its edge, and snow of 6 kN that holds it.
#[test]
fn exact_snow_that_holds_a_pillar_does_not_count_and_a_bracket_that_pulls_it_does() {
    let text = "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\ndensity = 2300\njoint = { friction = 0.6 }\n\
        blocks = [{ name = \"pillar\", width = 0.6, height = 3 }]\n\
        wind = { speed = \"30 m/s\", means = \"gust\", force_coefficient = 2.0 }\n\
        loads = [{ name = \"sign\", at = \"pillar\", position = [1.3, 0, 2.5], force = [0, 0, \"-3 kN\"] },\
        { name = \"snow\", at = \"pillar\", position = [-0.3, 0, 3], force = [0, 0, \"-6 kN\"] }]\n";
    let weight = 0.6 * 0.6 * 3.0 * 2300.0 * 9.80665;
    let holds = weight * 0.3 - 3e3 * 1.0;
    let wind = 2.0 * 0.5 * 1.25 * 30.0 * 30.0 * (0.6 * 3.0) * 1.5;
    let words = said("pillar-snow", text, "check project.toml");
    let borne = format!("{:.2} times", holds / wind);
    assert!(words.contains(&borne), "{borne}: {words}");
    let moves = format!("without those that hold it at {:.3} g", holds / (weight * 1.5));
    assert!(words.contains(&moves), "{moves}: {words}");
}

/// Pressure under 73.5 kN of stone and 200 kN on it, over 1 m².
#[test]
fn exact_the_pressure_of_a_joint_counts_loads_and_codes_move_no_loads_without_mass() {
    let text = "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\ndensity = 2500\njoint = { friction = 0.7 }\n\
        blocks = [{ name = \"pillar\", width = 1, depth = 1, height = 3 }]\n";
    let bare = said("pillar-bare", text, "check project.toml");
    assert!(bare.contains("Circolare"), "{bare}");
    let loaded =
        format!("{text}loads = [{{ name = \"beam\", at = \"pillar\", force = [0, 0, \"-200 kN\"] }}]\n");
    let words = said("pillar-pressed", &loaded, "check project.toml");
    let pressure = (3.0 * 2500.0 * 9.80665 + 200e3) / 1e3;
    assert!(words.contains(&format!(" {pressure:.0} ")), "{pressure}: {words}");
    assert!(!words.contains("Circolare"), "{words}");
    assert!(
        words.contains("Local mechanisms of codes are not given"),
        "{words}"
    );
}

#[test]
fn holds_loads_in_another_unit_upwards_or_off_their_stone_are_doubted() {
    for (load, doubt) in [
        ("force = [0, 0, 12]", "is it in kN"),
        ("force = [0, 0, 12]", "upwards"),
        ("force = [0, 0, \"-40000 kN\"]", "is it in N?"),
        (
            "position = [0, 2.5, 0.5], force = [0, 0, \"-2 kN\"]",
            "off 'pillar'",
        ),
    ] {
        let text = format!(
            "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\ndensity = 2500\njoint = {{ friction = 0.7 }}\n\
            blocks = [{{ name = \"pillar\", width = 1, depth = 1, height = 3 }}]\nloads = [{{ name = \"p\", at = \"pillar\", {load} }}]\n"
        );
        let words = said("pillar-doubted", &text, "check project.toml");
        assert!(words.contains(doubt), "{doubt}: {words}");
    }
}

/// Weight holds a pillar against a push: a combination that only makes it heavier leaves the worse case out.
#[test]
fn holds_a_combination_with_more_weight_alone_is_doubted_and_slips_of_bonds_and_movements_are_refused() {
    let with = |joint: &str, more: &str| {
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\ndensity = 2500\njoint = {{ friction = 0.7{joint} }}\n\
            blocks = [{{ name = \"pillar\", width = 1, depth = 1, height = 3 }}]\n{more}"
        )
    };
    let push = "loads = [{ name = \"p\", at = \"pillar\", force = [\"2 kN\", 0, 0] }]\n[combination.heavy]\nweight = 1.35\nloads = 1.5\n";
    let light = format!("{push}[combination.light]\nweight = 0.9\nloads = 1.5\n");
    let doubt = "weight holds stones against wind and thrust";
    assert!(said("pillar-heavy", &with("", push), "check project.toml").contains(doubt));
    assert!(!said("pillar-light", &with("", &light), "check project.toml").contains(doubt));
    for (joint, more, wrong) in [
        (", cohesion = 200", "", "mortar has 10 kPa to 1 MPa"),
        (
            "",
            "support_movement = [{ on = \"pillar\", x = 30 }]\n",
            "supports move by millimetres",
        ),
    ] {
        let scratch = Scratch::with_examples("pillar-slip");
        fs::write(scratch.path().join("project.toml"), with(joint, more)).unwrap();
        let answer = scratch.dolmen("check project.toml");
        let refused = answer.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            answer.status == 2 && refused.contains(wrong),
            "{wrong}: {refused}"
        );
    }
}

/// The wind that a wall bears, an upper bound, and the caveat that makes it one: together, or neither.
#[test]
fn holds_the_short_answer_gives_the_factor_of_the_wind_and_what_qualifies_it() {
    let text = "schema = 1\nkind = \"stack\"\nname = \"Wall\"\ndensity = 2400\njoint = { friction = 0.6 }\n\
        wall = { length = 1.8, thickness = 1.2, core = 0.4, leaves = 2, courses = 5, course_height = 0.3, stone_length = 0.6, through_every = 5 }\n\
        wind = { pressure = 800, means = \"gust\", force_coefficient = 1.4 }\n";
    let short = briefly("wall-in-wind", text, "check project.toml");
    assert!(short.contains("The wind of the file: "), "{short}");
    assert!(short.contains("the factor is an upper bound"), "{short}");
    assert!(!short.contains("at its limit"), "{short}");
    let full = said("wall-in-wind", text, "check project.toml");
    assert!(
        full.contains("The wind of the file: at its limit joints open"),
        "{full}"
    );
}

/// A dowel holds a pillar in the wind and is left out of what it bears: the short answer says so.
#[test]
fn holds_the_short_answer_says_that_a_tie_is_left_out_and_the_full_one_gives_both() {
    let text = "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\ndensity = 2500\njoint = { friction = 0.7 }\n\
        blocks = [{ name = \"base\", width = 1.5, height = 0.5 }, { name = \"pillar\", width = 0.5, height = 3 }]\n\
        ties = [{ lower = \"base\", upper = \"pillar\", position = [0, 0, 0.5], axial_stiffness = 5e7, shear_stiffness = 5e7, \
        tension_strength = \"30 kN\", shear_strength = \"20 kN\" }]\n";
    let short = briefly("pillar-tied", text, "check project.toml");
    assert!(short.contains("Ties are left out"), "{short}");
    let full = said("pillar-tied", text, "check project.toml");
    assert!(full.contains("with ties:"), "{full}");
}
