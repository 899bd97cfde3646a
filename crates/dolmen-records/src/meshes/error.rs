//! Why a mesh cannot be read.

use crate::limits::LimitError;
use crate::quoted::shown;

/// Why the bytes of a file are no mesh. Lines are counted from 1, as editors do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// None of the formats.
    #[error("the file is no OBJ, STL or PLY: none of them begins like this; export the mesh as one of these")]
    Unknown,
    /// No faces.
    #[error("the file holds {vertices} vertices but no faces: export a mesh, not a cloud of points")]
    NoFaces {
        /// How many vertices it holds.
        vertices: usize,
    },
    /// A word where a number should be.
    #[error(
        "line {line}: \"{text}\" is not a finite number",
        text = shown(text)
    )]
    Number {
        /// The line.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A line that breaks the format.
    #[error("line {line}: {what}")]
    Line {
        /// The line.
        line: usize,
        /// What is wrong.
        what: &'static str,
    },
    /// A face that names a vertex which is not there.
    #[error("line {line}: a face names vertex {given}, but there are {vertices}")]
    Vertex {
        /// The line, or the number of the face in a binary file.
        line: usize,
        /// The vertex as the file counts it.
        given: i64,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A binary file that ends early, or is longer than it says.
    #[error(
        "the file should have {expected} bytes by its own count, but has {held}: it was cut short or damaged"
    )]
    Length {
        /// How long it should be.
        expected: u64,
        /// How long it is.
        held: usize,
    },
    /// A binary file that ends within an element.
    #[error("byte {offset}: the file ends within {element} {number}: it was cut short")]
    CutShort {
        /// Where the reader stood.
        offset: usize,
        /// What it read.
        element: &'static str,
        /// Which one, from 0.
        number: usize,
    },
    /// A value in a binary file that cannot be.
    #[error("byte {offset}: {what}")]
    Byte {
        /// Where it stands.
        offset: usize,
        /// What is wrong.
        what: &'static str,
    },
    /// The file asks too much of the reader.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// A small file becomes much memory.
    #[error(
        "the file of {bytes} bytes holds a mesh of {held}, but at most {most} are read of it: it is damaged; export it again with triangles"
    )]
    Expands {
        /// Bytes of the file.
        bytes: usize,
        /// Bytes of its vertices and triangles so far.
        held: usize,
        /// The limit.
        most: usize,
    },
}
