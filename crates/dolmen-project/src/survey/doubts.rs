//! Patterns over surveys that look like a slip: sensors far from the others, frequencies unlike those of other surveys, large tilts.

use super::part::{ModeKind, Survey, SurveyMode};
use super::records::{ChannelSource, RecordSource};
use super::watch::date_of;
use crate::doubted::Doubted;
use crate::reader::Reader;
use crate::report::is_day;
use crate::usual_numbers::{hertz, metres, ratio};
use crate::wrong::{WrongRecords, WrongSurvey};
use std::collections::BTreeMap;

/// Distance of a sensor from the middle of the others, m, beyond that on any structure. Our choice.
const AWAY_MOST_M: f64 = 500.0;
/// Air temperature at a structure, °C; higher ones were measured only in deserts.
const WARM_MOST_C: f64 = 45.0;
/// A tilt of 5.7°: towers near collapse lean by less.
const TILT_MOST: f64 = 0.1;
/// Ratio of a frequency to the median of the same mode in the other surveys, either way. Our choice: damage near collapse halves a frequency.
const UNLIKE: f64 = 1.9;
/// Fewest surveys that must agree with each other.
const SURVEYS_LEAST: usize = 3;
/// Samples a second of a vibration record, Hz.
const RATE_HZ: [f64; 2] = [5.0, 20_000.0];

pub(crate) fn doubt_surveys(reader: &mut Reader, surveys: &[Survey]) {
    let by_number = Numbered::of(surveys);
    for survey in surveys {
        date(reader, &survey.name);
        if let Some(temperature_c) = survey.temperature_c.filter(|of| *of > WARM_MOST_C) {
            let path = format!("survey.{}.temperature_c", survey.name);
            let given = ratio(temperature_c);
            reader.doubt(
                &path,
                Doubted::Warm {
                    path: path.clone(),
                    given,
                },
            );
        }
        for source in survey.records.iter().chain(&survey.setups) {
            let path = format!("survey.{}.records", survey.name);
            sensors(reader, source, &path);
            rate(reader, source, &path);
        }
        for (direction, tilt) in &survey.tilt {
            if tilt.ratio.abs() > TILT_MOST {
                let path = format!("survey.{}.tilt.{direction}", survey.name);
                let degrees = ratio(tilt.ratio.atan().to_degrees());
                let is_bare = tilt.written.parse::<f64>().is_ok();
                let doubted = match is_bare {
                    true => Doubted::LargeTilt {
                        path: path.clone(),
                        degrees,
                    },
                    false => Doubted::LargeTiltWritten {
                        path: path.clone(),
                        written: tilt.written.clone(),
                        degrees,
                    },
                };
                reader.doubt(&path, doubted);
            }
        }
        modes(reader, survey, (surveys, &by_number));
    }
}

/// The days, or the month, that six digits at the start of a name may mean: 250402 is 2 April 2025, or 25 April 2002.
fn of_six_digits(name: &str) -> Vec<String> {
    let digits = name.bytes().take_while(u8::is_ascii_digit).count();
    let pair = |at: usize| name.get(at..at + 2).and_then(|two| two.parse::<u32>().ok());
    let (Some(first), Some(second), Some(third), 6) = (pair(0), pair(2), pair(4), digits) else {
        return Vec::new();
    };
    let year = |two: u32| if two < 70 { 2000 + two } else { 1900 + two };
    let day = |year: u32, month: u32, day: u32| {
        let text = format!("{year:04}-{month:02}-{day:02}");
        is_day(&text).then_some(text)
    };
    let century = 100 * first + second;
    let month = (1900..=2100).contains(&century) && (1..=12).contains(&third);
    let mut found = Vec::new();
    found.extend(day(year(first), second, third));
    found.extend(month.then(|| format!("{century}-{third:02}")));
    found.extend(day(year(third), second, first));
    found.dedup();
    found
}

/// A name that looks like a date but is not a readable one.
fn date(reader: &mut Reader, name: &str) {
    let path = format!("survey.{name}");
    let bare = name.trim_start_matches(['\'', '’', '‘', '`', '´']);
    let readings = of_six_digits(bare);
    if !readings.is_empty() {
        let message = WrongSurvey::SixDigits(name.to_owned());
        return reader.slip(&path, message, WrongSurvey::WriteTheDay(readings));
    }
    let parts: Vec<&str> = bare.splitn(3, ['-', '.', '/']).map(str::trim).collect();
    let is_number = |text: &str, most: usize| {
        (1..=most).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit())
    };
    let starts_with_day = |text: &str| text.starts_with(|sign: char| sign.is_ascii_digit());
    // a winter, over two years: 2022-23
    let is_season = |one: &str, two: &str| {
        let numbers = one.parse::<u32>().ok().zip(two.parse::<u32>().ok());
        numbers.is_some_and(|(year, next)| (year + 1) % 100 == next)
    };
    let looks_like = match parts.as_slice() {
        [one, ..] if one.starts_with("YYYY") => true, // of a template
        [one] => {
            let year = one.split('년').next().unwrap_or_default();
            one.len() == 8 && is_number(one, 8) || year.len() < one.len() && is_number(year, 2)
        }
        [one, two] => {
            one.len() == 4 && is_number(one, 4) && two.len() == 2 && is_number(two, 2) && !is_season(one, two)
        }
        [one, two, rest] => one.len() > 1 && is_number(one, 4) && is_number(two, 2) && starts_with_day(rest),
        _ => false,
    };
    let is_read = date_of(name).is_some_and(|[year, month, day]| {
        let has_all = parts.len() == 2 || day > 0;
        let first = day.max(1); // a month alone has none
        (1900..=2100).contains(&year) && has_all && is_day(&format!("{year:04}-{month:02}-{first:02}"))
    });
    if looks_like && !is_read {
        let message = WrongSurvey::LooksLikeADate(name.to_owned());
        reader.slip(&path, message, WrongSurvey::WriteTheYearFirst);
    }
}

fn rate(reader: &mut Reader, source: &RecordSource, path: &str) {
    let path = format!("{path}.sampling_rate");
    if let Some(rate_hz) = source.sampling_rate_hz
        && !(RATE_HZ[0]..=RATE_HZ[1]).contains(&rate_hz)
    {
        let message = WrongRecords::IsHzButVibration {
            path: path.to_string(),
            rate_hz: rate_hz.to_string(),
            least: RATE_HZ[0].to_string(),
            most: RATE_HZ[1].to_string(),
        };
        let help = match rate_hz < RATE_HZ[0] {
            true => WrongRecords::IsItStepIn {
                step: rate_hz.to_string(),
                rate_hz: (1.0 / rate_hz).to_string(),
            },
            false => WrongRecords::IsItInHz,
        };
        reader.slip(&path, message, help);
    }
}

fn sensors(reader: &mut Reader, source: &RecordSource, path: &str) {
    let places: Vec<(&ChannelSource, [f64; 3])> = source
        .channels
        .iter()
        .filter_map(|channel| Some((channel, channel.position_m?)))
        .collect();
    for (at, (channel, place)) in places.iter().enumerate() {
        let median = |axis: usize| {
            let mut others: Vec<f64> = places
                .iter()
                .enumerate()
                .filter(|(i, _)| *i != at)
                .map(|(_, (_, of))| of[axis])
                .collect();
            others.sort_by(f64::total_cmp);
            others.get(others.len() / 2).copied().unwrap_or(0.0)
        };
        let from_others = (0..3)
            .map(|axis| (place[axis] - median(axis)).powi(2))
            .sum::<f64>()
            .sqrt();
        let from_origin = place.iter().map(|of| of * of).sum::<f64>().sqrt();
        if from_others > AWAY_MOST_M
            || (from_others == 0.0 || places.len() > 1) && from_origin > 10.0 * AWAY_MOST_M
        {
            let name = match (&channel.name, &channel.column) {
                (Some(name), _) | (None, super::records::Column::Name(name)) => name.clone(),
                (None, super::records::Column::Number(number)) => format!("ch{number}"),
            };
            let path = format!("{path}.channels {name}");
            let away = metres(from_others.max(from_origin));
            reader.doubt(
                &path,
                Doubted::SensorFar {
                    path: path.clone(),
                    away,
                },
            );
        }
    }
}

/// Relative difference within which a frequency of another survey is the same mode. Our choice.
const KNOWN_WITHIN: f64 = 0.1;

/// The translation modes of a direction, by number.
fn sways<'a>(survey: &'a Survey, direction: &str) -> impl Iterator<Item = &'a SurveyMode> {
    let modes = survey.modes.get(direction).into_iter().flatten();
    modes.filter(|mode| mode.kind == ModeKind::Translation)
}

/// The frequencies of all surveys by direction and number, rising, Hz.
struct Numbered<'a>(BTreeMap<&'a str, Vec<Vec<f64>>>);

impl<'a> Numbered<'a> {
    fn of(surveys: &'a [Survey]) -> Self {
        let mut by_direction: BTreeMap<&str, Vec<Vec<f64>>> = BTreeMap::new();
        for survey in surveys {
            for direction in survey.modes.keys() {
                let numbers = by_direction.entry(direction).or_default();
                for (number, mode) in sways(survey, direction).enumerate() {
                    if number == numbers.len() {
                        numbers.push(Vec::new());
                    }
                    numbers[number].push(mode.frequency.value);
                }
            }
        }
        let all = by_direction.values_mut().flatten();
        all.for_each(|of| of.sort_by(f64::total_cmp));
        Self(by_direction)
    }

    /// The median of the other surveys, if enough of them have the mode.
    fn usual_hz(&self, direction: &str, number: usize, own_hz: f64) -> Option<f64> {
        let all = &self.0[direction][number];
        let others = all.len() - 1;
        if others < SURVEYS_LEAST - 1 {
            return None;
        }
        let own = all.partition_point(|hz| hz.total_cmp(&own_hz).is_lt());
        let middle = others / 2;
        Some(all[middle + usize::from(middle >= own)])
    }
}

/// Compares the modes of a direction, by number, with those of the other surveys.
fn modes(reader: &mut Reader, survey: &Survey, (surveys, by_number): (&[Survey], &Numbered<'_>)) {
    for direction in survey.modes.keys() {
        for (number, mode) in sways(survey, direction).enumerate() {
            let own_hz = mode.frequency.value;
            let Some(usual) = by_number.usual_hz(direction, number, own_hz) else {
                continue;
            };
            if (1.0 / UNLIKE..=UNLIKE).contains(&(own_hz / usual)) {
                continue;
            }
            // a survey that misses a mode gives other numbers to the modes above it
            let is_near = |mode: &SurveyMode| (mode.frequency.value / own_hz - 1.0).abs() <= KNOWN_WITHIN;
            let others = surveys.iter().filter(|other| other.name != survey.name);
            let known = others.filter(|other| sways(other, direction).any(is_near));
            if known.count() < SURVEYS_LEAST - 1 {
                let path = &mode.frequency.path;
                let (measured, others) = (hertz(own_hz), hertz(usual));
                reader.doubt(
                    path,
                    Doubted::SurveysDiffer {
                        path: path.clone(),
                        measured,
                        others,
                    },
                );
            }
        }
    }
}
