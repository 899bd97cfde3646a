//! Rebuilds the command when a built-in example changes.

fn main() {
    println!("cargo:rerun-if-changed=../../examples");
}
