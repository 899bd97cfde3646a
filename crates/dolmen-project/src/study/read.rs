//! Reads studies. Values of inputs stay text: each run merges them into the file and reads it again.

use super::after::after_motion;
use super::file::{
    ArtificialRaw, DamageRaw, ExpectedRaw, HarmonicRaw, LawRaw, SeriesRaw, StudyRaw, TrendRaw,
};
use super::part::{
    ArtificialPart, Axis, DRIFT_LIMITS, ExpectedTrend, HarmonicPart, LawPart, Override, StudyPart,
};
use super::values::{axis, leaves, scan, series};
use crate::error::Fault;
use crate::file_number::{At, NumberRaw};
use crate::measure::{Bound, Measure};
use crate::names::names;
use crate::reader::Reader;
use crate::wrong::{Common, WrongStudy};
use dolmen::assess::{DamageThresholds, Direction};
use dolmen_words::message::Both;
use std::collections::BTreeMap;
use std::ops::Range;

/// Most samples, artificial motions, and bisections.
const SAMPLES_MOST: usize = 1_000_000;
const MADE_MOST: usize = 1000;
const HALVINGS_MOST: usize = 20;
/// Default bisections for the first fall. Our choice: an eighth of a step of the scan.
const HALVINGS: u32 = 3;
/// Least threshold of a damage state, as a ratio: below it every stack is damaged. Our choice.
const RATIO_LEAST: f64 = 1e-4;
/// Largest limit of drift over the height of the storey: beyond it no structure is linear. Our choice.
const DRIFT_MOST: f64 = 0.1;
/// Longest time, s.
const TIME_MOST_S: f64 = 1e4;
/// Default periods of spectral accelerations, their range, s, and their largest number. Our choice.
const PERIODS_S: [f64; 4] = [0.2, 0.5, 1.0, 2.0];
const PERIOD_RANGE_S: [f64; 2] = [0.01, 20.0];
const PERIODS_MOST: usize = 20;
/// Default damping ratio of spectral accelerations, and the largest.
const SPECTRAL_DAMPING: f64 = 0.05;
const SPECTRAL_DAMPING_MOST: f64 = 0.5;
/// Allowed numbers of contact points of a joint.
const POINTS: [i64; 4] = [4, 9, 16, 36];

/// The studies in the order of the file.
pub(crate) fn studies(
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
    let mut vary: Vec<Axis> = vary
        .iter()
        .filter_map(|leaf| axis(reader, text, &below("vary"), leaf))
        .collect();
    all_once(reader, (text, given), &set, &vary, &path);
    let texts = |list: &Option<At<Vec<At<String>>>>| -> Vec<String> {
        let list = list.iter().flat_map(|list| &list.value);
        list.map(|item| item.value.clone()).collect()
    };
    let samples = reader.count(given.samples.as_ref(), &below("samples"), 1, SAMPLES_MOST);
    let seed = seed(reader, given.seed.as_ref(), &below("seed"));
    let artificial = given
        .artificial
        .as_ref()
        .and_then(|raw| artificial(reader, raw, &path));
    let turns_rad = turns_rad(reader, given, &path);
    let sizes = (given.scale.as_ref(), given.peak.as_ref());
    let scan = scan(reader, sizes, Bound::Positive, &path);
    let after = given.after.as_ref();
    let after = after.and_then(|raw| after_motion(reader, (raw, text), &mut vary, &path));
    let harmonic = given
        .harmonic
        .as_ref()
        .and_then(|raw| harmonic(reader, raw, &path));
    let release_m = reader.plain(
        given.release.as_ref(),
        &below("release"),
        Measure::Length,
        Bound::Positive,
    );
    let refine = reader.count(given.refine.as_ref(), &below("refine"), 0, HALVINGS_MOST);
    let points = points(reader, given.points.as_ref(), &below("points"));
    let rest_s = reader.within(given.rest_s.as_ref(), &below("rest_s"), 0.0, TIME_MOST_S);
    let spectral_periods_s = periods(
        reader,
        given.spectral_periods_s.as_ref(),
        &below("spectral_periods_s"),
    );
    let spectral_damping_ratio = reader.within(
        given.spectral_damping_ratio.as_ref(),
        &below("spectral_damping_ratio"),
        0.0,
        SPECTRAL_DAMPING_MOST,
    );
    let damage = given
        .damage
        .as_ref()
        .map(|raw| damage(reader, raw, &below("damage")));
    let drift_limits = drift_limits(reader, given.drift_limits.as_ref(), &below("drift_limits"));
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
        after,
        refine: refine.and_then(|n| u32::try_from(n).ok()).unwrap_or(HALVINGS),
        law: match given.law.as_ref().map(|law| law.value) {
            Some(LawRaw::Rigid) => LawPart::Rigid,
            Some(LawRaw::Springs) | None => LawPart::Springs,
        },
        points,
        rest_s,
        spectral_periods_s,
        spectral_damping_ratio: spectral_damping_ratio.unwrap_or(SPECTRAL_DAMPING),
        damage: damage.unwrap_or_default(),
        drift_limits,
        expect,
        harmonic,
        release_m,
    })
}

/// Rejects double entries of a study: values of an axis, inputs that are set and varied, motions, variants, directions.
fn all_once(
    reader: &mut Reader,
    (text, given): (&str, &StudyRaw),
    set: &[Override],
    vary: &[Axis],
    path: &str,
) {
    let below = |key: &str| format!("{path}.{key}");
    for axis in vary {
        once(
            reader,
            below(&format!("vary.{}", axis.path)).into(),
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
        WrongStudy::SetAndVary(path.to_string()).into(),
        named.map(|(path, span)| (path.as_str(), span)),
    );
    for (key, list) in [("motions", &given.motions), ("variants", &given.variants)] {
        let items = list.iter().flat_map(|list| &list.value);
        once(
            reader,
            below(key).into(),
            items.map(|item| (item.value.as_str(), &item.span)),
        );
    }
    for (i, variant) in given.variants.iter().flat_map(|list| &list.value).enumerate() {
        reader.mark(&format!("{path}.variants[{}]", i + 1), &variant.span);
    }
    let turns = given.directions.iter().flat_map(|list| &list.value);
    once(
        reader,
        below("directions").into(),
        turns.map(|turn| (text.get(turn.span.clone()).unwrap_or_default(), &turn.span)),
    );
}

/// Artificial motions: number of seeds, and duration.
fn artificial(reader: &mut Reader, raw: &At<ArtificialRaw>, path: &str) -> Option<ArtificialPart> {
    let path = format!("{path}.artificial");
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
}

/// Angles by which the ground motion is turned, rad; 0 if none is given.
fn turns_rad(reader: &mut Reader, given: &StudyRaw, path: &str) -> Vec<f64> {
    let mut turns_rad = Vec::new();
    for (i, turn) in given.directions.iter().flat_map(|list| &list.value).enumerate() {
        let path = format!("{path}.directions[{}]", i + 1);
        turns_rad.extend(reader.plain(Some(turn), &path, Measure::Angle, Bound::Any));
    }
    if turns_rad.is_empty() {
        turns_rad.push(0.0);
    }
    turns_rad
}

/// Frequencies and accelerations of a harmonic ground motion.
fn harmonic(reader: &mut Reader, raw: &At<HarmonicRaw>, path: &str) -> Option<HarmonicPart> {
    let path = format!("{path}.harmonic");
    let mut of = |series: &Option<At<SeriesRaw>>, key: &str, measure| {
        let path = format!("{path}.{key}");
        self::series(reader, series.as_ref(), &path, (measure, Bound::Positive))
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
}

/// Periods of spectral accelerations: the default if not given, none if the list is empty.
fn periods(reader: &mut Reader, raw: Option<&At<Vec<At<f64>>>>, path: &str) -> Vec<f64> {
    let Some(raw) = raw else {
        return PERIODS_S.to_vec();
    };
    if raw.value.len() > PERIODS_MOST {
        let message = WrongStudy::HasPeriods {
            path: path.to_string(),
            count: raw.value.len().to_string(),
        };
        let fault = Fault::new(raw.span.clone(), path, message);
        reader.fault(fault.allowed(WrongStudy::MustHaveAtMost(PERIODS_MOST.to_string())));
        return Vec::new();
    }
    let [least, most] = PERIOD_RANGE_S;
    let mut found: Vec<f64> = Vec::new();
    for (i, period) in raw.value.iter().enumerate() {
        let path = format!("{path}[{}]", i + 1);
        found.extend(reader.within(Some(period), &path, least, most));
    }
    found.sort_by(f64::total_cmp);
    found.dedup();
    found
}

/// Thresholds of damage states, with defaults.
fn damage(reader: &mut Reader, raw: &At<DamageRaw>, path: &str) -> DamageThresholds {
    let (given, usual) = (&raw.value, DamageThresholds::default());
    let mut length = |value: &Option<At<NumberRaw>>, key: &str, usual: f64| {
        let path = format!("{path}.{key}");
        let found = reader.plain(value.as_ref(), &path, Measure::Length, Bound::Positive);
        found.unwrap_or(usual)
    };
    let slip_begun_m = length(&given.slip_begun, "slip_begun", usual.slip_begun_m);
    let offset_m = length(&given.offset, "offset", usual.offset_m);
    let mut ratio = |value: &Option<At<f64>>, key: &str, usual: f64| {
        let found = reader.within(value.as_ref(), &format!("{path}.{key}"), RATIO_LEAST, 1.0);
        found.unwrap_or(usual)
    };
    let found = DamageThresholds {
        slip_begun_m,
        offset_m,
        offset_ratio: ratio(&given.offset_ratio, "offset_ratio", usual.offset_ratio),
        severe_offset_ratio: ratio(
            &given.severe_offset_ratio,
            "severe_offset_ratio",
            usual.severe_offset_ratio,
        ),
        severe_rocking_ratio: ratio(
            &given.severe_rocking_ratio,
            "severe_rocking_ratio",
            usual.severe_rocking_ratio,
        ),
    };
    if found.severe_offset_ratio < found.offset_ratio {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            WrongStudy::SevereOffsetRatioIs {
                path: path.to_string(),
                severe_offset_ratio: found.severe_offset_ratio.to_string(),
                offset_ratio: found.offset_ratio.to_string(),
            },
        );
        reader.fault(fault.help(WrongStudy::Ds3IsWorseThan));
    }
    found
}

/// Four rising drifts over the height of the storey.
fn drift_limits(reader: &mut Reader, raw: Option<&At<Vec<At<f64>>>>, path: &str) -> [f64; 4] {
    let Some(raw) = raw else { return DRIFT_LIMITS };
    let values: Vec<f64> = raw.value.iter().map(|value| value.value).collect();
    let rises = values.windows(2).all(|pair| pair[1] > pair[0]);
    let in_range = values
        .iter()
        .all(|value| (RATIO_LEAST..=DRIFT_MOST).contains(value));
    match <[f64; 4]>::try_from(values.as_slice()) {
        Ok(limits) if rises && in_range => limits,
        _ => {
            let words: Vec<String> = values.iter().map(f64::to_string).collect();
            let message = WrongStudy::AreNoLimits {
                path: path.to_string(),
                words: words.join(", "),
            };
            let fault = Fault::new(raw.span.clone(), path, message);
            let fault = fault.allowed(WrongStudy::MustBeRisingTo {
                least: RATIO_LEAST.to_string(),
                most: DRIFT_MOST.to_string(),
            });
            reader.fault(fault.help(WrongStudy::DriftsOverHeightOf));
            DRIFT_LIMITS
        }
    }
}

/// Rejects a value listed twice: it would count twice.
fn once<'v>(reader: &mut Reader, list: Both, items: impl Iterator<Item = (&'v str, &'v Range<usize>)>) {
    let mut seen: Vec<&str> = Vec::new();
    for (item, span) in items {
        let item = item.trim_matches(['"', '\'', ' ']);
        if seen.contains(&item) {
            let fault = Fault::new(
                span.clone(),
                &list.english,
                WrongStudy::HasTwice {
                    path: list.clone(),
                    item: item.to_string(),
                },
            );
            let fault = fault.allowed(WrongStudy::MustHaveEachOnce);
            reader.fault(fault.help(WrongStudy::LeaveOneOfThem));
            return;
        }
        seen.push(item);
    }
}

fn seed(reader: &mut Reader, raw: Option<&At<i64>>, path: &str) -> u64 {
    let Some(raw) = raw else { return 1 };
    u64::try_from(raw.value).unwrap_or_else(|_| {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            WrongStudy::CannotBe {
                path: path.to_string(),
                given: raw.value.to_string(),
            },
        );
        reader.fault(fault.allowed(Common::ZeroOrMore));
        1
    })
}

fn points(reader: &mut Reader, raw: Option<&At<i64>>, path: &str) -> u32 {
    match raw {
        Some(raw) if !POINTS.contains(&raw.value) => {
            let fault = Fault::new(
                raw.span.clone(),
                path,
                WrongStudy::IsNotKnown {
                    path: path.to_string(),
                    given: raw.value.to_string(),
                },
            );
            reader.fault(fault.allowed(WrongStudy::MustBeOr));
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
            let message = WrongStudy::IsNotVaried {
                path: path.to_string(),
                input: input.value.to_string(),
            };
            let fault = Fault::new(input.span.clone(), &path, message);
            reader.fault(fault.help(WrongStudy::VariedAre(known.join(", "))));
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
