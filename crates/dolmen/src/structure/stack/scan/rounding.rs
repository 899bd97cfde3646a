//! Finds the end of the flat part of a face before a rounded edge: only the flat part of a bed carries load.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | x | `inside` | distance inwards from the line where the planes of two adjacent faces intersect, m |
//! | h | `depth` | depth of a vertex below the plane of the face, m |
//! | x_f | `flat_end` | end of the flat part, m |

use super::plane::Plane;
use super::surface::Surface;
use glam::DVec3;

/// Part of an edge that is used, as fractions of its length: near its ends the adjacent edges are also rounded.
const ALONG: [f64; 2] = [0.2, 0.8];
/// Cosine of 50°, the angle between the normals of a vertex and of the face above which the vertex belongs to another face.
const OWN_LEAST: f64 = 0.643;
/// Radius of an arc, divided by its length along the face up to that angle.
const RADIUS: f64 = 1.305;
/// Number of trial values for the end of the flat part.
const TRIED: usize = 80;
/// Fewest vertices of an edge, outside and inside the flat part. The cap of a cut has no vertices inside, and its edge is sharp.
const VERTICES_LEAST: [usize; 2] = [4, 12];
/// Least improvement of the fit by a rounded instead of a sharp edge: the F value of one additional parameter, with [`TRIED`] trial values.
const BETTER_LEAST: f64 = 25.0;
/// Trial values whose sum of squares exceeds the best by at most this multiple of its mean square count as equally good. The innermost of them is
/// used, so that a rounding with few vertices is not underestimated.
const AS_GOOD: f64 = 1.0;
pub(super) struct Edge {
    pub(super) face: Plane,
    /// Outward normal of the adjacent face.
    pub(super) beyond: DVec3,
    pub(super) ends: [DVec3; 2],
    /// Distance from the edge to the far side of the face, m.
    pub(super) across_m: f64,
}

/// The plane through the end of the flat part of a face, inclined halfway towards the adjacent face, if the flat part ends more than `least_m` before
/// the edge.
pub(super) fn chamfer(surface: &Surface, edge: &Edge, least_m: f64, noise_m: f64) -> Option<Plane> {
    let [from, to] = edge.ends;
    let along = (to - from).normalize_or_zero();
    let across = along.cross(edge.face.normal);
    let toward = across * across.dot(edge.beyond).signum();
    let most_m = 0.4 * edge.across_m;
    let mut depths = depths(surface, edge, toward, (most_m, noise_m));
    // from the outermost vertex: the adjacent face may be a piece fitted to the rounded edge
    let outermost_m = depths.iter().map(|d| d[0]).fold(f64::INFINITY, f64::min);
    depths.iter_mut().for_each(|d| d[0] -= outermost_m);
    let flat_m = flat_end_m(&depths, most_m - outermost_m)? + outermost_m;
    let normal = (edge.face.normal + edge.beyond).normalize_or_zero();
    (flat_m > least_m && normal != DVec3::ZERO).then(|| Plane {
        normal,
        offset_m: normal.dot(from - toward * flat_m),
    })
}

/// Distance from the edge, and depth, of the vertices of one face near that edge.
fn depths(surface: &Surface, edge: &Edge, toward: DVec3, (most_m, noise_m): (f64, f64)) -> Vec<[f64; 2]> {
    let [from, to] = edge.ends;
    let along = (to - from).normalize_or_zero();
    let length = from.distance(to);
    let of = |(vertex, normal): (&DVec3, &DVec3)| {
        let share = (*vertex - from).dot(along) / length;
        let (inside, depth) = ((from - *vertex).dot(toward), -edge.face.height_m(*vertex));
        let is_near = (ALONG[0]..=ALONG[1]).contains(&share)
            && inside.abs() <= most_m
            && normal.dot(edge.face.normal) >= OWN_LEAST
            && depth <= most_m
            && depth >= -4.0 * noise_m.max(1e-6 * length);
        is_near.then_some([inside, depth])
    };
    surface
        .vertices
        .iter()
        .zip(&surface.normals)
        .filter_map(of)
        .collect()
}

/// The end of the flat part, by least squares; `None` for a sharp edge or too few vertices.
///
/// ```text
/// h = h_0 + c [r - √(r² - (x_f - x)²)] for x < x_f, h_0 beyond,   r = x_f / sin 50°
/// ```
fn flat_end_m(depths: &[[f64; 2]], most_m: f64) -> Option<f64> {
    let count = depths.len();
    if count < VERTICES_LEAST[0] + VERTICES_LEAST[1] {
        return None;
    }
    let n = count as f64;
    let mean = depths.iter().map(|d| d[1]).sum::<f64>() / n;
    let sharp: f64 = depths.iter().map(|d| (d[1] - mean).powi(2)).sum();
    let mut tried: Vec<(f64, f64)> = Vec::with_capacity(TRIED);
    for number in 1..TRIED {
        let flat_end = most_m * number as f64 / TRIED as f64;
        let arc = |d: &[f64; 2]| {
            let (u, radius) = ((flat_end - d[0]).max(0.0), RADIUS * flat_end);
            radius - (radius * radius - u * u).max(0.0).sqrt()
        };
        let rounded = depths.iter().filter(|d| d[0] < flat_end).count();
        if rounded < VERTICES_LEAST[0] || count - rounded < VERTICES_LEAST[1] {
            continue;
        }
        let mean_arc = depths.iter().map(arc).sum::<f64>() / n;
        let (mut gg, mut gh) = (0.0, 0.0);
        for d in depths {
            let g = arc(d) - mean_arc;
            gg += g * g;
            gh += g * (d[1] - mean);
        }
        if gg > 0.0 && gh > 0.0 {
            tried.push((sharp - gh * gh / gg, flat_end));
        }
    }
    let least = tried
        .iter()
        .map(|(left, _)| left.max(0.0))
        .fold(f64::INFINITY, f64::min);
    if !least.is_finite() || sharp - least <= BETTER_LEAST * least / (n - 3.0) {
        return None;
    }
    let as_good = least + AS_GOOD * (least / (n - 3.0)).max(1e-12 * sharp);
    let alike = tried.iter().filter(|(left, _)| *left <= as_good);
    alike.map(|(_, flat_end)| *flat_end).reduce(f64::max)
}
