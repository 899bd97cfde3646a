//! Posts at the sides of a pole in its elevations.

/// Thickness of a post, smallest clearance to the pole, and height of the post above the highest support, as fractions of the total
/// height. Our choice: the file gives none of them.
const THICKNESS: f64 = 0.035;
const CLEARANCE: f64 = 0.012;
const HEAD: f64 = 0.02;
/// A gap is drawn as this fraction of the clearance. Our choice: true gaps are too small to see.
const GAP_SHARE: f64 = 0.5;

/// A side support for drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DrawnSupport {
    /// Above the ground, m.
    pub(super) height_m: f64,
    /// Whether it has no gap.
    pub(super) is_tight: bool,
}

/// Posts and supports of the pole, m: across, up.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SidePosts {
    /// Left and right post, corners in order.
    pub(super) posts: Vec<Vec<[f64; 2]>>,
    /// From the post towards the pole, reaching it if tight.
    pub(super) wedges: Vec<[[f64; 2]; 2]>,
}

/// Posts on both sides of a pole up to its highest support; `half_width_m` gives that of the pole at a height.
pub(super) fn side_posts(
    supports: &[DrawnSupport],
    half_width_m: &dyn Fn(f64) -> f64,
    height_m: f64,
) -> SidePosts {
    let top = supports
        .iter()
        .map(|of| of.height_m)
        .fold(f64::NEG_INFINITY, f64::max);
    if supports.is_empty() {
        return SidePosts::default();
    }
    let top = top + HEAD * height_m;
    const STEPS: u32 = 64; // points along the pole, whose links have steps
    let widest = (0..=STEPS).map(|step| half_width_m(top * f64::from(step) / f64::from(STEPS)));
    let inner = widest.fold(0.0, f64::max) + CLEARANCE * height_m;
    let outer = inner + THICKNESS * height_m;
    let mut drawn = SidePosts::default();
    for side in [-1.0, 1.0] {
        drawn.posts.push(vec![
            [side * inner, 0.0],
            [side * outer, 0.0],
            [side * outer, top],
            [side * inner, top],
        ]);
        for support in supports {
            let face = half_width_m(support.height_m);
            let end = match support.is_tight {
                true => face,
                false => face + GAP_SHARE * (inner - face),
            };
            drawn
                .wedges
                .push([[side * inner, support.height_m], [side * end, support.height_m]]);
        }
    }
    drawn
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_tight_wedge_meets_the_pole_and_one_with_a_gap_does_not() {
        let support = |height_m, is_tight| DrawnSupport { height_m, is_tight };
        let drawn = side_posts(&[support(3.0, true), support(1.0, false)], &|_| 0.3, 10.0);
        assert_eq!(drawn.posts.len(), 2);
        let ends: Vec<f64> = drawn.wedges.iter().map(|wedge| wedge[1][0].abs()).collect();
        assert_eq!(ends[0], 0.3);
        assert!(ends[1] > 0.3 && ends[1] < drawn.wedges[1][0][0].abs(), "{ends:?}");
        let top = drawn.posts[0][2][1];
        assert!(top > 3.0 && top < 3.5, "{top}");
        assert_eq!(side_posts(&[], &|_| 0.3, 10.0), SidePosts::default());
    }
}
