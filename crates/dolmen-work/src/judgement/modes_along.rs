//! Compares the measured modes of a chain or frame along a direction with those of the model.

use super::as_of::AsOf;
use super::in_doubt::{MissedMode, PairedMode};
use super::measured_frequency::{MeasuredFrequency, measured_sd};
use super::mode_pairs::{Measured, pair};
use crate::mode_heights::mode_heights_m;
use crate::state::Check;
use dolmen::structure::{NaturalMode, ShapePoint};
use dolmen_project::{ModeKind, Project, SurveyMode};

/// The measured modes above the lowest of each direction, with those of a chain or frame, and the modes that the surveys missed.
pub(super) fn higher_modes(
    as_of: &AsOf<'_>,
    latest: &[MeasuredFrequency],
) -> (Vec<PairedMode>, Vec<MissedMode>) {
    let (mut paired, mut missed) = (Vec::new(), Vec::new());
    for lowest in latest {
        let Some((project, check)) = as_of.of(&lowest.survey) else {
            continue;
        };
        let survey = project.surveys.iter().find(|survey| survey.name == lowest.survey);
        let modes = survey.and_then(|survey| survey.modes.get(&lowest.direction));
        let measured = modes.into_iter().flatten();
        let measured: Vec<&SurveyMode> = measured
            .filter(|mode| mode.kind == ModeKind::Translation && !mode.frequency.is_assumed())
            .collect();
        let model = natural_modes(check, &lowest.direction);
        let pairs = pairs_along(project, model, &measured);
        let higher = pairs.iter().zip(&measured).skip(1);
        paired.extend(higher.map(|(at, mode)| PairedMode {
            survey: lowest.survey.clone(),
            direction: Some(lowest.direction.clone()),
            number: at + 1,
            measured_hz: mode.frequency.value,
            sd_hz: measured_sd(&mode.frequency),
            computed_hz: model[*at].frequency_hz,
        }));
        let below = 0..pairs.last().copied().unwrap_or(0);
        missed.extend(below.filter(|at| !pairs.contains(at)).map(|at| MissedMode {
            survey: lowest.survey.clone(),
            direction: lowest.direction.clone(),
            number: at + 1,
            computed_hz: model[at].frequency_hz,
        }));
    }
    (paired, missed)
}

/// The mode of the model, from 0, for each measured mode of translation along a direction; at most as many as the model has modes.
pub(super) fn pairs_along(project: &Project, model: &[NaturalMode], measured: &[&SurveyMode]) -> Vec<usize> {
    let has_shape = |mode: &&SurveyMode| mode.shape.len() >= 2;
    let heights_m = match measured.iter().any(has_shape) {
        true => mode_heights_m(&project.structure),
        false => None,
    };
    let each = measured.iter().map(|mode| Measured {
        hz: mode.frequency.value,
        sd_hz: measured_sd(&mode.frequency),
        assurance: match &heights_m {
            Some(heights_m) if has_shape(mode) => model
                .iter()
                .map(|of| likeness(&mode.shape, heights_m, &of.displacement))
                .collect(),
            _ => Vec::new(),
        },
    });
    let model_hz: Vec<f64> = model.iter().map(|mode| mode.frequency_hz).collect();
    pair(&each.collect::<Vec<_>>(), &model_hz)
}

/// MAC of measured points with a mode of the model, straight between its heights.
fn likeness(shape: &[ShapePoint], heights_m: &[f64], displacement: &[f64]) -> f64 {
    let at = |height_m: f64| {
        let above = heights_m.iter().position(|of| height_m <= *of);
        let above = above.unwrap_or(heights_m.len() - 1);
        let (below_m, below) = match above {
            0 => (0.0, 0.0),
            above => (heights_m[above - 1], displacement[above - 1]),
        };
        let share = ((height_m - below_m) / (heights_m[above] - below_m)).min(1.0);
        below + share * (displacement[above] - below)
    };
    let (mut both, mut measured, mut computed) = (0.0, 0.0, 0.0);
    for point in shape {
        let (u, v) = (point.displacement, at(point.height_m));
        both += u * v;
        measured += u * u;
        computed += v * v;
    }
    match measured * computed > 0.0 {
        true => both * both / (measured * computed),
        false => 0.0,
    }
}

/// Modes of a chain or frame in a direction; empty for a chain with weights of loads, whose higher modes are not computed.
pub(super) fn natural_modes<'a>(check: &'a Check, direction: &str) -> &'a [NaturalMode] {
    match check {
        Check::Chain(chain) if chain.loaded.is_some() => &[],
        Check::Chain(chain) => match (&chain.across, direction) {
            (None, _) | (Some(_), "x") => &chain.modes,
            (Some(across), "y") => &across.modes,
            (Some(_), _) => &[],
        },
        Check::Frame(all) => {
            let own = all.iter().find(|d| d.direction == direction);
            own.map_or(&[], |own| &own.check.modes)
        }
        Check::Stack(_) | Check::Building(_) => &[],
    }
}
