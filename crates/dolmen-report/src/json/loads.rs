//! Wind and static loads as JSON.

use dolmen_work::loads::{CombinationAnswer, Combined, LoadsAnswer};
use serde_json::{Value, json};

/// The effect of wind and static loads.
pub(super) fn loads(answer: &LoadsAnswer) -> Value {
    let (wind, refused) = match &answer.wind {
        None => (None, None),
        Some(Ok(met)) => (Some(met), None),
        Some(Err(why)) => (None, Some(why.to_string())),
    };
    json!({
        "with_their_weight": answer.carried.map(|of| json!({
            "weight_n": of.weight_n,
            "load_factor": of.load_factor,
            "frequency_hz": of.frequency_hz,
        })),
        "verdict": answer.verdict(),
        "load_factor": answer.factor().filter(|factor| factor.is_finite()),
        "wind": wind,
        "wind_across": answer.wind_across,
        "wind_along": answer.frame_winds,
        "wind_refused": refused,
        "tilt_rad": answer.tilt_rad,
        "combinations": answer.combinations.iter().map(combination).collect::<Vec<_>>(),
    })
}

fn combination(of: &CombinationAnswer) -> Value {
    let mut value = json!({
        "name": of.name,
        "weight": of.weight,
        "wind": of.wind,
        "loads": of.loads,
        "verdict": of.verdict(),
        "load_factor": of.factor().filter(|factor| factor.is_finite()),
    });
    let own = match &of.of {
        Combined::Chain(chain) => json!({
            "wind_reversed": chain.wind_reversed,
            "weight_factor": chain.weight_factor.filter(|factor| factor.is_finite()),
            "under": chain.under,
            "across": chain.across,
        }),
        Combined::Frame(frame) => json!({
            "weight_factor": frame.weight_factor.filter(|factor| factor.is_finite()),
            "directions": frame.directions,
            "directions_unknown": frame.unknown,
        }),
        Combined::Stack(stack) => json!({
            "dilating_factor": stack.dilating_factor.filter(|factor| factor.is_finite()),
            "uncrushed_factor": stack.uncrushed_factor.filter(|factor| factor.is_finite()),
            "at_least": Some(stack.found.at_least).filter(|factor| factor.is_finite()),
            "grows": stack.grows,
            "wind_to": stack.wind_to,
            "blown": stack.blown,
            "mechanism": stack.found.mechanism,
        }),
    };
    if let (Value::Object(all), Value::Object(own)) = (&mut value, own) {
        all.extend(own);
    }
    value
}
