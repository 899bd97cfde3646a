//! A closed triangle mesh: neighbours of its triangles, noise of its vertices, smoothed normals.

use glam::DVec3;

/// Angle between adjacent triangles below which a mesh has no modelled edge, rad: 3°, a cylinder of 120 sides. Our choice.
const TURN_MODELLED_RAD: f64 = 0.052;
/// The same for triangles that may be part of a bed, rad: 8°. Adjacent triangles on the side of a drum may differ by less, but those of a modelled
/// bed do not differ. Our choice.
const TURN_BED_RAD: f64 = 0.14;
/// Least vertical component of the unit normal of a triangle that may be part of a bed: a slope of 20°.
const BED_RISE: f64 = 0.94;
/// Median of the absolute value of a normal variable over its standard deviation.
const MEDIAN_OF_NORMAL: f64 = 0.6745;

pub(super) struct Surface {
    pub(super) vertices: Vec<DVec3>,
    pub(super) triangles: Vec<[usize; 3]>,
    /// The adjacent triangle at the edge from corner i to the next.
    pub(super) across: Vec<[usize; 3]>,
    /// Normals of triangles; their length is the area, m².
    pub(super) areas: Vec<DVec3>,
    /// Unit normals of vertices: mean over the triangles around a vertex and its neighbours, weighted by area. Noise s changes the normal of one
    /// triangle by 2 s/ℓ.
    pub(super) normals: Vec<DVec3>,
    pub(super) edge_m: f64,
}

impl Surface {
    /// The surface of a closed mesh: every edge has two triangles.
    pub(super) fn new(vertices_m: &[[f64; 3]], triangles: &[[usize; 3]]) -> Self {
        let vertices: Vec<DVec3> = vertices_m.iter().copied().map(DVec3::from).collect();
        let mut sides: Vec<([usize; 2], usize, usize)> = Vec::with_capacity(3 * triangles.len());
        let mut areas = Vec::with_capacity(triangles.len());
        let mut lengths = Vec::with_capacity(3 * triangles.len());
        for (number, t) in triangles.iter().enumerate() {
            let [a, b, c] = t.map(|corner| vertices[corner]);
            areas.push(0.5 * (b - a).cross(c - a));
            for edge in 0..3 {
                let (from, to) = (t[edge], t[(edge + 1) % 3]);
                sides.push(([from.min(to), from.max(to)], number, edge));
                lengths.push(vertices[from].distance(vertices[to]));
            }
        }
        sides.sort_unstable();
        let mut across = vec![[0; 3]; triangles.len()];
        for pair in sides.chunks_exact(2) {
            across[pair[0].1][pair[0].2] = pair[1].1;
            across[pair[1].1][pair[1].2] = pair[0].1;
        }
        let about = |of: &dyn Fn(usize) -> DVec3| {
            let mut sums = vec![DVec3::ZERO; vertices.len()];
            for (number, t) in triangles.iter().enumerate() {
                for corner in t {
                    sums[*corner] += of(number);
                }
            }
            sums
        };
        let near = about(&|number| areas[number]);
        let normals = about(&|number| triangles[number].iter().map(|corner| near[*corner]).sum());
        Surface {
            normals: normals.into_iter().map(DVec3::normalize_or_zero).collect(),
            vertices,
            triangles: triangles.to_vec(),
            across,
            areas,
            edge_m: median(&mut lengths),
        }
    }

    pub(super) fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|corner| self.vertices[corner])
    }

    pub(super) fn centre(&self, triangle: usize) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        (a + b + c) / 3.0
    }

    /// Whether adjacent triangles either are in one plane or meet at an edge. Small angles between them come only from noise or fine curvature.
    pub(super) fn is_modelled(&self, flat_m: f64) -> bool {
        (0..self.triangles.len()).all(|t| {
            let normal = self.areas[t].normalize_or_zero();
            let on = self.corners(t)[0];
            self.across[t].iter().all(|&beyond| {
                let other = self.areas[beyond].normalize_or_zero();
                let level = normal.z.abs().min(other.z.abs()) > BED_RISE;
                let most = if level { TURN_BED_RAD } else { TURN_MODELLED_RAD };
                let flat = || {
                    let heights = self.corners(beyond).map(|p| normal.dot(p - on).abs());
                    heights.iter().all(|&height| height <= flat_m)
                };
                normal.dot(other) < most.cos() || flat()
            })
        })
    }

    /// Whether two adjacent triangles meet at an angle with a cosine below `smooth`: a mesh without an edge is a ball.
    pub(super) fn has_edge(&self, smooth: f64) -> bool {
        let normals: Vec<DVec3> = self.areas.iter().map(|area| area.normalize_or_zero()).collect();
        let mut sides = self.across.iter().zip(&normals);
        sides.any(|(across, normal)| across.iter().any(|&beyond| normal.dot(normals[beyond]) < smooth))
    }

    /// Standard deviation of the vertices about the surface, m. It comes from the median over the vertices of the distance, along the normal, from
    /// the mean of the neighbours. Curvature within one edge length counts as noise.
    pub(super) fn noise_m(&self) -> f64 {
        let mut sums = vec![(DVec3::ZERO, DVec3::ZERO, 0.0); self.vertices.len()];
        for (t, corners) in self.triangles.iter().enumerate() {
            for edge in 0..3 {
                let sum = &mut sums[corners[edge]];
                sum.0 += self.areas[t];
                sum.1 += self.vertices[corners[(edge + 1) % 3]]; // counts each adjacent vertex once
                sum.2 += 1.0;
            }
        }
        let off = |(v, (normal, neighbours, count)): (&DVec3, &(DVec3, DVec3, f64))| {
            if *count < 3.0 {
                return None;
            }
            let height = normal.normalize_or_zero().dot(*v - *neighbours / *count);
            Some(height.abs() / (1.0 + 1.0 / count).sqrt())
        };
        let mut heights: Vec<f64> = self.vertices.iter().zip(&sums).filter_map(off).collect();
        median(&mut heights) / MEDIAN_OF_NORMAL
    }

    /// For each triangle, the unit normal of the connected area within `radius_m`, and the flatness of that area (length of the sum of its normals
    /// over the sum of their lengths).
    pub(super) fn smoothed(&self, radius_m: f64) -> Vec<(DVec3, f64)> {
        let centres: Vec<DVec3> = (0..self.triangles.len()).map(|t| self.centre(t)).collect();
        let mut seen = vec![usize::MAX; self.triangles.len()];
        let mut reached: Vec<usize> = Vec::new();
        let near = radius_m * radius_m;
        (0..self.triangles.len())
            .map(|seed| {
                reached.clear();
                reached.push(seed);
                seen[seed] = seed;
                let (mut sum, mut total, mut at) = (DVec3::ZERO, 0.0, 0);
                while let Some(&t) = reached.get(at) {
                    at += 1;
                    sum += self.areas[t];
                    total += self.areas[t].length();
                    for &beyond in &self.across[t] {
                        if seen[beyond] != seed && centres[beyond].distance_squared(centres[seed]) <= near {
                            seen[beyond] = seed;
                            reached.push(beyond);
                        }
                    }
                }
                (
                    sum.normalize_or_zero(),
                    sum.length() / total.max(f64::MIN_POSITIVE),
                )
            })
            .collect()
    }
}

/// Standard deviation of the vertices of a closed mesh from its surface, m; 0 for a modelled mesh, whose faces are flat within `flat_m`.
pub(in crate::structure::stack) fn noise_of(
    vertices_m: &[[f64; 3]],
    triangles: &[[usize; 3]],
    flat_m: f64,
) -> f64 {
    let surface = Surface::new(vertices_m, triangles);
    match surface.is_modelled(flat_m) {
        true => 0.0,
        false => surface.noise_m(),
    }
}

/// The median; 0 without values.
pub(super) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    match values.is_empty() {
        true => 0.0,
        false => *values.select_nth_unstable_by(middle, f64::total_cmp).1,
    }
}
