//! Records from CSV: every dialect, every refusal with its message.

use super::korean_logs::said_of;
use dolmen::signal::{Channel, Processing, Quantity};
use dolmen_records::records::{
    Column, CsvLayout, Decimal, Delimiter, Header, Layout, Pick, RateSource, Reading, RecordOptions,
    TimeColumn, Unit, parse_number, read_csv,
};
use proptest::prelude::*;

pub(super) fn read(text: &str) -> Reading {
    read_csv(text.as_bytes(), &RecordOptions::default()).unwrap()
}

pub(super) fn layout(reading: &Reading) -> &CsvLayout {
    match &reading.layout {
        Layout::Csv(layout) => layout,
        other => panic!("{other:?}"),
    }
}

pub(super) fn refusal_with(text: &str, options: &RecordOptions) -> String {
    read_csv(text.as_bytes(), options).unwrap_err().to_string()
}

pub(super) fn refusal(text: &str) -> String {
    refusal_with(text, &RecordOptions::default())
}

pub(super) fn at_100_hz() -> RecordOptions {
    RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    }
}

fn named(column: &str, channel: &str) -> Pick {
    Pick {
        scale: None,
        column: Column::Named(column.into()),
        channel: Channel::named(channel),
    }
}

#[test]
fn exact_the_same_record_in_every_dialect() {
    for (text, delimiter, decimal) in [
        (
            "time,a,b\n0.00,1.5,-2\n0.01,2.5,0\n0.02,1,3e-1\n",
            Delimiter::Comma,
            Decimal::Point,
        ),
        (
            "time;a;b\r\n0,00;1,5;-2\r\n0,01;2,5;0\r\n0,02;1;3e-1\r\n",
            Delimiter::Semicolon,
            Decimal::Comma,
        ),
        (
            "time;a;b\n0.00;1.5;-2\n0.01;2.5;0\n0.02;1;3e-1",
            Delimiter::Semicolon,
            Decimal::Point,
        ),
        (
            "time\ta\tb\n0.00\t1.5\t-2\n0.01\t2.5\t0\n0.02\t1\t3e-1\n",
            Delimiter::Tab,
            Decimal::Point,
        ),
        (
            "  time   a b\n  0.00  1.5 -2\n\t0.01 2.5\t0  \n0.02 1 3e-1\n",
            Delimiter::WhiteSpace,
            Decimal::Point,
        ),
        (
            "time a b\n0,00 1,5 -2\n0,01 2,5 0\n0,02 1 3e-1\n",
            Delimiter::WhiteSpace,
            Decimal::Comma,
        ),
        (
            "# by hand\n\ntime, a, b\n# rest\n0.00, 1.5, -2\n\n0.01 ,2.5 , 0\n0.02,1,3e-1 \n",
            Delimiter::Comma,
            Decimal::Point,
        ),
        (
            "\"time\",\"a\",\"b\"\n\"0.00\",\"1.5\",\"-2\"\n\"0.01\",\"2.5\",\"0\"\n\"0.02\",\"1\",\"3e-1\"\n",
            Delimiter::Comma,
            Decimal::Point,
        ),
        (
            "\"time\",\"a\",\"b\"\n\"0,00\",\"1,5\",\"-2\"\n\"0,01\",\"2,5\",\"0\"\n\"0,02\",\"1\",\"3e-1\"\n",
            Delimiter::Comma,
            Decimal::Comma,
        ),
        (
            "\u{feff}time,a,b,\n0.00,1.5,-2,\n0.01,2.5,0,\n0.02,1,3e-1,\n",
            Delimiter::Comma,
            Decimal::Point,
        ),
        (
            "time,a,b\n0.00,1.5,-2,\n0.01,2.5,0,\n0.02,1,3e-1,\n",
            Delimiter::Comma,
            Decimal::Point,
        ),
        (
            "a,time (ms),b\n1.5,0,-2\n2.5,10,0\n1,20,3e-1\n",
            Delimiter::Comma,
            Decimal::Point,
        ),
    ] {
        let options = RecordOptions {
            // a comma as both decimal sign and separator is never guessed
            decimal: (delimiter == Delimiter::Comma).then_some(decimal),
            ..Default::default()
        };
        let reading = read_csv(text.as_bytes(), &options).unwrap_or_else(|e| panic!("{text}\n{e}"));
        let record = &reading.record;
        assert_eq!(
            (layout(&reading).delimiter, layout(&reading).decimal),
            (delimiter, decimal),
            "{text}"
        );
        assert_eq!(record.channels(), ["a", "b"].map(Channel::named), "{text}");
        assert_eq!(
            (record.samples(0), record.samples(1)),
            (&[1.5, 2.5, 1.0][..], &[-2.0, 0.0, 0.3][..]),
            "{text}"
        );
        assert_eq!(record.sampling_rate_hz(), 100.0, "{text}");
    }
}

#[test]
fn exact_units_history_and_what_was_found_out() {
    let options = RecordOptions {
        unit: Unit::Gal,
        ..Default::default()
    };
    let reading = read_csv(b"t,roof\n0,100\n0.5,-50\n1.0,25", &options).unwrap();
    assert_eq!(reading.record.samples(0), [1.0, -0.5, 0.25]);
    assert_eq!(reading.record.channels()[0].quantity, Quantity::Acceleration);
    assert_eq!(
        reading.record.history(),
        [Processing::Read {
            format: "csv".into(),
            unit: "cm/s2".into()
        }]
    );
    assert_eq!(
        *layout(&reading),
        CsvLayout {
            delimiter: Delimiter::Comma,
            decimal: Decimal::Point,
            header_line: Some(1),
            columns: vec!["t".into(), "roof".into()],
            time_column: Some("t".into()),
            rate_source: RateSource::Stamps,
            unread_stamps: None,
            first_date: None,
            passed_over: None,
            is_cp949: false,
            names_unread: false,
            time_unit_s: None,
            last_line_ended: false,
        }
    );
}

#[test]
fn exact_columns_picked_by_name_and_number() {
    let options = RecordOptions {
        picks: vec![
            named("b", "roof y"),
            Pick {
                scale: None,
                column: Column::Number(1),
                channel: Channel {
                    position_m: Some([1.0, 2.0, 3.0]),
                    direction: Some([0.0, 1.0, 0.0]),
                    ..Channel::named("roof x")
                },
            },
        ],
        ..at_100_hz()
    };
    let record = read_csv(b"a,x,b\n1,text,2\n3,,4\n5,\"a,b\",7\n", &options)
        .unwrap()
        .record;
    assert_eq!(record.samples(0), [2.0, 4.0, 7.0]); // an unrequested column may contain anything
    assert_eq!(record.samples(1), [1.0, 3.0, 5.0]);
    assert_eq!(record.channels()[1].position_m, Some([1.0, 2.0, 3.0]));
    assert_eq!(record.channels()[0].name, "roof y");
}

#[test]
fn exact_without_names_or_with_lines_to_skip() {
    let record = read_csv(b"1,4\n2,7\n3.5,1\n", &at_100_hz()).unwrap().record;
    assert_eq!(record.channels(), ["ch1", "ch2"].map(Channel::named));
    let options = RecordOptions {
        skip_lines: 2,
        header: Header::Present,
        ..at_100_hz()
    };
    let record = read_csv(b"Logger 7; 3 channels\nm/s2\n1;2\n0,5;4\n1,5;2\n", &options)
        .unwrap()
        .record;
    assert_eq!(record.channels(), ["1", "2"].map(Channel::named));
    assert_eq!(record.samples(0), [0.5, 1.5]);
}

#[test]
fn refuses_a_time_column_taken_for_a_channel() {
    let rows: String = (0..50).map(|i| format!("{},{}\n", i, (i * i) % 7)).collect();
    assert_eq!(
        refusal_with(&rows, &at_100_hz()),
        "column \"ch1\" rises by 1 from each line to the next, as time stamps or a line count do, not as a sensor: name it \
         as the time column, or name the columns to read"
    );
    let options = RecordOptions {
        time: TimeColumn::At(Column::Number(1)),
        sampling_rate_hz: Some(1.0),
        ..Default::default()
    };
    assert_eq!(
        read_csv(rows.as_bytes(), &options)
            .unwrap()
            .record
            .sampling_rate_hz(),
        1.0
    );
}

#[test]
fn refuses_numbers_of_samples_as_seconds_though_the_column_is_named() {
    let rows: String = (1..50).map(|i| format!("{i},{}\n", (i * i) % 7)).collect();
    let options = RecordOptions {
        time: TimeColumn::At(Column::Number(1)),
        ..Default::default()
    };
    for head in ["번호,x\n", "시간(초),x\n"] {
        let refused = refusal_with(&format!("{head}{rows}"), &options);
        assert!(refused.contains("lie 1 apart"), "{refused}");
        assert!(
            refused.contains("if they number the samples, leave time_column out and give sampling_rate"),
            "{refused}"
        );
    }
    // a hundredth of a second is a rate of a vibration
    let rows: String = (1..50)
        .map(|i| format!("{},{}\n", 0.01 * f64::from(i), (i * i) % 7))
        .collect();
    let read = read_csv(format!("t,x\n{rows}").as_bytes(), &options).unwrap();
    assert_eq!(read.record.sampling_rate_hz(), 100.0);
}

#[test]
fn refuses_cells_that_are_no_samples() {
    let with = |cell: &str| format!("time,roof x,roof y\n0.00,1,2\n0.01,{cell},4\n0.02,5,6\n");
    assert_eq!(
        refusal(&with("abc")),
        "line 3, column \"roof x\": \"abc\" is not a number; correct it, leave the column out, or cut the file"
    );
    assert_eq!(
        refusal(&with("1.2.3")),
        "line 3, column \"roof x\": \"1.2.3\" is not a number; correct it, leave the column out, or cut the file"
    );
    assert_eq!(
        refusal(&with("NaN")),
        "line 3, column \"roof x\" holds NaN: a sample is missing; cut the file before or after it, or leave the column out"
    );
    assert!(refusal("time,x\n0.00,1\nNaN,2\n0.02,3\n").starts_with("line 3, column \"time\" holds NaN"));
    for empty in ["", "  ", "\"\""] {
        assert_eq!(
            refusal(&with(empty)),
            "line 3, column \"roof x\" is empty: a sample is missing; cut the file before or after it, or leave the column \
             out"
        );
    }
    for text in ["inf", "-Infinity", "1e999"] {
        assert!(refusal(&with(text)).contains(&format!("holds {text}: a sample is missing")));
    }
    // for stamps as for samples
    assert!(
        refusal("time,x\n0,1\nlater,2\n")
            .starts_with("line 3, column \"time\": the time stamp \"later\" is not")
    );
}

#[test]
fn refuses_a_second_header() {
    let said = "line 4 is the header again: the recorder restarted there, and the time in between is not known; cut the file \
                there, and make the part after it a record of its own";
    assert_eq!(
        refusal("time,x,y\n0,1,2\n0.01,3,1\ntime,x,y\n0,2,5\n0.01,2,5\n"),
        said
    );
    let told = RecordOptions {
        picks: vec![named("y", "roof")],
        ..at_100_hz()
    };
    assert_eq!(refusal_with("x,y\n1,2\n3,1\nx,y\n2,5\n", &told), said);
}

#[test]
fn refuses_dates_unless_rate_and_columns_are_told() {
    let text =
        "time,x,y\n2010-05-12 10:00:00.00,1,2\n2010-05-12 10:00:00.01,3,1\n2010-05-12 10:00:00.02,2,5\n";
    let message = "line 2, column \"time\": the time stamp \"2010-05-12 10:00:00.00\" is not a number of seconds: give \
                   sampling_rate and name the columns to read, then the first and the last date are held against that rate";
    assert_eq!(refusal(text), message);
    assert_eq!(refusal_with(text, &at_100_hz()), message);
    let told = RecordOptions {
        picks: vec![named("y", "roof")],
        ..at_100_hz()
    };
    let reading = read_csv(text.as_bytes(), &told).unwrap();
    assert_eq!(reading.record.samples(0), [2.0, 1.0, 5.0]);
    assert_eq!(
        (layout(&reading).rate_source, &layout(&reading).time_column),
        (RateSource::GivenAndDates, &None)
    );
}

#[test]
fn refuses_a_rate_that_dates_contradict() {
    // ten minutes at 100 Hz, in the formats of loggers and tables
    let written = |stamp: &dyn Fn(u32) -> String, samples: u32| -> String {
        (0..samples).fold("Date/Time;roof\n".to_owned(), |text, i| {
            text + &format!("{};{}.5\n", stamp(i), i * i % 7)
        })
    };
    let clock = |i: u32, point: char| format!("10:{:02}:{:02}{point}{:02}0", i / 6000, i / 100 % 60, i % 100);
    let ways: [&dyn Fn(u32) -> String; 4] = [
        &|i| format!("2024-06-05 {}", clock(i, '.')),
        &|i| format!("2024-06-05T{}Z", clock(i, '.')),
        &|i| format!("05.06.2024 {}", &clock(i, '.')[..8]),
        &|i| format!("{:.9}", 45448.5 + f64::from(i) / 8_640_000.0),
    ];
    let at = |rate_hz: f64| RecordOptions {
        sampling_rate_hz: Some(rate_hz),
        picks: vec![named("roof", "roof")],
        ..Default::default()
    };
    for (k, way) in ways.iter().enumerate() {
        let text = written(way, 60_000);
        let reading = read_csv(text.as_bytes(), &at(100.0)).unwrap();
        assert_eq!(layout(&reading).rate_source, RateSource::GivenAndDates, "{k}");
        let said = refusal_with(&text, &at(200.0));
        assert!(
            said.starts_with("sampling_rate is 200, but column \"Date/Time\" goes from ")
                && said.contains(" in 60000 samples, which is ")
                && said.contains("Hz: correct the rate"),
            "{said}"
        );
    }
    // with missing samples the rate must not change, even if the first and the last date agree with another one
    let cut = |i: u32| ways[0](i + if i < 30_000 { 0 } else { 140 });
    let lost = written(&cut, 59_860);
    for rate_hz in [100.0, 100.0 * 59_859.0 / 59_999.0] {
        let said = refusal_with(&lost, &at(rate_hz));
        assert!(
            said.starts_with("samples are missing: column \"Date/Time\" goes from ")
                && said.contains("1.410 s later")
                && said.contains("(line 30001)"),
            "{said}"
        );
    }
    // unreadable columns confirm nothing, and a note says so
    let reading = read_csv(written(&|i| format!("tick {i}"), 200).as_bytes(), &at(200.0)).unwrap();
    assert_eq!(
        said_of(&reading),
        ["column \"Date/Time\" is not read as times: nothing in the file confirms the sampling rate given"]
    );
}

#[test]
fn refuses_ragged_lines() {
    assert_eq!(
        refusal("time,a,b\n0.00,1,2\n0.01,3\n0.02,5,6\n"),
        "line 3 holds 2 cells, but the lines before it 3: correct it, or cut the file there"
    );
    assert_eq!(
        refusal("time,a,b\n0.00,1,2\n0.01,3,4,5\n0.02,5,6\n"),
        "line 3 holds 4 cells, but the lines before it 3: correct it, or cut the file there"
    );
    assert_eq!(
        refusal("time,a,b\n0.00,1,2\n0.01,3,4\n0.02,"),
        "line 4 holds 2 cells, but the lines before it 3: correct it, or cut the file there; it is the last line: the file \
         was cut short"
    );
    assert!(refusal("t a b\n0.00 1 2\n0.01 3 4\n0.02 5 \n").starts_with("line 4 holds 2 cells"));
    assert!(refusal("t;a;b\n0.00;1;2;\n0.01;3;4;;\n").starts_with("line 3 holds 4 cells"));
}

#[test]
fn refuses_files_without_samples() {
    let empty = "the file is empty: it holds no line but blank ones and comments; is it the right file?";
    for text in ["", "\n\n", "# nothing\n", "  \r\n\r\n"] {
        assert_eq!(refusal(text), empty);
    }
    assert_eq!(
        refusal("time,a\n"),
        "the file holds a header (line 1) but no samples: is it the right file?"
    );
    assert_eq!(
        refusal("time\n0\n1\n"),
        "the file holds only the time column \"time\": there is nothing to read"
    );
    assert_eq!(
        refusal("time,a\n0,1\n"),
        "the record has 1 channels of 1 samples, but must have at least 1 of 2"
    );
    assert_eq!(
        read_csv(b"\xff\xfet\0", &RecordOptions::default())
            .unwrap_err()
            .to_string(),
        "the file is UTF-16 text: save it as UTF-8 (\"CSV UTF-8\" in spreadsheets)"
    );
}

#[test]
fn refuses_columns_that_are_not_there() {
    let text = "time,roof x,roof y,roof y\n0,1,2,3\n1,2,3,4\n";
    let pick = |picks: Vec<Pick>| {
        refusal_with(
            text,
            &RecordOptions {
                picks,
                ..Default::default()
            },
        )
    };
    assert_eq!(
        pick(vec![named("Rooof X", "x")]),
        "there is no column \"Rooof X\" (did you mean \"roof x\"?); the file has time, roof x, roof y, roof y"
    );
    assert_eq!(
        pick(vec![named("base", "x")]),
        "there is no column \"base\"; the file has time, roof x, roof y, roof y"
    );
    assert_eq!(
        pick(vec![named("roof y", "y")]),
        "2 columns are named \"roof y\": ask for the one you mean by its number"
    );
    assert_eq!(
        pick(vec![named("roof x", "x"), named("roof x", "y")]),
        "column \"roof x\" is read twice, as \"x\" and as \"y\": give each channel its own column"
    );
    assert_eq!(
        pick(vec![named("time", "x")]),
        "column \"time\" is read twice, as \"time\" and as \"x\": give each channel its own column"
    );
    let fifth = Pick {
        scale: None,
        column: Column::Number(5),
        channel: Channel::named("x"),
    };
    assert_eq!(
        pick(vec![fifth]),
        "there is no column 5: the file has columns 1 to 4"
    );
}

#[test]
fn refuses_a_first_line_of_names_and_numbers() {
    assert_eq!(
        refusal_with("0.1,oops,0.3\n0.2,0.1,0.4\n", &at_100_hz()),
        "line 1 holds both names and numbers: if it names the columns, say that the header is present; if it holds samples, \
         correct it"
    );
}

#[test]
fn holds_a_file_cut_anywhere_gives_an_error_or_a_shorter_record() {
    for text in [
        "# a\r\ntime,a,b\r\n0.00,1.5,-2\r\n0.01,2.5,0\r\n0.02,1,3e-1\r\n0.03,1,2\r\n",
        "\u{feff}time;\"a;\";b;\n0,00;1,5;-2;\n0,01;\"2,5\";0;\n0,02;1;3e-1;\n",
        "  t  x y\n 0 1 2\n 1 4 3\n 2 9 1\n",
    ] {
        let whole = read(text).record;
        for end in 0..text.len() {
            if let Ok(part) = read_csv(&text.as_bytes()[..end], &RecordOptions::default()) {
                let (length, channels) = (part.record.length(), part.record.channels().len());
                assert!(length <= whole.length() && channels <= whole.channels().len());
                // all but the last line, which may be cut within its last number
                if channels == whole.channels().len() {
                    for channel in 0..channels {
                        assert_eq!(
                            part.record.samples(channel)[..length - 1],
                            whole.samples(channel)[..length - 1]
                        );
                    }
                }
            }
        }
    }
}

proptest! {
    #[test]
    fn holds_numbers_are_those_of_the_standard_library(text in "[+-]?[0-9]{0,22}(\\.[0-9]{0,22})?([eE][+-]?[0-9]{0,5})?") {
        let expected = text.parse::<f64>().ok().map(f64::to_bits);
        prop_assert_eq!(parse_number(text.as_bytes()).map(f64::to_bits), expected);
    }

    #[test]
    fn holds_any_double_comes_back(bits: u64) {
        let x = f64::from_bits(bits);
        prop_assume!(x.is_finite());
        for text in [format!("{x}"), format!("{x:e}"), format!("{x:?}")] {
            let back = read_number_in_a_file(&text);
            if x.abs() <= 1e100 {
                prop_assert_eq!(back.map(f64::to_bits), Some(bits), "{}", text);
            }
        }
    }

    #[test]
    fn holds_any_bytes_give_a_record_or_an_error(bytes in prop::collection::vec(prop::sample::select(b"0123456789.,;-+e\"# \t\r\ntx\xff".to_vec()), 0..80)) {
        let _ = read_csv(&bytes, &RecordOptions::default());
        let _ = read_csv(&bytes, &at_100_hz());
    }
}

/// This text as the first sample of a record.
fn read_number_in_a_file(text: &str) -> Option<f64> {
    if text.len() > 60 {
        return text.parse().ok(); // longer cells are not printed numbers, and are refused
    }
    let file = format!("{text},0\n1,2\n0,0\n");
    Some(read_csv(file.as_bytes(), &at_100_hz()).ok()?.record.samples(0)[0])
}

#[test]
fn exact_columns_below_the_lines_of_a_recorder_and_of_names_in_another_code() {
    let text = "Recorder,GMS\nSerial,1234\n\ntime,ax [mg],ay\n0.00,1,2\n0.01,5,4\n0.02,3,1\n";
    let reading = read(text);
    assert_eq!(reading.record.samples(0), [1.0, 5.0, 3.0]);
    assert_eq!(layout(&reading).header_line, Some(4));
    let said = said_of(&reading);
    assert!(
        said.iter()
            .any(|r| r.starts_with("lines 1 to 2 stand above the names")),
        "{said:?}"
    );
    assert!(said.iter().any(|r| r.contains("\"ax [mg]\" says mg")), "{said:?}");
    // 시간 and 가속도 as EUC-KR
    let mut text = b"\xbd\xc3\xb0\xa3,\xb0\xa1\xbc\xd3\xb5\xb5\n".to_vec();
    text.extend_from_slice(b"0.00,1\n0.01,3\n0.02,2\n");
    let reading = read_csv(&text, &RecordOptions::default()).unwrap();
    assert_eq!(reading.record.sampling_rate_hz(), 100.0);
    assert_eq!(reading.record.channels()[0].name, "가속도");
    assert!(said_of(&reading)[0].contains("CP949"), "{:?}", said_of(&reading));
    // "Höhe" in Windows-1252 is neither
    let reading = read_csv(
        b"time,H\xf6he\n0.00,1\n0.01,3\n0.02,2\n",
        &RecordOptions::default(),
    )
    .unwrap();
    assert_eq!(reading.record.channels()[0].name, "ch2");
    assert!(
        said_of(&reading)[0].contains("neither UTF-8 nor CP949"),
        "{:?}",
        said_of(&reading)
    );
    // a sample that is text stays a fault of its line
    let fault = refusal("time,x\n0.00,abc\n0.01,3\n0.02,2\n");
    assert!(fault.starts_with("line 2"), "{fault}");
}
