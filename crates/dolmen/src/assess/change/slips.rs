//! Detects probable mistakes in a survey: exchanged channels, a wrong sampling rate.

use super::mode_change::ModeChange;
use super::notes::ChangeNote;
use super::swapped::ONE_FREQUENCY;
use crate::modal::ObservedMode;

/// Relative difference up to which frequency ratios count as equal, and smallest deviation of such a ratio from 1 for a note. Our choice: rates of
/// recorders differ by a factor of 1.25 and more.
const ONE_RATIO: f64 = 0.01;
const RATIO_LEAST: f64 = 1.2;

/// Probable mistakes in a survey: exchanged channels, a wrong sampling rate.
pub(super) fn slips(modes: &[ModeChange], lost: &[ObservedMode], new: &[ObservedMode]) -> Vec<ChangeNote> {
    let mut notes = Vec::new();
    let has_twin = |mode: &&ObservedMode| {
        let mut twins = new.iter().filter(|other| {
            !mode.shape.is_empty()
                && !other.shape.is_empty()
                && (other.frequency_hz / mode.frequency_hz - 1.0).abs() <= ONE_FREQUENCY
        });
        twins.next().is_some()
    };
    let twins: Vec<f64> = lost
        .iter()
        .filter(has_twin)
        .map(|mode| mode.frequency_hz)
        .collect();
    if !twins.is_empty() {
        notes.push(ChangeNote::OtherShapes {
            frequencies_hz: twins,
        });
    }
    if modes.is_empty() && lost.len() == new.len() && lost.len() >= 2 {
        let rising = |modes: &[ObservedMode]| {
            let mut all: Vec<f64> = modes.iter().map(|mode| mode.frequency_hz).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let ratios = rising(new).into_iter().zip(rising(lost));
        let ratios: Vec<f64> = ratios.map(|(after, before)| after / before).collect();
        let (least, most) = ratios.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), &r| {
            (low.min(r), high.max(r))
        });
        let factor = (least * most).sqrt();
        if most <= least * (1.0 + ONE_RATIO) && factor.max(1.0 / factor) >= RATIO_LEAST {
            notes.push(ChangeNote::OneFactor {
                factor,
                modes: ratios.len(),
            });
        }
    }
    notes
}
