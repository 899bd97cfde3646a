//! A frame that leans before it is shaken.

use super::DynamicsError;
use super::excitation::TimeFunction;
use super::frame_friction::{FrictionFrame, Sliders, StoreyFriction};
use super::frame_model::{Model, Slider, State};
use super::frame_rest::rest_m;
use super::frame_tenon::Joint;

/// What a lean puts on a frame in a run, and where the run begins.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameLeaning {
    /// Forces of P-delta at the levels, lowest first, which stay.
    pub forces_n: Vec<TimeFunction>,
    /// Displacements at the start, m: where springs hold these forces, every slider stuck; 0 where they do not.
    pub start_displacement_m: Vec<f64>,
}

impl FrictionFrame {
    /// The frame leaning by `tilt`, horizontal over vertical, as built or settled: without stress, displacements counted from there.
    ///
    /// ```text
    /// M Y'' + C Y' + K Y + Σ b_i q_i = −M 1 a_ground + Bᵀ N τ,     start: K_stuck Y = Bᵀ N τ, no Coulomb slider moved
    /// ```
    /// A measured tilt holds already what gravity added to it, so that the start is a little on the unfavourable side: by τ N/(κ l) a storey.
    ///
    /// # Errors
    /// [`DynamicsError::Structure`] if the values differ by more than the numbers hold.
    pub fn leaning(&self, tilt: f64) -> Result<FrameLeaning, DynamicsError> {
        let forces_n = self.frame.lean_forces_n(tilt);
        let n = forces_n.len();
        let rigid = |of: &StoreyFriction| matches!(of.acting(), StoreyFriction::Coulomb { .. });
        // what falls with its sliders stuck has no place to begin but upright
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
