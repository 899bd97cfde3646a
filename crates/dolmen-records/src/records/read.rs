//! Any record file: the format is found out from its first bytes.

use super::options::RecordFormat;
use super::series::{Found, assembled, factors};
use super::{
    ChannelsLayout, CsvLayout, NpyLayout, RecordError, RecordOptions, Unit, gcf, mat, read_csv, read_npy,
    saf, seismic, tdms, uff, wav,
};
use crate::motions::time_text;
use dolmen::signal::{Quantity, Record, scale};

/// A record, with what was found out about its file.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The record, in SI; its history begins with [`Read`](dolmen::signal::Processing::Read).
    pub record: Record,
    /// The first sample, s from 1 January 1970 in the clock of the file; `None` if it does not say it.
    pub begins_s: Option<f64>,
    /// How the file was laid out.
    pub layout: Layout,
}

/// How a file was laid out.
#[derive(Clone, Debug, PartialEq)]
pub enum Layout {
    /// Text in columns.
    Csv(CsvLayout),
    /// A NumPy array.
    Npy(NpyLayout),
    /// Channels, each with a header.
    Channels(ChannelsLayout),
    /// Several files.
    Stations(Vec<Layout>),
}

impl Reading {
    /// What the file says beside its samples, in sentences: when it begins, and what was passed over.
    pub fn remarks(&self) -> Vec<String> {
        let mut remarks: Vec<String> = Vec::new();
        if let Some(at) = self.begins_s {
            // small numbers are seconds of a clock of the project's own, not dates
            const YEAR_S: f64 = 3.2e7;
            remarks.push(if at.abs() < YEAR_S {
                format!("begins at {at:.3} s of the clock given")
            } else {
                match zones(&self.layout) {
                    [true, false] => format!("begins {} UTC", time_text(at)),
                    [true, true] => format!(
                        "begins {}: some of its files say times in UTC, others without a time zone, and they are taken for one clock: if theirs is \
                         another, the files do not belong together as they are joined",
                        time_text(at)
                    ),
                    _ => format!("begins {} by its clock (time zone not said)", time_text(at)),
                }
            });
        }
        if let Layout::Stations(stations) = &self.layout {
            remarks.push(format!(
                "{} files joined, their clocks taken as right: a clock that is late or drifts turns shapes across files, and their signs",
                stations.len()
            ));
        }
        let unit_unknown = !self
            .record
            .channels()
            .iter()
            .any(|channel| channel.quantity != Quantity::Unknown);
        noted(&self.layout, unit_unknown, &mut remarks);
        remarks
    }
}

/// Whether some of the files say their times in UTC, and whether some do without a zone.
fn zones(layout: &Layout) -> [bool; 2] {
    match layout {
        Layout::Channels(channels) => {
            let utc = channels.format.clock_is_utc();
            [utc, !utc]
        }
        Layout::Stations(layouts) => layouts
            .iter()
            .map(zones)
            .fold([false, false], |all, one| [all[0] || one[0], all[1] || one[1]]),
        Layout::Csv(_) | Layout::Npy(_) => [false, true],
    }
}

/// The unit in brackets behind the name of a column: "ax [mg]", "x (m/s2)".
fn named_unit(name: &str) -> Option<String> {
    let inside = name.trim_end().strip_suffix([']', ')'])?;
    let (_, unit) = inside.rsplit_once(['[', '('])?;
    let unit = unit.trim();
    let motion = Unit::parse(unit).is_ok_and(|known| known.quantity() != Quantity::Unknown);
    motion.then(|| unit.to_owned())
}

fn noted(layout: &Layout, unit_unknown: bool, remarks: &mut Vec<String>) {
    match layout {
        Layout::Channels(channels) => remarks.extend(channels.notes.iter().cloned()),
        Layout::Stations(layouts) => layouts
            .iter()
            .for_each(|layout| noted(layout, unit_unknown, remarks)),
        Layout::Csv(csv) => {
            if csv.names_unread {
                remarks.push(
                    "names of columns are not UTF-8 (EUC-KR or CP949?): those columns are called ch1, ch2, … by their number; save the file as UTF-8 \
                     to have their names"
                        .to_owned(),
                );
            }
            if let Some([first, last]) = csv.passed_over {
                remarks.push(format!(
                    "lines {first} to {last} stand above the names of the columns and are passed over"
                ));
            }
            if let (Some(name), true) = (
                csv.columns.iter().find(|name| named_unit(name).is_some()),
                unit_unknown,
            ) {
                let unit = named_unit(name).unwrap_or_default();
                remarks.push(format!(
                    "column \"{name}\" says {unit}, and no unit is given: numbers are kept as they are; unit = \"{unit}\" takes them as that"
                ));
            }
            remarks.extend(csv.unread_stamps.iter().map(|column| {
                format!("column \"{column}\" is not read as times: nothing in the file confirms the sampling rate given")
            }));
            if let (Some(column), Some(unit_s)) = (&csv.time_column, csv.time_unit_s) {
                let unit = match unit_s {
                    1e-3 => "milliseconds",
                    1e-6 => "microseconds",
                    _ => "days, as tables keep dates",
                };
                remarks.push(format!(
                    "the time stamps of column \"{column}\" are read as {unit}: their steps say so"
                ));
            }
        }
        Layout::Npy(_) => {}
    }
}

/// A record from the bytes of a file: CSV, NPY, UFF 58, WAV, MAT 5 and 7.3, SAF, GCF, TDMS, miniSEED, SAC, K-NET, ESM, COSMOS.
///
/// Channels of one file that begin apart or are sampled differently are [joined](dolmen::signal::join).
///
/// # Errors
/// [`RecordError`], which says where in the file and what to do.
///
/// # Example
/// ```
/// use dolmen_records::records::{RecordOptions, Unit, read_record};
/// let text = "Time (s);roof x;roof y\n0,00;1,5;-2\n0,01;2,5;0\n0,02;1,0;3\n";
/// let options = RecordOptions { unit: Unit::MilliGravity, ..Default::default() };
/// let record = read_record(text.as_bytes(), &options)?.record;
/// assert_eq!(record.sampling_rate_hz(), 100.0);
/// assert_eq!(record.channels()[0].name, "roof x");
/// assert!((record.samples(0)[1] - 2.5e-3 * 9.80665).abs() < 1e-15);
/// # Ok::<(), dolmen_records::records::RecordError>(())
/// ```
pub fn read_record(bytes: &[u8], options: &RecordOptions) -> Result<Reading, RecordError> {
    let is_npy = bytes.starts_with(super::npy::MAGIC);
    // the numbers of an array may look like the header of anything
    if !is_npy && let Some(found) = channels(bytes, options) {
        let found = found?;
        return match options.format {
            Some(format) if format != found.format => Err(not_of(format, bytes)),
            _ => assembled(found, options),
        };
    }
    let reading = match options.format {
        None if is_npy => read_npy(bytes, options)?,
        Some(RecordFormat::Npy) => read_npy(bytes, options)?,
        None | Some(RecordFormat::Csv) if !is_npy => read_csv(bytes, options)?,
        format => return Err(not_of(format.unwrap_or(RecordFormat::Csv), bytes)),
    };
    let factors = factors(options, reading.record.channels().len());
    if factors.iter().all(|factor| *factor == 1.0) {
        return Ok(reading);
    }
    Ok(Reading {
        record: scale(reading.record, &factors)?,
        ..reading
    })
}

/// The channels of a file that describes them; `None` for columns of numbers.
fn channels(bytes: &[u8], options: &RecordOptions) -> Option<Result<Found, RecordError>> {
    if wav::is_wav(bytes) {
        Some(wav::read(bytes, options))
    } else if tdms::is_tdms(bytes) {
        Some(tdms::read(bytes))
    } else if mat::is_mat(bytes) {
        Some(mat::read(bytes))
    } else if saf::is_saf(bytes) {
        Some(saf::read(bytes))
    } else if uff::is_uff(bytes) {
        Some(uff::read(bytes))
    } else if let Some(found) = seismic::read(bytes) {
        Some(found)
    } else if options.format == Some(RecordFormat::Gcf) || (options.format.is_none() && gcf::is_gcf(bytes)) {
        Some(gcf::read(bytes))
    } else {
        None
    }
}

fn not_of(format: RecordFormat, bytes: &[u8]) -> RecordError {
    const SHOWN: usize = 16;
    let first = &bytes[..bytes.len().min(SHOWN)];
    RecordError::NotOfFormat {
        format: format.name(),
        begins: format!("\"{}\"", first.escape_ascii()),
    }
}
