//! The simulation of a chain, with its input.

use crate::motion::MotionAnswer;
use crate::tilt_left_out::TiltLeftOut;
use crate::undamped::Undamped;
use dolmen::dynamics::{
    ChainGrowth, ChainHistory, ChainModel, ChainOutcome, ChainRotations, ChainRun, ChainSupportPeak,
};
use dolmen::signal::Component;
use dolmen::structure::SideSupport;
use dolmen_project::{ChainAxis, ChainLean, Names};

/// A side support of a chain in a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupportMet {
    /// The support.
    pub support: SideSupport,
    /// Largest displacement at it, and its force there.
    pub peak: ChainSupportPeak,
    /// Number of contacts.
    pub times: usize,
    /// Time of the first contact, s; `None` without one.
    pub first_s: Option<f64>,
}

/// The combined response of a chain in two planes under two components, at the samples that both have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainTogether {
    /// Largest lean of a link from the vertical, rad.
    pub lean_rad: f64,
    /// The link, 0 the lowest.
    pub link: usize,
    /// Time of this lean, s.
    pub at_s: f64,
    /// Largest displacement of the top relative to its foot, m.
    pub top_m: f64,
}

impl ChainTogether {
    /// Combines both planes of a chain; `None` without a sample. Small rotations add as vectors. For large ones, tan² of the lean is the
    /// sum of tan² in both planes.
    pub(crate) fn of(model: &ChainModel, histories: [&ChainHistory; 2]) -> Option<Self> {
        let is_small = model.rotations() == ChainRotations::Small;
        let lean = |each: [f64; 2]| match is_small {
            true => each[0].hypot(each[1]),
            false => each[0].tan().hypot(each[1].tan()).atan(),
        };
        let aside = |rotation_rad: f64| {
            if is_small {
                rotation_rad
            } else {
                rotation_rad.sin()
            }
        };
        let mut most: Option<ChainTogether> = None;
        let mut top_m = 0.0_f64;
        let both = histories[0].times_s.iter().zip(&histories[1].times_s);
        for (sample, (at_s, _)) in both.enumerate().take_while(|(_, (a, b))| a == b) {
            let mut top = [0.0; 2];
            for (link, of) in model.chain().links().iter().enumerate() {
                let each = histories.map(|history| history.rotation_rad[link][sample]);
                let lean_rad = lean(each);
                if most.is_none_or(|known| lean_rad > known.lean_rad) {
                    most = Some(ChainTogether {
                        lean_rad,
                        link,
                        at_s: *at_s,
                        top_m,
                    });
                }
                top = [0, 1].map(|axis| top[axis] + of.length_m * aside(each[axis]));
            }
            top_m = top_m.max(top[0].hypot(top[1]));
        }
        most.map(|most| ChainTogether { top_m, ..most })
    }
}

/// A simulation of a chain in one plane, and its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainSimulation {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// A longer name of the variant, if the file gives one.
    pub variant_title: Option<Names>,
    /// The direction, if each direction has its own run.
    pub direction: Option<ChainAxis>,
    /// The combined response; `None` for one component.
    pub together: Option<ChainTogether>,
    /// Names of the links, lowest first.
    pub links: Vec<String>,
    /// The chain.
    pub model: ChainModel,
    /// The motion of its base and the component that acts; `None` for a still ground.
    pub motion: Option<(MotionAnswer, Component)>,
    /// Angle by which the chain leaned at the start, rad.
    pub push_rad: f64,
    /// The lowest link that a push leans, from 0 at the bottom: joints below it are taken as rigid.
    pub pushed_from: usize,
    /// Options of the run.
    pub options: ChainRun,
    /// Lowest natural frequency upright, with every slider free, Hz; `None` if the chain is unstable.
    pub first_frequency_hz: Option<f64>,
    /// Growth of the lean; `None` if the chain is stable without shaking.
    pub growth: Option<ChainGrowth>,
    /// A note that it ran without viscous damping and friction; `None` if it has some.
    pub undamped: Option<Undamped>,
    /// The surveyed lean at the start of the run.
    pub lean: Option<ChainLean>,
    /// Weight of the static loads that it carries, N.
    pub carried_n: f64,
    /// Whether the file has forces, moments or a wind that do not act in the run.
    pub loads_left_out: bool,
    /// A surveyed tilt that the run does not start from.
    pub tilt_left_out: Option<TiltLeftOut>,
    /// The response.
    pub history: ChainHistory,
}

impl ChainSimulation {
    /// Largest acceleration of the ground, m/s²; 0 for a still one.
    pub fn peak_acceleration_m_s2(&self) -> f64 {
        self.motion.as_ref().map_or(0.0, |(motion, component)| {
            motion.motion.component_peak_m_s2(*component)
        })
    }

    /// The response at each side support.
    pub fn supports_met(&self) -> Vec<SupportMet> {
        let supports = self.model.chain().side_supports().iter();
        let peaks = supports.zip(&self.history.support_peaks).enumerate();
        let met = peaks.map(|(i, (support, peak))| {
            let mut touches = self.history.touches.iter().filter(|touch| touch.support == i);
            let times = touches.clone().count();
            SupportMet {
                support: *support,
                peak: *peak,
                times,
                first_s: touches.next().map(|touch| touch.from_s),
            }
        });
        met.collect()
    }

    /// Whether a link fell.
    pub fn falls(&self) -> bool {
        matches!(self.history.outcome, ChainOutcome::Fell { .. })
    }

    /// Whether it falls without any shaking: neither its springs nor friction support it.
    pub fn falls_by_itself(&self) -> bool {
        // posts with a gap may support a chain that falls by itself; the run shows whether they do
        let supports = self.model.chain().side_supports();
        let may_lean = !self.falls() && supports.iter().any(|support| !support.acts_linearly());
        self.first_frequency_hz.is_none() && !self.model.has_friction() && !may_lean
    }

    /// End of the run, s, if it is before that of the motion and no link fell: there is no verdict.
    pub fn ended_before_the_motion_s(&self) -> Option<f64> {
        let (motion, _) = self.motion.as_ref()?;
        let is_open = matches!(
            self.history.outcome,
            ChainOutcome::Stood | ChainOutcome::Uplifted { .. } | ChainOutcome::StillLeaning { .. }
        );
        motion.cut_at_s(self.options.duration_s?).filter(|_| is_open)
    }

    /// Whether the run is complete, with a verdict on falling.
    pub fn is_whole(&self) -> bool {
        !matches!(
            self.history.outcome,
            ChainOutcome::Stopped { .. } | ChainOutcome::StillLeaning { .. }
        ) && self.ended_before_the_motion_s().is_none()
    }

    /// Joints without a bed that can open, which transmit any moment in this run, and the bed width that the largest moment would need, m:
    /// 2 M / N.
    pub fn held_joints(&self) -> Vec<(usize, f64)> {
        let most = self.model.moment_most_n_m().iter().enumerate();
        let held = most.filter(|(_, most)| most.is_infinite());
        held.map(|(joint, _)| {
            let chain = self.model.chain();
            let mass_kg: f64 = chain.links()[joint..].iter().map(|link| link.mass_kg).sum();
            let weight_n = mass_kg * chain.gravity_m_s2();
            (joint, 2.0 * self.joint_moment_peak_n_m(joint) / weight_n)
        })
        .collect()
    }

    /// Joints whose bed opened on one side, beyond N b/6, but did not reach its edge at N b/2.
    pub fn opened_beds(&self) -> Vec<usize> {
        let each = self.model.moment_most_n_m().iter().enumerate();
        let opened = each.filter(|(joint, most)| {
            let moment = self.joint_moment_peak_n_m(*joint);
            most.is_finite() && moment > **most / 3.0 && moment < **most * (1.0 - 1e-9)
        });
        opened.map(|(joint, _)| joint).collect()
    }

    /// Duration of the run, s.
    pub fn duration_s(&self) -> f64 {
        self.history.times_s.last().copied().unwrap_or_default()
    }

    /// Name of a link, 0 the lowest.
    pub fn link(&self, link: usize) -> &str {
        self.links.get(link).map_or("", String::as_str)
    }

    /// Largest moment of a joint at the samples, from spring and friction, N m.
    pub fn joint_moment_peak_n_m(&self, joint: usize) -> f64 {
        let rows = &self.history.joint_moment_n_m[joint];
        rows.iter().fold(0.0, |most, moment| most.max(moment.abs()))
    }
}
