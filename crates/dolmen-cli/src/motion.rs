//! Ground motions from what was typed: carried along or read from files, then changed step by step.

use crate::cli::Motion as Options;
use crate::files;
use anyhow::{Context as _, Result, bail};
use dolmen::signal::{Component, GroundMotion, Quantity};
use dolmen_formats::motions::{MotionOptions, read_motion};
use dolmen_formats::records::Unit;
use dolmen_formats::simulation::MotionAnswer;
use std::path::Path;

/// The motions that the command carries with it: name, file as it is called in `data/`, and its bytes.
const CARRIED: [(&str, &str, &[u8]); 1] = [(
    "el-centro-1940-ns",
    "el_centro_1940_ns.csv",
    include_bytes!("../../../data/el_centro_1940_ns/el_centro_1940_ns.csv"),
)];

/// Whether a motion was asked for.
pub(crate) fn is_given(options: &Options) -> bool {
    options.motion.is_some() || !options.motion_file.is_empty()
}

/// Whether something is to be done to it.
pub(crate) fn is_changed(options: &Options) -> bool {
    let numbers = [options.keep_first, options.taper, options.turn, options.scale];
    numbers.iter().any(Option::is_some) || options.peak.is_some()
}

/// The motion that was asked for, ready to act.
pub(crate) fn motion(options: &Options) -> Result<MotionAnswer> {
    let mut answer = match &options.motion {
        Some(name) => carried(name)?,
        None if options.motion_file.is_empty() => bail!(
            "no motion is given: name files with --motion-file, or take --motion {}",
            names()
        ),
        None => from_files(options)?,
    };
    answer.motion = changed(answer.motion, options)?;
    Ok(answer)
}

fn names() -> String {
    CARRIED.map(|(name, ..)| name).join(", ")
}

fn carried(name: &str) -> Result<MotionAnswer> {
    let same = |known: &str| known == name || known.replace('-', "_") == name;
    let Some((name, file, bytes)) = CARRIED.into_iter().find(|(known, ..)| same(known)) else {
        bail!(
            "there is no motion \"{name}\": known are {}; other motions come from files with --motion-file",
            names()
        );
    };
    let motion = read_motion(name, &[(Component::X, bytes)], &MotionOptions::default())?;
    Ok(of_files(motion, vec![(Component::X, file.to_owned())]))
}

fn of_files(motion: GroundMotion, files: Vec<(Component, String)>) -> MotionAnswer {
    let peaks = files
        .iter()
        .map(|(component, _)| (*component, motion.component_peak_m_s2(*component)));
    MotionAnswer {
        peaks_read_m_s2: peaks.collect(),
        motion,
        files,
    }
}

fn from_files(options: &Options) -> Result<MotionAnswer> {
    let mut named: Vec<(Component, String)> = Vec::new();
    for (position, text) in options.motion_file.iter().enumerate() {
        let split = text.split_once('=').and_then(|(before, file)| {
            let component = Component::ALL.into_iter().find(|c| c.name() == before)?;
            Some((component, file))
        });
        let (component, file) = split.unwrap_or((Component::ALL[position.min(2)], text));
        if named.iter().any(|(other, _)| *other == component) {
            bail!(
                "--motion-file: the {component} component is given twice; name each as in {component}=FILE"
            );
        }
        named.push((component, file.to_owned()));
    }
    let read = MotionOptions {
        unit: match &options.unit {
            Some(unit) => Some(Unit::parse(unit)?),
            None => None,
        },
        time_step_s: options.sample_step,
        ..MotionOptions::default()
    };
    let mut bytes = Vec::new();
    for (component, file) in &named {
        bytes.push((*component, files::read(Path::new(file))?));
    }
    let parts: Vec<(Component, &[u8])> = bytes.iter().map(|(c, b)| (*c, b.as_slice())).collect();
    let stems: Vec<String> = named
        .iter()
        .map(|(_, file)| {
            Path::new(file)
                .file_stem()
                .map(|s| s.to_string_lossy().into_owned())
        })
        .map(Option::unwrap_or_default)
        .collect();
    let files: Vec<&str> = named.iter().map(|(_, file)| file.as_str()).collect();
    let motion = read_motion(&stems.join(" + "), &parts, &read).with_context(|| files.join(", "))?;
    Ok(of_files(motion, named))
}

/// Cut, tapered, turned, scaled, in this order.
fn changed(mut motion: GroundMotion, options: &Options) -> Result<GroundMotion> {
    if let Some(seconds) = options.keep_first {
        motion = motion.keep_first(seconds).context("--keep-first")?;
    }
    if let Some(seconds) = options.taper {
        motion = motion.tapered(seconds).context("--taper")?;
    }
    if let Some(degrees) = options.turn {
        motion = motion.rotated(degrees.to_radians()).context("--turn")?;
    }
    if let Some(factor) = options.scale {
        motion = motion.scaled(factor).context("--scale")?;
    }
    if let Some(peak) = &options.peak {
        let wanted = acceleration_m_s2(peak).context("--peak")?;
        let horizontal = [Component::X, Component::Y];
        let largest = horizontal
            .into_iter()
            .max_by(|a, b| {
                let of = |c: &Component| motion.component_peak_m_s2(*c);
                of(a).total_cmp(&of(b)).then(b.name().cmp(a.name()))
            })
            .filter(|c| motion.component_peak_m_s2(*c) > 0.0)
            .unwrap_or(Component::Z);
        motion = motion.scaled_to_peak(largest, wanted).context("--peak")?;
    }
    Ok(motion)
}

/// "0.3 g", "2.94 m/s2", "294 gal" as m/s².
fn acceleration_m_s2(text: &str) -> Result<f64> {
    let text = text.trim();
    let end = text
        .char_indices()
        .find(|(at, c)| {
            let exponent = matches!(c, 'e' | 'E')
                && text[at + 1..].starts_with(|n: char| n.is_ascii_digit() || n == '-');
            !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+') || exponent)
        })
        .map_or(text.len(), |(at, _)| at);
    let (number, unit) = text.split_at(end);
    let Ok(value) = number.parse::<f64>() else {
        bail!("\"{text}\" is no acceleration: write it as \"0.3 g\" or \"2.94 m/s2\"");
    };
    let unit = unit.trim();
    if unit.is_empty() {
        bail!("\"{text}\" has no unit: write \"{value} g\" or \"{value} m/s2\"");
    }
    let unit = Unit::parse(unit)?;
    if unit.quantity() != Quantity::Acceleration {
        bail!("\"{text}\" is no acceleration: write it as \"0.3 g\" or \"2.94 m/s2\"");
    }
    Ok(value * unit.si())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_accelerations_with_their_unit() {
        for (text, exact) in [
            ("0.3 g", 0.3 * 9.80665),
            ("0.3g", 0.3 * 9.80665),
            ("2.5e0 m/s2", 2.5),
            ("250 gal", 2.5),
        ] {
            assert!((acceleration_m_s2(text).unwrap() - exact).abs() < 1e-14, "{text}");
        }
    }

    #[test]
    fn refuses_accelerations_without_unit_or_of_another_quantity() {
        for (text, said) in [
            ("0.3", "has no unit"),
            ("0.3 m", "no acceleration"),
            ("g", "no acceleration"),
            ("3 kg", "kg"),
        ] {
            let message = format!("{:#}", acceleration_m_s2(text).unwrap_err());
            assert!(message.contains(said), "{message}");
        }
    }
}
