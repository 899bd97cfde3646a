//! Medians of daily readings over several days.

use super::daily::DailyReadings;
use crate::numeric::middle_mean;

/// Medians over this number of days each.
pub(super) struct Blocks {
    pub(super) begins: Vec<f64>,
    pub(super) days: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) temperatures_c: Vec<f64>,
}

impl Blocks {
    pub(super) fn of(daily: &DailyReadings, temperatures_c: &[f64], block_days: f64) -> Self {
        let first = daily.days.first().copied().unwrap_or(0.0);
        let block = |day: f64| ((day - first) / block_days).floor();
        let mut blocks = Blocks {
            begins: Vec::new(),
            days: Vec::new(),
            values: Vec::new(),
            temperatures_c: Vec::new(),
        };
        let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
        let mut from = 0;
        while from < daily.days.len() {
            let own = block(daily.days[from]);
            let to = daily.days.partition_point(|day| block(*day) <= own);
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
}
