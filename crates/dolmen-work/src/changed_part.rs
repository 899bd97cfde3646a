//! Which joint of a chain or stack, or storey of a frame or building, explains how frequencies changed.

use crate::loosened::{Loosening, TORSION, loosening};
use crate::part_limit::Part;
use crate::survey_direction::direction_of;
use dolmen::assess::{FrequencyChange, SurveyChange, WhichPart, which_part};
use dolmen_project::Project;

/// Largest ratio, either way, of a measured frequency to that of its mode in the model. Our choice.
const SAME_MODE: f64 = 1.25;
/// Number of standard deviations within which a frequency is unchanged; if all frequencies of a direction are, no part is sought there.
const CHANGED_FROM_SD: f64 = 1.96;

/// The part of the model that explains a change, in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedPart {
    /// The direction; `None` for a chain that is alike in all directions, and for a stack, whose model has all directions.
    pub direction: Option<String>,
    /// The parts, lowest first.
    pub parts: Vec<Part>,
    /// Measured frequencies before, and those of the model, Hz.
    pub modes_hz: Vec<[f64; 2]>,
    /// The explanation of the changes.
    pub found: WhichPart,
}

/// A model too far from the structure to seek a part: its nearest frequency belongs to another mode.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelOff {
    /// The measured frequency that changed most beyond its deviation, Hz.
    pub measured_hz: f64,
    /// The nearest frequency of the model in its direction, Hz.
    pub model_hz: f64,
}

impl ModelOff {
    /// Ratio of the larger to the smaller.
    pub fn factor(&self) -> f64 {
        let ratio = self.measured_hz / self.model_hz;
        ratio.max(1.0 / ratio)
    }

    /// The largest such ratio for one mode.
    pub fn allowed() -> f64 {
        SAME_MODE
    }
}

/// Change of one measured frequency.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MeasuredChange {
    /// The direction of the mode's motion, if known.
    pub(crate) direction: Option<String>,
    /// Before, Hz.
    pub(crate) frequency_hz: f64,
    /// Relative change.
    pub(crate) relative: f64,
    /// Its standard deviation, if known.
    pub(crate) sd: Option<f64>,
}

/// The part that explains the significant changes from one survey to another, by direction; empty if none is significant, or if the model
/// has no such parts.
pub(crate) fn changed_parts(
    project: &Project,
    change: &SurveyChange,
) -> (Vec<ChangedPart>, Option<ModelOff>) {
    if change.changed().count() == 0 {
        return (Vec::new(), None);
    }
    let each = change.modes.iter().map(|mode| MeasuredChange {
        direction: match mode.from.direction.as_deref() {
            Some(TORSION) => Some(TORSION.to_owned()),
            _ => direction_of(&mode.from),
        },
        frequency_hz: mode.from.frequency_hz,
        relative: mode.frequency.relative,
        sd: mode.frequency.evidence.as_ref().map(|evidence| evidence.sd),
    });
    let each: Vec<MeasuredChange> = each.collect();
    let models = loosening(project);
    let parts = explained_by(&models, &each);
    let off = parts.is_empty().then(|| model_off(&models, &each)).flatten();
    (parts, off)
}

/// The part of given models that explains changes of frequencies, by direction; empty if the models have no such parts.
pub(crate) fn explained_by(models: &[Loosening<'_>], changes: &[MeasuredChange]) -> Vec<ChangedPart> {
    let each = models.iter().filter_map(|model| explained(model, changes));
    each.collect()
}

/// The changed frequency without a partner in the model that exceeds its deviation most, where fewer than two frequencies of every model
/// are near measured ones. `None` if parts can be sought, or if the directions of the model were not measured.
pub(crate) fn model_off(models: &[Loosening<'_>], changes: &[MeasuredChange]) -> Option<ModelOff> {
    let mut apart: Vec<(f64, ModelOff)> = Vec::new();
    for model in models {
        let given = (model.frequencies_hz)(None, 1.0)?;
        let mut partners = 0;
        for (direction, model_hz) in model.along.iter().zip(&given) {
            let own = along(direction.as_deref(), changes);
            let pairs = matched(&own, model_hz);
            partners += pairs.len();
            let alone = own
                .into_iter()
                .filter(|of| !pairs.iter().any(|(pair, _)| std::ptr::eq(*pair, *of)));
            apart.extend(alone.filter_map(|of| {
                let off = |hz: f64| (of.frequency_hz / hz).ln().abs();
                let nearest = model_hz
                    .iter()
                    .copied()
                    .min_by(|a, b| off(*a).total_cmp(&off(*b)))?;
                let is_apart = off(nearest) > SAME_MODE.ln();
                let found = ModelOff {
                    measured_hz: of.frequency_hz,
                    model_hz: nearest,
                };
                is_apart.then(|| (of.sd.map_or(0.0, |sd| (of.relative / sd).abs()), found))
            }));
        }
        if partners > 1 {
            return None;
        }
    }
    let farthest = apart.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    farthest.map(|(_, found)| found)
}

/// The changes along a direction of a model; without a direction, all except torsion.
fn along<'c>(direction: Option<&str>, changes: &'c [MeasuredChange]) -> Vec<&'c MeasuredChange> {
    let is_along = |mode: &&MeasuredChange| match direction {
        None => mode.direction.as_deref() != Some(TORSION),
        Some(own) => mode.direction.as_deref() == Some(own),
    };
    changes.iter().filter(is_along).collect()
}

/// A measured change with the index of the direction in the model, and the mode in it.
struct Matched<'c> {
    change: &'c MeasuredChange,
    along: usize,
    mode: usize,
}

fn explained(model: &Loosening<'_>, changes: &[MeasuredChange]) -> Option<ChangedPart> {
    let given = (model.frequencies_hz)(None, 1.0)?;
    let mut all: Vec<Matched<'_>> = Vec::new();
    for (along, (direction, given)) in model.along.iter().zip(&given).enumerate() {
        let own = self::along(direction.as_deref(), changes);
        let own = matched(&own, given).into_iter();
        all.extend(own.map(|(change, mode)| Matched { change, along, mode }));
    }
    let measured: Vec<FrequencyChange> = all
        .iter()
        .map(|of| {
            Some(FrequencyChange {
                relative: of.change.relative,
                sd: of.change.sd?,
            })
        })
        .collect::<Option<_>>()?;
    // perhaps only another direction changed
    let is_changed = |of: &FrequencyChange| of.relative.abs() > CHANGED_FROM_SD * of.sd;
    if model.direction.is_some() && !measured.iter().any(is_changed) {
        return None;
    }
    let changes_of = |part: Option<usize>, factor: f64| -> Option<Vec<f64>> {
        let after = (model.frequencies_hz)(part, factor)?;
        let relative =
            |of: &Matched<'_>| Some(after.get(of.along)?.get(of.mode)? / given[of.along][of.mode] - 1.0);
        all.iter().map(relative).collect()
    };
    Some(ChangedPart {
        found: which_part(&measured, model.parts.len(), changes_of)?,
        direction: model.direction.clone(),
        parts: model.parts.clone(),
        modes_hz: all
            .iter()
            .map(|of| [of.change.frequency_hz, given[of.along][of.mode]])
            .collect(),
    })
}

/// Pairs of measured and model modes, each the nearest of the other.
fn matched<'c>(measured: &[&'c MeasuredChange], model_hz: &[f64]) -> Vec<(&'c MeasuredChange, usize)> {
    let off = |mode: &MeasuredChange, hz: f64| (mode.frequency_hz / hz).ln().abs();
    let nearest_of_model = |mode: &MeasuredChange| {
        (0..model_hz.len()).min_by(|a, b| off(mode, model_hz[*a]).total_cmp(&off(mode, model_hz[*b])))
    };
    let each = measured.iter().filter_map(|mode| {
        let at = nearest_of_model(mode)?;
        let best = measured
            .iter()
            .min_by(|a, b| off(a, model_hz[at]).total_cmp(&off(b, model_hz[at])))?;
        let is_same = std::ptr::eq(*best, *mode) && off(mode, model_hz[at]) <= SAME_MODE.ln();
        is_same.then_some((*mode, at))
    });
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn changes(x_hz: f64, y_hz: f64) -> Vec<MeasuredChange> {
        let each = [("x", x_hz, -0.04), ("y", y_hz, -0.01)];
        let each = each.map(|(direction, frequency_hz, relative)| MeasuredChange {
            direction: Some(direction.to_owned()),
            frequency_hz,
            relative,
            sd: Some(0.002),
        });
        each.to_vec()
    }

    #[test]
    fn exact_a_model_too_far_off_is_named_with_its_factor() {
        let model = [Loosening {
            direction: None,
            parts: Vec::new(),
            along: vec![Some("x".to_owned()), Some("y".to_owned())],
            frequencies_hz: Box::new(|_, _| Some(vec![vec![3.0, 9.0], vec![3.1]])),
        }];
        let off = model_off(&model, &changes(4.5, 4.6)).unwrap();
        assert_eq!((off.measured_hz, off.model_hz, off.factor()), (4.5, 3.0, 1.5));
        let off = model_off(&model, &changes(2.0, 3.2)).unwrap();
        assert_eq!((off.measured_hz, off.factor()), (2.0, 1.5));
        assert_eq!(model_off(&model, &changes(3.3, 3.2)), None);
        assert_eq!(model_off(&[], &changes(4.5, 4.6)), None);
    }
}
