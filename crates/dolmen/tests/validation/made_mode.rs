//! A mode in the form of an analysis, for tests that use its shape.

use dolmen::modal::Mode;
use dolmen_linalg::Complex64;

/// A mode given by its frequency and shape only, with 600 cycles.
pub(crate) fn made_mode(frequency_hz: f64, shape: Vec<Complex64>) -> Mode {
    Mode {
        frequency_hz,
        frequency_sd_hz: None,
        frequency_changes_hz: vec![],
        damping_ratio: None,
        damping_ratio_sd: None,
        shape,
        shape_sd: None,
        phase_collinearity: 1.0,
        cycles: 600.0,
        orders: vec![],
        kurtosis: None,
        wander: None,
        window_bias: None,
        accepted: None,
    }
}
