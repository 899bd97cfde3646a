//! The separate closed pieces of a mesh.

use super::SliceError;
use super::half::Part;
use crate::structure::stack::solid::moments_of;
use glam::DVec3;
use std::collections::BTreeMap;

impl Part {
    /// Volume within its triangles, m³.
    pub(super) fn volume_m3(&self) -> f64 {
        let near = self.vertices.first().copied().unwrap_or(DVec3::ZERO);
        let triangles = self.triangles.iter().map(|t| t.map(|v| self.vertices[v]));
        moments_of(triangles, near).0
    }

    /// The connected parts, each with its own vertices; sorted by x, then by y.
    ///
    /// # Errors
    /// [`SliceError::Void`] for a piece that is inside out.
    pub(super) fn pieces(self) -> Result<Vec<Part>, SliceError> {
        let mut owner: Vec<usize> = (0..self.vertices.len()).collect();
        for triangle in &self.triangles {
            let roots = triangle.map(|vertex| root(&mut owner, vertex));
            let least = roots.into_iter().min().unwrap_or_default();
            for of in roots {
                owner[of] = least;
            }
        }
        let mut pieces: BTreeMap<usize, (Part, BTreeMap<usize, usize>)> = BTreeMap::new();
        for triangle in &self.triangles {
            let (part, numbers) = pieces.entry(root(&mut owner, triangle[0])).or_default();
            let own = triangle.map(|vertex| {
                *numbers.entry(vertex).or_insert_with(|| {
                    part.vertices.push(self.vertices[vertex]);
                    part.vertices.len() - 1
                })
            });
            part.triangles.push(own);
        }
        let mut all: Vec<Part> = pieces.into_values().map(|(part, _)| part).collect();
        for part in &all {
            let volume_m3 = part.volume_m3();
            if volume_m3 <= 0.0 {
                return Err(SliceError::Void { volume_m3 });
            }
        }
        let least = |part: &Part| part.vertices.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        all.sort_by(|a, b| {
            let (a, b) = (least(a), least(b));
            a.x.total_cmp(&b.x)
                .then(a.y.total_cmp(&b.y))
                .then(a.z.total_cmp(&b.z))
        });
        Ok(all)
    }
}

/// The root of a vertex; shortens the path to it.
fn root(owner: &mut [usize], mut vertex: usize) -> usize {
    while owner[vertex] != vertex {
        owner[vertex] = owner[owner[vertex]];
        vertex = owner[vertex];
    }
    vertex
}
