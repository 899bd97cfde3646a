//! Analyses the whole history of a structure: changes, alarms and tilts.

use super::MonitoringError;
use super::alarm::{AlarmOptions, JudgedMode, ModeAlarm, alarm_limit, judge};
use super::changes::{Changes, Seeking, changes};
use super::fitted_mode::{FittedMode, FittedReading};
use super::history::{History, HistorySurvey};
use super::lost::{LostMode, UnseenMode, is_beyond_chance, lost, unseen};
use super::outliers::outliers;
use super::scan::ChangeForm;
use super::t_squared::{SurveyTSquared, t_squared};
use super::tilt::{Level, SlopeLimit, TiltSeeking, TiltSeries, TiltTrend, tilt_trend};
use super::tilt_marks::carry;
use super::tilt_signs::without_forecast;
use super::tracking::{Track, Tracked, Tracking, track};
use super::unknown_temperatures::{filled, with_temperature};
use super::watched_mode::{LastOff, WatchedChange, WatchedMode, WeatherEffect, WorkEffect};
use super::weather::{ModeSeries, WeatherKnown, YEAR_DAYS, columns, earned, has_temperature, knows_frost};
use crate::numeric::middle;

/// Fewest surveys in a history.
const SURVEYS_LEAST: usize = 3;
/// Days after the last survey within which a work answers alarms. Our choice: a work dated a year ahead is only planned, or its date is wrong.
pub const ANSWERED_DAYS: f64 = 366.0;
/// Fewest surveys of a mode for a search of changes. Our choice: with fewer, no change can exceed the limit of chance.
const READINGS_LEAST: usize = 8;
/// Correlation of temperature and time above which it is reported, as in the comparison of two surveys.
const WITH_TIME: f64 = 0.7;

/// Options of [`watch`].
#[derive(Clone, Debug, PartialEq)]
pub struct WatchOptions {
    /// Options of tracking the modes.
    pub tracking: Tracking,
    /// Probability of a false finding in any mode; default 0.05.
    pub significance: f64,
    /// Mean time between false alarms of all modes together, years; default 10.
    pub years_between_false_alarms: f64,
    /// Number of surveys for training before the first one is judged; default 10.
    pub training: usize,
    /// Weight of the newest survey in the moving average; default 0.2.
    pub weight: f64,
    /// Temperature below which stone freezes, °C; default 0.
    pub frost_below_c: f64,
    /// Largest allowed tilt, horizontal over vertical.
    pub tilt_limit: Option<f64>,
    /// Number of simulated histories for a change near the limit of chance; default 999. With 0, only the table is used.
    pub replicates: usize,
    /// Seed of the simulated histories.
    pub seed: u64,
}

impl Default for WatchOptions {
    fn default() -> Self {
        WatchOptions {
            tracking: Tracking::default(),
            significance: 0.05,
            years_between_false_alarms: 10.0,
            training: 10,
            weight: 0.2,
            frost_below_c: 0.0,
            tilt_limit: None,
            replicates: 999,
            seed: 1,
        }
    }
}

/// An alarm of the structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StructureAlarm {
    /// Index of the mode.
    pub mode: usize,
    /// The alarm.
    pub alarm: ModeAlarm,
    /// Whether a work or an inspection followed.
    pub is_answered: bool,
}

/// Result of watching a history.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    /// The modes.
    pub modes: Vec<WatchedMode>,
    /// Additional results of the tracking.
    pub tracked: Tracked,
    /// Confirmed alarms, by time.
    pub alarms: Vec<StructureAlarm>,
    /// Modes that are missing in the last surveys, without a later inspection.
    pub lost: Vec<LostMode>,
    /// Modes that the last surveys cannot show.
    pub unseen: Vec<UnseenMode>,
    /// Number of surveys times modes per allowed false alarm.
    pub surveys_between: f64,
    /// T² of each survey for which it can be computed.
    pub t_squared: Vec<SurveyTSquared>,
    /// Results for the tilts.
    pub tilts: Vec<TiltTrend>,
    /// Usual time between two surveys, days.
    pub interval_days: f64,
    /// Limit of the moving average, relative to its own standard deviation.
    pub average_limit: f64,
    /// Probability of at least one false alarm over the observed years.
    pub false_alarm_probability: f64,
    /// Significance of the search for changes.
    pub significance: f64,
}

impl Watched {
    /// The empty result for a history with too few surveys.
    pub fn nothing(significance: f64) -> Self {
        Watched {
            modes: Vec::new(),
            tracked: Tracked::default(),
            alarms: Vec::new(),
            lost: Vec::new(),
            unseen: Vec::new(),
            surveys_between: 1.0,
            t_squared: Vec::new(),
            tilts: Vec::new(),
            interval_days: 0.0,
            average_limit: 0.0,
            false_alarm_probability: 0.0,
            significance,
        }
    }

    /// Whether a mode is missing significantly, which is an alarm like that of a frequency.
    pub fn is_mode_lost(&self) -> bool {
        !self.lost.is_empty() && is_beyond_chance(&self.lost, self.surveys_between)
    }
}

/// Analyses a history: tracks the modes, removes the effect of weather, finds changes, and compares each survey and tilt with earlier ones.
///
/// ```text
/// f_i(t) = f_i0 [1 + β_i (T − T₀) + γ_i max(0, T_k − T) + changes] + e,   Cov e = diag(σ_i²) + s² φ^|Δt|
/// ```
///
/// # Errors
/// [`MonitoringError`] for an option out of range, or for data that cannot be analysed.
///
/// # Limits
/// For more than 1,000 surveys the limit of chance for 1,000 is used. Without temperatures a change cannot be separated from the weather; a yearly
/// wave is removed if the surveys cover more than two years.
pub fn watch(history: &History, options: &WatchOptions) -> Result<Watched, MonitoringError> {
    check(history, options)?;
    let tracked = track(&history.surveys, &options.tracking)?;
    let days: Vec<f64> = history.surveys.iter().map(|survey| survey.day).collect();
    let interval_days = middle(days.windows(2).map(|pair| pair[1] - pair[0]).collect());
    let count = tracked.tracks.len().max(1);
    let surveys_between = (options.years_between_false_alarms * YEAR_DAYS / interval_days).max(1.0);
    let alarm = AlarmOptions {
        weight: options.weight,
        training: options.training,
        limit: alarm_limit(options.weight, surveys_between * count as f64)?,
        frost_below_c: options.frost_below_c,
    };
    let modes: Vec<WatchedMode> = tracked
        .tracks
        .iter()
        .enumerate()
        .map(|(i, track)| {
            let seeking = Seeking {
                significance: options.significance,
                modes: count,
                replicates: options.replicates,
                seed: options.seed.wrapping_add(i as u64),
            };
            watched_mode(history, track, interval_days, (&seeking, &alarm))
        })
        .collect::<Result<_, _>>()?;
    let judged: Vec<JudgedMode> = modes.iter().map(|mode| mode.judged.clone()).collect();
    // works dated long after the last survey are only planned, or have a wrong date
    let answered_until = days[days.len() - 1] + ANSWERED_DAYS;
    let answered = |survey: usize| {
        history
            .works
            .iter()
            .any(|work| work.answers && work.day >= days[survey] && work.day <= answered_until)
    };
    let mut alarms: Vec<StructureAlarm> = judged
        .iter()
        .enumerate()
        .flat_map(|(mode, judged)| judged.alarms.iter().map(move |alarm| (mode, *alarm)))
        .map(|(mode, alarm)| StructureAlarm {
            mode,
            alarm,
            is_answered: answered(alarm.survey),
        })
        .collect();
    alarms.sort_by_key(|alarm| (alarm.alarm.survey, alarm.mode));
    let years = (days[days.len() - 1] - days[0]) / YEAR_DAYS;
    Ok(Watched {
        t_squared: t_squared(&judged, days.len())?,
        lost: lost(history, &tracked.tracks, &tracked.jumped, answered),
        unseen: unseen(history, &tracked.tracks),
        surveys_between: surveys_between * count as f64,
        modes,
        alarms,
        tilts: tilts(history, options)?,
        interval_days,
        average_limit: alarm.limit,
        false_alarm_probability: -(-years / options.years_between_false_alarms).exp_m1(),
        significance: options.significance,
        tracked,
    })
}

fn check(history: &History, options: &WatchOptions) -> Result<(), MonitoringError> {
    let surveys = &history.surveys;
    if surveys.len() < SURVEYS_LEAST {
        return Err(MonitoringError::TooFewSurveys {
            given: surveys.len(),
            least: SURVEYS_LEAST,
        });
    }
    let order = |survey: &HistorySurvey| {
        Err(MonitoringError::Order {
            survey: survey.name.clone(),
            day: survey.day,
        })
    };
    for pair in surveys.windows(2) {
        if pair[1].day <= pair[0].day || !pair[1].day.is_finite() || !pair[0].day.is_finite() {
            return order(&pair[1]);
        }
    }
    let bounds = [
        (
            "significance",
            options.significance,
            1e-4,
            0.5,
            "between 0.0001 and 0.5",
        ),
        (
            "years_between_false_alarms",
            options.years_between_false_alarms,
            0.1,
            1e4,
            "between 0.1 and 10,000",
        ),
        ("weight", options.weight, 0.01, 1.0, "between 0.01 and 1"),
        ("training", options.training as f64, 6.0, 1e6, "6 or more"),
    ];
    for (option, given, least, most, allowed) in bounds {
        if !(least..=most).contains(&given) {
            return Err(MonitoringError::Option {
                option,
                given,
                allowed,
            });
        }
    }
    Ok(())
}

/// The readings of a mode, relative to its median frequency.
fn series_of(history: &History, track: &Track, interval_days: f64) -> ModeSeries {
    let mut series = ModeSeries::default();
    for (survey, mode) in track.modes.iter().enumerate() {
        let (Some(mode), from) = (mode, &history.surveys[survey]) else {
            continue;
        };
        let mode = &from.modes[*mode];
        series.surveys.push(survey);
        series.days.push(from.day);
        series.temperatures_c.push(from.temperature_c.unwrap_or(f64::NAN));
        series
            .series
            .at
            .push((from.day - history.surveys[0].day) / interval_days);
        series
            .series
            .readings
            .push(mode.frequency_hz / track.frequency_hz - 1.0);
        series.series.noise_sd.push(
            mode.frequency_sd_hz
                .map_or(f64::NAN, |sd| sd / track.frequency_hz),
        );
    }
    // a missing standard deviation is replaced by that of the other surveys
    let stated = series.series.noise_sd.iter().copied().filter(|sd| sd.is_finite());
    let usual = middle(stated.collect());
    for sd in series.series.noise_sd.iter_mut().filter(|sd| !sd.is_finite()) {
        *sd = usual;
    }
    series
}

/// A mode before anything explains its readings.
fn unexplained(history: &History, track: &Track, judged: JudgedMode) -> WatchedMode {
    WatchedMode {
        track: track.clone(),
        weather: None,
        explained_hz: vec![None; history.surveys.len()],
        changes: Vec::new(),
        works: Vec::new(),
        seen_from_ratio: None,
        last_off: None,
        outliers: Vec::new(),
        strange: Vec::new(),
        guessed: Vec::new(),
        judged,
        fitted: None,
    }
}

fn watched_mode(
    history: &History,
    track: &Track,
    interval_days: f64,
    (seeking, alarm): (&Seeking, &AlarmOptions),
) -> Result<WatchedMode, MonitoringError> {
    let series = series_of(history, track, interval_days);
    let works: Vec<usize> = (0..history.works.len())
        .filter(|w| history.works[*w].splits)
        .collect();
    let level = |of: &ModeSeries, work: usize| of.days.iter().position(|day| *day >= history.works[work].day);
    let levels: Vec<usize> = works.iter().filter_map(|work| level(&series, *work)).collect();
    let mut mode = unexplained(history, track, judge(&series, &levels, alarm)?);
    let frost = knows_frost(&series, alarm.frost_below_c);
    let by_temperature = has_temperature(&series);
    let steps = |of: &ModeSeries| {
        let mut steps: Vec<(usize, Vec<f64>)> = Vec::new();
        for work in &works {
            let from = level(of, *work).unwrap_or(of.len());
            let step = super::scan::column(&of.series.at, ChangeForm::Step, from);
            if step.contains(&1.0) && step.contains(&0.0) && steps.iter().all(|(_, known)| *known != step) {
                steps.push((*work, step));
            }
        }
        steps
    };
    let read = series;
    let series = match by_temperature {
        true => {
            let levels: Vec<Vec<f64>> = steps(&with_temperature(&read))
                .into_iter()
                .map(|of| of.1)
                .collect();
            filled(&read, &levels, alarm.frost_below_c)
        }
        false => read.clone(),
    };
    let is_strange = |i: usize| {
        let t = series.temperatures_c[i];
        by_temperature && (t.is_nan() || (!frost && t < alarm.frost_below_c))
    };
    let alone = outliers(&series);
    mode.strange = (0..series.len())
        .filter(|i| is_strange(*i))
        .map(|i| series.surveys[i])
        .collect();
    mode.guessed = (0..series.len())
        .filter(|i| by_temperature && read.temperatures_c[*i].is_nan() && !is_strange(*i))
        .map(|i| series.surveys[i])
        .collect();
    mode.outliers = alone.iter().map(|i| series.surveys[*i]).collect();
    let kept = series.kept(|i| !is_strange(i) && !alone.contains(&i));
    if kept.len() < READINGS_LEAST {
        return Ok(mode);
    }
    let known: Vec<f64> = kept
        .temperatures_c
        .iter()
        .copied()
        .filter(|t| t.is_finite())
        .collect();
    let at = (
        known.iter().sum::<f64>() / known.len().max(1) as f64,
        alarm.frost_below_c,
    );
    let (dated, extra): (Vec<usize>, Vec<Vec<f64>>) = steps(&kept).into_iter().unzip();
    let weather = earned(&kept, &extra, at);
    let mut all = columns(&kept, weather, at);
    let of_weather = all.len();
    all.extend(extra);
    let Some(found) = changes(&kept.series, &all, seeking) else {
        return Ok(mode);
    };
    explain(
        &mut mode,
        (&kept, &found),
        weather,
        (of_weather, &dated, interval_days),
    );
    let beside = (0..series.len()).filter(|i| is_strange(*i) || alone.contains(i));
    let beside = beside.map(|i| FittedReading::beside(&series, i, (!is_strange(i)).then_some((weather, at))));
    mode.fitted = Some(FittedMode {
        series: kept.series,
        columns: found.columns,
        of_weather,
        disturbance: found.disturbance,
        surveys: kept.surveys,
        beside: beside.collect(),
    });
    Ok(mode)
}

/// Adds the explained frequencies, changes and effects of works to the mode.
fn explain(
    mode: &mut WatchedMode,
    (kept, found): (&ModeSeries, &Changes),
    weather: WeatherKnown,
    (of_weather, dated, interval_days): (usize, &[usize], f64),
) {
    let fit = &found.fit;
    let coefficient = |c: usize| (0.1 * fit.coefficients[c], 0.1 * fit.sd[c]);
    let is_line = matches!(
        weather,
        WeatherKnown::Temperature | WeatherKnown::TemperatureAndFrost
    );
    mode.weather = Some(WeatherEffect {
        known: weather,
        per_c: is_line.then(|| coefficient(1)),
        frost_per_c: (weather == WeatherKnown::TemperatureAndFrost).then(|| coefficient(2)),
        with_time: is_line
            .then(|| correlation(&kept.days, &kept.temperatures_c))
            .filter(|r| r.abs() > WITH_TIME),
        disturbance: found.disturbance,
    });
    for i in 0..kept.len() {
        let parts = found.columns.iter().zip(&fit.coefficients);
        let explained: f64 = parts.map(|(column, beta)| column[i] * beta).sum();
        mode.explained_hz[kept.surveys[i]] = Some(mode.track.frequency_hz * (1.0 + explained));
    }
    // the level before a change: the effects of works and earlier changes
    let level_before = |from: usize, but: usize| -> f64 {
        let steps = (of_weather..found.columns.len()).filter(|c| *c != but);
        let before = from.saturating_sub(1);
        let lifted: f64 = steps
            .map(|c| found.columns[c][before] * fit.coefficients[c])
            .sum();
        1.0 + fit.coefficients[0] + lifted
    };
    let of_works = dated.iter().enumerate().map(|(w, work)| {
        let c = of_weather + w;
        let from = found.columns[c].iter().position(|x| *x == 1.0).unwrap_or(0);
        let before = level_before(from, c);
        WorkEffect {
            work: *work,
            ratio: fit.coefficients[c] / before,
            sd: fit.sd[c] / before,
        }
    });
    mode.works = of_works.collect();
    mode.seen_from_ratio = Some(found.seen_from).filter(|least| least.is_finite());
    mode.last_off = found.late.map(|of| {
        let before = level_before(of.from, usize::MAX);
        LastOff {
            from: kept.surveys[of.from],
            surveys: kept.len() - of.from,
            ratio: of.size / before,
            sd: of.sd / before,
        }
    });
    let last = kept.series.at[kept.len() - 1];
    for change in &found.found {
        let from = change.change.from;
        let before = level_before(from, usize::MAX);
        let (lasts, per_year) = match change.change.form {
            ChangeForm::Step => (1.0, None),
            ChangeForm::Slope => {
                let yearly = change.change.size * YEAR_DAYS / interval_days;
                (last - kept.series.at[from], Some(yearly / before))
            }
        };
        let survey = |i: usize| kept.surveys[i.min(kept.len() - 1)];
        let is_step = change.change.form == ChangeForm::Step;
        mode.changes.push(WatchedChange {
            form: change.change.form,
            from: survey(from),
            after: survey(change.earliest.saturating_sub(usize::from(is_step))),
            before: survey(change.latest),
            ratio: change.change.size * lasts / before,
            sd: change.change.sd * lasts / before,
            per_year,
            p_value: change.p_value,
        });
    }
}

fn correlation(x: &[f64], y: &[f64]) -> f64 {
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (mx, my) = (mean(x), mean(y));
    let sum = |f: &dyn Fn(f64, f64) -> f64| x.iter().zip(y).map(|(a, b)| f(a - mx, b - my)).sum::<f64>();
    sum(&|a, b| a * b) / (sum(&|a, _| a * a) * sum(&|_, b| b * b)).sqrt()
}

/// The tilts of each direction and datum.
fn tilts(history: &History, options: &WatchOptions) -> Result<Vec<TiltTrend>, MonitoringError> {
    let mut all: Vec<TiltSeries> = Vec::new();
    for (survey, of) in history.surveys.iter().enumerate() {
        for tilt in &of.tilts {
            let same =
                |series: &&mut TiltSeries| series.direction == tilt.direction && series.datum == tilt.datum;
            let i = match all.iter_mut().position(|series| same(&&mut *series)) {
                Some(i) => i,
                None => {
                    all.push(TiltSeries {
                        direction: tilt.direction.clone(),
                        datum: tilt.datum.clone(),
                        surveys: Vec::new(),
                        days: Vec::new(),
                        ratios: Vec::new(),
                    });
                    all.len() - 1
                }
            };
            all[i].surveys.push(survey);
            all[i].days.push(of.day);
            all[i].ratios.push(tilt.ratio);
        }
    }
    let levels: Vec<Level> = history
        .works
        .iter()
        .enumerate()
        .filter(|(_, work)| work.splits)
        .map(|(work, of)| Level { work, day: of.day })
        .collect();
    // directions are tested together
    let alone = options.significance / all.len().max(1) as f64;
    let seeking = |i: usize| TiltSeeking {
        significance: alone,
        limit: options.tilt_limit.map(|size| SlopeLimit {
            size,
            is_one_sided: false,
        }),
        reading_sd: 0.0,
        replicates: options.replicates,
        seed: options.seed.wrapping_add(i as u64),
    };
    let mut trends: Vec<TiltTrend> = all
        .into_iter()
        .enumerate()
        .map(|(i, series)| tilt_trend(series, &levels, &seeking(i)))
        .collect::<Result<_, _>>()?;
    trends.iter_mut().for_each(without_forecast);
    carry(&mut trends, seeking(0).limit)?;
    Ok(trends)
}
