//! A simulated record of many channels, identified with the references that Dolmen chooses and with all channels.
//!
//! ```text
//! cargo run --release -p dolmen --example wide_array -- CHANNELS RATE_HZ HIGHEST_HZ SEED [FILE.csv]
//! ```
//! Six modes between 1.3 Hz and the highest, ten minutes. Prints each mode of both, the seconds they took, and the number of modes missed and
//! false. With a file it only writes the record, for the time and memory of the whole process.
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::print_stdout,
    reason = "an example: it prints times, and writes a record"
)]

use dolmen::modal::{Identify, MadeMode, MadeRecord, identify};
use dolmen::signal::Record;
use std::error::Error;
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::time::Instant;

const MODES: usize = 6;
const LOWEST_HZ: f64 = 1.3;
/// A mode found is a true one within this share of its frequency.
const NEAR: f64 = 0.02;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let [channels, rate_hz, highest_hz, seed, ref file @ ..] = words[..] else {
        return Err("wide_array CHANNELS RATE_HZ HIGHEST_HZ SEED [FILE.csv]".into());
    };
    let made = made(
        channels.parse()?,
        rate_hz.parse()?,
        highest_hz.parse()?,
        seed.parse()?,
    );
    let record = made.make()?;
    if let Some(file) = file.first() {
        return Ok(std::fs::write(file, csv(&record)?)?);
    }
    let all = Identify {
        references: (0..record.channels().len()).collect(),
        ..Identify::default()
    };
    for (name, options) in [("chosen", Identify::default()), ("all", all)] {
        let begun = Instant::now();
        let found = identify(&record, &options)?;
        let settings = &found.settings;
        println!(
            "{name} references: {} ({:?}), {} block rows, decimation {}, order {}: {:.2} s",
            settings.references.len(),
            settings.references_keep,
            settings.block_rows,
            settings.decimation,
            settings.order_most,
            begun.elapsed().as_secs_f64()
        );
        let near = |f: f64, mode: &MadeMode| (f / mode.frequency_hz - 1.0).abs() < NEAR;
        let modes = &found.modes.modes;
        let missed = made
            .modes
            .iter()
            .filter(|of| !modes.iter().any(|m| near(m.frequency_hz, of)));
        let other = modes
            .iter()
            .filter(|m| !made.modes.iter().any(|of| near(m.frequency_hz, of)));
        println!("  missed {}, false {}", missed.count(), other.count());
        for mode in modes {
            println!(
                "  {:9.4} ± {:.4} Hz, {:.3} ± {:.3} %",
                mode.frequency_hz,
                mode.frequency_sd_hz.unwrap_or(f64::NAN),
                100.0 * mode.damping_ratio.unwrap_or(f64::NAN),
                100.0 * mode.damping_ratio_sd.unwrap_or(f64::NAN)
            );
        }
    }
    Ok(())
}

/// Modes of a fixed beam, one or two of which a channel hardly sees.
fn made(channels: usize, rate_hz: f64, highest_hz: f64, seed: u64) -> MadeRecord {
    let mode = |k: usize| MadeMode {
        frequency_hz: LOWEST_HZ * (highest_hz / LOWEST_HZ).powf(k as f64 / (MODES - 1) as f64),
        damping_ratio: 0.012,
        shape: (1..=channels)
            .map(|c| ((k as f64 + 0.5) * PI * c as f64 / channels as f64).sin())
            .collect(),
    };
    MadeRecord {
        modes: (0..MODES).map(mode).collect(),
        sampling_rate_hz: rate_hz,
        duration_s: 600.0,
        noise_ratio: 0.1,
        seed,
        ..MadeRecord::default()
    }
}

fn csv(record: &Record) -> Result<String, std::fmt::Error> {
    let names: Vec<&str> = record.channels().iter().map(|c| c.name.as_str()).collect();
    let mut text = format!("time (s),{}\n", names.join(","));
    for t in 0..record.length() {
        write!(text, "{:.6}", t as f64 / record.sampling_rate_hz())?;
        for c in 0..names.len() {
            write!(text, ",{:.6}", record.samples(c)[t])?;
        }
        text.push('\n');
    }
    Ok(text)
}
