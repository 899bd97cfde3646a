//! Responses of a variant other than its load factor: to the earthquake of the site, to wind, static loads and combinations.

use dolmen::stability::Verdict;
use dolmen_words::message::Both;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::judgement::{Colour, Earthquake, MovedBy, VersionJudgement, Weight, WindFinding, WindLimit};

/// Relative difference below which values are equal.
pub(super) const SAME_SHARE: f64 = 1e-6;
/// Digits of a ratio.
const DIGITS: usize = 3;

messages! {
    /// What a variant responds to, and how the response changes.
    pub(crate) enum Responses in "check.variant-responses" {
        Earthquake => { en: "under the earthquake of the site capacity/demand", ko: "부지의 지진에 대한 저항/요구" },
        Wind => { en: "in the wind limit/response", ko: "바람에 대한 허용값/응답" },
        Loads => { en: "under static loads limit/response", ko: "정하중에 대한 허용값/응답" },
        WindAndLoads => { en: "under wind and static loads limit/response", ko: "풍하중·정하중에 대한 허용값/응답" },
        WithEarthquake => {
            en: "in combinations with the earthquake limit/response",
            ko: "지진을 포함한 하중조합에 대한 허용값/응답",
        },
        Goes { what: Sentence, before: Quantity, after: Quantity } => {
            en: "{what} goes from {before} to {after}",
            ko: "{what}이(가) {before}에서 {after}(으)로 바뀐다",
        },
        GoesBeyond { what: Sentence, before: Quantity, after: Quantity, word: Both } => {
            en: "{what} goes from {before} to {after}, {word}",
            ko: "{what}이(가) {before}에서 {after}(으)로 바뀐다({word})",
        },
        Is { what: Sentence, after: Quantity, word: Both } => {
            en: "{what} is {after}, {word}",
            ko: "{what}은(는) {after}이다({word})",
        },
        OfVariant { variant: Both, said: Sentence } => {
            en: "Variant “{variant}”: {said}.",
            ko: "대안 ‘{variant}’: {said}.",
        },
        SameFactor { variant: Both, said: Sentence, factor: Quantity, verdict: Both } => {
            en: "Variant “{variant}”: {said}; the load factor stays {factor}: {verdict}.",
            ko: "대안 ‘{variant}’: {said}. 하중배율은 {factor}(으)로 같다: {verdict}.",
        },
        Acceleration => { en: "acceleration", ko: "가속도" },
        Drift => { en: "drift", ko: "층간변위" },
        DriftWithEarthquake => { en: "drift with the earthquake", ko: "층간변위(지진 포함)" },
        Room => { en: "room of a damper", ko: "감쇠기 여유 공간" },
        UnderWeight { word: Both } => { en: "{word} under its weight", ko: "자중에 대해 {word}" },
        UnderWeightAndLoads { word: Both } => {
            en: "{word} under its weight and these loads",
            ko: "자중과 이 하중에 대해 {word}",
        },
    }
}

/// A response of a variant, and that of the structure as it is.
#[derive(Clone, Debug)]
pub(super) struct Response {
    what: Responses,
    before: Option<f64>,
    after: f64,
    word: Both,
    /// Whether it is beyond a limit or below the demand.
    pub(super) is_red: bool,
    /// Whether it is that to the earthquake of the site.
    pub(super) is_earthquake: bool,
}

impl Response {
    /// Whether a variant changes it.
    pub(super) fn changes(&self) -> bool {
        self.before
            .is_some_and(|old| (self.after / old - 1.0).abs() >= SAME_SHARE)
    }

    /// Whether it is worse than that of the structure as it is.
    pub(super) fn is_worse(&self) -> bool {
        self.before.is_some_and(|old| self.after < old)
    }

    /// What changes, without the variant.
    pub(super) fn said(&self) -> Sentence {
        let number = |ratio: f64| Quantity::beside_one(ratio, DIGITS);
        let what = Sentence::from(self.what.clone());
        let word = self.word.clone();
        let after = number(self.after);
        match (self.before.filter(|_| self.changes()).map(number), self.is_red) {
            (Some(before), true) => Responses::GoesBeyond {
                what,
                before,
                after,
                word,
            },
            (Some(before), false) => Responses::Goes { what, before, after },
            (None, _) => Responses::Is { what, after, word },
        }
        .into()
    }
}

/// The demand of the site on a version, with the smallest capacity over demand of all parts.
pub(super) fn asked(version: &VersionJudgement) -> Option<(Earthquake, Option<f64>)> {
    let found = &version.earthquake;
    let ratios = found.iter().filter_map(|finding| finding.ratio);
    (!found.is_empty()).then(|| (version.earthquake_word(), ratios.reduce(f64::min)))
}

/// What a version is limited in by its wind and static loads, as words.
pub(super) fn limited_in(of: &WindFinding) -> Option<Responses> {
    Some(match (of.limit?, of.by) {
        (WindLimit::Acceleration, _) => Responses::Acceleration,
        (WindLimit::Drift, MovedBy::WithEarthquake) => Responses::DriftWithEarthquake,
        (WindLimit::Drift, MovedBy::Wind | MovedBy::Loads | MovedBy::Both) => Responses::Drift,
        (WindLimit::Room, _) => Responses::Room,
        (WindLimit::NotGiven, _) => return None,
    })
}

/// The responses of a variant that differ from those of the structure as it is, or are beyond what is allowed. A response without a ratio, of
/// a variant that does not bear its loads, stands in its headline.
pub(super) fn responses(before: &VersionJudgement, after: &VersionJudgement) -> Vec<Response> {
    let earthquake = asked(after).and_then(|(word, ratio)| {
        Some(Response {
            what: Responses::Earthquake,
            before: asked(before).and_then(|(_, ratio)| ratio),
            after: ratio?,
            word: Both::of(|language| word.word(language)),
            is_red: word.colour() == Colour::Red,
            is_earthquake: true,
        })
    });
    let old = WindFinding::deciding(&before.wind);
    let wind = WindFinding::deciding(&after.wind).and_then(|of| {
        Some(Response {
            what: match of.by {
                MovedBy::Wind => Responses::Wind,
                MovedBy::Loads => Responses::Loads,
                MovedBy::Both => Responses::WindAndLoads,
                MovedBy::WithEarthquake => Responses::WithEarthquake,
            },
            before: old.filter(|old| old.by == of.by).and_then(|old| old.ratio),
            // 0: the loads are not borne at all
            after: of.ratio.filter(|ratio| *ratio > 0.0)?,
            word: Both::of(|language| of.word.word(language)),
            is_red: of.word.colour() == Colour::Red,
            is_earthquake: false,
        })
    });
    let all = earthquake.into_iter().chain(wind);
    all.filter(|of| of.is_red || of.changes()).collect()
}

/// Whether a version is unstable, below the demand or beyond a limit.
pub(super) fn is_beyond(version: &VersionJudgement) -> bool {
    let weight = version.weight.map(Weight::colour);
    let others = [version.earthquake_word().colour(), version.wind_word().colour()];
    weight.into_iter().chain(others).any(|of| of == Colour::Red)
}

/// The word for a version in a table: below the demand or beyond its limits, if its verdict hides that.
pub(super) fn red_word(version: &VersionJudgement, verdict: Verdict) -> Option<Both> {
    let (earthquake, wind) = (version.earthquake_word(), version.wind_word());
    let is_red = [earthquake.colour(), wind.colour()].map(|of| of == Colour::Red);
    (verdict != Verdict::Unstable && is_red != [false, false]).then(|| {
        Both::of(|language| {
            let words = [earthquake.word(language), wind.word(language)];
            let red = words.into_iter().zip(is_red).filter(|(_, is_red)| *is_red);
            red.map(|(word, _)| word).collect::<Vec<_>>().join(", ")
        })
    })
}
