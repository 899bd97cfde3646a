//! A report as a workbook for Excel and LibreOffice: a summary, and each table on its own sheet with numeric cells.

mod fault;
mod form;
mod headed;
mod inputs;
mod properties;
mod sheet;
mod summary;
mod tables;
mod words;

pub use fault::WorkbookFault;
pub use form::score_form_workbook;
pub(crate) use inputs::inputs_tables;
pub(crate) use words::Workbook;

use crate::html::{Imprint, NotReported};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use properties::properties;
use rust_xlsxwriter::Workbook as Book;
use sheet::{Styles, write_table};
use summary::{Listed, Summary};

/// The report on one or more projects as the bytes of an XLSX file.
///
/// The first sheet contains the headlines and findings and lists the other sheets: the inputs and every table of the report, one per sheet.
/// Numbers have full precision in the unit of their column, with a number format for the digits of the page; a standard deviation has its own
/// column. Figures are left out. The same input gives the same bytes.
///
/// # Errors
/// If the writer refuses, as for more rows than a sheet holds (1,048,576).
pub fn workbook(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
) -> Result<Vec<u8>, WorkbookFault> {
    let mut book = Book::new();
    let styles = Styles::new();
    book.set_properties(&properties(answers, language, imprint)?);
    // the summary comes first, but is written last, when its list of sheets is complete
    let summary_name = Summary::sheet_name(language);
    book.add_worksheet().set_name(&summary_name)?;
    let mut summary = Summary::new(answers, others, imprint);
    for (number, answer) in answers.iter().enumerate() {
        for table in tables::tables(answer) {
            let name = sheet_name(book.worksheets().len(), &table.head.text(language));
            let sheet = book.add_worksheet().set_name(&name)?;
            write_table(sheet, &table, &summary_name, language, &styles)?;
            summary.list(
                number,
                Listed {
                    sheet: name,
                    caption: table.caption_text(language),
                },
            );
        }
    }
    summary.write(book.worksheet_from_index(0)?, language, &styles)?;
    Ok(book.save_to_buffer()?)
}

/// "3 Joints": at most 31 characters, without those that Excel refuses, unique.
fn sheet_name(number: usize, head: &str) -> String {
    const CHARACTERS_MOST: usize = 31;
    let allowed = head
        .chars()
        .filter(|c| !"[]:*?/\\'".contains(*c) && !c.is_control());
    let name: String = format!("{number} ")
        .chars()
        .chain(allowed)
        .take(CHARACTERS_MOST)
        .collect();
    name.trim_end().to_owned()
}
