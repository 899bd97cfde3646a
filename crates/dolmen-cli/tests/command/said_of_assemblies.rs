// SOURCE     faults that an engineer found with structures whose answer he knew
// GOAL       What an answer about an assembly says is true, whole and in one language.
// TOLERANCE  none

use super::verbs::Scratch;
use std::fs;

fn with(name: &str, project: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    scratch
}

const ARCH: &str = "schema = 1\nkind = \"stack\"\nname = \"Arch\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
    arch = { span = 3, thickness = 0.45, depth = 1, voussoirs = 15, springing_height = 1.2, abutment = 1.5 }\n";

#[test]
fn holds_an_arch_whose_hinges_change_their_joints_stands_and_says_that_it_jumps() {
    let moved = |z: &str| format!("{ARCH}support_movement = [{{ on = \"right abutment\", z = \"{z}\" }}]\n");
    let scratch = with("jumps", &moved("-120 mm"));
    let answer = scratch.briefly("check project.toml");
    assert!(
        answer.stdout.contains("VERDICT Own weight: stable"),
        "{}",
        answer.stdout
    );
    assert!(
        answer.words().contains("At 90.6 mm stones jump by up to 6.6"),
        "{}",
        answer.stdout
    );
    let korean = scratch.briefly("check project.toml --language ko").words();
    assert!(korean.contains("90.6 mm에서 열린 접합면이 닫히고"), "{korean}");
    // a tenth of its size, 6 m, and more: not followed to 1.5 times that, or not at all
    let near = with("jumps-near", &moved("-500 mm")).briefly("check project.toml");
    assert!(
        near.words().contains("“stable” needs 1.50 times"),
        "{}",
        near.stdout
    );
    let far = with("jumps-far", &moved("-900 mm")).briefly("check project.toml");
    assert!(
        far.words().contains("nothing is known of the movement beyond"),
        "{}",
        far.stdout
    );
    for answer in [near, far] {
        assert!(
            answer.stdout.contains("VERDICT Own weight: unknown"),
            "{}",
            answer.stdout
        );
    }
}

#[test]
fn holds_a_wall_of_leaves_says_which_joint_moves_first() {
    let wall = "schema = 1\nkind = \"stack\"\nname = \"Wall\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
        wall = { length = 1.2, thickness = 0.8, courses = 4, course_height = 0.25, stone_length = 0.6, leaves = 3 }\n";
    let answer = with("first-of-leaves", wall).briefly("check project.toml");
    assert!(
        answer.words().contains("First what stands on"),
        "{}",
        answer.stdout
    );
}

#[test]
fn holds_a_variant_with_a_site_has_its_words_once() {
    let project = "schema = 1\nkind = \"stack\"\nname = \"T\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
        blocks = [{ name = \"a\", width = 1.0, height = 0.5 }, { name = \"b\", width = 0.6, height = 2.0 }]\n\
        site = { code = \"KDS 17 10 00\", zone = \"I\", return_period_years = 1000, soil = \"S4\" }\n\
        [variant.rough]\njoint = { friction = 0.8 }\n";
    let scratch = with("variant-site", project);
    let english = scratch.dolmen("check project.toml").words();
    assert!(
        english.contains("own weight stable.") && !english.contains("stable under its weight"),
        "{english}"
    );
    let korean = scratch.dolmen("check project.toml --language ko").words();
    assert!(!korean.contains("자중 자중"), "{korean}");
}

#[test]
fn holds_a_small_surveyed_tilt_is_named_as_it_was_measured() {
    let project = "schema = 1\nkind = \"stack\"\nname = \"T\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
        blocks = [{ name = \"a\", width = 1.2, height = 0.3 }, { name = \"b\", width = 0.6, height = 0.9, tilt = { x = \"1/30\" } }]\n\
        [survey.2024-10-01]\ntilt = { x = \"1/200\" }\n";
    let said = with("small-tilt", project).briefly("check project.toml").words();
    assert!(said.contains("measured a tilt of x 1/200"), "{said}");
}

#[test]
fn holds_korean_answers_on_made_stones_have_their_korean_names() {
    let project = "schema = 1\nkind = \"stack\"\nname = \"T\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
        pagoda = { storeys = 3, body_height = 3.0 }\n\
        site = { code = \"table\", periods_s = [0, 0.1, 0.5, 2], accelerations = [0.2, 0.5, 0.5, 0.125], unit = \"g\" }\n";
    let scratch = with("korean-stones", project);
    // in full, the project file is printed too
    let said = scratch.briefly("check project.toml --language ko").words();
    for english in ["storey ", "upper base", "table of"] {
        assert!(!said.contains(english), "{english}: {said}");
    }
    assert!(said.contains("지진 project.toml:"), "{said}");
    let from_a_spectrum_in_m_s2 = project.replace("[0.2, 0.5, 0.5, 0.125]", "[2.0, 5.0, 5.0, 1.25]");
    let slip = with("spectrum-unit", &from_a_spectrum_in_m_s2).briefly("check project.toml");
    assert!(
        slip.stderr.contains("site.unit"),
        "{} {}",
        slip.stdout,
        slip.stderr
    );
}

#[test]
fn refuses_a_mesh_once_and_to_a_tenth_of_a_millimetre() {
    let scratch = Scratch::new("mesh-once");
    // a tetrahedron without its base
    let mesh = "v 0 0 0\nv 1.23456789 0 0\nv 0 1 0\nv 0 0 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    fs::write(scratch.path().join("open.obj"), mesh).unwrap();
    let answer = scratch.briefly("new pagoda tower --scan open.obj --beds 0.5 --unit m");
    assert_eq!(
        answer.stderr.matches("the mesh has a hole").count(),
        1,
        "{}",
        answer.stderr
    );
    assert!(answer.stderr.contains("(1.2346, 0, 0)"), "{}", answer.stderr);
}
