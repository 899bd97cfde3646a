//! The contact body of a scanned stone: its fitted faces and their intersections instead of the hull of noisy vertices.

use super::curvature;
use super::half_spaces::body;
use super::plane::Plane;
use super::regions::{Region, regions};
use super::rounding::{Edge, chamfer};
use super::surface::Surface;
use crate::structure::stack::{Solid, StackError};
use glam::DVec3;
use std::collections::BTreeSet;

/// Distance within which a vertex lies in a plane, m, at least. Dressed stone is not flatter.
const TOLERANCE_M: f64 = 0.003;
/// As above in a small stone, as a part of its size.
const FLAT_SHARE: f64 = 0.01;
/// As above, in standard deviations of the noise.
const TOLERANCE_NOISE: f64 = 4.0;
/// Largest distance of a face behind the outermost vertex, in standard deviations: the mean effect of noise on an outermost vertex.
const OUTERMOST_NOISE: f64 = 2.0;
/// Rotation of triangle normals by noise below which they are used without smoothing, rad.
const TURN_RAW_RAD: f64 = 0.03;
/// Largest volume of the fitted body over that of the mesh, minus 1: a larger value means a stone that is not convex. Our choice.
const VOLUME_MOST: f64 = 0.02;
/// Number of rounds in which worn edges and corners are cut.
const BEVELS: usize = 8;
/// Least distance between the edge and the end of the flat part, relative to the size of the stone, for a rounded edge. Our choice.
const ROUNDED_LEAST: f64 = 0.004;
/// Cosine of 10°, the largest inclination of a face whose edges are examined: these are the beds of the stone in its position. Our choice.
const LEVEL_LEAST: f64 = 0.985;
const PLANES_MOST: usize = 400;
/// Cosine of 5°: two beds within this angle may touch, so two such faces side by side are one bed, or a bent one.
const ONE_BED: f64 = 0.996_194_7;
/// Fewest vertices of two such faces whose noise averages out, so that the bend between them is real. Our choice.
const BENT_VERTICES_LEAST: usize = 12;
/// A plane with more than this fraction of the hull's corners outside belongs to a re-entrant corner.
const OUTSIDE_MOST: f64 = 0.05;

/// Normals closer than this belong to one plane: 0.06°.
const ONE_PLANE: f64 = 1e-3;

/// A stone bounded by its fitted planes.
pub(crate) struct Fitted {
    /// The body that carries contact.
    pub(crate) solid: Solid,
    /// Triangles in each of its faces.
    pub(crate) triangles: Vec<Vec<usize>>,
    /// Radius of curvature of each of its faces that is part of a curved surface, m.
    pub(crate) radii_m: Vec<Option<f64>>,
    /// Standard deviation of the vertices of faces off their planes, m.
    pub(crate) noise_m: f64,
}

/// The fitted body of a mesh; `None` for a mesh without noise, whose hull is exact.
///
/// # Errors
/// [`StackError::MeshBent`] if the few vertices of a face do not lie in one plane, [`StackError::MeshUneven`] if no planes bound a body with the volume
/// of the mesh.
pub(crate) fn fitted(
    vertices_m: &[[f64; 3]],
    triangles: &[[usize; 3]],
    hull: &Solid,
    volume_m3: f64,
    flat_m: f64,
) -> Result<Option<Fitted>, StackError> {
    let surface = Surface::new(vertices_m, triangles);
    if surface.is_modelled(flat_m) && surface.has_edge(curvature::SMOOTH) && is_merged(hull, flat_m) {
        return Ok(None);
    }
    let noise = surface.noise_m();
    let edge = surface.edge_m;
    let [low, high] = hull.bounds_m().map(DVec3::from);
    let size = (high - low).max_element();
    let smooth = (1.6 * edge).max(5.5 * (noise * edge).sqrt());
    let mut radii = vec![0.0];
    let shows_noise = smooth < 0.25 * size;
    if shows_noise {
        let raw_first = 2.0 * noise < TURN_RAW_RAD * edge;
        radii.insert(usize::from(raw_first), smooth);
    }
    let (mut closest, mut bent): (Option<f64>, Option<Bend>) = (None, None);
    for radius in radii {
        let spread = if radius > 0.0 { noise } else { 0.0 };
        let tolerance = TOLERANCE_M.min(FLAT_SHARE * size).max(TOLERANCE_NOISE * spread);
        let found = regions(&surface, &surface.smoothed(radius), tolerance);
        let faces = outer(found, hull, tolerance);
        if let Some(bend) = torn(&surface, &faces) {
            bent.get_or_insert(bend);
            continue;
        }
        let Some((fit, uncut_m3)) = bounded(&surface, &faces, hull) else {
            continue;
        };
        let off = uncut_m3 / volume_m3 - 1.0;
        if off.abs() <= VOLUME_MOST {
            return Ok(Some(fit));
        }
        if closest.is_none_or(|least| off.abs() < least.abs()) {
            closest = Some(off);
        }
    }
    if let (None, Some(bend)) = (closest, bent) {
        return Err(StackError::MeshBent {
            at_m: bend.at_m,
            off_m: bend.off_m,
            corners: bend.corners,
        });
    }
    Err(StackError::MeshUneven {
        noise_m: shows_noise.then_some(noise),
        volume_m3,
        fitted_m3: closest.map(|off| volume_m3 * (1.0 + off)),
    })
}

/// Whether no two faces of a hull are coplanar: a face with many points may leave facets unmerged.
fn is_merged(hull: &Solid, flat_m: f64) -> bool {
    let mut planes: Vec<(DVec3, f64)> = (0..hull.faces().len())
        .map(|face| {
            let normal = hull.normal(face);
            let corner = DVec3::from(hull.vertices_m()[hull.faces()[face][0]]);
            (normal, normal.dot(corner))
        })
        .collect();
    planes.sort_by(|a, b| a.0.x.total_cmp(&b.0.x));
    planes.iter().enumerate().all(|(number, (normal, offset_m))| {
        let near = planes[number + 1..]
            .iter()
            .take_while(|other| other.0.x - normal.x <= ONE_PLANE);
        near.into_iter().all(|(other, other_m)| {
            normal.distance(*other) > ONE_PLANE || (offset_m - other_m).abs() > 2.0 * flat_m
        })
    })
}

/// The regions that bound the body: those with hardly a corner of the hull outside of their planes.
fn outer(found: Vec<Region>, hull: &Solid, tolerance_m: f64) -> Vec<Region> {
    let corners: Vec<DVec3> = hull.vertices_m().iter().copied().map(DVec3::from).collect();
    let is_outer = |region: &Region| {
        let beyond = |p: &&DVec3| region.plane.height_m(**p) > tolerance_m;
        (corners.iter().filter(beyond).count() as f64) <= OUTSIDE_MOST * corners.len() as f64
    };
    found.into_iter().filter(is_outer).collect()
}

/// The body behind the planes of all outer faces. Its worn edges and corners are cut, repeatedly if faces are then no longer flat. Also its
/// volume before the cuts, m³.
fn bounded(surface: &Surface, faces: &[Region], hull: &Solid) -> Option<(Fitted, f64)> {
    let corners: Vec<DVec3> = hull.vertices_m().iter().copied().map(DVec3::from).collect();
    let noise_m = roughness_m(surface, faces);
    let [low, high] = hull.bounds_m().map(DVec3::from);
    let (centre, size) = (0.5 * (low + high), (high - low).max_element());
    let mut planes: Vec<Plane> = faces.iter().map(|face| face.plane).collect();
    let worn = (0.002 * size).max(3.0 * noise_m);
    let mut solid = body(&planes, centre, size).ok()?;
    let cuts = chamfers(surface, &solid, faces, size, noise_m);
    for _ in 0..BEVELS {
        let before = planes.len();
        planes.extend(bevels(&solid, &corners, worn, OUTERMOST_NOISE * noise_m));
        if planes.len() == before || planes.len() > PLANES_MOST {
            break;
        }
        solid = body(&planes, centre, size).ok()?;
    }
    let uncut_m3 = solid.volume_m3();
    if !cuts.is_empty() {
        planes.extend(cuts);
        solid = body(&planes, centre, size).ok()?;
    }
    let of_faces: Vec<Option<&Region>> = (0..solid.faces().len())
        .map(|number| region_of(&solid, number, faces, size))
        .collect();
    let triangles = of_faces
        .iter()
        .map(|face| face.map_or(Vec::new(), |face| face.triangles.clone()))
        .collect();
    let flat_m = TOLERANCE_M.min(FLAT_SHARE * size);
    let radii_m = of_faces
        .iter()
        .map(|face| face.and_then(|face| curvature::radius_m(surface, face, flat_m)))
        .collect();
    let fit = Fitted {
        solid,
        triangles,
        radii_m,
        noise_m,
    };
    Some((fit, uncut_m3))
}

/// A face of few vertices that do not lie in one plane.
struct Bend {
    /// Its vertex that is farthest from the plane of the others, m.
    at_m: [f64; 3],
    /// Distance of this vertex from that plane, m.
    off_m: f64,
    /// Number of vertices of the face.
    corners: usize,
}

/// The bend that tears a bed in two: its few vertices do not lie in one plane, and half of it would carry the stone.
fn torn(surface: &Surface, faces: &[Region]) -> Option<Bend> {
    let corners_of = |face: &Region| -> BTreeSet<usize> {
        let corners = face.triangles.iter().flat_map(|&t| surface.triangles[t]);
        corners.collect()
    };
    let corners: Vec<BTreeSet<usize>> = faces.iter().map(corners_of).collect();
    let is_bent = |first: usize, second: usize| {
        let shared = corners[first].intersection(&corners[second]).count();
        let all = corners[first].len() + corners[second].len() - shared;
        let together = faces[first].plane.normal.dot(faces[second].plane.normal);
        shared >= 2 && all < BENT_VERTICES_LEAST && together > ONE_BED
    };
    let mut pairs = (0..faces.len()).flat_map(|first| (0..first).map(move |second| (first, second)));
    let (first, second) = pairs.find(|&(first, second)| is_bent(first, second))?;
    let all: BTreeSet<usize> = corners[first].union(&corners[second]).copied().collect();
    let off = |plane: &Plane, vertex: usize| plane.height_m(surface.vertices[vertex]).abs();
    // from the plane of the larger half, which comes first
    let plane = &faces[second].plane;
    let &farthest = all
        .iter()
        .max_by(|&&a, &&b| off(plane, a).total_cmp(&off(plane, b)))?;
    Some(Bend {
        at_m: surface.vertices[farthest].into(),
        off_m: off(plane, farthest),
        corners: all.len(),
    })
}

/// The region whose plane contains a face of the body.
fn region_of<'a>(solid: &Solid, number: usize, faces: &'a [Region], size: f64) -> Option<&'a Region> {
    let (normal, on) = (solid.normal(number), solid.vertices_m()[solid.faces()[number][0]]);
    faces.iter().find(|face| {
        face.plane.normal.dot(normal) > 1.0 - 1e-9
            && face.plane.height_m(DVec3::from(on)).abs() <= 1e-5 * size
    })
}

/// Planes through the ends of the flat parts of beds at rounded edges; `sharp` is the body of the faces alone.
fn chamfers(surface: &Surface, sharp: &Solid, faces: &[Region], size: f64, noise_m: f64) -> Vec<Plane> {
    let place = |vertex: usize| DVec3::from(sharp.vertices_m()[vertex]);
    let regions: Vec<Option<&Region>> = (0..sharp.faces().len())
        .map(|number| region_of(sharp, number, faces, size))
        .collect();
    let mut cuts = Vec::new();
    for (number, region) in regions.iter().enumerate() {
        let Some(region) = region else { continue };
        if region.plane.normal.z.abs() < LEVEL_LEAST {
            continue;
        }
        let own = &sharp.faces()[number];
        for (first, second) in own.iter().zip(own.iter().cycle().skip(1)) {
            let shares = |other: &usize| {
                let corners = &sharp.faces()[*other];
                *other != number && corners.contains(first) && corners.contains(second)
            };
            let beyond = (0..regions.len()).find(shares);
            let Some(beyond) = beyond.and_then(|other| regions[other]) else {
                continue;
            };
            let ends = [place(*first), place(*second)];
            let along = (ends[1] - ends[0]).normalize_or_zero();
            let far = own
                .iter()
                .map(|&v| (place(v) - ends[0]).reject_from(along).length());
            let edge = Edge {
                face: region.plane,
                beyond: beyond.plane.normal,
                ends,
                across_m: far.fold(0.0, f64::max),
            };
            cuts.extend(chamfer(surface, &edge, ROUNDED_LEAST * size, noise_m));
        }
    }
    cuts
}

/// Root mean square distance of the corners of triangles from their planes, m.
fn roughness_m(surface: &Surface, faces: &[Region]) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for face in faces {
        for &t in &face.triangles {
            for corner in surface.corners(t) {
                sum += face.plane.height_m(corner).powi(2);
                count += 1.0;
            }
        }
    }
    match count > 0.0 {
        true => (sum / count).sqrt(),
        false => 0.0,
    }
}

/// Planes that cut off parts of the body outside the stone by more than `worn_m`: at each edge and corner of the body, normal to the mean of
/// the normals there, `inside_m` behind the outermost vertex.
fn bevels(solid: &Solid, corners: &[DVec3], worn_m: f64, inside_m: f64) -> Vec<Plane> {
    let mut at: Vec<(Vec<usize>, DVec3)> = Vec::new();
    for (vertex, &place) in solid.vertices_m().iter().enumerate() {
        let meets = (0..solid.faces().len()).filter(|&f| solid.faces()[f].contains(&vertex));
        at.push((meets.collect(), DVec3::from(place)));
    }
    let mut spots: Vec<(DVec3, DVec3)> = Vec::new();
    for (first, (faces, place)) in at.iter().enumerate() {
        spots.push((faces.iter().map(|&f| solid.normal(f)).sum(), *place));
        for (other, end) in at.iter().skip(first + 1) {
            let shared: Vec<usize> = faces.iter().copied().filter(|f| other.contains(f)).collect();
            if shared.len() == 2 {
                spots.push((
                    shared.iter().map(|&f| solid.normal(f)).sum(),
                    0.5 * (*place + *end),
                ));
            }
        }
    }
    let mut cut: Vec<Plane> = Vec::new();
    for (direction, place) in spots {
        let normal = direction.normalize_or_zero();
        let outermost = corners
            .iter()
            .map(|c| normal.dot(*c))
            .fold(f64::NEG_INFINITY, f64::max);
        if normal != DVec3::ZERO && normal.dot(place) > outermost + worn_m {
            cut.push(Plane {
                normal,
                offset_m: outermost - inside_m,
            });
        }
    }
    cut
}

#[cfg(test)]
mod tests {
    use crate::structure::stack::{Block, Joint, JointMaterial, Placement, Solid, Stack, StackError};
    use std::collections::BTreeMap;

    /// Normally distributed numbers: the sum of twelve uniform ones from a linear congruential generator.
    struct Draws(u64);

    impl Draws {
        fn normal(&mut self) -> f64 {
            let mut uniform = || {
                self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (self.0 >> 11) as f64 / (1u64 << 53) as f64
            };
            (0..12).map(|_| uniform()).sum::<f64>() - 6.0
        }
    }

    /// A box with its base centred on the origin, each side n × n squares, rotated by 0.1 rad, shifted, and with noise. If `worn`, it is
    /// hollow below except for its rim.
    fn scan(size: [f64; 3], n: usize, z: f64, noise_m: f64, worn: bool) -> Result<Solid, String> {
        let mut draws = Draws(7);
        let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for axis in 0..3 {
            for end in [0, n] {
                for (i, j) in (0..n * n).map(|k| (k / n, k % n)) {
                    let mut corner = |a: usize, b: usize| {
                        let mut key = [0; 3];
                        (key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]) = (end, a, b);
                        *numbers.entry(key).or_insert_with(|| {
                            let [u, v, mut w] = key.map(|k| k as f64 / n as f64);
                            if worn && w == 0.0 && u > 0.0 && u < 1.0 && v > 0.0 && v < 1.0 {
                                w = 0.3;
                            }
                            vertices.push([size[0] * (u - 0.5), size[1] * (v - 0.5), size[2] * w]);
                            vertices.len() - 1
                        })
                    };
                    let [a, b, c, d] = [
                        corner(i, j),
                        corner(i + 1, j),
                        corner(i + 1, j + 1),
                        corner(i, j + 1),
                    ];
                    for t in [[a, b, c], [a, c, d]] {
                        triangles.push(if end == 0 { [t[0], t[2], t[1]] } else { t });
                    }
                }
            }
        }
        let (sin, cos) = 0.1_f64.sin_cos();
        for v in &mut vertices {
            *v = [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1], v[2] + z]
                .map(|x| x + noise_m * draws.normal());
        }
        Solid::mesh(&vertices, &triangles).map_err(|why| why.to_string())
    }

    fn joints(solids: [Solid; 2]) -> Vec<Joint> {
        let block = |(number, solid): (usize, Solid)| Block {
            name: format!("stone {number}"),
            solid,
            density_kg_m3: 2600.0,
        };
        let blocks = solids.into_iter().enumerate().map(block).collect();
        let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap_or_else(|why| panic!("{why}"));
        stack.joints().to_vec()
    }

    /// Beds of two boxes of 0.6 × 0.5 × 0.4 m and 0.5 × 0.4 × 0.6 m: area and position of each joint, by arithmetic.
    #[test]
    fn exact_beds_of_boxes_with_noise() {
        for noise_m in [0.0, 1e-5, 1e-4, 1e-3, 2e-3] {
            let found = joints([
                scan([0.6, 0.5, 0.4], 12, 0.0, noise_m, false).unwrap(),
                scan([0.5, 0.4, 0.6], 12, 0.4, noise_m, false).unwrap(),
            ]);
            assert_eq!(found.len(), 2);
            let tolerance = 1e-9 + 1.5 * noise_m;
            for (joint, [width, depth, height]) in found.iter().zip([[0.6, 0.5, 0.0], [0.5, 0.4, 0.4]]) {
                let (cos, sin) = (0.1_f64.cos(), 0.1_f64.sin());
                for (direction, half) in [([cos, sin], 0.5 * width), ([-sin, cos], 0.5 * depth)] {
                    for sign in [1.0, -1.0] {
                        let direction = direction.map(|part| sign * part);
                        let at = [-joint.origin_m[0], -joint.origin_m[1]]; // the axis of the stone
                        let reach = joint.patch.reach_m(at, direction);
                        assert!((reach - half).abs() < tolerance, "{noise_m}: {reach} for {half}");
                    }
                }
                assert!(
                    (joint.origin_m[2] - height).abs() < tolerance,
                    "{noise_m}: {:?}",
                    joint.origin_m
                );
                let Some(known) = joint.scanned else {
                    assert_eq!(noise_m, 0.0, "an exact hull");
                    continue;
                };
                assert!((known.used_ratio - 1.0).abs() < 0.05, "{known:?}");
                let scatter = known.roughness_m / noise_m;
                assert!((0.7..1.3).contains(&scatter), "{known:?}");
            }
        }
    }

    #[test]
    fn exact_a_bed_of_four_corners_that_noise_tears_is_refused() {
        // the corners of the bed are off its plane by `torn`: of two triangles, one would carry
        let mesh = |torn: f64| {
            let bed = [
                [-0.3, -0.25, torn],
                [0.3, -0.25, -torn],
                [0.3, 0.25, torn],
                [-0.3, 0.25, -torn],
            ];
            let top = [
                [-0.3, -0.25, 0.4012],
                [0.3, -0.25, 0.3991],
                [0.3, 0.25, 0.4004],
                [-0.3, 0.25, 0.3989],
            ];
            let corners: Vec<[f64; 3]> = bed.into_iter().chain(top).collect();
            let mut triangles = vec![[0, 3, 1], [1, 3, 2], [4, 5, 6], [4, 6, 7]];
            for (i, next) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
                triangles.extend([[i, next, next + 4], [i, next + 4, i + 4]]);
            }
            Solid::mesh(&corners, &triangles)
        };
        assert!(mesh(0.001).is_ok());
        let fault = mesh(0.005).unwrap_err();
        let StackError::MeshBent { at_m, off_m, corners } = fault else {
            panic!("{fault}")
        };
        // three corners slope by 2 t over each side; the fourth lies 4 t above or below them
        let slope = (0.01_f64 / 0.6).hypot(0.01 / 0.5);
        assert!((off_m - 0.02 / 1.0_f64.hypot(slope)).abs() < 1e-9, "{off_m}");
        assert!(at_m[2].abs() == 0.005 && corners == 4, "{at_m:?}");
        assert!(
            fault
                .to_string()
                .contains("lies 20.0 mm off the plane of the others"),
            "{fault}"
        );
    }

    /// A box of 0.8 × 0.6 × 0.6 m on the ground, with edges and corners rounded by a radius.
    fn rounded(radius_m: f64, noise_m: f64) -> Result<Solid, String> {
        let (size, n) = ([0.8, 0.6, 0.6], [40, 30, 30]);
        let mut draws = Draws(5);
        let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for axis in 0..3 {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            for end in [0, n[axis]] {
                for (i, j) in (0..n[next] * n[last]).map(|k| (k / n[last], k % n[last])) {
                    let mut corner = |a: usize, b: usize| {
                        let mut key = [0; 3];
                        (key[axis], key[next], key[last]) = (end, a, b);
                        *numbers.entry(key).or_insert_with(|| {
                            let at: [f64; 3] =
                                std::array::from_fn(|k| size[k] * (key[k] as f64 / n[k] as f64 - 0.5));
                            // move vertices within the radius of an edge onto the sphere about the nearest point of the inner box
                            let inner: [f64; 3] = std::array::from_fn(|k| {
                                let most = 0.5 * size[k] - radius_m;
                                at[k].clamp(-most, most)
                            });
                            let off: [f64; 3] = std::array::from_fn(|k| at[k] - inner[k]);
                            let length = off.iter().map(|x| x * x).sum::<f64>().sqrt();
                            vertices.push(std::array::from_fn::<f64, 3, _>(|k| {
                                let on = inner[k] + radius_m * off[k] / length.max(1e-12);
                                let lift = if k == 2 { 0.5 * size[2] } else { 0.0 };
                                on + lift + noise_m * draws.normal()
                            }));
                            vertices.len() - 1
                        })
                    };
                    let [a, b, c, d] = [
                        corner(i, j),
                        corner(i + 1, j),
                        corner(i + 1, j + 1),
                        corner(i, j + 1),
                    ];
                    for t in [[a, b, c], [a, c, d]] {
                        triangles.push(if end == 0 { [t[0], t[2], t[1]] } else { t });
                    }
                }
            }
        }
        Solid::mesh(&vertices, &triangles).map_err(|why| why.to_string())
    }

    /// Extent of the bed of a rounded box with vertices 20 mm apart: half its width minus the radius. With two rows of vertices or fewer in
    /// the rounding, the bed may end one or two rows earlier, but never later.
    #[test]
    fn holds_a_bed_ends_where_its_edge_begins_to_round() {
        let mut wrong = Vec::new();
        for (radius_m, noise_m) in [(0.02, 0.0), (0.05, 5e-4), (0.1, 0.0), (0.1, 2e-3)] {
            let block = Block {
                name: "stone".to_owned(),
                solid: rounded(radius_m, noise_m).unwrap(),
                density_kg_m3: 2600.0,
            };
            let stack = Stack::new(vec![block], JointMaterial::default(), 9.81).unwrap();
            let joint = &stack.joints()[0];
            for (direction, half) in [([1.0, 0.0], 0.4), ([0.0, -1.0], 0.3)] {
                let at = [-joint.origin_m[0], -joint.origin_m[1]];
                let off = joint.patch.reach_m(at, direction) - (half - radius_m);
                let rows = if radius_m <= 0.05 {
                    0.02 + 10.0 * noise_m
                } else {
                    0.0
                };
                if off > 0.02 * half || off < -0.02 * half - rows {
                    wrong.push((radius_m, noise_m, off));
                }
            }
        }
        assert!(wrong.is_empty(), "{wrong:?}");
    }

    #[test]
    fn refuses_a_stone_that_is_hollow_below() {
        let said = scan([0.6, 0.5, 0.4], 12, 0.0, 5e-4, true).unwrap_err();
        assert!(
            said.contains("the stone is not convex, or too worn or curved"),
            "{said}"
        );
    }

    /// A bed with only eight corners, 0.01 mm off: its hull consists of triangles.
    #[test]
    fn exact_bed_of_eight_corners_with_noise() {
        let upright = |z: f64| scan([0.4, 0.4, 1.0], 1, z, 1e-5, false).unwrap();
        let place = Placement {
            position_m: [0.0, 0.0, 1.0],
            ..Placement::default()
        };
        for joint in joints([upright(0.0), upright(0.0).placed(&place)]) {
            assert!((joint.patch.moments().area_m2 - 0.16).abs() < 1e-4);
        }
    }
}
