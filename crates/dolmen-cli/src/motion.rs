//! Ground motions from what was typed: carried along or read from files, then changed step by step.

use crate::cli::Motion as Options;
use crate::files;
use anyhow::{Context as _, Result, bail};
use dolmen::signal::{Baseline, Component, GroundMotion, Quantity};
use dolmen_project::{MotionPart, MotionSize, MotionSource, Project, Structure};
use dolmen_records::motions::{Lengths, MotionOptions, StatedPeak, read_motion, read_oriented};
use dolmen_records::records::Unit;
use dolmen_work::simulation::MotionAnswer;
use std::path::{Path, PathBuf};

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
    let base_line = options.baseline.is_some() || options.high_pass.is_some();
    numbers.iter().any(Option::is_some) || options.peak.is_some() || base_line
}

/// A motion by its name, as if it had been typed.
pub(crate) fn named(name: &str) -> Options {
    Options {
        motion: Some(name.to_owned()),
        motion_file: Vec::new(),
        unit: None,
        sample_step: None,
        channel: None,
        factor: 1.0,
        shortest: false,
        ignore_stated_peak: false,
        x_azimuth: None,
        baseline: None,
        high_pass: None,
        keep_first: None,
        taper: None,
        turn: None,
        scale: None,
        peak: None,
    }
}

/// What is to be read and done: the file's words, with what was typed in their place.
struct Wanted {
    from: From,
    unit: Option<String>,
    sample_step_s: Option<f64>,
    keep_first_s: Option<f64>,
    taper_s: Option<f64>,
    turn_rad: Option<f64>,
    /// Scaled before it is turned, as studies do for what moves in plan: turning then leaves the strength of the shaking as it is.
    is_sized_first: bool,
    size: Option<MotionSize>,
    /// What else is told of the files, and done to what they hold: typed only.
    read: MotionOptions,
    x_azimuth_deg: Option<f64>,
    baseline: Option<usize>,
    high_pass_hz: Option<f64>,
    /// Where complaints about what the project file says belong.
    part: Option<String>,
}

enum From {
    Carried(String),
    /// Component, the file as it was named, where it is.
    Files(Vec<(Component, String, PathBuf)>),
}

/// The motion that was asked for, ready to act: of the project file, carried along, or from files. What is typed goes before
/// what the project file says.
pub(crate) fn motion(options: &Options, project: &Project, file: &Path) -> Result<MotionAnswer> {
    prepared(options, Some((project, file)))
}

/// The same without a project file.
pub(crate) fn motion_alone(options: &Options) -> Result<MotionAnswer> {
    prepared(options, None)
}

/// A motion changed as it was typed, but for its size, which it was made with.
pub(crate) fn changed_alone(motion: GroundMotion, options: &Options) -> Result<GroundMotion> {
    let mut told = options.clone();
    (told.motion, told.motion_file) = (Some(CARRIED[0].0.to_owned()), Vec::new());
    changed(motion, &wanted(&told, None)?)
}

fn prepared(options: &Options, project: Option<(&Project, &Path)>) -> Result<MotionAnswer> {
    let wanted = wanted(options, project)?;
    let mut answer = match &wanted.from {
        From::Carried(name) => carried(name)?,
        From::Files(files) => from_files(files, &wanted)?,
    };
    answer.motion = changed(answer.motion, &wanted)?;
    Ok(answer)
}

fn wanted(options: &Options, project: Option<(&Project, &Path)>) -> Result<Wanted> {
    let own = project.map_or(&[][..], |(project, _)| &project.motions[..]);
    let file = project.map_or(Path::new("."), |(_, file)| file);
    let part = match &options.motion {
        Some(name) => own.iter().find(|part| part.name == *name),
        None => None,
    };
    let from = match (&options.motion, part) {
        (_, Some(part)) => match &part.from {
            MotionSource::BuiltIn(name) => From::Carried(name.clone()),
            MotionSource::Files(files) => {
                let folder = file.parent().unwrap_or(Path::new("."));
                let each = files
                    .iter()
                    .map(|(component, name)| (*component, name.clone(), folder.join(name)));
                From::Files(each.collect())
            }
        },
        (Some(name), None) if is_carried(name) => From::Carried(name.clone()),
        (Some(name), None) => bail!(
            "there is no motion \"{name}\": known are {}; other motions come from files with --motion-file, or stand in the \
             project file as [motion.{name}]",
            names(own)
        ),
        (None, _) if options.motion_file.is_empty() => bail!(
            "no motion is given: name files (`dolmen simulate`: with --motion-file), or take --motion {}",
            names(own)
        ),
        (None, _) => From::Files(typed_files(options)?),
    };
    let typed_size = match (options.scale, &options.peak) {
        (Some(factor), _) => Some(MotionSize::Scale(factor)),
        (None, Some(peak)) => Some(MotionSize::Peak(acceleration_m_s2(peak).context("--peak")?)),
        (None, None) => None,
    };
    let of = |read: fn(&MotionPart) -> Option<f64>| part.and_then(read);
    Ok(Wanted {
        from,
        unit: options.unit.clone().or_else(|| part?.unit.clone()),
        sample_step_s: options.sample_step.or_else(|| of(|part| part.sample_step_s)),
        keep_first_s: options.keep_first.or_else(|| of(|part| part.keep_first_s)),
        taper_s: options.taper.or_else(|| of(|part| part.taper_s)),
        turn_rad: options
            .turn
            .map(f64::to_radians)
            .or_else(|| of(|part| part.turn_rad)),
        is_sized_first: project.is_some_and(|(project, _)| {
            matches!(project.structure, Structure::Stack(_) | Structure::Building(_))
        }),
        size: typed_size.or_else(|| part?.size),
        read: motion_options(options)?,
        x_azimuth_deg: options.x_azimuth,
        baseline: options.baseline,
        high_pass_hz: options.high_pass,
        part: part.map(|part| format!("motion.{}", part.name)),
    })
}

/// The motions there are: those of the project file, then those carried along.
fn names(own: &[MotionPart]) -> String {
    let own = own.iter().map(|part| part.name.as_str());
    own.chain(CARRIED.map(|(name, ..)| name))
        .collect::<Vec<_>>()
        .join(", ")
}

fn find(name: &str) -> Option<(&'static str, &'static str, &'static [u8])> {
    let same = |known: &str| known == name || known.replace('-', "_") == name;
    CARRIED.into_iter().find(|(known, ..)| same(known))
}

fn is_carried(name: &str) -> bool {
    find(name).is_some()
}

fn carried(name: &str) -> Result<MotionAnswer> {
    let Some((name, file, bytes)) = find(name) else {
        let known = CARRIED.map(|(known, ..)| known).join(", ");
        bail!("there is no built-in motion \"{name}\": known are {known}");
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

/// "y" and "FILE" of "y=FILE"; a text without a component is a file.
pub(crate) fn named_file(text: &str) -> (Option<Component>, &str) {
    let split = text.split_once('=').and_then(|(before, file)| {
        let component = Component::ALL.into_iter().find(|c| c.name() == before)?;
        Some((Some(component), file))
    });
    split.unwrap_or((None, text))
}

/// What is told of the files.
pub(crate) fn motion_options(options: &Options) -> Result<MotionOptions> {
    Ok(MotionOptions {
        unit: match &options.unit {
            Some(unit) => Some(Unit::parse(unit)?),
            None => None,
        },
        time_step_s: options.sample_step,
        channel: options.channel.clone(),
        factor: options.factor,
        stated_peak: if options.ignore_stated_peak {
            StatedPeak::Ignore
        } else {
            StatedPeak::Check
        },
        lengths: if options.shortest {
            Lengths::Shortest
        } else {
            Lengths::Same
        },
        ..MotionOptions::default()
    })
}

/// The files of the command line, each with its component.
fn typed_files(options: &Options) -> Result<Vec<(Component, String, PathBuf)>> {
    let mut named: Vec<(Component, String, PathBuf)> = Vec::new();
    for (position, text) in options.motion_file.iter().enumerate() {
        let (component, file) = named_file(text);
        let component = component.unwrap_or(Component::ALL[position.min(2)]);
        if named.iter().any(|(other, ..)| *other == component) {
            bail!(
                "--motion-file: the {component} component is given twice; name each as in {component}=FILE"
            );
        }
        named.push((component, file.to_owned(), PathBuf::from(file)));
    }
    Ok(named)
}

fn from_files(named: &[(Component, String, PathBuf)], wanted: &Wanted) -> Result<MotionAnswer> {
    let read = MotionOptions {
        unit: match &wanted.unit {
            Some(unit) => Some(Unit::parse(unit)?),
            None => None,
        },
        time_step_s: wanted.sample_step_s,
        ..wanted.read.clone()
    };
    let place = |file: &str| match &wanted.part {
        Some(part) => format!("{part}.files: {file}"),
        None => file.to_owned(),
    };
    let mut bytes = Vec::new();
    for (component, name, path) in named {
        let read = files::read(path);
        bytes.push((
            *component,
            match &wanted.part {
                Some(_) => read.with_context(|| place(name))?,
                None => read?,
            },
        ));
    }
    let parts: Vec<(Component, &[u8])> = bytes.iter().map(|(c, b)| (*c, b.as_slice())).collect();
    let stem = |path: &Path| path.file_stem().map(|s| s.to_string_lossy().into_owned());
    let stems: Vec<String> = named
        .iter()
        .map(|(.., path)| stem(path).unwrap_or_default())
        .collect();
    let files: Vec<&str> = named.iter().map(|(_, name, _)| name.as_str()).collect();
    let name = stems.join(" + ");
    let motion = match wanted.x_azimuth_deg {
        None => read_motion(&name, &parts, &read),
        Some(azimuth_deg) => {
            let parts: Vec<&[u8]> = parts.iter().map(|(_, bytes)| *bytes).collect();
            read_oriented(&name, &parts, azimuth_deg, &read)
        }
    };
    let motion = motion.with_context(|| place(&files.join(", ")))?;
    let of_each: Vec<(Component, String)> = match wanted.x_azimuth_deg {
        None => named
            .iter()
            .map(|(component, name, _)| (*component, name.clone()))
            .collect(),
        // turned: every direction comes from all files
        Some(_) => {
            let given = Component::ALL
                .into_iter()
                .filter(|component| motion.has(*component));
            given.map(|component| (component, files.join(" + "))).collect()
        }
    };
    Ok(of_files(motion, of_each))
}

/// Cut, base line taken off, filtered, tapered, scaled and turned, in this order: for what moves in one plane turned, then scaled to what acts there.
fn changed(mut motion: GroundMotion, wanted: &Wanted) -> Result<GroundMotion> {
    let place = |flag: &'static str, key: &str| match &wanted.part {
        Some(part) => format!("{flag}, {part}.{key}"),
        None => flag.to_owned(),
    };
    if let Some(seconds) = wanted.keep_first_s {
        motion = motion
            .keep_first(seconds)
            .with_context(|| place("--keep-first", "keep_first_s"))?;
    }
    if let Some(degree) = wanted.baseline {
        motion = motion
            .baseline_corrected(Baseline::Polynomial { degree })
            .context("--baseline")?;
    }
    if let Some(corner_hz) = wanted.high_pass_hz {
        let filter = Baseline::HighPass { corner_hz, order: 4 };
        motion = motion.baseline_corrected(filter).context("--high-pass")?;
    }
    if let Some(seconds) = wanted.taper_s {
        motion = motion
            .tapered(seconds)
            .with_context(|| place("--taper", "taper_s"))?;
    }
    let turned = |motion: GroundMotion| -> Result<GroundMotion> {
        match wanted.turn_rad {
            Some(angle_rad) => motion.rotated(angle_rad).with_context(|| place("--turn", "turn")),
            None => Ok(motion),
        }
    };
    let sized = |motion: GroundMotion| -> Result<GroundMotion> {
        match wanted.size {
            Some(MotionSize::Scale(factor)) => {
                motion.scaled(factor).with_context(|| place("--scale", "scale"))
            }
            Some(MotionSize::Peak(wanted_m_s2)) => {
                let largest = largest_component(&motion);
                motion
                    .scaled_to_peak(largest, wanted_m_s2)
                    .with_context(|| place("--peak", "peak"))
            }
            None => Ok(motion),
        }
    };
    match wanted.is_sized_first {
        true => turned(sized(motion)?),
        false => sized(turned(motion)?),
    }
}

/// The horizontal component of the larger peak; the vertical one if there is no other.
fn largest_component(motion: &GroundMotion) -> Component {
    let horizontal = [Component::X, Component::Y];
    let largest = horizontal.into_iter().max_by(|a, b| {
        let of = |c: &Component| motion.component_peak_m_s2(*c);
        of(a).total_cmp(&of(b)).then(b.name().cmp(a.name()))
    });
    largest
        .filter(|c| motion.component_peak_m_s2(*c) > 0.0)
        .unwrap_or(Component::Z)
}

/// "0.3 g", "2.94 m/s2", "294 gal" as m/s².
pub(crate) fn acceleration_m_s2(text: &str) -> Result<f64> {
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
