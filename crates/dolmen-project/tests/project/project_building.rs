//! Buildings in the project file: their values, and every error at its line.

use super::project::{example, read, refused};
use dolmen::damper::{DamperKind, TuningRule, rule_tuning};
use dolmen::structure::building::PlanDirection;
use dolmen_project::{Project, Quantity, Structure};

const BUILDING: &str = r#"schema = 1
kind = "building"
name = "hall"
units = { mass = "t", stiffness = "kN/mm" }
floors = [
  { mass = 100, sides = [10, 8], height = 4, walls = [
    { x = 0, y = -4, stiffness_x = 20 },
    { x = 0, y = 4, stiffness_x = 20 },
    { x = -5, y = 0, stiffness_y = 24 },
    { x = 5, y = 0, stiffness_y = 12 },
  ] },
  { mass = 80, outline = [[-5, -4], [5, -4], [5, 4], [-5, 4]], height = 3.5, count = 2, stiffness = { x = 30, y = 20, rotation = "500 MN*m/rad", centre = [-1, 0] } },
]
damping.ratio = "2 %"
points = [{ name = "corner", floor = 3, place = [5, 4] }]
[damper.top]
kind = "tmd"
floor = 3
place = [4, 0]
direction = "y"
mass_ratio = 0.05
tuning = "den_hartog"
"#;

fn with(from: &str, to: &str) -> String {
    assert!(BUILDING.contains(from), "{from}");
    BUILDING.replacen(from, to, 1)
}

fn part(project: &Project) -> &dolmen_project::BuildingPart {
    let Structure::Building(part) = &project.structure else {
        panic!("no building");
    };
    part
}

#[test]
fn exact_floors_storeys_and_a_damper_in_si() {
    let project = read(BUILDING);
    let part = part(&project);
    assert_eq!(project.kind(), "building");
    let pick = &mut Quantity::nominal;
    let vibrating = part.as_written().unwrap();
    let (building, modes) = (vibrating.building(), vibrating.modes());
    assert_eq!(building.floors().len(), 3);
    assert_eq!(
        (building.mass_kg(), building.floor_heights_m()),
        (260e3, vec![4.0, 7.5, 11.0])
    );
    assert!((building.floors()[1].gyration_m.powi(2) - 164.0 / 12.0).abs() < 1e-12);
    let lowest = building.storeys()[0].stiffness.matrix_about([0.0, 0.0]);
    // rows by hand: 40 along x, 36 along y, coupling (−5·24 + 5·12), rotation 40·16 + 36·25, in kN/mm
    let by_hand = [[40.0, 0.0, 0.0], [0.0, 36.0, -60.0], [0.0, -60.0, 1540.0]];
    for i in 0..3 {
        for j in 0..3 {
            assert!((lowest[i][j] - 1e6 * by_hand[i][j]).abs() < 1e-6, "{lowest:?}");
        }
    }
    assert_eq!(
        building.storeys()[2].stiffness.centre_of_rigidity_m(),
        Some([-1.0, 0.0])
    );
    let damper = &part.dampers(vibrating, pick).unwrap()[0];
    let row = building.point_row(3, 4.0, 0.0, PlanDirection::Y).unwrap();
    let along: f64 = row
        .iter()
        .zip(&modes.modes[0].shape)
        .map(|(r, phi)| r * phi)
        .sum();
    assert!((damper.kind.mass_kg() * along * along - 0.05).abs() < 1e-14);
    assert!((damper.own().unwrap()[0] * 1.05 / modes.modes[0].frequency_hz - 1.0).abs() < 1e-14);
    assert!((damper.own().unwrap()[1] - 0.1336306).abs() < 0.5e-7);
    assert_eq!(part.floor_names(), ["1", "2", "3"]);
    assert!(
        project
            .input("floors[1].walls[3].stiffness_y")
            .is_some_and(|q| q.value == 24e6)
    );
}

#[test]
fn published_tunings_of_a_mass_ratio_of_5_percent() {
    for (tuning, f, zeta) in [
        ("den_hartog", 0.952_381_0, 0.133_630_6),
        ("warburton_force", 0.964_212_2, 0.109_772_2),
        ("warburton_base", 0.940_400_8, 0.109_806_1),
    ] {
        let project = read(&with("den_hartog", tuning));
        let part = part(&project);
        let pick = &mut Quantity::nominal;
        let vibrating = part.as_written().unwrap();
        let (modes, damper) = (vibrating.modes(), &part.dampers(vibrating, pick).unwrap()[0]);
        let ratio = damper.own().unwrap()[0] / modes.modes[0].frequency_hz;
        let damping = damper.own().unwrap()[1];
        assert!(
            (ratio - f).abs() < 0.5e-7 && (damping - zeta).abs() < 0.5e-7,
            "{tuning}: {ratio} {damping}"
        );
        assert_eq!(damper.tuning.unwrap().name(), tuning);
    }
}

#[test]
fn exact_a_matrix_is_the_storey_that_it_is_of() {
    let whole = r#"stiffness = { x = 30, y = 20, rotation = "500 MN*m/rad", centre = [-1, 0] }"#;
    // about the origin: k_yθ = 20e6 (−1), k_θ = 5e8 + 20e6
    let matrix = "stiffness = { matrix = [[30e6, 0.0, 0.0], [0.0, 20e6, -20e6], [0.0, -20e6, 520e6]], centre = [0, 0] }";
    let (one, other) = (read(BUILDING), read(&with(whole, matrix)));
    let build = |project: &Project| {
        part(project)
            .build(&mut Quantity::nominal)
            .unwrap()
            .stiffness_matrix()
    };
    let (a, b) = (build(&one), build(&other));
    for (a, b) in a.as_slice().iter().zip(b.as_slice()) {
        assert!((a - b).abs() < 1e-6, "{a} {b}");
    }
}

#[test]
fn holds_the_examples_are_read_and_the_floor_has_the_modes_of_its_source() {
    let project = read(&example("twisting_floor"));
    let modes = part(&project)
        .build(&mut Quantity::nominal)
        .unwrap()
        .modes()
        .unwrap();
    for (mode, known) in modes.modes.iter().zip([1.84707, 2.28210, 3.60553]) {
        assert!((mode.omega_rad_s - known).abs() < 0.5e-5);
    }
    let tall = read(&example("twenty_storeys"));
    let building = part(&tall).build(&mut Quantity::nominal).unwrap();
    let known = dolmen::comparisons::twenty_storeys().unwrap();
    let largest = known
        .stiffness_matrix()
        .as_slice()
        .iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in building
        .stiffness_matrix()
        .as_slice()
        .iter()
        .zip(known.stiffness_matrix().as_slice())
    {
        assert!((a - b).abs() < 1e-9 * largest);
    }
}

#[test]
fn refuses_what_cannot_be_with_its_line_and_what_to_do() {
    for (from, to, said) in [
        (
            "stiffness_y = 24",
            "stiffness_y = -24",
            "floors[1].walls[3].stiffness_y = -24 kN/mm cannot be",
        ),
        (
            "floor = 3\nplace = [4, 0]",
            "floor = 3\nplace = [6, 0]",
            "lies 1.000 m outside the outline of floor 3",
        ),
        (
            "floor = 3\nplace = [4, 0]",
            "floor = 4\nplace = [4, 0]",
            "damper.top.floor = 4, but the building has 3 floors",
        ),
        (
            "mass_ratio = 0.05",
            "mass_ratio = 1.5",
            "a damper is lighter than what it damps",
        ),
        (
            "mass_ratio = 0.05",
            "mass_ratio = 1.5",
            "mass_ratio = 1.5\n    |              ^^^ must be above 0, at most 1",
        ),
        (
            "direction = \"y\"",
            "direction = \"y\"\nstroke = 600",
            "dampers have 2 mm to 5 m of room each way here",
        ),
        (
            "kind = \"tmd\"\nfloor = 3\nplace = [4, 0]\ndirection = \"y\"\nmass_ratio = 0.05\ntuning = \"den_hartog\"",
            "kind = \"link\"\nfloor = 3\nplace = [4, 0]\ndirection = \"y\"\ncoefficient = \"5e6 kN*s/m\"",
            "is it in N*s/m, kN*s/m or MN*s/m?",
        ),
        (
            "kind = \"tmd\"",
            "kind = \"tlcmd\"\nlength_ratio = 0.6\nliquid_frequency = 60\nliquid_share = 0.5\nliquid_damping_ratio = 0.1",
            "damper.top: its liquid swings at 60.0000 Hz",
        ),
        (
            "damping.ratio",
            "storeys = 4\ndamping.ratio",
            "\"storeys\" belongs to kind = \"frame\"",
        ),
        (
            "{ x = 0, y = -4, stiffness_x = 20 },\n    { x = 0, y = 4, stiffness_x = 20 }",
            "{ name = \"a\", x = 0, y = -4, stiffness_x = 20 },\n    { name = \"a\", x = 0, y = 4, stiffness_x = 20 }",
            "two walls of one storey are named \"a\"",
        ),
        (
            "place = [5, 4] }]",
            "place = [5, 4] }, { name = \"other\", floor = 3, place = [5, 4] }]",
            "point \"other\" is where \"corner\" is",
        ),
        ("mass_ratio = 0.05", "mass = 5000", "more than 1"),
        (
            "mass_ratio = 0.05",
            "",
            "damper.top has neither mass nor mass_ratio",
        ),
        ("tuning = \"den_hartog\"", "", "damper.top has no frequency"),
        (
            "tuning = \"den_hartog\"",
            "frequency = 0.6\ndamping_ratio = 12",
            "damper.top.damping_ratio = 12, but above 1 nothing swings",
        ),
        (
            "tuning = \"den_hartog\"",
            "frequency = 20\ndamping_ratio = 0.1",
            "in Hz, not rad/s",
        ),
        (
            "{ x = 5, y = 0, stiffness_y = 12 }",
            "{ x = 5000, y = 0, stiffness_y = 12 }",
            "lies 5000 m off its floor",
        ),
        ("sides = [10, 8]", "sides = [10000, 8000]", "are its sides in mm?"),
        (
            "kind = \"tmd\"",
            "kind = \"tlcd\"",
            "damper.top has no length_ratio",
        ),
        (
            "kind = \"tmd\"",
            "kind = \"tlcd\"\nlength_ratio = 1.2",
            "damper.top.length_ratio = 1.2 is not below 1",
        ),
        (
            "kind = \"tmd\"",
            "kind = \"tlcmd\"\nlength_ratio = 0.6",
            "damper.top needs one of liquid_frequency and length",
        ),
        (
            "kind = \"tmd\"",
            "kind = \"tlcmd\"\nlength_ratio = 0.6\nlength = 3",
            "damper.top needs liquid_share and liquid_damping_ratio",
        ),
        (
            "kind = \"tmd\"",
            "kind = \"link\"",
            "damper.top.mass_ratio belongs to kind = \"tmd\" or \"tlcd\" or \"tlcmd\", but this is a \"link\"",
        ),
        (
            "tuning = \"den_hartog\"",
            "tuning = \"den_hartog\"\ncoefficient = 5",
            "damper.top.coefficient belongs to kind = \"link\"",
        ),
        (
            "mass_ratio = 0.05\ntuning = \"den_hartog\"",
            "masses = [{ share = 0.5 }, { share = 0.4 }]\nmass_ratio = 0.05\ntuning = \"den_hartog\"",
            "the shares of damper.top.masses add up to 0.9",
        ),
        (
            "kind = \"tmd\"\nfloor = 3\nplace = [4, 0]\ndirection = \"y\"\nmass_ratio = 0.05\ntuning = \"den_hartog\"",
            "kind = \"link\"\nfloor = 3\nto_floor = 3\nplace = [4, 0]\ndirection = \"y\"\ncoefficient = 5",
            "damper.top ties floor 3 to itself",
        ),
        (
            "kind = \"tmd\"\nfloor = 3\nplace = [4, 0]\ndirection = \"y\"\nmass_ratio = 0.05\ntuning = \"den_hartog\"",
            "kind = \"link\"\nfloor = 3\nplace = [4, 0]\ndirection = \"y\"",
            "damper.top has no coefficient",
        ),
        (
            "direction = \"y\"",
            "direction = \"up\"",
            "must be \"x\", \"y\", or an angle from x",
        ),
        (
            "place = [5, 4] }",
            "place = [5, 5] }",
            "points[1]: the point (5, 5) m lies 1.000 m outside the outline of floor 3",
        ),
        (
            "sides = [10, 8], ",
            "",
            "has neither sides nor outline, so that its centre of mass is not known",
        ),
        (
            "[[-5, -4], [5, -4], [5, 4], [-5, 4]]",
            "[[-5, -4], [5, 4], [5, -4], [-5, 4]]",
            "crosses itself",
        ),
        (
            "rotation = \"500 MN*m/rad\", ",
            "",
            "floors[2].stiffness.rotation is missing",
        ),
        (
            "damping.ratio = \"2 %\"",
            "damping = { ratio = 0.02, ratios = [0.02] }",
            "damping needs one of",
        ),
        (
            "damping.ratio = \"2 %\"",
            "damping.caughey = [0.05, 0.001]",
            "damping: mode",
        ),
        ("height = 4,", "height = 4000,", "did you mean"),
        (
            "kind = \"building\"",
            "kind = \"frame\"",
            "belongs to kind = \"building\"",
        ),
        (
            "stiffness_y = 24 },",
            "stiffness_x = 24 },",
            "storey 1 does not resist twisting",
        ),
    ] {
        let mut text = with(from, to);
        if said.contains("twisting") {
            // all walls along x except one, which runs through the origin along y
            text = text.replace(
                "{ x = 5, y = 0, stiffness_y = 12 }",
                "{ x = 0, y = 0, stiffness_y = 12 }",
            );
            text = text
                .replace("y = -4, stiffness_x", "y = 0, stiffness_x")
                .replace("y = 4, stiffness_x", "y = 0, stiffness_x");
        }
        let answer = refused(&text);
        assert!(answer.contains(said), "{said}: {answer}");
        assert!(answer.contains("project.toml:"), "{answer}");
    }
    // a mode without motion at the damper: mode 2 of the shipped floor has none along x
    let floor = example("twisting_floor").replace(
        "direction = \"y\"\nmass = 5.125",
        "direction = \"y\"\nmode = 2\nmass = 5.125",
    );
    let answer = refused(&floor);
    assert!(
        answer.contains("mode 2 does not move at its place along its direction (it moves only in x here)"),
        "{answer}"
    );
}

#[test]
fn exact_dampers_of_every_kind_in_si() {
    let dampers = r#"[damper.pair]
kind = "tmd"
floor = 3
place = [4, 0]
direction = "y"
mass_ratio = 0.04
tuning = "warburton_base"
stroke = "300 mm"
masses = [
  { share = 0.25, place = [5, 0], frequency = 0.7, damping_ratio = 0.05 },
  { share = 0.75 },
]
[damper.tube]
kind = "tlcd"
floor = 2
place = [0, 0]
direction = "y"
mass = 2
length_ratio = 0.7
length = 1.8
damping_ratio = 0.06
[damper.tank]
kind = "tlcmd"
floor = 3
place = [-4, 0]
direction = "y"
mass_ratio = 0.01
tuning = "den_hartog"
liquid_share = 0.4
length_ratio = 0.6
liquid_frequency = "0.9 Hz"
liquid_damping_ratio = "8 %"
liquid_stroke = "250 mm"
[damper.strut]
kind = "link"
floor = 2
to_place = [1, 1]
place = [2, 1]
direction = "x"
coefficient = "500 kN*s/m"
"#;
    let at = BUILDING.find("[damper.top]").unwrap();
    let project = read(&(BUILDING[..at].to_owned() + dampers));
    let part = part(&project);
    let pick = &mut Quantity::nominal;
    let vibrating = part.as_written().unwrap();
    let (building, modes) = (vibrating.building(), vibrating.modes());
    let built = part.dampers(vibrating, pick).unwrap();
    let names: Vec<&str> = built.iter().map(|damper| damper.name.as_str()).collect();
    assert_eq!(names, ["pair-1", "pair-2", "tube", "tank", "strut"]);
    let along = |floor, x, y, direction| building.point_row(floor, x, y, direction).unwrap();
    let modal_mass = |row: &[f64]| {
        let moves: f64 = row
            .iter()
            .zip(&modes.modes[0].shape)
            .map(|(r, phi)| r * phi)
            .sum();
        1.0 / (moves * moves)
    };
    let y = PlanDirection::Y;
    // the pair has 4 % of the modal mass at its own place; one mass is elsewhere
    let whole = 0.04 * modal_mass(&along(3, 4.0, 0.0, y));
    let tuned = rule_tuning(TuningRule::WarburtonBase, 0.04, 0.0).unwrap();
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    close(built[0].kind.mass_kg(), 0.25 * whole);
    close(built[1].kind.mass_kg(), 0.75 * whole);
    assert_eq!(built[0].own(), Some([0.7, 0.05]));
    close(
        built[1].own().unwrap()[0],
        tuned.frequency_ratio * modes.modes[0].frequency_hz,
    );
    close(built[1].own().unwrap()[1], tuned.damping_ratio);
    assert_eq!(built[0].row, along(3, 5.0, 0.0, y));
    assert_eq!(
        (built[0].tuning, built[1].tuning),
        (None, Some(TuningRule::WarburtonBase))
    );
    assert_eq!((built[0].room_m, built[2].room_m), (Some(0.3), None));
    assert_eq!((built[3].room_m, built[3].liquid_room_m), (None, Some(0.25)));
    let gravity = part.gravity_m_s2;
    assert_eq!(
        built[2].kind,
        DamperKind::LiquidColumn {
            liquid_mass_kg: 2e3,
            length_ratio: 0.7,
            frequency_hz: (2.0 * gravity / 1.8_f64).sqrt() / std::f64::consts::TAU,
            damping_ratio: 0.06,
        }
    );
    let DamperKind::LiquidColumnMass {
        container_mass_kg,
        liquid_mass_kg,
        length_ratio,
        liquid_frequency_hz,
        liquid_damping_ratio,
        ..
    } = built[3].kind
    else {
        panic!("{:?}", built[3].kind);
    };
    let tank = 0.01 * modal_mass(&along(3, -4.0, 0.0, y));
    close(container_mass_kg, 0.6 * tank);
    close(liquid_mass_kg, 0.4 * tank);
    assert_eq!(
        (length_ratio, liquid_frequency_hz, liquid_damping_ratio),
        (0.6, 0.9, 0.08)
    );
    // a strut between floors 2 and 1
    let (upper, lower) = (
        along(2, 2.0, 1.0, PlanDirection::X),
        along(1, 1.0, 1.0, PlanDirection::X),
    );
    for (i, a) in built[4].row.iter().enumerate() {
        assert!((a - (upper[i] - lower[i])).abs() < 1e-15);
    }
    assert_eq!(
        built[4].kind,
        DamperKind::Viscous {
            coefficient_n_s_m: 5e5
        }
    );
    assert!(project.input("damper.pair.masses[1].share").is_some());
    assert!(project.input("damper.strut.coefficient").is_some());
}

#[test]
fn exact_modes_of_one_frequency_have_one_modal_mass_any_way() {
    // equal along x and y, no eccentricity: 100 t along 45 degrees as along x
    let text = r#"schema = 1
kind = "building"
name = "equal"
p_delta = false
floors = [
  { mass = 1e5, sides = [12, 8], height = 30, stiffness = { x = 4e6, y = 4e6, rotation = 2e8, centre = [0, 0] } },
]
[damper.d]
kind = "tmd"
floor = 1
place = [0, 0]
direction = "45 deg"
mass_ratio = 0.05
tuning = "den_hartog"
"#;
    for direction in ["45 deg", "x", "y", "-20 deg"] {
        let project = read(&text.replace("45 deg", direction));
        let part = part(&project);
        let pick = &mut Quantity::nominal;
        let built = part.dampers(part.as_written().unwrap(), pick).unwrap();
        assert!(
            (built[0].kind.mass_kg() - 5e3).abs() < 1e-6,
            "{direction} {:?}",
            built[0]
        );
    }
}

#[test]
fn refuses_a_damper_heavier_than_the_building() {
    // .6 m, 15 mm from the centre of mode 3
    let floor = example("twisting_floor").replace(
        "place = [5, 0]\ndirection = \"y\"\nmass = 5.125",
        "place = [0.6, 0]\ndirection = \"y\"\nmode = 3\nmass_ratio = 0.05",
    );
    let answer = refused(&floor);
    assert!(
        answer.contains("more than the whole building's 100000 kg: mode 3 hardly moves at its"),
        "{answer}"
    );
}

#[test]
fn refuses_a_twist_without_a_sway() {
    let survey = |mode: &str| format!("{BUILDING}[[survey.s.modes.x]]\nfrequency = 2.0\n{mode}\n");
    let project = read(&survey("twist = -0.2\ntwist_sd = 0.01"));
    let twist = project.surveys[0].modes["x"][0].twist.unwrap();
    assert_eq!((twist.ratio, twist.sd), (-0.2, 0.01));
    for (mode, said) in [
        ("twist = 0.1\nkind = \"torsion\"", "is of a mode of torsion"),
        ("twist_sd = 0.1", "stands without twist"),
        ("sideways = 0.1", "stands without"),
        ("twist = 0.1\nsideways = 3", "is outside its range"),
        ("twist = 2.5", "is outside its range"),
        ("twist = 0.5\ntwist_sd = -0.1", "is outside its range"),
    ] {
        let answer = refused(&survey(mode));
        assert!(answer.contains(said), "{mode}: {answer}");
    }
}
