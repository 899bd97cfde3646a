//! The answer of a study: inputs, runs, levels and trends.

use super::earthquake_of::EarthquakeOf;
use super::fitted::Fitted;
use super::input_columns::{CaseInputs, InputColumn};
use super::kind::StudyKind;
use super::maps::ResponseMaps;
use super::motions::MotionCopy;
use super::run::{Run, RunOutcome};
use super::scans::{CapacityOf, LevelRow, capacity_of};
use super::shaking_measure::ShakingScales;
use super::shown_inputs::{shown_inputs, shown_values, with_unit};
use super::some_runs::DamageInRuns;
use super::state_before::StateBefore;
use dolmen::assess::{AssessError, Direction, Reached, Trend, trend};
use dolmen_project::{ExpectedTrend, HazardPart, Names, Scan, StudyPart};
use dolmen_words::Unit;
use dolmen_words::message::Both;
use std::collections::BTreeMap;

/// A study with all its runs.
#[derive(Clone, Debug)]
pub struct StudyAnswer {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The study.
    pub study: StudyPart,
    /// The kind of structure.
    pub kind: StudyKind,
    /// Gravity, which converts accelerations to g, m/s².
    pub gravity_m_s2: f64,
    /// The allowable drift of a storey over its height in the file, for a frame or a building.
    pub drift_limit: Option<f64>,
    /// The hazard at the site, if known.
    pub hazard: Option<HazardPart>,
    /// Version of the program.
    pub version: String,
    /// Warnings about the project file: missing values and others.
    pub notes: Vec<Both>,
    /// Inspected damage in the models of the runs.
    pub model_damage: Vec<DamageInRuns>,
    /// Units in which random inputs are shown, by path.
    pub drawn_units: BTreeMap<String, Unit>,
    /// Values that the study sets, as shown: `pagoda.body_height = 3.0 m`.
    pub set_shown: Vec<String>,
    /// Properties of the file that the runs leave out.
    pub left_out_of_runs: Vec<Both>,
    /// Whether runs have neither damping nor friction.
    pub is_undamped: bool,
    /// Whether columns alone support a storey in runs: these fall at a drift of their own, not at that of the frame model.
    pub on_columns: bool,
    /// Motions that are copies of others.
    pub copies: Vec<MotionCopy>,
    /// Inputs, the varied ones first.
    pub inputs: Vec<InputColumn>,
    /// Cases: samples of the first combination, then of the next.
    pub cases: Vec<CaseInputs>,
    /// For a stack, by combination: the stones of its joints; empty where its inputs were refused.
    pub joints: Vec<Vec<String>>,
    /// Data for measures of shaking.
    pub shaking: ShakingScales,
    /// Motions, by name.
    pub motions: Vec<String>,
    /// Data of the earthquake of each motion; empty if motions are varied.
    pub earthquakes: Vec<EarthquakeOf>,
    /// The record of each motion, as the index of the first motion from it.
    pub records: Vec<usize>,
    /// The state of each case after the earlier motion; empty without one.
    pub before: Vec<StateBefore>,
    /// For a frame with an allowable drift: the largest lean of a storey of each case before it is shaken, –, where it leans as surveyed; else
    /// empty.
    pub leans_at_rest: Vec<Option<f64>>,
    /// Runs by job and scale.
    pub runs: Vec<Run>,
    /// Scans that are not done.
    pub missing: Vec<usize>,
    /// For a frame: maps and releases by case.
    pub maps: Vec<ResponseMaps>,
    /// Curves fitted to the runs so far.
    pub fitted: Fitted,
}

/// The verdict on an expected trend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrendVerdict {
    /// Significant.
    Holds,
    /// Neither it nor its opposite is significant.
    NotSeen,
    /// The opposite is significant.
    Contradicted,
}

impl TrendVerdict {
    /// The word that is printed.
    pub fn word(self) -> &'static str {
        match self {
            TrendVerdict::Holds => "holds",
            TrendVerdict::NotSeen => "not seen",
            TrendVerdict::Contradicted => "contradicted",
        }
    }
}

/// The trend of the capacity with one input, with all others equal.
#[derive(Clone, Debug, PartialEq)]
pub struct TrendAnswer {
    /// The input, an index.
    pub input: usize,
    /// From pairs within one motion, direction and sample; the records of the motions are the independent units.
    pub of_pairs: Trend,
    /// τ of each motion, direction and sample.
    pub of_each: Vec<f64>,
    /// The expected trend and its verdict.
    pub expected: Option<(ExpectedTrend, TrendVerdict)>,
    /// Whether the input changes anything in the runs.
    pub acts: bool,
}

impl TrendAnswer {
    /// Number of motions, directions and samples whose τ has this sign.
    pub fn same_way(&self, direction: Direction) -> usize {
        let goes = |tau: &&f64| match direction {
            Direction::Rising => **tau > 0.0,
            Direction::Falling => **tau < 0.0,
        };
        self.of_each.iter().filter(goes).count()
    }
}

impl StudyAnswer {
    /// Number of scans: cases × motions × directions.
    pub fn jobs(&self) -> usize {
        self.cases.len() * self.replicates()
    }

    /// Number of scans of a case: motions × directions.
    fn replicates(&self) -> usize {
        self.motions.len() * self.study.turns_rad.len()
    }

    fn samples(&self) -> usize {
        self.study.samples.unwrap_or(1)
    }

    /// The index of the case of a job.
    pub fn case_of(&self, job: usize) -> usize {
        job / self.replicates().max(1)
    }

    /// The inputs of a job.
    pub fn case(&self, job: usize) -> &CaseInputs {
        &self.cases[self.case_of(job)]
    }

    /// The varied inputs of a job in words, without random ones; empty if nothing is varied.
    pub fn combination_words(&self, job: usize) -> String {
        let case = self.case(job);
        let several = self.study.variants.len() > 1;
        let mut words: Vec<String> = case.variant.iter().filter(|_| several).cloned().collect();
        let varied = self.inputs.iter().take_while(|input| !input.is_drawn);
        let varied: Vec<InputColumn> = varied.cloned().collect();
        words.extend(shown_inputs(&varied, case, &self.drawn_units));
        words.join(", ")
    }

    /// The inputs of a job with their values, as shown: `joints[1].stiffness = 1027 kN·m/rad`.
    pub fn inputs_shown(&self, job: usize) -> Vec<String> {
        shown_inputs(&self.inputs, self.case(job), &self.drawn_units)
    }

    /// The values of the inputs of a job, as shown.
    pub fn values_shown(&self, job: usize) -> Vec<String> {
        shown_values(&self.inputs, self.case(job), &self.drawn_units)
    }

    /// The value of a level: as written, a bare number with its unit.
    pub fn level_shown(&self, level: &LevelRow) -> String {
        let input = level.input.and_then(|input| self.inputs.get(input));
        let units = input.map_or(&[][..], |input| &input.written_units);
        with_unit(&level.text, level.value, units)
    }

    /// The sample of a job, from 0.
    pub fn sample_of(&self, job: usize) -> usize {
        self.case_of(job) % self.samples()
    }

    /// The combination of varied values of a job, from 0.
    pub fn combination_of(&self, job: usize) -> usize {
        self.case_of(job) / self.samples()
    }

    /// The motion of a job.
    pub fn motion_of(&self, job: usize) -> &str {
        self.motions
            .get(self.motion_index(job))
            .map_or("", String::as_str)
    }

    /// The motion of a job, from 0.
    pub fn motion_index(&self, job: usize) -> usize {
        job % self.replicates().max(1) / self.study.turns_rad.len()
    }

    /// The record of a job's motion, from 0: several directions of one record are one motion.
    pub fn record_index(&self, job: usize) -> usize {
        let motion = self.motion_index(job);
        self.records.get(motion).copied().unwrap_or(motion)
    }

    /// Whether every scan has an answer; a fall is an answer.
    pub fn is_whole(&self) -> bool {
        self.missing.is_empty() && !(self.study.scan.is_some() && self.left_out() > 0)
    }

    /// The rotation of the motion of a job, rad.
    pub fn turn_rad(&self, job: usize) -> f64 {
        self.study.turns_rad[job % self.study.turns_rad.len()]
    }

    /// Results of each scan, by job, including unusable ones.
    pub fn capacities(&self) -> Vec<CapacityOf> {
        let mut scans = self.runs.chunk_by(|a, b| a.job == b.job).peekable();
        let beyond_before = self.drift_limit.map(|limit| self.cases_beyond_before(limit));
        let beyond_before = beyond_before.unwrap_or_default();
        let [a, b, c, d] = self.study.drift_limits;
        let limits = [a, b, c, d, self.drift_limit.unwrap_or(f64::INFINITY)];
        let each = (0..self.jobs()).map(|job| {
            let runs = scans.next_if(|runs| runs.first().is_some_and(|run| run.job == job));
            let is_whole = self.missing.binary_search(&job).is_err();
            let runs = runs.unwrap_or_default();
            let mut found = capacity_of(job, runs, is_whole);
            let is_counted = is_whole && !beyond_before.contains(&self.case_of(job));
            let is_at_rest = is_whole && self.is_beyond_at_rest(self.case_of(job));
            found = match self.drift_limit {
                Some(_) if is_at_rest => found.with_drift_at_rest(),
                Some(limit) if is_counted => found.with_allowed_drift(runs, limit),
                Some(_) | None => found,
            };
            match self.kind {
                StudyKind::Building => found.in_proportion(runs, limits),
                StudyKind::Stack | StudyKind::Frame | StudyKind::Chain => found,
            }
        });
        each.collect()
    }

    /// Unusable scans: refused, with runs missing below their first fall, or not done.
    pub fn left_out(&self) -> usize {
        let scans = self.capacities();
        scans.iter().filter(|scan| !scan.verdict.is_usable()).count()
    }

    /// Number of runs by their end.
    pub fn outcomes(&self) -> BTreeMap<RunOutcome, usize> {
        let mut counts = BTreeMap::new();
        for run in &self.runs {
            *counts.entry(run.outcome).or_insert(0) += 1;
        }
        counts
    }

    /// Usable scans that fell at the smallest size of the study; below it, only halving was tried.
    pub fn fell_at_the_least(&self) -> usize {
        const ROUNDING: f64 = 1e-9;
        let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min) * (1.0 + ROUNDING);
        let capacities = self.capacities();
        let usable = capacities.iter().filter(|c| c.verdict.is_usable());
        let fell = usable.filter(|c| match &self.study.scan {
            Some(Scan::Scales(values)) => {
                let first = c.scan.as_ref().and_then(|scan| scan.first_fall);
                first.is_some_and(|scale| scale <= least(values))
            }
            Some(Scan::Peaks(values)) => c.fell_m_s2().is_some_and(|peak| peak <= least(values)),
            None => false,
        });
        fell.count()
    }

    /// Capacities by value of each varied input; with a single row for everything if nothing is varied.
    pub fn levels(&self) -> Vec<LevelRow> {
        let capacities = self.capacities();
        let mut rows = Vec::new();
        if self.study.variants.len() > 1 {
            for variant in &self.study.variants {
                let own = |c: &&CapacityOf| self.case(c.job).variant.as_ref() == Some(variant);
                rows.push(level((None, variant, None), capacities.iter().filter(own)));
            }
        }
        for (index, axis) in self
            .study
            .vary
            .iter()
            .enumerate()
            .filter(|(_, axis)| axis.values.len() > 1)
        {
            let mut seen: Vec<&str> = Vec::new();
            for value in &axis.values {
                let text = value.text.trim_matches('"');
                if seen.contains(&text) {
                    continue;
                }
                seen.push(text);
                let is_own = |c: &&CapacityOf| self.case(c.job).texts.get(index).is_some_and(|t| t == text);
                let own: Vec<&CapacityOf> = capacities.iter().filter(is_own).collect();
                let number = own
                    .first()
                    .and_then(|c| self.case(c.job).values.get(index).copied().flatten());
                rows.push(level((Some(index), text, number), own.into_iter()));
            }
        }
        if rows.is_empty() {
            rows.push(level((None, "all", None), capacities.iter()));
        }
        rows
    }

    /// The trend of the capacity with each varied input of two or more numbers.
    ///
    /// # Errors
    /// None for runs as read; [`AssessError`] for a value that is not a number.
    pub fn trends(&self) -> Result<Vec<TrendAnswer>, AssessError> {
        let capacities = self.capacities();
        let mut found = Vec::new();
        for (index, axis) in self
            .study
            .vary
            .iter()
            .enumerate()
            .filter(|(_, axis)| axis.values.len() > 1)
        {
            let expected = self
                .study
                .expect
                .iter()
                .find(|expected| expected.input == axis.path);
            if !self.inputs.get(index).is_some_and(|input| input.is_number) {
                continue;
            }
            let all: Vec<(usize, Reached)> = capacities
                .iter()
                .filter_map(|c| Some((c.job, c.first_fall_m_s2()?)))
                .collect();
            let of_pairs = trend(&self.units(index, &all))?;
            let mut of_each = Vec::new();
            for replicate in 0..self.replicates() * self.samples() {
                let own = all.iter().copied();
                let own: Vec<(usize, Reached)> = own
                    .filter(|(job, _)| self.replicate_of(*job) == replicate)
                    .collect();
                let tau = trend(&self.units(index, &own))?;
                if tau.pairs > 0 {
                    of_each.push(tau.tau);
                }
            }
            let expected = expected.map(|expected| {
                let opposite = match expected.direction {
                    Direction::Rising => Direction::Falling,
                    Direction::Falling => Direction::Rising,
                };
                let verdict = if of_pairs.shows(expected.direction) {
                    TrendVerdict::Holds
                } else if of_pairs.shows(opposite) {
                    TrendVerdict::Contradicted
                } else {
                    TrendVerdict::NotSeen
                };
                (expected.clone(), verdict)
            });
            found.push(TrendAnswer {
                input: index,
                of_pairs,
                of_each,
                expected,
                acts: self.input_acts(index),
            });
        }
        Ok(found)
    }

    /// Key of the motion, direction and sample of a job, equal for all cases.
    pub(super) fn replicate_of(&self, job: usize) -> usize {
        let replicates = self.replicates().max(1);
        self.sample_of(job) * replicates + job % replicates
    }

    /// (input, result) in groups with equal motion, direction, sample, variant and other inputs; infinite without a fall. The groups of one
    /// record are one unit: its directions and samples are not further records.
    fn units(&self, index: usize, results: &[(usize, Reached)]) -> Vec<Vec<Vec<(f64, f64)>>> {
        let mut units: BTreeMap<usize, BTreeMap<AllElse<'_>, Vec<(f64, Reached)>>> = BTreeMap::new();
        for &(job, result) in results {
            let case = self.case(job);
            let Some(value) = case.values.get(index).copied().flatten() else {
                continue;
            };
            let others = case.texts.iter().take(self.study.vary.len()).enumerate();
            let others: Vec<&str> = others
                .filter(|(i, _)| *i != index)
                .map(|(_, t)| t.as_str())
                .collect();
            let key = (self.replicate_of(job), case.variant.as_deref(), others);
            let groups = units.entry(self.record_index(job)).or_default();
            groups.entry(key).or_default().push((value, result));
        }
        let units = units.into_values();
        units
            .map(|groups| groups.into_values().map(ranked).collect())
            .collect()
    }
}

/// Results in order of capacity: one without a fall has a larger capacity than all that fell. One that was tried only below the fall of
/// another could be smaller or larger, and is left out.
fn ranked(group: Vec<(f64, Reached)>) -> Vec<(f64, f64)> {
    let fell = group.iter().filter(|(_, result)| result.is_reached());
    let largest_fall = fell.map(|(_, result)| result.value()).fold(0.0, f64::max);
    let each = group.into_iter().filter_map(|(input, result)| match result {
        Reached::At(value) => Some((input, value)),
        Reached::Above(value) => (value >= largest_fall).then_some((input, f64::INFINITY)),
    });
    each.collect()
}

/// Key of a group: motion, direction and sample, the variant, and all other inputs as written.
type AllElse<'a> = (usize, Option<&'a str>, Vec<&'a str>);

fn level<'c>(
    (input, text, value): (Option<usize>, &str, Option<f64>),
    capacities: impl Iterator<Item = &'c CapacityOf>,
) -> LevelRow {
    LevelRow {
        input,
        text: text.to_owned(),
        value,
        scans: capacities.cloned().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_what_did_not_fall_ranks_above_what_did_if_that_is_known() {
        use Reached::{Above, At};
        let inf = f64::INFINITY;
        let known = ranked(vec![(1.0, At(0.4)), (2.0, Above(1.0)), (3.0, At(0.9))]);
        assert_eq!(known, [(1.0, 0.4), (2.0, inf), (3.0, 0.9)]);
        let unknown = ranked(vec![(1.0, At(0.4)), (2.0, Above(0.3)), (3.0, Above(0.5))]);
        assert_eq!(unknown, [(1.0, 0.4), (3.0, inf)]);
    }
}
