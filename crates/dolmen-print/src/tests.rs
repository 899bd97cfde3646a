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

/// How reports look.
const PRELUDE: &str = include_str!("../../dolmen-report/src/typeset/prelude.typ");

#[test]
fn holds_a_number_with_its_unit_stays_on_one_line() {
    // between two boxes: on two lines if the words are parted in a line that lacks 2 pt for them, otherwise on three
    let asserted = |words: &str, lines: &str| {
        format!(
            "#context {{
              let words = \"{words}\"
              let first = box(width: 40pt)[x]
              let width = measure([#first #words]).width - 2pt
              let last = box(width: width - 0.6 * measure([#words]).width)[x]
              let high = measure(block(width: width)[#first #words #last]).height
              assert(high {lines} measure([x \\ x \\ x]).height)
            }}\n"
        )
    };
    let whole = [
        "+0.28 %",
        "+0.28\u{202f}%.",
        "44.76\u{202f}kN·m/rad",
        "58.8\u{202f}MN/m로",
        "0.2 %이다.",
    ];
    let whole = whole.map(|words| (words, asserted(words, "==")));
    let parted = ("several of", asserted("several of", "<"));
    for (words, said) in whole.into_iter().chain([parted]) {
        let main = format!("{PRELUDE}\n#report[\n{said}]");
        let files = Vec::new();
        let printed = pdf(Sheets { main, files });
        assert!(printed.is_ok(), "{words}: {:?}", printed.err());
    }
}
