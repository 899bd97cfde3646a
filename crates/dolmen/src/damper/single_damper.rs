//! Effect of one mass damper at one place, for any tuning, in one pass over the prepared frequencies, with derivatives.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | N | `link` | ω_d² + 2iζω_d ω, spring and dashpot over the mass |
//! | N′ | `above`, `link` | N − (1 − α²) ω²: the fraction 1 − α² of the mass of a liquid column moves with its place; α = 1 for a mass on a
//! spring |
//! | T | `force` | m N′ / (N − ω² − ω² m N′ g): force on the structure per acceleration of the place without the damper |
//! | g | `own` | receptance of the place along the damper |
//! | q | `through` | motion of a point per unit T: receptance from place to point times acceleration of the place |

use super::{PlacedDamper, Plan};
use crate::numeric::{Piece, Worst};
use dolmen_linalg::Complex64;
use pulp::Arch;
use std::f64::consts::TAU;

/// Number of frequencies computed together.
const LANES: usize = 4;
type Lane = [f64; LANES];

/// A place in plan, and the mass of the damper.
pub(super) struct SingleDamper {
    mass_kg: f64,
    length_ratio: f64,
    points: usize,
    loads: usize,
    omega: Vec<Lane>,
    own: [Vec<Lane>; 2],
    /// For each load: densities; for each point and load: q and the motion without the damper, real and imaginary parts.
    densities: Vec<Vec<Lane>>,
    through: Vec<[Vec<Lane>; 2]>,
    free: Vec<[Vec<Lane>; 2]>,
}

/// ln of each point's standard deviation, and its derivatives with respect to ln f and ln ζ.
pub(super) struct SingleDamperValue {
    pub(super) ln_rms: f64,
    pub(super) slope: [f64; 2],
}

impl SingleDamper {
    pub(super) fn new(plan: &Plan, damper: &PlacedDamper) -> Self {
        let (points, loads) = (plan.problem().points.len(), plan.problem().loads.len());
        let site = &plan.problem().sites[damper.site];
        let a = site.coefficients(damper.place_m, damper.direction_degrees);
        let (first, c) = (3 * damper.site, 3 * plan.problem().sites.len());
        let dot =
            |list: &dyn Fn(usize) -> Complex64| -> Complex64 { (0..3).map(|i| list(first + i) * a[i]).sum() };
        let lanes = plan.nodes.len().div_ceil(LANES);
        let zero = || vec![[0.0; LANES]; lanes];
        let mut single = SingleDamper {
            mass_kg: damper.mass_kg,
            length_ratio: damper.length_ratio,
            points,
            loads,
            omega: vec![[1.0; LANES]; lanes],
            own: [zero(), zero()],
            densities: (0..loads).map(|_| zero()).collect(),
            through: (0..points * loads).map(|_| [zero(), zero()]).collect(),
            free: (0..points * loads).map(|_| [zero(), zero()]).collect(),
        };
        for (i, table) in plan.nodes.iter().enumerate() {
            let (at, lane) = (i / LANES, i % LANES);
            let put = |target: &mut [Vec<Lane>; 2], z: Complex64| {
                target[0][at][lane] = z.re;
                target[1][at][lane] = z.im;
            };
            single.omega[at][lane] = table.omega;
            put(&mut single.own, dot(&|i| dot(&|j| table.own[i * c + j])));
            for l in 0..loads {
                single.densities[l][at][lane] = table.densities[l];
                let felt = dot(&|i| table.felt[i * loads + l]);
                for p in 0..points {
                    let to_point = dot(&|i| table.to_point[p * c + i]);
                    put(&mut single.through[p * loads + l], to_point * felt);
                    put(&mut single.free[p * loads + l], table.free[p * loads + l]);
                }
            }
        }
        single
    }

    /// Standard deviation of each point with a tuning.
    pub(super) fn judge(&self, frequency_hz: f64, damping_ratio: f64) -> Vec<SingleDamperValue> {
        let own = TAU * frequency_hz;
        let (spring, dashpot) = (own * own, 2.0 * damping_ratio * own);
        // runs in the widest vectors of the processor; the operations, and so the bits, are the same on each
        let sums = Arch::new().dispatch(
            #[inline(always)]
            || self.sums(spring, dashpot),
        );
        (0..self.points)
            .map(|p| {
                let [mut variance, mut along, mut across] = [0.0; 3];
                for l in 0..self.loads {
                    let of = &sums[p * self.loads + l];
                    variance += of[0].iter().sum::<f64>();
                    along += of[1].iter().sum::<f64>();
                    across += of[2].iter().sum::<f64>();
                }
                // dT/dN = −α² m ω²/(…)²; dN/d ln f = 2 ω_d² + i·link, dN/d ln ζ = i·link; ln rms = ½ ln variance
                SingleDamperValue {
                    ln_rms: 0.5 * variance.ln(),
                    slope: [(2.0 * spring * along - across) / variance, -across / variance],
                }
            })
            .collect()
    }

    /// The damper's force at each frequency.
    #[inline(always)]
    fn worked(&self, spring: f64, dashpot: f64) -> Vec<DamperForces> {
        let m = self.mass_kg;
        let swings = self.length_ratio * self.length_ratio;
        let rides = 1.0 - swings;
        let nodes = self.omega.iter().zip(&self.own[0]).zip(&self.own[1]);
        let each = nodes.map(
            #[inline(always)]
            |((omega, own_re), own_im)| {
                let mut worked = DamperForces::default();
                for k in 0..LANES {
                    let w = omega[k];
                    let w2 = w * w;
                    let link = dashpot * w;
                    worked.damped[k] = link;
                    let (g_re, g_im) = (own_re[k] * w2 * m, own_im[k] * w2 * m);
                    let above = spring - rides * w2;
                    let below_re = spring - w2 - (above * g_re - link * g_im);
                    let below_im = link - (above * g_im + link * g_re);
                    let inverse = 1.0 / (below_re * below_re + below_im * below_im);
                    let (r_re, r_im) = (below_re * inverse, -below_im * inverse);
                    worked.force[0][k] = m * (above * r_re - link * r_im);
                    worked.force[1][k] = m * (above * r_im + link * r_re);
                    let scale = -m * swings * w2;
                    worked.change[0][k] = scale * (r_re * r_re - r_im * r_im);
                    worked.change[1][k] = scale * (2.0 * r_re * r_im);
                }
                worked
            },
        );
        each.collect()
    }

    /// For each point and load the variance and the terms of its derivatives, in lanes.
    #[inline(always)]
    fn sums(&self, spring: f64, dashpot: f64) -> Vec<[Lane; 3]> {
        let worked = self.worked(spring, dashpot);
        let count = self.points * self.loads;
        let mut all = Vec::with_capacity(count);
        for which in 0..count {
            let ([q_re, q_im], [free_re, free_im]) = (&self.through[which], &self.free[which]);
            let q = q_re.iter().zip(q_im);
            let free = free_re.iter().zip(free_im);
            let density = &self.densities[which % self.loads];
            let mut sums = [[0.0; LANES]; 3];
            for (((of, (q_re, q_im)), (free_re, free_im)), density) in
                worked.iter().zip(q).zip(free).zip(density)
            {
                for k in 0..LANES {
                    let (q_re, q_im) = (q_re[k], q_im[k]);
                    let h_re = free_re[k] + q_re * of.force[0][k] - q_im * of.force[1][k];
                    let h_im = free_im[k] + q_re * of.force[1][k] + q_im * of.force[0][k];
                    // conj(H) q dT/dN
                    let x_re = h_re * q_re + h_im * q_im;
                    let x_im = h_re * q_im - h_im * q_re;
                    let y_re = x_re * of.change[0][k] - x_im * of.change[1][k];
                    let y_im = x_re * of.change[1][k] + x_im * of.change[0][k];
                    sums[0][k] += density[k] * (h_re * h_re + h_im * h_im);
                    sums[1][k] += density[k] * y_re;
                    sums[2][k] += density[k] * y_im * of.damped[k];
                }
            }
            all.push(sums);
        }
        all
    }
}

/// Force of the damper, its derivative with respect to N, and the damping in its link, at some frequencies.
#[derive(Clone, Copy, Default)]
struct DamperForces {
    force: [Lane; 2],
    change: [Lane; 2],
    damped: Lane,
}

/// The tuning of a damper at one place as an optimisation problem: the unknowns are ln f and ln ζ, the functions ln of each point's standard
/// deviation.
pub(super) struct SingleDamperSearch<'a> {
    pub(super) single: &'a SingleDamper,
    pub(super) weights: &'a [f64],
    pub(super) mean: bool,
    range_hz: [f64; 2],
    least_damping: f64,
    last: Option<(Vec<f64>, Vec<Piece>)>,
}

/// Upper limit of the damping ratio. Above 1 nothing oscillates; where a damper does harm, the optimum is such a rigid link.
pub(super) const DAMPING_MOST: f64 = 3.0;

impl<'a> SingleDamperSearch<'a> {
    pub(super) fn new(
        single: &'a SingleDamper,
        weights: &'a [f64],
        mean: bool,
        (range_hz, least_damping): ([f64; 2], f64),
    ) -> Self {
        SingleDamperSearch {
            single,
            weights,
            mean,
            range_hz,
            least_damping,
            last: None,
        }
    }

    /// Frequency, Hz, and damping ratio, within their limits.
    pub(super) fn within(&self, x: &[f64]) -> [f64; 2] {
        let [low, high] = self.range_hz;
        [
            x[0].exp().clamp(low, high),
            x[1].exp().clamp(self.least_damping, DAMPING_MOST),
        ]
    }

    fn look(&mut self, x: &[f64]) -> Option<&Vec<Piece>> {
        if self.last.as_ref().is_none_or(|(at, _)| at != x) {
            let tuning = self.within(x);
            // beyond a limit the derivative is zero
            let moves = [0, 1].map(|i| if tuning[i] == x[i].exp() { 1.0 } else { 0.0 });
            let values = self.single.judge(tuning[0], tuning[1]);
            let mut pieces: Vec<Piece> = values
                .iter()
                .zip(self.weights)
                .map(|(value, weight)| Piece {
                    value: value.ln_rms + weight.ln(),
                    slope: vec![value.slope[0] * moves[0], value.slope[1] * moves[1]],
                })
                .collect();
            if self.mean {
                let squares: Vec<f64> = pieces.iter().map(|piece| (2.0 * piece.value).exp()).collect();
                let sum: f64 = squares.iter().sum();
                let slope = |i: usize| {
                    pieces
                        .iter()
                        .zip(&squares)
                        .map(|(p, s)| s * p.slope[i])
                        .sum::<f64>()
                        / sum
                };
                pieces = vec![Piece {
                    value: 0.5 * (sum / squares.len() as f64).ln(),
                    slope: vec![slope(0), slope(1)],
                }];
            }
            if pieces.iter().any(|piece| !piece.value.is_finite()) {
                return None;
            }
            self.last = Some((x.to_vec(), pieces));
        }
        self.last.as_ref().map(|(_, pieces)| pieces)
    }
}

impl Worst for SingleDamperSearch<'_> {
    fn worst(&mut self, x: &[f64]) -> Option<f64> {
        self.look(x)?.iter().map(|piece| piece.value).reduce(f64::max)
    }

    fn pieces(&mut self, x: &[f64]) -> Option<Vec<Piece>> {
        self.look(x).cloned()
    }
}
