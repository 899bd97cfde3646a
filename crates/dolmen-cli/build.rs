//! The command carries the examples: it is built anew when one of them changes.

fn main() {
    println!("cargo:rerun-if-changed=../../examples");
    // at a fixed address nothing of its tables has to be written anew at each start
    println!("cargo:rustc-link-arg-bins=-no-pie");
}
