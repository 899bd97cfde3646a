//! First root at which a polynomial becomes negative. No root is missed, however short the negative interval.

/// Largest number of coefficients of a polynomial.
pub(crate) const COEFFICIENTS_MOST: usize = 40;
/// Number of halvings of [0, 1] after which an interval is a point: 2⁻⁵² is the resolution of numbers near 1.
const HALVINGS_MOST: u32 = 52;

/// The first σ in [`from`, 1] at which p(σ) = Σ c_k σᵏ becomes negative; `None` if p stays at or above zero.
///
/// A double root that p only touches does not count. If p is already negative at `from`, the result is `from`.
///
/// On an interval, p lies within the hull of its Bernstein coefficients. If all of them are positive, the interval has no root. If
/// they change sign once, it has exactly one, which is located by bisection and secants. Other intervals are halved. So two close
/// roots are found too, within the precision of p.
///
/// # Source
/// Farouki, R. T. (2012) The Bernstein polynomial basis: a centennial retrospective. Comput. Aided Geom. Des. 29:379-419, §§ 3, 5.
pub(crate) fn first_descent(c: &[f64], from: f64) -> Option<f64> {
    // near σ = 0 the sign of p is that of its first coefficient
    let c = if from == 0.0 {
        &c[c.iter().take_while(|x| **x == 0.0).count()..]
    } else {
        c
    };
    let (&first, rest) = c.split_first()?;
    // most calls end here: the other coefficients cannot reduce p to zero
    if first > falls_most(rest) || stays_up(c) {
        return None;
    }
    let mut bernstein = [0.0; COEFFICIENTS_MOST];
    let b = &mut bernstein[..c.len()];
    to_bernstein(c, b);
    if from > 0.0 {
        let mut left = [0.0; COEFFICIENTS_MOST];
        split(b, from, &mut left[..c.len()]);
    }
    descend(c, b, from, 1.0, HALVINGS_MOST)
}

/// Largest reduction of p on [0, 1] by negative coefficients.
fn falls_most(c: &[f64]) -> f64 {
    c.iter().map(|c| if *c < 0.0 { -c } else { 0.0 }).sum()
}

/// Whether the cubic of the first four coefficients, by its Bernstein coefficients, stays above the largest reduction by the other
/// coefficients, including rounding.
fn stays_up(c: &[f64]) -> bool {
    let Some((&[c0, c1, c2, c3], rest)) = c.split_first_chunk::<4>() else {
        return false;
    };
    let rounding = 8.0 * f64::EPSILON * (c0.abs() + c1.abs() + c2.abs() + c3.abs());
    let floor = falls_most(rest) + rounding;
    let third = c1 / 3.0;
    [c0, c0 + third, c0 + 2.0 * third + c2 / 3.0, c0 + c1 + c2 + c3]
        .into_iter()
        .all(|b| b > floor)
}

/// Bernstein coefficients b_j = Σ_{k ≤ j} C(j, k)/C(d, k) c_k on [0, 1], by differences, without binomial coefficients.
fn to_bernstein(c: &[f64], b: &mut [f64]) {
    let degree = c.len() - 1;
    // c_k / C(d, k)
    let mut binomial = 1.0;
    for (k, (b, c)) in b.iter_mut().zip(c).enumerate() {
        *b = c / binomial;
        binomial *= (degree - k) as f64 / (k + 1) as f64;
    }
    for row in 1..=degree {
        let mut before = b[row - 1];
        for b in &mut b[row..] {
            let own = *b;
            *b += before;
            before = own;
        }
    }
}

/// De Casteljau's algorithm: splits an interval at the fraction `at`. `b` becomes the coefficients of the right part, `left` those
/// of the left part.
fn split(b: &mut [f64], at: f64, left: &mut [f64]) {
    let n = b.len();
    for (row, left) in left.iter_mut().enumerate() {
        *left = b[0];
        for j in 0..n - 1 - row {
            b[j] += at * (b[j + 1] - b[j]);
        }
    }
}

fn descend(c: &[f64], b: &[f64], low: f64, high: f64, halvings: u32) -> Option<f64> {
    if b[0] < 0.0 {
        return Some(low);
    }
    let mut changes = 0;
    let mut positive = true;
    for &x in b {
        if x != 0.0 && (x > 0.0) != positive {
            positive = !positive;
            changes += 1;
        }
    }
    match changes {
        0 => return None,
        // one sign change, from positive to negative: one root
        1 => return Some(locate(c, low, high)),
        _ => {}
    }
    if halvings == 0 {
        return Some(low);
    }
    let mut right = [0.0; COEFFICIENTS_MOST];
    let mut left = [0.0; COEFFICIENTS_MOST];
    let (right, left) = (&mut right[..b.len()], &mut left[..b.len()]);
    right.copy_from_slice(b);
    split(right, 0.5, left);
    let middle = 0.5 * (low + high);
    descend(c, left, low, middle, halvings - 1).or_else(|| descend(c, right, middle, high, halvings - 1))
}

/// The only root in [low, high], by the Illinois method with bisection, to adjacent floating-point numbers.
fn locate(c: &[f64], mut low: f64, mut high: f64) -> f64 {
    let (mut at_low, mut at_high) = (polynomial(c, low), polynomial(c, high));
    // p may be zero or rounded at the low end: by its coefficients it first increases from there
    at_low = at_low.max(f64::MIN_POSITIVE);
    if at_high >= 0.0 {
        return high;
    }
    let mut side = 0;
    for round in 0..200 {
        let width = high - low;
        if width <= f64::EPSILON * high {
            break;
        }
        let mut x = (low * at_high - high * at_low) / (at_high - at_low);
        if round % 8 == 7 || !(x > low && x < high) {
            x = 0.5 * (low + high);
            if x <= low || x >= high {
                break;
            }
        }
        let y = polynomial(c, x);
        if y == 0.0 {
            return x;
        }
        if y > 0.0 {
            (low, at_low) = (x, y);
            if side == 1 {
                at_high *= 0.5;
            }
            side = 1;
        } else {
            (high, at_high) = (x, y);
            if side == -1 {
                at_low *= 0.5;
            }
            side = -1;
        }
    }
    high
}

/// Upper bound of |Σ c_k σᵏ| on [0, 1]: Σ |c_k|.
pub(crate) fn polynomial_most(c: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    let fours = c.chunks_exact(4);
    let rest: f64 = fours.remainder().iter().map(|c| c.abs()).sum();
    for four in fours {
        for (lane, c) in lanes.iter_mut().zip(four) {
            *lane += c.abs();
        }
    }
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]) + rest
}

/// Σ c_k σᵏ.
pub(crate) fn polynomial(c: &[f64], sigma: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, &c| sum * sigma + c)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients of the product of (1 − σ/root), with its sign.
    fn from_roots(roots: &[f64]) -> Vec<f64> {
        let mut c = vec![1.0];
        for root in roots {
            let mut next = vec![0.0; c.len() + 1];
            for (k, x) in c.iter().enumerate() {
                next[k] += x;
                next[k + 1] -= x / root;
            }
            c = next;
        }
        c
    }

    #[test]
    fn exact_first_of_several_roots() {
        let near = |c: &[f64], from, wanted: f64| {
            let found = first_descent(c, from).unwrap();
            assert!((found - wanted).abs() < 1e-13, "{found} for {wanted}");
        };
        near(&from_roots(&[0.3]), 0.0, 0.3);
        near(&from_roots(&[0.8, 0.3, 2.0]), 0.0, 0.3);
        // two roots 0.001 apart, with the same sign at both ends
        let pair = from_roots(&[0.4, 0.401]);
        assert!(polynomial(&pair, 0.0) > 0.0 && polynomial(&pair, 1.0) > 0.0);
        assert!((first_descent(&pair, 0.0).unwrap() - 0.4).abs() < 1e-11);
        // after the first negative interval the next descent is at the third root
        near(&from_roots(&[0.2, 0.5, 0.7]), 0.5 + 1e-9, 0.7);
        assert_eq!(first_descent(&from_roots(&[0.2, 0.5, 1.7]), 0.5 + 1e-9), None);
        // a high degree
        let mut c = from_roots(&[0.9, 1.1, 1.2, -0.5, 3.0, -2.0, 5.0, 1.05, -1.0, -7.0, 2.2, 1.6]);
        c.resize(20, 0.0);
        assert!((first_descent(&c, 0.0).unwrap() - 0.9).abs() < 1e-11);
    }

    #[test]
    fn exact_none_and_touching() {
        assert_eq!(first_descent(&[1.0, -0.999], 0.0), None);
        assert_eq!(first_descent(&from_roots(&[1.5, -2.0]), 0.0), None);
        assert_eq!(first_descent(&[0.0, 1.0, -0.5], 0.0), None);
        // zero at the start, then decreasing
        assert_eq!(first_descent(&[0.0, -1.0], 0.0), Some(0.0));
        // (σ − ½)² touches zero exactly in binary
        assert_eq!(first_descent(&[0.25, -1.0, 1.0], 0.0), None);
        // first increasing, then decreasing
        assert!((first_descent(&[0.0, 1.0, -2.0], 0.0).unwrap() - 0.5).abs() < 1e-15);
        assert!((first_descent(&[0.0, 1.0, -4.0], 0.0).unwrap() - 0.25).abs() < 1e-15);
        assert!((first_descent(&[0.0, 0.0, 1.0, -4.0], 0.0).unwrap() - 0.25).abs() < 1e-15);
        // already negative
        assert_eq!(first_descent(&[-1e-3, 1.0], 0.0), Some(0.0));
    }
}
