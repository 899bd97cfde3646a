//! Where the flat part of a face ends before a rounded edge: a bed carries no farther than it is flat.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | x | `inside` | distance inwards from the line in which the plane of the face meets that of the next, m |
//! | h | `depth` | depth of a vertex under the plane of the face, m |
//! | x_f | `flat_end` | where the flat part ends, m |

use super::plane::Plane;
use super::surface::Surface;
use glam::DVec3;

/// The part of an edge that counts: near its ends other edges are rounded, too.
const ALONG: [f64; 2] = [0.2, 0.8];
/// Cosine of the angle between the normals of a vertex and of the face beyond which it belongs to another face: 50°.
const OWN_LEAST: f64 = 0.643;
/// Radius of an arc over its length along the face up to there.
const RADIUS: f64 = 1.305;
/// Places tried for the end of the flat part.
const TRIED: usize = 80;
/// Vertices that an edge needs, before the end of the flat part and in it: the cap of a cut has none inside, and its edge is sharp.
const VERTICES_LEAST: [usize; 2] = [4, 12];
/// How much better a rounded edge must explain the depths than a sharp one: F of one parameter more, where [`TRIED`] were tried.
const BETTER_LEAST: f64 = 25.0;
/// Ends of the flat part that explain the depths as well as the best one does: by so much more of its mean square. The innermost counts, so that a
/// rounding which few vertices show does not seem smaller than it may be.
const AS_GOOD: f64 = 1.0;
/// An edge of a face.
pub(super) struct Edge {
    pub(super) face: Plane,
    /// Outward normal of the face beyond it.
    pub(super) beyond: DVec3,
    pub(super) ends: [DVec3; 2],
    /// Distance from the edge to the far side of the face, m.
    pub(super) across_m: f64,
}

/// The plane through the end of the flat part of a face, half turned towards the face beyond, if the flat part ends more than `least_m` before the edge.
pub(super) fn chamfer(surface: &Surface, edge: &Edge, least_m: f64, noise_m: f64) -> Option<Plane> {
    let [from, to] = edge.ends;
    let along = (to - from).normalize_or_zero();
    let across = along.cross(edge.face.normal);
    let toward = across * across.dot(edge.beyond).signum();
    let most_m = 0.4 * edge.across_m;
    let mut depths = depths(surface, edge, toward, (most_m, noise_m));
    // from the outermost vertex: the face beyond may be a piece that a rounded edge was fitted by
    let outermost_m = depths.iter().map(|d| d[0]).fold(f64::INFINITY, f64::min);
    depths.iter_mut().for_each(|d| d[0] -= outermost_m);
    let flat_m = flat_end_m(&depths, most_m - outermost_m)? + outermost_m;
    let normal = (edge.face.normal + edge.beyond).normalize_or_zero();
    (flat_m > least_m && normal != DVec3::ZERO).then(|| Plane {
        normal,
        offset_m: normal.dot(from - toward * flat_m),
    })
}

/// Distance from the edge and depth of the vertices of one face near it.
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

/// The end of the flat part, by least squares; `None` of a sharp edge, and of one that too few vertices show.
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
