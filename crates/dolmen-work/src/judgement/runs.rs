//! Words for the earthquake from simulated motions, by kind of structure.

use super::earthquake::{DecidedBy, Earthquake, EarthquakeFinding, of_parts, split_assumed};
use crate::building::{BuildingSimulation, RowRun};
use crate::chain::ChainSimulation;
use crate::frame::FrameSimulation;
use crate::part_limit::PartLimit;
use crate::simulation::Simulation;
use crate::stack::{Repeats, SettledSimulation, StackRuns, StackSimulation};
use dolmen::assess::{DamageState, JointDamage};
use dolmen::blocks::{LooseEnding, Outcome};

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ending {
    /// It fell, or exceeded the validity of its model.
    Fell,
    /// It was stopped, cut short, or ended without a verdict.
    Open,
    /// The run is unusable.
    Lost,
    /// It is complete.
    Whole,
}

/// Findings of a simulation for the earthquake.
pub(super) struct RunFindings {
    pub(super) findings: Vec<EarthquakeFinding>,
    /// Whether it is complete.
    pub(super) is_done: bool,
}

impl RunFindings {
    fn new(findings: Vec<EarthquakeFinding>, is_done: bool) -> Self {
        RunFindings { findings, is_done }
    }
}

/// A simulation of any kind.
pub(super) fn of_simulation(run: &Simulation) -> RunFindings {
    match run {
        Simulation::Stack(runs) => of_stack_runs(runs),
        // moving supports are not an earthquake
        Simulation::Supports(run) => RunFindings::new(Vec::new(), run.is_whole()),
        Simulation::Settled(run) => RunFindings::new(of_settled(run), run.is_whole()),
        Simulation::Frame(run) => RunFindings::new(of_frame(run), run.falls() || run.is_whole()),
        Simulation::Chain(run) => RunFindings::new(of_chain(run), run.falls() || run.is_whole()),
        Simulation::Building(run) => {
            RunFindings::new(of_building(run), run.ended_before_the_motion_s().is_none())
        }
        // no earthquake
        Simulation::Wind(_) => RunFindings::new(Vec::new(), true),
    }
}

/// The runs of a stack by each law of contact, and their repeats with small differences: the worst one decides.
pub(super) fn of_stack_runs(runs: &StackRuns) -> RunFindings {
    let is_stopped = runs.repeats.as_ref().is_some_and(|repeats| repeats.is_stopped);
    let is_done = !is_stopped && runs.each().all(|run| run.falls() || run.is_whole());
    let mut found = of_stack(&runs.deciding);
    let motion = runs.deciding.motion.motion.name();
    let state = Some(runs.deciding.damage.state);
    let repeats = runs.repeats.as_ref().filter(|of| of.worst_state() > state);
    let worst = repeats.and_then(|repeats| of_repeats(repeats, motion));
    if let Some(worst) = worst.filter(|worst| worst.word >= Earthquake::worst(&found)) {
        found.insert(0, worst);
    }
    if runs.deciding.stack.is_pressed() {
        found = found.into_iter().map(EarthquakeFinding::held_by_loads).collect();
    }
    if !runs.deciding.stack.support_movements().is_empty() {
        let of_before = found.into_iter();
        found = of_before.map(EarthquakeFinding::before_supports_moved).collect();
    }
    RunFindings::new(found, is_done)
}

/// Loose stones under a motion: whether one left its place of rest. Without a motion there is no earthquake.
fn of_settled(run: &SettledSimulation) -> Vec<EarthquakeFinding> {
    let Some(motion) = &run.motion else {
        return Vec::new();
    };
    let each = run.runs.iter().filter_map(|run| run.shaken.as_ref());
    let endings: Vec<LooseEnding> = each.map(|shaken| shaken.ending).collect();
    let falls = endings.contains(&LooseEnding::Fell);
    let stays = !endings.is_empty() && endings.iter().all(|ending| *ending == LooseEnding::Stood);
    let found = match (falls, stays) {
        (true, _) => (Earthquake::BelowDemand, DecidedBy::Fall),
        (false, true) => (Earthquake::Above, DecidedBy::DamageState(0)),
        (false, false) => (Earthquake::NotDecided, DecidedBy::Unfinished),
    };
    under(motion.motion.name(), vec![found])
}

/// The worst damage of runs with small differences.
fn of_repeats(repeats: &Repeats, motion: &str) -> Option<EarthquakeFinding> {
    let (state, runs) = *repeats.states().last()?;
    let decided_by = DecidedBy::DamageOfRuns {
        state: state.number(),
        runs,
        all: repeats.runs.len(),
    };
    let word = Earthquake::of_damage(state);
    Some(EarthquakeFinding::new(word, decided_by, Some(motion)))
}

/// Whether a run of a stack is worse than another: by its word, then by its damage.
pub(crate) fn is_worse_stack_run(run: &StackSimulation, other: &StackSimulation) -> bool {
    let rank = |run: &StackSimulation| {
        let word = Earthquake::worst(&of_stack(run));
        (word, run.damage.state.number())
    };
    rank(run) > rank(other)
}

/// A stack: whether a stone fell, its damage, its ties.
pub(super) fn of_stack(run: &StackSimulation) -> Vec<EarthquakeFinding> {
    let ending = match run.history.outcome {
        _ if run.falls() => Ending::Fell,
        Outcome::Diverged { .. } => Ending::Lost,
        _ if run.is_whole() => Ending::Whole,
        _ => Ending::Open,
    };
    let state = run.counted_damage();
    let is_nan = run.damage.joints.iter().any(has_nan);
    let broke = !run.history.broken_ties.is_empty();
    let mut found = of_damage(ending, state, is_nan, broke);
    if ending != Ending::Lost && run.crushes() {
        found.push((Earthquake::Near, DecidedBy::Crushing));
    }
    under(run.motion.motion.name(), found)
}

fn has_nan(joint: &JointDamage) -> bool {
    [
        joint.peak_uplift_m,
        joint.peak_slip_m,
        joint.residual_slip_m,
        joint.residual_slip_ratio,
        joint.peak_rocking_ratio,
    ]
    .iter()
    .any(|number| number.is_nan())
}

/// Damage in an incomplete run still counts, because it has happened.
fn of_damage(
    ending: Ending,
    state: DamageState,
    is_nan: bool,
    a_tie_broke: bool,
) -> Vec<(Earthquake, DecidedBy)> {
    let damage = DecidedBy::DamageState(state.number());
    let mut found = match ending {
        Ending::Fell => vec![(Earthquake::BelowDemand, DecidedBy::Fall)],
        Ending::Lost => return vec![(Earthquake::NotDecided, DecidedBy::Unfinished)],
        _ if Earthquake::of_damage(state) == Earthquake::BelowDemand => {
            vec![(Earthquake::BelowDemand, damage)]
        }
        Ending::Open => vec![(Earthquake::NotDecided, DecidedBy::Unfinished)],
        Ending::Whole if is_nan => vec![(Earthquake::NotDecided, damage)],
        Ending::Whole => vec![(Earthquake::of_damage(state), damage)],
    };
    if a_tie_broke {
        found.push((Earthquake::BelowDemand, DecidedBy::Strength));
    }
    found
}

/// A chain: whether a link fell.
pub(super) fn of_chain(run: &ChainSimulation) -> Vec<EarthquakeFinding> {
    let ending = match (
        run.falls() || run.beyond_small_rotations().is_some(),
        run.is_whole(),
    ) {
        (true, _) => Ending::Fell,
        (false, true) => Ending::Whole,
        (false, false) => Ending::Open,
    };
    let mut peaks = run.history.rotation_peaks.iter();
    let is_nan = peaks.any(|peak| peak.rotation_rad.is_nan());
    let found = vec![of_fall(ending, is_nan)];
    match &run.motion {
        Some((motion, _)) => {
            let name = motion.motion.name();
            let mut all = under(name, found);
            all.extend(of_beds(ending, &run.parts(), name));
            all
        }
        // a push alone is not an earthquake
        None => {
            let counted = found.into_iter().filter(|(word, _)| *word != Earthquake::Above);
            findings(None, counted.collect())
        }
    }
}

/// Relative tolerance on the moment at the edge of a bed: an opening bed cannot carry more.
const AT_THE_EDGE: f64 = 0.99;

/// A bed near its edge or on it, in a run without a fall; "near" is the same share as for storeys. A bed of unknown width was modelled as
/// unable to open, so a run without a fall proves nothing for it.
fn of_beds(ending: Ending, parts: &[PartLimit], motion: &str) -> Vec<EarthquakeFinding> {
    if ending != Ending::Whole {
        return Vec::new();
    }
    let each = of_parts(parts, Some(motion)).into_iter();
    let counted = each.filter(|of| match of.decided_by {
        DecidedBy::BedUnknown => true,
        DecidedBy::BedEdge => matches!(of.word, Earthquake::Near | Earthquake::BelowDemand),
        _ => false,
    });
    let stood = counted.map(|of| match of.ratio {
        Some(ratio) if (AT_THE_EDGE..=1.0 / AT_THE_EDGE).contains(&ratio) => EarthquakeFinding {
            word: Earthquake::Near,
            decided_by: DecidedBy::StoodOnEdge,
            ratio: None,
            ..of
        },
        _ => of,
    });
    stood.collect()
}

fn of_fall(ending: Ending, is_nan: bool) -> (Earthquake, DecidedBy) {
    match ending {
        Ending::Fell => (Earthquake::BelowDemand, DecidedBy::Fall),
        Ending::Whole if !is_nan => (Earthquake::Above, DecidedBy::Fall),
        _ => (Earthquake::NotDecided, DecidedBy::Unfinished),
    }
}

/// A frame: its storeys compared with the allowable drift.
pub(super) fn of_frame(run: &FrameSimulation) -> Vec<EarthquakeFinding> {
    let ending = match (run.falls(), run.is_whole()) {
        (true, _) => Ending::Fell,
        (false, true) => Ending::Whole,
        (false, false) => Ending::Open,
    };
    let motion = run.motion.motion.name();
    let mut found = of_storeys(ending, &run.parts(), motion);
    if let Some(storey) = run.lifts_off_unfollowed() {
        found.push(EarthquakeFinding {
            part: run.storeys.get(storey).cloned(),
            ..EarthquakeFinding::new(Earthquake::NotDecided, DecidedBy::FeetLiftOff, Some(motion))
        });
    }
    found.extend(of_split(run, Earthquake::worst(&found), motion));
    found.extend(run.without_stiffness.iter().map(|direction| EarthquakeFinding {
        part: Some(direction.clone()),
        ..EarthquakeFinding::new(Earthquake::NotDecided, DecidedBy::StiffnessUnknown, Some(motion))
    }));
    found
}

/// A frame whose file does not say how beds and joints share its stiffness, and that meets the demand with all of it in its joints, and not, or
/// barely, with all of it in the beds of its columns.
fn of_split(run: &FrameSimulation, in_joints: Earthquake, motion: &str) -> Option<EarthquakeFinding> {
    let beds = run.all_in_beds.as_ref().map(|of| &of.run)?;
    let together_m = run.together_once().and_then(|both| both.all_in_beds_m);
    if !beds.lifts_off() && together_m.is_none() {
        return None;
    }
    let parts = run.parts_all_in_beds();
    let in_beds = match beds.is_followed() && !beds.falls() {
        true => Earthquake::worst(&of_parts(&parts, Some(motion))),
        false => Earthquake::NotDecided,
    };
    split_assumed(in_joints, in_beds, (parts.first()?, Some(motion)))
}

/// A storey beyond its limit in an incomplete run still counts, because it has happened.
fn of_storeys(ending: Ending, parts: &[PartLimit], motion: &str) -> Vec<EarthquakeFinding> {
    let mut found = of_parts(parts, Some(motion));
    match ending {
        Ending::Whole => {}
        Ending::Fell => {
            let fell = EarthquakeFinding::new(Earthquake::BelowDemand, DecidedBy::Drift, Some(motion));
            found.retain(|of| of.word == Earthquake::BelowDemand);
            if found.is_empty() {
                found.push(fell);
            }
        }
        Ending::Open | Ending::Lost => {
            found.retain(|of| of.word == Earthquake::BelowDemand);
            found.extend(under(
                motion,
                vec![(Earthquake::NotDecided, DecidedBy::Unfinished)],
            ));
        }
    }
    found
}

/// A building: its storeys compared with the allowable drift, and the strokes of its dampers with their rooms.
pub(super) fn of_building(run: &BuildingSimulation) -> Vec<EarthquakeFinding> {
    let ending = match run.ended_before_the_motion_s() {
        _ if run.falls() => Ending::Fell,
        Some(_) => Ending::Open,
        None => Ending::Whole,
    };
    of_storeys(ending, &run.parts(), run.motion.motion.name())
}

/// A building with the dampers of a row of a tuning, under a whole motion of the file.
pub(super) fn of_row_run(run: &RowRun) -> Vec<EarthquakeFinding> {
    let ending = if run.falls { Ending::Fell } else { Ending::Whole };
    of_storeys(ending, &run.parts, &run.motion)
}

fn under(motion: &str, found: Vec<(Earthquake, DecidedBy)>) -> Vec<EarthquakeFinding> {
    findings(Some(motion), found)
}

fn findings(motion: Option<&str>, found: Vec<(Earthquake, DecidedBy)>) -> Vec<EarthquakeFinding> {
    let each = found.into_iter();
    let each = each.map(|(word, decided_by)| EarthquakeFinding::new(word, decided_by, motion));
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judgement::Colour;
    use crate::part_limit::{Limited, Part};

    /// The worst word of all findings.
    fn word(found: &[(Earthquake, DecidedBy)]) -> Earthquake {
        found
            .iter()
            .map(|(word, _)| *word)
            .max()
            .unwrap_or(Earthquake::NotAsked)
    }

    #[test]
    fn holds_damage_and_endings_of_a_stack_have_their_words() {
        use DamageState::{Begun, Fallen, None, Offset, Severe};
        use Earthquake::{Above, BelowDemand, Near, NotDecided};
        use Ending::{Fell, Lost, Open, Whole};
        // ending, damage, NaN, a tie broke
        for (ending, state, is_nan, broke, expected) in [
            (Whole, None, false, false, Above),
            (Whole, Begun, false, false, Above),
            (Whole, Offset, false, false, Near),
            (Whole, Severe, false, false, BelowDemand),
            (Fell, Fallen, false, false, BelowDemand),
            (Whole, None, true, false, NotDecided),
            (Whole, None, false, true, BelowDemand),
            (Open, None, false, false, NotDecided),
            (Open, Offset, false, false, NotDecided),
            (Open, Severe, false, false, BelowDemand),
            (Open, None, false, true, BelowDemand),
            (Lost, Severe, false, true, NotDecided),
        ] {
            let found = of_damage(ending, state, is_nan, broke);
            assert_eq!(word(&found), expected, "{ending:?} {state:?} {is_nan} {broke}");
        }
    }

    #[test]
    fn holds_falls_and_drifts_have_their_words() {
        for (ending, is_nan, expected) in [
            (Ending::Fell, false, Earthquake::BelowDemand),
            (Ending::Whole, false, Earthquake::Above),
            (Ending::Whole, true, Earthquake::NotDecided),
            (Ending::Open, false, Earthquake::NotDecided),
        ] {
            assert_eq!(of_fall(ending, is_nan).0, expected, "{ending:?} {is_nan}");
        }
        let storey = |demand: f64, capacity: Option<f64>| PartLimit {
            taken: 0.0,
            lean: [0.0; 2],
            part: Part::Storey("a".into()),
            direction: None,
            limited: Limited::Drift,
            demand,
            capacity,
        };
        let limit = Some(0.015);
        for (ending, parts, colour) in [
            (
                Ending::Whole,
                vec![storey(0.005, limit), storey(0.012, limit)],
                Colour::Green,
            ),
            (
                Ending::Whole,
                vec![storey(0.005, limit), storey(0.0125, limit)],
                Colour::Amber,
            ),
            (
                Ending::Whole,
                vec![storey(0.005, limit), storey(f64::NAN, limit)],
                Colour::Amber,
            ),
            (Ending::Whole, vec![storey(0.016, limit)], Colour::Red),
            // without a limit nothing is decided, except by the fall of a storey
            (Ending::Whole, vec![storey(0.005, None)], Colour::Amber),
            (Ending::Whole, vec![storey(0.11, None)], Colour::Red),
            (Ending::Fell, vec![storey(0.099, None)], Colour::Red),
            (Ending::Open, vec![storey(0.005, limit)], Colour::Amber),
            (Ending::Open, vec![storey(0.016, limit)], Colour::Red),
        ] {
            let found = of_storeys(ending, &parts, "shake");
            assert_eq!(Earthquake::worst(&found).colour(), colour, "{ending:?} {parts:?}");
        }
    }
}
