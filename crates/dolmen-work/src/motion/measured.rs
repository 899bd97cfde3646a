//! `dolmen motion`: ground motions read, measured, matched and made.

use super::answer::{MatchAnswer, MotionReport, MotionSeries};
use super::demand::{Demand, demand, range};
use super::error::MotionRequestError;
use super::prepare::{acceleration_m_s2, changed_alone, motion_alone, motion_options};
use super::request::MotionRequest;
use super::wanted_file::{given_files, typed_columns};
use crate::error::{Within as _, WorkError};
use dolmen::signal::{
    Component, GroundMotion, Noise, Processing, PulseShape, SpectralOrdinate, SpectrumMatch, SpectrumMisfit,
    intensity_measures, match_spectrum, noise_motion, pulse, pulse_periods_s, response_spectrum,
};
use dolmen_records::motions::{
    ComponentReading, MotionOptions as ReadOptions, read_channels, read_component,
};

/// Number of periods of a spectrum, evenly spaced in their logarithm, and their range, s. Our choice.
const PERIODS: usize = 200;
const PERIODS_S: [f64; 2] = [0.02, 4.0];
/// Number of periods on each side of the matched ones for the misfit in the answer.
const OUTSIDE: usize = 40;
/// Factor by which they extend beyond the matched ones.
const OUTSIDE_LEAST: f64 = 4.0 / 3.0;
/// Number of periods among the matched ones: four times as dense as in the fit. Our choice.
const INSIDE: usize = 600;

/// Options of `dolmen motion`.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionOptions {
    /// The motion and its changes, unless one is made.
    pub request: MotionRequest,
    /// A motion to make instead; the request holds its peak.
    pub made: Option<MadeMotion>,
    /// Whether the response spectrum is computed.
    pub spectrum: bool,
    /// Damping ratio of spectra.
    pub damping_ratio: f64,
    /// The demand spectrum that the first component is matched to.
    pub matched: Option<Demand>,
    /// The periods of the match, s.
    pub range_s: [f64; 2],
}

/// A motion to make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MadeMotion {
    /// Its shape.
    pub shape: MotionShape,
    /// Period of a pulse, s.
    pub period_s: f64,
    /// Half cycles of a near-fault pulse, above 1.
    pub gamma: f64,
    /// Phase of a near-fault pulse, degrees.
    pub phase_deg: f64,
    /// Length of noise, s.
    pub duration_s: f64,
    /// Seed of noise.
    pub seed: u64,
}

/// Shapes of motions that can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionShape {
    /// Half a sine wave; a velocity remains.
    HalfSine,
    /// One sine wave; a displacement remains.
    Sine,
    /// One cosine wave; nothing remains.
    Cosine,
    /// Ricker's wavelet, even.
    Ricker,
    /// Ricker's wavelet, odd.
    RickerOdd,
    /// Near-fault pulse of Mavroeidis and Papageorgiou.
    NearFault,
    /// Seeded noise of firm ground (Clough and Penzien) with an envelope.
    Noise,
}

/// A series under its name.
struct Named {
    name: String,
    motion: GroundMotion,
    component: Component,
}

/// Measures, spectra and matches of the requested motions.
///
/// # Errors
/// [`WorkError`] if a file cannot be read, a step is impossible, or the motion cannot be matched.
pub fn motion(options: &MotionOptions) -> Result<MotionReport, WorkError> {
    let mut report = MotionReport {
        files: Vec::new(),
        series: Vec::new(),
        matched: None,
    };
    let mut motions: Vec<Named> = Vec::new();
    if let Some(wanted) = &options.made {
        // the sample step of the request is its step
        let rest = MotionRequest {
            sample_step_s: None,
            ..options.request.clone()
        };
        if let Some(flag) = rest.of_files() {
            return Err(MotionRequestError::OfFilesNotMade { flag }.into());
        }
        let told = MotionRequest {
            peak: None, // its own peak is used
            ..options.request.clone()
        };
        motions.extend(moving(&changed_alone(made(wanted, &options.request)?, &told)?));
    } else {
        read(&options.request, &mut report, &mut motions)?;
    }
    if let Some(wanted) = &options.matched {
        matched(wanted, options, &mut report, &mut motions)?;
    }
    for Named {
        name,
        motion,
        component,
    } in motions
    {
        let spectrum = match options.spectrum || options.matched.is_some() {
            true => spectrum(&motion, component, options.damping_ratio)?,
            false => Vec::new(),
        };
        let measures = intensity_measures(&motion, component).within(|| name.clone())?;
        report.series.push(MotionSeries {
            name,
            motion,
            component,
            measures,
            spectrum,
        });
    }
    Ok(report)
}

/// The files with their channels, and the motions in them: one of x, y, z, or each channel alone.
fn read(
    request: &MotionRequest,
    report: &mut MotionReport,
    motions: &mut Vec<Named>,
) -> Result<(), WorkError> {
    let told = motion_options(request)?;
    let mut channels = 0;
    if request.columns.is_empty() {
        for file in &request.files {
            let found = read_channels(&file.bytes, &told).within(|| file.name.clone())?;
            channels = channels.max(found.len());
            report.files.push((file.name.clone(), found));
        }
    } else {
        report.files = named_columns(request, &told)?;
    }
    let are_told =
        request.channel.is_some() || request.x_azimuth_deg.is_some() || !request.columns.is_empty();
    if channels > 1 && !are_told {
        if request.turn_deg.is_some() {
            return Err(MotionRequestError::TurnOfChannels { channels }.into());
        }
        for (_, found) in &report.files {
            for (number, channel) in found.iter().enumerate() {
                let name = match channel.name.is_empty() {
                    true => format!("channel {}", number + 1),
                    false => channel.name.clone(),
                };
                let series = vec![(Component::X, channel.acceleration_m_s2.clone())];
                let alone = GroundMotion::new(name.clone(), channel.time_step_s, series)?;
                motions.push(Named {
                    name,
                    motion: changed_alone(alone, request)?,
                    component: Component::X,
                });
            }
        }
        return Ok(());
    }
    motions.extend(moving(&motion_alone(request)?.motion));
    Ok(())
}

/// Each file with the columns that the request names: its other columns may measure something else.
fn named_columns(
    request: &MotionRequest,
    told: &ReadOptions,
) -> Result<Vec<(String, Vec<ComponentReading>)>, WorkError> {
    let mut files: Vec<(String, Vec<ComponentReading>)> = Vec::new();
    for file in typed_columns(given_files(&request.files)?, &request.columns)? {
        let told = ReadOptions {
            channel: file.channel.or_else(|| told.channel.clone()),
            ..told.clone()
        };
        let bytes = file.bytes.unwrap_or_default();
        let found = read_component(&bytes, &told).within(|| file.name.clone())?;
        match files.iter_mut().find(|(name, _)| *name == file.name) {
            Some((_, channels)) => channels.push(found),
            None => files.push((file.name, vec![found])),
        }
    }
    Ok(files)
}

/// The components of a motion, without those that a rotation leaves at rest: after a quarter turn, the old axis.
fn moving(motion: &GroundMotion) -> Vec<Named> {
    let is_turned = |done: &Processing| matches!(done, Processing::Rotated { .. });
    let is_turned = motion.history().iter().any(is_turned);
    let given = Component::ALL.into_iter().filter(|of| motion.has(*of));
    let shown = given.filter(|of| !is_turned || motion.component_peak_m_s2(*of) > 0.0);
    let named = shown.map(|component| Named {
        name: component.name().to_owned(),
        motion: motion.clone(),
        component,
    });
    named.collect()
}

fn made(wanted: &MadeMotion, request: &MotionRequest) -> Result<GroundMotion, WorkError> {
    let peak = request.peak.as_deref().unwrap_or("1 m/s2");
    let peak_acceleration_m_s2 = acceleration_m_s2(peak).within(|| "--peak".to_owned())?;
    let time_step_s = request.sample_step_s.unwrap_or(0.01);
    let form = match wanted.shape {
        MotionShape::HalfSine => PulseShape::HalfSine,
        MotionShape::Sine => PulseShape::OneSine,
        MotionShape::Cosine => PulseShape::OneCosine,
        MotionShape::Ricker => PulseShape::RickerEven,
        MotionShape::RickerOdd => PulseShape::RickerOdd,
        MotionShape::NearFault => PulseShape::MavroeidisPapageorgiou {
            gamma: wanted.gamma,
            phase_rad: wanted.phase_deg.to_radians(),
        },
        MotionShape::Noise => {
            let noise = Noise {
                duration_s: wanted.duration_s,
                time_step_s,
                peak_acceleration_m_s2,
                ..Noise::default()
            };
            return Ok(noise_motion(&noise, wanted.seed)?);
        }
    };
    let [least_s, most_s] = pulse_periods_s(time_step_s);
    let given_s = wanted.period_s;
    if !(least_s..=most_s).contains(&given_s) {
        let wrong = MotionRequestError::PeriodTyped {
            given_s,
            least_s,
            most_s,
        };
        return Err(wrong.into());
    }
    Ok(pulse(form, wanted.period_s, peak_acceleration_m_s2, time_step_s)?)
}

fn matched(
    wanted: &Demand,
    options: &MotionOptions,
    report: &mut MotionReport,
    motions: &mut [Named],
) -> Result<(), WorkError> {
    let Some(Named {
        motion, component, ..
    }) = motions.first()
    else {
        return Err(MotionRequestError::NothingToMatch.into());
    };
    if motions.iter().any(|other| other.motion.name() != motion.name()) {
        return Err(MotionRequestError::SeveralToMatch.into());
    }
    let (component, demand) = (*component, demand(wanted)?);
    let damping_ratio = options.damping_ratio;
    let [period_least_s, period_most_s] = range(options.range_s)?;
    let told = SpectrumMatch {
        damping_ratio,
        period_least_s,
        period_most_s,
        ..SpectrumMatch::default()
    };
    demand.acceleration_m_s2(told.period_least_s, damping_ratio)?; // checks the damping ratio
    let target = |period_s: f64| {
        demand
            .acceleration_m_s2(period_s, damping_ratio)
            .unwrap_or(f64::NAN)
    };
    let mut matched = match_spectrum(motion, component, &target, &told)?;
    // also between the fitted periods
    let fitted = [told.period_least_s, told.period_most_s];
    let between = misfit(
        &matched.motion,
        component,
        &target,
        (fitted, damping_ratio),
        INSIDE,
    )?;
    matched.after = SpectrumMisfit {
        lowest: matched.after.lowest.min(between.lowest),
        highest: matched.after.highest.max(between.highest),
        ..between
    };
    for one in motions.iter_mut() {
        one.motion = matched.motion.clone();
    }
    let outside = |periods_s: [f64; 2]| {
        misfit(
            &matched.motion,
            component,
            &target,
            (periods_s, damping_ratio),
            OUTSIDE,
        )
    };
    let outside = [
        outside([
            PERIODS_S[0].min(told.period_least_s / OUTSIDE_LEAST),
            told.period_least_s,
        ])?,
        outside([
            told.period_most_s,
            PERIODS_S[1].max(told.period_most_s * OUTSIDE_LEAST),
        ])?,
    ];
    report.matched = Some(MatchAnswer {
        outside,
        demand: demand.source.clone(),
        matched,
        damping_ratio,
        component,
    });
    Ok(())
}

/// Difference of a spectrum from a demand over some periods.
pub(super) fn misfit(
    motion: &GroundMotion,
    component: Component,
    target: &dyn Fn(f64) -> f64,
    (periods_s, damping_ratio): ([f64; 2], f64),
    count: usize,
) -> Result<SpectrumMisfit, WorkError> {
    let ratio = periods_s[1] / periods_s[0];
    let periods: Vec<f64> = (0..count)
        .map(|k| periods_s[0] * ratio.powf(k as f64 / (count - 1) as f64))
        .collect();
    let found = response_spectrum(motion, component, &periods, damping_ratio)?;
    let off: Vec<f64> = found
        .iter()
        .map(|o| o.pseudo_acceleration_m_s2() / target(o.period_s) - 1.0)
        .collect();
    Ok(SpectrumMisfit {
        root_mean_square: (off.iter().map(|x| x * x).sum::<f64>() / count as f64).sqrt(),
        lowest: off.iter().copied().fold(f64::INFINITY, f64::min),
        highest: off.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    })
}

fn spectrum(
    motion: &GroundMotion,
    component: Component,
    damping_ratio: f64,
) -> Result<Vec<SpectralOrdinate>, WorkError> {
    let ratio = PERIODS_S[1] / PERIODS_S[0];
    let periods: Vec<f64> = (0..PERIODS)
        .map(|k| PERIODS_S[0] * ratio.powf(k as f64 / (PERIODS - 1) as f64))
        .collect();
    Ok(response_spectrum(motion, component, &periods, damping_ratio)?)
}
