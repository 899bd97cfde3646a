//! Blocks as paragraphs, tables and figures.

use super::{
    BAD, BAD_WASH, Caption, Grid, Heading, Ink, Media, PaperFault, Paragraph, Picture, Piece, Role, Run,
    Shade, Shown, TEXT_WIDTH, TWIPS, tone,
};
use crate::document::{
    Answered, Block, Cell, Document, Figure, Framed, Numbers, Photo, Signatory, Table, Tone, figure_label,
    joined, table_label,
};
use dolmen_words::{Language, Sentence};

/// Width of the text, pt.
pub(super) const WIDTH: f64 = TEXT_WIDTH as f64 / TWIPS;

/// A document in the making.
pub(super) struct Body<'a> {
    pub(super) language: Language,
    pub(super) pieces: Vec<Piece>,
    pub(super) media: Media<'a>,
    pub(super) numbers: Numbers,
    /// Additional heading depth, relative to a report on one project.
    pub(super) deeper: usize,
    pub(super) heads: usize,
}

impl Body<'_> {
    pub(super) fn document(&mut self, document: &Document<'_>) -> Result<(), PaperFault> {
        document.blocks.iter().try_for_each(|block| self.block(block))
    }

    pub(super) fn line(&mut self, role: Role, text: &str) {
        self.pieces.push(Piece::Paragraph(Paragraph::of(role, text)));
    }

    pub(super) fn shaded(&mut self, role: Role, shade: Shade, runs: Vec<Run>) {
        self.pieces.push(Piece::Paragraph(Paragraph {
            role,
            runs,
            shade: Some(shade),
            keeps_next: false,
            room_above: None,
        }));
    }

    pub(super) fn block(&mut self, block: &Block<'_>) -> Result<(), PaperFault> {
        let language = self.language;
        match block {
            Block::Heading(head) => {
                let number = self.numbers.section();
                self.heading(1, &number, &head.text(language));
            }
            Block::Subheading(head) => {
                let number = self.numbers.part();
                self.heading(2, &number, &head.text(language));
            }
            Block::Paragraph(sentences) => self.line(Role::Body, &joined(sentences, language)),
            Block::Warning(sentence) => {
                let said = Run::Words(sentence.text(language), Ink::PLAIN);
                self.shaded(Role::Warning, [BAD, BAD_WASH], vec![said]);
            }
            Block::Note(sentence) => self.line(Role::Remark, &sentence.text(language)),
            Block::List(points) => {
                for point in points {
                    self.line(Role::Bullet, &point.text(language));
                }
            }
            Block::KeyValues(rows) => self.key_values(rows),
            Block::Table(of) => self.table(of),
            Block::Equation(of) => {
                self.pieces.push(Piece::Equation(of.formula.clone()));
                self.line(Role::Remark, &of.meaning.text(language));
            }
            Block::Figures(figures) => return self.figures(figures),
            Block::Photos(photos) => self.photos(photos),
            Block::Signatures(rows) => self.signatures(rows),
            Block::Answers(answers) => {
                // one column per question, with its word below
                let word = |answer: &Answered| Shown {
                    text: format!("{} {}", tone(answer.tone)[2], answer.word.text(language)),
                    is_bad: answer.tone == Tone::Bad,
                };
                let question = |answer: &Answered| answer.question.text(language);
                self.pieces.push(Piece::Gap(None));
                self.grid(Grid {
                    heads: answers.iter().map(question).collect(),
                    is_words: vec![true; answers.len()],
                    is_form: false,
                    rows: vec![answers.iter().map(word).collect()],
                });
            }
        }
        Ok(())
    }

    /// A heading with its number.
    pub(super) fn heading(&mut self, level: usize, number: &str, head: &str) {
        self.heads += 1;
        self.pieces.push(Piece::Heading(Heading {
            level: level + self.deeper,
            number: number.to_owned(),
            head: head.to_owned(),
            place: self.heads,
        }));
    }

    fn key_values(&mut self, rows: &[(Sentence, Cell)]) {
        let language = self.language;
        let row = |(key, cell): &(Sentence, Cell)| {
            let key = Shown {
                text: key.text(language),
                is_bad: false,
            };
            let value = Shown {
                text: cell.whole(language),
                is_bad: cell.is_bad(),
            };
            vec![key, value]
        };
        self.grid(Grid {
            heads: Vec::new(),
            is_words: vec![true, true],
            is_form: false,
            rows: rows.iter().map(row).collect(),
        });
    }

    /// A table below its caption; nothing without a column.
    fn table(&mut self, of: &Table) {
        let language = self.language;
        if of.columns.is_empty() {
            return;
        }
        let number = self.numbers.table();
        let caption = caption(
            &table_label(&number, language),
            &number,
            &of.caption,
            language,
            true,
        );
        self.pieces.push(Piece::Caption(caption));
        let shown = |cell: &Cell| Shown {
            text: cell.text(language),
            is_bad: cell.is_bad(),
        };
        self.grid(Grid {
            heads: of.columns.iter().map(|column| column.text(language)).collect(),
            is_words: of.columns.iter().map(|column| column.is_words).collect(),
            is_form: false,
            rows: of
                .rows
                .iter()
                .map(|row| row.iter().map(shown).collect())
                .collect(),
        });
    }

    /// A table, and a gap before the next one.
    fn grid(&mut self, grid: Grid) {
        if grid.rows.is_empty() && grid.heads.is_empty() {
            return;
        }
        self.pieces.push(Piece::Table(grid));
        self.pieces.push(Piece::Gap(None));
    }

    /// Pictures above their captions; several stand two side by side.
    fn pictures(&mut self, mut shown: Vec<(Picture, Caption)>) {
        match shown.len() {
            0 => {}
            1 => {
                for (picture, caption) in shown.drain(..) {
                    self.pieces.push(Piece::Picture(picture, false));
                    self.pieces.push(Piece::Caption(caption));
                }
            }
            _ => {
                self.pieces.push(Piece::Beside(shown));
                self.pieces.push(Piece::Gap(None));
            }
        }
    }

    /// Photographs; unread ones are left out, as in print.
    fn photos(&mut self, photos: &[Photo<'_>]) {
        let language = self.language;
        let read: Vec<_> = photos
            .iter()
            .filter_map(|photo| Some((photo, photo.image?)))
            .collect();
        let width = match read.len() {
            1 => WIDTH,
            _ => 0.5 * WIDTH - 8.0,
        };
        let mut shown: Vec<(Picture, Caption)> = Vec::with_capacity(read.len());
        for (photo, image) in read {
            let picture = self.media.photo(image, &photo.text(language), width);
            let number = self.numbers.figure();
            let label = figure_label(&number, language);
            shown.push((picture, caption(&label, &number, &photo.caption, language, false)));
        }
        self.pictures(shown);
    }

    /// Rows for signatures, with space at the right.
    fn signatures(&mut self, rows: &[Signatory]) {
        let language = self.language;
        let shown = |words: &Sentence| Shown {
            text: words.text(language),
            is_bad: false,
        };
        let heads = [Framed::Role, Framed::Name, Framed::Licence, Framed::Signature];
        // space for a signature
        let room = || Shown {
            text: "\u{a0}".repeat(24),
            is_bad: false,
        };
        let row = |row: &Signatory| vec![shown(&row.role), shown(&row.name), shown(&row.licence), room()];
        self.grid(Grid {
            heads: heads.map(|head| Sentence::from(head).text(language)).to_vec(),
            is_words: vec![true; 4],
            is_form: true,
            rows: rows.iter().map(row).collect(),
        });
    }

    /// Figures above their captions; several stand two side by side.
    fn figures(&mut self, figures: &[Figure<'_>]) -> Result<(), PaperFault> {
        let width = match figures.len() {
            1 => WIDTH,
            _ => 0.5 * WIDTH - 8.0,
        };
        let drawn: Result<Vec<(Picture, Caption)>, PaperFault> =
            figures.iter().map(|figure| self.figure(figure, width)).collect();
        self.pictures(drawn?);
        Ok(())
    }

    fn figure(&mut self, figure: &Figure<'_>, width_most: f64) -> Result<(Picture, Caption), PaperFault> {
        let language = self.language;
        let alt = figure.caption.first().map(|lead| lead.text(language));
        let svg = (figure.draw)(language);
        let picture = self.media.picture(&svg, &alt.unwrap_or_default(), width_most)?;
        let number = self.numbers.figure();
        let caption = caption(
            &figure_label(&number, language),
            &number,
            &figure.caption,
            language,
            false,
        );
        Ok((picture, caption))
    }
}

/// A caption; its first sentence is emphasised.
fn caption(label: &str, number: &str, sentences: &[Sentence], language: Language, is_above: bool) -> Caption {
    let (lead, rest) = match sentences {
        [lead, rest @ ..] => (Some(lead.text(language)), rest),
        [] => (None, sentences),
    };
    Caption {
        word: label.strip_suffix(number).unwrap_or(label).to_owned(),
        number: number.to_owned(),
        lead,
        rest: (!rest.is_empty()).then(|| joined(rest, language)),
        is_above,
    }
}
