//! `dolmen check` on a terminal: the verdict and the decisive findings, or everything.

use super::findings::{findings, of_state, unread};
use super::made_stones::made_stones_text;
use super::project::project_text;
use super::sampled;
use super::variants::{section as variants_section, title};
use super::versions::{variant_sections, version_sections};
use crate::brief::{all_findings_text, brief_text, note_text, notes_text};
use crate::document::{
    Document, Finding, TextStyle, Tone, document_text, findings_text, heading_text, wrapped,
};
use crate::engineer::{self, Pictures};
use crate::headline::{verdict_line, worse};
use crate::stack;
use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence, messages};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::judgement::{VersionJudgement, judge_check};
use dolmen_work::state::{Check, State, VariantAnswer};

messages! {
    /// Sentences around a check on a terminal.
    pub(crate) enum Said in "check.text" {
        NothingModelled => {
            en: "Nothing is modelled« (kind = \"survey\")», so there is nothing to check: run «`dolmen identify`|the identification from vibration».",
            ko: "모델이 없으므로«(kind = \"survey\")» 검토할 것이 없다. «`dolmen identify`|진동 평가»를 실행한다.",
        },
        Variant(variant: Both) => { en: "Variant “{variant}”", ko: "대안 ‘{variant}’" },
    }
}

/// The check of a project and its variants.
pub fn check_text(answer: &CheckAnswer, style: TextStyle) -> String {
    let mut out = project_text(&answer.project, &answer.file, style);
    out.push('\n');
    let Some(state) = &answer.state else {
        out += &wrapped(
            &said(Said::NothingModelled, style.language),
            "",
            "",
            style.columns(),
        );
        return match style.is_full {
            true => out + &findings_text(&findings(answer), style) + &notes_text(&answer.project, style),
            false => out + &brief_text(&findings(answer), &answer.project, 0, style),
        };
    };
    let judgement = judge_check(answer);
    let head = out.lines().count();
    for judged in judgement.versions.iter().take(1) {
        out += &verdict_line(judged, style);
    }
    for judged in judgement.worse() {
        out += &worse_text(answer, judged, style);
    }
    match style.is_full {
        false => {
            let above = out.lines().count().saturating_sub(head + 1);
            out + &brief_text(&with_unread(answer), &answer.project, above, style)
        }
        true => out + &full_text(answer, state, &judgement.versions, style),
    }
}

fn said(message: Said, language: Language) -> String {
    Sentence::from(message).text(language)
}

/// The findings, with a note on records that a check does not read; a report reads them.
fn with_unread(answer: &CheckAnswer) -> Vec<Finding> {
    let mut all = findings(answer);
    let bad = all.iter().take_while(|finding| finding.tone == Tone::Bad).count();
    if let Some(unread) = unread(answer) {
        all.insert(bad, unread);
    }
    all
}

/// A variant that is worse than the structure as it is.
fn worse_text(answer: &CheckAnswer, judged: &VersionJudgement, style: TextStyle) -> String {
    let name = judged.variant.as_deref().unwrap_or_default();
    let own = answer.variants.iter().find(|variant| variant.name == name);
    let variant = own.map_or_else(|| Both::of(|_| name), title);
    let said = worse(variant, judged).text(style.language);
    wrapped(&said, "", "  ", style.columns())
}

fn full_text(answer: &CheckAnswer, state: &State, versions: &[VersionJudgement], style: TextStyle) -> String {
    let mut out = all_findings_text(&with_unread(answer), style);
    out += &document_text(&version_sections(&answer.project, state), style);
    out += &made_stones_text(&answer.project, style);
    for (variant, judged) in answer.variants.iter().zip(versions.iter().skip(1)) {
        out += &variant_text(answer, variant, judged, style);
    }
    out += &document_text(&side_by_side(answer, state), style);
    out += &document_text(&sampled::sections(answer), style);
    out += &document_text(&engineer::damage(&answer.project, Pictures::unread()), style);
    if let Some(given) = &answer.project.report {
        out += &document_text(&engineer::place(given, Pictures::unread()), style);
        out += &document_text(&engineer::tests_made(given), style);
        out += &document_text(&engineer::opinion(given), style);
    }
    out + &notes_text(&answer.project, style)
}

fn variant_text(
    answer: &CheckAnswer,
    variant: &VariantAnswer,
    judged: &VersionJudgement,
    style: TextStyle,
) -> String {
    let head = Said::Variant(title(variant));
    let mut out = heading_text(&said(head, style.language));
    out += &verdict_line(judged, style);
    let own = answer
        .project
        .variants
        .iter()
        .find(|own| own.name == variant.name);
    let found = own.map_or_else(Vec::new, |own| of_state(&own.project, &variant.state));
    out += &findings_text(found.iter().filter(|of: &&Finding| of.is_key), style);
    if let Some(own) = own {
        out += &document_text(&variant_sections(answer, &own.project, variant), style);
        let notes = own.project.warnings.iter();
        for note in notes.filter(|note| !answer.project.warnings.contains(note)) {
            out += &note_text(&own.project, note, style);
        }
    }
    out
}

/// All versions side by side.
fn side_by_side<'a>(answer: &'a CheckAnswer, state: &State) -> Document<'a> {
    match &state.check {
        Check::Stack(_) if answer.variants.is_empty() => Document::default(),
        Check::Stack(_) => stack::comparison(state, &answer.variants),
        Check::Chain(_) | Check::Frame(_) | Check::Building(_) => variants_section(answer),
    }
}
