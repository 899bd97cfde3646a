//! Blocks as paragraphs, tables and figures.

use super::contents::{Entry, mark};
use super::fault::DocxFault;
use super::inline::{Ink, field, paragraph, said, words};
use super::look::{BAD, BAD_WASH, TEXT_WIDTH, cell_margins, tone};
use super::picture::Media;
use super::table::{Grid, Shown, table};
use super::xml::Xml;
use crate::document::{
    Block, Cell, Document, Figure, Framed, Numbers, Photo, Signatory, Table, figure_label, table_label,
};
use dolmen_words::{Language, Sentence};

/// Twentieths of a point in a point.
const TWIPS: f64 = 20.0;
/// Width of the text, pt.
const WIDTH: f64 = TEXT_WIDTH as f64 / TWIPS;

/// A document in the making.
pub(super) struct Body<'a> {
    pub(super) language: Language,
    /// What stands before the contents.
    pub(super) front: Xml,
    pub(super) xml: Xml,
    pub(super) media: Media<'a>,
    pub(super) numbers: Numbers,
    pub(super) entries: Vec<Entry>,
    /// By how much heads stand below those of a report on one project.
    pub(super) deeper: usize,
    pub(super) marks: usize,
}

impl Body<'_> {
    pub(super) fn document(&mut self, document: &Document<'_>) -> Result<(), DocxFault> {
        document.blocks.iter().try_for_each(|block| self.block(block))
    }

    pub(super) fn block(&mut self, block: &Block<'_>) -> Result<(), DocxFault> {
        let language = self.language;
        let xml = &mut self.xml;
        match block {
            Block::Heading(head) => {
                let number = self.numbers.section();
                self.heading(1, &number, &head.text(language));
            }
            Block::Subheading(head) => {
                let number = self.numbers.part();
                self.heading(2, &number, &head.text(language));
            }
            Block::Paragraph(sentences) => said(xml, "BodyText", &joined(sentences, language)),
            Block::Warning(sentence) => shaded(xml, "Warning", [BAD, BAD_WASH], |xml| {
                words(xml, &sentence.text(language), Ink::PLAIN);
            }),
            Block::Note(sentence) => said(xml, "Remark", &sentence.text(language)),
            Block::List(points) => {
                for point in points {
                    said(xml, "ListBullet", &point.text(language));
                }
            }
            Block::KeyValues(rows) => self.key_values(rows),
            Block::Table(of) => self.table(of),
            Block::Figures(figures) => return self.figures(figures),
            Block::Photos(photos) => self.photos(photos),
            Block::Signatures(rows) => self.signatures(rows),
            Block::Answers(answers) => {
                for answer in answers {
                    let [colour, wash, sign] = tone(answer.tone);
                    let ink = Ink {
                        bold: true,
                        colour: Some(colour),
                    };
                    shaded(xml, "Judgement", [colour, wash], |xml| {
                        words(xml, &answer.question.text(language), Ink::PLAIN);
                        words(xml, &format!("  {sign} "), ink);
                        words(xml, &answer.word.text(language), ink);
                    });
                }
            }
        }
        Ok(())
    }

    /// A head, numbered by its style; `number` is what it comes to.
    pub(super) fn heading(&mut self, level: usize, number: &str, head: &str) {
        let level = level + self.deeper;
        self.marks += 1;
        let (id, mark) = (self.marks.to_string(), mark(self.marks));
        paragraph(
            &mut self.xml,
            &format!("Heading{level}"),
            |_| (),
            |xml| {
                xml.leaf("w:bookmarkStart", &[("w:id", &id), ("w:name", &mark)]);
                words(xml, head, Ink::PLAIN);
                xml.leaf("w:bookmarkEnd", &[("w:id", &id)]);
            },
        );
        if level <= 2 {
            self.entries.push(Entry {
                level,
                number: number.to_owned(),
                head: head.to_owned(),
                mark,
            });
        }
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
        self.grid(&Grid {
            heads: Vec::new(),
            is_words: vec![true, true],
            rows: rows.iter().map(row).collect(),
        });
    }

    /// A table below its caption; none where it has no column.
    fn table(&mut self, of: &Table) {
        let language = self.language;
        if of.columns.is_empty() {
            return;
        }
        let number = self.numbers.table();
        caption(
            &mut self.xml,
            &table_label(&number, language),
            &number,
            &of.caption,
            language,
            true,
        );
        let shown = |cell: &Cell| Shown {
            text: cell.text(language),
            is_bad: cell.is_bad(),
        };
        self.grid(&Grid {
            heads: of.columns.iter().map(|column| column.text(language)).collect(),
            is_words: of.columns.iter().map(|column| column.is_words).collect(),
            rows: of
                .rows
                .iter()
                .map(|row| row.iter().map(shown).collect())
                .collect(),
        });
    }

    /// A table, and the paragraph that keeps it from the next.
    fn grid(&mut self, grid: &Grid) {
        if grid.rows.is_empty() && grid.heads.is_empty() {
            return;
        }
        table(&mut self.xml, grid);
        paragraph(&mut self.xml, "AfterTable", |_| (), |_| ());
    }

    /// Photographs above their captions; those that were not read are left out, as in print.
    fn photos(&mut self, photos: &[Photo<'_>]) {
        let language = self.language;
        for photo in photos {
            let Some(image) = photo.image else { continue };
            let picture = self.media.photo(image, &photo.text(language), WIDTH);
            let number = self.numbers.figure();
            let label = figure_label(&number, language);
            paragraph(&mut self.xml, "Figure", |_| (), |xml| xml.append(picture));
            caption(&mut self.xml, &label, &number, &photo.caption, language, false);
        }
    }

    /// Rows to sign in, with room at the right.
    fn signatures(&mut self, rows: &[Signatory]) {
        let language = self.language;
        let shown = |words: &Sentence| Shown {
            text: words.text(language),
            is_bad: false,
        };
        let heads = [Framed::Role, Framed::Name, Framed::Licence, Framed::Signature];
        // room for a signature
        let room = || Shown {
            text: "\u{a0}".repeat(24),
            is_bad: false,
        };
        let row = |row: &Signatory| vec![shown(&row.role), shown(&row.name), shown(&row.licence), room()];
        self.grid(&Grid {
            heads: heads.map(|head| Sentence::from(head).text(language)).to_vec(),
            is_words: vec![true; 4],
            rows: rows.iter().map(row).collect(),
        });
    }

    /// Figures above their captions, two beside each other where there are several.
    fn figures(&mut self, figures: &[Figure<'_>]) -> Result<(), DocxFault> {
        if let [one] = figures {
            let drawn = self.figure(one, WIDTH)?;
            self.xml.append(drawn);
            return Ok(());
        }
        let half = (TEXT_WIDTH / 2).to_string();
        let drawn: Result<Vec<Xml>, DocxFault> = figures
            .iter()
            .map(|figure| self.figure(figure, 0.5 * WIDTH - 8.0))
            .collect();
        let mut drawn = drawn?.into_iter();
        let xml = &mut self.xml;
        xml.element("w:tbl", &[], |xml| {
            xml.element("w:tblPr", &[], |xml| {
                xml.leaf("w:tblW", &[("w:w", &TEXT_WIDTH.to_string()), ("w:type", "dxa")]);
                xml.leaf("w:tblLayout", &[("w:type", "fixed")]);
                cell_margins(xml, "70");
            });
            xml.element("w:tblGrid", &[], |xml| {
                for _ in 0..2 {
                    xml.leaf("w:gridCol", &[("w:w", &half)]);
                }
            });
            while let Some(left) = drawn.next() {
                xml.element("w:tr", &[], |xml| {
                    xml.element("w:trPr", &[], |xml| xml.leaf("w:cantSplit", &[]));
                    for one in [Some(left), drawn.next()] {
                        xml.element("w:tc", &[], |xml| {
                            xml.element("w:tcPr", &[], |xml| {
                                xml.leaf("w:tcW", &[("w:w", &half), ("w:type", "dxa")]);
                            });
                            match one {
                                Some(one) => xml.append(one),
                                None => paragraph(xml, "BodyText", |_| (), |_| ()),
                            }
                        });
                    }
                });
            }
        });
        paragraph(xml, "AfterTable", |_| (), |_| ());
        Ok(())
    }

    fn figure(&mut self, figure: &Figure<'_>, width_most: f64) -> Result<Xml, DocxFault> {
        let language = self.language;
        let alt = figure.caption.first().map(|lead| lead.text(language));
        let svg = (figure.draw)(language);
        let picture = self.media.picture(&svg, &alt.unwrap_or_default(), width_most)?;
        let number = self.numbers.figure();
        let mut xml = Xml::default();
        paragraph(&mut xml, "Figure", |_| (), |xml| xml.append(picture));
        caption(
            &mut xml,
            &figure_label(&number, language),
            &number,
            &figure.caption,
            language,
            false,
        );
        Ok(xml)
    }
}

/// A caption: its number counts itself anew where figures or tables are added; the first sentence stands out.
fn caption(
    xml: &mut Xml,
    label: &str,
    number: &str,
    sentences: &[Sentence],
    language: Language,
    keep_next: bool,
) {
    let word = label.strip_suffix(number).unwrap_or(label);
    let keep = |xml: &mut Xml| {
        if keep_next {
            xml.leaf("w:keepNext", &[]);
        }
    };
    paragraph(xml, "Caption", keep, |xml| {
        words(xml, word, Ink::BOLD);
        let counted = format!("SEQ {} \\* ARABIC", word.trim());
        match number.split_once('.') {
            Some((chapter, number)) => {
                field(xml, "STYLEREF 1 \\s", chapter, Ink::BOLD);
                words(xml, ".", Ink::BOLD);
                // LibreOffice begins anew only where the file says so, Word with each head as well
                let anew = if number == "1" { " \\r 1" } else { "" };
                field(xml, &format!("{counted} \\s 1{anew}"), number, Ink::BOLD);
            }
            None => field(xml, &counted, number, Ink::BOLD),
        }
        if let [lead, rest @ ..] = sentences {
            words(xml, "  ", Ink::PLAIN);
            words(xml, &lead.text(language), Ink::BOLD);
            if !rest.is_empty() {
                words(xml, &format!(" {}", joined(rest, language)), Ink::PLAIN);
            }
        }
    });
}

/// A paragraph on a ground of its own with a bar at its left.
pub(super) fn shaded(xml: &mut Xml, style: &str, colours: [&str; 2], inside: impl FnOnce(&mut Xml)) {
    let [colour, wash] = colours;
    let properties = |xml: &mut Xml| {
        xml.element("w:pBdr", &[], |xml| {
            for (side, eighths, colour) in [
                ("w:top", "2", wash),
                ("w:left", "24", colour),
                ("w:bottom", "2", wash),
            ] {
                xml.leaf(
                    side,
                    &[
                        ("w:val", "single"),
                        ("w:sz", eighths),
                        ("w:space", "6"),
                        ("w:color", colour),
                    ],
                );
            }
        });
        xml.leaf(
            "w:shd",
            &[("w:val", "clear"), ("w:color", "auto"), ("w:fill", wash)],
        );
    };
    paragraph(xml, style, properties, inside);
}

fn joined(sentences: &[Sentence], language: Language) -> String {
    let each: Vec<String> = sentences.iter().map(|sentence| sentence.text(language)).collect();
    each.join(" ")
}
