//! Logs saved by Korean spreadsheets: CP949, halves of the day, units in the names of columns.

use super::csv_records::{layout, refusal_with};
use dolmen::signal::Channel;
use dolmen_records::records::{
    Column, Pick, RateSource, Reading, RecordOptions, Unit, join_stations, read_csv, read_record,
};
use std::fmt::Write as _;

/// Remarks on a file, in English.
pub(super) fn said_of(reading: &Reading) -> Vec<String> {
    reading.remarks().into_iter().map(|said| said.english).collect()
}

/// "측정시각,1층 가속도(gal)\n" as Python 3.11 encodes it in "cp949".
const NAMES: &[u8] = b"\xc3\xf8\xc1\xa4\xbd\xc3\xb0\xa2,1\xc3\xfe \xb0\xa1\xbc\xd3\xb5\xb5(gal)\r\n";
/// "오전" in CP949.
const MORNING: &[u8] = b"\xbf\xc0\xc0\xfc";
/// "오후" in CP949.
const AFTERNOON: &[u8] = b"\xbf\xc0\xc8\xc4";

/// Ten seconds at 100 Hz from five seconds before noon, in CP949.
fn log_across_noon() -> Vec<u8> {
    let mut log = NAMES.to_vec();
    for i in 0..1000_u32 {
        let half = if i < 500 { MORNING } else { AFTERNOON };
        let clock = match i {
            0..500 => format!("11:59:{:02}.{:02}0", 55 + i / 100, i % 100),
            _ => format!("12:00:{:02}.{:02}0", i / 100 - 5, i % 100),
        };
        let value = format!(",{}.5\r\n", (7 * i) % 11);
        log.extend(
            [
                b"2026-04-02 ".as_slice(),
                half,
                b" ",
                clock.as_bytes(),
                value.as_bytes(),
            ]
            .concat(),
        );
    }
    log
}

fn picked(column: &str, scale: Option<f64>) -> Pick {
    Pick {
        column: Column::Named(column.to_owned()),
        channel: Channel::named(column),
        scale,
    }
}

fn at(rate_hz: f64, picks: Vec<Pick>) -> RecordOptions {
    RecordOptions {
        sampling_rate_hz: Some(rate_hz),
        unit: Unit::Gal,
        picks,
        ..RecordOptions::default()
    }
}

#[test]
fn exact_names_and_times_of_a_log_in_cp949() {
    let log = log_across_noon();
    let wanted = || vec![picked("1층 가속도(gal)", None)];
    let reading = read_csv(&log, &at(100.0, wanted())).unwrap();
    assert_eq!(layout(&reading).columns, ["측정시각", "1층 가속도(gal)"]);
    assert_eq!(layout(&reading).rate_source, RateSource::GivenAndDates);
    assert_eq!(reading.record.samples(0)[..2], [0.005, 0.075]);
    assert_eq!(
        said_of(&reading),
        ["the text is in CP949 (EUC-KR) and was read as that"]
    );
    let fault = read_csv(&log, &at(200.0, wanted())).unwrap_err().to_string();
    assert_eq!(
        fault,
        "sampling_rate is 200, but column \"측정시각\" goes from 2026-04-02 오전 11:59:55.000 to 2026-04-02 오후 12:00:04.990 in 1000 samples, \
         which is 100.000 Hz: correct the rate"
    );
}

#[test]
fn refuses_a_rate_that_halves_of_the_day_contradict() {
    for (before, after) in [("AM ", ""), ("오전 ", ""), ("", " am"), ("", " 오전")] {
        let mut log = "when,x\n".to_owned();
        for i in 0..2000 {
            let second = 30 + i / 100;
            writeln!(
                log,
                "2026-04-02 {before}9:59:{second:02}.{:02}0{after},{}",
                i % 100,
                (7 * i) % 11
            )
            .unwrap();
        }
        let options = |rate_hz| RecordOptions {
            unit: Unit::Unknown,
            ..at(rate_hz, vec![picked("x", None)])
        };
        let reading = read_csv(log.as_bytes(), &options(100.0)).unwrap();
        assert_eq!(
            layout(&reading).rate_source,
            RateSource::GivenAndDates,
            "{before}{after}"
        );
        assert!(reading.unread_stamps().is_empty());
        let fault = refusal_with(&log, &options(200.0));
        assert!(fault.contains("which is 100.000 Hz"), "{fault}");
    }
}

#[test]
fn holds_times_that_cannot_be_read_are_told_of_every_file() {
    let reading = |column: &str| {
        let log = format!("{column} time,x\ntick 1,1\ntick 2,4\ntick 3,2\n");
        let options = RecordOptions {
            unit: Unit::Unknown,
            ..at(100.0, vec![picked("x", None)])
        };
        read_record(log.as_bytes(), &options).unwrap()
    };
    let station = |name: &str| dolmen_records::records::Station {
        file: format!("{name}.csv"),
        reading: reading(name),
        begins_s: Some(0.0),
    };
    let joined = join_stations(vec![station("a"), station("b")], &dolmen::signal::Join::default()).unwrap();
    let mut unread = joined.unread_stamps();
    unread.sort();
    assert_eq!(unread, ["a time", "b time"]);
}

/// Three columns, the last with another unit in its name.
const MIXED: &str = "a1 [gal],a2 [gal],a3 [g]\n1,2,0.003\n4,1,0.001\n2,5,0.002\n";

#[test]
fn refuses_columns_whose_names_contradict_the_unit_or_each_other() {
    let told = |unit, picks| RecordOptions {
        unit,
        ..at(100.0, picks)
    };
    assert_eq!(
        refusal_with(MIXED, &told(Unit::Gal, Vec::new())),
        "column \"a3 [g]\" says g, but unit is \"cm/s2\": correct unit; or, if only this column is in g, give its channel scale = 980.665; or, if \
         its name is wrong, give its channel scale = 1"
    );
    assert_eq!(
        refusal_with(MIXED, &told(Unit::Unknown, Vec::new())),
        "column \"a1 [gal]\" says cm/s2, but column \"a3 [g]\" says g: one record has one unit; take unit = \"cm/s2\" and, for \"a3 [g]\", give \
         its channel scale = 980.665; or, if the name is wrong, give its channel scale = 1"
    );
    let speed = MIXED.replace("a3 [g]", "v (mm/s)");
    let fault = refusal_with(&speed, &told(Unit::Gal, Vec::new()));
    assert!(
        fault.contains("leave it out: it measures something else"),
        "{fault}"
    );
    let counts = "ch1 (counts),ch2 (counts)\n1,2\n4,1\n2,5\n";
    let fault = refusal_with(counts, &told(Unit::Gal, Vec::new()));
    assert!(
        fault.contains("its numbers are in \"counts\": give scale"),
        "{fault}"
    );
}

#[test]
fn exact_a_scale_of_the_channel_takes_a_column_to_the_unit() {
    let picks = vec![picked("a1 [gal]", None), picked("a3 [g]", Some(980.665))];
    let record = read_record(MIXED.as_bytes(), &at(100.0, picks)).unwrap().record;
    assert_eq!(record.samples(0)[0], 0.01);
    assert!((record.samples(1)[0] - 0.003 * 9.80665).abs() < 1e-15);
    // an unread column contradicts nothing
    let picks = vec![picked("a1 [gal]", None), picked("a2 [gal]", None)];
    assert!(read_record(MIXED.as_bytes(), &at(100.0, picks)).is_ok());
}
