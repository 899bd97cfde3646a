//! Earthquakes in a record as JSON.

use super::identified::identified;
use crate::as_json;
use crate::finite::JsonObject;
use dolmen::modal::{
    AtLeast, During, LastingChange, Mode, Part, ShakingKind, StrongChannel, StrongEvent, TrackPoint,
};
use dolmen_work::surveyed::{Earthquake, ModesOf};
use serde_json::Value;

/// The part of a record with an earthquake that the modes come from.
pub(super) fn modes_of(of: ModesOf) -> &'static str {
    match of {
        ModesOf::After => "after",
        ModesOf::Between => "between",
        ModesOf::Before => "before",
        ModesOf::During => "during",
        ModesOf::Whole => "whole",
    }
}

/// The earthquakes in a record; times from the first sample of its file. Values next to `events` belong to the earthquake that is
/// strongest over its noise.
pub(super) fn earthquake(of: &Earthquake) -> Value {
    let found = &of.found;
    let part = |of: &Part| {
        as_json!({
            "from_s": of.span_s[0],
            "to_s": of.span_s[1],
            "modes": of.analysis.as_ref().map(|of| identified(&of.modes)),
        })
    };
    let mut all = JsonObject::default();
    all.append(event(found.strongest()));
    all.append(as_json!({
        "modes_of": modes_of(of.modes_of),
        "events": found.events.iter().map(event).collect::<Vec<_>>(),
        "before": part(found.before()),
        "after": part(found.after()),
        "parts": found.quiet.iter().map(part).collect::<Vec<_>>(),
        "changes": found.changes.iter().map(change).collect::<Vec<_>>(),
        "compared_parts": found.compared,
    }));
    all.done()
}

fn event(of: &StrongEvent) -> Value {
    let shaking = &of.shaking;
    let taken = match shaking.kind {
        ShakingKind::Earthquake => "earthquake",
        ShakingKind::EarthquakeOrTraffic => "earthquake_or_traffic",
    };
    as_json!({
        "taken_for": taken,
        "arrival_s": shaking.arrival_s,
        "strong_from_s": shaking.strong_from_s,
        "strong_to_s": shaking.strong_to_s,
        "end_s": shaking.end_s,
        "over_noise": shaking.over_noise,
        "growth": shaking.growth,
        "channels": of.channels.iter().map(channel).collect::<Vec<_>>(),
        "during": during(&of.during),
        "changes": of.changes.iter().map(change).collect::<Vec<_>>(),
    })
}

fn channel(of: &StrongChannel) -> Value {
    let at_least = of.at_least.map(|why| match why {
        AtLeast::Clipped => "clipped",
        AtLeast::Lost => "lost_samples",
        AtLeast::Edge => "edge_of_record",
    });
    as_json!({
        "name": of.name,
        "peak_acceleration_m_s2": of.peak_acceleration_m_s2,
        "peak_at_least": at_least,
        "peak_at_s": of.peak_at_s,
        "peak_velocity_m_s": of.peak_velocity_m_s,
        "velocity_band_hz": of.velocity_band_hz,
        "arias_intensity_m_s": of.arias_intensity_m_s,
        "noise": of.noise,
        "spectrum": of.spectrum.iter().map(|of| [of.period_s, of.pseudo_acceleration_m_s2()]).collect::<Vec<_>>(),
    })
}

pub(super) fn change(of: &LastingChange) -> Value {
    as_json!({
        "before_hz": of.before_hz,
        "before_sd_hz": of.before_sd_hz,
        "after_hz": of.after_hz,
        "after_sd_hz": of.after_sd_hz,
        "change_ratio": of.ratio,
        "sd": of.ratio_sd,
        "chance": of.chance,
        "beyond_chance": of.is_beyond_chance(),
    })
}

fn during(of: &During) -> Value {
    let window = |of: &TrackPoint| as_json!({ "at_s": of.at_s, "frequency_hz": of.frequency_hz, "frequency_sd_hz": of.frequency_sd_hz });
    let mode = |hz: f64, sd: Option<f64>, zeta: Option<f64>, zeta_sd: Option<f64>| as_json!({ "frequency_hz": hz, "frequency_sd_hz": sd, "damping_ratio": zeta, "damping_ratio_sd": zeta_sd });
    let (how, modes, windows): (&str, Vec<Value>, Vec<Value>) = match of {
        During::Driven(of) => {
            let each = of.analysis.modes.modes.iter().map(|of: &Mode| {
                mode(
                    of.frequency_hz,
                    of.frequency_sd_hz,
                    of.damping_ratio,
                    of.damping_ratio_sd,
                )
            });
            ("inputs", each.collect(), Vec::new())
        }
        During::Tracked(of) => {
            let one = mode(of.frequency_hz, Some(of.frequency_sd_hz), None, None);
            ("tracked", vec![one], of.points.iter().map(window).collect())
        }
        During::Unknown => ("unknown", Vec::new(), Vec::new()),
    };
    as_json!({ "how": how, "modes": modes, "windows": windows })
}
