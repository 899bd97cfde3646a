//! State variables of sliding stones.

use super::sliding_bed::Twist;
use super::sliding_chain::Place;

/// State variables of sliding stones.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) places: Vec<Place>,
    pub(super) twists: Vec<Twist>,
    pub(super) input: f64,
    pub(super) friction: f64,
}

/// Adds rates times `h` seconds.
pub(super) fn add(state: &mut State, h: f64, places: &[Place], twists: &[Twist], energies: [f64; 2]) {
    for (place, rate) in state.places.iter_mut().zip(places) {
        place.shift += h * rate.shift;
        place.yaw += h * rate.yaw;
    }
    for (twist, k) in state.twists.iter_mut().zip(twists) {
        *twist += h * *k;
    }
    state.input += h * energies[0];
    state.friction += h * energies[1];
}
