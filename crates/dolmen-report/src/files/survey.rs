//! Surveys as files: identification and change.

use super::figures::NotDrawn;
use super::modes::mode_files;
use super::named::NamedFile;
use crate::figures::{identification, survey_changes, years};
use crate::json::{change_json, identification_json, watch_json};
use dolmen_words::{Language, keeping_names};
use dolmen_work::answer::{CompareAnswer, IdentifyAnswer};
use dolmen_work::surveyed::SetupsAnswer;
use dolmen_work::watched::WatchAnswer;

/// Figures (PNG by `paint`) and JSON of an identification, and the modes of each survey for other programs.
///
/// # Errors
/// [`NotDrawn`].
pub fn identification_files(
    answer: &IdentifyAnswer,
    language: Language,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<NamedFile>, NotDrawn> {
    let json = NamedFile::json(
        "identification.json",
        &keeping_names(|| identification_json(answer)),
    );
    let mut figures = Vec::new();
    for figure in identification(answer, language) {
        let painted = paint(&figure.svg).map_err(|why| NotDrawn {
            figure: figure.name.clone(),
            why,
        })?;
        figures.push(NamedFile::new(&format!("{}.png", figure.name), painted));
        figures.push(NamedFile::figure(figure));
    }
    let modes = answer.surveys.iter().flat_map(|survey| {
        let found = survey.setups.as_ref().map(SetupsAnswer::modes);
        let found = found.or_else(|| survey.records.as_ref().map(|record| &record.analysis.modes));
        found.map_or_else(Vec::new, |modes| mode_files(&survey.name, modes))
    });
    Ok([json].into_iter().chain(figures).chain(modes).collect())
}

/// Figure and JSON of what changed.
pub fn change_files(answer: &CompareAnswer, language: Language) -> Vec<NamedFile> {
    let json = keeping_names(|| change_json(answer));
    let figure = answer
        .change
        .as_ref()
        .map(|change| NamedFile::svg("change", &survey_changes(change, language)));
    std::iter::once(NamedFile::json("change.json", &json))
        .chain(figure)
        .collect()
}

/// Figure and JSON of a history.
pub fn watch_files(answer: &WatchAnswer, language: Language) -> Vec<NamedFile> {
    vec![
        NamedFile::json("watch.json", &keeping_names(|| watch_json(answer))),
        NamedFile::svg("years", &years(answer, language)),
    ]
}
