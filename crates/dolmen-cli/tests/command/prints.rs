//! A report as a PDF: the same input gives the same bytes, and the rules of every output apply; without the feature it is refused at once.

use super::verbs::Scratch;
#[cfg(feature = "pdf")]
use std::fs;

#[cfg(feature = "pdf")]
#[test]
fn holds_the_same_project_gives_the_same_pdf() {
    let scratch = Scratch::with_examples("prints");
    for (example, flags) in [
        ("naju_flagpole", "--motion el-centro"),
        ("three_storey_pagoda", ""),
        ("gate_through_the_seasons", ""),
    ] {
        for language in ["en", "ko"] {
            let answer = scratch.dolmen(&format!(
                "report examples/{example} {flags} --language {language} --date 2026-05-12 -o once.pdf -o again.pdf"
            ));
            assert!(answer.status < 2, "{example}: {}", answer.stderr);
            assert!(!answer.stderr.contains("boxes"), "{example}: {}", answer.stderr);
            let bytes = fs::read(scratch.path().join("once.pdf")).unwrap();
            assert!(bytes.starts_with(b"%PDF-1.7"));
            assert_eq!(bytes, fs::read(scratch.path().join("again.pdf")).unwrap());
            // the PDF/A-2a metadata are not compressed
            let archival = b"<pdfaid:conformance>A</pdfaid:conformance>";
            assert!(
                bytes.windows(archival.len()).any(|part| part == archival),
                "{example}"
            );
        }
    }
}

#[cfg(feature = "pdf")]
#[test]
fn holds_several_projects_are_one_pdf_and_one_that_cannot_be_read_is_named() {
    let scratch = Scratch::with_examples("prints_several");
    let run =
        "report examples/heunginjimun_gate examples/nothing examples/twenty_storeys --samples 0 -o all.pdf";
    assert_eq!(scratch.dolmen(run).status, 2);
    let bytes = fs::read(scratch.path().join("all.pdf")).unwrap();
    assert!(bytes.starts_with(b"%PDF-1.7"));
}

#[cfg(not(feature = "pdf"))]
#[test]
fn holds_a_pdf_that_is_not_built_in_is_refused_before_any_work() {
    let scratch = Scratch::with_examples("prints_refused");
    let answer = scratch.dolmen("report examples/naju_flagpole -o page.html -o report.pdf");
    assert_eq!(answer.status, 2);
    assert!(answer.stderr.contains("--features pdf"), "{}", answer.stderr);
    assert!(!scratch.path().join("page.html").exists());
}
