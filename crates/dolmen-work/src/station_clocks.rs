//! Compares the starts that the project file gives to the files of a record with the dates inside these files.

use dolmen::signal::Starts;
use dolmen_records::records::{FirstDate, Layout, Station};

/// Two files of a record whose dates contradict the starts that the project file gives.
#[derive(Clone, Debug, PartialEq)]
pub struct ClockDoubt {
    /// The file that begins first by the dates.
    pub first: String,
    /// The other file.
    pub second: String,
    /// Time by which the second begins later, by the dates in the files, s.
    pub by_dates_s: f64,
    /// The same by the project file, s.
    pub as_given_s: f64,
}

/// The first file with a date, compared with each other one.
pub(crate) fn clock_doubts(stations: &[Station], starts: Starts) -> Vec<ClockDoubt> {
    let given = |station: &Station| match starts {
        Starts::Together => Some(0.0),
        Starts::Stated => station.begins_s,
    };
    let mut dated = stations
        .iter()
        .filter_map(|station| Some((station, first_date(station)?, given(station)?)));
    let Some((first, date, start_s)) = dated.next() else {
        return Vec::new();
    };
    let doubts = dated.filter_map(|(other, other_date, other_start_s)| {
        let (by_dates_s, as_given_s) = (other_date.at_s - date.at_s, other_start_s - start_s);
        let step_s = 1.0 / other.reading.record.sampling_rate_hz();
        let allowed_s = date.resolution_s + other_date.resolution_s + step_s;
        let (first, second, sign) = match by_dates_s < 0.0 {
            true => (other, first, -1.0),
            false => (first, other, 1.0),
        };
        ((by_dates_s - as_given_s).abs() > allowed_s).then(|| ClockDoubt {
            first: first.file.clone(),
            second: second.file.clone(),
            by_dates_s: sign * by_dates_s,
            as_given_s: sign * as_given_s,
        })
    });
    doubts.collect()
}

/// The date of the first sample of a text file.
fn first_date(station: &Station) -> Option<FirstDate> {
    match &station.reading.layout {
        Layout::Csv(layout) => layout.first_date,
        Layout::Npy(_) | Layout::Channels(_) | Layout::Stations(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::signal::Channel;
    use dolmen_records::records::{Column, Pick, RecordOptions, Unit, read_record};

    /// A record of 100 Hz whose first sample has this time, with a column of dates.
    fn station(file: &str, second: f64, begins_s: Option<f64>) -> Station {
        let rows = (0..40).map(|sample| {
            let at = second + 0.01 * f64::from(sample);
            format!("2024-03-05 13:58:{at:06.3},{}\n", sample * sample % 7)
        });
        let text = format!("date,x\n{}", rows.collect::<String>());
        let options = RecordOptions {
            sampling_rate_hz: Some(100.0),
            unit: Unit::Unknown,
            picks: vec![Pick {
                column: Column::Named("x".to_owned()),
                channel: Channel::named("x"),
                scale: None,
            }],
            ..RecordOptions::default()
        };
        Station {
            file: file.to_owned(),
            reading: read_record(text.as_bytes(), &options).unwrap(),
            begins_s,
        }
    }

    /// The dates of two files 7.30 s apart are held against what the project file gives.
    #[test]
    fn exact_starts_that_contradict_the_dates_in_the_files_are_found() {
        let doubts = |given: [Option<f64>; 2], starts| {
            clock_doubts(
                &[station("a.csv", 0.0, given[0]), station("b.csv", 7.3, given[1])],
                starts,
            )
        };
        let together = doubts([None, None], Starts::Together);
        assert_eq!(together.len(), 1);
        assert_eq!(
            (together[0].first.as_str(), together[0].second.as_str()),
            ("a.csv", "b.csv")
        );
        assert!((together[0].by_dates_s - 7.3).abs() < 1e-6 && together[0].as_given_s == 0.0);
        // whole seconds miss the start by 0.3 s; a clock of another zone does not matter
        let whole = doubts([Some(3600.0), Some(3607.0)], Starts::Stated);
        assert!((whole[0].as_given_s - 7.0).abs() < 1e-9);
        assert!(doubts([Some(3600.0), Some(3607.3)], Starts::Stated).is_empty());
        let later_first = clock_doubts(
            &[station("b.csv", 7.3, None), station("a.csv", 0.0, None)],
            Starts::Together,
        );
        assert_eq!(
            (later_first[0].first.as_str(), later_first[0].by_dates_s > 0.0),
            ("a.csv", true)
        );
    }
}
