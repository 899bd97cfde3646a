//! Triangulates a simple polygon by ear clipping.
//!
//! The ear with the shortest cut comes first, which avoids long slivers from one corner.
//!
//! # Source
//! G. H. Meisters, "Polygons have ears", The American Mathematical Monthly 82 (1975).

use glam::DVec2;
use std::collections::BTreeSet;

/// Largest area that the triangles may miss, relative to the polygon.
const AREA_MISSED: f64 = 1e-7;

/// Region inside an outline.
#[derive(Debug)]
pub(super) enum Outline {
    /// Triangles between the corners, counterclockwise.
    Closed(Vec<[usize; 3]>),
    /// The outline is clockwise around a hole of this area, m².
    Turned { area_m2: f64 },
    /// The outline crosses itself.
    Crossed,
}

/// Twice the area of a triangle, positive counterclockwise.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The remaining corners, each with its two neighbours.
struct Ring<'a> {
    places: &'a [DVec2],
    before: Vec<usize>,
    after: Vec<usize>,
}

impl Ring<'_> {
    /// Whether a corner turns by more than `least` and its triangle contains no other corner.
    fn is_ear(&self, corner: usize, least: f64) -> bool {
        let (from, to) = (self.before[corner], self.after[corner]);
        let [a, b, c] = [from, corner, to].map(|at| self.places[at]);
        if turn(a, b, c) <= least {
            return false;
        }
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let mut other = self.after[to];
        while other != from {
            let p = self.places[other];
            let is_near = p.cmpge(low).all() && p.cmple(high).all();
            if is_near && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0 {
                return false;
            }
            other = self.after[other];
        }
        true
    }

    /// Length of the cut that removes a corner, as bits in the order of the lengths.
    fn cut(&self, corner: usize) -> u64 {
        let [a, c] = [self.before[corner], self.after[corner]].map(|at| self.places[at]);
        a.distance_squared(c).to_bits()
    }
}

/// The triangles of a counterclockwise polygon.
pub(super) fn triangles_of(places: &[DVec2]) -> Outline {
    let count = places.len();
    let first = places.first().copied().unwrap_or_default();
    let pairs = (0..count).map(|n| (places[n] - first, places[(n + 1) % count] - first));
    let twice: f64 = pairs.map(|(a, b)| a.perp_dot(b)).sum();
    if count < 3 || twice <= 0.0 {
        return Outline::Turned {
            area_m2: 0.5 * twice.abs(),
        };
    }
    let mut ring = Ring {
        places,
        before: (0..count).map(|n| (n + count - 1) % count).collect(),
        after: (0..count).map(|n| (n + 1) % count).collect(),
    };
    // corners whose area is only rounding are cut last
    let rounding = 1e-14 * twice;
    let mut least = rounding;
    let mut waiting: BTreeSet<(u64, usize)> = (0..count).map(|corner| (ring.cut(corner), corner)).collect();
    let mut passed: BTreeSet<usize> = BTreeSet::new();
    let mut has_cut = false;
    let (mut triangles, mut left, mut covered) = (Vec::with_capacity(count - 2), count, 0.0);
    while left > 3 {
        let Some((_, corner)) = waiting.pop_first() else {
            if !has_cut && least < 0.0 {
                return Outline::Crossed;
            }
            // a later cut may have blocked other ears
            least = if has_cut { rounding } else { -rounding };
            has_cut = false;
            waiting.extend(passed.iter().map(|&corner| (ring.cut(corner), corner)));
            passed.clear();
            continue;
        };
        if !ring.is_ear(corner, least) {
            passed.insert(corner);
            continue;
        }
        let (from, to) = (ring.before[corner], ring.after[corner]);
        for end in [from, to] {
            waiting.remove(&(ring.cut(end), end));
            passed.remove(&end);
        }
        triangles.push([from, corner, to]);
        covered += turn(places[from], places[corner], places[to]);
        (ring.after[from], ring.before[to]) = (to, from);
        (left, has_cut, least) = (left - 1, true, rounding);
        waiting.extend([from, to].map(|at| (ring.cut(at), at)));
    }
    let corner = triangles.last().map_or(1, |last: &[usize; 3]| last[0]);
    let (from, to) = (ring.before[corner], ring.after[corner]);
    triangles.push([from, corner, to]);
    covered += turn(places[from], places[corner], places[to]);
    match (covered - twice).abs() <= AREA_MISSED * twice {
        true => Outline::Closed(triangles),
        false => Outline::Crossed,
    }
}
