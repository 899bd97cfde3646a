//! Work for `bench/ssi_cov`: makes a record of known poles as NPY, or finds the poles of one.
//!
//! ```text
//! ssi_bench make pairs|twisting|tower SEED FILE
//! ssi_bench cov|dat FILE SAMPLING_RATE_HZ BLOCK_ROWS ORDER_MOST     prints order, frequency, damping ratio
//! ssi_bench cov-sd|dat-sd FILE RATE BLOCK_ROWS ORDER_MOST           the same with the standard deviations of each pole
//! ssi_bench fdd FILE RATE LINES -                                   prints the frequency of each peak
//! ```
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a measurement")]

use dolmen::modal::{Fdd, Propagation, ReferenceCase, Ssi, fdd, ssi_cov, ssi_data};
use dolmen::signal::Record;
use dolmen_records::records::{RecordOptions, read_npy};
use std::error::Error;
use std::io::Write as _;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        ["make", case, seed, file] => {
            let case = match case {
                "pairs" => ReferenceCase::ClosePairs,
                "twisting" => ReferenceCase::Twisting,
                "tower" => ReferenceCase::Tower,
                _ => return Err("the case must be pairs, twisting or tower".into()),
            };
            std::fs::write(file, npy(&case.made(seed.parse()?)?.make()?))?;
        }
        [method, file, rate, size, order_most] => {
            let options = RecordOptions {
                sampling_rate_hz: Some(rate.parse()?),
                ..Default::default()
            };
            let record = read_npy(&std::fs::read(file)?, &options)?.record;
            let mut out = std::io::BufWriter::new(std::io::stdout().lock());
            if method == "fdd" {
                let options = Fdd {
                    lines: Some(size.parse()?),
                    ..Default::default()
                };
                for mode in fdd(&record, &options)?.modes.modes {
                    writeln!(out, "0 {:.12} 0.01", mode.frequency_hz)?;
                }
                return Ok(());
            }
            let options = Ssi {
                block_rows: size.parse()?,
                order_most: order_most.parse()?,
                ..Default::default()
            };
            let found = match method {
                "cov" | "cov-sd" => ssi_cov(&record, &options)?,
                "dat" | "dat-sd" => ssi_data(&record, &options)?,
                _ => return Err("the method must be cov, dat, cov-sd, dat-sd or fdd".into()),
            };
            drop(record);
            let mut propagation = method.ends_with("-sd").then(|| Propagation::new(&found));
            for pole in &found.poles {
                let (order, f, zeta) = (pole.order, pole.frequency_hz, pole.damping_ratio);
                write!(out, "{order} {f:.12} {zeta:.12}")?;
                if let Some(propagation) = &mut propagation {
                    let sd = propagation.deviation(pole)?;
                    write!(out, " {:.6e} {:.6e}", sd.frequency_sd_hz, sd.damping_ratio_sd)?;
                }
                writeln!(out)?;
            }
        }
        _ => return Err("see the head of ssi_bench.rs".into()),
    }
    Ok(())
}

/// NPY version 1.0, samples × channels, 64-bit.
fn npy(record: &Record) -> Vec<u8> {
    let (samples, channels) = (record.length(), record.channels().len());
    let mut head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({samples}, {channels}), }}");
    while !(10 + head.len() + 1).is_multiple_of(64) {
        head.push(' ');
    }
    head.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((head.len() as u16).to_le_bytes());
    bytes.extend(head.as_bytes());
    for t in 0..samples {
        for c in 0..channels {
            bytes.extend(record.samples(c)[t].to_le_bytes());
        }
    }
    bytes
}
