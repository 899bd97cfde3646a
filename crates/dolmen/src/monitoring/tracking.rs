//! Tracks modes through many surveys: each survey is assigned to references from the last surveys.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | Δf | | frequency minus the reference, which is the median of the last surveys | Hz |
//! | σ_f | | standard deviation of the difference | Hz |
//! | w | `width_hz` | max(`frequency_within` f, 4 σ_f) | Hz |

use super::MonitoringError;
use super::history::HistorySurvey;
use super::sensors::{EXPLAINED, JUMPED_BELOW, SensorChange, sensor_change};
use crate::modal::{ObservedMode, ObservedPoint, Pairing, assurance, shared};
use crate::numeric::{assignment, middle};

/// Number of surveys in the median of a reference.
const REFERENCE_SURVEYS: usize = 10;
/// Largest difference of frequencies of the same mode, in standard deviations.
const DEVIATIONS: f64 = 4.0;
/// Cost of a forbidden pair.
const FORBIDDEN: f64 = 1e6;
/// Number of surveys after which a mode that was rarely found is dropped. Our choice.
const FORGOTTEN_AFTER: usize = 30;
/// Fewest common sensors for comparing shapes.
const PLACES_LEAST: usize = 2;
/// MAC from which a mode that ended and a mode that began may be one mode that jumped.
const JUMPED_LEAST: f64 = 0.8;

/// Options of [`track`].
#[derive(Clone, Debug, PartialEq)]
pub struct Tracking {
    /// Largest relative change of the frequency of one mode between surveys; default 0.15.
    pub frequency_within: f64,
    /// Cost of a mode without a partner; default 1.2, so that two modes of the same frequency with different shapes are not paired.
    pub unpaired: f64,
    /// Smallest number of surveys with the mode for a track; default 3.
    pub found_least: usize,
    /// Smallest fraction of the surveys with the mode for a track; default 0.2 (our choice).
    pub share_least: f64,
    /// Largest distance between two sensors at the same position, m; default 0.1.
    pub place_within_m: f64,
}

impl Default for Tracking {
    fn default() -> Self {
        let pairing = Pairing::default();
        Tracking {
            frequency_within: pairing.frequency_within,
            unpaired: 1.2,
            found_least: 3,
            share_least: 0.2,
            place_within_m: pairing.place_within_m,
        }
    }
}

/// One mode through all surveys.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// Median frequency, Hz.
    pub frequency_hz: f64,
    /// Direction, if the surveys state it.
    pub direction: Option<String>,
    /// Index of the mode in each survey; `None` for a gap.
    pub modes: Vec<Option<usize>>,
    /// MAC with the reference in each survey, if the shapes can be compared.
    pub assurances: Vec<Option<f64>>,
}

impl Track {
    /// Number of surveys with the mode.
    pub fn found(&self) -> usize {
        self.modes.iter().flatten().count()
    }
}

/// A mode that ended and one that began, with similar shapes: possibly one mode that jumped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jumped {
    /// Median frequency of the mode that ended, Hz.
    pub from_hz: f64,
    /// Median frequency of the mode that began, Hz.
    pub to_hz: f64,
    /// First survey of the mode that began.
    pub at: usize,
    /// MAC of the two shapes.
    pub assurance: f64,
}

/// Result of [`track`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tracked {
    /// Modes that were found often enough, by frequency.
    pub tracks: Vec<Track>,
    /// Median frequencies of the other modes, Hz, and the number of surveys with each.
    pub rare: Vec<(f64, usize)>,
    /// Modes that may have jumped in frequency.
    pub jumped: Vec<Jumped>,
    /// Jumps of shapes without changes of frequency.
    pub sensors: Vec<SensorChange>,
}

/// Reference of one mode from the surveys so far.
struct Reference {
    modes: Vec<Option<usize>>,
    assurances: Vec<Option<f64>>,
    /// The last accepted modes, newest last.
    recent: Vec<ObservedMode>,
}

impl Reference {
    fn frequency_hz(&self) -> f64 {
        middle(self.recent.iter().map(|mode| mode.frequency_hz).collect())
    }

    /// Median of the last shapes at their common sensors, each scaled to the amplitude and phase of the newest one.
    fn shape(&self, within_m: f64) -> Vec<ObservedPoint> {
        let Some(newest) = self.recent.iter().rev().find(|mode| !mode.shape.is_empty()) else {
            return Vec::new();
        };
        let mut each: Vec<Vec<f64>> = vec![Vec::new(); newest.shape.len()];
        for mode in &self.recent {
            let [new, old] = shared(&newest.shape, &mode.shape, within_m);
            if new.len() != newest.shape.len() {
                continue;
            }
            let inner: dolmen_linalg::Complex64 = old.iter().zip(&new).map(|(o, n)| o.conj() * n).sum();
            let power: f64 = old.iter().map(|o| o.norm_sqr()).sum();
            if power > 0.0 {
                for (values, (o, n)) in each.iter_mut().zip(old.iter().zip(&new)) {
                    // component in phase with the newest shape; the other component is noise
                    let phase = if n.norm() > 0.0 { n / n.norm() } else { 1.0.into() };
                    values.push((o * inner / power * phase.conj()).re);
                }
            }
        }
        let points = newest.shape.iter().zip(each);
        points
            .map(|(point, values)| {
                let norm = point.component.norm();
                let phase = if norm > 0.0 {
                    point.component / norm
                } else {
                    1.0.into()
                };
                ObservedPoint {
                    channel: point.channel.clone(),
                    component: phase * middle(values),
                }
            })
            .collect()
    }

    fn as_mode(&self, within_m: f64) -> ObservedMode {
        let mut mode = self.recent[self.recent.len() - 1].clone();
        mode.frequency_hz = self.frequency_hz();
        mode.shape = self.shape(within_m);
        mode
    }
}

/// Tracks modes through surveys.
///
/// ```text
/// cost = |Δf|/w + (1 − MAC), or |Δf|/w where shapes cannot be compared        a mode without a partner: 1.2
/// ```
/// References are medians of frequency and shape over the last ten surveys with the mode. A survey without the mode is a gap.
///
/// # Errors
/// [`MonitoringError::Option`] for an option out of range; [`MonitoringError::Numeric`] for a frequency that is not finite.
///
/// # Limits
/// Without shapes, modes that cross are confused, because their order is kept. If a mode changes by more than `frequency_within` between two surveys,
/// its track ends and another begins; if their shapes are similar, both are listed as one possible mode ([`Jumped`]).
pub fn track(surveys: &[HistorySurvey], options: &Tracking) -> Result<Tracked, MonitoringError> {
    check(options)?;
    let mut references: Vec<Reference> = Vec::new();
    let mut retired = Vec::new();
    let mut sensors = Vec::new();
    for (at, survey) in surveys.iter().enumerate() {
        let known: Vec<ObservedMode> = references
            .iter()
            .map(|reference| reference.as_mode(options.place_within_m))
            .collect();
        let chosen = assigned(&known, &survey.modes, options)?;
        let pairs: Vec<(&ObservedMode, &ObservedMode)> = known
            .iter()
            .zip(&chosen)
            .filter_map(|(known, j)| Some((known, &survey.modes[(*j)?])))
            .collect();
        let changed = sensor_change(&pairs, options.place_within_m);
        for (reference, j) in references.iter_mut().zip(&chosen) {
            let shape = reference.shape(options.place_within_m);
            let mac = j.and_then(|j| likeness(&shape, &survey.modes[j], options));
            reference.modes.push(*j);
            reference.assurances.push(mac);
            if changed.is_some() {
                reference.recent.iter_mut().for_each(|mode| mode.shape.clear());
            }
            if let Some(j) = j {
                reference.recent.push(survey.modes[*j].clone());
                if reference.recent.len() > REFERENCE_SURVEYS {
                    reference.recent.remove(0);
                }
            }
        }
        let is_chance = |reference: &mut Reference| {
            let found = reference.modes.iter().flatten().count();
            let last = reference.modes.iter().rposition(Option::is_some).unwrap_or(0);
            found < options.found_least && at - last > FORGOTTEN_AFTER
        };
        retired.extend(references.extract_if(.., is_chance));
        sensors.extend(changed.map(|change| SensorChange {
            survey: jumped_since(surveys, &references, at, options),
            ..change
        }));
        for (j, mode) in survey.modes.iter().enumerate() {
            if !chosen.contains(&Some(j)) {
                let mut modes = vec![None; at];
                modes.push(Some(j));
                references.push(Reference {
                    modes,
                    assurances: vec![None; at + 1],
                    recent: vec![mode.clone()],
                });
            }
        }
    }
    retired.extend(references);
    Ok(gathered(retired, sensors, surveys, options))
}

/// The first survey that already has the changed shapes. It may be before `at`, because an earlier survey may have had too few comparable modes to
/// show the jump itself.
fn jumped_since(surveys: &[HistorySurvey], references: &[Reference], at: usize, options: &Tracking) -> usize {
    let mut since = at;
    while since > 0 {
        let earlier = since - 1;
        let shows = |reference: &Reference| {
            let of = |survey: usize| {
                let mode = (*reference.modes.get(survey)?)?;
                surveys[survey].modes.get(mode)
            };
            let has_jumped = reference
                .assurances
                .get(earlier)
                .is_some_and(|mac| mac.is_some_and(|mac| mac < JUMPED_BELOW));
            let like = of(at)
                .zip(of(earlier))
                .and_then(|(now, before)| likeness(&now.shape, before, options));
            has_jumped && like.is_some_and(|mac| mac >= EXPLAINED)
        };
        if !references.iter().any(shows) {
            break;
        }
        since = earlier;
    }
    since
}

fn likeness(shape: &[ObservedPoint], mode: &ObservedMode, options: &Tracking) -> Option<f64> {
    let [phi, psi] = shared(shape, &mode.shape, options.place_within_m);
    (phi.len() >= PLACES_LEAST).then(|| assurance(&phi, &psi))
}

/// For each reference, the index of the same mode in the survey.
fn assigned(
    known: &[ObservedMode],
    modes: &[ObservedMode],
    options: &Tracking,
) -> Result<Vec<Option<usize>>, MonitoringError> {
    let gaps = known.len();
    let row = |known: &ObservedMode| -> Vec<f64> {
        let own = modes.iter().map(|mode| {
            let strangers = matches!((&known.direction, &mode.direction), (Some(a), Some(b)) if a != b);
            let sd = known
                .frequency_sd_hz
                .unwrap_or(0.0)
                .hypot(mode.frequency_sd_hz.unwrap_or(0.0));
            let width_hz = (options.frequency_within * known.frequency_hz).max(DEVIATIONS * sd);
            let apart = (mode.frequency_hz - known.frequency_hz).abs() / width_hz;
            let unlike = likeness(&known.shape, mode, options).map_or(0.0, |mac| 1.0 - mac);
            let cost = apart + unlike;
            match strangers || cost > options.unpaired || cost.is_nan() {
                true => FORBIDDEN,
                false => cost,
            }
        });
        own.chain(std::iter::repeat_n(options.unpaired, gaps)).collect()
    };
    let cost: Vec<Vec<f64>> = known.iter().map(row).collect();
    let chosen = assignment(&cost)?;
    let pairs = chosen.into_iter().zip(&cost);
    Ok(pairs
        .map(|(j, row)| (j < modes.len() && row[j] < FORBIDDEN).then_some(j))
        .collect())
}

/// Sorts the tracks into those found often enough, by frequency, the others, and possible jumps.
fn gathered(
    references: Vec<Reference>,
    sensors: Vec<SensorChange>,
    surveys: &[HistorySurvey],
    options: &Tracking,
) -> Tracked {
    let with_modes = surveys.iter().filter(|survey| !survey.modes.is_empty()).count();
    let least = (options.share_least * with_modes as f64).max(options.found_least as f64);
    let mut tracks = Vec::new();
    let mut rare = Vec::new();
    let mut shapes = Vec::new();
    for reference in references {
        let found: Vec<(usize, usize)> = reference
            .modes
            .iter()
            .enumerate()
            .filter_map(|(at, j)| Some((at, (*j)?)))
            .collect();
        let frequency_hz = middle(
            found
                .iter()
                .map(|(at, j)| surveys[*at].modes[*j].frequency_hz)
                .collect(),
        );
        // a mode that began late is judged by the surveys since then
        let began = found.first().map_or(0, |(at, _)| *at);
        let since = surveys[began..]
            .iter()
            .filter(|survey| !survey.modes.is_empty())
            .count();
        let least = least.min((options.share_least * since as f64).max(options.found_least as f64));
        if (found.len() as f64) < least {
            rare.push((frequency_hz, found.len()));
            continue;
        }
        shapes.push((
            reference.as_mode(options.place_within_m),
            began,
            found.last().map_or(0, |(at, _)| *at),
        ));
        tracks.push(Track {
            frequency_hz,
            direction: found
                .iter()
                .find_map(|(at, j)| surveys[*at].modes[*j].direction.clone()),
            modes: reference.modes,
            assurances: reference.assurances,
        });
    }
    let mut jumped = Vec::new();
    for (ended, (from, _, last)) in shapes.iter().enumerate() {
        for (began, (to, first, _)) in shapes.iter().enumerate() {
            let follows = ended != began && first > last;
            let strangers = matches!((&from.direction, &to.direction), (Some(a), Some(b)) if a != b);
            let mac = likeness(&from.shape, to, options).filter(|mac| *mac >= JUMPED_LEAST);
            if let (true, false, Some(assurance)) = (follows, strangers, mac) {
                jumped.push(Jumped {
                    from_hz: tracks[ended].frequency_hz,
                    to_hz: tracks[began].frequency_hz,
                    at: *first,
                    assurance,
                });
            }
        }
    }
    tracks.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    rare.sort_by(|a, b| a.0.total_cmp(&b.0));
    Tracked {
        tracks,
        rare,
        jumped,
        sensors,
    }
}

fn check(options: &Tracking) -> Result<(), MonitoringError> {
    let refused = |option, given, allowed| {
        Err(MonitoringError::Option {
            option,
            given,
            allowed,
        })
    };
    if !(options.frequency_within > 0.0 && options.frequency_within <= 1.0) {
        return refused(
            "frequency_within",
            options.frequency_within,
            "above 0 and at most 1",
        );
    }
    if !(options.unpaired > 0.0 && options.unpaired <= 2.0) {
        return refused("unpaired", options.unpaired, "above 0 and at most 2");
    }
    if !(0.0..=1.0).contains(&options.share_least) {
        return refused("share_least", options.share_least, "between 0 and 1");
    }
    Ok(())
}
