//! What figures of studies show, and how large they are.

use super::Figure;

/// Size of a figure, px.
pub(super) const SIZE_PX: [f64; 2] = [640.0, 380.0];

/// What a figure of a study shows.
#[derive(Clone, Copy)]
pub(crate) enum StudyFigure {
    /// Capacity against an input.
    Capacity,
    /// What fell and what survived.
    Survived,
    /// Probabilities of states.
    Fragility,
    /// What the runs reach as the shaking grows.
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
