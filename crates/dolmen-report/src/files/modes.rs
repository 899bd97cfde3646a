//! Modes for other programs: universal file (UFF 15 and 55), CSV, and animated shapes (glTF).
//!
//! | dataset | what | per |
//! |:--|:--|:--|
//! | 164 | units: SI | |
//! | 15 | node, place in m | place of sensors |
//! | 55 | complex eigenvalue (rad/s) and displacement vector (complex, 3 components) | mode |

use super::named::NamedFile;
use crate::figures::Wires;
use crate::mode_film::mode_film;
use dolmen::modal::{Mode, Modes};
use dolmen::structure::ShapeMotion;
use dolmen_records::records::exponential;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Largest number of animated modes: the lowest in frequency, as in the figure.
const FILMS_MOST: usize = 12;
/// Begins and ends a dataset.
const DELIMITER: &str = "    -1\n";
/// Two directions at one position are perpendicular within this cosine.
const RIGHT_ANGLE: f64 = 0.02;

/// The modes of a survey as CSV and, if its sensors have positions and directions, as a universal file.
pub(super) fn mode_files(survey: &str, modes: &Modes) -> Vec<NamedFile> {
    if modes.modes.is_empty() {
        return Vec::new();
    }
    let csv = NamedFile::new(&format!("{survey}-modes.csv"), csv(modes));
    let universal = universal(survey, modes);
    let universal = universal.map(|text| NamedFile::new(&format!("{survey}-modes.uff"), text));
    [csv]
        .into_iter()
        .chain(universal)
        .chain(films(survey, modes))
        .collect()
}

/// The lowest modes animated, one glTF each, if at least two sensors have positions and directions.
fn films(survey: &str, modes: &Modes) -> Vec<NamedFile> {
    let Some(wires) = Wires::of(modes) else {
        return Vec::new();
    };
    let each = modes.modes.iter().take(FILMS_MOST).enumerate();
    let film = |(at, mode)| {
        let number = at + 1;
        let name = format!("{survey}-mode-{number}.glb");
        NamedFile::new(&name, mode_film(&wires, (number, mode)))
    };
    each.map(film).collect()
}

/// One row per mode: frequency and damping ratio with standard deviations, whether the user accepted it although no test found it,
/// the direction of its motion ("x", "y", "torsion", otherwise "other"), then real and imaginary part of each channel.
fn csv(modes: &Modes) -> String {
    let mut text = String::from(
        "mode,frequency_hz,frequency_sd_hz,damping_ratio,damping_ratio_sd,phase_collinearity,accepted,direction",
    );
    for channel in &modes.channels {
        let name = channel.name.replace('"', "\"\"");
        let _ = write!(text, ",\"{name} re\",\"{name} im\"");
    }
    text.push('\n');
    let known = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for (i, mode) in modes.modes.iter().enumerate() {
        let _ = write!(
            text,
            "{},{},{},{},{},{},{},{}",
            i + 1,
            mode.frequency_hz,
            known(mode.frequency_sd_hz),
            known(mode.damping_ratio),
            known(mode.damping_ratio_sd),
            mode.phase_collinearity,
            !mode.is_found(),
            direction(modes, mode)
        );
        for z in &mode.shape {
            let _ = write!(text, ",{},{}", z.re, z.im);
        }
        text.push('\n');
    }
    text
}

/// The direction of a mode in the words of surveys.
fn direction(modes: &Modes, mode: &Mode) -> &'static str {
    let shape: Vec<[f64; 2]> = mode.shape.iter().map(|z| [z.re, z.im]).collect();
    let motion = ShapeMotion::of(&modes.channels, &shape);
    motion.direction().unwrap_or("other")
}

/// Positions of the sensors; position and direction of each channel.
struct Nodes {
    places: Vec<[f64; 3]>,
    channels: Vec<(usize, [f64; 3])>,
}

impl Nodes {
    /// `None` if a channel lacks position or direction, or if two directions at one position are neither equal nor perpendicular: the
    /// motion there is then not the sum of the measured components.
    fn of(modes: &Modes) -> Option<Nodes> {
        let mut nodes = Nodes {
            places: Vec::new(),
            channels: Vec::new(),
        };
        for channel in &modes.channels {
            let (at, direction) = (channel.position_m?, channel.direction?);
            let place = nodes.places.iter().position(|place| *place == at);
            let place = place.unwrap_or_else(|| {
                nodes.places.push(at);
                nodes.places.len() - 1
            });
            let cosine = |other: &[f64; 3]| -> f64 { other.iter().zip(direction).map(|(a, b)| a * b).sum() };
            let mut here = nodes.channels.iter().filter(|(node, _)| *node == place);
            if here.any(|(_, other)| cosine(other).abs() > RIGHT_ANGLE) {
                return None;
            }
            nodes.channels.push((place, direction));
        }
        Some(nodes)
    }

    /// The vectors of a mode, one per position: real and imaginary part of each component.
    fn vectors(&self, mode: &Mode) -> Vec<[[f64; 2]; 3]> {
        let mut vectors = vec![[[0.0; 2]; 3]; self.places.len()];
        for ((place, direction), z) in self.channels.iter().zip(&mode.shape) {
            for (sum, part) in vectors[*place].iter_mut().zip(direction) {
                sum[0] += part * z.re;
                sum[1] += part * z.im;
            }
        }
        vectors
    }
}

/// The universal file: nodes, then one dataset 55 per mode, each with its complex eigenvalue.
fn universal(survey: &str, modes: &Modes) -> Option<String> {
    let nodes = Nodes::of(modes)?;
    let mut text = String::from(DELIMITER);
    let _ = writeln!(text, "{:>6}\n{:>10}{:<20}{:>10}", 164, 1, "SI: Meter (newton)", 2);
    let _ = writeln!(text, "{}", "  1.00000000000000000D+00".repeat(3));
    let _ = writeln!(text, "  0.00000000000000000D+00\n    -1");
    text.push_str(DELIMITER);
    text.push_str("    15\n");
    for (i, place) in nodes.places.iter().enumerate() {
        let _ = writeln!(text, "{:10}{:10}{:10}{:10}{}", i + 1, 0, 0, 0, numbers(place));
    }
    text.push_str(DELIMITER);
    for (i, mode) in modes.modes.iter().enumerate() {
        text.push_str(DELIMITER);
        text.push_str("    55\n");
        let first = match mode.is_found() {
            true => format!("{survey} mode {}", i + 1),
            false => format!("{survey} mode {} (accepted by the user)", i + 1),
        };
        let known =
            |value: Option<f64>| value.map_or_else(|| "NONE".to_owned(), |value| format!("{value:.6}"));
        let lines = [
            first,
            format!(
                "{:.6} Hz, damping ratio {}",
                mode.frequency_hz,
                known(mode.damping_ratio)
            ),
            format!(
                "standard deviations {} Hz, {}",
                known(mode.frequency_sd_hz),
                known(mode.damping_ratio_sd)
            ),
            modes.method.name().to_owned(),
            "NONE".to_owned(),
        ];
        for line in lines {
            let printable = |c: char| {
                if c.is_ascii() && !c.is_ascii_control() {
                    c
                } else {
                    '_'
                }
            };
            let line: String = line.chars().map(printable).take(80).collect();
            let _ = writeln!(text, "{line}");
        }
        // structural, complex eigenvalues, vectors of three, displacement, complex, three values a node
        let _ = writeln!(text, "{:10}{:10}{:10}{:10}{:10}{:10}", 1, 3, 2, 8, 5, 3);
        let _ = writeln!(text, "{:10}{:10}{:10}{:10}", 2, 6, 1, i + 1);
        let (omega, zeta) = (TAU * mode.frequency_hz, mode.damping_ratio.unwrap_or(0.0));
        let eigenvalue = [-zeta * omega, omega * (1.0 - zeta * zeta).max(0.0).sqrt()];
        let _ = writeln!(
            text,
            "{}",
            numbers(&[eigenvalue[0], eigenvalue[1], 1.0, 0.0, 1.0, 0.0])
        );
        for (node, vector) in nodes.vectors(mode).iter().enumerate() {
            let _ = writeln!(text, "{:10}", node + 1);
            let _ = writeln!(text, "{}", numbers(&vector.concat()));
        }
        text.push_str(DELIMITER);
    }
    Some(text)
}

/// Numbers in FORTRAN format E13.5.
fn numbers(values: &[f64]) -> String {
    values
        .iter()
        .map(|value| format!("{:>13}", exponential(*value, 5)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::modal::{Identify, ReferenceCase, identify};

    fn modes() -> Modes {
        let record = ReferenceCase::ShearChain.made(1).unwrap().make().unwrap();
        let mut modes = identify(&record, &Identify::default()).unwrap().modes;
        for (i, channel) in modes.channels.iter_mut().enumerate() {
            channel.position_m = Some([0.0, 0.0, 1.0 + i as f64]);
            channel.direction = Some([1.0, 0.0, 0.0]);
        }
        modes
    }

    #[test]
    fn exact_numbers_as_fortran_writes_them() {
        assert_eq!(
            numbers(&[0.012_345_67, -3.0e12, 0.0]),
            "  1.23457E-02 -3.00000E+12  0.00000E+00"
        );
        assert_eq!(exponential(1e-120, 5), "1.00000E-120");
    }

    /// Read by the format description, with a reader that shares no code with the writer.
    #[test]
    fn holds_eigenvalues_and_shapes_come_back_from_the_universal_file() {
        let modes = modes();
        let text = universal("2026-04-02", &modes).unwrap();
        let datasets: Vec<Vec<&str>> = text
            .split("    -1\n")
            .filter(|part| !part.is_empty())
            .map(|part| part.lines().collect())
            .collect();
        assert_eq!(datasets.len(), 2 + modes.modes.len());
        assert_eq!(datasets[0][0].trim(), "164");
        assert_eq!(datasets[1][0].trim(), "15");
        assert_eq!(datasets[1][2].split_whitespace().last(), Some("2.00000E+00"));
        for (dataset, mode) in datasets[2..].iter().zip(&modes.modes) {
            assert_eq!(dataset[0].trim(), "55");
            let of = |line: usize| -> Vec<f64> {
                dataset[line]
                    .split_whitespace()
                    .map(|word| word.parse().unwrap())
                    .collect()
            };
            assert_eq!(of(6), [1.0, 3.0, 2.0, 8.0, 5.0, 3.0]);
            let eigenvalue = of(8);
            let omega = eigenvalue[0].hypot(eigenvalue[1]);
            assert!((omega / TAU / mode.frequency_hz - 1.0).abs() < 1e-5);
            assert!((-eigenvalue[0] / omega - mode.damping_ratio.unwrap()).abs() < 1e-6);
            for (node, z) in mode.shape.iter().enumerate() {
                assert_eq!(of(9 + 2 * node), [(node + 1) as f64]);
                let vector = of(10 + 2 * node);
                assert!((vector[0] - z.re).abs() < 1e-5 && (vector[1] - z.im).abs() < 1e-5);
                assert_eq!(vector[2..], [0.0; 4]);
            }
        }
    }

    #[test]
    fn no_universal_file_without_places_or_of_slanted_pairs() {
        let mut modes = modes();
        modes.channels[1].position_m = modes.channels[0].position_m;
        modes.channels[1].direction = Some([0.8, 0.6, 0.0]);
        assert_eq!(universal("a", &modes), None);
        modes.channels[1].direction = Some([0.0, 1.0, 0.0]);
        assert!(universal("a", &modes).is_some());
        modes.channels[1].position_m = None;
        assert_eq!(universal("a", &modes), None);
    }

    #[test]
    fn holds_a_row_a_mode_in_the_csv() {
        let mut modes = modes();
        modes.channels[0].name = "top \"x\"".to_owned();
        let text = csv(&modes);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 1 + modes.modes.len());
        assert!(lines[0].contains("\"top \"\"x\"\" re\""), "{}", lines[0]);
        let frequency: f64 = lines[1].split(',').nth(1).unwrap().parse().unwrap();
        assert_eq!(frequency, modes.modes[0].frequency_hz);
    }
}
