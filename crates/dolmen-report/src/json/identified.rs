//! Identified modes as JSON.

use crate::as_json;
use dolmen::modal::{Accepted, Method, Mode, Modes, RefusedPeak};
use dolmen::signal::Channel;
use serde_json::Value;

/// Why a mode was accepted by the user.
fn accepted(frequency_hz: f64, of: &Accepted) -> Value {
    let refused = RefusedPeak {
        frequency_hz,
        refusal: of.refusal,
    };
    as_json!({ "asked_hz": of.asked_hz, "refused": refused.to_string() })
}

/// Identified modes; shapes as one [re, im] per channel.
pub(super) fn identified(modes: &Modes) -> Value {
    let finite = |x: f64| x.is_finite().then_some(x);
    // the noise floor is that of ambient vibration
    let has_floor = !matches!(modes.method, Method::Era | Method::Okid);
    let mode = |mode: &Mode| {
        as_json!({
            "frequency_hz": mode.frequency_hz,
            "frequency_sd_hz": mode.frequency_sd_hz,
            "damping_ratio": mode.damping_ratio,
            "damping_ratio_sd": mode.damping_ratio_sd,
            "shape": mode.shape.iter().map(|z| [z.re, z.im]).collect::<Vec<_>>(),
            "shape_sd": mode.shape_sd,
            "phase_collinearity": mode.phase_collinearity,
            "cycles": mode.cycles,
            "frequency_floor_hz": finite(mode.frequency_floor_hz()).filter(|_| has_floor),
            "damping_ratio_floor": finite(mode.damping_ratio.unwrap_or(f64::NAN) * mode.damping_floor()).filter(|_| has_floor),
            "orders": mode.orders,
            "kurtosis": mode.kurtosis.map(|k| k.kurtosis),
            "kurtosis_sd": mode.kurtosis.map(|k| k.deviation),
            "wander": mode.wander.map(|of| of.along),
            "wander_sd": mode.wander.map(|of| of.deviation),
            "harmonic": mode.harmonic(),
            "window_bias": mode.window_bias,
            "accepted": mode.accepted.map(|of| accepted(mode.frequency_hz, &of)),
        })
    };
    let channel =
        |c: &Channel| as_json!({ "name": c.name, "position_m": c.position_m, "direction": c.direction });
    as_json!({
        "method": modes.method.name(),
        "duration_s": modes.duration_s,
        "channels": modes.channels.iter().map(channel).collect::<Vec<_>>(),
        "modes": modes.modes.iter().map(mode).collect::<Vec<_>>(),
    })
}
