//! Options of poly-reference least squares.

/// Options of [`plscf`](crate::modal::plscf).
#[derive(Clone, Debug, PartialEq)]
pub struct Plscf {
    /// Longest lag M of the correlations at the rate after decimation, at least 4; the spacing of the lines is 1/((M + 1) dt).
    pub lags: usize,
    /// Highest model order, reference channels × degree: all multiples of the number of reference channels up to it are fitted.
    pub order_most: usize,
    /// Samples before over samples after a low-pass filter of the correlations; 1 (default): no decimation.
    pub decimation: usize,
    /// Number of consecutive blocks of time whose scatter gives the standard deviations; default 30; at least 2.
    pub time_blocks: usize,
    /// Reference channels, by index; empty (default): all.
    pub references: Vec<usize>,
    /// Value of the exponential window at the last lag, above 0 and at most 1; default 0.01 (Peeters & Van der Auweraer 2005 use
    /// 0.1 to 1 %). Its decay is removed from the damping.
    pub window_end: f64,
    /// Lowest fitted line, Hz; default 0.
    pub frequency_low_hz: f64,
    /// Highest fitted line, Hz; default infinite: all lines.
    pub frequency_high_hz: f64,
}

impl Default for Plscf {
    fn default() -> Self {
        Plscf {
            lags: 200,
            order_most: 60,
            decimation: 1,
            time_blocks: 30,
            references: Vec::new(),
            window_end: 0.01,
            frequency_low_hz: 0.0,
            frequency_high_hz: f64::INFINITY,
        }
    }
}
