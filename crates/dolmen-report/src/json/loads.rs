//! Wind and static loads as JSON.

use crate::as_json;
use dolmen_work::loads::{CombinationAnswer, Combined, LoadsAnswer, StoreyCombined};
use serde_json::Value;

/// The effect of wind and static loads.
pub(super) fn loads(answer: &LoadsAnswer) -> Value {
    let (wind, refused) = match &answer.wind {
        None => (None, None),
        Some(Ok(met)) => (Some(met), None),
        Some(Err(why)) => (None, Some(why.to_string())),
    };
    as_json!({
        "with_their_weight": answer.carried.map(|of| as_json!({
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
    let mut value = as_json!({
        "name": of.name,
        "weight": of.weight,
        "wind": of.wind,
        "loads": of.loads,
        "verdict": of.verdict(),
        "load_factor": of.factor().filter(|factor| factor.is_finite()),
    });
    let own = match &of.of {
        Combined::Chain(chain) => as_json!({
            "wind_reversed": chain.wind_reversed,
            "weight_factor": chain.weight_factor.filter(|factor| factor.is_finite()),
            "under": chain.under,
            "across": chain.across,
        }),
        Combined::Frame(frame) => as_json!({
            "weight_factor": frame.weight_factor.filter(|factor| factor.is_finite()),
            "directions": frame.directions,
            "directions_unknown": frame.unknown,
        }),
        Combined::Building(building) => as_json!({
            "earthquake": building.earthquake,
            "weight_factor": Some(building.weight_factor).filter(|factor| factor.is_finite()),
            "storeys": building.storeys.iter().map(storey).collect::<Vec<_>>(),
            "largest_drift": building.largest().map(|of| as_json!({
                "floor": of.storey.floor,
                "axis": if of.axis == 0 { "x" } else { "y" },
                "drift_ratio": of.ratio,
            })),
            "drift_limit": building.drift_limit,
            "limit_over_drift": building.drift_margin(),
            "unknown": building.unknown,
        }),
        Combined::Stack(stack) => as_json!({
            "dilating_factor": stack.dilating_factor.filter(|factor| factor.is_finite()),
            "uncrushed_factor": stack.uncrushed_factor.filter(|factor| factor.is_finite()),
            "rigid_ground_factor": stack.rigid_ground_factor.filter(|factor| factor.is_finite()),
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

/// A floor and the storey below it, with the sum of its drifts over the height.
fn storey(of: &StoreyCombined) -> Value {
    let mut value = as_json!(of);
    if let Value::Object(all) = &mut value {
        all.insert("drift_ratio".to_owned(), as_json!(of.drift_ratios()));
    }
    value
}
