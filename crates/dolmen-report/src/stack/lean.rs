//! The lean of the model.

use crate::document::{Finding, Tone};
use dolmen_project::SurveyedLean;
use dolmen_words::messages;

messages! {
    /// The lean of a model.
    pub(crate) enum Leaning in "stack.lean" {
        AsSurveyed { survey: String, tilt: String } => {
            en: "The model leans as survey {survey} found it, tilt {tilt}«; as_surveyed = \"none\" leaves that out».",
            ko: "모델은 {survey} 조사의 실측 기울기 {tilt}을(를) 반영하였다.« 제외하려면 as_surveyed = \"none\"으로 한다.»",
        },
    }
}

/// The lean of the model and its survey.
pub(crate) fn lean(of: &SurveyedLean) -> Finding {
    let (survey, tilt) = (of.survey.clone(), of.written.clone());
    Finding::key(Tone::Plain, Leaning::AsSurveyed { survey, tilt })
}
