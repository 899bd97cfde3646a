//! The parts of a DOCX file, packed: an Open Packaging archive of XML and pictures.

use super::look::{W, styles};
use super::numbering::{numbering, settings};
use super::picture::relation;
use crate::paper::xml::Xml;
use crate::paper::{Paper, PaperFault, Part, pack};
use dolmen_words::Language;
use std::borrow::Cow;

const RELATIONS: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
const WORDS: &str = "application/vnd.openxmlformats-officedocument.wordprocessingml";

/// Content of a document.
pub(super) struct Package {
    pub(super) paper: Paper,
    pub(super) body: Xml,
    pub(super) header: Xml,
    pub(super) footer: Xml,
}

impl Package {
    /// The bytes of the file.
    pub(super) fn pack(self, language: Language) -> Result<Vec<u8>, PaperFault> {
        let mut texts = vec![
            ("[Content_Types].xml", content_types()),
            (
                "_rels/.rels",
                relations(&[
                    ("rId1", &format!("{OFFICE}/officeDocument"), "word/document.xml"),
                    (
                        "rId2",
                        "http://schemas.openxmlformats.org/package/2006/relationships/metadata/core-properties",
                        "docProps/core.xml",
                    ),
                ]),
            ),
            ("docProps/core.xml", self.core(language)),
            ("word/styles.xml", styles(language)),
            ("word/numbering.xml", numbering()),
            ("word/settings.xml", settings(self.paper.with_contents)),
            ("word/_rels/document.xml.rels", self.document_relations()),
        ];
        texts.push(("word/document.xml", self.body.finish()));
        texts.push(("word/header1.xml", self.header.finish()));
        texts.push(("word/footer1.xml", self.footer.finish()));
        let texts = texts
            .into_iter()
            .map(|(name, text)| (name.to_owned(), Cow::Owned(text.into_bytes())));
        let media = self
            .paper
            .files
            .iter()
            .map(|(name, bytes)| (format!("word/media/{name}"), Cow::Borrowed(bytes.as_slice())));
        let parts: Vec<Part<'_>> = texts.chain(media).collect();
        pack(&parts)
    }

    fn core(&self, language: Language) -> String {
        let mut xml = Xml::document();
        let spaces = [
            (
                "xmlns:cp",
                "http://schemas.openxmlformats.org/package/2006/metadata/core-properties",
            ),
            ("xmlns:dc", "http://purl.org/dc/elements/1.1/"),
            ("xmlns:dcterms", "http://purl.org/dc/terms/"),
            ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
        ];
        xml.element("cp:coreProperties", &spaces, |xml| {
            xml.words("dc:title", &[], &self.paper.title);
            xml.words("dc:creator", &[], &self.paper.program);
            xml.words("dc:language", &[], language.code());
            if let Some(date) = &self.paper.date {
                let moment = format!("{date}T00:00:00Z");
                for what in ["dcterms:created", "dcterms:modified"] {
                    xml.words(what, &[("xsi:type", "dcterms:W3CDTF")], &moment);
                }
            }
        });
        xml.finish()
    }

    fn document_relations(&self) -> String {
        let mut all: Vec<(String, String, String)> = Vec::new();
        for what in ["styles", "numbering", "settings"] {
            all.push((what.to_owned(), format!("{OFFICE}/{what}"), format!("{what}.xml")));
        }
        for what in ["header", "footer"] {
            all.push((
                what.to_owned(),
                format!("{OFFICE}/{what}"),
                format!("{what}1.xml"),
            ));
        }
        for (name, _) in &self.paper.files {
            all.push((relation(name), format!("{OFFICE}/image"), format!("media/{name}")));
        }
        let each: Vec<(&str, &str, &str)> = all
            .iter()
            .map(|(id, of, target)| (id.as_str(), of.as_str(), target.as_str()))
            .collect();
        relations(&each)
    }
}

/// Identifier, kind and target of each.
fn relations(each: &[(&str, &str, &str)]) -> String {
    let mut xml = Xml::document();
    xml.element("Relationships", &[("xmlns", RELATIONS)], |xml| {
        for (id, of, target) in each {
            xml.leaf("Relationship", &[("Id", id), ("Type", of), ("Target", target)]);
        }
    });
    xml.finish()
}

fn content_types() -> String {
    let mut xml = Xml::document();
    let space = "http://schemas.openxmlformats.org/package/2006/content-types";
    xml.element("Types", &[("xmlns", space)], |xml| {
        for (ending, of) in [
            ("rels", "application/vnd.openxmlformats-package.relationships+xml"),
            ("xml", "application/xml"),
            ("jpg", "image/jpeg"),
            ("png", "image/png"),
            ("svg", "image/svg+xml"),
        ] {
            xml.leaf("Default", &[("Extension", ending), ("ContentType", of)]);
        }
        for (part, of) in [
            ("document", "document.main"),
            ("styles", "styles"),
            ("numbering", "numbering"),
            ("settings", "settings"),
            ("header1", "header"),
            ("footer1", "footer"),
        ] {
            let (part, of) = (format!("/word/{part}.xml"), format!("{WORDS}.{of}+xml"));
            xml.leaf("Override", &[("PartName", &part), ("ContentType", &of)]);
        }
        let core = "application/vnd.openxmlformats-package.core-properties+xml";
        xml.leaf(
            "Override",
            &[("PartName", "/docProps/core.xml"), ("ContentType", core)],
        );
    });
    xml.finish()
}

/// The running header or footer: words left, `right` at the right.
pub(super) fn running(tag: &str, style: &str, left: &str, right: impl FnOnce(&mut Xml)) -> Xml {
    use super::inline::{paragraph, tab, words};
    use super::look::border;
    use crate::paper::{HAIR, Ink, TEXT_WIDTH};
    let mut xml = Xml::document();
    xml.element(tag, &[("xmlns:w", W)], |xml| {
        let properties = |xml: &mut Xml| {
            if style == "Header" {
                xml.element("w:pBdr", &[], |xml| border(xml, "w:bottom", "4", HAIR));
            }
            xml.element("w:tabs", &[], |xml| {
                let end = TEXT_WIDTH.to_string();
                xml.leaf("w:tab", &[("w:val", "right"), ("w:pos", &end)]);
            });
        };
        paragraph(xml, style, properties, |xml| {
            words(xml, left, Ink::PLAIN);
            tab(xml);
            right(xml);
        });
    });
    xml
}
