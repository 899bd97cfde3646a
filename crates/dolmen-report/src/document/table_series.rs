//! The numbers of a table as columns.

use super::blocks::{Cell, Column, Table};
use super::series::{Entries, Series};
use dolmen_words::{Language, Sentence};

/// The columns of a table, with numbers at full precision in the displayed units.
pub(crate) fn table_series(table: &Table) -> Vec<Series> {
    let columns = table.columns.iter().enumerate();
    let of_column = |(at, column): (usize, &Column)| {
        let cells = || table.rows.iter().filter_map(move |row| row.get(at));
        let units = || {
            cells()
                .filter_map(Cell::quantity)
                .map(|quantity| quantity.unit.symbol.as_str())
        };
        let entries = match column.is_words {
            true => Entries::Words(cells().map(word).collect()),
            false => Entries::Numbers(cells().map(number).collect()),
        };
        Series {
            name: column.head.clone(),
            // captions may give the unit of all columns
            unit: Some(column.unit.symbol.as_str())
                .filter(|symbol| !symbol.is_empty())
                .or_else(|| units().next())
                .unwrap_or_default()
                .to_owned(),
            entries,
        }
    };
    columns.map(of_column).collect()
}

fn number(cell: &Cell) -> Option<f64> {
    cell.quantity()
        .map(|quantity| quantity.value_si * quantity.unit.factor)
}

fn word(cell: &Cell) -> Sentence {
    match cell {
        Cell::Words(words) | Cell::BadWords(words) => words.clone(),
        Cell::Number(_) | Cell::Bad(_) | Cell::Rises(_) => Sentence::of_symbol(&cell.text(Language::English)),
    }
}
