//! What `dolmen simulate` found of a chain, with what went in.

use super::MotionAnswer;
use crate::project::Names;
use dolmen::dynamics::{ChainGrowth, ChainHistory, ChainModel, ChainOutcome, ChainRun};
use dolmen::signal::Component;

/// A simulation of a chain in one plane, and its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainSimulation {
    /// The project file, as it was named.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// A longer name of the variant, if the file gives one.
    pub variant_title: Option<Names>,
    /// Names of the links, lowest first.
    pub links: Vec<String>,
    /// The chain.
    pub model: ChainModel,
    /// The motion of its base and the component that acts; `None` for a still ground.
    pub motion: Option<(MotionAnswer, Component)>,
    /// Angle by which the whole chain leaned at the start, rad.
    pub push_rad: f64,
    /// Options of the run.
    pub options: ChainRun,
    /// Lowest natural frequency upright, with every slider free, Hz; `None` if it falls by itself.
    pub first_frequency_hz: Option<f64>,
    /// How fast it left the vertical; `None` if it stands by itself.
    pub growth: Option<ChainGrowth>,
    /// What happened.
    pub history: ChainHistory,
}

impl ChainSimulation {
    /// Largest acceleration of the ground, m/s²; 0 for a still one.
    pub fn peak_acceleration_m_s2(&self) -> f64 {
        self.motion.as_ref().map_or(0.0, |(motion, component)| {
            motion.motion.component_peak_m_s2(*component)
        })
    }

    /// Whether a link fell: exit status 1.
    pub fn falls(&self) -> bool {
        matches!(self.history.outcome, ChainOutcome::Fell { .. })
    }

    /// Whether the run came to an end that says whether it falls.
    pub fn is_whole(&self) -> bool {
        !matches!(
            self.history.outcome,
            ChainOutcome::Stopped { .. } | ChainOutcome::StillLeaning { .. }
        )
    }

    /// How long the run was, s.
    pub fn duration_s(&self) -> f64 {
        self.history.times_s.last().copied().unwrap_or_default()
    }

    /// Name of a link, 0 the lowest.
    pub fn link(&self, link: usize) -> &str {
        self.links.get(link).map_or("", String::as_str)
    }

    /// Largest moment of a joint at the samples, spring and friction, N m.
    pub fn joint_moment_peak_n_m(&self, joint: usize) -> f64 {
        let rows = &self.history.joint_moment_n_m[joint];
        rows.iter().fold(0.0, |most, moment| most.max(moment.abs()))
    }
}
