//! The document read back: it has the text of the page, is valid XML, and user text stays text.

use super::docx;
use crate::html::tests::{gate, pole, survey};
use crate::html::{Imprint, NotReported};
use crate::paper::holds_the_page;
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use std::collections::BTreeMap;
use std::io::{Cursor, Read as _};
use zip::ZipArchive;

fn imprint() -> Imprint {
    Imprint {
        program: "dolmen".into(),
        date: Some("2026-05-12".into()),
    }
}

fn written(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
) -> Vec<u8> {
    let paint = |svg: &str| match svg.starts_with("<svg") {
        true => Ok(b"\x89PNG".to_vec()),
        false => Err("no figure".to_owned()),
    };
    docx(answers, others, language, imprint, &paint).unwrap()
}

/// The parts of a document by their names.
fn parts(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let each = (0..archive.len()).map(|at| {
        let mut file = archive.by_index(at).unwrap();
        let mut part = Vec::new();
        file.read_to_end(&mut part).unwrap();
        (file.name().unwrap().into_owned(), part)
    });
    each.collect()
}

fn text(parts: &BTreeMap<String, Vec<u8>>, name: &str) -> String {
    String::from_utf8(parts[name].clone()).unwrap()
}

/// The text of each paragraph, as an XML reader sees it.
fn paragraphs(document: &str) -> Vec<String> {
    let tree = roxmltree::Document::parse(document).unwrap();
    let said = tree
        .descendants()
        .filter(|node| node.has_tag_name((super::look::W, "p")));
    let said = said.map(|paragraph| {
        let runs = paragraph
            .descendants()
            .filter(|node| node.has_tag_name((super::look::W, "t")));
        runs.filter_map(|run| run.text()).collect()
    });
    said.collect()
}

#[test]
fn holds_what_the_page_says_stands_in_the_document() {
    for answer in [pole("\"unknown\""), gate(), survey()] {
        for language in [Language::English, Language::Korean] {
            let bytes = written(std::slice::from_ref(&answer), &[], language, &imprint());
            let there = paragraphs(&text(&parts(&bytes), "word/document.xml"));
            holds_the_page(&there, &answer, language);
        }
    }
}

#[test]
fn holds_rows_of_pictures_part_between_pages() {
    let answer = pole("\"unknown\"");
    let bytes = written(&[answer], &[], Language::English, &imprint());
    let document = text(&parts(&bytes), "word/document.xml");
    let tree = roxmltree::Document::parse(&document).unwrap();
    let is = |node: &roxmltree::Node<'_, '_>, name: &str| node.has_tag_name((super::look::W, name));
    let drawings = tree.descendants().filter(|node| is(node, "drawing"));
    let in_rows: Vec<_> = drawings
        .filter(|node| node.ancestors().any(|above| is(&above, "tr")))
        .collect();
    assert!(in_rows.len() > 1, "{}", in_rows.len());
    for drawing in in_rows {
        let paragraph = drawing.ancestors().find(|above| is(above, "p")).unwrap();
        let keep = paragraph.descendants().find(|node| is(node, "keepNext"));
        assert_eq!(keep.unwrap().attribute((super::look::W, "val")), Some("0"));
    }
}

#[test]
fn holds_every_part_is_xml_and_every_relation_leads_to_one() {
    let bytes = written(&[pole("\"unknown\""), gate()], &[], Language::Korean, &imprint());
    let parts = parts(&bytes);
    for name in parts
        .keys()
        .filter(|name| name.ends_with(".xml") || name.ends_with(".rels"))
    {
        let text = text(&parts, name);
        roxmltree::Document::parse(&text).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    }
    let relations = text(&parts, "word/_rels/document.xml.rels");
    let document = text(&parts, "word/document.xml");
    let tree = roxmltree::Document::parse(&relations).unwrap();
    let mut identifiers = Vec::new();
    for relation in tree.root_element().children() {
        let target = relation.attribute("Target").unwrap();
        assert!(parts.contains_key(&format!("word/{target}")), "{target}");
        identifiers.push(relation.attribute("Id").unwrap());
    }
    for named in document.split("r:embed=\"").skip(1) {
        let name = named.split('"').next().unwrap();
        assert!(identifiers.contains(&name), "{name}");
    }
    assert!(document.contains("r:embed=\"image1-png\"") && document.contains("r:embed=\"image1-svg\""));
    assert_eq!(
        bytes,
        written(&[pole("\"unknown\""), gate()], &[], Language::Korean, &imprint())
    );
}

#[test]
fn holds_words_of_a_user_stay_words() {
    let imprint = Imprint {
        program: "a <w:p> & \"b\" \u{1}\u{7}]]>".into(),
        date: Some("2026-02-31".into()),
    };
    let others = [NotReported {
        file: "<&\">".into(),
        why: "\u{0}&amp;".into(),
    }];
    let bytes = written(&[pole("\"unknown\"")], &others, Language::English, &imprint);
    let parts = parts(&bytes);
    let there = paragraphs(&text(&parts, "word/document.xml"));
    for words in ["Pole <script> & 'co'", "a <w:p> & \"b\"   ]]>", "<&\">:  &amp;"] {
        assert!(there.iter().any(|said| said == words), "{words}");
    }
    let core = text(&parts, "docProps/core.xml");
    roxmltree::Document::parse(&core).unwrap();
    assert!(!core.contains("created"), "no such day: {core}");
}

#[test]
fn holds_tables_repeat_their_heads_and_captions_count_by_fields() {
    let bytes = written(&[pole("\"unknown\"")], &[], Language::English, &imprint());
    let document = text(&parts(&bytes), "word/document.xml");
    let (tables, heads) = (
        document.matches("SEQ Table").count(),
        document.matches("<w:tblHeader/>").count(),
    );
    // the three answers are a table without a number
    assert!(
        tables > 2 && tables + 1 == heads,
        "{tables} numbered tables, {heads} heads"
    );
    assert_eq!(
        document.matches("SEQ Figure").count(),
        document.matches("<asvg:svgBlip").count()
    );
    assert!(
        !document.contains("descr=\"\""),
        "a figure without words for those who do not see it"
    );
    let contents = document.matches("PAGEREF").count();
    let named = document.matches("<w:bookmarkStart").count();
    assert!(
        contents > 3 && contents <= named,
        "{contents} entries, {named} heads"
    );
}

#[test]
fn holds_every_formula_is_an_equation_that_word_processors_edit() {
    for answer in [pole("\"unknown\""), gate(), survey()] {
        let formulas = crate::html::method::method(&answer.project).blocks;
        let formulas = formulas.iter().filter_map(|block| match block {
            crate::document::Block::Equation(of) => Some(&of.formula),
            _ => None,
        });
        let wanted: Vec<String> = formulas
            .map(|formula| {
                crate::document::linear(formula).replace([' ', '/', '²', '_', '^', '(', ')', '|'], "")
            })
            .collect();
        assert!(!wanted.is_empty());
        let bytes = written(std::slice::from_ref(&answer), &[], Language::English, &imprint());
        let document = text(&parts(&bytes), "word/document.xml");
        let tree = roxmltree::Document::parse(&document).unwrap();
        let of = |tag: &'static str| {
            let all = tree.descendants();
            all.filter(move |node| node.has_tag_name((super::equation::M, tag)))
        };
        let found: Vec<String> = of("oMath")
            .map(|equation| {
                let letters = equation
                    .descendants()
                    .filter(|node| node.has_tag_name((super::equation::M, "t")));
                let letters: String = letters.filter_map(|node| node.text()).collect();
                // the exponent of a square is a separate digit
                letters.replace('2', "")
            })
            .collect();
        assert_eq!(found, wanted);
        assert_eq!(of("oMathPara").count(), wanted.len());
    }
}

#[test]
fn refuses_a_figure_that_cannot_be_painted() {
    let paint = |_: &str| Err("no".to_owned());
    let fault = docx(&[pole("\"unknown\"")], &[], Language::English, &imprint(), &paint).unwrap_err();
    assert!(fault.to_string().contains("could not be painted: no"), "{fault}");
}
