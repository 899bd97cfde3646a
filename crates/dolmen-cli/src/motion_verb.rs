//! `dolmen motion`: ground motions read, measured, matched, made and written.

use crate::cli::{GroundMotionVerb as Options, Language as Chosen, Shape};
use crate::{Outcome, files, motion};
use anyhow::{Context as _, Result, bail};
use dolmen::assess::demand::{
    DesignSpectrum, EurocodeGround, EurocodeType, KoreanSite, KoreanZone, eurocode_8, kds_17,
    kds_17_effective_acceleration_g,
};
use dolmen::signal::{
    Component, GroundMotion, Noise, PulseShape, SpectrumMatch, SpectrumMisfit, intensity_measures,
    match_spectrum, noise_motion, pulse, response_spectrum,
};
use dolmen_records::motions::{motion_at2, motion_csv, read_channels};
use dolmen_report::figures::motion_figures;
use dolmen_report::json::motion_report_json;
use dolmen_report::text::motion_report_text;
use dolmen_words::Language;
use dolmen_work::motion::{MatchAnswer, MotionReport, MotionSeries};
use std::path::Path;

/// Periods of a spectrum: so many, evenly spaced in their logarithm, s. Chosen here.
const PERIODS: usize = 200;
const PERIODS_S: [f64; 2] = [0.02, 4.0];
/// Periods on each side of the matched ones at which the misfit is told.
const OUTSIDE: usize = 40;

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    let mut report = MotionReport {
        files: Vec::new(),
        series: Vec::new(),
        matched: None,
    };
    let mut motions: Vec<(String, GroundMotion, Component)> = Vec::new();
    if let Some(shape) = options.make {
        let mut told = options.motion.clone();
        told.peak = None; // it is made with its peak
        let made = motion::changed_alone(made(shape, options)?, &told)?;
        motions.push((Component::X.name().to_owned(), made, Component::X));
    } else {
        read(options, &mut report, &mut motions)?;
    }
    if options.matched {
        matched(options, &mut report, &mut motions)?;
    }
    for (name, motion, component) in motions {
        let spectrum = if options.spectrum || options.matched {
            spectrum(&motion, component, options.damping)?
        } else {
            Vec::new()
        };
        let measures = intensity_measures(&motion, component).with_context(|| name.clone())?;
        report.series.push(MotionSeries {
            name,
            motion,
            component,
            measures,
            spectrum,
        });
    }
    if as_json {
        files::say(&format!("{:#}\n", motion_report_json(&report)))?;
    } else {
        files::say(&motion_report_text(&report))?;
    }
    written(options, &report, quiet)?;
    let is_close = report.matched.as_ref().is_none_or(MatchAnswer::is_close);
    Ok(if is_close {
        Outcome::Stands
    } else {
        Outcome::Unfinished
    })
}

/// The files with their channels, and the motions that they are: one of x, y, z, or each channel for itself.
fn read(
    options: &Options,
    report: &mut MotionReport,
    motions: &mut Vec<(String, GroundMotion, Component)>,
) -> Result<()> {
    let mut given = options.motion.clone();
    given.motion_file = options.files.clone();
    let told = motion::motion_options(&given)?;
    let mut channels = 0;
    for text in &given.motion_file {
        let file = motion::named_file(text).1;
        let bytes = files::read(Path::new(file))?;
        let found = read_channels(&bytes, &told).with_context(|| file.to_owned())?;
        channels = channels.max(found.len());
        report.files.push((file.to_owned(), found));
    }
    if channels > 1 && given.channel.is_none() && given.x_azimuth.is_none() {
        for (_, found) in &report.files {
            for (number, channel) in found.iter().enumerate() {
                let name = if channel.name.is_empty() {
                    format!("channel {}", number + 1)
                } else {
                    channel.name.clone()
                };
                let series = vec![(Component::X, channel.acceleration_m_s2.clone())];
                let alone = GroundMotion::new(name.clone(), channel.time_step_s, series)?;
                motions.push((name, motion::changed_alone(alone, &given)?, Component::X));
            }
        }
        return Ok(());
    }
    let motion = motion::motion_alone(&given)?.motion;
    for component in Component::ALL
        .into_iter()
        .filter(|component| motion.has(*component))
    {
        motions.push((component.name().to_owned(), motion.clone(), component));
    }
    Ok(())
}

fn made(shape: Shape, options: &Options) -> Result<GroundMotion> {
    let peak = options.motion.peak.as_deref().unwrap_or("1 m/s2");
    let peak_acceleration_m_s2 = motion::acceleration_m_s2(peak).context("--peak")?;
    let time_step_s = options.motion.sample_step.unwrap_or(0.01);
    let form = match shape {
        Shape::HalfSine => PulseShape::HalfSine,
        Shape::Sine => PulseShape::OneSine,
        Shape::Cosine => PulseShape::OneCosine,
        Shape::Ricker => PulseShape::RickerEven,
        Shape::RickerOdd => PulseShape::RickerOdd,
        Shape::NearFault => PulseShape::MavroeidisPapageorgiou {
            gamma: options.gamma,
            phase_rad: options.phase.to_radians(),
        },
        Shape::Noise => {
            let noise = Noise {
                duration_s: options.duration,
                time_step_s,
                peak_acceleration_m_s2,
                ..Noise::default()
            };
            return Ok(noise_motion(&noise, options.seed)?);
        }
    };
    Ok(pulse(form, options.period, peak_acceleration_m_s2, time_step_s)?)
}

/// The demand that --code and what belongs to it name.
fn demand(options: &Options) -> Result<DesignSpectrum> {
    let site = options.site.to_uppercase();
    if let Some(acceleration_g) = options.ground_acceleration {
        let grounds = [
            EurocodeGround::A,
            EurocodeGround::B,
            EurocodeGround::C,
            EurocodeGround::D,
            EurocodeGround::E,
        ];
        let Some(ground) = grounds.into_iter().find(|ground| format!("{ground:?}") == site) else {
            bail!(
                "--site is \"{}\", but a ground of Eurocode 8 is A, B, C, D or E",
                options.site
            );
        };
        let kind = if options.spectrum_type == 2 {
            EurocodeType::Two
        } else {
            EurocodeType::One
        };
        return Ok(eurocode_8(acceleration_g, kind, ground)?);
    }
    let sites = [
        KoreanSite::S1,
        KoreanSite::S2,
        KoreanSite::S3,
        KoreanSite::S4,
        KoreanSite::S5,
        KoreanSite::S6,
    ];
    let Some(site) = sites.into_iter().find(|known| format!("{known:?}") == site) else {
        bail!(
            "--site is \"{}\", but a site of KDS 17 10 00 is S1 to S5; for Eurocode 8 give --ground-acceleration too",
            options.site
        );
    };
    let zone = if options.zone == 2 {
        KoreanZone::II
    } else {
        KoreanZone::I
    };
    Ok(kds_17(
        kds_17_effective_acceleration_g(zone, options.years)?,
        site,
    )?)
}

fn matched(
    options: &Options,
    report: &mut MotionReport,
    motions: &mut [(String, GroundMotion, Component)],
) -> Result<()> {
    let Some((_, motion, component)) = motions.first() else {
        bail!("no motion is given to match");
    };
    if motions.iter().any(|(_, other, _)| other.name() != motion.name()) {
        bail!(
            "the file has several channels: name the one to match with --channel, or turn them to x and y with --x-azimuth"
        );
    }
    let (component, demand) = (*component, demand(options)?);
    let told = SpectrumMatch {
        damping_ratio: options.damping,
        ..SpectrumMatch::default()
    };
    demand.acceleration_m_s2(told.period_least_s, options.damping)?; // refuses the damping ratio
    let target = |period_s: f64| {
        demand
            .acceleration_m_s2(period_s, options.damping)
            .unwrap_or(f64::NAN)
    };
    let matched = match_spectrum(motion, component, &target, &told)?;
    for (_, motion, _) in motions.iter_mut() {
        *motion = matched.motion.clone();
    }
    let outside =
        |periods_s: [f64; 2]| misfit(&matched.motion, component, &target, (periods_s, options.damping));
    let outside = [
        outside([PERIODS_S[0], told.period_least_s])?,
        outside([told.period_most_s, PERIODS_S[1]])?,
    ];
    report.matched = Some(MatchAnswer {
        outside,
        demand: demand.source.clone(),
        matched,
        damping_ratio: options.damping,
        component,
    });
    Ok(())
}

/// How far a spectrum is from a demand, over some periods.
fn misfit(
    motion: &GroundMotion,
    component: Component,
    target: &dyn Fn(f64) -> f64,
    (periods_s, damping_ratio): ([f64; 2], f64),
) -> Result<SpectrumMisfit> {
    let ratio = periods_s[1] / periods_s[0];
    let periods: Vec<f64> = (0..OUTSIDE)
        .map(|k| periods_s[0] * ratio.powf(k as f64 / (OUTSIDE - 1) as f64))
        .collect();
    let found = response_spectrum(motion, component, &periods, damping_ratio)?;
    let off: Vec<f64> = found
        .iter()
        .map(|o| o.pseudo_acceleration_m_s2() / target(o.period_s) - 1.0)
        .collect();
    Ok(SpectrumMisfit {
        root_mean_square: (off.iter().map(|x| x * x).sum::<f64>() / OUTSIDE as f64).sqrt(),
        lowest: off.iter().copied().fold(f64::INFINITY, f64::min),
        highest: off.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    })
}

fn spectrum(
    motion: &GroundMotion,
    component: Component,
    damping_ratio: f64,
) -> Result<Vec<dolmen::signal::SpectralOrdinate>> {
    let ratio = PERIODS_S[1] / PERIODS_S[0];
    let periods: Vec<f64> = (0..PERIODS)
        .map(|k| PERIODS_S[0] * ratio.powf(k as f64 / (PERIODS - 1) as f64))
        .collect();
    Ok(response_spectrum(motion, component, &periods, damping_ratio)?)
}

/// The motion as --convert names it, and everything of the report into --output.
fn written(options: &Options, report: &MotionReport, quiet: bool) -> Result<()> {
    let mut said = Vec::new();
    if let Some(file) = &options.convert {
        let Some(first) = report.series.first() else {
            bail!("no motion is given to write")
        };
        if report.series.iter().any(|other| other.motion != first.motion) {
            bail!(
                "the channels are no motion of x, y and z: name one with --channel, or turn them with --x-azimuth"
            );
        }
        let ending = file
            .extension()
            .map(|e| e.to_string_lossy().to_lowercase())
            .unwrap_or_default();
        match (ending.as_str(), report.series.len()) {
            ("csv", _) => files::write(file, motion_csv(&first.motion).as_bytes())?,
            ("at2", 1) => files::write(file, motion_at2(&first.motion, first.component).as_bytes())?,
            ("at2", count) => {
                bail!("AT2 holds one component, but the motion has {count}: write .csv, or give one file")
            }
            _ => bail!(
                "{} ends in neither .csv nor .at2, the formats that are written",
                file.display()
            ),
        }
        said.push(file.display().to_string());
    }
    if let Some(folder) = &options.output {
        let language = match options.language {
            Chosen::En => Language::English,
            Chosen::Ko => Language::Korean,
        };
        for figure in motion_figures(report, language) {
            files::write(
                &folder.join(format!("{}.svg", figure.name)),
                figure.svg.as_bytes(),
            )?;
        }
        files::write(
            &folder.join("motion.json"),
            format!("{:#}\n", motion_report_json(report)).as_bytes(),
        )?;
        if report.series.iter().any(|one| !one.spectrum.is_empty()) {
            files::write(&folder.join("spectrum.csv"), spectrum_csv(report).as_bytes())?;
        }
        said.push(folder.display().to_string());
    }
    if !quiet && !said.is_empty() {
        note!("wrote {}", said.join(", "));
    }
    Ok(())
}

fn spectrum_csv(report: &MotionReport) -> String {
    let mut out = "series,period_s,damping_ratio,displacement_m,displacement_at_samples_m,at_s,pseudo_velocity_m_s,pseudo_acceleration_m_s2\n".to_owned();
    for one in &report.series {
        let name = format!("\"{}\"", one.name.replace('"', "'"));
        for o in &one.spectrum {
            out += &format!(
                "{name},{},{},{},{},{},{},{}\n",
                o.period_s,
                o.damping_ratio,
                o.displacement_m,
                o.displacement_at_samples_m,
                o.at_s,
                o.pseudo_velocity_m_s(),
                o.pseudo_acceleration_m_s2()
            );
        }
    }
    out
}
