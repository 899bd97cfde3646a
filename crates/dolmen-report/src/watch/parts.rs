//! The part that explains a lasting change, with its date.

use super::numbers::name;
use crate::change::{model_off, part_findings, part_section};
use crate::document::{Document, Finding, Tone};
use dolmen::monitoring::ChangeForm;
use dolmen_words::{Sentence, messages};
use dolmen_work::watched::WatchAnswer;
use dolmen_work::years_parts::YearsParts;

messages! {
    /// The date of the explained change.
    pub(crate) enum Dated in "watch.parts" {
        Step { after: String, before: String, said: Sentence } => {
            en: "The change between {after} and {before}. {said}",
            ko: "{after}~{before} 사이의 변화. {said}",
        },
        Drift { since: String, said: Sentence } => {
            en: "The drift since about {since}. {said}",
            ko: "{since}경부터의 점진 변화. {said}",
        },
        Table { after: String, before: String } => {
            en: "The change between {after} and {before}, modes that did not change beyond chance included.",
            ko: "{after}~{before} 사이의 변화. 유의하게 변하지 않은 모드도 포함하였다.",
        },
    }
}

/// The findings, each with its date.
pub(super) fn parts(answer: &WatchAnswer) -> Vec<Finding> {
    let dated = |of: &YearsParts, said: Sentence| match of.form {
        ChangeForm::Step => Dated::Step {
            after: name(answer, of.after),
            before: name(answer, of.before),
            said,
        },
        ChangeForm::Slope => Dated::Drift {
            since: name(answer, of.after),
            said,
        },
    };
    let each = answer.parts.iter().flat_map(|of| {
        let own = part_findings(&of.parts).into_iter();
        own.map(move |found| Finding {
            sentence: dated(of, found.sentence).into(),
            ..found
        })
    });
    each.collect()
}

/// Finding that the model is too far from the measured frequencies for any part to be sought.
pub(super) fn model_apart(answer: &WatchAnswer) -> Option<Finding> {
    let of = answer.model_off.as_ref()?;
    Some(Finding {
        tone: Tone::Warn,
        ..model_off(of, &answer.project)
    })
}

/// The tables of all parts.
pub(super) fn put(document: &mut Document<'_>, answer: &WatchAnswer) {
    for of in &answer.parts {
        document.note(Dated::Table {
            after: name(answer, of.after),
            before: name(answer, of.before),
        });
        part_section(document, &of.parts);
    }
}
