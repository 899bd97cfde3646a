//! A report as an editable document: its text and numbers are those of the page, and the rules of every output apply.

use super::verbs::Scratch;
use std::fs;
use std::io::{Cursor, Read as _};
use zip::ZipArchive;

const W: &str = "http://schemas.openxmlformats.org/wordprocessingml/2006/main";

/// The text of each paragraph of a document.
fn paragraphs(bytes: &[u8]) -> Vec<String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut document = String::new();
    archive
        .by_name("word/document.xml")
        .unwrap()
        .read_to_string(&mut document)
        .unwrap();
    let tree = roxmltree::Document::parse(&document).unwrap();
    let said = tree
        .descendants()
        .filter(|node| node.has_tag_name((W, "p")))
        .map(|paragraph| {
            let runs = paragraph.descendants().filter(|node| node.has_tag_name((W, "t")));
            runs.filter_map(|run| run.text()).collect::<String>()
        });
    said.collect()
}

/// The texts inside tags of a kind, without nested tags.
fn inside(page: &str, tag: &str) -> Vec<String> {
    let (open, close) = (format!("<{tag}"), format!("</{tag}>"));
    let each = page.split(&open).skip(1).filter_map(|rest| {
        let (attributes, inside) = rest.split_once('>')?;
        let is_tag = attributes.is_empty() || attributes.starts_with(' ');
        let inside = is_tag.then(|| inside.split(&close).next().unwrap_or_default())?;
        let bare: String = inside
            .split('<')
            .map(|part| part.split_once('>').map_or(part, |p| p.1))
            .collect();
        let bare = bare
            .replace("&lt;", "<")
            .replace("&gt;", ">")
            .replace("&quot;", "\"");
        Some(bare.replace("&#39;", "'").replace("&amp;", "&"))
    });
    each.filter(|text| !text.is_empty()).collect()
}

#[test]
fn holds_what_the_page_says_stands_in_the_document_with_the_same_numbers() {
    let scratch = Scratch::with_examples("documents");
    for (example, flags) in [
        ("naju_flagpole", "--motion el-centro"),
        ("three_storey_pagoda", "--motion el-centro-1940-ns --keep-first 2"),
        ("gate_through_the_seasons", ""),
        ("several_dampers", "--samples 0"),
    ] {
        for language in ["en", "ko"] {
            let answer = scratch.dolmen(&format!(
                "report examples/{example} {flags} --language {language} -o page.html -o once.docx -o again.docx"
            ));
            assert!(answer.status < 2, "{example}: {}", answer.stderr);
            let bytes = fs::read(scratch.path().join("once.docx")).unwrap();
            assert!(
                bytes == fs::read(scratch.path().join("again.docx")).unwrap(),
                "{example}: other bytes"
            );
            let there = paragraphs(&bytes);
            let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
            // inputs have another layout: their unit has its own column
            let inputs = page
                .find("부록: 입력 자료</h2>")
                .or(page.find("Appendix: What was given</h2>"))
                .unwrap();
            let page = &page[page.find("<h2").unwrap()..inputs];
            let said = ["td", "h3", "p"].map(|tag| inside(page, tag)).concat();
            assert!(said.len() > 40, "{example}: {} of the page", said.len());
            for words in said {
                // the page writes a subscript as "a_z", the document lowers it
                let words = match words.contains('_') && !there.contains(&words) {
                    true => words.replace('_', ""),
                    false => words,
                };
                let is_head = |text: &String| words.ends_with(text.as_str()) && words.contains(". ");
                let found = there.contains(&words)
                    || words
                        .split_once(' ')
                        .is_some_and(|(_, bare)| there.iter().any(|text| text == bare))
                    || there.iter().any(is_head);
                assert!(found, "{example}, {language}: not in the document: {words}");
            }
            let captions = ["caption", "figcaption"].map(|tag| inside(page, tag)).concat();
            assert!(captions.len() > 2, "{example}: {} captions", captions.len());
            for caption in captions {
                // two spaces follow the number of a caption
                let found = there.iter().any(|text| text.replacen("  ", " ", 1) == caption);
                assert!(found, "{example}, {language}: no such caption: {caption}");
            }
        }
    }
}

#[test]
fn holds_a_document_that_somebody_edited_is_not_replaced_without_force() {
    let scratch = Scratch::with_examples("documents_kept");
    let write = |more: &str| {
        scratch.dolmen(&format!(
            "report examples/heunginjimun_gate --samples 0 -o r.docx{more}"
        ))
    };
    assert_eq!(write("").status, 0);
    assert_eq!(write("").status, 0, "its own may be replaced");
    let file = scratch.path().join("r.docx");
    let own = fs::read(&file).unwrap();
    let mut bytes = own.clone();
    bytes.push(0);
    fs::write(&file, &bytes).unwrap();
    let refused = write("");
    assert_eq!(refused.status, 2);
    assert!(refused.stderr.contains("--force"), "{}", refused.stderr);
    assert_eq!(fs::read(&file).unwrap(), bytes);
    assert_eq!(write(" --force").status, 0);
    assert_eq!(fs::read(&file).unwrap(), own);
}

#[test]
fn holds_several_projects_are_one_document() {
    let scratch = Scratch::with_examples("documents_several");
    let run = "report examples/heunginjimun_gate examples/nothing examples/naju_flagpole --samples 0 -o all.docx -o all.html";
    assert_eq!(scratch.dolmen(run).status, 2);
    let there = paragraphs(&fs::read(scratch.path().join("all.docx")).unwrap());
    let page = fs::read_to_string(scratch.path().join("all.html")).unwrap();
    let captions = ["caption", "figcaption"].map(|tag| inside(&page, tag)).concat();
    let second = captions.iter().filter(|caption| caption.contains(" 2."));
    let labels = second.filter_map(|caption| caption.split(' ').nth(1));
    let labels: Vec<&str> = labels.collect();
    assert!(labels.len() > 3, "{labels:?}");
    for label in labels {
        assert!(
            there.iter().any(|text| text.contains(&format!(" {label}  "))),
            "{label}"
        );
    }
    assert!(
        there.iter().any(|text| text.contains("examples/nothing")),
        "the answer names what it leaves out"
    );
}

#[test]
fn holds_the_sources_have_a_fingerprint_of_every_file_that_was_read() {
    let scratch = Scratch::new("documents-files");
    let project = "schema = 1\nkind = \"survey\"\nname = \"Pagoda\"\nsurveys = { file = \"list.csv\" }\n";
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    let line = |tilt: &str| {
        let list = format!(
            "date,frequency x 1 (Hz),tilt x (mm/m)\n2016-05-03,2.938,11.15\n2016-11-05,2.981,{tilt}\n"
        );
        fs::write(scratch.path().join("list.csv"), list).unwrap();
        let answer = scratch.briefly("report . -o page.html --force");
        assert!(answer.stderr.is_empty() || answer.status < 2, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        let of = |word: &str| page[page.find(word).unwrap()..][..80].to_owned();
        (of("File list.csv"), of("Fingerprint of the project file"))
    };
    let (before, project) = line("11.30");
    let (after, same) = line("11.31");
    assert!(
        before.contains("bytes: ") && before != after && project == same,
        "{before} {after}"
    );
}
