//! Time stamps of records from CSV: the resulting rate, lost samples, uneven clocks.

use super::csv_records::{at_100_hz, layout, read, refusal, refusal_with};
use super::korean_logs::said_of;
use dolmen_records::records::{
    Column, LostSamples, RateSource, Reading, RecordOptions, TimeColumn, read_csv,
};

/// `steps` stamps at this rate, printed with this many decimals.
fn stamped(rate_hz: f64, steps: usize, decimals: usize) -> String {
    (0..steps).fold("t,x\n".to_string(), |text, i| {
        text + &format!("{:.decimals$},{}\n", i as f64 / rate_hz, (i * i) % 7)
    })
}

#[test]
fn exact_the_rate_behind_rounded_stamps() {
    for (rate_hz, steps, decimals) in [
        (100.0, 3, 2),
        (100.0, 5000, 2),
        (100.0, 5000, 6),
        (128.0, 5000, 3),
        (200.0, 5000, 3),
        (51.2, 5000, 4),
        (1000.0 / 3.0, 5000, 3), // a step of 3 ms
        (256.0, 5000, 9),
        (1.25, 20, 1),
        (10.0, 4, 1),
    ] {
        let rate = read(&stamped(rate_hz, steps, decimals)).record.sampling_rate_hz();
        assert!(
            (rate / rate_hz - 1.0).abs() < 1e-12,
            "{rate_hz} Hz with {decimals} decimals: {rate}"
        );
    }
}

#[test]
fn exact_stamps_that_lose_decimals_as_they_grow() {
    // seven digits, as printed by "%.7g": 0.005 … 1000.005 is 1000.005; 10000.01 loses a digit
    let mut text = "t,x\n".to_string();
    for i in 0..3000 {
        let stamp = 9990.0 + f64::from(i) * 0.02;
        let decimals = if stamp < 10_000.0 { 3 } else { 2 };
        text += &format!("{stamp:.decimals$},{}\n", i % 11);
    }
    assert_eq!(read(&text).record.sampling_rate_hz(), 50.0);
}

#[test]
fn refuses_uneven_time_stamps_with_line_step_and_expectation() {
    let mut lines: Vec<String> = stamped(100.0, 200, 3).lines().map(String::from).collect();
    lines.remove(120); // the stamp 1.19
    let whole = RecordOptions {
        lost_samples: LostSamples::Refuse,
        ..Default::default()
    };
    assert_eq!(
        refusal_with(&lines.join("\n"), &whole),
        "line 121: the time stamp 1.2 s is 0.020000 s after the one before, but even steps of 0.010000 s would put it at \
         1.190000 s: samples are missing or the clock jumped; cut the file there, or resample it before"
    );
    // repeated, backwards, and a clock that runs faster from the middle on
    assert!(
        refusal("t,x\n0,1\n0.01,2\n0.01,5\n0.02,2\n").contains("line 4: the time stamp is 0.000000 s after")
    );
    assert!(
        refusal("t,x\n0,1\n0.010,2\n0.005,5\n")
            .starts_with("line 4: the time stamp 0.005 s is -0.005000 s after")
    );
    let mut text = stamped(100.0, 500, 4);
    for i in 1..500 {
        text += &format!("{:.4},{}\n", 4.99 + f64::from(i) * 0.01002, i % 5);
    }
    assert!(refusal(&text).contains("samples are missing or the clock jumped"));
}

#[test]
fn refuses_stamps_that_scatter_and_says_that_no_sample_is_missing() {
    // 100 Hz, stamps up to 0.8 ms off, as of a phone
    let mut text = "t,x\n".to_string();
    for i in 0..200 {
        text += &format!(
            "{:.4},{}\n",
            0.01 * f64::from(i) + 0.0008 * f64::from(7 * i % 5 - 2) / 2.0,
            i % 11
        );
    }
    let given = RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    };
    let said = refusal_with(&text, &given);
    assert!(
        said.contains("even steps are 0.010000 s: no sample is missing there, but the stamps scatter"),
        "{said}"
    );
    // without the rate, the even step is the mean of all steps, not that of the stamps before
    let said = refusal(&text);
    assert!(
        said.contains("even steps are 0.010006 s: no sample is missing there"),
        "{said}"
    );
}

/// The used rows, their first sample, and the notes.
fn kept(rows: impl Iterator<Item = usize>) -> (usize, f64, String) {
    let text = rows.fold("t,x\n".to_string(), |text, i| {
        text + &format!("{:.3},{i}.{}\n", 7.0 + i as f64 / 100.0, 7 * i % 10)
    });
    let record = read(&text).record;
    assert_eq!(record.sampling_rate_hz(), 100.0);
    let said = record
        .history()
        .last()
        .map(ToString::to_string)
        .unwrap_or_default();
    (record.length(), record.samples(0)[0], said)
}

#[test]
fn exact_longest_whole_span_of_a_record_that_lost_samples() {
    let lost = |gaps: &'static [std::ops::Range<usize>]| {
        kept((0..200).filter(|i| !gaps.iter().any(|gap| gap.contains(i))))
    };
    let (length, first, said) = lost(&[119..128, 150..160]);
    assert_eq!((length, first), (119, 0.0));
    assert_eq!(
        said,
        "samples are lost: 0.090 s after 1.180 s, 0.100 s after 1.490 s; only the longest whole span is used, 0.000 to 1.180 s: 1.180 of \
         1.990 s"
    );
    // an isolated sample, at the start and between two gaps, is its own span
    let (length, first, said) = lost(&[1..4, 50..60, 61..70]);
    assert_eq!((length, first), (130, 70.0));
    assert!(
        said.starts_with(
            "samples are lost: 0.030 s after 0.000 s, 0.100 s after 0.490 s, 0.090 s after 0.600 s; only"
        ),
        "{said}"
    );
    // every eleventh is lost: the remaining spans are no record
    let text = (0..200)
        .filter(|i| i % 11 > 0)
        .fold("t,x\n".to_string(), |text, i| {
            text + &format!("{:.3},{i}.{}\n", i as f64 / 100.0, 7 * i % 10)
        });
    assert!(refusal(&text).contains("samples are missing or the clock jumped"));
}

/// A 1 Hz oscillation at 100 Hz, stamped to the millisecond, without some rows.
fn swing(lost: &[std::ops::Range<usize>]) -> String {
    let rows = (0..2000).filter(|i| !lost.iter().any(|gap| gap.contains(i)));
    rows.fold("t,x,y\n".to_string(), |text, i| {
        let t = i as f64 / 100.0;
        let x = (6.3 * t).sin() + 0.3 * (19.0 * t).cos();
        text + &format!("{t:.3},{x:.9},{:.9}\n", -2.0 * x)
    })
}

#[test]
fn holds_single_lost_samples_are_filled_in_and_said() {
    let whole = read(&swing(&[])).record;
    let found = read(&swing(&[300..301, 800..803, 1500..1501])).record;
    assert_eq!(found.length(), 2000);
    for channel in 0..2 {
        for (a, b) in whole.samples(channel).iter().zip(found.samples(channel)) {
            assert!((a - b).abs() < 0.02, "{a} {b}");
        }
    }
    let said = found.history().last().unwrap().to_string();
    assert_eq!(
        said,
        "lost samples filled in by linear prediction: 5 (0.250 %), 0.010 s after 2.990 s, 0.030 s after 7.990 s, 0.010 s after 14.990 s"
    );
    // nine at once are too many: the longer side is used, including its filled samples
    let found = read(&swing(&[300..309, 800..803])).record;
    assert_eq!((found.length(), found.history().len()), (1691, 3));
    let said: Vec<String> = found.history().iter().map(ToString::to_string).collect();
    assert!(
        said[1].starts_with(
            "samples are lost: 0.090 s after 2.990 s; only the longest whole span is used, 3.090 to 19.990 s"
        ),
        "{said:?}"
    );
    assert!(said[2].contains("prediction: 3 (0.177 %)"), "{said:?}");
    // as before, if requested
    let options = RecordOptions {
        lost_samples: LostSamples::Longest,
        ..Default::default()
    };
    let found = read_csv(swing(std::slice::from_ref(&(800..803))).as_bytes(), &options)
        .unwrap()
        .record;
    assert_eq!(found.length(), 1197);
}

#[test]
fn refuses_a_missing_sample_hidden_in_coarse_stamps() {
    let mut lines: Vec<String> = stamped(100.0, 200, 2).lines().map(String::from).collect();
    lines.remove(120);
    let expected = "line 121: the time stamp is 0.020000 s after the one before, that one 0.010000 s after its own; printed \
                    to 0.01 s, this may be rounding or a missing sample: give sampling_rate if none is missing, or \
                    print more digits";
    assert_eq!(refusal(&lines.join("\n")), expected);
    // a given rate whose stamps need no rounding changes nothing; one whose stamps do is accepted
    assert_eq!(refusal_with(&lines.join("\n"), &at_100_hz()), expected);
    let options = RecordOptions {
        sampling_rate_hz: Some(128.0),
        ..Default::default()
    };
    let reading = read_csv(stamped(128.0, 500, 2).as_bytes(), &options).unwrap();
    assert_eq!(layout(&reading).rate_source, RateSource::GivenAndStamps);
}

#[test]
fn refuses_a_rate_that_the_stamps_contradict() {
    let options = RecordOptions {
        sampling_rate_hz: Some(200.0),
        ..Default::default()
    };
    assert_eq!(
        refusal_with(&stamped(100.0, 500, 4), &options),
        "sampling_rate is 200, but the time stamps say 100.000000: correct it, or leave it out to take that of the stamps; \
         if the stamps count another unit than the head of their column says, correct the head"
    );
    assert_eq!(
        refusal("a,b\n1,2\n4,3\n"),
        "the sampling rate is not known: no column is named time or t (the columns are a, b); give sampling_rate (dates in a column are then \
         held against it), or name a time column in seconds"
    );
    assert!(
        refusal("시간 (시),b\n1,2\n4,3\n")
            .starts_with("column \"시간 (시)\" looks like time stamps in a unit")
    );
}

#[test]
fn exact_rates_of_stamps_in_days_and_in_milliseconds() {
    // 2023-03-15 12:00 in the days of a table, ten decimals, 200 Hz
    let days = (0..2000).fold("time,x\n".to_string(), |text, i| {
        text + &format!(
            "{:.10},{}\n",
            45_000.5 + f64::from(i) / 200.0 / 86_400.0,
            (i * i) % 7
        )
    });
    let reading = read(&days);
    assert!((reading.record.sampling_rate_hz() / 200.0 - 1.0).abs() < 1e-4);
    assert_eq!(layout(&reading).time_unit_s, Some(86_400.0));
    assert!(
        said_of(&reading)[0].contains("are read as days"),
        "{:?}",
        said_of(&reading)
    );

    let milliseconds = |name: &str| {
        (0..200).fold(format!("{name},x\n"), |text, i| {
            text + &format!("{},{}\n", 5 * i, (i * i) % 7)
        })
    };
    let fault = refusal(&milliseconds("time"));
    assert!(
        fault.starts_with("the time stamps of column \"time\" lie 5 apart")
            && fault.contains("sampling_rate = \"200.0000 Hz\""),
        "{fault}"
    );
    let given = RecordOptions {
        sampling_rate_hz: Some(200.0),
        ..Default::default()
    };
    let reading = read_csv(milliseconds("time").as_bytes(), &given).unwrap();
    assert_eq!(reading.record.sampling_rate_hz(), 200.0);
    assert_eq!(layout(&reading).time_unit_s, Some(1e-3));
    // stated by the name, or steps in seconds: unchanged; 5 s is no step of a vibration, unless the rate confirms it
    assert_eq!(read(&milliseconds("time [ms]")).record.sampling_rate_hz(), 200.0);
    let fault = refusal(&milliseconds("시간 [s]"));
    assert!(fault.contains("if they number the samples"), "{fault}");
    let slow = RecordOptions {
        sampling_rate_hz: Some(0.2),
        ..Default::default()
    };
    let reading = read_csv(milliseconds("시간 [s]").as_bytes(), &slow).unwrap();
    assert_eq!(reading.record.sampling_rate_hz(), 0.2);
    assert_eq!(
        read(&stamped(100.0, 200, 2).replace("t,", "시간,"))
            .record
            .sampling_rate_hz(),
        100.0
    );
}

#[test]
fn exact_stamps_in_minutes_and_hours_are_read_by_the_unit_of_their_head() {
    let stamps = |name: &str, unit_s: f64| {
        (0..2000).fold(format!("{name},x\n"), |text, i| {
            text + &format!("{:.9},{}\n", f64::from(i) * 0.01 / unit_s, (i * i) % 7)
        })
    };
    let near =
        |reading: &Reading, rate_hz: f64| (reading.record.sampling_rate_hz() / rate_hz - 1.0).abs() < 1e-4;
    for (name, unit_s) in [
        ("시간(분)", 60.0),
        ("Time (min)", 60.0),
        ("time [h]", 3600.0),
        ("시간(밀리초)", 1e-3),
    ] {
        assert!(near(&read(&stamps(name, unit_s)), 100.0), "{name}");
        // the same if the user names the column
        let named = RecordOptions {
            time: TimeColumn::At(Column::Number(1)),
            ..Default::default()
        };
        let reading = read_csv(stamps(name, unit_s).as_bytes(), &named).unwrap();
        assert!(near(&reading, 100.0), "{name}");
    }
    // an ambiguous heading, named or not: the rate determines the unit, and without one it is refused
    for time in [TimeColumn::Detect, TimeColumn::At(Column::Number(1))] {
        let text = stamps("시간(시)", 60.0);
        let options = RecordOptions {
            time,
            ..Default::default()
        };
        let fault = read_csv(text.as_bytes(), &options).unwrap_err().to_string();
        assert!(
            fault.contains("give sampling_rate, which then tells the unit"),
            "{fault}"
        );
        let rated = RecordOptions {
            sampling_rate_hz: Some(100.0),
            ..options
        };
        assert!(near(&read_csv(text.as_bytes(), &rated).unwrap(), 100.0));
    }
    // a rate that contradicts the unit in the heading
    let rated = RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    };
    let fault = read_csv(stamps("Time (min)", 1.0).as_bytes(), &rated)
        .unwrap_err()
        .to_string();
    assert!(fault.contains("correct the head"), "{fault}");
}

#[test]
fn refuses_a_second_stamp_that_is_not_after_the_first() {
    let fault = refusal("t,x\n0.50,1\n0.20,5\n0.10,3\n");
    assert!(
        fault.starts_with("line 3: the time stamp 0.2 is not after the one before, 0.5"),
        "{fault}"
    );
}

/// "mm:ss.00" of Excel across an hour, without a rate: the record, and faults with their lines.
#[test]
fn exact_minutes_and_seconds_without_their_hour() {
    let of = |stamp: &dyn Fn(usize) -> String| -> String {
        let lines = (0..400).map(|i| format!("{},{}\n", stamp(i), (i * 37) % 11));
        format!("시간,x\n{}", lines.collect::<String>())
    };
    // 3598 s of the hour at 100 Hz
    let stamp = |hundredths: usize| {
        let second = hundredths / 100;
        format!(
            "{:02}:{:02}.{:02}",
            second / 60 % 60,
            second % 60,
            hundredths % 100
        )
    };
    let read = read_csv(of(&|i| stamp(359_800 + i)).as_bytes(), &RecordOptions::default()).unwrap();
    assert_eq!(
        (read.record.sampling_rate_hz(), read.record.length()),
        (100.0, 400)
    );
    let refused = |text: String| {
        read_csv(text.as_bytes(), &RecordOptions::default())
            .unwrap_err()
            .to_string()
    };
    // a gap of a second after the 251st: the longest span remains, as for stamps in seconds
    let gap = of(&|i| stamp(359_800 + i + if i > 250 { 100 } else { 0 }));
    let kept = read_csv(gap.as_bytes(), &RecordOptions::default()).unwrap();
    assert_eq!(
        (kept.record.sampling_rate_hz(), kept.record.length()),
        (100.0, 251)
    );
    // "mm:ss.0" shows ten samples with the same text
    let coarse = refused(of(&|i| stamp(10 * ((359_800 + i) / 10))[..7].to_owned()));
    assert!(coarse.contains("line 12"), "{coarse}");
    // hours and minutes, or minutes and seconds
    let either = refused(of(&|i| stamp(100 * i)[..5].to_owned()));
    assert!(
        either.starts_with("line 2, column \"시간\": the time stamp \"00:00\""),
        "{either}"
    );
}
