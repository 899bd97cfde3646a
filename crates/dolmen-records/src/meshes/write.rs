//! Stacks for other programs: OBJ, JSON of blocks, 3DEC, ParaView.
//!
//! Each block is written as the convex hull that carries contact. If its own volume differs (drums, meshes, openings), the density is
//! adjusted so that the hull has the block's mass; centroid and inertia are then those of the hull.

use dolmen::structure::stack::{Block, Stack};
use serde_json::json;
use std::fmt::Write as _;

/// The pose of a block at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockPose {
    /// Its centroid, m.
    pub centroid_m: [f64; 3],
    /// Rotation matrix relative to the drawn position, by rows: a point is at x = c + R (x₀ − c₀).
    pub rotation: [[f64; 3]; 3],
    /// Velocity of its centroid, m/s; written if all blocks have one.
    pub velocity_m_s: Option<[f64; 3]>,
}

/// A file of a series and its time.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesFile {
    /// Time, s.
    pub time_s: f64,
    /// Name of the file, as seen from the folder of the series.
    pub file: String,
}

/// Why poses cannot be written.
#[derive(Clone, Debug, PartialEq)]
pub enum PoseError {
    /// The numbers of poses and blocks differ.
    Count {
        /// Poses given.
        poses: usize,
        /// Blocks of the stack.
        blocks: usize,
    },
    /// A pose that is not finite.
    NotFinite {
        /// The block, from 0.
        block: usize,
    },
}

/// The pose of each block as drawn.
pub fn poses_as_drawn(stack: &Stack) -> Vec<BlockPose> {
    let pose = |block: &Block| BlockPose {
        centroid_m: block.solid.centroid_m(),
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        velocity_m_s: None,
    };
    stack.blocks().iter().map(pose).collect()
}

/// A stack as Wavefront OBJ, in metres, one object per block, faces counterclockwise seen from outside.
pub fn stack_obj(stack: &Stack) -> String {
    let mut text = String::from("# metres, z up\n");
    let mut first = 1;
    for block in stack.blocks() {
        let _ = writeln!(text, "o {}", block.name.replace(char::is_whitespace, "_"));
        for [x, y, z] in block.solid.vertices_m() {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        for face in block.solid.faces() {
            let corners: Vec<String> = face.iter().map(|corner| (corner + first).to_string()).collect();
            let _ = writeln!(text, "f {}", corners.join(" "));
        }
        first += block.solid.vertices_m().len();
    }
    text
}

/// A stack as JSON, for programs for assemblies of blocks: name, vertices (m), faces (counterclockwise seen from
/// outside, from 0) and density [kg/m³] of each block.
pub fn stack_json(stack: &Stack) -> String {
    let block = |block: &Block| {
        json!({
            "name": block.name,
            "vertices": block.solid.vertices_m(),
            "faces": block.solid.faces(),
            "density": hull_density(block),
        })
    };
    json!({ "blocks": stack.blocks().iter().map(block).collect::<Vec<_>>() }).to_string()
}

/// A stack as commands of 3DEC (version 7): blocks with their groups and densities; the user adds joints and boundaries.
///
/// Faces are clockwise seen from outside, as its manual requires. Written from the manual; not tested in 3DEC.
pub fn stack_3dec(stack: &Stack) -> String {
    let mut text = String::from("; metres, z up, kg/m3\n");
    for block in stack.blocks() {
        let name = block.name.replace(['"', '\n', '\r'], " ");
        let _ = write!(text, "block create group \"{name}\" polyhedron");
        for face in block.solid.faces() {
            text.push_str(" &\n  face");
            for &corner in face.iter().rev() {
                let [x, y, z] = block.solid.vertices_m()[corner];
                let _ = write!(text, " {x},{y},{z}");
            }
        }
        text.push('\n');
    }
    for block in stack.blocks() {
        let name = block.name.replace(['"', '\n', '\r'], " ");
        let density = hull_density(block);
        let _ = writeln!(text, "block property density {density} range group \"{name}\"");
    }
    text
}

/// A stack at one time as VTU for ParaView: one polyhedron for each block, with its number, the displacement (and velocity) of its centroid, and
/// the displacement of every corner.
///
/// # Errors
/// [`PoseError`] unless there is one finite pose for each block.
pub fn stack_vtu(stack: &Stack, poses: &[BlockPose]) -> Result<String, PoseError> {
    let blocks = stack.blocks();
    if poses.len() != blocks.len() {
        return Err(PoseError::Count {
            poses: poses.len(),
            blocks: blocks.len(),
        });
    }
    let (mut points, mut shifts, mut cells, mut faces) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let (mut ends, mut face_ends, mut moves, mut velocities) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (number, (block, pose)) in blocks.iter().zip(poses).enumerate() {
        let numbers = pose.rotation.iter().flatten().chain(&pose.centroid_m);
        if !numbers
            .chain(pose.velocity_m_s.iter().flatten())
            .all(|v| v.is_finite())
        {
            return Err(PoseError::NotFinite { block: number });
        }
        let (first, drawn) = (points.len(), block.solid.centroid_m());
        for vertex in block.solid.vertices_m() {
            let arm: [f64; 3] = std::array::from_fn(|axis| vertex[axis] - drawn[axis]);
            let at: [f64; 3] = std::array::from_fn(|axis| {
                let row = pose.rotation[axis];
                pose.centroid_m[axis] + row[0] * arm[0] + row[1] * arm[1] + row[2] * arm[2]
            });
            points.push(at);
            shifts.push(std::array::from_fn(|axis| at[axis] - vertex[axis]));
        }
        cells.extend(first..points.len());
        ends.push(cells.len());
        faces.push(block.solid.faces().len());
        for face in block.solid.faces() {
            faces.push(face.len());
            faces.extend(face.iter().map(|corner| corner + first));
        }
        face_ends.push(faces.len());
        moves.push(std::array::from_fn(|axis| pose.centroid_m[axis] - drawn[axis]));
        velocities.extend(pose.velocity_m_s);
    }
    let (count, numbers): (usize, Vec<usize>) = (blocks.len(), (0..blocks.len()).collect());
    let mut text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{count}\">\n<Points>\n",
        points.len()
    );
    vectors(&mut text, "points", &points);
    text.push_str("</Points>\n<Cells>\n");
    integers(&mut text, "connectivity", &cells);
    integers(&mut text, "offsets", &ends);
    integers(&mut text, "types", &vec![POLYHEDRON; count]);
    integers(&mut text, "faces", &faces);
    integers(&mut text, "faceoffsets", &face_ends);
    text.push_str("</Cells>\n<PointData>\n");
    vectors(&mut text, "displacement_m", &shifts);
    text.push_str("</PointData>\n<CellData>\n");
    integers(&mut text, "block", &numbers);
    vectors(&mut text, "displacement_m", &moves);
    if velocities.len() == count {
        vectors(&mut text, "velocity_m_s", &velocities);
    }
    text.push_str("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    Ok(text)
}

/// The PVD file that lists VTU files with their times.
pub fn series_pvd(files: &[SeriesFile]) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for SeriesFile { time_s, file } in files {
        let file = file
            .replace('&', "&amp;")
            .replace('<', "&lt;")
            .replace('"', "&quot;");
        let _ = writeln!(
            text,
            "<DataSet timestep=\"{time_s}\" part=\"0\" file=\"{file}\"/>"
        );
    }
    text.push_str("</Collection>\n</VTKFile>\n");
    text
}

/// VTK's number of a polyhedron.
const POLYHEDRON: usize = 42;

/// The density that gives the convex hull the block's mass, kg/m³.
fn hull_density(block: &Block) -> f64 {
    let (own, hull) = (block.solid.volume_m3(), block.solid.hull_volume_m3());
    if (own / hull - 1.0).abs() < 1e-12 {
        return block.density_kg_m3; // rounding
    }
    block.mass_kg() / hull
}

fn vectors(text: &mut String, name: &str, values: &[[f64; 3]]) {
    let _ = writeln!(
        text,
        "<DataArray type=\"Float64\" Name=\"{name}\" NumberOfComponents=\"3\" format=\"ascii\">"
    );
    for [x, y, z] in values {
        let _ = writeln!(text, "{x} {y} {z}");
    }
    text.push_str("</DataArray>\n");
}

fn integers(text: &mut String, name: &str, values: &[usize]) {
    let _ = writeln!(
        text,
        "<DataArray type=\"Int64\" Name=\"{name}\" format=\"ascii\">"
    );
    let values: Vec<String> = values.iter().map(usize::to_string).collect();
    let _ = writeln!(text, "{}\n</DataArray>", values.join(" "));
}

#[cfg(test)]
mod tests {
    use super::super::read_obj;
    use super::*;
    use dolmen::structure::stack::{JointMaterial, Placement, Solid};

    fn stack() -> Stack {
        let place = |z: f64| Placement {
            position_m: [0.0, 0.0, z],
            ..Placement::default()
        };
        let block = |name: &str, solid: Solid| Block {
            name: name.into(),
            solid,
            density_kg_m3: 2600.0,
        };
        let blocks = vec![
            block("base", Solid::cuboid(2.0, 2.0, 0.5).unwrap()),
            block("drum 1", Solid::drum(1.0, 0.5).unwrap().placed(&place(0.5))),
        ];
        Stack::new(blocks, JointMaterial::default(), 9.81).unwrap()
    }

    #[test]
    fn exact_obj_comes_back_as_the_same_volume() {
        let text = stack_obj(&stack());
        assert!(text.contains("o drum_1\n"));
        let mesh = read_obj(text.as_bytes()).unwrap();
        let of_drum = mesh
            .triangles
            .iter()
            .filter(|t| t[0] >= 8)
            .map(|t| t.map(|corner| corner - 8));
        let solid = Solid::mesh(&mesh.vertices[8..], &of_drum.collect::<Vec<_>>()).unwrap();
        assert!((solid.volume_m3() - stack().blocks()[1].solid.hull_volume_m3()).abs() < 1e-14);
    }

    #[test]
    fn exact_json_keeps_the_mass() {
        let value: serde_json::Value = serde_json::from_str(&stack_json(&stack())).unwrap();
        let blocks = value["blocks"].as_array().unwrap();
        assert_eq!((blocks.len(), &blocks[0]["name"]), (2, &json!("base")));
        assert_eq!(blocks[0]["density"], json!(2600.0));
        let stack = stack();
        let drum = &stack.blocks()[1];
        let mass = blocks[1]["density"].as_f64().unwrap() * drum.solid.hull_volume_m3();
        assert!((mass / drum.mass_kg() - 1.0).abs() < 1e-12);
        assert_eq!(blocks[0]["faces"].as_array().unwrap().len(), 6);
    }

    #[test]
    fn exact_3dec_faces_run_clockwise() {
        let text = stack_3dec(&stack());
        // its base, seen from below: the manual's own cube has 0,0,0 1,0,0 1,1,0 0,1,0
        assert!(
            text.contains("block create group \"base\" polyhedron &\n  face "),
            "{text}"
        );
        let bottom = text.lines().nth(2).unwrap();
        let corners: Vec<[f64; 2]> = bottom
            .split_whitespace()
            .filter(|word| word.contains(','))
            .map(|word| {
                let values: Vec<f64> = word.split(',').map(|v| v.parse().unwrap()).collect();
                assert_eq!(values[2], 0.0);
                [values[0], values[1]]
            })
            .collect();
        let twice: f64 = (0..4)
            .map(|i| {
                let (a, b) = (corners[i], corners[(i + 1) % 4]);
                a[0] * b[1] - a[1] * b[0]
            })
            .sum();
        assert_eq!(twice, 8.0, "counterclockwise from above is clockwise from below");
        assert!(text.contains("block property density 2600 range group \"base\"\n"));
    }

    #[test]
    fn exact_vtu_of_a_quarter_turn_and_a_lift() {
        let stack = stack();
        let mut poses = poses_as_drawn(&stack);
        poses[0].rotation = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        poses[0].centroid_m[2] += 0.25;
        let text = stack_vtu(&stack, &poses).unwrap();
        // the first corner (−1, −1, 0) goes to (1, −1, 0.25)
        let first_of = |name: &str| -> Vec<f64> {
            let array = text.split(&format!("Name=\"{name}\"")).nth(1).unwrap();
            let line = array.lines().nth(1).unwrap();
            line.split(' ').map(|value| value.parse().unwrap()).collect()
        };
        for (name, exact) in [
            ("points", [1.0, -1.0, 0.25]),
            ("displacement_m", [2.0, 0.0, 0.25]),
        ] {
            let difference = first_of(name).into_iter().zip(exact).map(|(a, b)| (a - b).abs());
            assert!(difference.fold(0.0, f64::max) < 1e-14, "{name}");
        }
        assert!(text.contains("<DataArray type=\"Int64\" Name=\"types\" format=\"ascii\">\n42 42\n"));
        assert!(!text.contains("velocity"));
        poses
            .iter_mut()
            .for_each(|pose| pose.velocity_m_s = Some([0.0, 0.5, 0.0]));
        assert!(stack_vtu(&stack, &poses).unwrap().contains("velocity_m_s"));
        let series = series_pvd(&[SeriesFile {
            time_s: 0.5,
            file: "a&b.vtu".into(),
        }]);
        assert!(series.contains("<DataSet timestep=\"0.5\" part=\"0\" file=\"a&amp;b.vtu\"/>"));
    }

    #[test]
    fn refuses_poses_that_do_not_fit() {
        let stack = stack();
        let mut poses = poses_as_drawn(&stack);
        let fault = stack_vtu(&stack, &poses[..1]).unwrap_err();
        assert!(
            fault.to_string().starts_with("1 poses are given for 2 blocks"),
            "{fault}"
        );
        poses[1].rotation[0][0] = f64::NAN;
        assert_eq!(stack_vtu(&stack, &poses), Err(PoseError::NotFinite { block: 1 }));
    }
}
