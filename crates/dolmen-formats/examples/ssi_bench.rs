//! Work for `bench/ssi_cov`: makes a record of known poles as NPY, or finds the poles of one.
//!
//! ```text
//! ssi_bench make pairs|twisting SEED FILE
//! ssi_bench poles FILE SAMPLING_RATE_HZ BLOCK_ROWS ORDER_MOST      prints order, frequency, damping ratio
//! ```

use dolmen::modal::{ReferenceCase, SsiCov, ssi_cov};
use dolmen::signal::Record;
use dolmen_formats::records::{RecordOptions, read_npy};
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
                _ => return Err("the case must be pairs or twisting".into()),
            };
            std::fs::write(file, npy(&case.made(seed.parse()?)?.make()?))?;
        }
        ["poles", file, rate, block_rows, order_most] => {
            let options = RecordOptions {
                sampling_rate_hz: Some(rate.parse()?),
                ..Default::default()
            };
            let record = read_npy(&std::fs::read(file)?, &options)?.record;
            let found = ssi_cov(
                &record,
                &SsiCov {
                    block_rows: block_rows.parse()?,
                    order_most: order_most.parse()?,
                    ..Default::default()
                },
            )?;
            let mut out = std::io::BufWriter::new(std::io::stdout().lock());
            for pole in &found.poles {
                writeln!(
                    out,
                    "{} {:.12} {:.12}",
                    pole.order, pole.frequency_hz, pole.damping_ratio
                )?;
            }
        }
        _ => {
            return Err(
                "ssi_bench make CASE SEED FILE, or ssi_bench poles FILE RATE BLOCK_ROWS ORDER_MOST".into(),
            );
        }
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
