//! Merges the triangles of a convex hull into plane faces. A face may include triangles that leave its plane only because corners are rounded.

use super::scan::Plane;
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Cosine of the largest angle between a face with rounded corners and a triangle that joins it. Chamfers are steeper and remain separate faces.
const ALIGNED_LEAST: f64 = 0.5;
/// Largest height of a corner above the current plane, in tolerances, for a new fit that includes this corner. The fourth corner of a
/// parallelogram can be this far off, because its error is the sum of the rounding of the other three. Our choice.
const REACH: f64 = 4.0;

/// Merges triangles of one plane into faces; `None` if the edges of a face do not form a single loop.
pub(super) fn merged(
    points: &[DVec3],
    triangles: &[[usize; 3]],
    flat: f64,
    exact: f64,
) -> Option<Vec<Vec<usize>>> {
    let group = groups(points, triangles, flat, exact);
    let mut met: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for (triangle, &group) in triangles.iter().zip(&group) {
        for &corner in triangle {
            met.entry(corner).or_default().insert(group);
        }
    }
    let count = group.iter().max()? + 1;
    let mut borders: Vec<BTreeMap<usize, usize>> = vec![BTreeMap::new(); count];
    let owner = edge_owners(triangles);
    let mut edges = vec![0; count];
    for (triangle, &own) in triangles.iter().zip(&group) {
        for edge in 0..3 {
            let (from, to) = (triangle[edge], triangle[(edge + 1) % 3]);
            if group[*owner.get(&(to, from))?] != own {
                borders[own].insert(from, to);
                edges[own] += 1;
            }
        }
    }
    let mut faces = Vec::with_capacity(count);
    for (border, edges) in borders.iter().zip(edges) {
        let (&start, _) = border.first_key_value()?;
        let (mut face, mut at, mut length) = (Vec::new(), start, 0);
        loop {
            if met[&at].len() >= 3 {
                face.push(at); // where only two faces meet, the corner lies inside an edge and is left out
            }
            at = *border.get(&at)?;
            length += 1;
            if at == start || length > edges {
                break;
            }
        }
        if length != edges || face.len() < 3 {
            return None;
        }
        faces.push(face);
    }
    Some(faces)
}

/// The triangle to the left of each directed edge.
pub(super) fn edge_owners(triangles: &[[usize; 3]]) -> BTreeMap<(usize, usize), usize> {
    let edges = triangles.iter().enumerate().flat_map(|(number, triangle)| {
        (0..3).map(move |edge| ((triangle[edge], triangle[(edge + 1) % 3]), number))
    });
    edges.collect()
}

/// The face of each triangle. Faces grow from their largest triangle.
fn groups(points: &[DVec3], triangles: &[[usize; 3]], flat: f64, exact: f64) -> Vec<usize> {
    let normal = |t: &[usize; 3]| (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    let normals: Vec<DVec3> = triangles.iter().map(normal).collect();
    let mut by_area: Vec<usize> = (0..triangles.len()).collect();
    by_area.sort_by(|&a, &b| {
        normals[b]
            .length()
            .total_cmp(&normals[a].length())
            .then(a.cmp(&b))
    });
    let owner = edge_owners(triangles);
    let mut group = vec![usize::MAX; triangles.len()];
    let mut count = 0;
    for seed in by_area {
        if group[seed] != usize::MAX {
            continue;
        }
        group[seed] = count;
        let mut face = Face::of(points, triangles[seed], normals[seed], flat, exact);
        let (mut own, mut at, mut plane_moved) = (vec![seed], 0, false);
        loop {
            while at < own.len() {
                let triangle = own[at];
                at += 1;
                for edge in 0..3 {
                    let [from, to] = [0, 1].map(|i| triangles[triangle][(edge + i) % 3]);
                    let Some(&beyond) = owner.get(&(to, from)) else {
                        continue;
                    };
                    if group[beyond] == usize::MAX
                        && let Some(moved) = face.takes(triangles[beyond], normals[beyond])
                    {
                        group[beyond] = count;
                        own.push(beyond);
                        plane_moved |= moved;
                    }
                }
            }
            if !std::mem::take(&mut plane_moved) {
                break;
            }
            at = 0; // the plane has moved: try the rejected neighbours again
        }
        count += 1;
    }
    group
}

/// A face that grows triangle by triangle.
struct Face<'a> {
    points: &'a [DVec3],
    corners: BTreeSet<usize>,
    plane: Plane,
    flat: f64,
    exact: f64,
}

impl<'a> Face<'a> {
    fn of(points: &'a [DVec3], triangle: [usize; 3], normal: DVec3, flat: f64, exact: f64) -> Self {
        let normal = normal.normalize_or_zero();
        let plane = Plane {
            normal,
            offset_m: normal.dot(points[triangle[0]]),
        };
        Face {
            points,
            corners: triangle.into(),
            plane,
            flat,
            exact,
        }
    }

    /// Adds a triangle if its corners and all others fit one plane. Returns whether the plane moved; `None` if the triangle does not fit.
    fn takes(&mut self, triangle: [usize; 3], normal: DVec3) -> Option<bool> {
        let height = |plane: &Plane, i: usize| plane.height_m(self.points[i]).abs();
        let farthest = triangle
            .map(|i| height(&self.plane, i))
            .into_iter()
            .fold(0.0, f64::max);
        let aligned = self.plane.normal.dot(normal);
        let least = if farthest <= self.exact {
            0.0
        } else {
            ALIGNED_LEAST * normal.length()
        };
        if farthest > REACH * self.flat || aligned < least {
            return None;
        }
        let moved = farthest > self.flat;
        if moved {
            let all = || self.corners.iter().copied().chain(triangle);
            let plane = Plane::weighted(|| all().map(|i| (1.0, self.points[i])), self.plane.normal)?;
            if all().any(|i| height(&plane, i) > self.flat) {
                return None;
            }
            self.plane = plane;
        }
        self.corners.extend(triangle);
        Some(moved)
    }
}
