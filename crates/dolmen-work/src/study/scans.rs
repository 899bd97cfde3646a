//! Results of scans: first falls, gaps by unusable runs, and capacities at one value of an input.

use super::measures::RunMeasures;
use super::run::{Run, RunOutcome};
use dolmen::assess::{
    Capacity, Observation, Reached, Reading, ScaleTrial, Trial, capacity, reached_quantile,
};
use dolmen_words::Language;

/// Number of states with a curve: the four damage states, and the allowable drift of the file.
pub(super) const STATES: usize = 5;
/// Place of the allowable drift of the file among the states.
pub const ALLOWED_DRIFT: usize = 4;
/// Fewest scans for 5 % and 95 % quantiles: with fewer they would be the extremes. Our choice.
pub const SCANS_OF_TAILS: usize = 20;

/// Usability of a scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScanVerdict {
    /// Its first fall is known.
    Fell,
    /// It falls under its own weight: its capacity is 0.
    FellAlone,
    /// It fell at no scale, and no run is missing.
    Beyond,
    /// A run below its first fall is unusable: only a bracket is known.
    Bracketed,
    /// Nothing is known.
    Unusable,
    /// Its inputs were refused: nothing was run.
    Refused,
    /// It is not done.
    Missing,
}

impl ScanVerdict {
    /// The word of tables and of JSON.
    pub fn word(self) -> &'static str {
        match self {
            ScanVerdict::Fell => "fell",
            ScanVerdict::FellAlone => "fell by itself",
            ScanVerdict::Beyond => "beyond",
            ScanVerdict::Bracketed => "bracketed",
            ScanVerdict::Unusable => "unusable",
            ScanVerdict::Refused => "refused",
            ScanVerdict::Missing => "missing",
        }
    }

    /// Whether it counts in quantiles and trends.
    pub fn is_usable(self) -> bool {
        matches!(
            self,
            ScanVerdict::Fell | ScanVerdict::FellAlone | ScanVerdict::Beyond
        )
    }
}

/// The result of one scan.
#[derive(Clone, Debug)]
pub struct CapacityOf {
    /// Index of its case, motion and direction.
    pub job: usize,
    /// Its usability.
    pub verdict: ScanVerdict,
    /// First fall and survived scales, as factors on the motion; `None` if nothing was run.
    pub scan: Option<Capacity>,
    /// Largest horizontal peak of the motion at scale 1, m/s²; NaN if nothing was run.
    pub peak_of_scale_1_m_s2: f64,
    /// Largest velocity of that component at scale 1, m/s.
    pub velocity_of_scale_1_m_s: f64,
    /// Peak at which DS1, DS2, DS3, a fall and the allowable drift of the file are first reached, m/s², for usable scans; 0 if it falls by its
    /// own weight.
    pub first_m_s2: Option<[Reached; STATES]>,
    /// Knowledge of the same peaks, m/s², including scans with only a bracket; `None` for the drift of a file without `[limits]`.
    pub seen_m_s2: [Option<Observation>; STATES],
    /// Whether it leans beyond the allowable drift of the file before it is shaken.
    pub is_beyond_at_rest: bool,
}

impl CapacityOf {
    /// Peak at which it first fell, m/s².
    pub fn first_fall_m_s2(&self) -> Option<Reached> {
        self.first_m_s2.map(|first| first[3])
    }

    /// Peak up to which every size was survived, m/s²; 0 if there is none.
    pub fn survived_m_s2(&self) -> f64 {
        self.in_m_s2(self.scan.as_ref().map(|scan| scan.survived_below))
            .unwrap_or(0.0)
    }

    /// The smallest peak at which it fell, whatever happened below, m/s².
    pub fn fell_m_s2(&self) -> Option<f64> {
        self.in_m_s2(self.scan.as_ref().and_then(|scan| scan.first_fall))
    }

    /// The largest peak that was tried, m/s².
    pub fn largest_m_s2(&self) -> Option<f64> {
        self.in_m_s2(self.scan.as_ref().map(|scan| scan.largest_tried))
    }

    /// Largest peak up to which a state is not reached, m/s²; 0 if none is known.
    pub fn not_yet_m_s2(&self, state: usize) -> f64 {
        match self.seen_m_s2[state] {
            Some(Observation::At(peak) | Observation::Above(peak)) => peak,
            Some(Observation::Between(low, _)) => low,
            Some(Observation::Below(_) | Observation::Stripe { .. }) | None => 0.0,
        }
    }

    /// Peaks above the first fall that were survived, m/s².
    pub fn survived_above_m_s2(&self) -> Vec<f64> {
        let scales = self.scan.iter().flat_map(|scan| &scan.survived_above);
        scales.map(|scale| scale * self.peak_of_scale_1_m_s2).collect()
    }

    /// The same for a linear building, where everything is proportional: its largest run gives exactly the peak at which each drift limit
    /// is reached, up to the largest size.
    pub(super) fn in_proportion(mut self, runs: &[Run], limits: [f64; STATES]) -> Self {
        let ratio = |run: &Run| match run.measures {
            RunMeasures::Building(of) => Some(of.peak_corner_drift_ratio).filter(|ratio| *ratio > 0.0),
            _ => None,
        };
        let usable = runs.iter().filter(|run| run.scale > 0.0);
        let known = usable.filter_map(|run| Some((run.peak_ground_acceleration_m_s2, ratio(run)?)));
        let Some((largest, ratio)) = known.reduce(|most, own| if own.0 > most.0 { own } else { most }) else {
            return self;
        };
        let exact = limits.map(|limit| limit * (largest / ratio));
        if self.first_m_s2.is_some() {
            self.first_m_s2 = Some(exact.map(|peak| match peak <= largest {
                true => Reached::At(peak),
                false => Reached::Above(largest),
            }));
        }
        for (seen, peak) in self.seen_m_s2.iter_mut().zip(exact) {
            *seen = seen.map(|_| match peak <= largest {
                true => Observation::At(peak),
                false => Observation::Above(largest),
            });
        }
        self
    }

    /// Whether it fell at the smallest size: its first fall may be below.
    pub fn fell_at_the_least(&self) -> bool {
        let scan = self.scan.as_ref();
        scan.is_some_and(|scan| scan.first_fall.is_some() && scan.survived_below == 0.0)
    }

    /// Number of unusable runs.
    pub fn unusable_runs(&self) -> usize {
        self.scan.as_ref().map_or(0, |scan| scan.unknown.len())
    }

    fn in_m_s2(&self, scale: Option<f64>) -> Option<f64> {
        scale.map(|scale| scale * self.peak_of_scale_1_m_s2)
    }
}

/// Capacities over all other inputs, at one value of an input.
#[derive(Clone, Debug)]
pub struct LevelRow {
    /// The index of the input; `None` for the variant.
    pub input: Option<usize>,
    /// The value as it is written.
    pub text: String,
    /// In SI, if it is a number.
    pub value: Option<f64>,
    /// Its scans, including unusable ones.
    pub scans: Vec<CapacityOf>,
}

impl LevelRow {
    /// The value for display; "all" for a study that varies nothing.
    pub fn shown(&self, language: Language) -> &str {
        match (self.input, self.text.as_str()) {
            (None, "all") => language.pick("all", "전체"),
            (_, text) => text,
        }
    }

    /// Usable scans.
    pub fn usable(&self) -> usize {
        self.scans.iter().filter(|scan| scan.verdict.is_usable()).count()
    }

    /// Unusable scans.
    pub fn left_out(&self) -> impl Iterator<Item = &CapacityOf> {
        self.scans.iter().filter(|scan| !scan.verdict.is_usable())
    }

    /// Peaks at which a state is first reached, m/s², by size.
    pub fn first_m_s2(&self, state: usize) -> Vec<Reached> {
        let mut first: Vec<Reached> = self
            .scans
            .iter()
            .filter_map(|scan| scan.first_m_s2.map(|first| first[state]))
            .collect();
        first.sort_by(|a, b| a.value().total_cmp(&b.value()));
        first
    }

    /// Number of scans that fall under their own weight.
    pub fn fell_alone(&self) -> usize {
        let scans = self.scans.iter();
        scans
            .filter(|scan| scan.verdict == ScanVerdict::FellAlone)
            .count()
    }

    /// Number of usable scans that fell.
    pub fn fell(&self) -> usize {
        self.first_m_s2(3)
            .iter()
            .filter(|first| first.is_reached())
            .count()
    }

    /// The smallest first fall, m/s²; the smallest size tried if none fell; `None` without a usable scan.
    pub fn least_m_s2(&self) -> Option<Reached> {
        let first = self.first_m_s2(3);
        let fell = first.iter().find(|first| first.is_reached());
        fell.or(first.first()).copied()
    }

    /// Whether the smallest first fall is known only to be at or below the smallest size of its scan.
    pub fn least_is_bound(&self) -> bool {
        let least = self.least_m_s2();
        let is_least = |scan: &&CapacityOf| scan.first_fall_m_s2() == least;
        least.is_some_and(Reached::is_reached)
            && self
                .scans
                .iter()
                .filter(is_least)
                .any(CapacityOf::fell_at_the_least)
    }

    /// A quantile of the peaks at which a state is first reached, m/s²; `None` without a usable scan, and for tails with fewer than
    /// [`SCANS_OF_TAILS`].
    pub fn quantile_m_s2(&self, state: usize, probability: f64) -> Option<Reached> {
        let is_tail = probability != 0.5;
        if is_tail && self.usable() < SCANS_OF_TAILS {
            return None;
        }
        reached_quantile(&self.first_m_s2(state), probability)
    }

    /// Largest peak below the smallest first fall at which nothing fell, m/s²: the fall lies between the two. 0 if nothing smaller was tried.
    pub fn least_survived_m_s2(&self) -> f64 {
        let least = self.least_m_s2();
        let scans = self.scans.iter();
        let first = scans.filter(|scan| scan.first_fall_m_s2() == least);
        first
            .map(|scan| scan.not_yet_m_s2(3))
            .fold(f64::INFINITY, f64::min)
    }

    /// The median of the largest peaks up to which a state is not reached, m/s²: the median of its first peaks lies above.
    pub fn median_not_yet_m_s2(&self, state: usize) -> Option<f64> {
        let usable = self.scans.iter().filter(|scan| scan.verdict.is_usable());
        let each: Vec<Reached> = usable.map(|scan| Reached::At(scan.not_yet_m_s2(state))).collect();
        reached_quantile(&each, 0.5).map(Reached::value)
    }

    /// Usable scans that survived a size above their first fall.
    pub fn survived_above(&self) -> usize {
        let usable = self.scans.iter().filter(|scan| scan.verdict.is_usable());
        usable
            .filter(|scan| {
                scan.scan
                    .as_ref()
                    .is_some_and(|scan| !scan.survived_above.is_empty())
            })
            .count()
    }
}

/// Information of one run on a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RunInformation {
    Reached,
    NotReached,
    /// The run is unusable, or ended too early.
    Unknown,
}

/// Information of runs at rising sizes on the first time of a state; `None` without any.
pub(super) fn first_seen(runs: impl Iterator<Item = (f64, RunInformation)>) -> Option<Observation> {
    let (mut below, mut is_open) = (None, false);
    for (size, seen) in runs {
        match seen {
            RunInformation::Reached => {
                return Some(match below {
                    Some(below) => Observation::Between(below, size),
                    None => Observation::Below(size),
                });
            }
            RunInformation::NotReached if !is_open => below = Some(size),
            RunInformation::NotReached => {}
            RunInformation::Unknown => is_open = true, // the state may have been reached first here
        }
    }
    below.map(Observation::Above)
}

/// The result of the runs of one scan; `is_whole`: none is missing.
pub(super) fn capacity_of(job: usize, runs: &[Run], is_whole: bool) -> CapacityOf {
    let usable: Vec<&Run> = runs.iter().filter(|run| run.scale > 0.0).collect();
    let tried: Vec<ScaleTrial> = usable
        .iter()
        .map(|run| ScaleTrial {
            scale: run.scale,
            trial: run.outcome.trial(),
        })
        .collect();
    let scan = capacity(&tried).ok().filter(|_| !tried.is_empty());
    let reading = scan.as_ref().map(Capacity::reading);
    let verdict = match reading {
        _ if runs.iter().any(Run::fell_alone) => ScanVerdict::FellAlone,
        _ if runs.iter().any(Run::is_refused) => ScanVerdict::Refused,
        _ if !is_whole => ScanVerdict::Missing,
        Some(Reading::Fell(_)) => ScanVerdict::Fell,
        Some(Reading::Beyond(_)) => ScanVerdict::Beyond,
        Some(Reading::Open { survived, fell }) if survived > 0.0 || fell.is_some() => ScanVerdict::Bracketed,
        Some(Reading::Open { .. }) | None => ScanVerdict::Unusable,
    };
    let largest = usable.iter().map(|run| run.peak_ground_acceleration_m_s2);
    let largest = largest.fold(0.0, f64::max);
    let first = |state: u8| {
        if verdict == ScanVerdict::FellAlone {
            return Reached::At(0.0);
        }
        let reached = usable.iter().filter(|run| run.damage_state >= state);
        let least = reached
            .map(|run| run.peak_ground_acceleration_m_s2)
            .fold(f64::INFINITY, f64::min);
        match least.is_finite() {
            true => Reached::At(least),
            false => Reached::Above(largest),
        }
    };
    let seen = |state: u8| {
        let each = usable.iter().map(|run| {
            let seen = match run.outcome.trial() {
                _ if run.damage_state >= state => RunInformation::Reached,
                Trial::Unknown => RunInformation::Unknown,
                Trial::Fell | Trial::Survived => RunInformation::NotReached,
            };
            (run.peak_ground_acceleration_m_s2, seen)
        });
        first_seen(each).filter(|_| is_whole)
    };
    CapacityOf {
        job,
        verdict,
        scan,
        peak_of_scale_1_m_s2: usable
            .first()
            .map_or(f64::NAN, |run| run.peak_ground_acceleration_m_s2 / run.scale),
        velocity_of_scale_1_m_s: usable
            .first()
            .map_or(f64::NAN, |run| run.peak_ground_velocity_m_s / run.scale),
        first_m_s2: verdict
            .is_usable()
            .then(|| [first(1), first(2), first(3), first(4), first(u8::MAX)]),
        seen_m_s2: [seen(1), seen(2), seen(3), seen(4), None],
        is_beyond_at_rest: false,
    }
}

impl RunOutcome {
    /// The run as a trial of a scan.
    pub fn trial(self) -> Trial {
        match self {
            RunOutcome::Fell => Trial::Fell,
            RunOutcome::StillMoving | RunOutcome::Diverged | RunOutcome::Refused => Trial::Unknown,
            RunOutcome::Stood | RunOutcome::Uplifted | RunOutcome::Slid => Trial::Survived,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_words::message::Both;

    fn runs(outcomes: &[RunOutcome]) -> Vec<Run> {
        let each = outcomes.iter().zip(1..);
        each.map(|(&outcome, scale)| Run {
            job: 0,
            scale: f64::from(scale),
            peak_ground_acceleration_m_s2: 2.0 * f64::from(scale),
            peak_ground_velocity_m_s: 0.1,
            outcome,
            damage_state: if outcome == RunOutcome::Fell { 4 } else { 0 },
            joint_states: Vec::new(),
            at_s: f64::NAN,
            part: String::new(),
            gave_way: String::new(),
            measures: RunMeasures::None,
            why: Both::default(),
        })
        .collect()
    }

    /// Above a run without information, no size is known to be below the state.
    #[test]
    fn exact_what_runs_say_of_when_a_state_begins() {
        use RunInformation::{NotReached as No, Reached as Yes, Unknown as Open};
        let of = |all: &[RunInformation]| first_seen((1..).map(f64::from).zip(all.iter().copied()));
        assert_eq!(of(&[No, No, Yes, No]), Some(Observation::Between(2.0, 3.0)));
        assert_eq!(of(&[No, Open, No, Yes]), Some(Observation::Between(1.0, 4.0)));
        assert_eq!(of(&[Open, No, Yes]), Some(Observation::Below(3.0)));
        assert_eq!(of(&[No, No, Open, No]), Some(Observation::Above(2.0)));
        assert_eq!(of(&[Open, No]), None);
        assert_eq!(of(&[]), None);
    }

    #[test]
    fn holds_what_cannot_be_used_is_left_out_with_its_bracket() {
        use RunOutcome::{Diverged, Fell, Refused, Stood};
        let row = |scans: &[&[RunOutcome]]| LevelRow {
            input: None,
            text: String::new(),
            value: None,
            scans: scans
                .iter()
                .map(|ends| capacity_of(0, &runs(ends), true))
                .collect(),
        };
        let refused = row(&[&[Refused, Refused]]);
        assert_eq!((refused.usable(), refused.fell()), (0, 0));
        assert_eq!(refused.quantile_m_s2(3, 0.5), None);
        assert_eq!(refused.scans[0].verdict, ScanVerdict::Unusable);
        let mixed = row(&[&[Stood, Fell], &[Stood, Diverged, Fell], &[Stood, Stood]]);
        assert_eq!(
            (mixed.usable(), mixed.fell(), mixed.least_m_s2()),
            (2, 1, Some(Reached::At(4.0)))
        );
        // both usable scans stood at 2 m/s², one of them at 4 too
        assert_eq!(mixed.least_survived_m_s2(), 2.0);
        assert_eq!(mixed.median_not_yet_m_s2(3), Some(3.0));
        let open = mixed.left_out().next().unwrap();
        assert_eq!(open.verdict, ScanVerdict::Bracketed);
        assert_eq!((open.survived_m_s2(), open.fell_m_s2()), (2.0, Some(6.0)));
        assert_eq!(open.seen_m_s2[3], Some(Observation::Between(2.0, 6.0)));
        assert_eq!(mixed.quantile_m_s2(3, 0.05), None);
        assert_eq!(mixed.quantile_m_s2(3, 0.5), Some(Reached::Above(4.0)));
        let halfway = capacity_of(0, &runs(&[Stood, Stood]), false);
        assert_eq!(
            (halfway.verdict, halfway.first_m_s2),
            (ScanVerdict::Missing, None)
        );
        let many: Vec<&[RunOutcome]> = vec![&[Stood, Fell]; SCANS_OF_TAILS];
        assert_eq!(row(&many).quantile_m_s2(3, 0.05), Some(Reached::At(4.0)));
    }
}
