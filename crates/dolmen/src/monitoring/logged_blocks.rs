//! Medians of daily readings over several days.

use super::daily::DailyReadings;
use super::series::Series;
use super::wave::yearly_wave;
use super::weather::YEAR_DAYS;
use crate::numeric::middle_mean;

/// Medians over this number of days each.
pub(super) struct Blocks {
    pub(super) begins: Vec<f64>,
    pub(super) days: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) temperatures_c: Vec<f64>,
}

impl Blocks {
    /// `splits`: days with which a new median begins, so that none holds days before and after a step. The rest before a split joins the median before
    /// it if it is shorter than half a median.
    pub(super) fn of(daily: &DailyReadings, temperatures_c: &[f64], block_days: f64, splits: &[f64]) -> Self {
        let n = daily.days.len();
        let mut blocks = Blocks {
            begins: Vec::new(),
            days: Vec::new(),
            values: Vec::new(),
            temperatures_c: Vec::new(),
        };
        let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
        let (mut from, mut first) = (0, daily.days.first().copied().unwrap_or(0.0));
        while from < n {
            let day = daily.days[from];
            let split = splits.iter().copied().filter(|at| *at > day);
            let split = split.fold(f64::INFINITY, f64::min);
            if splits.contains(&day) {
                first = day;
            }
            let mut end = first + (((day - first) / block_days).floor() + 1.0) * block_days;
            if split - end < 0.5 * block_days {
                end = split;
            }
            let to = daily.days.partition_point(|day| *day < end);
            blocks.begins.push(daily.days[from]);
            blocks.days.push(mean(&daily.days[from..to]));
            blocks.values.push(middle_mean(daily.values[from..to].to_vec()));
            if let Some(of) = temperatures_c.get(from..to) {
                blocks.temperatures_c.push(mean(of));
            }
            from = to;
        }
        blocks
    }

    /// Columns of level and slope on the last day, season, temperature, and a step at each work. Also returns the indices of the works.
    pub(super) fn columns(&self, last: f64, works: &[[f64; 2]]) -> (Vec<Vec<f64>>, Vec<usize>) {
        let n = self.days.len();
        let mut columns = vec![
            vec![1.0; n],
            self.days.iter().map(|day| (day - last) / YEAR_DAYS).collect(),
        ];
        let wave = yearly_wave(&self.days, &columns);
        columns.extend(wave);
        if !self.temperatures_c.is_empty() {
            let mean = self.temperatures_c.iter().sum::<f64>() / n as f64;
            columns.push(self.temperatures_c.iter().map(|t| t - mean).collect());
        }
        let first_level = columns.len();
        let mut found: Vec<usize> = Vec::new();
        for (work, [at, _]) in works.iter().enumerate() {
            let before: Vec<f64> = self
                .days
                .iter()
                .map(|day| f64::from(u8::from(day < at)))
                .collect();
            // two works between two readings give one shift
            let is_new = columns.iter().skip(first_level).all(|column| *column != before);
            if before.contains(&1.0) && before.contains(&0.0) && is_new {
                columns.push(before);
                found.push(work);
            }
        }
        (columns, found)
    }

    /// The medians as a series, with times in usual gaps.
    pub(super) fn series(&self) -> Series {
        let first = self.days.first().copied().unwrap_or(0.0);
        let gap = usual_gap(&self.days).max(f64::MIN_POSITIVE);
        Series {
            at: self.days.iter().map(|day| (day - first) / gap).collect(),
            readings: self.values.clone(),
            noise_sd: vec![0.0; self.days.len()],
        }
    }
}

/// The median gap between neighbouring days.
pub(super) fn usual_gap(days: &[f64]) -> f64 {
    let mut gaps: Vec<f64> = days.windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_by(f64::total_cmp);
    gaps.get(gaps.len() / 2).copied().unwrap_or(1.0)
}
