//! Studies from what is written. Values of inputs are kept as text: each run lays them over the file and reads it again.

use super::combine::keys;
use super::error::Fault;
use super::file_number::{At, NumberRaw};
use super::file_study::{ExpectedRaw, LawRaw, RangeRaw, SeriesRaw, SpacingRaw, StudyRaw, TreeRaw, TrendRaw};
use super::measure::{Bound, Measure};
use super::reader::{Reader, names, short};
use super::study::{ArtificialPart, Axis, ExpectedTrend, HarmonicPart, LawPart, Override, Scan, StudyPart};
use super::units::split_number;
use dolmen::assess::Direction;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use std::collections::BTreeMap;
use std::ops::Range;
use toml::de::DeValue;

/// Most values of one list or range, of samples, of motions that are made, of halvings.
const VALUES_MOST: usize = 10_000;
const SAMPLES_MOST: usize = 1_000_000;
const MADE_MOST: usize = 1000;
const HALVINGS_MOST: usize = 20;
/// Halvings of the bracket of the first fall if nothing else is said. Chosen here: an eighth of a step of the scan.
const HALVINGS: u32 = 3;
/// Largest peak of the ground that is scanned, m/s²: four times the largest recorded. Chosen here.
const PEAK_MOST_M_S2: f64 = 10.0 * STANDARD_GRAVITY_M_S2;
/// Longest time, s.
const TIME_MOST_S: f64 = 1e4;
/// Contact points that a joint can have.
const POINTS: [i64; 4] = [4, 9, 16, 36];

/// The studies in the order of the file.
pub(super) fn studies(
    reader: &mut Reader,
    text: &str,
    raw: Option<&BTreeMap<String, At<StudyRaw>>>,
) -> Vec<StudyPart> {
    let mut listed: Vec<_> = raw.into_iter().flatten().collect();
    listed.sort_by_key(|(_, raw)| raw.span.start);
    let each = listed
        .into_iter()
        .filter_map(|(name, raw)| study(reader, text, name, raw));
    each.collect()
}

fn study(reader: &mut Reader, text: &str, name: &str, raw: &At<StudyRaw>) -> Option<StudyPart> {
    let path = format!("study.{name}");
    reader.mark(&path, &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let below = |key: &str| format!("{path}.{key}");
    let set = leaves(reader, given.set.as_ref(), &below("set"));
    let vary = leaves(reader, given.vary.as_ref(), &below("vary"));
    let set: Vec<Override> = set.iter().map(|leaf| leaf.value(text)).collect();
    let vary: Vec<Axis> = vary
        .iter()
        .filter_map(|leaf| axis(reader, text, &below("vary"), leaf))
        .collect();
    for axis in &vary {
        once(
            reader,
            &below(&format!("vary.{}", axis.path)),
            axis.values.iter().map(|value| (value.text.as_str(), &value.span)),
        );
    }
    let named = set.iter().map(|set| (&set.path, &set.span));
    let named = named.chain(
        vary.iter()
            .filter_map(|axis| Some((&axis.path, &axis.values.first()?.span))),
    );
    once(
        reader,
        &format!("{path}: set and vary"),
        named.map(|(path, span)| (path.as_str(), span)),
    );
    for (key, list) in [("motions", &given.motions), ("variants", &given.variants)] {
        let items = list.iter().flat_map(|list| &list.value);
        once(
            reader,
            &below(key),
            items.map(|item| (item.value.as_str(), &item.span)),
        );
    }
    let turns = given.directions.iter().flat_map(|list| &list.value);
    once(
        reader,
        &below("directions"),
        turns.map(|turn| (text.get(turn.span.clone()).unwrap_or_default(), &turn.span)),
    );
    let texts = |list: &Option<At<Vec<At<String>>>>| -> Vec<String> {
        let list = list.iter().flat_map(|list| &list.value);
        list.map(|item| item.value.clone()).collect()
    };
    let samples = reader.count(given.samples.as_ref(), &below("samples"), 1, SAMPLES_MOST);
    let seed = seed(reader, given.seed.as_ref(), &below("seed"));
    let artificial = given.artificial.as_ref().and_then(|raw| {
        let path = below("artificial");
        let given = &raw.value;
        let mut time = |value: &Option<At<f64>>, key: &str, default: f64| {
            let found = reader.within(value.as_ref(), &format!("{path}.{key}"), 0.1, TIME_MOST_S);
            found.unwrap_or(default)
        };
        let duration_s = time(&given.duration_s, "duration_s", 20.0);
        let rise_s = time(&given.rise_s, "rise_s", 2.0);
        let strong_s = time(&given.strong_s, "strong_s", 8.0);
        Some(ArtificialPart {
            seed: self::seed(reader, given.seed.as_ref(), &format!("{path}.seed")),
            count: reader.count(given.count.as_ref(), &format!("{path}.count"), 1, MADE_MOST)?,
            duration_s,
            rise_s,
            strong_s,
        })
    });
    let mut turns_rad = Vec::new();
    for (i, turn) in given.directions.iter().flat_map(|list| &list.value).enumerate() {
        let path = format!("{path}.directions[{}]", i + 1);
        turns_rad.extend(reader.plain(Some(turn), &path, Measure::Angle, Bound::Any));
    }
    if turns_rad.is_empty() {
        turns_rad.push(0.0);
    }
    let scan = scan(reader, given, &path);
    let harmonic = given.harmonic.as_ref().and_then(|raw| {
        let path = below("harmonic");
        let mut of = |series: &Option<At<SeriesRaw>>, key: &str, measure| {
            self::series(reader, series.as_ref(), &format!("{path}.{key}"), measure)
        };
        let frequencies_hz = of(&raw.value.frequency, "frequency", Measure::Frequency);
        let accelerations_m_s2 = of(
            &raw.value.acceleration,
            "acceleration",
            Measure::GroundAcceleration,
        );
        Some(HarmonicPart {
            frequencies_hz: frequencies_hz?,
            accelerations_m_s2: accelerations_m_s2?,
        })
    });
    let release_m = reader.plain(
        given.release.as_ref(),
        &below("release"),
        Measure::Length,
        Bound::Positive,
    );
    let refine = reader.count(given.refine.as_ref(), &below("refine"), 0, HALVINGS_MOST);
    let points = points(reader, given.points.as_ref(), &below("points"));
    let rest_s = reader.within(given.rest_s.as_ref(), &below("rest_s"), 0.0, TIME_MOST_S);
    let expect = expected(reader, given.expect.as_deref(), &vary, &path);
    (reader.faults.len() == before).then_some(())?;
    Some(StudyPart {
        name: name.to_owned(),
        title: given.title.as_ref().map(|title| names(title.clone())),
        set,
        vary,
        variants: texts(&given.variants),
        samples,
        seed,
        motions: texts(&given.motions),
        artificial,
        turns_rad,
        direction: given.direction.as_ref().map(|name| name.value.clone()),
        scan,
        refine: refine.and_then(|n| u32::try_from(n).ok()).unwrap_or(HALVINGS),
        law: match given.law.as_ref().map(|law| law.value) {
            Some(LawRaw::Rigid) => LawPart::Rigid,
            Some(LawRaw::Springs) | None => LawPart::Springs,
        },
        points,
        rest_s,
        expect,
        harmonic,
        release_m,
    })
}

/// Refuses what is written twice: it would count as more than it is.
fn once<'v>(reader: &mut Reader, path: &str, items: impl Iterator<Item = (&'v str, &'v Range<usize>)>) {
    let mut seen: Vec<&str> = Vec::new();
    for (item, span) in items {
        let item = item.trim_matches(['"', '\'', ' ']);
        if seen.contains(&item) {
            let fault = Fault::new(span.clone(), path, format!("{path} has {item} twice"));
            let fault = fault.allowed("must have each once");
            reader.fault(
                fault.help("leave one of them out: runs of the same count as more scans than there are"),
            );
            return;
        }
        seen.push(item);
    }
}

/// A value, list or range at the end of a path.
struct Leaf<'r> {
    path: String,
    tree: &'r TreeRaw,
    span: Range<usize>,
}

impl Leaf<'_> {
    fn value(&self, text: &str) -> Override {
        Override {
            path: self.path.clone(),
            text: text.get(self.span.clone()).unwrap_or_default().to_owned(),
            span: self.span.clone(),
        }
    }
}

/// The leaves of a tree in the order of the file.
fn leaves<'r>(reader: &mut Reader, tree: Option<&'r At<TreeRaw>>, place: &str) -> Vec<Leaf<'r>> {
    let mut found = Vec::new();
    if let Some(tree) = tree {
        flatten(&tree.value, &tree.span, "", &mut found);
    }
    found.sort_by_key(|leaf| leaf.span.start);
    for leaf in &found {
        if keys(&leaf.path).is_none() {
            let message = format!("{place}: \"{}\" is no path", leaf.path);
            let fault = Fault::new(leaf.span.clone(), place, message);
            reader.fault(fault.help("write it as \"joint.friction\" or \"links[2].weight\""));
        }
    }
    found
}

/// Paths may be written as one key, "joint.friction", or as tables: both end in the same leaves.
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

fn axis(reader: &mut Reader, text: &str, place: &str, leaf: &Leaf<'_>) -> Option<Axis> {
    let path = format!("{place}.{}", leaf.path);
    let at = |text: &str, span: &Range<usize>| Override {
        path: leaf.path.clone(),
        text: text.to_owned(),
        span: span.clone(),
    };
    let values: Vec<Override> =
        match leaf.tree {
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
                let fault = Fault::new(leaf.span.clone(), &path, format!("{path} is one value"));
                let fault = fault.allowed("must be a list or a range");
                reader.fault(fault.help(
                    "write [ … ] or { from = …, to = …, steps = … }; what all runs share stands in set",
                ));
                return None;
            }
        };
    if values.is_empty() || values.len() > VALUES_MOST {
        let message = format!("{path} has {} values", values.len());
        let fault = Fault::new(leaf.span.clone(), &path, message);
        reader.fault(fault.allowed(format!("must have 1 to {VALUES_MOST}")));
        return None;
    }
    Some(Axis {
        path: leaf.path.clone(),
        values,
    })
}

/// The values of { from, to, steps, spacing } as they would be written one by one.
fn written_range(
    reader: &mut Reader,
    text: &str,
    path: &str,
    span: &Range<usize>,
    table: &BTreeMap<String, At<TreeRaw>>,
) -> Option<Vec<String>> {
    let mut refuse = |message: String, help: &str| {
        reader.fault(Fault::new(span.clone(), path, message).help(help));
    };
    let known = ["from", "to", "steps", "spacing"];
    if let Some(other) = table.keys().find(|key| !known.contains(&key.as_str())) {
        refuse(
            format!("{path} has no key \"{other}\""),
            "write { from = …, to = …, steps = … } and, if wanted, spacing = \"logarithmic\"",
        );
        return None;
    }
    let written = |key: &str| text.get(table.get(key)?.span.clone());
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
            format!("{path} is no range"),
            "write { from = 3, to = 9, steps = 8 }, with units in quotes: from = \"0.1 g\"; spacing is \"linear\" or \"logarithmic\"",
        );
        return None;
    };
    if from.unit != to.unit {
        refuse(
            format!("{path} goes from {} to {}", written("from")?, written("to")?),
            "write both ends in the same unit",
        );
        return None;
    }
    let Some(values) = spaced(from.value, to.value, steps, spacing) else {
        refuse(
            format!(
                "{path} has {steps} steps from {} to {}",
                short(from.value),
                short(to.value)
            ),
            "take 2 to 10 000 steps between two different numbers, both above 0 if the spacing is logarithmic",
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

/// One end of a range as it is written.
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

/// Numbers from one to another, both ends exact; `None` if that cannot be.
fn spaced(from: f64, to: f64, steps: usize, spacing: SpacingRaw) -> Option<Vec<f64>> {
    let is_log = spacing == SpacingRaw::Logarithmic;
    let fits = from.is_finite() && to.is_finite() && from != to && (2..=VALUES_MOST).contains(&steps);
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

/// The number of 12 digits nearest to it: 0.3 and not 0.30000000000000004, whatever the mathematics library makes of a power.
fn as_written(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// Numbers in SI; `None` if there are none or one is wrong, which has then been reported.
fn series(
    reader: &mut Reader,
    raw: Option<&At<SeriesRaw>>,
    path: &str,
    measure: Measure,
) -> Option<Vec<f64>> {
    let raw = raw?;
    let before = reader.faults.len();
    let mut of =
        |number: &At<NumberRaw>, path: &str| reader.plain(Some(number), path, measure, Bound::Positive);
    let values: Option<Vec<f64>> = match &raw.value {
        SeriesRaw::List(list) => {
            let each = list.iter().enumerate();
            each.map(|(i, number)| of(number, &format!("{path}[{}]", i + 1)))
                .collect()
        }
        SeriesRaw::Range(range) => {
            let from = range.from.as_ref().and_then(|n| of(n, &format!("{path}.from")));
            let to = range.to.as_ref().and_then(|n| of(n, &format!("{path}.to")));
            from.zip(to).and_then(|ends| of_range(range, ends))
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
            format!("{path} does not rise from value to value"),
        );
        let fault = fault.allowed("must be rising");
        reader.fault(fault.help(
            "give each value once, the least first; a range needs from below to, and 2 to 10 000 steps",
        ));
        return None;
    }
    values
}

fn of_range(range: &RangeRaw, (from, to): (f64, f64)) -> Option<Vec<f64>> {
    let steps = usize::try_from(range.steps.as_ref()?.value).ok()?;
    spaced(from, to, steps, range.spacing.unwrap_or_default())
}

fn scan(reader: &mut Reader, given: &StudyRaw, path: &str) -> Option<Scan> {
    if let (Some(_), Some(peak)) = (&given.scale, &given.peak) {
        let fault = Fault::new(peak.span.clone(), path, format!("{path} has both scale and peak"));
        reader.fault(fault.help("keep one of them"));
        return None;
    }
    let scales = series(
        reader,
        given.scale.as_ref(),
        &format!("{path}.scale"),
        Measure::Ratio,
    );
    let peaks = series(
        reader,
        given.peak.as_ref(),
        &format!("{path}.peak"),
        Measure::GroundAcceleration,
    );
    if let (Some(most), Some(raw)) = (peaks.as_ref().and_then(|peaks| peaks.last()), &given.peak)
        && *most > PEAK_MOST_M_S2
    {
        let path = format!("{path}.peak");
        let message = format!("{path} goes up to {:.4} g", most / STANDARD_GRAVITY_M_S2);
        let fault = Fault::new(raw.span.clone(), &path, message).allowed("must be 10 g or below");
        reader.fault(fault.help("no ground moves like that: is the unit right?"));
        return None;
    }
    scales.map(Scan::Scales).or(peaks.map(Scan::Peaks))
}

fn seed(reader: &mut Reader, raw: Option<&At<i64>>, path: &str) -> u64 {
    let Some(raw) = raw else { return 1 };
    u64::try_from(raw.value).unwrap_or_else(|_| {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            format!("{path} = {} cannot be", raw.value),
        );
        reader.fault(fault.allowed("must be 0 or above"));
        1
    })
}

fn points(reader: &mut Reader, raw: Option<&At<i64>>, path: &str) -> u32 {
    match raw {
        Some(raw) if !POINTS.contains(&raw.value) => {
            let fault = Fault::new(
                raw.span.clone(),
                path,
                format!("{path} = {} is not known", raw.value),
            );
            reader.fault(fault.allowed("must be 4, 9, 16 or 36"));
            16
        }
        Some(raw) => u32::try_from(raw.value).unwrap_or(16),
        None => 16,
    }
}

fn expected(
    reader: &mut Reader,
    raw: Option<&[At<ExpectedRaw>]>,
    vary: &[Axis],
    path: &str,
) -> Vec<ExpectedTrend> {
    let mut found = Vec::new();
    for (i, raw) in raw.into_iter().flatten().enumerate() {
        let given = &raw.value;
        let (Some(input), Some(trend)) = (&given.input, &given.trend) else {
            continue; // reported: the schema requires both
        };
        if !vary.iter().any(|axis| axis.path == input.value) {
            let path = format!("{path}.expect[{}].input", i + 1);
            let known: Vec<&str> = vary.iter().map(|axis| axis.path.as_str()).collect();
            let message = format!("{path} = \"{}\" is not varied", input.value);
            let fault = Fault::new(input.span.clone(), &path, message);
            reader.fault(fault.help(format!("varied are {}", known.join(", "))));
            continue;
        }
        found.push(ExpectedTrend {
            input: input.value.clone(),
            direction: match trend.value {
                TrendRaw::Rising => Direction::Rising,
                TrendRaw::Falling => Direction::Falling,
            },
            words: given.words.as_ref().map(|words| names(words.clone())),
            source: given.source.clone(),
        });
    }
    found
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
