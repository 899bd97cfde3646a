//! Why runs of a study were refused.

use super::answer::StudyAnswer;
use super::run::RunOutcome;
use dolmen_words::message::Both;
use std::collections::BTreeMap;

impl StudyAnswer {
    /// Reasons of refusals, each with its number of cases; of reasons that differ in their numbers alone the first.
    pub fn refusals(&self) -> Vec<(&Both, usize)> {
        let mut counts = BTreeMap::new();
        for run in self.runs.iter().filter(|run| run.outcome == RunOutcome::Refused) {
            let key = without_numbers(&run.why.english);
            counts.entry(key).or_insert((&run.why, 0)).1 += 1;
        }
        counts.into_values().collect()
    }
}

/// A sentence without its numbers; those of paths stay: `storeys[1].mass`.
fn without_numbers(sentence: &str) -> String {
    let mut out = String::with_capacity(sentence.len());
    let mut is_of_path = false;
    for letter in sentence.chars() {
        is_of_path = letter == '[' || is_of_path && letter.is_ascii_digit();
        let is_number = letter.is_ascii_digit() || letter == '.';
        match is_number && !is_of_path {
            true if out.ends_with('#') => {}
            true => out.push('#'),
            false => out.push(letter),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_reasons_differ_by_words_and_paths_alone() {
        let of = without_numbers;
        assert_eq!(of("x[1].k is drawn as 1.18, no"), of("x[1].k is drawn as 21, no"));
        assert_ne!(
            of("x[1].k is drawn as 1.18, no"),
            of("x[2].k is drawn as 1.18, no")
        );
        assert_ne!(of("a is 1"), of("b is 1"));
    }
}
