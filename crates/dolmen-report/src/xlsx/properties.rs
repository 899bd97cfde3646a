//! Title, author and date of a workbook.

use super::summary::title;
use crate::engineer::date_of;
use crate::html::Imprint;
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use rust_xlsxwriter::{DocProperties, ExcelDateTime, XlsxError};

/// Excel requires a date in every file; this is the default, so that the same input gives the same bytes.
const NO_DATE: (u16, u8, u8) = (2000, 1, 1);

pub(super) fn properties(
    answers: &[ProjectReport],
    language: Language,
    imprint: &Imprint,
) -> Result<DocProperties, XlsxError> {
    let (year, month, day) = NO_DATE;
    let date = match answers {
        [one] => date_of(one, imprint),
        _ => imprint.date.as_deref(),
    };
    let given = date.and_then(|date| ExcelDateTime::parse_from_str(date).ok());
    let date = match given {
        Some(date) => date,
        None => ExcelDateTime::from_ymd(year, month, day)?,
    };
    Ok(DocProperties::new()
        .set_title(title(answers, language))
        .set_author(&imprint.program)
        .set_creation_datetime(&date))
}
