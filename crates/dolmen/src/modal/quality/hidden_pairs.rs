//! Detects two modes under one peak: only one mode was found, but the second singular value of the spectrum has a peak near it.

use crate::modal::spectrum::{SingularSpectrum, decibel, peaks};
use crate::modal::{Modes, Note};

/// Least ratio of the second to the first singular value at the peak of the second. Our choice: one mode with 20 dB of noise gives less
/// than a thirtieth.
const SECOND_LEAST: f64 = 0.1;
/// Least ratio of the first singular value at that line to its maximum near the mode, because between two separate modes the second also
/// rises, where the first is low. Our choice.
const NEAR_TOP: f64 = 0.35;

/// Adds a note on modes that may be two: near them the second singular value has a peak of its own.
pub(crate) fn note_hidden_pairs(
    modes: &Modes,
    spectrum: &SingularSpectrum,
    prominence_db: f64,
    notes: &mut Vec<Note>,
) {
    let lines = &spectrum.frequency_hz;
    let second: Option<Vec<f64>> = spectrum
        .singular_values
        .iter()
        .map(|s| s.get(1).map(|s| decibel(*s)))
        .collect();
    let (Some(second), Some(step_hz)) = (second, lines.get(1).copied()) else {
        return;
    };
    let width_hz = 2.0 * step_hz; // of the window
    let mut frequency_hz: Vec<f64> = Vec::new();
    for peak in peaks(&second, 1..lines.len(), prominence_db) {
        let at_hz = lines[peak.line];
        let is_near = |f: f64, zeta: f64| (f - at_hz).abs() <= 2.0 * zeta * f + width_hz;
        let near: Vec<f64> = modes
            .modes
            .iter()
            .filter(|m| is_near(m.frequency_hz, m.damping_ratio.unwrap_or(0.0)))
            .map(|m| m.frequency_hz)
            .collect();
        let [one_hz] = near[..] else { continue };
        let reach_hz = (one_hz - at_hz).abs() + width_hz;
        let top = lines
            .iter()
            .zip(&spectrum.singular_values)
            .filter(|(f, _)| (*f - one_hz).abs() <= reach_hz)
            .map(|(_, s)| s[0])
            .fold(0.0, f64::max);
        let here = &spectrum.singular_values[peak.line];
        if here[1] >= SECOND_LEAST * top && here[0] >= NEAR_TOP * top {
            frequency_hz.push(one_hz);
        }
    }
    frequency_hz.dedup();
    if !frequency_hz.is_empty() {
        notes.push(Note::HiddenPairs { frequency_hz });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, MadeMode, MadeRecord, Method, ReferenceCase, identify};

    fn hidden(made: &MadeRecord, method: Method) -> Vec<f64> {
        let options = Identify {
            method,
            ..Identify::default()
        };
        let found = identify(&made.make().unwrap(), &options).unwrap();
        found
            .notes
            .into_iter()
            .find_map(|note| match note {
                Note::HiddenPairs { frequency_hz } => Some(frequency_hz),
                _ => None,
            })
            .unwrap_or_default()
    }

    #[test]
    fn holds_two_modes_under_one_peak_are_named() {
        let mode = |(frequency_hz, shape): (f64, [f64; 3])| MadeMode {
            frequency_hz,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        let shapes = [[1.0, 0.3, 0.6], [-0.3, 1.0, 0.1], [0.7, 0.4, -1.0]];
        let made = MadeRecord {
            modes: [2.0, 2.02, 5.0].into_iter().zip(shapes).map(mode).collect(),
            seed: 4,
            ..MadeRecord::default()
        };
        let found = hidden(&made, Method::Fdd);
        assert!(
            found.len() == 1 && (found[0] / 2.01 - 1.0).abs() < 0.02,
            "{found:?}"
        );
    }

    #[test]
    fn holds_modes_that_are_found_are_not_named() {
        for seed in 0..4 {
            for method in [Method::Fdd, Method::Plscf, Method::SsiCov] {
                let chain = ReferenceCase::ShearChain.made(seed).unwrap();
                assert_eq!(hidden(&chain, method), [0.0; 0], "{method:?} {seed}");
            }
            let pairs = ReferenceCase::ClosePairs.made(seed).unwrap();
            for method in [Method::Plscf, Method::SsiCov] {
                assert_eq!(hidden(&pairs, method), [0.0; 0], "{method:?} {seed}");
            }
        }
    }
}
