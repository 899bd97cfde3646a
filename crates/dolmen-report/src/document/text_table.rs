//! A table for a terminal: aligned columns, wrapped headings, and parts one below the other if it is too wide.

use super::blocks::{Cell, Table};
use dolmen_words::Language;
use dolmen_words::number::NARROW_SPACE;
use unicode_width::UnicodeWidthStr as _;

/// Space before the first column and between columns.
const MARGIN: usize = 2;
const GAP: usize = 2;
/// Candidate widths of columns due to their headings, the widest first.
const HEAD_WIDTHS: [usize; 5] = [24, 16, 12, 9, 1];
/// Width for headings of a table that needs several parts anyway.
const PART_HEAD_WIDTH: usize = 12;
/// Largest width of words in a cell.
const WORDS_MOST: usize = 30;

/// A column with its wrapped cells.
struct Set {
    head: Vec<String>,
    cells: Vec<Vec<String>>,
    width: usize,
    is_words: bool,
}

/// The table under its caption; `columns` is the terminal width.
pub(super) fn table_text(table: &Table, language: Language, columns: usize) -> String {
    let set = |head_width: usize| -> Vec<Set> {
        (0..table.columns.len())
            .map(|column| set_column(table, column, language, head_width))
            .collect()
    };
    let whole = HEAD_WIDTHS.into_iter().map(set);
    let fitting = whole.into_iter().find(|all| breadth(all.iter()) <= columns);
    match fitting {
        Some(all) => part_text(&all.iter().collect::<Vec<_>>()),
        None => {
            let all = set(PART_HEAD_WIDTH);
            let parts: Vec<String> = parts(&all, columns).iter().map(|part| part_text(part)).collect();
            parts.join("\n")
        }
    }
}

/// Columns that fit side by side, with the first column repeated in each part.
fn parts(all: &[Set], columns: usize) -> Vec<Vec<&Set>> {
    let Some((first, rest)) = all.split_first() else {
        return Vec::new();
    };
    let mut parts = vec![vec![first]];
    for column in rest {
        let last = parts.len() - 1;
        let with = breadth(parts[last].iter().copied().chain([column]));
        if with > columns && parts[last].len() > 1 {
            parts.push(vec![first, column]);
        } else {
            parts[last].push(column);
        }
    }
    parts
}

fn breadth<'a>(columns: impl Iterator<Item = &'a Set>) -> usize {
    columns.map(|column| column.width + GAP).sum::<usize>() + MARGIN - GAP
}

fn set_column(table: &Table, column: usize, language: Language, head_width: usize) -> Set {
    let is_words = table.columns[column].is_words;
    let text = |row: &Vec<Cell>| {
        let said = row
            .get(column)
            .map_or_else(String::new, |cell| cell.text(language));
        lines(&said, if is_words { WORDS_MOST } else { usize::MAX })
    };
    let cells: Vec<Vec<String>> = table.rows.iter().map(text).collect();
    let widest = cells.iter().flatten().map(|line| line.width()).max().unwrap_or(0);
    let head = table.columns[column].text(language);
    let longest = head.split(' ').map(|word| word.width()).max().unwrap_or(0);
    let head = lines(&head, widest.max(head_width).max(longest));
    let width = head.iter().map(|line| line.width()).fold(widest, usize::max);
    Set {
        head,
        cells,
        width,
        is_words,
    }
}

/// Lines of a text, broken only between words.
fn lines(text: &str, width: usize) -> Vec<String> {
    let options = textwrap::Options::new(width)
        .break_words(false)
        .word_separator(textwrap::WordSeparator::AsciiSpace)
        .wrap_algorithm(textwrap::WrapAlgorithm::FirstFit);
    let each = textwrap::wrap(text, options).into_iter();
    each.map(|line| line.replace(NARROW_SPACE, " ")).collect()
}

fn part_text(columns: &[&Set]) -> String {
    let head_lines = columns.iter().map(|column| column.head.len()).max().unwrap_or(0);
    let mut out = String::new();
    for at in 0..head_lines {
        // short headings are aligned to the bottom
        let of = |column: &Set| (at + column.head.len()).checked_sub(head_lines);
        out += &line(columns, |column| of(column).map_or("", |own| &column.head[own]));
    }
    let rows = columns.first().map_or(0, |column| column.cells.len());
    for row in 0..rows {
        let height = columns.iter().map(|column| column.cells[row].len()).max();
        for at in 0..height.unwrap_or(0) {
            out += &line(columns, |column| {
                column.cells[row].get(at).map_or("", String::as_str)
            });
        }
    }
    out
}

fn line<'a>(columns: &[&'a Set], text: impl Fn(&'a Set) -> &'a str) -> String {
    let mut out = " ".repeat(MARGIN);
    for (at, column) in columns.iter().enumerate() {
        let cell = text(column);
        let padding = " ".repeat(column.width - cell.width());
        if at > 0 {
            out += &" ".repeat(GAP);
        }
        match column.is_words {
            true => out += &(cell.to_owned() + &padding),
            false => out += &(padding + cell),
        }
    }
    out.truncate(out.trim_end().len());
    out + "\n"
}

#[cfg(test)]
mod tests {
    use super::super::blocks::Column;
    use super::*;
    use dolmen_words::{Quantity, Sentence, Unit};

    fn symbol(text: &str) -> Sentence {
        Sentence::of_symbol(text)
    }

    #[test]
    fn exact_columns_line_up_with_hangul_and_break_where_they_are_too_wide() {
        let number = |value: f64| Cell::number(Quantity::ratio(value, 3));
        let numbers = |head: &str| Column::numbers(symbol(head), Unit::ratio());
        let mut table = Table {
            caption: Vec::new(),
            columns: vec![
                Column::words(symbol("part")),
                numbers("k"),
                numbers("margin of it"),
            ],
            rows: vec![
                vec![Cell::words(symbol("석당간")), number(1.5), number(2.0)],
                vec![Cell::words(symbol("ab")), number(10.25), Cell::Number(None)],
            ],
        };
        let text = |table: &Table, columns| table_text(table, Language::English, columns);
        assert_eq!(
            text(&table, 80),
            "  part       k  margin of it\n  석당간  1.50          2.00\n  ab      10.2             –\n"
        );
        assert_eq!(
            text(&table, 24),
            "                margin\n  part       k   of it\n  석당간  1.50    2.00\n  ab      10.2       –\n"
        );
        for head in ["one", "two", "three"] {
            table.columns.push(numbers(head));
            for row in &mut table.rows {
                row.push(number(123.0));
            }
        }
        let narrow = text(&table, 24);
        assert!(narrow.lines().all(|line| line.width() <= 24), "{narrow}");
        assert_eq!(narrow.matches("석당간").count(), 4, "{narrow}");
    }
}
