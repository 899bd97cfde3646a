//! Common to all short and full answers on a terminal: the decisive findings, how much more there is, and the notes on the file.

use crate::document::{Finding, Role, TextStyle, Tone, findings_text, heading_text, wrapped};
use crate::warned::warned;
use dolmen_project::{Project, Warning, WarningKind};
use dolmen_words::{Language, Sentence, messages};

/// Lines of a short answer below its headline.
const LINES_MOST: usize = 15;

messages! {
    /// Sentences around findings on a terminal.
    pub(crate) enum Brief in "brief" {
        FindingsHead => { en: "Findings", ko: "검토 결과 요약" },
        NotesHead => { en: "Notes on the file", ko: "입력 파일에 대한 경고" },
        Note { line: usize, message: Sentence } => {
            en: "line {line}: {message}",
            ko: "{line}행: {message}",
        },
        MoreFindings { count: usize } => { en: "further findings: {count}", ko: "그 밖의 결과: {count}개" },
        MoreToActOn { count: usize, to_act_on: usize } => {
            en: "further findings: {count}, to look into: {to_act_on}",
            ko: "그 밖의 결과: {count}개(확인할 것 {to_act_on}개)",
        },
        Reserved { count: usize } => {
            en: "limits of this answer that do not fit here: {count} (--full)",
            ko: "여기에 다 적지 못한 위 답의 조건: {count}개(--full)",
        },
        MoreNotes { count: usize } => { en: "notes on the file: {count}", ko: "입력 파일 경고: {count}개" },
        Full => { en: "all of it with --full", ko: "전체 내용은 --full" },
    }
}

fn said(message: Brief, language: Language) -> String {
    Sentence::from(message).text(language)
}

/// The decisive findings in their order, and how much more there is; if they do not all fit, only those that require action. `above` is
/// the number of lines of the headline after its first.
pub(crate) fn brief_text(all: &[Finding], project: &Project, above: usize, style: TextStyle) -> String {
    let text = text_within(all, project, LINES_MOST.saturating_sub(above + 1), style);
    // the line of counts may take two
    match above + text.lines().count() > LINES_MOST {
        true => text_within(all, project, LINES_MOST.saturating_sub(above + 2), style),
        false => text,
    }
}

/// The findings that fit into a number of lines, and how much more there is.
fn text_within(all: &[Finding], project: &Project, left: usize, style: TextStyle) -> String {
    let key: Vec<&Finding> = all.iter().filter(|finding| finding.is_key).collect();
    let shown = shown_within(&key, left, style);
    let is_hidden = |(i, finding): (usize, &&Finding)| !shown[i] && rank(finding.tone) < rank(Tone::Good);
    let to_act_on = key.iter().enumerate().filter(|of| is_hidden(*of)).count();
    let count = shown.iter().filter(|shown| **shown).count();
    let more = match (all.len() - count, to_act_on) {
        (0, _) => None,
        (count, 0) => Some(Brief::MoreFindings { count }),
        (count, to_act_on) => Some(Brief::MoreToActOn { count, to_act_on }),
    };
    shown_text(&key, &shown, style) + &more_text(project, more, style)
}

/// The findings that fit; below an answer of which not all limits fit, a line that says so.
fn shown_text(key: &[&Finding], shown: &[bool], style: TextStyle) -> String {
    let mut text = String::new();
    for group in groups(key) {
        let (fit, rest): (Group, Group) = group.into_iter().partition(|&i| shown[i]);
        text += &findings_text(fit.iter().map(|&i| key[i]), style);
        if !fit.is_empty() && !rest.is_empty() {
            text += &findings_text([&reserved(rest.len())], style);
        }
    }
    text
}

/// An answer and what qualifies it, or one finding of another kind: numbers of findings.
type Group = Vec<usize>;

fn groups(key: &[&Finding]) -> Vec<Group> {
    let mut all: Vec<Group> = Vec::new();
    for (i, finding) in key.iter().enumerate() {
        // other findings may stand between the two
        let answer = |group: &&mut Group| key[group[0]].role == Role::Answer;
        match all.iter_mut().rfind(answer) {
            Some(group) if finding.role == Role::Qualifies => group.push(i),
            _ => all.push(vec![i]),
        }
    }
    all
}

/// The line below an answer of which not all limits fit.
fn reserved(count: usize) -> Finding {
    Finding::key(Tone::Warn, Brief::Reserved { count })
}

/// Which findings fit: the first one, answers with what qualifies them and bad ones, then the others by their tone.
///
/// An answer takes a line more where not all of its limits fit.
fn shown_within(key: &[&Finding], mut left: usize, style: TextStyle) -> Vec<bool> {
    let mut by_weight = groups(key);
    by_weight.sort_by_key(|group| match group[0] {
        0 => 0,
        i if key[i].role == Role::Answer || key[i].tone == Tone::Bad || is_asked_for(key[i]) => 1,
        i => 2 + rank(key[i].tone),
    });
    let lines = |finding: &Finding| findings_text([finding], style).lines().count();
    let mut shown = vec![false; key.len()];
    for group in by_weight {
        // a shorter group may fit where a longer one does not
        let each: Vec<usize> = group.iter().map(|&i| lines(key[i])).collect();
        let last = lines(&reserved(each.len()));
        let needed =
            |count: usize| each[..count].iter().sum::<usize>() + if count < each.len() { last } else { 0 };
        if let Some(count) = (1..=each.len()).rev().find(|&count| needed(count) <= left) {
            left -= needed(count);
            group[..count].iter().for_each(|&i| shown[i] = true);
        }
    }
    shown
}

/// Whether a flag requested the result: samples, sensitivities.
fn is_asked_for(finding: &Finding) -> bool {
    matches!(finding.code, Some("sensitivity" | "probability"))
}

/// Priority of findings for the available lines, below answers: those that require action, good ones, the rest.
fn rank(tone: Tone) -> u8 {
    match tone {
        Tone::Bad => 0,
        Tone::Warn | Tone::Unknown => 1,
        Tone::Good => 2,
        Tone::Plain => 3,
    }
}

fn more_text(project: &Project, findings: Option<Brief>, style: TextStyle) -> String {
    let notes = project.warnings.len();
    let notes = (notes > 0).then_some(Brief::MoreNotes { count: notes });
    let mut each: Vec<String> = findings
        .into_iter()
        .chain(notes)
        .map(|message| said(message, style.language))
        .collect();
    each.push(said(Brief::Full, style.language));
    wrapped(&each.join(" · "), "  ", "  ", style.columns())
}

/// All findings under their head.
pub(crate) fn all_findings_text(all: &[Finding], style: TextStyle) -> String {
    heading_text(&said(Brief::FindingsHead, style.language)) + &findings_text(all, style)
}

/// Notes of every result: assumptions and omissions.
pub(crate) fn notes_text(project: &Project, style: TextStyle) -> String {
    if project.warnings.is_empty() {
        return String::new();
    }
    let head = heading_text(&said(Brief::NotesHead, style.language));
    let each = project
        .warnings
        .iter()
        .map(|note| note_text(project, note, style));
    head + &each.collect::<String>()
}

/// One note on the file.
pub(crate) fn note_text(project: &Project, note: &Warning, style: TextStyle) -> String {
    // keys are English words
    let message = match (note.kind, style.language) {
        (WarningKind::Assumed, Language::Korean) => warned(project, note),
        _ => note.message.clone(),
    };
    let message = Brief::Note {
        line: note.line,
        message,
    };
    wrapped(&said(message, style.language), "  * ", "    ", style.columns())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three lines are left: an answer goes before warnings, and what qualifies it goes nowhere without it, nor it without that.
    #[test]
    fn holds_answers_come_first_and_what_qualifies_them_only_beside_them() {
        let style = TextStyle::plain();
        let said = |text: &str| Sentence::of_symbol(text);
        let long = "very ".repeat(2 * style.width / 5) + "long";
        let shown = |all: &[Finding], left: usize| {
            let key: Vec<&Finding> = all.iter().collect();
            let text = shown_text(&key, &shown_within(&key, left, style), style);
            text.lines()
                .map(|line| line.trim().to_owned())
                .collect::<Vec<_>>()
        };
        let all = [
            Finding::answer(Tone::Good, said("stands")),
            Finding::answer(Tone::Good, said("bears 2 times the wind")),
            Finding::key(Tone::Warn, said(&long)),
            Finding::qualifies(Tone::Warn, said("an upper bound")),
        ];
        let three: [&str; 3] = ["● stands", "● bears 2 times the wind", "◆ an upper bound"];
        assert_eq!(shown(&all, 3), three);
        assert_eq!(shown(&all, 9)[..3], three);
        assert_eq!(shown(&all, 2), ["● stands"]);
        // what limits an answer does not fit: the answer says so
        let long_limit = Finding::qualifies(Tone::Warn, said(&long));
        let limited = [all[0].clone(), all[1].clone(), long_limit];
        let hidden = "◆ limits of this answer that do not fit here: 1 (--full)";
        assert_eq!(shown(&limited, 3), [three[0], three[1], hidden]);
        let long_answer = Finding::answer(Tone::Good, said(&long));
        let without = [all[0].clone(), long_answer, all[3].clone()];
        assert_eq!(shown(&without, 2), ["● stands"]);
    }
}
