//! The judgement of an answer: the three questions for the structure as it is and for each variant.

use super::colour::Colour;
use super::earthquake::{Earthquake, EarthquakeFinding, of_row};
use super::evidence::Evidence;
use super::exit::{Verb, exit_status};
use super::in_doubt::FromRecords;
use super::runs::{RunFindings, of_row_run, of_simulation, of_stack};
use super::tilt_limit::{is_tilt_beyond, tilt_against_limit};
use super::version::{AfterMotion, VersionJudgement, leaning, version};
use super::weight::Weight;
use super::wind::of_wind_histories;
use crate::answer::{Answer, CheckAnswer, CompareAnswer};
use crate::building::{RoomCheck, TogetherAnswer, TogetherChoice, TuneAnswer};
use crate::frame::FrameBeside;
use crate::inspected::inspected_beyond;
use crate::inventory::InventoryLine;
use crate::lowest_of_records::lowest_of_records;
use crate::simulation::{AfterFirst, SimulateAnswer, Simulation};
use crate::stack::StackSimulation;
use crate::survey_doubts::survey_doubts;
use crate::watched::WatchAnswer;
use dolmen::assess::ModeChange;
use dolmen::damper::Choice;
use dolmen_project::Project;

/// The judgement of one project.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The structure as it is first, then its variants in the order of the file.
    pub versions: Vec<VersionJudgement>,
    /// Whether every requested run is complete.
    pub is_done: bool,
    /// Open findings of its surveys over the years.
    pub alarming: Alarming,
    /// Frequencies that changed beyond chance from the first to the last survey.
    pub changed: Option<ChangedSince>,
}

/// Frequencies that changed beyond chance from one survey to another.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedSince {
    /// The earlier survey.
    pub from: String,
    /// The later survey.
    pub to: String,
    /// Number of changed frequencies.
    pub changed: usize,
    /// Number of compared frequencies.
    pub tested: usize,
    /// Whether the weather may be the reason: the temperatures or their effect are unknown, and no change is too large for their difference.
    pub may_be_weather: bool,
}

/// Largest temperature coefficient of a frequency, relative per °C, that weather may have. Our choice.
const PER_C_MOST: f64 = 0.01;

/// Whether no weather explains a change: it would take a larger coefficient.
fn beyond_weather(mode: &ModeChange) -> bool {
    mode.explaining_per_c
        .is_some_and(|per_c| per_c.abs() > PER_C_MOST)
}

impl ChangedSince {
    fn of(compared: &CompareAnswer) -> Option<ChangedSince> {
        let change = compared.change.as_ref()?;
        let changed = change.changed().count();
        // surveys that nobody measured are no evidence
        let both = [&compared.from, &compared.to];
        let mut surveys = compared.project.surveys.iter();
        let is_made_up = surveys.any(|survey| survey.is_made_up && both.contains(&&survey.name));
        (changed > 0 && !is_made_up).then(|| ChangedSince {
            from: compared.from.clone(),
            to: compared.to.clone(),
            changed,
            tested: change.tested(),
            may_be_weather: change.temperature.leaves_doubt() && !change.changed().any(beyond_weather),
        })
    }
}

/// Findings of the surveys over the years that require an inspection.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alarming {
    /// Alarms without a later repair or inspection.
    pub open_alarms: usize,
    /// Whether a tilt is beyond its limit.
    pub is_tilt_beyond: bool,
    /// Cracks and other damage beyond their limits.
    pub cracks_beyond: usize,
}

impl Alarming {
    fn of(watched: &WatchAnswer) -> Self {
        let history = InventoryLine::watched(String::new(), watched).history;
        history.map_or_else(Alarming::default, |history| Alarming {
            open_alarms: history.open_alarms,
            is_tilt_beyond: history.is_tilt_beyond,
            cracks_beyond: history.cracks_beyond,
        })
    }

    /// Of a project without a model: its surveyed tilt and damage. A version of a model counts them in its own colour.
    fn without_model(checked: &CheckAnswer) -> Self {
        Alarming {
            is_tilt_beyond: checked.state.is_none() && is_tilt_beyond(&checked.project),
            cracks_beyond: match checked.state {
                None => damage_beyond(&checked.project),
                Some(_) => 0,
            },
            ..Alarming::default()
        }
    }

    /// Both findings together.
    fn and(self, other: Alarming) -> Self {
        Alarming {
            open_alarms: self.open_alarms.max(other.open_alarms),
            is_tilt_beyond: self.is_tilt_beyond || other.is_tilt_beyond,
            cracks_beyond: self.cracks_beyond.max(other.cracks_beyond),
        }
    }

    /// Whether there is any.
    pub fn is_any(&self) -> bool {
        *self != Alarming::default()
    }
}

impl Judgement {
    fn empty() -> Self {
        Judgement {
            versions: Vec::new(),
            is_done: true,
            alarming: Alarming::default(),
            changed: None,
        }
    }

    fn of_run(variant: Option<&str>, found: Vec<EarthquakeFinding>, is_done: bool) -> Self {
        let mut judgement = Judgement {
            is_done,
            ..Judgement::empty()
        };
        judgement.add(variant, found);
        judgement
    }

    /// Runs of one version each; a structure that does not stand even without shaking is unstable.
    fn add_runs(&mut self, simulated: &SimulateAnswer) {
        for run in &simulated.simulations {
            self.add_run(run, simulated);
        }
        if simulated.does_not_stand.is_some() {
            let variant = simulated.variant.as_deref();
            let mut version = VersionJudgement::new(variant, Some(Weight::Unstable), Evidence::none());
            version.damage.clone_from(&simulated.damage);
            version.basis = simulated.basis.clone().unwrap_or_default();
            self.versions.push(version);
        }
    }

    fn add_run(&mut self, run: &Simulation, of: &SimulateAnswer) {
        let RunFindings {
            findings: mut found,
            is_done,
        } = of_simulation(run);
        let is_as_it_is = run.variant().is_none();
        found.extend(worse_after_first(of, &found));
        // the results of a check of the same structure are used as well
        let checked = self.versions.iter().find(|version| version.variant.is_none());
        let checked = checked.map(|version| version.evidence.clone());
        let evidence = &checked
            .filter(Evidence::is_doubted)
            .unwrap_or_else(|| of.evidence.clone());
        // runs depend on stiffness, including those of stacks; a variant has no survey of its own
        if evidence.is_contradicted() && is_as_it_is {
            let of_model = found.into_iter();
            found = of_model.map(EarthquakeFinding::if_model_were_right).collect();
        }
        if let Simulation::Frame(run) = run
            && run.beside.as_ref().is_some_and(FrameBeside::differs)
        {
            let of_model = found.into_iter();
            found = of_model.map(EarthquakeFinding::if_model_were_right).collect();
        }
        if let Some(left) = of.drift_left {
            let plumb = found.into_iter();
            found = plumb.map(|found| found.with_drift_left(left)).collect();
        }
        self.add(run.variant(), found);
        let mut versions = self.versions.iter_mut();
        if let Some(version) = versions.find(|of| of.variant.as_deref() == run.variant()) {
            if let Simulation::Stack(runs) = run {
                version.tilt_left_out = runs
                    .deciding
                    .tilt_left_out
                    .clone()
                    .or(version.tilt_left_out.take());
            }
            version.tilt_left_out = version.tilt_left_out.take().or_else(|| of.tilt_left_out.clone());
            // a run that starts plumb lacks the tilt that the check counts
            let of_check = version.leans.take();
            let left_out = version.tilt_left_out.as_ref().map(|of| &of.survey);
            version.leans = leaning(run).or(of_check.filter(|of| Some(&of.survey) != left_out));
            version.is_undamped |= run.is_undamped();
            if !of.damage.is_empty() {
                version.damage.clone_from(&of.damage);
            }
            if let Some(basis) = &of.basis {
                version.basis.clone_from(basis);
            }
            version.after = after_motion(of);
            version.tilt_beyond_limit |= is_as_it_is && of.tilt_beyond_limit;
            let is_contradicted = evidence.is_contradicted() && is_as_it_is;
            if let Simulation::Wind(run) = run {
                version.wind = of_wind_histories(run, is_contradicted);
            }
            if evidence.is_doubted() && is_as_it_is {
                version.evidence = evidence.clone();
            }
            // a chain that falls without any shaking is unstable, whatever happens under the motion
            version.weight = match run {
                Simulation::Chain(run) if run.falls_by_itself() => {
                    version.governed_by = of.without_shaking.as_ref().and_then(|of| of.governed_by.clone());
                    Some(Weight::Unstable)
                }
                Simulation::Supports(run) => {
                    let found = of.without_shaking.as_ref().filter(|_| version.weight.is_none());
                    let before = found.map(|of| of.weight).or(version.weight);
                    let weight = Weight::of_supports(run, before);
                    // the run decides if it is worse
                    if let Some(found) = found.filter(|of| of.weight == weight) {
                        version.governed_by.clone_from(&found.governed_by);
                    }
                    version.with_loads |= !run.stack.static_loads().is_empty();
                    Some(weight)
                }
                Simulation::Settled(run) => Some(Weight::of_settled(run)),
                // evidence against a model never improves its judgement
                _ if version.weight.is_none() => {
                    let found = of.without_shaking.as_ref();
                    let found = found.filter(|of| !is_contradicted || of.weight == Weight::Unstable);
                    version.governed_by = found.and_then(|of| of.governed_by.clone());
                    found.map(|of| of.weight)
                }
                _ => version.weight,
            };
        }
        self.is_done &= is_done;
    }

    /// The worst colour of all versions, for banner, index and exit status.
    pub fn colour(&self) -> Colour {
        let alarm = self.alarming.is_any().then_some(Colour::Red);
        let changed = self.changed.as_ref().filter(|of| !of.may_be_weather);
        let over_the_years = alarm.into_iter().chain(changed.map(|_| Colour::Amber));
        Colour::worst(
            self.versions
                .iter()
                .map(VersionJudgement::colour)
                .chain(over_the_years),
        )
    }

    /// The version in the headline: the structure as it is, otherwise the first one.
    pub fn headline(&self) -> Option<&VersionJudgement> {
        let mut versions = self.versions.iter();
        let as_it_is = versions.find(|version| version.variant.is_none());
        as_it_is.or(self.versions.first())
    }

    /// The variants that are worse than the headline.
    pub fn worse(&self) -> impl Iterator<Item = &VersionJudgement> {
        let headline = self.headline();
        let variants = self.versions.iter().filter(|version| version.variant.is_some());
        variants.filter(move |version| headline.is_none_or(|of| version.is_worse_than(of)))
    }

    /// The exit status of a verb with this judgement.
    pub fn exit_status(&self, verb: Verb) -> u8 {
        exit_status(verb, self.colour(), self.is_done)
    }

    /// Adds a finding for a version, if the judgement has it.
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

/// The judgement of all answers about one project.
///
/// A survey belongs to the structure as it is, so variants have no evidence of their own.
pub fn judge(answers: &[Answer]) -> Judgement {
    let mut judgement = Judgement::empty();
    let found = answers.iter().find_map(|answer| match answer {
        Answer::Identify(identified) => {
            let (project, surveys) = (&identified.project, &identified.surveys);
            Some(FromRecords {
                lowest: lowest_of_records(project, surveys),
                doubts: survey_doubts(project, surveys),
            })
        }
        _ => None,
    });
    for answer in answers {
        if let Answer::Check(checked) = answer {
            judgement
                .versions
                .extend(of_check(checked, &found.clone().unwrap_or_default()));
            judgement.alarming = Alarming::without_model(checked);
        }
    }
    for answer in answers {
        match answer {
            Answer::Simulate(simulated) => judgement.add_runs(simulated),
            Answer::Tune(tuned) => {
                // a single damper out of several does not represent the structure of the file
                for of in tuned.tunings.iter().filter(|of| of.others == 0) {
                    judgement.add(of.variant.as_deref(), of_tuned(of));
                }
                for of in &tuned.together {
                    judgement.add(of.variant.as_deref(), of_together(of));
                }
            }
            Answer::Watch(watched) => {
                judgement.alarming = judgement.alarming.and(Alarming::of(watched));
            }
            Answer::Compare(compared) => judgement.changed = ChangedSince::of(compared),
            // included above, or without a verdict on the structure
            Answer::Check(_)
            | Answer::Identify(_)
            | Answer::Study(_)
            | Answer::Score(_)
            | Answer::Rank(_)
            | Answer::Motion(_) => {}
        }
    }
    judgement
}

/// Names of both motions, if the second acted after the first.
fn after_motion(of: &SimulateAnswer) -> Option<AfterMotion> {
    let after = of.after.as_ref()?;
    after.second.began_at_rest().map(|_| AfterMotion {
        first: after.first_motion.clone(),
        second: after.second_motion.clone(),
    })
}

/// What the first of two motions did alone, if it is worse: joints that the second closes were open.
fn worse_after_first(of: &SimulateAnswer, found: &[EarthquakeFinding]) -> Vec<EarthquakeFinding> {
    let began = |of: &&AfterFirst| of.second.began_at_rest().is_some();
    let first = of.after.as_deref().filter(began);
    let runs = first.iter().flat_map(|of| &of.first.simulations);
    let alone: Vec<_> = runs.flat_map(|run| of_simulation(run).findings).collect();
    match Earthquake::worst(&alone) > Earthquake::worst(found) {
        true => alone,
        false => Vec::new(),
    }
}

/// Damages of inspections beyond their limits.
fn damage_beyond(project: &Project) -> usize {
    inspected_beyond(project).map_or(0, |found| found.beyond().count())
}

/// The versions of a check, each with its weight and its demand.
fn of_check(checked: &CheckAnswer, found: &FromRecords) -> Vec<VersionJudgement> {
    let as_it_is = checked.state.as_ref().map(|state| {
        // a survey belongs to the structure as it is
        let evidence = Evidence::with_records(&checked.project, &state.check, found);
        let mut version = version((None, &*checked.project), state, evidence);
        version.tilt_beyond_limit = is_tilt_beyond(&checked.project);
        let against = tilt_against_limit(&checked.project);
        version.tilt_near_limit = !version.tilt_beyond_limit && against.is_some_and(|of| of.is_near());
        version.damage_beyond_limit = damage_beyond(&checked.project);
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
        versions: of_check(checked, &FromRecords::default()),
        alarming: Alarming::without_model(checked),
        ..Judgement::empty()
    }
}

/// The judgement of simulations alone.
pub fn judge_simulation(simulated: &SimulateAnswer) -> Judgement {
    let mut judgement = Judgement::empty();
    judgement.add_runs(simulated);
    judgement
}

/// The judgement of one simulation of an answer.
pub fn judge_run(run: &Simulation, of: &SimulateAnswer) -> Judgement {
    let mut judgement = Judgement::empty();
    judgement.add_run(run, of);
    judgement
}

/// The judgement of one simulated stack.
pub fn judge_stack_run(run: &StackSimulation) -> Judgement {
    let is_done = run.falls() || run.is_whole();
    Judgement::of_run(run.variant.as_deref(), of_stack(run), is_done)
}

/// The building with the damper in the file under the motions of the file and the spectrum of its site.
fn of_tuned(tuned: &TuneAnswer) -> Vec<EarthquakeFinding> {
    let row = |row: usize| tuned.comparison.rows.get(row).map(|row| row.choice);
    of_rows(&tuned.room, |of| row(of) == Some(Choice::Given))
}

/// The same for all dampers together.
fn of_together(tuned: &TogetherAnswer) -> Vec<EarthquakeFinding> {
    let row = |row: usize| tuned.rows.get(row).map(|row| &row.choice);
    of_rows(&tuned.room, |of| row(of) == Some(&TogetherChoice::Given))
}

/// Under the motions of the file, drifts and strokes decide together, as in a simulation. Under the spectrum of the site, a check judges the
/// drifts, so a stroke within its room decides nothing.
fn of_rows(room: &RoomCheck, is_given: impl Fn(usize) -> bool) -> Vec<EarthquakeFinding> {
    let runs = room.runs.iter().filter(|of| is_given(of.row));
    let at_site = room.strokes.iter().filter(|of| of.motion.is_none());
    let at_site = at_site.filter(|of| is_given(of.row)).map(of_row);
    let short = at_site.filter(|of| of.word != Earthquake::Above);
    runs.flat_map(of_row_run).chain(short).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::building::{RowRun, RowStroke};
    use crate::judgement::DecidedBy;
    use crate::part_limit::{Limited, Part, PartLimit};
    use dolmen_words::Language;

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
                ..Judgement::empty()
            };
            let headline = judgement.headline().map(|of| of.words(Language::English));
            assert_eq!(headline.unwrap_or_default().join("; "), words);
            assert_eq!(judgement.colour(), colour, "{words}");
            assert_eq!(judgement.exit_status(Verb::Check), exit, "{words}");
            assert_eq!(judgement.exit_status(Verb::Tune), 0, "{words}");
        }
    }

    #[test]
    fn holds_a_stroke_within_its_room_alone_never_meets_a_demand() {
        let part = |limited, demand, capacity| PartLimit {
            part: Part::Damper("tmd".into()),
            direction: None,
            limited,
            demand,
            capacity,
            taken: 0.0,
            lean: [0.0; 2],
        };
        let stroke = |motion: Option<&str>, stroke_m| RowStroke {
            row: 0,
            damper: "tmd".into(),
            motion: motion.map(str::to_owned),
            stroke_m,
            room_m: 0.6,
        };
        for (allowed, stroke_m, word) in [
            (None, 0.378, Earthquake::NotDecided),
            (None, 0.61, Earthquake::BelowDemand),
            (Some(0.002), 0.378, Earthquake::BelowDemand),
            (Some(0.02), 0.378, Earthquake::Above),
        ] {
            let drift = part(Limited::Drift, 0.00377, allowed);
            let room = RoomCheck {
                has_room: true,
                is_judged: true,
                strokes: vec![stroke(Some("ec"), stroke_m), stroke(None, stroke_m)],
                runs: vec![RowRun {
                    row: 0,
                    motion: "ec".into(),
                    parts: vec![drift, part(Limited::Room, stroke_m, Some(0.6))],
                    falls: false,
                }],
                ..RoomCheck::default()
            };
            let found = of_rows(&room, |row| row == 0);
            assert_eq!(Earthquake::worst(&found), word, "{found:?}");
            // another row is not the structure
            assert!(of_rows(&room, |row| row == 1).is_empty());
        }
        // under the spectrum of the site, the check judges the drifts
        let room = RoomCheck {
            strokes: vec![stroke(None, 0.3)],
            ..RoomCheck::default()
        };
        assert!(of_rows(&room, |_| true).is_empty());
    }

    #[test]
    fn holds_a_worse_variant_is_named_and_its_colour_is_that_of_the_whole() {
        let stable = |variant| version(variant, Weight::Stable, Earthquake::NotAsked);
        let falls = version(Some("loose"), Weight::Unstable, Earthquake::NotAsked);
        let judgement = Judgement {
            versions: vec![stable(None), stable(Some("wedged")), falls],
            ..Judgement::empty()
        };
        let worse: Vec<_> = judgement.worse().map(|of| of.variant.clone()).collect();
        assert_eq!(worse, [Some("loose".to_owned())]);
        assert_eq!(judgement.colour(), Colour::Red);
        assert_eq!(judgement.headline().map(|of| of.colour()), Some(Colour::Green));
        assert_eq!(judgement.exit_status(Verb::Report), 1);
    }

    #[test]
    fn holds_a_variant_that_does_not_stand_is_worse_than_a_structure_below_demand() {
        let of = |variant, weight, word| version(variant, weight, word);
        let judgement = Judgement {
            versions: vec![
                of(None, Weight::Stable, Earthquake::BelowDemand),
                of(Some("thin"), Weight::Unstable, Earthquake::BelowDemand),
                of(Some("thick"), Weight::Stable, Earthquake::Near),
            ],
            ..Judgement::empty()
        };
        let worse: Vec<_> = judgement.worse().map(|of| of.variant.clone()).collect();
        assert_eq!(worse, [Some("thin".to_owned())]);
    }

    #[test]
    fn holds_an_unfinished_run_is_3_unless_something_is_red() {
        for (word, exit) in [(Earthquake::NotDecided, 3), (Earthquake::BelowDemand, 1)] {
            let judgement = Judgement {
                versions: vec![version(None, Weight::Stable, word)],
                is_done: false,
                ..Judgement::empty()
            };
            assert_eq!(judgement.exit_status(Verb::Simulate), exit);
        }
        let nothing = Judgement { ..Judgement::empty() };
        assert_eq!(
            (nothing.colour(), nothing.exit_status(Verb::Check)),
            (Colour::Green, 0)
        );
    }

    #[test]
    fn holds_a_change_beyond_chance_is_never_green_unless_the_weather_may_be_its_reason() {
        let changed = |may_be_weather| Judgement {
            versions: vec![version(None, Weight::Stable, Earthquake::Above)],
            changed: Some(ChangedSince {
                from: "2024-03-05".to_owned(),
                to: "2026-03-07".to_owned(),
                changed: 2,
                tested: 4,
                may_be_weather,
            }),
            ..Judgement::empty()
        };
        assert_eq!(changed(false).colour(), Colour::Amber);
        assert_eq!(changed(true).colour(), Colour::Green);
        assert_eq!(changed(false).exit_status(Verb::Report), 0);
    }
}
