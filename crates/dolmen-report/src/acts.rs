//! Removes the commands and keys of a terminal from sentences: a reader of paper cannot type them.

use crate::document::{Block, Document, Finding};
use dolmen_words::message::Run;
use dolmen_words::{Language, Sentence};

/// What a command does, in English and Korean. The Korean ends in the same kind of sound, so the particle after it stays right.
const ACTS: [(&str, [&str; 2]); 9] = [
    ("identify", ["the identification from vibration", "진동 평가"]),
    ("check", ["the check of stability", "안정성 검토"]),
    ("simulate", ["a simulation in time", "지진응답 검토"]),
    ("watch", ["the review of all surveys", "장기 변화 검토"]),
    ("compare", ["the comparison of two surveys", "조사 비교"]),
    ("report", ["the report", "보고서"]),
    ("study", ["a study of many runs", "반복 해석 검토"]),
    ("sensors", ["a plan of sensors", "센서 배치 검토"]),
    ("explain", ["the list of terms", "용어 설명"]),
];

/// The findings in words for paper.
pub(crate) fn on_paper(findings: &mut [Finding]) {
    for finding in findings {
        finding.sentence = plain(&finding.sentence);
    }
}

/// The blocks in words for paper.
pub(crate) fn document_on_paper(document: &mut Document<'_>) {
    // the list of terms belongs to the terminal
    document
        .blocks
        .retain(|block| !matches!(block, Block::Note(said) if is_of_terms(said)));
    for block in &mut document.blocks {
        let sentences: &mut [Sentence] = match block {
            Block::Heading(one) | Block::Subheading(one) | Block::Warning(one) | Block::Note(one) => {
                std::slice::from_mut(one)
            }
            Block::Paragraph(all) | Block::List(all) => all,
            Block::Table(table) => &mut table.caption,
            Block::Figures(figures) => {
                for figure in figures {
                    figure.caption.iter_mut().for_each(|said| *said = plain(said));
                }
                continue;
            }
            Block::KeyValues(_)
            | Block::Equation(_)
            | Block::Photos(_)
            | Block::Signatures(_)
            | Block::Answers(_) => continue,
        };
        sentences.iter_mut().for_each(|said| *said = plain(said));
    }
}

fn is_of_terms(said: &Sentence) -> bool {
    said.text(Language::English).starts_with("`dolmen explain`")
}

fn plain(sentence: &Sentence) -> Sentence {
    let of = |runs: &[Run], language| {
        let each = runs.iter().map(|run| match run {
            Run::Text(text) => Run::Text(without_commands(text, language)),
            Run::Name(text) => Run::Name(without_commands(text, language)),
            Run::Quantity(_) => run.clone(),
        });
        each.collect()
    };
    Sentence {
        id: sentence.id.clone(),
        arguments: sentence.arguments.clone(),
        english: of(&sentence.english, Language::English),
        korean: of(&sentence.korean, Language::Korean),
    }
}

fn without_commands(text: &str, language: Language) -> String {
    let text = without_asides(text);
    let mut said = String::with_capacity(text.len());
    let mut rest = text.as_str();
    while let Some((before, behind)) = rest.split_once("`dolmen ") {
        let Some((command, after)) = behind.split_once('`') else {
            break;
        };
        said.push_str(before);
        let verb = command.split(' ').next().unwrap_or_default();
        match ACTS.iter().find(|(known, _)| *known == verb) {
            Some((_, [english, korean])) => {
                let act = language.pick(english, korean);
                let begins = said.is_empty() || said.ends_with(". ");
                said.push_str(&if begins { capital(act) } else { (*act).to_string() });
            }
            None => said.push_str(command),
        }
        rest = after;
    }
    said + rest
}

fn capital(text: &str) -> String {
    let mut signs = text.chars();
    let first = signs.next().into_iter().flat_map(char::to_uppercase);
    first.chain(signs).collect()
}

/// Without brackets that hold nothing but commands, keys or flags: "(`dolmen compare`)", "(--law both)", "(`tilt`, `offset`)".
fn without_asides(text: &str) -> String {
    let mut said = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once('(') {
        let inside = behind.split_once(')').filter(|(inside, _)| is_aside(inside));
        match inside {
            Some((_, after)) => {
                said.push_str(before.trim_end_matches(' '));
                rest = after;
            }
            None => {
                said.push_str(before);
                said.push('(');
                rest = behind;
            }
        }
    }
    said + rest
}

fn is_aside(inside: &str) -> bool {
    if inside.starts_with("--") {
        return true;
    }
    // the text between backquotes
    let between: String = inside.split('`').step_by(2).collect();
    inside.starts_with('`') && between.chars().all(|sign| matches!(sign, ',' | ' '))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_commands_become_acts_and_asides_go() {
        let english = |text| without_commands(text, Language::English);
        let korean = |text| without_commands(text, Language::Korean);
        assert_eq!(
            english("let `dolmen identify` find the stiffness (`tilt`, `offset`)."),
            "let the identification from vibration find the stiffness."
        );
        assert_eq!(
            korean("`dolmen identify PROJECT --write`로 쓰고 두 조사를 비교한다(`dolmen compare`)."),
            "진동 평가로 쓰고 두 조사를 비교한다."
        );
        assert_eq!(
            english("Not shown here. `dolmen watch` finds both, and `dolmen check` one."),
            "Not shown here. The review of all surveys finds both, and the check of stability one."
        );
        assert_eq!(
            english("It can be asked for (--law both)."),
            "It can be asked for."
        );
        assert_eq!(korean("기울기(x, `tilt`)와 `폭`"), "기울기(x, `tilt`)와 `폭`");
    }
}
