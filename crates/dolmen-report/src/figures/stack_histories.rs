//! Histories of a simulated motion: what the ground did, where the top went, what each joint did.

use super::Figure;
use super::axis::Axis;
use super::ink::{GREY, Line, SERIES};
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Component;
use dolmen_words::Language;
use dolmen_work::stack::StackSimulation;

/// Width and height of one plot, px.
const SIZE_PX: [f64; 2] = [760.0, 210.0];
/// A line is drawn through the least and the most of each of so many stretches of time: about one a px.
const STRETCHES: usize = 700;
/// Joints drawn in one plot: those that did most. More lines are not told apart.
const JOINTS_MOST: usize = 5;

/// One line of a plot.
pub(super) struct Series {
    pub(super) name: String,
    pub(super) points: Vec<[f64; 2]>,
}

/// A line with no more points than can be seen: of each stretch the least and the most, in their order. Peaks stay.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() <= 2 * STRETCHES {
        return points.to_vec();
    }
    let mut kept = Vec::with_capacity(2 * STRETCHES + 2);
    kept.extend(points.first());
    for stretch in points.chunks(points.len().div_ceil(STRETCHES)) {
        let by = |a: &(usize, &[f64; 2]), b: &(usize, &[f64; 2])| a.1[1].total_cmp(&b.1[1]);
        let least = stretch.iter().enumerate().min_by(by);
        let most = stretch.iter().enumerate().max_by(by);
        if let (Some(least), Some(most)) = (least, most) {
            let (first, second) = if least.0 < most.0 {
                (least, most)
            } else {
                (most, least)
            };
            kept.push(*first.1);
            kept.push(*second.1);
        }
    }
    kept.extend(points.last());
    kept
}

/// A plot of some lines over time; nothing if there is no line.
pub(super) fn plot(series: &[Series], axis: Axes, language: Language, title: Titles) -> Option<String> {
    let name = say(axis, language);
    let end = series.first()?.points.last()?[0];
    let mut values: Vec<f64> = series
        .iter()
        .flat_map(|s| s.points.iter().map(|p| p[1]))
        .collect();
    values.push(0.0);
    let x = Axis::linear(say(Axes::Time, language), 0.0, end, 10);
    let mut y = Axis::around(name.as_str(), &values, 4);
    if y.to - y.from < 1e-6 {
        y = Axis::linear(name, -1.0, 1.0, 4); // nothing moved: a flat line on a scale that says so
    }
    let mut plot = Plot::new(SIZE_PX, x, y);
    plot.line(vec![[0.0, 0.0], [end, 0.0]], Line::new(GREY, 0.8));
    for (number, series) in series.iter().enumerate() {
        let line = Line::new(SERIES[number % SERIES.len()], 1.2);
        plot.line(thinned(&series.points), line);
        plot.key(Key::Line(Line { width: 2.2, ..line }), series.name.as_str());
    }
    Some(plot.svg(say(title, language)))
}

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
    /// All, in the order in which they are shown.
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
        let (series, axis, title) = match self {
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
                joint_series(simulation, |joint, sample| 1e3 * joint.opening_m[sample]),
                Axes::Opening,
                Titles::OpeningOfTheJoints,
            ),
            Self::Slip => (
                joint_series(simulation, |joint, sample| {
                    1e3 * joint.slip_m[sample][0].hypot(joint.slip_m[sample][1])
                }),
                Axes::Slip,
                Titles::SlipOfTheJoints,
            ),
            Self::Yaw => (
                joint_series(simulation, |joint, sample| 1e3 * joint.yaw_rad[sample]),
                Axes::Yaw,
                Titles::YawOfTheJoints,
            ),
        };
        plot(&series, axis, language, title)
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

/// The joints of which a value was largest, largest first.
fn joint_series(
    simulation: &StackSimulation,
    value: impl Fn(&dolmen::blocks::JointHistory, usize) -> f64,
) -> Vec<Series> {
    let time_s = &simulation.history.time_s;
    let mut all: Vec<(f64, Series)> = Vec::new();
    for (number, joint) in simulation.history.joints.iter().enumerate() {
        let points: Vec<[f64; 2]> = (0..time_s.len()).map(|i| [time_s[i], value(joint, i)]).collect();
        let most = points.iter().map(|p| p[1].abs()).fold(0.0, f64::max);
        let [upper, lower] = simulation.joint_names(number);
        let name = format!("{upper} / {lower}");
        all.push((most, Series { name, points }));
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.truncate(JOINTS_MOST);
    all.into_iter().map(|(_, series)| series).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_thinning_keeps_both_ends_and_every_peak() {
        let points: Vec<[f64; 2]> = (0..10_000)
            .map(|i| {
                [
                    f64::from(i),
                    if i == 7777 {
                        5.0
                    } else {
                        (0.1 * f64::from(i)).sin()
                    },
                ]
            })
            .collect();
        let kept = thinned(&points);
        assert!(kept.len() <= 2 * STRETCHES + 2);
        assert!(kept.contains(&[7777.0, 5.0]));
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[9999]));
        assert!(kept.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
    }
}
