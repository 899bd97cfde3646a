//! Failing sensors: faults of the channels of records, tracked from survey to survey. They do not describe the structure.

use crate::survey_dates::date;
use dolmen::signal::ChannelFault;
use dolmen_project::Project;
use serde::Serialize;
use std::collections::BTreeMap;

/// Faults of the channels of surveys, by the names of the surveys.
pub type SensorFaults = BTreeMap<String, Vec<(String, SensorFault)>>;

/// Faults of a sensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SensorFault {
    /// Every sample is the same.
    Dead,
    /// Far weaker than the others.
    Faint,
    /// It was stuck for a while.
    Stuck,
    /// Its strength changed tenfold during the record.
    Faded,
    /// The strength of its fast motion changes back and forth.
    Loose,
    /// It is almost the same signal as another one.
    Alike,
    /// It drifts by far more than it oscillates.
    Drifts,
    /// It has spikes.
    Spikes,
    /// The range of sensor or logger was exceeded.
    Clipped,
    /// It is the same signal as another one.
    Duplicated,
}

impl SensorFault {
    /// All kinds.
    const ALL: [SensorFault; 10] = [
        SensorFault::Dead,
        SensorFault::Faint,
        SensorFault::Stuck,
        SensorFault::Faded,
        SensorFault::Loose,
        SensorFault::Alike,
        SensorFault::Drifts,
        SensorFault::Spikes,
        SensorFault::Clipped,
        SensorFault::Duplicated,
    ];

    /// The channel of a fault, and its kind.
    pub fn of(fault: &ChannelFault) -> (String, Self) {
        let (channel, what) = match fault {
            ChannelFault::Constant { channel, .. } => (channel, SensorFault::Dead),
            ChannelFault::Faint { channel, .. } => (channel, SensorFault::Faint),
            ChannelFault::Stuck { channel, .. } => (channel, SensorFault::Stuck),
            ChannelFault::Faded { channel, .. } => (channel, SensorFault::Faded),
            ChannelFault::Loose { channel, .. } => (channel, SensorFault::Loose),
            ChannelFault::Alike { channel, .. } => (channel, SensorFault::Alike),
            ChannelFault::Drifts { channel, .. } => (channel, SensorFault::Drifts),
            ChannelFault::Spikes { channel, .. } => (channel, SensorFault::Spikes),
            ChannelFault::Clipped { channel, .. } => (channel, SensorFault::Clipped),
            ChannelFault::Duplicated { channel, .. } => (channel, SensorFault::Duplicated),
        };
        (channel.clone(), what)
    }

    /// Its word in stores and programs: "dead".
    pub fn word(self) -> &'static str {
        match self {
            SensorFault::Dead => "dead",
            SensorFault::Faint => "faint",
            SensorFault::Stuck => "stuck",
            SensorFault::Faded => "faded",
            SensorFault::Loose => "loose",
            SensorFault::Alike => "alike",
            SensorFault::Drifts => "drifts",
            SensorFault::Spikes => "spikes",
            SensorFault::Clipped => "clipped",
            SensorFault::Duplicated => "duplicated",
        }
    }

    /// The fault for a word.
    pub fn of_word(word: &str) -> Option<Self> {
        SensorFault::ALL.into_iter().find(|fault| fault.word() == word)
    }

    /// Number of successive records with the fault before it is an alarm; `None` for never. A strong shock clips one record, and a passing
    /// cart shakes one; a dead sensor stays dead. Our choice.
    fn records_least(self) -> Option<usize> {
        match self {
            SensorFault::Dead | SensorFault::Faint | SensorFault::Duplicated => Some(1),
            SensorFault::Stuck
            | SensorFault::Faded
            | SensorFault::Loose
            | SensorFault::Drifts
            | SensorFault::Clipped => Some(2),
            SensorFault::Alike | SensorFault::Spikes => None,
        }
    }
}

/// A failing sensor.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SensorAlarm {
    /// Its channel.
    pub channel: String,
    /// Its fault.
    pub fault: SensorFault,
    /// The first survey with the fault.
    pub since: String,
    /// The last successive survey with it.
    pub last: String,
    /// Number of successive ones.
    pub records: usize,
    /// Whether the newest record still has it.
    pub is_open: bool,
}

/// Failing sensors, by the time of their first fault; dated surveys with records are found by their names.
pub(crate) fn sensor_alarms(project: &Project, faults: &SensorFaults) -> Vec<SensorAlarm> {
    let dated = project
        .surveys
        .iter()
        .filter(|survey| survey.records.is_some() || !survey.setups.is_empty());
    let mut names: Vec<&str> = dated
        .map(|survey| survey.name.as_str())
        .filter(|name| date(name).is_some())
        .collect();
    names.sort_unstable();
    let mut running: Vec<SensorAlarm> = Vec::new();
    let mut all = Vec::new();
    for name in names {
        let own = faults.get(name).map_or(&[][..], Vec::as_slice);
        let shows = |alarm: &SensorAlarm| own.contains(&(alarm.channel.clone(), alarm.fault));
        all.extend(
            running
                .extract_if(.., |alarm| !shows(alarm))
                .map(|alarm| SensorAlarm {
                    is_open: false,
                    ..alarm
                }),
        );
        for (channel, fault) in own {
            match running
                .iter_mut()
                .find(|alarm| alarm.channel == *channel && alarm.fault == *fault)
            {
                Some(alarm) if alarm.last == name => {}
                Some(alarm) => {
                    name.clone_into(&mut alarm.last);
                    alarm.records += 1;
                }
                None => running.push(SensorAlarm {
                    channel: channel.clone(),
                    fault: *fault,
                    since: name.to_owned(),
                    last: name.to_owned(),
                    records: 1,
                    is_open: true,
                }),
            }
        }
    }
    all.extend(running);
    all.retain(|alarm| {
        alarm
            .fault
            .records_least()
            .is_some_and(|least| alarm.records >= least)
    });
    all.sort_by(|a, b| (&a.since, &a.channel).cmp(&(&b.since, &b.channel)));
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_project::parse_project;

    #[test]
    fn holds_a_sensor_alarms_once_it_failed_long_enough_and_until_it_works_again() {
        let days = [
            "2026-01-03",
            "2026-01-01",
            "2026-01-02T10:00:00",
            "2026-01-04",
            "first",
        ];
        let text: String = days
            .iter()
            .map(|day| format!("[survey.\"{day}\".records]\nfile = \"a.csv\"\nsampling_rate = \"100 Hz\"\n"))
            .collect();
        let project = parse_project(
            &format!("schema = 1\nkind = \"survey\"\nname = \"a\"\n{text}"),
            "p",
        )
        .unwrap();
        let on = |channel: &str, fault| (channel.to_owned(), fault);
        let faults = SensorFaults::from([
            ("first".to_owned(), vec![on("n", SensorFault::Dead)]),
            (
                "2026-01-01".to_owned(),
                vec![on("a", SensorFault::Dead), on("b", SensorFault::Clipped)],
            ),
            (
                "2026-01-02T10:00:00".to_owned(),
                vec![on("a", SensorFault::Dead), on("s", SensorFault::Spikes)],
            ),
            (
                "2026-01-03".to_owned(),
                vec![on("c", SensorFault::Drifts), on("s", SensorFault::Spikes)],
            ),
            (
                "2026-01-04".to_owned(),
                vec![on("c", SensorFault::Drifts), on("b", SensorFault::Clipped)],
            ),
        ]);
        let found = sensor_alarms(&project, &faults);
        let told: Vec<(&str, &str, &str, usize, bool)> = found
            .iter()
            .map(|alarm| {
                (
                    alarm.channel.as_str(),
                    alarm.since.as_str(),
                    alarm.last.as_str(),
                    alarm.records,
                    alarm.is_open,
                )
            })
            .collect();
        assert_eq!(
            told,
            [
                ("a", "2026-01-01", "2026-01-02T10:00:00", 2, false),
                ("c", "2026-01-03", "2026-01-04", 2, true),
            ]
        );
    }

    #[test]
    fn holds_every_word_is_known_again() {
        for fault in SensorFault::ALL {
            assert_eq!(SensorFault::of_word(fault.word()), Some(fault));
        }
        assert_eq!(SensorFault::of_word("other"), None);
    }
}
