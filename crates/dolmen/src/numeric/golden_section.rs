//! The maximum of a function with a single peak in an interval, by golden sections.

/// Fraction of an interval that a golden section keeps.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// The position of the maximum of `f` between `low` and `high`, for a single peak. The relative accuracy is about 1e-8, because `f`
/// is flat to rounding there.
pub(crate) fn maximum_between(f: &impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    const WIDTH_LEAST: f64 = 1e-9; // relative
    let floor = WIDTH_LEAST * WIDTH_LEAST * (high - low); // ends the search of a maximum at 0
    let (mut low, mut high) = (low, high);
    let mut inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let mut values = inner.map(f);
    while high - low > (WIDTH_LEAST * low.abs().max(high.abs())).max(floor) {
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

    #[test]
    fn exact_top_at_an_end_that_is_zero() {
        let evaluations = std::cell::Cell::new(0);
        let falling = |x: f64| {
            evaluations.set(evaluations.get() + 1);
            -x
        };
        let top = maximum_between(&falling, 0.0, 1.0);
        assert!((0.0..1e-17).contains(&top), "{top}");
        assert!(evaluations.get() < 100, "{}", evaluations.get());
    }
}
