//! Tables: the text of their cells, and the width of their columns.

use super::ink::TEXT_WIDTH;
use unicode_width::UnicodeWidthStr as _;

/// A cell as shown.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) text: String,
    pub(crate) is_bad: bool,
}

/// Columns of a table: headings, and which contain words.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    /// Empty if the rows have no heading.
    pub(crate) heads: Vec<String>,
    pub(crate) is_words: Vec<bool>,
    /// Rows have room to write in.
    pub(crate) is_form: bool,
    pub(crate) rows: Vec<Vec<Shown>>,
}

/// Tables with at least this many columns have smaller text.
const SMALL_FROM: usize = 7;
const FINE_FROM: usize = 10;
/// Space on both sides of a cell, twentieths of a point.
const ROOM: usize = 160;

/// Tables of at most this many rows stay on one page.
pub(crate) const WHOLE_ROWS: usize = 12;

/// Text size of a table with this many columns, half-points.
pub(crate) fn text_size(columns: usize) -> usize {
    match columns {
        FINE_FROM.. => 13,
        SMALL_FROM.. => 15,
        _ => 17,
    }
}

/// Width of a text on one line with the space of its cell, twentieths of a point.
fn wide(text: &str, half_points: usize) -> usize {
    // a letter is at most about 0.64 times its size wide, a Korean one twice that, and these up to 1.05
    let broad = text
        .chars()
        .filter(|sign| matches!(sign, 'm' | 'M' | 'w' | 'W' | '%'))
        .count();
    ((text.width_cjk() * 64 + broad * 41) * half_points).div_ceil(10) + ROOM
}

/// Approximate number of lines of a cell's text in a column of this width.
pub(crate) fn line_count(text: &str, half_points: usize, width: usize) -> usize {
    let words = wide(text, half_points) - ROOM;
    words.div_ceil(width.saturating_sub(ROOM).max(1)).max(1)
}

/// Widths of the columns, twentieths of a point: as their cells need, limited by the page.
pub(crate) fn widths(grid: &Grid, half_points: usize) -> Vec<usize> {
    let wide = |text: &str| wide(text, half_points);
    let longest = |text: &str| text.split_whitespace().map(wide).max().unwrap_or(ROOM);
    // heads are bold
    let bold = |plain: usize| (plain - ROOM) * 11 / 10 + ROOM;
    let measured = (0..grid.is_words.len()).map(|at| {
        let head = grid.heads.get(at).map_or("", String::as_str);
        let cells = || {
            grid.rows
                .iter()
                .filter_map(|row| Some(row.get(at)?.text.as_str()))
        };
        let whole = cells().map(wide).max().unwrap_or(ROOM);
        // headings and words may take two lines; numbers never break
        let longest_of_head = bold(longest(head));
        let wanted = whole.max(longest_of_head).max(wide(head) / 2 + ROOM);
        let least = match grid.is_words[at] {
            true => cells().map(longest).max().unwrap_or(ROOM).max(longest_of_head),
            false => whole.max(longest_of_head),
        };
        (least.min(wanted), wanted)
    });
    let measured: Vec<(usize, usize)> = measured.collect();
    let least: usize = measured.iter().map(|(least, _)| least).sum();
    let wanted: usize = measured.iter().map(|(_, wanted)| wanted).sum();
    let shared = |(low, high): &(usize, usize)| match (wanted <= TEXT_WIDTH, least <= TEXT_WIDTH) {
        // only the space for writing remains
        (true, _) if grid.is_form && wanted > 0 => high * TEXT_WIDTH / wanted,
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
            is_form: false,
            rows: vec![cells.iter().map(shown).collect()],
        }
    }

    #[test]
    fn holds_a_unit_of_broad_letters_fits_into_its_column() {
        // each m is 1.04 of its size wide in DejaVu Sans Bold, the fallback font
        let [column] = widths(
            &Grid {
                heads: vec!["change (mm/m)".to_owned()],
                ..grid(&["0.58"])
            },
            17,
        )[..] else {
            panic!("one column");
        };
        let letters = 3.0 * 1.042 + 0.365 + 2.0 * 0.457;
        assert!(column as f64 >= letters * 17.0 * 10.0 + ROOM as f64, "{column}");
    }

    #[test]
    fn holds_a_word_of_broad_letters_does_not_break() {
        let [column] = widths(&grid(&["unknown"]), 15)[..] else {
            panic!("one column");
        };
        // of DejaVu Sans: n and u 0.634 of its size wide, k 0.579, o 0.612, w 0.818
        let letters = 4.0 * 0.634 + 0.579 + 0.612 + 0.818;
        assert!(column as f64 >= letters * 15.0 * 10.0 + ROOM as f64, "{column}");
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
