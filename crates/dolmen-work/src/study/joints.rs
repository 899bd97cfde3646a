//! The size of shaking at which each joint of a stack reaches a damage state.

use super::answer::StudyAnswer;
use super::column::{Column, ColumnValues};
use super::combination_fragility::CombinationFragility;
use super::fragility::combination_columns;
use super::joint_fragility::{JointFragility, JointState};
use super::run::{Run, RunOutcome};
use super::scans::{RunInformation, first_seen};
use dolmen::assess::{FragilityFit, Observation, fit_fragility_of_motions};
use std::collections::BTreeMap;

/// States with curves for joints: DS1 to DS3. Joints that gave way are only counted.
const STATES: u8 = 3;

/// Largest share of scans cut short by a fall elsewhere. Our choice: with more, medians of curves were off by a tenth and more.
const CUT_SHORT_MOST: f64 = 0.1;

impl StudyAnswer {
    pub(super) fn fit_joints(&self, found: &[CombinationFragility]) -> Vec<JointFragility> {
        let mut by_combination: BTreeMap<usize, Vec<&[Run]>> = BTreeMap::new();
        let scans = self.runs.chunk_by(|a, b| a.job == b.job);
        for scan in scans.filter(|scan| scan.iter().any(|run| !run.joint_states.is_empty())) {
            if self.missing.binary_search(&scan[0].job).is_err() {
                let combination = self.combination_of(scan[0].job);
                by_combination.entry(combination).or_default().push(scan);
            }
        }
        let mut all = Vec::new();
        for one in found {
            let Some(names) = self.joints.get(one.combination) else {
                continue;
            };
            let own = by_combination
                .get(&one.combination)
                .map_or(&[][..], Vec::as_slice);
            for (joint, name) in names.iter().enumerate() {
                let states = (1..=STATES).map(|state| self.joint_state(joint, state, own));
                let gives_way = |scan: &&&[Run]| {
                    let first = scan.iter().find(|run| run.outcome == RunOutcome::Fell);
                    first.is_some_and(|run| run.joint_states.get(joint) == Some(&4))
                };
                all.push(JointFragility {
                    combination: one.combination,
                    job: one.job,
                    joint,
                    name: name.clone(),
                    states: states.collect(),
                    gave_way: own.iter().filter(gives_way).count(),
                });
            }
        }
        all
    }

    fn joint_state(&self, joint: usize, state: u8, scans: &[&[Run]]) -> JointState {
        let seen = |run: &Run| match run.joint_states.get(joint) {
            Some(own) if *own >= state => RunInformation::Reached,
            // the state of a joint after a stone fell elsewhere is unknown
            Some(_)
                if matches!(
                    run.outcome,
                    RunOutcome::Stood | RunOutcome::Uplifted | RunOutcome::Slid
                ) =>
            {
                RunInformation::NotReached
            }
            _ => RunInformation::Unknown,
        };
        let mut cut_short = 0;
        let (mut observations, mut motions, mut ends) = (Vec::new(), Vec::new(), [Vec::new(), Vec::new()]);
        for scan in scans {
            let told: Vec<(f64, RunInformation)> = scan
                .iter()
                .map(|run| (run.peak_ground_acceleration_m_s2, seen(run)))
                .collect();
            let first = told
                .iter()
                .position(|(_, seen)| *seen != RunInformation::NotReached);
            cut_short += usize::from(first.is_some_and(|first| told[first].1 == RunInformation::Unknown));
            let found = first_seen(told.into_iter());
            let (low, high) = match found {
                Some(Observation::Between(low, high)) => (low, high),
                Some(Observation::Below(high)) => (0.0, high),
                Some(Observation::Above(low)) => (low, f64::INFINITY),
                _ => (0.0, f64::INFINITY),
            };
            ends[0].push(low);
            ends[1].push(high);
            if let Some(found) = found {
                observations.push(found);
                motions.push(self.record_index(scan[0].job));
            }
        }
        let is_whole = cut_short as f64 <= CUT_SHORT_MOST * scans.len() as f64;
        let fit = fit_fragility_of_motions(&observations, &motions).ok();
        JointState {
            state: usize::from(state) - 1,
            fit: fit.filter(|_| is_whole),
            median_between: ends.map(|ends| median(ends).filter(|end| *end > 0.0 && end.is_finite())),
            observations,
        }
    }
}

/// The lower middle value of an even number. Used at both ends of all scans, it covers at least half of them.
fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len().checked_sub(1)? / 2).copied()
}

impl JointState {
    /// The median peak in g, or its bounds, in words.
    pub fn median_words(&self, answer: &StudyAnswer) -> String {
        let g = |value: f64| format!("{:.3}", value / answer.gravity_m_s2);
        let [low, high] = self.median_between;
        match (&self.fit, low, high) {
            (Some(fit), _, Some(_)) => g(fit.curve.theta()),
            (_, Some(low), None) => format!("> {}", g(low)),
            (None, Some(low), Some(high)) => format!("{} – {}", g(low), g(high)),
            (None, None, Some(high)) => format!("< {}", g(high)),
            (_, None, None) => "–".to_owned(),
        }
    }

    /// Number of scans that reached it, and of all with information.
    pub fn reached(&self) -> usize {
        let reached = self.observations.iter();
        reached
            .filter(|seen| !matches!(seen, Observation::Above(_)))
            .count()
    }
}

/// Every joint and state, one row each: inputs, joint, median, dispersion and their errors, and always the bounds of the median.
pub fn joint_columns(answer: &StudyAnswer) -> Vec<Column> {
    let rows: Vec<(&JointFragility, &JointState)> = answer
        .joint_fragilities()
        .iter()
        .flat_map(|one| one.states.iter().map(move |state| (one, state)))
        .collect();
    let column = |name: &str, values| Column {
        name: name.to_owned(),
        values,
    };
    let counts = |name: &str, of: fn(&JointFragility, &JointState) -> usize| {
        let values = rows.iter().map(|(one, state)| of(one, state) as i64);
        column(name, ColumnValues::Counts(values.collect()))
    };
    let words = |name: &str, of: &dyn Fn(&JointFragility, &JointState) -> String| {
        let values = rows.iter().map(|(one, state)| of(one, state));
        column(name, ColumnValues::Words(values.collect()))
    };
    let numbers = |name: &str, of: fn(&FragilityFit) -> f64| {
        let values = rows.iter().map(|(_, state)| state.fit.as_ref().map(of));
        column(name, ColumnValues::Numbers(values.collect()))
    };
    let of_rows: Vec<(usize, usize)> = rows.iter().map(|(one, _)| (one.combination, one.job)).collect();
    let mut columns = combination_columns(answer, &of_rows);
    columns.extend([
        counts("joint", |one, _| one.joint + 1),
        words("name", &|one, _| one.name.clone()),
        words("state", &|_, state| answer.kind.states()[state.state].to_owned()),
        counts("scans", |_, state| state.observations.len()),
        counts("reached", |_, state| state.reached()),
        counts("gave_way", |one, _| one.gave_way),
        numbers("theta_pga_m_s2", |fit| fit.curve.theta()),
        numbers("beta_pga", |fit| fit.curve.beta()),
        numbers("ln_theta_error", |fit| fit.ln_theta_error),
        numbers("beta_error", |fit| fit.beta_error),
    ]);
    for (place, name) in ["median_above_m_s2", "median_at_most_m_s2"]
        .into_iter()
        .enumerate()
    {
        let values = rows.iter().map(|(_, state)| state.median_between[place]);
        columns.push(column(name, ColumnValues::Numbers(values.collect())));
    }
    columns
}
