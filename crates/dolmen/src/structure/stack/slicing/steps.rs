//! Steps of the section over the whole height of a scan: the beds that it shows, given or not.

use super::ledge::LOOKED_M;
use super::section::Body;
use glam::DVec2;

/// Least step of the area over [`LOOKED_M`], relative to the larger area. Our choice: the capacity of the joint changes by a tenth or more.
const STEP_LEAST: f64 = 0.2;
/// Sections over [`LOOKED_M`].
const OVER: usize = 4;
/// Least ratio of a step to the change over the same height just below and just above.
const STEP_SLOPES: f64 = 2.0;
/// Least share of a step within half of its height: a slope has 0.5, the tip of a cone 0.58.
const STEP_SHARE: f64 = 0.75;
/// Sections for which the triangles are chosen at once.
const CHUNK: usize = 32;
/// Number of bisections: 20 mm become less than 1e-9 m.
const ROUNDS: usize = 26;

/// An abrupt change of the area of the section by more than a fifth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SlicedStep {
    /// Height, m.
    pub at_m: f64,
    /// Area of the section below, m².
    pub area_below_m2: f64,
    /// Area of the section above, m².
    pub area_above_m2: f64,
}

/// The steps of a body, lowest first; none within 20 mm of its ends, where no bed can be.
pub(super) fn steps(body: &Body<'_>, middle: DVec2) -> Vec<SlicedStep> {
    let [low_m, high_m] = body.span_m();
    let spacing = LOOKED_M / OVER as f64;
    let count = ((high_m - low_m - 2.0 * LOOKED_M) / spacing).max(0.0) as usize;
    let heights: Vec<f64> = (0..=count)
        .map(|number| low_m + LOOKED_M + spacing * number as f64)
        .collect();
    let areas: Vec<f64> = heights
        .chunks(CHUNK)
        .flat_map(|of| areas(body, of, middle))
        .collect();
    let size = |from: usize| (areas[from + OVER] - areas[from]).abs();
    let last = areas.len().saturating_sub(OVER);
    let is_step = |from: &usize| {
        let ends = [areas[*from], areas[*from + OVER]];
        size(*from) > STEP_LEAST * ends[0].max(ends[1]) && is_abrupt(&areas, *from)
    };
    let mut found: Vec<usize> = (0..last).filter(is_step).collect();
    found.sort_by(|a, b| size(*b).total_cmp(&size(*a)));
    let mut all: Vec<SlicedStep> = Vec::new();
    for from in found {
        let step = located(body, heights[from], [areas[from], areas[from + OVER]], middle);
        if all.iter().all(|other| (other.at_m - step.at_m).abs() > LOOKED_M) {
            all.push(step);
        }
    }
    all.sort_by(|a, b| a.at_m.total_cmp(&b.at_m));
    all
}

fn areas(body: &Body<'_>, heights: &[f64], middle: DVec2) -> Vec<f64> {
    let [first, last] = [heights.first(), heights.last()].map(|of| of.copied().unwrap_or_default());
    let near = body.between(first, last);
    let near = Body {
        vertices: body.vertices,
        triangles: &near,
    };
    heights
        .iter()
        .map(|&height| near.section(height, middle).area_m2)
        .collect()
}

/// Whether a change is no slope: it lies in half of its height, or is far larger than those beside it.
fn is_abrupt(areas: &[f64], from: usize) -> bool {
    let change = |from: usize, to: usize| (areas[to] - areas[from]).abs();
    let size = change(from, from + OVER);
    let half = OVER / 2;
    let inner = (from..=from + OVER - half).map(|at| change(at, at + half));
    let below = from.checked_sub(OVER).map_or(0.0, |below| change(below, from));
    let end = from + 2 * OVER;
    let above = match end < areas.len() {
        true => change(from + OVER, end),
        false => 0.0,
    };
    let has_both = from >= OVER && end < areas.len();
    inner.fold(0.0, f64::max) > STEP_SHARE * size || has_both && size > STEP_SLOPES * below.max(above)
}

fn located(body: &Body<'_>, from_m: f64, [below, above]: [f64; 2], middle: DVec2) -> SlicedStep {
    let [mut low, mut high] = [from_m, from_m + LOOKED_M];
    let near = body.between(low, high);
    let near = Body {
        vertices: body.vertices,
        triangles: &near,
    };
    let half = 0.5 * (below + above);
    for _ in 0..ROUNDS {
        let at = 0.5 * (low + high);
        match (near.section(at, middle).area_m2 < half) == (below < half) {
            true => low = at,
            false => high = at,
        }
    }
    SlicedStep {
        at_m: 0.5 * (low + high),
        area_below_m2: below,
        area_above_m2: above,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// Frusta of half widths at base and top and height, one upon the other; their areas by hand.
    fn steps_of(stones: &[[f64; 3]]) -> Vec<SlicedStep> {
        let (mut vertices, mut triangles, mut z) = (Vec::new(), Vec::new(), 0.0);
        for [base, top, height] in stones {
            let from = vertices.len();
            for (half, z) in [(base, z), (top, z + height)] {
                let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
                vertices.extend(corners.map(|[x, y]| DVec3::new(half * x, half * y, z)));
            }
            triangles.extend([[2, 1, 0], [3, 2, 0], [4, 5, 6], [4, 6, 7]].map(|t| t.map(|v| from + v)));
            for a in 0..4 {
                let b = (a + 1) % 4;
                triangles.extend([[a, b, 4 + b], [a, 4 + b, 4 + a]].map(|t| t.map(|v| from + v)));
            }
            z += height;
        }
        let body = Body {
            vertices: &vertices,
            triangles: &triangles,
        };
        steps(&body, DVec2::ZERO)
    }

    #[test]
    fn exact_steps_of_boxes_are_found_at_their_heights() {
        let found = steps_of(&[
            [0.5, 0.5, 0.5],
            [0.3, 0.3, 1.2],
            [0.45, 0.45, 0.303],
            [0.1, 0.1, 0.4],
        ]);
        let wanted = [[0.5, 1.0, 0.36], [1.7, 0.36, 0.81], [2.003, 0.81, 0.04]];
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        for (step, wanted) in found.iter().zip(wanted) {
            let found = [step.at_m, step.area_below_m2, step.area_above_m2];
            for (found, wanted) in found.iter().zip(wanted) {
                assert!((found - wanted).abs() < 1e-6, "{step:?}");
            }
        }
    }

    #[test]
    fn holds_slopes_tips_and_small_steps_are_no_steps() {
        // a taper, a pyramid, a box with a step of 19 % of its area
        assert_eq!(steps_of(&[[0.5, 0.2, 2.0]]), []);
        assert_eq!(steps_of(&[[0.3, 1e-6, 0.3]]), []);
        assert_eq!(steps_of(&[[0.5, 0.5, 0.5], [0.45, 0.45, 0.5]]), []);
    }

    #[test]
    fn holds_steps_in_a_row_are_each_a_step() {
        let row: Vec<f64> = steps_of(&[
            [0.3, 0.3, 0.4],
            [0.4, 0.4, 0.03],
            [0.5, 0.5, 0.03],
            [0.65, 0.65, 0.3],
        ])
        .iter()
        .map(|step| step.at_m)
        .collect();
        assert_eq!(row.len(), 3, "{row:?}");
    }
}
