//! `dolmen motion --suite`: chooses and scales records of a folder so that their mean spectrum follows a demand.

use super::demand::{Demand, demand, range};
use super::error::MotionRequestError;
use super::prepare::{changed_alone, motion_options};
use super::request::MotionRequest;
use crate::error::{Within as _, WorkError};
use crate::told::told_both;
use dolmen::signal::{
    Component, GroundMotion, MatchedMotion, SpectralOrdinate, SpectrumMatch, SpectrumMisfit, SuiteCandidate,
    SuiteRule, is_same_shaking, match_spectrum, motion_suite, response_spectrum,
};
use dolmen_records::motions::{ComponentReading, MotionError, Orientation, Origin, origin, read_channels};
use dolmen_records::{Files, MOTION_BYTES_MOST};
use dolmen_words::message::Both;
use std::collections::BTreeSet;

/// Number of periods at which the mean spectrum is compared with the demand, evenly spaced in their logarithm; as for matching.
const PERIODS: usize = 150;
/// Longest name of a member. Our choice.
const NAME_MOST: usize = 40;

/// Options of a suite.
#[derive(Clone, Debug, PartialEq)]
pub struct SuiteOptions {
    /// How to read the files, and the changes to each record before scaling.
    pub request: MotionRequest,
    /// The demand.
    pub demand: Demand,
    /// The periods of the comparison, s.
    pub range_s: [f64; 2],
    /// Damping ratio of the spectra.
    pub damping_ratio: f64,
    /// Number of records, and the rules of the choice.
    pub rule: SuiteRule,
    /// Whether to match each member to the demand after scaling.
    pub matched: bool,
}

/// A record of a suite.
#[derive(Clone, Debug, PartialEq)]
pub struct SuiteMember {
    /// Its name in a project file: small letters, digits and hyphens.
    pub name: String,
    /// Its file.
    pub file: String,
    /// Its channel; "" for a single channel without a name.
    pub channel: String,
    /// Its direction, if the file states it.
    pub orientation: Option<Orientation>,
    /// Its earthquake and station, if the file states them.
    pub origin: Origin,
    /// Its factor.
    pub factor: f64,
    /// The record along x before scaling; matched, if it was.
    pub motion: GroundMotion,
    /// Result of the match after scaling.
    pub matched: Option<MatchedMotion>,
    /// Its pseudo-acceleration at the periods, scaled, m/s².
    pub acceleration_m_s2: Vec<f64>,
    /// Its misfit.
    pub misfit: SpectrumMisfit,
}

impl SuiteMember {
    /// Largest acceleration, scaled, m/s².
    pub fn peak_m_s2(&self) -> f64 {
        self.motion.component_peak_m_s2(Component::X) * self.remaining_factor()
    }

    /// The remaining factor on the motion: 1 if it was matched.
    pub fn remaining_factor(&self) -> f64 {
        match self.matched {
            Some(_) => 1.0,
            None => self.factor,
        }
    }
}

/// Why a file or a channel is not in a suite.
#[derive(Clone, Debug, PartialEq)]
pub enum NotTaken {
    /// The file cannot be read as a motion.
    Refused {
        /// Reason.
        why: Both,
    },
    /// It is vertical.
    Vertical,
    /// It is a copy of an earlier record: the same samples, or scaled, inverted, cut or resampled.
    CopyOf {
        /// The file of the earlier record.
        file: String,
    },
}

/// A suite of records whose mean spectrum follows a demand.
#[derive(Clone, Debug, PartialEq)]
pub struct SuiteAnswer {
    /// Description of the demand: the code with its year and parameters.
    pub demand: String,
    /// Damping ratio of the spectra.
    pub damping_ratio: f64,
    /// The rules of the choice.
    pub rule: SuiteRule,
    /// Number of horizontal records.
    pub candidates: usize,
    /// Number of records without a stated direction, taken as horizontal.
    pub without_direction: usize,
    /// The periods, s.
    pub periods_s: Vec<f64>,
    /// The demand at each, m/s².
    pub target_m_s2: Vec<f64>,
    /// The mean spectrum of the suite at each, m/s².
    pub mean_m_s2: Vec<f64>,
    /// Misfit of the mean.
    pub misfit: SpectrumMisfit,
    /// The period at which the mean is lowest relative to the demand, s.
    pub worst_s: f64,
    /// The chosen records.
    pub members: Vec<SuiteMember>,
    /// Files and channels left out, each with its reason.
    pub not_taken: Vec<(String, NotTaken)>,
}

impl SuiteAnswer {
    /// Whether the mean is at least the required share of the demand at every period.
    pub fn is_kept(&self) -> bool {
        self.misfit.lowest >= self.rule.least_share - 1.0 - 1e-9
    }
}

/// A record that can be chosen.
struct CandidateRecord {
    file: String,
    reading: ComponentReading,
    origin: Origin,
    motion: GroundMotion,
    accelerations_m_s2: Vec<f64>,
}

/// Chooses records of files for a suite, and scales them.
///
/// # Errors
/// [`WorkError`] if the demand, the periods or the rules are not allowed, no file contains a record, no suite satisfies the rules, or a member
/// cannot be matched. A file that cannot be read is left out, and the answer gives the reason.
pub fn suite(options: &SuiteOptions, names: &[String], files: &dyn Files) -> Result<SuiteAnswer, WorkError> {
    let [least_s, most_s] = range(options.range_s)?;
    let demand = demand(&options.demand)?;
    let ratio = most_s / least_s;
    let periods_s: Vec<f64> = (0..PERIODS)
        .map(|k| least_s * ratio.powf(k as f64 / (PERIODS - 1) as f64))
        .collect();
    let mut target_m_s2 = Vec::with_capacity(PERIODS);
    for period_s in &periods_s {
        target_m_s2.push(demand.acceleration_m_s2(*period_s, options.damping_ratio)?);
    }
    let ReadFiles {
        records: found,
        not_taken,
    } = ReadFiles::of(options, names, files, &periods_s)?;
    refuse_none(names.len(), &found, &not_taken)?;
    let candidates: Vec<SuiteCandidate> = found.iter().map(|one| candidate(one, &target_m_s2)).collect();
    let chosen = motion_suite(&candidates, &options.rule)?;
    let without_direction = found
        .iter()
        .filter(|one| one.reading.orientation.is_none())
        .count();
    let mut taken = BTreeSet::new();
    let mut members = Vec::new();
    for (at, factor) in chosen.members.iter().zip(&chosen.factors) {
        let name = unique(&named(&found[*at].file), &mut taken);
        members.push(member(
            options,
            (&found[*at], name, *factor),
            &periods_s,
            &target_m_s2,
        )?);
    }
    let mean_m_s2: Vec<f64> = (0..PERIODS)
        .map(|k| {
            let sum: f64 = members
                .iter()
                .map(|one: &SuiteMember| one.acceleration_m_s2[k])
                .sum();
            sum / members.len() as f64
        })
        .collect();
    let over = |k: &usize| mean_m_s2[*k] / target_m_s2[*k];
    let worst = (0..PERIODS)
        .min_by(|a, b| over(a).total_cmp(&over(b)))
        .unwrap_or(0);
    Ok(SuiteAnswer {
        demand: demand.source,
        damping_ratio: options.damping_ratio,
        rule: options.rule,
        candidates: found.len(),
        without_direction,
        misfit: against(&mean_m_s2, &target_m_s2),
        worst_s: periods_s[worst],
        periods_s,
        target_m_s2,
        mean_m_s2,
        members,
        not_taken,
    })
}

/// The records of the files, and the channels that cannot be chosen.
struct ReadFiles {
    records: Vec<CandidateRecord>,
    not_taken: Vec<(String, NotTaken)>,
}

impl ReadFiles {
    fn of(
        options: &SuiteOptions,
        names: &[String],
        files: &dyn Files,
        periods_s: &[f64],
    ) -> Result<Self, WorkError> {
        let told = motion_options(&options.request)?;
        let mut not_taken = Vec::new();
        let mut found: Vec<CandidateRecord> = Vec::new();
        for name in names {
            let read = files
                .read(name, MOTION_BYTES_MOST)
                .map_err(WorkError::from)
                .and_then(|bytes| Ok(read_channels(&bytes, &told)?));
            let channels = match read {
                Ok(channels) => channels,
                Err(why) => {
                    let why = told_both(&why);
                    not_taken.push((name.clone(), NotTaken::Refused { why }));
                    continue;
                }
            };
            let are_several = channels.len() > 1;
            for reading in channels {
                let place = match are_several {
                    true => format!("{name}, {}", reading.name),
                    false => name.clone(),
                };
                if matches!(reading.orientation, Some(Orientation::Up | Orientation::Down)) {
                    not_taken.push((place, NotTaken::Vertical));
                    continue;
                }
                if reading.is_borehole {
                    let why = told_both(&WorkError::from(MotionError::Borehole { component: "x" }));
                    not_taken.push((place, NotTaken::Refused { why }));
                    continue;
                }
                let samples = |of: &ComponentReading| (of.acceleration_m_s2.clone(), of.time_step_s);
                let (own, step_s) = samples(&reading);
                let same = |one: &&CandidateRecord| {
                    is_same_shaking(
                        (&one.reading.acceleration_m_s2, one.reading.time_step_s),
                        (&own, step_s),
                    )
                };
                if let Some(first) = found.iter().find(same) {
                    let file = first.file.clone();
                    not_taken.push((place, NotTaken::CopyOf { file }));
                    continue;
                }
                match of_channel(options, name, reading, periods_s) {
                    Ok(one) => found.push(one),
                    Err(why) => {
                        let why = told_both(&why);
                        not_taken.push((place, NotTaken::Refused { why }));
                    }
                }
            }
        }
        Ok(ReadFiles {
            records: found,
            not_taken,
        })
    }
}

fn refuse_none(
    files: usize,
    found: &[CandidateRecord],
    not_taken: &[(String, NotTaken)],
) -> Result<(), WorkError> {
    if !found.is_empty() {
        return Ok(());
    }
    let refused = not_taken.iter().find_map(|(file, why)| match why {
        NotTaken::Refused { why } => Some((file.clone(), why.clone())),
        NotTaken::Vertical | NotTaken::CopyOf { .. } => None,
    });
    Err(match refused {
        Some((file, why)) => MotionRequestError::NoneReadable { files, file, why },
        None => MotionRequestError::NoRecords { files },
    }
    .into())
}

/// A channel as a record along x, with its spectrum.
fn of_channel(
    options: &SuiteOptions,
    file: &str,
    reading: ComponentReading,
    periods_s: &[f64],
) -> Result<CandidateRecord, WorkError> {
    let series = vec![(Component::X, reading.acceleration_m_s2.clone())];
    let alone = GroundMotion::new(file, reading.time_step_s, series)?;
    let motion = changed_alone(alone, &options.request)?;
    Ok(CandidateRecord {
        file: file.to_owned(),
        origin: origin(&reading),
        accelerations_m_s2: accelerations(&motion, periods_s, options.damping_ratio)?,
        motion,
        reading,
    })
}

fn accelerations(
    motion: &GroundMotion,
    periods_s: &[f64],
    damping_ratio: f64,
) -> Result<Vec<f64>, WorkError> {
    let found = response_spectrum(motion, Component::X, periods_s, damping_ratio)?;
    Ok(found
        .iter()
        .map(SpectralOrdinate::pseudo_acceleration_m_s2)
        .collect())
}

/// The directions of one record form one candidate, in one file or in several files of one earthquake and station.
fn candidate(one: &CandidateRecord, target_m_s2: &[f64]) -> SuiteCandidate {
    let Origin { event, station } = one.origin.clone();
    SuiteCandidate {
        ratios: one
            .accelerations_m_s2
            .iter()
            .zip(target_m_s2)
            .map(|(a, target)| a / target)
            .collect(),
        record: match (&event, &station) {
            (Some(event), Some(station)) => format!("{event}\n{station}"),
            _ => one.file.clone(),
        },
        event,
        station,
    }
}

fn member(
    options: &SuiteOptions,
    (one, name, factor): (&CandidateRecord, String, f64),
    periods_s: &[f64],
    target_m_s2: &[f64],
) -> Result<SuiteMember, WorkError> {
    let place = || one.file.clone();
    let mut motion = one.motion.clone().renamed(&name);
    let mut matched = None;
    let mut acceleration_m_s2: Vec<f64> = one.accelerations_m_s2.iter().map(|a| factor * a).collect();
    if options.matched {
        let told = SpectrumMatch {
            damping_ratio: options.damping_ratio,
            period_least_s: options.range_s[0],
            period_most_s: options.range_s[1],
            ..SpectrumMatch::default()
        };
        let demand = demand(&options.demand)?;
        let target = |period_s: f64| {
            demand
                .acceleration_m_s2(period_s, options.damping_ratio)
                .unwrap_or(f64::NAN)
        };
        let scaled = motion.scaled(factor).within(place)?;
        let done = match_spectrum(&scaled, Component::X, &target, &told).within(place)?;
        motion = done.motion.clone();
        acceleration_m_s2 = accelerations(&motion, periods_s, options.damping_ratio)?;
        matched = Some(done);
    }
    Ok(SuiteMember {
        name,
        file: one.file.clone(),
        channel: one.reading.name.clone(),
        orientation: one.reading.orientation,
        origin: one.origin.clone(),
        factor,
        motion,
        matched,
        misfit: against(&acceleration_m_s2, target_m_s2),
        acceleration_m_s2,
    })
}

/// Misfit of a spectrum.
fn against(found_m_s2: &[f64], target_m_s2: &[f64]) -> SpectrumMisfit {
    let off: Vec<f64> = found_m_s2
        .iter()
        .zip(target_m_s2)
        .map(|(a, target)| a / target - 1.0)
        .collect();
    SpectrumMisfit {
        root_mean_square: (off.iter().map(|x| x * x).sum::<f64>() / off.len() as f64).sqrt(),
        lowest: off.iter().copied().fold(f64::INFINITY, f64::min),
        highest: off.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    }
}

/// The name of a table in a project file, from a file name: "rsn6-impvall-i-elc180".
fn named(file: &str) -> String {
    let stem = file.rsplit(['/', '\\']).next().unwrap_or_default();
    let stem = stem.rsplit_once('.').map_or(stem, |(stem, _)| stem);
    let mut name = String::new();
    for c in stem.chars() {
        match c.is_ascii_alphanumeric() {
            true => name.push(c.to_ascii_lowercase()),
            false if !name.is_empty() && !name.ends_with('-') => name.push('-'),
            false => {}
        }
    }
    name.truncate(NAME_MOST);
    match name.trim_matches('-') {
        "" => "record".to_owned(),
        name => name.to_owned(),
    }
}

/// The name, with a number after it if it exists.
fn unique(name: &str, taken: &mut BTreeSet<String>) -> String {
    let mut tried = name.to_owned();
    let mut number = 1;
    while !taken.insert(tried.clone()) {
        number += 1;
        tried = format!("{name}-{number}");
    }
    tried
}
