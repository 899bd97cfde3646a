//! Stacks: values, places of the blocks, and the full text of every message.

use super::project::{example, refused, with};
use dolmen::comparisons::p10;
use dolmen::structure::stack::{Body, JointMaterial, Stack};
use dolmen_project::{Quantity, StackPart, Structure, WarningKind, parse_project};
use dolmen_words::Language;

/// A correct stack: each test breaks one thing.
const STACK: &str = r#"schema = 1
kind = "stack"
name = "Pagoda"
density = 2600
joint = { friction = 0.6, normal_stiffness = "1 GPa/m", shear_stiffness = "0.4 GPa/m", damping_ratio = 0.3 }
blocks = [
  { name = "base", width = 2.4, height = 0.5 },
  { name = "body", shape = "frustum", width = 1.2, top_width = 1.1, height = 1.0 },
  { name = "roof", width = 2.35, depth = 2.0, height = 0.3, offset = [0.01, 0] },
]
"#;

fn stack_with(changes: &[(&str, &str)]) -> String {
    with(STACK, changes)
}

fn part(text: &str) -> StackPart {
    let project = parse_project(text, "project.toml").unwrap_or_else(|error| panic!("{error}"));
    let Structure::Stack(part) = project.structure else {
        panic!("not a stack")
    };
    *part
}

fn built(text: &str) -> Stack {
    part(text).build(&mut Quantity::nominal).unwrap()
}

#[test]
fn holds_blocks_stand_on_each_other_where_the_file_puts_them() {
    let stack = built(STACK);
    assert_eq!(stack.joints().len(), 3);
    let roof = stack.blocks()[2].solid.bounds_m();
    let expected = [[0.01 - 1.175, -1.0, 1.5], [0.01 + 1.175, 1.0, 1.8]];
    for (given, expected) in roof.iter().flatten().zip(expected.iter().flatten()) {
        assert!((given - expected).abs() < 1e-12, "{roof:?}");
    }
    let body = &stack.joints()[1];
    assert_eq!((body.lower, body.upper), (Body::Block(0), 1));
    assert!((body.patch.moments().area_m2 - 1.44).abs() < 1e-12);
    assert!((body.material.normal_stiffness_pa_m - 1e9).abs() < 1.0);
    // the frustum's depth at its top is in proportion
    assert!((stack.joints()[2].patch.moments().area_m2 - 1.21).abs() < 1e-12);
    let base = 2600.0 * 2.4 * 2.4 * 0.5;
    assert!((stack.blocks()[0].mass_kg() - base).abs() < 1e-9);
}

#[test]
fn holds_several_stones_a_storey_carry_one_slab() {
    let posts = r#"[
  { name = "base", width = 2.4, height = 0.5 },
  { name = "post a", on = "base", at = [0.9, 0.9], width = 0.3, height = 1.0 },
  { name = "post b", on = "base", at = [-0.9, 0.9], width = 0.3, height = 1.0 },
  { name = "post c", on = "base", at = [0, -0.9], width = 0.3, height = 1.0, rotation = "45 deg" },
  { name = "slab", on = ["post a", "post b", "post c"], width = 2.4, height = 0.3, offset = [0, -0.3] },
]"#;
    let start = STACK.find("[\n").unwrap();
    let text = STACK[..start].to_owned() + posts + "\n";
    let stack = built(&text);
    assert_eq!(stack.joints().len(), 7);
    let slab = stack.blocks()[4].solid.bounds_m();
    // the middle of the three tops, and 0.3 m towards −y
    assert!((slab[0][1] + slab[1][1]).abs() < 1e-12, "{slab:?}");
    let turned = stack.blocks()[3].solid.bounds_m();
    assert!((turned[1][0] - 0.15 * 2f64.sqrt()).abs() < 1e-12);
    let low = text.replace(
        "on = \"base\", at = [0, -0.9], width = 0.3, height = 1.0",
        "on = \"base\", at = [0, -0.9], width = 0.3, height = 0.98",
    );
    let said = r##"
error: 'slab' is said to stand on 'post c', but they do not touch: it is 0.0000 m along x, 0.0000 m along y and 0.0200 m along z away from it, and a bed there must lie within 0.005 m of it and be level with it to 5°
  --> project.toml:11:3
   |
 11 |   { name = "slab", on = ["post a", "post b", "post c"], width = 2.4, height = 0.3, offset = [0, -0.3] },
"##;
    assert!(
        refused(&low).starts_with(
            said.trim_start_matches('\n')
                .split(" -->")
                .next()
                .unwrap()
                .trim_end()
        )
    );
    assert!(refused(&low).contains("project.toml:11:3"), "{}", refused(&low));
}

#[test]
fn holds_a_leaning_stone_carries_the_next_on_its_own_plane() {
    let text = stack_with(&[(
        "top_width = 1.1, height = 1.0",
        "top_width = 1.1, height = 1.0, tilt = { x = \"1/200\" }",
    )]);
    let stack = built(&text);
    let top_m = stack.blocks()[2].solid.bounds_m()[0][2];
    // offset of 0.01 m on a top that falls by 1/200
    let slope: f64 = 1.0 / 200.0;
    let lean = 1.0 / slope.hypot(1.0);
    // centre of the leaning top, and 10 mm down its slope
    let expected = 0.5 + lean - 0.01 * slope;
    assert!((top_m - expected).abs() < 1e-12, "{top_m} {expected}");
    let middle = stack.blocks()[2].solid.centroid_m()[0];
    assert!((middle - (0.01 + slope * lean)).abs() < 1e-12, "{middle}");
}

#[test]
fn holds_joints_differ_by_block_and_by_pair() {
    let text = stack_with(&[(
        "offset = [0.01, 0] },\n]\n",
        "offset = [0.01, 0], joint = { friction = 0.5, friction_kinetic = 0.45, cohesion = \"20 kPa\" } },\n]\n\
         contacts = [{ lower = \"base\", upper = \"body\", joint = { friction = \"40 %\" } }]\n",
    )]);
    let stack = built(&text);
    // a joint has one contact
    let again = "joint = { friction = \"40 %\" } }, { lower = \"base\", upper = \"body\", joint = { friction = 0.9 } }]";
    let twice = text.replace("joint = { friction = \"40 %\" } }]", again);
    let fault = parse_project(&twice, "stack.toml").unwrap_err().to_string();
    let said = "contacts[2] gives the joint of 'body' on 'base' a second time, after contacts[1]";
    assert!(fault.contains(said), "{fault}");
    let friction = |joint: usize| {
        let material = &stack.joints()[joint].material;
        (
            material.friction_static,
            material.friction_kinetic,
            material.cohesion_pa,
        )
    };
    assert_eq!(friction(0), (0.6, 0.6, 0.0));
    assert_eq!(friction(1), (0.4, 0.4, 0.0));
    assert_eq!(friction(2), (0.5, 0.45, 20e3));
    assert_eq!(stack.joints()[2].material.shear_stiffness_pa_m, 4e8);
}

#[test]
fn holds_ties_and_side_supports_are_read() {
    let text = STACK.to_owned()
        + "ties = [{ lower = \"base\", upper = \"body\", position = [0, 0, 0.5], shear_stiffness = \"20 kN/mm\", shear_strength = \"15 kN\" }]\n\
           side_supports = [{ block = \"body\", position = [0.6, 0, 1.0], direction = \"x\", gap = \"20 mm\", stiffness = \"5 kN/mm\" }]\n";
    let stack = built(&text);
    assert_eq!(stack.ties()[0].shear_stiffness_n_m, 20e6);
    assert_eq!(stack.ties()[0].axis, [0.0, 0.0, 1.0]);
    assert_eq!(
        (stack.side_supports()[0].gap_m, stack.side_supports()[0].block),
        (0.02, 1)
    );
}

#[test]
fn holds_movements_of_supports_are_read_and_refused_by_name() {
    let moved = |movement: &str| STACK.to_owned() + "support_movement = [" + movement + "]\n";
    let text = moved("{ on = \"base\", x = \"30 mm\", z = \"-10 mm\" }");
    let movement = built(&text).support_movements()[0];
    assert_eq!((movement.block, movement.movement_m), (0, [0.03, 0.0, -0.01]));
    let project = parse_project(&text, "project.toml").unwrap();
    let mut paths = project.inputs().into_iter().map(|input| input.path.as_str());
    assert!(paths.any(|path| path == "support_movement[1].z"));
    let still = refused(&moved("{ on = \"base\", x = 0 }"));
    assert!(still.contains("support_movement[1] moves nothing"), "{still}");
    let unknown = refused(&moved("{ on = \"bose\", x = \"1 mm\" }"));
    assert!(
        unknown.contains("bose") && unknown.contains("did you mean"),
        "{unknown}"
    );
    let above = refused(&moved("{ on = \"roof\", x = \"1 mm\" }"));
    assert!(above.contains("'roof', which does not stand on it"), "{above}");
}

#[test]
fn holds_every_number_of_a_stack_is_an_input_and_can_be_picked() {
    let text = stack_with(&[
        (
            "density = 2600",
            "density = { value = 2600, cov = 0.03, source = \"test\" }",
        ),
        (
            "offset = [0.01, 0]",
            "offset = [{ value = 0.01, sd = 0.002, source = \"measured\" }, 0], tilt = { y = \"1/300\" }, rotation = \"1 deg\"",
        ),
    ]);
    let project = parse_project(&text, "project.toml").unwrap();
    let paths: Vec<&str> = project.inputs().iter().map(|input| input.path.as_str()).collect();
    assert_eq!(
        paths,
        [
            "density",
            "joint.friction",
            "joint.normal_stiffness",
            "joint.shear_stiffness",
            "joint.damping_ratio",
            "blocks[1].width",
            "blocks[1].height",
            "blocks[2].width",
            "blocks[2].top_width",
            "blocks[2].height",
            "blocks[3].width",
            "blocks[3].depth",
            "blocks[3].height",
            "blocks[3].offset[1]",
            "blocks[3].offset[2]",
            "blocks[3].rotation",
            "blocks[3].tilt.y",
        ]
    );
    let Structure::Stack(part) = &project.structure else {
        panic!()
    };
    let mut pick = |q: &Quantity| {
        if q.path == "blocks[2].height" {
            1.2
        } else {
            q.value
        }
    };
    assert!((part.build(&mut pick).unwrap().height_m() - 2.0).abs() < 0.01);
}

#[test]
fn holds_what_joints_do_not_say_is_named_and_variants_patch_blocks() {
    let text = stack_with(&[(
        "joint = { friction = 0.6, normal_stiffness = \"1 GPa/m\", shear_stiffness = \"0.4 GPa/m\", damping_ratio = 0.3 }\n",
        "",
    )]) + "\n[variant.moved]\nblocks = { 3 = { offset = [0.05, 0] } }\n";
    let project = parse_project(&text, "project.toml").unwrap();
    assert_eq!(project.kind(), "stack");
    let warning = &project.warnings[0];
    assert_eq!((warning.kind, warning.line), (WarningKind::JointDefaults, 5));
    assert!(
        warning
            .message
            .text(Language::English)
            .contains("and assumed: friction 0.6, normal_stiffness 1e9 Pa/m"),
        "{:?}",
        warning.message
    );
    let Structure::Stack(moved) = &project.variants[0].project.structure else {
        panic!()
    };
    assert_eq!(moved.blocks[2].offset.as_ref().unwrap()[0].value, 0.05);
}

#[test]
fn agrees_the_example_p10_with_that_of_the_library() {
    let built = built(&example("p10"));
    let library = p10(JointMaterial::with_friction(0.6), 9.80665).unwrap();
    assert_eq!(built.joints().len(), library.joints().len());
    for (ours, theirs) in built.blocks().iter().zip(library.blocks()) {
        assert_eq!(ours.name, theirs.name);
        assert!((ours.mass_kg() - theirs.mass_kg()).abs() < 1e-9);
        for (a, b) in ours.solid.centroid_m().iter().zip(theirs.solid.centroid_m()) {
            assert!((a - b).abs() < 1e-12);
        }
    }
    assert_eq!(built.joints()[3].material, library.joints()[3].material);
}

#[test]
fn exact_prisms_drums_and_openings_have_their_volumes() {
    let text = stack_with(&[
        (
            "shape = \"frustum\", width = 1.2, top_width = 1.1",
            "shape = \"prism\", sides = 6, width = 1.2",
        ),
        (
            "width = 2.35, depth = 2.0, height = 0.3",
            "shape = \"drum\", diameter = 2.0, height = 0.3, openings = [{ width = 0.4, depth = 0.2, height = 0.1, position = [0.5, 0, 0.1] }]",
        ),
    ]);
    let stack = built(&text);
    let volume = |block: usize| stack.blocks()[block].solid.volume_m3();
    assert!(
        (volume(1) - 1.2 * 1.2 * 0.5 * 3f64.sqrt()).abs() < 1e-12,
        "{}",
        volume(1)
    );
    assert!(
        (volume(2) - (0.3 * std::f64::consts::PI - 0.008)).abs() < 1e-12,
        "{}",
        volume(2)
    );
    // material removed on the right moves the centroid to the left of the axis, which is 10 mm from the middle
    let centroid = stack.blocks()[2].solid.centroid_m()[0] - 0.01;
    assert!((centroid + 0.008 * 0.5 / volume(2)).abs() < 1e-12, "{centroid}");
}

/// The full message of each broken file.
#[test]
fn refuses_bad_stacks_with_the_line_and_the_remedy() {
    let cases: [((&str, &str), &str); 16] = [
        (
            ("width = 2.35", "width = 1150"),
            r##"
error: blocks[3].width = 1150 m, 958 × the stone below
  --> project.toml:9:28
   |
 9 |   { name = "roof", width = 1150, depth = 2.0, height = 0.3, offset = [0.01, 0] },
   |                            ^^^^ probably a slip
   = help: did you mean mm? If it is right, write allow = ["blocks[3].width"]
"##,
        ),
        (
            ("density = 2600", "density = 2.6"),
            r##"
error: density = 2.6 kg/m3, but stone has 1500 to 3200 kg/m3
  --> project.toml:4:11
   |
 4 | density = 2.6
   |           ^^^ probably a slip
   = help: did you mean "2.6 t/m3"? If it is right, write allow = ["density"]
"##,
        ),
        (
            ("friction = 0.6", "friction = 60"),
            r##"
error: joint.friction = 60, but stone on stone has 0.4 to 0.8
  --> project.toml:5:22
   |
 5 | joint = { friction = 60, normal_stiffness = "1 GPa/m", shear_stiffness = "0.4 GPa/m", damping_ratio = 0.3 }
   |                      ^^ probably a slip
   = help: did you mean "60 %"? If it is right, write allow = ["joint.friction"]
"##,
        ),
        (
            ("\"1 GPa/m\"", "1"),
            r##"
error: joint.normal_stiffness = 1 Pa/m, but joints have 1e6 to 1e13 Pa/m
  --> project.toml:5:46
   |
 5 | joint = { friction = 0.6, normal_stiffness = 1, shear_stiffness = "0.4 GPa/m", damping_ratio = 0.3 }
   |                                              ^ probably a slip
   = help: did you mean MPa/m or GPa/m? If it is right, write allow = ["joint.normal_stiffness"]
"##,
        ),
        (
            ("name = \"roof\"", "name = \"body\""),
            r##"
error: blocks[3].name = "body" is also the name of blocks[2]
  --> project.toml:9:12
   |
 9 |   { name = "body", width = 2.35, depth = 2.0, height = 0.3, offset = [0.01, 0] },
   |            ^^^^^^ must be unique
   = help: number them: "body 1", "body 2"
"##,
        ),
        (
            ("offset = [0.01, 0]", "on = \"bodi\""),
            r##"
error: blocks[3].on = "bodi" is no block
  --> project.toml:9:66
   |
 9 |   { name = "roof", width = 2.35, depth = 2.0, height = 0.3, on = "bodi" },
   |                                                                  ^^^^^^ unknown name
   = help: did you mean "body"?
"##,
        ),
        (
            ("height = 0.5 }", "height = 0.5, on = \"roof\" }"),
            r##"
error: blocks[1].on: 'base' stands, over the blocks below it, on itself
  --> project.toml:7:3
   |
 7 |   { name = "base", width = 2.4, height = 0.5, on = "roof" },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   = help: let one of them stand on "ground"
"##,
        ),
        (
            ("offset = [0.01, 0]", "offset = [4, 0]"),
            r##"
error: blocks[3]: 'roof' floats: it is 2.2250 m along x, 0.0000 m along y and 0.0000 m along z off the top of body, and 1.5000 m above the ground, and a bed must lie within 0.005 m
  --> project.toml:9:3
   |
 9 |   { name = "roof", width = 2.35, depth = 2.0, height = 0.3, offset = [4, 0] },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
"##,
        ),
        (
            ("offset = [0.01, 0]", "on = \"base\", offset = [0.6, 0]"),
            r##"
error: blocks[3]: 'roof' and 'body' overlap by 0.3000 m, but stones may touch only (within 0.005 m): check their sizes and offsets
  --> project.toml:9:3
   |
 9 |   { name = "roof", width = 2.35, depth = 2.0, height = 0.3, on = "base", offset = [0.6, 0] },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
"##,
        ),
        (
            ("offset = [0.01, 0]", "rotation = 3"),
            r##"
error: blocks[3].rotation = 3 has no unit
  --> project.toml:9:72
   |
 9 |   { name = "roof", width = 2.35, depth = 2.0, height = 0.3, rotation = 3 },
   |                                                                        ^ must be an angle with its unit
   = help: write "3 deg" or "3 rad"
"##,
        ),
        (
            ("offset = [0.01, 0]", "offset = [0.01]"),
            r##"
error: blocks[3].offset has 1 numbers
  --> project.toml:9:70
   |
 9 |   { name = "roof", width = 2.35, depth = 2.0, height = 0.3, offset = [0.01] },
   |                                                                      ^^^^^^ must be 2: [x, y]
"##,
        ),
        (
            ("offset = [0.01, 0]", "tilt = { x = \"slightly\" }"),
            r##"
error: blocks[3].tilt.x = "slightly" is not a tilt
  --> project.toml:9:74
   |
 9 |   { name = "roof", width = 2.35, depth = 2.0, height = 0.3, tilt = { x = "slightly" } },
   |                                                                          ^^^^^^^^^^ must be a ratio, or text such as "1/177", "0.32 deg", "5.65 mm/m"
"##,
        ),
        (
            ("top_width = 1.1, ", ""),
            r##"
error: blocks[2] has no "top_width", but a frustum needs it
  --> project.toml:8:3
   |
 8 |   { name = "body", shape = "frustum", width = 1.2, height = 1.0 },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   = help: write top_width = …
"##,
        ),
        (
            ("depth = 2.0", "top_width = 2.0"),
            r##"
error: blocks[3].top_width has no meaning in a box
  --> project.toml:9:46
   |
 9 |   { name = "roof", width = 2.35, top_width = 2.0, height = 0.3, offset = [0.01, 0] },
   |                                              ^^^
   = help: take it out, or write shape = "frustum" or shape = "prism"
"##,
        ),
        (
            ("density = 2600\n", ""),
            r##"
error: blocks[1] has no density, nor have 2 more blocks
  --> project.toml:6:3
   |
 6 |   { name = "base", width = 2.4, height = 0.5 },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   = help: write density = 2600 at the top level for all blocks (granite, kg/m3), or density = … in the block
"##,
        ),
        (
            ("offset = [0.01, 0]", "offset = [{ value = -0.01, cov = 0.1 }, 0]"),
            r##"
error: blocks[3].offset[1] = -0.01 m has a scatter
  --> project.toml:9:71
   |
 9 |   { name = "roof", width = 2.35, depth = 2.0, height = 0.3, offset = [{ value = -0.01, cov = 0.1 }, 0] },
   |                                                                       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ must be above 0 to have one
   = help: a number with a cov or sd stands for a lognormal variable, which is positive
"##,
        ),
    ];
    let mut wrong = String::new();
    for (change, said) in cases {
        let refused = refused(&stack_with(&[change]));
        if refused != said.trim_start_matches('\n') {
            wrong += &format!("{change:?}\n{refused}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn holds_stones_that_say_what_they_stand_on_come_in_any_order() {
    let upside = r#"[
  { name = "roof", width = 2.35, depth = 2.0, height = 0.3, offset = [0.01, 0], on = "body" },
  { name = "base", width = 2.4, height = 0.5, on = "ground" },
  { name = "body", shape = "frustum", width = 1.2, top_width = 1.1, height = 1.0, on = "base" },
]
"#;
    let list = &STACK[STACK.find("blocks = ").unwrap() + "blocks = ".len()..];
    let (given, turned) = (built(STACK), built(&STACK.replace(list, upside)));
    assert_eq!(turned.joints().len(), 3);
    for block in given.blocks() {
        let same = turned
            .blocks()
            .iter()
            .find(|other| other.name == block.name)
            .unwrap();
        assert_eq!(same.solid, block.solid);
    }
}

#[test]
fn refuses_a_list_that_begins_with_the_top() {
    let top_first = r#"[
  { name = "bowl", width = 0.4, height = 0.2 },
  { name = "roof", width = 1.2, height = 0.3 },
  { name = "body", width = 1.0, height = 0.8 },
  { name = "base", width = 2.4, height = 0.5 },
]
"#;
    let list = &STACK[STACK.find("blocks = ").unwrap() + "blocks = ".len()..];
    let said = parse_project(&STACK.replace(list, top_first), "project.toml")
        .unwrap_err()
        .to_string();
    assert!(
        said.contains(
            "the last stone, 'base', stands on top and is 2.4 m wide, the first, 'bowl', stands on the ground and is 0.4 m"
        ) && said.contains("list the stones lowest first"),
        "{said}"
    );
}

/// Two cubes of points in coordinates of a site, the upper one listed first and no `on`: the joint is where they touch.
#[test]
fn holds_stones_of_a_site_stand_on_what_they_touch() {
    let cube = |low: f64| {
        let corners = (0..8).map(|i| {
            let [x, y, z] = [i & 1, (i >> 1) & 1, i >> 2].map(f64::from);
            format!("[{x}, {y}, {}]", z + low)
        });
        corners.collect::<Vec<_>>().join(", ")
    };
    let stones = format!(
        "[\n  {{ name = \"high\", shape = \"points\", coordinates = \"site\", points = [{}] }},\n  \
         {{ name = \"low\", shape = \"points\", coordinates = \"site\", points = [{}] }},\n]\n",
        cube(1.0),
        cube(0.0)
    );
    let list = &STACK[STACK.find("blocks = ").unwrap() + "blocks = ".len()..];
    let stack = built(&STACK.replace(list, &stones));
    let ends: Vec<_> = stack
        .joints()
        .iter()
        .map(|joint| (joint.lower, joint.upper))
        .collect();
    assert_eq!(ends, [(Body::Block(1), 0), (Body::Ground, 1)]);
}
