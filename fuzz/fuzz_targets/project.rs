//! What is done with each input stands in bodies/project.rs: the tests of dolmen-cli run it too.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../bodies/project.rs"]
mod body;

fuzz_target!(|text: &str| body::run(text));
