//! Limits of workbooks, checked before reading, so that a small file cannot use much memory or time.

use crate::sheet_error::{
    COLUMNS_MOST, ROWS_MOST, SheetError, UNPACKED_A_BYTE_MOST, UNPACKED_BYTES_FREE, UNPACKED_BYTES_MOST,
    unreadable,
};
use calamine::Xlsx;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::io::{BufReader, Cursor, Read as _};

/// Number of cells between the corners allowed for any sheet. Our choice: they take 80 MB.
const AREA_FREE: usize = ROWS_MOST * COLUMNS_MOST;
/// Largest number of cells between the corners of a larger sheet for each cell with contents. Our choice: a log with one of its ten
/// channels in each line.
const AREA_A_CELL: usize = 10;

/// Unpacks every part once without keeping it: the stated size of a workbook may be wrong, and its cells may have impossible places.
pub(crate) fn refuse_bomb(bytes: &[u8]) -> Result<(), SheetError> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(unreadable)?;
    let most = (UNPACKED_A_BYTE_MOST * bytes.len() as u64).clamp(UNPACKED_BYTES_FREE, UNPACKED_BYTES_MOST);
    let mut left = most;
    for number in 0..archive.len() {
        let part = archive.by_index(number).map_err(unreadable)?;
        let mut places = Places::default();
        let unpacked = std::io::copy(&mut part.take(left + 1), &mut places).map_err(unreadable)?;
        if let Some(place) = places.beyond {
            return Err(SheetError::NoPlace { place });
        }
        left = left
            .checked_sub(unpacked)
            .ok_or(SheetError::TooLarge { most_mib: most >> 20 })?;
    }
    Ok(())
}

/// Letters and digits of the place of a cell: XFD1048576 is the last.
const LETTERS_MOST: usize = 3;
const DIGITS_MOST: usize = 7;

/// Reads the places of cells (attributes `r` and `ref`) while the bytes of a part go by: calamine uses these texts, however long they are.
#[derive(Default)]
struct Places {
    within: Within,
    /// Name of the current attribute, and whether it is complete.
    name: Vec<u8>,
    name_ended: bool,
    /// The cell reference being read, and its numbers of letters and digits.
    place: Vec<u8>,
    letters: usize,
    digits: usize,
    /// The first impossible place.
    beyond: Option<String>,
}

/// State of the XML scanner.
#[derive(Clone, Copy, Default)]
enum Within {
    #[default]
    Text,
    Tag,
    /// A value, with its quote character, and whether it contains cell references.
    Value(u8, bool),
}

impl Places {
    fn read(&mut self, byte: u8) {
        match (self.within, byte) {
            (Within::Text, b'<') => (self.within, self.name_ended) = (Within::Tag, true),
            (Within::Text, _) => {}
            (Within::Tag, b'>') => self.within = Within::Text,
            (Within::Tag, b'"' | b'\'') => {
                self.within = Within::Value(byte, matches!(&self.name[..], b"r" | b"ref"));
                self.between();
            }
            (Within::Tag, b'=') => {}
            (Within::Tag, _) if byte.is_ascii_whitespace() => self.name_ended = true,
            (Within::Tag, _) => {
                if std::mem::take(&mut self.name_ended) {
                    self.name.clear();
                }
                if self.name.len() < 8 {
                    self.name.push(byte);
                }
            }
            (Within::Value(quote, _), _) if byte == quote => {
                (self.within, self.name_ended) = (Within::Tag, true);
            }
            (Within::Value(_, true), _) => self.of_place(byte),
            (Within::Value(_, false), _) => {}
        }
    }

    fn of_place(&mut self, byte: u8) {
        if !byte.is_ascii_alphanumeric() {
            return self.between();
        }
        self.letters += usize::from(byte.is_ascii_alphabetic());
        self.digits += usize::from(byte.is_ascii_digit());
        self.place.push(byte);
        if self.letters > LETTERS_MOST || self.digits > DIGITS_MOST {
            self.beyond = Some(String::from_utf8_lossy(&self.place).into_owned());
        }
    }

    fn between(&mut self) {
        self.place.clear();
        (self.letters, self.digits) = (0, 0);
    }
}

impl std::io::Write for Places {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let mut each = bytes.iter();
        while self.beyond.is_none()
            && let Some(byte) = each.next()
        {
            self.read(*byte);
        }
        Ok(bytes.len())
    }
    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// Refuses a sheet with a cell far from the others, before memory is allocated for all cells between: one at XFD1048576 would take half a
/// terabyte.
pub(crate) fn refuse_far(
    book: &mut Xlsx<Cursor<&[u8]>>,
    name: &str,
    rows_most: usize,
) -> Result<(), SheetError> {
    let (mut most, mut cells) = ((0, 0), 0);
    let mut far = |(row, column): (u32, u32)| {
        most = (most.0.max(row as usize + 1), most.1.max(column as usize + 1));
        let (rows, columns) = most;
        match rows > rows_most || columns > COLUMNS_MOST {
            true => Err(SheetError::TooMany {
                rows,
                columns,
                rows_most,
            }),
            false => Ok(()),
        }
    };
    let mut each = book.worksheet_cells_reader(name).map_err(unreadable)?;
    while let Some(cell) = each.next_cell().map_err(unreadable)? {
        far(cell.get_position())?;
        cells += 1;
    }
    drop(each);
    let mut each = book.worksheet_cells_reader(name).map_err(unreadable)?;
    while let Some(cell) = each.next_formula().map_err(unreadable)? {
        far(cell.get_position())?;
    }
    let (rows, columns) = most;
    match rows * columns > AREA_FREE.max(AREA_A_CELL * cells) {
        true => Err(SheetError::Sparse { rows, columns, cells }),
        false => Ok(()),
    }
}

/// For a table of parts.
pub(crate) fn too_many(rows: usize, columns: usize) -> SheetError {
    SheetError::TooMany {
        rows,
        columns,
        rows_most: ROWS_MOST,
    }
}

/// Refuses sheets of a workbook (ODS) that become larger than any table through repeated contents or gaps: a row repeated a million times
/// takes a hundred bytes in the file, and gigabytes in memory. Empty rows and cells at the end of a sheet do not count: LibreOffice writes
/// them up to the last row. Also refuses truncated tables, for which calamine would wait endlessly.
pub(crate) fn refuse_repeats(bytes: &[u8]) -> Result<(), SheetError> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(unreadable)?;
    let Ok(part) = archive.by_name("content.xml") else {
        return Ok(()); // the reader of the workbook reports this error
    };
    let mut reader = Reader::from_reader(BufReader::new(part));
    // as calamine reads it, so that both agree, except that an end tag ends the last element
    let config = reader.config_mut();
    config.check_end_names = true;
    config.check_comments = false;
    config.expand_empty_elements = true;
    let (mut sheet, mut whole) = (Extent::default(), 0_usize);
    let mut open = 0_usize;
    let mut buffer = Vec::new();
    loop {
        let event = reader.read_event_into(&mut buffer).map_err(|fault| match fault {
            quick_xml::Error::IllFormed(_) | quick_xml::Error::Syntax(_) => SheetError::Damaged,
            other => unreadable(other),
        })?;
        open = match event {
            Event::Start(_) => open + 1,
            Event::End(_) => open.saturating_sub(1),
            Event::Eof if open > 0 => return Err(SheetError::Damaged),
            _ => open,
        };
        match event {
            Event::Start(tag) => match tag.name().as_ref() {
                "table:table" => sheet = Extent::default(),
                "table:table-row" => sheet.begin_row(repeats(&tag, "table:number-rows-repeated")),
                "table:table-cell" | "table:covered-table-cell" => {
                    let raw = tag.attributes_raw();
                    let holds = raw.contains("office:") || raw.contains("formula");
                    sheet.begin_cell(repeats(&tag, "table:number-columns-repeated"), holds);
                }
                _ => {}
            },
            Event::End(tag) => match tag.name().as_ref() {
                "table:table-row" => sheet.end_row()?,
                "table:table-cell" | "table:covered-table-cell" => sheet.end_cell(),
                "table:table" => {
                    whole = whole.saturating_add(sheet.filled_rows.saturating_mul(sheet.filled_columns));
                    if whole > AREA_FREE {
                        let (rows, columns) = (sheet.filled_rows, sheet.filled_columns);
                        return Err(too_many(rows, columns));
                    }
                }
                _ => {}
            },
            Event::Text(text) => sheet.cell.holds |= !text.trim().is_empty(),
            Event::CData(_) | Event::GeneralRef(_) => sheet.cell.holds = true,
            Event::Eof => return Ok(()),
            _ => {}
        }
        buffer.clear();
    }
}

/// Extent of a sheet.
#[derive(Default)]
struct Extent {
    /// Number of rows before the present one, and its repetitions.
    rows: usize,
    row_repeats: usize,
    /// Number of cells before the present one in the row, and up to the last with contents.
    columns: usize,
    filled_in_row: usize,
    cell: Repeated,
    /// Number of rows up to the last with contents.
    filled_rows: usize,
    filled_columns: usize,
}

/// A cell, its repetitions, and whether it has contents.
#[derive(Clone, Copy, Default)]
struct Repeated {
    times: usize,
    holds: bool,
}

impl Extent {
    fn begin_row(&mut self, row_repeats: usize) {
        (self.row_repeats, self.columns, self.filled_in_row) = (row_repeats, 0, 0);
    }

    fn begin_cell(&mut self, times: usize, holds: bool) {
        self.cell = Repeated { times, holds };
    }

    fn end_cell(&mut self) {
        self.columns = self.columns.saturating_add(self.cell.times);
        if self.cell.holds {
            self.filled_in_row = self.columns;
        }
        self.cell = Repeated::default();
    }

    fn end_row(&mut self) -> Result<(), SheetError> {
        self.rows = self.rows.saturating_add(self.row_repeats);
        if self.filled_in_row == 0 {
            return Ok(());
        }
        self.filled_rows = self.rows;
        self.filled_columns = self.filled_columns.max(self.filled_in_row);
        let (rows, columns) = (self.filled_rows, self.filled_columns);
        match rows > ROWS_MOST || columns > COLUMNS_MOST {
            true => Err(too_many(rows, columns)),
            false => Ok(()),
        }
    }
}

/// Repetitions of a row or cell; an invalid number is taken as more than any table has.
fn repeats(tag: &BytesStart<'_>, name: &str) -> usize {
    match tag.try_get_attribute(name) {
        Ok(None) => 1,
        Ok(Some(found)) => found.value.parse().unwrap_or(usize::MAX),
        Err(_) => usize::MAX,
    }
}
