//! `dolmen compare`: what changed from one survey to another.

use crate::cli::Compare;
use crate::{Outcome, files, identify, open};
use anyhow::Result;
use dolmen_report::figures;
use dolmen_report::json::change_json;
use dolmen_report::text::change_text;
use dolmen_words::Language;
use dolmen_work::answer::SurveyAnswer;
use dolmen_work::change::{change_of, surveys_to_compare};

pub(crate) fn run(options: &Compare, as_json: bool, quiet: bool) -> Result<Outcome> {
    let open::Opened { project, file } = open::project(&options.project)?;
    let compared = surveys_to_compare(&project, options.from.as_deref(), options.to.as_deref())?;
    let needed = [compared.from, compared.to]
        .into_iter()
        .chain(compared.earlier.iter().copied());
    let answers: Vec<SurveyAnswer> = needed
        .map(|i| identify::found_in(&project.surveys[i], &file, quiet))
        .collect::<Result<_>>()?;
    let change = change_of(&project, &compared, &answers)?;
    let file = file.display().to_string();
    let json = change_json(&project, &file, &change);
    if as_json {
        files::say(&format!("{json:#}\n"))?;
    } else {
        files::say(&change_text(&project, &file, &change))?;
    }
    if let Some(folder) = &options.output {
        files::write(&folder.join("change.json"), format!("{json:#}\n").as_bytes())?;
        let svg = figures::survey_changes(&change, Language::English);
        files::write(&folder.join("change.svg"), svg.as_bytes())?;
        if !quiet {
            note!("change.svg and change.json are in {}", folder.display());
        }
    }
    Ok(Outcome::Stands)
}
