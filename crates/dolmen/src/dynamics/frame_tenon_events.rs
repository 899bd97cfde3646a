//! Events of the tenons of a storey within a step: contact, opening, crushing and its end.

use super::frame_tenon::{Joint, TenonChange, Touch};
use crate::numeric::{COEFFICIENTS_MOST, first_descent};

/// Fraction of the largest motion of the storey's levels within the step below which a distance from a limit, or its rate, counts as
/// rounding; the first larger rate decides. The force is continuous at each change, so that rate is the same before and after it.
const ROUNDING: f64 = 1e-12;

/// The first change of a storey's tenons within a step and its time, from the coefficients of the drift. `moved_m` bounds the motion of the
/// two levels of the storey.
pub(super) fn tenon_event(joint: &Joint, drift: &[f64], moved_m: f64) -> Option<(TenonChange, f64)> {
    let reaches = |sign: f64, at_m: f64| {
        // s δ − at becomes positive
        let mut c = [0.0; COEFFICIENTS_MOST];
        let c = &mut c[..drift.len()];
        for (c, drift) in c.iter_mut().zip(drift) {
            *c = -sign * drift;
        }
        c[0] += at_m;
        at_limit(c, moved_m.max(at_m.abs()));
        first_descent(c, 0.0)
    };
    let bears = |sign: f64| Some((TenonChange::Bears(sign), reaches(sign, joint.face(sign).gap_m)?));
    match joint.touch {
        Touch::Free => earlier(bears(1.0), bears(-1.0)),
        Touch::Bearing(sign) => {
            let face = joint.face(sign);
            let opens = reaches(-sign, -face.gap_m).map(|sigma| (TenonChange::Opens, sigma));
            let crushes = joint.law.crushing_force_n.and_then(|most_n| {
                let sigma = reaches(sign, face.gap_m + most_n / face.stiffness_n_m)?;
                Some((TenonChange::Crushes, sigma))
            });
            earlier(opens, crushes)
        }
        Touch::Crushing(sign) => {
            let mut c = [0.0; COEFFICIENTS_MOST];
            let c = &mut c[..drift.len() - 1];
            let mut power = 0.0;
            for (c, drift) in c.iter_mut().zip(&drift[1..]) {
                power += sign;
                *c = power * drift;
            }
            at_limit(c, moved_m);
            first_descent(c, 0.0).map(|sigma| (TenonChange::Stops, sigma))
        }
    }
}

/// Sets a distance below rounding to zero, and also the rates before the first larger rate.
fn at_limit(c: &mut [f64], largest: f64) {
    for c in c {
        if c.abs() > ROUNDING * largest {
            break;
        }
        *c = 0.0;
    }
}

fn earlier(a: Option<(TenonChange, f64)>, b: Option<(TenonChange, f64)>) -> Option<(TenonChange, f64)> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b.1 < a.1 { b } else { a }),
        (one, None) | (None, one) => one,
    }
}
