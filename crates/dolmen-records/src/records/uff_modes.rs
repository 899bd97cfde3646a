//! Modes of a universal file: dataset 55 (data at nodes), real or complex, with nodes (15, 2411) and units (164).
//!
//! ```text
//! five lines of text, then:
//! 6   model  analysis  characteristic  specific data  2 real, 5 complex  values a node
//! 7   integers, reals, load case, mode
//! 8   analysis 2: frequency (Hz), modal mass, viscous and hysteretic damping; 3, 7: eigenvalue (rad/s), modal A and B
//! 9   node, then its values, for each node
//! ```
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ = −ζω ± iω√(1 − ζ²) | `eigenvalue` | complex eigenvalue | rad/s |
//! | ζ, η | `damping_ratio`, `hysteretic` | viscous damping ratio, loss factor; ζ = η/2 at resonance | |
//!
//! Source: University of Cincinnati, Structural Dynamics Research Laboratory, *Universal File Formats for Modal Analysis Testing*.

use super::RecordError;
use super::uff::{OtherDatasets, datasets, printed};
use super::uff_text::{FORMAT, Lines, cell, decimal, whole};
use crate::quoted::listed;
use crate::wrong::{Expected, Unread};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Codes of line 6.
const NORMAL: i64 = 2;
const COMPLEX_EIGENVALUES: [i64; 2] = [3, 7];
const REAL: i64 = 2;
const COMPLEX: i64 = 5;
/// Number of values per node: displacements, or displacements and rotations.
const VALUES: [i64; 2] = [3, 6];
/// Number of columns of a real number.
const WIDTH: usize = 13;
/// Number of text lines of a dataset 55.
const LINES: usize = 5;
/// Text before the standard deviations in the third line of text of a file from Dolmen.
const DEVIATIONS: &str = "standard deviations ";

/// A mode of a universal file.
#[derive(Clone, Debug, PartialEq)]
pub struct UffMode {
    /// Natural (undamped) frequency, Hz.
    pub frequency_hz: f64,
    /// Its standard deviation, Hz, if Dolmen wrote the file.
    pub frequency_sd_hz: Option<f64>,
    /// Damping ratio; `None` where the file has 0, which programs write for unknown.
    pub damping_ratio: Option<f64>,
    /// Its standard deviation, if Dolmen wrote the file.
    pub damping_ratio_sd: Option<f64>,
    /// Displacement of each node along x, y and z: real and imaginary part.
    pub displacements: BTreeMap<i64, [[f64; 2]; 3]>,
    /// The line of the frequency.
    pub line: usize,
}

/// The modes of a universal file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UffModes {
    /// In the order of the file.
    pub modes: Vec<UffMode>,
    /// Positions of nodes in the length unit of the file.
    pub places: BTreeMap<i64, [f64; 3]>,
    /// Length units of the file per metre; `None` without a dataset 164.
    pub lengths_a_metre: Option<f64>,
}

/// The modes of a universal file (datasets 55 of normal modes or complex eigenvalues).
///
/// Of a conjugate pair, the mode with the positive imaginary part is kept.
///
/// # Errors
/// [`RecordError`] if it is not a universal file, contains no modes, or rotates the axes of its nodes.
///
/// # Source
/// As for the reader of the file; validated with files of pyuff 2.5.8 (`tests/records/uff_modes.rs`).
pub fn read_modes_uff(bytes: &[u8]) -> Result<UffModes, RecordError> {
    let mut modes: Vec<(UffMode, bool)> = Vec::new();
    let beside = datasets(bytes, "55", &mut |lines, _, beside| {
        match mode(lines)? {
            Some(one) => modes.push(one),
            None => beside.pass("55, no modes"),
        }
        Ok(())
    })?;
    let has_positive = modes.iter().any(|(_, is_negative)| !is_negative);
    modes.retain(|(_, is_negative)| !(has_positive && *is_negative));
    refuse(&beside, modes.is_empty())?;
    Ok(UffModes {
        modes: modes.into_iter().map(|(mode, _)| mode).collect(),
        places: beside.nodes,
        lengths_a_metre: beside.length,
    })
}

fn refuse(beside: &OtherDatasets, is_empty: bool) -> Result<(), RecordError> {
    let passed = beside.passed_over();
    let (what, instead) = if is_empty {
        let held = match passed.is_empty() {
            true => Unread::WithoutAny.into(),
            false => listed(&passed),
        };
        (Unread::NoModes(held), Unread::Dataset55)
    } else if beside.turned {
        (Unread::TurnedAxes, Unread::GlobalAxes)
    } else {
        return Ok(());
    };
    Err(RecordError::NotReadHere {
        format: FORMAT,
        what: what.into(),
        instead: instead.into(),
    })
}

/// A dataset 55 up to its end, and whether it is the conjugate of a mode; `None` if it contains no mode.
fn mode(lines: &mut Lines) -> Result<Option<(UffMode, bool)>, RecordError> {
    let mut text = Vec::with_capacity(LINES);
    for _ in 0..LINES {
        text.push(lines.want(Expected::Lines55)?);
    }
    let sixth = lines.want(Expected::Codes55)?;
    let code =
        |at: usize| whole(&cell(&sixth, 10 * at, 10)).ok_or_else(|| lines.is_not(&sixth, Expected::Codes55));
    let (analysis, kind, values) = (code(1)?, code(4)?, code(5)?);
    let is_complex_eigenvalue = COMPLEX_EIGENVALUES.contains(&analysis);
    if analysis != NORMAL && !is_complex_eigenvalue {
        return Ok(None);
    }
    if !VALUES.contains(&values) || ![REAL, COMPLEX].contains(&kind) {
        return Err(lines.is_not(&sixth, Expected::Vectors55));
    }
    lines.want(Expected::Integers55)?;
    let line = lines.number() + 1;
    let reals = lines.peek()?.unwrap_or_default();
    let wanted = if is_complex_eigenvalue { 2 } else { 1 };
    let numbers = numbers(&reals).filter(|numbers| numbers.len() >= wanted);
    lines.want(Expected::Frequency55)?;
    let numbers = numbers.ok_or_else(|| lines.is_not(&reals, Expected::Frequency55))?;
    let (frequency_hz, damping_ratio) = match is_complex_eigenvalue {
        true => {
            let modulus = numbers[0].hypot(numbers[1]);
            (modulus / TAU, -numbers[0] / modulus)
        }
        false => {
            let of = |at: usize| numbers.get(at).copied().unwrap_or(0.0);
            let (viscous, hysteretic) = (of(2), of(3));
            let damping_ratio = if viscous == 0.0 { 0.5 * hysteretic } else { viscous };
            (numbers[0], damping_ratio)
        }
    };
    let is_negative = is_complex_eigenvalue && numbers[1] < 0.0;
    if !(frequency_hz > 0.0 && frequency_hz.is_finite() && (0.0..1.0).contains(&damping_ratio)) {
        return Err(lines.is_not(&reals, Expected::FrequencyAndDamping55));
    }
    let (frequency_sd_hz, damping_ratio_sd) = deviations(&text[2]);
    Ok(Some((
        UffMode {
            frequency_hz,
            frequency_sd_hz,
            damping_ratio: Some(damping_ratio).filter(|ratio| *ratio > 0.0),
            damping_ratio_sd,
            displacements: displacements(lines, kind == COMPLEX, values as usize)?,
            line,
        },
        is_negative,
    )))
}

/// The values of each node up to the −1.
fn displacements(
    lines: &mut Lines,
    is_complex: bool,
    values: usize,
) -> Result<BTreeMap<i64, [[f64; 2]; 3]>, RecordError> {
    let parts = if is_complex { 2 } else { 1 };
    let mut all = BTreeMap::new();
    while let Some(line) = lines.peek()?.filter(|line| line.trim() != "-1") {
        lines.next()?;
        let node = whole(&cell(&line, 0, 10)).filter(|_| !line.trim().is_empty());
        let node = node.ok_or_else(|| lines.is_not(&line, Expected::NodeLabel))?;
        let count = parts * values;
        let read = printed(lines, (count, WIDTH), [Expected::Values55, Expected::Values55])?;
        let mut vector = [[0.0; 2]; 3];
        for (component, pair) in vector.iter_mut().zip(read.chunks(parts)) {
            component[..parts].copy_from_slice(pair);
        }
        all.insert(node, vector);
    }
    Ok(all)
}

/// The numbers of a line, separated by blanks or in columns of fixed width.
fn numbers(line: &str) -> Option<Vec<f64>> {
    let apart: Option<Vec<f64>> = line.split_whitespace().map(decimal).collect();
    let columns = || {
        let characters: Vec<char> = line.trim_end().chars().collect();
        let cells = characters.chunks(WIDTH);
        cells
            .map(|cell| decimal(&cell.iter().collect::<String>()))
            .collect()
    };
    let all: Option<Vec<f64>> = apart.or_else(columns);
    all.filter(|all| all.iter().all(|x| x.is_finite()))
}

/// Standard deviations of frequency and damping ratio in the text of a file from Dolmen.
fn deviations(text: &str) -> (Option<f64>, Option<f64>) {
    let Some((hz, ratio)) = text
        .strip_prefix(DEVIATIONS)
        .and_then(|rest| rest.split_once(" Hz, "))
    else {
        return (None, None);
    };
    let read = |text: &str| decimal(text).filter(|sd| *sd > 0.0 && sd.is_finite());
    (read(hz), read(ratio))
}
