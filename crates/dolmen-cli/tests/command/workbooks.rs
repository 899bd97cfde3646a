//! A report as a workbook: its numbers are those of the page, and the rules of every output apply to it.

use super::verbs::Scratch;
use calamine::{Data, Reader, Xlsx};
use std::fs;
use std::io::Cursor;

/// The texts of all table cells of a page.
fn cells(page: &str) -> Vec<String> {
    let each = page.split("<td").skip(1).filter_map(|rest| {
        let inside = rest.split_once('>')?.1.split("</td>").next()?;
        Some(inside.replace("<sub>", "").replace("</sub>", ""))
    });
    each.collect()
}

/// A number as the page prints it, and half a unit of its last digit; without deviation and arrow.
fn shown(cell: &str) -> Option<(f64, f64)> {
    let first = cell.split(" ± ").next()?.trim_end_matches(" ↑").replace('−', "-");
    let value: f64 = first.parse().ok()?;
    let decimals = match first.split_once('.') {
        Some((_, decimals)) => i32::try_from(decimals.len()).ok()?,
        // "1910" is 1908 with three digits
        None => -i32::try_from(first.len() - first.trim_end_matches('0').len()).ok()?,
    };
    Some((value, 0.5001 * 0.1_f64.powi(decimals)))
}

/// All numbers of all sheets, and how many cells hold a formula.
fn numbers(bytes: &[u8]) -> (Vec<f64>, usize) {
    let mut book = Xlsx::new(Cursor::new(bytes)).unwrap();
    let (mut all, mut formulas) = (Vec::new(), 0);
    for name in book.sheet_names() {
        for cell in book.worksheet_range(&name).unwrap().used_cells() {
            match cell.2 {
                Data::Float(value) => all.push(*value),
                // the number of a mode is stored as a name
                Data::String(text) => all.extend(text.parse::<f64>().ok()),
                _ => {}
            }
        }
        formulas += book.worksheet_formula(&name).unwrap().used_cells().count();
    }
    (all, formulas)
}

#[test]
fn holds_every_number_of_the_page_stands_in_the_workbook_and_the_same_twice() {
    let scratch = Scratch::with_examples("workbooks");
    for (example, flags) in [
        ("naju_flagpole", "--motion el-centro"),
        ("heunginjimun_gate", "--motion el-centro"),
        ("three_storey_pagoda", ""),
        ("gate_through_the_seasons", ""),
        ("several_dampers", "--samples 0"),
    ] {
        for language in ["en", "ko"] {
            let answer = scratch.dolmen(&format!(
                "report examples/{example} {flags} --language {language} -o page.html -o book.xlsx -o again.xlsx"
            ));
            assert!(answer.status < 2, "{example}: {}", answer.stderr);
            let bytes = fs::read(scratch.path().join("book.xlsx")).unwrap();
            assert_eq!(bytes, fs::read(scratch.path().join("again.xlsx")).unwrap());
            let (found, formulas) = numbers(&bytes);
            assert_eq!(formulas, 0);
            let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
            let mut compared = 0;
            for (value, half) in cells(&page).iter().filter_map(|cell| shown(cell)) {
                let is_there = found.iter().any(|n| (n - value).abs() <= half);
                assert!(is_there, "{example}, {language}: {value} is not in the workbook");
                compared += 1;
            }
            assert!(compared > 20, "{example}: {compared} numbers");
        }
    }
}

#[test]
fn holds_a_format_that_is_not_written_is_refused_before_any_work() {
    let scratch = Scratch::with_examples("workbook_formats");
    for name in ["report.odt", "report.hwp"] {
        let answer = scratch.dolmen(&format!("report examples/naju_flagpole -o page.html -o {name}"));
        assert_eq!(answer.status, 2);
        assert!(
            [".html", ".docx", ".hwpx", ".xlsx"]
                .iter()
                .all(|known| answer.stderr.contains(known)),
            "{}",
            answer.stderr
        );
        assert!(!scratch.path().join("page.html").exists() && !scratch.path().join(name).exists());
    }
}

#[test]
fn holds_a_workbook_that_somebody_changed_is_not_replaced() {
    let scratch = Scratch::with_examples("workbook_kept");
    let write = || scratch.dolmen("report examples/heunginjimun_gate --samples 0 -o book.xlsx");
    assert_eq!(write().status, 0);
    assert_eq!(write().status, 0, "its own may be replaced");
    let file = scratch.path().join("book.xlsx");
    let mut bytes = fs::read(&file).unwrap();
    bytes.push(0);
    fs::write(&file, &bytes).unwrap();
    assert_eq!(write().status, 2);
    assert_eq!(fs::read(&file).unwrap(), bytes);
}
