//! Printing gives the same bytes each time, PDF/A where possible, and clear errors.

use crate::{Sheets, pdf};

fn sheets(body: &str, date: &str) -> Sheets {
    Sheets {
        main: format!(
            "#set document(title: \"t\", date: {date})\n#set text(font: \"Pretendard\", lang: \"ko\")\n{body}"
        ),
        files: Vec::new(),
    }
}

const DAY: &str = "datetime(year: 2026, month: 5, day: 12)";

#[test]
fn the_same_source_gives_the_same_bytes() {
    let once = pdf(sheets("석탑 #strong[A]", DAY)).unwrap();
    let twice = pdf(sheets("석탑 #strong[A]", DAY)).unwrap();
    assert!(once.bytes.starts_with(b"%PDF-1.7"));
    assert_eq!(once.bytes, twice.bytes);
    assert!(once.is_archival);
    assert!(once.without_glyph.is_empty());
}

#[test]
fn without_a_date_it_is_no_page_for_the_archive() {
    assert!(!pdf(sheets("석탑", "none")).unwrap().is_archival);
}

#[test]
fn characters_without_a_glyph_are_named() {
    let printed = pdf(sheets("塔 석탑 𒀀", DAY)).unwrap();
    assert_eq!(printed.without_glyph, ['塔', '𒀀']);
    assert!(!printed.is_archival);
}

#[test]
fn no_file_of_the_machine_can_be_read() {
    let fault = pdf(sheets("#read(\"/etc/hostname\")", DAY)).unwrap_err();
    assert!(fault.to_string().contains("file not found"), "{fault}");
}
