//! Whose measured lean a stack takes over.

use super::part::StackPart;
use super::surveyed_lean::{SurveyedLean, only_foot};
use crate::content::WarningKind;
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::{Survey, as_surveyed};
use crate::warned::Warned;
use crate::wrong::WrongStack;

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
    let mut directions = survey.tilt.keys();
    if let Some(direction) = directions.find(|direction| !["x", "y"].contains(&direction.as_str())) {
        let path = format!("{path}.{direction}");
        let fault = Fault::new(
            reader.place(&path),
            &path,
            WrongStack::TiltDirection {
                direction: direction.clone(),
            },
        );
        return reader.fault(
            fault
                .allowed(WrongStack::MustBeXOrY)
                .help(WrongStack::OrLeftUpright),
        );
    }
    let why_not = if stack.carries_own_lean() {
        Some(Warned::TiltOnParts { survey: name })
    } else if slope[0].hypot(slope[1]) > SLOPE_MOST {
        let steeper = if slope[0].abs() > slope[1].abs() { "x" } else { "y" };
        let path = format!("{path}.{steeper}");
        let degrees = slope[0].hypot(slope[1]).atan().to_degrees();
        let fault = Fault::new(
            reader.place(&path),
            &path,
            WrongStack::TiltTooSteep {
                degrees: format!("{degrees:.1}"),
            },
        );
        return reader.fault(
            fault
                .allowed(WrongStack::TiltMost)
                .help(WrongStack::TiltOnEachBlock),
        );
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
