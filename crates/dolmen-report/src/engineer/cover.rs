//! The cover: title, client, author, date.

use super::photos::Pictures;
use super::words::{both, said, verbatim};
use crate::document::Photo;
use crate::html::Imprint;
use dolmen_words::{Sentence, messages};
use dolmen_work::answer::ProjectReport;

messages! {
    /// Keys of the cover.
    pub(crate) enum Cover in "engineer.cover" {
        Address => { en: "Location", ko: "위치" },
        Client => { en: "Client", ko: "의뢰 기관" },
        Organisation => { en: "Prepared by", ko: "수행 기관" },
        OrganisationAt => { en: "Address", ko: "주소" },
        Date => { en: "Date", ko: "보고일" },
        Number => { en: "Document", ko: "문서 번호" },
        Program => { en: "Computed by", ko: "계산 프로그램" },
    }
}

/// The date of the report: from the command, otherwise from the file.
pub(crate) fn date_of<'a>(answer: &'a ProjectReport, imprint: &'a Imprint) -> Option<&'a str> {
    let own = answer
        .project
        .report
        .as_ref()
        .and_then(|report| report.date.as_deref());
    imprint.date.as_deref().or(own)
}

/// The engineer's title.
pub(crate) fn report_title(answer: &ProjectReport) -> Option<dolmen_words::message::Both> {
    answer.project.report.as_ref()?.title.as_ref().map(both)
}

/// Rows of the cover below the name, in order.
pub(crate) fn cover_rows(answer: &ProjectReport, imprint: &Imprint) -> Vec<(Sentence, Sentence)> {
    let report = answer.project.report.clone().unwrap_or_default();
    let address = report.location.and_then(|location| location.address);
    let date = date_of(answer, imprint).map(verbatim);
    let rows = [
        (Cover::Address, address.as_ref().map(said)),
        (Cover::Client, report.client.as_ref().map(said)),
        (Cover::Organisation, report.organisation.as_ref().map(said)),
        (Cover::OrganisationAt, report.address.as_ref().map(said)),
        (Cover::Date, date),
        (Cover::Number, report.number.as_ref().map(said)),
        (Cover::Program, Some(verbatim(&imprint.program))),
    ];
    let given = rows.into_iter();
    given
        .filter_map(|(key, value)| Some((key.into(), value?)))
        .collect()
}

/// The photograph of the cover: the first one.
pub(crate) fn cover_photo(answer: &ProjectReport) -> Option<Photo<'_>> {
    let first = answer.project.report.as_ref()?.photos.first()?;
    Some(Pictures::of(answer).photo(first))
}
