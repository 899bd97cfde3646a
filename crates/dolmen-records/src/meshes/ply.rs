//! PLY, the polygon file format of Stanford: text, binary little endian, binary big endian.
//!
//! The header lists elements in the order of the body, each with its properties; everything except vertex positions and face
//! lists is ignored.

use super::mesh::{CORNERS_MOST, number, refuse_triangles, words};
use super::{Mesh, MeshError};
use crate::limits::line_end;
use crate::wrong::OfMesh;

#[derive(Clone, Copy, PartialEq)]
enum Coding {
    Text,
    Little,
    Big,
}

/// A type of number.
#[derive(Clone, Copy)]
enum Kind {
    Signed(usize),
    Unsigned(usize),
    Float(usize),
}

impl Kind {
    fn of(word: &[u8]) -> Option<Self> {
        Some(match word {
            b"char" | b"int8" => Kind::Signed(1),
            b"short" | b"int16" => Kind::Signed(2),
            b"int" | b"int32" => Kind::Signed(4),
            b"uchar" | b"uint8" => Kind::Unsigned(1),
            b"ushort" | b"uint16" => Kind::Unsigned(2),
            b"uint" | b"uint32" => Kind::Unsigned(4),
            b"float" | b"float32" => Kind::Float(4),
            b"double" | b"float64" => Kind::Float(8),
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Kind::Signed(size) | Kind::Unsigned(size) | Kind::Float(size) => size,
        }
    }
}

struct Property {
    name: Vec<u8>,
    kind: Kind,
    /// Type of the length, if the property is a list.
    length: Option<Kind>,
}

struct Element {
    name: Vec<u8>,
    count: usize,
    properties: Vec<Property>,
}

struct Header {
    coding: Coding,
    elements: Vec<Element>,
    body: usize,
    lines: usize,
}

/// Largest number of header lines. Our choice: a hundred elements of a hundred properties have fewer.
const HEADER_LINES_MOST: usize = 16_384;

/// A mesh from the bytes of a PLY file.
///
/// # Errors
/// [`MeshError`] with the line, or the byte of a binary file.
pub fn read_ply(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let header = header(bytes)?;
    let mut body = Body {
        bytes,
        at: header.body,
        line: header.lines + 1,
        coding: header.coding,
    };
    let mut mesh = Mesh::default();
    // faces may precede the vertices
    let of_vertices = header.elements.iter().filter(|element| element.name == b"vertex");
    let vertices = of_vertices.fold(0, |sum: usize, element| sum.saturating_add(element.count));
    for element in &header.elements {
        let is_vertex = element.name == b"vertex";
        let is_face = element.name == b"face";
        let place = |name: &[u8]| {
            element
                .properties
                .iter()
                .position(|p| p.name == name && p.length.is_none())
        };
        let places = [place(b"x"), place(b"y"), place(b"z")];
        if is_vertex && places.contains(&None) {
            return Err(MeshError::Line {
                line: header.lines,
                what: OfMesh::NoCoordinates.into(),
            });
        }
        // a head may state more than its file can hold
        if is_face && element.count <= bytes.len() {
            refuse_triangles(element.count)?;
        }
        if element.properties.is_empty() {
            continue;
        }
        for item in 0..element.count {
            let mut vertex = [0.0; 3];
            let at = body.place();
            for (index, property) in element.properties.iter().enumerate() {
                let values = body.values(property, is_vertex, item)?;
                if let Some(axis) = places.iter().position(|place| is_vertex && *place == Some(index)) {
                    vertex[axis] = values.first().copied().unwrap_or_default();
                }
                if is_face && matches!(&property.name[..], b"vertex_indices" | b"vertex_index") {
                    if values.is_empty() {
                        return Err(MeshError::Byte {
                            offset: body.at,
                            what: OfMesh::FaceWithoutVertices.into(),
                        });
                    }
                    mesh.push_polygon(&corners(&values, vertices, at)?);
                    mesh.refuse_expansion(bytes.len())?;
                }
            }
            body.end_line()?;
            if is_vertex {
                if !vertex.iter().all(|value| value.is_finite()) {
                    return Err(MeshError::Byte {
                        offset: body.at,
                        what: OfMesh::VertexNotFinite.into(),
                    });
                }
                mesh.vertices.push(vertex);
            }
        }
    }
    mesh.checked()
}

/// The corners of a face; each must be a vertex.
fn corners(values: &[f64], vertices: usize, line: usize) -> Result<Vec<usize>, MeshError> {
    let corner = |&value: &f64| {
        let given = value as i64; // an integer by its type, or refused as text below
        let index = usize::try_from(given)
            .ok()
            .filter(|&i| i < vertices && value.fract() == 0.0);
        index.ok_or(MeshError::Vertex {
            line,
            given,
            vertices,
        })
    };
    values.iter().map(corner).collect()
}

fn header(bytes: &[u8]) -> Result<Header, MeshError> {
    let mut header = Header {
        coding: Coding::Text,
        elements: Vec::new(),
        body: 0,
        lines: 0,
    };
    let refuse = |line: usize, what: OfMesh| {
        Err(MeshError::Line {
            line,
            what: what.into(),
        })
    };
    let mut has_format = false;
    for line in bytes.split_inclusive(|&b| b == b'\n') {
        header.lines += 1;
        line_end(line, header.lines)?;
        if header.lines > HEADER_LINES_MOST {
            return refuse(header.lines, OfMesh::LongHeader);
        }
        header.body += line.len();
        let words: Vec<&[u8]> = words(line).collect();
        match words[..] {
            [b"ply"] if header.lines == 1 => {}
            _ if header.lines == 1 => return refuse(1, OfMesh::FirstLine),
            [b"format", coding, ..] => {
                has_format = true;
                header.coding = match coding {
                    b"ascii" => Coding::Text,
                    b"binary_little_endian" => Coding::Little,
                    b"binary_big_endian" => Coding::Big,
                    _ => {
                        return refuse(header.lines, OfMesh::Format);
                    }
                };
            }
            [b"element", name, count] => {
                let count = std::str::from_utf8(count).ok().and_then(|text| text.parse().ok());
                let Some(count) = count else {
                    return refuse(header.lines, OfMesh::ElementCount);
                };
                header.elements.push(Element {
                    name: name.to_vec(),
                    count,
                    properties: Vec::new(),
                });
            }
            [b"property", b"list", length, kind, name] => {
                let (Some(length), Some(kind)) = (Kind::of(length), Kind::of(kind)) else {
                    return refuse(header.lines, OfMesh::TypeOfNumber);
                };
                let Some(element) = header.elements.last_mut() else {
                    return refuse(header.lines, OfMesh::PropertyFirst);
                };
                element.properties.push(Property {
                    name: name.to_vec(),
                    kind,
                    length: Some(length),
                });
            }
            [b"property", kind, name] => {
                let Some(kind) = Kind::of(kind) else {
                    return refuse(header.lines, OfMesh::TypeOfNumber);
                };
                let Some(element) = header.elements.last_mut() else {
                    return refuse(header.lines, OfMesh::PropertyFirst);
                };
                element.properties.push(Property {
                    name: name.to_vec(),
                    kind,
                    length: None,
                });
            }
            [b"end_header"] if has_format => return Ok(header),
            [b"comment" | b"obj_info", ..] | [] => {}
            _ => return refuse(header.lines, OfMesh::NoHeaderLine),
        }
    }
    refuse(header.lines, OfMesh::NoEndHeader)
}

struct Body<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
    coding: Coding,
}

impl Body<'_> {
    /// Position for an error message: line of a text file, byte of a binary file.
    fn place(&self) -> usize {
        if self.coding == Coding::Text {
            self.line
        } else {
            self.at
        }
    }

    fn values(&mut self, property: &Property, is_vertex: bool, item: usize) -> Result<Vec<f64>, MeshError> {
        let element = if is_vertex {
            OfMesh::Vertex
        } else {
            OfMesh::Element
        };
        let Some(length) = property.length else {
            return Ok(vec![self.value(property.kind, &element, item)?]);
        };
        let length = self.value(length, &element, item)?;
        if !(length >= 0.0 && length <= CORNERS_MOST as f64 && length.fract() == 0.0) {
            return Err(match self.coding {
                Coding::Text => MeshError::Line {
                    line: self.line,
                    what: OfMesh::ListLength.into(),
                },
                _ => MeshError::Byte {
                    offset: self.at,
                    what: OfMesh::ListLength.into(),
                },
            });
        }
        (0..length as usize)
            .map(|_| self.value(property.kind, &element, item))
            .collect()
    }

    fn value(&mut self, kind: Kind, element: &OfMesh, number_of_item: usize) -> Result<f64, MeshError> {
        let cut_short = MeshError::CutShort {
            offset: self.at,
            element: element.clone().into(),
            number: number_of_item,
        };
        if self.coding == Coding::Text {
            let rest = &self.bytes[self.at..];
            let start = rest
                .iter()
                .position(|b| !b.is_ascii_whitespace())
                .ok_or(cut_short)?;
            let rest = &rest[start..];
            let end = rest
                .iter()
                .position(u8::is_ascii_whitespace)
                .unwrap_or(rest.len());
            let skipped = &self.bytes[self.at..self.at + start];
            self.line += skipped.iter().filter(|&&b| b == b'\n').count();
            self.at += start + end;
            return number(&rest[..end], self.line);
        }
        let raw = self
            .at
            .checked_add(kind.size())
            .and_then(|end| self.bytes.get(self.at..end));
        let raw = raw.ok_or(cut_short)?;
        self.at += kind.size();
        let mut low_first = [0u8; 8];
        for (i, &byte) in raw.iter().enumerate() {
            let place = if self.coding == Coding::Little {
                i
            } else {
                raw.len() - 1 - i
            };
            low_first[place] = byte;
        }
        let bits = u64::from_le_bytes(low_first);
        let unused = 64 - 8 * kind.size() as u32;
        Ok(match kind {
            Kind::Unsigned(_) => bits as f64,
            Kind::Signed(_) => (((bits << unused) as i64) >> unused) as f64,
            Kind::Float(4) => f64::from(f32::from_bits(bits as u32)),
            Kind::Float(_) => f64::from_bits(bits),
        })
    }

    /// In text, one element is one line.
    fn end_line(&mut self) -> Result<(), MeshError> {
        if self.coding != Coding::Text {
            return Ok(());
        }
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
        if !rest[..end].trim_ascii().is_empty() {
            return Err(MeshError::Line {
                line: self.line,
                what: OfMesh::LongLine.into(),
            });
        }
        self.at += end;
        if self.at < self.bytes.len() {
            self.at += 1;
            self.line += 1;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(coding: &str) -> String {
        format!(
            "ply\nformat {coding} 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty float x\nproperty double y\n\
             property float z\nproperty uchar red\nelement face 3\nproperty uchar flag\n\
             property list uchar int vertex_indices\nend_header\n"
        )
    }

    const CORNERS: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 0.5]];
    const FACES: [&[i32]; 3] = [&[0, 2, 1], &[0, 1, 3], &[1, 2, 0, 3]];

    fn text() -> String {
        let mut text = head("ascii");
        for [x, y, z] in CORNERS {
            text += &format!("{x} {y} {z} 255\n");
        }
        for face in FACES {
            let corners: Vec<String> = face.iter().map(i32::to_string).collect();
            text += &format!("1 {} {}\n", face.len(), corners.join(" "));
        }
        text
    }

    fn binary(little: bool) -> Vec<u8> {
        let mut bytes = head(if little {
            "binary_little_endian"
        } else {
            "binary_big_endian"
        })
        .into_bytes();
        let mut push = |low_first: &[u8]| {
            let mut value = low_first.to_vec();
            if !little {
                value.reverse();
            }
            bytes.extend(value);
        };
        for [x, y, z] in CORNERS {
            push(&(x as f32).to_le_bytes());
            push(&y.to_le_bytes());
            push(&(z as f32).to_le_bytes());
            push(&[255]);
        }
        for face in FACES {
            push(&[1]);
            push(&[face.len() as u8]);
            face.iter().for_each(|corner| push(&corner.to_le_bytes()));
        }
        bytes
    }

    #[test]
    fn exact_the_three_codings_say_the_same() {
        let mesh = read_ply(text().as_bytes()).unwrap();
        assert_eq!(mesh.vertices, CORNERS);
        assert_eq!(mesh.triangles, [[0, 2, 1], [0, 1, 3], [1, 2, 0], [1, 0, 3]]);
        assert_eq!(read_ply(&binary(true)).unwrap(), mesh);
        assert_eq!(read_ply(&binary(false)).unwrap(), mesh);
    }

    #[test]
    fn refuses_with_the_place() {
        let says = |bytes: &[u8]| read_ply(bytes).unwrap_err().to_string();
        let bytes = binary(true);
        assert!(says(&bytes[..bytes.len() - 3]).contains("the file ends within element 2"));
        assert!(
            says(text().replace("1 3 0 2 1", "1 3 0 2 9").as_bytes())
                .starts_with("line 17: a face names vertex 9")
        );
        assert!(
            says(text().replace("1 0 0 255", "1 0 255").as_bytes())
                .starts_with("line 15: the line holds more")
        );
        assert!(says(text().replace("element face 3", "element face x").as_bytes()).starts_with("line 9"));
        assert!(says(b"ply\n").contains("no end_header"));
        assert!(says(text().replace("end_header", "end").as_bytes()).starts_with("line 12"));
        let faces = text().replace("1 3 0 2 1", "1 0");
        assert!(says(faces.as_bytes()).ends_with("a face before here has no vertices"));
        let header = "ply\n".to_owned() + &"comment\n".repeat(20_000);
        assert_eq!(
            says(header.as_bytes()),
            "line 16385: the header has more than 16384 lines"
        );
        let huge = text().replace("element vertex 4", "element vertex 4000000000000");
        assert!(read_ply(huge.as_bytes()).is_err());
    }
}
