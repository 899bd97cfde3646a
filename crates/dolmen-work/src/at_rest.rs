//! Checks that a structure has come to rest after a motion, before the next one.

use dolmen::blocks::StackHistory;
use dolmen::dynamics::{ChainHistory, ChainModel, FrameHistory};

/// Largest speed of a structure at rest between two motions, m/s. Our choice: a hundredth of the peak velocity of weak shaking.
pub const SPEED_AT_REST_M_S: f64 = 1e-3;
/// Longest time for a structure to come to rest, s. Our choice: at 1 Hz and a damping ratio of 0.5 % a motion of 1 m/s falls below that speed.
pub(crate) const WAIT_MOST_S: f64 = 320.0;
/// Time before the end of a run in which speeds are examined, s: for stacks the time in which joints must be still, otherwise a period of 0.2 Hz.
const STILL_S: f64 = 0.5;
const SWING_S: f64 = 5.0;

/// State at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AtRest {
    /// Time of the end, s.
    pub(crate) end_s: f64,
    /// Largest speed of any part relative to the ground shortly before, m/s.
    pub(crate) speed_m_s: f64,
}

impl AtRest {
    /// Combines two ends: the later time and the larger speed.
    pub(crate) fn worse(self, other: AtRest) -> AtRest {
        AtRest {
            end_s: self.end_s.max(other.end_s),
            speed_m_s: self.speed_m_s.max(other.speed_m_s),
        }
    }

    /// The end of a stack, from the centroids of its stones.
    pub(crate) fn of_stack(history: &StackHistory) -> AtRest {
        let times = &history.time_s;
        let end_s = times.last().copied().unwrap_or(0.0);
        let mut speed_m_s = 0.0_f64;
        for sample in (1..times.len())
            .rev()
            .take_while(|i| times[i - 1] >= end_s - STILL_S)
        {
            let took_s = times[sample] - times[sample - 1];
            for block in 0..history.blocks {
                let [now, before] = [sample, sample - 1].map(|at| history.pose(at, block).centroid_m);
                let moved = now.iter().zip(before).map(|(now, before)| (now - before).powi(2));
                speed_m_s = speed_m_s.max(moved.sum::<f64>().sqrt() / took_s);
            }
        }
        AtRest { end_s, speed_m_s }
    }

    /// The end of a frame, from its levels.
    pub(crate) fn of_frame(history: &FrameHistory) -> AtRest {
        let end_s = history.duration_s;
        let from = history.time_s.partition_point(|time| *time < end_s - SWING_S);
        let levels = history.velocity_m_s.iter();
        let speeds = levels.flat_map(|level| level.iter().skip(from));
        AtRest {
            end_s,
            speed_m_s: speeds.fold(0.0, |most, speed| f64::max(most, speed.abs())),
        }
    }

    /// The end of a chain in one plane, from the tops of its links.
    pub(crate) fn of_chain(model: &ChainModel, history: &ChainHistory) -> AtRest {
        let end_s = history.times_s.last().copied().unwrap_or(0.0);
        let from = history.times_s.partition_point(|time| *time < end_s - SWING_S);
        let mut speed_m_s = 0.0_f64;
        for sample in from..history.times_s.len() {
            let mut top = [0.0; 2];
            for (link, of) in model.chain().links().iter().enumerate() {
                let (sin, cos) = history.rotation_rad[link][sample].sin_cos();
                let rate = history.velocity_rad_s[link][sample];
                top = [
                    top[0] + of.length_m * cos * rate,
                    top[1] + of.length_m * sin * rate,
                ];
                speed_m_s = speed_m_s.max(top[0].hypot(top[1]));
            }
        }
        AtRest { end_s, speed_m_s }
    }

    /// Whether it is at rest.
    pub(crate) fn is_at_rest(&self) -> bool {
        self.speed_m_s <= SPEED_AT_REST_M_S
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_the_worse_of_two_runs_counts() {
        let of = |end_s, speed_m_s| AtRest { end_s, speed_m_s };
        assert_eq!(of(3.0, 2e-3).worse(of(5.0, 1e-4)), of(5.0, 2e-3));
        assert!(
            of(1.0, 1e-3).is_at_rest() && !of(1.0, 1.1e-3).is_at_rest() && !of(1.0, f64::NAN).is_at_rest()
        );
    }
}
