//! A report for word processors: paragraphs, headings, tables, pictures and captions in order. DOCX and HWPX are both written from this.

mod archive;
#[cfg(test)]
mod beside_page;
mod body;
mod fault;
mod grid;
mod ink;
mod media;
mod parts;
mod piece;
pub(crate) mod xml;

use crate::document::Numbers;
use crate::engineer::date_of;
use crate::html::front::kind_words;
use crate::html::{Imprint, NotReported, day, project_name};
pub(crate) use archive::{Part, pack};
#[cfg(test)]
pub(crate) use beside_page::holds_the_page;
use body::Body;
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
pub use fault::PaperFault;
pub(crate) use grid::{Grid, Shown, WHOLE_ROWS, line_count, text_size, widths};
pub(crate) use ink::{BAD, BAD_WASH, HAIR, INK, Ink, QUIET, TEXT_WIDTH, TWIPS, tone};
pub(crate) use media::{Media, Picture};
pub(crate) use piece::{Caption, Heading, Paragraph, Piece, Role, Run, Shade};

/// A report ready to be written.
#[derive(Clone, Debug)]
pub(crate) struct Paper {
    pub(crate) title: String,
    /// Kind of the structure; empty for several projects.
    pub(crate) kind: &'static str,
    pub(crate) program: String,
    /// "2026-05-12", if it is a date.
    pub(crate) date: Option<String>,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) files: Vec<(String, Vec<u8>)>,
    pub(crate) with_contents: bool,
}

/// The report on one or more projects; `paint` makes a PNG of a figure's SVG.
///
/// # Errors
/// [`PaperFault::Figure`].
pub(crate) fn paper(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Paper, PaperFault> {
    let (title, kind) = match (answers, others) {
        ([one], []) => (
            project_name(one, language),
            kind_words(&one.project.structure, language),
        ),
        _ => (language.pick("Reports", "보고서 모음"), ""),
    };
    let date = match answers {
        [one] => date_of(one, imprint),
        _ => imprint.date.as_deref(),
    };
    let mut body = Body {
        language,
        pieces: Vec::new(),
        media: Media::new(paint),
        numbers: Numbers::alone(),
        deeper: 0,
        heads: 0,
    };
    let alone = answers.len() == 1;
    if answers.len() > 1 {
        body.several(answers, others);
    }
    for (at, answer) in answers.iter().enumerate() {
        if at > 0 {
            body.pieces.push(Piece::NextProject);
        }
        body.project(answer, imprint, (!alone).then_some(at + 1))?;
    }
    body.not_reported(others, answers.len());
    keep_leads(&mut body.pieces);
    Ok(Paper {
        title: title.to_owned(),
        kind,
        program: imprint.program.clone(),
        date: date.filter(|date| day(Some(date)).is_some()).map(str::to_owned),
        pieces: body.pieces,
        files: body.media.files,
        with_contents: alone,
    })
}

/// A paragraph between a heading and a table or picture stays with both, so that no page ends with a heading and one sentence.
fn keep_leads(pieces: &mut [Piece]) {
    for at in 1..pieces.len().saturating_sub(1) {
        let is_first = matches!(pieces[at - 1], Piece::Heading(_));
        let stands_whole = match &pieces[at + 1] {
            Piece::Caption(caption) => caption.is_above,
            Piece::Picture(..) | Piece::Table(_) => true,
            _ => false,
        };
        if let Piece::Paragraph(paragraph) = &mut pieces[at]
            && is_first
            && stands_whole
        {
            paragraph.keeps_next = true;
        }
    }
}

impl Paper {
    /// The headings in the contents: two levels.
    pub(crate) fn entries(&self) -> impl Iterator<Item = &Heading> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Heading(head) if head.level <= 2 => Some(head),
            _ => None,
        })
    }
}
