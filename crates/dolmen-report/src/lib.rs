//! Answers as text, JSON, figures and pages, in English and Korean. Opens no file.

mod after_first;
mod behind;
mod brief;
mod brief_rows;
mod building;
mod building_simulation;
mod chain;
mod change;
mod check;
mod damaged;
mod demand;
mod document;
pub mod docx;
mod engineer;
pub mod explain;
mod explain_korean;
mod explanation;
pub mod figures;
pub mod files;
pub mod film;
mod finite;
mod frame;
mod frame_simulation;
mod gltf;
mod headline;
mod headline_basis;
mod headline_combined;
mod headline_damage;
pub mod html;
pub mod hwpx;
mod identification;
mod identify;
mod inputs_by_part;
pub mod json;
pub mod kept;
mod limits;
mod load_factor;
mod loads;
mod lowered;
mod mark;
mod modal;
mod mode_film;
mod motion;
mod on_paper;
mod other_inputs;
mod paper;
mod processing;
mod rank;
mod scanned;
mod score;
mod sensors;
pub mod sentences;
mod simulated;
mod stack;
mod stack_simulation;
mod study;
mod surveys_given;
mod surveys_many;
pub mod tables;
pub mod text;
mod tune;
pub mod typeset;
mod warned;
mod watch;
mod whole;
mod wind_simulation;
pub mod xlsx;

pub use after_first::after_first_text;
pub use check::{against_studies_text, against_text, check_text};
pub use document::TextStyle;
pub use finite::{JsonObject, json_value};
pub use headline::{simulation_headline_text, solution_headlines_text};
pub use identification::written_back_text;
pub use identify::identification_text;
pub use motion::{motion_report_text, suite_text};
pub use rank::rank_text;
pub use scanned::scan_text;
pub use score::{score_given_text, score_quality_text, score_text};
pub use sensors::sensors_text;

/// The listings of the book are compiled and run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/library.md")]
pub struct LibraryPage;

/// The same of fragility.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/fragility.md")]
pub struct FragilityPage;
