//! Pieces of the pages, as WordprocessingML.

use super::contents::{contents, mark};
use super::equation::equation;
use super::inline::{field, paragraph, tab, words};
use super::look::{MARGIN_SIDE, MARGIN_TOP, PAGE, cell_margins};
use super::picture::drawing;
use super::table::table;
use crate::paper::xml::Xml;
use crate::paper::{Caption, Heading, Ink, Paper, Paragraph, Picture, Piece, Role, Run, Shade, TEXT_WIDTH};
use dolmen_words::Language;

/// Adds a piece.
pub(super) fn put(xml: &mut Xml, piece: &Piece, paper: &Paper, language: Language) {
    match piece {
        Piece::Paragraph(paragraph) => line(xml, paragraph),
        Piece::Heading(of) => heading(xml, of),
        Piece::Caption(of) => caption(xml, of),
        Piece::Equation(formula) => equation(xml, formula),
        Piece::Table(grid) => table(xml, grid),
        Piece::Picture(picture, on_cover) => shown(xml, picture, !on_cover, on_cover.then_some("700")),
        Piece::Beside(pictures) => beside(xml, pictures),
        Piece::Gap(room) => {
            let room = room.map(|room| room.to_string());
            let properties = |xml: &mut Xml| spaced(xml, room.as_deref());
            paragraph(xml, "AfterTable", properties, |_| ());
        }
        Piece::PageBreak => xml.element("w:p", &[], |xml| {
            xml.element("w:r", &[], |xml| xml.leaf("w:br", &[("w:type", "page")]));
        }),
        Piece::Contents => contents(xml, paper, language),
        Piece::NextProject => xml.element("w:p", &[], |xml| xml.element("w:pPr", &[], section)),
    }
}

fn style(role: Role) -> &'static str {
    match role {
        Role::Body => "BodyText",
        Role::Remark => "Remark",
        Role::Bullet => "ListBullet",
        Role::Judgement => "Judgement",
        Role::Finding => "Finding",
        Role::Warning => "Warning",
        Role::FrontHeading => "FrontHeading",
        Role::Title => "Title",
        Role::Subtitle => "Subtitle",
    }
}

fn spaced(xml: &mut Xml, above: Option<&str>) {
    if let Some(above) = above {
        xml.leaf("w:spacing", &[("w:before", above)]);
    }
}

fn line(xml: &mut Xml, of: &Paragraph) {
    let above = of.room_above.map(|room| room.to_string());
    let properties = |xml: &mut Xml| {
        if of.keeps_next {
            xml.leaf("w:keepNext", &[]);
        }
        if let Some(shade) = of.shade {
            shaded(xml, shade);
        }
        spaced(xml, above.as_deref());
    };
    paragraph(xml, style(of.role), properties, |xml| {
        for run in &of.runs {
            match run {
                Run::Words(text, ink) => words(xml, text, *ink),
                Run::Tab => tab(xml),
            }
        }
    });
}

/// A background, with a bar at its left.
fn shaded(xml: &mut Xml, [colour, wash]: Shade) {
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
}

/// A heading, numbered by its style.
fn heading(xml: &mut Xml, of: &Heading) {
    let (id, mark) = (of.place.to_string(), mark(of.place));
    let style = format!("Heading{}", of.level);
    paragraph(
        xml,
        &style,
        |_| (),
        |xml| {
            xml.leaf("w:bookmarkStart", &[("w:id", &id), ("w:name", &mark)]);
            words(xml, &of.head, Ink::PLAIN);
            xml.leaf("w:bookmarkEnd", &[("w:id", &id)]);
        },
    );
}

/// A picture with its caption on the same page.
fn shown(xml: &mut Xml, picture: &Picture, with_next: bool, room_above: Option<&str>) {
    let properties = |xml: &mut Xml| {
        if !with_next {
            xml.leaf("w:keepNext", &[("w:val", "0")]);
        }
        spaced(xml, room_above);
    };
    paragraph(xml, "Figure", properties, |xml| xml.append(drawing(picture)));
}

fn beside(xml: &mut Xml, pictures: &[(Picture, Caption)]) {
    let half = (TEXT_WIDTH / 2).to_string();
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
        for row in pictures.chunks(2) {
            xml.element("w:tr", &[], |xml| {
                xml.element("w:trPr", &[], |xml| xml.leaf("w:cantSplit", &[]));
                for one in [row.first(), row.get(1)] {
                    xml.element("w:tc", &[], |xml| {
                        xml.element("w:tcPr", &[], |xml| {
                            xml.leaf("w:tcW", &[("w:w", &half), ("w:type", "dxa")]);
                        });
                        match one {
                            Some((picture, of)) => {
                                // a row does not keep with the next one
                                shown(xml, picture, false, None);
                                caption(xml, of);
                            }
                            None => paragraph(xml, "BodyText", |_| (), |_| ()),
                        }
                    });
                }
            });
        }
    });
}

/// A caption: its number updates when figures or tables are added; the first sentence is emphasised.
fn caption(xml: &mut Xml, of: &Caption) {
    let keep = |xml: &mut Xml| {
        if of.is_above {
            xml.leaf("w:keepNext", &[]);
        }
    };
    paragraph(xml, "Caption", keep, |xml| {
        words(xml, &of.word, Ink::BOLD);
        let counted = format!("SEQ {} \\* ARABIC", of.word.trim());
        match of.number.split_once('.') {
            Some((chapter, number)) => {
                field(xml, "STYLEREF 1 \\s", chapter, Ink::BOLD);
                words(xml, ".", Ink::BOLD);
                // LibreOffice restarts numbering only if the file says so; Word also with each heading
                let anew = if number == "1" { " \\r 1" } else { "" };
                field(xml, &format!("{counted} \\s 1{anew}"), number, Ink::BOLD);
            }
            None => field(xml, &counted, &of.number, Ink::BOLD),
        }
        if let Some(lead) = &of.lead {
            words(xml, "  ", Ink::PLAIN);
            words(xml, lead, Ink::BOLD);
        }
        if let Some(rest) = &of.rest {
            words(xml, &format!(" {rest}"), Ink::PLAIN);
        }
    });
}

/// Paper, margins and running lines of a section.
pub(super) fn section(xml: &mut Xml) {
    xml.element("w:sectPr", &[], |xml| {
        for (tag, id) in [("w:headerReference", "header"), ("w:footerReference", "footer")] {
            xml.leaf(tag, &[("w:type", "default"), ("r:id", id)]);
        }
        xml.leaf("w:pgSz", &[("w:w", PAGE[0]), ("w:h", PAGE[1])]);
        xml.leaf(
            "w:pgMar",
            &[
                ("w:top", MARGIN_TOP),
                ("w:right", MARGIN_SIDE),
                ("w:bottom", MARGIN_SIDE),
                ("w:left", MARGIN_SIDE),
                ("w:header", "737"),
                ("w:footer", "680"),
                ("w:gutter", "0"),
            ],
        );
        xml.leaf("w:titlePg", &[]);
    });
}
