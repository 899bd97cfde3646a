//! The surveyed tilt of a frame, compared with the tilt at which it has fallen.

use super::lean::DirectionLean;
use crate::state::{DirectionCheck, TiltCheck};
use dolmen_project::FramePart;

/// Tilts of a frame, compared with those at which it has fallen, in each direction and together.
pub(crate) fn tilts(part: &FramePart, checks: &[DirectionCheck]) -> Vec<TiltCheck> {
    let Some(lean) = &part.lean else {
        return Vec::new();
    };
    let held_against = |direction: String, tilt: f64, share: Option<f64>| TiltCheck {
        survey: lean.survey.clone(),
        direction,
        tilt,
        uplift_tilt: share.map(|share| tilt.abs() / share),
        opens_tilt: None,
    };
    let leaning = part
        .directions
        .iter()
        .zip(checks)
        .filter(|(own, _)| part.tilt(&own.name) != 0.0);
    let mut all: Vec<TiltCheck> = leaning
        .map(|(own, check)| {
            let share = check.lean.as_ref().map(|lean| lean.worst().1);
            held_against(own.name.clone(), part.tilt(&own.name), share)
        })
        .collect();
    let leans: Vec<&DirectionLean> = checks.iter().filter_map(|check| check.lean.as_ref()).collect();
    if let ([first, second], [a, b]) = (all.as_slice(), leans.as_slice()) {
        let storeys = a.at_rest.iter().zip(&b.at_rest).zip(&a.most);
        let shares = storeys.map(|((a, b), most)| a.hypot(*b) / most);
        let share = shares.fold(0.0, f64::max);
        let direction = format!("{}+{}", first.direction, second.direction);
        // tilts in directions that the frame does not have count fully in each
        let tilt = first.tilt.hypot(second.tilt).min(lean.together);
        let share = share * tilt / first.tilt.hypot(second.tilt);
        all.push(held_against(direction, tilt, Some(share)));
    }
    all
}
