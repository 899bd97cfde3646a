//! Detects probable mistakes in a survey: exchanged channels, a wrong sampling rate, another unit.

use super::mode_change::ModeChange;
use super::notes::ChangeNote;
use super::swapped::ONE_FREQUENCY;
use crate::modal::ObservedMode;

/// Relative difference up to which frequency ratios count as equal, and smallest deviation of such a ratio from 1 for a note. Our choice: rates of
/// recorders differ by a factor of 1.25 and more.
const ONE_RATIO: f64 = 0.01;
const RATIO_LEAST: f64 = 1.2;
/// Fewest modes for a factor that damage may have, too; rad/s and periods are asked about for one mode. Our choice.
const MODES_LEAST: usize = 2;

/// Probable mistakes in a survey: exchanged channels, a wrong sampling rate, another unit.
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
    if modes.is_empty() && lost.len() == new.len() && !lost.is_empty() {
        notes.extend(one_ratio(lost, new));
    }
    notes
}

/// One factor, or reciprocals, between all frequencies of two surveys.
fn one_ratio(lost: &[ObservedMode], new: &[ObservedMode]) -> Option<ChangeNote> {
    let rising = |modes: &[ObservedMode]| {
        let mut all: Vec<f64> = modes.iter().map(|mode| mode.frequency_hz).collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let (before, after) = (rising(lost), rising(new));
    let modes = before.len();
    // the highest frequency has the shortest period
    let falling = after.iter().rev();
    if falling
        .zip(&before)
        .all(|(after, before)| (after * before - 1.0).abs() <= ONE_RATIO)
    {
        return Some(ChangeNote::Reciprocals { modes });
    }
    let ratios = after.iter().zip(&before).map(|(after, before)| after / before);
    let (least, most) = ratios.fold((f64::INFINITY, 0.0_f64), |(low, high), ratio| {
        (low.min(ratio), high.max(ratio))
    });
    let factor = (least * most).sqrt();
    let is_one = most <= least * (1.0 + ONE_RATIO) && factor.max(1.0 / factor) >= RATIO_LEAST;
    let note = ChangeNote::OneFactor { factor, modes };
    (is_one && (note.is_angular() || modes >= MODES_LEAST)).then_some(note)
}

impl ChangeNote {
    /// Whether the one factor of all frequencies is 2π or its reciprocal: rad/s for Hz.
    pub fn is_angular(&self) -> bool {
        let of_tau = |factor: f64| (factor.max(1.0 / factor) / std::f64::consts::TAU - 1.0).abs();
        matches!(self, ChangeNote::OneFactor { factor, .. } if of_tau(*factor) <= ONE_RATIO)
    }
}
