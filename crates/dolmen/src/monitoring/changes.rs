//! Detects changes of a series, with date and size, by regression on weather and change together for all possible dates.

use super::critical::{disturbed, limit_of, probability_of};
use super::regression::Fit;
use super::scan::{Candidate, ChangeForm, column, scan, strongest};
use super::series::Series;
use super::whitening::Disturbance;
use crate::numeric::Random;

/// Decrease of −2 ln of the likelihood up to which another date of a step is in the 95 % interval: (1 − e^(−x/2))² = 0.95.
///
/// Source: Eo & Morley (2015) Quantitative Economics 6:463-497, table 1.
pub(super) const STEP_DATES: f64 = 7.35;
/// Limit for the date of a slope, which is a regular parameter: χ² with one degree of freedom.
const SLOPE_DATES: f64 = 3.84;
/// Relative distance from the limit within which a simulation of the series itself decides.
const NEAR_LIMIT: f64 = 0.2;
/// Longest series with a simulated limit. For longer series the table is sufficient, because their disturbance is well known.
const SIMULATED_MOST: usize = 400;
/// Number of larger simulated statistics at which a simulation ends. Besag & Clifford (1991) Biometrika 78:301-304.
const LARGER_MOST: usize = 20;
/// Largest number of changes in one series. Our choice.
const CHANGES_MOST: usize = 6;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Seeking {
    /// Probability of finding a change in any of the modes although there is none.
    pub(super) significance: f64,
    /// Number of modes in the search.
    pub(super) modes: usize,
    /// Largest number of simulated series.
    pub(super) replicates: usize,
    pub(super) seed: u64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DetectedChange {
    pub(super) change: Candidate,
    /// First and last survey at which the change may have begun.
    pub(super) earliest: usize,
    pub(super) latest: usize,
    /// Probability of a change this strong in any mode by chance.
    pub(super) p_value: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Changes {
    pub(super) found: Vec<DetectedChange>,
    /// A step only in the last one or two surveys: no lasting change yet.
    pub(super) late: Option<Candidate>,
    /// Disturbance with all changes in the regression.
    pub(super) disturbance: Disturbance,
    /// Smallest step halfway through the series that would be found with 80 % probability.
    pub(super) seen_from: f64,
    /// The fit with all changes, and its columns.
    pub(super) fit: Fit,
    pub(super) columns: Vec<Vec<f64>>,
}

/// Correlation of two successive surveys, including the noise of the readings.
pub(super) fn effective_correlation(series: &Series, of: Disturbance) -> f64 {
    let noise = series.noise_sd.iter().map(|sd| sd * sd).sum::<f64>() / series.len() as f64;
    let variance = of.sd * of.sd;
    of.correlation * variance / (variance + noise).max(f64::MIN_POSITIVE)
}

/// The probability adjusted for all modes together.
fn family(p: f64, modes: usize) -> f64 {
    -(modes as f64 * (-p).ln_1p()).exp_m1()
}

/// Probability by chance of a change at least this strong in this series, by simulation. All quantities that are estimated from the series
/// are estimated again for each simulated series.
fn simulated(
    series: &Series,
    columns: &[Vec<f64>],
    of: Disturbance,
    statistic: f64,
    how: (usize, u64),
) -> f64 {
    let (replicates, seed) = how;
    let (mut larger, mut done) = (0, 0);
    for replicate in 0..replicates {
        let mut random = Random::new(seed, replicate as u64);
        let made = Series {
            readings: disturbed(&series.at, &series.noise_sd, of, &mut random),
            ..series.clone()
        };
        if let Some(found) = strongest(&made, columns, Some(of)) {
            done += 1;
            larger += usize::from(found.change.statistic.abs() >= statistic);
        }
        if larger == LARGER_MOST {
            return larger as f64 / done as f64;
        }
    }
    (larger + 1) as f64 / (done + 1) as f64
}

/// Searches for changes one after the other, each in addition to the earlier ones, until the remaining ones may be chance.
pub(super) fn changes(series: &Series, weather: &[Vec<f64>], how: &Seeking) -> Option<Changes> {
    let alone = 1.0 - (1.0 - how.significance).powf(1.0 / how.modes as f64);
    let n = series.len();
    let mut found: Vec<(Candidate, f64)> = Vec::new();
    let mut late: Option<Candidate> = None;
    let with = |(found, late): (&[(Candidate, f64)], Option<Candidate>), but: Option<usize>| {
        let mut columns = weather.to_vec();
        let kept = found.iter().enumerate().filter(|(i, _)| Some(*i) != but);
        let kept = kept.map(|(_, (change, _))| *change).chain(late);
        columns.extend(kept.map(|change| column(&series.at, change.form, change.from)));
        columns
    };
    let mut disturbance = super::regression::restricted_likelihood(series, weather, None)?;
    while found.len() < CHANGES_MOST {
        let columns = with((&found, late), None);
        if n < columns.len() + 6 {
            break;
        }
        let Some(best) = strongest(series, &columns, Some(disturbance)) else {
            break;
        };
        let statistic = best.change.statistic.abs();
        // estimated without a change: with a change, the disturbance would be underestimated
        let correlation = effective_correlation(series, best.without);
        let limit = limit_of(alone, n, correlation);
        // otherwise a step in the last surveys would be found as a drift with wrong start and size
        let later = best
            .late
            .filter(|of| late.is_none() && of.statistic.abs() > statistic.max(limit));
        if later.is_some() {
            late = later;
            disturbance = best.without;
            continue;
        }
        let mut p = probability_of(statistic, n, correlation);
        if (statistic / limit - 1.0).abs() <= NEAR_LIMIT && n <= SIMULATED_MOST && how.replicates > 0 {
            let seed = (how.replicates, how.seed);
            p = simulated(series, &columns, best.without, statistic, seed);
        }
        if p > alone {
            break;
        }
        found.push((best.change, p));
        disturbance = best.disturbance;
        // each date is searched again, together with the other changes
        for i in 0..found.len() {
            let columns = with((&found, late), Some(i));
            let fit = Fit::new(series, &columns, disturbance)?;
            if let Some(again) = scan(series, &columns, &fit).strongest() {
                found[i].0 = again;
            }
        }
    }
    let columns = with((&found, late), None);
    disturbance = super::regression::restricted_likelihood(series, &columns, Some(disturbance))?;
    let fit = Fit::new(series, &columns, disturbance)?;
    // the size is estimated with all other columns in the regression
    let beside = with((&found, None), None);
    let late = late.and_then(|of| {
        let scanned = scan(series, &beside, &Fit::new(series, &beside, disturbance)?);
        scanned.late.into_iter().find(|other| other.from == of.from)
    });
    let dated = found.iter().enumerate().filter_map(|(i, (change, p))| {
        dated(
            series,
            &with((&found, late), Some(i)),
            disturbance,
            (*change, family(*p, how.modes)),
        )
    });
    let mut found: Vec<DetectedChange> = dated.collect();
    found.sort_by_key(|found| found.change.from);
    let limit = limit_of(alone, n, effective_correlation(series, disturbance));
    let steps = scan(series, &columns, &fit).all;
    let mut sds: Vec<f64> = steps
        .iter()
        .filter(|change| change.form == ChangeForm::Step)
        .map(|change| change.sd)
        .collect();
    sds.sort_by(f64::total_cmp);
    const OF_POWER: f64 = 0.8416212335729143; // z of 80 %
    Some(Changes {
        found,
        late,
        disturbance,
        seen_from: sds
            .get(sds.len() / 2)
            .map_or(f64::INFINITY, |sd| power_factor(n) * (limit + OF_POWER) * sd),
        fit,
        columns,
    })
}

/// Ratio of the step that is found with 80 % probability to the step whose statistic exceeds the limit with 80 % probability. Before the
/// step is known, part of it is attributed to the disturbance, more so with few surveys.
///
/// Measured on simulated histories of three modes with known weather and a disturbance with correlation 0.3 (`examples/watch_power.rs`,
/// the table of steps found); interpolated linearly in ln n. The ratio is smaller for disturbances without correlation.
fn power_factor(surveys: usize) -> f64 {
    const MEASURED: [(f64, f64); 5] = [(15.0, 2.7), (25.0, 2.25), (40.0, 2.2), (80.0, 1.5), (200.0, 1.0)];
    let ln_n = (surveys as f64).ln();
    let after = MEASURED.iter().position(|(n, _)| n.ln() >= ln_n);
    match after {
        None => MEASURED[MEASURED.len() - 1].1,
        Some(0) => MEASURED[0].1,
        Some(i) => {
            let ((n0, f0), (n1, f1)) = (MEASURED[i - 1], MEASURED[i]);
            f0 + (ln_n - n0.ln()) / (n1.ln() - n0.ln()) * (f1 - f0)
        }
    }
}

/// A change with its possible dates.
fn dated(
    series: &Series,
    columns: &[Vec<f64>],
    of: Disturbance,
    (change, p_value): (Candidate, f64),
) -> Option<DetectedChange> {
    let fit = Fit::new(series, columns, of)?;
    let all = scan(series, columns, &fit).all;
    let same = all.iter().filter(|other| other.form == change.form);
    let strongest = same.clone().find(|other| other.from == change.from)?;
    let fall = match change.form {
        ChangeForm::Step => STEP_DATES,
        ChangeForm::Slope => SLOPE_DATES,
    };
    let as_likely = same.filter(|other| other.statistic.powi(2) >= strongest.statistic.powi(2) - fall);
    let (earliest, latest) = as_likely.fold((change.from, change.from), |(low, high), other| {
        (low.min(other.from), high.max(other.from))
    });
    Some(DetectedChange {
        change: *strongest,
        earliest,
        latest,
        p_value,
    })
}
