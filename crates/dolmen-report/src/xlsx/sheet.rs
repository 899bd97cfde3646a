//! One table on one sheet.

use super::headed::Headed;
use super::words::Workbook;
use crate::document::{Cell, Column, Tone};
use dolmen_words::message::Both;
use dolmen_words::{Language, Quantity, Sentence};
use rust_xlsxwriter::{Color, Format, FormatAlign, FormatBorder, Url, Worksheet, XlsxError};
use unicode_width::UnicodeWidthStr;

/// Largest number of characters in an Excel cell.
const CHARACTERS_MOST: usize = 32_767;
/// Widths of columns, in characters.
const WIDTH_LEAST: usize = 8;
const WIDTH_MOST: usize = 60;

/// Colour of values that indicate a fall or must not be used, as on the page.
const BAD: Color = Color::RGB(0x00B3_261E);
const HEAD_GROUND: Color = Color::RGB(0x00EE_F1F4);

/// The formats of a workbook.
pub(super) struct Styles {
    pub(super) title: Format,
    pub(super) caption: Format,
    pub(super) words: Format,
    head_words: Format,
    head_number: Format,
    warning: Format,
    bad_words: Format,
    number: Format,
}

impl Styles {
    pub(super) fn new() -> Self {
        let words = Format::new()
            .set_text_wrap()
            .set_align(FormatAlign::Left)
            .set_align(FormatAlign::Top);
        let head = Format::new()
            .set_bold()
            .set_text_wrap()
            .set_align(FormatAlign::Top)
            .set_border_bottom(FormatBorder::Thin)
            .set_background_color(HEAD_GROUND);
        Styles {
            title: Format::new().set_bold().set_font_size(16),
            caption: Format::new().set_bold(),
            head_words: head.clone().set_align(FormatAlign::Left),
            head_number: head.set_align(FormatAlign::Right),
            warning: Format::new().set_font_color(BAD).set_bold(),
            bad_words: words.clone().set_font_color(BAD).set_bold(),
            number: Format::new()
                .set_align(FormatAlign::Right)
                .set_align(FormatAlign::Top),
            words,
        }
    }
}

impl Styles {
    /// The format of the head of a column.
    fn head(&self, shown: &Shown<'_>) -> &Format {
        match shown {
            Shown::Value(_, column) if column.is_words => &self.head_words,
            Shown::Value(..) | Shown::Deviation(..) => &self.head_number,
        }
    }

    /// The format of words in a column: aligned like numbers if the column has some.
    fn words_in(&self, column: &Column) -> &Format {
        match column.is_words {
            true => &self.words,
            false => &self.number,
        }
    }
}

/// A column of the sheet: one of the table, or the deviations of one.
enum Shown<'a> {
    Value(usize, &'a Column),
    Deviation(usize, &'a Column),
}

/// Writes the caption, the headings with units, and the rows.
pub(super) fn write_table(
    sheet: &mut Worksheet,
    headed: &Headed,
    summary: &str,
    language: Language,
    styles: &Styles,
) -> Result<(), XlsxError> {
    let back = Url::new(format!("internal:'{summary}'!A1"))
        .set_text(Sentence::from(Workbook::Back {}).text(language));
    write_words(sheet, (0, 0), &headed.head.text(language), &styles.title)?;
    write_words(sheet, (1, 0), &headed.caption_text(language), &styles.caption)?;
    sheet.write_url(2, 0, back)?;
    let mut head_row = 3;
    for warning in &headed.warnings {
        let words = format!("{} {}", Tone::Bad.sign(), warning.text(language));
        write_words(sheet, (head_row, 0), &words, &styles.warning)?;
        head_row += 1;
    }
    let mut lines = vec![1; headed.table.rows.len() + 1];
    for (at, shown) in (0..).zip(shown(headed)) {
        let texts = texts(&shown, headed, language);
        let width = column_width(&texts);
        sheet.set_column_width(at, characters(width))?;
        for (most, text) in lines.iter_mut().zip(&texts) {
            *most = lines_of(text, width).max(*most);
        }
        let head = texts.first().map_or("", String::as_str);
        write_words(sheet, (head_row, at), head, styles.head(&shown))?;
        for (row, cells) in (head_row + 1..).zip(&headed.table.rows) {
            match &shown {
                Shown::Value(column, of) => {
                    let words = styles.words_in(of);
                    write_cell(sheet, (row, at), cells.get(*column), (language, words), styles)?;
                }
                Shown::Deviation(column, _) => {
                    write_deviation(sheet, (row, at), cells.get(*column), styles)?;
                }
            }
        }
    }
    for (row, lines) in (head_row..).zip(lines) {
        sheet.set_row_height(row, row_height(lines))?;
    }
    sheet.set_freeze_panes(head_row + 1, 0)?;
    sheet
        .set_landscape()
        .set_print_fit_to_pages(1, 0)
        .set_repeat_rows(head_row, head_row)?;
    Ok(())
}

/// The columns, each followed by one for its deviations if it has any.
fn shown(headed: &Headed) -> Vec<Shown<'_>> {
    let table = &headed.table;
    let mut all = Vec::new();
    for (index, column) in table.columns.iter().enumerate() {
        all.push(Shown::Value(index, column));
        let mut cells = table.rows.iter().filter_map(|row| row.get(index));
        if cells.any(|cell| cell.quantity().is_some_and(|q| q.sd_si.is_some())) {
            all.push(Shown::Deviation(index, column));
        }
    }
    all
}

fn head(shown: &Shown<'_>, language: Language) -> String {
    match shown {
        Shown::Value(_, column) => column.text(language),
        Shown::Deviation(_, column) => {
            let head = Both::of(|language| column.text(language));
            Sentence::from(Workbook::Deviation(head)).text(language)
        }
    }
}

/// The heading and the cells of a column as text.
fn texts(shown: &Shown<'_>, headed: &Headed, language: Language) -> Vec<String> {
    let cells = headed.table.rows.iter().map(|row| match shown {
        Shown::Value(column, _) => row.get(*column).map(|cell| cell.text(language)),
        Shown::Deviation(..) => None,
    });
    let head = std::iter::once(head(shown, language));
    head.chain(cells.map(Option::unwrap_or_default)).collect()
}

/// Width for the cells and a heading of two lines.
fn column_width(texts: &[String]) -> usize {
    let head = texts.first().map_or(0, |head| head.width().div_ceil(2));
    let cells = texts.iter().skip(1).map(|text| text.width()).max();
    (cells.unwrap_or(0).max(head) + 3).clamp(WIDTH_LEAST, WIDTH_MOST)
}

/// Number of lines of a text in a column; wrapped words leave space at line ends.
pub(super) fn lines_of(text: &str, width: usize) -> usize {
    let room = width.saturating_sub(3).max(1);
    text.width().div_ceil(room).max(1)
}

/// The height of a row in points.
pub(super) fn row_height(lines: usize) -> f64 {
    const POINTS_A_LINE: f64 = 15.0;
    const POINTS_MOST: f64 = 409.0; // of a row in Excel
    (characters(lines) * POINTS_A_LINE).min(POINTS_MOST)
}

/// A count as a width or height.
pub(super) fn characters(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::from(u32::MAX), f64::from)
}

/// Writes a cell, with words in the language and format of its column.
fn write_cell(
    sheet: &mut Worksheet,
    at: (u32, u16),
    cell: Option<&Cell>,
    (language, words): (Language, &Format),
    styles: &Styles,
) -> Result<(), XlsxError> {
    let Some(cell) = cell else { return Ok(()) };
    match cell
        .quantity()
        .filter(|quantity| shown_value(quantity).is_finite())
    {
        Some(quantity) => {
            let mut format = styles
                .number
                .clone()
                .set_num_format(number_format(cell, quantity));
            if cell.is_bad() {
                format = format.set_font_color(BAD).set_bold();
            }
            sheet
                .write_number_with_format(at.0, at.1, shown_value(quantity), &format)
                .map(|_| ())
        }
        None if cell.is_bad() => write_words(sheet, at, &cell.text(language), &styles.bad_words),
        None => {
            let text = cell.text(language);
            match signed_number(&text) {
                Some(value) => {
                    let digits = decimals(&text);
                    let format = styles
                        .number
                        .clone()
                        .set_num_format(format!("+{digits};-{digits};{digits}"));
                    sheet
                        .write_number_with_format(at.0, at.1, value, &format)
                        .map(|_| ())
                }
                None => write_words(sheet, at, &text, words),
            }
        }
    }
}

/// A change as on the page, "+1.38": a number with the shown digits.
fn signed_number(text: &str) -> Option<f64> {
    let is_signed = text.starts_with(['+', '−']);
    let value = is_signed.then(|| text.replace('−', "-").parse::<f64>().ok());
    value.flatten().filter(|value| value.is_finite())
}

fn write_deviation(
    sheet: &mut Worksheet,
    at: (u32, u16),
    cell: Option<&Cell>,
    styles: &Styles,
) -> Result<(), XlsxError> {
    let Some((cell, quantity)) = cell.and_then(|cell| cell.quantity().map(|of| (cell, of))) else {
        return Ok(());
    };
    if let Some(sd) = quantity.sd_si.filter(|sd| sd.is_finite()) {
        let format = styles
            .number
            .clone()
            .set_num_format(number_format(cell, quantity));
        sheet.write_number_with_format(at.0, at.1, sd * quantity.unit.factor, &format)?;
    }
    Ok(())
}

/// The number format of Excel for the digits of the page: "0.000".
fn number_format(cell: &Cell, quantity: &Quantity) -> String {
    let digits = decimals(&quantity.number());
    match cell {
        Cell::Rises(_) => format!("{digits}\" ↑\""),
        Cell::Words(_) | Cell::BadWords(_) | Cell::Number(_) | Cell::Bad(_) => digits,
    }
}

/// As many digits after the point as the last number of a text, such as "1.88 ± 0.04".
fn decimals(text: &str) -> String {
    let last = text.rsplit(' ').next().unwrap_or_default();
    let is_plain = last.chars().all(|c| c.is_ascii_digit() || ".+-−".contains(c));
    match last.split_once('.') {
        _ if !is_plain => "General".to_owned(),
        Some((_, decimals)) => format!("0.{}", "0".repeat(decimals.len())),
        None => "0".to_owned(),
    }
}

/// Writes text, never as a formula, cut to the cell limit.
pub(super) fn write_words(
    sheet: &mut Worksheet,
    at: (u32, u16),
    text: &str,
    format: &Format,
) -> Result<(), XlsxError> {
    let cut: String = text.chars().take(CHARACTERS_MOST).collect();
    sheet
        .write_string_with_format(at.0, at.1, cut, format)
        .map(|_| ())
}

/// The value of a cell in its displayed unit.
fn shown_value(quantity: &Quantity) -> f64 {
    quantity.value_si * quantity.unit.factor
}
