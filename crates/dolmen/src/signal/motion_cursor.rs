//! Evaluates a ground motion at successive times.

use super::ground_motion::{Component, GroundMotion};

/// Evaluates a motion at times that mostly stay within one step. The results equal [`GroundMotion::acceleration_at_m_s2`]
/// bit for bit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MotionCursor<'a> {
    motion: &'a GroundMotion,
    /// The current step: its first sample, and the difference to the next.
    step: usize,
    first: [f64; 3],
    way: [f64; 3],
}

impl<'a> MotionCursor<'a> {
    pub(crate) fn of(motion: &'a GroundMotion) -> Self {
        MotionCursor {
            motion,
            step: usize::MAX,
            first: [0.0; 3],
            way: [0.0; 3],
        }
    }

    #[inline]
    pub(crate) fn acceleration_at_m_s2(&mut self, time_s: f64) -> [f64; 3] {
        let motion = self.motion;
        if !(time_s >= 0.0 && time_s <= motion.duration_s()) {
            return [0.0; 3];
        }
        let steps = time_s / motion.time_step_s();
        let step = (steps as usize).min(motion.length() - 2);
        if step != self.step {
            self.go_to(step);
        }
        let part = (steps - step as f64).min(1.0);
        let ([x, y, z], [way_x, way_y, way_z]) = (self.first, self.way);
        [x + part * way_x, y + part * way_y, z + part * way_z]
    }

    #[inline(never)]
    fn go_to(&mut self, step: usize) {
        self.step = step;
        for (direction, component) in Component::ALL.into_iter().enumerate() {
            let samples = self.motion.acceleration_m_s2(component);
            self.first[direction] = samples[step];
            self.way[direction] = samples[step + 1] - samples[step];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_cursor_has_the_bits_of_the_motion() {
        let wave = |part: f64| (0..40).map(|i| (f64::from(i) * part).sin()).collect::<Vec<f64>>();
        let series = vec![(Component::X, wave(0.7)), (Component::Z, wave(1.1))];
        let motion = GroundMotion::new("waves", 0.01, series).unwrap();
        let mut cursor = MotionCursor::of(&motion);
        for i in -3..1200 {
            let time_s = f64::from(i) * 3.571e-4;
            assert_eq!(
                cursor.acceleration_at_m_s2(time_s),
                motion.acceleration_at_m_s2(time_s),
                "{time_s}"
            );
        }
        assert_eq!(
            cursor.acceleration_at_m_s2(0.39),
            motion.acceleration_at_m_s2(0.39)
        );
        assert_eq!(cursor.acceleration_at_m_s2(0.0), motion.acceleration_at_m_s2(0.0));
    }
}
