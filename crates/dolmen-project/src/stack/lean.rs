//! Whose measured lean a stack takes over.

use super::part::StackPart;
use super::surveyed_lean::{SurveyedLean, only_foot};
use crate::content::WarningKind;
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::Survey;
use crate::warned::Warned;
use crate::wrong::WrongStack;

/// Slope beyond which a stack does not lie on level ground any more: joints are recognised up to 5°.
const SLOPE_MOST: f64 = 0.087;

/// The day of a survey from its name: "2010-05-12", "2011-restored".
fn day(name: &str) -> Option<[u32; 3]> {
    let mut parts = name.split('-');
    let number =
        |part: Option<&str>, digits: usize| part.filter(|part| part.len() == digits)?.parse::<u32>().ok();
    let year = number(parts.next(), 4)?;
    let month = number(parts.next(), 2);
    let day = month.and_then(|_| number(parts.next(), 2));
    Some([year, month.unwrap_or(0), day.unwrap_or(0)])
}

/// The survey whose tilt the model takes over: the one named, else the latest with a date and a tilt.
fn chosen<'a>(reader: &mut Reader, given: Option<&At<String>>, surveys: &'a [Survey]) -> Option<&'a Survey> {
    let tilted = || surveys.iter().filter(|survey| !survey.tilt.is_empty());
    match given.map(|given| given.value.as_str()) {
        Some("none") => None,
        None | Some("latest") => tilted()
            .filter_map(|survey| Some((day(&survey.name)?, survey)))
            .max_by_key(|(day, _)| *day)
            .map(|(_, survey)| survey),
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

/// Gives the stack the lean of the survey that `as_surveyed` chooses, or says why not.
pub(crate) fn lean(
    reader: &mut Reader,
    given: Option<&At<String>>,
    surveys: &[Survey],
    stack: &mut StackPart,
) {
    let Some(survey) = chosen(reader, given, surveys) else {
        return;
    };
    let path = format!("survey.{}.tilt", survey.name);
    let name = survey.name.clone();
    let along = |direction: &str| survey.tilt.get(direction);
    let slope = ["x", "y"].map(|direction| along(direction).map_or(0.0, |tilt| tilt.ratio));
    let why_not = if survey
        .tilt
        .keys()
        .any(|direction| direction != "x" && direction != "y")
    {
        Some(Warned::TiltNotAlongAxes { survey: name })
    } else if stack.carries_own_lean() {
        Some(Warned::TiltOnParts { survey: name })
    } else if slope[0].hypot(slope[1]) > SLOPE_MOST {
        Some(Warned::TiltTooSteep { survey: name })
    } else {
        let built = stack.build(&mut crate::quantity::Quantity::nominal);
        match built {
            // said where the stack is looked at
            Err(_) => return,
            Ok(built) if only_foot(built.blocks()).is_none() => {
                Some(Warned::TiltOfSeveralFeet { survey: name })
            }
            Ok(_) => None,
        }
    };
    if let Some(why_not) = why_not {
        reader.warn(WarningKind::SurveyTilt, &path, why_not);
        return;
    }
    let written = survey
        .tilt
        .iter()
        .map(|(direction, tilt)| format!("{direction} {}", tilt.written));
    stack.lean = Some(SurveyedLean {
        survey: survey.name.clone(),
        slope,
        written: written.collect::<Vec<_>>().join(", "),
    });
}
