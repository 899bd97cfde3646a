//! The part before the sections: participants, the three answers, recommendations.

use super::words::{said, verbatim};
use crate::check::title;
use crate::document::{Answered, Block, Signatory, Tone};
use dolmen_project::Names;
use dolmen_words::message::Both;
use dolmen_words::{Sentence, messages};
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::{
    Colour, Earthquake, Evidence, MovedBy, VersionJudgement, WindFinding, WindWord, judge,
};

messages! {
    /// Signatures and the three questions.
    pub(crate) enum Front in "engineer.front" {
        Signatures => { en: "Participating engineers", ko: "참여기술진" },
        Weight => { en: "Does it stand under its own weight and the static loads?", ko: "자중과 정하중을 견디는가" },
        Earthquake => { en: "Does it meet what the earthquake asks?", ko: "지진에 대한 기준을 만족하는가" },
        Wind => { en: "Does it move no more in the wind than is allowed?", ko: "풍응답이 허용값 이내인가" },
        Loads => { en: "Does it move no more under its loads than is allowed?", ko: "하중에 의한 변위가 허용값 이내인가" },
        Evidence => { en: "Is the model the structure?", ko: "모델이 실제와 일치하는가" },
        Word { word: Both } => { en: "{word}", ko: "{word}" },
        WithVariants { word: Both, each: Vec<Sentence> } => { en: "as given: {word}; {each}", ko: "현 상태: {word}; {each}" },
        OfVariant { variant: Both, word: Both } => { en: "variant “{variant}”: {word}", ko: "대안 ‘{variant}’: {word}" },
        ToDo => { en: "What to do", ko: "보수·보강 방안" },
    }
}

/// Blocks before the sections, under headings without numbers.
pub(crate) struct FrontMatter {
    /// Participants, under their heading.
    pub(crate) signatures: Option<(Sentence, Block<'static>)>,
    /// The three questions with the fixed words; `None` if no model was judged.
    pub(crate) answers: Option<Block<'static>>,
    /// The engineer's recommendations, under their heading.
    pub(crate) to_do: Option<(Sentence, Block<'static>)>,
}

/// The part before the sections.
pub(crate) fn front(answer: &ProjectReport) -> FrontMatter {
    let report = answer.project.report.iter();
    let authors = report.clone().flat_map(|report| &report.authors);
    let signatures: Vec<Signatory> = authors
        .map(|author| Signatory {
            role: of(author.role.as_ref()),
            name: said(&author.name),
            licence: of(author.licence.as_ref()),
        })
        .collect();
    let points: Vec<Sentence> = report
        .flat_map(|report| &report.recommendations)
        .map(said)
        .collect();
    let filled =
        |is_empty: bool, head: Front, block: Block<'static>| (!is_empty).then(|| (head.into(), block));
    FrontMatter {
        signatures: filled(
            signatures.is_empty(),
            Front::Signatures,
            Block::Signatures(signatures),
        ),
        answers: answers(answer),
        to_do: filled(points.is_empty(), Front::ToDo, Block::List(points)),
    }
}

fn of(names: Option<&Names>) -> Sentence {
    names.map_or_else(|| verbatim(""), said)
}

fn answers(answer: &ProjectReport) -> Option<Block<'static>> {
    let judgement = judge(&answer.answers);
    let headline = judgement.headline()?;
    let weight = headline.weight?;
    let earthquake = headline.earthquake_word();
    let answered = |question: Front, tone: Tone, word: Both| Answered {
        question: question.into(),
        tone,
        word: Front::Word { word }.into(),
    };
    let versions: Vec<(Both, &VersionJudgement)> = judgement
        .versions
        .iter()
        .filter_map(|version| {
            let name = version.variant.as_deref()?;
            let own = answer.variants().iter().find(|variant| variant.name == name);
            Some((own.map_or_else(|| Both::of(|_| name), title), version))
        })
        .collect();
    // a check that was not requested or measured is not a good result
    let of_earthquake = match earthquake {
        Earthquake::NotAsked => Tone::Unknown,
        asked => tone(asked.colour()),
    };
    let of_evidence = match &headline.evidence {
        Evidence::TooRough(_)
        | Evidence::Unread { .. }
        | Evidence::NotCompared { .. }
        | Evidence::NotMeasured { .. } => Tone::Unknown,
        Evidence::MarkedAssumed { .. } => Tone::Warn,
        measured => tone(measured.colour()),
    };
    let wind = headline.wind_word();
    let of_wind = (wind != WindWord::NotAsked).then(|| {
        let word = Both::of(|language| wind.word(language));
        let worse = versions.iter().map(|(name, version)| {
            let word = version.wind_word();
            (name, word.colour(), Both::of(|language| word.word(language)))
        });
        let asks = match WindFinding::deciding(&headline.wind).map(|of| of.by) {
            Some(MovedBy::Loads | MovedBy::Both | MovedBy::WithEarthquake) => Front::Loads,
            Some(MovedBy::Wind) | None => Front::Wind,
        };
        let own = answered(asks, tone(wind.colour()), word.clone());
        with_variants(own, (wind.colour(), word), worse)
    });
    let weights = versions.iter().filter_map(|(name, version)| {
        let weight = version.weight?;
        Some((name, weight.colour(), Both::of(|language| weight.words(language))))
    });
    let shaken = versions.iter().map(|(name, version)| {
        let word = version.earthquake_word();
        (name, word.colour(), Both::of(|language| word.word(language)))
    });
    let of_weight = Both::of(|language| weight.words(language));
    let of_word = Both::of(|language| earthquake.word(language));
    // a stiffness that nothing checks makes no answer good
    let is_checked = headline.basis.unchecked_stiffness_from.is_empty();
    let own_tone = match tone(weight.colour()) {
        Tone::Good if !is_checked => Tone::Unknown,
        own => own,
    };
    let mut all = vec![
        with_variants(
            answered(Front::Weight, own_tone, of_weight.clone()),
            (weight.colour(), of_weight),
            weights,
        ),
        with_variants(
            answered(Front::Earthquake, of_earthquake, of_word.clone()),
            (earthquake.colour(), of_word),
            shaken,
        ),
        answered(
            Front::Evidence,
            of_evidence,
            Both::of(|language| headline.evidence.words(language)),
        ),
    ];
    all.extend(of_wind);
    Some(Block::Answers(all))
}

/// An answer for the structure as given; variants with a worse colour stand beside it, and the worst of them gives it its tone.
fn with_variants<'a>(
    own: Answered,
    (colour, word): (Colour, Both),
    variants: impl Iterator<Item = (&'a Both, Colour, Both)>,
) -> Answered {
    let worse: Vec<_> = variants.filter(|(_, own, _)| *own > colour).collect();
    let Some(worst) = worse.iter().map(|(_, own, _)| *own).max() else {
        return own;
    };
    let each = worse.into_iter().map(|(variant, _, word)| {
        let variant = variant.clone();
        Front::OfVariant { variant, word }.into()
    });
    Answered {
        tone: tone(worst),
        word: Front::WithVariants {
            word,
            each: each.collect(),
        }
        .into(),
        ..own
    }
}

fn tone(colour: Colour) -> Tone {
    match colour {
        Colour::Green => Tone::Good,
        Colour::Amber => Tone::Warn,
        Colour::Red => Tone::Bad,
    }
}
