//! The parts of a report: cover, answers, findings, sections.

use super::literal::{array, literal};
use crate::behind::behind_document;
use crate::document::{Block, Finding};
use crate::engineer::{cover_photo, cover_rows, front, report_title};
use crate::html::front::{banner, kind_words, listed};
use crate::html::fronted::{Fronted, text};
use crate::html::{Imprint, NotReported, project_name};
use crate::whole::{all_findings, whole_document};
use dolmen_project::Structure;
use dolmen_words::{Language, Sentence};
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::Colour;

/// The running header of each page.
pub(super) fn running_head(answers: &[ProjectReport], language: Language) -> &'static str {
    match answers {
        [one] => kind_words(&one.project.structure, language),
        _ => "",
    }
}

/// The source being written.
pub(super) struct Parts {
    pub(super) language: Language,
    main: String,
    figures: Vec<(String, Vec<u8>)>,
    /// Additional heading depth, relative to a report on one project.
    deeper: usize,
}

impl Parts {
    pub(super) fn new(language: Language) -> Self {
        Parts {
            language,
            main: String::new(),
            figures: Vec::new(),
            deeper: 0,
        }
    }

    pub(super) fn finish(self) -> (String, Vec<(String, Vec<u8>)>) {
        (self.main, self.figures)
    }

    pub(super) fn line(&mut self, line: &str) {
        self.main.push_str(line);
        self.main.push('\n');
    }

    /// A call of a prelude function with a text.
    pub(super) fn call(&mut self, function: &str, words: &str) {
        self.line(&format!("#{function}({})", literal(words)));
    }

    pub(super) fn heading(&mut self, level: usize, words: &str) {
        self.line(&format!(
            "#heading(level: {}, {})",
            level + self.deeper,
            literal(words)
        ));
    }

    pub(super) fn list(&mut self, points: impl IntoIterator<Item = String>) {
        let each = array(points.into_iter().map(|point| literal(&point)));
        self.line(&format!("#list(..{each})"));
    }

    /// Stores a figure, and returns its file name; spells out a character that the fonts lack.
    pub(super) fn figure_file(&mut self, svg: &str) -> String {
        let svg = svg.replace('⊕', "(+)");
        let name = format!("figure-{}.svg", self.figures.len() + 1);
        self.figures.push((name.clone(), svg.into_bytes()));
        name
    }

    /// Stores a photograph, and returns its file name.
    pub(super) fn photo_file(&mut self, photo: &dolmen_records::Photo) -> String {
        let name = format!("photo-{}.{}", self.figures.len() + 1, photo.format.extension());
        self.figures.push((name.clone(), photo.bytes.clone()));
        name
    }

    /// A heading without a number, left out of the contents.
    fn plain_heading(&mut self, level: usize, words: &str) {
        self.line(&format!(
            "#heading(level: {}, numbering: none, outlined: false, {})",
            level + self.deeper,
            literal(words)
        ));
    }

    /// The list of several projects, before the cover of the first.
    pub(super) fn several(&mut self, answers: &[ProjectReport], others: &[NotReported]) {
        let language = self.language;
        self.plain_heading(1, &text(Fronted::Reports, language));
        self.list(listed(answers, others, language));
    }

    /// The report on one project.
    pub(super) fn project(&mut self, answer: &ProjectReport, imprint: &Imprint, alone: bool) {
        let language = self.language;
        self.cover(answer, imprint);
        self.deeper = usize::from(!alone);
        if !alone {
            self.line(&format!(
                "#heading(level: 1, {})",
                literal(project_name(answer, language))
            ));
        }
        let front = front(answer);
        if let Some((head, block)) = &front.signatures {
            self.plain_heading(1, &head.text(language));
            self.block(block);
        }
        if alone {
            self.call("contents", language.code());
            self.line("#pagebreak(weak: true)");
        }
        if let Some(banner) = banner(answer, language) {
            let sentence: Vec<String> = [Some(banner.sentence), banner.assumed]
                .into_iter()
                .flatten()
                .collect();
            self.line(&format!(
                "#banner({}, {}, {}, {}, {})",
                literal(colour(banner.colour)),
                literal(&banner.words),
                array(banner.first.iter().map(|line| literal(line))),
                literal(&sentence.join(" ")),
                literal(&banner.scale),
            ));
        }
        if let Some(block) = &front.answers {
            self.block(block);
        }
        self.findings(&all_findings(answer));
        if let Some((head, block)) = &front.to_do {
            self.plain_heading(2, &head.text(language));
            self.block(block);
        }
        self.document(&whole_document(answer));
        self.document(&behind_document(answer, imprint));
    }

    fn cover(&mut self, answer: &ProjectReport, imprint: &Imprint) {
        let language = self.language;
        let project = &answer.project;
        let name = project_name(answer, language);
        let other = Some(language.pick(project.name.korean(), project.name.english()));
        let other = other.filter(|other| *other != name);
        let rows = cover_rows(answer, imprint);
        let said = |sentence: &Sentence| literal(&sentence.text(language));
        let rows = array(
            rows.iter()
                .map(|(key, value)| format!("({}, {})", said(key), said(value))),
        );
        let title = report_title(answer);
        let kind = title.as_ref().map_or_else(
            || kind_words(&project.structure, language),
            |title| title.text(language),
        );
        let picture = self.picture(answer);
        self.line(&format!(
            "#cover(kind: {}, title: {}, other: {}, rows: {rows}, picture: {picture})",
            literal(kind),
            literal(name),
            other.map_or("none".to_owned(), literal),
        ));
    }

    /// The first photograph for the cover, otherwise a stack as drawn; none for other kinds, which begin with graphs.
    fn picture(&mut self, answer: &ProjectReport) -> String {
        if let Some(photo) = cover_photo(answer)
            && let Some(image) = photo.image
        {
            let file = self.photo_file(image);
            return format!("({}, {})", literal(&file), literal(&photo.text(self.language)));
        }
        if !matches!(answer.project.structure, Structure::Stack(_)) {
            return "none".to_owned();
        }
        let document = whole_document(answer);
        let first = document.blocks.iter().find_map(|block| match block {
            Block::Figures(figures) => figures.first(),
            _ => None,
        });
        let Some(first) = first else {
            return "none".to_owned();
        };
        let file = self.figure_file(&(first.draw)(self.language));
        let said = first.caption.first();
        let said = said.map_or(String::new(), |said| said.text(self.language));
        format!("({}, {})", literal(&file), literal(&said))
    }

    fn findings(&mut self, findings: &[Finding]) {
        let head = &text(Fronted::Findings, self.language);
        self.plain_heading(1, head);
        for finding in findings {
            let words = finding.sentence.text(self.language);
            self.line(&format!(
                "#finding({}, {})",
                literal(finding.tone.class()),
                literal(&words)
            ));
        }
    }

    /// Projects that could not be reported on, and why.
    pub(super) fn not_reported(&mut self, others: &[NotReported]) {
        if others.is_empty() {
            return;
        }
        let language = self.language;
        self.deeper = 0;
        self.heading(1, &text(Fronted::NotReported, language));
        let said = others
            .iter()
            .map(|other| format!("{}: {}", other.file, other.why));
        self.list(said);
    }
}

fn colour(colour: Colour) -> &'static str {
    match colour {
        Colour::Green => "good",
        Colour::Amber => "warn",
        Colour::Red => "bad",
    }
}
