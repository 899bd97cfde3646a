//! Lower bounds of the joint factors from the measured frequencies: how soft each joint can be, whatever the stiffness of the other joints.
//!
//! ```text
//! λ_q(c) increases with every c_g (Courant–Fischer). So assume that all other joints are rigid: a c_j that gives mode q a frequency below the
//! measured f is excluded.
//! ```

use super::model::{Datum, FactorModel};
use crate::numeric::{Bracketing, bracketed_root};
use std::f64::consts::TAU;

/// Factor, relative to the common factor, at which a joint counts as rigid. Our choice: the remaining flexibility changes a bound by less than 1e-4,
/// and rounding of the eigendecomposition by 1e-7.
pub(super) const RIGID: f64 = 1e6;
/// Softest factor in the search, relative to the common factor: a softer joint is open. Our choice.
const OPEN: f64 = 1e-6;
/// Number of standard deviations below the measured frequency at which a factor is excluded.
const EXCLUDED_SD: f64 = 2.0;
/// Tolerance of the bounds in ln c, far below the measurement error.
const BOUND_WITHIN: f64 = 1e-7;

pub(super) struct LeastFactor {
    pub(super) factor: f64,
    /// Index of the measured frequency that gives the bound.
    pub(super) datum: usize,
}

impl FactorModel {
    /// The lower bound of the factor of joint `j`, whatever the other factors are; `None` if no measured frequency gives one. Each measured frequency
    /// gets the highest order that it has in its mode family for any of the factors `known`.
    pub(super) fn least(&self, j: usize, common: f64, known: &[Vec<f64>]) -> Option<LeastFactor> {
        let mut least: Option<LeastFactor> = None;
        for (at, datum) in self.data.iter().enumerate() {
            let others = vec![common.ln() + RIGID.ln(); self.unknowns];
            let ends = [common.ln() + OPEN.ln(), common.ln() + RIGID.ln()];
            let order = known
                .iter()
                .filter_map(|factors| self.order_at(datum, factors))
                .max();
            let off = -EXCLUDED_SD * datum.relative_sd;
            let family = &self.families[datum.family];
            let found = order.and_then(|order| {
                let square = |factors: &[f64]| family.square_of(factors, order);
                crossing(square, datum, j, &others, ends, off)
            });
            let Some(x) = found else {
                continue;
            };
            if least.as_ref().is_none_or(|known| x.exp() > known.factor) {
                least = Some(LeastFactor {
                    factor: x.exp(),
                    datum: at,
                });
            }
        }
        least
    }
}

/// Solves for x_j = ln c_j between two ends, with the other factors at `others`. At the root, `square`, which gives ω², equals the measured ω² times
/// e^(2 `off`). `None` if there is no root between the ends.
pub(super) fn crossing(
    square: impl Fn(&[f64]) -> Option<f64>,
    datum: &Datum,
    j: usize,
    others: &[f64],
    ends: [f64; 2],
    off: f64,
) -> Option<f64> {
    let mut factors: Vec<f64> = others.iter().map(|x| x.exp()).collect();
    let aim = (TAU * datum.frequency_hz).powi(2);
    let mut away = |x: f64| {
        factors[j] = x.exp();
        let square = square(&factors).unwrap_or(f64::NAN);
        // a mode without stiffness has zero frequency, below every measured one
        0.5 * (square.max(f64::MIN_POSITIVE) / aim).ln() - off
    };
    let bracketing = Bracketing {
        width_most: BOUND_WITHIN,
        ..Bracketing::default()
    };
    bracketed_root(&mut away, ends[0], ends[1], &bracketing).ok()
}
