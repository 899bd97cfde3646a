//! Joints that a run takes as rigid because they are much stiffer than the other joints.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | ω², φ | `eigen` | square of a circular frequency and shape, with the joints rigid | 1/s², rad |
//! | q_i | `held_n_m` | moment in rigid joint i in that shape | N m |
//! | k_i | `stiffness_n_m_rad` | spring of joint i | N m/rad |

use super::chain_model::{ChainModel, JointFriction};
use super::chain_props::Prop;
use super::chain_run::ChainRun;
use dolmen_linalg::{LinalgError, Matrix, generalized_symmetric_eigen};

/// Largest relative change of a natural frequency by joints taken as rigid. Our choice: a hundredth of the effect of 1 % of mass.
const FREQUENCY_CHANGE_MOST: f64 = 1e-4;
/// Least stiffness over load of a candidate, relative to the softest joint: below it the frequencies change too much anyway.
const STIFFER_AT_LEAST: f64 = 100.0;
/// Fraction of the largest initial rotation of any joint above which the spring of a joint is integrated, because it would oscillate.
const START_MOST: f64 = 1e-3;

/// A joint taken as rigid in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainRigidJoint {
    /// The joint, 0 the lowest.
    pub joint: usize,
    /// Its spring, N m/rad.
    pub stiffness_n_m_rad: f64,
    /// Largest relative change of a natural frequency by all joints taken as rigid together.
    pub frequency_change_ratio: f64,
}

/// The joints of a chain that a run takes as rigid: as many as possible, with a relative change of at most 1e-4 in every other natural frequency.
///
/// ```text
/// δω/ω = Σ_i q_i²/(2 k_i ω² φᵀMφ)          first order in 1/k_i; i: rigid joints
/// ```
/// `released` are joints that would rock on the edge of their bed.
///
/// # Limits
/// Upright, without open joints, and with side supports with a gap both free and in contact.
pub(super) fn rigid_joints(
    model: &ChainModel,
    options: &ChainRun,
    released: &[usize],
) -> Vec<ChainRigidJoint> {
    let loads = model.chain.necessary_n_m_rad();
    let relative = |joint: usize| model.joints[joint].stiffness_n_m_rad / loads[joint];
    let count = model.joints.len();
    let softest = (0..count).map(relative).fold(f64::INFINITY, f64::min);
    let mut stiff: Vec<usize> = (0..count)
        .filter(|joint| relative(*joint) > STIFFER_AT_LEAST * softest.max(f64::MIN_POSITIVE))
        .filter(|joint| model.joints[*joint].friction == JointFriction::None)
        .filter(|joint| !released.contains(joint) && starts_still(model, options, *joint))
        .collect();
    stiff.sort_by(|a, b| relative(*b).total_cmp(&relative(*a)));
    while !stiff.is_empty() {
        // if the modes are not accurate, the springs are integrated
        let of = |touched| frequency_change(model, &stiff, touched).unwrap_or(f64::INFINITY);
        let change = of(false).max(of(true));
        if change <= FREQUENCY_CHANGE_MOST {
            stiff.sort_unstable();
            let taken = stiff.iter().map(|joint| ChainRigidJoint {
                joint: *joint,
                stiffness_n_m_rad: model.joints[*joint].stiffness_n_m_rad,
                frequency_change_ratio: change,
            });
            return taken.collect();
        }
        stiff.pop();
    }
    Vec::new()
}

/// The lowest joint that a push rotates, from 0 at the bottom. The joints below it are rigid in a run from this state, and the push would not
/// bring their beds to their edges. 0 if no joint rotates.
///
/// ```text
/// joint i is passed over if it is rigid and k_i |push| < N_i b_i/2
/// ```
/// Validated by tests/validation/chain_rigid_joints.rs.
pub fn lowest_turning_joint(model: &ChainModel, at_rest: &ChainRun, push_rad: f64) -> usize {
    let rigid = rigid_joints(model, at_rest, &[]);
    let turns = |joint: &usize| {
        let passes = rigid.iter().any(|of| {
            let moment_n_m = of.stiffness_n_m_rad * push_rad.abs();
            of.joint == *joint && moment_n_m < model.moment_most_n_m[*joint]
        });
        !passes
    };
    (0..model.joints.len()).find(turns).unwrap_or(0)
}

/// The chain without the springs and dashpots of these joints. Their moments follow from the equilibrium of the links.
pub(super) fn holding(model: &ChainModel, rigid: &[ChainRigidJoint]) -> ChainModel {
    let mut model = model.clone();
    for of in rigid {
        let joint = &mut model.joints[of.joint];
        (joint.stiffness_n_m_rad, joint.damping_n_m_s_rad) = (0.0, 0.0);
    }
    model
}

/// Whether a joint hardly rotates at the start, compared with the others.
fn starts_still(model: &ChainModel, options: &ChainRun, joint: usize) -> bool {
    let rotation = &options.start_rotation_rad;
    let rate = &options.start_velocity_rad_s;
    let turns = !rate.is_empty() && rate[joint] != joint.checked_sub(1).map_or(0.0, |below| rate[below]);
    if turns {
        return false;
    }
    let at_zero = vec![0.0; model.joints.len()];
    let rotation = if rotation.is_empty() { &at_zero } else { rotation };
    let across = |i: usize| model.across_rad(i, rotation).abs();
    let most = (0..model.joints.len()).map(across).fold(0.0, f64::max);
    let moment_n_m = model.joints[joint].stiffness_n_m_rad * across(joint);
    across(joint) <= START_MOST * most && moment_n_m < model.moment_most_n_m[joint]
}

/// Largest relative change of a natural frequency if these joints are rigid; infinite for a mode that is neither stable nor unstable.
fn frequency_change(model: &ChainModel, rigid: &[usize], touched: bool) -> Result<f64, LinalgError> {
    let n = model.joints.len();
    let mut group: Vec<Option<usize>> = Vec::with_capacity(n);
    let mut groups = 0;
    for joint in 0..n {
        let below = joint.checked_sub(1).and_then(|below| group[below]);
        group.push(match rigid.contains(&joint) {
            true => below,
            false => {
                groups += 1;
                Some(groups - 1)
            }
        });
    }
    let (mass, gravity) = (model.chain.mass_matrix(), model.chain.gravity_moments_n_m_rad());
    let props: Vec<&Prop> = model
        .props
        .iter()
        .filter(|prop| touched || prop.gap_m == 0.0)
        .collect();
    let spring = |joint: usize| match rigid.contains(&joint) {
        true => 0.0,
        false => model.joints[joint].stiffness_n_m_rad,
    };
    let entry = |i: usize, j: usize| {
        let own = match (i.max(j), i.abs_diff(j)) {
            (_, 0) => spring(i) + if i + 1 < n { spring(i + 1) } else { 0.0 } - gravity[i],
            (upper, 1) => -spring(upper),
            _ => 0.0,
        };
        let beside = props
            .iter()
            .map(|prop| prop.stiffness_n_m * prop.lever_m[i] * prop.lever_m[j]);
        own + beside.sum::<f64>()
    };
    let stiffness = Matrix::from_fn(n, n, entry);
    let joined = |of: &Matrix| {
        let mut sum = Matrix::zeros(groups, groups);
        for i in 0..n {
            for j in 0..n {
                if let (Some(a), Some(b)) = (group[i], group[j]) {
                    sum[(a, b)] += of[(i, j)];
                }
            }
        }
        sum
    };
    let eigen = generalized_symmetric_eigen(&joined(&stiffness), &joined(&mass))?;
    let mut most: f64 = 0.0;
    for (mode, square) in eigen.values.iter().enumerate() {
        let of_groups = eigen.vectors.column(mode);
        let shape: Vec<f64> = group
            .iter()
            .map(|of| of.map_or(0.0, |of| of_groups[of]))
            .collect();
        let (elastic, inertia) = (stiffness.times(&shape), mass.times(&shape));
        let mut held_n_m = 0.0;
        let mut change = 0.0;
        for joint in (0..n).rev() {
            held_n_m -= elastic[joint] - square * inertia[joint];
            if rigid.contains(&joint) {
                change += held_n_m * held_n_m / model.joints[joint].stiffness_n_m_rad;
            } else {
                held_n_m = 0.0;
            }
        }
        let whole = 2.0 * square.abs() * mass.form(&shape, &shape);
        most = most.max(if whole > 0.0 {
            change / whole
        } else {
            f64::INFINITY
        });
    }
    Ok(most)
}
