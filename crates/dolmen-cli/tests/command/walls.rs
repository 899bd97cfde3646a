// SOURCE     A leaf that rotates about its outer edge: a/g = thickness over height (tests/validation/walls.rs has the numbers).
// GOAL       Leaves, through stones and openings of a wall from the file to the answer, and impossible walls.

use super::verbs::Scratch;
use std::fs;

fn first_motion_g(scratch: &Scratch, wall: &str) -> f64 {
    let text = format!(
        "schema = 1\nkind = \"stack\"\nname = \"Wall\"\ndensity = 2600\njoint = {{ friction = 0.9 }}\nwall = {wall}\n"
    );
    fs::write(scratch.path().join("w.toml"), text).unwrap();
    let run = scratch.briefly("check w.toml --json");
    let value: serde_json::Value =
        serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{}", run.stderr));
    let capacity = &value["state"]["check"]["stack"]["capacity"]["acceleration_g"];
    capacity.as_f64().unwrap_or_else(|| panic!("{capacity}"))
}

#[test]
fn exact_two_leaves_have_half_of_one_wall() {
    let scratch = Scratch::new("walls-leaves");
    let size = "length = 1.6, thickness = 0.6, courses = 6, course_height = 0.25, stone_length = 0.8";
    for (more, known) in [
        ("", 0.4),
        (", leaves = 2, core = 0.1", 0.25 / 1.5),
        (", leaves = 2, through_every = 1", 0.4),
    ] {
        let found = first_motion_g(&scratch, &format!("{{ {size}{more} }}"));
        assert!((found - known).abs() < 1e-6, "{more}: {found}");
    }
}

#[test]
fn holds_the_example_says_what_through_stones_mend() {
    let scratch = Scratch::with_examples("walls-example");
    let run = scratch.briefly("check examples/wall/two_leaves.toml");
    assert_eq!(run.status, 0, "{}{}", run.stdout, run.stderr);
    let full = scratch.briefly("check examples/wall/two_leaves.toml --full");
    assert!(
        full.words().contains("Through stones in every third"),
        "{}",
        full.stdout
    );
    let json = scratch.briefly("check examples/wall/two_leaves.toml --json");
    assert!(json.stdout.contains("\"lintel 1\"") && json.stdout.contains("course 3 through stone 1"));
}

#[test]
fn refuses_openings_that_no_wall_has() {
    let scratch = Scratch::new("walls-refused");
    for (opening, en, ko) in [
        (
            "{ from = 0.1, width = 1, courses = 2 }",
            "its lintel has its bearing",
            "걸침 길이",
        ),
        (
            "{ from = 1, width = 1, courses = 9 }",
            "within the courses of the wall",
            "켜 수",
        ),
        (
            "{ from = 0.5, width = 0.8, courses = 2 }, { from = 1.2, width = 0.8, courses = 2 }",
            "apart, with their lintels",
            "겹치지 않는",
        ),
        (
            "{ from = 1, width = 0, courses = 2 }",
            "wall.openings[1].width",
            "wall.openings[1].width",
        ),
    ] {
        let text = format!(
            "schema = 1\nkind = \"stack\"\nname = \"Wall\"\ndensity = 2600\nwall = {{ length = 3, thickness = 0.4, courses = 6, \
             course_height = 0.25, stone_length = 0.6, openings = [{opening}] }}\n"
        );
        fs::write(scratch.path().join("w.toml"), text).unwrap();
        let run = scratch.briefly("check w.toml");
        assert!(
            run.status > 1 && run.stderr.contains(en),
            "{opening}: {}",
            run.stderr
        );
        let run = scratch.briefly("check w.toml --language ko");
        assert!(run.stderr.contains(ko), "{opening}: {}", run.stderr);
    }
}
