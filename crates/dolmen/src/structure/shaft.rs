//! Linearly tapered shafts of stone.

/// A rectangular section.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Section {
    /// Size in the direction of motion, m.
    pub depth_m: f64,
    /// Size across the motion, m.
    pub breadth_m: f64,
}

/// A shaft whose depth and breadth change linearly from its foot to its top.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Shaft {
    /// Length, m.
    pub length_m: f64,
    /// Section at the foot.
    pub foot: Section,
    /// Section at the top; size 0 is a point or an edge.
    pub top: Section,
}

/// Elastic constants and density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stone {
    /// E, Young's modulus, Pa.
    pub elastic_modulus_pa: f64,
    /// ν, Poisson's ratio.
    pub poisson_ratio: f64,
    /// ρ, density, kg/m³.
    pub density_kg_m3: f64,
}

impl Shaft {
    /// Section at a fraction of the length.
    pub(super) fn section(&self, share: f64) -> Section {
        let at = |foot: f64, top: f64| foot + share * (top - foot);
        Section {
            depth_m: at(self.foot.depth_m, self.top.depth_m),
            breadth_m: at(self.foot.breadth_m, self.top.breadth_m),
        }
    }

    /// Simpson's rule, exact for an area that is quadratic in height.
    pub(super) fn volume_m3(&self) -> f64 {
        let area = |share: f64| {
            let section = self.section(share);
            section.depth_m * section.breadth_m
        };
        self.length_m * (area(0.0) + 4.0 * area(0.5) + area(1.0)) / 6.0
    }
}

/// Ratio top/foot of a shaft from the relative height of its centre of mass; `None` if no taper has it.
pub(super) fn taper(centroid: f64) -> Option<f64> {
    if !(0.25..0.75).contains(&centroid) {
        return None;
    }
    let (a, b, c) = (3.0 - 4.0 * centroid, 2.0 - 4.0 * centroid, 1.0 - 4.0 * centroid);
    Some((-b + (b * b - 4.0 * a * c).sqrt()) / (2.0 * a))
}
