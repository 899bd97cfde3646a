// SOURCE     Statics of a bed without tension: the resultant is inside the bed. In a rigid, perfectly plastic bed, a straight line bounds the
//            stress block f, whose centre is as far out as that of any part of the bed with the same area.
// GOAL       The largest moment of a rectangular bed in every direction, with and without strength, and the response of a bed to a growing
//            moment.
//
//            ┌───────────┐ w     limit towards d = N · min over n of h(n)/(n · d),
//            │     ·→ d ▓│       h(n) = (f/N) ∫ t p(t) dt over the outermost N/f of the bed,
//            └───────────┘       p(t) the width of the bed at the distance t along n
//                  b
//
// PARAMETERS 300 random beds, shares of the bed and directions, seed below.
// TOLERANCE  1e-9 for a ray and a rectangle; 2e-5 if h is a quadrature with 4000 strips and n takes 3000 directions.

use crate::draws::Draws;
use dolmen::stability::BedEdge;
use std::f64::consts::{FRAC_PI_2, TAU};

const BEDS: usize = 300;

/// Distance from the centre of a rectangle to its edge: the ray meets each of its four sides.
fn to_the_edge(b: f64, w: f64, [x, y]: [f64; 2]) -> f64 {
    let sides = [(x, b), (-x, b), (y, w), (-y, w)];
    let met = sides.into_iter().filter(|(towards, _)| *towards > 0.0);
    met.map(|(towards, side)| 0.5 * side / towards)
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn exact_a_bed_passes_its_weight_times_the_way_to_its_edge() {
    let mut draws = Draws::new(41);
    for _ in 0..BEDS {
        let (b, w, n) = (
            draws.between(0.1, 2.0),
            draws.between(0.1, 2.0),
            draws.between(1e3, 1e6),
        );
        let angle = draws.between(0.0, TAU);
        let bed = BedEdge {
            width_m: b,
            depth_m: Some(w),
            strength_pa: None,
        };
        let d = [angle.cos(), angle.sin()];
        let expected = n * to_the_edge(b, w, d);
        let found = bed.moment_towards_n_m(n, d.map(|of| 7.0 * of));
        assert!(
            (found / expected - 1.0).abs() < 1e-9,
            "{b} {w} {angle}: {found} {expected}"
        );
        // along the sides it equals the result in one plane
        let along = bed.moment_towards_n_m(n, [1.0, 0.0]);
        assert!((along / bed.moment_n_m(n) - 1.0).abs() < 1e-12);
        // an additional moment is limited by the edge
        let there = [0.3 * n * b / 2.0, -0.2 * n * w / 2.0];
        let times = bed.reach(n, there, d);
        let end = [there[0] + times * d[0], there[1] + times * d[1]];
        let use_of = (end[0] / (n * b / 2.0)).abs().max((end[1] / (n * w / 2.0)).abs());
        assert!((use_of - 1.0).abs() < 1e-9, "{use_of}");
    }
}

/// h(n): mean distance along n of the outermost `share` of the rectangle.
fn outermost(b: f64, w: f64, share: f64, angle: f64) -> f64 {
    const STRIPS: usize = 4000;
    let (p, q) = (0.5 * b * angle.cos().abs(), 0.5 * w * angle.sin().abs());
    let (wide, narrow) = (p.max(q), p.min(q));
    // share of the area per length: a trapezoid
    let density = |t: f64| match t.abs() {
        t if t <= wide - narrow => 0.5 / wide,
        t if t < wide + narrow => 0.5 / wide * (wide + narrow - t) / (2.0 * narrow),
        _ => 0.0,
    };
    let end = wide + narrow;
    let step = 2.0 * end / STRIPS as f64;
    let (mut area, mut moment) = (0.0, 0.0);
    for strip in 0..STRIPS {
        let t = end - (strip as f64 + 0.5) * step;
        let own = (density(t) * step).min(share - area);
        if own <= 0.0 {
            break;
        }
        area += own;
        moment += own * t;
    }
    moment / area
}

#[test]
fn agrees_the_stress_block_with_the_outermost_parts_of_the_bed() {
    const STEPS: usize = 3000;
    let mut draws = Draws::new(42);
    for _ in 0..BEDS / 10 {
        let (b, w, n) = (draws.between(0.2, 1.5), draws.between(0.2, 1.5), 5e4);
        let (share, angle) = (draws.between(0.02, 0.98), draws.between(0.0, FRAC_PI_2));
        let bed = BedEdge {
            width_m: b,
            depth_m: Some(w),
            strength_pa: Some(n / (share * b * w)),
        };
        let d = [angle.cos(), angle.sin()];
        let normals = (0..=STEPS).map(|step| FRAC_PI_2 * step as f64 / STEPS as f64);
        let limits = normals.map(|of| outermost(b, w, share, of) / (of.cos() * d[0] + of.sin() * d[1]));
        let expected = n * limits.fold(f64::INFINITY, f64::min);
        let found = bed.moment_towards_n_m(n, d);
        assert!(
            (found / expected - 1.0).abs() < 2e-5,
            "b {b} w {w} share {share} angle {angle}: {found} {expected}"
        );
    }
}

#[test]
fn holds_along_its_sides_the_block_is_that_of_one_plane_and_a_square_is_weaker_towards_its_corners() {
    let mut draws = Draws::new(43);
    for _ in 0..BEDS {
        let (b, w, n) = (draws.between(0.2, 1.5), draws.between(0.2, 1.5), 5e4);
        let share = draws.between(0.01, 0.99);
        let bed = BedEdge {
            width_m: b,
            depth_m: Some(w),
            strength_pa: Some(n / (share * b * w)),
        };
        let [along, across] = [[1.0, 0.0], [0.0, -1.0]].map(|of| bed.moment_towards_n_m(n, of));
        assert!((along / bed.moment_n_m(n) - 1.0).abs() < 1e-12);
        assert!((across / bed.across().moment_n_m(n) - 1.0).abs() < 1e-12);
        assert_eq!(bed.across().across(), bed);
        // an additional moment is limited by the capacity of the bed
        let there = [0.2 * along, 0.1 * across];
        let growing = [draws.between(0.0, 1.0), draws.between(-1.0, 1.0)];
        let times = bed.reach(n, there, growing);
        let end = [there[0] + times * growing[0], there[1] + times * growing[1]];
        let limit = bed.moment_towards_n_m(n, end);
        assert!(
            (end[0].hypot(end[1]) / limit - 1.0).abs() < 1e-9,
            "{share} {growing:?}"
        );
    }
    // if half of a square is crushed: the centre of a triangle with half its area is at (1/6, 1/6), that of a strip at 1/4
    let bed = BedEdge {
        width_m: 1.0,
        depth_m: Some(1.0),
        strength_pa: Some(2.0),
    };
    let corner = bed.moment_towards_n_m(1.0, [1.0, 1.0]);
    assert!((corner - 2.0_f64.sqrt() / 6.0).abs() < 1e-12, "{corner}");
    assert!((bed.moment_towards_n_m(1.0, [1.0, 0.0]) - 0.25).abs() < 1e-12);
    // crushed by its own weight
    assert_eq!(bed.moment_towards_n_m(2.5, [1.0, 1.0]), 0.0);
    assert_eq!(bed.reach(2.5, [0.0; 2], [1.0, 1.0]), 0.0);
}

#[test]
fn exact_springs_under_a_bed_are_softer_across_by_the_square_of_its_sides() {
    const CELLS: usize = 400;
    for (b, w) in [(0.7, 0.3), (0.5, 0.5), (0.4, 1.1)] {
        let bed = BedEdge {
            width_m: b,
            depth_m: Some(w),
            strength_pa: None,
        };
        // Σ k dA x² and Σ k dA y² of equal springs
        let place = |i: usize, side: f64| ((i as f64 + 0.5) / CELLS as f64 - 0.5) * side;
        let squares = |side: f64| (0..CELLS).map(|i| place(i, side).powi(2)).sum::<f64>() * CELLS as f64;
        let ratio = squares(w) / squares(b);
        assert!(
            (bed.stiffness_ratio_across() / ratio - 1.0).abs() < 1e-9,
            "{b} {w}"
        );
    }
}
