//! Checks of a record and its modes: machines, clocks, sensors, clipping, gusts, pairs of modes under one peak.

mod averaged;
mod clipping;
mod clocks;
mod combs;
mod crest_phases;
mod from_clipping;
mod gusts;
mod harmonics;
mod hidden_pairs;
mod in_spells;
mod late_clocks;
mod lines;
mod machines;
mod refused_peaks;
mod remarks;
mod shape_checks;
mod spells;
mod valleys;
mod wander;

pub(super) use clipping::{ClippedRecord, leave_out_clipped};
pub(super) use clocks::leave_out_other_clocks;
pub(super) use combs::leave_out_combs;
pub use from_clipping::FromClipping;
pub(super) use gusts::{unequal, widen};
pub use harmonics::{Kurtosis, band_kurtosis};
pub(super) use hidden_pairs::note_hidden_pairs;
pub use in_spells::InSpells;
pub(super) use late_clocks::off_clocks;
pub(super) use machines::{SetAside, note_tones_on_modes, of_steady, split_tones};
pub(super) use machines::{leave_out_steadier, test_for_machines};
pub(super) use refused_peaks::Diagram;
pub(super) use remarks::{explained, near, remark};
pub(super) use shape_checks::{Quantities, doubt_channels, to_one_quantity};
pub(super) use spells::leave_out_spells;
pub(super) use valleys::in_valleys;
pub use wander::Wander;
