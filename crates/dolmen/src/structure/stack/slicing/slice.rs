//! The stones between the beds of a scanned tower.

use super::SliceError;
use super::half::{Part, Plane, Side, half};
use super::ledge::{Bed, LOOKED_M, Named, bed};
use super::section::Body;
use super::steps::{SlicedStep, steps};
use crate::structure::stack::StackError;
use crate::structure::stack::hull::FLAT;
use crate::structure::stack::mesh::{check_corners, check_edges};
use crate::structure::stack::scan::noise_of;
use glam::DVec3;

/// Largest relative difference between the volume of all stones and that of the whole.
const VOLUME_OFF_MOST: f64 = 0.005;
/// Largest noise that is considered, m. Our choice: larger scatter is shape.
const NOISE_MOST_M: f64 = 0.002;

/// Distance from a step at which a bed without a step is still at it, m: noise blurs a step by as much.
const BESIDE_M: f64 = 0.005;

/// A tower cut into stones.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sliced {
    /// The stones, course by course from below; within a course by x.
    pub stones: Vec<SlicedStone>,
    /// The beds, lowest first.
    pub beds: Vec<SlicedBed>,
    /// Steps of the section by more than a fifth of its area where no bed is given, lowest first.
    pub steps_without_bed: Vec<SlicedStep>,
    /// Lowest and highest point of the whole, m.
    pub span_m: [f64; 2],
    /// Volume of the whole, m³.
    pub volume_m3: f64,
    /// Volume of all stones over that of the whole.
    pub volume_ratio: f64,
    /// Noise of the vertices considered in the cuts, m; 0 for a modelled mesh.
    pub noise_m: f64,
}

/// A stone between two beds.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SlicedStone {
    /// Course of the stone, from 0 at the bottom.
    pub course: usize,
    /// Its corners, m.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub vertices_m: Vec<[f64; 3]>,
    /// Its triangles, counterclockwise seen from outside.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub triangles: Vec<[usize; 3]>,
    /// Volume of the stone, m³.
    pub volume_m3: f64,
}

/// A bed between two courses.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SlicedBed {
    /// Given height, m.
    pub named_m: f64,
    /// Height of the cut, m: that of the step near the given height, if there is one.
    pub at_m: f64,
    /// Whether the section has a step there.
    pub is_at_step: bool,
    /// Area of the section just below, m².
    pub area_below_m2: f64,
    /// Area of the section just above, m².
    pub area_above_m2: f64,
}

/// Cuts a closed mesh into stones at the heights of its beds; level caps close each stone.
///
/// The heights are measured values. If the section of the scan has a step within 20 mm of a height (a stone on a wider or narrower one, or off
/// its centre), the bed is at the step. The lower stone then ends with the section just below, and the upper one begins with the section just
/// above, each outside the noise of the scan (five standard deviations); both are extended to the bed. So no fragment of one stone remains on
/// the other. Separate parts between two beds become several stones.
///
/// # Errors
/// [`SliceError`] for a mesh that bounds no body; for heights that do not ascend, are outside, or are less than 20 mm apart; for a section
/// with a hole or an outline that crosses itself; and if the volumes of the stones differ from the whole by more than 0.5 %.
///
/// # Limits
/// The caps are plane because they are cuts: the outside does not show how rough the real bed is, or how much of it is in contact. Stones that
/// touch within a course become one stone.
pub fn slice(
    vertices_m: &[[f64; 3]],
    triangles: &[[usize; 3]],
    beds_m: &[f64],
) -> Result<Sliced, SliceError> {
    check_corners(vertices_m, triangles)?;
    check_edges(vertices_m, triangles)?;
    let whole = Part {
        vertices: vertices_m.iter().copied().map(DVec3::from).collect(),
        triangles: triangles.to_vec(),
    };
    let volume_m3 = whole.volume_m3();
    if volume_m3 <= 0.0 {
        return Err(StackError::MeshInverted { volume_m3 }.into());
    }
    let body = whole.body();
    let (span_m, size_m) = (body.span_m(), body.size_m());
    check_heights(beds_m, span_m)?;
    let noise_m = noise_of(vertices_m, triangles, 2.0 * FLAT * size_m).min(NOISE_MOST_M);
    let middle = middle(&body);
    let ends = |number: usize| {
        let below = number.checked_sub(1).map_or(span_m[0], |number| beds_m[number]);
        [below, beds_m.get(number + 1).copied().unwrap_or(span_m[1])]
    };
    let beds: Vec<Bed> = (0..beds_m.len())
        .map(|number| {
            let named = Named {
                height_m: beds_m[number],
                neighbours_m: ends(number),
                noise_m,
                middle,
            };
            bed(&body, &named)
        })
        .collect();
    let area = |at_m: f64| body.section(at_m, middle).area_m2;
    let beds_cut: Vec<SlicedBed> = beds
        .iter()
        .zip(beds_m)
        .map(|(bed, &named_m)| SlicedBed {
            named_m,
            at_m: bed.at_m,
            is_at_step: bed.apart_m > 0.0,
            area_below_m2: area(bed.at_m - bed.apart_m),
            area_above_m2: area(bed.at_m + bed.apart_m),
        })
        .collect();
    for bed in &beds_cut {
        if bed.area_below_m2.min(bed.area_above_m2) <= 0.0 {
            return Err(SliceError::Air { bed_m: bed.named_m });
        }
    }
    let steps_without_bed = without_bed(steps(&body, middle), &beds_cut);
    let mut stones = Vec::new();
    for course in 0..=beds.len() {
        let mut part = whole.clone();
        if let Some(bed) = course.checked_sub(1).map(|below| beds[below]) {
            let plane = Plane {
                cut_m: bed.at_m + bed.apart_m,
                at_m: bed.at_m,
            };
            part = half(&part.body(), Side::Above, plane, size_m)?;
        }
        if let Some(bed) = beds.get(course) {
            let plane = Plane {
                cut_m: bed.at_m - bed.apart_m,
                at_m: bed.at_m,
            };
            part = half(&part.body(), Side::Below, plane, size_m)?;
        }
        let pieces = part.pieces()?.into_iter();
        stones.extend(pieces.map(|piece| SlicedStone {
            course,
            volume_m3: piece.volume_m3(),
            vertices_m: piece.vertices.into_iter().map(Into::into).collect(),
            triangles: piece.triangles,
        }));
    }
    let volume_ratio = stones.iter().map(|stone| stone.volume_m3).sum::<f64>() / volume_m3;
    if (volume_ratio - 1.0).abs() > VOLUME_OFF_MOST {
        return Err(SliceError::Volume {
            ratio: volume_ratio,
            whole_m3: volume_m3,
            allowed: VOLUME_OFF_MOST,
        });
    }
    Ok(Sliced {
        stones,
        beds: beds_cut,
        steps_without_bed,
        span_m,
        volume_m3,
        volume_ratio,
        noise_m,
    })
}

/// The steps that are no bed: one cut without a step does not hold the step beside it.
fn without_bed(steps: Vec<SlicedStep>, beds: &[SlicedBed]) -> Vec<SlicedStep> {
    let holds = |bed: &SlicedBed, step: &SlicedStep| {
        let most_m = if bed.is_at_step { LOOKED_M } else { BESIDE_M };
        (bed.at_m - step.at_m).abs() <= most_m
    };
    let is_free = |step: &SlicedStep| !beds.iter().any(|bed| holds(bed, step));
    steps.into_iter().filter(is_free).collect()
}

/// The middle of the bounds in plan.
fn middle(body: &Body<'_>) -> glam::DVec2 {
    let used = || {
        body.triangles
            .iter()
            .flatten()
            .map(|&v| body.vertices[v].truncate())
    };
    let low = used().fold(glam::DVec2::INFINITY, glam::DVec2::min);
    let high = used().fold(glam::DVec2::NEG_INFINITY, glam::DVec2::max);
    0.5 * (low + high)
}

/// Checks that the heights ascend within the scan, with a stone between successive heights.
fn check_heights(beds_m: &[f64], [low_m, high_m]: [f64; 2]) -> Result<(), SliceError> {
    if beds_m.is_empty() {
        return Err(SliceError::NoBeds);
    }
    if let Some(&given) = beds_m.iter().find(|bed| !bed.is_finite()) {
        return Err(SliceError::NotFinite { given });
    }
    if let Some(pair) = beds_m.windows(2).find(|pair| pair[0] >= pair[1]) {
        return Err(SliceError::Unsorted {
            first_m: pair[0],
            then_m: pair[1],
        });
    }
    if let Some(&bed_m) = beds_m.iter().find(|&&bed| bed <= low_m || bed >= high_m) {
        return Err(SliceError::Outside { bed_m, low_m, high_m });
    }
    let ends: Vec<f64> = [&[low_m], beds_m, &[high_m]].concat();
    match ends.windows(2).find(|pair| pair[1] - pair[0] < LOOKED_M) {
        Some(pair) => Err(SliceError::Thin {
            low_m: pair[0],
            high_m: pair[1],
            least_m: LOOKED_M,
        }),
        None => Ok(()),
    }
}
