//! Aligned columns of text; a Hangul character is two columns wide.

use unicode_width::UnicodeWidthStr as _;

/// Space between columns.
const GAP: &str = "   ";

/// A table filled row by row and printed once.
#[derive(Clone, Debug, Default)]
pub struct Table {
    rows: Vec<Vec<String>>,
    words: usize,
}

impl Table {
    /// A table with these headings; the first `words` columns contain words (aligned left), the others numbers (right).
    pub fn new(heads: &[&str], words: usize) -> Self {
        Table {
            rows: vec![heads.iter().map(|head| (*head).to_owned()).collect()],
            words,
        }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The table, each line indented by two spaces.
    pub fn text(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |j: usize| {
            self.rows
                .iter()
                .filter_map(|r| r.get(j))
                .map(|c| c.width())
                .max()
                .unwrap_or(0)
        };
        let widths: Vec<usize> = (0..columns).map(width).collect();
        let mut out = String::new();
        for row in &self.rows {
            let mut line = String::from("  ");
            for (j, cell) in row.iter().enumerate() {
                let padding = " ".repeat(widths[j] - cell.width());
                if j > 0 {
                    line.push_str(GAP);
                }
                if j < self.words {
                    line += &(cell.clone() + &padding);
                } else {
                    line += &(padding + cell);
                }
            }
            out.push_str(line.trim_end());
            out.push('\n');
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_columns_line_up_with_hangul() {
        let mut table = Table::new(&["part", "k"], 1);
        table.row(vec!["석당간".into(), "1.5".into()]);
        table.row(vec!["ab".into(), "10.25".into()]);
        assert_eq!(
            table.text(),
            "  part         k\n  석당간     1.5\n  ab       10.25\n"
        );
    }
}
