//! Inputs with which a record has no modes on a fixed base: sines, inputs that are alike, and inputs that move nothing.

use super::driven_modes::DrivenMode;
use crate::modal::ModalError;
use crate::numeric::quantile;
use crate::signal::{CrossSpectra, Record, Welch, cross_spectra};
use dolmen_linalg::{ComplexMatrix, hermitian_eigen};

/// Least share of the motion due to the inputs, at the mode with the largest share; chance alone gives less. Our choice.
const FOLLOWS_LEAST: f64 = 0.15;
/// Least independent share of the inputs' motion; below it their effects cannot be distinguished. Our choice.
const APART_LEAST: f64 = 0.05;

/// Refuses inputs if nearly all power of each is near one line of 32 segments.
pub(super) fn refuse_sine(record: &Record, inputs: &[usize]) -> Result<(), ModalError> {
    const AROUND: usize = 2; // lines that Hann's window fills
    const SHARE_MOST: f64 = 0.95; // chosen here: a noise with a resonance damped by 5 % has less than 0.3
    let spectra = averaged(record, record.length() / 32)?;
    let lines = spectra.frequency_hz.len();
    let shares = inputs.iter().map(|&c| {
        let power = |line: usize| spectra.density(c, c, line).re;
        let whole: f64 = (1..lines).map(power).sum();
        let top = (1..lines)
            .max_by(|a, b| power(*a).total_cmp(&power(*b)))
            .unwrap_or(0);
        let here = top.saturating_sub(AROUND).max(1)..(top + AROUND + 1).min(lines);
        (top, here.map(power).sum::<f64>() / whole.max(f64::MIN_POSITIVE))
    });
    match shares.min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((line, share)) if share > SHARE_MOST => Err(ModalError::InputsSine {
            frequency_hz: spectra.frequency_hz[line],
            share,
        }),
        _ => Ok(()),
    }
}

/// Refuses inputs if one is a combination of the others at most lines.
pub(super) fn refuse_alike(
    record: &Record,
    inputs: &[usize],
    [low_hz, high_hz]: [f64; 2],
) -> Result<(), ModalError> {
    if inputs.len() < 2 {
        return Ok(());
    }
    let spectra = averaged(record, record.length() / 16)?;
    let mut apart = Vec::new();
    for (line, hz) in spectra.frequency_hz.iter().enumerate() {
        if *hz <= low_hz || *hz > high_hz {
            continue;
        }
        let coherent = ComplexMatrix::from_fn(inputs.len(), inputs.len(), |i, j| {
            let (a, b) = (inputs[i], inputs[j]);
            let power = spectra.density(a, a, line).re * spectra.density(b, b, line).re;
            spectra.density(a, b, line) / power.sqrt().max(f64::MIN_POSITIVE)
        });
        apart.push(hermitian_eigen(&coherent)?.values[0]);
    }
    match quantile(&apart, 0.5) {
        Ok(share) if share < APART_LEAST => Err(ModalError::InputsAlike { share }),
        _ => Ok(()),
    }
}

/// Refuses inputs without effect on any mode: the modes would be those of structure and ground together, wrongly named fixed-base modes.
pub(super) fn refuse_unrelated<'a>(modes: impl Iterator<Item = &'a DrivenMode>) -> Result<(), ModalError> {
    let shares: Option<Vec<f64>> = modes.map(|mode| mode.explained).collect();
    let most = shares.and_then(|of| of.into_iter().reduce(f64::max));
    match most {
        Some(share) if share < FOLLOWS_LEAST => Err(ModalError::InputsUnrelated { share }),
        _ => Ok(()),
    }
}

pub(super) fn averaged(record: &Record, wished: usize) -> Result<CrossSpectra, ModalError> {
    let segment_length = wished.clamp(8, record.length().max(8));
    Ok(cross_spectra(record, &Welch { segment_length })?)
}
