//! Decides whether a text is a table of numbers. Errors never quote other text.

use super::date_text::is_date;
use super::dialect::{Decimal, Delimiter, Line, unquoted};
use crate::number::parse_cell;
use crate::wrong::DiffersFromATable;
use dolmen_words::message::{Argument, Run};
use dolmen_words::{Language, Sentence};

/// Statistics of a text that is not a table of numbers. A project may name any file of its user, so the error quotes nothing of the
/// text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotATable {
    /// Number of lines examined.
    pub lines: usize,
    /// Number of cells that are numbers, dates or times.
    pub numbers: usize,
    /// Number of cells that are not empty.
    pub cells: usize,
}

impl NotATable {
    fn sentence(&self) -> Sentence {
        DiffersFromATable::NotATable {
            lines: self.lines,
            numbers: self.numbers,
            cells: self.cells,
        }
        .into()
    }
}

impl std::fmt::Display for NotATable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.sentence().text(Language::English))
    }
}

impl std::error::Error for NotATable {}

impl Argument for NotATable {
    fn said(&self, language: Language) -> Vec<Run> {
        self.sentence().runs(language).to_vec()
    }
}

/// Number of numeric cells and of all cells in a line.
#[derive(Clone, Copy, Default)]
struct Count {
    numbers: usize,
    cells: usize,
}

impl Count {
    fn of(line: &Line<'_>, (delimiter, decimal): (Delimiter, Decimal)) -> Self {
        let is_number = |cell: &[u8]| {
            parse_cell(cell, decimal.byte()).is_some() || is_date(&String::from_utf8_lossy(cell))
        };
        let cells = delimiter.cells(line.text).into_iter().map(unquoted);
        let filled: Vec<&[u8]> = cells.filter(|cell| !cell.is_empty()).collect();
        Count {
            numbers: filled.iter().filter(|cell| is_number(cell)).count(),
            cells: filled.len(),
        }
    }

    fn is_whole(self) -> bool {
        self.numbers > 0 && self.numbers == self.cells
    }
}

fn sum(counts: &[Count]) -> Count {
    counts.iter().fold(Count::default(), |sum, line| Count {
        numbers: sum.numbers + line.numbers,
        cells: sum.cells + line.cells,
    })
}

/// Refuses a text whose first lines are not a table. At least half of the cells must be numbers, dates or times: in all lines, or in
/// those from `below_names` on, or in those from the first numeric line on if there are several.
pub(super) fn refuse_other_text(
    lines: &[Line<'_>],
    below_names: usize,
    dialect: (Delimiter, Decimal),
) -> Result<(), NotATable> {
    let counts: Vec<Count> = lines.iter().map(|line| Count::of(line, dialect)).collect();
    let is_table = |from: usize| {
        let sum = sum(counts.get(from..).unwrap_or_default());
        sum.numbers > 0 && 2 * sum.numbers >= sum.cells
    };
    let whole = |count: &&Count| count.is_whole();
    let first = counts.iter().position(|count| count.is_whole());
    let first = first.filter(|_| counts.iter().filter(whole).count() > 1);
    if is_table(0) || is_table(below_names) || first.is_some_and(is_table) {
        return Ok(());
    }
    let Count { numbers, cells } = sum(&counts);
    Err(NotATable {
        lines: lines.len(),
        numbers,
        cells,
    })
}

#[cfg(test)]
mod tests {
    use crate::records::{Header, RecordOptions, read_csv};

    fn refusal(text: &str, options: &RecordOptions) -> String {
        read_csv(text.as_bytes(), options).unwrap_err().to_string()
    }

    #[test]
    fn refuses_other_text_without_a_word_of_it() {
        let secret = "root:$y$j9T$abc:19000:0:99999:7:::\ndaemon:*:19000:0:99999:7:::\n";
        let rate = RecordOptions {
            sampling_rate_hz: Some(100.0),
            header: Header::Absent,
            ..Default::default()
        };
        for options in [RecordOptions::default(), rate.clone()] {
            assert_eq!(
                refusal(secret, &options),
                "the file does not look like a table of numbers (its first 2 lines hold 0 numbers in 2 cells): is it the right file?"
            );
        }
        let hosts = "127.0.0.1 localhost\n192.168.1.7 hidden\n";
        let letter = "Dear Ann,\nthe code of the gate is\n1234\nand that of the house, hidden\n";
        let one_line = "hidden";
        for text in [hosts, letter, one_line] {
            let said = refusal(text, &rate);
            assert!(
                said.starts_with("the file does not look like a table of numbers")
                    && !said.contains("hidden"),
                "{said}"
            );
        }
    }

    #[test]
    fn holds_a_cell_of_a_table_is_quoted() {
        for text in [
            "time,x\n0.00,1\n0.01,abc\n",
            "Date;Time;x\n2024-06-05;10:00:00.010;abc\n2024-06-05;10:00:00.020;1\n",
            "Recorder GMS\nSerial of the sensor\nMade for the tower of a church\nx y\n1 2\n3 4\n5 abc\n",
        ] {
            let said = refusal(
                text,
                &RecordOptions {
                    sampling_rate_hz: Some(100.0),
                    ..Default::default()
                },
            );
            assert!(
                said.contains("\"abc\" is not a number") || said.contains("column \"Date\""),
                "{said}"
            );
        }
    }
}
