//! Shapes that jumped while frequencies did not: a sensor was moved, replaced or turned, and not the structure.

use crate::modal::{ObservedMode, assurance, shared};
use crate::numeric::quantile;
use dolmen_linalg::Complex64;

/// Median MAC of the modes below which shapes jumped. Chosen here, as [`JumpedShapes`](crate::assess::ChangeNote) of two surveys.
pub(super) const JUMPED_BELOW: f64 = 0.8;
/// Median MAC from which one sensor left out explains the jump. Chosen here.
pub(super) const EXPLAINED: f64 = 0.95;
/// Relative difference within which frequencies stayed. Chosen here: twice what weather does from one survey to the next.
const STAYED: f64 = 0.03;
/// Fewest sensors in common between shapes for one to be identified as changed: with fewer, the others prove little.
const NAMED_FROM: usize = 4;

/// Where shapes jumped and frequencies did not.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorChange {
    /// The first survey that shows it.
    pub survey: usize,
    /// Median MAC of the modes with what was before.
    pub assurance: f64,
    /// The sensor without which the shapes are alike; `None` where it is more than one, or there are too few to tell.
    pub channel: Option<String>,
}

/// Whether the shapes of these pairs, reference and survey, jumped. Modes measured by the same sensors are asked together: those of another
/// direction know nothing of a sensor that was turned.
pub(super) fn sensor_change(pairs: &[(&ObservedMode, &ObservedMode)], within_m: f64) -> Option<SensorChange> {
    let mut groups: Vec<Vec<(&ObservedMode, &ObservedMode)>> = Vec::new();
    for pair in pairs {
        match groups
            .iter_mut()
            .find(|group| channels(group[0].0).eq(channels(pair.0)))
        {
            Some(group) => group.push(*pair),
            None => groups.push(vec![*pair]),
        }
    }
    groups.iter().find_map(|group| change_of(group, within_m))
}

fn channels(mode: &ObservedMode) -> impl Iterator<Item = &str> {
    mode.shape.iter().map(|point| point.channel.name.as_str())
}

fn change_of(pairs: &[(&ObservedMode, &ObservedMode)], within_m: f64) -> Option<SensorChange> {
    let shapes: Vec<[Vec<Complex64>; 2]> = pairs
        .iter()
        .filter(|(known, now)| (now.frequency_hz / known.frequency_hz - 1.0).abs() <= STAYED)
        .map(|(known, now)| shared(&known.shape, &now.shape, within_m))
        .filter(|[phi, _]| phi.len() >= 2)
        .collect();
    // one mode alone may be another one
    if shapes.len() < 2 || 2 * shapes.len() < pairs.len() {
        return None;
    }
    let without = |left_out: Option<usize>| {
        let each = shapes.iter().map(|[phi, psi]| {
            let kept = |shape: &[Complex64]| -> Vec<Complex64> {
                let all = shape.iter().enumerate();
                all.filter(|(i, _)| Some(*i) != left_out)
                    .map(|(_, z)| *z)
                    .collect()
            };
            assurance(&kept(phi), &kept(psi))
        });
        quantile(&each.collect::<Vec<f64>>(), 0.5).unwrap_or(1.0)
    };
    let assurance = without(None);
    if assurance >= JUMPED_BELOW {
        return None;
    }
    let places = shapes.iter().map(|[phi, _]| phi.len()).min()?;
    let best = (0..places)
        .map(|i| (without(Some(i)), i))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .filter(|(mac, _)| places >= NAMED_FROM && *mac >= EXPLAINED);
    let names = &pairs[0].0.shape;
    Some(SensorChange {
        survey: 0,
        assurance,
        channel: best
            .and_then(|(_, i)| names.get(i))
            .map(|point| point.channel.name.clone()),
    })
}
