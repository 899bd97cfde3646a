//! Friction of a frame in the project file: its values, and the full text of every error.

use super::project::refused;
use dolmen::dynamics::{FrictionActsOn, StoreyFriction};
use dolmen_project::{Quantity, Structure, parse_project};

const FRAME: &str = r#"schema = 1
kind = "frame"
name = "gate"
evidence = "assumed"
units = { force = "kN", mass = "t", stiffness = "kN/mm" }
axial = "storey"
storeys = [
  { mass = 290, height = 5.84, axial_force = 5919 },
  { mass = 314, height = 7.69, axial_force = 3077 },
]
[direction.x]
stiffness = [185, 17]
damping_ratio = "2 %"
friction = { FRICTION }
"#;

fn with(friction: &str) -> String {
    FRAME.replace("FRICTION", friction)
}

fn sliders(friction: &str) -> (Vec<f64>, Vec<StoreyFriction>, FrictionActsOn) {
    let text = with(friction);
    let project = parse_project(&text, "project.toml").unwrap();
    let Structure::Frame(part) = &project.structure else {
        panic!("no frame");
    };
    let built = part.with_friction("x", &mut Quantity::nominal).unwrap().unwrap();
    assert!(part.with_friction("y", &mut Quantity::nominal).unwrap().is_none());
    (
        built.stiffness_n_m().to_vec(),
        built.friction().to_vec(),
        built.acts_on(),
    )
}

#[test]
fn exact_forces_follow_from_coefficients_and_stiffness() {
    let (stiffness, friction, acts_on) = sliders("coefficient = 0.1, static_coefficient = 0.2");
    assert_eq!(stiffness, [185e6, 17e6]);
    assert_eq!(acts_on, FrictionActsOn::Drift);
    let StoreyFriction::Coulomb {
        static_force_n,
        kinetic_force_n,
    } = friction[1]
    else {
        panic!("{friction:?}");
    };
    assert!((kinetic_force_n - 307.7e3).abs() < 1e-6 && (static_force_n - 615.4e3).abs() < 1e-6);
    // Jenkins: the stiffness lost by slipping is in series with the slider
    let (stiffness, friction, acts_on) = sliders(
        r#"law = "jenkins", force = [500, "0.3 MN"], slipping_stiffness = [85, 0], acts_on = "displacement""#,
    );
    assert_eq!(stiffness, [85e6, 0.0]);
    assert_eq!(acts_on, FrictionActsOn::Displacement);
    assert_eq!(
        friction,
        [
            StoreyFriction::jenkins(100e6, 500e3),
            StoreyFriction::jenkins(17e6, 300e3)
        ]
    );
}

#[test]
fn refuses_friction_that_says_too_little_or_too_much() {
    let says = |friction: &str, words: &[&str]| {
        let message = refused(&with(friction));
        for word in words {
            assert!(message.contains(word), "{word}:\n{message}");
        }
    };
    says(
        r#"law = "coulomb""#,
        &[
            "direction.x.friction has neither coefficient nor force",
            "friction = { coefficient = 0.3 }",
        ],
    );
    says(
        "coefficient = 0.1, force = [1, 2]",
        &[
            "direction.x.friction has both coefficient and force",
            "keep one of them",
        ],
    );
    says(
        "coefficient = 30",
        &["direction.x.friction.coefficient = 30", "must be 0 to 2"],
    );
    says(
        "coefficient = 0.3, static_coefficient = 0.2",
        &["direction.x.friction.static_coefficient = 0.2 is below coefficient = 0.3"],
    );
    says(
        "force = [100]",
        &["direction.x.friction.force has 1 elements for 2 storeys"],
    );
    says(
        r#"law = "jenkins", coefficient = 0.1"#,
        &[r#"has law = "jenkins", but no slipping_stiffness"#],
    );
    says(
        "coefficient = 0.1, slipping_stiffness = [1, 1]",
        &[r#"slipping_stiffness is given, but the law is "coulomb""#],
    );
    says(
        r#"law = "jenkins", coefficient = 0.1, slipping_stiffness = [90, 17]"#,
        &[
            "direction.x.friction.slipping_stiffness[2] = 17",
            "is not below direction.x.stiffness[2] = 17",
        ],
    );
    says(
        "coefficient = 0.1, static_force = 3",
        &["no key \"static_force\""],
    );
}

#[test]
fn refuses_damping_in_percent() {
    let message = refused(&with("coefficient = 0.1").replace("\"2 %\"", "2"));
    assert!(
        message.contains("direction.x.damping_ratio = 2") && message.contains("must be 0 to 0.5"),
        "{message}"
    );
}
