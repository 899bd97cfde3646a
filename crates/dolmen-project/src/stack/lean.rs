//! Whose measured lean a stack takes over.

use super::part::StackPart;
use super::surveyed_lean::{SurveyedLean, only_foot};
use crate::content::WarningKind;
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::{Survey, as_surveyed};
use crate::warned::Warned;

/// Slope beyond which a stack does not lie on level ground any more: joints are recognised up to 5°.
const SLOPE_MOST: f64 = 0.087;

/// Gives the stack the lean of the survey that `as_surveyed` chooses, or says why not.
pub(crate) fn lean(
    reader: &mut Reader,
    given: Option<&At<String>>,
    surveys: &[Survey],
    stack: &mut StackPart,
) {
    let Some(survey) = as_surveyed(reader, given, surveys) else {
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
