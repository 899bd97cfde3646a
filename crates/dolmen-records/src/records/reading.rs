//! Result of reading a record file.

use super::column_units::unit_in_name;
use super::{CsvLayout, FileUnit, Layout};
use crate::start::time_text;
use crate::wrong::Remark;
use dolmen::signal::{Quantity, Record};
use dolmen_words::message::Both;

/// A record, and the other content of its file.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The record in SI units; its processing history begins with [`Read`](dolmen::signal::Processing::Read).
    pub record: Record,
    /// Time of the first sample, s from 1 January 1970 by the clock of the file; `None` if the file does not state it.
    pub begins_s: Option<f64>,
    /// Layout of the file.
    pub layout: Layout,
}

impl Reading {
    /// Remarks on the file, as sentences: its start time, and ignored contents. Text that other programs wrote into the file is the same in
    /// both languages.
    pub fn remarks(&self) -> Vec<Both> {
        let mut remarks: Vec<Both> = Vec::new();
        if let Some(at) = self.begins_s {
            // small numbers are seconds of a clock of the project, not dates
            const YEAR_S: f64 = 3.2e7;
            let time = time_text(at);
            let begins = match zones(&self.layout) {
                _ if at.abs() < YEAR_S => Remark::BeginsOfClock(format!("{at:.3}")),
                [true, false] => Remark::BeginsUtc(time),
                [true, true] => Remark::BeginsOfTwoZones(time),
                _ => Remark::Begins(time),
            };
            remarks.push(begins.into());
        }
        if let Layout::Stations(stations) = &self.layout {
            let files = stations.len();
            remarks.push(Remark::Joined(files).into());
        }
        let unit_unknown = !self
            .record
            .channels()
            .iter()
            .any(|channel| channel.quantity != Quantity::Unknown);
        noted(&self.layout, unit_unknown, &mut remarks);
        remarks
    }

    /// Columns that look like times but cannot be read, so that no time stamps confirm the given sampling rate.
    pub fn unread_stamps(&self) -> Vec<String> {
        let mut found = Vec::new();
        let mut left = vec![&self.layout];
        while let Some(layout) = left.pop() {
            match layout {
                Layout::Csv(csv) => found.extend(csv.unread_stamps.clone()),
                Layout::Stations(layouts) => left.extend(layouts),
                Layout::Npy(_) | Layout::Channels(_) => {}
            }
        }
        found
    }
}

/// Whether some files give times in UTC, and whether some give them without a time zone.
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

fn noted(layout: &Layout, unit_unknown: bool, remarks: &mut Vec<Both>) {
    match layout {
        Layout::Channels(channels) => remarks.extend(channels.notes.iter().cloned()),
        Layout::Stations(layouts) => layouts
            .iter()
            .for_each(|layout| noted(layout, unit_unknown, remarks)),
        Layout::Csv(csv) => of_columns(csv, unit_unknown, remarks),
        Layout::Npy(_) => {}
    }
}

fn of_columns(csv: &CsvLayout, unit_unknown: bool, remarks: &mut Vec<Both>) {
    if csv.is_cp949 {
        remarks.push(Remark::Cp949.into());
    }
    if csv.names_unread {
        remarks.push(Remark::NamesUnread.into());
    }
    if let Some([first, last]) = csv.passed_over {
        remarks.push(match first == last {
            true => Remark::LinePassedOver(first).into(),
            false => Remark::PassedOver { first, last }.into(),
        });
    }
    let unit_of = |name: &String| match unit_in_name(name) {
        FileUnit::Known(unit) => Some((name.clone(), unit.symbol().to_owned())),
        _ => None,
    };
    if let (Some((column, unit)), true) = (csv.columns.iter().find_map(unit_of), unit_unknown) {
        remarks.push(Remark::NoUnitGiven { column, unit }.into());
    }
    if let Some(column) = csv.unread_stamps.clone() {
        remarks.push(Remark::UnreadStamps(column).into());
    }
    if let (Some(column), Some(unit_s)) = (csv.time_column.clone(), csv.time_unit_s) {
        let stamps = match unit_s {
            1e-3 => Remark::Milliseconds(column),
            1e-6 => Remark::Microseconds(column),
            60.0 => Remark::Minutes(column),
            3600.0 => Remark::Hours(column),
            1.0 => Remark::Seconds(column),
            _ => Remark::Days(column),
        };
        remarks.push(stamps.into());
    }
}
