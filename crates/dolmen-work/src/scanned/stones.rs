//! Stones, meshes and a project file from the mesh of a whole tower.

use super::answer::{ScanAnswer, ScanRequest, ScanUnit, ScannedStone};
use super::error::ScanError;
use super::project::{Cut, project_text};
use crate::error::{Within as _, WorkError};
use crate::opened::Opened;
use crate::wrong::Place;
use dolmen::structure::stack::{Sliced, SlicedStep, slice};
use dolmen_project::{Quantity, Structure};
use dolmen_records::MemoryFiles;
use dolmen_records::meshes::{Mesh, mesh_ply, read_mesh};

/// A mesh without a unit is in metres up to this height, and in millimetres from [`MILLIMETRES_FROM`] on. Our choice.
const METRES_TO: f64 = 30.0;
const MILLIMETRES_FROM: f64 = 300.0;
/// Heights of towers, m. Our choice: lower ones are models, higher ones have another unit.
const LEAST_M: f64 = 0.1;
const MOST_M: f64 = 100.0;
/// Distance from which the middle of the scan is moved to x = y = 0, m: national coordinates lose digits.
const FAR_M: f64 = 100.0;
/// Ground within this distance of 0 is not moved, m.
const GROUND_M: f64 = 1e-3;
/// Number of standard deviations by which the lowest vertex of a noisy foot lies below its plane.
const LOWEST_NOISE: f64 = 3.0;
/// Distance within which an allowed step is the one found, m, as for the height of a bed.
const ALLOWED_M: f64 = 0.02;

/// Cuts a scan into stones and writes a project of them, which it reads and builds as a check.
///
/// # Errors
/// [`WorkError::Scan`] for a mesh that cannot be read or cut, and errors of the stack of its stones.
pub fn stones_of_scan(request: &ScanRequest<'_>) -> Result<ScanAnswer, WorkError> {
    let mesh = read_mesh(request.bytes).map_err(ScanError::from)?.merged();
    let height_in_file = height(&mesh);
    let unit = unit(request.unit, height_in_file)?;
    let mesh = mesh.scaled(unit.metres());
    let sliced = slice(&mesh.vertices, &mesh.triangles, &request.beds_m).map_err(ScanError::from)?;
    check_steps(&sliced, &request.allowed_steps_m)?;
    let moved_m = moved(&mesh, &sliced);
    let (mut stones, mut files) = (Vec::new(), Vec::new());
    for (number, stone) in sliced.stones.iter().enumerate() {
        let mark = mark(&sliced, number);
        let file = format!("stone-{mark}.ply");
        let vertices = stone.vertices_m.iter();
        let placed = Mesh {
            vertices: vertices
                .map(|vertex| std::array::from_fn(|axis| vertex[axis] + moved_m[axis]))
                .collect(),
            triangles: stone.triangles.clone(),
        };
        files.push((file.clone(), mesh_ply(&placed)));
        stones.push(ScannedStone {
            name: format!("stone {mark}"),
            file,
            volume_m3: stone.volume_m3,
            triangles: stone.triangles.len(),
        });
    }
    let text = project_text(&Cut {
        file: &request.file,
        unit,
        moved_m,
        beds: &sliced.beds,
        stones: &stones,
    });
    let named = MemoryFiles {
        files: files.iter().cloned().collect(),
    };
    let place = || Place::StonesOfScan(request.file.clone());
    let opened = Opened::read(text.clone(), "project.toml".to_owned(), &named).within(place)?;
    if let Structure::Stack(part) = &opened.project.structure {
        part.build(&mut Quantity::nominal).within(place)?;
    }
    files.push(("project.toml".to_owned(), text.into_bytes()));
    Ok(ScanAnswer {
        file: request.file.clone(),
        unit,
        is_unit_recognised: request.unit.is_none(),
        height_in_file,
        moved_m,
        sliced,
        stones,
        files,
        opened,
    })
}

/// Refuses a forgotten bed, or one given beside a step.
fn check_steps(sliced: &Sliced, allowed_m: &[f64]) -> Result<(), ScanError> {
    let is_allowed = |step: &SlicedStep| allowed_m.iter().any(|at| (at - step.at_m).abs() <= ALLOWED_M);
    let steps: Vec<SlicedStep> = sliced
        .steps_without_bed
        .iter()
        .copied()
        .filter(|step| !is_allowed(step))
        .collect();
    let plain = sliced.beds.iter().enumerate().filter(|(_, bed)| !bed.is_at_step);
    let plain_beds: Vec<(usize, f64)> = plain.map(|(at, bed)| (at + 1, bed.named_m)).collect();
    match (steps.is_empty(), plain_beds.is_empty()) {
        (true, _) => Ok(()),
        (false, true) => Err(ScanError::StepsWithoutBed { steps }),
        (false, false) => Err(ScanError::BedsBesideSteps { steps, plain_beds }),
    }
}

/// Labels: "2a", "2b" and "2c" for three pieces of the second course; "2" for a course in one piece.
fn mark(sliced: &Sliced, number: usize) -> String {
    let course = sliced.stones[number].course;
    let first = sliced.stones.iter().position(|stone| stone.course == course);
    let count = sliced
        .stones
        .iter()
        .filter(|stone| stone.course == course)
        .count();
    let own = number - first.unwrap_or(number);
    match (count, u8::try_from(own).ok().filter(|own| *own < 26)) {
        (1, _) => format!("{}", course + 1),
        (_, Some(letter)) if count <= 26 => format!("{}{}", course + 1, char::from(b'a' + letter)),
        _ => format!("{}-{}", course + 1, own + 1),
    }
}

fn height(mesh: &Mesh) -> f64 {
    let used = mesh.triangles.iter().flatten().map(|&v| mesh.vertices[v][2]);
    let [low, high] = used.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
        [low.min(z), high.max(z)]
    });
    high - low
}

/// The given unit, or the one that the height implies.
fn unit(given: Option<ScanUnit>, height: f64) -> Result<ScanUnit, ScanError> {
    let unit = match given {
        Some(unit) => unit,
        None if height <= METRES_TO => ScanUnit::Metres,
        None if height >= MILLIMETRES_FROM => ScanUnit::Millimetres,
        None => return Err(ScanError::UnitUnclear { height }),
    };
    let height_m = unit.metres() * height;
    match (LEAST_M..=MOST_M).contains(&height_m) {
        true => Ok(unit),
        false => Err(ScanError::Height {
            height_m,
            unit: unit.symbol(),
            least_m: LEAST_M,
            most_m: MOST_M,
        }),
    }
}

/// Displacement of the stones.
fn moved(mesh: &Mesh, sliced: &Sliced) -> [f64; 3] {
    let ground_m = sliced.span_m[0] + LOWEST_NOISE * sliced.noise_m;
    let up_m = if ground_m.abs() <= GROUND_M {
        0.0
    } else {
        -ground_m
    };
    let middle = [0, 1].map(|axis| {
        let used = mesh.triangles.iter().flatten().map(|&v| mesh.vertices[v][axis]);
        let [low, high] = used.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| {
            [low.min(at), high.max(at)]
        });
        0.5 * (low + high)
    });
    match middle[0].hypot(middle[1]) > FAR_M {
        true => [-middle[0], -middle[1], up_m],
        false => [0.0, 0.0, up_m],
    }
}
