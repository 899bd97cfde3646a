//! A study as it is answered: inputs, runs, and the capacities, levels and trends that they show.

use super::frame_maps::FrameMaps;
use super::run::{Run, RunOutcome, StudyKind};
use crate::project::{ExpectedTrend, Names, StudyPart};
use dolmen::assess::{AssessError, Capacity, Direction, ScaleTrial, Trend, Trial, capacity, trend};
use std::collections::BTreeMap;

/// One input of the runs: varied, or drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct InputColumn {
    /// Its path in the project file.
    pub path: String,
    /// Its column in tables, the unit last.
    pub column: String,
    /// Its SI unit; empty without one.
    pub unit: String,
    /// Whether its values are numbers.
    pub is_number: bool,
    /// Whether it is drawn, not varied.
    pub is_drawn: bool,
}

/// The inputs of one case: a combination of varied values, and a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseInputs {
    /// The variant; `None` for the file as it is.
    pub variant: Option<String>,
    /// One value an input, in SI; `None` where it is no number or was refused.
    pub values: Vec<Option<f64>>,
    /// The same as they are written.
    pub texts: Vec<String>,
}

/// A study with everything that was run.
#[derive(Clone, Debug)]
pub struct StudyAnswer {
    /// The project file, as it was named.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The study.
    pub study: StudyPart,
    /// What is studied.
    pub kind: StudyKind,
    /// Gravity that turns accelerations into g, m/s².
    pub gravity_m_s2: f64,
    /// Inputs, the varied ones first.
    pub inputs: Vec<InputColumn>,
    /// Cases: samples of the first combination, then of the next.
    pub cases: Vec<CaseInputs>,
    /// Motions, by name.
    pub motions: Vec<String>,
    /// Runs by job and scale.
    pub runs: Vec<Run>,
    /// Scans that are not done.
    pub missing: Vec<usize>,
    /// Of a frame: maps and releases by case.
    pub maps: Vec<FrameMaps>,
}

/// What one scan shows.
#[derive(Clone, Debug)]
pub struct CapacityOf {
    /// Its case, motion and direction.
    pub job: usize,
    /// First fall and what was survived, as factors on the motion.
    pub scan: Capacity,
    /// Largest horizontal peak of the motion at scale 1, m/s².
    pub peak_of_scale_1_m_s2: f64,
    /// Peak at which DS1, DS2, DS3 are first reached, and the first fall, m/s²; infinite where no scale tried did.
    pub first_m_s2: [f64; 4],
}

/// Capacities over everything else at one value of an input.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelRow {
    /// The input, an index; `None` for the variant.
    pub input: Option<usize>,
    /// The value as it is written.
    pub text: String,
    /// In SI, if it is a number.
    pub value: Option<f64>,
    /// Peaks of first falls, m/s², rising; infinite where nothing fell.
    pub first_fall_m_s2: Vec<f64>,
    /// Medians of the peaks at which DS1, DS2, DS3 are first reached, m/s²; infinite beyond the scan.
    pub median_states_m_s2: [f64; 3],
    /// Scans that survived a scale above their first fall.
    pub survived_above: usize,
}

/// What is said of an expected trend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrendVerdict {
    /// Seen, beyond chance.
    Holds,
    /// Neither it nor its opposite is seen beyond chance.
    NotSeen,
    /// The opposite is seen beyond chance.
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

/// The trend of the capacity with one input, all else equal.
#[derive(Clone, Debug, PartialEq)]
pub struct TrendAnswer {
    /// The input, an index.
    pub input: usize,
    /// Of the medians over motions, directions and samples.
    pub of_medians: Trend,
    /// τ of each motion, direction and sample by itself.
    pub of_each: Vec<f64>,
    /// What was expected of it, with what is said of that.
    pub expected: Option<(ExpectedTrend, TrendVerdict)>,
}

impl TrendAnswer {
    /// Of how many motions, directions and samples τ goes this way.
    pub fn same_way(&self, direction: Direction) -> usize {
        let goes = |tau: &&f64| match direction {
            Direction::Rising => **tau > 0.0,
            Direction::Falling => **tau < 0.0,
        };
        self.of_each.iter().filter(goes).count()
    }
}

impl StudyAnswer {
    /// Scans in all: cases × motions × directions.
    pub fn jobs(&self) -> usize {
        self.cases.len() * self.replicates()
    }

    /// Scans a case: motions × directions.
    fn replicates(&self) -> usize {
        self.motions.len() * self.study.turns_rad.len()
    }

    fn samples(&self) -> usize {
        self.study.samples.unwrap_or(1)
    }

    /// The case of a job, an index.
    pub fn case_of(&self, job: usize) -> usize {
        job / self.replicates().max(1)
    }

    /// The inputs of a job.
    pub fn case(&self, job: usize) -> &CaseInputs {
        &self.cases[self.case_of(job)]
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
        let index = job % self.replicates().max(1) / self.study.turns_rad.len();
        self.motions.get(index).map_or("", String::as_str)
    }

    /// The turn of the motion of a job, rad.
    pub fn turn_rad(&self, job: usize) -> f64 {
        self.study.turns_rad[job % self.study.turns_rad.len()]
    }

    /// What each scan shows, by job; scans whose inputs were refused are left out.
    pub fn capacities(&self) -> Vec<CapacityOf> {
        let scans = self.runs.chunk_by(|a, b| a.job == b.job);
        scans.filter_map(capacity_of).collect()
    }

    /// How many runs ended each way.
    pub fn outcomes(&self) -> BTreeMap<RunOutcome, usize> {
        let mut counts = BTreeMap::new();
        for run in &self.runs {
            *counts.entry(run.outcome).or_insert(0) += 1;
        }
        counts
    }

    /// Reasons of refusals, each with how many cases have it.
    pub fn refusals(&self) -> BTreeMap<&str, usize> {
        let mut counts = BTreeMap::new();
        for run in self.runs.iter().filter(|run| run.outcome == RunOutcome::Refused) {
            *counts.entry(run.why.as_str()).or_insert(0) += 1;
        }
        counts
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
    /// None for runs as they are read: [`AssessError`] for a value that is not a number.
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
            let of_medians = trend(&self.groups(index, &self.medians(&capacities)))?;
            let mut of_each = Vec::new();
            for replicate in 0..self.replicates() * self.samples() {
                let own: Vec<(usize, f64)> = capacities
                    .iter()
                    .filter(|c| self.replicate_of(c.job) == replicate)
                    .map(|c| (c.job, c.first_m_s2[3]))
                    .collect();
                let tau = trend(&self.groups(index, &own))?;
                if tau.pairs > 0 {
                    of_each.push(tau.tau);
                }
            }
            let expected = expected.map(|expected| {
                let opposite = match expected.direction {
                    Direction::Rising => Direction::Falling,
                    Direction::Falling => Direction::Rising,
                };
                let verdict = if of_medians.shows(expected.direction) {
                    TrendVerdict::Holds
                } else if of_medians.shows(opposite) {
                    TrendVerdict::Contradicted
                } else {
                    TrendVerdict::NotSeen
                };
                (expected.clone(), verdict)
            });
            found.push(TrendAnswer {
                input: index,
                of_medians,
                of_each,
                expected,
            });
        }
        Ok(found)
    }

    /// Which motion, direction and sample a job has, all cases alike.
    fn replicate_of(&self, job: usize) -> usize {
        let replicates = self.replicates().max(1);
        self.sample_of(job) * replicates + job % replicates
    }

    /// The median first fall of each combination, with one of its jobs.
    fn medians(&self, capacities: &[CapacityOf]) -> Vec<(usize, f64)> {
        let mut by_combination: BTreeMap<usize, (usize, Vec<f64>)> = BTreeMap::new();
        for c in capacities {
            let entry = by_combination.entry(self.combination_of(c.job));
            entry.or_insert((c.job, Vec::new())).1.push(c.first_m_s2[3]);
        }
        let each = by_combination.into_values();
        each.map(|(job, values)| (job, quantile_of_capacities(&values, 0.5)))
            .collect()
    }

    /// (input, result) in groups in which the variant and all other inputs are equal.
    fn groups(&self, index: usize, results: &[(usize, f64)]) -> Vec<Vec<(f64, f64)>> {
        let mut groups: BTreeMap<AllElse<'_>, Vec<(f64, f64)>> = BTreeMap::new();
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
            let key = (case.variant.as_deref(), others);
            groups.entry(key).or_default().push((value, result));
        }
        groups.into_values().collect()
    }
}

/// What is equal within a group: the variant, and all other inputs as they are written.
type AllElse<'a> = (Option<&'a str>, Vec<&'a str>);

fn capacity_of(runs: &[Run]) -> Option<CapacityOf> {
    let job = runs.first()?.job;
    let usable = runs.iter().filter(|run| run.scale > 0.0);
    let tried: Vec<ScaleTrial> = usable
        .clone()
        .map(|run| ScaleTrial {
            scale: run.scale,
            trial: match run.outcome {
                RunOutcome::Fell => Trial::Fell,
                RunOutcome::Diverged | RunOutcome::Refused => Trial::Unknown,
                RunOutcome::Stood | RunOutcome::Uplifted | RunOutcome::Slid => Trial::Survived,
            },
        })
        .collect();
    let peak_of_scale_1_m_s2 = usable
        .clone()
        .map(|run| run.peak_ground_acceleration_m_s2 / run.scale)
        .next()?;
    let first = |state: u8| {
        let reached = usable.clone().filter(|run| run.damage_state >= state);
        reached
            .map(|run| run.peak_ground_acceleration_m_s2)
            .fold(f64::INFINITY, f64::min)
    };
    Some(CapacityOf {
        job,
        scan: capacity(&tried).ok()?,
        peak_of_scale_1_m_s2,
        first_m_s2: [first(1), first(2), first(3), first(4)],
    })
}

fn level<'c>(
    (input, text, value): (Option<usize>, &str, Option<f64>),
    capacities: impl Iterator<Item = &'c CapacityOf>,
) -> LevelRow {
    let own: Vec<&CapacityOf> = capacities.collect();
    let of = |state: usize| -> Vec<f64> { own.iter().map(|c| c.first_m_s2[state]).collect() };
    let median = |state: usize| quantile_of_capacities(&of(state), 0.5);
    let mut first_fall_m_s2 = of(3);
    first_fall_m_s2.sort_by(f64::total_cmp);
    LevelRow {
        input,
        text: text.to_owned(),
        value,
        first_fall_m_s2,
        median_states_m_s2: [median(0), median(1), median(2)],
        survived_above: own.iter().filter(|c| !c.scan.survived_above.is_empty()).count(),
    }
}

/// The quantile of capacities between order statistics (definition 7 of Hyndman and Fan), infinite as soon as an infinite one has a
/// part in it; not a number without any.
pub fn quantile_of_capacities(values: &[f64], probability: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else {
        return f64::NAN;
    };
    let h = last as f64 * probability;
    let below = (h.floor() as usize).min(last);
    let (low, part) = (sorted[below], h - below as f64);
    match sorted.get(below + 1) {
        Some(high) if part > 0.0 => {
            if high.is_finite() {
                low + part * (high - low)
            } else {
                f64::INFINITY
            }
        }
        _ => low,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_quantiles_with_capacities_beyond_the_scan() {
        let inf = f64::INFINITY;
        assert_eq!(quantile_of_capacities(&[3.0, 1.0, 2.0], 0.5), 2.0);
        assert_eq!(quantile_of_capacities(&[1.0, 2.0], 0.25), 1.25);
        assert_eq!(quantile_of_capacities(&[1.0, inf, 2.0], 0.5), 2.0);
        assert_eq!(quantile_of_capacities(&[1.0, inf], 0.5), inf);
        assert_eq!(quantile_of_capacities(&[1.0, inf, inf], 0.0), 1.0);
        assert!(quantile_of_capacities(&[], 0.5).is_nan());
    }
}
