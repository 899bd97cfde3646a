//! A document for a terminal: plain characters, wrapped to its width.

use super::blocks::{Block, Cell, Document};
use super::finding::Finding;
use super::formula::linear;
use super::photos::{Answered, Photo, Signatory};
use super::text_table::table_text;
use super::words::Framed;
use dolmen_words::number::NARROW_SPACE;
use dolmen_words::{Language, Sentence};
use unicode_width::UnicodeWidthStr as _;

/// Largest line width, however wide the terminal is: longer lines are hard to read.
const WIDTH_MOST: usize = 100;
/// Smallest line width.
const WIDTH_LEAST: usize = 40;

/// Style of a document on a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextStyle {
    /// The language.
    pub language: Language,
    /// Columns of the terminal.
    pub width: usize,
    /// Whether to show everything, not only the results that decide.
    pub is_full: bool,
}

impl TextStyle {
    /// Everything in English, for wide terminals.
    pub fn plain() -> Self {
        TextStyle {
            language: Language::English,
            width: WIDTH_MOST,
            is_full: true,
        }
    }

    /// Width of sentences.
    pub(crate) fn columns(self) -> usize {
        self.width.clamp(WIDTH_LEAST, WIDTH_MOST)
    }
}

/// A wrapped sentence; the first line begins with `first`, the others with `other`.
pub(crate) fn wrapped(text: &str, first: &str, other: &str, columns: usize) -> String {
    let options = textwrap::Options::new(columns)
        .initial_indent(first)
        .subsequent_indent(other)
        .break_words(false)
        // codes are not hyphenated, so that they can be copied
        .word_splitter(textwrap::WordSplitter::NoHyphenation)
        .word_separator(textwrap::WordSeparator::AsciiSpace)
        .wrap_algorithm(textwrap::WrapAlgorithm::FirstFit);
    // lines are broken by now; terminals need plain spaces
    (textwrap::fill(&tied(text), options) + "\n").replace([NARROW_SPACE, TIE], " ")
}

/// A space at which no line is broken.
const TIE: char = '\u{a0}';
/// Signs between two numbers, or between a name and its number: "p < 0.001", "2.411 ± 0.006".
const RELATIONS: [&str; 8] = ["±", "<", ">", "≤", "≥", "=", "≈", "×"];

/// The text with fixed spaces where no line may end: before a per cent, around a relation, before a signed direction ("wall -x").
pub(crate) fn tied(text: &str) -> String {
    let mut said = String::with_capacity(text.len());
    let mut last = "";
    for (at, word) in text.split(' ').enumerate() {
        let is_share = word.starts_with('%') && last.ends_with(|sign: char| sign.is_ascii_digit());
        let is_direction = ["-", "+", "−"].iter().any(|sign| {
            let way = word.strip_prefix(sign).and_then(|way| way.chars().next());
            way.is_some_and(|way| matches!(way, 'x' | 'y' | 'z'))
        });
        if at > 0 {
            let is_tied = is_share || is_direction || RELATIONS.contains(&word) || RELATIONS.contains(&last);
            said.push(if is_tied { TIE } else { ' ' });
        }
        said.push_str(word);
        last = word;
    }
    said
}

/// The blocks, without figures.
pub(crate) fn document_text(document: &Document<'_>, style: TextStyle) -> String {
    document
        .blocks
        .iter()
        .map(|block| block_text(block, style))
        .collect()
}

/// One block.
pub(crate) fn block_text(block: &Block<'_>, style: TextStyle) -> String {
    let (language, columns) = (style.language, style.columns());
    let said = |sentence: &Sentence, first: &str, other: &str| {
        wrapped(&sentence.text(language), first, other, columns)
    };
    match block {
        Block::Heading(head) => heading_text(&head.text(language)),
        Block::Subheading(head) => format!("\n{}\n", head.text(language)),
        Block::Paragraph(sentences) => wrapped(&joined(sentences, language), "  ", "  ", columns),
        Block::Warning(sentence) => said(sentence, "  ! ", "    "),
        Block::Note(sentence) => said(sentence, "  * ", "    "),
        Block::List(points) => points.iter().map(|point| said(point, "  - ", "    ")).collect(),
        Block::KeyValues(rows) => key_values_text(rows, language),
        Block::Table(table) => {
            let caption = wrapped(&joined(&table.caption, language), "", "", columns);
            format!("\n{caption}{}", table_text(table, language, columns))
        }
        Block::Equation(of) => {
            wrapped(&linear(&of.formula), "      ", "        ", columns) + &said(&of.meaning, "  ", "  ")
        }
        Block::Figures(_) => String::new(),
        Block::Photos(photos) => photos.iter().map(|photo| photo_text(photo, style)).collect(),
        Block::Signatures(rows) => rows.iter().map(|row| signatory_text(row, style)).collect(),
        Block::Answers(answers) => {
            let line = |answer: &Answered| {
                let mark = format!("  {} ", answer.tone.sign());
                let [question, word] = [&answer.question, &answer.word].map(|said| said.text(language));
                wrapped(&format!("{question}: {word}"), &mark, "    ", columns)
            };
            answers.iter().map(line).collect()
        }
    }
}

/// The heading of a section, underlined.
pub(crate) fn heading_text(head: &str) -> String {
    format!("\n{head}\n{}\n", "-".repeat(head.width()))
}

/// Findings, a mark before each.
pub(crate) fn findings_text<'a>(findings: impl IntoIterator<Item = &'a Finding>, style: TextStyle) -> String {
    let said = |finding: &Finding| {
        let mark = format!("  {} ", finding.tone.sign());
        let code = finding.code.map_or_else(String::new, |code| format!(" [{code}]"));
        wrapped(
            &(finding.sentence.text(style.language) + &code),
            &mark,
            "    ",
            style.columns(),
        )
    };
    findings.into_iter().map(said).collect()
}

/// Sentences one after the other.
pub(crate) fn joined(sentences: &[Sentence], language: Language) -> String {
    let each: Vec<String> = sentences.iter().map(|sentence| sentence.text(language)).collect();
    each.join(" ")
}

/// "- photograph: its caption (its file)".
fn photo_text(photo: &Photo<'_>, style: TextStyle) -> String {
    let head = Sentence::from(Framed::Photo).text(style.language);
    let shows = photo.text(style.language);
    let line = match shows == photo.file {
        true => format!("{head}: {shows}"),
        false => format!("{head}: {shows} ({})", photo.file),
    };
    wrapped(&line, "  - ", "    ", style.columns())
}

fn signatory_text(row: &Signatory, style: TextStyle) -> String {
    let each = [&row.role, &row.name, &row.licence].map(|words| words.text(style.language));
    let given: Vec<String> = each.into_iter().filter(|words| !words.is_empty()).collect();
    wrapped(&given.join(", "), "  - ", "    ", style.columns())
}

fn key_values_text(rows: &[(Sentence, Cell)], language: Language) -> String {
    let keys: Vec<String> = rows.iter().map(|(key, _)| key.text(language)).collect();
    let widest = keys.iter().map(|key| key.width()).max().unwrap_or(0);
    let line = |(key, (_, cell)): (&String, &(Sentence, Cell))| {
        let gap = " ".repeat(widest - key.width());
        format!("  {key}{gap}   {}\n", cell.whole(language)).replace(NARROW_SPACE, " ")
    };
    keys.iter().zip(rows).map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_no_line_ends_inside_a_number() {
        let text = "확률은 80 %이다(p < 0.001). 2.411 ± 0.006 Hz, wall -x";
        for columns in 8..40 {
            let lines = wrapped(text, "", "", columns);
            for line in lines.lines().skip(1) {
                let first = line.split(' ').next().unwrap_or_default();
                let is_inner = ["%", "<", "±", "0.001", "0.006", "-x"];
                assert!(!is_inner.iter().any(|start| first.starts_with(start)), "{lines}");
            }
            assert_eq!(
                lines.split_whitespace().collect::<Vec<_>>(),
                text.split_whitespace().collect::<Vec<_>>()
            );
        }
    }
}
