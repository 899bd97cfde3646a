//! Growth of sizes measured in inspections: the width of a crack, the gap of a joint, the settlement of a part.

use super::MonitoringError;
use super::tilt::{Level, SlopeLimit, TiltSeeking, TiltSeries, TiltTrend, tilt_trend};

/// Sizes of one damage, from successive inspections.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GrowthSeries {
    /// The day of each reading, ascending.
    pub days: Vec<f64>,
    /// Readings, m.
    pub sizes_m: Vec<f64>,
    /// Standard deviation of the error of each reading, m; 0 if unknown.
    pub reading_sds_m: Vec<f64>,
}

/// Options of [`growth`].
#[derive(Clone, Debug, PartialEq)]
pub struct GrowthOptions {
    /// Days of repairs, each with its index: after each, the size has a new level.
    pub repairs: Vec<(usize, f64)>,
    /// The largest allowed size, m.
    pub limit_m: Option<f64>,
    /// Probability by chance below which a slope is significant.
    pub significance: f64,
    /// Largest number of simulated series for a change near the limit of chance.
    pub replicates: usize,
    /// Seed of the simulated series.
    pub seed: u64,
}

/// The slope of a size over the years, fitted as for a tilt, with a yearly wave, repairs, steps and changes of slope. The ratios in the result are
/// sizes, m, and the limit applies on the positive side only.
///
/// The scatter is at least the error of reading: equal readings with a coarse gauge do not prove that the slope is exactly 0.
///
/// ```text
/// Cov e = σ_r² I + s² φ^|Δt|,   σ_r² = mean of σ_i²        e: n
/// ```
///
/// # Errors
/// [`MonitoringError::Option`] for readings that are not finite or not in order; [`MonitoringError::Numeric`].
pub fn growth(series: GrowthSeries, options: &GrowthOptions) -> Result<TiltTrend, MonitoringError> {
    let finite = series.sizes_m.iter().chain(&series.reading_sds_m);
    if let Some(given) = finite.copied().find(|value| !value.is_finite() || *value < 0.0) {
        return Err(MonitoringError::Option {
            option: "size_m",
            given,
            allowed: "finite, 0 or more",
        });
    }
    let is_wrong = |pair: &&[f64]| !pair[1].is_finite() || pair[0] >= pair[1];
    if let Some(pair) = series.days.windows(2).find(is_wrong) {
        return Err(MonitoringError::Option {
            option: "days",
            given: pair[1],
            allowed: "after the day before it",
        });
    }
    let n = series.sizes_m.len().max(1) as f64;
    let square = series.reading_sds_m.iter().map(|sd| sd * sd).sum::<f64>() / n;
    let levels: Vec<Level> = options
        .repairs
        .iter()
        .map(|(work, day)| Level {
            work: *work,
            day: *day,
        })
        .collect();
    let seeking = TiltSeeking {
        significance: options.significance,
        limit: options.limit_m.map(|size| SlopeLimit {
            size,
            is_one_sided: true,
        }),
        reading_sd: square.sqrt(),
        replicates: options.replicates,
        seed: options.seed,
    };
    let as_tilt = TiltSeries {
        direction: String::new(),
        datum: None,
        surveys: (0..series.days.len()).collect(),
        days: series.days,
        ratios: series.sizes_m,
    };
    tilt_trend(as_tilt, &levels, &seeking)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::monitoring::weather::YEAR_DAYS;
    use crate::numeric::Random;

    fn options(limit_m: Option<f64>) -> GrowthOptions {
        GrowthOptions {
            repairs: Vec::new(),
            limit_m,
            significance: 0.05,
            replicates: 0,
            seed: 1,
        }
    }

    fn yearly(sizes_m: Vec<f64>, sd_m: f64) -> GrowthSeries {
        let n = sizes_m.len();
        GrowthSeries {
            days: (0..n).map(|i| YEAR_DAYS * i as f64).collect(),
            reading_sds_m: vec![sd_m; n],
            sizes_m,
        }
    }

    #[test]
    fn exact_the_slope_of_readings_on_a_line_is_as_sure_as_the_readings_are() {
        // by hand: σ / √Σ(t − t̄)², of t = 0 … 6 years: σ / √28
        let sizes: Vec<f64> = (0..7).map(|i| 2e-4 + 5e-5 * f64::from(i)).collect();
        let found = growth(yearly(sizes, 3e-5), &options(Some(1e-3)))
            .unwrap()
            .slope
            .unwrap();
        assert!((found.per_year - 5e-5).abs() < 1e-12, "{found:?}");
        assert!(
            (found.sd_per_year / (3e-5 / 28f64.sqrt()) - 1.0).abs() < 1e-3,
            "{found:?}"
        );
        // 0.5 mm now, 0.05 mm a year, 1 mm in 10 years
        let reach = found.reach.unwrap();
        assert!((reach.years.unwrap() - 10.0).abs() < 1e-6, "{reach:?}");
    }

    #[test]
    fn holds_readings_of_a_coarse_gauge_that_are_all_alike_show_no_exact_zero() {
        let sd = 1e-4 / 12f64.sqrt();
        let found = growth(yearly(vec![3e-4; 6], sd), &options(None))
            .unwrap()
            .slope
            .unwrap();
        assert!(
            found.per_year.abs() < 1e-12 && found.sd_per_year > 6e-6,
            "{found:?}"
        );
        assert!(found.seen_from_per_year > 2e-5, "{found:?}");
    }

    #[test]
    fn holds_the_interval_of_rounded_readings_holds_the_truth_as_often_as_it_says() {
        // twelve yearly readings to 0.1 mm of a crack that opens by 0.04 mm a year, with another observer each time (0.05 mm)
        let (mut held, mut seen, drawn) = (0, 0, 400);
        for seed in 0..drawn {
            let mut random = Random::new(31, seed);
            let truth = 4e-5;
            let sizes: Vec<f64> = (0..12)
                .map(|i| {
                    let read = 2e-4 + truth * f64::from(i) + 5e-5 * random.normal();
                    (read.max(0.0) * 1e4).round() / 1e4
                })
                .collect();
            let found = growth(yearly(sizes, 1e-4 / 12f64.sqrt()), &options(None)).unwrap();
            let Some(slope) = found.slope.filter(|_| found.changes.is_empty()) else {
                continue;
            };
            let quantile = crate::numeric::student_two_sided_quantile(0.05, 8.0).unwrap();
            held += usize::from((slope.per_year - truth).abs() < quantile * slope.sd_per_year);
            seen += usize::from(found.is_beyond_chance());
        }
        assert!((360..=400).contains(&held), "{held} of {drawn}");
        assert!(seen > 380, "{seen} of {drawn}");
    }

    #[test]
    fn refuses_readings_that_are_no_sizes() {
        let mut wrong = yearly(vec![1e-4, f64::NAN], 0.0);
        assert!(growth(wrong.clone(), &options(None)).is_err());
        wrong.sizes_m = vec![1e-4, 2e-4];
        wrong.days.reverse();
        assert!(growth(wrong, &options(None)).is_err());
    }
}
