//! The command carries the examples: it is built anew when one of them changes.

fn main() {
    println!("cargo:rerun-if-changed=../../examples");
}
