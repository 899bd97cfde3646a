//! Work on a frame over one step: input, and dissipation by friction and dashpots.

use super::frame_friction::StoreyFriction;
use super::frame_history::FrameEnergy;
use super::frame_model::{Model, Slider, State, drift_m};
use super::frame_series::Series;
use super::frame_tenon::Joint;
use crate::numeric::{COEFFICIENTS_MOST, polynomial};

/// Number of coefficients of the work: a product of two series.
const WORK_MOST: usize = 2 * COEFFICIENTS_MOST;
/// Nodes and weights of 8-point Gauss-Legendre quadrature on [0, 1]: exact for polynomials up to degree 15.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

pub(super) struct Work {
    /// State at the start of the current series; its stored energy is not updated.
    pub(super) energy: FrameEnergy,
    /// Input since the start of the series: coefficients of σ, and their number.
    put_in: [f64; WORK_MOST],
    orders: usize,
    within: State,
}

impl Work {
    pub(super) fn start(model: &Model, state: &State) -> Self {
        let (kinetic_j, stored_j) = (model.kinetic_j(&state.v), model.stored_j(state));
        Work {
            energy: FrameEnergy {
                kinetic_j,
                stored_j,
                input_j: kinetic_j + stored_j,
                ..FrameEnergy::default()
            },
            put_in: [0.0; WORK_MOST],
            orders: 0,
            within: state.clone(),
        }
    }

    /// ∫ force dY and −∫ M 1 a_ground dY from the start of the series, as one polynomial in σ.
    pub(super) fn expand(&mut self, model: &Model, series: &Series) {
        self.orders = series.orders + series.ground_orders.max(series.force_orders);
        self.put_in[..self.orders].fill(0.0);
        // power of the input: (Σ σᵏ f_k) (Σ j y_j σ^(j−1)); its coefficient j + k − 1 is stored at j + k
        let mut add = |acts: &[f64], way: &[f64]| {
            for (k, act) in acts.iter().enumerate() {
                for (put_in, way) in self.put_in[k..].iter_mut().zip(way) {
                    *put_in += act * way;
                }
            }
        };
        let mut way = [0.0; COEFFICIENTS_MOST];
        let way = &mut way[..series.orders];
        if series.ground_orders > 0 {
            for (y, mass) in series.y.iter().zip(&model.mass_kg) {
                for (way, y) in way.iter_mut().zip(y) {
                    *way -= mass * y;
                }
            }
            times_power(way);
            add(&series.ground[..series.ground_orders], way);
        }
        for (y, force) in series.y.iter().zip(&series.forces) {
            way.copy_from_slice(&y[..series.orders]);
            times_power(way);
            add(&force[..series.force_orders], way);
        }
        let mut power = 0.0;
        for put_in in &mut self.put_in[1..self.orders] {
            power += 1.0;
            *put_in /= power;
        }
    }

    /// Work input and dissipated energy up to σ of the series, from state `from` to state `to`, without stored
    /// energy.
    pub(super) fn at(
        &mut self,
        model: &Model,
        [from, to]: [&State; 2],
        series: &Series,
        sigma: f64,
    ) -> FrameEnergy {
        let mut energy = self.energy;
        energy.input_j += polynomial(&self.put_in[..self.orders], sigma);
        for (i, friction) in model.friction.iter().enumerate() {
            if let (
                StoreyFriction::Coulomb { kinetic_force_n, .. }
                | StoreyFriction::Jenkins { kinetic_force_n, .. },
                Slider::Slipping(_),
            ) = (friction, from.slider[i])
            {
                // no reversal within a series
                let way = model.across(i, &to.y) - model.across(i, &from.y);
                energy.friction_j += kinetic_force_n * way.abs();
            }
        }
        for (i, joint) in from.joint.iter().enumerate() {
            if let Some(force_n) = joint
                .as_ref()
                .map(Joint::crushing_n)
                .filter(|force_n| *force_n > 0.0)
            {
                // no reversal within a series
                energy.crushing_j += force_n * (drift_m(&to.y, i) - drift_m(&from.y, i)).abs();
            }
        }
        if model.damped() {
            let mut taken = 0.0;
            for (node, weight) in GAUSS {
                for node in [node, -node] {
                    series.place(0.5 * sigma * (1.0 + node), &mut self.within);
                    taken += 0.5 * weight * model.damping_power(&self.within.v);
                }
            }
            energy.damping_j += taken * sigma * series.h;
        }
        energy
    }
}

/// Multiplies coefficient j by j: the coefficients of σ p'(σ).
fn times_power(c: &mut [f64]) {
    let mut power = 0.0;
    for c in c {
        *c *= power;
        power += 1.0;
    }
}
