//! The joint of a chain or stack, or storey of a frame or building, that explains a change over the years.

use crate::changed_part::{ChangedPart, MeasuredChange, ModelOff, explained_by, model_off};
use crate::loosened::loosening;
use dolmen::monitoring::{ChangeForm, WatchedChange, WatchedMode};
use dolmen_project::Project;

/// Largest number of changes of one structure to explain. Our choice: each costs some hundred modal analyses for each part.
pub(crate) const EXPLAINED_MOST: usize = 3;

/// Explanation of a change in several modes at one date.
#[derive(Clone, Debug, PartialEq)]
pub struct YearsParts {
    /// Step or slope.
    pub form: ChangeForm,
    /// The survey before the change.
    pub after: usize,
    /// The survey after it.
    pub before: usize,
    /// The explanation, by direction.
    pub parts: Vec<ChangedPart>,
}

/// The part that explains each of the lasting changes of a history, the strongest first, at most `most`. Modes without a change at that date also
/// count: their data there help to distinguish parts. If the model is too far off, no part is sought, and the second value gives the reason.
pub(crate) fn years_parts(
    project: &Project,
    modes: &[WatchedMode],
    most: usize,
) -> (Vec<YearsParts>, Option<ModelOff>) {
    let strength = |of: &WatchedChange| (of.ratio / of.sd).abs();
    let mut all: Vec<WatchedChange> = modes.iter().flat_map(|mode| mode.changes.clone()).collect();
    all.sort_by(|a, b| strength(b).total_cmp(&strength(a)));
    if all.is_empty() {
        return (Vec::new(), None);
    }
    let models = loosening(project);
    let mut found: Vec<YearsParts> = Vec::new();
    let mut off: Option<ModelOff> = None;
    for change in all {
        let is_told = |of: &YearsParts| {
            of.form == change.form && of.after <= change.before && change.after <= of.before
        };
        if found.len() == most {
            break;
        }
        if found.iter().any(is_told) {
            continue;
        }
        let measured = modes.iter().filter_map(|mode| {
            let there = mode.change_there(change.form, change.from)?;
            Some(MeasuredChange {
                direction: mode.track.direction.clone(),
                frequency_hz: mode.track.frequency_hz,
                relative: there.ratio,
                sd: Some(there.sd),
            })
        });
        let measured: Vec<MeasuredChange> = measured.collect();
        let parts = explained_by(&models, &measured);
        if parts.is_empty() && off.is_none() {
            off = model_off(&models, &measured);
        }
        found.push(YearsParts {
            form: change.form,
            after: change.after,
            before: change.before,
            parts,
        });
    }
    found.retain(|of| !of.parts.is_empty());
    (found, off)
}
