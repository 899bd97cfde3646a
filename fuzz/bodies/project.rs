//! Any text is read or refused as a project file, never a panic; what is read builds its structure.

use dolmen::dynamics::ChainRotations;
use dolmen_project::{Project, Quantity, Structure, parse_project};

fn build(project: &Project) {
    match &project.structure {
        Structure::Chain(chain) => {
            let built = chain.build(&mut Quantity::nominal);
            assert!(built.is_ok(), "{built:?}");
            let _ = chain.moving(&project.loads, ChainRotations::Large, &mut Quantity::nominal);
        }
        Structure::Frame(frame) => {
            let built = frame.build(&mut Quantity::nominal);
            assert!(built.is_ok(), "{built:?}");
            for direction in &frame.directions {
                let moving = frame.with_friction(&direction.name, &mut Quantity::nominal);
                assert!(moving.is_ok(), "{moving:?}");
            }
        }
        Structure::Stack(stack) => {
            let built = stack.build(&mut Quantity::nominal);
            assert!(built.is_ok(), "{built:?}");
        }
        Structure::Building(part) => {
            let _ = part.build(&mut Quantity::nominal);
        }
        Structure::Survey => {}
    }
    assert!(project.inputs().iter().all(|input| input.value.is_finite()));
}

pub(super) fn run(text: &str) {
    match parse_project(text, "fuzz") {
        Ok(project) => {
            build(&project);
            for variant in &project.variants {
                build(&variant.project);
            }
        }
        Err(error) => assert!(!error.problems.is_empty() && error.to_string().starts_with("error: ")),
    }
}
