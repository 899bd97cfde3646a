//! The survey whose measured lean a stack takes.

use super::part::StackPart;
use super::surveyed_lean::{SurveyedLean, only_foot};
use crate::content::WarningKind;
use crate::doubted::Doubted;
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::{Survey, as_surveyed};
use crate::warned::Warned;
use crate::wrong::WrongStack;

/// Slope beyond which a stack is no longer on level ground: joints are recognised up to 5°.
const SLOPE_MOST: f64 = 0.087;

/// Smallest difference of slopes that a tape or plumb line shows: 5 mm per metre. Our choice.
const SLOPE_SEEN: f64 = 0.005;
/// Smallest slope that a message names, far below that of any survey.
const SLOPE_NAMED: f64 = 1e-4;
/// Allowed difference of two slopes, also as a share of the larger. Our choice.
const SHARE_MOST: f64 = 1.0 / 3.0;

/// The slope of the line from the centre of the lowest block to that of the top one, by the tilts, offsets and places in the file; `None`
/// for one block, and where the blocks cannot be built.
fn own_slope(stack: &StackPart) -> Option<[f64; 2]> {
    let built = stack.build(&mut crate::quantity::Quantity::nominal).ok()?;
    let centres = built.blocks().iter().map(|block| block.solid.centroid_m());
    let by_height = |a: &[f64; 3], b: &[f64; 3]| a[2].total_cmp(&b[2]);
    let lowest = centres.clone().min_by(by_height)?;
    let top = centres.max_by(by_height)?;
    let height = top[2] - lowest[2];
    (height > 0.0).then(|| [0, 1].map(|axis| (top[axis] - lowest[axis]) / height))
}

/// Whether two slopes are too different to belong to one structure.
fn differ(own: [f64; 2], measured: [f64; 2]) -> bool {
    let apart = (own[0] - measured[0]).hypot(own[1] - measured[1]);
    let larger = own[0].hypot(own[1]).max(measured[0].hypot(measured[1]));
    apart > SLOPE_SEEN && apart > SHARE_MOST * larger
}

fn sign(ratio: f64) -> &'static str {
    match ratio < 0.0 {
        true => "-",
        false => "",
    }
}

/// Gives the stack the lean of the survey that `as_surveyed` chooses, or reports why not.
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
            // reported where the stack is checked
            Err(_) => return,
            Ok(built) if only_foot(built.blocks()).is_none() => {
                Some(Warned::TiltOfSeveralFeet { survey: name })
            }
            Ok(_) => None,
        }
    };
    if stack.carries_own_lean()
        && let Some(own) = own_slope(stack)
        && differ(own, slope)
    {
        let tilt = |slope: [f64; 2]| {
            let each = ["x", "y"].into_iter().zip(slope);
            let each = each.filter(|(_, ratio)| ratio.abs() > SLOPE_NAMED);
            let each: Vec<String> = each
                .map(|(direction, ratio)| format!("{direction} {}1/{:.0}", sign(ratio), 1.0 / ratio.abs()))
                .collect();
            match each.is_empty() {
                true => "0".to_owned(),
                false => each.join(", "),
            }
        };
        let doubt = Doubted::TiltsDiffer {
            survey: survey.name.clone(),
            measured: tilt(slope),
            own: tilt(own),
        };
        reader.doubt(&path, doubt);
    }
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
