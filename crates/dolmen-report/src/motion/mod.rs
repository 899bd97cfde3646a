//! Answers about a ground motion: its files, measures, match and spectra.

mod files;
mod matched;
mod measures;
mod spectra;
mod suite;
mod text;

pub use suite::suite_text;
pub use text::motion_report_text;

use dolmen_words::Template;

/// Templates of the sentences on ground motions.
pub(crate) const TEMPLATES: [&[Template]; 6] = [
    files::Files::TEMPLATES,
    matched::Matched::TEMPLATES,
    measures::Measured::TEMPLATES,
    spectra::Spectra::TEMPLATES,
    suite::Suite::TEMPLATES,
    text::Motion::TEMPLATES,
];
