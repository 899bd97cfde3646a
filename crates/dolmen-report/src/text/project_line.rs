//! A project in one line.

use dolmen::structure::{Choice, Convention};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::judge;

/// One line on a project: its judgement, what was measured, what explains it.
pub fn project_line(answer: &ProjectReport) -> String {
    let mut parts = Vec::new();
    for version in &judge(&answer.answers).versions {
        let name = version.variant.as_deref().unwrap_or("as it is");
        parts.push(format!("{name} {}", version.words(Language::English).join(", ")));
    }
    for survey in answer.surveys() {
        if let Some(record) = &survey.records {
            let found: Vec<String> = record
                .analysis
                .modes
                .modes
                .iter()
                .map(|mode| format!("{:.3}", mode.frequency_hz))
                .collect();
            parts.push(format!("modes at {} Hz", found.join(", ")));
        }
        for stiffness in &survey.stiffness {
            let convention = match stiffness.convention {
                Some(Convention::Drift) => " (drift)",
                Some(Convention::Grounded) => " (grounded)",
                None => "",
            };
            let found = &stiffness.solutions;
            let what = match found.choice {
                Choice::One => "one stiffness explains".to_owned(),
                Choice::Bounded => "one stiffness, known only between bounds, explains".to_owned(),
                Choice::Indistinguishable => format!("{} stiffnesses explain", found.solutions.len()),
                Choice::Underdetermined => "too few data for the stiffness of".to_owned(),
                Choice::Impossible => "no stiffness explains".to_owned(),
            };
            parts.push(format!("{what} direction {}{convention}", stiffness.direction));
        }
    }
    parts.join("; ")
}
