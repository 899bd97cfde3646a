//! STL, text and binary.
//!
//! Binary layout, little endian: 80 bytes of comment, number of triangles (u32), then 50 bytes each: normal and three
//! corners (12 × f32), attribute (u16).

use super::mesh::{Merging, number, refuse_triangles, words};
use super::{Mesh, MeshError};
use crate::limits::line_end;
use crate::wrong::OfMesh;

const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Length of a binary file with its stated number of triangles.
pub(super) fn binary_length(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(80..HEAD)?;
    let count = u32::from_le_bytes([count[0], count[1], count[2], count[3]]);
    Some(HEAD as u64 + TRIANGLE as u64 * u64::from(count))
}

/// A mesh from the bytes of an STL file, text or binary. Corners in exactly the same place become one vertex; triangles without area are
/// dropped. The normals of the file are ignored.
///
/// # Errors
/// [`MeshError`] with the line, or the byte of a binary file.
pub fn read_stl(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let expected = binary_length(bytes);
    let is_text = bytes.trim_ascii_start().starts_with(b"solid") && expected != Some(bytes.len() as u64);
    if is_text {
        return text(bytes)?.merged().checked();
    }
    let expected = expected.unwrap_or(HEAD as u64);
    if expected > bytes.len() as u64 || bytes.len() < HEAD {
        return Err(MeshError::Length {
            expected,
            held: bytes.len(),
        });
    }
    binary(bytes, expected)?.checked()
}

/// The triangles of a binary file; corners with identical coordinates are merged.
fn binary(bytes: &[u8], expected: u64) -> Result<Mesh, MeshError> {
    let mut merging = Merging::default();
    refuse_triangles((expected as usize).saturating_sub(HEAD) / TRIANGLE)?;
    let end = usize::try_from(expected).unwrap_or(bytes.len());
    for (number, record) in bytes[HEAD..end].chunks_exact(TRIANGLE).enumerate() {
        let value = |at: usize| {
            f64::from(f32::from_le_bytes([
                record[at],
                record[at + 1],
                record[at + 2],
                record[at + 3],
            ]))
        };
        let corners = [12, 24, 36].map(|at| [value(at), value(at + 4), value(at + 8)]);
        if !corners.iter().flatten().all(|v| v.is_finite()) {
            return Err(MeshError::Byte {
                offset: HEAD + TRIANGLE * number,
                what: OfMesh::CornerNotFinite.into(),
            });
        }
        let triangle = corners.map(|corner| merging.place(corner));
        merging.push(triangle);
    }
    Ok(merging.mesh)
}

fn text(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut mesh = Mesh::default();
    let mut loop_from = 0;
    for (at, line) in bytes.split(|&b| b == b'\n').enumerate() {
        let line_number = at + 1;
        line_end(line, line_number)?;
        let mut words = words(line);
        match words.next() {
            Some(b"vertex") => {
                let place: Vec<f64> = words
                    .take(3)
                    .map(|word| number(word, line_number))
                    .collect::<Result<_, _>>()?;
                let place = <[f64; 3]>::try_from(place).map_err(|_| MeshError::Line {
                    line: line_number,
                    what: OfMesh::ThreeCoordinates.into(),
                })?;
                mesh.vertices.push(place);
            }
            Some(b"outer") => loop_from = mesh.vertices.len(),
            Some(b"endloop") => {
                let corners: Vec<usize> = (loop_from..mesh.vertices.len()).collect();
                if corners.len() < 3 {
                    return Err(MeshError::Line {
                        line: line_number,
                        what: OfMesh::ShortLoop.into(),
                    });
                }
                mesh.push_polygon(&corners);
                loop_from = mesh.vertices.len();
            }
            Some(b"solid" | b"facet" | b"endfacet" | b"endsolid") | None => {}
            Some(_) => {
                return Err(MeshError::Line {
                    line: line_number,
                    what: OfMesh::NoStlLine.into(),
                });
            }
        }
    }
    if loop_from != mesh.vertices.len() {
        return Err(MeshError::Line {
            line: bytes.split(|&b| b == b'\n').count(),
            what: OfMesh::EndsInTriangle.into(),
        });
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f32; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

    fn as_binary(comment: &[u8]) -> Vec<u8> {
        let mut bytes = comment.to_vec();
        bytes.resize(80, b' ');
        bytes.extend(4u32.to_le_bytes());
        for face in FACES {
            bytes.extend([0; 12]);
            for corner in face {
                bytes.extend(CORNERS[corner].iter().flat_map(|v| v.to_le_bytes()));
            }
            bytes.extend([0; 2]);
        }
        bytes
    }

    fn as_text() -> String {
        let mut text = "solid stone\n".to_owned();
        for face in FACES {
            text += " facet normal 0 0 0\n  outer loop\n";
            for corner in face {
                let [x, y, z] = CORNERS[corner];
                text += &format!("   vertex {x:e} {y} {z}\n");
            }
            text += "  endloop\n endfacet\n";
        }
        text + "endsolid stone\n"
    }

    #[test]
    fn exact_text_and_binary_say_the_same() {
        let mesh = read_stl(as_text().as_bytes()).unwrap();
        assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (4, 4));
        for comment in [&b"made by hand"[..], b"solid but binary"] {
            assert_eq!(read_stl(&as_binary(comment)).unwrap(), mesh);
        }
        let solid = dolmen::structure::stack::Solid::mesh(&mesh.vertices, &mesh.triangles).unwrap();
        assert!((solid.volume_m3() - 1.0 / 6.0).abs() < 1e-15);
    }

    #[test]
    fn refuses_a_file_cut_short() {
        let bytes = as_binary(b"x");
        let fault = read_stl(&bytes[..200]).unwrap_err();
        assert!(fault.to_string().contains("should have 284 bytes"), "{fault}");
        let text = as_text();
        let fault = read_stl(&text.as_bytes()[..text.find("endloop").unwrap()]).unwrap_err();
        assert!(fault.to_string().contains("ends within a triangle"), "{fault}");
        assert!(read_stl(b"").is_err() && read_stl(b"solid").is_err());
    }
}
