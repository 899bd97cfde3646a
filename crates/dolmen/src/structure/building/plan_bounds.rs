//! Between which bounds the stiffness of a storey in plan lies where its centre of rigidity is not known.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | t_x, t_y | `twist` | ρθ/u of the mode along x, ρθ/v of that along y | – |
//!
//! Three frequencies leave two of the five unknowns free. The twists of the modes along x and y name each of the stiffnesses that have the
//! frequencies, so that all of them are reached by going through the twists.

use super::plan_roots::{PlanRoot, roots_with_shapes};
use super::plan_stiffness::moves_otherwise;
use super::plan_storey::{Labelled, PlanMode, PlanMotion, PlanStorey};
use std::f64::consts::TAU;

/// Largest twist: ρθ has twice the energy of the sway, beyond which the mode turns. √2, with which the rule on motions agrees.
const TWIST_MOST: f64 = std::f64::consts::SQRT_2;
/// Twists of each mode in a round, and rounds, each about the best of the one before on a finer net. Ours: to four digits.
const NET: i32 = 20;
const ROUNDS: usize = 6;
const FINER: f64 = 0.2;

/// Bounds of what three frequencies leave free.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PlanBounds {
    /// Least and most of k_x, k_y, N/m, and of k_θ about the centre of rigidity, N·m/rad.
    pub stiffness: [[f64; 2]; 3],
    /// Least and most of the centre of rigidity from the centre of mass, m.
    pub eccentricity_m: [[f64; 2]; 2],
}

/// Bounds of the stiffness with which a floor has the measured frequencies and moves as it was measured, over every centre of rigidity within
/// `reach_m` (from the centre of mass, least and most along x and y); `None` unless all three motions are known, or where no centre does.
///
/// # Limits
/// Deviations of the frequencies are not in the bounds. They are found on a net of twists that grows finer about each extreme.
pub fn plan_bounds(
    storey: &PlanStorey,
    modes: &[PlanMode; 3],
    reach_m: Option<[[f64; 2]; 2]>,
) -> Option<PlanBounds> {
    let at = |motion| modes.iter().position(|mode| mode.motion == Some(motion));
    let [x, y] = [at(PlanMotion::X)?, at(PlanMotion::Y)?];
    at(PlanMotion::Torsion)?;
    let family = Family {
        storey,
        modes,
        lambda: modes.map(|mode| (TAU * mode.frequency_hz).powi(2)),
        mode_of: [x, y, 3 - x - y],
        reach_m,
    };
    let bound = |quantity: usize| Some([family.extreme(quantity, -1.0)?, family.extreme(quantity, 1.0)?]);
    Some(PlanBounds {
        stiffness: [bound(0)?, bound(1)?, bound(2)?],
        eccentricity_m: [bound(3)?, bound(4)?],
    })
}

struct Family<'a> {
    storey: &'a PlanStorey,
    modes: &'a [PlanMode; 3],
    lambda: [f64; 3],
    mode_of: [usize; 3],
    reach_m: Option<[[f64; 2]; 2]>,
}

impl Family<'_> {
    /// The largest (`sign` 1) or least (−1) of k_x, k_y, k_θ, e_x, e_y.
    fn extreme(&self, quantity: usize, sign: f64) -> Option<f64> {
        let (mut about, mut step) = ([0.0, 0.0], TWIST_MOST / f64::from(NET));
        let mut best: Option<f64> = None;
        for _ in 0..ROUNDS {
            let centre = about;
            for i in -NET..=NET {
                for j in -NET..=NET {
                    let twist = [centre[0] + f64::from(i) * step, centre[1] + f64::from(j) * step];
                    for value in self.values(twist, quantity) {
                        if best.is_none_or(|best| sign * value > sign * best) {
                            (best, about) = (Some(value), twist);
                        }
                    }
                }
            }
            best?;
            step *= FINER;
        }
        best
    }

    fn values(&self, twist: [f64; 2], quantity: usize) -> Vec<f64> {
        if twist.iter().any(|t| t.abs() > TWIST_MOST) {
            return Vec::new();
        }
        let labelled = Labelled {
            mode_of: self.mode_of,
            twist,
        };
        let roots = roots_with_shapes(self.storey, &self.lambda, &labelled).roots;
        let within = roots.into_iter().filter(|root| self.is_possible(root));
        let value = |root: PlanRoot| match quantity {
            0..=2 => root.stiffness[quantity],
            _ => root.eccentricity_m[quantity - 3],
        };
        within.map(value).collect()
    }

    fn is_possible(&self, root: &PlanRoot) -> bool {
        const ROUNDING: f64 = 1e-9;
        let is_within = self.reach_m.is_none_or(|reach| {
            let each = root.eccentricity_m.iter().zip(reach);
            let slack = ROUNDING * self.storey.gyration_m;
            each.into_iter()
                .all(|(e, [least, most])| *e >= least - slack && *e <= most + slack)
        });
        let energy_shares = root.shapes.map(|shape| shape.map(|q| q * q));
        is_within
            && root.stiffness.iter().all(|k| *k > 0.0)
            && moves_otherwise(self.modes, &energy_shares).is_none()
    }
}
