//! Chooses the two surveys of a project to compare, and prepares their modes.

use crate::answer::CompareAnswer;
use crate::change_fault::ChangeFault;
use crate::changed_part::changed_parts;
use crate::compared_readings::{compared_readings, has_modes};
use crate::compared_surveys::{ComparedSurveys, surveys_to_compare};
use crate::error::WorkError;
use crate::history_behind::{Behind, behind, has_history};
use crate::identify;
use crate::left_out::found_without;
use crate::modes_of_survey::surveyed;
use crate::opened::Opened;
use crate::progress::Progress;
use crate::rate_slip::rate_slip;
use crate::same_record::refuse_same_records;
use crate::surveyed::{ModesOf, SurveyAnswer};
use crate::told::told_both;
use crate::unlike_forces::unlike_forces;
use dolmen::assess::{SurveyChange, SurveyChangeOptions, Surveyed, TemperatureEffect, survey_change};
use dolmen::modal::Pairing;
use dolmen_project::{Project, TemperaturePart};
use dolmen_records::Files;

/// Names of the surveys to compare.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CompareOptions {
    /// The earlier survey; by default the first whose name begins with a date.
    pub from: Option<String>,
    /// The later survey; by default the last whose name begins with a date.
    pub to: Option<String>,
}

/// Compares two surveys. If the project has enough others, the weather and the scatter come from all.
///
/// # Errors
/// Surveys that cannot be compared, or whose records cannot be read.
pub fn compare(
    opened: &Opened,
    options: &CompareOptions,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<CompareAnswer, WorkError> {
    let project = &opened.project;
    let compared = surveys_to_compare(project, options.from.as_deref(), options.to.as_deref())?;
    let needed = [compared.from, compared.to]
        .into_iter()
        .chain(compared.earlier.iter().copied());
    let is_among_many = has_history(project, [compared.from, compared.to]);
    let used = |at: &usize| is_among_many || [compared.from, compared.to].contains(at);
    let used = (0..project.surveys.len()).filter(used);
    refuse_same_records(used.map(|at| &project.surveys[at]), files)?;
    let mut answers: Vec<SurveyAnswer> = needed
        .map(|i| identify::found_in(&project.surveys[i], files, progress))
        .collect::<Result<_, _>>()?;
    let mut unread = Vec::new();
    if is_among_many {
        for survey in &project.surveys {
            let is_found = answers.iter().any(|answer| answer.name == survey.name);
            let has_records = survey.records.is_some() || !survey.setups.is_empty();
            if has_records && !is_found {
                // a record that cannot be used leaves the history, not the comparison
                match found_without(survey, files, progress) {
                    Ok((found, _)) => answers.push(found),
                    Err(why) => unread.push((survey.name.clone(), told_both(&why))),
                }
            }
        }
    }
    let answer = compared_of(opened, &compared, &answers, files)?;
    Ok(CompareAnswer { unread, ..answer })
}

/// Compares two surveys of a project; `answers` hold the results of their records.
///
/// # Errors
/// [`ChangeFault::Assess`]; logs that cannot be read.
pub(crate) fn compared_of(
    opened: &Opened,
    compared: &ComparedSurveys,
    answers: &[SurveyAnswer],
    files: &dyn Files,
) -> Result<CompareAnswer, WorkError> {
    let project = &opened.project;
    let [from, to] = [compared.from, compared.to].map(|at| &project.surveys[at]);
    let have_modes = has_modes(from) && has_modes(to);
    let history = match have_modes {
        true => behind(opened, compared, answers, files)?,
        false => None,
    };
    let ends = history.as_ref().map(|of| of.ends);
    let of_modes = &ends.map_or_else(|| compared.clone(), |ends| compared.with_ends(project, ends));
    let change = match have_modes {
        true => Some(change_of(project, of_modes, answers, history.as_ref())?),
        false => None,
    };
    let is_taken = |change: &SurveyChange| {
        change
            .modes
            .iter()
            .any(|mode| mode.history.is_some() || mode.is_undecided)
    };
    let history = history.filter(|_| change.as_ref().is_some_and(is_taken));
    // the model of the earlier survey: damage found at the later one is the change itself
    let before = project.as_of(&project.surveys[of_modes.from].name);
    let explained = change.as_ref().map(|change| changed_parts(&before, change));
    let (parts, model_off) = explained.unwrap_or_default();
    Ok(CompareAnswer {
        file: opened.file.clone(),
        project: opened.project.clone(),
        from: from.name.clone(),
        to: to.name.clone(),
        parts,
        model_off,
        change,
        history: history.map(|of| of.told),
        readings: compared_readings(project, compared.from, compared.to),
        shaken: shaken(project, of_modes, answers),
        unlike_forces: unlike_forces(project, of_modes, answers),
        unread: Vec::new(),
    })
}

/// Which of both surveys contain an earthquake, and which part of their records their modes come from.
pub(crate) fn shaken(
    project: &Project,
    compared: &ComparedSurveys,
    answers: &[SurveyAnswer],
) -> Vec<(String, ModesOf)> {
    let both = [compared.from, compared.to].map(|at| project.surveys[at].name.as_str());
    let own = answers
        .iter()
        .filter(|answer| both.contains(&answer.name.as_str()));
    let each = own.filter_map(|answer| {
        let of = answer.earthquake()?;
        (of.is_one() || of.is_shaken()).then(|| (answer.name.clone(), of.modes_of))
    });
    each.collect()
}

/// The change of modes between two surveys of a project.
fn change_of(
    project: &Project,
    compared: &ComparedSurveys,
    answers: &[SurveyAnswer],
    history: Option<&Behind>,
) -> Result<SurveyChange, ChangeFault> {
    let of = |i: usize| {
        let survey = &project.surveys[i];
        surveyed(survey, answers.iter().find(|a| a.name == survey.name))
    };
    let pairing = Pairing::default();
    let options = SurveyChangeOptions {
        pairing: Pairing {
            frequency_within: project
                .change
                .frequency_within
                .unwrap_or(pairing.frequency_within),
            ..pairing
        },
        temperature: match project.change.temperature {
            TemperaturePart::Unknown => TemperatureEffect::Unknown,
            TemperaturePart::Coefficient { per_c, sd_per_c } => {
                TemperatureEffect::Coefficient { per_c, sd_per_c }
            }
            TemperaturePart::Fitted => TemperatureEffect::Fitted,
        },
        history: history.map_or_else(Vec::new, |of| of.effects.clone()),
        undecided_hz: history.map_or_else(Vec::new, |of| of.undecided_hz.clone()),
        ..SurveyChangeOptions::default()
    };
    let earlier: Vec<Surveyed> = compared.earlier.iter().map(|i| of(*i)).collect();
    let (mut from, mut to) = (of(compared.from), of(compared.to));
    if let Some(Behind {
        temperatures_c: [before_c, after_c],
        ..
    }) = history
    {
        from.temperature_c = from.temperature_c.or(*before_c);
        to.temperature_c = to.temperature_c.or(*after_c);
    }
    let mut change = survey_change(&from, &to, &earlier, &options)?;
    let answer = |of: &Surveyed| answers.iter().find(|answer| answer.name == of.name);
    change
        .notes
        .extend(rate_slip((&from, answer(&from)), (&to, answer(&to))));
    Ok(change)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compared_history::Course;
    use crate::progress::Silent;
    use crate::survey_dates::date;
    use dolmen_project::parse_project;
    use dolmen_records::NoFiles;
    use std::sync::Arc;

    fn project(surveys: &[&str], change: &str) -> Project {
        let mut text = "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n".to_owned() + change;
        for name in surveys {
            text += &format!("\n[survey.{name}]\ntemperature_c = 9\nfrequencies = {{ x = [2.0] }}\n");
        }
        parse_project(&text, "project.toml").unwrap()
    }

    #[test]
    fn holds_the_first_and_the_last_date_are_compared() {
        // those with a date are read by date
        let four = project(&["2024-11-30", "2019-04-02", "extra", "2019-03"], "");
        let found = surveys_to_compare(&four, None, None).unwrap();
        assert_eq!((found.from, found.to, found.earlier), (0, 3, vec![]));
        let found = surveys_to_compare(&four, Some("extra"), Some("2019-03")).unwrap();
        assert_eq!((found.from, found.to), (2, 0));
    }

    #[test]
    fn holds_a_line_is_fitted_to_what_came_before() {
        let five = project(
            &["2021", "2019", "2020-02", "2023", "2022-05-01"],
            "[change]\ntemperature = \"fitted\"\n",
        );
        let found = surveys_to_compare(&five, None, Some("2022-05-01")).unwrap();
        assert_eq!((found.from, found.to, found.earlier), (0, 3, vec![1, 2]));
    }

    /// Fourteen surveys in warm and cold months, −0.08 % per °C; from the ninth on 4 % lower.
    fn of_many() -> Project {
        parse_project(&text_of_many(), "project.toml").unwrap()
    }

    fn text_of_many() -> String {
        let off = [
            0.4, -0.7, 0.1, 0.9, -0.5, -0.2, 0.6, -0.8, 0.3, -0.4, 0.8, -0.1, -0.6, 0.2,
        ];
        let mut text = "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n".to_owned();
        for (i, off) in off.iter().enumerate() {
            let temperature_c = if i % 2 == 0 { 20.0 } else { 6.0 } + 5.0 * off;
            let step = if i < 8 { 1.0 } else { 0.96 };
            let hz = 3.0 * step * (1.0 - 0.0008 * (temperature_c - 13.0)) * (1.0 + 0.001 * off * off);
            text += &format!(
                "[survey.{}-{:02}-07]\ntemperature_c = {temperature_c}\nfrequencies.x = [{{ value = {hz}, sd = 0.003 }}]\n",
                2018 + i / 2,
                5 + 6 * (i % 2)
            );
        }
        text
    }

    fn compared(project: &Project, from: Option<&str>) -> CompareAnswer {
        let opened = Opened {
            project: Arc::new(project.clone()),
            text: String::new(),
            file: String::new(),
            identified: Vec::new(),
        };
        let options = CompareOptions {
            from: from.map(str::to_owned),
            to: None,
        };
        compare(&opened, &options, &NoFiles, &Silent).unwrap()
    }

    #[test]
    fn holds_another_survey_that_cannot_be_read_is_named_with_the_reason() {
        let gone = "[survey.2020-01-07.records]\nfile = \"gone.csv\"\nsampling_rate = 100\n";
        let project = parse_project(&(text_of_many() + gone), "project.toml").unwrap();
        let answer = compared(&project, None);
        let [(survey, why)] = answer.unread.as_slice() else {
            panic!("{:?}", answer.unread)
        };
        assert_eq!(survey, "2020-01-07");
        assert!(why.korean.contains("파일을 읽지 않고"), "{why:?}");
        assert_eq!(answer.history.map(|of| of.surveys), Some(14));
        assert!(compared(&of_many(), None).unread.is_empty());
    }

    #[test]
    fn holds_weather_and_scatter_are_those_of_all_surveys() {
        let all = of_many();
        for from in [None, Some("2019-11-07")] {
            let answer = compared(&all, from);
            let change = answer.change.unwrap();
            let frequency = &change.modes[0].frequency;
            assert!((frequency.relative + 0.04).abs() < 0.003, "{frequency:?}");
            assert!(!change.temperature.leaves_doubt() && change.changed().count() == 1);
            let history = answer.history.unwrap();
            assert_eq!(history.surveys, 14);
            let [of] = history.lasting.as_slice() else {
                panic!("{:?}", history.lasting)
            };
            assert!((of.ratio + 0.04).abs() < 0.003, "{of:?}");
            assert!(
                matches!(&of.course, Course::Step { before, .. } if before == "2022-05-07"),
                "{of:?}"
            );
        }
        // nothing changed before the step, so the answer names no lasting change
        let mut earlier = all.clone();
        earlier.surveys.truncate(8);
        let answer = compared(&earlier, None);
        assert!(answer.history.unwrap().lasting.is_empty());
        assert_eq!(answer.change.unwrap().changed().count(), 0);
    }

    #[test]
    fn holds_a_first_survey_of_unknown_weather_is_passed_over_and_named_not_tested() {
        // the first survey alone is below freezing, 1 % higher than its line
        let cold = text_of_many().replacen("temperature_c = 22", "temperature_c = -4", 1);
        assert_ne!(cold, text_of_many());
        let project = parse_project(&cold, "project.toml").unwrap();
        let answer = compared(&project, None);
        let change = answer.change.as_ref().unwrap();
        assert_eq!(
            (answer.from.as_str(), change.from.as_str()),
            ("2018-05-07", "2018-11-07")
        );
        assert!(change.modes[0].history.is_some() && !change.modes[0].is_undecided);
        assert_eq!(answer.history.as_ref().unwrap().passed_over, ["2018-05-07"]);
        let named = compared(&project, Some("2018-05-07"));
        let change = named.change.as_ref().unwrap();
        assert_eq!(change.from, "2018-05-07");
        assert!(change.modes[0].is_undecided && change.modes[0].frequency.evidence.is_none());
        assert!(named.history.unwrap().passed_over.is_empty());
    }

    #[test]
    fn holds_few_surveys_are_compared_alone() {
        let mut few = of_many();
        few.surveys.truncate(7);
        let answer = compared(&few, None);
        assert!(answer.history.is_none() && answer.change.unwrap().modes[0].history.is_none());
    }

    #[test]
    fn refuses_what_is_not_clear() {
        let message = |p: &Project, from, to| surveys_to_compare(p, from, to).unwrap_err().to_string();
        let two = project(&["before", "after"], "");
        assert!(message(&two, None, None).contains("(it has before, after)"));
        let said = message(&two, Some("before"), Some("afer"));
        assert!(said.starts_with("there is no survey \"afer\""), "{said}");
        let said = message(&two, Some("after"), Some("after"));
        assert_eq!(
            said,
            "survey \"after\" cannot be compared with itself: name an earlier one with --from, or a later one with --to"
        );
        assert_eq!(date("201904"), None);
        assert_eq!(date("2019-13"), Some([2019, 0, 0]));
    }
}
