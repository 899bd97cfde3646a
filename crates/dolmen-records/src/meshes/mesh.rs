//! Triangles, and the words and numbers of the texts that hold them.

use super::MeshError;
use std::collections::BTreeMap;

/// Triangles between vertices, in the unit of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners, in the unit of the file: none of the formats says which.
    pub vertices: Vec<[f64; 3]>,
    /// Corners of each triangle, from 0; counterclockwise seen from outside, if the file keeps to the custom.
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
