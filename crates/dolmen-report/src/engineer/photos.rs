//! Photographs of the project in a report.

use super::words::{said, verbatim};
use crate::document::Photo;
use dolmen_project::PhotoPart;
use dolmen_words::Sentence;
use dolmen_work::Photos;
use dolmen_work::answer::ProjectReport;

/// Source of the photographs; `None` if only text is needed.
#[derive(Clone, Copy)]
pub(crate) struct Pictures<'a>(Option<&'a Photos>);

impl<'a> Pictures<'a> {
    /// The photographs of a report.
    pub(crate) fn of(answer: &'a ProjectReport) -> Self {
        Pictures(Some(&answer.photos))
    }

    /// No photos.
    pub(crate) fn unread() -> Self {
        Pictures(None)
    }

    /// A photograph with its caption and its part.
    pub(super) fn photo(self, part: &'a PhotoPart) -> Photo<'a> {
        let caption: Vec<Sentence> = match (&part.caption, &part.of) {
            (Some(caption), Some(of)) => vec![said(caption), verbatim(&format!("({of})"))],
            (Some(caption), None) => vec![said(caption)],
            (None, Some(of)) => vec![verbatim(of)],
            (None, None) => vec![verbatim(&part.file)],
        };
        Photo {
            caption,
            file: &part.file,
            image: self.0.and_then(|photos| photos.get(&part.file)),
        }
    }

    /// Several photographs.
    pub(super) fn photos(self, parts: &'a [PhotoPart]) -> Vec<Photo<'a>> {
        parts.iter().map(|part| self.photo(part)).collect()
    }
}
