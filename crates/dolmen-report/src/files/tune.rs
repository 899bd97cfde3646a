//! Tuned dampers as files: one folder per damper.

use super::named::NamedFile;
use crate::figures::tune_figures;
use crate::json::{together_json, tune_json};
use dolmen_words::{Language, keeping_names};
use dolmen_work::answer::TuneAnswers;

/// Results and figures of every damper, and of all together.
pub fn tune_files(answers: &TuneAnswers, language: Language) -> Vec<NamedFile> {
    let mut files = Vec::new();
    for answer in &answers.tunings {
        let json = NamedFile::json("tune.json", &keeping_names(|| tune_json(answer)));
        let figures = tune_figures(answer, language).into_iter().map(NamedFile::figure);
        files.extend(
            [json]
                .into_iter()
                .chain(figures)
                .map(|file| file.within(&answer.damper)),
        );
    }
    for answer in &answers.together {
        let name = match &answer.variant {
            None => "together.json".to_owned(),
            Some(variant) => format!("together-{variant}.json"),
        };
        files.push(NamedFile::json(&name, &keeping_names(|| together_json(answer))));
    }
    files
}
