//! The survey whose measured tilt a model takes.

use super::part::Survey;
use super::watch::date_of;
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::wrong::WrongStack;

/// The survey whose tilt the model takes: the named one, else the latest with a date and a tilt.
pub(crate) fn as_surveyed<'a>(
    reader: &mut Reader,
    given: Option<&At<String>>,
    surveys: &'a [Survey],
) -> Option<&'a Survey> {
    let tilted = || surveys.iter().filter(|survey| !survey.tilt.is_empty());
    match given.map(|given| given.value.as_str()) {
        Some("none") => None,
        None | Some("latest") => {
            let dated = || tilted().filter_map(|survey| Some((date_of(&survey.name)?, survey)));
            let last = dated().map(|(day, _)| day).max()?;
            let of_day: Vec<&Survey> = dated()
                .filter(|(day, _)| *day == last)
                .map(|(_, of)| of)
                .collect();
            if of_day.iter().any(|survey| survey.tilt != of_day[0].tilt) {
                let path = format!("survey.{}.tilt", of_day[of_day.len() - 1].name);
                let surveys = of_day.iter().map(|survey| survey.name.clone()).collect();
                let fault = Fault::new(reader.place(&path), &path, WrongStack::TiltsOfOneDay { surveys });
                reader.fault(fault.help(WrongStack::SayAsSurveyed));
            }
            of_day.last().copied()
        }
        Some(name) => {
            let found = tilted().find(|survey| survey.name == name);
            if found.is_none()
                && let Some(given) = given
            {
                let names: Vec<String> = tilted().map(|survey| format!("\"{}\"", survey.name)).collect();
                let message = WrongStack::AsSurveyedButNo {
                    name: name.to_string(),
                };
                let fault = Fault::new(given.span.clone(), "as_surveyed", message);
                let allowed = [vec!["\"latest\"".to_owned(), "\"none\"".to_owned()], names].concat();
                reader.fault(fault.allowed(WrongStack::MustBeOneOf {
                    allowed: allowed.join(", "),
                }));
            }
            found
        }
    }
}
