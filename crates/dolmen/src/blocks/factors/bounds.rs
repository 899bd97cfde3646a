//! How soft a joint can be whatever the others are, and how far a factor can lie by one frequency: by frequencies that rise with every factor.
//!
//! ```text
//! λ_q(c) rises with every c_g (Courant–Fischer), so that a mode measured at f excludes every c_j at which, all others rigid, it lies below f.
//! ```

use super::model::{Datum, FactorModel};
use crate::numeric::{Bracketing, bracketed_root};
use std::f64::consts::TAU;

/// A joint this many times stiffer than by the common factor is rigid. Chosen here: what it leaves out of a bound is below 1e-4, and rounding of the
/// decomposition takes 1e-7 of it.
pub(super) const RIGID: f64 = 1e6;
/// Softest factor that is sought, over the common one: below it a joint is open. Chosen here.
const OPEN: f64 = 1e-6;
/// Deviations below the measured frequency at which a factor is excluded.
const EXCLUDED_SD: f64 = 2.0;
/// Bounds are found to this in ln c: far below what is measured.
const BOUND_WITHIN: f64 = 1e-7;

/// The least factor that a joint can have.
pub(super) struct LeastFactor {
    pub(super) factor: f64,
    /// Which of the data excludes softer ones.
    pub(super) datum: usize,
}

impl FactorModel {
    /// The least factor of the springs `j` whatever the others are; `None` if no mode excludes any. Each mode is taken as of the highest order that it
    /// has among those of its family with the factors `known`.
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

/// The x_j between two ends at which ω² as `square` has it is that of the measured frequency times e^`off`, the others as given; `None` if there is none.
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
        // a mode without stiffness lies below every frequency
        0.5 * (square.max(f64::MIN_POSITIVE) / aim).ln() - off
    };
    let bracketing = Bracketing {
        width_most: BOUND_WITHIN,
        ..Bracketing::default()
    };
    bracketed_root(&mut away, ends[0], ends[1], &bracketing).ok()
}
