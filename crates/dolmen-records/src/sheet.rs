//! Tables of stones and storeys: XLSX, ODS and CSV to rows of cells with their references.

use crate::number::parse_cell;
use crate::sheet_error::{COLUMNS_MOST, ROWS_MOST, SheetError, unreadable};
use crate::sheet_limits::{refuse_bomb, refuse_far, refuse_repeats, too_many};
use crate::text_code::decoded;
use calamine::{Data, DataRef, Dimensions, ExcelDateTime, Ods, Range, Reader, Xlsx};
use std::io::Cursor;

/// Most bytes of a table.
pub const SHEET_BYTES_MOST: u64 = 32 << 20;
/// Contents of a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum SheetValue {
    /// Nothing.
    Empty,
    /// A number.
    Number(f64),
    /// Words.
    Text(String),
}

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetCell {
    /// Place of the cell: "C4".
    pub place: String,
    /// Its contents.
    pub value: SheetValue,
}

/// The rows of a table, the header first; empty rows at the end are left out.
///
/// # Errors
/// [`SheetError`]: not a table, a formula, merged cells, or too much; each names the cell.
pub fn read_sheet(bytes: &[u8], file: &str, sheet: Option<&str>) -> Result<Vec<Vec<SheetCell>>, SheetError> {
    rows_of(bytes, file, sheet, SheetUse::Parts)
}

/// As [`read_sheet`], for a table with a date in each row: dates of a spreadsheet are text, "2026-11-25".
///
/// # Errors
/// [`SheetError`].
pub fn read_dated_sheet(
    bytes: &[u8],
    file: &str,
    sheet: Option<&str>,
) -> Result<Vec<Vec<SheetCell>>, SheetError> {
    rows_of(bytes, file, sheet, SheetUse::Dated)
}

fn rows_of(
    bytes: &[u8],
    file: &str,
    sheet: Option<&str>,
    of: SheetUse,
) -> Result<Vec<Vec<SheetCell>>, SheetError> {
    let ending = file.rsplit('.').next().map(str::to_lowercase);
    let mut rows = match ending.as_deref() {
        Some("xlsx") => of_xlsx(bytes, sheet, of)?,
        Some("ods") => of_ods(bytes, sheet, of)?,
        Some("csv" | "tsv" | "txt") if sheet.is_some() => return Err(SheetError::NoSheets),
        Some("csv" | "tsv" | "txt") => of_text(bytes, of)?,
        _ => return Err(SheetError::NotATable),
    };
    let is_empty = |row: &Vec<SheetCell>| row.iter().all(|cell| cell.value == SheetValue::Empty);
    while rows.last().is_some_and(is_empty) {
        rows.pop();
    }
    match rows.len() {
        0 | 1 => Err(SheetError::NoRows),
        _ => Ok(rows),
    }
}

/// Rows of a workbook of samples: as many as a sheet of Excel has.
const SAMPLES_MOST: usize = 1 << 20;

/// Purpose of a sheet.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum SheetUse {
    /// Parts of a structure: dates are mistakes.
    Parts,
    /// Surveys of a structure, one row per date: dates are text.
    Dated,
    /// Samples or readings, with dates and times as text.
    Samples,
}

impl SheetUse {
    fn rows_most(self) -> usize {
        match self {
            SheetUse::Parts | SheetUse::Dated => ROWS_MOST,
            SheetUse::Samples => SAMPLES_MOST,
        }
    }
}

/// The nonempty sheets of a workbook (XLSX).
///
/// # Errors
/// [`SheetError::Unreadable`], [`SheetError::TooLarge`].
pub(crate) fn filled_sheets(bytes: &[u8]) -> Result<Vec<String>, SheetError> {
    refuse_bomb(bytes)?;
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(unreadable)?;
    let mut filled = Vec::new();
    for name in book.sheet_names() {
        let mut each = book.worksheet_cells_reader(&name).map_err(unreadable)?;
        let mut holds = false;
        while let Some(cell) = each.next_cell().map_err(unreadable)?.filter(|_| !holds) {
            holds = !matches!(cell.get_value(), DataRef::Empty);
        }
        drop(each);
        if holds {
            filled.push(name);
        }
    }
    Ok(filled)
}

/// "C4" for a column and row from 0.
fn place(row: usize, column: usize) -> String {
    let mut letters = Vec::new();
    let mut left = column + 1;
    while left > 0 {
        letters.push(char::from(b'A' + u8::try_from((left - 1) % 26).unwrap_or(0)));
        left = (left - 1) / 26;
    }
    let letters: String = letters.into_iter().rev().collect();
    format!("{letters}{}", row + 1)
}

/// The name of the requested sheet.
fn chosen(names: &[String], sheet: Option<&str>) -> Result<String, SheetError> {
    let known = || names.join(", ");
    match (sheet, names) {
        (Some(name), _) if names.iter().any(|one| one == name) => Ok(name.to_owned()),
        (Some(name), _) => Err(SheetError::NoSuchSheet {
            name: name.to_owned(),
            known: known(),
        }),
        (None, [one]) => Ok(one.clone()),
        (None, _) => Err(SheetError::SeveralSheets { known: known() }),
    }
}

pub(crate) fn of_xlsx(
    bytes: &[u8],
    sheet: Option<&str>,
    of: SheetUse,
) -> Result<Vec<Vec<SheetCell>>, SheetError> {
    refuse_bomb(bytes)?;
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(unreadable)?;
    let mut names = book.sheet_names();
    if sheet.is_none() && names.len() > 1 {
        // older versions of Excel create three sheets, of which two stay empty
        names = match filled_sheets(bytes)? {
            filled if filled.is_empty() => names,
            filled => filled,
        };
    }
    let name = chosen(&names, sheet)?;
    let merged = book.merge_cells_by_sheet_name(&name).map_err(unreadable)?;
    if let Some(Dimensions { start, end }) = merged.first() {
        let corner = |(row, column): (u32, u32)| place(row as usize, column as usize);
        return Err(SheetError::Merged {
            place: format!("{}:{}", corner(*start), corner(*end)),
        });
    }
    refuse_far(&mut book, &name, of.rows_most())?;
    refuse_formula(&book.worksheet_formula(&name).map_err(unreadable)?)?;
    cells(&book.worksheet_range(&name).map_err(unreadable)?, of)
}

fn of_ods(bytes: &[u8], sheet: Option<&str>, of: SheetUse) -> Result<Vec<Vec<SheetCell>>, SheetError> {
    refuse_bomb(bytes)?;
    refuse_repeats(bytes)?;
    let mut book: Ods<_> = Ods::new(Cursor::new(bytes)).map_err(unreadable)?;
    let name = chosen(&book.sheet_names(), sheet)?;
    refuse_formula(&book.worksheet_formula(&name).map_err(unreadable)?)?;
    cells(&book.worksheet_range(&name).map_err(unreadable)?, of)
}

fn refuse_formula(formulas: &Range<String>) -> Result<(), SheetError> {
    let (first_row, first_column) = formulas.start().unwrap_or_default();
    let mut each = formulas.used_cells();
    match each.find(|(_, _, formula)| !formula.is_empty()) {
        None => Ok(()),
        Some((row, column, _)) => Err(SheetError::Formula {
            place: place(row + first_row as usize, column + first_column as usize),
        }),
    }
}

fn cells(range: &Range<Data>, of: SheetUse) -> Result<Vec<Vec<SheetCell>>, SheetError> {
    let (first_row, first_column) = range.start().unwrap_or_default();
    let (rows, columns) = range.get_size();
    let rows_most = of.rows_most();
    if rows > rows_most || columns > COLUMNS_MOST {
        return Err(SheetError::TooMany {
            rows,
            columns,
            rows_most,
        });
    }
    let cell = |row: usize, column: usize, value: &Data| {
        let place = place(row + first_row as usize, column + first_column as usize);
        let value = match value {
            Data::Empty => SheetValue::Empty,
            Data::Int(number) => SheetValue::Number(*number as f64),
            Data::Float(number) => SheetValue::Number(*number),
            Data::String(text) if text.trim().is_empty() => SheetValue::Empty,
            Data::String(text) => SheetValue::Text(text.trim().to_owned()),
            Data::DateTime(at) if of != SheetUse::Parts => SheetValue::Text(moment(*at)),
            Data::DateTimeIso(at) if of != SheetUse::Parts => SheetValue::Text(at.replace('T', " ")),
            other => {
                let what = match other {
                    Data::Error(error) => format!("the error {error}"),
                    Data::Bool(value) => format!("{value}"),
                    _ => "a date or time".to_owned(),
                };
                return Err(SheetError::Other { place, what });
            }
        };
        Ok(SheetCell { place, value })
    };
    let of_row = |(number, row): (usize, &[Data])| {
        let each = row.iter().enumerate();
        each.map(|(column, value)| cell(number, column, value)).collect()
    };
    range.rows().enumerate().map(of_row).collect()
}

/// "2026-11-25 10:00:00.005", "2026-11-25" for a day without a time, "10:00:00.005" for a time without a day.
fn moment(at: ExcelDateTime) -> String {
    let (year, month, day, hour, minute, second, millisecond) = at.to_ymd_hms_milli();
    let clock = format!("{hour:02}:{minute:02}:{second:02}.{millisecond:03}");
    let day = format!("{year:04}-{month:02}-{day:02}");
    match at.as_f64() {
        days if days < 1.0 => clock,
        days if days.fract() == 0.0 => day,
        _ => format!("{day} {clock}"),
    }
}

/// CSV with commas, semicolons or tabs, by its first line.
fn of_text(bytes: &[u8], of: SheetUse) -> Result<Vec<Vec<SheetCell>>, SheetError> {
    let turned = decoded(bytes);
    let text = std::str::from_utf8(&turned.bytes).map_err(|fault| {
        let at = fault.valid_up_to();
        unreadable(format!(
            "it is not UTF-8 or CP949 text (byte {at}): save it as CSV UTF-8"
        ))
    })?;
    let text = text.trim_start_matches('\u{feff}');
    // a remark above the table is not part of it
    let mut lines = text.lines();
    let first = lines.clone().find(|line| !line.starts_with('#')).or(lines.next());
    let first = first.unwrap_or_default();
    let count = |mark: u8| first.bytes().filter(|byte| *byte == mark).count();
    let delimiter = [b',', b';', b'\t']
        .into_iter()
        .max_by_key(|mark| count(*mark))
        .unwrap_or(b',');
    let records = || {
        csv::ReaderBuilder::new()
            .delimiter(delimiter)
            .has_headers(false)
            .flexible(true)
            .from_reader(text.as_bytes())
    };
    let may_have_commas = delimiter != b',' && of == SheetUse::Dated;
    let has_decimal_commas = may_have_commas && by_decimal_commas(records());
    let mut reader = records();
    let mut rows = Vec::new();
    // lines that a spreadsheet shows within one cell
    let mut within_cells = 0;
    for record in reader.records() {
        let record = record.map_err(unreadable)?;
        // a record begins after the previous one, with any empty lines between
        let line = record.position().map_or(rows.len() + 1, |at| {
            let ahead = text.as_bytes().get(at.byte() as usize..).unwrap_or_default();
            let empty = ahead.iter().take_while(|byte| matches!(byte, b'\n' | b'\r'));
            at.line() as usize + empty.filter(|byte| **byte == b'\n').count()
        });
        let number = line.saturating_sub(1 + within_cells);
        within_cells += record
            .iter()
            .map(|cell| cell.matches('\n').count())
            .sum::<usize>();
        if number >= ROWS_MOST || record.len() > COLUMNS_MOST {
            return Err(too_many(number + 1, record.len()));
        }
        let cell = |(column, field): (usize, &str)| {
            let (place, field) = (place(number, column), field.trim());
            if field.starts_with('=') {
                return Err(SheetError::Formula { place });
            }
            let value = match (field, field.parse::<f64>()) {
                ("", _) => SheetValue::Empty,
                // "007" is a name, or a folder
                (_, Ok(number)) if number.is_finite() && !has_leading_zero(field) => {
                    SheetValue::Number(number)
                }
                _ => match decimal_comma(field).filter(|_| has_decimal_commas) {
                    Some(number) => SheetValue::Number(number),
                    None => SheetValue::Text(field.to_owned()),
                },
            };
            Ok(SheetCell { place, value })
        };
        rows.push(
            record
                .iter()
                .enumerate()
                .map(cell)
                .collect::<Result<Vec<_>, _>>()?,
        );
    }
    Ok(rows)
}

/// Whether the numbers of a table have decimal commas, as spreadsheets of some countries write them between semicolons or tabs: some cells
/// are such numbers, and none has a decimal point. Records of vibrations decide alike, by the sign that makes most cells numbers.
fn by_decimal_commas(mut reader: csv::Reader<&[u8]>) -> bool {
    let (mut with_comma, mut with_point) = (false, false);
    for record in reader.records().map_while(Result::ok) {
        for field in record.iter().map(str::trim) {
            with_comma |= decimal_comma(field).is_some();
            with_point |= field.contains('.') && field.parse::<f64>().is_ok_and(f64::is_finite);
        }
    }
    with_comma && !with_point
}

/// The number in a cell with one decimal comma.
fn decimal_comma(field: &str) -> Option<f64> {
    let number = parse_cell(field.as_bytes(), b',').filter(|_| field.matches(',').count() == 1);
    number
        .map(|number| number.value)
        .filter(|value| value.is_finite())
}

fn has_leading_zero(field: &str) -> bool {
    let mut signs = field.chars();
    signs.next() == Some('0') && signs.next().is_some_and(|sign| sign.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_places_are_those_of_a_spreadsheet() {
        let places =
            [(0, 0), (3, 2), (9, 25), (0, 26), (0, 701), (0, 702)].map(|(row, column)| place(row, column));
        assert_eq!(places, ["A1", "C4", "Z10", "AA1", "ZZ1", "AAA1"]);
    }

    #[test]
    fn refuses_text_that_is_no_table() {
        let told = |bytes: &[u8], file: &str, sheet| read_sheet(bytes, file, sheet).unwrap_err().to_string();
        assert!(told(b"a", "a.pdf", None).contains(".xlsx, .ods or .csv"));
        assert!(told(b"a,b\n", "a.csv", None).contains("no rows"));
        assert!(told(b"a,b\n1,=A1\n", "a.csv", None).contains("cell B2 holds a formula"));
        assert!(told(b"a\n1\n", "a.csv", Some("x")).contains("has no sheets"));
        assert!(told(&[0xb0, 0xff], "a.csv", None).contains("not UTF-8"));
        assert!(told(b"PK\x03\x04", "a.xlsx", None).contains("cannot be read"));
    }

    #[test]
    fn exact_rows_are_those_of_a_spreadsheet() {
        let rows = read_sheet("name,\"width\n(mm)\"\na,1\n\n007,2\n".as_bytes(), "a.csv", None).unwrap();
        let places: Vec<&str> = rows.iter().map(|row| row[1].place.as_str()).collect();
        assert_eq!(places, ["B1", "B2", "B4"]);
        assert_eq!(rows[2][0].value, SheetValue::Text("007".to_owned()));
    }

    #[test]
    fn exact_semicolons_and_quotes() {
        let rows = read_sheet("name;width\n\"a;b\";1.5\n".as_bytes(), "a.csv", None).unwrap();
        assert_eq!(rows[1][0].value, SheetValue::Text("a;b".to_owned()));
        assert_eq!(
            (rows[1][1].place.as_str(), &rows[1][1].value),
            ("B2", &SheetValue::Number(1.5))
        );
    }

    #[test]
    fn exact_decimal_commas_between_semicolons_and_tabs() {
        let cell = |text: &str, row: usize, column: usize| {
            read_dated_sheet(text.as_bytes(), "a.csv", None).unwrap()[row][column]
                .value
                .clone()
        };
        let text = "date;width\n2020-01-05;12,5\n2020-02-05;-0,25\na,b;7\n";
        for text in [text.to_owned(), text.replace(';', "\t")] {
            assert_eq!(cell(&text, 1, 1), SheetValue::Number(12.5));
            assert_eq!(cell(&text, 2, 1), SheetValue::Number(-0.25));
            assert_eq!(cell(&text, 3, 0), SheetValue::Text("a,b".to_owned()));
        }
        // a point elsewhere in the table: the comma may be of thousands
        let mixed = text.replace(";7", ";7.5");
        assert_eq!(cell(&mixed, 1, 1), SheetValue::Text("12,5".to_owned()));
        assert_eq!(cell(&mixed, 3, 1), SheetValue::Number(7.5));
        assert_eq!(
            cell("a,b\n\"12,5\",1\n", 1, 0),
            SheetValue::Text("12,5".to_owned())
        );
    }

    fn book(write: impl Fn(&mut rust_xlsxwriter::Worksheet)) -> Vec<u8> {
        let mut book = rust_xlsxwriter::Workbook::new();
        let sheet = book.add_worksheet().set_name("stones").unwrap();
        write(sheet);
        book.save_to_buffer().unwrap()
    }

    fn heads(sheet: &mut rust_xlsxwriter::Worksheet) {
        for (column, head) in (1..).zip(["이름", "폭 (mm)"]) {
            sheet.write_string(2, column, head).unwrap();
        }
        sheet.write_string(3, 1, "몸돌").unwrap();
        sheet.write_number(3, 2, 950.0).unwrap();
    }

    #[test]
    fn exact_dates_of_a_spreadsheet_are_text_where_rows_have_dates() {
        let dated = book(|sheet| {
            let day = rust_xlsxwriter::Format::new().set_num_format("yyyy-mm-dd");
            sheet.write_string(0, 0, "date").unwrap();
            let when = rust_xlsxwriter::ExcelDateTime::from_ymd(2016, 5, 3).unwrap();
            sheet.write_datetime_with_format(1, 0, &when, &day).unwrap();
        });
        let rows = read_dated_sheet(&dated, "list.xlsx", None).unwrap();
        assert_eq!(rows[1][0].value, SheetValue::Text("2016-05-03".to_owned()));
        assert!(matches!(
            read_sheet(&dated, "list.xlsx", None),
            Err(SheetError::Other { .. })
        ));
    }

    #[test]
    fn refuses_a_cell_far_from_the_others_without_room_for_all_between() {
        let far = book(|sheet| {
            heads(sheet);
            sheet.write_string(1_048_575, 16_383, "x").unwrap();
        });
        assert_eq!(
            read_sheet(&far, "stones.xlsx", None).unwrap_err(),
            SheetError::TooMany {
                rows: 1_048_576,
                columns: 16_384,
                rows_most: ROWS_MOST
            }
        );
    }

    #[test]
    fn refuses_a_cell_whose_place_no_sheet_has() {
        use std::io::{Read as _, Write as _};
        let mut packed = zip::ZipArchive::new(Cursor::new(book(heads))).unwrap();
        let with = |from: &str, to: &str, packed: &mut zip::ZipArchive<Cursor<Vec<u8>>>| {
            let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
            for number in 0..packed.len() {
                let mut part = packed.by_index(number).unwrap();
                let mut text = String::new();
                part.read_to_string(&mut text).unwrap();
                archive
                    .start_file(part.name().unwrap(), zip::write::SimpleFileOptions::default())
                    .unwrap();
                archive.write_all(text.replace(from, to).as_bytes()).unwrap();
            }
            read_sheet(&archive.finish().unwrap().into_inner(), "stones.xlsx", None)
        };
        assert_eq!(with("r=\"C4\"", "r = 'C4'", &mut packed).unwrap().len(), 2);
        for (to, place) in [
            ("r='C44444444'", "C44444444"),
            ("s=\">\" r=\"CCCCCCCCCC4\"", "CCCC"),
        ] {
            let place = place.to_owned();
            assert_eq!(
                with("r=\"C4\"", to, &mut packed).unwrap_err(),
                SheetError::NoPlace { place }
            );
        }
    }

    #[test]
    fn refuses_a_log_of_two_cells_at_its_corners() {
        let far = book(|sheet| {
            heads(sheet);
            sheet.write_number(1_048_575, 255, 1.0).unwrap();
        });
        assert_eq!(
            of_xlsx(&far, None, SheetUse::Samples).unwrap_err(),
            SheetError::Sparse {
                rows: 1_048_576,
                columns: 256,
                cells: 5
            }
        );
        // one of ten channels in each line
        let log = book(|sheet| {
            for row in 0..3000 {
                sheet.write_number(row, (row % 10) as u16, 1.0).unwrap();
            }
        });
        assert_eq!(of_xlsx(&log, None, SheetUse::Samples).unwrap().len(), 3000);
    }

    #[test]
    fn refuses_a_sheet_of_open_document_that_repeats_what_it_holds_or_does_not_end() {
        use std::io::Write as _;
        let ods = |rows: &str| {
            let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
            archive
                .start_file("content.xml", zip::write::SimpleFileOptions::default())
                .unwrap();
            let table = format!("<office:spreadsheet><table:table>{rows}</table:table></office:spreadsheet>");
            archive.write_all(table.as_bytes()).unwrap();
            refuse_repeats(&archive.finish().unwrap().into_inner())
        };
        // calamine would otherwise search endlessly for the end of the table or row
        for cut in ["</table:table>", "<table:table-row>", "<!-- </table:table>"] {
            assert_eq!(ods(cut), Err(SheetError::Damaged), "{cut}");
        }
        let row = |rows: &str, cell: &str| {
            format!("<table:table-row table:number-rows-repeated={rows}>{cell}</table:table-row>")
        };
        let filled = "<table:table-cell office:value='1'><text:p>1</text:p></table:table-cell>";
        let text = "<table:table-cell>\n<text:p>a</text:p></table:table-cell>";
        let empty = "<table:table-cell table:number-columns-repeated=\"16384\">\n</table:table-cell>";
        let too_many = |rows, columns| Err(too_many(rows, columns));
        // LibreOffice writes these up to the last row and column of a sheet
        let end = row("\"1048000\"", empty);
        assert_eq!(
            ods(&format!("{}{end}", row("'9'", &format!("{filled}{empty}")))),
            Ok(())
        );
        assert_eq!(ods(&row("\"10001\"", filled)), too_many(10_001, 1));
        assert_eq!(ods(&row("'10001'", text)), too_many(10_001, 1));
        // far below, far to the right, and an invalid number
        assert_eq!(
            ods(&format!("{end}{}", row("'1'", filled))),
            too_many(1_048_001, 1)
        );
        assert_eq!(ods(&row("'1'", &format!("{empty}{filled}"))), too_many(1, 16_385));
        assert_eq!(ods(&row("'&#57;'", filled)), too_many(usize::MAX, 1));
        // an end tag within a value
        let hidden = "<table:table-row table:style-name=\">\" table:number-rows-repeated='20000'>";
        assert_eq!(
            ods(&format!("<!-- ' -->{hidden}{filled}</table:table-row>")),
            too_many(20_000, 1)
        );
    }

    #[test]
    fn agrees_a_workbook_of_another_writer_is_read_with_its_places() {
        let bytes = book(heads);
        for sheet in [None, Some("stones")] {
            let rows = read_sheet(&bytes, "a.xlsx", sheet).unwrap();
            assert_eq!(rows.len(), 2);
            assert_eq!(
                (rows[0][1].place.as_str(), &rows[0][1].value),
                ("C3", &SheetValue::Text("폭 (mm)".to_owned()))
            );
            assert_eq!(
                (rows[1][1].place.as_str(), &rows[1][1].value),
                ("C4", &SheetValue::Number(950.0))
            );
        }
    }

    #[test]
    fn refuses_formulas_merged_cells_and_sheets_that_are_not_there_by_their_cell() {
        let told = |bytes: &[u8], sheet| read_sheet(bytes, "a.xlsx", sheet).unwrap_err().to_string();
        let formula = book(|sheet| {
            heads(sheet);
            sheet.write_formula(4, 2, "=C4*2").unwrap();
        });
        assert!(
            told(&formula, None).contains("cell C5 holds a formula"),
            "{}",
            told(&formula, None)
        );
        let merged = book(|sheet| {
            heads(sheet);
            sheet
                .merge_range(4, 1, 5, 1, "a", &rust_xlsxwriter::Format::new())
                .unwrap();
        });
        assert!(
            told(&merged, None).contains("cells B5:B6 are merged"),
            "{}",
            told(&merged, None)
        );
        assert!(told(&book(heads), Some("stone")).contains("has no sheet \"stone\": it has stones"));
    }

    #[test]
    fn refuses_a_workbook_that_unpacks_to_far_more_than_it_holds() {
        use std::io::Write as _;
        let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
        archive
            .start_file("xl/workbook.xml", zip::write::SimpleFileOptions::default())
            .unwrap();
        let zeros = vec![0_u8; 1 << 20];
        (0..130).for_each(|_| archive.write_all(&zeros).unwrap());
        let bytes = archive.finish().unwrap().into_inner();
        assert!(bytes.len() < 1 << 20, "{}", bytes.len());
        assert_eq!(
            read_sheet(&bytes, "a.xlsx", None),
            Err(SheetError::TooLarge { most_mib: 16 })
        );
    }
}
