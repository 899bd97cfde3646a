// SOURCE     docs/store.md.
// GOAL       A full or read-only disk is an error, and the store stays as it was.
// TOLERANCE  none: bytes, rows, words and exit statuses.

use super::stores::{below, content, good, project, refused};
use super::verbs::Scratch;
use std::fs;
use std::process::Command;

/// A small file system of its own; `None` if mounting is not allowed.
pub(super) struct Small<'a>(&'a Scratch);

impl<'a> Small<'a> {
    pub(super) fn of(scratch: &'a Scratch, size: &str) -> Option<Self> {
        let folder = scratch.path().join("small");
        fs::create_dir_all(&folder).unwrap();
        let options = format!("size={size}");
        let mounted = Command::new("mount")
            .args(["-t", "tmpfs", "-o", &options, "none"])
            .arg(&folder)
            .output();
        match mounted.is_ok_and(|output| output.status.success()) {
            true => Some(Small(scratch)),
            false => {
                use std::io::Write as _;
                let _ = writeln!(
                    std::io::stderr(),
                    "SKIPPED: no file system may be mounted here, so a full and a read-only disk are not tried"
                );
                None
            }
        }
    }

    pub(super) fn remount(&self, options: &str) {
        let done = Command::new("mount")
            .args(["-o", options])
            .arg(self.0.path().join("small"))
            .status();
        assert!(done.unwrap().success());
    }
}

impl Drop for Small<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.0.path().join("small")).status();
    }
}

#[test]
fn refuses_a_full_or_read_only_disk_and_keeps_what_was_there() {
    let scratch = Scratch::new("store-full");
    let store = "--store small/s.db";
    let Some(small) = Small::of(&scratch, "2m") else {
        return;
    };
    project(&scratch, "a", 2);
    good(scratch.briefly(&format!("survey add a {store} --without-modes")));
    let before = content(&scratch, store);
    // incompressible bytes
    let mut seed = 3;
    let noise: Vec<u8> = (0..3_000_000).map(|_| below(&mut seed, 256) as u8).collect();
    project(&scratch, "b", 1);
    fs::write(scratch.path().join("b/record-0.csv"), &noise).unwrap();
    refused(
        &scratch.briefly(&format!("survey add b {store} --without-modes")),
        "The disk is full",
    );
    assert_eq!(before, content(&scratch, store));
    // another file takes the last bytes, so the database has no space
    fs::write(scratch.path().join("small/rest"), vec![0; 64]).unwrap();
    let mut rest = fs::OpenOptions::new()
        .append(true)
        .open(scratch.path().join("small/rest"))
        .unwrap();
    while std::io::Write::write_all(&mut rest, &[0; 4096]).is_ok() {}
    drop(rest);
    project(&scratch, "c", 1);
    refused(
        &scratch.briefly(&format!("survey add c {store} --without-modes")),
        "The disk is full",
    );
    fs::remove_file(scratch.path().join("small/rest")).unwrap();
    assert_eq!(before, content(&scratch, store));
    small.remount("remount,ro");
    refused(
        &scratch.briefly(&format!("survey add c {store} --without-modes")),
        "may only be read",
    );
    assert_eq!(before, content(&scratch, store));
    good(scratch.briefly(&format!("survey export a -o back {store}")));
}
