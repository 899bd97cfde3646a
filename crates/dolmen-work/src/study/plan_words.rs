//! Cases and scans of a study in words.

use super::plan::Plan;
use super::shown_inputs::shown_inputs;
use dolmen_words::number::trimmed;

impl Plan<'_> {
    /// A case in words: its variant and inputs; empty if there is only one.
    pub(super) fn case_words(&self, case: usize) -> String {
        let Some(inputs) = self.cases.get(case).filter(|_| self.cases.len() > 1) else {
            return String::new();
        };
        let mut words: Vec<String> = inputs.variant.iter().cloned().collect();
        words.extend(shown_inputs(&self.inputs, inputs, &self.drawn_units));
        words.join(", ")
    }

    /// A scan in words: its inputs.
    pub fn scan_words(&self, job: usize) -> String {
        let turns = self.study.turns_rad.len();
        let case = self.case_words(job / (self.motions.len() * turns));
        let mut words = vec![format!(
            "motion {}",
            self.motions[job / turns % self.motions.len()].0
        )];
        if !case.is_empty() {
            words.insert(0, case);
        }
        if turns > 1 {
            let degrees = self.study.turns_rad[job % turns].to_degrees();
            words.push(format!("turned by {}°", trimmed(degrees, 4)));
        }
        words.join(", ")
    }
}
