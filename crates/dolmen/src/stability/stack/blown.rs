//! Wind forces on each block of a stack, by height.

use crate::structure::stack::{Silhouette, Stack, StaticLoad, across, silhouettes};
use crate::structure::wind::WindPressure;

/// Wind data of the blocks of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct WindSurfaces {
    /// Force coefficient of the blocks.
    pub force_coefficient: f64,
    /// For each block, an area that replaces its visible outline; `None` to use the outline.
    pub instead: Vec<Option<WindArea>>,
    /// Additional areas, such as banners: block, height in m, and area.
    pub more: Vec<(usize, f64, WindArea)>,
    /// Height of the ground, m.
    pub ground_m: f64,
}

/// An area perpendicular to the wind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WindArea {
    /// Area, m².
    pub area_m2: f64,
    /// Force coefficient × area, m².
    pub effective_m2: f64,
}

/// Wind force on one block.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BlownBlock {
    /// Index of the block.
    pub block: usize,
    /// Area exposed to the wind, m², including banners and signs.
    pub area_m2: f64,
    /// Fraction of the block's outline that other blocks hide, 0 to 1.
    pub hidden: f64,
    /// Point of application, m.
    pub position_m: [f64; 3],
    /// Force along the wind, N.
    pub force_n: f64,
}

impl BlownBlock {
    /// The wind force times a factor, as a static load in the direction of the wind.
    pub fn load(&self, direction: [f64; 2], factor: f64) -> StaticLoad {
        let [x, y] = direction.map(|part| part * self.force_n * factor);
        StaticLoad {
            block: self.block,
            position_m: self.position_m,
            force_n: [x, y, 0.0],
        }
    }
}

/// Forces of a wind towards `direction`, a unit vector in plan, on each exposed block.
///
/// ```text
/// F = C_f ∫ q(z) b(z) dz over the visible part of the block + Σ C_f A q(z_A) of additional areas, at its centroid
/// ```
///
/// # Limits
/// As for [`silhouettes`]. Uplift of caps, friction along the wind and suction on leeward faces are not included separately: a force
/// coefficient covers the windward and leeward sides together.
pub fn blown_blocks(
    stack: &Stack,
    surfaces: &WindSurfaces,
    pressure: &WindPressure,
    direction: [f64; 2],
) -> Vec<BlownBlock> {
    let seen = silhouettes(stack, direction);
    let each = seen.iter().enumerate().filter_map(|(block, seen)| {
        let centroid = stack.blocks()[block].solid.centroid_m();
        let left = across(direction);
        let own_across = left[0] * centroid[0] + left[1] * centroid[1];
        let mut taken = ForceAndMoments::default();
        let instead = surfaces.instead.get(block).copied().flatten();
        let (area_m2, hidden) = match instead {
            Some(area) => {
                let [low, high] = stack.blocks()[block].solid.bounds_m();
                let (bottom, top) = (low[2] - surfaces.ground_m, high[2] - surfaces.ground_m);
                let strip = pressure.strip(bottom, top);
                let per_m = area.effective_m2 / (top - bottom);
                taken.add(per_m * strip.force_n_m, per_m * strip.moment_n, own_across);
                (area.area_m2, 0.0)
            }
            None => {
                taken.strips(seen, surfaces, pressure);
                (seen.area_m2, 1.0 - seen.area_m2 / seen.own_area_m2)
            }
        };
        let mut area_m2 = area_m2;
        for (_, height_m, area) in surfaces.more.iter().filter(|(of, ..)| *of == block) {
            let force_n = area.effective_m2 * pressure.at_pa(*height_m);
            taken.add(force_n, force_n * height_m, own_across);
            area_m2 += area.area_m2;
        }
        (taken.force > 0.0).then(|| {
            let across_m = taken.across / taken.force;
            let along_m = direction[0] * centroid[0] + direction[1] * centroid[1];
            BlownBlock {
                block,
                area_m2,
                hidden: hidden.max(0.0),
                position_m: [
                    left[0] * across_m + direction[0] * along_m,
                    left[1] * across_m + direction[1] * along_m,
                    taken.up / taken.force + surfaces.ground_m,
                ],
                force_n: taken.force,
            }
        })
    });
    each.collect()
}

#[derive(Default)]
struct ForceAndMoments {
    force: f64,
    up: f64,
    across: f64,
}

impl ForceAndMoments {
    fn add(&mut self, force: f64, moment: f64, across: f64) {
        self.force += force;
        self.up += moment;
        self.across += force * across;
    }

    /// Adds the visible part of a block, integrated over its height. Under uniform pressure its centroid is that of the outline.
    fn strips(&mut self, seen: &Silhouette, surfaces: &WindSurfaces, pressure: &WindPressure) {
        let (mut own, mut middle) = (ForceAndMoments::default(), [0.0; 2]);
        for strip in &seen.strips {
            let (bottom, top) = (
                strip.bottom_m - surfaces.ground_m,
                strip.top_m - surfaces.ground_m,
            );
            let of = pressure.strip(bottom, top);
            let breadth = surfaces.force_coefficient * strip.breadth_m;
            own.add(breadth * of.force_n_m, breadth * of.moment_n, strip.middle_m);
            let area = strip.breadth_m * (top - bottom);
            middle[0] += area * strip.middle_m / seen.area_m2;
            middle[1] += area * 0.5 * (bottom + top) / seen.area_m2;
        }
        if own.force <= 0.0 {
            return;
        }
        let height = seen.centroid_m[1] - surfaces.ground_m;
        self.force += own.force;
        self.up += own.up + own.force * (height - middle[1]);
        self.across += own.across + own.force * (seen.centroid_m[0] - middle[0]);
    }
}
