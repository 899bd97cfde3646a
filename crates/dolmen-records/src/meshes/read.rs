//! Reads a mesh in any supported format.

use super::obj::is_vertex;
use super::stl::binary_length;
use super::{Mesh, MeshError, read_obj, read_ply, read_stl};

/// The format of a mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Wavefront OBJ.
    Obj,
    /// Stereolithography, text.
    StlText,
    /// Stereolithography, binary.
    StlBinary,
    /// Stanford PLY, text or binary.
    Ply,
}

impl MeshFormat {
    /// The format from the first bytes or the length; OBJ if a line is specific to OBJ.
    pub fn of(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"ply") {
            return Some(MeshFormat::Ply);
        }
        if binary_length(bytes) == Some(bytes.len() as u64) {
            return Some(MeshFormat::StlBinary); // also where its comment begins with "solid"
        }
        let text = bytes.trim_ascii_start();
        if text.starts_with(b"solid") {
            return Some(MeshFormat::StlText);
        }
        let mut lines = bytes.split(|&b| b == b'\n');
        lines.any(is_vertex).then_some(MeshFormat::Obj)
    }
}

/// A mesh from the bytes of an OBJ, STL or PLY file.
///
/// Polygons become fans of triangles. Vertices of STL in the same place become one; OBJ and PLY keep theirs: see
/// [`Mesh::merged`].
///
/// # Errors
/// [`MeshError`] with the line, or the byte of a binary file.
///
/// # Example
/// ```
/// use dolmen_records::meshes::read_mesh;
/// let mesh = read_mesh(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
/// assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
/// # Ok::<(), dolmen_records::meshes::MeshError>(())
/// ```
pub fn read_mesh(bytes: &[u8]) -> Result<Mesh, MeshError> {
    match MeshFormat::of(bytes) {
        Some(MeshFormat::Obj) => read_obj(bytes),
        Some(MeshFormat::StlText | MeshFormat::StlBinary) => read_stl(bytes),
        Some(MeshFormat::Ply) => read_ply(bytes),
        None => Err(match cloud(bytes) {
            Some(format) => MeshError::PointCloud { format },
            None => MeshError::Unknown,
        }),
    }
}

/// The format of a cloud of points, from the first bytes.
fn cloud(bytes: &[u8]) -> Option<&'static str> {
    let known = [
        (&b"LASF"[..], "LAS, LAZ"),
        (&b"ASTM-E57"[..], "E57"),
        (&b"# .PCD"[..], "PCD"),
    ];
    let found = known.into_iter().find(|(start, _)| bytes.starts_with(start));
    found.map(|(_, format)| format)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meshes::mesh_ply;

    #[test]
    fn refuses_clouds_of_points_by_their_format() {
        for (start, format) in [
            ("LASF\0\0", "(LAS, LAZ)"),
            ("ASTM-E57\u{1}", "(E57)"),
            ("# .PCD v0.7", "(PCD)"),
        ] {
            let said = read_mesh(start.as_bytes()).unwrap_err().to_string();
            assert!(
                said.starts_with("the file is a cloud of points") && said.contains(format),
                "{said}"
            );
            assert!(said.contains("make a closed mesh of it first"), "{said}");
        }
    }

    #[test]
    fn exact_ply_is_read_as_it_was_written() {
        let mesh = Mesh {
            vertices: vec![
                [0.1, 0.0, 1.0 / 3.0],
                [1.0, -2e-7, 0.0],
                [0.0, 1.0, 0.0],
                [0.0, 0.0, 1e9],
            ],
            triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
        };
        assert_eq!(read_mesh(&mesh_ply(&mesh)).unwrap(), mesh);
    }
}
