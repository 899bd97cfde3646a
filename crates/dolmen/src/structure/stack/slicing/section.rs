//! Horizontal sections of a closed mesh: area, and extent in each direction.

use glam::{DVec2, DVec3};

/// Number of directions, around the full circle, in which the extent is measured.
const DIRECTIONS: usize = 16;

pub(super) struct Body<'a> {
    pub(super) vertices: &'a [DVec3],
    pub(super) triangles: &'a [[usize; 3]],
}

/// Size of a section: the square root of its area, then its extent from the middle in each direction, m.
#[derive(Clone, Debug)]
pub(super) struct Section {
    pub(super) area_m2: f64,
    /// Root of the area and reaches, m.
    pub(super) lengths_m: Vec<f64>,
}

impl Body<'_> {
    /// Lowest and highest point, m.
    pub(super) fn span_m(&self) -> [f64; 2] {
        let used = self.triangles.iter().flatten().map(|&v| self.vertices[v].z);
        used.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
            [low.min(z), high.max(z)]
        })
    }

    /// Largest extent along an axis, m.
    pub(super) fn size_m(&self) -> f64 {
        let used = || self.triangles.iter().flatten().map(|&v| self.vertices[v]);
        let low = used().fold(DVec3::INFINITY, DVec3::min);
        let high = used().fold(DVec3::NEG_INFINITY, DVec3::max);
        (high - low).max_element()
    }

    /// Triangles within a range of heights.
    pub(super) fn between(&self, low_m: f64, high_m: f64) -> Vec<[usize; 3]> {
        let reaches = |t: &&[usize; 3]| {
            let z = t.map(|v| self.vertices[v].z);
            z.iter().any(|&z| z >= low_m) && z.iter().any(|&z| z <= high_m)
        };
        self.triangles.iter().filter(reaches).copied().collect()
    }

    /// The section at a height; its outline is counterclockwise seen from above.
    ///
    /// ```text
    /// A = ½ Σ (p × q)z      over the segments p → q of the outline
    /// h(d) = max d·p        for each direction d
    /// ```
    pub(super) fn section(&self, height_m: f64, middle: DVec2) -> Section {
        let mut area_m2 = 0.0;
        let mut reaches = [f64::NEG_INFINITY; DIRECTIONS];
        let directions: Vec<DVec2> = (0..DIRECTIONS)
            .map(|n| DVec2::from_angle(std::f64::consts::TAU * n as f64 / DIRECTIONS as f64))
            .collect();
        for triangle in self.triangles {
            let corners = triangle.map(|v| self.vertices[v]);
            let is_above = corners.map(|corner| corner.z >= height_m);
            if is_above == [true; 3] || is_above == [false; 3] {
                continue;
            }
            let (mut up, mut down) = (DVec2::ZERO, DVec2::ZERO);
            for edge in 0..3 {
                let (a, b) = (edge, (edge + 1) % 3);
                if is_above[a] == is_above[b] {
                    continue;
                }
                let (p, q) = (corners[a], corners[b]);
                let at = (p.lerp(q, (height_m - p.z) / (q.z - p.z))).truncate() - middle;
                match is_above[b] {
                    true => up = at,
                    false => down = at,
                }
                for (reach, direction) in reaches.iter_mut().zip(&directions) {
                    *reach = reach.max(direction.dot(at));
                }
            }
            // where the surface goes up, the outside is to the right: from the falling to the rising edge
            area_m2 += 0.5 * down.perp_dot(up);
        }
        let reaches = reaches.map(|reach| if reach.is_finite() { reach } else { 0.0 });
        let mut lengths_m = vec![area_m2.max(0.0).sqrt()];
        lengths_m.extend(reaches);
        Section { area_m2, lengths_m }
    }
}
