//! Reads the channels of a motion file: detects the format from the content, determines unit and time step, and checks peaks.

use super::plausible::refuse_implausible;
use super::spike::{Codes, refuse_spikes};
use super::{MotionError, MotionFormat, MotionOptions, Orientation, SeismicError, StatedPeak, text};
use crate::seismic::{Raw, Response, motion_channels};
use crate::unit::Unit;
use crate::workbook::{is_workbook, workbook_as_csv};
use crate::wrong::OfStation;
use dolmen::signal::Quantity;

/// Largest relative difference between the peak of a channel and that in its header. Our choice: headers print 3 digits or more.
const PEAK_TOLERANCE: f64 = 0.01;

/// Relative difference within which two time steps are equal. Our choice: only for the rounding of printed digits.
const STEP_TOLERANCE: f64 = 1e-6;

/// One channel of a motion file.
#[derive(Clone, Debug, PartialEq)]
pub struct ComponentReading {
    /// Format of the file.
    pub format: MotionFormat,
    /// Name of the channel in the file: "HI.ARS1.HNE", "Chan 1", "AOM004 E-W"; "" if it has none.
    pub name: String,
    /// Title of the file: earthquake, station, direction; "" if it has none.
    pub title: String,
    /// Acceleration, m/s².
    pub acceleration_m_s2: Vec<f64>,
    /// Time between samples, s.
    pub time_step_s: f64,
    /// Unit of the numbers in the file.
    pub unit: Unit,
    /// Direction of positive numbers, if the file states it.
    pub orientation: Option<Orientation>,
    /// Time of the first sample, s from 1 January 1970 by the clock of the file, if the file states it.
    pub begins_s: Option<f64>,
    /// The mean that was subtracted, m/s². Only for K-NET and KiK-net files, whose numbers have an offset by definition.
    pub mean_subtracted_m_s2: Option<f64>,
    /// Whether the file states that the sensor is in a borehole.
    pub is_borehole: bool,
}

/// Reads all channels of a motion file: AT2, COSMOS, CSMIP, K-NET, ESM, SAC, miniSEED, text in columns, or a workbook (XLSX) with one sheet of
/// columns.
///
/// # Errors
/// [`MotionError`], with the place in the file and what to do, for a missing unit, a unit or step that contradicts the file, a peak that is
/// impossible for an earthquake or differs from the header, a value that is not a number, a number of samples that differs from the header, or a
/// gap between records.
///
/// # Example
/// ```
/// use dolmen_records::motions::{MotionOptions, Orientation, read_channels};
/// let file = "NETWORK: HI\nSTATION_CODE: ARS1\nSAMPLING_INTERVAL_S: 0.005\nNDATA: 3\nSTREAM: HNE\nUNITS: cm/s^2\n0.5\n-2\n1\n";
/// let read = &read_channels(file.as_bytes(), &MotionOptions::default())?[0];
/// assert_eq!((read.name.as_str(), read.acceleration_m_s2[1]), ("HI.ARS1.HNE", -0.02));
/// assert_eq!(read.orientation, Some(Orientation::Horizontal { azimuth_deg: 90.0 }));
/// # Ok::<(), dolmen_records::motions::MotionError>(())
/// ```
pub fn read_channels(bytes: &[u8], options: &MotionOptions) -> Result<Vec<ComponentReading>, MotionError> {
    let channels = checked_raw(bytes, options)?;
    let are_several = channels.len() > 1;
    let each = channels.into_iter().map(|channel| {
        let named = (are_several && channel.format == MotionFormat::Text).then(|| channel.name.clone());
        finished(channel, options).map_err(|fault| match named {
            Some(channel) => MotionError::Channel {
                channel,
                fault: Box::new(fault),
            },
            None => fault,
        })
    });
    each.collect()
}

/// The channels, checked against the options.
fn checked_raw(bytes: &[u8], options: &MotionOptions) -> Result<Vec<Raw>, MotionError> {
    if let Some(given) = options.time_step_s
        && !(given > 0.0 && given.is_finite())
    {
        return Err(MotionError::Step { given });
    }
    if !(options.factor.is_finite() && options.factor != 0.0) {
        return Err(MotionError::Factor {
            given: options.factor,
        });
    }
    raw(bytes, options)
}

/// The numbers of each channel as printed in the file. A file without a seismic format is read as text in columns, or as a workbook.
fn raw(bytes: &[u8], options: &MotionOptions) -> Result<Vec<Raw>, MotionError> {
    if is_workbook(bytes) {
        return text::read(
            &workbook_as_csv(bytes).map_err(|why| MotionError::Workbook { why })?,
            options,
        );
    }
    match motion_channels(bytes, options.unit.is_some()) {
        Some(read) => Ok(read?),
        None => text::read(bytes, options),
    }
}

/// Reads one channel of a motion file: its only channel, or that of [`MotionOptions::channel`].
///
/// # Errors
/// As [`read_channels`]; [`MotionError::Channels`] for a file with several channels if the options select none.
///
/// # Example
/// ```
/// use dolmen_records::motions::{MotionOptions, read_component};
/// let text = "time_s,acceleration_g\n0,0\n0.02,0.1\n0.04,-0.3\n";
/// let read = read_component(text.as_bytes(), &MotionOptions::default())?;
/// assert!((read.acceleration_m_s2[2] + 0.3 * 9.80665).abs() < 1e-15 && read.time_step_s == 0.02);
/// # Ok::<(), dolmen_records::motions::MotionError>(())
/// ```
pub fn read_component(bytes: &[u8], options: &MotionOptions) -> Result<ComponentReading, MotionError> {
    let mut channels = checked_raw(bytes, options)?;
    let at = chosen(&channels, options.channel.as_deref())?;
    finished(channels.swap_remove(at), options)
}

/// Index of the only channel, or of the one in the options: by its name, in any case and with or without its unit, or by its number from 1.
fn chosen(channels: &[Raw], given: Option<&str>) -> Result<usize, MotionError> {
    let names = || channels.iter().map(|channel| channel.name.clone()).collect();
    let Some(given) = given else {
        return match channels.len() {
            1 => Ok(0),
            _ => Err(MotionError::Channels {
                given: None,
                names: names(),
            }),
        };
    };
    let named = channels
        .iter()
        .position(|channel| channel.name.eq_ignore_ascii_case(given));
    let number = given
        .parse::<usize>()
        .ok()
        .filter(|n| (1..=channels.len()).contains(n));
    named
        .or(number.map(|number| number - 1))
        .ok_or_else(|| MotionError::Channels {
            given: Some(given.to_owned()),
            names: names(),
        })
}

/// Sets the value of a count from the instrument response of the channel, if responses are given and the file states no unit.
fn respond(raw: &mut Raw, options: &MotionOptions) -> Result<(), MotionError> {
    if options.responses.is_empty() || raw.unit.is_some() {
        return Ok(());
    }
    let covers = |of: &&Response| {
        let begins_s = raw.begins_s.unwrap_or(of.from_s);
        of.channel == raw.name && of.from_s <= begins_s && of.to_s.is_none_or(|to_s| begins_s < to_s)
    };
    let Some(found) = options.responses.iter().find(covers) else {
        return Err(MotionError::NoResponse {
            channel: raw.name.clone(),
            known: options.responses.iter().map(|of| of.channel.clone()).collect(),
        });
    };
    if options.factor != 1.0 {
        return Err(MotionError::ResponseAndFactor {
            factor: options.factor,
        });
    }
    raw.quantity = Some(found.quantity);
    raw.unit = Some(Unit::MetrePerSecondSquared);
    raw.samples
        .iter_mut()
        .for_each(|count| *count /= found.counts_per_unit);
    Ok(())
}

/// Converts a channel to SI units.
fn finished(mut raw: Raw, options: &MotionOptions) -> Result<ComponentReading, MotionError> {
    respond(&mut raw, options)?;
    let other = match raw.quantity {
        Some(Quantity::Velocity) => Some(OfStation::Velocities),
        Some(Quantity::Displacement) => Some(OfStation::Displacements),
        _ => None,
    };
    if let Some(what) = other {
        return Err(SeismicError::Quantity {
            line: 0,
            what: what.into(),
        }
        .into());
    }
    let unit = match (options.unit, raw.unit) {
        (Some(given), Some(found)) if given != found => {
            return Err(MotionError::UnitDisagrees {
                given: given.symbol(),
                found: found.symbol(),
            });
        }
        (given, found) => given.or(found).ok_or(MotionError::NoUnit)?,
    };
    if unit.quantity() != Quantity::Acceleration {
        return Err(MotionError::NotAcceleration {
            given: unit.symbol().to_owned(),
        });
    }
    if let Some(given) = options.time_step_s
        && !same_step(given, raw.time_step_s)
    {
        return Err(MotionError::StepDisagrees {
            given,
            found: raw.time_step_s,
        });
    }
    let mut samples = raw.samples;
    if let Some(sample) = samples.iter().position(|value| !value.is_finite()) {
        return Err(MotionError::NotFinite {
            channel: raw.name,
            sample,
        });
    }
    let mean = samples.iter().sum::<f64>() / samples.len().max(1) as f64;
    if raw.subtract_mean {
        samples.iter_mut().for_each(|a| *a -= mean);
    }
    let peak = largest(&samples);
    if let (Some(stated), StatedPeak::Check) = (raw.stated_peak, options.stated_peak)
        && (peak - stated).abs() > PEAK_TOLERANCE * stated
    {
        return Err(MotionError::StatedPeak {
            channel: raw.name,
            stated,
            found: peak,
            unit: unit.symbol(),
        });
    }
    if raw.format != MotionFormat::Text {
        refuse_spikes(&samples, raw.time_step_s, Codes::None, &|_| None)?;
    }
    let si = unit.si() * options.factor;
    samples.iter_mut().for_each(|a| *a *= si);
    refuse_implausible(largest(&samples), unit, &options.plausible_peak_m_s2)?;
    Ok(ComponentReading {
        format: raw.format,
        name: raw.name,
        title: raw.title,
        acceleration_m_s2: samples,
        time_step_s: raw.time_step_s,
        unit,
        orientation: raw.orientation,
        begins_s: raw.begins_s,
        mean_subtracted_m_s2: raw.subtract_mean.then_some(mean * si),
        is_borehole: raw.is_borehole,
    })
}

pub(super) fn same_step(a: f64, b: f64) -> bool {
    (a - b).abs() <= STEP_TOLERANCE * a.abs()
}

fn largest(samples: &[f64]) -> f64 {
    samples.iter().fold(0.0, |peak, a| f64::max(peak, a.abs()))
}
