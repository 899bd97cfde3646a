//! Maximum likelihood modes: fitted to the Fourier lines of each band of the spectrum.

mod band;
mod band_fit;
mod band_lines;
mod band_motion;
mod bayoma;
mod evidence;
mod hermitian;

pub(super) use bayoma::refined;
pub(super) use evidence::{Question, shown_by_lines};
