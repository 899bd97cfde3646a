//! What a log of the project says of its structure.

use dolmen::monitoring::LoggedTrend;
use dolmen_project::{LogKind, LogPart};

/// Days, and usual gaps between readings, without a reading from which on a log has fallen silent. Chosen here.
const SILENT_DAYS: f64 = 7.0;
const SILENT_GAPS: f64 = 5.0;

/// What a log of the project says; tilts are ratios, widths m.
#[derive(Clone, Debug)]
pub struct WatchedLog {
    /// As the project says.
    pub part: LogPart,
    /// What was wrong with the file.
    pub rows: LogRows,
    /// What it says.
    pub trend: LoggedTrend,
}

/// Rows of a file that say less than they should.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LogRows {
    /// Rows without a reading.
    pub gaps: usize,
    /// Rows whose time was there already: the last one counts.
    pub repeated: usize,
    /// Rows before the one above them.
    pub set_back: usize,
    /// Rows of a wrong clock, left out.
    pub misdated: usize,
}

impl WatchedLog {
    /// Whether it reads a tilt.
    pub fn is_tilt(&self) -> bool {
        matches!(self.part.kind, LogKind::Tilt { .. })
    }

    /// Whether it is at its limit.
    pub fn is_beyond(&self) -> bool {
        self.trend.is_beyond_limit()
    }

    /// The last day with a reading, where something newer is known of the structure than that by a week and by five usual gaps of the log.
    pub fn silent_since(&self, newest: Option<f64>) -> Option<f64> {
        let days = &self.trend.daily.days;
        let last = *days.last()?;
        let mut gaps: Vec<f64> = days.windows(2).map(|pair| pair[1] - pair[0]).collect();
        gaps.sort_by(f64::total_cmp);
        let usual = gaps.get(gaps.len() / 2).copied().unwrap_or(1.0);
        (newest? - last > SILENT_DAYS.max(SILENT_GAPS * usual)).then_some(last)
    }

    /// The first and the last day that counted, from 1970-01-01.
    pub fn span(&self) -> Option<[f64; 2]> {
        let days = &self.trend.daily.days;
        Some([*days.first()?, *days.last()?])
    }
}
