//! Reads tenons with slack in a direction of a frame.

use super::file::TenonsRaw;
use super::part::TenonsPart;
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::one_each;
use crate::quantity::Quantity;
use crate::ratio::below;
use crate::reader::Reader;
use crate::wrong::WrongFrame;

/// Most slack, as drift over height: at 0.1 the storey counts as fallen. Our choice.
const SLACK_MOST: f64 = 0.1;

pub(super) fn tenons(
    reader: &mut Reader,
    raw: &At<TenonsRaw>,
    path: &str,
    storeys: usize,
) -> Option<TenonsPart> {
    reader.mark(path, &raw.span);
    let given = &raw.value;
    let mut each = |list: &Option<At<Vec<At<QuantityRaw>>>>, key: &str, measure, bound| {
        let list = list.as_ref()?;
        let path = format!("{path}.{key}");
        let sound = one_each(reader, &list.value, &list.span, &path, ("storeys", storeys));
        let numbered = list.value.iter().enumerate();
        let read: Vec<Option<Quantity>> = numbered
            .map(|(i, raw)| {
                let read = reader.quantity(Some(raw), &format!("{path}[{}]", i + 1), measure, bound)?;
                match measure {
                    Measure::Tilt => below(reader, read, Some(raw), SLACK_MOST, WrongFrame::SlackIsRotation),
                    _ => Some(read),
                }
            })
            .collect();
        let read: Option<Vec<Quantity>> = read.into_iter().collect();
        read.filter(|_| sound)
    };
    let slack = each(&given.slack, "slack", Measure::Tilt, Bound::Positive);
    let stiffness = each(
        &given.stiffness,
        "stiffness",
        Measure::StoreyStiffness,
        Bound::NotNegative,
    );
    let crushing_force = each(
        &given.crushing_force,
        "crushing_force",
        Measure::Force,
        Bound::Positive,
    );
    if given.crushing_force.is_some() && crushing_force.is_none() {
        return None;
    }
    let half_path = format!("{path}.half_stiffness_depth");
    let half_stiffness_depth = match &given.half_stiffness_depth {
        None => None,
        Some(half) if crushing_force.is_none() => {
            let fault = Fault::new(
                half.span.clone(),
                &half_path,
                WrongFrame::HalfWithoutCrushing(half_path.clone()),
            );
            reader.fault(fault.help(WrongFrame::GiveCrushingForce));
            return None;
        }
        Some(half) => Some(reader.quantity(Some(half), &half_path, Measure::Length, Bound::Positive)?),
    };
    Some(TenonsPart {
        slack: slack?,
        stiffness: stiffness?,
        crushing_force,
        half_stiffness_depth,
    })
}
