//! A frame that leans before a run.

use super::DynamicsError;
use super::excitation::TimeFunction;
use super::frame_friction::{FrictionFrame, Sliders, StoreyFriction};
use super::frame_model::{Model, Slider, State};
use super::frame_rest::rest_m;
use super::frame_tenon::Joint;

/// The load of a lean on a frame, and the initial state.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameLeaning {
    /// Constant forces of P-delta at the levels, lowest first.
    pub forces_n: Vec<TimeFunction>,
    /// Initial displacements, m: the springs balance these forces with every slider stuck; 0 if there is no such state.
    pub start_displacement_m: Vec<f64>,
}

impl FrictionFrame {
    /// A frame with a stress-free lean `tilt`, horizontal over vertical, as built or settled. Displacements are relative to the leaning
    /// position.
    ///
    /// ```text
    /// M Y'' + C Y' + K Y + Σ b_i q_i = −M 1 a_ground + Bᵀ N τ,     start: K_stuck Y = Bᵀ N τ, no Coulomb slider moved
    /// ```
    /// A measured tilt already includes the contribution of gravity, so the start is slightly on the safe side: by τ N/(κ l) for each storey.
    ///
    /// # Errors
    /// [`DynamicsError::Structure`] if the range of values exceeds the precision of the numbers.
    pub fn leaning(&self, tilt: f64) -> Result<FrameLeaning, DynamicsError> {
        let forces_n = self.frame.lean_forces_n(tilt);
        let n = forces_n.len();
        let rigid = |of: &StoreyFriction| matches!(of.acting(), StoreyFriction::Coulomb { .. });
        // a frame that falls with stuck sliders can only start without displacement
        let is_held = self.friction.iter().all(rigid)
            || self.frequencies_hz(Sliders::Stuck)?.iter().all(Option::is_some);
        let start_displacement_m = match is_held && tilt != 0.0 {
            true => {
                let state = State {
                    y: vec![0.0; n],
                    v: vec![0.0; n],
                    slider: vec![Slider::Stuck; n],
                    offset_m: vec![0.0; n],
                    joint: self
                        .tenons
                        .iter()
                        .map(|tenon| tenon.map(|of| Joint::at(of, 0.0)))
                        .collect(),
                };
                rest_m(&Model::of(self)?, &state, &forces_n)
            }
            false => vec![0.0; n],
        };
        Ok(FrameLeaning {
            forces_n: forces_n.into_iter().map(TimeFunction::Constant).collect(),
            start_displacement_m,
        })
    }
}
