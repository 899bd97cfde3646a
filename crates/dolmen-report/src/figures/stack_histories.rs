//! Histories of a simulated motion: the ground, the top, and each joint.

use super::Figure;
use super::history_series::history_series;
use super::lines::{Lines, Series};
use super::words::{Axes, Titles, body_words};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Component;
use dolmen_words::Language;
use dolmen_work::stack::StackSimulation;

/// Largest number of joints in one plot: those with the largest values. More lines cannot be distinguished.
const JOINTS_MOST: usize = 5;

/// A figure of a simulated stack over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StackPlot {
    Ground,
    Top,
    Opening,
    Slip,
    Yaw,
}

impl StackPlot {
    /// All figures, in order.
    pub(crate) const ALL: [Self; 5] = [Self::Ground, Self::Top, Self::Opening, Self::Slip, Self::Yaw];

    fn name(self) -> &'static str {
        match self {
            Self::Ground => "ground",
            Self::Top => "top",
            Self::Opening => "opening",
            Self::Slip => "slip",
            Self::Yaw => "yaw",
        }
    }

    /// Its SVG; `None` without a sample.
    pub(crate) fn draw(self, simulation: &StackSimulation, language: Language) -> Option<String> {
        self.lines(simulation, language).draw(language)
    }

    /// The numbers of the figure.
    pub(crate) fn series(self, simulation: &StackSimulation) -> Vec<crate::document::Series> {
        history_series(|language| Some(self.lines(simulation, language)))
    }

    fn lines(self, simulation: &StackSimulation, language: Language) -> Lines {
        let (lines, axis, title) = match self {
            Self::Ground => (
                ground_series(simulation),
                Axes::Acceleration,
                Titles::AccelerationOfTheGround,
            ),
            Self::Top => (
                top_series(simulation),
                Axes::Displacement,
                Titles::DisplacementOfTheHighestStone,
            ),
            Self::Opening => (
                joint_series(simulation, language, |joint, sample| {
                    1e3 * joint.opening_m[sample]
                }),
                Axes::Opening,
                Titles::OpeningOfTheJoints,
            ),
            Self::Slip => (
                joint_series(simulation, language, |joint, sample| {
                    1e3 * joint.slip_m[sample][0].hypot(joint.slip_m[sample][1])
                }),
                Axes::Slip,
                Titles::SlipOfTheJoints,
            ),
            Self::Yaw => (
                joint_series(simulation, language, |joint, sample| 1e3 * joint.yaw_rad[sample]),
                Axes::Yaw,
                Titles::YawOfTheJoints,
            ),
        };
        Lines { axis, title, lines }
    }
}

/// The figures of a simulation over time: ground, top, and of the joints opening, slip and yaw.
pub fn stack_histories(simulation: &StackSimulation, language: Language) -> Vec<Figure> {
    let each = StackPlot::ALL.into_iter();
    each.filter_map(|plot| {
        let svg = plot.draw(simulation, language)?;
        Some(Figure {
            name: plot.name().to_owned(),
            svg,
        })
    })
    .collect()
}

fn ground_series(simulation: &StackSimulation) -> Vec<Series> {
    let motion = &simulation.motion.motion;
    let step = motion.time_step_s();
    let given = Component::ALL
        .into_iter()
        .filter(|component| motion.has(*component));
    given
        .map(|component| {
            let samples = motion.acceleration_m_s2(component).iter().enumerate();
            Series {
                name: component.name().to_owned(),
                points: samples
                    .map(|(i, a)| [i as f64 * step, a / STANDARD_GRAVITY_M_S2])
                    .collect(),
            }
        })
        .collect()
}

fn top_series(simulation: &StackSimulation) -> Vec<Series> {
    let moved = simulation.displacement_m(simulation.highest_block());
    let time_s = &simulation.history.time_s;
    let each = ["x", "y", "z"].into_iter().enumerate();
    each.map(|(axis, name)| Series {
        name: name.to_owned(),
        points: time_s
            .iter()
            .zip(&moved)
            .map(|(t, d)| [*t, 1e3 * d[axis]])
            .collect(),
    })
    .collect()
}

/// The joints with the largest values, largest first.
fn joint_series(
    simulation: &StackSimulation,
    language: Language,
    value: impl Fn(&dolmen::blocks::JointHistory, usize) -> f64,
) -> Vec<Series> {
    let time_s = &simulation.history.time_s;
    let mut all: Vec<(f64, Series)> = Vec::new();
    for (number, joint) in simulation.history.joints.iter().enumerate() {
        let points: Vec<[f64; 2]> = (0..time_s.len()).map(|i| [time_s[i], value(joint, i)]).collect();
        let most = points.iter().map(|p| p[1].abs()).fold(0.0, f64::max);
        let [upper, lower] = simulation.joint_names(number);
        let name = format!("{upper} / {}", body_words(lower, language));
        all.push((most, Series { name, points }));
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.truncate(JOINTS_MOST);
    all.into_iter().map(|(_, series)| series).collect()
}
