//! State of friction in the joints of a chain, from event to event.

use super::ChainSlip;
use super::frame_model::Slider;

/// Change of the friction of a joint within a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change {
    /// Its moment has reached the static limit, in this direction.
    Goes(f64),
    /// It has stopped rotating.
    Stops,
}

pub(super) struct Friction {
    /// For each joint, number of first coefficients that are zero after an event and contain only rounding.
    pub(super) zeros: Vec<usize>,
    /// States of the joints before the event, if they may have to change before the next step.
    pub(super) unsettled: Option<Vec<Slider>>,
    /// Joints that must rotate: their static moment was reached and is above the kinetic one.
    pub(super) gone: Vec<usize>,
    /// Rotation and time at the start of the current slip.
    pub(super) turning: Vec<Option<(f64, f64)>>,
    pub(super) pile: usize,
    pub(super) pile_at_s: f64,
    pub(super) last_event_s: f64,
    pub(super) slips: Vec<ChainSlip>,
    pub(super) events: usize,
}

impl Friction {
    /// State at the start of a run: joints that rotate slip; the others stick until the law is evaluated.
    pub(super) fn start(sliders: &[Slider]) -> Self {
        let any = sliders.iter().any(|slider| *slider != Slider::Absent);
        Friction {
            zeros: vec![0; sliders.len()],
            unsettled: any.then(|| vec![Slider::Absent; sliders.len()]),
            gone: Vec::new(),
            turning: vec![None; sliders.len()],
            pile: 0,
            pile_at_s: f64::NEG_INFINITY,
            last_event_s: 0.0,
            slips: Vec::new(),
            events: 0,
        }
    }

    /// After some time, no quantity is exactly at its limit any more.
    pub(super) fn moved_on(&mut self) {
        self.zeros.fill(0);
        self.gone.clear();
    }
}
