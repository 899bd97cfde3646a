//! The form of the six-factor score: written, filled in, read back.

use super::verbs::Scratch;
use std::fs;
use std::io::{Cursor, Read as _, Write as _};
use std::path::Path;
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

/// Rows of the form, numbered as in Excel, with the keys in column A.
const ROWS: [(&str, u32); 7] = [
    ("name", 5),
    ("storeys", 6),
    ("body_height", 7),
    ("body_slenderness", 8),
    ("slenderness_angle", 9),
    ("taper", 10),
    ("body_base_height_ratio", 11),
];

/// The form with values in column D, as a spreadsheet would save them: numbers, or inline strings.
fn filled(form: &Path, values: &[(&str, &str)]) -> Vec<u8> {
    let mut archive = ZipArchive::new(Cursor::new(fs::read(form).unwrap())).unwrap();
    let mut written = ZipWriter::new(Cursor::new(Vec::new()));
    for at in 0..archive.len() {
        let mut part = archive.by_index(at).unwrap();
        let name = part.name().unwrap().into_owned();
        let mut text = String::new();
        part.read_to_string(&mut text).unwrap();
        if name == "xl/worksheets/sheet1.xml" {
            for (key, value) in values {
                let row = ROWS.iter().find(|(of, _)| of == key).unwrap().1;
                let open = format!("<c r=\"D{row}\"");
                let begin = text
                    .find(&open)
                    .unwrap_or_else(|| panic!("no cell D{row} in {text}"));
                let end = begin + text[begin..].find("/>").unwrap() + 2;
                let cell = match value.parse::<f64>() {
                    Ok(number) => format!("{open}><v>{number}</v></c>"),
                    Err(_) => format!("{open} t=\"inlineStr\"><is><t>{value}</t></is></c>"),
                };
                text.replace_range(begin..end, &cell);
            }
        }
        written.start_file(name, SimpleFileOptions::default()).unwrap();
        written.write_all(text.as_bytes()).unwrap();
    }
    written.finish().unwrap().into_inner()
}

const FACTORS: [(&str, &str); 5] = [
    ("storeys", "5"),
    ("body_height", "6"),
    ("slenderness_angle", "0.385"),
    ("taper", "8"),
    ("body_base_height_ratio", "3"),
];

#[test]
fn agrees_a_filled_form_scores_as_the_project_of_the_same_factors() {
    let scratch = Scratch::with_examples("score_forms");
    for language in ["en", "ko"] {
        assert_eq!(
            scratch
                .dolmen(&format!("score --sheet {language}.xlsx --language {language}"))
                .status,
            0
        );
        assert_eq!(
            scratch
                .dolmen(&format!("score --sheet {language}.html --language {language}"))
                .status,
            0
        );
        let form = scratch.path().join(format!("{language}.xlsx"));
        let bytes = filled(
            &form,
            &[&[("name", "A &lt;b&gt; \"c\" \\ 석탑")], FACTORS.as_slice()].concat(),
        );
        fs::write(scratch.path().join("filled.xlsx"), bytes).unwrap();
        let of_form = scratch.dolmen("score filled.xlsx --json");
        assert_eq!(of_form.status, 0, "{}", of_form.stderr);
        assert!(
            of_form.stdout.contains("A <b> \\\"c\\\" \\\\ 석탑"),
            "{}",
            of_form.stdout
        );
        let of_project = scratch.dolmen("score examples/pagodas_of_figure_19 --json");
        let states = |said: &str| said.split_once("\"states\"").map(|(_, rest)| rest.to_owned());
        assert!(states(&of_form.stdout).is_some(), "{}", of_form.stdout);
        assert_eq!(states(&of_form.stdout), states(&of_project.stdout));
        let page = fs::read_to_string(scratch.path().join(format!("{language}.html"))).unwrap();
        for (key, _) in ROWS {
            assert!(page.contains(&format!(">{key}<")), "{key} is not on the page");
        }
    }
}

#[test]
fn refuses_a_form_that_is_not_filled_or_says_two_things() {
    let scratch = Scratch::new("score_form_faults");
    assert_eq!(scratch.dolmen("score --sheet form.xlsx").status, 0);
    let form = scratch.path().join("form.xlsx");
    let told = |values: &[(&str, &str)]| {
        fs::write(scratch.path().join("filled.xlsx"), filled(&form, values)).unwrap();
        let answer = scratch.dolmen("score filled.xlsx");
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        answer.stderr
    };
    assert!(told(&[]).contains("storeys is not filled"));
    assert!(told(&FACTORS[..4]).contains("body_base_height_ratio is not filled"));
    let both = [FACTORS.as_slice(), &[("body_slenderness", "3.7")]].concat();
    assert!(told(&both).contains("keep one"));
    let with = |key: &str, value: &'static str| {
        let each = FACTORS
            .iter()
            .map(|(of, given)| (*of, if *of == key { value } else { given }));
        told(&each.collect::<Vec<_>>())
    };
    assert!(with("storeys", "4.5").contains("whole number"));
    assert!(with("taper", "steep").contains("taper is \"steep\""));
    assert!(with("body_height", "-6").contains("body_height"));
    fs::write(scratch.path().join("bad.xlsx"), b"PK no workbook").unwrap();
    let bad = scratch.dolmen("score bad.xlsx");
    assert!(
        bad.status == 2 && bad.stderr.contains("no workbook"),
        "{}",
        bad.stderr
    );
    let word = scratch.dolmen("score --sheet form.docx");
    assert!(
        word.status == 2 && word.stderr.contains(".html"),
        "{}",
        word.stderr
    );
}
