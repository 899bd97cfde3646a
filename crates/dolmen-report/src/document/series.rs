//! The data of a figure: columns with names and units.

use dolmen_words::{Language, Sentence};

/// A data column of a figure.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    /// The quantity.
    pub(crate) name: Sentence,
    /// The unit of its numbers; empty for words and ratios.
    pub(crate) unit: String,
    pub(crate) entries: Entries,
}

/// Contents of a column.
#[derive(Clone, Debug)]
pub(crate) enum Entries {
    /// Names.
    Words(Vec<Sentence>),
    /// Numbers in the unit of the column; `None` if missing.
    Numbers(Vec<Option<f64>>),
}

impl Series {
    /// Numbers in a unit.
    pub(crate) fn numbers(
        name: impl Into<Sentence>,
        unit: &str,
        values: impl IntoIterator<Item = f64>,
    ) -> Self {
        Series {
            name: name.into(),
            unit: unit.to_owned(),
            entries: Entries::Numbers(values.into_iter().map(Some).collect()),
        }
    }

    /// Names.
    pub(crate) fn words(name: impl Into<Sentence>, words: impl IntoIterator<Item = Sentence>) -> Self {
        Series {
            name: name.into(),
            unit: String::new(),
            entries: Entries::Words(words.into_iter().collect()),
        }
    }

    /// "time (s)".
    pub(crate) fn head(&self, language: Language) -> String {
        match self.unit.as_str() {
            "" => self.name.text(language),
            unit => format!("{} ({unit})", self.name.text(language)),
        }
    }

    fn len(&self) -> usize {
        match &self.entries {
            Entries::Words(words) => words.len(),
            Entries::Numbers(numbers) => numbers.len(),
        }
    }

    fn entry(&self, row: usize, language: Language) -> String {
        match &self.entries {
            Entries::Words(words) => words.get(row).map_or(String::new(), |word| word.text(language)),
            Entries::Numbers(numbers) => match numbers.get(row) {
                Some(Some(number)) if number.is_finite() => format!("{number:?}"),
                _ => String::new(),
            },
        }
    }
}

/// Columns as CSV, with the byte order mark by which Excel recognises UTF-8. Short columns end in empty cells.
pub(crate) fn series_csv(series: &[Series], language: Language) -> String {
    let rows = series.iter().map(Series::len).max().unwrap_or(0);
    let heads = series.iter().map(|one| one.head(language));
    let mut csv = format!("\u{feff}{}", csv_row(heads));
    for row in 0..rows {
        csv += &csv_row(series.iter().map(|one| one.entry(row, language)));
    }
    csv
}

pub(crate) fn csv_row(cells: impl Iterator<Item = String>) -> String {
    let quoted = |text: String| match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text,
    };
    let cells: Vec<String> = cells.map(quoted).collect();
    cells.join(",") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_columns_as_csv() {
        let names = ["a, \"b\"", "c"].map(Sentence::of_symbol).to_vec();
        let words = Series {
            name: Sentence::of_symbol("link"),
            unit: String::new(),
            entries: Entries::Words(names),
        };
        let numbers = Series::numbers(Sentence::of_symbol("k"), "N/m", [0.1, f64::NAN, 1e-7]);
        let csv = series_csv(&[words, numbers], Language::English);
        assert_eq!(csv, "\u{feff}link,k (N/m)\n\"a, \"\"b\"\"\",0.1\nc,\n,1e-7\n");
    }
}
