//! Triangle mesh, and parsing of words and numbers in the text formats of meshes.

use super::MeshError;
use std::collections::BTreeMap;

/// Largest number of corners of a face. Our choice: a file with more is damaged.
pub(super) const CORNERS_MOST: usize = 65_536;
/// Largest number of triangles. Our choice: cutting a million into stones takes 20 s and 0.5 GB, and ten million more than two minutes and 3.5 GB;
/// a bed is found as well from triangles of 10 mm.
const TRIANGLES_MOST: usize = 2_000_000;
/// Largest size of a mesh relative to its file, in bytes. Our choice: a binary file of quadrilaterals or hexagons grows threefold, a text file
/// less.
const EXPANSION_MOST: usize = 4;
/// Size of a mesh that is always allowed, bytes. Our choice: two million triangles and vertices fit in any memory.
const EXPANDED_FREE: usize = 64 << 20;

/// Triangles and their vertices, in the unit of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices, in the unit of the file: no mesh format states the unit.
    pub vertices: Vec<[f64; 3]>,
    /// Vertex indices of each triangle, from 0; counterclockwise seen from outside, if the file follows the usual convention.
    pub triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// The same mesh in metres.
    pub fn scaled(mut self, metres_per_unit: f64) -> Self {
        for vertex in &mut self.vertices {
            *vertex = vertex.map(|value| value * metres_per_unit);
        }
        self
    }

    /// Merges vertices with identical coordinates, and drops triangles that then have two equal vertices.
    pub fn merged(self) -> Self {
        let mut merging = Merging::default();
        let places: Vec<usize> = self.vertices.into_iter().map(|v| merging.place(v)).collect();
        for triangle in self.triangles {
            merging.push(triangle.map(|corner| places[corner]));
        }
        merging.mesh
    }

    /// Adds a polygon as a fan of triangles from its first corner.
    pub(super) fn push_polygon(&mut self, corners: &[usize]) {
        for pair in corners.get(1..).unwrap_or_default().windows(2) {
            self.triangles.push([corners[0], pair[0], pair[1]]);
        }
    }

    /// Refuses a mesh that is much larger than its file of `bytes` bytes.
    pub(super) fn refuse_expansion(&self, bytes: usize) -> Result<(), MeshError> {
        const OF_ONE: usize = 24; // three numbers, or three corners
        let held = OF_ONE * (self.vertices.len() + self.triangles.len());
        match bytes.saturating_mul(EXPANSION_MOST).max(EXPANDED_FREE) {
            most if held <= most => Ok(()),
            most => Err(MeshError::Expands { bytes, held, most }),
        }
    }

    pub(super) fn checked(self) -> Result<Self, MeshError> {
        if self.triangles.is_empty() {
            return Err(MeshError::NoFaces {
                vertices: self.vertices.len(),
            });
        }
        refuse_triangles(self.triangles.len())?;
        Ok(self)
    }
}

/// Refuses so many triangles, counted or stated in the head of a file.
pub(super) fn refuse_triangles(found: usize) -> Result<(), MeshError> {
    let most = TRIANGLES_MOST;
    match found <= most {
        true => Ok(()),
        false => Err(MeshError::Triangles { found, most }),
    }
}

/// Collects a mesh; merges vertices with identical coordinates.
#[derive(Default)]
pub(super) struct Merging {
    pub(super) mesh: Mesh,
    numbers: BTreeMap<[u64; 3], usize>,
}

impl Merging {
    /// Index of the vertex, which is added if it is new.
    pub(super) fn place(&mut self, vertex: [f64; 3]) -> usize {
        let key = vertex.map(|value| (value + 0.0).to_bits()); // −0 is 0
        *self.numbers.entry(key).or_insert_with(|| {
            self.mesh.vertices.push(vertex);
            self.mesh.vertices.len() - 1
        })
    }

    /// Adds a triangle of three vertices.
    pub(super) fn push(&mut self, [a, b, c]: [usize; 3]) {
        if a != b && b != c && c != a {
            self.mesh.triangles.push([a, b, c]);
        }
    }
}

/// Parses a finite number.
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

/// The words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}

#[cfg(test)]
mod tests {
    use crate::meshes::read_mesh;

    /// The same vertex repeated: every few bytes of the file give a triangle of 24 bytes.
    #[test]
    fn refuses_a_small_file_of_endless_faces() {
        let obj =
            "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned() + &format!("f{}\n", " 1".repeat(60_000)).repeat(50);
        assert_eq!(
            read_mesh(obj.as_bytes()).unwrap_err().to_string(),
            "the file of 6000124 bytes holds a mesh of 67677816, but at most 67108864 are read of it: it is damaged; export it again with \
             triangles"
        );
    }

    #[test]
    fn refuses_a_face_or_a_line_without_end() {
        let corners = |count: usize| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf{}\n", " 1".repeat(count));
        assert_eq!(
            read_mesh(corners(65_537).as_bytes()).unwrap_err().to_string(),
            "line 4: a face has more than 65536 vertices"
        );
        let said = read_mesh(corners(550_000).as_bytes()).unwrap_err().to_string();
        assert!(
            said.starts_with("line 4 has 1100001 bytes, but at most 1048576 are read"),
            "{said}"
        );
    }

    #[test]
    fn refuses_other_text_without_a_word_of_it() {
        for text in ["v hidden\nv 1 hidden\n", "Dear Ann,\nv for victory\n", "v 1\n"] {
            let said = read_mesh(text.as_bytes()).unwrap_err().to_string();
            assert!(said.starts_with("the file is no OBJ, STL or PLY"), "{said}");
        }
        let said = read_mesh(b"v 0 0 0\nv 0 0 \x1b[2J\n").unwrap_err().to_string();
        assert_eq!(said, "line 2: \"\\u{1b}[2J\" is not a finite number");
    }

    #[test]
    fn refuses_more_triangles_than_are_cut() {
        let most = super::TRIANGLES_MOST;
        assert_eq!(super::refuse_triangles(most), Ok(()));
        let ply = format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face {}\n\
             property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n{}",
            most + 1,
            "3 0 1 2\n".repeat(most + 1)
        );
        let mut stl = vec![0_u8; 84 + 50 * (most + 1)];
        stl[80..84].copy_from_slice(&(most as u32 + 1).to_le_bytes());
        let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned() + &"f 1 2 3\n".repeat(most + 1);
        for file in [ply.as_bytes(), &stl, obj.as_bytes()] {
            let fault = read_mesh(file).unwrap_err().to_string();
            assert!(
                fault.starts_with("the mesh has 2000001 triangles, but at most 2000000"),
                "{fault}"
            );
        }
    }
}
