//! Tables: headings repeat on the next page, words left, numbers right.

use super::inline::{paragraph, words};
use crate::paper::xml::Xml;
use crate::paper::{BAD, Grid, Ink, WHOLE_ROWS, text_size, widths};

/// The height of a row for handwriting, twentieths of a point: 13 mm.
const FORM_ROW: &str = "737";

pub(super) fn table(xml: &mut Xml, grid: &Grid) {
    let half_points = text_size(grid.is_words.len());
    let style = match half_points {
        13 => "TableTextFine",
        15 => "TableTextSmall",
        _ => "TableText",
    };
    let widths = widths(grid, half_points);
    let total = widths.iter().sum::<usize>().to_string();
    xml.element("w:tbl", &[], |xml| {
        xml.element("w:tblPr", &[], |xml| {
            xml.leaf("w:tblStyle", &[("w:val", "DolmenTable")]);
            xml.leaf("w:tblW", &[("w:w", &total), ("w:type", "dxa")]);
            let first = if grid.heads.is_empty() { "0" } else { "1" };
            let value = if grid.heads.is_empty() { "0000" } else { "0020" };
            xml.leaf(
                "w:tblLook",
                &[
                    ("w:val", value),
                    ("w:firstRow", first),
                    ("w:lastRow", "0"),
                    ("w:firstColumn", "0"),
                    ("w:lastColumn", "0"),
                    ("w:noHBand", "1"),
                    ("w:noVBand", "1"),
                ],
            );
        });
        xml.element("w:tblGrid", &[], |xml| {
            for width in &widths {
                xml.leaf("w:gridCol", &[("w:w", &width.to_string())]);
            }
        });
        if !grid.heads.is_empty() {
            xml.element("w:tr", &[], |xml| {
                xml.element("w:trPr", &[], |xml| {
                    xml.leaf("w:cantSplit", &[]);
                    xml.leaf("w:tblHeader", &[]);
                });
                for (at, head) in grid.heads.iter().enumerate() {
                    cell(xml, widths[at], "bottom", |xml| {
                        line(xml, style, grid.is_words[at], head, Ink::BOLD, true);
                    });
                }
            });
        }
        for (number, row) in grid.rows.iter().enumerate() {
            // short tables stay on one page, longer ones break with four rows or more on either side
            let left = grid.rows.len() - number;
            let keep = left > 1 && (grid.rows.len() <= WHOLE_ROWS || number < 3 || left <= 4);
            xml.element("w:tr", &[], |xml| {
                xml.element("w:trPr", &[], |xml| {
                    xml.leaf("w:cantSplit", &[]);
                    if grid.is_form {
                        xml.leaf("w:trHeight", &[("w:val", FORM_ROW), ("w:hRule", "atLeast")]);
                    }
                });
                let side = if grid.is_form { "center" } else { "top" };
                for (at, shown) in row.iter().enumerate() {
                    let ink = match shown.is_bad {
                        true => Ink::bold(BAD),
                        false => Ink::PLAIN,
                    };
                    cell(xml, widths[at], side, |xml| {
                        line(xml, style, grid.is_words[at], &shown.text, ink, keep);
                    });
                }
            });
        }
    });
}

fn cell(xml: &mut Xml, width: usize, side: &str, inside: impl FnOnce(&mut Xml)) {
    xml.element("w:tc", &[], |xml| {
        xml.element("w:tcPr", &[], |xml| {
            xml.leaf("w:tcW", &[("w:w", &width.to_string()), ("w:type", "dxa")]);
            xml.leaf("w:vAlign", &[("w:val", side)]);
        });
        inside(xml);
    });
}

fn line(xml: &mut Xml, style: &str, is_words: bool, text: &str, ink: Ink, keep_next: bool) {
    let properties = |xml: &mut Xml| {
        if keep_next {
            xml.leaf("w:keepNext", &[]);
        }
        if !is_words {
            xml.leaf("w:jc", &[("w:val", "right")]);
        }
    };
    paragraph(xml, style, properties, |xml| words(xml, text, ink));
}
