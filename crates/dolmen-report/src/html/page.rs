//! The page: head, verdict, findings, sections, method, evidence.

use super::front::{Banner, banner, closing, has_headline, headline_line, kind_words, project_name, sources};
use super::fronted::{Fronted, text};
use super::given;
use super::imprint::{Imprint, NotReported};
use super::style::STYLE;
use super::words::colour_class;
use crate::document::{Block, Numbers, block_html, document_html, findings_html, numbered};
use crate::engineer::{cover_rows, front, report_title};
use crate::lowered::with_lowered;
use crate::mark::GENERATOR;
use crate::whole::{all_findings, whole_document};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use maud::{DOCTYPE, Markup, PreEscaped, html as markup};

/// The report on one or more projects as a self-contained page: no external script, font or picture.
///
/// In print each project begins on a new page, after a list of all projects. Missing data are left out or described as unknown.
/// Projects without a report are listed first.
pub fn html(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
) -> String {
    let title = match (answers, others) {
        ([one], []) => project_name(one, language).to_string(),
        _ => text(Fronted::Reports, language),
    };
    let body = markup! {
        @if answers.len() + others.len() > 1 { (contents(answers, others, language)) }
        @for (i, answer) in answers.iter().enumerate() {
            article id=(format!("report-{}", i + 1)) {
                (article(answer, language, imprint, (answers.len() > 1).then_some(i + 1)))
            }
        }
    };
    let page = whole(&title, language, &body);
    // the title contains no tags
    let (head, body) = page.split_at(page.find("<body>").unwrap_or(0));
    let body = with_lowered(body, |index| format!("<sub>{index}</sub>"));
    format!("{head}{body}")
}

/// Content of a page: its style sheet and the styles in its figures, embedded images; no scripts or external resources.
const POLICY: &str =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

/// A self-contained page.
pub(super) fn whole(title: &str, language: Language, body: &Markup) -> String {
    markup! {
        (DOCTYPE)
        html lang=(language.code()) {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="generator" content=(GENERATOR);
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body { (body) }
        }
    }
    .into_string()
}

fn contents(answers: &[ProjectReport], others: &[NotReported], language: Language) -> Markup {
    markup! {
        nav {
            h1 { (text(Fronted::Reports, language)) }
            ol { @for (i, answer) in answers.iter().enumerate() {
                li {
                    a href=(format!("#report-{}", i + 1)) { (project_name(answer, language)) }
                    @if has_headline(answer) { ": " (headline_line(answer, language)) }
                }
            } }
            @for other in others {
                p.note {
                    (text(Fronted::NotReported, language)) ": " code { (other.file) } ": "
                    (other.why)
                }
            }
        }
    }
}

/// The report on a project, with its number if there are several.
fn article(answer: &ProjectReport, language: Language, imprint: &Imprint, number: Option<usize>) -> Markup {
    let project = &answer.project;
    let mut numbers = number.map_or(Numbers::alone(), Numbers::of_project);
    let name = project_name(answer, language);
    let front = front(answer);
    let other = language.pick(project.name.korean(), project.name.english());
    markup! {
        header {
            @if let Some(title) = report_title(answer) { p.kicker { (title.text(language)) } }
            @else { p.kicker { (kind_words(&project.structure, language)) } }
            h1 { @match number { Some(number) => (numbered(&number.to_string(), name)), None => (name) } }
            @if other != project_name(answer, language) { p.sub { (other) } }
            @if project.report.is_some() { dl.cover { @for (key, value) in cover_rows(answer, imprint) {
                dt { (key.text(language)) } dd { (value.text(language)) }
            } } }
            @else { p.sub {
                @if let Some(date) = &imprint.date { (date) " · " }
                (imprint.program)
            } }
        }
        @if let Some((head, block)) = &front.signatures { h2 id=(numbers.anchor(head)) { (head.text(language)) } (block_html(block, language, &mut numbers)) }
        @if let Some(banner) = banner(answer, language) { (banner_html(&banner)) }
        @if let Some(block) = &front.answers { (block_html(block, language, &mut numbers)) }
        h2 id=(numbers.anchor(&Fronted::Findings.into())) { (text(Fronted::Findings, language)) }
        (findings_html(&all_findings(answer), language))
        @if let Some((head, block)) = &front.to_do { h3 id=(numbers.anchor(head)) { (head.text(language)) } (block_html(block, language, &mut numbers)) }
        (document_html(&whole_document(answer), language, &mut numbers))
        (given::section(answer, language, &mut numbers))
        (block_html(&Block::Heading(Fronted::Sources.into()), language, &mut numbers))
        ul { @for line in sources(answer, language, imprint) { li { (line) } } }
        footer { (closing(language)) }
    }
}

fn banner_html(banner: &Banner) -> Markup {
    markup! {
        div class=(format!("verdict {}", colour_class(banner.colour))) {
            div.word { (banner.sign) " " (banner.words) }
            div {
                @for line in &banner.first { p { b { (line) } } }
                p { b { (banner.sentence) }
                    @if let Some(assumed) = &banner.assumed { " " (assumed) }
                }
                p.scale { (banner.scale) }
            }
        }
    }
}
