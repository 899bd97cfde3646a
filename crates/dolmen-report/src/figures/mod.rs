//! Figures as SVG: text stays text, units on every axis, readable for colour-blind readers and in grey print.

mod assess;
mod axis;
mod building;
mod building_drifts;
mod building_histories;
mod chain;
mod chain_histories;
mod chain_moments;
mod change;
mod channels;
mod damage_map;
mod demand;
mod drawing;
mod earthquakes;
mod elevation;
mod fragility;
mod frame;
mod frame_histories;
mod free_columns;
mod frequency_by_height;
mod gusts;
mod history_series;
mod hull;
mod identification;
mod ink;
mod joint_factors;
mod likeness;
mod lines;
mod modal;
mod model_likeness;
mod more_numbers;
mod motion;
mod moved_supports;
mod moving_shapes;
mod numbers;
mod plan_modes;
mod plot;
mod rank;
mod responses;
mod scene;
mod shaking;
mod shapes;
mod sheet;
mod side_posts;
mod spectrogram;
mod stack;
mod stack_directions;
mod stack_histories;
mod stack_limits;
mod stack_pushed;
mod stack_settled;
mod stack_view;
mod storey_pushed;
mod study;
mod study_drawing;
mod study_growth;
mod suite;
mod supports_in_time;
mod tune;
mod wind_histories;
mod wires;
mod words;
mod years;

use dolmen_words::Template;

pub use assess::{VariantDot, load_factor_distribution, variants_compared};
pub use building::building_plan;
pub(crate) use building_drifts::building_drifts;
pub(crate) use building_histories::BuildingPlot;
pub use building_histories::building_histories;
pub use chain::{centroid_effect, chain_elevation, stiffness_limits};
pub(crate) use chain_histories::ChainPlot;
pub use chain_histories::chain_histories;
pub use chain_moments::chain_moments;
pub use change::survey_changes;
pub(crate) use channels::{CHANNELS_DRAWN, channels_over_time, unit_of};
pub(crate) use damage_map::{DamageMark, damage_map};
pub use demand::design_spectrum;
pub(crate) use demand::spectrum_curves;
pub(crate) use drawing::{drawing, planned_drawing};
pub(crate) use earthquakes::{frequency_through, lowest_of_parts, spectra_of_channels};
pub(crate) use elevation::columns_seen;
pub use frame::frame_sketch;
pub(crate) use frame_histories::FramePlot;
pub use frame_histories::frame_histories;
pub use free_columns::free_columns;
pub(crate) use frequency_by_height::frequency_by_height;
pub(crate) use gusts::{GustPlot, gust_profile};
pub use identification::{Figure, identification};
pub(crate) use identification::{letter, measured_modes, solution_shapes};
pub(crate) use joint_factors::joint_factors;
pub use likeness::likeness;
pub use modal::{sensor_shapes, singular_values, stabilization};
pub(crate) use model_likeness::model_likeness;
pub(crate) use more_numbers::{
    columns_series, direction_series, gust_series, pushed_series, study_series, tune_series, years_series,
};
pub use motion::motion_figures;
pub(crate) use moved_supports::moved_supports;
pub use moving_shapes::moving_shapes;
pub(crate) use numbers::{
    chain_series, drawing_series, frame_series, likeness_series, moved_series, pole_series, singular_series,
    stone_series, through_series,
};
pub(crate) use plan_modes::plan_modes;
pub use rank::ranking;
pub(crate) use responses::{response_coherence, response_magnitudes};
pub use shaking::Shaking;
pub use shapes::{ShapePanel, mode_shapes};
pub(crate) use spectrogram::spectrogram;
pub use stack::{stack_after, stack_view};
pub use stack_directions::stack_directions;
pub(crate) use stack_histories::StackPlot;
pub use stack_histories::stack_histories;
pub use stack_limits::{stack_capacity, stack_governing};
pub(crate) use stack_pushed::stack_pushed;
pub(crate) use stack_settled::stack_settled;
pub use storey_pushed::storey_pushed;
pub(crate) use study::study_drawings;
pub use study::study_figures;
pub(crate) use study_drawing::{StudyDrawing, StudyFigure};
pub use suite::suite_figure;
pub(crate) use supports_in_time::{supports_in_time, supports_series};
pub(crate) use tune::TuneFigure;
pub use tune::tune_figures;
pub(crate) use wind_histories::WindPlot;
pub use wind_histories::wind_histories;
pub(crate) use wires::Wires;
pub(crate) use words::TEMPLATES;
pub use years::years;

/// Templates of the words in single figures.
pub(crate) const OF_SINGLE_FIGURES: [&[Template]; 6] = [
    damage_map::Mapped::TEMPLATES,
    drawing::Drawn::TEMPLATES,
    moved_supports::Shown::TEMPLATES,
    stack_pushed::Shown::TEMPLATES,
    suite::SuiteLines::TEMPLATES,
    years::Panels::TEMPLATES,
];
