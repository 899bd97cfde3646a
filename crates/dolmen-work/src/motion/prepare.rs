//! Prepares requested ground motions: built-in or from files, then changed step by step.

use super::acting::{MotionAnswer, TakenOff};
use super::error::MotionRequestError;
use super::of_survey::{SURVEY, of_survey};
use super::request::{GivenFile, MotionRequest, acting_size};
use super::wanted_file::{WantedFile, column_of, given_files, typed_columns};
use crate::error::{Within as _, WorkError};
use dolmen::signal::{Baseline, Component, GroundMotion, Quantity};
use dolmen_project::{MotionPart, MotionSize, MotionSource, Project, Structure};
use dolmen_records::motions::{
    ComponentSource, Lengths, MotionError, MotionOptions, ReadFor, Response, StatedPeak, read_columns_as,
    read_motion, read_oriented, responses,
};
use dolmen_records::records::Unit;
use dolmen_records::{FileError, Files, MOTION_BYTES_MOST};
use std::borrow::Cow;
use std::path::Path;

/// The built-in motions: name, file name in `data/`, and bytes.
const CARRIED: [(&str, &str, &[u8]); 1] = [(
    "el-centro-1940-ns",
    "el_centro_1940_ns.csv",
    include_bytes!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv"),
)];

/// Whether this is the name of a built-in motion.
pub fn is_built_in_motion(name: &str) -> bool {
    CARRIED.iter().any(|(own, ..)| *own == name)
}

/// Largest peak of an acting motion, g. Our choice: more than twice the 4.1 g of Ichinoseki on 14 June 2008 (Aoi, Kunugi and Fujiwara, Science
/// 322, 2008), the largest ever recorded.
const ACTS_MOST_G: f64 = 10.0;

/// The settings of the project file, replaced by those of the request where it has them.
struct MotionSettings {
    from: MotionOrigin,
    unit: Option<String>,
    sample_step_s: Option<f64>,
    keep_first_s: Option<f64>,
    taper_s: Option<f64>,
    turn_rad: Option<f64>,
    /// Whether the motion is for a structure.
    acts: bool,
    /// Whether to scale before the rotation, as studies do for structures that move in plan: the strength of the shaking then does not
    /// depend on the rotation.
    is_sized_first: bool,
    size: Option<MotionSize>,
    /// Further options, only from the request.
    read: MotionOptions,
    /// Files of responses that the project file names.
    responses: Vec<String>,
    x_azimuth_deg: Option<f64>,
    baseline: Option<usize>,
    high_pass_hz: Option<f64>,
    /// Place for errors about the project file.
    part: Option<String>,
}

enum MotionOrigin {
    Carried(String),
    Survey(String),
    Files(Vec<WantedFile>),
}

/// The project of a motion, and the files that it names.
type ProjectFiles<'a> = (&'a Project, &'a dyn Files);

/// The requested motion, ready to act: from the project file, built-in, or from files. The request overrides the project file.
pub(crate) fn prepared(
    request: &MotionRequest,
    project: ProjectFiles<'_>,
) -> Result<MotionAnswer, WorkError> {
    ready(request, Some(project))
}

/// The same without a project file.
pub(crate) fn motion_alone(request: &MotionRequest) -> Result<MotionAnswer, WorkError> {
    ready(request, None)
}

/// A made motion with the changes of the request, except for its peak, with which it was made.
pub(crate) fn changed_alone(
    motion: GroundMotion,
    request: &MotionRequest,
) -> Result<GroundMotion, WorkError> {
    let told = MotionRequest {
        name: Some(CARRIED[0].0.to_owned()),
        files: Vec::new(),
        ..request.clone()
    };
    let wanted = wanted(&told, None)?;
    placed(trimmed(motion, &wanted)?, &wanted)
}

fn ready(request: &MotionRequest, project: Option<ProjectFiles<'_>>) -> Result<MotionAnswer, WorkError> {
    let wanted = wanted(request, project)?;
    let mut answer = match &wanted.from {
        MotionOrigin::Carried(name) => match request.of_files() {
            Some(flag) => {
                let name = name.clone();
                return Err(MotionRequestError::OfFilesNotCarried { flag, name }.into());
            }
            None => carried(name)?,
        },
        MotionOrigin::Survey(name) => match (request.of_files(), project) {
            (Some(flag), _) => {
                let name = format!("{SURVEY}{name}");
                return Err(MotionRequestError::OfFilesNotSurvey { flag, name }.into());
            }
            (None, Some((project, files))) => of_survey(name, project, files)?,
            (None, None) => {
                let name = name.clone();
                return Err(MotionRequestError::SurveyWithoutProject { name }.into());
            }
        },
        MotionOrigin::Files(named) => from_files(named, &wanted, project)?,
    };
    let trimmed = trimmed(answer.motion.clone(), &wanted)?;
    answer.taken_off = TakenOff::between(&answer.motion, &trimmed);
    answer.motion = placed(trimmed, &wanted)?;
    if let Some(own) = wanted
        .part
        .as_deref()
        .and_then(|path| path.strip_prefix("motion."))
    {
        answer.motion = answer.motion.renamed(own);
    }
    // the measured response does not belong to a changed motion
    answer.measured = answer.measured.filter(|_| !request.is_changed());
    answer.turned_rad = request.turn_deg.map(f64::to_radians);
    Ok(answer)
}

fn wanted(options: &MotionRequest, project: Option<ProjectFiles<'_>>) -> Result<MotionSettings, WorkError> {
    let own = project.map_or(&[][..], |(project, _)| &project.motions[..]);
    let part = match &options.name {
        Some(name) => own.iter().find(|part| part.name == *name),
        None => None,
    };
    let from = match (&options.name, part) {
        (_, Some(part)) => match &part.from {
            MotionSource::BuiltIn(name) => MotionOrigin::Carried(name.clone()),
            MotionSource::Files(files) => {
                let each = files.iter().map(|(component, name)| WantedFile {
                    component: *component,
                    name: name.clone(),
                    channel: column_of(&part.columns, *component),
                    bytes: None,
                });
                MotionOrigin::Files(typed_columns(each.collect(), &options.columns)?)
            }
        },
        (Some(name), None) if name.starts_with(SURVEY) => {
            MotionOrigin::Survey(name[SURVEY.len()..].to_owned())
        }
        (Some(name), None) if is_carried(name) => MotionOrigin::Carried(name.clone()),
        (Some(name), None) => {
            return Err(MotionRequestError::NoSuchMotion {
                name: name.clone(),
                known: names(own),
            }
            .into());
        }
        (None, _) if options.files.is_empty() => {
            return Err(MotionRequestError::NoMotion { known: names(own) }.into());
        }
        (None, _) => MotionOrigin::Files(typed_columns(given_files(&options.files)?, &options.columns)?),
    };
    let typed_size = typed_size(options)?;
    let of = |read: fn(&MotionPart) -> Option<f64>| part.and_then(read);
    Ok(MotionSettings {
        from,
        unit: options.unit.clone().or_else(|| part?.unit.clone()),
        sample_step_s: options.sample_step_s.or_else(|| of(|part| part.sample_step_s)),
        keep_first_s: options.keep_first_s.or_else(|| of(|part| part.keep_first_s)),
        taper_s: options.taper_s.or_else(|| of(|part| part.taper_s)),
        turn_rad: typed_turn_rad(options)?.or_else(|| of(|part| part.turn_rad)),
        acts: project.is_some(),
        is_sized_first: project.is_some_and(|(project, _)| {
            matches!(project.structure, Structure::Stack(_) | Structure::Building(_))
        }),
        size: acting_size(typed_size, part.and_then(|part| part.size)),
        read: MotionOptions {
            factor: match (options.factor, part) {
                (1.0, Some(part)) => part.factor.unwrap_or(1.0),
                (typed, _) => typed,
            },
            stated_peak: match options.ignore_stated_peak || part.is_some_and(|part| part.ignores_stated_peak)
            {
                true => StatedPeak::Ignore,
                false => StatedPeak::Check,
            },
            lengths: match options.shortest || part.is_some_and(|part| part.cut_to_shortest) {
                true => Lengths::Shortest,
                false => Lengths::Same,
            },
            ..motion_options(options)?
        },
        responses: part.map_or_else(Vec::new, |part| part.responses.clone()),
        x_azimuth_deg: match options.columns.is_empty() && options.channel.is_none() {
            true => options.x_azimuth_deg.or_else(|| of(|part| part.x_azimuth_deg)),
            false => options.x_azimuth_deg,
        },
        baseline: options.baseline_degree,
        high_pass_hz: options.high_pass_hz,
        part: part.map(|part| format!("motion.{}", part.name)),
    })
}

/// The size in the request. Unlike in a project file it may not be negative, because an inverted record looks like a typing mistake.
fn typed_size(options: &MotionRequest) -> Result<Option<MotionSize>, WorkError> {
    match (options.scale, &options.peak) {
        (Some(given), _) if given > 0.0 => Ok(Some(MotionSize::Scale(given))),
        (Some(given), _) => Err(MotionRequestError::ScaleTyped { given }.into()),
        (None, Some(peak)) => match acceleration_m_s2(peak).within(|| "--peak".to_owned())? {
            peak_m_s2 if peak_m_s2 > 0.0 => Ok(Some(MotionSize::Peak(peak_m_s2))),
            _ => {
                let given = peak.clone();
                Err(MotionRequestError::PeakTyped { given }.into())
            }
        },
        (None, None) => Ok(None),
    }
}

/// The rotation on the command line, at most a full turn.
fn typed_turn_rad(options: &MotionRequest) -> Result<Option<f64>, WorkError> {
    match options.turn_deg {
        Some(given_deg) if !(-360.0..=360.0).contains(&given_deg) => {
            Err(MotionRequestError::TurnTyped { given_deg }.into())
        }
        given_deg => Ok(given_deg.map(f64::to_radians)),
    }
}

/// The available motions: those of the project file, then the built-in ones.
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

fn carried(name: &str) -> Result<MotionAnswer, WorkError> {
    let Some((name, file, bytes)) = find(name) else {
        return Err(MotionRequestError::NoBuiltInMotion {
            name: name.to_owned(),
            known: CARRIED.map(|(known, ..)| known).join(", "),
        }
        .into());
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
        turned_rad: None,
        taken_off: None,
        measured: None,
        motion,
        files,
    }
}

/// The settings of the request for the files.
pub(crate) fn motion_options(options: &MotionRequest) -> Result<MotionOptions, WorkError> {
    Ok(MotionOptions {
        unit: match &options.unit {
            Some(unit) => Some(Unit::parse(unit)?),
            None => None,
        },
        time_step_s: options.sample_step_s,
        channel: options.channel.clone(),
        factor: options.factor,
        responses: typed_responses(&options.responses)?,
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

/// The instrument responses on the command line.
fn typed_responses(files: &[GivenFile]) -> Result<Vec<Response>, WorkError> {
    let mut all = Vec::new();
    for file in files {
        let read = responses(&String::from_utf8_lossy(&file.bytes)).map_err(MotionError::from);
        all.extend(read.within(|| file.name.clone())?);
    }
    Ok(all)
}

/// The instrument responses that the project file names.
fn responses_of_files(
    names: &[String],
    project: Option<ProjectFiles<'_>>,
    place: impl Fn(&str) -> String,
) -> Result<Vec<Response>, WorkError> {
    let Some((_, files)) = project else {
        return Ok(Vec::new());
    };
    let mut all = Vec::new();
    for name in names {
        let bytes = files.read(name, MOTION_BYTES_MOST).within(|| place(name))?;
        let read = responses(&String::from_utf8_lossy(&bytes)).map_err(MotionError::from);
        all.extend(read.within(|| place(name))?);
    }
    Ok(all)
}

fn from_files(
    named: &[WantedFile],
    wanted: &MotionSettings,
    project: Option<ProjectFiles<'_>>,
) -> Result<MotionAnswer, WorkError> {
    let place = |file: &str| match &wanted.part {
        Some(part) => format!("{part}.files: {file}"),
        None => file.to_owned(),
    };
    let mut read = MotionOptions {
        unit: match &wanted.unit {
            Some(unit) => Some(Unit::parse(unit)?),
            None => None,
        },
        time_step_s: wanted.sample_step_s,
        read_for: match wanted.acts {
            true => ReadFor::Shaking,
            false => ReadFor::Looking,
        },
        ..wanted.read.clone()
    };
    if read.responses.is_empty() {
        read.responses = responses_of_files(&wanted.responses, project, place)?;
    }
    let mut bytes: Vec<Cow<'_, [u8]>> = Vec::new();
    for (at, file) in named.iter().enumerate() {
        let before = named[..at].iter().position(|other| other.name == file.name);
        bytes.push(match (&file.bytes, before, project) {
            (Some(given), ..) => Cow::Borrowed(given.as_slice()),
            (None, Some(before), _) => bytes[before].clone(),
            (None, None, Some((_, files))) => {
                let read = files.read(&file.name, MOTION_BYTES_MOST);
                Cow::Owned(read.within(|| place(&file.name))?)
            }
            (None, None, None) => return Err(FileError::TextAlone.into()),
        });
    }
    let stem = |name: &str| {
        Path::new(name)
            .file_stem()
            .map(|s| s.to_string_lossy().into_owned())
    };
    let is_new = |at: &usize| named[..*at].iter().all(|other| other.name != named[*at].name);
    let new: Vec<usize> = (0..named.len()).filter(is_new).collect();
    let files: Vec<&str> = new.iter().map(|at| named[*at].name.as_str()).collect();
    let mut stems: Vec<String> = files.iter().map(|file| stem(file).unwrap_or_default()).collect();
    // K-NET names the components of one record by their endings
    stems.dedup();
    let name = stems.join(" + ");
    let motion = match wanted.x_azimuth_deg {
        None => {
            let sources = named.iter().zip(&bytes).map(|(file, bytes)| ComponentSource {
                component: file.component,
                bytes,
                channel: file.channel.as_deref(),
            });
            read_columns_as(&name, &sources.collect::<Vec<_>>(), &read)
        }
        Some(azimuth_deg) => {
            let all: Vec<&[u8]> = new.iter().map(|at| bytes[*at].as_ref()).collect();
            read_oriented(&name, &all, azimuth_deg, &read)
        }
    };
    let motion = motion.within(|| place(&files.join(", ")))?;
    let of_each: Vec<(Component, String)> = match wanted.x_azimuth_deg {
        None => named
            .iter()
            .map(|file| (file.component, file.name.clone()))
            .collect(),
        // rotated: every direction needs all files
        Some(_) => {
            let given = Component::ALL
                .into_iter()
                .filter(|component| motion.has(*component));
            given.map(|component| (component, files.join(" + "))).collect()
        }
    };
    Ok(of_files(motion, of_each))
}

/// A flag, and the key of the project file that has the same effect.
fn place_of(wanted: &MotionSettings, flag: &'static str, key: &str) -> String {
    match &wanted.part {
        Some(part) => format!("{flag}, {part}.{key}"),
        None => flag.to_owned(),
    }
}

/// Cuts, corrects the base line, filters and tapers, in this order.
fn trimmed(mut motion: GroundMotion, wanted: &MotionSettings) -> Result<GroundMotion, WorkError> {
    let place = |flag: &'static str, key: &str| place_of(wanted, flag, key);
    if let Some(seconds) = wanted.keep_first_s {
        motion = motion
            .keep_first(seconds)
            .within(|| place("--keep-first", "keep_first_s"))?;
    }
    if let Some(degree) = wanted.baseline {
        motion = motion
            .baseline_corrected(Baseline::Polynomial { degree })
            .within(|| "--baseline".to_owned())?;
    }
    if let Some(corner_hz) = wanted.high_pass_hz {
        let filter = Baseline::HighPass { corner_hz, order: 4 };
        motion = motion
            .baseline_corrected(filter)
            .within(|| "--high-pass".to_owned())?;
    }
    if let Some(seconds) = wanted.taper_s {
        motion = motion.tapered(seconds).within(|| place("--taper", "taper_s"))?;
    }
    Ok(motion)
}

/// Scales and rotates; for structures that move in one plane it rotates first and scales the acting component.
fn placed(motion: GroundMotion, wanted: &MotionSettings) -> Result<GroundMotion, WorkError> {
    let place = |flag: &'static str, key: &str| place_of(wanted, flag, key);
    let turned = |motion: GroundMotion| -> Result<GroundMotion, WorkError> {
        match wanted.turn_rad {
            Some(angle_rad) => motion.rotated(angle_rad).within(|| place("--turn", "turn")),
            None => Ok(motion),
        }
    };
    let sized = |motion: GroundMotion| -> Result<GroundMotion, WorkError> {
        match wanted.size {
            Some(MotionSize::Scale(factor)) => motion.scaled(factor).within(|| place("--scale", "scale")),
            Some(MotionSize::Peak(wanted_m_s2)) => {
                let largest = largest_component(&motion);
                motion
                    .scaled_to_peak(largest, wanted_m_s2)
                    .within(|| place("--peak", "peak"))
            }
            None => Ok(motion),
        }
    };
    let acting = match wanted.is_sized_first {
        true => turned(sized(motion)?),
        false => sized(turned(motion)?),
    }?;
    match wanted.acts {
        true => plausible(acting),
        false => Ok(acting),
    }
}

/// Refuses a motion that does not move, or that no ground can have.
fn plausible(motion: GroundMotion) -> Result<GroundMotion, WorkError> {
    let peaks = Component::ALL.map(|component| motion.component_peak_m_s2(component));
    let peak_g = peaks.into_iter().fold(0.0, f64::max) / Unit::Gravity.si();
    match peak_g > 0.0 && peak_g <= ACTS_MOST_G {
        true => Ok(motion),
        false => Err(MotionRequestError::Acts {
            peak_g,
            most_g: ACTS_MOST_G,
        }
        .into()),
    }
}

/// The horizontal component with the larger peak; the vertical one if there is no other.
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
pub(crate) fn acceleration_m_s2(text: &str) -> Result<f64, WorkError> {
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
        return Err(MotionRequestError::NoAcceleration {
            given: text.to_owned(),
        }
        .into());
    };
    let unit = unit.trim();
    if unit.is_empty() {
        return Err(MotionRequestError::AccelerationWithoutUnit {
            given: text.to_owned(),
            value,
        }
        .into());
    }
    let unit = Unit::parse(unit)?;
    if unit.quantity() != Quantity::Acceleration {
        return Err(MotionRequestError::NoAcceleration {
            given: text.to_owned(),
        }
        .into());
    }
    Ok(value * unit.si())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::told::told;

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
            let message = told(&acceleration_m_s2(text).unwrap_err());
            assert!(message.contains(said), "{message}");
        }
    }
}
