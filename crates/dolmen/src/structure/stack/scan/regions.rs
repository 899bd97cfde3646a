//! Finds the dressed faces in a noisy surface mesh: regions with similar normals first, then each triangle is
//! assigned to its nearest plane.

use super::plane::Plane;
use super::surface::Surface;
use glam::DVec3;
use std::collections::VecDeque;

/// Cosine of 15°, the largest angle between a region and a normal that joins it. Our choice: smoothed normals
/// scatter by 3° to 5°.
const JOINS: f64 = 0.965_9;
/// Cosine of 45°, the largest angle between a plane face and a smoothed normal on it.
const FACES: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Smallest region that counts as a face, as a fraction of the surface. Our choice: smaller regions are worn
/// corners.
const AREA_LEAST: f64 = 0.004;
/// Cosine of 8°, the angle between normals below which two regions may be one face.
const ONE_FACE: f64 = 0.990_3;
/// Number of rounds of fitting planes and reassigning triangles.
const ROUNDS: usize = 4;

pub(super) struct Region {
    pub(super) plane: Plane,
    pub(super) triangles: Vec<usize>,
    pub(super) area_m2: f64,
}

/// The faces of a surface, largest first. Every vertex of a face is within `tolerance_m` of its plane.
pub(super) fn regions(surface: &Surface, normals: &[(DVec3, f64)], tolerance_m: f64) -> Vec<Region> {
    let mut found = fitted(surface, grown(surface, normals, tolerance_m));
    for _ in 0..ROUNDS {
        found = one_face_once(surface, found, tolerance_m);
        found = fitted(surface, nearest(surface, normals, &found, tolerance_m));
    }
    found
}

/// Regions of triangles with similar normals near the plane of their first triangle, grown from the flattest
/// triangles on.
fn grown(surface: &Surface, normals: &[(DVec3, f64)], tolerance_m: f64) -> Vec<(DVec3, Vec<usize>)> {
    let mut seeds: Vec<usize> = (0..normals.len()).collect();
    seeds.sort_by(|&a, &b| normals[b].1.total_cmp(&normals[a].1).then(a.cmp(&b)));
    let mut taken = vec![false; normals.len()];
    let mut all = Vec::new();
    for seed in seeds {
        if taken[seed] {
            continue;
        }
        taken[seed] = true;
        let mut members = Vec::new();
        let (mut sum, mut first, mut total) = (DVec3::ZERO, DVec3::ZERO, 0.0);
        let mut reached = VecDeque::from([seed]);
        while let Some(t) = reached.pop_front() {
            members.push(t);
            let area = surface.areas[t].length();
            sum += normals[t].0 * area;
            first += surface.centre(t) * area;
            total += area;
            let (mean, on) = (sum.normalize_or_zero(), first / total.max(f64::MIN_POSITIVE));
            for &beyond in &surface.across[t] {
                let height = mean.dot(surface.centre(beyond) - on).abs();
                if !taken[beyond] && normals[beyond].0.dot(mean) >= JOINS && height <= tolerance_m {
                    taken[beyond] = true;
                    reached.push_back(beyond);
                }
            }
        }
        all.push((sum.normalize_or_zero(), members));
    }
    all
}

/// Fits planes to the sets of triangles that are large enough; the largest first.
fn fitted(surface: &Surface, sets: Vec<(DVec3, Vec<usize>)>) -> Vec<Region> {
    let whole: f64 = surface.areas.iter().map(|area| area.length()).sum();
    let mut found: Vec<Region> = sets
        .into_iter()
        .filter_map(|(normal, triangles)| {
            let area_m2: f64 = triangles.iter().map(|&t| surface.areas[t].length()).sum();
            if area_m2 < AREA_LEAST * whole {
                return None;
            }
            let plane = Plane::of(surface, &triangles, normal)?;
            Some(Region {
                plane,
                triangles,
                area_m2,
            })
        })
        .collect();
    found.sort_by(|a, b| b.area_m2.total_cmp(&a.area_m2));
    found
}

/// Removes regions in the plane of a larger region.
fn one_face_once(surface: &Surface, found: Vec<Region>, tolerance_m: f64) -> Vec<Region> {
    let mut kept: Vec<Region> = Vec::new();
    for region in found {
        let centre = region.triangles.iter().fold(DVec3::ZERO, |sum, &t| {
            sum + surface.centre(t) * surface.areas[t].length()
        }) / region.area_m2;
        let same = kept.iter().any(|other| {
            other.plane.normal.dot(region.plane.normal) >= ONE_FACE
                && other.plane.height_m(centre).abs() <= tolerance_m
        });
        if !same {
            kept.push(region);
        }
    }
    kept
}

/// Assigns each triangle to the nearest plane, if one is close enough and has a similar normal.
fn nearest(
    surface: &Surface,
    normals: &[(DVec3, f64)],
    found: &[Region],
    tolerance_m: f64,
) -> Vec<(DVec3, Vec<usize>)> {
    let mut sets: Vec<(DVec3, Vec<usize>)> = found.iter().map(|r| (r.plane.normal, Vec::new())).collect();
    for (t, (normal, _)) in normals.iter().enumerate() {
        let corners = surface.corners(t);
        let farthest = |plane: &Plane| {
            let heights = corners.map(|p| plane.height_m(p).abs());
            heights.into_iter().fold(0.0, f64::max)
        };
        let mut best: Option<(f64, usize)> = None;
        for (number, region) in found.iter().enumerate() {
            if normal.dot(region.plane.normal) < FACES {
                continue;
            }
            let height = farthest(&region.plane);
            if height <= tolerance_m && best.is_none_or(|(least, _)| height < least) {
                best = Some((height, number));
            }
        }
        if let Some((_, number)) = best {
            sets[number].1.push(t);
        }
    }
    sets
}
