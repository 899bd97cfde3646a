//! From a record that holds an earthquake to what the structure did.

use super::parts::{During, LastingChange, Part, after, before, changes, during};
use super::peaks::{StrongChannel, channels};
use super::shaking::{Shaking, earthquake_in};
use crate::modal::options::Identify;
use crate::modal::{Method, Modes};
use crate::signal::{Quantity, Record};

/// An earthquake in a record, and the structure before, in and after it.
#[derive(Clone, Debug)]
pub struct StrongMotion {
    /// When it was and how it was told.
    pub shaking: Shaking,
    /// What each channel measured.
    pub channels: Vec<StrongChannel>,
    /// The structure before.
    pub before: Part,
    /// The structure in it.
    pub during: During,
    /// The structure after.
    pub after: Part,
    /// Each mode found both before and after.
    pub changes: Vec<LastingChange>,
}

impl StrongMotion {
    /// The channel with the largest acceleration; without accelerations, the largest of all.
    pub fn strongest(&self) -> Option<&StrongChannel> {
        let is_acceleration = |of: &&StrongChannel| of.quantity == Quantity::Acceleration;
        let of_acceleration = self.channels.iter().filter(is_acceleration);
        let all = of_acceleration.max_by(|a, b| a.peak.total_cmp(&b.peak));
        all.or_else(|| self.channels.iter().max_by(|a, b| a.peak.total_cmp(&b.peak)))
    }

    /// The change beyond chance that is surest.
    pub fn lasting(&self) -> Option<&LastingChange> {
        let beyond = self.changes.iter().filter(|of| of.is_beyond_chance());
        let sure = |of: &LastingChange| of.ratio.abs() / of.ratio_sd.unwrap_or(f64::INFINITY);
        beyond.max_by(|a, b| sure(a).total_cmp(&sure(b)))
    }
}

/// The earthquake in a record; `None` of ambient vibration, and where the user says that it is a free decay.
///
/// Before and after it modes are found as in any ambient record. In it they are those above the channels marked as inputs, where there are
/// any, by observer/Kalman filter identification; without, the lowest mode is followed along its shape, window by window.
///
/// # Limits
/// Before and after need 40 s each. A structure that softens with amplitude, as all of stone and timber do, shows a lower frequency as long as
/// it still moves: the part after begins where the motion has sunk to twice the noise. No lasting tilt or displacement is given: integrating an
/// accelerometer twice makes one of any offset; a tilt sensor or a survey gives it.
///
/// # Example
/// ```
/// use dolmen::modal::{Identify, MadeEarthquake, strong_motion};
/// let record = MadeEarthquake::default().make()?;
/// let found = strong_motion(&record, &Identify::default()).unwrap();
/// assert!((found.shaking.arrival_s - 150.0).abs() < 2.0);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn strong_motion(record: &Record, options: &Identify) -> Option<StrongMotion> {
    if options.method == Method::Era {
        return None;
    }
    let shaking = earthquake_in(record, &options.inputs)?;
    let (before, after) = (
        before(record, options, &shaking),
        after(record, options, &shaking),
    );
    let modes = |part: &'_ Part| -> Option<Modes> { part.analysis.as_ref().map(|of| of.modes.clone()) };
    let (quiet, later) = (modes(&before), modes(&after));
    let changes = match (&quiet, &later) {
        (Some(quiet), Some(later)) => changes(quiet, later),
        _ => Vec::new(),
    };
    let during = during(record, options, &shaking, quiet.or(later).as_ref());
    Some(StrongMotion {
        channels: channels(record, &shaking),
        shaking,
        before,
        during,
        after,
        changes,
    })
}
