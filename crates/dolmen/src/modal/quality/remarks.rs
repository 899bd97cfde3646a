//! Remarks on the modes of a record: peaks without a mode, pairs, few cycles.

use crate::modal::{Method, Mode, Modes, Note, Refusal, RefusedPeak};

/// Damping ratio below which few structures have modes.
pub(super) const USUAL_LEAST: f64 = 0.002;

/// Frequencies for which another note already gives the reason.
fn told_hz(note: &Note) -> Vec<f64> {
    match note {
        Note::InSpells { modes } => modes.iter().map(|mode| mode.frequency_hz).collect(),
        Note::Clipping { modes } => modes.iter().map(|mode| mode.frequency_hz).collect(),
        _ => Vec::new(),
    }
}

/// Keeps of the modes that only the lines show those that later tests left.
fn keep_shown(modes: &[Mode], notes: &mut Vec<Note>) {
    notes.retain_mut(|note| match note {
        Note::FromPeaks { frequency_hz } => {
            frequency_hz.retain(|hz| modes.iter().any(|mode| mode.frequency_hz == *hz));
            !frequency_hz.is_empty()
        }
        _ => true,
    });
}

/// `why` gives the test that refused a peak of the spectrum.
pub(crate) fn remark(
    modes: &Modes,
    (peaks, why): (&Modes, &dyn Fn(f64) -> Option<Refusal>),
    not_picked_hz: Vec<f64>,
    notes: &mut Vec<Note>,
) {
    const DAMPING_FLOOR: f64 = 0.3; // relative: a damping ratio known worse is a guess
    keep_shown(&modes.modes, notes);
    let picked_away = |peak: &Mode| not_picked_hz.iter().any(|hz| near(*hz, peak.frequency_hz));
    let told_hz: Vec<f64> = notes.iter().flat_map(told_hz).collect();
    let is_told = |peak: &Mode| told_hz.iter().any(|hz| near(*hz, peak.frequency_hz));
    let peaks: Vec<RefusedPeak> = peaks
        .modes
        .iter()
        .filter(|peak| !explained(peak, &modes.modes) && !picked_away(peak) && !is_told(peak))
        .map(|peak| RefusedPeak {
            frequency_hz: peak.frequency_hz,
            refusal: why(peak.frequency_hz),
        })
        .collect();
    if !peaks.is_empty() {
        notes.push(Note::PeaksWithoutMode { peaks });
    }
    if !not_picked_hz.is_empty() {
        notes.push(Note::NotPicked {
            frequency_hz: not_picked_hz,
        });
    }
    if matches!(modes.method, Method::Efdd | Method::Fsdd) {
        let without = modes.modes.iter().filter(|m| m.damping_ratio.is_none());
        let frequency_hz: Vec<f64> = without.map(|m| m.frequency_hz).collect();
        if !frequency_hz.is_empty() {
            notes.push(Note::NoDamping { frequency_hz });
        }
    }
    let light = modes
        .modes
        .iter()
        .filter(|m| m.damping_ratio.is_some_and(|zeta| zeta < USUAL_LEAST));
    let frequency_hz: Vec<f64> = light.map(|m| m.frequency_hz).collect();
    if !frequency_hz.is_empty() {
        notes.push(Note::LightModes { frequency_hz });
    }
    let pairs: Vec<[f64; 2]> = modes
        .modes
        .windows(2)
        .filter(|pair| pair[0].overlaps(&pair[1]))
        .map(|pair| [pair[0].frequency_hz, pair[1].frequency_hz])
        .collect();
    if !pairs.is_empty() {
        notes.push(Note::ClosePairs { pairs });
    }
    for mode in &modes.modes {
        let damping_floor = mode.damping_floor();
        if modes.method != Method::Era && mode.damping_ratio.is_some() && damping_floor > DAMPING_FLOOR {
            notes.push(Note::FewCycles {
                frequency_hz: mode.frequency_hz,
                damping_floor,
            });
        }
    }
}

/// Whether one of the modes is at this peak of the spectrum.
pub(crate) fn explained(peak: &Mode, modes: &[Mode]) -> bool {
    modes
        .iter()
        .any(|mode| near(mode.frequency_hz, peak.frequency_hz))
}

/// Whether a line of the spectrum is near enough to a peak.
pub(crate) fn near(frequency_hz: f64, peak_hz: f64) -> bool {
    const NEAR: f64 = 0.03;
    (frequency_hz / peak_hz - 1.0).abs() <= NEAR
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_no_mode_that_was_left_out_is_said_to_be_shown_by_the_lines() {
        let kept = [Mode::made(2.0, 0.01, &[1.0])];
        let from = |frequency_hz: &[f64]| Note::FromPeaks {
            frequency_hz: frequency_hz.to_vec(),
        };
        let mut notes = vec![from(&[2.0, 4.2]), from(&[4.2])];
        keep_shown(&kept, &mut notes);
        assert_eq!(notes, [from(&[2.0])]);
    }
}
