//! Limits of a part in the plane of horizontal accelerations: half planes.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x | `x` | horizontal acceleration of inertia forces (F = m x) | m/s² |
//! | l | `lever` | reduction of the reserve per unit of acceleration | N m or N per m/s² |
//! | s | `reserve` | reserve without horizontal acceleration | N m or N |

use super::Threshold;

/// The half plane l · x ≤ s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HalfPlane {
    pub(super) lever: [f64; 2],
    pub(super) reserve: f64,
}

impl HalfPlane {
    /// Smallest acceleration on its boundary, s / |l|; infinite if no acceleration reaches it.
    pub(super) fn distance(&self) -> f64 {
        let lever = self.lever[0].hypot(self.lever[1]);
        if lever > 0.0 {
            self.reserve / lever
        } else {
            f64::INFINITY
        }
    }

    /// Acceleration along a unit vector at which the boundary is reached; infinite if the direction
    /// leads away from it.
    pub(super) fn along(&self, direction: [f64; 2]) -> f64 {
        let loses = self.lever[0] * direction[0] + self.lever[1] * direction[1];
        let lever = self.lever[0].hypot(self.lever[1]);
        if loses > 1e-12 * lever {
            self.reserve / loses
        } else {
            f64::INFINITY
        }
    }

    /// The point of the boundary with the smallest acceleration.
    pub(super) fn threshold(&self, gravity: f64) -> Threshold {
        let lever = self.lever[0].hypot(self.lever[1]);
        let direction = if lever > 0.0 {
            [self.lever[0] / lever, self.lever[1] / lever]
        } else {
            [1.0, 0.0]
        };
        Threshold::new(self.distance(), gravity, direction)
    }
}

/// Position of the minimum of a unimodal f on an interval, by golden sections.
pub(super) fn least_on(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - ratio * (high - low), low + ratio * (high - low));
    let (mut at_a, mut at_b) = (f(a), f(b));
    for _ in 0..48 {
        // 48 sections: 1e-10 of the interval, where f is flat
        if at_a <= at_b {
            high = b;
            (b, at_b) = (a, at_a);
            a = high - ratio * (high - low);
            at_a = f(a);
        } else {
            low = a;
            (a, at_a) = (b, at_b);
            b = low + ratio * (high - low);
            at_b = f(b);
        }
    }
    if at_a <= at_b { a } else { b }
}
