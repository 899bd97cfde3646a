//! Alarms that need a person.

use crate::survey_dates::day_of_a_record;
use crate::watched::WatchAnswer;
use std::collections::BTreeSet;

/// Kind of an alarm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum AlarmSort {
    /// A frequency is outside the prediction from earlier surveys.
    Structure,
    /// An earthquake was recorded.
    Earthquake,
    /// The tilt exceeds its limit.
    Tilt,
    /// A crack, logged or inspected, or another inspected damage exceeds its limit.
    Crack,
    /// A sensor failed.
    Sensor,
}

impl AlarmSort {
    /// "structure", "earthquake", "tilt", "crack", "sensor".
    pub fn word(self) -> &'static str {
        match self {
            AlarmSort::Structure => "structure",
            AlarmSort::Earthquake => "earthquake",
            AlarmSort::Tilt => "tilt",
            AlarmSort::Crack => "crack",
            AlarmSort::Sensor => "sensor",
        }
    }
}

/// An open alarm.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
pub struct OpenAlarm {
    /// The kind of alarm.
    pub sort: AlarmSort,
    /// The day that confirmed it; for a tilt or crack the last survey.
    pub date: String,
    /// Its key among the alarms of the structure.
    pub key: String,
}

impl OpenAlarm {
    /// Whether the structure needs an inspection, not only a sensor.
    pub fn is_of_structure(&self) -> bool {
        self.sort != AlarmSort::Sensor
    }
}

impl WatchAnswer {
    /// Number of open alarms of the structure: [`open_alarms`] without those of sensors.
    pub fn open_alarms(&self) -> usize {
        let all = open_alarms(self);
        all.iter().filter(|alarm| alarm.is_of_structure()).count()
    }
}

/// The open alarms: one for each day that confirmed changes of frequencies, one for each earthquake, and one each for a tilt and a crack
/// beyond its limit, until the file has a later work or inspection; and one for each failing sensor.
pub fn open_alarms(answer: &WatchAnswer) -> Vec<OpenAlarm> {
    let name = |survey: usize| answer.surveys.get(survey).map(|survey| survey.name.as_str());
    let day = |name: &str| day_of_a_record(name).unwrap_or(name).to_owned();
    let days: BTreeSet<String> = answer
        .watched
        .alarms
        .iter()
        .filter(|alarm| !alarm.is_answered)
        .filter_map(|alarm| name(alarm.alarm.survey).map(day))
        .collect();
    let mut all: Vec<OpenAlarm> = days
        .into_iter()
        .map(|date| OpenAlarm {
            sort: AlarmSort::Structure,
            key: format!("structure {date}"),
            date,
        })
        .collect();
    all.extend(answer.lost_since().and_then(name).map(|since| OpenAlarm {
        sort: AlarmSort::Structure,
        date: day(since),
        key: format!("modes lost since {}", day(since)),
    }));
    all.extend(answer.open_earthquakes().map(|of| OpenAlarm {
        sort: AlarmSort::Earthquake,
        date: day(&of.survey),
        key: format!("earthquake {}", of.survey),
    }));
    let last_work = answer.works.last().map_or("-", |(_, work)| work.date.as_str());
    let last_survey = answer.surveys.last().map(|last| last.name.as_str());
    let last_survey = last_survey.or(answer.inspected.last().map(|last| last.survey.as_str()));
    let last_survey = last_survey.map_or_else(String::new, day);
    let beyond = [
        (AlarmSort::Tilt, answer.is_tilt_beyond()),
        (AlarmSort::Crack, answer.cracks_beyond() > 0),
    ];
    all.extend(
        beyond
            .into_iter()
            .filter(|(_, is)| *is)
            .map(|(sort, _)| OpenAlarm {
                sort,
                date: last_survey.clone(),
                key: format!("{} since {last_work}", sort.word()),
            }),
    );
    let sensors = answer.sensor_alarms.iter().filter(|alarm| alarm.is_open);
    all.extend(sensors.map(|alarm| OpenAlarm {
        sort: AlarmSort::Sensor,
        date: day(&alarm.since),
        key: format!(
            "sensor {} since {}: {}",
            alarm.fault.word(),
            alarm.since,
            alarm.channel
        ),
    }));
    all
}
