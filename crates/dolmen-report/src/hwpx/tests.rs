//! The document read back: it has the text of the page, is valid XML, and user text stays text.

use super::hwpx;
use crate::html::tests::{gate, pole, survey};
use crate::html::{Imprint, NotReported};
use crate::paper::holds_the_page;
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use std::collections::BTreeMap;
use std::io::{Cursor, Read as _};
use zip::ZipArchive;

const HP: &str = "http://www.hancom.co.kr/hwpml/2011/paragraph";
const HH: &str = "http://www.hancom.co.kr/hwpml/2011/head";

fn imprint() -> Imprint {
    Imprint {
        program: "dolmen".into(),
        date: Some("2026-05-12".into()),
    }
}

fn written(answers: &[ProjectReport], others: &[NotReported], language: Language) -> Vec<u8> {
    let paint = |svg: &str| match svg.starts_with("<svg") {
        true => Ok(b"\x89PNG".to_vec()),
        false => Err("no figure".to_owned()),
    };
    hwpx(answers, others, language, &imprint(), &paint).unwrap()
}

/// The parts of a document by their names, and the first of them.
fn parts(bytes: &[u8]) -> (BTreeMap<String, String>, String) {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut first = String::new();
    let each = (0..archive.len()).map(|at| {
        let mut file = archive.by_index(at).unwrap();
        let mut part = Vec::new();
        file.read_to_end(&mut part).unwrap();
        let name = file.name().unwrap().into_owned();
        if at == 0 {
            first = name.clone();
        }
        (name, String::from_utf8_lossy(&part).into_owned())
    });
    (each.collect(), first)
}

/// The text of each paragraph, without paragraphs in its tables.
fn paragraphs(section: &str) -> Vec<String> {
    let tree = roxmltree::Document::parse(section).unwrap();
    let said = tree.descendants().filter(|node| node.has_tag_name((HP, "p")));
    let said = said.map(|paragraph| {
        let runs = paragraph.children().filter(|node| node.has_tag_name((HP, "run")));
        // each formula has plain characters beside its script
        let is_said = |node: &roxmltree::Node<'_, '_>| {
            node.has_tag_name((HP, "t")) || node.has_tag_name((HP, "shapeComment"))
        };
        let words = runs.flat_map(|run| {
            let equations = run.children().filter(|node| node.has_tag_name((HP, "equation")));
            let all = run
                .children()
                .chain(equations.flat_map(|equation| equation.children()));
            all.filter(is_said).collect::<Vec<_>>()
        });
        words.filter_map(|words| words.text()).collect()
    });
    said.collect()
}

#[test]
fn holds_what_the_page_says_stands_in_the_document() {
    for answer in [pole("\"unknown\""), gate(), survey()] {
        for language in [Language::English, Language::Korean] {
            let (parts, _) = parts(&written(std::slice::from_ref(&answer), &[], language));
            let there = paragraphs(&parts["Contents/section0.xml"]);
            holds_the_page(&there, &answer, language);
        }
    }
}

#[test]
fn holds_every_number_of_a_look_or_picture_leads_to_one() {
    let bytes = written(&[pole("\"unknown\""), gate()], &[], Language::Korean);
    let (parts, first) = parts(&bytes);
    assert_eq!(
        (first.as_str(), parts["mimetype"].as_str()),
        ("mimetype", "application/hwp+zip")
    );
    for (name, text) in parts
        .iter()
        .filter(|(name, _)| name.ends_with(".xml") || name.ends_with(".hpf"))
    {
        roxmltree::Document::parse(text).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    }
    let content = roxmltree::Document::parse(&parts["Contents/content.hpf"]).unwrap();
    let items = content.descendants().filter(|node| node.has_attribute("href"));
    let items: Vec<(&str, &str)> = items
        .map(|item| (item.attribute("id").unwrap(), item.attribute("href").unwrap()))
        .collect();
    for (_, path) in &items {
        assert!(parts.contains_key(*path), "{path}");
    }
    let header = roxmltree::Document::parse(&parts["Contents/header.xml"]).unwrap();
    let count = |tag: &str| {
        let all = header.descendants().filter(|node| node.has_tag_name((HH, tag)));
        all.count()
    };
    let (mut pictures, mut tables) = (0, 0);
    for section in ["Contents/section0.xml", "Contents/section1.xml"] {
        let tree = roxmltree::Document::parse(&parts[section]).unwrap();
        for node in tree.descendants() {
            for (attribute, tag, from) in [
                ("charPrIDRef", "charPr", 0),
                ("paraPrIDRef", "paraPr", 0),
                ("styleIDRef", "style", 0),
                ("borderFillIDRef", "borderFill", 1),
            ] {
                let Some(number) = node.attribute(attribute) else {
                    continue;
                };
                let number: usize = number.parse().unwrap();
                assert!(
                    (from..count(tag) + from).contains(&number),
                    "{attribute} {number}"
                );
            }
            if let Some(item) = node.attribute("binaryItemIDRef") {
                pictures += 1;
                assert!(items.iter().any(|(id, _)| *id == item), "{item}");
            }
            if node.has_tag_name((HP, "tbl")) {
                tables += 1;
                let rows = node.children().filter(|node| node.has_tag_name((HP, "tr")));
                let rows: Vec<_> = rows.collect();
                assert_eq!(node.attribute("rowCnt"), Some(rows.len().to_string().as_str()));
                let columns: usize = node.attribute("colCnt").unwrap().parse().unwrap();
                for row in rows {
                    let cells = row.children().filter(|node| node.has_tag_name((HP, "tc")));
                    assert_eq!(cells.count(), columns);
                }
            }
        }
    }
    assert!(pictures > 5 && tables > 5, "{pictures} pictures, {tables} tables");
    assert_eq!(
        bytes,
        written(&[pole("\"unknown\""), gate()], &[], Language::Korean)
    );
}

#[test]
fn holds_words_of_a_user_stay_words() {
    let others = [NotReported {
        file: "<&\">".into(),
        why: "\u{0}&amp;".into(),
    }];
    let (parts, _) = parts(&written(&[pole("\"unknown\"")], &others, Language::English));
    let there = paragraphs(&parts["Contents/section0.xml"]);
    for words in ["Pole <script> & 'co'", "<&\">:  &amp;"] {
        assert!(there.iter().any(|said| said == words), "{words}");
    }
    assert!(parts["Preview/PrvText.txt"].contains("Pole <script> & 'co'"));
}

#[test]
fn refuses_a_figure_that_cannot_be_painted() {
    let paint = |_: &str| Err("no".to_owned());
    let fault = hwpx(&[pole("\"unknown\"")], &[], Language::English, &imprint(), &paint).unwrap_err();
    assert!(fault.to_string().contains("could not be painted: no"), "{fault}");
}
