//! Rows of the comparison of variants.

use super::variant_responses::SAME_SHARE;
use dolmen::assess::Probability;
use dolmen::stability::Verdict;
use dolmen::structure::lowest_frequency_hz;
use dolmen_words::Language;
use dolmen_words::message::Both;
use dolmen_work::judgement::{Earthquake, WindFinding};
use dolmen_work::loads::LoadsAnswer;
use dolmen_work::state::{Check, State};

/// One row: a variant, or one direction of it.
pub(super) struct Row {
    pub(super) name: Both,
    pub(super) direction: Option<String>,
    pub(super) load_factor: Option<f64>,
    /// Factor on wind and static loads at which a joint reaches its limit.
    pub(super) borne: Option<f64>,
    /// The same with wind and static loads.
    pub(super) verdict: Verdict,
    /// Verdict under its weight alone.
    pub(super) own_verdict: Verdict,
    pub(super) margins: Vec<Option<f64>>,
    pub(super) frequency_hz: Option<f64>,
    /// Samples that fall under their own weight.
    pub(super) falls: Option<Probability>,
    /// Share of samples that wind and static loads bring to a limit.
    pub(super) overloaded: Option<f64>,
    /// The demand of the site on the version, as a word and as capacity over demand; `None` without a demand.
    pub(super) earthquake: Option<(Earthquake, Option<f64>)>,
    /// The limit that decides in wind and under static loads; `None` without limits.
    pub(super) limited: Option<WindFinding>,
    /// That it is below the demand or beyond its limits, where the verdict hides it.
    pub(super) red_word: Option<Both>,
}

impl Row {
    pub(super) fn named(&self, language: Language) -> String {
        let name = language.pick(&self.name.english, &self.name.korean);
        match &self.direction {
            Some(direction) => format!("{name} · {direction}"),
            None => name.clone(),
        }
    }

    /// Whether the sentence on its loads tells its load factor as well: those of frames are told by direction.
    pub(super) fn is_told_with_loads(&self) -> bool {
        self.borne.is_some() && self.direction.is_none()
    }

    /// Whether its load factor is that of another row.
    pub(super) fn is_same(&self, other: &Row) -> bool {
        let both = self.load_factor.zip(other.load_factor);
        both.is_some_and(|(new, old)| (new / old - 1.0).abs() < SAME_SHARE)
    }

    /// `None` if no margin is known, `Some(None)` if a part falls for any stiffness.
    pub(super) fn least_margin(&self) -> Option<Option<f64>> {
        match self.margins.is_empty() {
            true => None,
            false if self.margins.iter().any(Option::is_none) => Some(None),
            false => Some(self.margins.iter().flatten().copied().min_by(f64::total_cmp)),
        }
    }
}

/// The rows of a version: one, or one a direction of a frame.
pub(super) fn rows(state: &State, name: &Both) -> Vec<Row> {
    let falls = state.sampled.as_ref().map(|sampled| sampled.unstable);
    let sampled = state.sampled.as_ref();
    let overloaded = sampled.and_then(|sampled| sampled.under_loads.as_ref().map(|of| of.estimate));
    match &state.check {
        Check::Chain(check) => {
            let across = check.across.as_ref();
            let stabilities = [
                check.stability.as_ref(),
                across.and_then(|of| of.stability.as_ref()),
            ];
            let joints = stabilities.iter().flatten().flat_map(|of| &of.joints);
            let modes = [Some(&check.modes), across.map(|of| &of.modes)];
            let lowest = modes
                .into_iter()
                .flatten()
                .filter_map(|of| lowest_frequency_hz(of));
            vec![Row {
                name: name.clone(),
                direction: None,
                load_factor: check.load_factor(),
                borne: state.loads.as_ref().and_then(|loads| loads.factor()),
                verdict: match &state.loads {
                    Some(_) => state.verdict(),
                    None => state.stability_verdict(),
                },
                own_verdict: state.stability_verdict(),
                margins: joints.map(|joint| joint.margin).collect(),
                frequency_hz: lowest.min_by(f64::total_cmp),
                falls,
                overloaded,
                earthquake: None,
                limited: None,
                red_word: None,
            }]
        }
        Check::Frame(directions) => directions
            .iter()
            .map(|of| {
                let stability = of.check.stability.as_ref();
                let storeys = stability.iter().flat_map(|of| &of.storeys);
                let own = stability.map_or(Verdict::Unknown, |of| of.verdict);
                let loads = state.loads.as_ref();
                let borne = loads.and_then(|loads| borne_along(loads, &of.direction));
                let is_unknown = loads.is_some_and(|loads| loads.lacks_resonance_at_hz().is_some());
                Row {
                    name: name.clone(),
                    direction: Some(of.direction.clone()),
                    load_factor: stability.map(|of| of.load_factor),
                    borne,
                    verdict: match borne.map(Verdict::of_load_factor) {
                        Some(Verdict::Unstable) => Verdict::Unstable,
                        Some(_) if is_unknown && own != Verdict::Unstable => Verdict::Unknown,
                        Some(Verdict::Marginal) if own == Verdict::Stable => Verdict::Marginal,
                        Some(_) | None => own,
                    },
                    own_verdict: own,
                    margins: storeys.map(|storey| storey.margin).collect(),
                    frequency_hz: lowest_frequency_hz(&of.check.modes),
                    falls,
                    overloaded,
                    earthquake: None,
                    limited: None,
                    red_word: None,
                }
            })
            .collect(),
        Check::Building(answer) => {
            let modes = answer.stands.as_ref().map(|standing| &standing.modes.modes);
            let mode = modes.and_then(|modes| modes.first());
            vec![Row {
                name: name.clone(),
                direction: None,
                load_factor: Some(answer.load_factor()),
                borne: None,
                verdict: Verdict::of_load_factor(answer.load_factor()),
                own_verdict: Verdict::of_load_factor(answer.load_factor()),
                margins: answer.falls.iter().map(|fall| Some(fall.load_factor)).collect(),
                frequency_hz: mode.map(|mode| mode.frequency_hz),
                falls,
                overloaded,
                earthquake: None,
                limited: None,
                red_word: None,
            }]
        }
        Check::Stack(answer) => vec![Row {
            falls,
            overloaded,
            ..of_stack(name, state, answer.check.verdict)
        }],
    }
}

/// The row of a stack, which has no load factor; without samples.
fn of_stack(name: &Both, state: &State, own_verdict: Verdict) -> Row {
    let borne = state.loads.as_ref().and_then(|loads| loads.factor());
    Row {
        name: name.clone(),
        direction: None,
        load_factor: None,
        borne: borne.filter(|factor| factor.is_finite()),
        verdict: state.verdict(),
        own_verdict,
        margins: Vec::new(),
        frequency_hz: None,
        falls: None,
        overloaded: None,
        earthquake: None,
        limited: None,
        red_word: None,
    }
}

/// Smallest factor on wind and static loads that a direction of a frame bears; `None` without loads that push it.
fn borne_along(loads: &LoadsAnswer, direction: &str) -> Option<f64> {
    let frames = loads.combinations.iter().filter_map(|of| of.frame());
    let own = frames
        .flat_map(|frame| &frame.directions)
        .filter(|own| own.direction == direction);
    let factors = own.filter_map(|own| Some(own.governing()?.1.under.factor));
    factors.filter(|factor| factor.is_finite()).reduce(f64::min)
}
