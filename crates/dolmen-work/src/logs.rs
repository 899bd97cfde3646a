//! The logs of a project: read, reduced to one value a day, and watched.

use crate::air::{BELIEVED_C, air_temperature_c};
use crate::error::{Within as _, WorkError};
use crate::follow::moment_of;
use crate::survey_dates::{date, days_of};
use crate::watched_log::{LogRows, WatchedLog};
use crate::wrong::Place;
use dolmen::monitoring::{
    DailyReadings, LoggedOptions, LoggedSeries, SlopeLimit, daily_medians, logged_trend,
};
use dolmen_project::{LogKind, LogPart, Project, WorkKind, WorkPart};
use dolmen_records::{Files, Log, RECORD_BYTES_MOST, read_log};

/// Largest tilt, horizontal over vertical, and width, m, of a reading: beyond, it is the sign of a logger for no reading, 9999. Our choice: nothing
/// stands at 45°.
const TILT_READ_MOST: f64 = 1.0;
const WIDTH_READ_MOST_M: f64 = 2.0;
/// Probability of a false trend in any log of a project.
const SIGNIFICANCE: f64 = 0.05;

/// The logs of a project.
#[derive(Clone, Debug, Default)]
pub struct Logs {
    /// Tilts and cracks.
    read: Vec<ReadLog>,
    /// The temperature.
    air: Option<Log>,
}

#[derive(Clone, Debug)]
struct ReadLog {
    part: LogPart,
    rows: LogRows,
    daily: DailyReadings,
}

impl Logs {
    /// Reads all logs of a project.
    ///
    /// # Errors
    /// Files that cannot be read as logs, or that state another unit than the project.
    pub fn read(project: &Project, files: &dyn Files) -> Result<Self, WorkError> {
        let mut logs = Logs::default();
        for part in &project.watch.logs {
            let place = || Place::OfLog {
                name: part.name.clone(),
                file: files.shown(&part.file),
            };
            let log = log_of(part, files).within(place)?;
            match part.kind {
                LogKind::Temperature => logs.air = Some(believed(log)),
                LogKind::Tilt { .. } | LogKind::Crack => logs.read.push(daily(part, &log)),
            }
        }
        Ok(logs)
    }

    /// Whether one of the logs is watched separately.
    pub fn are_watched(&self) -> bool {
        !self.read.is_empty()
    }

    /// The air temperature at a survey whose name gives its time, °C.
    pub fn temperature_c(&self, survey: &str) -> Option<f64> {
        let from_s = moment_of(survey)?;
        let has_time = from_s.rem_euclid(86_400.0) != 0.0 || survey.contains(':');
        air_temperature_c(self.air.as_ref()?, from_s, has_time.then_some(0.0))
    }

    /// The results of each log; works by their days.
    pub(crate) fn watched(
        &self,
        works: &[(f64, WorkPart)],
        tilt_limit: Option<f64>,
    ) -> Result<Vec<WatchedLog>, WorkError> {
        let air = self
            .air
            .as_ref()
            .map(|log| daily_medians(&log.times_s, &log.values));
        let days: Vec<[f64; 2]> = works.iter().map(|(_, work)| shifting(work)).collect();
        let each = self.read.iter().map(|log| {
            let series = LoggedSeries {
                temperatures_c: air
                    .as_ref()
                    .map_or_else(Vec::new, |air| on_days(air, &log.daily.days)),
                daily: log.daily.clone(),
            };
            let is_tilt = matches!(log.part.kind, LogKind::Tilt { .. });
            // a limit of the structure does not apply to readings with an unknown zero
            let of_structure = tilt_limit.filter(|_| is_tilt && log.part.zero.is_some());
            let options = LoggedOptions {
                significance: SIGNIFICANCE / self.read.len() as f64,
                limit: log.part.limit.or(of_structure).map(|size| SlopeLimit {
                    size,
                    is_one_sided: !is_tilt,
                }),
                works: days.clone(),
                zero: log.part.zero.unwrap_or(0.0),
            };
            Ok(WatchedLog {
                part: log.part.clone(),
                rows: log.rows,
                trend: logged_trend(&series, &options).map_err(crate::ChangeFault::from)?,
            })
        });
        each.collect()
    }
}

/// The days of works that may shift readings; inspections do not.
fn shifting(work: &WorkPart) -> [f64; 2] {
    match (work.kind, date(&work.date)) {
        (WorkKind::Repair | WorkKind::Sensors | WorkKind::Event, Some(when)) => days_of(when),
        _ => [f64::NAN; 2],
    }
}

fn log_of(part: &LogPart, files: &dyn Files) -> Result<Log, WorkError> {
    let bytes = files.read(&part.file, RECORD_BYTES_MOST)?;
    let log = read_log(&bytes, part.column.as_deref())?;
    match log.unit.as_ref().filter(|stated| part.contradicts(stated)) {
        Some(stated) => Err(WorkError::LogUnit {
            stated: stated.clone(),
            unit: part.unit.clone(),
        }),
        None => Ok(log),
    }
}

/// A temperature log without implausible readings.
fn believed(log: Log) -> Log {
    let both = log.times_s.iter().zip(&log.values);
    let (times_s, values) = both.filter(|(_, celsius)| BELIEVED_C.contains(celsius)).unzip();
    Log {
        times_s,
        values,
        ..log
    }
}

fn daily(part: &LogPart, log: &Log) -> ReadLog {
    let zero = part.zero.unwrap_or(0.0);
    let most = match part.kind {
        LogKind::Crack => WIDTH_READ_MOST_M,
        LogKind::Tilt { .. } | LogKind::Temperature => TILT_READ_MOST,
    };
    let is_possible = |reading: &f64| (part.factor * reading).abs() <= most;
    let possible = log.values.iter().filter(|reading| is_possible(reading)).count();
    // if most readings are impossible, so is the unit; the answer shows them
    let are_single = 2 * possible > log.values.len();
    let read = log.times_s.iter().zip(&log.values);
    let (times_s, values): (Vec<f64>, Vec<f64>) = read
        .filter(|(_, reading)| !are_single || is_possible(reading))
        .map(|(at_s, reading)| (*at_s, zero + part.si(*reading)))
        .unzip();
    ReadLog {
        part: part.clone(),
        rows: LogRows {
            gaps: log.gaps + log.values.len() - values.len(),
            repeated: log.repeated,
            set_back: log.set_back,
            misdated: log.misdated,
            ends_misdated: log.ends_misdated,
        },
        daily: daily_medians(&times_s, &values),
    }
}

/// The temperature of each day, NaN if there is none.
fn on_days(air: &DailyReadings, days: &[f64]) -> Vec<f64> {
    let of = |day: &f64| {
        let at = air.days.binary_search_by(|own| own.total_cmp(day)).ok()?;
        air.values.get(at).copied()
    };
    days.iter().map(|day| of(day).unwrap_or(f64::NAN)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opened::Opened;
    use dolmen_records::MemoryFiles;

    #[test]
    fn exact_the_temperature_of_a_survey_is_that_of_its_day_or_hour() {
        let head = "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n";
        let text = format!("{head}[watch.log.air]\nfile = \"air.csv\"\nkind = \"temperature\"\n");
        let rows =
            "2026-11-25 10:00,3.0\n2026-11-25 11:00,5.0\n2026-11-25 12:00,85.0\n2026-11-26 10:00,9.0\n";
        let files = MemoryFiles {
            files: [("air.csv".to_owned(), format!("Time,Air\n{rows}").into_bytes())].into(),
        };
        let opened = Opened::read(text, "p".to_owned(), &files).unwrap();
        let logs = Logs::read(&opened.project, &files).unwrap();
        assert_eq!(logs.temperature_c("2026-11-25"), Some(4.0)); // 85 is the reading of a sensor right after its start
        assert_eq!(logs.temperature_c("2026-11-25T10:50:00"), Some(5.0));
        assert_eq!(logs.temperature_c("2026-11-25T13:50:00"), None);
        assert_eq!(
            (logs.temperature_c("2026-11"), logs.temperature_c("2026-12-25")),
            (None, None)
        );
        assert!(!logs.are_watched());
    }

    #[test]
    fn exact_the_sign_of_a_logger_for_no_reading_is_no_tilt() {
        let head = "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n[watch]\ntilt_limit = \"1/150\"\n";
        let text = format!(
            "{head}[watch.log.x]\nfile = \"x.csv\"\nkind = \"tilt\"\ndirection = \"x\"\nunit = \"mm/m\"\nzero = 0\n"
        );
        let day = |day: usize, read: &str| format!("2026-11-{day:02},{read}\n");
        let read: String = (1..=20)
            .map(|i| day(i, &format!("3.{i:02}")))
            .chain((21..=30).map(|i| day(i, if i % 2 == 0 { "9999" } else { "-9999.0" })))
            .collect();
        let files = MemoryFiles {
            files: [("x.csv".to_owned(), format!("Time,X\n{read}").into_bytes())].into(),
        };
        let opened = Opened::read(text, "p".to_owned(), &files).unwrap();
        let logs = Logs::read(&opened.project, &files).unwrap();
        let [found] = logs.watched(&[], Some(1.0 / 150.0)).unwrap().try_into().unwrap();
        assert_eq!((found.rows.gaps, found.trend.daily.days.len()), (10, 20));
        assert!((found.trend.newest - 3.20e-3).abs() < 1e-9 && !found.is_beyond());
    }
}
