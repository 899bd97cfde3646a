//! Pieces of the pages, as paragraphs of sections.

use super::equation::equation;
use super::lines::{HUNDREDTHS_OF_TWIP, Lines, stretches, sub_list, written};
use super::looks::{Letters, Lie, Looks, Style};
use super::picture::picture;
use super::spaces::SPACES;
use super::table::{beside, table};
use crate::document::linear;
use crate::paper::xml::{Attributes, Xml};
use crate::paper::{Heading, Ink, Paper, Paragraph, Picture, Piece, Run, TEXT_WIDTH};
use dolmen_words::Language;

/// Heights of the running lines.
const RUNNING: usize = 2000;

/// A document in the making.
pub(super) struct Writer<'a> {
    paper: &'a Paper,
    language: Language,
    looks: Looks,
    tables: usize,
    paragraphs: u32,
    breaks: bool,
    opening: Option<Xml>,
    xml: Xml,
    sections: Vec<Xml>,
    /// The preview text.
    text: String,
}

impl<'a> Writer<'a> {
    pub(super) fn new(paper: &'a Paper, language: Language) -> Self {
        let mut writer = Writer {
            paper,
            language,
            looks: Looks::new(),
            tables: 0,
            paragraphs: 0,
            breaks: false,
            opening: None,
            xml: Xml::default(),
            sections: Vec::new(),
            text: String::new(),
        };
        writer.opening = Some(writer.opened());
        writer
    }

    /// Adds a piece.
    pub(super) fn put(&mut self, piece: &Piece) {
        match piece {
            Piece::Paragraph(of) => self.line(of),
            Piece::Heading(of) => self.heading(of),
            Piece::Caption(of) => self.with_lines(|xml, lines| lines.caption(xml, of)),
            Piece::Equation(formula) => {
                self.text.push_str(&linear(formula));
                self.text.push_str("\r\n");
                let number = self.paragraphs as usize;
                self.with_lines(|xml, lines| {
                    lines.holding(xml, Style::Figure, Style::Figure.lie(), |xml, _| {
                        xml.element("hp:run", &[("charPrIDRef", "0")], |xml| {
                            equation(xml, formula, number);
                        });
                    });
                });
            }
            Piece::Table(grid) => self.with_lines(|xml, lines| {
                lines.holding(xml, Style::Normal, Style::Normal.lie(), |xml, lines| {
                    xml.element("hp:run", &[("charPrIDRef", "0")], |xml| table(xml, lines, grid));
                });
            }),
            Piece::Picture(of, on_cover) => self.picture(of, *on_cover),
            Piece::Beside(pictures) => self.with_lines(|xml, lines| {
                lines.holding(xml, Style::Normal, Style::Normal.lie(), |xml, lines| {
                    xml.element("hp:run", &[("charPrIDRef", "0")], |xml| {
                        beside(xml, lines, pictures)
                    });
                });
            }),
            Piece::Gap(room) => self.gap(*room),
            Piece::PageBreak => self.breaks = true,
            Piece::Contents => self.contents(),
            Piece::NextProject => {
                self.sections.push(std::mem::take(&mut self.xml));
                self.opening = Some(self.opened());
            }
        }
    }

    /// The sections, their formats, and their preview text.
    pub(super) fn finish(mut self) -> (Vec<String>, Looks, String) {
        self.sections.push(self.xml);
        let section = |body: Xml| {
            let mut xml = Xml::document();
            xml.element("hs:sec", &SPACES, |xml| xml.append(body));
            xml.finish()
        };
        let sections = self.sections.into_iter().map(section).collect();
        (sections, self.looks, self.text)
    }

    fn with_lines(&mut self, write: impl FnOnce(&mut Xml, &mut Lines<'_>)) {
        let mut lines = Lines {
            looks: &mut self.looks,
            tables: self.tables,
            paragraphs: self.paragraphs,
            breaks: self.breaks,
            opening: self.opening.take(),
        };
        write(&mut self.xml, &mut lines);
        (self.tables, self.paragraphs) = (lines.tables, lines.paragraphs);
        (self.breaks, self.opening) = (lines.breaks, lines.opening);
    }

    fn words(&mut self, style: Style, lie: Lie, runs: &[Run]) {
        for run in runs {
            match run {
                Run::Words(text, _) => self.text.push_str(text),
                Run::Tab => self.text.push(' '),
            }
        }
        self.text.push_str("\r\n");
        self.with_lines(|xml, lines| {
            lines.paragraph(xml, style, lie, |xml, looks| {
                stretches(xml, looks, runs, style.letters());
            });
        });
    }

    fn line(&mut self, of: &Paragraph) {
        let style = Style::of(of.role);
        let mut lie = style.lie();
        if let Some(shade) = of.shade {
            lie.ground = super::looks::Ground::Shade(shade);
        }
        if let Some(twips) = of.room_above {
            lie.above = hundredths(twips);
        }
        self.words(style, lie, &of.runs);
    }

    fn heading(&mut self, of: &Heading) {
        let style = Style::heading(of.level);
        self.words(style, style.lie(), &[Run::Words(of.head.clone(), Ink::PLAIN)]);
    }

    fn picture(&mut self, of: &Picture, on_cover: bool) {
        let mut lie = Style::Figure.lie();
        if on_cover {
            (lie.above, lie.keep_next) = (3500, false);
        }
        self.with_lines(|xml, lines| {
            lines.paragraph(xml, Style::Figure, lie, |xml, looks| {
                written(xml, looks, Style::Figure.letters(), |xml| picture(xml, of));
            });
        });
    }

    /// An empty line of this height.
    fn gap(&mut self, room: Option<u32>) {
        let lie = Lie {
            above: room.map_or(0, hundredths),
            below: 300,
            line: 100,
            ..Style::Normal.lie()
        };
        let letters = Letters {
            size: 600,
            ..Style::Normal.letters()
        };
        self.with_lines(|xml, lines| {
            lines.paragraph(xml, Style::Normal, lie, |xml, looks| {
                written(xml, looks, letters, |xml| xml.leaf("hp:t", &[]));
            });
        });
    }

    /// The headings of two levels, without pages: Hangul makes contents with pages from the outline.
    fn contents(&mut self) {
        let head = self.language.pick("Contents", "목차");
        let style = Style::ContentsHeading;
        self.words(style, style.lie(), &[Run::Words(head.to_owned(), Ink::PLAIN)]);
        let paper = self.paper;
        for entry in paper.entries() {
            let style = match entry.level {
                1 => Style::Contents1,
                _ => Style::Contents2,
            };
            let text = format!("{}  {}", entry.number, entry.head);
            self.words(style, style.lie(), &[Run::Words(text, Ink::PLAIN)]);
        }
    }

    /// Paper, margins and running lines of a section. The first page is a cover and has no running lines.
    fn opened(&mut self) -> Xml {
        let mut xml = Xml::default();
        let number = |value: usize| value.to_string();
        paper_and_margins(&mut xml);
        let columns = [
            ("id", ""),
            ("type", "NEWSPAPER"),
            ("layout", "LEFT"),
            ("colCount", "1"),
            ("sameSz", "1"),
            ("sameGap", "0"),
        ];
        xml.element("hp:ctrl", &[], |xml| xml.leaf("hp:colPr", &columns));
        let style = Style::Running;
        let (lie, letters) = (self.looks.lie(style.lie()), self.looks.letters(style.letters()));
        let (lie, letters, style) = (number(lie), number(letters), number(style.number()));
        let run = [("charPrIDRef", letters.as_str())];
        let mut running = |tag: &str, side: &str, left: &str, right: &dyn Fn(&mut Xml, Attributes<'_>)| {
            let id = number(self.sections.len() + 1);
            let attributes = [("id", id.as_str()), ("applyPageType", "BOTH")];
            let sides = [TEXT_WIDTH * HUNDREDTHS_OF_TWIP, RUNNING];
            xml.element("hp:ctrl", &[], |xml| {
                xml.element(tag, &attributes, |xml| {
                    sub_list(xml, side, sides, |xml| {
                        let attributes = [
                            ("id", "0"),
                            ("paraPrIDRef", lie.as_str()),
                            ("styleIDRef", &style),
                            ("pageBreak", "0"),
                            ("columnBreak", "0"),
                            ("merged", "0"),
                        ];
                        xml.element("hp:p", &attributes, |xml| {
                            xml.element("hp:run", &run, |xml| xml.words("hp:t", &[], left));
                            xml.element("hp:run", &run, |xml| {
                                xml.element("hp:t", &[], |xml| {
                                    let tab = [("width", "1000"), ("leader", "0"), ("type", "2")];
                                    xml.leaf("hp:tab", &tab);
                                });
                            });
                            right(xml, &run);
                        });
                    });
                });
            });
        };
        let paper = self.paper;
        running("hp:header", "TOP", &paper.title, &|xml, run| {
            xml.element("hp:run", run, |xml| xml.words("hp:t", &[], paper.kind));
        });
        running("hp:footer", "BOTTOM", &paper.program, &|xml, run| {
            xml.element("hp:run", run, |xml| page_number(xml, "PAGE"));
            xml.element("hp:run", run, |xml| xml.words("hp:t", &[], " / "));
            xml.element("hp:run", run, |xml| page_number(xml, "TOTAL_PAGE"));
        });
        xml
    }
}

/// Paper, margins, and the elements hidden on the first page.
fn paper_and_margins(xml: &mut Xml) {
    let attributes = [
        ("id", ""),
        ("textDirection", "HORIZONTAL"),
        ("spaceColumns", "1134"),
        ("tabStop", "8000"),
        ("outlineShapeIDRef", "1"),
        ("memoShapeIDRef", "0"),
        ("textVerticalWidthHead", "0"),
        ("masterPageCnt", "0"),
    ];
    xml.element("hp:secPr", &attributes, |xml| {
        let grid = [("lineGrid", "0"), ("charGrid", "0"), ("wonggojiFormat", "0")];
        xml.leaf("hp:grid", &grid);
        let start = [
            ("pageStartsOn", "BOTH"),
            ("page", "0"),
            ("pic", "0"),
            ("tbl", "0"),
            ("equation", "0"),
        ];
        xml.leaf("hp:startNum", &start);
        let seen = [
            ("hideFirstHeader", "1"),
            ("hideFirstFooter", "1"),
            ("hideFirstMasterPage", "0"),
            ("border", "SHOW_ALL"),
            ("fill", "SHOW_ALL"),
            ("hideFirstPageNum", "1"),
            ("hideFirstEmptyLine", "0"),
            ("showLineNumber", "0"),
        ];
        xml.leaf("hp:visibility", &seen);
        let page = [
            ("landscape", "WIDELY"),
            ("width", "59528"),
            ("height", "84188"),
            ("gutterType", "LEFT_ONLY"),
        ];
        xml.element("hp:pagePr", &page, |xml| {
            let margin = [
                ("header", "3685"),
                ("footer", "3400"),
                ("gutter", "0"),
                ("left", "6520"),
                ("right", "6520"),
                ("top", "3685"),
                ("bottom", "3120"),
            ];
            xml.leaf("hp:margin", &margin);
        });
    });
}

fn page_number(xml: &mut Xml, of: &str) {
    xml.element("hp:ctrl", &[], |xml| {
        xml.element("hp:autoNum", &[("num", "1"), ("numType", of)], |xml| {
            let format = [
                ("type", "DIGIT"),
                ("userChar", ""),
                ("prefixChar", ""),
                ("suffixChar", ""),
                ("supscript", "0"),
            ];
            xml.leaf("hp:autoNumFormat", &format);
        });
    });
}

fn hundredths(twips: u32) -> u32 {
    twips * HUNDREDTHS_OF_TWIP as u32
}
