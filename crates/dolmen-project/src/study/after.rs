//! The motion before the runs of a study. Several sizes of it are varied as inputs.

use super::file::{AfterRaw, SeriesRaw};
use super::part::{AfterPart, Axis, Override, Scan};
use super::values::{as_written, scan};
use crate::file_number::At;
use crate::measure::Bound;
use crate::reader::Reader;
use dolmen::known::STANDARD_GRAVITY_M_S2;

/// The motion with its sizes; several sizes become the last of the varied inputs, `after.peak` or `after.scale`.
pub(super) fn after_motion(
    reader: &mut Reader,
    (raw, text): (&At<AfterRaw>, &str),
    vary: &mut Vec<Axis>,
    path: &str,
) -> Option<AfterPart> {
    let path = format!("{path}.after");
    reader.mark(&path, &raw.span);
    let given = &raw.value;
    let motion = given.motion.as_ref()?.value.clone();
    let written = (given.scale.as_ref(), given.peak.as_ref());
    let sizes = scan(reader, written, Bound::NotNegative, &path);
    let several = sizes.as_ref().filter(|sizes| sizes.steps() > 1);
    let axis = several.zip(written.0.or(written.1)).map(|(sizes, raw)| {
        vary.push(axis(sizes, raw, text));
        vary.len() - 1
    });
    Some(AfterPart { motion, sizes, axis })
}

fn axis(sizes: &Scan, raw: &At<SeriesRaw>, text: &str) -> Axis {
    let path = match sizes {
        Scan::Scales(_) => "after.scale",
        Scan::Peaks(_) => "after.peak",
    };
    let at = |text: String, span: &std::ops::Range<usize>| Override {
        path: path.to_owned(),
        text,
        span: span.clone(),
    };
    let values = match (&raw.value, sizes) {
        (SeriesRaw::List(list), _) => {
            let each = list.iter();
            each.map(|one| {
                at(
                    text.get(one.span.clone()).unwrap_or_default().to_owned(),
                    &one.span,
                )
            })
            .collect()
        }
        (SeriesRaw::Range(_), Scan::Scales(values)) => {
            let each = values.iter();
            each.map(|value| at(value.to_string(), &raw.span)).collect()
        }
        (SeriesRaw::Range(_), Scan::Peaks(values)) => {
            let each = values
                .iter()
                .map(|value| as_written(value / STANDARD_GRAVITY_M_S2));
            each.map(|value| at(format!("{value} g"), &raw.span)).collect()
        }
    };
    Axis {
        path: path.to_owned(),
        values,
    }
}
