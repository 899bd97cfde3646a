//! The newest readings of a tilt, where they are far from what the earlier ones predict: a slip of writing, or a structure that moved.

use super::regression::{Fit, restricted_likelihood};
use super::series::Series;
use super::tilt_outliers::{ALONE, READINGS_LEAST, usual_step};
use crate::numeric::student_two_sided;

/// Probability of such a reading by chance below which it is off. Our choice: a history of twenty series gives a false one in 5,000.
const OFF_BELOW: f64 = 1e-5;
/// Largest number of newest readings that are off together. Three are a step.
pub(super) const NEWEST_MOST: usize = 2;
/// Fewest readings beyond the number of columns.
const SPARE_LEAST: usize = 5;

/// The newest readings, which are off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltLast {
    /// Index of the first of them.
    pub from: usize,
    /// The last reading as the earlier ones predict it.
    pub expected: f64,
    /// Standard deviation of this prediction, with the scatter of a reading.
    pub sd: f64,
}

/// The newest one or two readings, if a regression of the others on their part of `columns` predicts them otherwise. `series` and `columns` hold all
/// readings. `None` if a column is constant before them: a work after the last reading but one explains them.
pub(super) fn last_off(series: &Series, columns: &[Vec<f64>]) -> Option<TiltLast> {
    (1..=NEWEST_MOST).find_map(|newest| off(series, columns, newest))
}

fn off(series: &Series, columns: &[Vec<f64>], newest: usize) -> Option<TiltLast> {
    let n = series.len();
    let until = n.checked_sub(newest)?;
    let degrees = until.checked_sub(columns.len())?;
    if until < READINGS_LEAST || degrees < SPARE_LEAST {
        return None;
    }
    let own: Vec<Vec<f64>> = columns.iter().map(|column| column[..until].to_vec()).collect();
    if own
        .iter()
        .skip(1)
        .any(|column| column.iter().all(|x| *x == column[0]))
    {
        return None;
    }
    let before = Series {
        at: series.at[..until].to_vec(),
        readings: series.readings[..until].to_vec(),
        noise_sd: series.noise_sd[..until].to_vec(),
    };
    let disturbance = restricted_likelihood(&before, &own, None)?;
    let fit = Fit::new(&before, &own, disturbance)?;
    let judged = |i: usize| -> Option<(f64, f64, f64)> {
        let mut row: Vec<f64> = columns.iter().map(|column| column[i]).collect();
        let expected: f64 = row.iter().zip(&fit.coefficients).map(|(x, beta)| x * beta).sum();
        let step = usual_step(&before.readings, until..until, expected);
        let (noise, rounding) = (series.noise_sd[i], step / 12f64.sqrt());
        let variance = disturbance.sd.powi(2) + noise * noise + rounding * rounding + fit.form(&mut row);
        let (off, sd) = (series.readings[i] - expected, variance.sqrt());
        let p_value = student_two_sided(off / sd, degrees as f64).ok()?;
        (p_value < OFF_BELOW && off.abs() > ALONE * step.max(noise)).then_some((expected, sd, off))
    };
    let all: Option<Vec<(f64, f64, f64)>> = (until..n).map(judged).collect();
    let all = all?;
    let (expected, sd, off) = *all.last()?;
    let is_one_side = all.iter().all(|(_, _, other)| other * off > 0.0);
    is_one_side.then_some(TiltLast {
        from: until,
        expected,
        sd,
    })
}

#[cfg(test)]
mod tests {
    use super::super::tilt::{SlopeLimit, TiltSeeking, TiltSeries, TiltTrend, tilt_trend};
    use super::super::weather::YEAR_DAYS;
    use super::*;
    use crate::numeric::Random;

    fn seen(days: Vec<f64>, ratios: Vec<f64>) -> TiltTrend {
        let how = TiltSeeking {
            significance: 0.05,
            limit: Some(SlopeLimit {
                size: 6.67e-3,
                is_one_sided: false,
            }),
            reading_sd: 0.0,
            replicates: 0,
            seed: 1,
        };
        let series = TiltSeries {
            direction: "x".into(),
            datum: None,
            surveys: (0..days.len()).collect(),
            days,
            ratios,
        };
        tilt_trend(series, &[], &how).unwrap()
    }

    /// Yearly readings of a tilt that grows by 0.25 mm/m a year from 3 mm/m, with a standard deviation of 0.03 mm/m.
    fn yearly(count: u32, seed: u64) -> (Vec<f64>, Vec<f64>) {
        let mut random = Random::new(11, seed);
        (0..count)
            .map(|i| {
                let read = 3e-3 + 2.5e-4 * f64::from(i) + 3e-5 * random.normal();
                (YEAR_DAYS * f64::from(i), read)
            })
            .unzip()
    }

    #[test]
    fn holds_a_slip_in_the_last_reading_is_found_and_spoils_no_forecast() {
        for seed in 0..4 {
            for (newest, factor) in [(1, 0.1), (1, -1.0), (1, 10.0), (2, 0.1), (2, 10.0)] {
                let (days, mut ratios) = yearly(12, seed);
                let n = ratios.len();
                ratios[n - newest..].iter_mut().for_each(|ratio| *ratio *= factor);
                let found = seen(days, ratios);
                let is_asked = found.is_sign_in_question() || !found.changes.is_empty();
                let Some(off) = found.last_off else {
                    assert!(is_asked, "{seed} {newest} {factor}: {found:?}");
                    continue;
                };
                // 3 mm/m and eleven years of 0.25
                assert_eq!(off.from, n - newest);
                assert!((off.expected - 5.75e-3).abs() < 4.0 * off.sd, "{off:?}");
                let slope = found.slope.unwrap();
                assert!(
                    (slope.per_year - 2.5e-4).abs() < 4.0 * slope.sd_per_year,
                    "{slope:?}"
                );
                assert!(slope.sd_per_year < 1e-5);
                let years = slope.reach.unwrap().years.unwrap();
                assert!((years - (6.67 - 5.75) / 0.25).abs() < 0.6, "{years}");
            }
        }
    }

    #[test]
    fn holds_readings_without_scatter_show_a_slip_in_the_last() {
        let days: Vec<f64> = (0..12).map(|i| YEAR_DAYS * f64::from(i)).collect();
        let ratios = (0..12).map(|i| if i == 11 { 0.5e-3 } else { 5e-3 }).collect();
        assert_eq!(seen(days, ratios).last_off.map(|of| of.from), Some(11));
    }

    #[test]
    fn holds_sound_histories_end_with_no_reading_that_is_off() {
        let shapes: [fn(f64) -> f64; 5] = [
            |_| 3.0,
            |t| 3.0 + 0.25 * t,
            |t| 3.0 + 0.03 * t * t,
            |t| 3.0 + 0.3 * (t - 4.0).max(0.0),
            |t| if t < 3.0 { 3.0 } else { 4.0 },
        ];
        let mut off = 0;
        for (kind, shape) in shapes.into_iter().enumerate() {
            for seed in 0..100 {
                let mut random = Random::new(12 + kind as u64, seed);
                let (mut drift, count) = (0.0, 12 + 2 * (seed % 10) as u32);
                let times: Vec<f64> = (0..count).map(|i| 0.5 * f64::from(i)).collect();
                let read = |t: &f64| {
                    drift = 0.6 * drift + 0.04 * random.normal();
                    let read = shape(*t) + drift + 0.03 * random.normal();
                    // every other history is rounded to 0.1 mm/m
                    if seed % 2 == 0 {
                        read
                    } else {
                        (10.0 * read).round() / 10.0
                    }
                };
                let series = Series {
                    at: (0..count).map(f64::from).collect(),
                    readings: times.iter().map(read).collect(),
                    noise_sd: vec![0.0; count as usize],
                };
                let last = times[times.len() - 1];
                let columns = [vec![1.0; times.len()], times.iter().map(|t| t - last).collect()];
                off += usize::from(last_off(&series, &columns).is_some());
            }
        }
        assert_eq!(off, 0);
    }
}
