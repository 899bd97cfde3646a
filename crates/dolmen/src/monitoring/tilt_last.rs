//! The newest readings of a tilt, where they are far from what the earlier ones predict: a slip of writing, or a structure that moved.

use super::regression::{Fit, restricted_likelihood};
use super::series::Series;
use super::tilt_outliers::{ALONE, READINGS_LEAST, usual_step};
use crate::numeric::{student_two_sided, student_two_sided_quantile};

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
    /// Half the width of its 95 % interval, by Student's t.
    pub half_95: f64,
    /// Probability of a last reading as far off by chance.
    pub p_value: f64,
}

/// The newest one or two readings, if a regression of the others on their part of `columns` predicts them otherwise. `series` and `columns` hold all
/// readings. `None` if a column is constant before them: a work after the last reading but one explains them.
pub(super) fn last_off(series: &Series, columns: &[Vec<f64>]) -> Option<TiltLast> {
    (1..=NEWEST_MOST).find_map(|newest| off(series, columns, newest))
}

/// Whether so many readings and columns are enough for [`last_off`].
pub(super) fn are_enough(readings: usize, columns: usize) -> bool {
    let before = readings.saturating_sub(1);
    before >= READINGS_LEAST && before >= columns + SPARE_LEAST
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
    let judged = |i: usize| -> Option<(TiltLast, f64)> {
        let mut row: Vec<f64> = columns.iter().map(|column| column[i]).collect();
        let expected: f64 = row.iter().zip(&fit.coefficients).map(|(x, beta)| x * beta).sum();
        let step = usual_step(&before.readings, until..until, expected);
        let (noise, rounding) = (series.noise_sd[i], step / 12f64.sqrt());
        let variance = disturbance.sd.powi(2) + noise * noise + rounding * rounding + fit.form(&mut row);
        let (off, sd) = (series.readings[i] - expected, variance.sqrt());
        let p_value = student_two_sided(off / sd, degrees as f64).ok()?;
        let half_95 = sd * student_two_sided_quantile(0.05, degrees as f64).ok()?;
        let found = TiltLast {
            from: until,
            expected,
            sd,
            half_95,
            p_value,
        };
        (p_value < OFF_BELOW && off.abs() > ALONE * step.max(noise)).then_some((found, off))
    };
    on_one_side((until..n).map(judged))
}

/// The last of these, if there is each and all are off to the same side.
fn on_one_side(all: impl Iterator<Item = Option<(TiltLast, f64)>>) -> Option<TiltLast> {
    let all: Vec<(TiltLast, f64)> = all.collect::<Option<_>>()?;
    let (found, off) = *all.last()?;
    all.iter().all(|(_, other)| other * off > 0.0).then_some(found)
}

/// The newest one or two of readings too few for [`last_off`], against the mean of the k ≥ 2 before them since the last of `works` (its column is 1
/// before it). `significance`: largest probability of such a finding by chance.
///
/// ```text
/// t = (y − ȳ) / (s √(1 + 1/k)),   s² at least σ_r² + δ²/12,   k − 1 degrees of freedom        δ: finest step of the readings
/// ```
///
/// A steady growth of any rate is not off: readings on a line in equal gaps have t = √3 for every k.
///
/// # Source
/// Hahn and Meeker (1991) Statistical Intervals, section 4.7: prediction interval of one further observation.
pub(super) fn last_of_few(series: &Series, works: &[Vec<f64>], significance: f64) -> Option<TiltLast> {
    let level = significance / NEWEST_MOST as f64;
    (1..=NEWEST_MOST).find_map(|newest| off_level(series, works, (newest, level)))
}

fn off_level(series: &Series, works: &[Vec<f64>], (newest, level): (usize, f64)) -> Option<TiltLast> {
    let n = series.len();
    let until = n.checked_sub(newest)?;
    let is_of_level = |i: &usize| works.iter().all(|column| column[*i] == column[n - 1]);
    let from = (0..until).rev().take_while(is_of_level).last()?;
    let before = &series.readings[from..until];
    let k = before.len() as f64;
    let degrees = k - 1.0;
    if degrees < 1.0 {
        return None;
    }
    let mean = before.iter().sum::<f64>() / k;
    let square = before.iter().map(|own| (own - mean).powi(2)).sum::<f64>() / degrees;
    let step = usual_step(before, before.len()..before.len(), mean);
    let judged = |i: usize| -> Option<(TiltLast, f64)> {
        let least = series.noise_sd[i].powi(2) + step * step / 12.0;
        let sd = (square.max(least) * (1.0 + 1.0 / k)).sqrt();
        let off = series.readings[i] - mean;
        let p_value = student_two_sided(off / sd, degrees).ok()?;
        let half_95 = sd * student_two_sided_quantile(0.05, degrees).ok()?;
        let found = TiltLast {
            from: until,
            expected: mean,
            sd,
            half_95,
            p_value,
        };
        (p_value < level).then_some((found, off))
    };
    on_one_side((until..n).map(judged))
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

    fn few(readings: &[f64]) -> Option<TiltLast> {
        let series = Series {
            at: (0..readings.len()).map(|i| i as f64).collect(),
            readings: readings.to_vec(),
            noise_sd: vec![0.0; readings.len()],
        };
        last_of_few(&series, &[], 0.05)
    }

    #[test]
    fn exact_the_last_of_few_readings_by_hand() {
        // mean 0.18333, s 0.0057735 of three; sd = s √(4/3); t = 0.17667/0.0066667 = 26.5; p of two degrees: 1 − t/√(2 + t²)
        let found = few(&[0.18, 0.18, 0.19, 0.36]).unwrap();
        let p_value = 1.0 - 26.5 / (2.0_f64 + 26.5 * 26.5).sqrt();
        assert!(
            (found.p_value / p_value - 1.0).abs() < 1e-9,
            "{found:?} {p_value}"
        );
        assert!((found.half_95 - 4.30265 * found.sd).abs() < 1e-6 && found.from == 3);
        // two degrees of freedom fewer: p of one degree, 1 − 2 atan(t)/π, with s √(3/2)
        let found = few(&[3.0, 3.1, 6.6]).unwrap();
        let t: f64 = 3.55 / (0.1 / 2_f64.sqrt() * 1.5_f64.sqrt());
        assert!(
            (found.p_value - (1.0 - t.atan() / std::f64::consts::FRAC_PI_2)).abs() < 1e-9,
            "{found:?}"
        );
        // a line, and readings of one step
        for steady in [
            vec![3.0, 3.5, 4.0, 4.5, 5.0],
            vec![0.18, 0.18, 0.18, 0.19],
            vec![4.0, 5.0, 6.0],
        ] {
            assert_eq!(few(&steady), None, "{steady:?}");
        }
        let years = |ratios: &[f64]| {
            let days = (0..ratios.len()).map(|i| YEAR_DAYS * i as f64).collect();
            seen(days, ratios.iter().map(|of| 1e-3 * of).collect()).last_off
        };
        let eight = [3.05, 3.0, 3.1, 3.05, 3.0, 3.1, 3.05, 6.6];
        assert!(
            years(&eight).is_some_and(|of| of.p_value < 1e-7),
            "{:?}",
            years(&eight)
        );
        assert!(years(&[3.0, 3.1, 3.2, 6.6]).is_some());
    }

    #[test]
    fn holds_few_sound_readings_are_off_as_rarely_as_stated() {
        for (k, growth) in [
            (2, 0.0),
            (3, 0.0),
            (3, 0.5),
            (4, 2.0),
            (7, 0.0),
            (7, 0.3),
            (7, 3.0),
        ] {
            let drawn = 2000;
            let is_off = |seed: &u64| {
                let mut random = Random::new(41, *seed);
                let read = |i: i32| 3.0 + growth * f64::from(i) + random.normal();
                few(&(0..=k).map(read).collect::<Vec<f64>>()).is_some()
            };
            let off = (0..drawn).filter(is_off).count() as f64 / drawn as f64;
            assert!(
                off < 0.05 + 3.0 * (0.05 * 0.95 / drawn as f64).sqrt(),
                "{k} {growth}: {off}"
            );
        }
    }
}
