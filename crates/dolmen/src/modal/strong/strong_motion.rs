//! Evaluates a record with earthquakes: what the structure did before, during and after them.

use super::detection::{SURE_M_S2, earthquakes_in, is_sudden};
use super::lasting::changes;
use super::lasting_change::LastingChange;
use super::losses::Losses;
use super::part::Part;
use super::parts::{During, during, quiet};
use super::peaks::{Strength, StrongChannel};
use super::shaking::{Shaking, ShakingKind};
use super::wind::{Cause, cause};
use crate::modal::options::Identify;
use crate::modal::{Method, Modes};
use crate::signal::{Quantity, Record};

/// One earthquake of a record.
#[derive(Clone, Debug)]
pub struct StrongEvent {
    /// Times of the earthquake, and how it was detected.
    pub shaking: Shaking,
    /// Peak values of each channel.
    pub channels: Vec<StrongChannel>,
    /// The structure during the earthquake.
    pub during: During,
    /// Changes of the modes found both before and after it.
    pub changes: Vec<LastingChange>,
}

/// The earthquakes of a record, and the structure before, during, between and after them.
#[derive(Clone, Debug)]
pub struct StrongMotion {
    /// All earthquakes, by time; at least one.
    pub events: Vec<StrongEvent>,
    /// The structure before the first earthquake, between successive ones, and after the last; these parts contain no earthquake.
    pub quiet: Vec<Part>,
    /// Indices of the two parts compared for the total lasting change: the first part with modes and the last.
    pub compared: Option<[usize; 2]>,
    /// Changes of the modes found in both parts, by frequency.
    pub changes: Vec<LastingChange>,
}

impl StrongEvent {
    /// The channel with the largest acceleration; if none measures acceleration, the channel with the largest value.
    pub fn strongest(&self) -> Option<&StrongChannel> {
        let is_acceleration = |of: &&StrongChannel| of.quantity == Quantity::Acceleration;
        let of_acceleration = self.channels.iter().filter(is_acceleration);
        let all = of_acceleration.max_by(|a, b| a.peak.total_cmp(&b.peak));
        all.or_else(|| self.channels.iter().max_by(|a, b| a.peak.total_cmp(&b.peak)))
    }

    /// Whether the true peak acceleration may have been larger.
    pub fn is_at_least(&self) -> bool {
        let is_acceleration = |of: &&StrongChannel| of.quantity == Quantity::Acceleration;
        let of_acceleration = self.channels.iter().filter(is_acceleration);
        of_acceleration.into_iter().any(|of| of.at_least.is_some())
    }

    /// As [`StrongMotion::lasting`], for this earthquake alone.
    pub fn lasting(&self) -> Option<&LastingChange> {
        lowest_beyond(&self.changes)
    }
}

impl StrongMotion {
    /// The earthquake that is strongest relative to the noise.
    pub fn strongest(&self) -> &StrongEvent {
        let over = |of: &&StrongEvent| of.shaking.over_noise;
        let strongest = self.events.iter().max_by(|a, b| over(a).total_cmp(&over(b)));
        strongest.unwrap_or(&self.events[0])
    }

    /// The earthquake with the largest acceleration.
    pub fn largest(&self) -> &StrongEvent {
        let peak = |of: &&StrongEvent| of.strongest().map_or(0.0, |of| of.peak);
        let largest = self.events.iter().max_by(|a, b| peak(a).total_cmp(&peak(b)));
        largest.unwrap_or(&self.events[0])
    }

    /// Whether at least one motion is certainly an earthquake.
    pub fn is_sure(&self) -> bool {
        self.events
            .iter()
            .any(|of| of.shaking.kind == ShakingKind::Earthquake)
    }

    /// The structure before the first earthquake.
    pub fn before(&self) -> &Part {
        &self.quiet[0]
    }

    /// The structure after the last earthquake.
    pub fn after(&self) -> &Part {
        &self.quiet[self.events.len()]
    }

    /// The last part between two earthquakes that has modes.
    pub fn between(&self) -> Option<&Part> {
        let inner = &self.quiet[1..self.events.len()];
        inner.iter().rev().find(|part| part.analysis.is_some())
    }

    /// The total lasting change; if it cannot be determined, the change by the last earthquake for which it can.
    pub fn shown(&self) -> &[LastingChange] {
        match self.compared {
            Some(_) => &self.changes,
            None => {
                let told = self.events.iter().rev().find(|of| !of.changes.is_empty());
                told.map_or(&[], |of| &of.changes)
            }
        }
    }

    /// The significant change of the lowest mode that has one.
    pub fn lasting(&self) -> Option<&LastingChange> {
        lowest_beyond(self.shown())
    }

    /// The largest significant change.
    pub fn lasting_most(&self) -> Option<&LastingChange> {
        let beyond = self.shown().iter().filter(|of| of.is_beyond_chance());
        beyond.max_by(|a, b| a.ratio.abs().total_cmp(&b.ratio.abs()))
    }

    /// The result with all times shifted by this number of seconds, for a record that was cut from a longer one.
    #[must_use]
    pub fn later(mut self, by_s: f64) -> Self {
        for event in &mut self.events {
            event.shaking.shift(by_s);
            event.during.shift(by_s);
            for channel in &mut event.channels {
                channel.peak_at_s += by_s;
            }
        }
        for part in &mut self.quiet {
            part.span_s = part.span_s.map(|at_s| at_s + by_s);
        }
        self
    }
}

/// The significant change of the lowest mode that has one.
fn lowest_beyond(changes: &[LastingChange]) -> Option<&LastingChange> {
    let beyond = changes.iter().filter(|of| of.is_beyond_chance());
    beyond.min_by(|a, b| a.before_hz.total_cmp(&b.before_hz))
}

/// The earthquakes in a record; `None` for ambient vibration, or if the user states that the record is a free decay.
///
/// Outside the earthquakes the modes are found as in any ambient record. During an earthquake, observer/Kalman filter identification gives the modes
/// relative to the channels marked as inputs. Without inputs the lowest mode is tracked along its shape, window by window.
///
/// # Limits
/// Each part needs 40 s. Structures of stone and timber soften with amplitude, and so show a lower frequency while they still move: the part after an
/// earthquake starts when the motion is down to twice the noise. Lasting tilt or displacement is not given, because double integration turns any
/// offset of an accelerometer into one; use a tilt sensor or a survey.
///
/// # Example
/// ```
/// use dolmen::modal::{Identify, Losses, MadeEarthquake, strong_motion};
/// let record = MadeEarthquake::default().make()?;
/// let found = strong_motion(&record, &Identify::default(), &Losses::default()).unwrap();
/// assert!((found.events[0].shaking.arrival_s - 150.0).abs() < 2.0);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn strong_motion(record: &Record, options: &Identify, losses: &Losses) -> Option<StrongMotion> {
    if options.method == Method::Era {
        return None;
    }
    let shakings = earthquakes_in(record, &options.inputs, &losses.lost_s);
    if shakings.is_empty() {
        return None;
    }
    let quiet = quiet(record, options, &shakings, losses);
    let modes = |at: usize| -> Option<&Modes> { quiet[at].analysis.as_ref().map(|of| &of.modes) };
    let last = shakings.len();
    let first = (0..last).find(|at| modes(*at).is_some());
    let compared = first.filter(|_| modes(last).is_some()).map(|first| [first, last]);
    let changes = changes(&quiet, compared);
    let strength = Strength::of(record, &shakings, &quiet, losses);
    let by_event = shakings.iter().zip(changes.by_event);
    let events = by_event.enumerate().map(|(at, (shaking, changes))| {
        let near = modes(at).or_else(|| modes(at + 1));
        let near = near.or_else(|| (0..=last).find_map(modes));
        let channels = strength.channels(at);
        let peaks = channels.iter().filter_map(|of| of.peak_acceleration_m_s2);
        // a part may miss the lowest mode, so none may speak of a force
        let causes: Vec<Cause> = (0..=last)
            .filter_map(modes)
            .map(|modes| cause((record, losses), shaking, modes))
            .collect();
        let is_pushed = causes.contains(&Cause::Force);
        let is_carried = causes.contains(&Cause::Ground) && !is_pushed;
        // strength alone names no cause: a storm may be as strong, but grows over seconds
        let is_strong = peaks.fold(0.0, f64::max) >= SURE_M_S2;
        let is_sure = is_carried || is_strong && is_sudden(shaking) && !is_pushed;
        StrongEvent {
            channels,
            during: during((record, losses), options, shaking, near),
            changes,
            shaking: Shaking {
                kind: match is_sure {
                    true => shaking.kind,
                    false => ShakingKind::EarthquakeOrTraffic,
                },
                ..shaking.clone()
            },
        }
    });
    Some(StrongMotion {
        events: events.collect(),
        changes: changes.in_all,
        compared,
        quiet,
    })
}
