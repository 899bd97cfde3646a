// SOURCE     every example that `dolmen check` takes.
// GOAL       A short answer has a headline and at most 15 lines of at most 80 columns; the Korean one contains no English sentence.
// TOLERANCE  names, sources, keys and units may be English.

use super::each_example::{Shown, shown};
use super::verbs::Scratch;
use std::fs;

/// Columns of a terminal; Hangul takes two.
fn columns(line: &str) -> usize {
    line.chars()
        .map(|c| {
            if ('\u{1100}'..='\u{ffef}').contains(&c) && !('\u{2000}'..='\u{2bff}').contains(&c) {
                2
            } else {
                1
            }
        })
        .sum()
}

#[test]
fn holds_a_brief_answer_is_a_headline_and_at_most_15_lines() {
    for Shown {
        example,
        check: answer,
        ..
    } in shown()
    {
        assert!(answer.status < 2, "{example}: {}", answer.stderr);
        for line in answer.stdout.lines() {
            assert!(
                columns(line) <= 80,
                "{example}, {} columns: {line}",
                columns(line)
            );
        }
        let lines: Vec<&str> = answer.stdout.lines().collect();
        assert!(lines.len() <= 22, "{example}: {}", answer.stdout);
        let verdict = lines
            .iter()
            .position(|line| line.starts_with("VERDICT") || line.starts_with("판정"));
        if let Some(verdict) = verdict {
            assert!(verdict <= 6, "{example}: {}", answer.stdout);
            let below = lines.len() - verdict - 1;
            assert!(
                (2..=15).contains(&below),
                "{example}, {below} lines: {}",
                answer.stdout
            );
        }
    }
}

#[test]
fn holds_a_brief_ranking_has_its_first_places_before_the_reasons_of_those_without() {
    let scratch = Scratch::new("brief-rank");
    let mut table =
        "name,storeys,body_height_m,body_slenderness,taper_deg,body_base_height_ratio,zone_factor_g,soil\n\
                     카리 당간지주,,,,,,0.11,S3\n타리 석등,1,2.2,3.0,3.0,1.5,0.11,S3\n"
            .to_owned();
    for i in 0..10 {
        table += &format!("석탑{i},5,{},3.9,7.0,2.5,0.11,S3\n", 3.0 + 0.2 * f64::from(i));
    }
    fs::write(scratch.path().join("t.csv"), table).unwrap();
    for language in ["en", "ko"] {
        let answer = scratch.briefly(&format!("rank t.csv --extrapolate --language {language}"));
        let lines: Vec<&str> = answer.stdout.lines().collect();
        let at = |what: &str| lines.iter().position(|line| line.contains(what));
        let first = at("  1  ").unwrap_or_else(|| panic!("{}{}", answer.stdout, answer.stderr));
        let reason = at("- 카리 당간지주").unwrap_or(usize::MAX);
        assert!(first < reason, "{}", answer.stdout);
        assert!(lines.len() <= 18, "{}", answer.stdout);
    }
}
