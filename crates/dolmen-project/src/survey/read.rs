//! Reads surveys.

use super::file::{
    ChangeRaw, ChannelRaw, EarthquakeRaw, MergeRaw, ModeKindRaw, ModeRaw, ShapeRaw, SurveyRaw,
};
use super::part::{ChangePart, EarthquakePart, Merge, ModeKind, Survey, SurveyMode, TemperaturePart, Tilt};
use super::read_inspections::inspections;
use super::read_records::records;
use super::records::RecordSource;
use super::watch::date_of;
use crate::error::Fault;
use crate::file_number::{At, NumberRaw};
use crate::measure::{Bound, Measure};
use crate::quantity::Evidence;
use crate::reader::Reader;
use crate::report::PartNames;
use crate::units::tilt_ratio;
use crate::written::short;
use crate::wrong::{Common, WrongSurvey};
use dolmen::structure::ShapePoint;
use dolmen::structure::building::Twist;
use std::collections::BTreeMap;

/// Air temperatures of surveys, °C, our choice: a wider range than at any heritage.
const TEMPERATURE_C: (f64, f64) = (-60.0, 60.0);

/// Largest relative change of a frequency, our choice: no structure stands with a larger loss.
const CHANGED_MOST: f64 = 0.9;

/// Largest tilt of a standing monument in a survey, our choice: Pisa before its repair had 1/10.
const TILT_MOST: f64 = 0.25;
/// Largest twist of a mode along x or y: a floor with more twist beside its sway is in torsion. Our choice.
const TWIST_MOST: f64 = 2.0;

/// All surveys: those with a date in its order, at whatever places the file lists them; one without a date keeps its place among them.
pub(crate) fn surveys(reader: &mut Reader, raw: Option<&BTreeMap<String, At<SurveyRaw>>>) -> Vec<Survey> {
    let mut listed: Vec<(&String, &At<SurveyRaw>)> = raw.into_iter().flatten().collect();
    listed.sort_by_key(|(_, survey)| survey.span.start);
    let read = listed
        .into_iter()
        .map(|(name, survey)| self::survey(reader, name, survey));
    in_order_of_dates(read.collect())
}

/// Surveys whose names begin with a date, sorted by it and then by name; the others keep their places.
fn in_order_of_dates(surveys: Vec<Survey>) -> Vec<Survey> {
    let is_dated: Vec<bool> = surveys
        .iter()
        .map(|survey| date_of(&survey.name).is_some())
        .collect();
    let (mut dated, undated): (Vec<Survey>, Vec<Survey>) = surveys
        .into_iter()
        .partition(|survey| date_of(&survey.name).is_some());
    dated.sort_by(|a, b| (date_of(&a.name), &a.name).cmp(&(date_of(&b.name), &b.name)));
    let (mut dated, mut undated) = (dated.into_iter(), undated.into_iter());
    let each = is_dated.into_iter().filter_map(|is_dated| match is_dated {
        true => dated.next(),
        false => undated.next(),
    });
    each.collect()
}

/// Adds the findings of inspections to surveys that were read: their parts are those of the structure.
pub(crate) fn add_inspections(
    reader: &mut Reader,
    raw: Option<&BTreeMap<String, At<SurveyRaw>>>,
    surveys: &mut [Survey],
    parts: &PartNames,
) {
    for survey in surveys {
        let raw = raw.and_then(|all| all.get(&survey.name)).map(|raw| &raw.value);
        let path = format!("survey.{}.inspections", survey.name);
        survey.inspections = inspections(reader, raw.and_then(|raw| raw.inspections.as_ref()), &path, parts);
    }
}

fn survey(reader: &mut Reader, name: &str, raw: &At<SurveyRaw>) -> Survey {
    let path = format!("survey.{name}");
    reader.mark(&path, &raw.span);
    let raw = &raw.value;
    let mut modes: BTreeMap<String, Vec<SurveyMode>> = BTreeMap::new();
    for (direction, frequencies) in raw.frequencies.iter().flatten() {
        let listed = modes.entry(direction.clone()).or_default();
        for (i, frequency) in frequencies.iter().enumerate() {
            let path = format!("{path}.frequencies.{direction}[{}]", i + 1);
            if let Some(frequency) =
                reader.quantity(Some(frequency), &path, Measure::Frequency, Bound::Positive)
            {
                listed.push(SurveyMode {
                    frequency,
                    damping_ratio: None,
                    shape: Vec::new(),
                    kind: ModeKind::Translation,
                    twist: None,
                    sideways: None,
                });
            }
        }
    }
    for (direction, given) in raw.modes.iter().flatten() {
        if modes.get(direction).is_some_and(|listed| !listed.is_empty()) {
            let span = given.first().map_or(0..0, |mode| mode.span.clone());
            let path = format!("{path}.modes.{direction}");
            let fault = Fault::new(
                span,
                &path,
                WrongSurvey::AndFrequenciesAreBoth {
                    path: path.to_string(),
                    direction: direction.to_string(),
                },
            );
            reader.fault(fault.help(WrongSurvey::KeepModesEachMode));
            continue;
        }
        let listed = modes.entry(direction.clone()).or_default();
        for (i, raw) in given.iter().enumerate() {
            listed.extend(mode(reader, raw, &format!("{path}.modes.{direction}[{}]", i + 1)));
        }
    }
    for listed in modes.values() {
        ascending(reader, listed);
    }
    let is_made_up = raw.made_up.as_ref().is_some_and(|given| given.value);
    if is_made_up {
        modes.values_mut().flatten().for_each(assume);
    }
    let mut tilt = BTreeMap::new();
    for (direction, raw) in raw.tilt.iter().flatten() {
        if let Some(read) = self::tilt(reader, raw, &format!("{path}.tilt.{direction}")) {
            tilt.insert(direction.clone(), read);
        }
    }
    let setups = setups(reader, raw, &path);
    let (coldest, hottest) = TEMPERATURE_C;
    Survey {
        name: name.to_owned(),
        note: raw.note.clone(),
        source: raw.source.clone(),
        is_made_up,
        temperature_c: reader.within(
            raw.temperature_c.as_ref(),
            &format!("{path}.temperature_c"),
            coldest,
            hottest,
        ),
        datum: raw.datum.clone(),
        tilt,
        modes,
        records: raw
            .records
            .as_ref()
            .and_then(|raw| records(reader, raw, &format!("{path}.records"))),
        setups,
        merge: merge(reader, raw, &path),
        inspections: Vec::new(), // read when the parts are known
        earthquake: raw
            .earthquake
            .as_ref()
            .map(|raw| earthquake(reader, &raw.value, &format!("{path}.earthquake"))),
    }
}

/// Marks a mode as not measured.
fn assume(mode: &mut SurveyMode) {
    let frequency = &mut mode.frequency;
    frequency.source = Some(Evidence::Assumed);
    frequency.cov_source = frequency.cov.map(|_| Evidence::Assumed);
    if let Some(damping) = &mut mode.damping_ratio {
        damping.source = Some(Evidence::Assumed);
    }
}

fn earthquake(reader: &mut Reader, raw: &EarthquakeRaw, path: &str) -> EarthquakePart {
    let peak = reader.quantity(
        raw.peak.as_ref(),
        &format!("{path}.peak"),
        Measure::GroundAcceleration,
        Bound::Positive,
    );
    EarthquakePart {
        peak_m_s2: peak.map(|peak| peak.value),
        is_at_least: raw.at_least.as_ref().is_some_and(|of| of.value),
        changed: reader.within(
            raw.changed.as_ref(),
            &format!("{path}.changed"),
            -CHANGED_MOST,
            CHANGED_MOST,
        ),
        changed_sd: reader.within(
            raw.changed_sd.as_ref(),
            &format!("{path}.changed_sd"),
            0.0,
            CHANGED_MOST,
        ),
    }
}

fn merge(reader: &mut Reader, raw: &SurveyRaw, path: &str) -> Merge {
    let Some(given) = &raw.merge else {
        return Merge::default();
    };
    if raw.setups.as_ref().is_none_or(Vec::is_empty) {
        let path = format!("{path}.merge");
        let fault = Fault::new(
            given.span.clone(),
            &path,
            WrongSurvey::HasNoSetupsTo(path.to_string()),
        );
        reader.fault(fault.help(WrongSurvey::LeaveMergeOutOr));
    }
    match given.value {
        MergeRaw::Poser => Merge::Poser,
        MergeRaw::Preger => Merge::Preger,
    }
}

/// Several records of one survey: two or more, each sensor with a name or a place that shows which ones stayed.
fn setups(reader: &mut Reader, raw: &SurveyRaw, path: &str) -> Vec<RecordSource> {
    let path = format!("{path}.setups");
    let listed = raw.setups.as_deref().unwrap_or_default();
    if let (Some(records), Some(_)) = (&raw.records, listed.first()) {
        let message = WrongSurvey::AndRecordsAreBoth(path.to_string());
        let fault = Fault::new(records.span.clone(), &path, message);
        reader.fault(fault.help(WrongSurvey::KeepSetupsForSeveral));
    }
    if let [one] = listed {
        let fault = Fault::new(
            one.span.clone(),
            &path,
            WrongSurvey::HoldsOneRecord(path.to_string()),
        );
        reader.fault(
            fault
                .allowed(WrongSurvey::NeedsTwoOrMore)
                .help(WrongSurvey::WriteOneRecordAs),
        );
    }
    for (i, setup) in listed.iter().enumerate() {
        let stations = setup.value.stations.iter().flatten();
        let of_stations = stations.flat_map(|station| station.value.channels.iter().flatten());
        let channels: Vec<&At<ChannelRaw>> =
            setup.value.channels.iter().flatten().chain(of_stations).collect();
        let known = |c: &ChannelRaw| c.name.is_some() || (c.position.is_some() && c.direction.is_some());
        if channels.is_empty() || !channels.iter().all(|c| known(&c.value)) {
            let path = format!("{path}[{}].channels", i + 1);
            let message = WrongSurvey::DoNotTellWhich(path.to_string());
            let fault = Fault::new(setup.span.clone(), &path, message);
            reader.fault(
                fault
                    .allowed(WrongSurvey::EachNeedsNameOr)
                    .help(WrongSurvey::SensorThatStayedHas),
            );
        }
    }
    let numbered = listed.iter().enumerate();
    numbered
        .filter_map(|(i, raw)| records(reader, raw, &format!("{path}[{}]", i + 1)))
        .collect()
}

/// Settings for the comparison of two surveys.
pub(crate) fn change(reader: &mut Reader, raw: Option<&At<ChangeRaw>>) -> ChangePart {
    const COEFFICIENT_MOST: f64 = 0.05; // relative per °C, as the comparison allows
    let Some(At { value: raw, .. }) = raw else {
        return ChangePart::default();
    };
    let per_c = raw.temperature_coefficient_per_c.as_ref();
    let sd_per_c = raw.temperature_coefficient_sd_per_c.as_ref();
    let key = "change.temperature_coefficient_per_c";
    let sd_key = "change.temperature_coefficient_sd_per_c";
    let read_per_c = reader.within(per_c, key, -COEFFICIENT_MOST, COEFFICIENT_MOST);
    let read_sd = reader.within(sd_per_c, sd_key, 0.0, COEFFICIENT_MOST);
    if let (Some(given), Some(_)) = (per_c.or(sd_per_c), &raw.temperature) {
        let message = WrongSurvey::ChangeTemperatureFittedAnd;
        let fault = Fault::new(given.span.clone(), key, message);
        reader.fault(fault.help(Common::KeepOneOfThem));
    } else if let (Some(given), None) | (None, Some(given)) = (per_c, sd_per_c) {
        let (has, lacks) = if per_c.is_some() {
            (key, sd_key)
        } else {
            (sd_key, key)
        };
        let fault = Fault::new(
            given.span.clone(),
            lacks,
            WrongSurvey::StandsWithout {
                has: has.to_string(),
                lacks: lacks.to_string(),
            },
        );
        reader.fault(
            fault
                .allowed(WrongSurvey::NeedsBoth)
                .help(WrongSurvey::CoefficientOfTemperatureIs),
        );
    }
    ChangePart {
        temperature: match (&raw.temperature, read_per_c, read_sd) {
            (Some(_), ..) => TemperaturePart::Fitted,
            (None, Some(per_c), Some(sd_per_c)) => TemperaturePart::Coefficient { per_c, sd_per_c },
            _ => TemperaturePart::Unknown,
        },
        frequency_within: reader.within(
            raw.frequency_within.as_ref(),
            "change.frequency_within",
            0.001,
            0.6,
        ),
    }
}

/// Translation modes of a direction are numbered by their order: frequencies must rise.
fn ascending(reader: &mut Reader, listed: &[SurveyMode]) {
    let translation: Vec<&SurveyMode> = listed
        .iter()
        .filter(|mode| mode.kind == ModeKind::Translation)
        .collect();
    for pair in translation.windows(2) {
        let [before, after] = pair else { continue };
        if after.frequency.value <= before.frequency.value {
            let path = &after.frequency.path;
            let message = WrongSurvey::DoesNotLieAbove {
                path: path.to_string(),
                written: after.frequency.written.to_string(),
            };
            let fault = Fault::new(reader.place(path), path, message);
            reader.fault(
                fault
                    .allowed(WrongSurvey::MustBeAbove(before.frequency.written.to_string()))
                    .help(WrongSurvey::ListModesOfDirection),
            );
        }
    }
}

fn mode(reader: &mut Reader, raw: &At<ModeRaw>, path: &str) -> Option<SurveyMode> {
    let raw = &raw.value;
    let frequency_path = format!("{path}.frequency");
    let frequency = reader.quantity(
        raw.frequency.as_ref(),
        &frequency_path,
        Measure::Frequency,
        Bound::Positive,
    );
    let damping_path = format!("{path}.damping_ratio");
    let damping_ratio = reader.quantity(
        raw.damping_ratio.as_ref(),
        &damping_path,
        Measure::Ratio,
        Bound::NotNegative,
    );
    let points = raw.shape.iter().flatten().enumerate();
    let shape: Vec<ShapePoint> = points
        .filter_map(|(i, raw)| shape_point(reader, raw, &format!("{path}.shape[{}]", i + 1)))
        .collect();
    if !shape.is_empty() && shape.iter().all(|point| point.displacement == 0.0) {
        let span = raw
            .shape
            .iter()
            .flatten()
            .next()
            .map_or(0..0, |point| point.span.clone());
        let path = format!("{path}.shape");
        let fault = Fault::new(span, &path, WrongSurvey::DoesNotMoveAt(path.to_string()));
        reader.fault(fault.allowed(WrongSurvey::AtLeastOneDisplacement));
    }
    let twist = twist(reader, raw, path);
    let sideways = sideways(reader, raw, path);
    Some(SurveyMode {
        frequency: frequency?,
        damping_ratio,
        shape,
        kind: match raw.kind {
            None | Some(ModeKindRaw::Translation) => ModeKind::Translation,
            Some(ModeKindRaw::Torsion) => ModeKind::Torsion,
        },
        twist,
        sideways,
    })
}

/// Motion of the floor across the direction of the mode over that along it; useful together with a twist.
fn sideways(reader: &mut Reader, raw: &ModeRaw, path: &str) -> Option<f64> {
    let path = format!("{path}.sideways");
    let given = raw.sideways.as_ref()?;
    if raw.twist.is_none() {
        let fault = Fault::new(
            given.span.clone(),
            &path,
            WrongSurvey::StandsWithout {
                has: path.clone(),
                lacks: "twist".to_owned(),
            },
        );
        reader.fault(fault.help(WrongSurvey::GiveTwistToo));
        return None;
    }
    reader.within(Some(given), &path, -TWIST_MOST, TWIST_MOST)
}

/// Rotation of the floor, with its deviation.
fn twist(reader: &mut Reader, raw: &ModeRaw, path: &str) -> Option<Twist> {
    let (path, sd_path) = (format!("{path}.twist"), format!("{path}.twist_sd"));
    let Some(given) = &raw.twist else {
        if let Some(sd) = &raw.twist_sd {
            let fault = Fault::new(
                sd.span.clone(),
                &sd_path,
                format!("{sd_path} stands without twist"),
            );
            reader.fault(fault.help("give twist, 0 for a floor that does not turn"));
        }
        return None;
    };
    if let Some(ModeKindRaw::Torsion) = raw.kind {
        let fault = Fault::new(
            given.span.clone(),
            &path,
            format!("{path} is of a mode of torsion"),
        );
        reader.fault(
            fault.help("twist belongs to the modes along x and y: how much the floor turns beside its sway"),
        );
        return None;
    }
    let most = TWIST_MOST;
    let ratio = reader.within(Some(given), &path, -most, most)?;
    let sd = reader.within(raw.twist_sd.as_ref(), &sd_path, 0.0, most);
    Some(Twist {
        ratio,
        sd: sd.unwrap_or(0.0),
    })
}

fn shape_point(reader: &mut Reader, raw: &At<ShapeRaw>, path: &str) -> Option<ShapePoint> {
    let raw = &raw.value;
    let height_path = format!("{path}.height");
    let height = reader.quantity(
        raw.height.as_ref(),
        &height_path,
        Measure::Length,
        Bound::NotNegative,
    );
    let mut finite = |number: Option<&At<f64>>, key: &str, bound| {
        let number = number?;
        let path = format!("{path}.{key}");
        reader.bounded(number.value, &short(number.value), &number.span, &path, bound)?;
        Some(number.value)
    };
    let displacement = finite(raw.displacement.as_ref(), "displacement", Bound::Any);
    let sd = finite(raw.sd.as_ref(), "sd", Bound::NotNegative);
    Some(ShapePoint {
        height_m: height?.value,
        displacement: displacement?,
        displacement_sd: sd.unwrap_or(0.0),
    })
}

/// "1/177", 0.0056, "0.3 deg", "5 mm/m".
fn tilt(reader: &mut Reader, raw: &At<NumberRaw>, path: &str) -> Option<Tilt> {
    let (ratio, written) = match &raw.value {
        NumberRaw::Number(ratio) => (Some(*ratio), short(*ratio)),
        NumberRaw::Text(text) => (tilt_ratio(text), text.trim().to_owned()),
    };
    reader.mark(path, &raw.span);
    let fault = |message: WrongSurvey| Fault::new(raw.span.clone(), path, message);
    match ratio {
        Some(ratio) if ratio.abs() <= TILT_MOST => Some(Tilt { ratio, written }),
        Some(_) => {
            let fault = fault(WrongSurvey::WouldHaveFallen {
                path: path.to_string(),
                written: written.to_string(),
            });
            reader.fault(
                fault
                    .allowed(WrongSurvey::MustBeWithin(TILT_MOST.to_string()))
                    .help(WrongSurvey::TiltIsHorizontalVertical),
            );
            None
        }
        None => {
            let fault = fault(WrongSurvey::IsNotTilt {
                path: path.to_string(),
                written: written.to_string(),
            });
            reader.fault(fault.allowed(Common::MustBeTilt));
            None
        }
    }
}
