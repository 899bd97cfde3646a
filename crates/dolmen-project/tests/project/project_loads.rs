//! Wind, static loads and combinations in the project file: their values, and every error with its remedy.

use dolmen::structure::wind::Wind;
use dolmen_project::{Quantity, Structure, WindPart, parse_project};

const POLE: &str = r#"schema = 1
kind = "chain"
name = "pole"
units = { length = "m", force = "kN", stiffness = "kN*m/rad" }
links = [
  { name = "shaft", weight = 39, length = 3.7, centroid = 1.6, bed_width = 0.65 },
  { name = "top", weight = 15, length = 2.6, centroid = 1.2, bed_width = 0.48 },
]
joints = [{ stiffness = 2200 }, { stiffness = 630 }]
"#;

/// The pole with these lines appended.
fn with(lines: &str) -> String {
    format!("{POLE}{lines}\n")
}

fn said(lines: &str) -> String {
    let text = with(lines);
    parse_project(&text, "pole.toml").unwrap_err().to_string()
}

#[test]
fn exact_wind_loads_and_combinations_are_read_in_si() {
    let text = with(
        r#"wind = { speed = 30, means = "gust", force_coefficient = 2.0, areas = [{ part = "top", area = 1.2 }, { part = "links[1]", area = 0.5, height = 3.0, force_coefficient = 1.4 }] }
loads = [{ name = "lamp", at = "top", height = 5.0, force = 0.4, weight = "200 N" }]
[combination.storm]
weight = 0.9
wind = 1.5
[combination.dead]
weight = 1.35"#,
    );
    let project = parse_project(&text, "pole.toml").unwrap();
    let WindPart::Given(wind) = &project.loads.wind else {
        panic!("no wind");
    };
    let gust = Wind::Gust {
        speed_m_s: 30.0,
        air_density_kg_m3: 1.25,
    };
    assert_eq!(wind.build(&mut Quantity::nominal), gust);
    assert_eq!((wind.areas[0].part, wind.areas[1].part), (1, 0));
    let load = &project.loads.loads[0];
    assert_eq!(load.force.as_ref().map(|force| force.value), Some(400.0));
    assert_eq!(load.weight.as_ref().map(|weight| weight.value), Some(200.0));
    let factors = |i: usize| {
        let of = &project.loads.combinations[i];
        (of.name.as_deref(), of.weight, of.wind, of.loads)
    };
    assert_eq!(factors(0), (Some("storm"), 0.9, 1.5, 0.0));
    assert_eq!(factors(1), (Some("dead"), 1.35, 0.0, 0.0));
    let sheltered = parse_project(&with("wind = \"sheltered\""), "pole.toml").unwrap();
    assert_eq!(sheltered.loads.wind, WindPart::Sheltered);
    // without combinations every load has the factor 1
    let plain = parse_project(
        &with("wind = { pressure = \"0.6 kPa\", means = \"gust\", force_coefficient = 1.2 }"),
        "pole.toml",
    )
    .unwrap();
    let only = &plain.loads.combinations[0];
    assert_eq!(
        (&only.name, only.weight, only.wind, only.loads),
        (&None, 1.0, 1.0, 1.0)
    );
}

#[test]
fn refuses_a_wind_that_does_not_say_what_it_is_and_says_what_to_do() {
    for (wind, message, help) in [
        (
            r#"speed = 30, pressure = 600, means = "gust""#,
            "wind has both speed and pressure",
            "keep one of them",
        ),
        (
            r#"means = "gust""#,
            "wind has neither speed nor pressure",
            "give speed = \"30 m/s\"",
        ),
        (
            r#"speed = 30"#,
            "wind does not say whether it is a gust or a mean",
            "write means = \"gust\"",
        ),
        (
            r#"speed = 30, means = "10 min""#,
            "no code makes the gust of it",
            "write code = \"EN 1991-1-4\"",
        ),
        (
            r#"speed = 30, means = "gust", code = "EN 1991-1-4", terrain = "II""#,
            "a code makes the gust from a 10-minute mean",
            "write means = \"10 min\"",
        ),
        (
            r#"pressure = 600, means = "10 min""#,
            "says nothing of gusts",
            "give speed with a code",
        ),
        (
            r#"speed = 30, means = "10 min", code = "KDS 41 12 00""#,
            "wind has a code, but no terrain",
            "\"C\" (open country)",
        ),
        (
            r#"speed = 30, means = "10 min", code = "KDS 41 12 00", terrain = "II""#,
            "wind.terrain is one of another code",
            "\"A\" (large town)",
        ),
        (
            r#"speed = 30, means = "gust", topography = 1.2"#,
            "wind.topography has no meaning without a code",
            "take it out",
        ),
        (
            r#"speed = 108, means = "gust""#,
            "no storm that people design for",
            "100 km/h is 28 m/s",
        ),
        (
            r#"speed = 30, means = "gust", areas = [{ part = "tops", area = 1 }]"#,
            "there is no part \"tops\"",
            "did you mean \"top\"?",
        ),
        (
            r#"speed = 30, means = "gust", areas = [{ part = "top", area = 1, height = 2 }]"#,
            "wind.areas[1].height = 2 m is not on links[2]",
            "heights count from the lowest joint",
        ),
    ] {
        let text = said(&format!("wind = {{ {wind}, force_coefficient = 2.0 }}"));
        assert!(text.contains(message) && text.contains(help), "{wind}: {text}");
    }
    let text = said("wind = { speed = 30, means = \"gust\", force_coefficient = 20 }");
    assert!(text.contains("a square prism has 2.0"), "{text}");
}

#[test]
fn refuses_wind_on_a_link_whose_width_nobody_gave() {
    let text = with("wind = { speed = 30, means = \"gust\", force_coefficient = 2.0 }");
    let text = text.replace(", bed_width = 0.48", "");
    let said = parse_project(&text, "pole.toml").unwrap_err().to_string();
    assert!(said.contains("the width of links[2] is not known"), "{said}");
    assert!(said.contains("wind.areas = [{ part = \"links[2]\""), "{said}");
}

#[test]
fn refuses_scatter_that_samples_do_not_draw() {
    let air = said(
        "wind = { speed = 30, means = \"gust\", force_coefficient = 2.0, density = { value = 1.25, cov = 0.1 } }",
    );
    assert!(air.contains("wind.density = 1.25 kg/m3 has a scatter"), "{air}");
    assert!(
        air.contains("samples do not draw it: leave cov or sd out"),
        "{air}"
    );
    let pull = POLE.replace("units =", "gravity = { value = 9.8, cov = 0.01 }\nunits =");
    let pull = parse_project(&pull, "pole.toml").unwrap_err().to_string();
    assert!(
        pull.contains("gravity = 9.8") && pull.contains("has a scatter"),
        "{pull}"
    );
}

#[test]
fn refuses_loads_that_load_nothing_and_combinations_without_weight() {
    for (lines, message) in [
        (
            "loads = [{ name = \"lamp\", at = \"top\" }]",
            "has no force, weight or moment",
        ),
        (
            "loads = [{ name = \"lamp\", at = \"top\", height = 9, force = 1 }]",
            "is not on links[2]",
        ),
        ("[combination.a]\nweight = 0", "leaves no weight"),
        ("[combination.a]\nwind = 11", "must be 0 to 10"),
    ] {
        let text = said(lines);
        assert!(text.contains(message), "{lines}: {text}");
    }
}

#[test]
fn refuses_a_bed_that_crushes_and_a_strength_without_a_bed() {
    let crushed = with("").replace(
        "{ stiffness = 2200 }",
        "{ stiffness = 2200, strength = \"0.1 MPa\" }",
    );
    let said = parse_project(&crushed, "pole.toml").unwrap_err().to_string();
    assert!(said.contains("the bed crushes under the weight alone"), "{said}");
    let bare = crushed.replace(", bed_width = 0.65", "");
    let said = parse_project(&bare, "pole.toml").unwrap_err().to_string();
    assert!(said.contains("the width of its bed is not"), "{said}");
}

const WALL: &str = r#"schema = 1
kind = "stack"
name = "wall"
units = { force = "kN" }
density = 2600
wall = { length = 1.2, thickness = 0.4, courses = 3, course_height = 0.3, stone_length = 0.6 }
"#;

#[test]
fn exact_loads_on_stones_are_read_in_si_and_act_on_the_stack() {
    let text = format!(
        "{WALL}loads = [{{ name = \"rope\", at = \"course 3 stone 1\", force = [0, \"300 N\", -0.5] }}, {{ name = \"sign\", at = \
         \"course 2 stone 1\", position = [0.1, -0.5, 0.4], force = [0.1, 0, 0] }}, {{ name = \"low\", at = \"blocks[1]\", height = \
         0.1, force = [1, 0, 0] }}]\nwind = {{ speed = 25, means = \"gust\", force_coefficient = 1.3, areas = [{{ part = \"course 3 \
         stone 1\", area = 0.4, height = 0.9 }}] }}\n[combination.storm]\nwind = 1.5\nloads = 1\n"
    );
    let project = parse_project(&text, "wall.toml").unwrap();
    let Structure::Stack(part) = &project.structure else {
        panic!("no stack");
    };
    let stack = part.build(&mut Quantity::nominal).unwrap();
    let loads = stack.static_loads();
    assert_eq!(stack.blocks()[loads[0].block].name, "course 3 stone 1");
    assert_eq!(loads[0].force_n, [0.0, 300.0, -500.0]);
    // without a place: the middle of the stone in plan, at its top
    let centroid = stack.blocks()[loads[0].block].solid.centroid_m();
    assert_eq!(loads[0].position_m[..2], centroid[..2]);
    assert!((loads[0].position_m[2] - 0.9).abs() < 1e-12);
    assert_eq!(loads[1].position_m, [0.1, -0.5, 0.4]);
    assert!((loads[2].position_m[2] - 0.1).abs() < 1e-15 && loads[2].block == 0);
    assert_eq!(project.loads.combinations[0].wind, 1.5);
    // every component is listed once among the inputs
    let paths: Vec<&str> = project.inputs().iter().map(|input| input.path.as_str()).collect();
    for path in [
        "loads[1].force[2]",
        "loads[2].position[3]",
        "loads[3].height",
        "wind.areas[1].area",
    ] {
        assert_eq!(
            paths.iter().filter(|own| **own == path).count(),
            1,
            "{path}: {paths:?}"
        );
    }
}

#[test]
fn refuses_loads_on_stones_that_are_written_as_those_on_links_and_the_other_way() {
    let on_wall = |load: &str| {
        let text = format!("{WALL}loads = [{{ name = \"a\", at = \"course 3 stone 1\", {load} }}]\n");
        parse_project(&text, "wall.toml").unwrap_err().to_string()
    };
    for (load, message, help) in [
        ("force = 1", "is one number", "force = [x, y, z]"),
        ("force = [1, 0]", "has 2 numbers", "must be 3"),
        ("height = 0.8", "has no force", "[0, 0, -2] presses down"),
        (
            "force = [1, 0, 0], weight = 2",
            "weight is not read here",
            "a block of its own",
        ),
        (
            "force = [1, 0, 0], moment = 2",
            "moment is not read here",
            "end of a bracket",
        ),
        (
            "force = [1, 0, 0], height = 0.8, position = [0, 0, 0.8]",
            "position is not read here",
            "keep position or height",
        ),
        (
            "force = [1, 0, 0], height = 0.5",
            "is not on blocks[",
            "must be 0.6 m to",
        ),
        (
            "force = [1, 0, 0], position = [0, 0, 80]",
            "a static load",
            "is it in mm",
        ),
    ] {
        let said = on_wall(load);
        assert!(said.contains(message), "{load}: {said}");
        assert!(said.contains(help), "{load}: {said}");
    }
    let other = format!("{WALL}loads = [{{ name = \"a\", at = \"course 4 stone 1\", force = [1, 0, 0] }}]\n");
    let text = parse_project(&other, "wall.toml").unwrap_err().to_string();
    assert!(text.contains("there is no part \"course 4 stone 1\""), "{text}");
    for (load, message) in [
        ("force = [1, 0, 0]", "pushed along one direction"),
        ("force = 1, position = [0, 0, 5]", "position is not read here"),
    ] {
        let text = said(&format!("loads = [{{ name = \"a\", at = \"top\", {load} }}]"));
        assert!(text.contains(message), "{load}: {text}");
    }
}

const TOWER: &str = r#"schema = 1
kind = "building"
name = "tower"
units = { mass = "t", stiffness = "kN/mm" }
floors = [{ mass = 300, sides = [20, 12], height = 4.0, stiffness = { x = 120, y = 90, rotation = "9000 MN*m/rad", centre = [0, 0] } }]
"#;
const KDS: &str =
    r#"speed = 30, means = "10 min", code = "KDS 41 12 00", terrain = "B", force_coefficient = 1.3"#;

#[test]
fn refuses_wind_factors_and_limits_more_generous_than_any_code() {
    for (more, message, help) in [
        (
            "topography = 0.8",
            "wind.topography = 0.8 is outside its range",
            "must be 1 to 3",
        ),
        (
            "importance_factor = 0.6",
            "is none of KDS 41 12 00",
            "the code has 0.9",
        ),
        (
            "acceleration_limit = \"25 m/s2\"",
            "wind.acceleration_limit = 25 m/s2 is no limit of comfort",
            "0.05 to 0.3 m/s2",
        ),
        (
            "drift_limit = 0.1",
            "wind.drift_limit is 0.1 of the height",
            "did you mean per cent?",
        ),
        (
            "drift_limit = \"3 %\"",
            "more than codes allow in an earthquake",
            "1/200 to 1/500",
        ),
    ] {
        let text = format!("{TOWER}wind = {{ {KDS}, {more} }}\n");
        let said = parse_project(&text, "tower.toml").unwrap_err().to_string();
        assert!(said.contains(message) && said.contains(help), "{more}: {said}");
    }
    // who means it says so
    let text = format!("allow = [\"wind.drift_limit\"]\n{TOWER}wind = {{ {KDS}, drift_limit = \"3 %\" }}\n");
    assert!(parse_project(&text, "tower.toml").is_ok());
}

#[test]
fn exact_drift_in_the_wind_is_read_as_a_ratio_per_cent_or_fraction() {
    for given in ["0.0025", "\"0.25 %\"", "\"1/400\""] {
        let text = format!("{TOWER}wind = {{ {KDS}, drift_limit = {given} }}\n");
        let project = parse_project(&text, "tower.toml").unwrap();
        let WindPart::Given(wind) = &project.loads.wind else {
            panic!("no wind");
        };
        let drift = wind.in_time.drift_limit.unwrap();
        assert!((drift - 0.0025).abs() < 1e-15, "{given}: {drift}");
    }
}
