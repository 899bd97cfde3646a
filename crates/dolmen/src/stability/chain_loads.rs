//! A chain under lateral forces: the moment at each joint compared with the capacity of its bed.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | F, h, C | `force_n`, `height_m`, `moment_n_m` | force on a link, its height above the link's lower joint, moment | N, m, N m |
//! | Q_i | `loads` | moment of all forces per rotation of link i | N m |
//! | M¹_i | `rigid_moment_n_m` | Σ_{j≥i} Q_j, moment in joint i of the upright chain | N m |
//! | M_i | `moment_n_m` | k_i (θ_i − θ_{i−1}), with what the weight adds as the chain leans | N m |

use super::{BedEdge, StabilityError, failing_joint};
use crate::structure::{Chain, StructureError};
use dolmen_linalg::{Matrix, solve};

/// A lateral load on one link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkLoad {
    /// The link, from 1 at the bottom.
    pub link: usize,
    /// h above the link's lower joint, m; from 0 to its length.
    pub height_m: f64,
    /// F, N.
    pub force_n: f64,
    /// C, N m.
    pub moment_n_m: f64,
}

/// Resistance of a joint against opening.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointHold {
    /// A bed without tension.
    Bed(BedEdge),
    /// A joint that carries any moment.
    Held,
    /// A joint with an unknown bed.
    Unknown,
}

/// Loads on a chain in addition to its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainLoading<'a> {
    /// Lateral forces.
    pub loads: &'a [LinkLoad],
    /// Resistance of each joint, lowest first.
    pub holds: &'a [JointHold],
    /// Common built-in tilt, in the direction of the loads, rad.
    pub tilt_rad: f64,
}

/// A joint of a chain under loads.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct JointUnderLoads {
    /// N, weight above the joint, N.
    pub axial_n: f64,
    /// Lateral force through the joint, N.
    pub shear_n: f64,
    /// M¹, moment of the loads on the upright chain, N m.
    pub rigid_moment_n_m: f64,
    /// M, as M¹ but including the moment of the weight as the chain leans under the loads, N m; `None` without stiffness or if it falls.
    pub moment_n_m: Option<f64>,
    /// Moment of the weight due to the tilt, N m; for the upright chain if a stiffness is unknown.
    pub tilt_moment_n_m: f64,
    /// M/k, rotation of the joint under the loads, rad.
    pub rotation_rad: Option<f64>,
    /// The largest moment that its bed carries, N m; `None` if the joint carries any moment or its bed is unknown.
    pub limit_n_m: Option<f64>,
    /// Factor on the loads at which the moment reaches the limit, for the given tilt: (limit − |tilt moment|)/|M|.
    pub factor: Option<f64>,
}

/// A chain under loads.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ChainUnderLoads {
    /// The joints, lowest first.
    pub joints: Vec<JointUnderLoads>,
    /// The joint with the smallest factor, from 1 at the bottom; `None` if no limit is known.
    pub governing_joint: Option<usize>,
    /// Smallest factor on the loads at which a joint reaches its limit; 0 if the chain falls under its weight alone.
    pub factor: Option<f64>,
    /// Whether every joint has a known limit or carries any moment.
    pub limits_known: bool,
    /// Whether the moments include the effect of the weight as the chain leans, which needs the stiffness.
    pub second_order: bool,
    /// Displacement of the top under the loads, m.
    pub top_displacement_m: Option<f64>,
}

/// Moments of a chain under lateral forces, in equilibrium in the leaning position, compared with the capacity of each bed.
///
/// ```text
/// Q_i = Σ_own (F h + C) + L_i Σ_{j>i} F_j        K θ = Q,  K with the weight
/// M_i = k_i (θ_i − θ_{i−1})                      = M¹_i + the moment of the weight
/// |M_i| ≤ N_i (b_i/2 − N_i/(2 f w_i))            factor = (limit − |tilt moment|)/|M_i|
/// ```
///
/// Without stiffness M¹ replaces M: the least moment that the joint must carry for any stiffness.
///
/// # Errors
/// [`StabilityError::Structure`] for a link that is not there, a height outside of it, or counts that do not fit.
///
/// # Limits
/// Rotations are small and springs linear up to the limit. A bed begins to open at a third of the limit and is softer from there, so the weight
/// adds more than this result contains: a factor just above 1 proves nothing.
///
/// # Example
/// ```
/// use dolmen::stability::{BedEdge, ChainLoading, JointHold, LinkLoad, chain_under_loads};
/// use dolmen::structure::{Chain, Inertia, Link};
/// let link = Link {
///     mass_kg: 1000.0,
///     length_m: 2.0,
///     centroid_m: 1.0,
///     inertia: Inertia::ThinRod,
///     bed_width_m: Some(0.5),
/// };
/// let chain = Chain::new(vec![link], 10.0)?; // N = 10 kN, m g l = 10 kN m/rad
/// let push = LinkLoad { link: 1, height_m: 2.0, force_n: 500.0, moment_n_m: 0.0 };
/// let bed = JointHold::Bed(BedEdge { width_m: 0.5, depth_m: Some(0.5), strength_pa: None });
/// let loading = ChainLoading { loads: &[push], holds: &[bed], tilt_rad: 0.0 };
/// let found = chain_under_loads(&chain, Some(&[40_000.0]), &loading)?;
/// assert_eq!(found.joints[0].rigid_moment_n_m, 1000.0);
/// assert!((found.joints[0].moment_n_m.unwrap_or(0.0) - 1000.0 / 0.75).abs() < 1e-9); // k/(k − m g l)
/// assert!((found.factor.unwrap_or(0.0) - 2500.0 * 0.75 / 1000.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn chain_under_loads(
    chain: &Chain,
    stiffness_n_m_rad: Option<&[f64]>,
    loading: &ChainLoading<'_>,
) -> Result<ChainUnderLoads, StabilityError> {
    let n = chain.links().len();
    if loading.holds.len() != n {
        return Err(StabilityError::Structure(StructureError::Count {
            quantity: "holds",
            given: loading.holds.len(),
            kind: "chain",
            needed: n,
            parts: "joints",
        }));
    }
    let forces = per_link(chain, loading.loads)?;
    let moments = generalised(chain, &forces);
    let rigid = sums_from_the_top(&moments);
    let shears = sums_from_the_top(&forces.iter().map(|of| of.force_n).collect::<Vec<_>>());
    let weight: Vec<f64> = chain
        .links()
        .iter()
        .map(|link| chain.gravity_m_s2() * link.mass_kg)
        .collect();
    let axial = sums_from_the_top(&weight);
    let mut answer = LoadRotations {
        rotations: None,
        falls: false,
        tilts: chain.necessary_n_m_rad(),
    };
    if let Some(k) = stiffness_n_m_rad {
        answer.falls = failing_joint(chain, k)?.is_some();
        if !answer.falls {
            answer.solve(chain, k, &moments)?;
        }
    }
    let joints: Vec<JointUnderLoads> = (0..n)
        .map(|i| {
            let turn = answer.rotations.as_ref().map(|theta| joint_rotation(theta, i));
            let moment = turn.zip(stiffness_n_m_rad).map(|(turn, k)| turn * k[i]);
            let limit_n_m = match loading.holds[i] {
                JointHold::Bed(bed) => Some(bed.moment_n_m(axial[i])),
                JointHold::Held | JointHold::Unknown => None,
            };
            let tilt_moment_n_m = answer.tilts[i] * loading.tilt_rad;
            let acting = moment.unwrap_or(rigid[i]).abs();
            JointUnderLoads {
                axial_n: axial[i],
                shear_n: shears[i],
                rigid_moment_n_m: rigid[i],
                moment_n_m: moment,
                tilt_moment_n_m,
                rotation_rad: turn,
                limit_n_m,
                factor: limit_n_m.map(|limit| match limit - tilt_moment_n_m.abs() {
                    left if left <= 0.0 => 0.0, // the tilt alone exceeds the limit
                    left => left / acting,
                }),
            }
        })
        .collect();
    let known = joints.iter().enumerate();
    let least = known
        .filter_map(|(i, joint)| Some((i + 1, joint.factor?)))
        .min_by(|a, b| a.1.total_cmp(&b.1));
    Ok(ChainUnderLoads {
        governing_joint: least.map(|(joint, _)| joint),
        factor: match answer.falls {
            true => Some(0.0),
            false => least.map(|(_, factor)| factor),
        },
        limits_known: loading.holds.iter().all(|hold| *hold != JointHold::Unknown),
        second_order: answer.rotations.is_some(),
        top_displacement_m: answer.rotations.as_ref().map(|theta| {
            let each = theta.iter().zip(chain.links());
            each.map(|(theta, link)| theta * link.length_m).sum()
        }),
        joints,
    })
}

/// Rotations under the loads and under a tilt.
struct LoadRotations {
    rotations: Option<Vec<f64>>,
    falls: bool,
    /// Moment of each joint per rad of a common tilt: M_i; Σ_{j≥i} G_j if the stiffness is unknown.
    tilts: Vec<f64>,
}

impl LoadRotations {
    fn solve(&mut self, chain: &Chain, k: &[f64], moments: &[f64]) -> Result<(), StabilityError> {
        let n = k.len();
        // a built-in tilt t leaves the springs stress-free in the tilted shape: K θ = K_springs t, and the joint carries k (α − α_0)
        let gravity = chain.gravity_moments_n_m_rad();
        let loads = Matrix::from_fn(n, 2, |i, column| match column {
            0 => moments[i],
            _ => gravity[i],
        });
        let stiffness = chain.stiffness_matrix(k)?;
        let solved = solve(&stiffness, &loads)?;
        let column = |c: usize| solved.column(c).to_vec();
        let lean = column(1);
        self.tilts = (0..n).map(|i| k[i] * joint_rotation(&lean, i)).collect();
        self.rotations = Some(column(0));
        Ok(())
    }
}

fn joint_rotation(theta: &[f64], i: usize) -> f64 {
    match i {
        0 => theta[0],
        _ => theta[i] - theta[i - 1],
    }
}

/// Force of each link, and its moment about the link's lower joint.
#[derive(Clone, Copy, Default)]
struct OfLink {
    force_n: f64,
    moment_n_m: f64,
}

fn per_link(chain: &Chain, loads: &[LinkLoad]) -> Result<Vec<OfLink>, StabilityError> {
    let links = chain.links();
    let mut all = vec![OfLink::default(); links.len()];
    for load in loads {
        let index = load.link.checked_sub(1).filter(|i| *i < links.len());
        let Some(i) = index else {
            return Err(StabilityError::Structure(StructureError::Part {
                part: "link",
                given: load.link,
                most: links.len(),
            }));
        };
        for (option, given) in [("force_n", load.force_n), ("moment_n_m", load.moment_n_m)] {
            if !given.is_finite() {
                return Err(StabilityError::Option {
                    option,
                    given,
                    allowed: "a finite number",
                });
            }
        }
        // a height computed from sums may miss the end of the link by rounding
        let slack = 1e-9 * links[i].length_m;
        if !(-slack..=links[i].length_m + slack).contains(&load.height_m) {
            return Err(StabilityError::Structure(StructureError::Height {
                quantity: "height_m of a load above its link's joint",
                given: load.height_m,
                top_m: links[i].length_m,
            }));
        }
        all[i].force_n += load.force_n;
        all[i].moment_n_m += load.force_n * load.height_m + load.moment_n_m;
    }
    Ok(all)
}

/// Q_i: moment of the link's own forces, and of the forces above at the full length of the link.
fn generalised(chain: &Chain, forces: &[OfLink]) -> Vec<f64> {
    let mut above_n = 0.0;
    let mut all = vec![0.0; forces.len()];
    for (i, (of, link)) in forces.iter().zip(chain.links()).enumerate().rev() {
        all[i] = of.moment_n_m + link.length_m * above_n;
        above_n += of.force_n;
    }
    all
}

fn sums_from_the_top(each: &[f64]) -> Vec<f64> {
    let mut sums = each.to_vec();
    for i in (1..sums.len()).rev() {
        sums[i - 1] += sums[i];
    }
    sums
}
