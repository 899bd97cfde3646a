//! How stiffness is sought, and by what measure data are weighted.

use super::modal_fit::StandIn;
use crate::structure::{MeasuredMode, StructureError};

/// How stiffness is sought from measured modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StiffnessSearch {
    /// Starting points scattered over the stiffnesses, where not every solution can be followed. Default 1000, our
    /// choice: with five frequencies of the flagpole of Choi (2021) it finds what 10,000 find for stiffness in
    /// proportion to M_i and for equal joints.
    pub starts: usize,
    /// Most solutions listed; how many more were found is noted. Default 64, our choice.
    pub solutions_most: usize,
    /// Largest misfit of a solution where the modes carry standard deviations or shapes, in standard deviations, given or
    /// assumed. Default 2, our choice.
    pub misfit_most: f64,
    /// Largest misfit of frequencies alone where they carry none, relative. Default 0.01, our choice: frequencies of monuments repeat to
    /// about that between seasons.
    pub difference_most: f64,
    /// Relative standard deviation taken for a frequency without one beside shapes or data that have theirs. Default 0.005, our
    /// choice.
    pub frequency_sd_assumed: f64,
    /// Standard deviation taken for a shape point without one, relative to the largest displacement of the mode. Default
    /// 0.05, our choice: shapes of the field scatter by about that.
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
    /// Refuses what makes no sense.
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

/// Whether the data are weighted by standard deviations.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Weighting {
    /// Frequencies alone, none with one: relative differences.
    Relative,
    /// None has one, but shapes are given: all get an assumed one.
    Assumed,
    /// All have.
    Given,
    /// Some have; the others get an assumed one.
    PartlyAssumed,
}

impl Weighting {
    pub(super) fn of(modes: &[MeasuredMode]) -> Self {
        let all = modes.iter().flat_map(|mode| {
            // one point without scatter among others with it is where the scale was taken
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
