//! Compares two surveys of one structure, mode by mode: the changes, and the smallest change that would be detected.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | f, f' | `from`, `to` | frequency before and after | Hz |
//! | κ | `per_c` | relative change of a frequency per °C | 1/°C |
//! | ΔT | `step_c` | later temperature minus earlier temperature | °C |
//! | r | `relative` | change that temperature does not explain | - |

use super::difference::{Raw, tested};
use super::directions::exchanged_directions;
use super::history::{HistoryEffect, nearest_of_pair};
use super::mode_change::{ModeChange, NotCompared, SurveyChange, TemperatureKnowledge};
use super::notes::ChangeNote;
use super::slips::slips;
use super::swapped::{Slip, slip_of_channels};
use super::temperature::{FitPoint, FittedTemperature, TemperatureEffect, line};
use crate::assess::AssessError;
use crate::modal::{ModePair, ObservedMode, Pairing, pair_modes};
use crate::numeric::welch;

/// Ratio of the scatter about a line over temperature to the stated standard deviations above which chance is excluded. Our choice: with two
/// degrees of freedom, one fit in a thousand exceeds 2.6.
const SCATTER_BEYOND: f64 = 3.0;
/// Correlation of temperature with the order of the surveys above which weather and ageing cannot be separated. Our choice.
const WITH_TIME: f64 = 0.7;

/// One survey: its modes and its temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Surveyed {
    /// Its name.
    pub name: String,
    /// Temperature, °C; `None` if not known.
    pub temperature_c: Option<f64>,
    /// Its modes, in ascending order of frequency.
    pub modes: Vec<ObservedMode>,
}

/// Options of [`survey_change`].
#[derive(Clone, Debug, PartialEq)]
pub struct SurveyChangeOptions {
    /// The pairing of modes.
    pub pairing: Pairing,
    /// Effect of temperature on the frequencies.
    pub temperature: TemperatureEffect,
    /// Effects of weather from a history of many surveys. Where a mode has one, it is used instead of `temperature`.
    pub history: Vec<HistoryEffect>,
    /// Frequencies in both surveys, Hz, of modes that such a history follows without knowing the weather of one of the two: their
    /// differences are not tested, because the stated deviations include neither weather nor scatter.
    pub undecided_hz: Vec<[f64; 2]>,
    /// Probability of finding a change in any mode although nothing changed; default 0.05.
    pub significance: f64,
    /// Probability of finding the smallest detectable change; default 0.8.
    pub power: f64,
}

impl Default for SurveyChangeOptions {
    fn default() -> Self {
        SurveyChangeOptions {
            pairing: Pairing::default(),
            temperature: TemperatureEffect::Unknown,
            history: Vec::new(),
            undecided_hz: Vec::new(),
            significance: 0.05,
            power: 0.8,
        }
    }
}

/// Changes from one survey to another: pairs of modes, each difference with its standard deviation and its probability by chance, and the smallest
/// change that would have been detected.
///
/// ```text
/// r = (f' - f (1 + κ ΔT)) / f
/// var r = (sd'² + (1 + κ ΔT)² sd² + (f ΔT sd_κ)²) / f²,     t = r / sd r    of Student with Welch's degrees of freedom
/// Δk/k = (1 + r)² - 1                                        if the stiffness changed alike everywhere and no mass did
/// ```
/// Frequencies are tested together, and so are damping ratios, each group by Holm's procedure. With [`TemperatureEffect::Fitted`], κ of each mode
/// is the least-squares slope through `earlier` and `from`, whose temperatures must be known. The scatter about that line, which includes moisture
/// and crowds, is then the deviation of each survey, and the covariance of f with κ is included. With a history
/// ([`SurveyChangeOptions::history`]), weather and scatter are those of all its surveys; modes of which it does not know the weather
/// ([`SurveyChangeOptions::undecided_hz`]) are not tested.
///
/// # Errors
/// [`AssessError::NothingToCompare`] if a survey has no modes; [`AssessError::Factor`] for an option out of range;
/// [`AssessError::Modal`] for invalid modes.
///
/// # Limits
/// The standard deviation of an identification holds for another record under the same conditions. It does not include moisture, crowds, the
/// strength of the wind, or a stone temperature that lags behind that of the air. In 4000 simulated pairs of surveys without a change (four modes,
/// normal variables, 30 time blocks), the test finds a change in 5 % of them, within 1 % (measured). One coefficient for all modes is a rough
/// rule.
///
/// # Example
/// ```
/// use dolmen::assess::{Surveyed, SurveyChangeOptions, survey_change};
/// use dolmen::modal::ObservedMode;
/// let survey = |name: &str, frequency_hz: f64| Surveyed {
///     name: name.into(),
///     temperature_c: Some(15.0),
///     modes: vec![ObservedMode {
///         frequency_hz, frequency_sd_hz: Some(0.01), damping_ratio: None, damping_ratio_sd: None,
///         degrees_of_freedom: f64::INFINITY, direction: None, accepted: false, shape: Vec::new(),
///     }],
/// };
/// let found = survey_change(&survey("2019", 2.0), &survey("2024", 1.94), &[], &SurveyChangeOptions::default())?;
/// let change = &found.modes[0].frequency;
/// assert!((change.relative + 0.03).abs() < 1e-12);
/// // 0.06 Hz over √2 0.01 Hz: 4.24 deviations
/// assert!(change.evidence.as_ref().is_some_and(|e| (e.statistic + 4.2426).abs() < 1e-4 && e.significant));
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn survey_change(
    from: &Surveyed,
    to: &Surveyed,
    earlier: &[Surveyed],
    options: &SurveyChangeOptions,
) -> Result<SurveyChange, AssessError> {
    check(from, to, options)?;
    let slip = slip_of_channels(&from.modes, &to.modes, &options.pairing);
    // shapes with a wrong sign or exchanged channels pair no modes, or the wrong ones
    let corrected = slip.as_ref().map(|slip| slip.corrected(&from.modes));
    let paired = pair_modes(
        corrected.as_ref().unwrap_or(&from.modes),
        &to.modes,
        &options.pairing,
    )?;
    let step_c = match (from.temperature_c, to.temperature_c) {
        (Some(before), Some(after)) => Some(after - before),
        _ => None,
    };
    let mut notes = Vec::new();
    let mut covariates = Vec::with_capacity(paired.pairs.len());
    for pair in &paired.pairs {
        covariates.push(covariate(pair, from, to, earlier, (options, &mut notes))?);
    }
    let both = |pair: &ModePair| (&from.modes[pair.first], &to.modes[pair.second]);
    let raw: Vec<Raw> = paired
        .pairs
        .iter()
        .zip(&covariates)
        .map(|(pair, covariate)| frequency_difference(both(pair), covariate, step_c, options))
        .collect();
    let frequencies = tested(&raw, options.significance, options.power)?;
    let with_damping: Vec<Option<Raw>> = paired.pairs.iter().map(|p| damping_difference(both(p))).collect();
    let known: Vec<Raw> = with_damping.iter().flatten().copied().collect();
    let mut dampings = tested(&known, options.significance, options.power)?.into_iter();
    let mut modes = Vec::with_capacity(raw.len());
    for (((pair, covariate), frequency), damping) in paired
        .pairs
        .iter()
        .zip(covariates)
        .zip(frequencies)
        .zip(with_damping)
    {
        let (before, after) = both(pair);
        let r = frequency.relative;
        let whole = after.frequency_hz / before.frequency_hz - 1.0;
        modes.push(ModeChange {
            pair: pair.clone(),
            from: before.clone(),
            to: after.clone(),
            damping: damping.and_then(|_| dampings.next()),
            explained_by_temperature: covariate.as_ref().map(|c| c.explained),
            history: covariate.as_ref().and_then(|c| c.history.clone()),
            is_undecided: is_undecided(both(pair), options),
            fitted: covariate.and_then(|c| c.fitted),
            explaining_per_c: step_c.filter(|step| *step != 0.0).map(|step| whole / step),
            uniform_stiffness: r * (2.0 + r),
            uniform_stiffness_sd: frequency.evidence.as_ref().map(|e| 2.0 * (1.0 + r).abs() * e.sd),
            frequency,
        });
    }
    let temperature = knowledge(step_c, &modes, options);
    beyond_the_line(&modes, to.temperature_c, &mut notes);
    let of = |survey: &Surveyed, alone: &[usize]| -> Vec<ObservedMode> {
        alone.iter().map(|i| survey.modes[*i].clone()).collect()
    };
    let (lost, new) = (of(from, &paired.only_first), of(to, &paired.only_second));
    let of_from_hz = from.modes.iter().map(|mode| mode.frequency_hz);
    let lowest_hz = of_from_hz.fold(f64::INFINITY, f64::min);
    let not_compared = paired.moved_further.iter().map(|moved| NotCompared {
        from: from.modes[moved.first].clone(),
        is_lowest: from.modes[moved.first].frequency_hz == lowest_hz,
        may_be: moved.second.map(|second| to.modes[second].clone()),
        assurance: moved.assurance,
    });
    let other = paired.most_pairs.iter();
    let other_pairing_hz = other.map(|&[i, j]| [from.modes[i].frequency_hz, to.modes[j].frequency_hz]);
    notes.extend(slip.map(|slip| match slip {
        Slip::Swapped(swapped) => ChangeNote::Swapped(swapped),
        Slip::Turned(turned) => ChangeNote::Turned(turned),
    }));
    let exchanged = exchanged_directions(&from.modes, &to.modes, &options.pairing);
    notes.extend(exchanged.map(ChangeNote::DirectionsExchanged));
    notes.extend(slips(&modes, &lost, &new));
    Ok(SurveyChange {
        from: from.name.clone(),
        to: to.name.clone(),
        temperature,
        modes,
        lost,
        new,
        significance: options.significance,
        power: options.power,
        not_compared: not_compared.collect(),
        other_pairing_hz: other_pairing_hz.collect(),
        notes,
    })
}

fn knowledge(
    step_c: Option<f64>,
    modes: &[ModeChange],
    options: &SurveyChangeOptions,
) -> TemperatureKnowledge {
    match step_c {
        None => TemperatureKnowledge::NotMeasured,
        Some(0.0) => TemperatureKnowledge::Same,
        Some(step_c) if modes.iter().all(|mode| is_corrected(mode, options)) => {
            TemperatureKnowledge::Corrected { step_c }
        }
        Some(step_c) => TemperatureKnowledge::Unexplained { step_c },
    }
}

/// Whether the effect of temperature is removed from a mode.
fn is_corrected(mode: &ModeChange, options: &SurveyChangeOptions) -> bool {
    let is_given = matches!(options.temperature, TemperatureEffect::Coefficient { .. });
    let history = mode.history.as_ref();
    mode.explained_by_temperature.is_some() && (is_given || history.is_none_or(|of| of.knows_temperature))
}

/// Whether a history follows the mode without knowing the weather of one of its two surveys.
fn is_undecided((from, to): (&ObservedMode, &ObservedMode), options: &SurveyChangeOptions) -> bool {
    let both_hz = |of: &HistoryEffect| [of.from_hz, of.to_hz];
    let of = options.undecided_hz.iter().copied();
    let nearest = nearest_of_pair(of, from, to);
    let known = nearest_of_pair(options.history.iter().map(both_hz), from, to);
    nearest.is_some_and(|of| known.is_none_or(|known| of.off < known.off))
}

fn check(from: &Surveyed, to: &Surveyed, options: &SurveyChangeOptions) -> Result<(), AssessError> {
    for survey in [from, to] {
        if survey.modes.is_empty() {
            return Err(AssessError::NothingToCompare {
                survey: survey.name.clone(),
            });
        }
    }
    let refused = |factor, given, allowed| {
        Err(AssessError::Factor {
            factor,
            given,
            allowed,
        })
    };
    if !(options.significance > 0.0 && options.significance < 0.5) {
        return refused("significance", options.significance, "above 0 and below 0.5");
    }
    if !(options.power >= 0.5 && options.power < 1.0) {
        return refused("power", options.power, "at least 0.5 and below 1");
    }
    if let TemperatureEffect::Coefficient { per_c, sd_per_c } = options.temperature {
        const MOST: f64 = 0.05; // relative per °C; ten times the value of frozen or drying masonry
        if !(-MOST..=MOST).contains(&per_c) {
            return refused("the coefficient of temperature", per_c, "within ±0.05 per °C");
        }
        if !(0.0..=MOST).contains(&sd_per_c) {
            return refused(
                "the deviation of the coefficient of temperature",
                sd_per_c,
                "between 0 and 0.05 per °C",
            );
        }
    }
    Ok(())
}

/// Effect of temperature on one mode.
struct Covariate {
    /// κ ΔT.
    explained: f64,
    /// Standard deviation of κ, 1/°C; not used for a fitted line, which has `spread`.
    sd_per_c: f64,
    fitted: Option<FittedTemperature>,
    /// Result of a history, whose scatter is used instead.
    history: Option<HistoryEffect>,
    /// For a fitted line: variance of f' - f - b ΔT, Hz², its degrees of freedom, and the part of it that comes from the stated standard
    /// deviations, Hz².
    spread: Option<(f64, f64, f64)>,
}

fn covariate(
    pair: &ModePair,
    from: &Surveyed,
    to: &Surveyed,
    earlier: &[Surveyed],
    (options, notes): (&SurveyChangeOptions, &mut Vec<ChangeNote>),
) -> Result<Option<Covariate>, AssessError> {
    let step_c = to
        .temperature_c
        .zip(from.temperature_c)
        .map(|(after, before)| after - before);
    if is_undecided((&from.modes[pair.first], &to.modes[pair.second]), options) {
        return Ok(None);
    }
    let history = HistoryEffect::of_pair(&options.history, &from.modes[pair.first], &to.modes[pair.second]);
    if let Some(of) = history {
        let (explained, sd_per_c) = match (options.temperature, step_c) {
            (TemperatureEffect::Coefficient { per_c, sd_per_c }, Some(step_c)) if !of.knows_temperature => {
                (per_c * step_c, sd_per_c)
            }
            _ => (of.explained, 0.0),
        };
        return Ok(Some(Covariate {
            explained,
            sd_per_c,
            fitted: None,
            history: Some(of.clone()),
            spread: None,
        }));
    }
    let (Some(before_c), Some(after_c)) = (from.temperature_c, to.temperature_c) else {
        return Ok(None);
    };
    match options.temperature {
        TemperatureEffect::Unknown => Ok(None),
        TemperatureEffect::Coefficient { per_c, sd_per_c } => Ok(Some(Covariate {
            explained: per_c * (after_c - before_c),
            sd_per_c,
            fitted: None,
            history: None,
            spread: None,
        })),
        TemperatureEffect::Fitted => {
            let mode = &from.modes[pair.first];
            let point = |mode: &ObservedMode, temperature_c| FitPoint {
                temperature_c,
                frequency_hz: mode.frequency_hz,
                sd_hz: mode.frequency_sd_hz,
            };
            let mut points = vec![point(mode, before_c)];
            for survey in earlier {
                let Some(temperature_c) = survey.temperature_c else {
                    continue;
                };
                let paired = pair_modes(&from.modes, &survey.modes, &options.pairing)?;
                if let Some(same) = paired.pairs.iter().find(|other| other.first == pair.first) {
                    points.push(point(&survey.modes[same.second], temperature_c));
                }
            }
            about_the_line(&points, after_c, notes);
            match line(&points, after_c) {
                Ok(line) => Ok(Some(Covariate {
                    explained: line.explained_hz / mode.frequency_hz,
                    sd_per_c: line.fitted.sd_per_c,
                    spread: Some((line.variance_hz2, line.degrees_of_freedom, line.stated_hz2)),
                    fitted: Some(line.fitted),
                    history: None,
                })),
                Err(why) => {
                    notes.push(ChangeNote::NotFitted {
                        frequency_hz: mode.frequency_hz,
                        why: Box::new(why),
                    });
                    Ok(None)
                }
            }
        }
    }
}

/// Notes if a change of the structure may be contained in the fitted line. The first point is the survey that is compared.
fn about_the_line(points: &[FitPoint], after_c: f64, notes: &mut Vec<ChangeNote>) {
    let (Ok(line), Some((compared, others))) = (line(points, after_c), points.split_first()) else {
        return;
    };
    let stated: Vec<f64> = points.iter().filter_map(|point| point.sd_hz).collect();
    let stated_hz = (stated.iter().map(|sd| sd * sd).sum::<f64>() / stated.len().max(1) as f64).sqrt();
    let scatter_hz = line.fitted.scatter_hz;
    if stated.len() == points.len() && scatter_hz > SCATTER_BEYOND * stated_hz {
        notes.push(ChangeNote::LineScatters {
            frequency_hz: compared.frequency_hz,
            scatter_hz,
            stated_hz,
        });
    }
    // the position of the compared survey among the earlier ones is unknown: both ends are tried
    let with_order = |order: Vec<&FitPoint>| {
        let middle = 0.5 * (order.len() as f64 - 1.0);
        let mean_c = order.iter().map(|point| point.temperature_c).sum::<f64>() / order.len() as f64;
        let mut sums = [0.0; 3];
        for (at, point) in order.iter().enumerate() {
            let (x, y) = (at as f64 - middle, point.temperature_c - mean_c);
            for (sum, product) in sums.iter_mut().zip([x * x, x * y, y * y]) {
                *sum += product;
            }
        }
        sums[1] / (sums[0] * sums[2]).sqrt()
    };
    let at_the_end = with_order(others.iter().chain([compared]).collect());
    let at_the_start = with_order(points.iter().collect());
    let correlation = match at_the_start.abs() > at_the_end.abs() {
        true => at_the_start,
        false => at_the_end,
    };
    if correlation.abs() > WITH_TIME {
        notes.push(ChangeNote::LineWithTime {
            frequency_hz: compared.frequency_hz,
            correlation,
        });
    }
}

fn frequency_difference(
    (from, to): (&ObservedMode, &ObservedMode),
    covariate: &Option<Covariate>,
    step_c: Option<f64>,
    options: &SurveyChangeOptions,
) -> Raw {
    let f = from.frequency_hz;
    if is_undecided((from, to), options) {
        return Raw {
            relative: to.frequency_hz / f - 1.0,
            spread: None,
        };
    }
    let explained = covariate.as_ref().map_or(0.0, |c| c.explained);
    let of_temperature = f * step_c.unwrap_or(0.0) * covariate.as_ref().map_or(0.0, |c| c.sd_per_c);
    let history = covariate.as_ref().and_then(|c| c.history.as_ref());
    let of_history = history.map(|of| of.spread(from, to, of_temperature.powi(2)));
    let parts =
        of_history.or_else(
            || match (covariate.as_ref().and_then(|c| c.spread), to.frequency_sd_hz) {
                (Some((variance_hz2, nu, stated_hz2)), after) => {
                    // a survey with a larger standard deviation than those of the line scatters more than they do
                    let more = (after.unwrap_or(0.0).powi(2) - stated_hz2).max(0.0);
                    Some(welch(&[(variance_hz2, nu), (more, to.degrees_of_freedom)]))
                }
                (None, Some(after_hz)) => from.frequency_sd_hz.map(|before_hz| {
                    welch(&[
                        (after_hz.powi(2), to.degrees_of_freedom),
                        (((1.0 + explained) * before_hz).powi(2), from.degrees_of_freedom),
                        (of_temperature.powi(2), f64::INFINITY),
                    ])
                }),
                (None, None) => None,
            },
        );
    Raw {
        relative: to.frequency_hz / f - 1.0 - explained,
        spread: parts.map(|(variance, nu)| (variance.sqrt() / f, nu)),
    }
}

fn damping_difference((from, to): (&ObservedMode, &ObservedMode)) -> Option<Raw> {
    let (before, after) = (from.damping_ratio?, to.damping_ratio?);
    if before <= 0.0 {
        return None;
    }
    let sds = from.damping_ratio_sd.zip(to.damping_ratio_sd);
    Some(Raw {
        relative: after / before - 1.0,
        spread: sds.map(|(sd_before, sd_after)| {
            let (variance, nu) = welch(&[
                (sd_before.powi(2), from.degrees_of_freedom),
                (sd_after.powi(2), to.degrees_of_freedom),
            ]);
            (variance.sqrt() / before, nu)
        }),
    })
}

fn beyond_the_line(modes: &[ModeChange], temperature_c: Option<f64>, notes: &mut Vec<ChangeNote>) {
    let Some(temperature_c) = temperature_c else {
        return;
    };
    let fitted = modes.iter().filter_map(|m| m.fitted.as_ref());
    let mut beyond = fitted.filter(|line| !(line.range_c[0]..=line.range_c[1]).contains(&temperature_c));
    if let Some(line) = beyond.next() {
        notes.push(ChangeNote::BeyondTheLine {
            temperature_c,
            range_c: line.range_c,
        });
    }
}
