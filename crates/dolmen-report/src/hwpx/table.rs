//! Tables: headings repeat on the next page, words left, numbers right.

use super::lines::{HUNDREDTHS_OF_TWIP, Lines, stretches, sub_list};
use super::looks::{Align, Ground, Letters, Lie, Style};
use super::picture::{margins, picture, place, size};
use crate::paper::xml::Xml;
use crate::paper::{
    BAD, Caption, Grid, Ink, Picture, Run, Shown, TEXT_WIDTH, WHOLE_ROWS, line_count, text_size, widths,
};

/// Hundredths of a point in a half-point.
const HALF_POINT: u32 = 50;
/// Space above and below the text of a cell.
const ROOM_ABOVE: usize = 170;
/// Space left and right of it; the column widths include it.
const ROOM_BESIDE: &str = "400";
/// Space for a caption of three lines below a picture, and above it.
const CAPTION: usize = 6500;

/// A row of a table.
struct Row<'a> {
    cells: Vec<(&'a str, Ink)>,
    is_head: bool,
}

pub(super) fn table(xml: &mut Xml, lines: &mut Lines<'_>, grid: &Grid) {
    let half_points = text_size(grid.is_words.len());
    let twips = widths(grid, half_points);
    let widths: Vec<usize> = twips.iter().map(|twips| twips * HUNDREDTHS_OF_TWIP).collect();
    let letters = Letters {
        size: u32::try_from(half_points).unwrap_or(17) * HALF_POINT,
        ..Style::TableText.letters()
    };
    let head = grid.heads.iter().map(|head| (head.as_str(), Ink::BOLD));
    let head: Vec<(&str, Ink)> = head.collect();
    let of = |shown: &'_ Shown| match shown.is_bad {
        true => Ink::bold(BAD),
        false => Ink::PLAIN,
    };
    let mut rows: Vec<Row<'_>> = Vec::new();
    if !head.is_empty() {
        rows.push(Row {
            cells: head,
            is_head: true,
        });
    }
    for row in &grid.rows {
        let cells = row.iter().map(|shown| (shown.text.as_str(), of(shown)));
        rows.push(Row {
            cells: cells.collect(),
            is_head: false,
        });
    }
    let last = rows.len().saturating_sub(1);
    // programs that recompute the layout take these as minimum
    let line = usize::try_from(letters.size * Style::TableText.lie().line / 100).unwrap_or(0);
    let height = |row: &Row<'_>| {
        let each = row.cells.iter().zip(&twips);
        let lines = each
            .map(|((text, _), width)| line_count(text, half_points, *width))
            .max();
        lines.unwrap_or(1) * line + 2 * ROOM_ABOVE
    };
    let heights: Vec<usize> = rows.iter().map(height).collect();
    let breaks = if grid.rows.len() > WHOLE_ROWS {
        "TABLE"
    } else {
        "NONE"
    };
    framed(xml, lines, (&heights, &widths, breaks), |xml, lines, at| {
        let Row { cells, is_head } = &rows[at];
        let ground = match *is_head || at == last {
            true => Ground::RowEnd,
            false => Ground::Row,
        };
        for (column, (text, ink)) in cells.iter().enumerate() {
            let lie = Lie {
                align: match grid.is_words[column] {
                    true => Align::Left,
                    false => Align::Right,
                },
                ..Style::TableText.lie()
            };
            let place = Place {
                row: at,
                column,
                sides: [widths[column], heights[at]],
                ground,
                is_head: *is_head,
                at_bottom: *is_head,
            };
            cell(xml, lines, place, |xml, lines| {
                let runs = [Run::Words((*text).to_owned(), *ink)];
                lines.paragraph(xml, Style::TableText, lie, |xml, looks| {
                    stretches(xml, looks, &runs, letters);
                });
            });
        }
    });
}

/// Pictures with their captions, two side by side.
pub(super) fn beside(xml: &mut Xml, lines: &mut Lines<'_>, pictures: &[(Picture, Caption)]) {
    let half = TEXT_WIDTH / 2 * HUNDREDTHS_OF_TWIP;
    let rows: Vec<&[(Picture, Caption)]> = pictures.chunks(2).collect();
    let height = |row: &&[(Picture, Caption)]| {
        let highest = row
            .iter()
            .map(|(picture, _)| picture.size_pt[1])
            .fold(0.0, f64::max);
        (highest * 100.0).round() as usize + CAPTION
    };
    let heights: Vec<usize> = rows.iter().map(height).collect();
    framed(
        xml,
        lines,
        (&heights, &[half, half], "TABLE"),
        |xml, lines, row| {
            for column in 0..2 {
                let place = Place {
                    row,
                    column,
                    sides: [half, heights[row]],
                    ground: Ground::None,
                    is_head: false,
                    at_bottom: false,
                };
                cell(xml, lines, place, |xml, lines| match rows[row].get(column) {
                    Some((of, caption)) => {
                        lines.paragraph(xml, Style::Figure, Style::Figure.lie(), |xml, looks| {
                            let letters = looks.letters(Style::Figure.letters()).to_string();
                            xml.element("hp:run", &[("charPrIDRef", &letters)], |xml| picture(xml, of));
                        });
                        lines.caption(xml, caption);
                    }
                    None => lines.paragraph(xml, Style::Body, Style::Body.lie(), |_, _| ()),
                });
            }
        },
    );
}

/// A table with these row heights and column widths; `row` writes its rows.
fn framed(
    xml: &mut Xml,
    lines: &mut Lines<'_>,
    (heights, widths, breaks): (&[usize], &[usize], &str),
    row: impl Fn(&mut Xml, &mut Lines<'_>, usize),
) {
    lines.tables += 1;
    let id = (2_000_000 + lines.tables).to_string();
    let (count, columns) = (heights.len().to_string(), widths.len().to_string());
    let attributes = [
        ("id", id.as_str()),
        ("zOrder", "0"),
        ("numberingType", "TABLE"),
        ("textWrap", "TOP_AND_BOTTOM"),
        ("textFlow", "BOTH_SIDES"),
        ("lock", "0"),
        ("dropcapstyle", "None"),
        ("pageBreak", breaks),
        ("repeatHeader", "1"),
        ("rowCnt", &count),
        ("colCnt", &columns),
        ("cellSpacing", "0"),
        ("borderFillIDRef", "1"),
        ("noAdjust", "0"),
    ];
    let width = widths.iter().sum::<usize>().to_string();
    let height = heights.iter().sum::<usize>().to_string();
    xml.element("hp:tbl", &attributes, |xml| {
        size(xml, &width, &height);
        place(xml, false);
        xml.leaf("hp:outMargin", &margins("0"));
        xml.leaf("hp:inMargin", &margins("0"));
        for at in 0..heights.len() {
            xml.element("hp:tr", &[], |xml| row(xml, lines, at));
        }
    });
}

struct Place {
    row: usize,
    column: usize,
    /// Width and height.
    sides: [usize; 2],
    ground: Ground,
    is_head: bool,
    at_bottom: bool,
}

fn cell(xml: &mut Xml, lines: &mut Lines<'_>, at: Place, inside: impl FnOnce(&mut Xml, &mut Lines<'_>)) {
    let fill = lines.looks.ground(at.ground).to_string();
    let head = if at.is_head { "1" } else { "0" };
    let attributes = [
        ("name", ""),
        ("header", head),
        ("hasMargin", "1"),
        ("protect", "0"),
        ("editable", "0"),
        ("dirty", "0"),
        ("borderFillIDRef", &fill),
    ];
    xml.element("hp:tc", &attributes, |xml| {
        let side = if at.at_bottom { "BOTTOM" } else { "TOP" };
        sub_list(xml, side, [0, 0], |xml| inside(xml, lines));
        let number = |value: usize| value.to_string();
        xml.leaf(
            "hp:cellAddr",
            &[("colAddr", &number(at.column)), ("rowAddr", &number(at.row))],
        );
        xml.leaf("hp:cellSpan", &[("colSpan", "1"), ("rowSpan", "1")]);
        xml.leaf(
            "hp:cellSz",
            &[("width", &number(at.sides[0])), ("height", &number(at.sides[1]))],
        );
        let above = ROOM_ABOVE.to_string();
        let room = [
            ("left", ROOM_BESIDE),
            ("right", ROOM_BESIDE),
            ("top", above.as_str()),
            ("bottom", above.as_str()),
        ];
        xml.leaf("hp:cellMargin", &room);
    });
}
