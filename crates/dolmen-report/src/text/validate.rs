//! `dolmen validate` as text: the content of VALIDATION.md.

use dolmen::comparisons::Case;
use std::fmt::Write as _;

/// Significant digits of a number in the table.
const DIGITS: usize = 7;

/// A Markdown table per source: published, computed, difference, and the right number if the published one is wrong.
pub fn validation_text(cases: &[Case]) -> String {
    let agree = cases.iter().filter(|case| case.agrees()).count();
    let mut out = String::from(
        "# Validation\n\nNumbers of others beside Dolmen's: this page is what `dolmen validate` prints. `computed` follows the \
         source's own\ndefinition, to show that it is reproduced; where that definition is wrong, `right` is the number to \
         use.\nUnder \"Second methods\" the published number is that of another method of Dolmen's own, which shares neither equations nor \
         steps with the first.\n",
    );
    let _ = writeln!(
        out,
        "\n{agree} of {} agree within the digits printed, or the tolerance that the notes give.",
        cases.len()
    );
    let mut source = "";
    for case in cases {
        if case.source != source {
            source = case.source;
            let _ = writeln!(out, "\n## {source}\n");
            out += "| what | unit | published | computed | difference | right | |\n|:--|:--|--:|--:|--:|--:|:--|\n";
        }
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {} | {} | {} |",
            case.what,
            case.unit,
            number(case.published),
            number(case.computed),
            difference(case),
            case.corrected.map_or_else(String::new, number),
            if case.agrees() { "" } else { "**differs**" }
        );
    }
    let mut notes: Vec<&str> = cases
        .iter()
        .map(|case| case.note)
        .filter(|note| !note.is_empty())
        .collect();
    notes.dedup();
    let mut seen = std::collections::BTreeSet::new();
    notes.retain(|note| seen.insert(*note));
    if !notes.is_empty() {
        out += "\n## Notes\n\n";
        for note in notes {
            let _ = writeln!(out, "- {note}");
        }
    }
    out
}

/// Relative differences below this are rounding, which depends on the processor.
const ROUNDING: f64 = 1e-9;

fn difference(case: &Case) -> String {
    if case.difference().abs() <= ROUNDING * case.published.abs() {
        return "0".to_owned();
    }
    format!("{:+.1e}", case.difference())
}

/// Significant digits without trailing zeros.
fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let before = x.abs().log10().floor() as i32 + 1;
    let decimals = (DIGITS as i32 - before).clamp(0, 12) as usize;
    let text = format!("{x:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_numbers_keep_seven_digits() {
        assert_eq!(number(128.643_712_9), "128.6437");
        assert_eq!(number(0.081_014_052_8), "0.08101405");
        assert_eq!(number(-44.829), "-44.829");
        assert_eq!(number(100.0), "100");
        assert_eq!(number(1_234_567_890.0), "1234567890");
    }

    #[test]
    fn holds_a_difference_is_shown_and_counted() {
        let case = |published| Case {
            source: "A (2000)",
            what: "x".into(),
            unit: "m",
            published,
            computed: 1.0,
            tolerance: 0.1,
            corrected: None,
            note: "",
        };
        let text = validation_text(&[case(1.05), case(2.0)]);
        assert!(
            text.contains("1 of 2 agree") && text.contains("**differs**"),
            "{text}"
        );
    }
}
