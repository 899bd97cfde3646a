//! Findings and documents in the words for paper, whose reader can type no command and no key.

use crate::document::{Block, Cell, Document, Finding};
use dolmen_words::{Language, Sentence};

/// The findings in words for paper.
pub(crate) fn findings_on_paper(findings: &mut [Finding]) {
    for finding in findings {
        put_on_paper(&mut finding.sentence);
    }
}

/// The blocks in words for paper. Sentences that say nothing there go.
pub(crate) fn document_on_paper(document: &mut Document<'_>) {
    for block in &mut document.blocks {
        match block {
            Block::Heading(one) | Block::Subheading(one) | Block::Warning(one) | Block::Note(one) => {
                put_on_paper(one);
            }
            Block::Paragraph(all) | Block::List(all) => all_on_paper(all),
            Block::Table(table) => {
                all_on_paper(&mut table.caption);
                table
                    .columns
                    .iter_mut()
                    .for_each(|column| put_on_paper(&mut column.head));
                table.rows.iter_mut().flatten().for_each(cell_on_paper);
            }
            Block::Figures(figures) => {
                for figure in figures {
                    all_on_paper(&mut figure.caption);
                }
            }
            Block::KeyValues(rows) => {
                for (key, value) in rows {
                    put_on_paper(key);
                    cell_on_paper(value);
                }
            }
            Block::Equation(_) | Block::Photos(_) | Block::Signatures(_) | Block::Answers(_) => {}
        }
    }
    document.blocks.retain(|block| match block {
        Block::Warning(said) | Block::Note(said) => says_something(said),
        Block::Paragraph(all) | Block::List(all) => !all.is_empty(),
        _ => true,
    });
}

fn put_on_paper(sentence: &mut Sentence) {
    *sentence = sentence.on_paper();
}

fn all_on_paper(sentences: &mut Vec<Sentence>) {
    sentences.iter_mut().for_each(put_on_paper);
    sentences.retain(says_something);
}

fn cell_on_paper(cell: &mut Cell) {
    if let Cell::Words(words) | Cell::BadWords(words) = cell {
        put_on_paper(words);
    }
}

fn says_something(sentence: &Sentence) -> bool {
    !sentence.text(Language::English).is_empty()
}
