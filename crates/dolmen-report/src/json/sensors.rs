//! A plan for sensors as JSON.

use crate::as_json;
use dolmen_work::sensors::{Axis, SensorsAnswer, SensorsOf, Side};
use serde_json::Value;

/// The whole plan.
pub fn sensors_json(answer: &SensorsAnswer) -> Value {
    let sensors = answer.sensors.iter().map(|sensor| {
        let axes = sensor.site.axes.iter().map(|axis| match axis {
            Axis::InPlane => "in_plane",
            other => other.key().unwrap_or_default(),
        });
        as_json!({
            "part": sensor.site.part,
            "place": place(sensor.site.side),
            "position_m": sensor.site.position_m,
            "axes": axes.collect::<Vec<_>>(),
            "setup": sensor.setup.map(|setup| setup + 1),
        })
    });
    let modes = answer.modes.iter().map(|mode| {
        as_json!({
            "frequency_hz": mode.frequency_hz,
            "direction": mode.direction,
            "energy_along": mode.along,
            "seen_ratio": mode.seen_ratio,
            "is_hardly_seen": mode.is_hardly_seen(),
            "most_alike": mode.most_alike.map(|(other, mac)| as_json!({ "mode": other + 1, "mac": mac })),
        })
    });
    as_json!({
        "file": answer.file,
        "name": { "en": answer.project.name.english(), "ko": answer.project.name.korean() },
        "places": answer.sites,
        "setups": answer.setups,
        "up_to_m": answer.up_to_m,
        "stiffness": match answer.of {
            SensorsOf::Given => "given",
            SensorsOf::EqualJoints => "equal_joints",
            SensorsOf::EqualStoreys => "equal_storeys",
        },
        "sensors": sensors.collect::<Vec<_>>(),
        "modes": modes.collect::<Vec<_>>(),
        "mac": answer.likeness,
        "without_dampers": answer.without_dampers,
    })
}

fn place(side: Side) -> String {
    match side {
        Side::Top => "top".to_owned(),
        Side::Right => "side +x".to_owned(),
        Side::Left => "side -x".to_owned(),
        Side::Back => "side +y".to_owned(),
        Side::Front => "side -y".to_owned(),
        Side::Corner(at) => format!("corner {}", at + 1),
    }
}
