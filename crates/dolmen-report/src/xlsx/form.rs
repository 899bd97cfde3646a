//! The form of the six-factor score as a sheet to fill in and read back.

use super::fault::WorkbookFault;
use super::properties::properties;
use crate::document::{Block, Table};
use crate::html::Imprint;
use crate::score::{Form, form};
use dolmen_words::{Language, Sentence};
use rust_xlsxwriter::{Color, Format, FormatAlign, FormatBorder, Workbook, Worksheet, XlsxError};

/// Fill of the cells for input.
const FILLED: Color = Color::RGB(0x00FF_F6DB);
/// Widths of the columns, in characters: key, what, unit, value, remark.
const WIDTHS: [f64; 5] = [24.0, 58.0, 8.0, 16.0, 40.0];

/// The form as the bytes of an XLSX file; the same bytes each time.
///
/// # Errors
/// If the writer refuses.
pub fn score_form_workbook(language: Language, imprint: &Imprint) -> Result<Vec<u8>, WorkbookFault> {
    let mut book = Workbook::new();
    let title = Sentence::from(Form::Title).text(language);
    book.set_properties(&properties(&[], language, imprint)?.set_title(&title));
    let sheet = book.add_worksheet();
    sheet.set_name(language.pick("Score", "점수"))?;
    for (column, width) in (0..).zip(WIDTHS) {
        sheet.set_column_width(column, width)?;
    }
    let head = Format::new().set_bold().set_font_size(16);
    sheet.write_with_format(0, 0, &title, &head)?;
    let mut row = 1;
    for block in form().blocks {
        row = match block {
            Block::Table(table) => table_rows(sheet, row + 1, &table, language)? + 1,
            Block::Paragraph(sentences) => {
                let each: Vec<String> = sentences.iter().map(|one| one.text(language)).collect();
                said(sheet, row, &each.join(" "))?
            }
            Block::Note(sentence) => said(sheet, row, &sentence.text(language))?,
            _ => row,
        };
    }
    sheet.set_landscape().set_print_fit_to_pages(1, 1);
    Ok(book.save_to_buffer()?)
}

/// A line of text over all columns; returns the next row.
fn said(sheet: &mut Worksheet, row: u32, words: &str) -> Result<u32, XlsxError> {
    let format = Format::new().set_text_wrap().set_align(FormatAlign::Top);
    sheet.merge_range(row, 0, row, 4, words, &format)?;
    sheet.set_row_height(row, super::sheet::row_height(super::sheet::lines_of(words, 140)))?;
    Ok(row + 1)
}

fn table_rows(
    sheet: &mut Worksheet,
    first: u32,
    table: &Table,
    language: Language,
) -> Result<u32, XlsxError> {
    let wrapped = Format::new()
        .set_text_wrap()
        .set_align(FormatAlign::Top)
        .set_border(FormatBorder::Hair);
    let head = wrapped.clone().set_bold().set_border_bottom(FormatBorder::Thin);
    let filled = wrapped.clone().set_background_color(FILLED);
    for (column, of) in (0..).zip(&table.columns) {
        sheet.write_with_format(first, column, of.text(language), &head)?;
    }
    let mut at = first;
    for cells in &table.rows {
        at += 1;
        for (column, cell) in (0..).zip(cells) {
            let words = cell.text(language);
            match words.is_empty() {
                true => sheet.write_blank(at, column, &filled)?,
                false => sheet.write_with_format(at, column, words, &wrapped)?,
            };
        }
        sheet.set_row_height(at, super::sheet::row_height(2))?;
    }
    Ok(at + 1)
}
