//! Bounds of the stiffness of a storey in plan whose centre of rigidity is unknown.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | t_x, t_y | `twist` | ρθ/u of the mode along x, ρθ/v of the mode along y | – |
//!
//! Three frequencies leave two of the five unknowns free. The twists of the modes along x and y parametrise all stiffnesses with these
//! frequencies, so a search over the twists covers all of them.

use super::plan_roots::{PlanRoot, roots_with_shapes};
use super::plan_stiffness::moves_otherwise;
use super::plan_storey::{Labelled, PlanMode, PlanMotion, PlanStorey};
use std::f64::consts::TAU;

/// Largest twist: ρθ then has twice the energy of the sway; with more twist the mode is torsional. √2, in agreement with the limit on motions.
const TWIST_MOST: f64 = std::f64::consts::SQRT_2;
/// Number of twists of each mode in a round, and number of rounds. Each round has a finer grid around the best point of the previous round. Our
/// choice: accurate to four digits.
const NET: i32 = 20;
const ROUNDS: usize = 6;
const FINER: f64 = 0.2;
/// Number of grid points for frequencies near the measured ones, around the twists found before.
const NEAR: i32 = 8;
/// Radius of the sphere of frequencies in standard deviations, which is the 95 % interval of a single value, and number of search steps on the
/// sphere. Our choice.
const DEVIATIONS: f64 = 1.96;
const CLIMBS: usize = 3;

/// Bounds of the quantities that three frequencies do not determine.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PlanBounds {
    /// Smallest and largest k_x, k_y, N/m, and k_θ about the centre of rigidity, N·m/rad.
    pub stiffness: [[f64; 2]; 3],
    /// Smallest and largest coordinates of the centre of rigidity relative to the centre of mass, m.
    pub eccentricity_m: [[f64; 2]; 2],
    /// Whether the bounds include the scatter of the frequencies, which needs all standard deviations.
    pub with_scatter: bool,
}

/// Bounds of the stiffness of a floor with the measured frequencies and kinds of modes, for all centres of rigidity within `reach_m` (smallest
/// and largest x and y relative to the centre of mass). `None` unless all three motions are known, or if no centre of rigidity is possible.
///
/// If all three standard deviations are known, the bounds also cover all frequencies within a joint distance of 1.96 of them: Σ ((f −
/// f_measured)/s)² ≤ 1.96². The search follows the gradient of each bound on this sphere.
///
/// # Limits
/// The search uses a grid of twists that is refined around each extreme. On the sphere it assumes that a bound is nearly linear.
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
    let with_scatter = modes.iter().all(|mode| mode.frequency_sd_hz > 0.0);
    let end = |quantity, sign| match with_scatter {
        true => family.with_scatter(quantity, sign),
        false => family.extreme(quantity, sign).map(|of| of.value),
    };
    let bound = |quantity: usize| Some([end(quantity, -1.0)?, end(quantity, 1.0)?]);
    Some(PlanBounds {
        with_scatter,
        stiffness: [bound(0)?, bound(1)?, bound(2)?],
        eccentricity_m: [bound(3)?, bound(4)?],
    })
}

#[derive(Clone, Copy)]
struct Extreme {
    value: f64,
    twist: [f64; 2],
}

struct Family<'a> {
    storey: &'a PlanStorey,
    modes: &'a [PlanMode; 3],
    lambda: [f64; 3],
    mode_of: [usize; 3],
    reach_m: Option<[[f64; 2]; 2]>,
}

impl Family<'_> {
    /// The largest (`sign` 1) or smallest (−1) of k_x, k_y, k_θ, e_x or e_y.
    fn extreme(&self, quantity: usize, sign: f64) -> Option<Extreme> {
        self.extreme_about([0.0, 0.0], (NET, 0), (quantity, sign))
    }

    /// The extreme value on a grid around given twists, without the first rounds.
    fn extreme_about(
        &self,
        twist: [f64; 2],
        (net, from_round): (i32, usize),
        (quantity, sign): (usize, f64),
    ) -> Option<Extreme> {
        let (mut about, mut step) = (twist, TWIST_MOST / f64::from(net));
        step *= FINER.powi(from_round as i32);
        let mut best: Option<f64> = None;
        for _ in from_round..ROUNDS {
            let centre = about;
            for i in -net..=net {
                for j in -net..=net {
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
        best.map(|value| Extreme { value, twist: about })
    }

    /// The extreme value over all frequencies within a joint distance of 1.96 standard deviations.
    fn with_scatter(&self, quantity: usize, sign: f64) -> Option<f64> {
        let measured = self.extreme(quantity, sign)?;
        let at = |deviations: [f64; 3]| {
            let moved = self.modes.iter().zip(deviations).map(|(mode, by)| {
                let f = mode.frequency_hz + by * mode.frequency_sd_hz;
                (TAU * f.max(0.0)).powi(2)
            });
            let mut lambda = self.lambda;
            lambda.iter_mut().zip(moved).for_each(|(own, moved)| *own = moved);
            let family = Family { lambda, ..*self };
            family.extreme_about(measured.twist, (NEAR, 1), (quantity, sign))
        };
        let mut best = measured.value;
        let mut keep = |found: Option<Extreme>| {
            let value = found.map(|of| of.value)?;
            if sign * value > sign * best {
                best = value;
            }
            Some(value)
        };
        let mut about = [0.0; 3];
        for _ in 0..CLIMBS {
            let slope: [f64; 3] = std::array::from_fn(|i| {
                let beside = |by: f64| {
                    let mut deviations = about;
                    deviations[i] += by;
                    at(deviations).map(|of| of.value)
                };
                match (beside(-0.5), beside(0.5)) {
                    (Some(less), Some(more)) => sign * (more - less),
                    _ => 0.0,
                }
            });
            let norm = slope.iter().map(|s| s * s).sum::<f64>().sqrt();
            if norm == 0.0 {
                break;
            }
            about = slope.map(|s| DEVIATIONS * s / norm);
            keep(at(about));
        }
        Some(best)
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
