//! The engineer's data appear in every format of the report, photographs are checked before any computation, and every kind is drawn.

use super::verbs::Scratch;
use std::fs;

#[test]
fn holds_a_report_is_handed_over_with_all_that_the_engineer_gives() {
    let scratch = Scratch::with_examples("handover");
    for (language, heads) in [
        (
            "en",
            [
                "Participating engineers",
                "Findings",
                "Location and photographs",
                "The structure as entered",
                "Inspection 2026-04-02",
                "Variants compared",
                "<h2>Opinion",
            ],
        ),
        (
            "ko",
            [
                "참여기술진",
                "검토 결과 요약",
                "위치와 사진",
                "입력한 구조",
                "2026-04-02 점검 결과",
                "대안 비교",
                "<h2>종합의견",
            ],
        ),
    ] {
        let run =
            format!("report examples/inspected_flagpole --language {language} -o page.html -o book.xlsx");
        let answer = scratch.dolmen(&run);
        assert!(answer.status < 2, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        let places: Vec<usize> = heads
            .iter()
            .map(|head| {
                page.find(head.trim_start_matches("<h2>"))
                    .unwrap_or_else(|| panic!("{head}"))
            })
            .collect();
        assert!(
            places.windows(2).all(|pair| pair[0] < pair[1]),
            "{heads:?} {places:?}"
        );
        assert_eq!(page.matches("data:image/png;base64,iVBORw0KGgo").count(), 3);
        assert!(page.contains("EX-2026-01") && page.contains("EX-CAL-7"));
        assert!(!page.contains("http-equiv=\"refresh\"") && !page.contains("src=\"http"));
    }
    let text = scratch.dolmen("check examples/inspected_flagpole").stdout;
    assert!(text.contains("view.png") && text.contains("C observe"), "{text}");
}

#[test]
fn holds_what_nothing_rests_on_stands_behind_the_opinion() {
    let scratch = Scratch::with_examples("behind");
    let report = |project: &str, language: &str| {
        let run = format!("report {project} --language {language} -o page.html --force");
        let answer = scratch.dolmen(&run);
        assert!(answer.status < 2, "{}", answer.stderr);
        fs::read_to_string(scratch.path().join("page.html")).unwrap()
    };
    let page = report("examples/inspected_flagpole", "en");
    let opinion = page.find("Grade, opinion and recommendations").unwrap();
    assert!(opinion < page.find("What lowering a centre of mass does").unwrap());
    let page = report("examples/heunginjimun_gate", "en");
    let others = page.find("Stiffness if the springs acted otherwise").unwrap();
    assert!(page.find("(as printed)").unwrap() > others);
    assert!(page.find("Stiffness from measured vibration").unwrap() < others);
}

#[test]
fn holds_a_description_and_links_are_called_in_the_language_of_the_reader() {
    let scratch = Scratch::new("bilingual");
    let project = "schema = 1\nkind = \"chain\"\nname = { en = \"Pole\", ko = \"당간\" }\n\
        description = { en = \"One shaft of granite.\", ko = \"화강석 간주석 하나.\" }\n\
        units = { force = \"kN\", stiffness = \"kN*m/rad\" }\nevidence = \"measured\"\n\
        links = [{ name = \"돌 하나\", weight = 20, length = 3.0, centroid = 1.5, breadth = 0.6 }]\n\
        joints = [{ stiffness = 90 }]\n";
    fs::write(scratch.path().join("p.toml"), project).unwrap();
    for (language, said, other) in [
        ("en", "One shaft of granite.", "화강석"),
        ("ko", "화강석 간주석 하나.", "granite"),
    ] {
        let answer = scratch.dolmen(&format!(
            "report p.toml --language {language} -o page.html --force"
        ));
        assert!(answer.status < 2, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        assert!(page.contains(said) && !page.contains(other), "{language}");
        assert!(
            page.contains("돌 하나 ") && !page.contains("link 1 weight"),
            "{language}"
        );
    }
}

#[test]
fn holds_a_project_without_a_report_has_no_empty_boxes() {
    let scratch = Scratch::with_examples("handover_none");
    scratch.dolmen("report examples/naju_flagpole -o page.html");
    let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
    for head in [
        "Participating engineers",
        "Opinion",
        "Client",
        "Grade",
        "Photograph",
    ] {
        assert!(!page.contains(head), "{head}");
    }
}

#[test]
fn refuses_a_photograph_that_cannot_be_shown_with_its_key_and_line() {
    let scratch = Scratch::with_examples("photos");
    let photo = scratch.path().join("examples/inspected_flagpole/view.png");
    let told = |bytes: Option<&[u8]>| {
        match bytes {
            Some(bytes) => fs::write(&photo, bytes).unwrap(),
            None => fs::remove_file(&photo).unwrap(),
        }
        let answer = scratch.dolmen("report examples/inspected_flagpole -o page.html");
        assert_eq!(answer.status, 2);
        assert!(!scratch.path().join("page.html").exists());
        answer.stderr
    };
    let png = fs::read(&photo).unwrap();
    let mut large = png.clone();
    large[16..24].copy_from_slice(&[0, 0, 0x4e, 0x20, 0, 0, 0x27, 0x10]); // 20,000 × 10,000
    for (bytes, said) in [
        (Some(&b"%PDF-1.7"[..]), "is no JPEG or PNG image"),
        (Some(&png[..200]), "is cut short"),
        (
            Some(&large[..]),
            "is an image of 20000 × 10000 pixels, but at most 160 million are used",
        ),
        (None, "there is no"),
    ] {
        let told = told(bytes);
        assert!(
            told.contains(said) && told.contains("report.photos[1].file, line "),
            "{told}"
        );
    }
}

#[test]
fn holds_every_kind_is_drawn_and_a_survey_alone_is_refused() {
    let scratch = Scratch::with_examples("draw");
    for (example, name) in [
        ("naju_flagpole", "shaft 5"),
        ("heunginjimun_gate", "2"),
        ("three_storey_pagoda", "body 1"),
        ("twisting_floor", "1"),
        ("arch", "keystone"),
        ("wall", ">"),
        ("inspected_flagpole", "drawn 20 times"),
    ] {
        let answer = scratch.dolmen(&format!("draw examples/{example} -o {example}.svg"));
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let svg = fs::read_to_string(scratch.path().join(format!("{example}.svg"))).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{example}");
        assert!(svg.contains(name), "{example}: {name}");
    }
    let refused = scratch.dolmen("draw examples/palisaden");
    assert_eq!(refused.status, 2);
    assert!(
        refused.stderr.contains("no structure to draw"),
        "{}",
        refused.stderr
    );
    let refused = scratch.dolmen("draw examples/arch -o arch.dxf");
    assert!(
        refused.status == 2 && refused.stderr.contains("-o takes an SVG"),
        "{}",
        refused.stderr
    );
}
