//! Chooses the two surveys of a project to compare, and prepares their modes.

use crate::answer::CompareAnswer;
use crate::change_fault::ChangeFault;
use crate::changed_part::changed_parts;
use crate::compared_readings::{compared_readings, has_modes};
use crate::error::WorkError;
use crate::identify;
use crate::opened::Opened;
use crate::progress::Progress;
use crate::rate_slip::rate_slip;
use crate::survey_dates::date;
use crate::surveyed::{ModesOf, SurveyAnswer};
use dolmen::assess::{SurveyChange, SurveyChangeOptions, Surveyed, TemperatureEffect, survey_change};
use dolmen::modal::{ObservedMode, ObservedPoint, Pairing};
use dolmen::signal::Channel;
use dolmen_project::{ModeKind, Project, Survey, SurveyMode, TemperaturePart};
use dolmen_records::Files;

/// Names of the surveys to compare.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CompareOptions {
    /// The earlier survey; by default the first whose name begins with a date.
    pub from: Option<String>,
    /// The later survey; by default the last whose name begins with a date.
    pub to: Option<String>,
}

/// Compares two surveys.
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
    let answers: Vec<SurveyAnswer> = needed
        .map(|i| identify::found_in(&project.surveys[i], files, progress))
        .collect::<Result<_, _>>()?;
    Ok(compared_of(opened, &compared, &answers)?)
}

/// Compares two surveys of a project; `answers` hold the results of their records.
///
/// # Errors
/// [`ChangeFault::Assess`].
pub(crate) fn compared_of(
    opened: &Opened,
    compared: &ComparedSurveys,
    answers: &[SurveyAnswer],
) -> Result<CompareAnswer, ChangeFault> {
    let project = &opened.project;
    let [from, to] = [compared.from, compared.to].map(|at| &project.surveys[at]);
    let change = match has_modes(from) && has_modes(to) {
        true => Some(change_of(project, compared, answers)?),
        false => None,
    };
    Ok(CompareAnswer {
        file: opened.file.clone(),
        project: opened.project.clone(),
        from: from.name.clone(),
        to: to.name.clone(),
        parts: change
            .as_ref()
            .map_or_else(Vec::new, |change| changed_parts(project, change)),
        change,
        readings: compared_readings(project, compared.from, compared.to),
        shaken: shaken(project, compared, answers),
    })
}

/// Which of both surveys hold an earthquake, and from which part of their records their modes are.
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

/// Two surveys, by index, and the earlier ones for the fit of a temperature coefficient.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ComparedSurveys {
    /// The survey before.
    pub from: usize,
    /// The survey after.
    pub to: usize,
    /// Other surveys before `to` with a temperature, in their order; empty without a fit.
    pub earlier: Vec<usize>,
}

/// Whether a survey has data for a comparison.
fn is_usable(survey: &Survey) -> bool {
    has_modes(survey) || !survey.tilt.is_empty() || !survey.inspections.is_empty()
}

/// The surveys to compare: those named, otherwise the first and the last whose names begin with a date, among those with modes if there are two.
///
/// # Errors
/// [`ChangeFault::NoSurvey`], [`ChangeFault::Unclear`], [`ChangeFault::Same`].
pub fn surveys_to_compare(
    project: &Project,
    from: Option<&str>,
    to: Option<&str>,
) -> Result<ComparedSurveys, ChangeFault> {
    let usable = || project.surveys.iter().enumerate().filter(|(_, s)| is_usable(s));
    let known = || {
        let names: Vec<&str> = usable().map(|(_, s)| s.name.as_str()).collect();
        if names.is_empty() {
            "none".to_owned()
        } else {
            names.join(", ")
        }
    };
    let named = |name: &str| {
        usable()
            .find(|(_, s)| s.name == name)
            .map(|(i, _)| i)
            .ok_or_else(|| ChangeFault::NoSurvey {
                given: name.to_owned(),
                known: known(),
            })
    };
    let mut dated: Vec<([u32; 3], usize)> = usable().filter_map(|(i, s)| Some((date(&s.name)?, i))).collect();
    dated.sort();
    let with_modes: Vec<([u32; 3], usize)> = dated
        .iter()
        .copied()
        .filter(|(_, i)| has_modes(&project.surveys[*i]))
        .collect();
    if with_modes.len() > 1 {
        dated = with_modes;
    }
    let unclear = || ChangeFault::Unclear { known: known() };
    let end = |name: Option<&str>, of_dated: Option<&([u32; 3], usize)>| match name {
        Some(name) => named(name),
        None => of_dated
            .filter(|_| dated.len() > 1)
            .map(|(_, i)| *i)
            .ok_or_else(unclear),
    };
    let (from, to) = (end(from, dated.first())?, end(to, dated.last())?);
    if from == to {
        return Err(ChangeFault::Same {
            given: project.surveys[from].name.clone(),
        });
    }
    let fitted = project.change.temperature == TemperaturePart::Fitted;
    // in the order of their dates if the later one has one, else of the file
    let place = |i: usize| {
        (
            date(&project.surveys[to].name).and(date(&project.surveys[i].name)),
            i,
        )
    };
    let earlier = usable()
        .filter(|(_, survey)| has_modes(survey))
        .map(|(i, _)| i)
        .filter(|i| fitted && *i != from && *i != to && place(*i) < place(to))
        .filter(|i| project.surveys[*i].temperature_c.is_some())
        .collect();
    Ok(ComparedSurveys { from, to, earlier })
}

/// The modes of a survey: from its records if it has any, otherwise those stated in the file.
pub fn surveyed(survey: &Survey, found: Option<&SurveyAnswer>) -> Surveyed {
    let mut modes = match found.and_then(SurveyAnswer::modes) {
        Some((modes, time_blocks)) => {
            let mut all = ObservedMode::all(modes, time_blocks);
            let setups = found
                .and_then(|found| found.setups.as_ref())
                .filter(|setups| setups.joint.is_none());
            let merged = setups.iter().flat_map(|setups| &setups.merged.merged);
            for (mode, merged) in all.iter_mut().zip(merged) {
                let own = merged.degrees_of_freedom.unwrap_or(f64::INFINITY);
                mode.degrees_of_freedom = mode.degrees_of_freedom.min(own);
            }
            all
        }
        None => {
            let listed = survey.modes.iter();
            listed
                .flat_map(|(direction, modes)| modes.iter().map(|mode| stated(direction, mode)))
                .collect()
        }
    };
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Surveyed {
        name: survey.name.clone(),
        temperature_c: survey.temperature_c,
        modes,
    }
}

fn stated(direction: &str, mode: &SurveyMode) -> ObservedMode {
    let twists = mode.kind == ModeKind::Torsion;
    ObservedMode {
        accepted: false,
        frequency_hz: mode.frequency.value,
        frequency_sd_hz: mode.frequency.cov.map(|_| mode.frequency.standard_deviation()),
        damping_ratio: mode.damping_ratio.as_ref().map(|zeta| zeta.value),
        damping_ratio_sd: mode
            .damping_ratio
            .as_ref()
            .and_then(|zeta| zeta.cov.map(|_| zeta.standard_deviation())),
        degrees_of_freedom: f64::INFINITY,
        direction: Some(if twists {
            "torsion".to_owned()
        } else {
            direction.to_owned()
        }),
        shape: mode
            .shape
            .iter()
            .map(|point| {
                let name = format!("{direction} at {:.3} m", point.height_m);
                ObservedPoint::real(Channel::named(name), point.displacement)
            })
            .collect(),
    }
}

/// The change of modes between two surveys of a project.
fn change_of(
    project: &Project,
    compared: &ComparedSurveys,
    answers: &[SurveyAnswer],
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
        ..SurveyChangeOptions::default()
    };
    let earlier: Vec<Surveyed> = compared.earlier.iter().map(|i| of(*i)).collect();
    let (from, to) = (of(compared.from), of(compared.to));
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
    use dolmen_project::parse_project;

    fn project(surveys: &[&str], change: &str) -> Project {
        let mut text = "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n".to_owned() + change;
        for name in surveys {
            text += &format!("\n[survey.{name}]\ntemperature_c = 9\nfrequencies = {{ x = [2.0] }}\n");
        }
        parse_project(&text, "project.toml").unwrap()
    }

    #[test]
    fn holds_the_first_and_the_last_date_are_compared() {
        let four = project(&["2024-11-30", "2019-04-02", "extra", "2019-03"], "");
        let found = surveys_to_compare(&four, None, None).unwrap();
        assert_eq!((found.from, found.to, found.earlier), (3, 0, vec![]));
        let found = surveys_to_compare(&four, Some("extra"), Some("2019-03")).unwrap();
        assert_eq!((found.from, found.to), (2, 3));
    }

    #[test]
    fn holds_a_line_is_fitted_to_what_came_before() {
        let five = project(
            &["2021", "2019", "2020-02", "2023", "2022-05-01"],
            "[change]\ntemperature = \"fitted\"\n",
        );
        let found = surveys_to_compare(&five, None, Some("2022-05-01")).unwrap();
        assert_eq!((found.from, found.to, found.earlier), (1, 4, vec![0, 2]));
    }

    #[test]
    fn refuses_what_is_not_clear() {
        let message = |p: &Project, from, to| surveys_to_compare(p, from, to).unwrap_err().to_string();
        let two = project(&["before", "after"], "");
        assert!(message(&two, None, None).contains("(it has before, after)"));
        let said = message(&two, Some("before"), Some("afer"));
        assert!(said.starts_with("there is no survey \"afer\""), "{said}");
        let said = message(&two, Some("after"), Some("after"));
        assert_eq!(said, "survey \"after\" cannot be compared with itself");
        assert_eq!(date("201904"), None);
        assert_eq!(date("2019-13"), Some([2019, 0, 0]));
    }
}
