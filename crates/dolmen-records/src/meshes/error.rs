//! Why a mesh cannot be read.

use crate::limits::LimitError;
use dolmen_words::message::Both;

/// Why the bytes of a file are not a mesh. Lines are counted from 1, as editors do.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshError {
    /// The file has none of the supported formats.
    Unknown,
    /// A cloud of points, which has no surface.
    PointCloud {
        /// Its format.
        format: &'static str,
    },
    /// A mesh without faces.
    NoFaces {
        /// Number of vertices.
        vertices: usize,
    },
    /// A word in place of a number.
    Number {
        /// The line.
        line: usize,
        /// The content found there.
        text: String,
    },
    /// A line that breaks the format.
    Line {
        /// The line.
        line: usize,
        /// The fault.
        what: Both,
    },
    /// A face with a vertex that does not exist.
    Vertex {
        /// The line, or the number of the face in a binary file.
        line: usize,
        /// The vertex in the file's numbering.
        given: i64,
        /// Number of vertices.
        vertices: usize,
    },
    /// A binary file that is shorter or longer than its header states.
    Length {
        /// Expected length.
        expected: u64,
        /// Actual length.
        held: usize,
    },
    /// A binary file that ends within an element.
    CutShort {
        /// Position of the reader.
        offset: usize,
        /// The unsupported element.
        element: Both,
        /// Number of the element, from 0.
        number: usize,
    },
    /// An invalid value in a binary file.
    Byte {
        /// Position of the value.
        offset: usize,
        /// The fault.
        what: Both,
    },
    /// The file exceeds a limit of the reader.
    Limit(LimitError),
    /// More triangles than can be cut in reasonable time.
    Triangles {
        /// Number of triangles.
        found: usize,
        /// The limit.
        most: usize,
    },
    /// A small file would need much memory.
    Expands {
        /// Bytes of the file.
        bytes: usize,
        /// Bytes of its vertices and triangles so far.
        held: usize,
        /// The limit.
        most: usize,
    },
}
