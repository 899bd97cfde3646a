//! Openings, friction and damping of chains in the project file: their values, and every error.

use super::project::refused;
use dolmen::dynamics::{ChainModel, ChainRotations, JointFriction, JointOpening};
use dolmen_project::{Quantity, Structure, parse_project};

const CHAIN: &str = r#"schema = 1
kind = "chain"
name = "pole"
units = { force = "kN", stiffness = "kN*m/rad", moment = "kN*m" }
KEYS
links = [
  { weight = 20, length = 2.0, centroid = 0.9, bed_width = 0.5 },
  { weight = 10, length = 1.5, centroid = 0.7 },
]
joints = [
  { stiffness = 400, FIRST },
  { stiffness = 60, SECOND },
]
"#;

fn text(keys: &str, first: &str, second: &str) -> String {
    let of = |keys: &str| {
        if keys.is_empty() {
            String::new()
        } else {
            format!(", {keys}")
        }
    };
    CHAIN
        .replace("KEYS", keys)
        .replace(", FIRST", &of(first))
        .replace(", SECOND", &of(second))
}

fn moving(keys: &str, first: &str, second: &str) -> ChainModel {
    let text = text(keys, first, second);
    let project = parse_project(&text, "project.toml").unwrap_or_else(|why| panic!("{why}"));
    let Structure::Chain(part) = &project.structure else {
        panic!("no chain");
    };
    part.moving(&project.loads, ChainRotations::Large, &mut Quantity::nominal)
        .unwrap()
        .unwrap()
}

#[test]
fn exact_a_joint_opens_where_its_bed_is_known_unless_it_is_held() {
    let plain = moving("", "", "");
    assert_eq!(plain.joints()[0].opening, JointOpening::AtBedEdge);
    assert!((plain.moment_most_n_m()[0] - 30e3 * 0.25).abs() < 1e-9);
    assert_eq!(plain.joints()[1].opening, JointOpening::Held);
    assert_eq!(plain.joints()[1].friction, JointFriction::None);
    let held = moving("", "opening = \"held\"", "bed_width = 0.4");
    assert_eq!(held.joints()[0].opening, JointOpening::Held);
    assert_eq!(held.joints()[1].opening, JointOpening::AtBedEdge);
}

#[test]
fn exact_friction_and_damping_in_their_units() {
    let model = moving(
        "",
        "friction_moment = 3, static_friction_moment = \"4000 N*m\"",
        "friction_moment = { value = 0.5, source = \"assumed\" }, damping = 200",
    );
    let moments = |static_moment_n_m, kinetic_moment_n_m| JointFriction::Coulomb {
        static_moment_n_m,
        kinetic_moment_n_m,
    };
    assert_eq!(model.joints()[0].friction, moments(4000.0, 3000.0));
    assert_eq!(model.joints()[1].friction, moments(500.0, 500.0));
    assert_eq!(model.joints()[1].damping_n_m_s_rad, 200.0);
    let damped = moving("damping_ratio = \"2 %\"", "", "");
    let own = |i: usize| damped.joints()[i].damping_n_m_s_rad / damped.joints()[i].stiffness_n_m_rad;
    assert!(own(0) > 0.0 && (own(0) / own(1) - 1.0).abs() < 1e-14);
}

#[test]
fn refuses_what_cannot_move() {
    for (keys, first, second, said) in [
        (
            "",
            "",
            "opening = \"edge\"",
            "joints[2].opening = \"edge\", but the width of its bed is not given",
        ),
        ("", "opening = \"open\"", "", "joints[1].opening"),
        ("", "friction_moment = -1", "", "joints[1].friction_moment = -1"),
        (
            "",
            "friction_moment = 3, static_friction_moment = 2",
            "",
            "joints[1].static_friction_moment = 2 kN*m is below joints[1].friction_moment = 3 kN*m",
        ),
        (
            "",
            "static_friction_moment = 2",
            "",
            "joints[1].static_friction_moment stands without friction_moment",
        ),
        (
            "damping_ratio = 0.02",
            "damping = 5",
            "",
            "damping_ratio and joints[1].damping both damp the joints",
        ),
        ("damping_ratio = 2", "", "", "damping_ratio = 2"),
        (
            "",
            "friction_moment = 3000",
            "",
            "× the weight times height above the joint",
        ),
        (
            "",
            "friction_moment = \"0.3 N*m\"",
            "",
            "× the weight times height above the joint",
        ),
        ("", "friction_moment = \"3 kN\"", "", "joints[1].friction_moment"),
    ] {
        let answer = refused(&text(keys, first, second));
        assert!(answer.contains(said), "{said}: {answer}");
        assert_eq!(answer.matches("error:").count(), 1, "{answer}");
    }
}
