//! The planned sensors as lines of a project file.

use dolmen_project::Structure;
use dolmen_work::sensors::{Axis, SensorsAnswer};
use std::fmt::Write as _;

const WAYS: [&str; 3] = ["x", "y", "z"];

/// The direction of a channel; in a frame with other names, the first direction is x, the second y.
fn way(axis: &Axis, named: &[&str]) -> &'static str {
    let key = axis.key().unwrap_or("x");
    let own = WAYS.into_iter().find(|way| *way == key);
    let place = named.iter().position(|name| *name == key);
    own.or_else(|| WAYS.get(place?).copied()).unwrap_or("x")
}

/// `channels = [ … ]`, setup by setup, for the table of a survey's records; the user must replace the consecutive column numbers by those
/// of the record.
pub(crate) fn channel_lines(answer: &SensorsAnswer) -> String {
    let named: Vec<&str> = match &answer.project.structure {
        Structure::Frame(part) => part
            .directions
            .iter()
            .map(|direction| direction.name.as_str())
            .collect(),
        Structure::Chain(_) | Structure::Stack(_) | Structure::Building(_) | Structure::Survey => Vec::new(),
    };
    let mut text = String::new();
    for name in named.iter().filter(|name| !WAYS.contains(name)) {
        let _ = writeln!(
            text,
            "# {} is \"{name}\"",
            way(&Axis::Named((*name).to_owned()), &named)
        );
    }
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
            let [x, y, z] = sensor.site.position_m.map(metres);
            for axis in &sensor.site.axes {
                column += 1;
                let key = way(axis, &named);
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

/// A length with its unit, independent of the unit of a project.
fn metres(length: f64) -> String {
    match length.abs() < 5e-4 {
        true => "0".to_owned(),
        false => format!("\"{length:.3} m\""),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_project::RecordSource;
    use dolmen_records::NoFiles;
    use dolmen_work::Opened;
    use dolmen_work::sensors::{SensorsOptions, sensors};

    /// The lines in a project give sensors at the planned positions.
    #[test]
    fn holds_the_lines_are_read_as_the_sensors_that_were_planned() {
        let text = include_str!("../../../../examples/three_storey_pagoda/project.toml");
        let opened = Opened::read(text.to_owned(), "p".to_owned(), &NoFiles).unwrap();
        for setups in [1, 2] {
            let how = SensorsOptions {
                count: Some(3),
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

    #[test]
    fn holds_named_directions_of_a_frame_stay_apart() {
        let text = include_str!("../../../../examples/heunginjimun_gate/project.toml");
        let opened = Opened::read(text.to_owned(), "p".to_owned(), &NoFiles).unwrap();
        let how = SensorsOptions {
            count: Some(1),
            axes: 2,
            ..SensorsOptions::default()
        };
        let answer = sensors(&opened, &how).unwrap();
        let axes = &answer.sensors[0].site.axes;
        let named = ["weak", "strong"];
        let ways: Vec<&str> = axes.iter().map(|axis| way(axis, &named)).collect();
        assert!(ways.iter().collect::<std::collections::BTreeSet<_>>().len() == axes.len());
        assert_eq!(
            ["weak", "strong"].map(|name| way(&Axis::Named(name.to_owned()), &named)),
            ["x", "y"]
        );
        assert_eq!(way(&Axis::Named("y".to_owned()), &["x", "y"]), "y");
        assert_eq!(way(&Axis::InPlane, &[]), "x");
    }
}
