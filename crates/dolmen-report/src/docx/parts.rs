//! The parts of a report: cover, what the answers come to, findings, contents, sections.

use super::body::{Body, shaded};
use super::contents::contents;
use super::fault::DocxFault;
use super::inline::{Ink, paragraph, said, tab, words};
use super::look::{MARGIN_SIDE, MARGIN_TOP, PAGE, TEXT_WIDTH, tone};
use super::table::{Grid, Shown, table};
use super::xml::Xml;
use crate::behind::behind_document;
use crate::document::{Block, Document, Finding, Numbers, Tone};
use crate::engineer::{cover_photo, cover_rows, front, report_title};
use crate::html::front::{banner, kind_words};
use crate::html::{Imprint, NotReported, project_name};
use crate::whole::{all_findings, whole_document};
use dolmen_project::Structure;
use dolmen_words::Sentence;
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::Colour;

impl Body<'_> {
    /// The whole report on one project; its number where there are several.
    pub(super) fn project(
        &mut self,
        answer: &ProjectReport,
        imprint: &Imprint,
        number: Option<usize>,
    ) -> Result<(), DocxFault> {
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
            said(&mut self.xml, "FrontHeading", &head.text(language));
            self.block(block)?;
        }
        self.banner(answer);
        if let Some(block) = &front.answers {
            self.block(block)?;
        }
        self.findings(&all_findings(answer));
        if let Some((head, block)) = &front.to_do {
            said(&mut self.xml, "FrontHeading", &head.text(language));
            self.block(block)?;
        }
        if number.is_none() {
            self.front = std::mem::take(&mut self.xml);
        }
        self.document(&whole)?;
        self.document(&behind_document(answer, imprint))
    }

    /// All of it, the contents before the sections that they name.
    pub(super) fn finish(mut self, with_contents: bool) -> (Xml, Vec<(String, Vec<u8>)>) {
        let mut all = self.front;
        if with_contents {
            contents(&mut all, &self.entries, self.language);
            page_break(&mut all);
        }
        all.append(std::mem::take(&mut self.xml));
        (all, self.media.files)
    }

    fn cover(
        &mut self,
        answer: &ProjectReport,
        whole: &Document<'_>,
        imprint: &Imprint,
    ) -> Result<(), DocxFault> {
        let language = self.language;
        let project = &answer.project;
        let name = project_name(answer, language);
        let title = report_title(answer);
        let kind = title.as_ref().map_or_else(
            || kind_words(&project.structure, language),
            |title| title.text(language),
        );
        let down = |xml: &mut Xml| xml.leaf("w:spacing", &[("w:before", "1800")]);
        paragraph(&mut self.xml, "Subtitle", down, |xml| {
            words(xml, kind, Ink::PLAIN);
        });
        said(&mut self.xml, "Title", name);
        let other = language.pick(project.name.korean(), project.name.english());
        if other != name {
            said(&mut self.xml, "Subtitle", other);
        }
        self.picture(answer, whole)?;
        let rows = cover_rows(answer, imprint);
        let shown = |text: &Sentence| Shown {
            text: text.text(language),
            is_bad: false,
        };
        let down = |xml: &mut Xml| xml.leaf("w:spacing", &[("w:before", "600")]);
        paragraph(&mut self.xml, "AfterTable", down, |_| ());
        table(
            &mut self.xml,
            &Grid {
                heads: Vec::new(),
                is_words: vec![true, true],
                rows: rows
                    .iter()
                    .map(|(key, value)| vec![shown(key), shown(value)])
                    .collect(),
            },
        );
        page_break(&mut self.xml);
        Ok(())
    }

    /// The first photograph for the cover, else a stack as it stands; none of other kinds, which begin with graphs.
    fn picture(&mut self, answer: &ProjectReport, whole: &Document<'_>) -> Result<(), DocxFault> {
        let width = TEXT_WIDTH as f64 / 20.0;
        let photo = cover_photo(answer).and_then(|photo| Some((photo.image?, photo.text(self.language))));
        if let Some((image, alt)) = photo {
            let picture = self.media.photo(image, &alt, width);
            paragraph(&mut self.xml, "Figure", on_cover, |xml| xml.append(picture));
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
        let picture = self.media.picture(&svg, &alt.unwrap_or_default(), width)?;
        paragraph(&mut self.xml, "Figure", on_cover, |xml| xml.append(picture));
        Ok(())
    }

    /// What the answers come to: the words first, then what must be read with them.
    fn banner(&mut self, answer: &ProjectReport) {
        let Some(state) = answer.state() else { return };
        let banner = banner(answer, state, self.language);
        let [colour, wash, sign] = tone(match banner.colour {
            Colour::Green => Tone::Good,
            Colour::Amber => Tone::Warn,
            Colour::Red => Tone::Bad,
        });
        let xml = &mut self.xml;
        let mut line = |text: &str, ink: Ink<'_>| {
            shaded(xml, "Judgement", [colour, wash], |xml| words(xml, text, ink));
        };
        let headline = Ink {
            bold: true,
            colour: Some(colour),
        };
        line(&format!("{sign} {}", banner.words), headline);
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
            colour: Some(super::look::QUIET),
        };
        line(&banner.scale, quiet);
    }

    fn findings(&mut self, findings: &[Finding]) {
        let language = self.language;
        said(
            &mut self.xml,
            "FrontHeading",
            language.pick("Findings", "검토 결과 요약"),
        );
        for finding in findings {
            let [colour, _, sign] = tone(finding.tone);
            let ink = Ink {
                bold: true,
                colour: Some(colour),
            };
            paragraph(
                &mut self.xml,
                "Finding",
                |_| (),
                |xml| {
                    words(xml, sign, ink);
                    tab(xml);
                    words(xml, &finding.sentence.text(language), Ink::PLAIN);
                },
            );
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
        let head = language.pick("Not reported on", "보고서에서 제외됨");
        self.heading(1, &number, head);
        for other in others {
            said(
                &mut self.xml,
                "ListBullet",
                &format!("{}: {}", other.file, other.why),
            );
        }
    }

    /// The end of a project: the next begins on a cover, which has no running lines.
    pub(super) fn end_section(&mut self) {
        self.xml
            .element("w:p", &[], |xml| xml.element("w:pPr", &[], section));
    }
}

/// Paper, margins and running lines of a section.
pub(super) fn section(xml: &mut Xml) {
    xml.element("w:sectPr", &[], |xml| {
        for (tag, id) in [("w:headerReference", "header"), ("w:footerReference", "footer")] {
            xml.leaf(tag, &[("w:type", "default"), ("r:id", id)]);
        }
        xml.leaf("w:pgSz", &[("w:w", PAGE[0]), ("w:h", PAGE[1])]);
        xml.leaf(
            "w:pgMar",
            &[
                ("w:top", MARGIN_TOP),
                ("w:right", MARGIN_SIDE),
                ("w:bottom", MARGIN_SIDE),
                ("w:left", MARGIN_SIDE),
                ("w:header", "737"),
                ("w:footer", "680"),
                ("w:gutter", "0"),
            ],
        );
        xml.leaf("w:titlePg", &[]);
    });
}

/// Where the picture of a cover stands.
fn on_cover(xml: &mut Xml) {
    xml.leaf("w:keepNext", &[("w:val", "0")]);
    xml.leaf("w:spacing", &[("w:before", "700")]);
}

fn page_break(xml: &mut Xml) {
    xml.element("w:p", &[], |xml| {
        xml.element("w:r", &[], |xml| xml.leaf("w:br", &[("w:type", "page")]));
    });
}
