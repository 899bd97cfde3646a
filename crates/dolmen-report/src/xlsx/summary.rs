//! The first sheet: the headline and findings of each project, and the list of sheets.

use super::sheet::{Styles, characters, lines_of, row_height, write_words};
use super::words::Workbook;
use crate::html::{Imprint, NotReported, has_headline, headline_line, project_name};
use crate::whole::all_findings;
use dolmen_words::{Language, Sentence};
use dolmen_work::answer::ProjectReport;
use rust_xlsxwriter::{Url, Worksheet, XlsxError};

/// Widths of the two columns, in characters.
const WIDTHS: [usize; 2] = [36, 110];

/// A sheet and its caption.
pub(super) struct Listed {
    pub(super) sheet: String,
    pub(super) caption: String,
}

/// Content of the first sheet.
pub(super) struct Summary<'a> {
    projects: Vec<(&'a ProjectReport, Vec<Listed>)>,
    others: &'a [NotReported],
    imprint: &'a Imprint,
}

/// The name of the only project, or a title for all.
pub(super) fn title(answers: &[ProjectReport], language: Language) -> String {
    match answers {
        [one] => project_name(one, language).to_owned(),
        _ => said(Workbook::Reports {}, language),
    }
}

fn said(words: Workbook, language: Language) -> String {
    Sentence::from(words).text(language)
}

impl<'a> Summary<'a> {
    pub(super) fn new(answers: &'a [ProjectReport], others: &'a [NotReported], imprint: &'a Imprint) -> Self {
        Summary {
            projects: answers.iter().map(|answer| (answer, Vec::new())).collect(),
            others,
            imprint,
        }
    }

    pub(super) fn sheet_name(language: Language) -> String {
        said(Workbook::Summary {}, language)
    }

    /// Adds a sheet to the list of a project, counted from 0.
    pub(super) fn list(&mut self, project: usize, listed: Listed) {
        if let Some((_, sheets)) = self.projects.get_mut(project) {
            sheets.push(listed);
        }
    }

    pub(super) fn write(
        &self,
        sheet: &mut Worksheet,
        language: Language,
        styles: &Styles,
    ) -> Result<(), XlsxError> {
        for (column, width) in (0..).zip(WIDTHS) {
            sheet.set_column_width(column, characters(width))?;
        }
        let made = [self.imprint.date.as_deref(), Some(&self.imprint.program)];
        let made: Vec<&str> = made.into_iter().flatten().collect();
        write_words(sheet, (0, 0), &made.join(" · "), &styles.caption)?;
        let mut row = 2;
        for other in self.others {
            let (file, why) = (other.file.clone(), other.why.clone());
            let words = said(Workbook::NotReported { file, why }, language);
            write_long(sheet, row, &words, styles)?;
            row += 1;
        }
        for (answer, sheets) in &self.projects {
            row = project(sheet, row, answer, language, styles)?;
            row = list(sheet, row, sheets, language, styles)? + 1;
        }
        sheet.set_print_fit_to_pages(1, 0);
        Ok(())
    }
}

/// Text of several lines in the wide column.
fn write_long(sheet: &mut Worksheet, row: u32, words: &str, styles: &Styles) -> Result<(), XlsxError> {
    write_words(sheet, (row, 1), words, &styles.words)?;
    sheet.set_row_height(row, row_height(lines_of(words, WIDTHS[1])))?;
    Ok(())
}

/// The name, the headline and the findings; returns the next free row.
fn project(
    sheet: &mut Worksheet,
    first: u32,
    answer: &ProjectReport,
    language: Language,
    styles: &Styles,
) -> Result<u32, XlsxError> {
    write_words(sheet, (first, 0), project_name(answer, language), &styles.title)?;
    let mut row = first + 1;
    if has_headline(answer) {
        write_words(sheet, (row, 0), &headline_line(answer, language), &styles.caption)?;
        row += 1;
    }
    row += 1;
    write_words(
        sheet,
        (row, 0),
        &said(Workbook::Findings {}, language),
        &styles.caption,
    )?;
    for finding in all_findings(answer) {
        let words = format!("{} {}", finding.tone.sign(), finding.sentence.text(language));
        write_long(sheet, row, &words, styles)?;
        row += 1;
    }
    Ok(row + 1)
}

/// The sheets with their captions; returns the next free row.
fn list(
    sheet: &mut Worksheet,
    first: u32,
    sheets: &[Listed],
    language: Language,
    styles: &Styles,
) -> Result<u32, XlsxError> {
    write_words(
        sheet,
        (first, 0),
        &said(Workbook::Tables {}, language),
        &styles.caption,
    )?;
    for (row, listed) in (first + 1..).zip(sheets) {
        let link = Url::new(format!("internal:'{}'!A1", listed.sheet)).set_text(&listed.sheet);
        sheet.write_url(row, 0, link)?;
        write_long(sheet, row, &listed.caption, styles)?;
    }
    Ok(first + 1 + u32::try_from(sheets.len()).unwrap_or(0))
}
