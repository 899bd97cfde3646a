//! Reads Wavefront OBJ files: vertices and faces; everything else (normals, textures, groups, lines) is ignored.

use super::mesh::{CORNERS_MOST, number, words};
use super::{Mesh, MeshError};
use crate::limits::line_end;
use crate::number::parse_number;
use crate::wrong::OfMesh;

/// Reads a mesh from the bytes of an OBJ file, with all its objects together.
///
/// Vertex numbers of faces count from the first vertex (1, 2, …) or back from the last (−1, −2, …). A `\` continues a line.
///
/// # Errors
/// [`MeshError`], with the line.
pub fn read_obj(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut mesh = Mesh::default();
    let mut lines = bytes.split(|&b| b == b'\n').enumerate();
    while let Some((at, line)) = lines.next() {
        let number_of_line = at + 1;
        line_end(line, number_of_line)?;
        let mut joined = line.trim_ascii_end().to_vec();
        while joined.last() == Some(&b'\\') {
            joined.pop();
            joined.push(b' ');
            match lines.next() {
                Some((_, next)) => joined.extend_from_slice(next.trim_ascii_end()),
                None => break,
            }
            line_end(&joined, number_of_line)?;
        }
        let content = joined.split(|&b| b == b'#').next().unwrap_or_default();
        let mut words = words(content);
        match words.next() {
            Some(b"v") => mesh.vertices.push(vertex(words, number_of_line)?),
            Some(b"f") => {
                let vertices = mesh.vertices.len();
                let corners = words.map(|word| corner(word, vertices, number_of_line));
                let corners: Vec<usize> = corners.collect::<Result<_, _>>()?;
                let what = match corners.len() {
                    0..3 => Some(OfMesh::FewCorners),
                    3..=CORNERS_MOST => None,
                    _ => Some(OfMesh::ManyCorners),
                };
                if let Some(what) = what {
                    return Err(MeshError::Line {
                        line: number_of_line,
                        what: what.into(),
                    });
                }
                mesh.push_polygon(&corners);
                mesh.refuse_expansion(bytes.len())?;
            }
            _ => {}
        }
    }
    mesh.checked()
}

/// Whether a line describes a vertex: `v` and at least two numbers. A text without such a line is not an OBJ file, and the
/// error quotes none of it.
pub(super) fn is_vertex(line: &[u8]) -> bool {
    let mut words = words(line);
    let is_number = |word: &[u8]| parse_number(word).is_some();
    words.next() == Some(b"v") && words.take(2).filter(|word| is_number(word)).count() == 2
}

fn vertex<'a>(words: impl Iterator<Item = &'a [u8]>, line: usize) -> Result<[f64; 3], MeshError> {
    // a weight or a colour may follow the coordinates
    let place: Vec<f64> = words
        .take(3)
        .map(|word| number(word, line))
        .collect::<Result<_, _>>()?;
    <[f64; 3]>::try_from(place).map_err(|_| MeshError::Line {
        line,
        what: OfMesh::ThreeCoordinates.into(),
    })
}

/// Vertex index of `7`, `7/1`, `7//3`, `7/1/3` or `-1`.
fn corner(word: &[u8], vertices: usize, line: usize) -> Result<usize, MeshError> {
    let first = word.split(|&b| b == b'/').next().unwrap_or_default();
    let text = String::from_utf8_lossy(first);
    let given: i64 = text.parse().map_err(|_| MeshError::Number {
        line,
        text: text.chars().take(40).collect(),
    })?;
    let index = match given {
        1.. => usize::try_from(given - 1).ok(),
        _ => usize::try_from(given.unsigned_abs())
            .ok()
            .and_then(|back| vertices.checked_sub(back)),
    };
    index.filter(|&index| index < vertices).ok_or(MeshError::Vertex {
        line,
        given,
        vertices,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_faces_of_every_spelling() {
        let text = b"# a pyramid\nmtllib x.mtl\no stone\nv 0 0 0\r\nv 1 0 0 1.0\nv 1 1 0 .5 .5 .5\nv 0 1 0\nv 5e-1 .5 1\n\
                     vn 0 0 1\nvt 0 0\nf 4/1/1 3/1/1 2//1 1/1\nf -1 \\\n -5 -4 # base to tip\nl 1 2\n";
        let mesh = read_obj(text).unwrap();
        assert_eq!(mesh.vertices.len(), 5);
        assert_eq!(mesh.triangles, [[3, 2, 1], [3, 1, 0], [4, 0, 1]]);
    }

    #[test]
    fn refuses_with_the_line() {
        let says = |text: &str| read_obj(text.as_bytes()).unwrap_err().to_string();
        assert_eq!(says("v 0 0 0\nv 0 0 x\n"), "line 2: \"x\" is not a finite number");
        assert_eq!(
            says("v 0 0 0\nv 0 0\n"),
            "line 2: a vertex needs three coordinates"
        );
        assert_eq!(
            says("v 0 0 0\nf 1 2 1\n"),
            "line 2: a face names vertex 2, but there are 1"
        );
        assert_eq!(
            says("v 0 0 0\nf 0 1 1\n"),
            "line 2: a face names vertex 0, but there are 1"
        );
        assert_eq!(says("v 0 0 nan\n"), "line 1: \"nan\" is not a finite number");
        assert!(says("v 0 0 0\n").contains("1 vertices but no faces"));
        assert!(says("v 0 0 0\nf 1 -9223372036854775808 1\n").starts_with("line 2: a face names vertex"));
    }
}
