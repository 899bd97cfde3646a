//! A simulated motion of a chain: ground motion, rotations of links, loops of moment and rotation, openings, slips, energy.

use super::frame_histories::{ground, loops, rows_of_bands};
use super::history_series::{band_series, history_series, loop_series};
use super::identification::{Figure, drawn};
use super::lines::{Lines, Series};
use super::words::{Axes, Signs, Titles, say};
use dolmen::dynamics::ChainEnergy;
use dolmen::structure::SideSupport;
use dolmen_words::Language;
use dolmen_words::number;
use dolmen_work::chain::ChainSimulation;

/// A figure of a simulated chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ChainPlot {
    Ground,
    Rotations,
    /// Moment against rotation of a joint, 0 the lowest.
    Loop(usize),
    Openings,
    Slips,
    /// Forces of side supports.
    Supports,
    Energy,
}

impl ChainPlot {
    /// The figures of a simulation, in order.
    pub(crate) fn all(simulation: &ChainSimulation) -> Vec<Self> {
        let history = &simulation.history;
        let mut all = Vec::new();
        all.extend(simulation.motion.as_ref().map(|_| Self::Ground));
        all.push(Self::Rotations);
        all.extend((0..simulation.links.len()).map(Self::Loop));
        all.extend((!history.uplifts.is_empty()).then_some(Self::Openings));
        all.extend((!history.slips.is_empty()).then_some(Self::Slips));
        all.extend((!history.support_force_n.is_empty()).then_some(Self::Supports));
        all.push(Self::Energy);
        all
    }

    fn name(self) -> String {
        match self {
            Self::Ground => "ground".to_owned(),
            Self::Rotations => "rotations".to_owned(),
            Self::Loop(joint) => format!("loop-{}", joint + 1),
            Self::Openings => "openings".to_owned(),
            Self::Slips => "slips".to_owned(),
            Self::Supports => "supports".to_owned(),
            Self::Energy => "energy".to_owned(),
        }
    }

    /// Its SVG; `None` without a sample.
    pub(crate) fn draw(self, simulation: &ChainSimulation, language: Language) -> Option<String> {
        match self {
            Self::Ground | Self::Rotations | Self::Supports | Self::Energy => {
                self.lines(simulation, language)?.draw(language)
            }
            Self::Loop(joint) => Some(hysteresis(simulation, joint, language)),
            Self::Openings => Some(openings(simulation, language)),
            Self::Slips => Some(slips(simulation, language)),
        }
    }

    /// The numbers of the figure.
    pub(crate) fn series(self, simulation: &ChainSimulation) -> Vec<crate::document::Series> {
        match self {
            Self::Ground | Self::Rotations | Self::Supports | Self::Energy => {
                history_series(|language| self.lines(simulation, language))
            }
            Self::Loop(joint) => loop_series(LOOP, across_and_moment(simulation, joint)),
            Self::Openings => band_series(&simulation.links, &opened(simulation)),
            Self::Slips => band_series(&simulation.links, &slipped(simulation)),
        }
    }

    /// The figures with lines over time.
    fn lines(self, simulation: &ChainSimulation, language: Language) -> Option<Lines> {
        match self {
            Self::Ground => {
                let (motion, component) = simulation.motion.as_ref()?;
                Some(Lines {
                    axis: Axes::Acceleration,
                    title: Titles::AccelerationOfTheGround,
                    lines: vec![ground(&motion.motion, *component)],
                })
            }
            Self::Rotations => Some(rotations(simulation)),
            Self::Supports => Some(supports(simulation)),
            Self::Energy => Some(energy(simulation, language)),
            Self::Loop(_) | Self::Openings | Self::Slips => None,
        }
    }
}

/// The figures of a simulation: ground, rotations, one loop per joint, bands of opening and slipping, energy.
pub fn chain_histories(simulation: &ChainSimulation, language: Language) -> Vec<Figure> {
    let all = ChainPlot::all(simulation).into_iter();
    drawn(all.map(|plot| (plot.name(), plot.draw(simulation, language))))
}

fn rotations(simulation: &ChainSimulation) -> Lines {
    let history = &simulation.history;
    let over_time = |values: &[f64]| -> Vec<[f64; 2]> {
        let pairs = history.times_s.iter().zip(values);
        pairs.map(|(t, y)| [*t, 1e3 * y]).collect()
    };
    let links: Vec<Series> = (0..simulation.links.len())
        .map(|link| Series {
            name: simulation.link(link).to_owned(),
            points: over_time(&history.rotation_rad[link]),
        })
        .collect();
    Lines {
        axis: Axes::LinkRotation,
        title: Titles::RotationOfTheLinksFromTheVertical,
        lines: links,
    }
}

fn supports(simulation: &ChainSimulation) -> Lines {
    let history = &simulation.history;
    let supports = simulation.model.chain().side_supports().iter();
    let line = |(support, forces): (&SideSupport, &Vec<f64>)| Series {
        name: format!("{} m", number::significant(support.height_m, 3)),
        points: history
            .times_s
            .iter()
            .zip(forces)
            .map(|(t, force)| [*t, 1e-3 * force])
            .collect(),
    };
    Lines {
        axis: Axes::Force,
        title: Titles::ForceOfTheSideSupports,
        lines: supports.zip(&history.support_force_n).map(line).collect(),
    }
}

/// The axes of a loop.
const LOOP: [Axes; 2] = [Axes::RotationAcrossTheJoint, Axes::Moment];

/// Rotation across a joint, mrad, and its moment, kN·m.
fn across_and_moment(simulation: &ChainSimulation, joint: usize) -> [Vec<f64>; 2] {
    let history = &simulation.history;
    [
        history.across_rad(joint).iter().map(|x| 1e3 * x).collect(),
        history.joint_moment_n_m[joint].iter().map(|x| 1e-3 * x).collect(),
    ]
}

fn hysteresis(simulation: &ChainSimulation, joint: usize, language: Language) -> String {
    let [across, moment] = across_and_moment(simulation, joint);
    let title = Titles::MomentAgainstRotation;
    loops(
        LOOP,
        [&across, &moment],
        (joint, simulation.link(joint)),
        title,
        language,
    )
}

/// When each joint was open, s.
fn opened(simulation: &ChainSimulation) -> Vec<(usize, [f64; 2])> {
    let each = simulation.history.uplifts.iter();
    each.map(|u| (u.joint, [u.from_s, u.to_s])).collect()
}

/// Times in which each joint slipped against its friction, s.
fn slipped(simulation: &ChainSimulation) -> Vec<(usize, [f64; 2])> {
    let each = simulation.history.slips.iter();
    each.map(|s| (s.joint, [s.from_s, s.to_s])).collect()
}

fn openings(simulation: &ChainSimulation, language: Language) -> String {
    let open = opened(simulation);
    let words = (Signs::Open, Titles::WhenJointsOpen);
    rows_of_bands(&simulation.links, &open, simulation.duration_s(), words, language)
}

fn slips(simulation: &ChainSimulation, language: Language) -> String {
    let slips = slipped(simulation);
    let words = (Signs::Turns, Titles::WhenJointsTurned);
    rows_of_bands(
        &simulation.links,
        &slips,
        simulation.duration_s(),
        words,
        language,
    )
}

fn energy(simulation: &ChainSimulation, language: Language) -> Lines {
    let history = &simulation.history;
    let part = |name: Signs, value: fn(&ChainEnergy) -> f64| Series {
        name: say(name, language),
        points: history
            .times_s
            .iter()
            .zip(&history.energy)
            .map(|(t, energy)| [*t, 1e-3 * value(energy)])
            .collect(),
    };
    let mut parts = vec![
        part(Signs::PutIn, |e| e.input_j),
        part(Signs::TakenByDashpots, |e| e.damping_j),
        part(Signs::MovingSpringsAndWeight, |e| {
            e.kinetic_j + e.springs_j + e.gravity_j
        }),
    ];
    if simulation.model.has_friction() {
        parts.push(part(Signs::TakenByFriction, |e| e.friction_j));
    }
    Lines {
        axis: Axes::Energy,
        title: Titles::WhereTheEnergyWent,
        lines: parts,
    }
}
