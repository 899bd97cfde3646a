//! Any bytes are a table of parts or an error, whatever its name says it is.

use dolmen_records::{SheetValue, read_sheet};

pub(super) fn run(bytes: &[u8]) {
    for file in ["a.csv", "a.xlsx", "a.ods"] {
        for sheet in [None, Some("stones")] {
            let Ok(rows) = read_sheet(bytes, file, sheet) else {
                continue;
            };
            assert!(rows.len() >= 2);
            let mut cells = rows.iter().flatten();
            assert!(cells.all(|cell| !matches!(cell.value, SheetValue::Number(number) if number.is_nan())));
        }
    }
}
