//! `dolmen identify` on a terminal: modes and stiffness from every survey.

use crate::brief::{all_findings_text, brief_text, notes_text};
use crate::check::{made_up_text, project_text};
use crate::document::{Finding, TextStyle, Tone, document_text, wrapped};
use crate::{identification, modal};
use dolmen_words::{Sentence, messages};
use dolmen_work::answer::IdentifyAnswer;
use dolmen_work::surveyed::SurveyAnswer;
use dolmen_work::{can_be_written, would_be_unchecked};

messages! {
    /// Text on a terminal if there is nothing to identify.
    pub(crate) enum Nothing in "identify" {
        NoSurvey => {
            en: "The file has no «[survey.NAME]|survey» with frequencies or records, so there is nothing to identify.",
            ko: "파일에 진동수나 기록이 있는 «[survey.NAME]이|조사가» 없으므로 추정할 것이 없다.",
        },
        FromSurveys { surveys: Vec<String> } => {
            en: "No records to analyse and no stiffness to seek: survey {surveys}.",
            ko: "분석할 기록이나 강성을 추정할 고유진동수가 없는 조사: {surveys}.",
        },
    }
}

/// The identification of every survey.
pub fn identification_text(answer: &IdentifyAnswer, style: TextStyle) -> String {
    let mut out = project_text(&answer.project, &answer.file, style);
    out += &made_up_text(&answer.project, style);
    out.push('\n');
    if let Some(nothing) = nothing(answer) {
        let nothing = Sentence::from(nothing).text(style.language);
        out += &wrapped(&nothing, "", "", style.columns());
    }
    let mut all = modal::findings(&answer.surveys);
    all.extend(identification::findings(&answer.project, &answer.surveys));
    if can_be_written(answer) && answer.project.identified_from().is_empty() {
        let can_be = match would_be_unchecked(answer) {
            true => identification::Written::CanBeUnchecked,
            false => identification::Written::CanBe,
        };
        all.push(Finding::key(Tone::Plain, can_be));
    }
    if !style.is_full {
        return out + &brief_text(&all, &answer.project, 0, style);
    }
    if !all.is_empty() {
        out += &all_findings_text(&all, style);
    }
    for survey in &answer.surveys {
        out += &document_text(&modal::sections(survey), style);
    }
    let every: Vec<&SurveyAnswer> = answer.surveys.iter().collect();
    out += &document_text(&identification::sections(&answer.project, &every), style);
    out += &document_text(&identification::appendix(&answer.project, &every), style);
    out + &notes_text(&answer.project, style)
}

/// Data from which nothing can be identified.
fn nothing(answer: &IdentifyAnswer) -> Option<Nothing> {
    if answer.surveys.is_empty() {
        return Some(Nothing::NoSurvey);
    }
    let is_empty = |survey: &&SurveyAnswer| {
        survey.records.is_none()
            && survey.setups.is_none()
            && survey.stiffness.is_empty()
            && survey.plan.is_none()
            && survey.factors.is_none()
            && survey.without_stiffness.is_none()
    };
    let surveys = answer.surveys.iter().filter(is_empty);
    let surveys: Vec<String> = surveys.map(|survey| survey.name.clone()).collect();
    (!surveys.is_empty()).then_some(Nothing::FromSurveys { surveys })
}
