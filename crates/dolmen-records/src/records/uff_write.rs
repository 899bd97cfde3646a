//! Writes a record as a universal file: title (151), units (164), nodes (15) and one dataset 58 or 58b per channel.
//!
//! Columns and codes as in the reader `uff`, which states the source.

use dolmen::signal::{Channel, Quantity, Record};
use std::fmt::Write as _;

/// First and last line of a dataset.
const DELIMITER: &str = "    -1\n";
/// Sine of the largest angle between a direction and the axis to which it is assigned.
const ALONG: f64 = 1e-3;
/// Width of a text line.
const COLUMNS: usize = 80;
/// Numbers per line of text.
const A_LINE: usize = 4;
/// Number of text lines in a dataset 58.
const LINES: usize = 11;

/// Format of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UffNumbers {
    /// As text, 13 significant digits (4E20.12).
    Text,
    /// As little-endian doubles (58b), without loss of digits.
    Binary,
}

/// A record as the bytes of a universal file, in SI units.
///
/// Each position of sensors is a node, in the order of the channels; a channel without a position has its own node. Characters of names that are not
/// ASCII become `_`, for other programs. A direction other than ±x, ±y, ±z cannot be written and gets the code 0.
///
/// ```
/// use dolmen::signal::{Channel, Record};
/// use dolmen_records::records::{RecordOptions, UffNumbers, read_record, record_uff};
/// let record = Record::new(vec![Channel::named("roof")], vec![vec![0.25, -1.0, 3.5]], 100.0)?;
/// let bytes = record_uff(&record, "Gate", UffNumbers::Binary);
/// let back = read_record(&bytes, &RecordOptions::default())?.record;
/// assert_eq!((back.samples(0), back.sampling_rate_hz()), (record.samples(0), 100.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn record_uff(record: &Record, title: &str, numbers: UffNumbers) -> Vec<u8> {
    let nodes = Nodes::of(record.channels());
    let mut bytes = head(title, &nodes).into_bytes();
    for (channel, (node, direction)) in nodes.channels.iter().enumerate() {
        let lines = function_lines(record, channel, (*node, *direction), title);
        let samples = record.samples(channel);
        bytes.extend(DELIMITER.as_bytes());
        match numbers {
            UffNumbers::Text => {
                bytes.extend(format!("{:>6}\n{lines}", 58).bytes());
                bytes.extend(printed(samples).bytes());
            }
            UffNumbers::Binary => {
                let size = 8 * samples.len();
                let kind = format!(
                    "{:>6}b{:>6}{:>6}{LINES:>12}{size:>12}{:>6}{:>6}{:>12}{:>12}\n{lines}",
                    58, 1, 2, 0, 0, 0, 0
                );
                bytes.extend(kind.bytes());
                bytes.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
                bytes.push(b'\n');
            }
        }
        bytes.extend(DELIMITER.as_bytes());
    }
    bytes
}

/// Nodes with their positions, and node and direction of each channel.
struct Nodes {
    /// `None` for a channel without a position.
    places: Vec<Option<[f64; 3]>>,
    channels: Vec<(usize, i32)>,
}

impl Nodes {
    fn of(channels: &[Channel]) -> Self {
        let mut nodes = Nodes {
            places: Vec::new(),
            channels: Vec::new(),
        };
        for channel in channels {
            let direction = channel.direction.map_or(0, code);
            // two channels of the same direction and position have separate nodes
            let is_free = |node: usize| !nodes.channels.contains(&(node, direction));
            let place = channel.position_m;
            let there = (0..nodes.places.len())
                .find(|node| place.is_some() && nodes.places[*node] == place && is_free(node + 1));
            let node = there.unwrap_or_else(|| {
                nodes.places.push(place);
                nodes.places.len() - 1
            });
            nodes.channels.push((node + 1, direction));
        }
        nodes
    }
}

/// Code of a direction: 1 x, 2 y, 3 z, negative for the opposite direction; 0 for any other.
fn code(direction: [f64; 3]) -> i32 {
    let across = |axis: usize| {
        let others = (0..3).filter(|other| *other != axis);
        others.map(|other| direction[other].powi(2)).sum::<f64>().sqrt()
    };
    let along = (0..3).find(|axis| across(*axis) <= ALONG && direction[*axis] != 0.0);
    along.map_or(0, |axis| {
        let number = [1, 2, 3][axis];
        if direction[axis] < 0.0 { -number } else { number }
    })
}

/// The datasets with title, units and nodes.
fn head(title: &str, nodes: &Nodes) -> String {
    let mut text = String::from(DELIMITER);
    let _ = writeln!(text, "{:>6}", 151);
    let none = "NONE";
    let program = concat!("dolmen ", env!("CARGO_PKG_VERSION"));
    for line in [&line(title), none, program, none, none, none, none] {
        let _ = writeln!(text, "{line}");
    }
    text += DELIMITER;
    text += DELIMITER;
    let _ = writeln!(text, "{:>6}", 164);
    let _ = writeln!(text, "{:>10}{:<20}{:>10}", 1, "SI: Meter (newton)", 2);
    let _ = writeln!(text, "{}", "  1.00000000000000000D+00".repeat(3));
    text += "  0.00000000000000000D+00\n";
    text += DELIMITER;
    if nodes.places.iter().any(Option::is_some) {
        text += DELIMITER;
        let _ = writeln!(text, "{:>6}", 15);
        for (node, place) in nodes.places.iter().enumerate() {
            if let Some(place) = place {
                let place: String = place
                    .iter()
                    .map(|x| format!("{:>13}", exponential(*x, 5)))
                    .collect();
                let _ = writeln!(text, "{:>10}{:>10}{:>10}{:>10}{place}", node + 1, 0, 0, 0);
            }
        }
        text += DELIMITER;
    }
    text
}

/// The eleven lines before the samples of a channel.
fn function_lines(record: &Record, channel: usize, (node, direction): (usize, i32), title: &str) -> String {
    let of = &record.channels()[channel];
    let (ordinate, name, unit) = match of.quantity {
        Quantity::Acceleration => (12, "Acceleration", "m/s^2"),
        Quantity::Velocity => (11, "Velocity", "m/s"),
        Quantity::Displacement => (8, "Displacement", "m"),
        Quantity::Unknown => (0, "NONE", "NONE"),
    };
    // as many digits as the columns hold: a FORTRAN format E13.5 reads them all
    let step = exponential(1.0 / record.sampling_rate_hz(), 7);
    let entity: String = line(&of.name).chars().take(10).collect();
    let mut text = String::new();
    for words in [
        line(&of.name),
        line(title),
        "NONE".into(),
        "NONE".into(),
        "NONE".into(),
    ] {
        let _ = writeln!(text, "{words}");
    }
    // time response, number, version, load case; response and reference: name, node, direction
    let _ = writeln!(
        text,
        "{:>5}{:>10}{:>5}{:>10} {entity:<10}{node:>10}{direction:>4} {:<10}{:>10}{:>4}",
        1,
        channel + 1,
        0,
        0,
        "NONE",
        0,
        0
    );
    let zero = exponential(0.0, 5);
    // double precision, equal time steps
    let _ = writeln!(
        text,
        "{:>10}{:>10}{:>10}{zero:>13}{step:>13}{zero:>13}",
        4,
        record.length(),
        1
    );
    for (code, exponent, name, unit) in [
        (17, 0, "Time", "s"),
        (ordinate, 0, name, unit),
        (0, 0, "NONE", "NONE"),
        (0, 0, "NONE", "NONE"),
    ] {
        let _ = writeln!(
            text,
            "{code:>10}{exponent:>5}{exponent:>5}{exponent:>5} {name:<20} {unit:<20}"
        );
    }
    text
}

fn printed(samples: &[f64]) -> String {
    let mut text = String::with_capacity(21 * samples.len());
    for row in samples.chunks(A_LINE) {
        for sample in row {
            let _ = write!(text, "{:>20}", exponential(*sample, 12));
        }
        text.push('\n');
    }
    text
}

/// A line of text: ASCII, not blank, within the line width.
fn line(text: &str) -> String {
    let plain = |c: char| {
        if c.is_ascii() && !c.is_ascii_control() {
            c
        } else {
            '_'
        }
    };
    let line: String = text.chars().map(plain).take(COLUMNS).collect();
    match line.trim() {
        "" => "NONE".to_owned(),
        _ => line,
    }
}

/// A number in the notation of FORTRAN, such as 1.23457E-02, with this number of digits after the point and at least two in the exponent.
pub fn exponential(value: f64, digits: usize) -> String {
    let written = format!("{value:.digits$E}");
    match written.split_once('E') {
        Some((digits, exponent)) => {
            let exponent: i32 = exponent.parse().unwrap_or(0);
            let sign = if exponent < 0 { '-' } else { '+' };
            format!("{digits}E{sign}{:02}", exponent.abs())
        }
        None => written,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::{RecordOptions, read_record};

    fn channel(name: &str, quantity: Quantity, position_m: [f64; 3], direction: [f64; 3]) -> Channel {
        Channel {
            name: name.to_owned(),
            quantity,
            position_m: Some(position_m),
            direction: Some(direction),
        }
    }

    fn record(rate_hz: f64) -> Record {
        let half = 0.5_f64.sqrt();
        let channels = vec![
            channel(
                "roof x",
                Quantity::Acceleration,
                [1.25, 0.0, 12.5],
                [1.0, 0.0, 0.0],
            ),
            channel(
                "지붕 y",
                Quantity::Acceleration,
                [1.25, 0.0, 12.5],
                [0.0, -1.0, 0.0],
            ),
            channel("slanted", Quantity::Velocity, [0.0, 2.0, 0.0], [half, half, 0.0]),
            channel(
                "again x",
                Quantity::Displacement,
                [1.25, 0.0, 12.5],
                [1.0, 0.0, 0.0],
            ),
        ];
        let sample = |c: usize, i: usize| ((i * (c + 2)) as f64 * 0.37).sin() * 10f64.powi(-3 * c as i32);
        let samples = (0..4).map(|c| (0..101).map(|i| sample(c, i)).collect()).collect();
        Record::new(channels, samples, rate_hz).unwrap()
    }

    #[test]
    fn holds_a_record_comes_back() {
        for rate_hz in [100.0, 128.0, 51.2] {
            let record = record(rate_hz);
            for (numbers, off) in [(UffNumbers::Text, 1e-12), (UffNumbers::Binary, 0.0)] {
                let bytes = record_uff(&record, "Gate", numbers);
                let back = read_record(&bytes, &RecordOptions::default()).unwrap().record;
                assert!((back.sampling_rate_hz() / rate_hz - 1.0).abs() < 1e-5);
                let names: Vec<&str> = back.channels().iter().map(|one| one.name.as_str()).collect();
                assert_eq!(names, ["1+X", "1-Y", "2", "3+X"]);
                for (at, (old, new)) in record.channels().iter().zip(back.channels()).enumerate() {
                    assert_eq!((old.quantity, old.position_m), (new.quantity, new.position_m));
                    assert_eq!(new.direction, old.direction.filter(|_| at != 2));
                    for (x, y) in record.samples(at).iter().zip(back.samples(at)) {
                        assert!((x - y).abs() <= off * x.abs(), "{x} {y}");
                    }
                }
            }
        }
    }

    #[test]
    fn holds_a_record_without_places_and_units_comes_back() {
        let channels = ["", "b"].map(Channel::named).to_vec();
        let record = Record::new(channels, vec![vec![1e-300, -2e90, 3.0], vec![0.0; 3]], 1.0).unwrap();
        for numbers in [UffNumbers::Text, UffNumbers::Binary] {
            let bytes = record_uff(&record, "", numbers);
            let back = read_record(&bytes, &RecordOptions::default()).unwrap().record;
            assert_eq!(back.samples(0), record.samples(0));
            assert_eq!(back.channels()[1].quantity, Quantity::Unknown);
            assert_eq!(
                (back.channels()[0].position_m, back.channels()[0].direction),
                (None, None)
            );
        }
    }
}
