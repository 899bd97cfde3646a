//! The rest position of a frame without further slip.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | y | `state.y` | displacements at the end of the run | m |
//! | f | `unbalanced` | force of springs and Jenkins elements at these displacements | N |
//! | λ | | forces of the Coulomb sliders, which keep their drifts | N |

use super::frame_friction::StoreyFriction;
use super::frame_model::{Model, State, drift_m};
use super::frame_tenon::{Joint, TenonChange};
use dolmen_linalg::{Matrix, solve};

/// Displacements at rest, m: springs and Jenkins elements are in equilibrium with constant forces, and every slider is fixed.
///
/// ```text
/// [K + K_J  Bᵀ] [Δ]   [F − f]
/// [B        0 ] [λ] = [ 0],    y_rest = y + Δ              (levels + Coulomb sliders)²
/// ```
///
/// Whether tenons are in contact depends on the drifts at rest: states are tried until one agrees with its own drifts. y does not change for
/// a frame without a rest position (it falls with its sliders fixed), or if none is found.
pub(super) fn rest_m(model: &Model, state: &State, forces_n: &[f64]) -> Vec<f64> {
    let mut joints: Vec<Option<Joint>> = state.joint.clone();
    for (i, joint) in joints.iter_mut().enumerate() {
        if let Some(joint) = joint {
            joint.change(TenonChange::Stops, drift_m(&state.y, i));
        }
    }
    for _ in 0..tries_most(joints.len()) {
        let rest_m = with_tenons(model, state, forces_n, &joints);
        let mut is_found = true;
        for (i, joint) in joints.iter_mut().enumerate() {
            if let Some(joint) = joint {
                let then = joint.resting_at(drift_m(&rest_m, i));
                is_found &= then.touch == joint.touch;
                *joint = then;
            }
        }
        if is_found {
            return rest_m;
        }
    }
    state.y.clone()
}

/// Largest number of tried states of tenons: each storey has five, and a storey seldom changes twice.
fn tries_most(storeys: usize) -> usize {
    10 + 5 * storeys
}

/// The rest position for given states of the tenons.
fn with_tenons(model: &Model, state: &State, forces_n: &[f64], joints: &[Option<Joint>]) -> Vec<f64> {
    let n = model.levels();
    let is_held = |i: &usize| matches!(model.friction[*i], StoreyFriction::Coulomb { .. });
    let held: Vec<usize> = (0..n).filter(is_held).collect();
    let size = n + held.len();
    let mut a = Matrix::zeros(size, size);
    let mut right = Matrix::zeros(size, 1);
    for (i, row) in model.k.each().enumerate() {
        right[(i, 0)] += forces_n.get(i).copied().unwrap_or(0.0);
        for &(j, k) in row {
            a[(i, j)] += k;
            right[(i, 0)] -= k * state.y[j];
        }
    }
    // the levels at both ends of a slider with their signs; the ground has none
    let ends = |i: usize| [(Some(i), 1.0), (model.below[i], -1.0)];
    for i in 0..n {
        let StoreyFriction::Jenkins {
            stuck_stiffness_n_m, ..
        } = model.friction[i]
        else {
            continue;
        };
        let force = model.jenkins_force(i, state);
        for (level, sign) in ends(i) {
            let Some(level) = level else { continue };
            right[(level, 0)] -= sign * force;
            for (other, sign_of_other) in ends(i) {
                let Some(other) = other else { continue };
                a[(level, other)] += sign * sign_of_other * stuck_stiffness_n_m;
            }
        }
    }
    for (i, joint) in joints.iter().enumerate() {
        let Some([spring_n_m, at_zero_n]) = joint.as_ref().map(Joint::spring) else {
            continue;
        };
        let force = spring_n_m * drift_m(&state.y, i) + at_zero_n;
        let ends = [(Some(i), 1.0), (i.checked_sub(1), -1.0)];
        for (level, sign) in ends {
            let Some(level) = level else { continue };
            right[(level, 0)] -= sign * force;
            for (other, sign_of_other) in ends {
                let Some(other) = other else { continue };
                a[(level, other)] += sign * sign_of_other * spring_n_m;
            }
        }
    }
    for (row, &i) in held.iter().enumerate() {
        for (level, sign) in ends(i) {
            let Some(level) = level else { continue };
            a[(n + row, level)] += sign;
            a[(level, n + row)] += sign;
        }
    }
    match solve(&a, &right) {
        Ok(change) => (0..n).map(|i| state.y[i] + change[(i, 0)]).collect(),
        Err(_) => state.y.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{FrameHistory, FrameLoad, FrameOutcome, FrameRun, FrictionFrame, simulate_frame};
    use crate::structure::{Convention, Frame, Storey};

    fn frame(friction: [StoreyFriction; 2]) -> FrictionFrame {
        let storey = Storey {
            mass_kg: 50e3,
            height_m: 4.0,
            axial_n: 0.0,
        };
        let frame = Frame::new(vec![storey; 2], Convention::Drift).unwrap();
        FrictionFrame::new(frame, vec![4e6, 2e6], friction.to_vec()).unwrap()
    }

    fn let_go(friction: [StoreyFriction; 2]) -> FrameHistory {
        let options = FrameRun {
            start_displacement_m: vec![0.02, 0.05],
            duration_s: Some(3.3),
            ..FrameRun::default()
        };
        let history = simulate_frame(&frame(friction), &FrameLoad::none(), &options, &mut |_| true).unwrap();
        assert_eq!(history.outcome, FrameOutcome::Finished);
        history
    }

    /// A frame that never slipped rests at its start position, however large its vibration is.
    #[test]
    fn exact_a_frame_without_sliders_rests_at_zero() {
        let history = let_go([StoreyFriction::None; 2]);
        assert!(history.residual_m[1].abs() > 1e-3, "it swings: {history:?}");
        assert!(
            history.rest_m.iter().all(|rest| rest.abs() < 1e-15),
            "{:?}",
            history.rest_m
        );
    }

    /// Two springs in series, the lower one with a Jenkins element that slipped: k_1 u_1 + k_J (u_1 − z) = 0, and the upper storey carries
    /// no force at rest.
    #[test]
    fn exact_a_slipped_element_holds_its_storey_off() {
        let element = StoreyFriction::Jenkins {
            stuck_stiffness_n_m: 6e6,
            static_force_n: 20e3,
            kinetic_force_n: 20e3,
        };
        let history = let_go([element, StoreyFriction::None]);
        let last = |rows: &[Vec<f64>]| *rows[0].last().unwrap();
        let place = last(&history.displacement_m) - last(&history.friction_force_n) / 6e6;
        let rest = 6e6 * place / (4e6 + 6e6);
        assert!(
            place.abs() > 1e-4 && (history.rest_m[0] - rest).abs() < 1e-9,
            "{rest} {:?}",
            history.rest_m
        );
        assert!((history.rest_m[1] - history.rest_m[0]).abs() < 1e-12);
    }
}
