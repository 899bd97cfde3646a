//! Removes the mean or the least-squares line.

use super::{Processing, Record};

/// The trend that is removed from each channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Trend {
    /// The mean: the offset of an accelerometer at rest.
    #[default]
    Mean,
    /// The least-squares line: the drift of a sensor.
    Line,
}

/// Subtracts the mean or the least-squares line from each channel.
///
/// ```text
/// Mean   y_i = x_i - x̄
/// Line   y_i = x_i - x̄ - b (i - ī)      b = Σ (i - ī) x_i / Σ (i - ī)²      ī = (n - 1) / 2
/// ```
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, Trend, detrend};
/// let record = Record::new(vec![Channel::named("x")], vec![vec![1.0, 2.0, 3.0]], 100.0)?;
/// assert_eq!(detrend(record, Trend::Mean).samples(0), [-1.0, 0.0, 1.0]);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn detrend(mut record: Record, trend: Trend) -> Record {
    for channel in 0..record.channels().len() {
        let x = record.samples_mut(channel);
        let n = x.len() as f64;
        let mean = x.iter().sum::<f64>() / n;
        let middle = 0.5 * (n - 1.0);
        let slope = match trend {
            Trend::Mean => 0.0,
            Trend::Line => {
                let moment: f64 = x
                    .iter()
                    .enumerate()
                    .map(|(i, v)| (i as f64 - middle) * (v - mean))
                    .sum();
                moment / (n * (n * n - 1.0) / 12.0) // Σ (i - ī)² of n equidistant points
            }
        };
        for (i, v) in x.iter_mut().enumerate() {
            *v -= mean + slope * (i as f64 - middle);
        }
    }
    record.note(Processing::Detrend {
        degree: match trend {
            Trend::Mean => 0,
            Trend::Line => 1,
        },
    });
    record
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;

    fn bent(offset: f64, slope: f64) -> Record {
        let x = (0..500).map(|i| offset + slope * i as f64 + (0.37 * i as f64).sin());
        Record::new(vec![Channel::named("a")], vec![x.collect()], 50.0).unwrap()
    }

    #[test]
    fn holds_any_line_leaves_the_same_rest() {
        let (plain, sloped) = (
            detrend(bent(0.0, 0.0), Trend::Line),
            detrend(bent(7.0, -0.03), Trend::Line),
        );
        for (a, b) in plain.samples(0).iter().zip(sloped.samples(0)) {
            assert!((a - b).abs() < 1e-13, "{a} {b}");
        }
    }

    #[test]
    fn exact_nothing_is_left_of_a_line() {
        let line = (0..500).map(|i| 3.0 - 0.25 * i as f64).collect();
        let record = Record::new(vec![Channel::named("a")], vec![line], 50.0).unwrap();
        let mean_only = detrend(record.clone(), Trend::Mean);
        assert!((mean_only.samples(0)[0] - 0.25 * 249.5).abs() < 1e-12);
        let rest = detrend(record, Trend::Line);
        assert!(rest.samples(0).iter().all(|v| v.abs() < 1e-12));
        assert_eq!(rest.history(), [Processing::Detrend { degree: 1 }]);
    }
}
