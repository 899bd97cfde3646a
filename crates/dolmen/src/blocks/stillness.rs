//! Decides when a stack has come to rest, so that a run may end.
//!
//! A stack is at rest when no joint moves and no centroid is near the edge of its support. After the shaking, contacts only dissipate
//! energy. Therefore a stack that rocks with decreasing amplitude for ten seconds, with every stone far from its edge, will not fall
//! either.

use super::history::StackHistory;

/// Time without joint motion that counts as rest, s, divided into `PARTS` intervals; the observed time is up to one interval longer.
/// Our choice: half a second shows rocking of 0.1 mm, except within 0.001 rad of the unstable position, which [`EDGE`] excludes.
const STILL_S: f64 = 0.5;
const PARTS: usize = 5;
/// Range of opening, slip or twist above which a joint moves, m: 0.1 mm, as for uplift. Our choice: elastic vibration of the contact
/// springs is smaller.
const STILL_M: f64 = StackHistory::UPLIFT_LEAST_M;
/// Smallest distance of a stone from its edge at rest, as a fraction of that distance in the upright position. Our choice.
pub(super) const EDGE: f64 = 0.01;
/// Interval for the comparison of rocking amplitudes, s: about one oscillation of a stone 6 m high. Our choice.
const SWING_S: f64 = 5.0;
/// Smallest distance of every stone from its edge, as a fraction of that in the upright position, for decaying rocking. Our choice: a
/// stone that leans by half of its overturning angle has three quarters of the energy to overturn, and gains no energy.
const SWINGS_LEFT: f64 = 0.5;

/// Smallest and largest value of opening, both slips and twist of a joint, m.
type Range = [[f64; 2]; 4];
const NOTHING: Range = [[f64::INFINITY, f64::NEG_INFINITY]; 4];

/// Recent motion of the joints.
#[derive(Clone, Debug)]
pub(super) struct Stillness {
    began_s: f64,
    /// The range of each joint, for the current interval and the intervals before it.
    parts: [Vec<Range>; PARTS + 1],
}

impl Stillness {
    pub(super) fn of(joints: usize) -> Self {
        Stillness {
            began_s: 0.0,
            parts: std::array::from_fn(|_| vec![NOTHING; joints]),
        }
    }

    /// Sets the time of an observation; begins a new interval when the current one is over.
    pub(super) fn at(&mut self, time_s: f64) {
        if time_s - self.began_s >= STILL_S / PARTS as f64 {
            self.began_s = time_s;
            self.parts.rotate_right(1);
            self.parts[0].fill(NOTHING);
        }
    }

    /// Records opening, slips and twist of a joint, m.
    pub(super) fn see(&mut self, joint: usize, places: [f64; 4]) {
        for ([least, largest], place) in self.parts[0][joint].iter_mut().zip(places) {
            *least = least.min(place);
            *largest = largest.max(place);
        }
    }

    /// The joint with the largest motion, if this exceeds the limit.
    pub(super) fn moving_joint(&self) -> Option<usize> {
        let (way, joint) = self.farthest()?;
        (way > STILL_M).then_some(joint)
    }

    /// Largest motion of any joint over the observed time, m, and the index of the joint.
    pub(super) fn farthest(&self) -> Option<(f64, usize)> {
        let mut found: Option<(f64, usize)> = None;
        for joint in 0..self.parts[0].len() {
            for place in 0..NOTHING.len() {
                let ends = self.parts.iter().map(|part| part[joint][place]);
                let [least, largest] = ends.fold(NOTHING[0], |[least, largest], end| {
                    [least.min(end[0]), largest.max(end[1])]
                });
                if largest - least > found.map_or(0.0, |(most, _)| most) {
                    found = Some((largest - least, joint));
                }
            }
        }
        found
    }
}

/// Rocking amplitude of a stack after the shaking, interval by interval.
#[derive(Clone, Debug)]
pub(super) struct Swings {
    began_s: Option<f64>,
    now: Swing,
    before: Option<Swing>,
    dies_down: bool,
}

/// Largest motion of any joint, m, and least distance of any stone from its edge, as a fraction.
#[derive(Clone, Copy, Debug)]
struct Swing {
    way: f64,
    margin_ratio: f64,
}

impl Swing {
    const NONE: Self = Swing {
        way: 0.0,
        margin_ratio: f64::INFINITY,
    };
}

impl Swings {
    pub(super) fn none() -> Self {
        Swings {
            began_s: None,
            now: Swing::NONE,
            before: None,
            dies_down: false,
        }
    }

    /// Records the motion and the distance from the edge at a time after the shaking.
    pub(super) fn see(&mut self, time_s: f64, way: f64, margin_ratio: f64) {
        let began_s = *self.began_s.get_or_insert(time_s);
        self.now.way = self.now.way.max(way);
        self.now.margin_ratio = self.now.margin_ratio.min(margin_ratio);
        if time_s - began_s >= SWING_S {
            let (before, now) = (self.before, self.now);
            self.dies_down = before.is_some_and(|before| {
                now.way <= before.way && before.margin_ratio.min(now.margin_ratio) >= SWINGS_LEFT
            });
            (self.before, self.now, self.began_s) = (Some(now), Swing::NONE, Some(time_s));
        }
    }

    /// Whether the rocking amplitude decreases while every stone is far from its edge.
    pub(super) fn die_down(&self) -> bool {
        self.dies_down
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_joint_that_moved_within_half_a_second_moves() {
        let mut stillness = Stillness::of(2);
        let mut look = |time_s: f64, opening: f64| {
            stillness.at(time_s);
            stillness.see(0, [0.01; 4]);
            stillness.see(1, [opening, 0.0, 0.0, 0.0]);
            stillness.moving_joint()
        };
        assert_eq!(look(0.0, 0.0), None);
        assert_eq!(look(0.2, 2e-4), Some(1));
        for i in 0..60 {
            let time_s = 0.21 + 0.02 * f64::from(i);
            let moving = look(time_s, 2e-4);
            if time_s < 0.6 {
                assert_eq!(moving, Some(1), "{time_s}");
            }
            if time_s > 0.85 {
                assert_eq!(moving, None, "{time_s}");
            }
        }
    }

    #[test]
    fn holds_swings_die_down_only_far_from_the_edge() {
        let swings = |way: fn(f64) -> f64, margin: fn(f64) -> f64| {
            let mut swings = Swings::none();
            let ends = (0..=112).map(|i| {
                let time_s = 3.0 + 0.1 * f64::from(i);
                swings.see(time_s, way(time_s), margin(time_s));
                swings.die_down()
            });
            ends.collect::<Vec<bool>>()
        };
        let down = swings(|t| 0.1 / t, |_| 0.6);
        assert!(!down[99] && down[112]);
        assert!(!swings(|t| 0.1 * t, |_| 0.6)[112]);
        assert!(!swings(|t| 0.1 / t, |t| if t < 4.0 { 0.4 } else { 0.9 })[112]);
    }
}
