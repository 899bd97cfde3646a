//! Reads values of a study: lists and ranges of inputs, kept as text, and of numbers in SI.

use super::file::{SeriesRaw, SpacingRaw, TreeRaw};
use super::part::{Axis, Override, Scan};
use crate::error::Fault;
use crate::file_number::{At, NumberRaw};
use crate::measure::{Bound, Measure};
use crate::paths::keys;
use crate::reader::Reader;
use crate::units::split_number;
use crate::written::short;
use crate::wrong::{Common, WrongNumber, WrongStudy};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use std::collections::BTreeMap;
use std::ops::Range;
use toml::de::DeValue;

/// Most values of one list or range.
pub(super) const VALUES_MOST: usize = 10_000;
/// Fewest values of a range: both of its ends.
const STEPS_LEAST: usize = 2;

/// Largest peak of the ground in a study, m/s²: four times the largest recorded. Our choice.
const PEAK_MOST_M_S2: f64 = 10.0 * STANDARD_GRAVITY_M_S2;

/// A value, list or range at the end of a path.
pub(super) struct Leaf<'r> {
    pub(super) path: String,
    pub(super) tree: &'r TreeRaw,
    pub(super) span: Range<usize>,
}

impl Leaf<'_> {
    pub(super) fn value(&self, text: &str) -> Override {
        Override {
            path: self.path.clone(),
            text: text.get(self.span.clone()).unwrap_or_default().to_owned(),
            span: self.span.clone(),
        }
    }
}

/// The leaves of a tree in the order of the file.
pub(super) fn leaves<'r>(reader: &mut Reader, tree: Option<&'r At<TreeRaw>>, place: &str) -> Vec<Leaf<'r>> {
    let mut found = Vec::new();
    if let Some(tree) = tree {
        flatten(&tree.value, &tree.span, "", &mut found);
    }
    found.sort_by_key(|leaf| leaf.span.start);
    for leaf in &found {
        if keys(&leaf.path).is_none() {
            let message = WrongStudy::IsNoPath {
                place: place.to_string(),
                path: leaf.path.to_string(),
            };
            let fault = Fault::new(leaf.span.clone(), place, message);
            reader.fault(fault.help(WrongStudy::WriteItAsJoint));
        }
    }
    found
}

/// A path may be one key, "joint.friction", or nested tables: both give the same leaves.
fn flatten<'r>(tree: &'r TreeRaw, span: &Range<usize>, path: &str, found: &mut Vec<Leaf<'r>>) {
    match tree {
        TreeRaw::Table(table)
            if path.is_empty() || !["from", "value"].iter().any(|key| table.contains_key(*key)) =>
        {
            for (key, value) in table {
                let below = if path.is_empty() {
                    key.clone()
                } else {
                    format!("{path}.{key}")
                };
                flatten(&value.value, &value.span, &below, found);
            }
        }
        tree => found.push(Leaf {
            path: path.to_owned(),
            tree,
            span: span.clone(),
        }),
    }
}

pub(super) fn axis(reader: &mut Reader, text: &str, place: &str, leaf: &Leaf<'_>) -> Option<Axis> {
    let path = format!("{place}.{}", leaf.path);
    let at = |text: &str, span: &Range<usize>| Override {
        path: leaf.path.clone(),
        text: text.to_owned(),
        span: span.clone(),
    };
    let values: Vec<Override> = match leaf.tree {
        TreeRaw::List(list) => {
            let written = list.iter().map(|item| (text.get(item.span.clone()), &item.span));
            written
                .map(|(text, span)| at(text.unwrap_or_default(), span))
                .collect()
        }
        TreeRaw::Table(table) => {
            let range = written_range(reader, text, &path, &leaf.span, table)?;
            range.iter().map(|text| at(text, &leaf.span)).collect()
        }
        TreeRaw::Leaf => {
            let fault = Fault::new(leaf.span.clone(), &path, WrongStudy::IsOneValue(path.to_string()));
            let fault = fault.allowed(WrongStudy::MustBeListOr);
            reader.fault(fault.help(WrongStudy::WriteOrFromTo));
            return None;
        }
    };
    if values.is_empty() || values.len() > VALUES_MOST {
        let message = WrongStudy::HasValues {
            path: path.to_string(),
            count: values.len().to_string(),
        };
        let fault = Fault::new(leaf.span.clone(), &path, message);
        reader.fault(fault.allowed(WrongStudy::MustHaveTo(VALUES_MOST.to_string())));
        return None;
    }
    Some(Axis {
        path: leaf.path.clone(),
        values,
    })
}

/// The values of { from, to, steps, spacing }, each as text.
fn written_range(
    reader: &mut Reader,
    text: &str,
    path: &str,
    span: &Range<usize>,
    table: &BTreeMap<String, At<TreeRaw>>,
) -> Option<Vec<String>> {
    let mut refuse = |message: WrongStudy, help: WrongStudy| {
        reader.fault(Fault::new(span.clone(), path, message).help(help));
    };
    let known = ["from", "to", "steps", "spacing"];
    if let Some(other) = table.keys().find(|key| !known.contains(&key.as_str())) {
        refuse(
            WrongStudy::HasNoKey {
                path: path.to_string(),
                other: other.to_string(),
            },
            WrongStudy::WriteFromToSteps,
        );
        return None;
    }
    let written = |key: &str| text.get(table.get(key)?.span.clone());
    if let Some(steps) = table.get("steps").filter(|_| is_no_count(written("steps"))) {
        let message = WrongNumber::OutsideRange {
            path: format!("{path}.steps"),
            number: written("steps")?.trim().to_owned(),
        };
        let fault = Fault::new(steps.span.clone(), path, message);
        reader.fault(fault.allowed(WrongNumber::MustBeWithin {
            least: STEPS_LEAST.to_string(),
            most: VALUES_MOST.to_string(),
        }));
        return None;
    }
    let number = |key: &str| end_of_range(written(key)?);
    let steps = written("steps").and_then(|steps| steps.trim().parse::<usize>().ok());
    let spacing = match written("spacing").map(|word| word.trim_matches(['"', '\''])) {
        None | Some("linear") => Some(SpacingRaw::Linear),
        Some("logarithmic") => Some(SpacingRaw::Logarithmic),
        Some(_) => None,
    };
    let (Some(from), Some(to), Some(steps), Some(spacing)) = (number("from"), number("to"), steps, spacing)
    else {
        refuse(
            WrongStudy::IsNoRange(path.to_string()),
            WrongStudy::WriteFromToStepsWith,
        );
        return None;
    };
    if from.unit != to.unit {
        refuse(
            WrongStudy::GoesFromTo {
                path: path.to_string(),
                from: (written("from")?).to_string(),
                to: (written("to")?).to_string(),
            },
            WrongStudy::WriteBothEndsIn,
        );
        return None;
    }
    let Some(values) = spaced(from.value, to.value, steps, spacing) else {
        refuse(
            WrongStudy::HasStepsFromTo {
                path: path.to_string(),
                steps: steps.to_string(),
                from: short(from.value),
                to: short(to.value),
            },
            WrongStudy::TakeToStepsBetween,
        );
        return None;
    };
    let whole = from.is_whole && to.is_whole && values.iter().all(|value| value.fract() == 0.0);
    let each = values.into_iter().map(|value| match &from.unit {
        Some(unit) => format!("\"{value} {unit}\""),
        None if whole => format!("{value}"),
        None => format!("{value:?}"),
    });
    Some(each.collect())
}

/// Whether a text is a number of steps that no range can have.
fn is_no_count(written: Option<&str>) -> bool {
    let number = written.and_then(|text| text.trim().replace('_', "").parse::<f64>().ok());
    number.is_some_and(|steps| {
        steps.fract() != 0.0 || !(STEPS_LEAST as f64..=VALUES_MOST as f64).contains(&steps)
    })
}

struct RangeEnd {
    value: f64,
    unit: Option<String>,
    is_whole: bool,
}

fn end_of_range(text: &str) -> Option<RangeEnd> {
    let of = |value: f64, unit, is_whole| RangeEnd {
        value,
        unit,
        is_whole,
    };
    match DeValue::parse(text).ok()?.into_inner() {
        DeValue::Integer(number) => Some(of(number.as_str().parse().ok()?, None, true)),
        DeValue::Float(number) => Some(of(number.as_str().parse().ok()?, None, false)),
        DeValue::String(text) => {
            let (value, unit) = split_number(&text)?;
            (!unit.is_empty()).then(|| of(value, Some(unit.to_owned()), false))
        }
        _ => None,
    }
}

/// Numbers from one to another, both ends exact; `None` if impossible.
fn spaced(from: f64, to: f64, steps: usize, spacing: SpacingRaw) -> Option<Vec<f64>> {
    let is_log = spacing == SpacingRaw::Logarithmic;
    let fits =
        from.is_finite() && to.is_finite() && from != to && (STEPS_LEAST..=VALUES_MOST).contains(&steps);
    (fits && (!is_log || (from > 0.0 && to > 0.0))).then_some(())?;
    let last = steps - 1;
    let each = (0..steps).map(|i| {
        let part = i as f64 / last as f64;
        if i == 0 {
            from
        } else if i == last {
            to
        } else if is_log {
            as_written(from * (to / from).powf(part))
        } else {
            as_written(from + (to - from) * part)
        }
    });
    Some(each.collect())
}

/// The nearest number of 12 digits: 0.3 instead of 0.30000000000000004, independent of the mathematics library.
pub(super) fn as_written(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// Numbers in SI; `None` if there are none or one is wrong, which is reported.
pub(super) fn series(
    reader: &mut Reader,
    raw: Option<&At<SeriesRaw>>,
    path: &str,
    (measure, bound): (Measure, Bound),
) -> Option<Vec<f64>> {
    let raw = raw?;
    let before = reader.faults.len();
    let mut of = |number: &At<NumberRaw>, path: &str| reader.plain(Some(number), path, measure, bound);
    let values: Option<Vec<f64>> = match &raw.value {
        SeriesRaw::List(list) => {
            let each = list.iter().enumerate();
            each.map(|(i, number)| of(number, &format!("{path}[{}]", i + 1)))
                .collect()
        }
        SeriesRaw::Range(range) => {
            let from = range.from.as_ref().and_then(|n| of(n, &format!("{path}.from")));
            let to = range.to.as_ref().and_then(|n| of(n, &format!("{path}.to")));
            let steps = format!("{path}.steps");
            let steps = reader.count(range.steps.as_ref(), &steps, STEPS_LEAST, VALUES_MOST)?;
            from.zip(to)
                .and_then(|(from, to)| spaced(from, to, steps, range.spacing.unwrap_or_default()))
        }
    };
    (reader.faults.len() == before).then_some(())?;
    let rising = values
        .as_ref()
        .is_some_and(|v| !v.is_empty() && v.len() <= VALUES_MOST && v.is_sorted_by(|a, b| a < b));
    if !rising {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            WrongStudy::DoesNotRiseFrom(path.to_string()),
        );
        let fault = fault.allowed(WrongStudy::MustBeRising);
        reader.fault(fault.help(WrongStudy::GiveEachValueOnce));
        return None;
    }
    values
}

/// If the largest peak of a study is below this, m/s², its unit is doubted: 0.005 g is hardly felt, and 1 gal is 0.001 g.
const PEAK_USUAL_LEAST_M_S2: f64 = 0.005 * STANDARD_GRAVITY_M_S2;

/// Factors or peaks, whichever are given; `None` if there are none or one is wrong, which is reported.
pub(super) fn scan(
    reader: &mut Reader,
    (scale, peak): (Option<&At<SeriesRaw>>, Option<&At<SeriesRaw>>),
    bound: Bound,
    path: &str,
) -> Option<Scan> {
    if let (Some(_), Some(peak)) = (scale, peak) {
        let fault = Fault::new(peak.span.clone(), path, Common::HasBothScaleAnd(path.to_string()));
        reader.fault(fault.help(Common::KeepOneOfThem));
        return None;
    }
    let scales = series(reader, scale, &format!("{path}.scale"), (Measure::Ratio, bound));
    let measure = Measure::GroundAcceleration;
    let peaks = series(reader, peak, &format!("{path}.peak"), (measure, bound));
    if let (Some(most), Some(raw)) = (peaks.as_ref().and_then(|peaks| peaks.last()), peak)
        && *most > PEAK_MOST_M_S2
    {
        let path = format!("{path}.peak");
        let message = WrongStudy::GoesUpToG {
            path: path.to_string(),
            peak_g: format!("{:.4}", most / STANDARD_GRAVITY_M_S2),
        };
        let fault = Fault::new(raw.span.clone(), &path, message).allowed(WrongStudy::MustBeGOr);
        reader.fault(fault.help(WrongStudy::NoGroundMovesLike));
        return None;
    }
    if let (Some(most), Some(raw)) = (peaks.as_ref().and_then(|peaks| peaks.last()), peak)
        && *most > 0.0
        && *most < PEAK_USUAL_LEAST_M_S2
    {
        let path = format!("{path}.peak");
        reader.mark(&path, &raw.span);
        let message = WrongStudy::GoesUpToOnly {
            path: path.clone(),
            peak_g: format!("{:.5}", most / STANDARD_GRAVITY_M_S2),
        };
        reader.slip(&path, message, WrongStudy::AreTheseG);
    }
    scales.map(Scan::Scales).or(peaks.map(Scan::Peaks))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_ranges_end_where_they_say_and_read_as_written() {
        let linear = spaced(0.1, 2.0, 20, SpacingRaw::Linear).unwrap();
        assert_eq!((linear[0], linear[2], linear[19]), (0.1, 0.3, 2.0));
        let log = spaced(0.01, 1.0, 3, SpacingRaw::Logarithmic).unwrap();
        assert_eq!(log, [0.01, 0.1, 1.0]);
        assert!(spaced(1.0, 1.0, 3, SpacingRaw::Linear).is_none());
        assert!(spaced(0.0, 1.0, 3, SpacingRaw::Logarithmic).is_none());
        assert!(spaced(0.0, 1.0, 1, SpacingRaw::Linear).is_none());
    }
}
