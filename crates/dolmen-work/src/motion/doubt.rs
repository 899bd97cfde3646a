//! Signs that a motion has a wrong unit, step or angle.

use super::acting::{MotionAnswer, TakenOff, base_line_drifts};
use super::answer::MotionSeries;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::{Component, GroundMotion, last_and_peak_displacement_m};
use dolmen_project::looks_like_radians;

/// A probable mistake in a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionDoubt {
    /// A file has a peak larger than that of almost any record.
    ReadStrong {
        /// The component.
        component: Component,
        /// Its peak, g.
        peak_g: f64,
    },
    /// A file has a peak that nobody would feel.
    ReadWeak {
        /// The component.
        component: Component,
        /// Its peak, g.
        peak_g: f64,
    },
    /// The acting motion is stronger than almost any record.
    ActsStrong {
        /// Its peak, g.
        peak_g: f64,
    },
    /// The acting motion would not be felt.
    ActsWeak {
        /// Its peak, g.
        peak_g: f64,
    },
    /// With this time step it oscillates too slowly or too fast for an earthquake.
    Step {
        /// The component.
        component: Component,
        /// The step, s.
        step_s: f64,
        /// Number of oscillations a second.
        swings_hz: f64,
    },
    /// The ground ends farther away than in any earthquake: the acceleration has an offset.
    Offset {
        /// The component.
        component: Component,
        /// Its displacement at the end, m.
        away_m: f64,
    },
    /// Its changes took off much of it.
    TakenOff(TakenOff),
    /// Its angle in degrees is a round multiple of π.
    TurnRadians {
        /// The angle, degrees.
        degrees: f64,
    },
}

/// Peak above which a motion is suspicious, g. Our choice: fewer than one in a thousand records of damaging earthquakes exceed it.
const STRONG_G: f64 = 1.5;
/// Peak of a file, and of an acting motion, below which it is suspicious, g. Our choice: people feel 0.003 g.
const READ_WEAK_G: f64 = 0.004;
const ACTS_WEAK_G: f64 = 0.0005;
/// Displacement of the ground at the end that no record has, m. Our choice: some metres beside a fault are the most.
const AWAY_M: f64 = 12.0;
/// Range of the mean frequency of zero crossings, Hz. Our choice: records of earthquakes have 0.5 to 25.
const SWINGS_HZ: [f64; 2] = [0.1, 32.0];

impl MotionAnswer {
    /// The doubts, each with its numbers.
    pub fn doubts(&self) -> Vec<MotionDoubt> {
        let mut doubts: Vec<MotionDoubt> = self
            .peaks_read_m_s2
            .iter()
            .filter_map(|(of, peak)| read(*of, *peak))
            .collect();
        let acting = [Component::X, Component::Y, Component::Z].map(|of| self.motion.component_peak_m_s2(of));
        let peak_g = acting.into_iter().fold(0.0, f64::max) / STANDARD_GRAVITY_M_S2;
        if doubts.is_empty() && peak_g > STRONG_G {
            doubts.push(MotionDoubt::ActsStrong { peak_g });
        } else if doubts.is_empty() && peak_g < ACTS_WEAK_G {
            doubts.push(MotionDoubt::ActsWeak { peak_g });
        }
        let given = self.files.iter().map(|(component, _)| *component);
        doubts.extend(given.filter_map(|component| step(&self.motion, component)));
        let far = self
            .drifting_m()
            .into_iter()
            .filter(|(_, away_m)| away_m.abs() > AWAY_M);
        doubts.extend(far.map(|(component, away_m)| MotionDoubt::Offset { component, away_m }));
        doubts.extend(self.taken_off.map(MotionDoubt::TakenOff));
        if let Some(degrees) = self
            .turned_rad
            .map(f64::to_degrees)
            .filter(|degrees| looks_like_radians(*degrees))
        {
            doubts.push(MotionDoubt::TurnRadians { degrees });
        }
        doubts
    }
}

impl MotionSeries {
    /// Signs of a wrong time step or an offset.
    pub fn doubts(&self) -> Vec<MotionDoubt> {
        let component = self.component;
        let end = last_and_peak_displacement_m(&self.motion, component).ok();
        let far =
            end.filter(|[last_m, peak_m]| last_m.abs() > AWAY_M && base_line_drifts([*last_m, *peak_m]));
        let offset = far.map(|[away_m, _]| MotionDoubt::Offset { component, away_m });
        step(&self.motion, component).into_iter().chain(offset).collect()
    }
}

fn read(component: Component, peak_m_s2: f64) -> Option<MotionDoubt> {
    let peak_g = peak_m_s2 / STANDARD_GRAVITY_M_S2;
    if peak_g > STRONG_G {
        Some(MotionDoubt::ReadStrong { component, peak_g })
    } else if peak_g > 0.0 && peak_g < READ_WEAK_G && component != Component::Z {
        Some(MotionDoubt::ReadWeak { component, peak_g })
    } else {
        None
    }
}

fn step(motion: &GroundMotion, component: Component) -> Option<MotionDoubt> {
    let samples = motion.acceleration_m_s2(component);
    let crossings = samples.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
    let swings_hz = 0.5 * crossings as f64 / motion.duration_s();
    let is_odd = crossings > 0 && !(SWINGS_HZ[0]..=SWINGS_HZ[1]).contains(&swings_hz);
    is_odd.then_some(MotionDoubt::Step {
        component,
        step_s: motion.time_step_s(),
        swings_hz,
    })
}
