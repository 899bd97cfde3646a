//! Two solutions for a storey in plan that coincide within the scatter of the measurement: near a double root of the cubic.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | p | | ratio v/u of the mode along x | – |
//! | c(p; d) | `cubic` | the cubic of [`super::plan_roots`] for the measured values d | (rad/s)² |
//! | d, s | `data`, `sd` | ln f of the three modes, t_x, t_y, and their standard deviations | – |
//! | g | `gradient` | s ∂c/∂d at the turning point; σ = \|g\| is the standard deviation of c there | (rad/s)² |
//!
//! At a turning point with \|c\| < σ two roots coincide or nearly do; near an inflection where c is almost flat, three. There a root moves with
//! the square or cube root of c, so no linear estimate gives its scatter. Every p with \|c\| ≤ z σ fits equally well, so the storey has a wide
//! interval.

use super::plan_roots::{PlanRoot, SIDEWAYS_MOST, cubic, real_roots, root_at, turning_points};
use super::plan_storey::{Labelled, PlanMode, PlanMotion, PlanStorey};
use std::f64::consts::TAU;

/// Number of standard deviations within which two real roots are one (95 %), and within which two complex roots are a double root that scatter
/// removed (1 in 400, as for other evidence).
const REAL_WITHIN: f64 = 1.96;
const LOST_WITHIN: f64 = 3.0;
/// Number of points in the interval of p at which the storey is computed. Our choice.
const SAMPLES: usize = 33;
/// Step of a numerical derivative, in standard deviations. Our choice: accurate to 1e-4 of a standard deviation.
const STEP: f64 = 1e-3;
const ROUNDS: usize = 20;
/// An inflection is flat if the cubic term of p is at least this fraction of the linear term over the scatter. Our choice.
const LINEAR: f64 = 0.5;

pub(super) struct DoubleRoot {
    /// The storey at the middle of the interval, for measured values shifted to it.
    pub(super) root: PlanRoot,
    /// Whether part of the interval agrees with the measured motions. The middle and the standard deviations then refer to this part only.
    pub(super) is_accepted: bool,
    /// Smallest and largest p.
    between: [f64; 2],
    /// k_x, k_y, k_θ, e_x, e_y over the interval, and their variances at one p.
    interval: Vec<[f64; 5]>,
    at_one_p: [f64; 5],
    /// The largest change of a stiffness in per cent when each frequency changes by 1 %.
    pub(super) amplification: f64,
}

impl DoubleRoot {
    /// Standard deviations of k_x, k_y, k_θ, e_x, e_y about a storey of the interval; 1.96 of them cover the interval.
    pub(super) fn deviations(&self, root: &PlanRoot) -> [f64; 5] {
        let about = numbers(root);
        std::array::from_fn(|at| {
            let far = self.interval.iter().map(|own| (own[at] - about[at]).abs());
            (far.fold(0.0, f64::max) / REAL_WITHIN).hypot(self.at_one_p[at].sqrt())
        })
    }

    pub(super) fn holds(&self, root: &PlanRoot) -> bool {
        let [least, most] = self.between;
        root.sideways.is_some_and(|p| p >= least && p <= most)
    }
}

struct NearDoubleRoot<'a> {
    storey: &'a PlanStorey,
    mode_of: [usize; 3],
    data: [f64; 5],
    sd: [f64; 5],
}

impl NearDoubleRoot<'_> {
    fn at(&self, shift: &[f64; 5]) -> ([f64; 3], Labelled) {
        let moved: [f64; 5] = std::array::from_fn(|i| self.data[i] + shift[i] * self.sd[i]);
        let lambda = [0, 1, 2].map(|i| (TAU * moved[i].exp()).powi(2));
        let twist = [moved[3], moved[4]];
        (
            lambda,
            Labelled {
                mode_of: self.mode_of,
                twist,
            },
        )
    }

    fn cubic(&self, shift: &[f64; 5]) -> [f64; 4] {
        let (lambda, labelled) = self.at(shift);
        cubic(&lambda, &labelled)
    }

    fn gradient(&self, p: f64, shift: &[f64; 5]) -> [f64; 5] {
        std::array::from_fn(|i| {
            let moved = |sign: f64| {
                let mut shift = *shift;
                shift[i] += sign * STEP;
                value(&self.cubic(&shift), p)
            };
            (moved(1.0) - moved(-1.0)) / (2.0 * STEP)
        })
    }

    /// The smallest shift of the data, in standard deviations, that makes p a root.
    fn to_root(&self, p: f64) -> [f64; 5] {
        let mut shift = [0.0; 5];
        for _ in 0..ROUNDS {
            let (c, g) = (value(&self.cubic(&shift), p), self.gradient(p, &shift));
            // projects onto the tangent of c = 0, which gives the smallest shift
            let square: f64 = g.iter().map(|g| g * g).sum();
            let along: f64 = g.iter().zip(&shift).map(|(g, s)| g * s).sum();
            shift = g.map(|g| g * (along - c) / square);
        }
        shift
    }

    fn storey(&self, p: f64, shift: &[f64; 5]) -> PlanRoot {
        let (lambda, labelled) = self.at(shift);
        root_at(self.storey, &lambda, &labelled, p)
    }
}

fn value(c: &[f64; 4], x: f64) -> f64 {
    c[0] + x * (c[1] + x * (c[2] + x * c[3]))
}

fn numbers(root: &PlanRoot) -> [f64; 5] {
    let [k_x, k_y, k_theta] = root.stiffness;
    let [e_x, e_y] = root.eccentricity_m;
    [k_x, k_y, k_theta, e_x, e_y]
}

/// The storey at the turning point nearest to a root, in standard deviations; `None` if none is within the scatter, or if the scatter is
/// unknown.
pub(super) fn double_root(
    storey: &PlanStorey,
    modes: &[PlanMode; 3],
    labelled: &Labelled,
    moves_as_measured: impl Fn(&PlanRoot) -> bool,
) -> Option<DoubleRoot> {
    let twist_sd = |motion| {
        let mode = modes.iter().find(|mode| mode.motion == Some(motion))?;
        Some(mode.twist?.sd)
    };
    let relative = modes.map(|mode| mode.frequency_sd_hz / mode.frequency_hz);
    let near = NearDoubleRoot {
        storey,
        mode_of: labelled.mode_of,
        data: [
            modes[0].frequency_hz.ln(),
            modes[1].frequency_hz.ln(),
            modes[2].frequency_hz.ln(),
            labelled.twist[0],
            labelled.twist[1],
        ],
        sd: [
            relative[0],
            relative[1],
            relative[2],
            twist_sd(PlanMotion::X)?,
            twist_sd(PlanMotion::Y)?,
        ],
    };
    if near.sd.iter().any(|sd| *sd <= 0.0) {
        return None;
    }
    let measured = near.cubic(&[0.0; 5]);
    let each = candidates(&measured).into_iter().filter_map(|p| {
        let c = value(&measured, p);
        let sigma = near
            .gradient(p, &[0.0; 5])
            .iter()
            .map(|g| g * g)
            .sum::<f64>()
            .sqrt();
        (c.abs() <= within(&measured, p, sigma) * sigma).then_some((p, c, sigma))
    });
    let (p, _, sigma) = each.min_by(|a, b| (a.1.abs() / a.2).total_cmp(&(b.1.abs() / b.2)))?;
    let [least, most] = between(&measured, p, LOST_WITHIN * sigma)?;
    let at = |i: usize| least + (most - least) * i as f64 / (SAMPLES - 1) as f64;
    let sample = |i: usize| near.storey(at(i), &near.to_root(at(i)));
    let all: Vec<PlanRoot> = (0..SAMPLES).map(sample).collect();
    // those that agree with the measured motions, if any
    let kept: Vec<usize> = (0..SAMPLES).filter(|i| moves_as_measured(&all[*i])).collect();
    let is_accepted = !kept.is_empty();
    let (first, last) = match (kept.first(), kept.last()) {
        (Some(first), Some(last)) => (*first, *last),
        _ => (0, SAMPLES - 1),
    };
    let p = 0.5 * (at(first) + at(last));
    let samples = &all[first..=last];
    let shift = near.to_root(p);
    let root = near.storey(p, &shift);
    let middle = numbers(&root);
    let mut at_one_p = [0.0; 5];
    for i in 0..5 {
        let mut moved = shift;
        moved[i] += 1.0;
        let moved = numbers(&near.storey(p, &moved));
        for ((square, own), middle) in at_one_p.iter_mut().zip(moved).zip(middle) {
            *square += (own - middle).powi(2);
        }
    }
    // each frequency changes by 1 %, with the signs that change c most
    let of_frequencies = near.gradient(p, &[0.0; 5]);
    let off: f64 = (0..3).map(|i| 0.01 * of_frequencies[i].abs() / near.sd[i]).sum();
    let moved = between(&measured, p, off + value(&measured, p).abs())
        .into_iter()
        .flatten();
    let moved = moved.map(|at| numbers(&near.storey(at, &near.to_root(at))));
    let amplification = moved.fold(0.0, |most, own| {
        (0..3).fold(most, |most: f64, i| {
            most.max(100.0 * (own[i] / middle[i] - 1.0).abs())
        })
    });
    Some(DoubleRoot {
        root,
        is_accepted,
        between: [least, most],
        interval: samples.iter().map(numbers).collect(),
        at_one_p,
        amplification,
    })
}

/// Candidates for coinciding roots: the turning points, or the inflection if there are none.
fn candidates(c: &[f64; 4]) -> Vec<f64> {
    match turning_points(c).as_slice() {
        [] => vec![-c[2] / (3.0 * c[3])],
        turning => turning.to_vec(),
    }
}

/// Number of standard deviations of c within which roots coincide at a candidate; 0 at an inflection where c is so steep that it is linear over
/// its scatter.
fn within(c: &[f64; 4], p: f64, sigma: f64) -> f64 {
    let slope = c[1] + p * (2.0 * c[2] + 3.0 * c[3] * p);
    let bend = 2.0 * c[2] + 6.0 * c[3] * p;
    if !turning_points(c).is_empty() {
        return if value(c, p) * bend < 0.0 {
            REAL_WITHIN
        } else {
            LOST_WITHIN
        };
    }
    let linear = LOST_WITHIN * sigma / slope.abs();
    let bent = c[3].abs() * linear.powi(3);
    if bent < LINEAR * LOST_WITHIN * sigma {
        0.0
    } else {
        REAL_WITHIN
    }
}

/// The nearest p below and above at which \|c\| reaches this value; `None` if one side has none.
fn between(c: &[f64; 4], p: f64, most: f64) -> Option<[f64; 2]> {
    let mut ends: Vec<f64> = Vec::new();
    for sign in [1.0, -1.0] {
        let mut shifted = *c;
        shifted[0] += sign * most;
        ends.extend(real_roots(&shifted, SIDEWAYS_MOST));
    }
    let below = ends.iter().copied().filter(|end| *end < p).reduce(f64::max)?;
    let above = ends.iter().copied().filter(|end| *end >= p).reduce(f64::min)?;
    Some([below, above])
}
