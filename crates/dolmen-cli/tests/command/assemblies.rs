// SOURCE     Leaves, bonds, gaps and non-convex stones from an audit; right values by hand: b/h of one leaf.
// GOAL       If a stone, a joint or friction cannot support a part, the short answer counts, reports or refuses it.
// TOLERANCE  none: words and exit statuses; accelerations to the three printed digits.

use super::verbs::Scratch;
use std::fs;

const HEAD: &str = "schema = 1\nkind = \"stack\"\nname = \"Assembly\"\ndensity = 2500\n";
const JOINT: &str = "joint = { friction = 0.6, normal_stiffness = \"1e10 Pa/m\", shear_stiffness = \"4e9 Pa/m\", damping_ratio = 0.3 }\n";

fn said(name: &str, text: &str, words: &str) -> (i32, String) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly(words);
    (answer.status, format!("{}{}", answer.words(), answer.stderr))
}

/// Two leaves of 0.2 × 3 × 3 m, as far apart as given.
fn leaves(apart_m: f64) -> String {
    let leaf = |name: &str, x: f64| {
        let corners: Vec<String> = [0.0, 3.0]
            .iter()
            .flat_map(|z| {
                [(x, -1.5), (x, 1.5), (x + 0.2, -1.5), (x + 0.2, 1.5)]
                    .map(|(x, y)| format!("[{x}, {y}, {z}]"))
            })
            .collect();
        let corners = corners.join(", ");
        format!("{{ name = \"{name}\", shape = \"points\", coordinates = \"site\", points = [{corners}] }}")
    };
    let (one, other) = (leaf("leaf1", 0.0), leaf("leaf2", 0.2 + apart_m));
    format!("{HEAD}{JOINT}blocks = [{one}, {other}]\n")
}

#[test]
fn exact_two_leaves_without_through_stones_bear_what_one_bears() {
    let (status, words) = said("two-leaves", &leaves(0.0), "check project.toml");
    assert_eq!(status, 0, "{words}");
    assert!(
        words.contains("begins to move between 0.0667 g and 0.0869 g"),
        "{words}"
    );
    let (_, full) = said("two-leaves", &leaves(0.0), "check project.toml --full");
    assert!(
        full.contains("would hold 0.0869 g, which is an upper bound"),
        "{full}"
    );
}

#[test]
fn holds_a_gap_between_leaves_is_said_and_opened() {
    let (_, words) = said("gap-between-leaves", &leaves(0.004), "check project.toml");
    assert!(words.contains("begins to move at 0.0667 g"), "{words}");
    assert!(
        words.contains("Left open: leaf1 – leaf2, 0.0040 m apart"),
        "{words}"
    );
    // the run begins with the gap, too
    let shaken = "simulate project.toml --motion el-centro-1940-ns --peak 0.01g --law springs --repeats 1";
    let (_, words) = said("gap-simulated", &leaves(0.004), shaken);
    assert!(
        words.contains("start open: leaf1 – leaf2, 0.0040 m apart"),
        "{words}"
    );
}

#[test]
fn holds_a_gap_below_the_middle_of_a_beam_is_said() {
    let points = |name: &str, [x0, x1]: [f64; 2], [z0, z1]: [f64; 2]| {
        let corners: Vec<String> = [z0, z1]
            .iter()
            .flat_map(|z| {
                [(x0, -0.25), (x0, 0.25), (x1, -0.25), (x1, 0.25)].map(|(x, y)| format!("[{x}, {y}, {z}]"))
            })
            .collect();
        let corners = corners.join(", ");
        format!("{{ name = \"{name}\", shape = \"points\", coordinates = \"site\", points = [{corners}] }}")
    };
    let blocks = [
        points("p1", [-2.0, -1.6], [0.0, 2.0]),
        points("p2", [1.6, 2.0], [0.0, 2.0]),
        points("middle", [-0.2, 0.2], [0.0, 1.996]),
        points("beam", [-2.0, 2.0], [2.0, 2.4]),
    ]
    .join(", ");
    let (_, words) = said(
        "low-pier",
        &format!("{HEAD}{JOINT}blocks = [{blocks}]\n"),
        "check project.toml",
    );
    assert!(words.contains("middle – beam, 0.0040 m apart"), "{words}");
}

const L: &str = "v 0 0 0\nv 1 0 0\nv 1 .7 0\nv .7 .7 0\nv .7 1 0\nv 0 1 0\nv 0 0 .5\nv 1 0 .5\nv 1 .7 .5\nv .7 .7 .5\nv .7 1 .5\nv 0 1 .5\n\
    f 1 3 2\nf 1 4 3\nf 1 5 4\nf 1 6 5\nf 7 8 9\nf 7 9 10\nf 7 10 11\nf 7 11 12\n\
    f 1 2 8\nf 1 8 7\nf 2 3 9\nf 2 9 8\nf 3 4 10\nf 3 10 9\nf 4 5 11\nf 4 11 10\nf 5 6 12\nf 5 12 11\nf 6 1 7\nf 6 7 12\n";

#[test]
fn refuses_a_post_on_the_missing_corner_of_an_l() {
    let scratch = Scratch::new("post-on-air");
    fs::write(scratch.path().join("l.obj"), L).unwrap();
    let on = |x: f64, y: f64| {
        let points: Vec<String> = [0.5, 1.3]
            .iter()
            .flat_map(|z| {
                [(0.0, 0.0), (0.2, 0.0), (0.0, 0.2), (0.2, 0.2)]
                    .map(|(u, v)| format!("[{}, {}, {z}]", x + u, y + v))
            })
            .collect();
        let post = points.join(", ");
        let text = format!(
            "{HEAD}{JOINT}blocks = [{{ name = \"base\", shape = \"mesh\", file = \"l.obj\", coordinates = \"site\" }}, \
             {{ name = \"post\", shape = \"points\", coordinates = \"site\", points = [{post}] }}]\n"
        );
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        scratch.briefly("check project.toml")
    };
    let on_air = on(0.71, 0.71);
    assert_eq!(on_air.status, 2, "{}", on_air.stdout);
    assert!(
        on_air.stderr.contains("'post' on 'base'") && on_air.stderr.contains("0.0 %"),
        "{}",
        on_air.stderr
    );
    assert_eq!(on(0.63, 0.7).status, 2);
    let on_leg = on(0.2, 0.2);
    assert_eq!(on_leg.status, 0, "{}", on_leg.stderr);
}

#[test]
fn refuses_an_opening_through_the_foot() {
    let text = format!(
        "{HEAD}{JOINT}blocks = [{{ name = \"shrine\", width = 1.0, depth = 1.0, height = 1.5, \
         openings = [{{ width = 1.0, depth = 0.8, height = 1.4, position = [0, -0.1, 0] }}] }}]\n"
    );
    let (status, words) = said("opening-through-foot", &text, "check project.toml");
    assert_eq!(status, 2, "{words}");
    assert!(
        words.contains("20.0 %") && words.contains("an opening reaches the joint"),
        "{words}"
    );
    // an inner cavity, and a small one in the bed, make no difference
    let chamber = text.replace("position = [0, -0.1, 0]", "position = [0, 0, 0.05]");
    assert_eq!(said("chamber-within", &chamber, "check project.toml").0, 0);
}

#[test]
fn holds_a_tilt_that_a_run_leaves_out_is_in_its_headline() {
    let wall = format!(
        "{HEAD}{JOINT}wall = {{ length = 1.4, thickness = 0.3, courses = 2, course_height = 0.3, stone_length = 0.7 }}\n\
         [survey.\"2024-05-01\"]\ntilt = {{ y = \"1/12\" }}\n"
    );
    let scratch = Scratch::new("tilt-of-a-wall");
    fs::write(scratch.path().join("project.toml"), &wall).unwrap();
    let run = "simulate project.toml --motion el-centro-1940-ns --peak 0.01g --law springs --repeats 1";
    let answer = scratch.briefly(run);
    assert!(
        answer
            .words()
            .contains("not in it: tilt y 1/12 of survey 2024-05-01"),
        "{}",
        answer.stdout
    );
    assert!(
        answer.words().contains("The run starts plumb"),
        "{}",
        answer.stdout
    );
    let json = scratch.briefly(&format!("{run} --json")).stdout;
    assert!(
        json.contains("\"tilt_left_out\": {") || json.contains("\"tilt_left_out\":{"),
        "{json}"
    );
}

#[test]
fn holds_a_tilt_that_a_wall_leaves_out_takes_its_part_of_the_capacity() {
    // 0.3 × 2 m moves at 0.15 g plumb, and at 0.15 - 1/15 with its lean; the same wall as two long stones leans in the model
    let wall = |tilt: &str| {
        format!(
            "{HEAD}{JOINT}wall = {{ length = 1.4, thickness = 0.3, courses = 4, course_height = 0.5, stone_length = 0.7 }}\n\
             wind = {{ speed = 25, means = \"gust\", force_coefficient = 1.3 }}\n\
             site = {{ code = \"table\", periods_s = [0, 0.05, 0.06, 4], accelerations = [0.1, 0.1, 0.1, 0.02], unit = \"g\" }}\n\
             [survey.\"2024-05-01\"]\ntilt = {{ y = \"{tilt}\" }}\n"
        )
    };
    let (status, plumb) = said("tilt-of-capacity-1", &wall("1/400"), "check project.toml");
    assert!(
        status == 0 && plumb.contains("loads: stable") && plumb.contains("above demand"),
        "{plumb}"
    );
    let (_, leaning) = said("tilt-of-capacity-2", &wall("1/15"), "check project.toml");
    assert!(
        leaning.contains("loads: unknown") && leaning.contains("not decided"),
        "{leaning}"
    );
    assert!(leaning.contains("not in it: tilt y 1/15"), "{leaning}");
}

#[test]
fn holds_an_arch_held_by_bond_or_by_static_friction_alone_says_so() {
    let arch = |joint: &str| {
        format!(
            "{HEAD}joint = {{ {joint}, normal_stiffness = \"1e10 Pa/m\", shear_stiffness = \"4e9 Pa/m\", damping_ratio = 0.3 }}\n\
             arch = {{ span = 3, thickness = 0.3, depth = 0.5, voussoirs = 9 }}\n"
        )
    };
    let (_, words) = said(
        "bonded-arch",
        &arch("friction = 0.3, cohesion = \"100 kPa\""),
        "check project.toml",
    );
    assert!(
        words.contains("Held by bond") && words.contains("marginal"),
        "{words}"
    );
    let (_, words) = said(
        "kinetic-arch",
        &arch("friction = 0.7, friction_kinetic = 0.2"),
        "check project.toml",
    );
    assert!(
        words.contains("it does not stand: no forces balance the weight"),
        "{words}"
    );
}

#[test]
fn holds_a_cap_pressed_against_its_side_support_finds_its_rest() {
    let text = format!(
        "{HEAD}units = {{ force = \"kN\" }}\njoint = {{ friction = 0.6, normal_stiffness = \"1e10 Pa/m\", shear_stiffness = \"4e9 Pa/m\", damping_ratio = 0.1 }}\n\
         blocks = [{{ name = \"base\", width = 1.2, height = 0.4 }}, {{ name = \"shaft\", width = 0.4, height = 1.6 }}, \
         {{ name = \"cap\", width = 0.8, height = 0.3 }}]\nloads = [{{ name = \"pull\", at = \"cap\", force = [0.5, 0, 0] }}]\n\
         side_supports = [{{ block = \"cap\", position = [0.4, 0, 2.1], direction = [1, 0, 0], gap = 0, stiffness = 1e7 }}]\n"
    );
    let run = "simulate project.toml --motion el-centro-1940-ns --peak 0.01g --law springs --repeats 1";
    let (status, words) = said("pressed-cap", &text, run);
    assert_eq!(status, 0, "{words}");
}

#[test]
fn holds_a_folder_with_blanks_is_quoted_where_it_is_to_be_typed() {
    let scratch = Scratch::new("quoted-folder");
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args(["new", "arch", "새 아치 & b"])
        .current_dir(scratch.path())
        .output()
        .unwrap();
    let printed = String::from_utf8(run.stdout).unwrap();
    assert!(printed.contains("dolmen check \"새 아치 & b\"\n"), "{printed}");
    assert!(printed.contains("-o \"새 아치 & b/report.html\"\n"), "{printed}");
}
