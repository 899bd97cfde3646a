//! The parts of an HWPX file: its type, header, sections, pictures, and preview text.

use super::header::header;
use super::looks::Looks;
use super::spaces::{SPACES, item};
use crate::paper::xml::{Attributes, Xml};
use crate::paper::{self, Paper, PaperFault, Part};
use dolmen_words::Language;
use std::borrow::Cow;

/// Number of characters in the preview.
const PREVIEW_MOST: usize = 1000;

/// Pictures that Hangul supports, which excludes SVG.
fn shown(paper: &Paper) -> impl Iterator<Item = &(String, Vec<u8>)> {
    paper.files.iter().filter(|(name, _)| !name.ends_with(".svg"))
}

/// The bytes of the file.
pub(super) fn pack(
    paper: &Paper,
    language: Language,
    sections: Vec<String>,
    looks: &Looks,
    text: String,
) -> Result<Vec<u8>, PaperFault> {
    let owned = |name: &str, text: String| -> Part<'_> { (name.to_owned(), Cow::Owned(text.into_bytes())) };
    // readers look for the file type in the first part
    let mut parts = vec![
        owned("mimetype", "application/hwp+zip".to_owned()),
        owned("version.xml", version()),
        owned("Contents/header.xml", header(looks, sections.len())),
    ];
    let list = content(paper, language, sections.len());
    for (at, section) in sections.into_iter().enumerate() {
        parts.push(owned(&format!("Contents/section{at}.xml"), section));
    }
    let preview: String = text.chars().take(PREVIEW_MOST).collect();
    parts.push(owned("Preview/PrvText.txt", preview));
    parts.push(owned("settings.xml", settings()));
    parts.push(owned("Contents/content.hpf", list));
    parts.push(owned("META-INF/container.xml", container()));
    parts.push(owned("META-INF/manifest.xml", manifest()));
    for (name, bytes) in shown(paper) {
        parts.push((format!("BinData/{name}"), Cow::Borrowed(bytes.as_slice())));
    }
    paper::pack(&parts)
}

fn document(tag: &str, attributes: Attributes<'_>, inside: impl FnOnce(&mut Xml)) -> String {
    let mut xml = Xml::document();
    xml.element(tag, attributes, inside);
    xml.finish()
}

fn version() -> String {
    let attributes = [
        ("xmlns:hv", "http://www.hancom.co.kr/hwpml/2011/version"),
        ("tagetApplication", "WORDPROCESSOR"), // spelt as in the format
        ("major", "5"),
        ("minor", "1"),
        ("micro", "1"),
        ("buildNumber", "0"),
        ("os", "1"),
        ("xmlVersion", "1.5"),
        ("application", "Dolmen"),
        ("appVersion", env!("CARGO_PKG_VERSION")),
    ];
    document("hv:HCFVersion", &attributes, |_| ())
}

fn settings() -> String {
    let space = [("xmlns:ha", "http://www.hancom.co.kr/hwpml/2011/app")];
    document("ha:HWPApplicationSetting", &space, |xml| {
        xml.leaf(
            "ha:CaretPosition",
            &[("listIDRef", "0"), ("paraIDRef", "0"), ("pos", "0")],
        );
    })
}

fn container() -> String {
    let spaces = [
        ("xmlns:ocf", "urn:oasis:names:tc:opendocument:xmlns:container"),
        ("xmlns:hpf", "http://www.hancom.co.kr/schema/2011/hpf"),
    ];
    document("ocf:container", &spaces, |xml| {
        xml.element("ocf:rootfiles", &[], |xml| {
            for (path, of) in [
                ("Contents/content.hpf", "application/hwpml-package+xml"),
                ("Preview/PrvText.txt", "text/plain"),
            ] {
                xml.leaf("ocf:rootfile", &[("full-path", path), ("media-type", of)]);
            }
        });
    })
}

fn manifest() -> String {
    let space = "urn:oasis:names:tc:opendocument:xmlns:manifest:1.0";
    document("odf:manifest", &[("xmlns:odf", space)], |_| ())
}

/// The title of the document, and its parts in order.
fn content(paper: &Paper, language: Language, sections: usize) -> String {
    let mut attributes = SPACES.to_vec();
    attributes.extend(["version", "unique-identifier", "id"].map(|name| (name, "")));
    let names: Vec<String> = (0..sections).map(|at| format!("section{at}")).collect();
    document("opf:package", &attributes, |xml| {
        xml.element("opf:metadata", &[], |xml| {
            xml.words("opf:title", &[], &paper.title);
            xml.words("opf:language", &[], language.code());
            let meta = |xml: &mut Xml, name: &str, value: &str| {
                xml.words("opf:meta", &[("name", name), ("content", "text")], value);
            };
            meta(xml, "creator", &paper.program);
            meta(xml, "subject", paper.kind);
            if let Some(date) = &paper.date {
                let moment = format!("{date}T00:00:00Z");
                meta(xml, "CreatedDate", &moment);
                meta(xml, "ModifiedDate", &moment);
            }
        });
        xml.element("opf:manifest", &[], |xml| {
            let mut one = |id: &str, path: &str, of: &str, more: Attributes<'_>| {
                let mut attributes = vec![("id", id), ("href", path), ("media-type", of)];
                attributes.extend(more);
                xml.leaf("opf:item", &attributes);
            };
            one("header", "Contents/header.xml", "application/xml", &[]);
            for name in &names {
                one(name, &format!("Contents/{name}.xml"), "application/xml", &[]);
            }
            one("settings", "settings.xml", "application/xml", &[]);
            one("version", "version.xml", "application/xml", &[]);
            for (name, _) in shown(paper) {
                let of = if name.ends_with(".png") {
                    "image/png"
                } else {
                    "image/jpeg"
                };
                let embedded = [("isEmbeded", "1")]; // spelt as in the format
                one(item(name), &format!("BinData/{name}"), of, &embedded);
            }
        });
        xml.element("opf:spine", &[], |xml| {
            for name in std::iter::once("header").chain(names.iter().map(String::as_str)) {
                xml.leaf("opf:itemref", &[("idref", name), ("linear", "yes")]);
            }
        });
    })
}
