//! How near a size may come to its limit.

use dolmen::stability::stack::DemandVerdict;

/// Relative rounding error of a share.
const ROUNDING: f64 = 1e-9;

/// Whether a size is near its limit, or has reached it: the limit is at most 1.25 times the size, so that the size is 80 % of the limit or
/// more. This is the same as for a [demand](DemandVerdict::NEAR_BELOW), and holds for tilts, cracks and other damage, of surveys and of logs.
pub(crate) fn is_near(share_of_limit: f64) -> bool {
    share_of_limit * DemandVerdict::NEAR_BELOW >= 1.0 - ROUNDING
}

#[cfg(test)]
mod tests {
    use super::is_near;

    #[test]
    fn exact_near_begins_at_four_fifths_of_the_limit() {
        for (share, near) in [
            (0.79, false),
            (0.8, true),
            (1.0, true),
            (1.3, true),
            (f64::NAN, false),
        ] {
            assert_eq!(is_near(share), near, "{share}");
        }
    }
}
