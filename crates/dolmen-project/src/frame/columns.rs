//! Free-standing columns of a storey: reading, and probable slips.

use super::file::ColumnsRaw;
use super::part::{ColumnsPart, FootPart, FramePart};
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::usual::{guess, rounded_length, unit_of, within};

/// Most columns of a storey. Our choice: the largest halls have some two hundred.
const COLUMNS_MOST: usize = 10_000;
/// Width of a column, m.
const WIDTH_M: (f64, f64) = (0.05, 2.0);
/// Usual width, for comparison, m.
const WIDTH_USUAL_M: f64 = 0.4;
/// Bed stiffness, Pa/m: 1e7 is a stone on soft ground, 1e12 a faced joint of hard stones.
const BED_STIFFNESS_PA_M: (f64, f64) = (1e6, 1e13);
/// Usual bed stiffness, for comparison, Pa/m.
const BED_STIFFNESS_USUAL_PA_M: f64 = 1e9;
/// Mean pressure under a foot, Pa: the largest is the strength of hard wood along its grain.
const PRESSURE_PA: (f64, f64) = (1e3, 5e7);

pub(super) fn columns(reader: &mut Reader, raw: &At<ColumnsRaw>, path: &str) -> Option<ColumnsPart> {
    reader.mark(path, &raw.span);
    let given = &raw.value;
    let before = reader.faults.len();
    let count = reader.count(given.count.as_ref(), &format!("{path}.count"), 1, COLUMNS_MOST);
    let mut of = |raw, key: &str, measure| {
        reader.quantity(
            Option::as_ref(raw),
            &format!("{path}.{key}"),
            measure,
            Bound::Positive,
        )
    };
    let width = of(&given.width, "width", Measure::Length);
    let breadth = of(&given.breadth, "breadth", Measure::Length);
    let diameter = of(&given.diameter, "diameter", Measure::Length);
    let bed_stiffness = of(&given.bed_stiffness, "bed_stiffness", Measure::BedStiffness);
    if reader.faults.len() > before {
        return None;
    }
    let foot = match (width, diameter, breadth) {
        (Some(width), None, breadth) => FootPart::Rectangle { width, breadth },
        (None, Some(diameter), None) => FootPart::Circle { diameter },
        (width, diameter, _) => {
            if !reader.is_reported(path) {
                let said = match (width, diameter) {
                    (Some(_), _) => "has both width and diameter",
                    (None, Some(_)) => "has both diameter and breadth",
                    (None, None) => "has neither width nor diameter",
                };
                let fault = Fault::new(raw.span.clone(), path, format!("{path} {said}"));
                reader.fault(fault.help("give width, and breadth if it is another, or diameter alone"));
            }
            return None;
        }
    };
    Some(ColumnsPart {
        count: count?,
        foot,
        bed_stiffness,
    })
}

/// Rejects columns that contradict the frame; returns whether they are consistent.
pub(super) fn agree(reader: &mut Reader, frame: &FramePart) -> bool {
    let before = reader.faults.len();
    let built = frame.build(&mut Quantity::nominal).ok();
    for (i, storey) in frame.storeys.iter().enumerate() {
        let Some(columns) = &storey.columns else {
            continue;
        };
        let path = format!("storeys[{}].columns", i + 1);
        let width = columns.foot.width();
        if width.value >= storey.height.value {
            let message = format!(
                "{} = {} is not below {} = {}",
                width.path, width.written, storey.height.path, storey.height.written
            );
            let fault = Fault::new(reader.place(&width.path), &width.path, message);
            reader.fault(fault.allowed("must be less than the height of the column"));
        }
        if let FootPart::Rectangle {
            breadth: Some(breadth),
            ..
        } = &columns.foot
            && frame.directions.len() > 1
            && breadth.value != width.value
        {
            let message = format!(
                "{} is given, but the frame has {} directions: nothing says along which of them the width lies",
                breadth.path,
                frame.directions.len()
            );
            let fault = Fault::new(reader.place(&breadth.path), &breadth.path, message);
            reader.fault(
                fault.help("take breadth out for square columns, or write one file for each direction"),
            );
        }
        let axial_n = built
            .as_ref()
            .and_then(|built| Some(built.storeys().get(i)?.axial_n));
        if axial_n == Some(0.0) {
            let message = format!("{path} is given, but the axial force of the storey is 0");
            let fault = Fault::new(reader.place(&path), &path, message);
            reader.fault(
                fault.help("columns that stand free stand by the weight on them: give the axial force"),
            );
        }
    }
    reader.faults.len() == before
}

/// Probable slips.
pub(super) fn judge(reader: &mut Reader, columns: &ColumnsPart, axial_n: f64) {
    let width = columns.foot.width();
    if !within(width.value, WIDTH_M) {
        let (least, most) = WIDTH_M;
        let message = format!(
            "{} = {}, but columns are {least} to {most} m wide",
            width.path, width.written
        );
        reader.slip(
            &width.path,
            message,
            guess(width.value / WIDTH_USUAL_M, unit_of(width)),
        );
        return; // pressures follow from it
    }
    if let Some(bed) = columns.bed_stiffness.as_ref()
        && !within(bed.value, BED_STIFFNESS_PA_M)
    {
        let message = format!(
            "{} = {}, but beds of feet have 0.001 to 10 000 GPa/m",
            bed.path, bed.written
        );
        let help = guess(bed.value / BED_STIFFNESS_USUAL_PA_M, unit_of(bed));
        reader.slip(&bed.path, message, help);
    }
    let pressure_pa = axial_n / (columns.count as f64 * columns.foot.area_m2());
    if axial_n > 0.0 && !within(pressure_pa, PRESSURE_PA) {
        let message = format!(
            "{} = {}: each of {} columns would press its stone with {} MPa",
            width.path,
            width.written,
            columns.count,
            rounded_length(pressure_pa / 1e6)
        );
        reader.slip(
            &width.path,
            message,
            "check count, width and axial force".to_owned(),
        );
    }
}
