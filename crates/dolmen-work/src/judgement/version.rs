//! The judgement of one version of a structure.

use super::basis::Basis;
use super::colour::Colour;
use super::earthquake::{Earthquake, EarthquakeFinding, of_site};
use super::evidence::Evidence;
use super::said::{MovedSaid, text};
use super::tilt_limit::{drift_left, last_tilt};
use super::weight::Weight;
use super::wind::{MovedBy, WindFinding, WindWord, of_wind};
use crate::loads::{Combined, Governing};
use crate::simulation::Simulation;
use crate::state::{Check, StackAnswer, State};
use crate::tilt_left_out::TiltLeftOut;
use dolmen::stability::Verdict;
use dolmen_project::{ChainLean, FrameLean, ModelDamage, Project, Structure, SurveyedLean};
use dolmen_words::Language;
use dolmen_words::message::Both;

/// The three questions for one version of a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct VersionJudgement {
    /// The variant; `None`: the structure as it is.
    pub variant: Option<String>,
    /// Its stability under weight; `None` if no model was checked.
    pub weight: Option<Weight>,
    /// The wind or static loads that govern the word for weight, and the combination; `None` if the weight alone does.
    pub governed_by: Option<Governing>,
    /// The lowest frequency, Hz, whose resonance the wind does not include, if the word for weight is unknown because of it.
    pub lacks_resonance_at_hz: Option<f64>,
    /// Whether the word for weight includes wind or static loads.
    pub with_loads: bool,
    /// Whether the word for weight is worse because edges of stones crush.
    pub crushes: bool,
    /// The share of samples that fall or reach a limit; `None` without samples, or if none does.
    pub falling_share: Option<f64>,
    /// Results for earthquakes, one for each demand, motion and part; empty without a demand.
    pub earthquake: Vec<EarthquakeFinding>,
    /// Results for the wind on a building, compared with the limits of the file; empty without limits.
    pub wind: Vec<WindFinding>,
    /// Whether the model represents the structure.
    pub evidence: Evidence,
    /// The code of the site and the return period, years, if one was chosen; `None` without a site.
    pub demand_source: Option<(String, Option<u32>)>,
    /// A measured tilt that is not in the model.
    pub tilt_left_out: Option<TiltLeftOut>,
    /// Whether the latest measured tilt is beyond the limit of the file.
    pub tilt_beyond_limit: bool,
    /// Whether it is near that limit, and below it.
    pub tilt_near_limit: bool,
    /// Damages of inspections beyond their limits.
    pub damage_beyond_limit: usize,
    /// The measured tilt in the model, if there is one.
    pub leans: Option<Leaning>,
    /// The earlier motion, if the earthquake is the second of two.
    pub after: Option<AfterMotion>,
    /// Which of several solutions for an identified stiffness it is; `None` with only one.
    pub solution: Option<Solution>,
    /// Assumed inputs, and omissions of the model.
    pub basis: Basis,
    /// Inspected damage in the model.
    pub damage: Vec<ModelDamage>,
    /// Whether a run had neither damping nor friction.
    pub is_undamped: bool,
}

/// One of several accepted solutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Solution {
    /// Its number, from 1.
    pub number: usize,
    /// Number of solutions.
    pub of: usize,
}

impl Solution {
    /// The solution of a project that has several.
    fn of(project: &Project) -> Option<Self> {
        let told = project.from_surveys.as_ref().filter(|told| told.of > 1)?;
        Some(Solution {
            number: told.number,
            of: told.of,
        })
    }
}

/// Two motions, of which the second acted after the first and was judged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AfterMotion {
    /// The first.
    pub first: String,
    /// The second.
    pub second: String,
}

/// A measured tilt in a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaning {
    /// The survey.
    pub survey: String,
    /// Direction and tilt as written: "x 1/177, y 1/540".
    pub tilt: String,
}

impl VersionJudgement {
    pub(super) fn new(variant: Option<&str>, weight: Option<Weight>, evidence: Evidence) -> Self {
        VersionJudgement {
            variant: variant.map(str::to_owned),
            weight,
            governed_by: None,
            lacks_resonance_at_hz: None,
            with_loads: false,
            crushes: false,
            falling_share: None,
            earthquake: Vec::new(),
            wind: Vec::new(),
            evidence,
            demand_source: None,
            tilt_left_out: None,
            tilt_beyond_limit: false,
            tilt_near_limit: false,
            damage_beyond_limit: 0,
            leans: None,
            after: None,
            solution: None,
            basis: Basis::default(),
            damage: Vec::new(),
            is_undamped: false,
        }
    }

    /// The word on the earthquake.
    pub fn earthquake_word(&self) -> Earthquake {
        Earthquake::worst(&self.earthquake)
    }

    /// The word on the motion in the wind.
    pub fn wind_word(&self) -> WindWord {
        let words = self.wind.iter().map(|finding| finding.word);
        words.max().unwrap_or(WindWord::NotAsked)
    }

    /// The worst colour of all questions.
    pub fn colour(&self) -> Colour {
        let weight = self.weight.map(Weight::colour);
        let others = [
            self.earthquake_word().colour(),
            self.wind_word().colour(),
            self.evidence.colour(),
        ];
        let is_beyond = self.tilt_beyond_limit || self.damage_beyond_limit > 0;
        let near = self.tilt_near_limit.then_some(Colour::Amber);
        let beyond = is_beyond.then_some(Colour::Red).or(near);
        let left_out = self.tilt_left_out.is_some() || self.basis.is_unsafe();
        let unchecked = (!self.basis.unchecked_stiffness_from.is_empty()).then_some(Colour::Amber);
        let left_out = left_out.then_some(Colour::Amber);
        Colour::worst(
            weight
                .into_iter()
                .chain(others)
                .chain(beyond)
                .chain(left_out)
                .chain(unchecked),
        )
    }

    /// Whether its overall colour or the colour of one question is worse than that of another version: the structure may be below the
    /// demand, and its variant may not even stand.
    pub fn is_worse_than(&self, other: &VersionJudgement) -> bool {
        let each = |of: &VersionJudgement| {
            [
                Some(of.colour()),
                of.weight.map(Weight::colour),
                Some(of.earthquake_word().colour()),
                Some(of.wind_word().colour()),
            ]
        };
        each(self)
            .into_iter()
            .zip(each(other))
            .any(|(own, other)| own > other && other.is_some())
    }

    /// The word for weight, with the combination of loads that decides it.
    pub fn weight_words(&self, weight: Weight, language: Language) -> String {
        match &self.governed_by {
            None => weight.words(language),
            Some(by) => by
                .under(Both::of(|language| weight.words(language)))
                .text(language),
        }
    }

    /// The headline: the fixed words, the worst first, then in the order of the questions. It leaves out an earthquake without a demand, and
    /// evidence that neither contradicts the model nor makes it doubtful.
    pub fn words(&self, language: Language) -> Vec<String> {
        let earthquake = self.earthquake_word();
        let mut words = Vec::new();
        if let Some(weight) = self.weight {
            words.push((weight.colour(), self.weight_words(weight, language)));
        }
        if earthquake != Earthquake::NotAsked {
            words.push((earthquake.colour(), earthquake.word(language).to_owned()));
        }
        let wind = self.wind_word();
        if wind != WindWord::NotAsked {
            let by = WindFinding::deciding(&self.wind).map_or(MovedBy::Wind, |of| of.by);
            let word = Both::of(|language| wind.word(language));
            let said = match by {
                MovedBy::Wind => MovedSaid::InWind { word },
                MovedBy::Loads => MovedSaid::UnderLoads { word },
                MovedBy::Both => MovedSaid::UnderBoth { word },
                MovedBy::WithEarthquake => MovedSaid::UnderAll { word },
            };
            let said = text(said, language);
            words.push((wind.colour(), said));
        }
        if self.evidence.is_doubted() {
            words.push((self.evidence.colour(), self.evidence.words(language)));
        }
        words.sort_by_key(|(colour, _)| std::cmp::Reverse(*colour));
        words.into_iter().map(|(_, words)| words).collect()
    }
}

/// Whether the weight of a stack is more critical because edges crush.
fn crushes(state: &State) -> bool {
    let Check::Stack(answer) = &state.check else {
        return false;
    };
    let crushing = answer.check.crushing.as_ref();
    crushing
        .is_some_and(|of| answer.check.verdict > of.uncrushed_verdict && of.verdict > of.uncrushed_verdict)
}

/// Adds the results of a check to a version.
pub(super) fn version(
    (variant, project): (Option<&str>, &Project),
    state: &State,
    evidence: Evidence,
) -> VersionJudgement {
    let is_contradicted = evidence.is_contradicted();
    let weight = Weight::of(state, is_contradicted);
    let mut version = VersionJudgement::new(variant, Some(weight), evidence);
    version.earthquake = of_site(state);
    // a stack depends on shapes and friction
    if is_contradicted && !matches!(state.check, Check::Stack(_)) {
        let found = version.earthquake.into_iter();
        version.earthquake = found.map(EarthquakeFinding::if_model_were_right).collect();
    }
    version.wind = of_wind(project, state, is_contradicted);
    // the word for weight of a building holds no loads from the side: they move it, and drifts are judged
    let loads = state
        .loads
        .as_ref()
        .filter(|_| !matches!(state.check, Check::Building(_)));
    version.with_loads = loads.is_some_and(|loads| {
        loads
            .combinations
            .iter()
            .any(|of| of.wind != 0.0 || of.loads != 0.0)
    });
    version.crushes = crushes(state);
    version.falling_share = state.falling_share();
    version.governed_by = governing(state, weight);
    version.lacks_resonance_at_hz = lacks_resonance_at_hz(state, weight);
    version.demand_source = state.demand.as_ref().map(|demand| {
        let site = &demand.site;
        (site.code().to_owned(), site.return_period_years())
    });
    version.leans = match &state.check {
        Check::Stack(answer) => answer.lean.as_ref().map(of_stack_lean),
        Check::Frame(_) => match &project.structure {
            Structure::Frame(part) => part.lean.as_ref().map(of_frame_lean),
            _ => None,
        },
        // its beds are compared with its tilt if their widths are known
        Check::Chain(_) => match &project.structure {
            Structure::Chain(part) if state.tilts.iter().any(|tilt| tilt.uplift_tilt.is_some()) => {
                let lean = part.lean.as_ref().map(of_chain_lean);
                lean.or_else(|| counted_tilt(project, state).filter(|_| !part.takes_no_tilt))
            }
            _ => None,
        },
        Check::Building(_) => None,
    };
    version.tilt_left_out = TiltLeftOut::of_model(project);
    let left = match &state.check {
        Check::Stack(answer) => version
            .tilt_left_out
            .as_ref()
            .and_then(|_| tilt_left(project, answer)),
        _ => drift_left(project),
    };
    if let Some(left) = left {
        let plumb = version.earthquake.into_iter();
        version.earthquake = plumb.map(|found| found.with_drift_left(left)).collect();
        if matches!(state.check, Check::Stack(_)) && weight_leaning(state, left) != Verdict::Stable {
            version.weight = version.weight.map(|plumb| plumb.if_it_stood_plumb());
        }
    }
    if matches!(&state.check, Check::Stack(answer) if !answer.stack.support_movements().is_empty()) {
        let of_before = version.earthquake.into_iter();
        version.earthquake = of_before.map(EarthquakeFinding::before_supports_moved).collect();
    }
    version.solution = Solution::of(project);
    version.basis = Basis::of_checked(project, variant, state);
    version.damage.clone_from(&project.damage);
    version
}

/// The share of the capacity of stones that start plumb in the model which their measured tilt leaves: beds that turn by φ lower the acceleration
/// a of first motion to a − φ. `None` without a tilt or a capacity.
fn tilt_left(project: &Project, answer: &StackAnswer) -> Option<f64> {
    let (_, tilt) = last_tilt(project)?;
    let capacity = answer.check.capacity?;
    Some(1.0 - tilt / capacity.acceleration_g)
}

/// The verdict on static loads and wind on a stack with a share of its capacity.
fn weight_leaning(state: &State, left: f64) -> Verdict {
    let combinations = state.loads.iter().flat_map(|loads| &loads.combinations);
    let factors = combinations.filter_map(|combination| match &combination.of {
        Combined::Stack(found) => Some(found.found.factor),
        _ => None,
    });
    let least = factors.fold(f64::INFINITY, f64::min);
    match left > 0.0 {
        true if least == f64::INFINITY => Verdict::Stable,
        _ => Verdict::of_load_factor(least.min(f64::MAX) * left),
    }
}

/// The frequency whose resonance is missing from the wind that makes the word for weight unknown; `None` for another word or reason.
fn lacks_resonance_at_hz(state: &State, weight: Weight) -> Option<f64> {
    let is_unknown = matches!(weight, Weight::Unknown { .. });
    let loads = state.governing_loads().filter(|_| is_unknown)?;
    let is_borne = loads.worst().is_some_and(|of| of.verdict() != Verdict::Unknown);
    loads.lacks_resonance_at_hz().filter(|_| is_borne)
}

/// What governs the word for weight: wind and static loads, or the worse of two directions.
pub(crate) fn governing(state: &State, weight: Weight) -> Option<Governing> {
    let loads = state.governing_loads().map(Governing::of);
    let is_short = matches!(weight, Weight::Unstable | Weight::Marginal);
    let direction = state.worse_direction().filter(|_| is_short);
    loads.or(direction.map(Governing::Direction))
}

/// The measured tilt at the start of a run.
pub(super) fn leaning(run: &Simulation) -> Option<Leaning> {
    match run {
        Simulation::Stack(runs) => runs.deciding.lean.as_ref().map(of_stack_lean),
        Simulation::Chain(run) => run.lean.as_ref().map(of_chain_lean),
        Simulation::Supports(run) => run.lean.as_ref().map(of_stack_lean),
        Simulation::Frame(run) => run.lean.as_ref().map(of_frame_lean),
        Simulation::Settled(_) | Simulation::Building(_) | Simulation::Wind(_) => None,
    }
}

fn of_chain_lean(lean: &ChainLean) -> Leaning {
    Leaning {
        survey: lean.survey.clone(),
        tilt: lean.written.clone(),
    }
}

/// The tilt of a chain that its beds are compared with, also of a survey without a date, which leans no model.
fn counted_tilt(project: &Project, state: &State) -> Option<Leaning> {
    let survey = &state.tilts.first()?.survey;
    let survey = project.surveys.iter().find(|own| own.name == *survey)?;
    Some(Leaning {
        survey: survey.name.clone(),
        tilt: TiltLeftOut::written(survey),
    })
}

fn of_frame_lean(lean: &FrameLean) -> Leaning {
    Leaning {
        survey: lean.survey.clone(),
        tilt: lean.written.clone(),
    }
}

fn of_stack_lean(lean: &SurveyedLean) -> Leaning {
    Leaning {
        survey: lean.survey.clone(),
        tilt: lean.written.clone(),
    }
}
