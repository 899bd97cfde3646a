//! The rest position of a leaning chain under its own weight.

use super::DynamicsError;
use super::chain_model::ChainModel;
use super::chain_props::{Prop, PropState};
use super::chain_rotations::ChainRotations;
use dolmen_linalg::{Matrix, cholesky, solve_lower, solve_lower_transposed};

/// Newton's method ends when no rotation changes by more than this, rad.
const FOUND_RAD: f64 = 1e-14;
/// Largest number of iterations. Newton's method doubles the correct digits and takes six iterations from a lean of 1/12. If it needs more than
/// the limit, the chain does not come to rest.
const ROUNDS: usize = 50;

/// Rotations of the links from the vertical, rad, at which the springs balance the weight of a leaning chain. `None` if there is no such state
/// within the limits of the joints: the chain falls, or a joint would open.
///
/// ```text
/// k_i φ_i − k_{i+1} φ_{i+1} + Σ c_i F cos θ_i = G_i sin θ_i,   φ_1 = θ_1 − lean,   |k_i φ_i| ≤ N_i b_i/2          θ for sin θ of small rotations
/// ```
///
/// # Errors
/// [`DynamicsError::Structure`] if the stiffness matrix cannot be assembled.
///
/// # Limits
/// Friction is not included: a stuck joint may hold the chain at another rotation.
pub fn chain_at_rest(model: &ChainModel) -> Result<Option<Vec<f64>>, DynamicsError> {
    let chain = model.chain();
    let n = chain.links().len();
    let gravity = chain.gravity_moments_n_m_rad();
    let stiffness: Vec<f64> = model.joints().iter().map(|j| j.stiffness_n_m_rad).collect();
    let upright = chain.without_side_supports().stiffness_matrix(&stiffness)?;
    let is_large = model.rotations() == ChainRotations::Large;
    let mut theta = vec![model.lean_rad(); n];
    let mut props: Vec<PropState> = model.props.iter().map(|prop| prop.state(0.0)).collect();
    for _ in 0..ROUNDS {
        let moment = |i: usize, theta: &[f64]| match i < n {
            true => stiffness[i] * model.across_rad(i, theta),
            false => 0.0,
        };
        let mut tangent = upright.clone();
        let mut left = Vec::with_capacity(n);
        for (i, gravity) in gravity.iter().enumerate() {
            let [sin, cos] = match is_large {
                true => [theta[i].sin(), theta[i].cos()],
                false => [theta[i], 1.0],
            };
            tangent[(i, i)] += gravity * (1.0 - cos);
            left.push(gravity * sin - moment(i, &theta) + moment(i + 1, &theta));
        }
        for (prop, state) in model.props.iter().zip(&props) {
            let PropState::Touching(sign) = *state else {
                continue;
            };
            let beside_m = prop.beside_m(&theta, model.rotations());
            let force_n = prop.stiffness_n_m * (beside_m - sign * prop.gap_m);
            let arm = |i: usize| prop.lever_m[i] * if is_large { theta[i].cos() } else { 1.0 };
            for i in 0..n {
                left[i] -= force_n * arm(i);
                for j in 0..n {
                    tangent[(i, j)] += prop.stiffness_n_m * arm(i) * arm(j);
                }
                if is_large {
                    tangent[(i, i)] -= force_n * prop.lever_m[i] * theta[i].sin();
                }
            }
        }
        // not positive definite: the chain falls, possibly onto a side support
        let lower = match cholesky(&tangent) {
            Ok(lower) => lower,
            Err(_) if props.contains(&PropState::Free) => {
                let sign = if model.lean_rad() < 0.0 { -1.0 } else { 1.0 };
                props
                    .iter_mut()
                    .for_each(|state| *state = PropState::Touching(sign));
                continue;
            }
            Err(_) => return Ok(None),
        };
        let turned = solve_lower(&lower, Matrix::from_column(&left))
            .and_then(|half| solve_lower_transposed(&lower, half));
        let Ok(turned) = turned else {
            return Ok(None);
        };
        let mut most_rad: f64 = 0.0;
        for (theta, turned) in theta.iter_mut().zip(turned.column(0)) {
            *theta += turned;
            most_rad = most_rad.max(turned.abs());
        }
        if most_rad <= FOUND_RAD {
            // the contacts of side supports stay fixed until everything else is at rest, so that an overshooting iteration does not release them
            let beside = |prop: &Prop| prop.state(prop.beside_m(&theta, model.rotations()));
            let now: Vec<PropState> = model.props.iter().map(beside).collect();
            if now != props {
                props = now;
                continue;
            }
            let mut joints = model.moment_most_n_m().iter().enumerate();
            let holds = joints.all(|(i, most)| moment(i, &theta).abs() <= *most);
            return Ok(holds.then_some(theta));
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{ChainJoint, ChainRun, JointOpening, TimeFunction, simulate_chain};
    use crate::structure::{Chain, Inertia, Link};

    const G: f64 = 9.81;

    fn pole(links: usize, stiffness_n_m_rad: f64, rotations: ChainRotations) -> ChainModel {
        let link = |i: usize| Link {
            mass_kg: 900.0 / (1.0 + i as f64),
            length_m: 2.0,
            centroid_m: 0.9,
            inertia: Inertia::ThinRod,
            bed_width_m: Some(0.8),
        };
        let chain = Chain::new((0..links).map(link).collect(), G).unwrap();
        let joint = |i: usize| ChainJoint {
            opening: JointOpening::AtBedEdge,
            ..ChainJoint::spring(stiffness_n_m_rad / (1.0 + i as f64).powi(3))
        };
        ChainModel::new(chain, (0..links).map(joint).collect(), rotations).unwrap()
    }

    #[test]
    fn exact_one_link_leans_on_until_spring_and_weight_agree() {
        // small rotations: k (θ − lean) = m g l θ; large rotations: k (θ − lean) = m g l sin θ
        let (k, lean) = (40_000.0, 0.02);
        let weight_n_m = 900.0 * G * 0.9;
        let model = pole(1, k, ChainRotations::Small).leaning(lean).unwrap();
        let theta = chain_at_rest(&model).unwrap().unwrap()[0];
        approx::assert_relative_eq!(theta, lean * k / (k - weight_n_m), max_relative = 1e-13);
        let model = pole(1, k, ChainRotations::Large).leaning(lean).unwrap();
        let theta = chain_at_rest(&model).unwrap().unwrap()[0];
        approx::assert_relative_eq!(k * (theta - lean), weight_n_m * theta.sin(), max_relative = 1e-12);
    }

    #[test]
    fn exact_a_lean_is_a_steady_push_of_the_ground_sideways() {
        // small rotations: along the leaning axis gravity acts as on an upright chain; across it, lean · g acts on every stone
        let (lean, n) = (0.01, 4);
        let model = pole(n, 3e6, ChainRotations::Small);
        let leaning = model.clone().leaning(lean).unwrap();
        let ground = TimeFunction::Harmonic {
            amplitude: 0.8,
            frequency_hz: 1.1,
            phase_rad: 0.0,
        };
        let run = |model: &ChainModel, start: Vec<f64>| {
            let options = ChainRun {
                duration_s: Some(4.0),
                start_rotation_rad: start,
                ..ChainRun::default()
            };
            simulate_chain(model, &ground, &options, &mut |_| true).unwrap()
        };
        let rest = chain_at_rest(&leaning).unwrap().unwrap();
        let (upright, leans) = (run(&model, vec![0.0; n]), run(&leaning, rest.clone()));
        let links = upright.rotation_rad.iter().zip(&leans.rotation_rad);
        for ((upright, leans), rest) in links.zip(&rest) {
            for (a, b) in upright.iter().zip(leans) {
                approx::assert_abs_diff_eq!(a + rest, *b, epsilon = 1e-12);
            }
        }
        assert!(
            leans.energy_left_over_ratio < 1e-9,
            "{}",
            leans.energy_left_over_ratio
        );
    }

    #[test]
    fn holds_at_rest_it_stays_and_beyond_the_edge_it_falls() {
        let still = |model: &ChainModel, start: Vec<f64>| {
            let options = ChainRun {
                duration_s: Some(20.0),
                start_rotation_rad: start,
                ..ChainRun::default()
            };
            simulate_chain(model, &TimeFunction::Zero, &options, &mut |_| true).unwrap()
        };
        // with stiff springs, the moment at the foot reaches N b/2 when the centre of mass is above the edge
        let stiff = pole(3, 1e9, ChainRotations::Large);
        let chain = stiff.chain();
        let (mut weight_n, mut about_foot) = (0.0, 0.0);
        for (i, link) in chain.links().iter().enumerate() {
            weight_n += link.mass_kg * G;
            about_foot += link.mass_kg * G * (2.0 * i as f64 + 0.9);
        }
        let edge = (0.4 * weight_n / about_foot).asin();
        let inside = stiff.clone().leaning(0.99 * edge).unwrap();
        let rest = chain_at_rest(&inside).unwrap().unwrap();
        let history = still(&inside, rest.clone());
        assert!(
            history
                .rotation_peaks
                .iter()
                .zip(&rest)
                .all(|(p, r)| (p.rotation_rad - r).abs() < 1e-9)
        );
        assert_eq!(
            chain_at_rest(&stiff.clone().leaning(1.01 * edge).unwrap()).unwrap(),
            None
        );
        let outside = stiff.leaning(1.01 * edge).unwrap();
        let history = still(&outside, vec![1.01 * edge; 3]);
        assert!(
            matches!(history.outcome, crate::dynamics::ChainOutcome::Fell { .. }),
            "{:?}",
            history.outcome
        );
    }

    #[test]
    fn refuses_a_lean_of_a_half() {
        let refused = pole(1, 1e5, ChainRotations::Large).leaning(0.53).unwrap_err();
        assert!(refused.to_string().contains("lean_rad"), "{refused}");
    }
}
