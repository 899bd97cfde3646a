//! Motions of a study: from the file, built-in, or made from a seed.

use super::error::StudyError;
use crate::error::WorkError;
use crate::fingerprint::fingerprint;
use crate::motion::{self, MotionRequest};
use dolmen::signal::{
    Component, GroundMotion, Noise, SignalError, SpectralOrdinate, intensity_measures, is_same_shaking,
    noise_motion, peak_velocity_m_s, response_spectrum,
};
use dolmen_project::{Project, StudyPart};
use dolmen_records::Files;

/// Prefix of the names of made motions, before their number.
const MADE: &str = "noise";
/// Length of a sample of made motions, s.
const MADE_STEP_S: f64 = 0.01;

/// A motion of the file, with the measures of its size.
#[derive(Clone, Debug)]
pub(super) struct PreparedMotion {
    pub(super) motion: GroundMotion,
    /// Largest horizontal component, m/s²; for motion in a plane, that of the plane.
    pub(super) peak_m_s2: f64,
    /// Largest velocity of that component, m/s.
    pub(super) velocity_m_s: f64,
    component: Component,
}

/// A motion of a study that is a copy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MotionCopy {
    /// The motion.
    pub motion: String,
    /// The earlier motion.
    pub of: String,
}

impl PreparedMotion {
    /// Whether one of its components is a copy of one of another motion: the same samples, or scaled, inverted, cut or resampled.
    pub(super) fn is_copy_of(&self, other: &PreparedMotion) -> bool {
        let series = |motion: &'_ GroundMotion| {
            let horizontal = [Component::X, Component::Y].into_iter();
            let has = horizontal.filter(|component| motion.has(*component));
            has.collect::<Vec<_>>()
        };
        let (own, its) = (series(&self.motion), series(&other.motion));
        own.iter().any(|a| {
            its.iter().any(|b| {
                is_same_shaking(
                    (self.motion.acceleration_m_s2(*a), self.motion.time_step_s()),
                    (other.motion.acceleration_m_s2(*b), other.motion.time_step_s()),
                )
            })
        })
    }

    /// As it acts on a structure that moves in one plane, along a component if the motion has both: rotated, that component alone, with its
    /// size.
    pub(super) fn in_plane(&self, turn_rad: f64, along: Component) -> Result<Self, WorkError> {
        let motion = self.acting(1.0, turn_rad)?;
        let component = match motion.has(along) {
            true => along,
            false => acting_component(&motion),
        };
        let series = vec![(component, motion.acceleration_m_s2(component).to_vec())];
        let alone = GroundMotion::new(motion.name(), motion.time_step_s(), series)?;
        measured(alone, component)
    }

    /// Its largest vertical acceleration over the largest horizontal one; `None` without a vertical component.
    pub(super) fn vertical_over_peak(&self) -> Option<f64> {
        let vertical_m_s2 = self.motion.component_peak_m_s2(Component::Z);
        let has_vertical = self.motion.has(Component::Z);
        has_vertical.then_some(vertical_m_s2 / self.peak_m_s2)
    }

    /// Its axis if it shakes along one and is rotated; `None` if it shakes along several.
    pub(super) fn axis(&self, turn_rad: f64) -> Option<[f64; 2]> {
        let (sin, cos) = turn_rad.sin_cos();
        match [Component::X, Component::Y].map(|component| self.motion.has(component)) {
            [true, false] => Some([cos, sin]),
            [false, true] => Some([-sin, cos]),
            _ => None,
        }
    }

    /// Of every sample.
    pub(super) fn fingerprint(&self) -> String {
        let mut bytes = self.motion.time_step_s().to_le_bytes().to_vec();
        for component in Component::ALL {
            if self.motion.has(component) {
                bytes.extend(component.name().bytes());
                let samples = self.motion.acceleration_m_s2(component).iter();
                bytes.extend(samples.flat_map(|sample| sample.to_le_bytes()));
            }
        }
        fingerprint(&bytes)
    }

    /// Pseudo-spectral accelerations of that component relative to its peak.
    pub(super) fn spectral_over_peak(
        &self,
        periods_s: &[f64],
        damping_ratio: f64,
    ) -> Result<Vec<f64>, SignalError> {
        let found = response_spectrum(&self.motion, self.component, periods_s, damping_ratio)?;
        let each = found.iter().map(SpectralOrdinate::pseudo_acceleration_m_s2);
        Ok(each.map(|acceleration| acceleration / self.peak_m_s2).collect())
    }

    /// Time from 5 to 95 % of the Arias intensity of that component, s.
    pub(super) fn significant_duration_s(&self) -> Option<f64> {
        let found = intensity_measures(&self.motion, self.component).ok()?;
        Some(found.significant_duration_s)
    }

    /// The motion with a factor, rotated.
    pub(super) fn acting(&self, scale: f64, turn_rad: f64) -> Result<GroundMotion, WorkError> {
        let scaled = self.motion.clone().scaled(scale)?;
        Ok(if turn_rad == 0.0 {
            scaled
        } else {
            scaled.rotated(turn_rad)?
        })
    }
}

/// Motions that are copies of earlier ones, whatever the names of their files.
pub(super) fn copies(motions: &[(String, PreparedMotion)]) -> Vec<MotionCopy> {
    let each = motions.iter().enumerate().filter_map(|(at, (name, motion))| {
        let mut before = motions[..at].iter();
        let (of, _) = before.find(|(_, before)| motion.is_copy_of(before))?;
        Some(MotionCopy {
            motion: name.clone(),
            of: of.clone(),
        })
    });
    each.collect()
}

/// The component that acts on a structure that moves in one plane: x, or y if there is no other.
pub(crate) fn acting_component(motion: &GroundMotion) -> Component {
    match (motion.has(Component::X), motion.has(Component::Y)) {
        (false, true) => Component::Y,
        _ => Component::X,
    }
}

/// Names of the motions in their order.
pub(super) fn motion_names(study: &StudyPart) -> Result<Vec<String>, WorkError> {
    let mut names = study.motions.clone();
    if let Some(made) = &study.artificial {
        names.extend((1..=made.count).map(|number| format!("{MADE} {number}")));
    }
    if names.is_empty() {
        return Err(StudyError::StudyWithoutMotion.into());
    }
    Ok(names)
}

/// A motion by its name.
pub(super) fn prepared(
    project: &Project,
    files: &dyn Files,
    study: &StudyPart,
    name: &str,
) -> Result<PreparedMotion, WorkError> {
    let number = name
        .strip_prefix(MADE)
        .and_then(|rest| rest.trim().parse::<u64>().ok());
    let motion = match (&study.artificial, number) {
        (Some(made), Some(number)) if !study.motions.iter().any(|own| own == name) => {
            let options = Noise {
                duration_s: made.duration_s,
                rise_s: made.rise_s,
                strong_s: made.strong_s,
                time_step_s: MADE_STEP_S,
                ..Noise::default()
            };
            noise_motion(&options, made.seed.wrapping_add(number - 1))?
        }
        _ => motion::prepared(&MotionRequest::named(name), (project, files))?.motion,
    };
    let horizontal = [Component::X, Component::Y];
    let largest = horizontal
        .into_iter()
        .filter(|component| motion.has(*component))
        .max_by(|a, b| {
            motion
                .component_peak_m_s2(*a)
                .total_cmp(&motion.component_peak_m_s2(*b))
        });
    let largest = largest.ok_or_else(|| WorkError::NoHorizontalOf {
        name: name.to_owned(),
    })?;
    measured(motion, largest)
}

/// A motion with the size of one of its components.
fn measured(motion: GroundMotion, component: Component) -> Result<PreparedMotion, WorkError> {
    let velocity_m_s = peak_velocity_m_s(&motion, component)?;
    Ok(PreparedMotion {
        peak_m_s2: motion.component_peak_m_s2(component),
        velocity_m_s,
        component,
        motion,
    })
}
