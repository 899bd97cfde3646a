//! Options of the search for stiffness, and weighting of the data.

use super::modal_fit::StandIn;
use crate::structure::{MeasuredMode, StructureError};

/// Options of the search for stiffness from measured modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StiffnessSearch {
    /// Number of random starting points, for problems in which not all solutions can be followed. Default 1000, our choice: with five
    /// frequencies of the flagpole of Choi (2021) it finds the same solutions as 10,000 starts, both for stiffness in proportion to M_i
    /// and for equal joints.
    pub starts: usize,
    /// Largest number of listed solutions; a note gives the number of further ones. Default 64, our choice.
    pub solutions_most: usize,
    /// Largest misfit of a solution in standard deviations (given or assumed), if the modes have standard deviations or shapes. Default
    /// 2, our choice.
    pub misfit_most: f64,
    /// Largest relative misfit of frequencies, if there are only frequencies without standard deviations. Default 0.01, our choice: the
    /// frequencies of monuments differ by about that between seasons.
    pub difference_most: f64,
    /// Relative standard deviation assumed for a frequency without one, if shapes or other data with standard deviations are given.
    /// Default 0.005, our choice.
    pub frequency_sd_assumed: f64,
    /// Standard deviation assumed for a shape point without one, relative to the largest displacement of the mode. Default 0.05, our
    /// choice: measured shapes scatter by about that.
    pub shape_sd_assumed: f64,
}

impl Default for StiffnessSearch {
    fn default() -> Self {
        StiffnessSearch {
            starts: 1000,
            solutions_most: 64,
            misfit_most: 2.0,
            difference_most: 0.01,
            frequency_sd_assumed: 0.005,
            shape_sd_assumed: 0.05,
        }
    }
}

impl StiffnessSearch {
    pub(super) fn check(&self) -> Result<(), StructureError> {
        let positive = "a positive number";
        for (option, given, allowed) in [
            ("starts", self.starts as f64, "at least 1"),
            ("solutions_most", self.solutions_most as f64, "at least 1"),
            ("misfit_most", self.misfit_most, positive),
            ("difference_most", self.difference_most, positive),
            ("frequency_sd_assumed", self.frequency_sd_assumed, positive),
            ("shape_sd_assumed", self.shape_sd_assumed, positive),
        ] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(StructureError::Option {
                    option,
                    given,
                    allowed,
                });
            }
        }
        Ok(())
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Weighting {
    /// Frequencies only, without standard deviations: relative differences.
    Relative,
    /// Shapes are given, but no datum has a standard deviation: all get an assumed one.
    Assumed,
    /// All data have standard deviations.
    Given,
    /// Some data have standard deviations; the others get an assumed one.
    PartlyAssumed,
}

impl Weighting {
    pub(super) fn of(modes: &[MeasuredMode]) -> Self {
        let all = modes.iter().flat_map(|mode| {
            // the largest deviation of a shape counts, because the point that sets its scale has none
            let points = mode.shape.iter().filter(|_| mode.shape.len() >= 2);
            let shape = points.map(|point| point.displacement_sd).reduce(f64::max);
            shape.into_iter().chain([mode.frequency_sd_hz])
        });
        let (given, count) = all.fold((0, 0), |(given, count), sd| {
            (given + usize::from(sd > 0.0), count + 1)
        });
        let shapes = modes.iter().any(|mode| mode.shape.len() >= 2);
        match given {
            0 if shapes => Weighting::Assumed,
            0 => Weighting::Relative,
            given if given == count => Weighting::Given,
            _ => Weighting::PartlyAssumed,
        }
    }

    pub(super) fn stand_in(self, options: &StiffnessSearch) -> StandIn {
        match self {
            Weighting::Relative => StandIn {
                frequency: 1.0,
                shape: 1.0,
            },
            _ => StandIn {
                frequency: options.frequency_sd_assumed,
                shape: options.shape_sd_assumed,
            },
        }
    }
}
