//! Errors of cutting a scan.

use dolmen::structure::stack::SliceError;
use dolmen_records::meshes::MeshError;
use dolmen_words::sentences;

/// Why a scan gives no stones.
#[derive(Clone, Debug, PartialEq)]
pub enum ScanError {
    /// The file is no mesh.
    Mesh(MeshError),
    /// The mesh cannot be cut.
    Slice(SliceError),
    /// Metres and millimetres are both possible.
    UnitUnclear {
        /// Height of the mesh in the unit of its file.
        height: f64,
    },
    /// No tower has this height.
    Height {
        /// Height of the mesh, m.
        height_m: f64,
        /// The given unit.
        unit: &'static str,
        /// Least height, m.
        least_m: f64,
        /// Greatest height, m.
        most_m: f64,
    },
}

sentences! {
    ScanError in "scan.error" {
        UnitUnclear { height } as { height: format!("{height:.3}") } => {
            en: "the mesh is {height} high in the unit of its file, which names none: say with --unit whether that is \"m\", \"cm\" or \"mm\"",
            ko: "메시의 높이가 {height}인데 파일에 단위가 없다. --unit으로 \"m\", \"cm\", \"mm\" 중 하나를 지정한다",
        },
        Height { height_m, unit, least_m, most_m } as { height_m: format!("{height_m:.4}"), unit, least_m, most_m } => {
            en: "the mesh is {height_m} m high if its file is in {unit}, but must be {least_m} to {most_m} m: correct --unit",
            ko: "파일의 단위가 {unit}이면 메시의 높이가 {height_m} m인데 {least_m}~{most_m} m이어야 한다. --unit을 고친다",
        },
    }
    handed on { Mesh(MeshError), Slice(SliceError) }
}
