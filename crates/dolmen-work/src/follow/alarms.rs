//! What somebody must be called for.

use crate::survey_dates::day_of_a_record;
use crate::watched::WatchAnswer;
use std::collections::BTreeSet;

/// Of what sort an alarm is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum AlarmSort {
    /// A frequency left what earlier surveys predict.
    Structure,
    /// An earthquake was recorded.
    Earthquake,
    /// It leans beyond its limit.
    Tilt,
    /// A crack, logged or inspected, or other inspected damage is larger than it may be.
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

/// An alarm that nobody has answered.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
pub struct OpenAlarm {
    /// Of what sort.
    pub sort: AlarmSort,
    /// The day that confirmed it; the last survey, of a tilt or crack.
    pub date: String,
    /// What tells it from every other alarm of the structure.
    pub key: String,
}

impl OpenAlarm {
    /// Whether somebody must look at the structure, not at a sensor.
    pub fn is_of_structure(&self) -> bool {
        self.sort != AlarmSort::Sensor
    }
}

impl WatchAnswer {
    /// How many alarms of the structure nobody has answered: those of [`open_alarms`], sensors passed over.
    pub fn open_alarms(&self) -> usize {
        let all = open_alarms(self);
        all.iter().filter(|alarm| alarm.is_of_structure()).count()
    }
}

/// The alarms that nobody has answered: one for each day on which frequencies confirmed any, one for each earthquake, and one each for a tilt and a crack beyond its limit, until a work or
/// an inspection is entered; one for each sensor that fails.
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
