//! Free-standing columns in the project file: their values, and the full text of every error.

use super::project::{example, read, refused, with};
use dolmen::stability::{FootSection, FreeColumns};
use dolmen_project::{Quantity, Structure, WarningKind};

const FRAME: &str = r#"schema = 1
kind = "frame"
name = "gate"
evidence = "assumed"
units = { length = "m", mass = "t", force = "kN", stiffness = "kN/mm" }
axial = "storey"
storeys = [{ mass = 32, height = 4, axial_force = 320, columns = { COLUMNS } }]
[direction.x]
stiffness = "unknown"
"#;

fn frame(columns: &str) -> String {
    FRAME.replace("COLUMNS", columns)
}

fn built(columns: &str) -> FreeColumns {
    let project = read(&frame(columns));
    let Structure::Frame(part) = &project.structure else {
        panic!("no frame");
    };
    let kinds: Vec<WarningKind> = project.warnings.iter().map(|warning| warning.kind).collect();
    assert!(kinds.contains(&WarningKind::ColumnsNotInMotion), "{kinds:?}");
    let built = part.build(&mut Quantity::nominal).unwrap();
    let given = part.storeys[0].columns.as_ref().unwrap();
    given.build(&built.storeys()[0], &mut Quantity::nominal).unwrap()
}

#[test]
fn exact_columns_carry_the_storey_and_are_as_high() {
    let rectangle = |width_m, breadth_m| FootSection::Rectangle { width_m, breadth_m };
    let of = |section, bed| FreeColumns::new(4, section, 4.0, 320e3, bed).unwrap();
    assert_eq!(built("count = 4, width = 0.5"), of(rectangle(0.5, 0.5), None));
    assert_eq!(
        built(r#"count = 4, width = "500 mm", breadth = 0.4, bed_stiffness = "0.4 GPa/m""#),
        of(rectangle(0.5, 0.4), Some(4e8))
    );
    assert_eq!(
        built("count = 4, diameter = 0.5, bed_stiffness = 4e8"),
        of(FootSection::Circle { diameter_m: 0.5 }, Some(4e8))
    );
    // every number is an input
    let project = read(&frame(
        "count = 4, width = 0.5, breadth = 0.4, bed_stiffness = 4e8",
    ));
    let paths: Vec<&str> = project.inputs().iter().map(|input| input.path.as_str()).collect();
    for key in ["width", "breadth", "bed_stiffness"] {
        let path = format!("storeys[1].columns.{key}");
        assert!(paths.contains(&path.as_str()), "{path}: {paths:?}");
    }
    read(&example("free_columns"));
}

#[test]
fn refuses_columns_that_cannot_be() {
    let says = |columns: &str, words: &[&str]| {
        let message = refused(&frame(columns));
        for word in words {
            assert!(message.contains(word), "{columns}: {message}");
        }
    };
    says("width = 0.5", &["storeys[1].columns", "count"]);
    says(
        "count = 0, width = 0.5",
        &["storeys[1].columns.count = 0", "must be 1 to 10000"],
    );
    says(
        "count = 4",
        &["storeys[1].columns has neither width nor diameter"],
    );
    says(
        "count = 4, width = 0.5, diameter = 0.5",
        &["has both width and diameter"],
    );
    says(
        "count = 4, diameter = 0.5, breadth = 0.5",
        &["has both diameter and breadth"],
    );
    says("count = 4, width = -1", &["storeys[1].columns.width = -1"]);
    says("count = 4, width = 0.5, height = 4", &["no key \"height\""]);
    says(
        "count = 4, width = 4",
        &["storeys[1].columns.width = 4 m is not below storeys[1].height = 4 m"],
    );
    let two = frame("count = 4, width = 0.5, breadth = 0.4") + "[direction.y]\nstiffness = \"unknown\"\n";
    let message = refused(&two);
    assert!(
        message.contains("breadth is given, but the frame has 2 directions"),
        "{message}"
    );
    let weightless = with(
        &frame("count = 4, width = 0.5"),
        &[("axial_force = 320", "axial_force = 0")],
    );
    let message = refused(&weightless);
    assert!(
        message.contains("the axial force of the storey is 0"),
        "{message}"
    );
}

#[test]
fn refuses_slips_of_unit() {
    let says = |columns: &str, words: &[&str]| {
        let message = refused(&frame(columns));
        for word in words {
            assert!(message.contains(word), "{columns}: {message}");
        }
    };
    says(
        r#"count = 4, width = "0.5 mm""#,
        &[
            "width = 0.5 mm, but columns are 0.05 to 2 m wide",
            "did you mean m?",
        ],
    );
    says(
        "count = 4, width = 0.5, bed_stiffness = 0.4",
        &["bed_stiffness = 0.4 Pa/m, but beds of feet have 0.001 to 10 000 GPa/m"],
    );
    // the stiffness of a storey is not that of a bed
    says(
        r#"count = 4, width = 0.5, bed_stiffness = "30 kN/mm""#,
        &["bed_stiffness"],
    );
    says(
        "count = 1, width = 0.06",
        &["each of 1 columns would press its stone with 88.9 MPa"],
    );
}
