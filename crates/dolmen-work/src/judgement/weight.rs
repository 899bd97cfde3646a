//! Weight: does the structure stand under its own weight and the static loads in the file?

use super::colour::Colour;
use super::said::{WeightSaid, text};
use crate::stack::{SettledSimulation, SupportsSimulation};
use crate::state::{Check, State};
use dolmen::blocks::{LooseEnding, LooseMargin};
use dolmen::stability::Verdict;
use dolmen::stability::stack::MovedSupports;
use dolmen_words::Language;
use dolmen_words::message::Both;
use dolmen_words::number::beside_one;

/// Digits of a load factor in a headline.
const DIGITS: usize = 3;
/// Share of falling samples from which no version is called stable: codes require a thousandth of that in a year.
const FALLING_SHARE_MOST: f64 = 0.01;

/// The fixed words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Weight {
    /// It stands with a sufficient margin.
    Stable,
    /// It stands with a small margin.
    Marginal,
    /// It does not stand.
    Unstable,
    /// A necessary input is unknown, or a survey contradicts the model.
    Unknown {
        /// The load factor of the model that a survey contradicts.
        load_factor_if_right: Option<f64>,
    },
}

impl Weight {
    /// The word for one version of a structure, given the survey that contradicts it, if any.
    pub fn of(state: &State, is_contradicted: bool) -> Weight {
        let stuck = state.load_factor();
        let least = match state.slipping_load_factor() {
            Some(slipping) => stuck.map(|stuck| stuck.min(slipping)),
            None => stuck,
        };
        let of_loads = state.loads.as_ref().and_then(|loads| loads.factor());
        let least = match (least, of_loads) {
            (Some(least), Some(factor)) => Some(least.min(factor)),
            _ => least,
        };
        // limit / tilt determines the verdict on a tilt
        let limits = state
            .tilts
            .iter()
            .filter_map(|of| Some((of.uplift_tilt?, of.tilt)));
        let is_nan = limits.map(|(limit, tilt)| limit / tilt).any(f64::is_nan)
            || stuck.is_some_and(f64::is_nan)
            || of_loads.is_some_and(f64::is_nan);
        let verdict = match state.verdict() {
            Verdict::Stable
                if state
                    .falling_share()
                    .is_some_and(|share| share >= FALLING_SHARE_MOST) =>
            {
                Verdict::Marginal
            }
            verdict => verdict,
        };
        match (&state.check, is_nan) {
            (_, true) => Weight::of_verdict(Verdict::Unknown, least, false),
            // a stack keeps its word, because it depends on shapes and friction, and only its springs are contradicted
            (Check::Stack(_), false) => Weight::of_verdict(verdict, None, false),
            _ => Weight::of_verdict(verdict, least, is_contradicted),
        }
    }

    /// The word for a stack whose supports moved by the given amount and farther; never better than its word before, nor than that of its check.
    pub(super) fn of_supports(run: &SupportsSimulation, before: Option<Weight>) -> Weight {
        let verdict = match run.falls_at() {
            Some(factor) if factor < 1.0 => Verdict::Unstable,
            _ if !run.is_whole() => Verdict::Unknown,
            _ if run.runs.iter().any(|run| run.on_the_brink().is_some()) => Verdict::Marginal,
            Some(factor) if factor < MovedSupports::MARGINAL_BELOW => Verdict::Marginal,
            Some(_) | None => Verdict::Stable,
        };
        let of_run = [verdict, run.verdict].map(|of| Weight::of_verdict(of, None, false));
        let each = before.into_iter().chain(of_run);
        each.rev()
            .max_by_key(|weight| weight.colour())
            .unwrap_or(Weight::Stable)
    }

    /// The word for loose stones as they settle, without a motion: stable if all rest in their places by every law, and no small push moves them
    /// there; unstable if by every law some leave them, wherever they come to rest, or a stone is only balanced.
    pub(super) fn of_settled(run: &SettledSimulation) -> Weight {
        let all = |ending: LooseEnding| run.runs.iter().all(|run| run.settled.ending == ending);
        let verdict = match run.runs.is_empty() {
            true => Verdict::Unknown,
            false if all(LooseEnding::Fell) => Verdict::Unstable,
            false if all(LooseEnding::Stood) && !run.laws_differ() => match run.margin() {
                LooseMargin::Balanced => Verdict::Unstable,
                LooseMargin::Small => Verdict::Marginal,
                LooseMargin::Enough => Verdict::Stable,
                LooseMargin::Unknown => Verdict::Unknown,
            },
            false => Verdict::Unknown,
        };
        Weight::of_verdict(verdict, None, false)
    }

    /// The word for a verdict that depends on stiffness. A contradicted model is not certain to stand; one that falls stays unstable, because
    /// evidence against a model never improves its judgement.
    fn of_verdict(verdict: Verdict, load_factor: Option<f64>, is_contradicted: bool) -> Weight {
        let load_factor_if_right = load_factor.filter(|factor| is_contradicted && factor.is_finite());
        match verdict {
            Verdict::Unstable => Weight::Unstable,
            Verdict::Stable if !is_contradicted => Weight::Stable,
            Verdict::Marginal if !is_contradicted => Weight::Marginal,
            _ => Weight::Unknown { load_factor_if_right },
        }
    }

    /// The word for a model that starts plumb although its structure leans, and would not be stable with its lean: stable is unknown then.
    pub(super) fn if_it_stood_plumb(self) -> Weight {
        match self {
            Weight::Stable => Weight::Unknown {
                load_factor_if_right: None,
            },
            other => other,
        }
    }

    /// Its colour.
    pub fn colour(self) -> Colour {
        match self {
            Weight::Stable => Colour::Green,
            Weight::Marginal | Weight::Unknown { .. } => Colour::Amber,
            Weight::Unstable => Colour::Red,
        }
    }

    /// The fixed word.
    pub fn word(self, language: Language) -> &'static str {
        match self {
            Weight::Stable => language.pick("stable", "안정"),
            Weight::Marginal => language.pick("marginal", "여유 부족"),
            Weight::Unstable => language.pick("unstable", "불안정"),
            Weight::Unknown { .. } => language.pick("unknown", "판정 불가"),
        }
    }

    /// The word, with the value of the contradicted model: "unknown (1.95 if this model were right)".
    pub fn words(self, language: Language) -> String {
        match self {
            Weight::Unknown {
                load_factor_if_right: Some(factor),
            } => {
                let said = WeightSaid::IfRight {
                    word: Both::of(|language| self.word(language)),
                    load_factor: beside_one(factor, DIGITS),
                };
                text(said, language)
            }
            _ => self.word(language).to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_words_and_colours_follow_the_verdict_and_what_contradicts_it() {
        // verdict, λ, contradicted: word, colour
        for (verdict, factor, is_contradicted, words, colour) in [
            (Verdict::Stable, Some(1.95), false, "stable", Colour::Green),
            (Verdict::Marginal, Some(1.2), false, "marginal", Colour::Amber),
            (Verdict::Unstable, Some(0.9), false, "unstable", Colour::Red),
            (Verdict::Unknown, None, false, "unknown", Colour::Amber),
            (
                Verdict::Unknown,
                Some(f64::INFINITY),
                true,
                "unknown",
                Colour::Amber,
            ),
            (Verdict::Unknown, Some(f64::NAN), true, "unknown", Colour::Amber),
            (
                Verdict::Stable,
                Some(1.95),
                true,
                "unknown (1.95 if this model were right)",
                Colour::Amber,
            ),
            (
                Verdict::Marginal,
                Some(1.2),
                true,
                "unknown (1.20 if this model were right)",
                Colour::Amber,
            ),
            (Verdict::Unstable, Some(0.9), true, "unstable", Colour::Red),
        ] {
            let weight = Weight::of_verdict(verdict, factor, is_contradicted);
            assert_eq!(weight.words(Language::English), words, "{verdict:?} {factor:?}");
            assert_eq!(weight.colour(), colour, "{verdict:?} {factor:?}");
        }
        let contradicted = Weight::of_verdict(Verdict::Stable, Some(1.95), true);
        assert_eq!(
            contradicted.words(Language::Korean),
            "판정 불가(이 모델이 옳다면 1.95)"
        );
    }
}
