//! Workbooks of samples and readings: the only sheet with contents, as the same table in CSV.

use crate::sheet::{SheetCell, SheetUse, SheetValue, filled_sheets, of_xlsx};
use crate::sheet_error::SheetError;

/// Whether the beginning of a file is that of a workbook.
pub(crate) fn is_workbook(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04")
}

/// The only sheet with values of a workbook (XLSX), as the same table in CSV; dates and times as "2026-11-25 10:00:00.005".
///
/// # Errors
/// [`SheetError`]; [`SheetError::SeveralTables`] if several sheets have values.
pub(crate) fn workbook_as_csv(bytes: &[u8]) -> Result<Vec<u8>, SheetError> {
    let filled = filled_sheets(bytes)?;
    let sheet = match filled.as_slice() {
        [] => return Err(SheetError::NoRows),
        [one] => one,
        several => {
            return Err(SheetError::SeveralTables {
                known: several.join(", "),
            });
        }
    };
    let mut rows = of_xlsx(bytes, Some(sheet), SheetUse::Samples)?;
    while rows.last().is_some_and(|row| is_empty(row)) {
        rows.pop();
    }
    // lines of the text are rows of the sheet, so that errors give their numbers
    let above = rows
        .first()
        .and_then(|row| row.first())
        .map_or(0, |cell| row_number(&cell.place) - 1);
    let mut text = "\n".repeat(above);
    for row in rows {
        let cells: Vec<String> = row
            .iter()
            .map(|cell| match &cell.value {
                SheetValue::Empty => String::new(),
                SheetValue::Number(number) => number.to_string(),
                SheetValue::Text(text) => {
                    format!("\"{}\"", text.replace('"', "'").replace(char::is_control, " "))
                }
            })
            .collect();
        text += &cells.join(",");
        text.push('\n');
    }
    Ok(text.into_bytes())
}

fn is_empty(row: &[SheetCell]) -> bool {
    row.iter().all(|cell| cell.value == SheetValue::Empty)
}

/// 4 of "C4".
fn row_number(place: &str) -> usize {
    place.trim_start_matches(char::is_alphabetic).parse().unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rust_xlsxwriter::{ExcelDateTime, Format, Workbook};

    #[test]
    fn agrees_dates_of_another_writer_and_sheets_without_values() {
        let mut book = Workbook::new();
        book.add_worksheet().set_name("Sheet1").unwrap();
        let sheet = book.add_worksheet().set_name("data").unwrap();
        sheet.write_string(0, 0, "시각").unwrap();
        sheet.write_string(0, 1, "tilt, mm/m").unwrap();
        for (row, format) in (1..).zip(["yyyy-mm-dd hh:mm", "yyyy/mm/dd", "hh:mm:ss.000"]) {
            let at = ExcelDateTime::from_ymd(2026, 11, 25)
                .unwrap()
                .and_hms_milli(14, 30, 1, 250)
                .unwrap();
            let at = if row == 3 {
                ExcelDateTime::from_hms_milli(14, 30, 1, 250).unwrap()
            } else {
                at
            };
            sheet
                .write_datetime_with_format(row, 0, &at, &Format::new().set_num_format(format))
                .unwrap();
            sheet.write_number(row, 1, f64::from(row) / 4.0).unwrap();
        }
        let csv = |book: &mut Workbook| workbook_as_csv(&book.save_to_buffer().unwrap());
        assert_eq!(
            String::from_utf8(csv(&mut book).unwrap()).unwrap(),
            "\"시각\",\"tilt, mm/m\"\n\"2026-11-25 14:30:01.250\",0.25\n\"2026-11-25 14:30:01.250\",0.5\n\"14:30:01.250\",0.75\n"
        );
        let more = book.add_worksheet().set_name("more").unwrap();
        more.write_number(0, 0, 1.0).unwrap();
        assert_eq!(
            csv(&mut book).unwrap_err(),
            SheetError::SeveralTables {
                known: "data, more".into()
            }
        );
        assert_eq!(csv(&mut Workbook::new()).unwrap_err(), SheetError::NoRows);
    }
}
