//! Wind and static loads of frames in the project file, and storeys on columns alone: their values, and every error with its remedy.

use dolmen_project::{Quantity, Structure, WindPart, parse_project};

/// A frame of two storeys and two directions.
const GATE: &str = r#"schema = 1
kind = "frame"
name = "Gate"
units = { mass = "t", force = "kN", stiffness = "kN/mm" }
storeys = [
  { name = "hall", mass = 60, height = 5 },
  { mass = 40, height = 4, columns = { count = 4, diameter = 0.5, bed_stiffness = "0.4 GPa/m" } },
]
direction.strong = { stiffness = [8, 5], along = "x" }
direction.weak = { stiffness = [6, 4], along = "y" }
"#;

fn said(text: &str) -> String {
    match parse_project(text, "gate.toml") {
        Ok(_) => panic!("accepted: {text}"),
        Err(why) => why.to_string(),
    }
}

#[test]
fn exact_loads_of_a_frame_are_read_in_si_and_carried() {
    let text = format!(
        "{GATE}loads = [{{ name = \"snow\", at = \"storeys[2]\", weight = 40 }}, {{ name = \"cable\", at = \"hall\", height = 4.0, force = [2, \"300 N\"] }}]\n\
         wind = {{ speed = 30, means = \"gust\", force_coefficient = 1.3, areas = [{{ part = \"hall\", area = 20, direction = \"strong\" }}, \
         {{ part = \"hall\", area = 12, direction = \"weak\" }}, {{ part = \"storeys[2]\", area = 0 }}, {{ part = \"storeys[2]\", area = 30, height = 10.5 }}] }}\n"
    );
    let project = parse_project(&text, "gate.toml").unwrap();
    let Structure::Frame(part) = &project.structure else {
        panic!("no frame");
    };
    let plain = parse_project(GATE, "gate.toml").unwrap();
    let Structure::Frame(without) = &plain.structure else {
        panic!("no frame");
    };
    let [with, without] = [part, without].map(|part| part.build(&mut Quantity::nominal).unwrap());
    for (own, other) in with.storeys().iter().zip(without.storeys()) {
        assert!((own.axial_n - other.axial_n - 40e3).abs() < 1e-6);
    }
    let mass = |frame: &dolmen::structure::Frame, i: usize| frame.storeys()[i].mass_kg;
    assert_eq!(mass(&with, 0), mass(&without, 0));
    assert!((mass(&with, 1) - mass(&without, 1) - 40e3 / 9.80665).abs() < 1e-9);
    let heavy = part.build_weighing([0.9, 1.5], &mut Quantity::nominal).unwrap();
    let wanted = 0.9 * without.storeys()[0].axial_n + 1.5 * 40e3;
    assert!((heavy.storeys()[0].axial_n / wanted - 1.0).abs() < 1e-12);
    let cable = &project.loads.loads[1];
    let forces: Vec<f64> = part
        .directions
        .iter()
        .map(|own| part.force_of(cable, own).unwrap().value)
        .collect();
    assert_eq!(forces, [2e3, 300.0]);
    let WindPart::Given(wind) = &project.loads.wind else {
        panic!("no wind");
    };
    let met = |direction: usize| {
        let all = wind.areas.iter().filter(|area| area.is_met(direction));
        all.map(|area| area.area.value).sum::<f64>()
    };
    assert_eq!([met(0), met(1)], [50.0, 42.0]);
}

#[test]
fn refuses_loads_that_a_frame_does_not_bear_and_says_what_to_do() {
    for (load, message, help) in [
        (
            "force = 2",
            "is one number, but the frame has several directions",
            "force = [x, y]",
        ),
        (
            "force = [1, 2, 3]",
            "wrong number of components",
            "force = [x, y]",
        ),
        (
            "moment = 2",
            "loads[1].moment is not read here",
            "which a moment does not push",
        ),
        (
            "position = [0, 0, 1], weight = 1",
            "loads[1].position is not read here",
            "give height",
        ),
        ("weight = 1, height = 6", "is not on storeys[1]", "from the feet"),
        ("", "has no force, weight or moment", "or weight"),
    ] {
        let text = said(&format!(
            "{GATE}loads = [{{ name = \"a\", at = \"hall\", {load} }}]\n"
        ));
        assert!(text.contains(message) && text.contains(help), "{load}: {text}");
    }
    let unnamed = GATE.replace(", along = \"y\"", "");
    let text = said(&format!(
        "{unnamed}loads = [{{ name = \"a\", at = \"hall\", force = [0, 2] }}]\n"
    ));
    assert!(text.contains("no direction of the frame lies along y"), "{text}");
    let one = GATE.replace("direction.weak = { stiffness = [6, 4], along = \"y\" }\n", "");
    let text = said(&format!(
        "{one}loads = [{{ name = \"a\", at = \"hall\", force = [0, 2] }}]\n"
    ));
    assert!(text.contains("the frame has one direction"), "{text}");
}

#[test]
fn refuses_wind_on_storeys_whose_area_nobody_gave() {
    let wind = |areas: &str| {
        format!(
            "{GATE}wind = {{ speed = 30, means = \"gust\", force_coefficient = 1.3, areas = [{areas}] }}\n"
        )
    };
    for (areas, message) in [
        (
            "",
            "the area of storeys[1], storeys[2] that the wind meets is not known",
        ),
        (
            "{ part = \"hall\", area = 2, direction = \"weak\" }, { part = \"storeys[2]\", area = 2 }",
            "the area of storeys[1] that",
        ),
        (
            "{ part = \"hall\", area = 2, direction = \"north\" }, { part = \"storeys[2]\", area = 2 }",
            "the frame has no direction \"north\"",
        ),
        (
            "{ part = \"hall\", area = 2 }, { part = \"storeys[2]\", area = 2 }, { part = \"storeys[2]\", area = 2, height = 20 }",
            "is not on storeys[2]",
        ),
    ] {
        let text = said(&wind(areas));
        assert!(text.contains(message), "{areas}: {text}");
    }
    let pole = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\" }\nlinks = [{ name = \"top\", weight = 10, length = 4, centroid = 2, bed_width = 0.4 }]\njoints = \"unknown\"\n\
                wind = { speed = 30, means = \"gust\", force_coefficient = 2, areas = [{ part = \"top\", area = 1, direction = \"x\" }] }\n";
    assert!(
        said(pole).contains("has no meaning without kind = \"frame\""),
        "{}",
        said(pole)
    );
}

#[test]
fn refuses_a_storey_of_nothing_but_columns_where_it_says_nothing() {
    let with = |stiffness: &str| GATE.replace("stiffness = [6, 4]", stiffness);
    assert!(parse_project(&with("stiffness = [6, 0]"), "gate.toml").is_ok());
    // no columns there
    assert!(said(&with("stiffness = [0, 4]")).contains("must be above 0"));
    let rigid = with("stiffness = [6, 0]").replace(", bed_stiffness = \"0.4 GPa/m\"", "");
    let text = said(&rigid);
    assert!(
        text.contains("no stiffness at small drift") && text.contains("storeys[2].columns.bed_stiffness"),
        "{text}"
    );
    let grounded = format!("convention = \"grounded\"\n{}", with("stiffness = [6, 0]"));
    assert!(
        said(&grounded).contains("convention = \"drift\""),
        "{}",
        said(&grounded)
    );
    let rubs = with("stiffness = [6, 0], friction = { coefficient = 0.1 }");
    assert!(said(&rubs).contains("no joint with friction"), "{}", said(&rubs));
}

#[test]
fn exact_columns_alone_give_a_storey_the_stiffness_of_their_beds() {
    let text = GATE.replace("stiffness = [6, 4]", "stiffness = [6, 0]");
    let project = parse_project(&text, "gate.toml").unwrap();
    let Structure::Frame(part) = &project.structure else {
        panic!("no frame");
    };
    let found = part.stiffness_n_m("weak", &mut Quantity::nominal).unwrap();
    let beds = 2.0 * 4.0 * 4e8 * std::f64::consts::PI * 0.0625 / 64.0 / 16.0;
    assert_eq!(found[0], 6e6);
    assert!((found[1] / beds - 1.0).abs() < 1e-12);
    assert!(part.is_on_columns_alone("weak") && !part.is_on_columns_alone("strong"));
}
