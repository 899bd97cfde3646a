//! Modes of greatest likelihood: fitted to the Fourier lines of one band after another.

mod band;
mod band_fit;
mod band_lines;
mod band_motion;
mod bayoma;
mod hermitian;

pub(super) use bayoma::refined;
