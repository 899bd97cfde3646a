//! Words for stacks: names of joints, directions of motion, the first motion.

use dolmen::assess::{StackCheck, StackNote};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{Governing, LimitKind, StackLimitStates, Threshold};
use dolmen_words::message::Run;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::VariantAnswer;

/// Digits of an acceleration, a margin or a distance.
pub(super) const DIGITS: usize = 3;

messages! {
    /// Parts of sentences on stacks.
    pub(crate) enum Words in "stack.words" {
        Value { value: Quantity } => { en: "{value}", ko: "{value}" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        NameAndMore { name: String, more: usize } => { en: "{name} and {more} more", ko: "{name} 외 {more}개" },
        Ground => { en: "the ground", ko: "지반" },
        GroundAnd { names: String } => { en: "the ground, {names}", ko: "지반, {names}" },
        Rocks { above: Sentence, direction: Sentence } => {
            en: "what stands on {above} rocks towards {direction}",
            ko: "{above} 위의 부분이 {direction} 방향으로 흔들린다(로킹)",
        },
        Slides { above: Sentence, direction: Sentence } => {
            en: "what stands on {above} slides towards {direction}",
            ko: "{above} 위의 부분이 {direction} 방향으로 미끄러진다",
        },
        Together { direction: Sentence } => {
            en: "several stones move together towards {direction} [limit-analysis]",
            ko: "여러 부재가 {direction} 방향으로 함께 움직인다 [limit-analysis]",
        },
        Stable => { en: "stable", ko: "안정" },
        Marginal => { en: "marginal", ko: "여유 부족" },
        Unstable => { en: "unstable", ko: "불안정" },
        Unknown => { en: "unknown", ko: "판정 불가" },
    }
}

/// A strength or a pressure of stone.
pub(crate) fn megapascals(stress_pa: f64) -> Quantity {
    let unit = Unit {
        symbol: "MPa".to_owned(),
        factor: 1e-6,
    };
    Quantity::new(stress_pa, unit, Digits::Significant(DIGITS))
}

/// An acceleration over gravity.
pub(super) fn in_g(acceleration_g: f64) -> Quantity {
    Quantity::new(
        known_g(acceleration_g),
        Unit::si("g"),
        Digits::Significant(DIGITS),
    )
}

/// Largest error of a limit analysis, over gravity: what is smaller is 0.
const LIMIT_ERROR_G: f64 = 1e-6;

/// An acceleration over gravity, 0 if it is only an error of the limit analysis.
pub(super) fn known_g(acceleration_g: f64) -> f64 {
    match acceleration_g.abs() < LIMIT_ERROR_G {
        true => 0.0,
        false => acceleration_g,
    }
}

/// A number alone.
pub(super) fn value(value: Quantity) -> Sentence {
    Words::Value { value }.into()
}

/// An acceleration in units of gravity; ∞ if no acceleration reaches it.
pub(super) fn at(threshold: &Threshold) -> Sentence {
    match threshold.acceleration_g.is_finite() {
        true => Words::Value {
            value: in_g(threshold.acceleration_g),
        }
        .into(),
        false => Sentence::of_symbol("∞"),
    }
}

/// A margin, or a dash if there is none.
pub(super) fn margin(margin: Option<f64>) -> Sentence {
    let value = |margin| Words::Value {
        value: Quantity::ratio(margin, DIGITS),
    };
    margin.map_or_else(|| Sentence::of_symbol("–"), |margin| value(margin).into())
}

/// Stones below a joint from which on only the first is named.
const NAMES_MANY: usize = 3;

/// Name of a joint: that of the part below it; of many stones the first one and the number of others.
pub(crate) fn place(above: &str) -> Sentence {
    let name = above.replace('\'', "");
    let all: Vec<&str> = name.split(", ").collect();
    if let [first, more @ ..] = all.as_slice()
        && all.len() >= NAMES_MANY
        && *first != "the ground"
    {
        let (name, more) = ((*first).to_owned(), more.len());
        return Words::NameAndMore { name, more }.into();
    }
    match name.strip_prefix("the ground") {
        Some("") => Words::Ground.into(),
        Some(rest) => match rest.strip_prefix(", ") {
            Some(names) => Words::GroundAnd { names: names.into() }.into(),
            None => Words::Name { name }.into(),
        },
        None => Words::Name { name }.into(),
    }
}

/// "+x", "-y", or whole degrees from +x towards +y.
pub(crate) fn direction(of: [f64; 2]) -> Sentence {
    let [x, y] = of;
    match y.atan2(x).to_degrees().round() as i32 {
        0 => Sentence::of_symbol("+x"),
        90 => Sentence::of_symbol("+y"),
        180 | -180 => Sentence::of_symbol("-x"),
        -90 => Sentence::of_symbol("-y"),
        degrees => Sentence::of_symbol(&format!("{degrees}°")),
    }
}

/// The acceleration at which several stones move together, if that is lower than for any single joint.
pub(super) fn moves_together(check: &StackCheck) -> Option<Threshold> {
    let lower = |note: &StackNote| matches!(note, StackNote::AnalysisLower { .. });
    check.capacity.filter(|_| check.notes.iter().any(lower))
}

/// "what stands on block 4 rocks towards +x".
pub(super) fn joint_moves(limits: &StackLimitStates, first: &Governing) -> Sentence {
    let above = limits.cuts.get(first.cut).map_or("", |cut| &cut.above);
    let (above, direction) = (place(above), direction(first.threshold.direction));
    match first.kind {
        LimitKind::Uplift => Words::Rocks { above, direction }.into(),
        LimitKind::Sliding => Words::Slides { above, direction }.into(),
    }
}

/// The first motion with every tie at its strength, if ties help.
pub(super) fn first_with_ties(limits: &StackLimitStates) -> Option<&Governing> {
    let (with, without) = (limits.governing_with_ties.as_ref()?, limits.governing.as_ref()?);
    (with.threshold.acceleration_g > without.threshold.acceleration_g).then_some(with)
}

/// Parts that ties hold, with every tie at its strength, where stones share their load and no cut governs alone.
pub(super) fn parts_with_ties(limits: &StackLimitStates) -> Vec<(Governing, Threshold)> {
    let sooner = |cut: usize, uplift: Option<Threshold>, sliding: Option<Threshold>| {
        let of = |kind: LimitKind, found: Option<Threshold>| {
            found.map(|threshold| Governing { kind, cut, threshold })
        };
        let both = [of(LimitKind::Uplift, uplift), of(LimitKind::Sliding, sliding)];
        let both = both.into_iter().flatten();
        both.min_by(|a, b| a.threshold.acceleration_g.total_cmp(&b.threshold.acceleration_g))
    };
    let each = limits.cuts.iter().enumerate().filter_map(|(index, cut)| {
        let with = sooner(index, cut.uplift_with_ties, cut.sliding_with_ties)?;
        let without = sooner(index, cut.uplift, cut.sliding)?.threshold;
        (with.threshold.acceleration_g > without.acceleration_g).then_some((with, without))
    });
    match limits.statically_determinate {
        true => Vec::new(),
        false => each.collect(),
    }
}

pub(super) fn verdict_word(verdict: Verdict) -> Words {
    match verdict {
        Verdict::Stable => Words::Stable,
        Verdict::Marginal => Words::Marginal,
        Verdict::Unstable => Words::Unstable,
        Verdict::Unknown => Words::Unknown,
    }
}

/// The user's name of a variant in each language.
pub(super) fn title(variant: &VariantAnswer) -> Sentence {
    let run = |name: &str| vec![Run::Name(name.to_owned())];
    let named = |english, korean| Sentence::of_runs("name", run(english), run(korean));
    match &variant.title {
        Some(names) => named(names.english(), names.korean()),
        None => named(&variant.name, &variant.name),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_words::Language;

    #[test]
    fn exact_directions_have_the_names_of_axes_or_degrees() {
        let english = |of| direction(of).text(Language::English);
        assert_eq!(english([1.0, 0.0]), "+x");
        assert_eq!(english([0.0, -1.0]), "-y");
        let half = 0.5f64.sqrt();
        assert_eq!(english([-half, half]), "135°");
    }

    #[test]
    fn exact_a_joint_is_called_by_what_is_below_it() {
        let korean = |above| place(above).text(Language::Korean);
        assert_eq!(korean("the ground"), "지반");
        assert_eq!(korean("the ground, 'post a'"), "지반, post a");
        assert_eq!(korean("'post a', 'post b'"), "post a, post b");
    }
}
