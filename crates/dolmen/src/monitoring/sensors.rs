//! Detects a moved, replaced or reversed sensor: mode shapes jump between surveys while frequencies stay the same.

use crate::modal::{ObservedMode, assurance, shared};
use crate::numeric::quantile;
use dolmen_linalg::Complex64;

/// Median MAC of the modes below which the shapes have jumped. Our choice, as for [`JumpedShapes`](crate::assess::ChangeNote) between two
/// surveys.
pub(super) const JUMPED_BELOW: f64 = 0.8;
/// Median MAC without one sensor from which that sensor explains the jump. Our choice.
pub(super) const EXPLAINED: f64 = 0.95;
/// Relative difference within which a frequency is unchanged. Our choice: twice the effect of weather between surveys.
const STAYED: f64 = 0.03;
/// Fewest common sensors for identifying the changed one: with fewer, the remaining sensors prove little.
const NAMED_FROM: usize = 4;

/// A jump of mode shapes without a change of frequencies.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorChange {
    /// The first survey with the jump.
    pub survey: usize,
    /// Median MAC between the modes of this survey and the reference.
    pub assurance: f64,
    /// The changed sensor: without it the shapes agree. `None` if several sensors changed, or if there are too few sensors.
    pub channel: Option<String>,
}

/// Tests for a jump of shapes between pairs of modes (reference, survey). Modes are tested in groups measured by the same sensors,
/// because a reversed sensor changes only the modes of its own direction.
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
    // a single pair may be two different modes
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
