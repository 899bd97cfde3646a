//! Every file that fuzzing kept is read again: a record or an error, never a panic.

use dolmen::structure::stack::Solid;
use dolmen_formats::meshes::{read_mesh, read_obj, read_ply, read_stl};
use dolmen_formats::motions::{MotionOptions, read_component};
use dolmen_formats::records::{Column, RecordOptions, Unit, read_csv, read_npy};
use std::path::Path;

/// Hands each file of a corpus on; returns how many there were.
fn replay(corpus: &str, read: impl Fn(&[u8])) -> usize {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../fuzz/corpus")
        .join(corpus);
    let files = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    files
        .map(|file| read(&std::fs::read(file.unwrap().path()).unwrap()))
        .count()
}

fn at_100_hz() -> RecordOptions {
    RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    }
}

#[test]
fn holds_csv() {
    let files = replay("csv", |bytes| {
        let _ = read_csv(bytes, &RecordOptions::default());
        let _ = read_csv(bytes, &at_100_hz());
    });
    assert!(files >= 10, "{files} files");
}

#[test]
fn holds_npy() {
    let files = replay("npy", |bytes| {
        let _ = read_npy(bytes, &at_100_hz());
    });
    assert!(files >= 10, "{files} files");
}

#[test]
fn holds_mesh() {
    let files = replay("mesh", |bytes| {
        let _ = (read_obj(bytes), read_ply(bytes), read_stl(bytes));
        if let Ok(mesh) = read_mesh(bytes) {
            assert!(
                mesh.triangles
                    .iter()
                    .flatten()
                    .all(|&corner| corner < mesh.vertices.len())
            );
            let _ = Solid::mesh(&mesh.vertices, &mesh.triangles);
        }
    });
    assert!(files >= 10, "{files} files");
}

#[test]
fn holds_motions() {
    let files = replay("motion", |bytes| {
        let _ = read_component(bytes, &MotionOptions::default());
        for column in [None, Some(Column::Number(0)), Some(Column::Number(2))] {
            let told = MotionOptions {
                unit: Some(Unit::Gal),
                time_step_s: Some(0.01),
                plausible_peak_m_s2: 0.0..=f64::MAX,
                column,
                ..Default::default()
            };
            let _ = read_component(bytes, &told);
        }
    });
    assert!(files >= 10, "{files} files");
}
