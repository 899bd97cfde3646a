//! Widths of spectral peaks where few blocks of time are strong.

use super::gusts::unequal;
use crate::modal::options::Identify;
use crate::modal::spectrum::{Fdd, fdd};
use crate::modal::{Method, ModalError};
use crate::signal::Record;

/// Share of the effective blocks of time below which the spectrum is averaged over wider lines. Our choice: with half of them, a line still averages
/// fifteen parts.
const FEW: f64 = 0.5;

/// Peaks of a spectrum whose lines average as many equally strong parts as in a steady record.
///
/// Lines of the usual spectrum average the parts of the record by their power. If few blocks are strong, a line is the average of few parts, and a
/// mode is ragged in the spectrum: the highest of its tips is as narrow as a sine.
pub(super) struct AveragedWidths {
    /// Frequency and width of each peak, Hz.
    peaks_hz: Vec<[f64; 2]>,
}

impl AveragedWidths {
    pub(super) fn of(record: &Record, options: &Identify) -> Result<Self, ModalError> {
        let share = unequal(record, options.time_blocks).time_blocks as f64 / options.time_blocks as f64;
        // the spectrum of a free decay averages nothing
        if share > FEW || options.fdd.lines.is_some() || options.method == Method::Era {
            return Ok(AveragedWidths { peaks_hz: Vec::new() });
        }
        let lines = options.fdd.lines_of(record)? as f64;
        let wider = Fdd {
            lines: Some(
                ((share * lines) as usize)
                    .next_power_of_two()
                    .max(Fdd::LINES_LEAST),
            ),
            ..options.fdd.clone()
        };
        let found = fdd(record, &wider)?;
        let each = found.modes.modes.iter().zip(&found.spectrum.half_power_width_hz);
        Ok(AveragedWidths {
            peaks_hz: each
                .map(|(mode, width_hz)| [mode.frequency_hz, *width_hz])
                .collect(),
        })
    }

    /// Width of a peak that is `width_hz` wide in the usual spectrum, Hz.
    pub(super) fn width_hz(&self, frequency_hz: f64, width_hz: f64) -> f64 {
        let here = self
            .peaks_hz
            .iter()
            .filter(|[at_hz, wide_hz]| (at_hz - frequency_hz).abs() <= *wide_hz);
        here.map(|[_, wide_hz]| *wide_hz).fold(width_hz, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{MadeMode, MadeRecord};

    #[test]
    fn holds_the_tip_of_a_ragged_peak_is_as_wide_as_its_mode() {
        let (hz, zeta) = (5.3, 0.02);
        let made = MadeRecord {
            modes: vec![MadeMode {
                frequency_hz: hz,
                damping_ratio: zeta,
                shape: vec![1.0, 0.6],
            }],
            duration_s: 3600.0,
            sampling_rate_hz: 25.0,
            seed: 2,
            ..MadeRecord::default()
        };
        let steady = made.make().unwrap();
        let options = Identify::default();
        let of_steady = AveragedWidths::of(&steady, &options).unwrap();
        assert_eq!(of_steady.width_hz(hz, 0.01), 0.01);
        // two of sixty minutes are ten times as strong
        let gust = |c: usize| -> Vec<f64> {
            let each = steady.samples(c).iter().enumerate();
            let strong = |t: usize| (30_000..33_000).contains(&t);
            each.map(|(t, y)| if strong(t) { 10.0 * y } else { *y }).collect()
        };
        let gusty = Record::new(steady.channels().to_vec(), vec![gust(0), gust(1)], 25.0).unwrap();
        let width_hz = AveragedWidths::of(&gusty, &options).unwrap().width_hz(hz, 0.01);
        assert!((0.7..1.6).contains(&(width_hz / (2.0 * zeta * hz))), "{width_hz}");
    }
}
