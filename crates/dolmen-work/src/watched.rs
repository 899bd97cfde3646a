//! Results of a history of surveys.

use crate::changed_part::ModelOff;
use crate::inspected::Inspected;
use crate::judgement::tilt_beyond_limit;
use crate::sensor_alarms::SensorAlarm;
use crate::watched_log::WatchedLog;
use crate::years_parts::YearsParts;
use dolmen::monitoring::{ANSWERED_DAYS, LoggedSeason, LoggedTrend, TiltSeries, Track, Watched};
use dolmen::numeric::{Bracketing, bracketed_root};
use dolmen_project::{EarthquakePart, LogKind, Project, WorkKind, WorkPart};
use dolmen_words::message::Both;
use std::sync::Arc;

/// Days of a year, as the regression of a log counts them.
const YEAR_DAYS: f64 = 365.25;
/// Years within which a lean with a season is followed to its limit, and the step, which must not pass over its peak. Our choice.
const SEASON_YEARS_MOST: f64 = 300.0;
const SEASON_STEP_YEARS: f64 = 0.02;

/// Results of a history of surveys.
#[derive(Clone, Debug)]
pub struct WatchAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// The project.
    pub project: Arc<Project>,
    /// The surveys of the history, by time.
    pub surveys: Vec<WatchedSurvey>,
    /// Names of surveys that were left out: those without a date, modes and a tilt, and those on the day of another survey with a name that
    /// is more than a date.
    pub left_out: Vec<String>,
    /// Days with several surveys, which are combined, and the number of surveys.
    pub several: Vec<(String, usize)>,
    /// Repairs and other works by time, each with its day.
    pub works: Vec<(f64, WorkPart)>,
    /// Earthquakes by time, from records or as stated in surveys.
    pub earthquakes: Vec<WatchedEarthquake>,
    /// Failed sensors; they do not describe the structure.
    pub sensor_alarms: Vec<SensorAlarm>,
    /// Surveys identified without failed sensors, and those sensors.
    pub sensors_left_out: Vec<(String, Vec<String>)>,
    /// Surveys whose records give no modes, and why: too short, or no vibration.
    pub without_modes: Vec<(String, Both)>,
    /// Surveys whose temperature is from the project's log.
    pub temperatures_of_log: usize,
    /// Results of logged tilts and cracks.
    pub logs: Vec<WatchedLog>,
    /// Results of inspections.
    pub inspected: Inspected,
    /// The parts of the model that explain the lasting changes; for a structure in a store only for the strongest change, and none in `watch
    /// --follow`.
    pub parts: Vec<YearsParts>,
    /// Why no part is sought: the model is too far from the measured frequencies.
    pub model_off: Option<ModelOff>,
    /// Results of the surveys.
    pub watched: Watched,
}

/// An earthquake at the structure.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedEarthquake {
    /// The survey.
    pub survey: String,
    /// Its day, from 1970-01-01.
    pub day: f64,
    /// Its data.
    pub part: EarthquakePart,
    /// Whether a repair or an inspection followed.
    pub is_answered: bool,
}

/// A survey in time.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedSurvey {
    /// Its name.
    pub name: String,
    /// Its day, from 1970-01-01.
    pub day: f64,
    /// Its temperature, °C.
    pub temperature_c: Option<f64>,
    /// Frequencies of its modes, Hz, in the numbering of the history.
    pub frequencies_hz: Vec<f64>,
    /// Their standard deviations, Hz, where known.
    pub frequency_sds_hz: Vec<Option<f64>>,
    /// Whether the user accepted each of these although a test refused it.
    pub accepted: Vec<bool>,
}

impl WatchAnswer {
    /// Whether a day is so long after the last survey that a work on it is ignored: it is planned, or a mistake.
    pub fn is_far_ahead(&self, day: f64) -> bool {
        let last = self.surveys.last();
        last.is_some_and(|last| day > last.day + ANSWERED_DAYS)
    }

    /// Whether a repair followed each survey that raised an alarm.
    pub fn is_mended(&self) -> bool {
        let mut alarms = self.watched.alarms.iter();
        alarms.all(|alarm| {
            let since = self
                .surveys
                .get(alarm.alarm.survey)
                .map_or(0.0, |survey| survey.day);
            let mut repairs = self
                .works
                .iter()
                .filter(|(_, work)| work.kind == WorkKind::Repair);
            repairs.any(|(day, _)| *day >= since && !self.is_far_ahead(*day))
        })
    }

    /// The newest day in surveys, inspections or logs.
    pub fn newest_day(&self) -> Option<f64> {
        let surveys = self.surveys.last().map(|survey| survey.day.floor());
        let logs = self
            .logs
            .iter()
            .filter_map(WatchedLog::span)
            .map(|[_, last]| last);
        let inspected = self.inspected.last().map(|last| last.day);
        logs.chain(surveys).chain(inspected).max_by(f64::total_cmp)
    }

    /// Number of surveys in which the user accepted the followed mode.
    pub fn accepted_in(&self, track: &Track) -> usize {
        let both = track.modes.iter().zip(&self.surveys);
        both.filter(|(at, survey)| at.is_some_and(|at| survey.accepted.get(at) == Some(&true)))
            .count()
    }

    /// Earthquakes without a later inspection.
    pub fn open_earthquakes(&self) -> impl Iterator<Item = &WatchedEarthquake> {
        self.earthquakes.iter().filter(|of| !of.is_answered)
    }

    /// The first survey without a mode, where modes vanished significantly.
    pub fn lost_since(&self) -> Option<usize> {
        let since = self.watched.lost.iter().map(|of| of.since).min();
        since.filter(|_| self.watched.is_mode_lost())
    }

    /// Failing sensors in the newest record.
    pub fn open_sensor_alarms(&self) -> usize {
        self.sensor_alarms.iter().filter(|alarm| alarm.is_open).count()
    }

    /// Whether its tilt is beyond its limit on the day of the last reading, by surveys or logs.
    pub fn is_tilt_beyond(&self) -> bool {
        self.lean_beyond().is_some()
    }

    /// The largest tilt beyond its limit, by surveys and logs, of all directions together if they can be combined.
    pub fn lean_beyond(&self) -> Option<f64> {
        let leans = self.leans().into_iter().chain(self.logged_lean());
        let beyond = leans.filter(LeanNow::is_beyond).map(|lean| lean.size);
        let logs = self.logs.iter().filter(|log| log.is_tilt() && log.is_beyond());
        beyond
            .chain(logs.map(|log| log.trend.size_to_judge().abs()))
            .max_by(f64::total_cmp)
    }

    /// Whether the newest days of a log differ from those before, or some of its days are on another scale.
    pub fn is_log_off(&self) -> bool {
        let mut logs = self.logs.iter().map(|log| &log.trend);
        logs.any(|trend| trend.last_off.is_some() || trend.scale.is_some())
    }

    /// Cracks, logged or inspected, and other inspected damage beyond their limits.
    pub fn cracks_beyond(&self) -> usize {
        let cracks = self.logs.iter().filter(|log| !log.is_tilt());
        cracks.filter(|log| log.is_beyond()).count() + self.inspected.beyond().count()
    }

    /// The tilt of x and y together, if there is one log of each with a known zero: without its season at the end of the logs, or by the readings of
    /// the last days, if that is larger.
    pub fn logged_lean(&self) -> Option<LeanNow> {
        let [x, y] = [self.logged_plane("x")?, self.logged_plane("y")?];
        let directions = vec!["x".to_owned(), "y".to_owned()];
        let limit = self.project.watch.tilt_limit;
        let parts = [LeanPart::of_log(x), LeanPart::of_log(y)];
        if parts.iter().any(|part| !part.now.is_finite()) {
            return None;
        }
        let lean = LeanNow::of(None, directions, &parts, limit);
        let newest = x.newest.hypot(y.newest);
        Some(match newest > lean.size {
            true => LeanNow {
                size: newest,
                years: lean
                    .years
                    .filter(|_| limit.is_none_or(|limit| newest < limit.abs())),
                ..lean
            },
            false => lean,
        })
    }

    /// The days on which the logs of x and y together were at the limit, without spikes.
    pub fn logged_days_at_limit(&self) -> Vec<f64> {
        let (Some(x), Some(y), Some(limit)) = (
            self.logged_plane("x"),
            self.logged_plane("y"),
            self.project.watch.tilt_limit,
        ) else {
            return Vec::new();
        };
        let each = x.daily.days.iter().zip(&x.daily.values);
        let at_limit = each.filter(|(day, of_x)| {
            let at = y.daily.days.binary_search_by(|own| own.total_cmp(day));
            let of_y = at.ok().and_then(|at| y.daily.values.get(at));
            of_y.is_some_and(|of_y| of_x.hypot(*of_y) >= limit.abs())
        });
        at_limit.map(|(day, _)| *day).collect()
    }

    /// The trend of the one log of a direction with a known zero.
    fn logged_plane(&self, direction: &str) -> Option<&LoggedTrend> {
        let mut all = self.logs.iter().filter(|log| {
            log.part.zero.is_some()
                && matches!(&log.part.kind, LogKind::Tilt { direction: own } if own == direction)
        });
        let first = all.next()?;
        all.next().is_none().then_some(&first.trend)
    }

    /// Whether a later series of the direction, from another mark, replaced it.
    pub fn is_replaced(&self, series: &TiltSeries) -> bool {
        let last = |of: &TiltSeries| of.surveys.last().copied();
        let mut others = self.watched.tilts.iter().map(|trend| &trend.series);
        others.any(|other| other.direction == series.direction && last(other) > last(series))
    }

    /// Whether another mark replaced this one and a repair followed its last reading, so that it has no information on today's tilt.
    fn is_of_the_past(&self, series: &TiltSeries) -> bool {
        let last = series.days.last().copied().unwrap_or(f64::INFINITY);
        let mut repairs = self
            .works
            .iter()
            .filter(|(_, work)| work.kind == WorkKind::Repair);
        self.is_replaced(series) && repairs.any(|(day, _)| *day > last && !self.is_far_ahead(*day))
    }

    /// The tilt on the day of the last readings: x and y of one datum together, other directions separately.
    pub fn leans(&self) -> Vec<LeanNow> {
        let limit = self.project.watch.tilt_limit;
        let mut leans: Vec<(LeanNow, Vec<LeanPart>)> = Vec::new();
        for trend in &self.watched.tilts {
            let of = &trend.series;
            let fitted = trend.carried.or(trend.slope).map(|slope| slope.now);
            let read = fitted.or(of.ratios.last().copied());
            let Some(now) = read.filter(|_| !self.is_of_the_past(of)) else {
                continue;
            };
            // a newest reading that is off may be right: the larger one is judged
            let last = of.ratios.last().copied().filter(|_| trend.last_off.is_some());
            let now = last.filter(|last| last.abs() > now.abs()).unwrap_or(now);
            let is_plane = |direction: &str| matches!(direction, "x" | "y");
            let seen = trend.forecast();
            let part = LeanPart {
                now,
                per_year: seen.map_or(0.0, |slope| slope.per_year),
                per_year2: 0.0,
                season: None,
            };
            let across = leans.iter_mut().find(|(lean, _)| {
                lean.datum == of.datum
                    && is_plane(&of.direction)
                    && lean
                        .directions
                        .iter()
                        .all(|own| is_plane(own) && *own != of.direction)
            });
            match across {
                Some((lean, parts)) => {
                    parts.push(part);
                    let mut directions = lean.directions.clone();
                    directions.push(of.direction.clone());
                    *lean = LeanNow::of(of.datum.clone(), directions, parts, limit);
                }
                None => {
                    let directions = vec![of.direction.clone()];
                    let lean = LeanNow::of(of.datum.clone(), directions, &[part], limit);
                    leans.push((lean, vec![part]));
                }
            }
        }
        // too few surveys for a trend
        let alone = tilt_beyond_limit(&self.project).filter(|_| self.watched.tilts.is_empty());
        let alone = alone.map(|beyond| LeanNow {
            datum: None,
            directions: beyond.directions,
            size: beyond.tilt,
            limit: Some(beyond.limit),
            years: None,
        });
        let latest = self.latest_tilts();
        let judged = leans.into_iter().map(|(lean, _)| {
            let mut read = latest.iter().filter(|read| read.is_beyond());
            // a newest reading beyond the limit counts, even if the regression is below it
            let beyond = read.find(|of| of.datum == lean.datum && of.directions == lean.directions);
            match beyond {
                Some(read) => LeanNow {
                    size: lean.size.max(read.ratio.abs()),
                    years: None,
                    ..lean
                },
                None => lean,
            }
        });
        judged.chain(alone).collect()
    }
}

/// The tilt of a structure, of all directions of one datum together.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct LeanNow {
    /// Its mark.
    pub datum: Option<String>,
    /// The directions.
    pub directions: Vec<String>,
    /// Horizontal over vertical, without a sign: from the trends, without the season, or from the last readings if there is no trend, or if these are
    /// beyond the limit.
    pub size: f64,
    /// Its limit.
    pub limit: Option<f64>,
    /// Years until the limit, at the significant slopes of all directions together; `None` without any, and beyond the limit.
    pub years: Option<f64>,
}

impl LeanNow {
    /// From the tilt now in each direction, its slope, the growth of its slope, and its season.
    ///
    /// ```text
    /// Σ (n + s T + ½ a T² + w(T))² = L²
    /// ```
    fn of(datum: Option<String>, directions: Vec<String>, parts: &[LeanPart], limit: Option<f64>) -> Self {
        let sum = |of: fn(&LeanPart) -> f64| parts.iter().map(of).sum::<f64>();
        let square = sum(|part| part.now * part.now);
        LeanNow {
            datum,
            directions,
            size: square.sqrt(),
            limit,
            years: limit.and_then(|limit| years_to(parts, limit)),
        }
    }
}

/// The tilt in one direction.
#[derive(Clone, Copy, Debug)]
struct LeanPart {
    /// Without its season, on the last day.
    now: f64,
    /// Its slope, 1/year; 0 unless beyond chance.
    per_year: f64,
    /// The growth of its slope, 1/year², where it speeds up.
    per_year2: f64,
    /// Its season, and the last day.
    season: Option<(LoggedSeason, f64)>,
}

impl LeanPart {
    /// Of a log: by its regression, or by its last days where it has none, or where the newest days differ from it.
    fn of_log(trend: &LoggedTrend) -> Self {
        let fitted = trend.slope.as_ref().ok().filter(|_| trend.last_off.is_none());
        let seen = trend.slope.as_ref().ok().filter(|_| trend.is_beyond_chance());
        let per_year = seen.map_or(0.0, |slope| slope.per_year);
        let grows = trend.curve.filter(|of| of.speeds_up(per_year));
        let last = trend.daily.days.last().copied();
        LeanPart {
            now: fitted.map_or(trend.now, |slope| slope.now),
            per_year,
            per_year2: grows.map_or(0.0, |of| of.per_year2),
            season: fitted.and(trend.yearly).zip(last),
        }
    }

    fn at(&self, years: f64) -> f64 {
        let season = self
            .season
            .map_or(0.0, |(of, last)| of.at(last + years * YEAR_DAYS));
        self.now + self.per_year * years + 0.5 * self.per_year2 * years * years + season
    }
}

/// Years until the parts together reach a limit; `None` without a slope, and beyond the limit.
fn years_to(parts: &[LeanPart], limit: f64) -> Option<f64> {
    let sum = |of: fn(&LeanPart) -> f64| parts.iter().map(of).sum::<f64>();
    let (square, both, slopes) = (
        sum(|part| part.now * part.now),
        sum(|part| part.now * part.per_year),
        sum(|part| part.per_year * part.per_year),
    );
    let left = limit * limit - square;
    let straight =
        (left > 0.0 && slopes > 0.0).then(|| ((both * both + slopes * left).sqrt() - both) / slopes)?;
    let beyond = |years: f64| parts.iter().map(|part| part.at(years).powi(2)).sum::<f64>() - limit * limit;
    if parts.iter().any(|part| part.season.is_some()) {
        if beyond(0.0) >= 0.0 {
            return Some(0.0);
        }
        let steps = (SEASON_YEARS_MOST / SEASON_STEP_YEARS) as usize;
        let at = |step: usize| step as f64 * SEASON_STEP_YEARS;
        let step = (1..=steps).find(|step| beyond(at(*step)) >= 0.0);
        return match step {
            Some(step) => bracketed_root(beyond, at(step - 1), at(step), &Bracketing::default()).ok(),
            None => Some(straight),
        };
    }
    // at a growing slope the limit is reached earlier, or not at all if the directions cancel
    match parts.iter().any(|part| part.per_year2 != 0.0) && beyond(straight) > 0.0 {
        true => bracketed_root(beyond, 0.0, straight, &Bracketing::default()).ok(),
        false => Some(straight),
    }
}

impl LeanNow {
    /// Whether it has reached its limit.
    pub fn is_beyond(&self) -> bool {
        self.limit.is_some_and(|limit| self.size >= limit.abs())
    }
}
