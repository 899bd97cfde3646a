//! Blocks as calls.

use super::equation::equation;
use super::literal::{array, literal};
use super::parts::Parts;
use crate::document::{Answered, Block, Cell, Document, Figure, Framed, Photo, Signatory, Table, joined};
use dolmen_words::{Language, Sentence};

impl Parts {
    /// The blocks of a document, in their order.
    pub(super) fn document(&mut self, document: &Document<'_>) {
        let mut before: Option<&Block<'_>> = None;
        for (at, block) in document.blocks.iter().enumerate() {
            let is_first = matches!(before, Some(Block::Heading(_) | Block::Subheading(_)));
            match (block, document.blocks.get(at + 1)) {
                // a head and a sentence alone do not end a page
                (Block::Paragraph(sentences), Some(next)) if is_first && stands_whole(next) => {
                    self.call("lead", &joined(sentences, self.language));
                }
                _ => self.block(block),
            }
            before = Some(block);
        }
    }

    pub(super) fn block(&mut self, block: &Block<'_>) {
        let language = self.language;
        match block {
            Block::Heading(head) => self.heading(1, &head.text(language)),
            Block::Subheading(head) => self.heading(2, &head.text(language)),
            Block::Paragraph(sentences) => self.call("par", &joined(sentences, language)),
            Block::Warning(sentence) => self.call("warning", &sentence.text(language)),
            Block::Note(sentence) => self.call("note", &sentence.text(language)),
            Block::List(points) => self.list(points.iter().map(|point| point.text(language))),
            Block::KeyValues(rows) => {
                let row = |(key, cell): &(Sentence, Cell)| {
                    let value = marked(cell, &cell.whole(language));
                    format!("({}, {value})", literal(&key.text(language)))
                };
                let each: Vec<String> = rows.iter().map(row).collect();
                self.line(&format!("#pairs({})", each.join(", ")));
            }
            Block::Table(table) => self.table(table),
            Block::Equation(of) => {
                let meaning = literal(&of.meaning.text(language));
                self.line(&format!("#formula({}, {meaning})", equation(&of.formula)));
            }
            Block::Figures(figures) => self.figures(figures),
            Block::Photos(photos) => self.photos(photos),
            Block::Signatures(rows) => {
                let heads = [Framed::Role, Framed::Name, Framed::Licence, Framed::Signature];
                let heads = array(heads.map(|head| literal(&Sentence::from(head).text(language))));
                let row = |row: &Signatory| {
                    let words =
                        [&row.role, &row.name, &row.licence].map(|words| literal(&words.text(language)));
                    array(words)
                };
                let each: Vec<String> = rows.iter().map(row).collect();
                self.line(&format!("#signatures({heads}, {})", each.join(", ")));
            }
            Block::Answers(answers) => {
                let one = |answer: &Answered| {
                    let [question, word] =
                        [&answer.question, &answer.word].map(|said| literal(&said.text(language)));
                    format!("({question}, {}, {word})", literal(answer.tone.class()))
                };
                let each: Vec<String> = answers.iter().map(one).collect();
                self.line(&format!("#answers({})", each.join(", ")));
            }
        }
    }

    /// A table; nothing without a column.
    pub(super) fn table(&mut self, table: &Table) {
        let language = self.language;
        if table.columns.is_empty() {
            return;
        }
        let heads = array(table.columns.iter().map(|column| literal(&column.text(language))));
        let words = array(table.columns.iter().map(|column| column.is_words.to_string()));
        let rows = table
            .rows
            .iter()
            .map(|row| array(row.iter().map(|cell| marked(cell, &cell.text(language)))));
        let rows: Vec<String> = rows.collect();
        self.line(&format!(
            "#numbers(columns: {heads}, words: {words}, caption: {}, {})",
            caption(&table.caption, language),
            rows.join(", ")
        ));
    }

    fn figures(&mut self, figures: &[Figure<'_>]) {
        let language = self.language;
        let each: Vec<String> = figures
            .iter()
            .map(|figure| {
                let file = self.figure_file(&(figure.draw)(language));
                let lead = figure.caption.first();
                format!(
                    "drawing({}, alt: {}, caption: {})",
                    literal(&file),
                    literal(&lead.map_or(String::new(), |lead| lead.text(language))),
                    caption(&figure.caption, language)
                )
            })
            .collect();
        match each.as_slice() {
            [one] => self.line(&format!("#{one}")),
            several => self.line(&format!("#beside({})", several.join(", "))),
        }
    }

    fn photos(&mut self, photos: &[Photo<'_>]) {
        let language = self.language;
        let each: Vec<String> = photos
            .iter()
            .filter_map(|photo| {
                let file = self.photo_file(photo.image?);
                let lead = literal(&photo.text(language));
                let caption = caption(&photo.caption, language);
                Some(format!(
                    "photograph({}, alt: {lead}, caption: {caption})",
                    literal(&file)
                ))
            })
            .collect();
        match each.as_slice() {
            [] => {}
            [one] => self.line(&format!("#{one}")),
            several => self.line(&format!("#beside({})", several.join(", "))),
        }
    }
}

/// Whether a block is more than text.
fn stands_whole(block: &Block<'_>) -> bool {
    matches!(
        block,
        Block::Table(_) | Block::Figures(_) | Block::KeyValues(_) | Block::Photos(_) | Block::Warning(_)
    )
}

/// The text of a cell, marked if it must not be used.
fn marked(cell: &Cell, text: &str) -> String {
    match cell.is_bad() {
        true => format!("bad({})", literal(text)),
        false => literal(text),
    }
}

/// A caption with its first sentence emphasised.
fn caption(sentences: &[Sentence], language: Language) -> String {
    match sentences {
        [] => "none".to_owned(),
        [lead, rest @ ..] => format!(
            "said({}, {})",
            literal(&lead.text(language)),
            literal(&joined(rest, language))
        ),
    }
}
