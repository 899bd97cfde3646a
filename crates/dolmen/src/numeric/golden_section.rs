//! The maximum of a function with a single peak in an interval, by golden sections.

/// Fraction of an interval that a golden section keeps.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// The position of the maximum of `f` between `low` and `high`, for a single peak; accurate to the
/// square root of rounding.
pub(crate) fn maximum_between(f: &impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    const WIDTH_LEAST: f64 = 1e-9; // relative: a maximum is flat to rounding over 1e-8
    let (mut low, mut high) = (low, high);
    let mut inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let mut values = inner.map(f);
    while high - low > WIDTH_LEAST * high.abs() {
        if values[0] >= values[1] {
            high = inner[1];
            inner = [high - GOLDEN * (high - low), inner[0]];
            values = [f(inner[0]), values[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + GOLDEN * (high - low)];
            values = [values[1], f(inner[1])];
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_top_of_a_parabola() {
        let top = maximum_between(&|x: f64| 3.0 - (x - 0.7) * (x - 0.7), 0.1, 1.0);
        assert!((top - 0.7).abs() < 1e-7, "{top}");
    }
}
