//! CPU time of the response spectrum of a motion, for bench/spectrum: `spectrum_bench FILE LOOPS`.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    missing_docs,
    reason = "a program for measuring, not a part of the product"
)]

use dolmen::signal::{Component, response_spectrum};
use dolmen_records::motions::{MotionOptions, read_motion};

/// CPU time of this process so far, s.
fn cpu_s() -> f64 {
    // fields 14 and 15 of /proc/self/stat are too coarse: nanoseconds of this thread on the CPU
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    text.split_whitespace().next().unwrap().parse::<f64>().unwrap() * 1e-9
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let bytes = std::fs::read(&arguments[1]).unwrap();
    let loops: usize = arguments[2].parse().unwrap();
    let motion = read_motion("", &[(Component::X, &bytes)], &MotionOptions::default()).unwrap();
    let periods: Vec<f64> = (0..200)
        .map(|k| 0.02 * 200f64.powf(f64::from(k) / 199.0))
        .collect();
    let mut spent = Vec::new();
    let mut spectrum = Vec::new();
    for _ in 0..loops {
        let start = cpu_s();
        spectrum = response_spectrum(&motion, Component::X, &periods, 0.05).unwrap();
        spent.push(cpu_s() - start);
    }
    spent.sort_by(f64::total_cmp);
    println!("{}", spent[spent.len() / 2]);
    for ordinate in spectrum {
        println!("{}", ordinate.displacement_at_samples_m);
    }
}
