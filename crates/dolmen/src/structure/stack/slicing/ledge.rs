//! Finds the step of a section near a measured height: the bed between two stones of different width.

use super::section::{Body, Section};
use glam::DVec2;

/// Range of the search for a step on each side of the given height, m. Our choice: a tape is accurate to 1 or 2 cm.
pub(super) const LOOKED_M: f64 = 0.02;
/// Largest range, as a share of the distance to the next bed.
const LOOKED_SHARE: f64 = 0.25;
/// Number of sections on each side of the height.
const SECTIONS: usize = 20;
/// Least size of a step, relative to the square root of the section's area.
const STEP_LEAST: f64 = 0.01;
/// Least step, in standard deviations of the noise.
const STEP_NOISE: f64 = 4.0;
/// Least ratio of the step to the change over the same height just below and just above, because slopes are not steps.
const STEP_SLOPES: f64 = 2.0;
/// Number of bisections: 20 mm become less than 1e-10 m.
const ROUNDS: usize = 28;
/// Heights closer than this are equal, m.
const ONE_HEIGHT_M: f64 = 1e-6;

/// The position at which a bed is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bed {
    /// Height of the bed, m.
    pub(super) at_m: f64,
    /// Distance of the sections below and above the bed, m; 0 without a step.
    pub(super) apart_m: f64,
}

/// Given data of a bed: its height, the distance of its neighbours, and the noise of the scan, m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named {
    pub(super) height_m: f64,
    pub(super) neighbours_m: [f64; 2],
    pub(super) noise_m: f64,
    pub(super) middle: DVec2,
}

/// Distance from a step at which both sections are taken, m: the noise of the vertices does not reach so far.
fn apart_m(noise_m: f64) -> f64 {
    (5.0 * noise_m).max(ONE_HEIGHT_M)
}

/// The bed at a height, or at the step near it.
pub(super) fn bed(body: &Body<'_>, named: &Named) -> Bed {
    let Named {
        height_m, noise_m, ..
    } = *named;
    let [below, above] = named.neighbours_m;
    let apart_m = apart_m(noise_m);
    let room = LOOKED_SHARE * (height_m - below).min(above - height_m);
    let looked = (LOOKED_M + 2.0 * apart_m).min(room);
    let near = body.between(height_m - looked, height_m + looked);
    let near = Body {
        vertices: body.vertices,
        triangles: &near,
    };
    let height = |number: f64| height_m + looked * (number / SECTIONS as f64 - 1.0);
    let sections: Vec<Section> = (0..=2 * SECTIONS)
        .map(|number| near.section(height(number as f64), named.middle))
        .collect();
    let spacing = looked / SECTIONS as f64;
    let over = ((2.0 * apart_m / spacing).ceil() as usize).clamp(1, SECTIONS);
    let least = sections
        .iter()
        .map(|section| section.lengths_m[0])
        .fold(f64::INFINITY, f64::min);
    let is_step = |step: &Step| {
        let middle = step.from as f64 + 0.5 * over as f64;
        (height(middle) - height_m).abs() <= LOOKED_M + spacing
            && step.size_m > (STEP_LEAST * least).max(STEP_NOISE * noise_m)
            && step.size_m > STEP_SLOPES * step.beside_m
    };
    let plain = Bed {
        at_m: height_m,
        apart_m: 0.0,
    };
    let lengths = sections.first().map_or(0, |section| section.lengths_m.len());
    let steps = (0..lengths).map(|length| Step::largest(&sections, length, over));
    let largest = steps.filter(is_step).max_by(|a, b| a.size_m.total_cmp(&b.size_m));
    let Some(step) = largest else {
        return plain;
    };
    let length = |at_m: f64| near.section(at_m, named.middle).lengths_m[step.length];
    let [mut low, mut high] = [step.from, step.from + over].map(|number| height(number as f64));
    let ends = [length(low), length(high)];
    let middle = 0.5 * (ends[0] + ends[1]);
    for _ in 0..ROUNDS {
        let half = 0.5 * (low + high);
        match (length(half) < middle) == (ends[0] < middle) {
            true => low = half,
            false => high = half,
        }
    }
    let found = 0.5 * (low + high);
    let at_m = match (found - height_m).abs() <= ONE_HEIGHT_M {
        true => height_m,
        false => found,
    };
    Bed { at_m, apart_m }
}

/// The largest change of one length of sections over some of them.
struct Step {
    length: usize,
    from: usize,
    size_m: f64,
    /// The larger of the changes just below and just above the step, over the same height.
    beside_m: f64,
}

impl Step {
    fn largest(sections: &[Section], length: usize, over: usize) -> Self {
        let at = |number: usize| sections[number].lengths_m[length];
        let change = |from: usize| (at(from + over) - at(from)).abs();
        let last = sections.len() - over;
        let changes: Vec<f64> = (0..last).map(change).collect();
        // the middle of a run of equal changes, because the step is within all of them
        let size_m = changes.iter().copied().fold(0.0, f64::max);
        let is_largest = |from: &usize| changes[*from] >= 0.98 * size_m;
        let runs: Vec<usize> = (0..last).filter(is_largest).collect();
        let from = runs.get(runs.len() / 2).copied().unwrap_or_default();
        let (below, above) = (from.min(over), (sections.len() - 1 - from - over).min(over));
        let scaled = |change: f64, count: usize| match 2 * count >= over && count > 0 {
            true => change.abs() * over as f64 / count as f64,
            false => 0.0, // too near to the end to tell a slope
        };
        let beside_m = scaled(at(from) - at(from - below), below)
            .max(scaled(at(from + over + above) - at(from + over), above));
        Step {
            length,
            from,
            size_m,
            beside_m,
        }
    }
}
