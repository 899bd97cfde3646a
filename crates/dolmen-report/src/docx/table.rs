//! Tables: heads that repeat on the next page, words left, numbers right.

use super::inline::{Ink, paragraph, words};
use super::look::{BAD, TEXT_WIDTH};
use super::xml::Xml;
use unicode_width::UnicodeWidthStr as _;

/// A cell as it is shown.
pub(super) struct Shown {
    pub(super) text: String,
    pub(super) is_bad: bool,
}

/// Columns of a table: heads, and which hold words.
pub(super) struct Grid {
    /// None where the rows have no head.
    pub(super) heads: Vec<String>,
    pub(super) is_words: Vec<bool>,
    pub(super) rows: Vec<Vec<Shown>>,
}

/// From so many columns on the text is smaller.
const SMALL_FROM: usize = 7;
const FINE_FROM: usize = 10;
/// Room at both sides of a cell, twentieths of a point.
const ROOM: usize = 160;

/// The style of the text, its size in half-points.
fn text_style(columns: usize) -> (&'static str, usize) {
    match columns {
        FINE_FROM.. => ("TableTextFine", 13),
        SMALL_FROM.. => ("TableTextSmall", 15),
        _ => ("TableText", 17),
    }
}

/// The table.
pub(super) fn table(xml: &mut Xml, grid: &Grid) {
    let (style, half_points) = text_style(grid.is_words.len());
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
            // short tables stay on one page
            let keep = grid.rows.len() <= WHOLE_ROWS && number + 1 < grid.rows.len();
            xml.element("w:tr", &[], |xml| {
                xml.element("w:trPr", &[], |xml| xml.leaf("w:cantSplit", &[]));
                for (at, shown) in row.iter().enumerate() {
                    let ink = match shown.is_bad {
                        true => Ink {
                            bold: true,
                            colour: Some(BAD),
                        },
                        false => Ink::PLAIN,
                    };
                    cell(xml, widths[at], "top", |xml| {
                        line(xml, style, grid.is_words[at], &shown.text, ink, keep);
                    });
                }
            });
        }
    });
}

/// Tables of so many rows stay on one page.
const WHOLE_ROWS: usize = 12;

fn cell(xml: &mut Xml, width: usize, side: &str, inside: impl FnOnce(&mut Xml)) {
    xml.element("w:tc", &[], |xml| {
        xml.element("w:tcPr", &[], |xml| {
            xml.leaf("w:tcW", &[("w:w", &width.to_string()), ("w:type", "dxa")]);
            xml.leaf("w:vAlign", &[("w:val", side)]);
        });
        inside(xml);
    });
}

fn line(xml: &mut Xml, style: &str, is_words: bool, text: &str, ink: Ink<'_>, keep_next: bool) {
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

/// Widths of the columns, twentieths of a point: as their cells want them, or as the page has room.
fn widths(grid: &Grid, half_points: usize) -> Vec<usize> {
    // a letter is at most about 0.64 of its size wide, a Korean one twice that
    let wide = |text: &str| (text.width() * half_points * 64).div_ceil(10) + ROOM;
    let longest = |text: &str| text.split_whitespace().map(wide).max().unwrap_or(ROOM);
    let measured = (0..grid.is_words.len()).map(|at| {
        let head = grid.heads.get(at).map_or("", String::as_str);
        let cells = || {
            grid.rows
                .iter()
                .filter_map(|row| Some(row.get(at)?.text.as_str()))
        };
        let whole = cells().map(wide).max().unwrap_or(ROOM);
        // heads take two lines, and so may words; numbers never break
        let wanted = whole.max(longest(head)).max(wide(head) / 2 + ROOM);
        let least = match grid.is_words[at] {
            true => cells().map(longest).max().unwrap_or(ROOM).max(longest(head)),
            false => whole.max(longest(head)),
        };
        (least.min(wanted), wanted)
    });
    let measured: Vec<(usize, usize)> = measured.collect();
    let least: usize = measured.iter().map(|(least, _)| least).sum();
    let wanted: usize = measured.iter().map(|(_, wanted)| wanted).sum();
    let shared = |(low, high): &(usize, usize)| match (wanted <= TEXT_WIDTH, least <= TEXT_WIDTH) {
        (true, _) => *high,
        (false, true) => low + (high - low) * (TEXT_WIDTH - least) / (wanted - least).max(1),
        (false, false) => low * TEXT_WIDTH / least,
    };
    measured.iter().map(shared).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(cells: &[&str]) -> Grid {
        let shown = |text: &&str| Shown {
            text: (*text).to_owned(),
            is_bad: false,
        };
        Grid {
            heads: cells.iter().map(|_| "head".to_owned()).collect(),
            is_words: cells.iter().map(|cell| cell.contains(' ')).collect(),
            rows: vec![cells.iter().map(shown).collect()],
        }
    }

    #[test]
    fn holds_a_table_is_never_wider_than_the_text() {
        for cells in [
            vec!["1", "2"],
            vec![
                "long words that fill more than one line of the page, which has room for a hundred or so",
                "2.5",
            ],
            vec!["1234567890123456789012345"; 14],
        ] {
            let total: usize = widths(&grid(&cells), 17).iter().sum();
            assert!(total <= TEXT_WIDTH, "{total}");
        }
        let [words, number] = widths(&grid(&[&"word ".repeat(60), "123.45"]), 17)[..] else {
            panic!("two columns");
        };
        assert!(number >= 6 * 17 * 5 && words > 8 * number, "{words}, {number}");
    }
}
