//! Stiffness that explains measured modes, with its load factor.

use crate::error::WorkError;
use crate::surveyed::StiffnessAnswer;
use dolmen::structure::{Convention, MeasuredMode, StiffnessNote, StiffnessSolution, StiffnessSolutions};
use dolmen_project::LoadsPart;

/// Data for the search for a stiffness.
pub(crate) struct MeasuredDirection<'a> {
    pub(crate) direction: &'a str,
    pub(crate) modes: &'a [MeasuredMode],
    pub(crate) notes: &'a [StiffnessNote],
    /// Weights of loads on the structure, which move with it.
    pub(crate) loads: &'a LoadsPart,
}

impl MeasuredDirection<'_> {
    /// The answer with the solutions; `load_factor` computes that of a stiffness.
    pub(crate) fn answer(
        &self,
        convention: Option<Convention>,
        mut solutions: StiffnessSolutions,
        load_factor: impl Fn(&[f64]) -> Result<f64, WorkError>,
    ) -> Result<StiffnessAnswer, WorkError> {
        // with the smallest stiffness that the data allow
        let least = solutions.solutions.iter().map(StiffnessSolution::stiffness_least);
        let load_factors: Result<Vec<Option<f64>>, WorkError> = least
            .map(|least| least.map(|k| load_factor(&k)).transpose())
            .collect();
        let load_factors = load_factors?;
        solutions.notes.extend(self.notes.iter().cloned());
        Ok(StiffnessAnswer {
            direction: self.direction.to_owned(),
            convention,
            frequencies_hz: self.modes.iter().map(|mode| mode.frequency_hz).collect(),
            with_shapes: self.modes.iter().any(|mode| !mode.shape.is_empty()),
            solutions,
            load_factors,
            peaks_below_hz: Vec::new(),
            doubted: None,
            other_choices: Vec::new(),
            beside_file: None,
        })
    }
}
