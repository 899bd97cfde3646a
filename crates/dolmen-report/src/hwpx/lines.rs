//! Paragraphs and their spans.

use super::looks::{Letters, Lie, Looks, Style};
use crate::lowered::{Stretch, stretches_of};
use crate::paper::xml::Xml;
use crate::paper::{Caption, Ink, Run};

/// Hundredths of a point in a twentieth of one.
pub(super) const HUNDREDTHS_OF_TWIP: usize = 5;
/// State of the paragraphs.
pub(super) struct Lines<'a> {
    pub(super) looks: &'a mut Looks,
    pub(super) tables: usize,
    pub(super) paragraphs: u32,
    /// Whether the next paragraph begins a page.
    pub(super) breaks: bool,
    /// Content of the first paragraph of a section: the paper and the running lines.
    pub(super) opening: Option<Xml>,
}

impl Lines<'_> {
    /// A paragraph, and its runs.
    pub(super) fn paragraph(
        &mut self,
        xml: &mut Xml,
        style: Style,
        lie: Lie,
        runs: impl FnOnce(&mut Xml, &mut Looks),
    ) {
        self.holding(xml, style, lie, |xml, lines| runs(xml, lines.looks));
    }

    /// A paragraph that may hold others, in a table.
    pub(super) fn holding(
        &mut self,
        xml: &mut Xml,
        style: Style,
        lie: Lie,
        inside: impl FnOnce(&mut Xml, &mut Lines<'_>),
    ) {
        let id = self.paragraphs.to_string();
        self.paragraphs += 1;
        let (lie, style) = (self.looks.lie(lie).to_string(), style.number().to_string());
        let breaks = if std::mem::take(&mut self.breaks) {
            "1"
        } else {
            "0"
        };
        let attributes = [
            ("id", id.as_str()),
            ("paraPrIDRef", &lie),
            ("styleIDRef", &style),
            ("pageBreak", breaks),
            ("columnBreak", "0"),
            ("merged", "0"),
        ];
        xml.element("hp:p", &attributes, |xml| {
            if let Some(opening) = self.opening.take() {
                xml.element("hp:run", &[("charPrIDRef", "0")], |xml| xml.append(opening));
            }
            inside(xml, self);
        });
    }

    /// A caption; its first sentence is emphasised.
    pub(super) fn caption(&mut self, xml: &mut Xml, of: &Caption) {
        let mut runs = vec![Run::Words(format!("{}{}", of.word, of.number), Ink::BOLD)];
        if let Some(lead) = &of.lead {
            runs.push(Run::Words("  ".to_owned(), Ink::PLAIN));
            runs.push(Run::Words(lead.clone(), Ink::BOLD));
        }
        if let Some(rest) = &of.rest {
            runs.push(Run::Words(format!(" {rest}"), Ink::PLAIN));
        }
        let lie = Lie {
            keep_next: of.is_above,
            ..Style::Caption.lie()
        };
        self.paragraph(xml, Style::Caption, lie, |xml, looks| {
            stretches(xml, looks, &runs, Style::Caption.letters());
        });
    }
}

/// Runs of a paragraph, with the letters of its style unless emphasised.
pub(super) fn stretches(xml: &mut Xml, looks: &mut Looks, runs: &[Run], letters: Letters) {
    for run in runs {
        match run {
            Run::Tab => written(xml, looks, letters, |xml| {
                xml.element("hp:t", &[], |xml| {
                    let tab = [("width", "1000"), ("leader", "0"), ("type", "1")];
                    xml.leaf("hp:tab", &tab);
                });
            }),
            Run::Words(text, ink) => {
                for Stretch { words, is_lowered } in stretches_of(text) {
                    let letters = Letters {
                        bold: letters.bold || ink.bold,
                        colour: ink.colour.unwrap_or(letters.colour),
                        low: is_lowered,
                        ..letters
                    };
                    written(xml, looks, letters, |xml| xml.words("hp:t", &[], &words));
                }
            }
        }
    }
}

pub(super) fn written(xml: &mut Xml, looks: &mut Looks, letters: Letters, inside: impl FnOnce(&mut Xml)) {
    let letters = looks.letters(letters).to_string();
    xml.element("hp:run", &[("charPrIDRef", &letters)], inside);
}

/// Paragraphs of a cell, or of a running line of this width and height.
pub(super) fn sub_list(xml: &mut Xml, side: &str, sides: [usize; 2], inside: impl FnOnce(&mut Xml)) {
    let [width, height] = sides.map(|side| side.to_string());
    let attributes = [
        ("id", ""),
        ("textDirection", "HORIZONTAL"),
        ("lineWrap", "BREAK"),
        ("vertAlign", side),
        ("linkListIDRef", "0"),
        ("linkListNextIDRef", "0"),
        ("textWidth", width.as_str()),
        ("textHeight", height.as_str()),
        ("hasTextRef", "0"),
        ("hasNumRef", "0"),
    ];
    xml.element("hp:subList", &attributes, inside);
}
