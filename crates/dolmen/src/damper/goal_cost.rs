//! Cost of given dampers for a goal, as in a design.

use super::design::Search;
use super::{DamperError, DesignOptions, Goal, PlacedDamper, Plan};

/// Cost of given dampers for a goal, as [`design`](super::design()) computes it, with unit weights.
///
/// # Errors
/// [`DamperError`] if a damper is out of its range.
pub fn goal_cost(plan: &Plan, dampers: &[PlacedDamper], goal: Goal) -> Result<f64, DamperError> {
    plan.judge(dampers)?;
    let options = DesignOptions {
        goal,
        ..DesignOptions::default()
    };
    let search = Search {
        plan,
        start: dampers,
        options: &options,
        weights: vec![1.0; plan.problem().points.len()],
    };
    search.cost(dampers).ok_or(DamperError::NoOptimum {
        what: "a resonance without damping",
        iterations: 0,
    })
}

/// The quantity of the goal at each point: the standard deviation, or the largest harmonic amplitude.
///
/// # Errors
/// [`DamperError`] if a damper is out of its range.
pub fn point_values(plan: &Plan, dampers: &[PlacedDamper], goal: Goal) -> Result<Vec<f64>, DamperError> {
    let judged = plan.judge(dampers)?;
    if goal != Goal::LargestPeak {
        return Ok(judged.point_rms);
    }
    let options = DesignOptions {
        goal,
        ..DesignOptions::default()
    };
    let points = plan.problem().points.len();
    let search = Search {
        plan,
        start: dampers,
        options: &options,
        weights: vec![1.0; points],
    };
    let peaks = search.peaks(dampers).ok_or(DamperError::NoOptimum {
        what: "a resonance without damping",
        iterations: 0,
    })?;
    let mut largest = vec![0.0_f64; points];
    for peak in peaks {
        let of = &mut largest[peak.which / plan.problem().loads.len()];
        *of = of.max(peak.value.exp());
    }
    Ok(largest)
}
