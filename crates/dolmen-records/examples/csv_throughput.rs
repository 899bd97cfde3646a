//! Reading speed of records: a million lines of CSV, compared with the crate `csv` and `str::parse`.
//!
//! `cargo run --release -p dolmen-records --example csv_throughput`
//!
//! One thread: on a quiet machine, wall time then equals processor time. Prints the median of the runs, and the
//! fastest run, which is disturbed least.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a measurement")]

use dolmen_records::records::{RecordOptions, read_csv, read_npy};
use std::fmt::Write;
use std::hint::black_box;
use std::time::Instant;

const LINES: usize = 1_000_000;
const CHANNELS: usize = 6;
const RUNS: usize = 7;

fn main() {
    for (what, decimals) in [("6 decimals", Some(6)), ("all digits of a double", None)] {
        let text = table(decimals);
        let megabytes = text.len() as f64 / 1e6;
        println!("{LINES} lines, time and {CHANNELS} channels, {what}: {megabytes:.0} MB");
        let ours = report("  dolmen", megabytes, || {
            read_csv(text.as_bytes(), &RecordOptions::default()).map_or(0, |r| r.record.length())
        });
        let theirs = report("  csv + str::parse", megabytes, || through_csv(&text));
        println!("  ratio {:.2}", ours / theirs);
    }
    let npy = array();
    let megabytes = npy.len() as f64 / 1e6;
    println!("the same as NPY, f8: {megabytes:.0} MB");
    let options = RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    };
    report("  dolmen", megabytes, || {
        read_npy(&npy, &options).map_or(0, |r| r.record.length())
    });
}

/// Runs the case, prints the rates, and returns the median, MB/s.
fn report(what: &str, megabytes: f64, read: impl Fn() -> usize) -> f64 {
    let mut seconds: Vec<f64> = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            assert_eq!(black_box(read()), LINES);
            start.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    let (median, best) = (megabytes / seconds[RUNS / 2], megabytes / seconds[0]);
    println!("{what}: {median:.0} MB/s median, {best:.0} MB/s best of {RUNS}");
    median
}

fn sample(line: usize, channel: usize) -> f64 {
    (0.37 * line as f64 + channel as f64).sin() * 0.01
}

fn table(decimals: Option<usize>) -> String {
    let mut text = "time".to_string();
    for channel in 1..=CHANNELS {
        let _ = write!(text, ",ch{channel}");
    }
    text.push('\n');
    for line in 0..LINES {
        let _ = write!(text, "{:.2}", line as f64 / 100.0);
        for channel in 0..CHANNELS {
            let x = sample(line, channel);
            let _ = match decimals {
                Some(decimals) => write!(text, ",{x:.decimals$}"),
                None => write!(text, ",{x}"),
            };
        }
        text.push('\n');
    }
    text
}

fn array() -> Vec<u8> {
    let literal = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({LINES}, {CHANNELS}), }}");
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(format!("{literal:<117}\n").bytes());
    for line in 0..LINES {
        bytes.extend((0..CHANNELS).flat_map(|channel| sample(line, channel).to_le_bytes()));
    }
    bytes
}

/// A program with the usual crate: byte records, each cell parsed, one vector per column.
fn through_csv(text: &str) -> usize {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let mut columns = vec![Vec::new(); CHANNELS + 1];
    let mut record = csv::ByteRecord::new();
    while reader.read_byte_record(&mut record).unwrap_or(false) {
        for (column, cell) in columns.iter_mut().zip(&record) {
            let value = std::str::from_utf8(cell).ok().and_then(|c| c.parse::<f64>().ok());
            column.push(value.unwrap_or(f64::NAN));
        }
    }
    black_box(&columns);
    columns[0].len()
}
