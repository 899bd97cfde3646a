//! Any text is read or refused as a project file, never a panic; what is read builds its structure.
#![no_main]

use dolmen_formats::project::{Project, Quantity, Structure, parse_project};
use libfuzzer_sys::fuzz_target;

fn build(project: &Project) {
    match &project.structure {
        Structure::Chain(chain) => {
            let built = chain.build(&mut Quantity::nominal);
            assert!(built.is_ok(), "{built:?}");
        }
        Structure::Frame(frame) => {
            let built = frame.build(&mut Quantity::nominal);
            assert!(built.is_ok(), "{built:?}");
        }
        Structure::Stack(stack) => {
            let built = stack.build(&mut Quantity::nominal);
            assert!(built.is_ok(), "{built:?}");
        }
        Structure::Survey => {}
    }
    assert!(project.inputs().iter().all(|input| input.value.is_finite()));
}

fuzz_target!(|text: &str| {
    match parse_project(text, "fuzz") {
        Ok(project) => {
            build(&project);
            project.variants.iter().for_each(|variant| build(&variant.project));
        }
        Err(error) => assert!(!error.problems.is_empty() && error.to_string().starts_with("error: ")),
    }
});
