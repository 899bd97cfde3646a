//! What is done with each input stands in bodies/photo.rs: the tests of dolmen-cli run it too.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../bodies/photo.rs"]
mod body;

fuzz_target!(|bytes: &[u8]| body::run(bytes));
