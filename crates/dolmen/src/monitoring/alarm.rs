//! The alarm: compares each new survey of a mode with the prediction from earlier ones.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | u_i | `score` | normal score of a survey: 0 as predicted; beyond ±3 in one of 370 | - |
//! | E_i | `average` | moving average of the scores | - |

use super::MonitoringError;
use super::ewma::ewma_limit;
use super::online::{Online, Reading};
use super::regression::restricted_likelihood;
use super::weather::{FROST_SURVEYS_LEAST, ModeSeries, WeatherKnown, columns, earned, explaining};
use super::whitening::Disturbance;
use crate::numeric::{normal_quantile, student_two_sided};

/// Limit of single scores; by chance, one in 370 is beyond it.
pub(super) const OUTSIDE: f64 = 3.0;
/// Number of readings outside the limit, among the last ones, that confirms an alarm.
const OUTSIDE_LEAST: usize = 3;
const AMONG: usize = 5;
/// Largest score in the average, so that one wrong survey hardly confirms an alarm. Our choice.
const SCORE_MOST: f64 = 3.0;
/// Surveys for the estimate of a new level.
const LEVEL_SURVEYS: usize = 3;
/// Fewest earlier surveys that were as cold or colder, and as warm or warmer, within a margin, °C. Our choice.
const TEMPERATURES_LEAST: usize = 3;
const MARGIN_C: f64 = 1.0;
/// Factor on the limit, because disturbance and weather are estimated. Without it, false alarms were 1.2 to 2.5 times as frequent as stated
/// (`examples/watch_power.rs`, with training repeated in each history).
const ALLOWANCE: f64 = 1.06;
/// Growth of the number of surveys after which the disturbance is estimated again. Our choice.
const AGAIN: f64 = 1.1;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct AlarmOptions {
    /// Weight of the newest score in the average; default 0.2.
    pub(super) weight: f64,
    /// Number of surveys for training before the first one is judged; default 10.
    pub(super) training: usize,
    /// Limit of the average over its standard deviation, [`alarm_limit`].
    pub(super) limit: f64,
    /// Temperature below which stone freezes, °C; default 0.
    pub(super) frost_below_c: f64,
}

/// Reason why a survey of a mode was not judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotJudged {
    /// Too few earlier surveys.
    Training,
    /// One of the first surveys after the structure was changed, or after an alarm: they determine the new level.
    NewLevel,
    /// Its temperature is outside the range of the surveys for training.
    Temperature,
    /// Its temperature is unknown, while the temperatures of the other surveys are known.
    NoTemperature,
}

/// Result for one survey of a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// Index of the survey.
    pub survey: usize,
    /// The predicted relative reading, and the standard deviation of reading minus prediction.
    pub predicted: Option<(f64, f64)>,
    /// Its score, or the reason why it has none.
    pub score: Result<f64, NotJudged>,
    /// The moving average over its limit; a value beyond ±1 is an alarm.
    pub average: f64,
}

/// The cause of an alarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlarmKind {
    /// The moving average exceeded its limit.
    Average,
    /// Three of the last five surveys were outside their limit.
    ThreeOfFive,
}

/// A confirmed alarm of one mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModeAlarm {
    /// Index of the confirming survey.
    pub survey: usize,
    /// The survey at which the change may have begun.
    pub since: usize,
    /// Its cause.
    pub kind: AlarmKind,
    /// The average, or the newest score outside its limit.
    pub value: f64,
    /// Its limit.
    pub limit: f64,
}

/// The surveys of one mode, judged one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct JudgedMode {
    /// Every survey with the mode.
    pub judged: Vec<Judged>,
    /// The alarms.
    pub alarms: Vec<ModeAlarm>,
}

/// The limit of the moving average over its standard deviation, for one false alarm of one mode in `run_length` surveys: the limit for known
/// parameters, times the allowance for estimated parameters.
///
/// # Errors
/// As [`ewma_limit`](super::ewma_limit).
pub(super) fn alarm_limit(weight: f64, run_length: f64) -> Result<f64, MonitoringError> {
    Ok(ALLOWANCE * ewma_limit(weight, run_length)?)
}

/// Judges each survey by the surveys before it.
///
/// ```text
/// z_i = (y_i − prediction)/sd of the difference,   u_i = Φ⁻¹(T_ν(z_i)),   E_i = (1 − λ) E_{i−1} + λ u_i
/// ```
/// The scores of a regression that is estimated from the earlier surveys are independent and normal (Hawkins 1987), so the limit of E is that of
/// known parameters. `levels` are indices of readings at which a new level begins (works).
pub(super) fn judge(
    series: &ModeSeries,
    levels: &[usize],
    options: &AlarmOptions,
) -> Result<JudgedMode, MonitoringError> {
    let h = options.limit * (options.weight / (2.0 - options.weight)).sqrt();
    let n = series.len();
    let known: Vec<f64> = series
        .temperatures_c
        .iter()
        .copied()
        .filter(|t| t.is_finite())
        .collect();
    let middle_c = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let at = (middle_c, options.frost_below_c);
    // a new level at the first survey has no effect
    let mut levels: Vec<usize> = levels.iter().copied().filter(|level| *level > 0).collect();
    let mut pool = Pool::default();
    let mut out = JudgedMode {
        judged: Vec::with_capacity(n),
        alarms: Vec::new(),
    };
    let mut model: Option<Model> = None;
    let mut scores = Scores::default();
    for i in 0..n {
        let temperature_c = series.temperatures_c[i];
        let active: Vec<usize> = levels.iter().copied().filter(|level| *level <= i).collect();
        let may_train = pool.used.len() >= options.training;
        let knows_frost = || pool.knows_frost(series, at.1);
        let is_due = |of: &Model| of.is_outgrown(pool.used.len(), &active) || of.with_frost != knows_frost();
        if may_train && model.as_ref().is_none_or(is_due) {
            model = Model::train(series, &pool, &active, at);
        }
        let row = model.as_ref().map(|model| model.row(series, i, at));
        let reading = row.as_ref().map(|row| Reading {
            at: series.series.at[i],
            noise_sd: series.series.noise_sd[i],
            row,
        });
        let predicted = model
            .as_ref()
            .zip(reading.as_ref())
            .and_then(|(model, reading)| Some((model.online.predict(reading)?, model.degrees_of_freedom())));
        let needs_temperature = model.as_ref().is_some_and(Model::needs_temperature);
        let learned = active.iter().max().map_or(usize::MAX, |from| pool.since(*from));
        let score = if model.is_none() {
            Err(NotJudged::Training)
        } else if needs_temperature && !temperature_c.is_finite() {
            Err(NotJudged::NoTemperature)
        } else if needs_temperature && !pool.has_seen(series, temperature_c) {
            Err(NotJudged::Temperature)
        } else if let (Some((prediction, degrees)), true) = (predicted, learned >= LEVEL_SURVEYS) {
            Ok(normal_score(prediction.score, degrees)?)
        } else {
            Err(NotJudged::NewLevel)
        };
        let is_outside = score.is_ok_and(|score| score.abs() > OUTSIDE);
        let confirmed = score
            .ok()
            .and_then(|score| scores.add(i, score, options.weight, h));
        out.judged.push(Judged {
            survey: series.surveys[i],
            predicted: predicted.map(|(p, _)| (p.expected, p.sd)),
            score,
            average: scores.average / h,
        });
        if is_outside {
            pool.outside.push(i);
        } else if score == Err(NotJudged::Temperature) {
            pool.waiting.push(i);
        } else if !needs_temperature || temperature_c.is_finite() {
            // waiting surveys are used as soon as a survey that can be judged agrees with its prediction
            let is_released = score.is_ok() && pool.release();
            pool.used.push(i);
            if is_released {
                model = Model::train(series, &pool, &active, at);
            } else if let (Some(model), Some(reading)) = (model.as_mut(), reading.as_ref()) {
                model.online.accept(reading);
                model.accepted += 1;
            }
        }
        if let Some(confirmed) = confirmed {
            let since = confirmed.since;
            out.alarms.push(confirmed.alarm(&series.surveys, i));
            // further surveys are compared with the level since the alarm
            levels.push(if levels.contains(&since) { i } else { since });
            levels.dedup();
            pool.take_back(since);
            scores = Scores::default();
            let active: Vec<usize> = levels.iter().copied().filter(|level| *level <= i).collect();
            model = Model::train(series, &pool, &active, at);
        }
    }
    Ok(out)
}

/// Scores since the last alarm, each with its survey.
#[derive(Default)]
struct Scores {
    /// Moving average E of the scores.
    average: f64,
    /// Scores since the average was last zero.
    one_sided: Vec<(usize, f64)>,
    all: Vec<(usize, f64)>,
}

/// An alarm among the scores.
struct Confirmed {
    kind: AlarmKind,
    value: f64,
    limit: f64,
    /// The most likely first survey of the change.
    since: usize,
}

impl Confirmed {
    fn alarm(&self, surveys: &[usize], i: usize) -> ModeAlarm {
        ModeAlarm {
            survey: surveys[i],
            since: surveys[self.since],
            kind: self.kind,
            value: self.value,
            limit: self.limit,
        }
    }
}

impl Scores {
    /// Adds the score of survey i. Returns an alarm if the average is beyond `h`, or if three of the last five scores are outside.
    fn add(&mut self, i: usize, score: f64, weight: f64, h: f64) -> Option<Confirmed> {
        let before = self.average;
        self.average = (1.0 - weight) * before + weight * score.clamp(-SCORE_MOST, SCORE_MOST);
        if before == 0.0 || before.signum() != self.average.signum() {
            self.one_sided.clear();
        }
        self.one_sided.push((i, score));
        self.all.push((i, score));
        if self.average.abs() > h {
            return Some(Confirmed {
                kind: AlarmKind::Average,
                value: self.average,
                limit: h,
                since: likeliest_start(&self.one_sided),
            });
        }
        let from = self.all.len().saturating_sub(AMONG);
        let outside = self.all[from..].iter().filter(|(_, score)| score.abs() > OUTSIDE);
        let outside: Vec<usize> = outside.map(|(i, _)| *i).collect();
        (outside.len() >= OUTSIDE_LEAST).then(|| Confirmed {
            kind: AlarmKind::ThreeOfFive,
            value: score,
            limit: OUTSIDE,
            since: outside[0],
        })
    }
}

/// The most likely first survey of a change, from scores of one sign: the start of the sum that is largest relative to its standard deviation.
///
/// # Source
/// Pignatiello & Samuel (2001) J. Qual. Technol. 33(3):357-365: the step of largest likelihood. Differs from the last zero of the average, which
/// may be years earlier.
fn likeliest_start(scores: &[(usize, f64)]) -> usize {
    let (mut sum, mut best, mut start) = (0.0, 0.0, scores.last().map_or(0, |(i, _)| *i));
    for (count, (i, score)) in scores.iter().rev().enumerate() {
        sum += score;
        let of = sum * sum / (count + 1) as f64;
        if of > best {
            (best, start) = (of, *i);
        }
    }
    start
}

/// Surveys for training.
#[derive(Clone, Debug, Default)]
struct Pool {
    /// Surveys that agree with their predictions, ascending.
    used: Vec<usize>,
    /// Surveys outside the limit.
    outside: Vec<usize>,
    /// Surveys at new temperatures, at which the effects of weather and structure cannot be separated yet.
    waiting: Vec<usize>,
}

impl Pool {
    fn since(&self, from: usize) -> usize {
        self.used.iter().rev().take_while(|i| **i >= from).count()
    }

    fn knows_frost(&self, series: &ModeSeries, frost_below_c: f64) -> bool {
        let frost = self
            .used
            .iter()
            .filter(|i| series.temperatures_c[**i] < frost_below_c);
        frost.take(FROST_SURVEYS_LEAST).count() == FROST_SURVEYS_LEAST
    }

    /// Whether there were surveys that were as cold or colder, and as warm or warmer.
    fn has_seen(&self, series: &ModeSeries, temperature_c: f64) -> bool {
        let enough = |as_far: &dyn Fn(f64) -> bool| {
            let all = self.used.iter().filter(|i| as_far(series.temperatures_c[**i]));
            all.take(TEMPERATURES_LEAST).count() == TEMPERATURES_LEAST
        };
        enough(&|t| t <= temperature_c + MARGIN_C) && enough(&|t| t >= temperature_c - MARGIN_C)
    }

    /// Uses the waiting surveys; returns whether there were any.
    fn release(&mut self) -> bool {
        let is_any = !self.waiting.is_empty();
        self.used.append(&mut self.waiting);
        self.used.sort_unstable();
        is_any
    }

    /// Uses the surveys outside the limit since a given survey: they belong to a new level.
    fn take_back(&mut self, since: usize) {
        self.release();
        let back: Vec<usize> = self.outside.iter().copied().filter(|i| *i >= since).collect();
        self.outside.retain(|i| *i < since);
        self.used.extend(back);
        self.used.sort_unstable();
    }
}

fn normal_score(score: f64, degrees_of_freedom: f64) -> Result<f64, MonitoringError> {
    const LIKE_NORMAL: f64 = 300.0;
    const PROBABILITY_LEAST: f64 = 1e-30;
    if degrees_of_freedom > LIKE_NORMAL {
        return Ok(score);
    }
    let both = student_two_sided(score.abs(), degrees_of_freedom)?.max(PROBABILITY_LEAST);
    Ok(-normal_quantile(0.5 * both.min(1.0 - 1e-16))?.min(0.0) * score.signum())
}

/// The regression at one time.
struct Model {
    weather: WeatherKnown,
    online: Online,
    /// Number of surveys in the pool when it was trained.
    pool: usize,
    accepted: usize,
    columns: usize,
    levels: Vec<usize>,
    with_frost: bool,
}

impl Model {
    fn train(series: &ModeSeries, pool: &Pool, levels: &[usize], at: (f64, f64)) -> Option<Model> {
        let with_frost = pool.knows_frost(series, at.1);
        let index: Vec<usize> = pool
            .used
            .iter()
            .copied()
            .filter(|i| with_frost || series.temperatures_c[*i].is_nan() || series.temperatures_c[*i] >= at.1)
            .collect();
        let mut is_kept = vec![false; series.len()];
        index.iter().for_each(|i| is_kept[*i] = true);
        let known = series.kept(|i| is_kept[i]);
        // a level without a survey cannot explain anything yet
        let step =
            |level: &usize| -> Vec<f64> { index.iter().map(|i| f64::from(u8::from(i >= level))).collect() };
        let extra: Vec<Vec<f64>> = levels
            .iter()
            .map(step)
            .filter(|column| column.contains(&1.0) && column.contains(&0.0))
            .collect();
        let weather = earned(&known, &extra, at);
        let mut all = columns(&known, weather, at);
        let width = all.len() + levels.len();
        all.extend(extra);
        if known.len() < all.len() + 2 {
            return None;
        }
        // always from the same start: from the last estimate the search would end too early, and false alarms would be 1.4 times as frequent
        let disturbance: Disturbance = restricted_likelihood(&known.series, &all, None)?;
        let mut model = Model {
            weather,
            online: Online::new(width, disturbance),
            pool: pool.used.len(),
            accepted: 0,
            columns: width,
            levels: levels.to_vec(),
            with_frost,
        };
        for i in index {
            let row = model.row(series, i, at);
            let noise_sd = series.series.noise_sd[i];
            let at = series.series.at[i];
            let row = &row;
            if row.iter().all(|value| value.is_finite()) {
                model.online.accept(&Reading { at, noise_sd, row });
                model.accepted += 1;
            }
        }
        Some(model)
    }

    /// Whether there are many more surveys for training, or other levels, than at the last estimate.
    fn is_outgrown(&self, surveys: usize, levels: &[usize]) -> bool {
        surveys as f64 >= AGAIN * self.pool as f64 || self.levels != levels
    }

    /// Regressors of a survey, followed by the reading.
    fn row(&self, series: &ModeSeries, i: usize, at: (f64, f64)) -> Vec<f64> {
        let mut row = explaining(self.weather, (series.days[i], series.temperatures_c[i]), at);
        row.extend(self.levels.iter().map(|level| f64::from(u8::from(i >= *level))));
        row.push(series.series.readings[i]);
        row
    }

    fn needs_temperature(&self) -> bool {
        matches!(
            self.weather,
            WeatherKnown::Temperature | WeatherKnown::TemperatureAndFrost
        )
    }

    fn degrees_of_freedom(&self) -> f64 {
        (self.accepted as f64 - self.columns as f64 - 1.0).max(1.0)
    }
}
