//! Results of a log of the project.

use crate::near_limit::is_near;
use dolmen::monitoring::LoggedTrend;
use dolmen_project::{LogKind, LogPart};

/// A log is silent if this many days, and this many of its usual intervals, pass without a reading. Our choice.
const SILENT_DAYS: f64 = 7.0;
const SILENT_GAPS: f64 = 5.0;

/// Results of a log of the project; tilts are ratios, widths m.
#[derive(Clone, Debug)]
pub struct WatchedLog {
    /// Its entry in the project.
    pub part: LogPart,
    /// Faults of the file.
    pub rows: LogRows,
    /// The trend.
    pub trend: LoggedTrend,
}

/// Rows of a file that are incomplete or doubtful.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LogRows {
    /// Rows without a reading.
    pub gaps: usize,
    /// Rows with a repeated time: the last one counts.
    pub repeated: usize,
    /// Rows with an earlier time than the row above.
    pub set_back: usize,
    /// Rows with a wrong clock, left out.
    pub misdated: usize,
    /// Whether the last row of the file is one of them.
    pub ends_misdated: bool,
}

impl WatchedLog {
    /// Whether it records a tilt.
    pub fn is_tilt(&self) -> bool {
        matches!(self.part.kind, LogKind::Tilt { .. })
    }

    /// Whether it is at its limit.
    pub fn is_beyond(&self) -> bool {
        self.trend.is_beyond_limit()
    }

    /// Whether the readings are near their limit, but have not reached it.
    pub fn is_near(&self) -> bool {
        let judged = self.trend.size_to_judge();
        let share = self.trend.limit.map(|limit| match limit.is_one_sided {
            true => judged / limit.size,
            false => (judged / limit.size).abs(),
        });
        !self.is_beyond() && share.is_some_and(is_near)
    }

    /// The last day with a reading, if other data are newer by a week and by five usual intervals of the log.
    pub fn silent_since(&self, newest: Option<f64>) -> Option<f64> {
        let days = &self.trend.daily.days;
        let last = *days.last()?;
        let mut gaps: Vec<f64> = days.windows(2).map(|pair| pair[1] - pair[0]).collect();
        gaps.sort_by(f64::total_cmp);
        let usual = gaps.get(gaps.len() / 2).copied().unwrap_or(1.0);
        (newest? - last > SILENT_DAYS.max(SILENT_GAPS * usual)).then_some(last)
    }

    /// The first and the last day in use, from 1970-01-01.
    pub fn span(&self) -> Option<[f64; 2]> {
        let days = &self.trend.daily.days;
        Some([*days.first()?, *days.last()?])
    }
}
