//! Why a scan cannot be cut into stones.

use crate::structure::stack::StackError;

/// Why a scan cannot be cut at given heights. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SliceError {
    /// The mesh bounds no body.
    #[error("{0}")]
    Mesh(#[from] StackError),
    /// No height is given.
    #[error("no bed is given, but a tower has at least 1 between its stones: give the height of each")]
    NoBeds,
    /// A height that is no number.
    #[error("a bed is at {given}, but must be a finite height in m")]
    NotFinite {
        /// The height.
        given: f64,
    },
    /// Heights that do not rise.
    #[error("the bed at {then_m} m comes after that at {first_m} m: give each once, lowest first")]
    Unsorted {
        /// The one before, m.
        first_m: f64,
        /// The one that is not above it, m.
        then_m: f64,
    },
    /// A height that the scan does not reach.
    #[error(
        "the bed at {bed_m} m lies outside of the scan, which reaches from {low_m:.4} to {high_m:.4} m: give heights in m, in the coordinates of the file"
    )]
    Outside {
        /// The height, m.
        bed_m: f64,
        /// Lowest point of the scan, m.
        low_m: f64,
        /// Highest point, m.
        high_m: f64,
    },
    /// A stone as thin as the slip of a measured height.
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
    /// A height at which there is air.
    #[error("there is no stone at {bed_m} m, where a bed is given: correct its height")]
    Air {
        /// The height, m.
        bed_m: f64,
    },
    /// A section with a hole.
    #[error(
        "the section at {bed_m} m has a hole of {area_m2:.4} m²: a bed round a hollow is not cut; fill the hollow of the mesh, or give the stones as points"
    )]
    Hollow {
        /// The height, m.
        bed_m: f64,
        /// Area of the hole, m².
        area_m2: f64,
    },
    /// A section whose outline crosses or touches itself.
    #[error(
        "the outline of the section at {bed_m} m crosses or touches itself: move the bed by some mm, or mend the mesh there"
    )]
    Crossed {
        /// The height, m.
        bed_m: f64,
    },
    /// A section of too many corners.
    #[error(
        "the section at {bed_m} m has {given} corners, but at most {most} are cut: make the mesh coarser (edges of 5 to 50 mm do)"
    )]
    Corners {
        /// The height, m.
        bed_m: f64,
        /// How many it has.
        given: usize,
        /// How many are allowed.
        most: usize,
    },
    /// A closed surface inside of the mesh, or one turned inside out.
    #[error(
        "a closed piece of the mesh has its outside inside, {:.6} m³: take surfaces out that lie in the stone, or turn their triangles over",
        volume_m3.abs()
    )]
    Void {
        /// Its volume, m³; negative.
        volume_m3: f64,
    },
    /// Stones that do not make the whole.
    #[error(
        "the stones hold {:.2} % of the scan's {whole_m3:.5} m³, but must hold 100 ± {:.1} %: near a bed the scan is too rough to be cut, or passes through itself",
        100.0 * ratio, 100.0 * allowed
    )]
    Volume {
        /// Volume of the stones over that of the whole.
        ratio: f64,
        /// Volume of the whole, m³.
        whole_m3: f64,
        /// How far from 1 it may be.
        allowed: f64,
    },
}
