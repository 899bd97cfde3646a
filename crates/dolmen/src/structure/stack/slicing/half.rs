//! The part of a closed mesh on one side of a level plane, closed by a cap.

use super::SliceError;
use super::cap::{Outline, triangles_of};
use super::section::Body;
use glam::DVec3;
use std::collections::BTreeMap;

/// Distance from the plane, relative to the size of the mesh, within which a vertex is in the plane.
const IN_PLANE: f64 = 1e-10;
/// Largest number of corners of a section. Our choice: the time for the cap grows with its square.
const CORNERS_MOST: usize = 20_000;

/// The side that remains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Below,
    Above,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    /// Height of the cut through the mesh, m.
    pub(super) cut_m: f64,
    pub(super) at_m: f64,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    pub(super) vertices: Vec<DVec3>,
    pub(super) triangles: Vec<[usize; 3]>,
}

impl Part {
    pub(super) fn body(&self) -> Body<'_> {
        Body {
            vertices: &self.vertices,
            triangles: &self.triangles,
        }
    }
}

/// The part of a body on one side of a plane, closed by a cap in the plane.
///
/// # Errors
/// [`SliceError`] for a section that no cap closes.
pub(super) fn half(body: &Body<'_>, side: Side, plane: Plane, size_m: f64) -> Result<Part, SliceError> {
    let mut cutting = Cutting::new(body, side, plane, IN_PLANE * size_m);
    for &triangle in body.triangles {
        cutting.keep(triangle);
    }
    let mut part = Part {
        vertices: cutting.vertices,
        triangles: cutting.triangles,
    };
    let rims = rims(&part.triangles).ok_or(SliceError::Crossed { bed_m: plane.at_m })?;
    for rim in rims {
        // a rim follows the direction of the kept triangles; its cap has the opposite direction
        let corners: Vec<usize> = match side {
            Side::Below => rim.into_iter().rev().collect(),
            Side::Above => rim,
        };
        if corners.len() > CORNERS_MOST {
            return Err(SliceError::Corners {
                bed_m: plane.at_m,
                given: corners.len(),
                most: CORNERS_MOST,
            });
        }
        let outline: Vec<_> = corners.iter().map(|&v| part.vertices[v].truncate()).collect();
        match triangles_of(&outline) {
            Outline::Turned { area_m2 } => {
                return Err(SliceError::Hollow {
                    bed_m: plane.at_m,
                    area_m2,
                });
            }
            Outline::Crossed => return Err(SliceError::Crossed { bed_m: plane.at_m }),
            Outline::Closed(cap) => part.triangles.extend(cap.into_iter().map(|triangle| {
                let [a, b, c] = triangle.map(|corner| corners[corner]);
                match side {
                    Side::Below => [a, b, c],
                    Side::Above => [a, c, b],
                }
            })),
        }
    }
    Ok(part)
}

/// The triangles kept so far.
struct Cutting<'a> {
    body: &'a Body<'a>,
    side: Side,
    plane: Plane,
    in_plane_m: f64,
    vertices: Vec<DVec3>,
    triangles: Vec<[usize; 3]>,
    kept: BTreeMap<usize, usize>,
    crossed: BTreeMap<[usize; 2], usize>,
}

impl<'a> Cutting<'a> {
    fn new(body: &'a Body<'a>, side: Side, plane: Plane, in_plane_m: f64) -> Self {
        Cutting {
            body,
            side,
            plane,
            in_plane_m,
            vertices: Vec::new(),
            triangles: Vec::new(),
            kept: BTreeMap::new(),
            crossed: BTreeMap::new(),
        }
    }

    /// A vertex in the plane is above it, for both sides.
    fn is_kept(&self, vertex: usize) -> bool {
        let is_above = self.body.vertices[vertex].z >= self.plane.cut_m - self.in_plane_m;
        is_above == (self.side == Side::Above)
    }

    fn push(&mut self, place: DVec3) -> usize {
        self.vertices.push(place);
        self.vertices.len() - 1
    }

    fn vertex(&mut self, old: usize) -> usize {
        if let Some(&new) = self.kept.get(&old) {
            return new;
        }
        let mut place = self.body.vertices[old];
        if (place.z - self.plane.cut_m).abs() <= self.in_plane_m {
            place.z = self.plane.at_m;
        }
        let new = self.push(place);
        self.kept.insert(old, new);
        new
    }

    /// Intersection of the plane with an edge from a kept to another vertex: a vertex in the plane, or a new
    /// one.
    fn crossing(&mut self, kept: usize, beyond: usize) -> usize {
        let [p, q] = [kept, beyond].map(|vertex| self.body.vertices[vertex]);
        let at_end = [kept, beyond]
            .into_iter()
            .find(|&end| (self.body.vertices[end].z - self.plane.cut_m).abs() <= self.in_plane_m);
        if let Some(end) = at_end {
            return self.vertex(end);
        }
        let key = [kept.min(beyond), kept.max(beyond)];
        if let Some(&new) = self.crossed.get(&key) {
            return new;
        }
        let mut place = p.lerp(q, (self.plane.cut_m - p.z) / (q.z - p.z));
        place.z = self.plane.at_m;
        let new = self.push(place);
        self.crossed.insert(key, new);
        new
    }

    /// Keeps the part of a triangle on this side.
    fn keep(&mut self, triangle: [usize; 3]) {
        let mut corners: Vec<usize> = Vec::with_capacity(4);
        for edge in 0..3 {
            let (from, to) = (triangle[edge], triangle[(edge + 1) % 3]);
            let (from_kept, to_kept) = (self.is_kept(from), self.is_kept(to));
            if from_kept {
                corners.push(self.vertex(from));
            }
            match (from_kept, to_kept) {
                (true, false) => corners.push(self.crossing(from, to)),
                (false, true) => corners.push(self.crossing(to, from)),
                (true, true) | (false, false) => {}
            }
        }
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        for pair in corners.get(1..).unwrap_or_default().windows(2) {
            self.triangles.push([corners[0], pair[0], pair[1]]);
        }
    }
}

/// The closed lines along which triangles have no neighbour; `None` if two of them meet at a vertex.
fn rims(triangles: &[[usize; 3]]) -> Option<Vec<Vec<usize>>> {
    let mut sides: BTreeMap<[usize; 2], i32> = BTreeMap::new();
    for triangle in triangles {
        for edge in 0..3 {
            let (from, to) = (triangle[edge], triangle[(edge + 1) % 3]);
            *sides.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
        }
    }
    let mut next: BTreeMap<usize, usize> = BTreeMap::new();
    for ([low, high], count) in sides {
        let (from, to) = match count {
            0 => continue,
            1 => (low, high),
            -1 => (high, low),
            _ => return None,
        };
        if next.insert(from, to).is_some() {
            return None;
        }
    }
    let mut rims = Vec::new();
    while let Some((&first, _)) = next.first_key_value() {
        let (mut rim, mut at) = (Vec::new(), first);
        while let Some(to) = next.remove(&at) {
            rim.push(at);
            at = to;
        }
        if at != first {
            return None;
        }
        rims.push(rim);
    }
    Some(rims)
}
