//! Options of stochastic subspace identification.

/// Options of [`ssi_cov`](crate::modal::ssi_cov) and [`ssi_data`](crate::modal::ssi_data).
#[derive(Clone, Debug, PartialEq)]
pub struct Ssi {
    /// Block rows br, at the rate after decimation: at least half a period of the lowest mode; at least 2.
    pub block_rows: usize,
    /// Highest model order, even, at most channels × (block_rows - 1) and reference channels × block_rows; at least
    /// twice the expected number of modes.
    pub order_most: usize,
    /// Samples before over samples after a low-pass filter of the correlations; 1 (default): no decimation.
    pub decimation: usize,
    /// Number of consecutive blocks of time whose scatter gives the standard deviations; default 30 (a standard
    /// deviation is then accurate to 13 %); at least 2.
    pub time_blocks: usize,
    /// Channels whose past is correlated with the future of all channels, by index; empty (default): all. Fewer
    /// channels need less computation, but a mode without motion at all of them is lost.
    pub references: Vec<usize>,
}

impl Default for Ssi {
    fn default() -> Self {
        Ssi {
            block_rows: 30,
            order_most: 60,
            decimation: 1,
            time_blocks: 30,
            references: Vec::new(),
        }
    }
}
