//! A structure before, during and after a simulated earthquake, with known stiffness at every time.

use super::{Case, ValidationError};
use crate::modal::{During, Identify, Losses, MadeEarthquake, strong_motion};

const SOURCE: &str = "Closed form";
const NOTE: &str = "Two storeys whose stiffness falls to 70 % in an earthquake of 2 m/s² and comes back to 90 %, noise of 2 mm/s²: the lowest frequency from the one \
                    record, before and after as ambient vibration, in it with the measured ground taken as given. Two deviations stated are allowed.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let made = MadeEarthquake::default();
    let options = Identify {
        inputs: vec![0],
        ..Identify::default()
    };
    let Some(found) = strong_motion(&made.make()?, &options, &Losses::default()) else {
        return Ok(Vec::new()); // a test counts the cases
    };
    let of = |softened: f64| MadeEarthquake::frequencies_hz(softened)[0];
    let case = |what: &str, published: f64, computed: f64, sd: f64| Case {
        source: SOURCE,
        what: format!("a made earthquake: lowest frequency {what}"),
        unit: "Hz",
        published,
        computed,
        tolerance: 2.0 * sd,
        corrected: None,
        note: NOTE,
    };
    let mut cases = Vec::new();
    if let Some(change) = found.changes.first() {
        let [before_sd, after_sd] = [change.before_sd_hz, change.after_sd_hz].map(|sd| sd.unwrap_or(0.0));
        cases.push(case("before it", of(1.0), change.before_hz, before_sd));
        cases.push(case("after it", of(made.softened[1]), change.after_hz, after_sd));
    }
    if let During::Driven(part) = &found.events[0].during
        && let Some(mode) = part.analysis.modes.modes.first()
    {
        let sd = mode.frequency_sd_hz.unwrap_or(0.0);
        cases.push(case("in it", of(made.softened[0]), mode.frequency_hz, sd));
    }
    Ok(cases)
}
