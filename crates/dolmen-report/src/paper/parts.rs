//! The parts of a report: cover, answers, findings, contents, sections.

use super::body::{Body, WIDTH};
use super::{Grid, Ink, PaperFault, Paragraph, Piece, QUIET, Role, Run, Shown, tone};
use crate::behind::behind_document;
use crate::document::{Block, Document, Finding, Numbers, Tone};
use crate::engineer::{cover_photo, cover_rows, front, report_title};
use crate::html::front::{banner, kind_words, listed};
use crate::html::fronted::{Fronted, text};
use crate::html::{Imprint, NotReported, project_name};
use crate::whole::{all_findings, whole_document};
use dolmen_project::Structure;
use dolmen_words::Sentence;
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::Colour;

/// Largest height of the picture on a cover, points, so that the rows below fit on the same page.
const COVER_HEIGHT_MOST: f64 = 270.0;

impl Body<'_> {
    /// The list of several projects, before the cover of the first.
    pub(super) fn several(&mut self, answers: &[ProjectReport], others: &[NotReported]) {
        self.line(Role::FrontHeading, &text(Fronted::Reports, self.language));
        for said in listed(answers, others, self.language) {
            self.line(Role::Bullet, &said);
        }
        self.pieces.push(Piece::PageBreak);
    }

    /// The whole report on one project, with its number if there are several.
    pub(super) fn project(
        &mut self,
        answer: &ProjectReport,
        imprint: &Imprint,
        number: Option<usize>,
    ) -> Result<(), PaperFault> {
        let language = self.language;
        self.numbers = number.map_or(Numbers::alone(), Numbers::of_project);
        let whole = whole_document(answer);
        self.cover(answer, &whole, imprint)?;
        if let Some(number) = number {
            self.deeper = 0;
            self.heading(1, &number.to_string(), project_name(answer, language));
            self.deeper = 1;
        }
        let front = front(answer);
        if let Some((head, block)) = &front.signatures {
            self.line(Role::FrontHeading, &head.text(language));
            self.block(block)?;
        }
        if number.is_none() {
            self.pieces.push(Piece::Contents);
            self.pieces.push(Piece::PageBreak);
        }
        self.banner(answer);
        if let Some(block) = &front.answers {
            self.block(block)?;
        }
        self.findings(&all_findings(answer));
        if let Some((head, block)) = &front.to_do {
            self.line(Role::FrontHeading, &head.text(language));
            self.block(block)?;
        }
        self.document(&whole)?;
        self.document(&behind_document(answer, imprint))
    }

    fn cover(
        &mut self,
        answer: &ProjectReport,
        whole: &Document<'_>,
        imprint: &Imprint,
    ) -> Result<(), PaperFault> {
        let language = self.language;
        let project = &answer.project;
        let name = project_name(answer, language);
        let title = report_title(answer);
        let kind = title.as_ref().map_or_else(
            || kind_words(&project.structure, language),
            |title| title.text(language),
        );
        self.pieces.push(Piece::Paragraph(Paragraph {
            room_above: Some(1800),
            ..Paragraph::of(Role::Subtitle, kind)
        }));
        self.line(Role::Title, name);
        let other = language.pick(project.name.korean(), project.name.english());
        if other != name {
            self.line(Role::Subtitle, other);
        }
        self.picture(answer, whole)?;
        let rows = cover_rows(answer, imprint);
        let shown = |text: &Sentence| Shown {
            text: text.text(language),
            is_bad: false,
        };
        self.pieces.push(Piece::Gap(Some(600)));
        self.pieces.push(Piece::Table(Grid {
            heads: Vec::new(),
            is_words: vec![true, true],
            is_form: false,
            rows: rows
                .iter()
                .map(|(key, value)| vec![shown(key), shown(value)])
                .collect(),
        }));
        self.pieces.push(Piece::PageBreak);
        Ok(())
    }

    /// The first photograph for the cover, otherwise a stack as drawn; none for other kinds, which begin with graphs.
    fn picture(&mut self, answer: &ProjectReport, whole: &Document<'_>) -> Result<(), PaperFault> {
        let photo = cover_photo(answer).and_then(|photo| Some((photo.image?, photo.text(self.language))));
        if let Some((image, alt)) = photo {
            let picture = self.media.photo(image, &alt, WIDTH);
            self.pieces.push(Piece::Picture(picture, true));
            return Ok(());
        }
        if !matches!(answer.project.structure, Structure::Stack(_)) {
            return Ok(());
        }
        let first = whole.blocks.iter().find_map(|block| match block {
            Block::Figures(figures) => figures.first(),
            _ => None,
        });
        let Some(first) = first else { return Ok(()) };
        let alt = first.caption.first().map(|said| said.text(self.language));
        let svg = (first.draw)(self.language);
        let picture = self.media.picture(&svg, &alt.unwrap_or_default(), WIDTH)?;
        let picture = picture.within(COVER_HEIGHT_MOST);
        self.pieces.push(Piece::Picture(picture, true));
        Ok(())
    }

    /// The answers: the words first, then their context.
    fn banner(&mut self, answer: &ProjectReport) {
        let Some(banner) = banner(answer, self.language) else {
            return;
        };
        let [colour, wash, sign] = tone(match banner.colour {
            Colour::Green => Tone::Good,
            Colour::Amber => Tone::Warn,
            Colour::Red => Tone::Bad,
        });
        let mut line = |text: &str, ink: Ink| {
            let runs = vec![Run::Words(text.to_owned(), ink)];
            self.shaded(Role::Judgement, [colour, wash], runs);
        };
        line(&format!("{sign} {}", banner.words), Ink::bold(colour));
        for first in &banner.first {
            line(first, Ink::BOLD);
        }
        let sentence: Vec<String> = [Some(banner.sentence), banner.assumed]
            .into_iter()
            .flatten()
            .collect();
        line(&sentence.join(" "), Ink::PLAIN);
        let quiet = Ink {
            bold: false,
            colour: Some(QUIET),
        };
        line(&banner.scale, quiet);
    }

    fn findings(&mut self, findings: &[Finding]) {
        let language = self.language;
        self.line(Role::FrontHeading, &text(Fronted::Findings, language));
        for finding in findings {
            let [colour, _, sign] = tone(finding.tone);
            self.pieces.push(Piece::Paragraph(Paragraph {
                runs: vec![
                    Run::Words(sign.to_owned(), Ink::bold(colour)),
                    Run::Tab,
                    Run::Words(finding.sentence.text(language), Ink::PLAIN),
                ],
                ..Paragraph::of(Role::Finding, "")
            }));
        }
    }

    /// Projects that could not be reported on, and why.
    pub(super) fn not_reported(&mut self, others: &[NotReported], answers: usize) {
        if others.is_empty() {
            return;
        }
        let language = self.language;
        self.deeper = 0;
        let number = match answers {
            1 => self.numbers.section(),
            several => (several + 1).to_string(),
        };
        let head = text(Fronted::NotReported, language);
        self.heading(1, &number, &head);
        for other in others {
            self.line(Role::Bullet, &format!("{}: {}", other.file, other.why));
        }
    }
}
