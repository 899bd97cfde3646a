//! Capacity of a joint of finite strength in a limit analysis, linearised from the safe side.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | f, A | `strength_pa`, `area` | compressive strength, area of the patch | Pa, m² |
//! | ν | `outward` | direction in the plane of the patch, unit | – |
//! | α | `share` | fraction of the patch that a straight line cuts off | – |
//! | N_k, c_k | `capacity_n`, `at_m` | α f A, resistance of this fraction at full stress, and its centroid | N, m |

use super::toe::toe;
use crate::structure::stack::Polygon;

/// Fractions of a patch that form its stress blocks, for stacks with few joints. Our choice: up to 0.6 of the full capacity, the moment of a
/// rectangle is at most 1.3 % too small about an edge, or 3.7 % about an oblique axis.
const MANY: [f64; 12] = [
    0.85, 0.7, 0.57, 0.46, 0.36, 0.27, 0.19, 0.12, 0.07, 0.03, 0.006, 0.000_1,
];
/// Fractions for stacks with many joints: the errors are 6.3 % and, with half of the directions, 12.2 %. Our choice.
const FEW: [f64; 9] = [0.75, 0.5, 0.3, 0.18, 0.1, 0.05, 0.02, 0.004, 0.000_05];
/// Largest number of joints that counts as few. Our choice: a check of such an arch takes some seconds.
const JOINTS_FEW: usize = 25;
/// Fractions relative to a known force in the joint, for shaking, which hardly changes that force. Our choice.
const ABOUT_KNOWN: [f64; 5] = [1.0, 0.9, 1.1, 0.25, 4.0];
/// The same for growing loads, which may change the force. Our choice, as [`MANY`].
const FROM_KNOWN: [f64; 12] = [1.0, 0.25, 0.7, 1.19, 1.41, 1.68, 2.0, 2.83, 4.0, 5.7, 8.0, 16.0];
/// Number of directions between the normals of adjacent edges: for few joints, for many joints, and for patches with so many edges that their
/// normals suffice. Our choice.
const BETWEEN_FEW: usize = 4;
const BETWEEN_MANY: usize = 2;
const EDGES_SUFFICE: usize = 12;

/// The resultant of one stress block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Toe {
    pub(super) at_m: [f64; 2],
    pub(super) capacity_n: f64,
}

/// Knowledge of the force in a joint before the analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum JointForce {
    /// Known from equilibrium alone.
    Known {
        /// The force without shaking, N.
        force_n: f64,
        /// Whether growing loads may press the joint together.
        grows: bool,
    },
    /// Known approximately, N, in a stack with this number of joints.
    About {
        /// The force, N.
        force_n: f64,
        /// Number of joints of the stack.
        joints: usize,
    },
}

/// Resultants of stress blocks; the patch can carry every mixture of them.
///
/// ```text
/// capacity of a patch         (N, N c) of a pressure 0 ≤ p ≤ f: convex; on its boundary p is f beyond a straight line and 0 elsewhere
/// mixtures                    Σ n_k (1, c_k) with n_k ≥ 0, Σ n_k / N_k ≤ 1: always within the capacity
/// rectangle b × l             N_k = f l t, c_k at t/2 inside the edge: exact if N is one of N_k
/// ```
///
/// `towards` is a direction of the plane in addition to those of the edges and between them.
pub(super) fn toes(
    patch: &Polygon,
    strength_pa: f64,
    pressed: JointForce,
    towards: Option<[f64; 2]>,
) -> Vec<Toe> {
    let moments = patch.moments();
    let area = moments.area_m2;
    let whole_n = strength_pa * area;
    let (between, shares) = match pressed {
        JointForce::Known { force_n, grows } => {
            let parts = if grows { &FROM_KNOWN[..] } else { &ABOUT_KNOWN[..] };
            let shares = parts.iter().map(|part| part * force_n / whole_n);
            (BETWEEN_FEW, shares.collect())
        }
        JointForce::About { force_n, joints } => {
            let (between, usual) = match joints > JOINTS_FEW {
                true => (BETWEEN_MANY, &FEW[..]),
                false => (BETWEEN_FEW, &MANY[..]),
            };
            let own = std::iter::once(force_n / whole_n);
            (between, own.chain(usual.iter().copied()).collect::<Vec<f64>>())
        }
    };
    let mut all = vec![Toe {
        at_m: moments.centroid_m,
        capacity_n: whole_n,
    }];
    let outwards: Vec<[f64; 2]> = outwards(patch, between).into_iter().chain(towards).collect();
    // those of the expected force first
    for &share in shares.iter().filter(|&&share| share > 0.0 && share < 1.0) {
        for &outward in &outwards {
            if let Some(at_m) = toe(std::slice::from_ref(patch), outward, share * area) {
                all.push(Toe {
                    at_m,
                    capacity_n: share * whole_n,
                });
            }
        }
    }
    all
}

/// The normals of a patch's edges and directions between them, evenly spaced after the patch is scaled to equal widths.
fn outwards(patch: &Polygon, between: usize) -> Vec<[f64; 2]> {
    let corners = &patch.corners_m;
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let over_width: Vec<[f64; 2]> = edges
        .map(|(a, b)| {
            let normal = [b[1] - a[1], a[0] - b[0]];
            let along = |corner: &[f64; 2]| corner[0] * normal[0] + corner[1] * normal[1];
            let most = corners.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
            let least = corners.iter().map(along).fold(f64::INFINITY, f64::min);
            normal.map(|part| part / (most - least))
        })
        .collect();
    let between = if corners.len() > EDGES_SUFFICE { 1 } else { between };
    let mut all = Vec::new();
    for (one, next) in over_width.iter().zip(over_width.iter().cycle().skip(1)) {
        for step in 0..between {
            let part = step as f64 / between as f64;
            let way = [0, 1].map(|axis| one[axis] * (1.0 - part) + next[axis] * part);
            let length = way[0].hypot(way[1]);
            all.push(way.map(|part| part / length));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use std::f64::consts::TAU;

    /// Whether a force is within the capacity for pressures from 0 to f: in every direction its point must not lie beyond the centroid of the
    /// strip that carries the force.
    fn is_borne(patch: &Polygon, strength_pa: f64, force_n: f64, at_m: [f64; 2]) -> bool {
        (0..720).all(|k| {
            let angle = TAU * f64::from(k) / 720.0;
            let outward = [angle.cos(), angle.sin()];
            let Some(border) = toe(std::slice::from_ref(patch), outward, force_n / strength_pa) else {
                return false;
            };
            outward[0] * (at_m[0] - border[0]) + outward[1] * (at_m[1] - border[1]) < 1e-9
        })
    }

    #[test]
    fn holds_mixtures_of_toes_lie_within_what_the_patch_bears() {
        let mut random = Random::new(11, 0);
        for _ in 0..40 {
            let points = (0..6).map(|_| [random.uniform(), random.uniform()]).collect();
            let patch = Polygon::hull(points);
            let (strength_pa, about) = (2e5, 3e4 * random.uniform());
            let pressed = JointForce::About {
                force_n: about,
                joints: 3,
            };
            let all = toes(&patch, strength_pa, pressed, Some([1.0, 0.0]));
            for _ in 0..50 {
                // a few stress blocks, with a total of at most the full capacity
                let picked: Vec<(Toe, f64)> = (0..3)
                    .map(|_| {
                        (
                            all[(random.uniform() * all.len() as f64) as usize],
                            random.uniform(),
                        )
                    })
                    .collect();
                let full: f64 = picked.iter().map(|(_, weight)| weight).sum();
                let (mut force_n, mut first) = (0.0, [0.0; 2]);
                for (toe, weight) in &picked {
                    let n = toe.capacity_n * weight / full;
                    force_n += n;
                    first = [first[0] + n * toe.at_m[0], first[1] + n * toe.at_m[1]];
                }
                let at_m = first.map(|part| part / force_n);
                assert!(
                    is_borne(&patch, strength_pa, force_n, at_m),
                    "{patch:?} {picked:?}"
                );
            }
        }
    }
}
