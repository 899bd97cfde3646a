//! The judgement of an answer: the three questions for the structure as it is and for each variant.

use super::colour::Colour;
use super::earthquake::{Earthquake, EarthquakeFinding, of_row, of_site};
use super::evidence::{Evidence, RecordFrequency};
use super::exit::{Verb, exit_status};
use super::runs::{of_simulation, of_stack};
use super::tilt_limit::tilt_beyond_limit;
use super::weight::Weight;
use super::wind::{WindFinding, WindWord, of_wind};
use crate::answer::{Answer, CheckAnswer};
use crate::building::{TogetherAnswer, TogetherChoice, TuneAnswer};
use crate::chain::ChainSimulation;
use crate::identify::lowest_of_records;
use crate::inventory::InventoryLine;
use crate::loads::Governing;
use crate::simulation::{SimulateAnswer, Simulation};
use crate::stack::StackSimulation;
use crate::state::{Check, State};
use crate::tilt_left_out::TiltLeftOut;
use dolmen::damper::Choice;
use dolmen_project::{Project, Structure, SurveyedLean};
use dolmen_words::Language;
use dolmen_words::message::Both;

/// The three questions for one version of a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct VersionJudgement {
    /// The variant; `None`: the structure as it is.
    pub variant: Option<String>,
    /// Does it stand; `None` where no model was checked.
    pub weight: Option<Weight>,
    /// What of wind and static loads makes the word for weight what it is, and the combination; `None` if its weight alone does.
    pub governed_by: Option<Governing>,
    /// Whether the word for weight is that under wind or static loads too.
    pub with_loads: bool,
    /// What an earthquake asks of it, one a demand, motion and part; empty where nothing is asked.
    pub earthquake: Vec<EarthquakeFinding>,
    /// What its wind makes of it against what the file allows, of a building; empty where nothing is limited.
    pub wind: Vec<WindFinding>,
    /// Is the model the structure.
    pub evidence: Evidence,
    /// What the site asks by: the code and the return period, years, if one was chosen; `None` without a site.
    pub demand_source: Option<(String, Option<u32>)>,
    /// A measured tilt that the model does not have.
    pub tilt_left_out: Option<TiltLeftOut>,
    /// Whether the last measured tilt is beyond the limit that the file sets.
    pub tilt_beyond_limit: bool,
    /// The measured tilt with which the model leans in what was judged, if it does.
    pub leans: Option<Leaning>,
    /// How many inputs nobody has measured.
    pub inputs: AssumedInputs,
}

/// A measured tilt that a model takes over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaning {
    /// The survey.
    pub survey: String,
    /// Direction and tilt as written: "x 1/177, y 1/540".
    pub tilt: String,
}

/// Inputs of a version.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AssumedInputs {
    /// Those that are assumed.
    pub assumed: usize,
    /// All.
    pub all: usize,
}

impl AssumedInputs {
    fn of(project: &Project) -> Self {
        let all = project.inputs();
        let defaults = match &project.structure {
            Structure::Stack(part) => part.joint_defaults().count(),
            _ => 0,
        };
        AssumedInputs {
            assumed: all.iter().filter(|input| input.is_assumed()).count() + defaults,
            all: all.len() + defaults,
        }
    }
}

/// The judgement of one project.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The structure as it is first, then its variants in the order of the file.
    pub versions: Vec<VersionJudgement>,
    /// Whether every run that was asked for came to its end.
    pub is_done: bool,
    /// Whether its surveys over the years leave an alarm open, or a tilt or crack beyond its limit.
    pub is_alarming: bool,
}

impl VersionJudgement {
    fn new(variant: Option<&str>, weight: Option<Weight>, evidence: Evidence) -> Self {
        VersionJudgement {
            variant: variant.map(str::to_owned),
            weight,
            governed_by: None,
            with_loads: false,
            earthquake: Vec::new(),
            wind: Vec::new(),
            evidence,
            demand_source: None,
            tilt_left_out: None,
            tilt_beyond_limit: false,
            leans: None,
            inputs: AssumedInputs::default(),
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
        let beyond = self.tilt_beyond_limit.then_some(Colour::Red);
        let left_out = self.tilt_left_out.as_ref().map(|_| Colour::Amber);
        Colour::worst(weight.into_iter().chain(others).chain(beyond).chain(left_out))
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

    /// The headline: the fixed words, the worst first, of equals in the order of the questions. Nothing is said of an earthquake
    /// that was not asked for, nor of evidence that does not contradict.
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
            let word = wind.word(language);
            let said = language.pick(format!("{word} in wind"), format!("풍응답 {word}"));
            words.push((wind.colour(), said));
        }
        if self.evidence.is_contradicted() {
            words.push((self.evidence.colour(), self.evidence.words(language)));
        }
        words.sort_by_key(|(colour, _)| std::cmp::Reverse(*colour));
        words.into_iter().map(|(_, words)| words).collect()
    }
}

impl Judgement {
    fn of_run(variant: Option<&str>, found: Vec<EarthquakeFinding>, is_done: bool) -> Self {
        let mut judgement = Judgement {
            versions: Vec::new(),
            is_done,
            is_alarming: false,
        };
        judgement.add(variant, found);
        judgement
    }

    /// Runs of one version each; a structure that does not stand without any shaking is unstable.
    fn add_runs(&mut self, simulated: &SimulateAnswer) {
        for run in &simulated.simulations {
            self.add_run(run, &simulated.evidence);
        }
        if simulated.does_not_stand.is_some() {
            let variant = simulated.variant.as_deref();
            self.versions.push(VersionJudgement::new(
                variant,
                Some(Weight::Unstable),
                Evidence::none(),
            ));
        }
    }

    fn add_run(&mut self, run: &Simulation, evidence: &Evidence) {
        let (mut found, is_done) = of_simulation(run);
        let is_as_it_is = run.variant().is_none();
        // a stack rests on shapes and friction, and a variant has no survey of its own
        if evidence.is_contradicted() && is_as_it_is && !matches!(run, Simulation::Stack(_)) {
            let of_model = found.into_iter();
            found = of_model.map(EarthquakeFinding::if_model_were_right).collect();
        }
        self.add(run.variant(), found);
        let mut versions = self.versions.iter_mut();
        if let Some(version) = versions.find(|of| of.variant.as_deref() == run.variant()) {
            version.leans = leaning(run).or(version.leans.take());
            if evidence.is_contradicted() && is_as_it_is {
                version.evidence = evidence.clone();
            }
        }
        self.is_done &= is_done;
        if let Simulation::Chain(run) = run {
            self.add_weight(run);
        }
    }

    /// A chain that falls without any shaking is unstable, whatever the motion did.
    fn add_weight(&mut self, run: &ChainSimulation) {
        let mut versions = self.versions.iter_mut();
        if run.falls_by_itself()
            && let Some(version) = versions.find(|version| version.variant == run.variant)
        {
            version.weight = Some(Weight::Unstable);
        }
    }

    /// The worst colour of all versions: that of banner, index and exit.
    pub fn colour(&self) -> Colour {
        let alarm = self.is_alarming.then_some(Colour::Red);
        Colour::worst(self.versions.iter().map(VersionJudgement::colour).chain(alarm))
    }

    /// The version that the headline judges: the structure as it is, else the first that was judged.
    pub fn headline(&self) -> Option<&VersionJudgement> {
        let mut versions = self.versions.iter();
        let as_it_is = versions.find(|version| version.variant.is_none());
        as_it_is.or(self.versions.first())
    }

    /// The variants that are worse than the headline.
    pub fn worse(&self) -> impl Iterator<Item = &VersionJudgement> {
        let headline = self.headline().map(VersionJudgement::colour);
        let variants = self.versions.iter().filter(|version| version.variant.is_some());
        variants.filter(move |version| Some(version.colour()) > headline)
    }

    /// The exit status of a verb that answered so.
    pub fn exit_status(&self, verb: Verb) -> u8 {
        exit_status(verb, self.colour(), self.is_done)
    }

    /// Adds what was found of a version, if it is one of those judged.
    fn add(&mut self, variant: Option<&str>, found: Vec<EarthquakeFinding>) {
        let version = self
            .versions
            .iter_mut()
            .find(|version| version.variant.as_deref() == variant);
        match version {
            Some(version) => version.earthquake.extend(found),
            None => {
                let mut version = VersionJudgement::new(variant, None, Evidence::none());
                version.earthquake = found;
                self.versions.push(version);
            }
        }
    }
}

/// The judgement of everything that was answered about one project.
///
/// A survey belongs to the structure as it is, so that variants have no evidence of their own. The file cannot say today
/// which survey a stiffness was identified from; once it can, that name goes into [`Evidence::of`].
pub fn judge(answers: &[Answer]) -> Judgement {
    let mut judgement = Judgement {
        versions: Vec::new(),
        is_done: true,
        is_alarming: false,
    };
    let found = answers.iter().find_map(|answer| match answer {
        Answer::Identify(identified) => Some(lowest_of_records(&identified.project, &identified.surveys)),
        _ => None,
    });
    for answer in answers {
        if let Answer::Check(checked) = answer {
            judgement
                .versions
                .extend(of_check(checked, &found.clone().unwrap_or_default()));
        }
    }
    for answer in answers {
        match answer {
            Answer::Simulate(simulated) => judgement.add_runs(simulated),
            Answer::Tune(tuned) => {
                for of in &tuned.tunings {
                    judgement.add(of.variant.as_deref(), of_tuned(of));
                }
                for of in &tuned.together {
                    judgement.add(of.variant.as_deref(), of_together(of));
                }
            }
            Answer::Watch(watched) => {
                let line = InventoryLine::watched(String::new(), watched);
                judgement.is_alarming |= line.is_alarming();
            }
            // judged above, or no verdict on a structure
            Answer::Check(_)
            | Answer::Identify(_)
            | Answer::Compare(_)
            | Answer::Study(_)
            | Answer::Score(_)
            | Answer::Rank(_)
            | Answer::Motion(_) => {}
        }
    }
    judgement
}

/// The versions of a check, each with its weight and what its site asks.
fn of_check(checked: &CheckAnswer, found: &[RecordFrequency]) -> Vec<VersionJudgement> {
    let as_it_is = checked.state.as_ref().map(|state| {
        // a survey belongs to the structure as it is
        let evidence = Evidence::with_records(&checked.project, &state.check, found);
        let mut version = version((None, &*checked.project), state, evidence);
        version.tilt_beyond_limit = tilt_beyond_limit(&checked.project).is_some();
        version
    });
    let own = |name: &str| checked.project.variants.iter().find(|own| own.name == name);
    let variants = checked.variants.iter().map(|variant| {
        let project = own(&variant.name).map_or(&*checked.project, |own| &own.project);
        version(
            (Some(variant.name.as_str()), project),
            &variant.state,
            Evidence::none(),
        )
    });
    as_it_is.into_iter().chain(variants).collect()
}

/// The judgement of a check alone.
pub fn judge_check(checked: &CheckAnswer) -> Judgement {
    Judgement {
        versions: of_check(checked, &[]),
        is_done: true,
        is_alarming: false,
    }
}

/// The judgement of simulations alone.
pub fn judge_simulation(simulated: &SimulateAnswer) -> Judgement {
    let mut judgement = Judgement {
        versions: Vec::new(),
        is_done: true,
        is_alarming: false,
    };
    judgement.add_runs(simulated);
    judgement
}

/// The judgement of one simulation, beside what surveys say of the model.
pub fn judge_run(run: &Simulation, evidence: &Evidence) -> Judgement {
    let mut judgement = Judgement {
        versions: Vec::new(),
        is_done: true,
        is_alarming: false,
    };
    judgement.add_run(run, evidence);
    judgement
}

/// The judgement of one simulated stack.
pub fn judge_stack_run(run: &StackSimulation) -> Judgement {
    let is_done = run.falls() || run.is_whole();
    Judgement::of_run(run.variant.as_deref(), of_stack(run), is_done)
}

fn version(
    (variant, project): (Option<&str>, &Project),
    state: &State,
    evidence: Evidence,
) -> VersionJudgement {
    let is_contradicted = evidence.is_contradicted();
    let weight = Weight::of(state, is_contradicted);
    let mut version = VersionJudgement::new(variant, Some(weight), evidence);
    version.earthquake = of_site(state);
    // a stack rests on shapes and friction
    if is_contradicted && !matches!(state.check, Check::Stack(_)) {
        let found = version.earthquake.into_iter();
        version.earthquake = found.map(EarthquakeFinding::if_model_were_right).collect();
    }
    version.wind = of_wind(project, state, is_contradicted);
    version.with_loads = state
        .loads
        .as_ref()
        .is_some_and(|loads| !loads.combinations.is_empty());
    version.governed_by = state.governing_loads().map(Governing::of);
    version.demand_source = state.demand.as_ref().map(|demand| {
        let site = &demand.site;
        (site.code().to_owned(), site.return_period_years())
    });
    version.leans = match &state.check {
        Check::Stack(answer) => answer.lean.as_ref().map(of_stack_lean),
        // what a chain is checked for, it is checked for upright
        _ => None,
    };
    version.tilt_left_out = TiltLeftOut::of_model(project);
    if matches!(&state.check, Check::Stack(answer) if !answer.stack.support_movements().is_empty()) {
        let of_before = version.earthquake.into_iter();
        version.earthquake = of_before.map(EarthquakeFinding::before_supports_moved).collect();
    }
    version.inputs = AssumedInputs::of(project);
    version
}

fn leaning(run: &Simulation) -> Option<Leaning> {
    match run {
        Simulation::Stack(runs) => runs.deciding.lean.as_ref().map(of_stack_lean),
        Simulation::Chain(run) => run.lean.as_ref().map(|lean| Leaning {
            survey: lean.survey.clone(),
            tilt: lean.written.clone(),
        }),
        Simulation::Frame(_) | Simulation::Building(_) => None,
    }
}

fn of_stack_lean(lean: &SurveyedLean) -> Leaning {
    Leaning {
        survey: lean.survey.clone(),
        tilt: lean.written.clone(),
    }
}

/// The damper as in the file against its room under the motions of the file and its site.
fn of_tuned(tuned: &TuneAnswer) -> Vec<EarthquakeFinding> {
    let row = |row: usize| tuned.comparison.rows.get(row).map(|row| row.choice);
    let given = tuned
        .room
        .strokes
        .iter()
        .filter(|of| row(of.row) == Some(Choice::Given));
    given.map(of_row).collect()
}

/// The same of all dampers at once.
fn of_together(tuned: &TogetherAnswer) -> Vec<EarthquakeFinding> {
    let row = |row: usize| tuned.rows.get(row).map(|row| &row.choice);
    let given = tuned
        .room
        .strokes
        .iter()
        .filter(|of| row(of.row) == Some(&TogetherChoice::Given));
    given.map(of_row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judgement::DecidedBy;

    fn version(variant: Option<&str>, weight: Weight, word: Earthquake) -> VersionJudgement {
        let mut version = VersionJudgement::new(variant, Some(weight), Evidence::none());
        version.earthquake = vec![EarthquakeFinding::new(word, DecidedBy::CodeDemand, None)];
        version
    }

    #[test]
    fn holds_words_stand_worst_first_and_the_worst_colour_decides_the_exit() {
        use Earthquake::{Above, BelowDemand, Near, NotAsked, NotDecided};
        let unknown = Weight::Unknown {
            load_factor_if_right: None,
        };
        for (weight, word, words, colour, exit) in [
            (Weight::Stable, NotAsked, "stable", Colour::Green, 0),
            (Weight::Stable, Above, "stable; above demand", Colour::Green, 0),
            (Weight::Stable, Near, "near demand; stable", Colour::Amber, 0),
            (
                Weight::Stable,
                BelowDemand,
                "below demand; stable",
                Colour::Red,
                1,
            ),
            (unknown, NotDecided, "unknown; not decided", Colour::Amber, 0),
            (
                Weight::Unstable,
                NotDecided,
                "unstable; not decided",
                Colour::Red,
                1,
            ),
            (
                Weight::Marginal,
                Above,
                "marginal; above demand",
                Colour::Amber,
                0,
            ),
        ] {
            let judgement = Judgement {
                versions: vec![version(None, weight, word)],
                is_done: true,
                is_alarming: false,
            };
            let headline = judgement.headline().map(|of| of.words(Language::English));
            assert_eq!(headline.unwrap_or_default().join("; "), words);
            assert_eq!(judgement.colour(), colour, "{words}");
            assert_eq!(judgement.exit_status(Verb::Check), exit, "{words}");
            assert_eq!(judgement.exit_status(Verb::Tune), 0, "{words}");
        }
    }

    #[test]
    fn holds_a_worse_variant_is_named_and_its_colour_is_that_of_the_whole() {
        let stable = |variant| version(variant, Weight::Stable, Earthquake::NotAsked);
        let falls = version(Some("loose"), Weight::Unstable, Earthquake::NotAsked);
        let judgement = Judgement {
            versions: vec![stable(None), stable(Some("wedged")), falls],
            is_done: true,
            is_alarming: false,
        };
        let worse: Vec<_> = judgement.worse().map(|of| of.variant.clone()).collect();
        assert_eq!(worse, [Some("loose".to_owned())]);
        assert_eq!(judgement.colour(), Colour::Red);
        assert_eq!(judgement.headline().map(|of| of.colour()), Some(Colour::Green));
        assert_eq!(judgement.exit_status(Verb::Report), 1);
    }

    #[test]
    fn holds_an_unfinished_run_is_3_unless_something_is_red() {
        for (word, exit) in [(Earthquake::NotDecided, 3), (Earthquake::BelowDemand, 1)] {
            let judgement = Judgement {
                versions: vec![version(None, Weight::Stable, word)],
                is_done: false,
                is_alarming: false,
            };
            assert_eq!(judgement.exit_status(Verb::Simulate), exit);
        }
        let nothing = Judgement {
            versions: Vec::new(),
            is_done: true,
            is_alarming: false,
        };
        assert_eq!(
            (nothing.colour(), nothing.exit_status(Verb::Check)),
            (Colour::Green, 0)
        );
    }
}
