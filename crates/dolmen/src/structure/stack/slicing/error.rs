//! Why a scan cannot be cut into stones.

use crate::structure::stack::StackError;

/// Why a scan cannot be cut at given heights. Each variant contains the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SliceError {
    /// The mesh does not enclose a body.
    #[error(transparent)]
    Mesh(#[from] StackError),
    /// No height is given.
    #[error("no bed is given, but a tower has at least 1 between its stones: give the height of each")]
    NoBeds,
    /// A height is not a number.
    #[error("a bed is at {given}, but must be a finite height in m")]
    NotFinite {
        /// The given height.
        given: f64,
    },
    /// The heights do not ascend.
    #[error("the bed at {then_m} m comes after that at {first_m} m: give each once, lowest first")]
    Unsorted {
        /// The earlier height, m.
        first_m: f64,
        /// The next height, which is not above the earlier one, m.
        then_m: f64,
    },
    /// A height is outside the scan.
    #[error(
        "the bed at {bed_m} m lies outside of the scan, which reaches from {low_m:.4} to {high_m:.4} m: give heights in m, in the coordinates of the file, whose z axis must point up"
    )]
    Outside {
        /// The height, m.
        bed_m: f64,
        /// Lowest point of the scan, m.
        low_m: f64,
        /// Highest point of the scan, m.
        high_m: f64,
    },
    /// A stone would be no thicker than the error of a measured height.
    #[error(
        "the stone from {low_m:.4} to {high_m:.4} m is {:.1} mm thick, but must be at least {:.0} mm: take one of its beds out",
        1e3 * (high_m - low_m), 1e3 * least_m
    )]
    Thin {
        /// Its lower end, m.
        low_m: f64,
        /// Its upper end, m.
        high_m: f64,
        /// The least thickness, m.
        least_m: f64,
    },
    /// There is air at a height.
    #[error("there is no stone at {bed_m} m, where a bed is given: correct its height")]
    Air {
        /// The height, m.
        bed_m: f64,
    },
    /// A section has a hole.
    #[error(
        "the section at {bed_m} m has a hole of {area_m2:.4} m²: a bed round a hollow is not cut; fill the hollow of the mesh, or give the stones as points"
    )]
    Hollow {
        /// The height, m.
        bed_m: f64,
        /// Area of the hole, m².
        area_m2: f64,
    },
    /// The outline of a section crosses or touches itself.
    #[error(
        "the outline of the section at {bed_m} m crosses or touches itself: move the bed by some mm, or mend the mesh there"
    )]
    Crossed {
        /// The height, m.
        bed_m: f64,
    },
    /// A section has too many corners.
    #[error(
        "the section at {bed_m} m has {given} corners, but at most {most} are cut: make the mesh coarser (edges of 5 to 50 mm do)"
    )]
    Corners {
        /// The height, m.
        bed_m: f64,
        /// Number of corners.
        given: usize,
        /// Allowed number of corners.
        most: usize,
    },
    /// The mesh contains a closed surface inside the stone, or a surface that is inside out.
    #[error(
        "a closed piece of the mesh has its outside inside, {:.6} m³: take surfaces out that lie in the stone, or turn their triangles over",
        volume_m3.abs()
    )]
    Void {
        /// Volume of this surface, m³; negative.
        volume_m3: f64,
    },
    /// The volumes of the stones do not add up to that of the scan.
    #[error(
        "the stones hold {:.2} % of the scan's {whole_m3:.5} m³, but must hold 100 ± {:.1} %: near a bed the scan is too rough to be cut, or passes through itself",
        100.0 * ratio, 100.0 * allowed
    )]
    Volume {
        /// Volume of the stones over that of the scan.
        ratio: f64,
        /// Volume of the scan, m³.
        whole_m3: f64,
        /// Allowed deviation from 1.
        allowed: f64,
    },
}
