//! Common text of all simulations: names, the motion, units.

mod motion;
mod names;
mod undamped;
mod units;

pub(crate) use motion::{doubted, doubted_of, motion_section, steps_of, vertical_peak};
pub(crate) use names::{Simulated, capitalised, cut, under, version_name};
pub(crate) use undamped::undamped;
pub(crate) use units::{energy_unit, kilo, left, milli, millimetres, milliradians, seconds, seconds_whole};

use dolmen_words::Template;

/// Templates of the sentences for all simulations.
pub(crate) const TEMPLATES: [&[Template]; 3] = [
    Simulated::TEMPLATES,
    motion::Motion::TEMPLATES,
    undamped::NoDamping::TEMPLATES,
];
