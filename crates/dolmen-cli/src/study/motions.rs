//! Motions of a study: of the file, carried by the command, or made from a seed.

use crate::cli;
use crate::motion;
use anyhow::{Context as _, Result, bail};
use dolmen::signal::{Component, GroundMotion, Noise, intensity_measures, noise_motion};
use dolmen_formats::project::{Project, StudyPart};
use dolmen_formats::study::fingerprint;
use std::path::Path;

/// What motions that are made are called, before their number.
const MADE: &str = "noise";
/// Length of a sample of motions that are made, s.
const MADE_STEP_S: f64 = 0.01;

/// A motion as the file has it, with what its size is measured by.
#[derive(Clone, Debug)]
pub(super) struct PreparedMotion {
    pub(super) motion: GroundMotion,
    /// Largest horizontal component, m/s².
    pub(super) peak_m_s2: f64,
    /// Largest velocity of that component, m/s.
    pub(super) velocity_m_s: f64,
}

impl PreparedMotion {
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

    /// The motion times a factor, turned.
    pub(super) fn acting(&self, scale: f64, turn_rad: f64) -> Result<GroundMotion> {
        let scaled = self.motion.clone().scaled(scale)?;
        Ok(if turn_rad == 0.0 {
            scaled
        } else {
            scaled.rotated(turn_rad)?
        })
    }
}

/// The component that acts on what moves in one plane: x, or y if there is no other.
pub(super) fn acting_component(motion: &GroundMotion) -> Component {
    match (motion.has(Component::X), motion.has(Component::Y)) {
        (false, true) => Component::Y,
        _ => Component::X,
    }
}

/// Names of the motions in their order.
pub(super) fn motion_names(study: &StudyPart) -> Result<Vec<String>> {
    let mut names = study.motions.clone();
    if let Some(made) = &study.artificial {
        names.extend((1..=made.count).map(|number| format!("{MADE} {number}")));
    }
    if names.is_empty() {
        bail!(
            "the study names no motion: give motions = [\"el-centro-1940-ns\"] or artificial = {{ count = 22 }}"
        );
    }
    Ok(names)
}

/// A motion by its name.
pub(super) fn prepared(
    project: &Project,
    file: &Path,
    study: &StudyPart,
    name: &str,
) -> Result<PreparedMotion> {
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
        _ => motion::motion(&named(name), project, file)?.motion,
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
    let largest = largest.with_context(|| format!("motion \"{name}\" has no horizontal component"))?;
    let peak_m_s2 = motion.component_peak_m_s2(largest);
    let velocity_m_s = intensity_measures(&motion, largest)?.peak_velocity_m_s;
    Ok(PreparedMotion {
        motion,
        peak_m_s2,
        velocity_m_s,
    })
}

/// As if it had been typed.
fn named(name: &str) -> cli::Motion {
    cli::Motion {
        motion: Some(name.to_owned()),
        motion_file: Vec::new(),
        unit: None,
        sample_step: None,
        channel: None,
        factor: 1.0,
        shortest: false,
        ignore_stated_peak: false,
        x_azimuth: None,
        baseline: None,
        high_pass: None,
        keep_first: None,
        taper: None,
        turn: None,
        scale: None,
        peak: None,
    }
}
