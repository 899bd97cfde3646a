//! The planned sensors as lines of a project file.

use dolmen_work::sensors::SensorsAnswer;
use std::fmt::Write as _;

/// `channels = [ … ]`, setup by setup, for the table of a survey's records; the columns are counted on, and to be changed to those of the record.
pub(crate) fn channel_lines(answer: &SensorsAnswer) -> String {
    let mut text = String::new();
    for setup in 0..answer.setups {
        if answer.setups > 1 {
            let _ = writeln!(
                text,
                "[[survey.\"YYYY-MM-DD\".setups]]\nfile = \"setup-{}.csv\"",
                setup + 1
            );
        } else {
            text += "[survey.\"YYYY-MM-DD\".records]\nfile = \"record.csv\"\n";
        }
        text += "channels = [\n";
        let here = answer.sensors.iter().enumerate();
        let here = here.filter(|(_, sensor)| sensor.setup.is_none_or(|of| of == setup));
        let mut column = 0;
        for (number, sensor) in here {
            let [x, y, z] = sensor
                .site
                .position_m
                .map(|length| format!("{:.3}", length + 0.0));
            for axis in &sensor.site.axes {
                column += 1;
                let key = axis
                    .key()
                    .filter(|key| ["x", "y", "z"].contains(key))
                    .unwrap_or("x");
                let _ = writeln!(
                    text,
                    "  {{ column = {column}, name = \"s{}{key}\", position = [{x}, {y}, {z}], direction = \"{key}\" }},",
                    number + 1
                );
            }
        }
        text += "]\n";
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_project::RecordSource;
    use dolmen_records::NoFiles;
    use dolmen_work::Opened;
    use dolmen_work::sensors::{SensorsOptions, sensors};

    /// The lines, put into a project, are read as sensors at the planned places.
    #[test]
    fn holds_the_lines_are_read_as_the_sensors_that_were_planned() {
        let text = include_str!("../../../../examples/three_storey_pagoda/project.toml");
        let opened = Opened::read(text.to_owned(), "p".to_owned(), &NoFiles).unwrap();
        for setups in [1, 2] {
            let how = SensorsOptions {
                count: 3,
                axes: 3,
                setups,
                references: setups - 1,
                ..SensorsOptions::default()
            };
            let answer = sensors(&opened, &how).unwrap();
            let rated = channel_lines(&answer)
                .replace(".csv\"", ".csv\"\nsampling_rate = \"100 Hz\"")
                .replace("YYYY-MM-DD", "2026-11-26");
            let read = Opened::read(format!("{text}\n{rated}"), "p".to_owned(), &NoFiles).unwrap();
            let survey = read
                .project
                .surveys
                .iter()
                .find(|survey| survey.name == "2026-11-26")
                .unwrap();
            let sources: Vec<&RecordSource> = survey.records.iter().chain(&survey.setups).collect();
            assert_eq!(sources.len(), setups);
            for (setup, source) in sources.into_iter().enumerate() {
                let here = answer
                    .sensors
                    .iter()
                    .filter(|sensor| sensor.setup.is_none_or(|of| of == setup));
                let places: Vec<[f64; 3]> = here.flat_map(|sensor| [sensor.site.position_m; 3]).collect();
                assert_eq!(source.channels.len(), places.len());
                for (channel, place) in source.channels.iter().zip(places) {
                    let read = channel.position_m.unwrap();
                    assert!(read.iter().zip(place).all(|(a, b)| (a - b).abs() <= 5e-4));
                    assert!(channel.direction.is_some());
                }
            }
        }
    }
}
