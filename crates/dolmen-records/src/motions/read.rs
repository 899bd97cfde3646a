//! Motions of several components from files of one channel each.

use super::channel::same_step;
use super::{
    ComponentReading, Lengths, MotionError, MotionFormat, MotionOptions, Orientation, Origin, ReadFor,
    origin, read_component,
};
use crate::wrong::Turned;
use dolmen::signal::{Component, GroundMotion, Processing};

/// Relative difference between the starts of components, in time steps. Our choice: half a step decides between two samples.
const START_STEPS: f64 = 0.5;

/// A component of a motion and its source.
#[derive(Clone, Copy, Debug)]
pub struct ComponentSource<'a> {
    /// Its direction.
    pub component: Component,
    /// The file, which may contain several components.
    pub bytes: &'a [u8],
    /// Its column or channel; `None` for that of [`MotionOptions::channel`].
    pub channel: Option<&'a str>,
}

/// A motion from one file for each component. Its history begins with the reading of each.
///
/// # Errors
/// [`MotionError::Component`] around what [`read_component`] says; [`MotionError::TimeSteps`]; [`MotionError::Lengths`]
/// unless [`MotionOptions::lengths`] allows it.
///
/// # Limits
/// The signs of the files are those of x, y and z, whatever direction they state; [`read_oriented`](super::read_oriented) rotates them. The
/// starts of files must agree; AT2 files and texts do not state them, but must agree as well.
pub fn read_motion(
    name: &str,
    files: &[(Component, &[u8])],
    options: &MotionOptions,
) -> Result<GroundMotion, MotionError> {
    let sources = files.iter().map(|(component, bytes)| ComponentSource {
        component: *component,
        bytes,
        channel: None,
    });
    read_columns_as(name, &sources.collect::<Vec<_>>(), options)
}

/// A motion from components that may be columns of one file.
///
/// # Errors
/// As [`read_motion`].
///
/// # Example
/// ```
/// use dolmen::signal::Component;
/// use dolmen_records::motions::{ComponentSource, MotionOptions, read_columns_as};
/// let bytes = b"time,NS(gal),EW(gal)\n0,0,0\n0.01,10,30\n";
/// let source = |component, column| ComponentSource { component, bytes, channel: Some(column) };
/// let sources = [source(Component::X, "EW"), source(Component::Y, "NS")];
/// let motion = read_columns_as("station", &sources, &MotionOptions::default())?;
/// assert!((motion.acceleration_m_s2(Component::X)[1] - 0.3).abs() < 1e-15);
/// # Ok::<(), dolmen_records::motions::MotionError>(())
/// ```
pub fn read_columns_as(
    name: &str,
    sources: &[ComponentSource<'_>],
    options: &MotionOptions,
) -> Result<GroundMotion, MotionError> {
    let mut read = Vec::with_capacity(sources.len());
    for source in sources {
        let told = MotionOptions {
            channel: source
                .channel
                .map(str::to_owned)
                .or_else(|| options.channel.clone()),
            ..options.clone()
        };
        let one = read_component(source.bytes, &told).map_err(|fault| MotionError::Component {
            component: source.component.name(),
            fault: Box::new(fault),
        })?;
        read.push((source.component, one));
    }
    refuse_mistaken(sources, &read)?;
    refuse_unfit(&read, options)?;
    motion_of(name, read, options)
}

/// Refuses columns whose names state another direction, and a column or a record that is used twice.
fn refuse_mistaken(
    sources: &[ComponentSource<'_>],
    read: &[(Component, ComponentReading)],
) -> Result<(), MotionError> {
    let refused = |why: Turned| Err(MotionError::Orientation { why: why.into() });
    let of_columns = sources
        .iter()
        .zip(read)
        .filter(|(source, _)| source.channel.is_some());
    for (_, (component, one)) in of_columns {
        let (channel, component) = (one.name.clone(), component.name().to_owned());
        match (component.as_str(), one.orientation) {
            ("z", Some(Orientation::Horizontal { .. })) => {
                return refused(Turned::HorizontalAs { channel, component });
            }
            ("x" | "y", Some(Orientation::Up | Orientation::Down)) => {
                return refused(Turned::VerticalAs { channel, component });
            }
            _ => {}
        }
    }
    let each = sources.iter().zip(read).enumerate();
    for (at, (source, (component, one))) in each {
        let mut before = sources[..at].iter().zip(&read[..at]);
        let same =
            before.find(|(other, (_, of_other))| other.bytes == source.bytes && of_other.name == one.name);
        let Some((other, (first, _))) = same else {
            continue;
        };
        if other.channel.is_none() {
            return Err(MotionError::SameRecord {
                first: first.name(),
                second: component.name(),
            });
        }
        return refused(Turned::TakenTwice {
            channel: one.name.clone(),
            first: first.name().to_owned(),
            second: component.name().to_owned(),
        });
    }
    Ok(())
}

/// Refuses records that cannot shake a structure as they are placed: vertical ones along x or y, and those from a borehole.
pub(super) fn refuse_unfit(
    read: &[(Component, ComponentReading)],
    options: &MotionOptions,
) -> Result<(), MotionError> {
    if options.read_for == ReadFor::Looking {
        return Ok(());
    }
    for (component, one) in read {
        let component = component.name();
        match one.orientation {
            Some(Orientation::Up | Orientation::Down) if component != "z" => {
                return Err(MotionError::Vertical { component });
            }
            _ if one.is_borehole => return Err(MotionError::Borehole { component }),
            _ => {}
        }
    }
    Ok(())
}

/// A motion from channels along x, y or z.
pub(super) fn motion_of(
    name: &str,
    read: Vec<(Component, ComponentReading)>,
    options: &MotionOptions,
) -> Result<GroundMotion, MotionError> {
    let Some((first, reference)) = read.first() else {
        return Err(MotionError::NoFile);
    };
    let length = reference.acceleration_m_s2.len();
    let time_step_s = reference.time_step_s;
    let mut shortest = length;
    for (component, one) in &read {
        agree((*first, reference), (*component, one), options)?;
        shortest = shortest.min(one.acceleration_m_s2.len());
    }
    let was_cut = read.iter().any(|(_, one)| one.acceleration_m_s2.len() > shortest);
    let mut steps: Vec<Processing> = Vec::new();
    for (_, one) in &read {
        steps.push(Processing::Read {
            format: one.format.name().to_owned(),
            unit: one.unit.symbol().to_owned(),
        });
    }
    if options.factor != 1.0 {
        steps.push(Processing::Scaled {
            factor: options.factor,
        });
    }
    if read.iter().any(|(_, one)| one.mean_subtracted_m_s2.is_some()) {
        steps.push(Processing::Detrend { degree: 0 });
    }
    let series = read.into_iter().map(|(component, one)| {
        let mut samples = one.acceleration_m_s2;
        samples.truncate(shortest);
        (component, samples)
    });
    let mut motion = GroundMotion::new(name, time_step_s, series.collect())?;
    steps.into_iter().for_each(|step| motion.note(step));
    if was_cut {
        motion.note(Processing::Cut {
            from_s: 0.0,
            to_s: motion.duration_s(),
        });
    }
    Ok(motion)
}

/// Refuses a component whose step, length or start differs from that of the first.
fn agree(
    (first, reference): (Component, &ComponentReading),
    (second, one): (Component, &ComponentReading),
    options: &MotionOptions,
) -> Result<(), MotionError> {
    let (first, second) = (first.name(), second.name());
    let (first_s, second_s) = (reference.time_step_s, one.time_step_s);
    if !same_step(first_s, second_s) {
        return Err(MotionError::TimeSteps {
            first,
            first_s,
            second,
            second_s,
        });
    }
    if let (Some(a), Some(b)) = (reference.begins_s, one.begins_s)
        && (b - a).abs() > START_STEPS * first_s
    {
        return Err(MotionError::Starts {
            first,
            second,
            later_s: b - a,
        });
    }
    refuse_other_origin((first, reference), (second, one))?;
    let (first_samples, second_samples) = (reference.acceleration_m_s2.len(), one.acceleration_m_s2.len());
    if options.lengths == Lengths::Same && first_samples != second_samples {
        return Err(MotionError::Lengths {
            first,
            first_samples,
            second,
            second_samples,
        });
    }
    Ok(())
}

/// Refuses a component whose header states another station or earthquake than that of the first.
fn refuse_other_origin(
    (first, reference): (&'static str, &ComponentReading),
    (second, other): (&'static str, &ComponentReading),
) -> Result<(), MotionError> {
    if reference.format != other.format {
        return Ok(());
    }
    let fields = |of: &ComponentReading| of.title.matches(',').count();
    // titles of AT2 with another number of fields are divided differently, but all begin with the earthquake
    let divides = reference.format != MotionFormat::At2 || fields(reference) == fields(other);
    let of = |one: &ComponentReading| {
        let Origin { event, station } = origin(one);
        let first = one.title.split(',').next().filter(|first| !first.is_empty());
        match divides {
            true => [station, event],
            false => [None, first.map(str::to_owned)],
        }
    };
    let plain = |text: &str| {
        text.split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
            .to_lowercase()
    };
    // the earthquake may be followed by its date
    let is_alike = |one: &str, other: &str| {
        let [one, other] = [one, other].map(plain);
        one == other || !divides && (one.starts_with(&other) || other.starts_with(&one))
    };
    let pairs = of(reference).into_iter().zip(of(other));
    for pair in pairs {
        if let (Some(first_of), Some(second_of)) = pair
            && !is_alike(&first_of, &second_of)
        {
            return Err(MotionError::Origins {
                first,
                first_of,
                second,
                second_of,
            });
        }
    }
    Ok(())
}
