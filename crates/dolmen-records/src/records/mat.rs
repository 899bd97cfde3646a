//! Reads MAT files of version 5 (MATLAB's `-v7` and `-v6`) and version 7.3 (HDF5): numeric matrices, plain or compressed.
//!
//! The longest side of all numeric matrices is the time axis. Each vector or matrix with a side of that length is read, as `acc`, or as `acc(:,1)`,
//! `acc(:,2)`, or `acc(1,:)`, `acc(2,:)` if time runs along the rows. A vector `t` or `time` holds time stamps; a scalar `fs`, `sampling_rate` … is the sampling rate, and `dt` the time step. A note lists
//! the other variables.

use super::hdf5;
use super::mat_elements::{Matrix, matrices};
use super::series::{FileSeries, Series, rate_of_step};
use super::{RecordError, RecordFormat};
use crate::limits::refuse_channels;
use crate::quoted::listed;
use crate::wrong::{Remark, Unread};
use dolmen_words::message::Both;

const FORMAT: &str = "mat";
/// Names of a scalar that holds the sampling rate, Hz, in lower case without underscores.
const RATES: [&str; 8] = [
    "fs",
    "fsamp",
    "sf",
    "samplerate",
    "samplingrate",
    "samplingratehz",
    "samplingfrequency",
    "freqsampling",
];
/// Names of a scalar that holds the time step, s.
const STEPS: [&str; 3] = ["dt", "timestep", "ts"];
const TIMES: [&str; 3] = ["t", "time", "times"];
/// Largest deviation of time stamps from equal steps, in steps. Our choice: double precision is more accurate.
const UNEVEN: f64 = 1e-3;

pub(super) fn is_mat(bytes: &[u8]) -> bool {
    bytes.starts_with(b"MATLAB 5.0 MAT-file") || bytes.starts_with(b"MATLAB 7.3 MAT-file")
}

fn plain(name: &str) -> String {
    name.to_lowercase().replace('_', "")
}

pub(super) fn read(bytes: &[u8]) -> Result<FileSeries, RecordError> {
    let (all, mut passed) = match bytes.starts_with(b"MATLAB 7.3") {
        true => hdf5::matrices(bytes)?,
        false => matrices(bytes)?,
    };
    let length = all.iter().map(|m| m.rows.max(m.columns)).max().unwrap_or(0);
    if length < 2 {
        return Err(RecordError::NotReadHere {
            format: FORMAT,
            what: Unread::NoMatrix(names(&all, &passed)).into(),
            instead: Unread::SaveMatrix.into(),
        });
    }
    let mut rate_hz = None;
    let mut series = Vec::new();
    for matrix in all {
        let name = plain(&matrix.name);
        let numbers = matrix.rows.saturating_mul(matrix.columns);
        if numbers == 1 {
            let value = matrix.values.first().copied().unwrap_or(f64::NAN);
            let found = if RATES.contains(&name.as_str()) {
                Some(value)
            } else if STEPS.contains(&name.as_str()) {
                Some(rate_of_step(value, 1e-12))
            } else {
                None
            };
            match found {
                Some(rate) => agreed(&mut rate_hz, rate, &matrix.name)?,
                None => passed.push(matrix.name),
            }
        } else if matrix.rows.max(matrix.columns) != length {
            passed.push(matrix.name);
        } else if numbers == length && TIMES.contains(&name.as_str()) {
            agreed(&mut rate_hz, stamps(&matrix)?, &matrix.name)?;
        } else {
            refuse_channels(FORMAT, (numbers / length).saturating_add(series.len()))?;
            series.extend(columns(matrix, length));
        }
    }
    if series.is_empty() {
        return Err(RecordError::NotReadHere {
            format: FORMAT,
            what: Unread::TimesAlone.into(),
            instead: Unread::SaveBeside.into(),
        });
    }
    series.iter_mut().for_each(|one| one.sampling_rate_hz = rate_hz);
    let note = (!passed.is_empty()).then(|| Remark::VariablesUnread(listed(&passed)).into());
    Ok(FileSeries {
        format: RecordFormat::Mat,
        series,
        notes: note.into_iter().collect(),
    })
}

fn names(all: &[Matrix], passed: &[String]) -> Both {
    let names: Vec<&str> = all
        .iter()
        .map(|m| m.name.as_str())
        .chain(passed.iter().map(String::as_str))
        .collect();
    if names.is_empty() {
        Unread::Nothing.into()
    } else {
        listed(&names)
    }
}

/// Several variables may give the rate; they must agree.
fn agreed(known: &mut Option<f64>, rate: f64, name: &str) -> Result<(), RecordError> {
    const TOLERANCE: f64 = 1e-6;
    if !(rate > 0.0 && rate.is_finite()) {
        return Err(RecordError::Variable {
            name: name.to_owned(),
            what: Unread::Rate(rate).into(),
        });
    }
    match known {
        Some(other) if (*other / rate - 1.0).abs() > TOLERANCE => Err(RecordError::Variable {
            name: name.to_owned(),
            what: Unread::TwoRates { rate, other: *other }.into(),
        }),
        Some(_) => Ok(()),
        None => {
            *known = Some(rate);
            Ok(())
        }
    }
}

/// Sampling rate from equally spaced time stamps, Hz.
fn stamps(matrix: &Matrix) -> Result<f64, RecordError> {
    let t = &matrix.values;
    let (first, last) = (t[0], t[t.len() - 1]);
    let step = (last - first) / (t.len() - 1) as f64;
    let even = |(i, x): (usize, &f64)| (x - first - i as f64 * step).abs() <= UNEVEN * step;
    match step > 0.0 && step.is_finite() && t.iter().enumerate().all(even) {
        true => Ok(rate_of_step(step, 1e-9)),
        false => Err(RecordError::Variable {
            name: matrix.name.clone(),
            what: Unread::UnevenStamps.into(),
        }),
    }
}

/// The channels of a matrix stored column by column.
fn columns(matrix: Matrix, length: usize) -> Vec<Series> {
    if matrix.values.len() == length {
        return vec![Series::new(matrix.name, matrix.values)];
    }
    let along_rows = matrix.rows == length;
    let count = matrix.values.len() / length;
    let channel = |j: usize| -> Vec<f64> {
        if along_rows {
            matrix.values[j * length..(j + 1) * length].to_vec()
        } else {
            matrix.values.iter().skip(j).step_by(count).copied().collect()
        }
    };
    let name = |j: usize| match along_rows {
        true => format!("{}(:,{})", matrix.name, j + 1),
        false => format!("{}({},:)", matrix.name, j + 1),
    };
    (0..count).map(|j| Series::new(name(j), channel(j))).collect()
}
