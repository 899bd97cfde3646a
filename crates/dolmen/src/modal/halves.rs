//! Frequencies that differ between the halves of a record: the structure changed, or its modes depend on their amplitude.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | d_b | `changes` | change of a frequency by block of time b, Σ d_b² its variance |
//! | c | `contrast` | (Σ d_b of the second half − Σ d_b of the first)/√Σ d_b² |

use super::modal_analysis::ModalAnalysis;
use super::options::Identify;
use super::quality::explained;
use super::strong::{LastingChange, Part, between_parts};
use super::{ModalError, Mode};
use crate::signal::{Record, cut};

/// Contrast of the blocks of time of one mode above which the halves are identified, which takes as long again: with ten modes, chance reaches it in one
/// record of forty. Our choice.
const CONTRAST_LEAST: f64 = 3.0;
/// Largest probability that chance gives a difference in any mode of a record. Our choice.
const CHANCE_MOST: f64 = 1e-3;

/// The modes of which the frequencies in the two halves of the record differ beyond chance. The halves are identified as the whole record was.
pub(super) fn changed_between_halves(
    record: &Record,
    options: &Identify,
    found: &ModalAnalysis,
    identify: &dyn Fn(&Record, &Identify) -> Result<ModalAnalysis, ModalError>,
) -> Vec<LastingChange> {
    let blocks = found.settings.time_blocks;
    let modes = &found.modes.modes;
    // a mode that changes by more than its bandwidth leaves a peak without a stable pole
    let lost = found
        .fdd_modes
        .modes
        .iter()
        .filter(|peak| !explained(peak, modes))
        .count();
    let may_change = modes.iter().any(|mode| contrast(mode, blocks) >= CONTRAST_LEAST);
    if !may_change && lost <= modes.len() {
        return Vec::new();
    }
    let own = Identify {
        modes_wanted: None,
        pick_hz: Vec::new(),
        accept_hz: Vec::new(),
        ..options.clone()
    };
    let middle_s = 0.5 * record.duration_s();
    let half = |span_s: [f64; 2]| Part {
        span_s,
        analysis: cut(record.clone(), span_s[0], span_s[1])
            .ok()
            .and_then(|part| identify(&part, &own).ok()),
    };
    let halves = [half([0.0, middle_s]), half([middle_s, record.duration_s()])];
    let mut changes = between_parts(&halves);
    changes.retain(|of| of.chance.is_some_and(|chance| chance <= CHANCE_MOST));
    changes
}

/// Absolute value of the contrast between the halves, 0 without changes by block.
fn contrast(mode: &Mode, blocks: usize) -> f64 {
    let Some(changes) = mode.frequency_changes_hz.get(..blocks) else {
        return 0.0;
    };
    let (first, second) = changes.split_at(blocks / 2);
    let sum = |half: &[f64]| half.iter().sum::<f64>();
    let size = changes.iter().map(|d| d * d).sum::<f64>().sqrt();
    (sum(second) - sum(first)).abs() / size.max(f64::MIN_POSITIVE)
}
