//! A mesh in whatever format it comes.

use super::{MeshError, read_obj, read_ply, read_stl};
use std::collections::BTreeMap;

/// Triangles between vertices, in the unit of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners, in the unit of the file: none of the formats says which.
    pub vertices: Vec<[f64; 3]>,
    /// Corners of each triangle, from 0; counterclockwise seen from outside, if the file keeps to the custom.
    pub triangles: Vec<[usize; 3]>,
}

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
    /// The format that the first bytes, or the length, give away; OBJ if there is a line that only OBJ has.
    pub fn of(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"ply") {
            return Some(MeshFormat::Ply);
        }
        if super::stl::binary_length(bytes) == Some(bytes.len() as u64) {
            return Some(MeshFormat::StlBinary); // also where its comment begins with "solid"
        }
        let text = bytes.trim_ascii_start();
        if text.starts_with(b"solid") {
            return Some(MeshFormat::StlText);
        }
        let mut lines = bytes.split(|&b| b == b'\n');
        lines
            .any(|line| line.trim_ascii_start().starts_with(b"v "))
            .then_some(MeshFormat::Obj)
    }
}

impl Mesh {
    /// The same mesh in metres.
    pub fn scaled(mut self, metres_per_unit: f64) -> Self {
        for vertex in &mut self.vertices {
            *vertex = vertex.map(|value| value * metres_per_unit);
        }
        self
    }

    /// Vertices in exactly the same place made one, and triangles that had two of them taken out.
    pub fn merged(self) -> Self {
        let mut numbers: BTreeMap<[u64; 3], usize> = BTreeMap::new();
        let mut vertices = Vec::new();
        let mut places = Vec::with_capacity(self.vertices.len());
        for vertex in self.vertices {
            let key = vertex.map(|value| (value + 0.0).to_bits()); // −0 is 0
            places.push(*numbers.entry(key).or_insert_with(|| {
                vertices.push(vertex);
                vertices.len() - 1
            }));
        }
        let triangles = self.triangles.iter().map(|t| t.map(|corner| places[corner]));
        Mesh {
            vertices,
            triangles: triangles.filter(|[a, b, c]| a != b && b != c && c != a).collect(),
        }
    }

    /// Adds a polygon as a fan of triangles from its first corner.
    pub(super) fn push_polygon(&mut self, corners: &[usize]) {
        for pair in corners.get(1..).unwrap_or_default().windows(2) {
            self.triangles.push([corners[0], pair[0], pair[1]]);
        }
    }

    pub(super) fn checked(self) -> Result<Self, MeshError> {
        if self.triangles.is_empty() {
            return Err(MeshError::NoFaces {
                vertices: self.vertices.len(),
            });
        }
        Ok(self)
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
        None => Err(MeshError::Unknown),
    }
}

/// A finite number.
pub(super) fn number(word: &[u8], line: usize) -> Result<f64, MeshError> {
    let text = String::from_utf8_lossy(word);
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(MeshError::Number {
            line,
            text: text.chars().take(40).collect(),
        }),
    }
}

/// Words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}
