//! Writes a record as CSV: time, then one column per channel, in SI units.

use dolmen::signal::{Quantity, Record};
use std::fmt::Write as _;

/// A record as the text of a CSV file without loss of digits: `time (s)` from 0, then each channel under its name and
/// unit.
///
/// ```
/// use dolmen::signal::{Channel, Record};
/// let record = Record::new(vec![Channel::named("roof, x")], vec![vec![0.25, -1.0]], 100.0)?;
/// assert_eq!(dolmen_records::records::record_csv(&record), "time (s),\"roof, x\"\n0,0.25\n0.01,-1\n");
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn record_csv(record: &Record) -> String {
    let mut text = String::from("time (s)");
    for channel in record.channels() {
        let unit = match channel.quantity {
            Quantity::Acceleration => " [m/s2]",
            Quantity::Velocity => " [m/s]",
            Quantity::Displacement => " [m]",
            Quantity::Unknown => "",
        };
        let _ = match format!("{}{unit}", channel.name) {
            name if name.contains([',', '"', '\n', '\r']) => {
                write!(text, ",\"{}\"", name.replace('"', "\"\""))
            }
            name => write!(text, ",{name}"),
        };
    }
    text.push('\n');
    let all: Vec<&[f64]> = (0..record.channels().len())
        .map(|at| record.samples(at))
        .collect();
    for i in 0..record.length() {
        let _ = write!(text, "{}", i as f64 / record.sampling_rate_hz());
        for samples in &all {
            let _ = match samples[i] {
                // the shortest text that is read as the same number
                sample if sample != 0.0 && !(1e-5..1e15).contains(&sample.abs()) => {
                    write!(text, ",{sample:e}")
                }
                sample => write!(text, ",{sample}"),
            };
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::{Pick, RecordOptions, Unit, read_record};
    use dolmen::signal::Channel;

    #[test]
    fn holds_a_record_comes_back_to_the_last_bit() {
        let acceleration = |name: &str| Channel {
            quantity: Quantity::Acceleration,
            ..Channel::named(name)
        };
        let samples = |c: i32| {
            (0..500)
                .map(|i| (f64::from(i) * 0.7).sin() * 10f64.powi(-7 * c))
                .collect()
        };
        let channels = vec![acceleration("a"), acceleration("b")];
        let record = Record::new(channels, vec![samples(0), samples(1)], 128.0).unwrap();
        let options = RecordOptions {
            unit: Unit::MetrePerSecondSquared,
            picks: Vec::<Pick>::new(),
            ..Default::default()
        };
        let back = read_record(record_csv(&record).as_bytes(), &options)
            .unwrap()
            .record;
        assert_eq!(back.sampling_rate_hz(), 128.0);
        for at in 0..2 {
            assert_eq!(back.samples(at), record.samples(at));
            assert_eq!(back.channels()[at].quantity, Quantity::Acceleration);
        }
    }
}
