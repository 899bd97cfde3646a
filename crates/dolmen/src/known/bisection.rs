//! Bisection of a sign change: slow, but simple enough to contain no error.

/// Bisects a sign change of `f` between `low` and `high` down to adjacent floating-point numbers. The caller
/// guarantees opposite signs.
pub(super) fn sign_change(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const HALVINGS: usize = 200; // more than the 64 bits of a number need
    let positive = f(low) > 0.0;
    for _ in 0..HALVINGS {
        let middle = low + 0.5 * (high - low);
        if middle == low || middle == high {
            break;
        }
        if (f(middle) > 0.0) == positive {
            low = middle;
        } else {
            high = middle;
        }
    }
    low + 0.5 * (high - low)
}
