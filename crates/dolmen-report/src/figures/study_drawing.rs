//! Kinds and sizes of figures of studies.

use super::Figure;

/// Size of a figure, px.
pub(super) const SIZE_PX: [f64; 2] = [640.0, 380.0];

/// Content of a figure of a study.
#[derive(Clone, Copy)]
pub(crate) enum StudyFigure {
    /// Capacity against an input.
    Capacity,
    /// Falls and survivals.
    Survived,
    /// Probabilities of states.
    Fragility,
    /// Response of the runs as the shaking increases.
    Growth,
    /// Shares of slipping under a harmonic ground.
    Harmonic,
    /// Free motion.
    Release,
}

/// A figure of a study, drawn.
pub(crate) struct StudyDrawing {
    pub(crate) shows: StudyFigure,
    pub(crate) figure: Figure,
}

impl StudyDrawing {
    pub(super) fn new(shows: StudyFigure, name: String, svg: String) -> Self {
        let figure = Figure { name, svg };
        StudyDrawing { shows, figure }
    }
}
