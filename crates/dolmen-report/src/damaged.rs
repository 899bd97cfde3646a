//! Damage of inspections in a model, in words.

use dolmen_project::{InModel, ModelDamage};
use dolmen_words::{Quantity, Sentence, Template, messages};

messages! {
    /// Damage in a model.
    pub(crate) enum Damaged in "damage.model" {
        Bed { part: String, share: Quantity, survey: String } => {
            en: "bed below “{part}” less {share} ({survey})",
            ko: "‘{part}’ 하부 접합면 {share} 손실({survey})",
        },
        BedAt { part: String, share: Quantity, side: String, survey: String } => {
            en: "bed below “{part}” less {share} at {side} ({survey})",
            ko: "‘{part}’ 하부 접합면 {side} 쪽 {share} 손실({survey})",
        },
        Stiffness { part: String, left: Quantity, survey: String } => {
            en: "“{part}” with {left} of its stiffness ({survey})",
            ko: "‘{part}’ 강성 {left}로 저하({survey})",
        },
        Ties { part: String, survey: String } => {
            en: "ties below “{part}” broken ({survey})",
            ko: "‘{part}’ 아래 연결재 파단({survey})",
        },
        Gone { part: String, survey: String } => { en: "“{part}” gone ({survey})", ko: "‘{part}’ 결실({survey})" },
        Mended { part: String, survey: String } => { en: "“{part}” mended ({survey})", ko: "‘{part}’ 보수({survey})" },
    }
}

/// Templates of the sentences.
pub(crate) const TEMPLATES: &[Template] = Damaged::TEMPLATES;

/// A damage, with the survey that found it.
pub(crate) fn damaged(of: &ModelDamage) -> Sentence {
    let (part, survey) = (of.part.clone(), of.survey.clone());
    match of.effect {
        InModel::BedLost { share, side } => {
            let share = Quantity::percent(share, 2);
            match side {
                None => Damaged::Bed { part, share, survey },
                Some(side) => Damaged::BedAt {
                    part,
                    share,
                    side: side.word().to_owned(),
                    survey,
                },
            }
        }
        InModel::StiffnessLeft(left) => Damaged::Stiffness {
            part,
            left: Quantity::percent(left, 2),
            survey,
        },
        InModel::TiesBroken => Damaged::Ties { part, survey },
        InModel::Lost => Damaged::Gone { part, survey },
        InModel::Mended => Damaged::Mended { part, survey },
    }
    .into()
}
