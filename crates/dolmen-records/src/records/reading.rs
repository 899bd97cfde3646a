//! A record as read, and what its file says beside the samples.

use super::Layout;
use crate::start::time_text;
use crate::unit::Unit;
use dolmen::signal::{Quantity, Record};

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
