//! Earthquakes in a record as JSON.

use super::identified::identified;
use dolmen::modal::{
    AtLeast, During, LastingChange, Mode, Part, ShakingKind, StrongChannel, StrongEvent, TrackPoint,
};
use dolmen_work::surveyed::{Earthquake, ModesOf};
use serde_json::{Map, Value, json};

/// Of which part of a record that holds an earthquake the modes are.
pub(super) fn modes_of(of: ModesOf) -> &'static str {
    match of {
        ModesOf::After => "after",
        ModesOf::Between => "between",
        ModesOf::Before => "before",
        ModesOf::During => "during",
        ModesOf::Whole => "whole",
    }
}

/// The earthquakes in a record; times from the first sample of its file. What stands beside `events` is of the strongest over its noise.
pub(super) fn earthquake(of: &Earthquake) -> Value {
    let found = &of.found;
    let part = |of: &Part| {
        json!({
            "from_s": of.span_s[0],
            "to_s": of.span_s[1],
            "modes": of.analysis.as_ref().map(|of| identified(&of.modes)),
        })
    };
    let mut all = event(found.strongest());
    all.insert("modes_of".into(), modes_of(of.modes_of).into());
    all.insert("events".into(), found.events.iter().map(event).collect());
    all.insert("before".into(), part(found.before()));
    all.insert("after".into(), part(found.after()));
    all.insert("parts".into(), found.quiet.iter().map(part).collect());
    all.insert("changes".into(), found.changes.iter().map(change).collect());
    all.insert("compared_parts".into(), json!(found.compared));
    all.into()
}

fn event(of: &StrongEvent) -> Map<String, Value> {
    let shaking = &of.shaking;
    let taken = match shaking.kind {
        ShakingKind::Earthquake => "earthquake",
        ShakingKind::EarthquakeOrTraffic => "earthquake_or_traffic",
    };
    let during = during(&of.during);
    let each = [
        ("taken_for", taken.into()),
        ("arrival_s", shaking.arrival_s.into()),
        ("strong_from_s", shaking.strong_from_s.into()),
        ("strong_to_s", shaking.strong_to_s.into()),
        ("end_s", shaking.end_s.into()),
        ("over_noise", shaking.over_noise.into()),
        ("growth", shaking.growth.into()),
        ("channels", of.channels.iter().map(channel).collect()),
        ("during", during),
        ("changes", of.changes.iter().map(change).collect()),
    ];
    each.into_iter()
        .map(|(key, value)| (key.to_owned(), value))
        .collect()
}

fn channel(of: &StrongChannel) -> Value {
    let at_least = of.at_least.map(|why| match why {
        AtLeast::Clipped => "clipped",
        AtLeast::Lost => "lost_samples",
        AtLeast::Edge => "edge_of_record",
    });
    json!({
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

fn change(of: &LastingChange) -> Value {
    json!({
        "before_hz": of.before_hz,
        "before_sd_hz": of.before_sd_hz,
        "after_hz": of.after_hz,
        "after_sd_hz": of.after_sd_hz,
        "change_ratio": of.ratio,
        "sd": of.ratio_sd,
        "beyond_chance": of.is_beyond_chance(),
    })
}

fn during(of: &During) -> Value {
    let window = |of: &TrackPoint| json!({ "at_s": of.at_s, "frequency_hz": of.frequency_hz, "frequency_sd_hz": of.frequency_sd_hz });
    let mode = |hz: f64, sd: Option<f64>, zeta: Option<f64>, zeta_sd: Option<f64>| json!({ "frequency_hz": hz, "frequency_sd_hz": sd, "damping_ratio": zeta, "damping_ratio_sd": zeta_sd });
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
    json!({ "how": how, "modes": modes, "windows": windows })
}
