//! Options and results of cutting a scan.

use crate::opened::Opened;
use dolmen::structure::stack::Sliced;
use serde::Serialize;

/// Unit of a file of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum ScanUnit {
    /// Metres.
    #[serde(rename = "m")]
    Metres,
    /// Centimetres.
    #[serde(rename = "cm")]
    Centimetres,
    /// Millimetres.
    #[serde(rename = "mm")]
    Millimetres,
}

impl ScanUnit {
    /// "mm".
    pub fn symbol(self) -> &'static str {
        match self {
            ScanUnit::Metres => "m",
            ScanUnit::Centimetres => "cm",
            ScanUnit::Millimetres => "mm",
        }
    }

    /// Length of the unit in metres.
    pub(super) fn metres(self) -> f64 {
        match self {
            ScanUnit::Metres => 1.0,
            ScanUnit::Centimetres => 0.01,
            ScanUnit::Millimetres => 0.001,
        }
    }
}

/// A scan and its cuts.
#[derive(Clone, Debug)]
pub struct ScanRequest<'a> {
    /// Name of its file.
    pub file: String,
    /// OBJ, STL or PLY.
    pub bytes: &'a [u8],
    /// Heights of the beds in the coordinates of the file, m, lowest first.
    pub beds_m: Vec<f64>,
    /// Heights in the coordinates of the file at which the section steps within one stone, m.
    pub allowed_steps_m: Vec<f64>,
    /// Unit of the file; `None` to recognise metres or millimetres.
    pub unit: Option<ScanUnit>,
}

/// A stone of the project.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScannedStone {
    /// Its name in the project.
    pub name: String,
    /// The file of its mesh.
    pub file: String,
    /// Its volume, m³.
    pub volume_m3: f64,
    /// Triangles of its mesh.
    pub triangles: usize,
}

/// The stones of a scan and their project.
#[derive(Clone, Debug)]
pub struct ScanAnswer {
    /// Name of the file.
    pub file: String,
    /// The unit used.
    pub unit: ScanUnit,
    /// Whether the unit was recognised from the height of the mesh.
    pub is_unit_recognised: bool,
    /// Height of the mesh in the unit of the file.
    pub height_in_file: f64,
    /// Displacement of the stones, m: the ground to 0, and a distant origin to the middle.
    pub moved_m: [f64; 3],
    /// The cuts.
    pub sliced: Sliced,
    /// The stones, lowest first.
    pub stones: Vec<ScannedStone>,
    /// Meshes by their file names, then the project file.
    pub files: Vec<(String, Vec<u8>)>,
    /// The project, parsed from its file.
    pub opened: Opened,
}
