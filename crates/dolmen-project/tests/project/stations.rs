// SOURCE     A simulated record of two floors (1.1 and 4.2 Hz) at 100 Hz. The recorder of the second floor keeps every other sample, half
//            a step of the common rate after that of the first.
// GOAL       Several files form one record: its shapes are those of the whole, and the clocks do not rotate them.
// TOLERANCE  phases: a hundredth of the rotation of the second mode in half a step; frequencies: their standard deviations.

use dolmen::modal::{Identify, ReferenceCase, identify};
use dolmen::signal::{Join, Record, Starts};
use dolmen_project::parse_project;
use dolmen_records::records::{Reading, RecordOptions, Station, join_stations, read_record};

/// A CSV file of one channel, every second sample from `first` on, with its record source.
fn station(record: &Record, channel: usize, first: usize, begins_s: Option<f64>) -> Station {
    let name = &record.channels()[channel].name;
    let kept = record.samples(channel).iter().skip(first).step_by(2);
    let lines: Vec<String> = kept.map(|x| format!("{x:e}")).collect();
    let file = format!("{name}\n{}\n", lines.join("\n"));
    let options = RecordOptions {
        sampling_rate_hz: Some(50.0),
        ..Default::default()
    };
    Station {
        file: format!("field/{name}.csv"),
        reading: read_record(file.as_bytes(), &options).unwrap(),
        begins_s,
    }
}

/// Largest phase between the two floors of the second mode, rad, taken to −π/2 … π/2; and its frequency.
fn second_mode(record: &Record) -> (f64, f64) {
    let found = identify(record, &Identify::default()).unwrap();
    let mode = &found.modes.modes[1];
    let phase = (mode.shape[1].im / mode.shape[1].re).atan() - (mode.shape[0].im / mode.shape[0].re).atan();
    (phase.abs(), mode.frequency_hz)
}

#[test]
fn holds_shapes_are_not_turned_by_the_clocks_of_two_stations() {
    let record = ReferenceCase::ShearChain.made(7).unwrap().make().unwrap();
    let joined = |late_s: f64| -> Reading {
        let stations = vec![
            station(&record, 0, 0, Some(100.0)),
            station(&record, 1, 1, Some(100.0 + late_s)),
        ];
        join_stations(stations, &Join::default()).unwrap()
    };
    let reading = joined(0.01);
    assert_eq!(reading.record.sampling_rate_hz(), 50.0);
    let said: Vec<String> = reading.record.history().iter().map(ToString::to_string).collect();
    assert_eq!(said.len(), 3, "{said:?}");
    assert!(
        said[1].contains("interpolated") && said[1].contains("0.5000 of a step"),
        "{said:?}"
    );
    assert!(
        said[2].starts_with("cut to the time that all channels share: 0.380 s before"),
        "{said:?}"
    );
    let turned = 2.0 * std::f64::consts::PI * 4.2 * 0.01; // half a step of 50 Hz
    let (right, frequency_hz) = second_mode(&reading.record);
    assert!(right < 0.05 * turned, "{right} rad");
    let (wrong, _) = second_mode(&joined(0.0).record);
    assert!(
        (wrong - turned).abs() < 0.05 * turned,
        "{wrong} rad, not {turned}"
    );
    let whole = second_mode(&record);
    assert!(
        (frequency_hz / whole.1 - 1.0).abs() < 2e-4,
        "{frequency_hz} Hz, {} Hz",
        whole.1
    );
}

#[test]
fn refuses_stations_without_a_clock_and_names_them_apart() {
    let record = ReferenceCase::ShearChain.made(7).unwrap().make().unwrap();
    let pair = |begins_s| vec![station(&record, 0, 0, begins_s), station(&record, 0, 0, begins_s)];
    let mut stations = pair(None);
    stations[1].file = "roof.csv".into();
    let said = join_stations(stations.clone(), &Join::default())
        .unwrap_err()
        .to_string();
    assert!(said.ends_with("does not say when it begins"), "{said}");
    let together = Join {
        starts: Starts::Together,
        ..Default::default()
    };
    let joined = join_stations(stations, &together).unwrap();
    let own = &record.channels()[0].name;
    let names: Vec<&str> = joined.record.channels().iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, [format!("{own} {own}"), format!("roof {own}")]);
    let mut stations = pair(Some(0.0));
    stations[0].reading.begins_s = Some(5.0);
    assert_eq!(
        join_stations(stations, &Join::default()).unwrap_err().to_string(),
        format!(
            "begins is given for field/{own}.csv, but the file says itself when it begins: leave begins out, or correct the clock in \
             the file"
        )
    );
}

const STATIONS: &str = "schema = 1\nkind = \"survey\"\nname = { en = \"Gate\" }\n[survey.a.records]\n[[survey.a.records.stations]]\n\
                        file = \"a.mseed\"\nunit = \"m/s\"\nscale = 1.2e-9\n[[survey.a.records.stations]]\nfile = \"b.csv\"\n\
                        begins = \"2024-06-05T10:00:00.25\"\nunit = \"m/s\"\n";

#[test]
fn exact_keys_of_stations() {
    let project = parse_project(STATIONS, "project.toml").unwrap();
    let records = project.surveys[0].records.as_ref().unwrap();
    assert_eq!(
        (records.file.as_str(), records.unit.as_deref()),
        ("a.mseed, b.csv", Some("m/s"))
    );
    assert_eq!(records.stations[0].scale, Some(1.2e-9));
    // datetime.timestamp of Python 3.11, UTC
    assert_eq!(records.stations[1].begins_s, Some(1_717_581_600.25));
}

#[test]
fn refuses_stations_that_contradict_the_record() {
    let said = |from: &str, to: &str| {
        let text = STATIONS.replace(from, to);
        assert_ne!(text, STATIONS);
        parse_project(&text, "project.toml").unwrap_err().to_string()
    };
    let both = said("[survey.a.records]\n", "[survey.a.records]\nunit = \"g\"\n");
    assert!(
        both.contains("survey.a.records.unit stands beside survey.a.records.stations")
            && both.contains("5:8"),
        "{both}"
    );
    assert!(said("1.2e-9", "0.0").contains("survey.a.records.stations[1].scale = 0 is no scale"));
    let time = said("2024-06-05T10:00:00.25", "noon");
    assert!(
        time.contains("survey.a.records.stations[2].begins = \"noon\" is no time"),
        "{time}"
    );
    let format = said("a.mseed", "a.xyz");
    assert!(
        format.contains("write format = one of \"csv\", \"npy\", \"uff\""),
        "{format}"
    );
    assert!(said("file = \"b.csv\"\n", "").contains("file"));
    let none = parse_project(
        "schema = 1\nkind = \"survey\"\nname = { en = \"Gate\" }\n[survey.a.records]\nunit = \"g\"\n",
        "project.toml",
    );
    assert!(
        none.unwrap_err()
            .to_string()
            .contains("survey.a.records names no file")
    );
}

#[test]
fn holds_a_start_that_is_given_is_that_of_the_file_whose_first_samples_were_cut() {
    // both files have the same motion and start; one lost a second after ten seconds, and continues
    let motion = ReferenceCase::ShearChain.made(7).unwrap().make().unwrap();
    let read = |lost: std::ops::Range<usize>| {
        let kept = (0..6000).filter(|i| !lost.contains(i));
        let line = |i: usize| format!("{:.2},{:e}", i as f64 / 100.0, motion.samples(0)[i]);
        let lines: Vec<String> = kept.map(line).collect();
        let file = format!("t,x\n{}\n", lines.join("\n"));
        read_record(file.as_bytes(), &RecordOptions::default()).unwrap()
    };
    let stations = [("whole", 0..0), ("cut", 1000..1100)].map(|(name, lost)| Station {
        file: format!("{name}.csv"),
        reading: read(lost),
        begins_s: Some(100.0),
    });
    assert_eq!(stations[1].reading.record.length(), 4900);
    let joined = join_stations(stations.to_vec(), &Join::default()).unwrap();
    assert_eq!(joined.record.length(), 4900);
    assert!(
        (joined.begins_s.unwrap() - 111.0).abs() < 1e-9,
        "{:?}",
        joined.begins_s
    );
    for (whole, cut) in joined.record.samples(0).iter().zip(joined.record.samples(1)) {
        assert!(
            (whole - cut).abs() < 1e-9 * whole.abs().max(1e-6),
            "{whole} {cut}"
        );
    }
}
