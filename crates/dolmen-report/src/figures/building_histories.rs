//! Motion of a building over time.

use super::frame_histories::ground;
use super::history_series::history_series;
use super::identification::{Figure, drawn};
use super::lines::{Lines, Series};
use super::words::{Axes, Signs, Titles, say};
use dolmen::dynamics::BuildingHistory;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Component;
use dolmen_words::Language;
use dolmen_work::building::BuildingSimulation;

/// A figure of a simulated building over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BuildingPlot {
    Ground,
    /// Displacement of the top floor along x, 0, or y, 1.
    Top(usize),
    Rotation,
    BaseShear,
    Strokes,
    /// Displacement of a point of the file, 0 the first.
    Point(usize),
    /// Acceleration of a point, and of the ground.
    Acceleration(usize),
}

impl BuildingPlot {
    /// The figures of a simulation with motion, in order; none if only peaks were kept.
    pub(crate) fn all(simulation: &BuildingSimulation) -> Vec<Self> {
        if simulation.history.coordinates.columns() == 0 {
            return Vec::new();
        }
        let mut all = vec![
            Self::Ground,
            Self::Top(0),
            Self::Top(1),
            Self::Rotation,
            Self::BaseShear,
            Self::Strokes,
        ];
        all.extend((0..simulation.points.len()).flat_map(|i| [Self::Point(i), Self::Acceleration(i)]));
        // a horizontal line is not worth a figure
        all.retain(|plot| !still(&plot.series(simulation, Language::English)));
        all
    }

    fn name(self) -> String {
        match self {
            Self::Ground => "ground".to_owned(),
            Self::Top(axis) => format!("top-{}", AXES[axis]),
            Self::Rotation => "rotation".to_owned(),
            Self::BaseShear => "base-shear".to_owned(),
            Self::Strokes => "strokes".to_owned(),
            Self::Point(i) => format!("point-{}", i + 1),
            Self::Acceleration(i) => format!("acceleration-{}", i + 1),
        }
    }

    /// Its SVG; `None` without a sample.
    pub(crate) fn draw(self, simulation: &BuildingSimulation, language: Language) -> Option<String> {
        self.lines(simulation, language).draw(language)
    }

    pub(crate) fn numbers(self, simulation: &BuildingSimulation) -> Vec<crate::document::Series> {
        history_series(|language| Some(self.lines(simulation, language)))
    }

    fn lines(self, simulation: &BuildingSimulation, language: Language) -> Lines {
        let (axis, title) = self.words(simulation);
        Lines {
            axis,
            title,
            lines: self.series(simulation, language),
        }
    }

    /// The name of the axis, and the title.
    fn words(self, simulation: &BuildingSimulation) -> (Axes, Titles) {
        let acceleration = Axes::Acceleration;
        let displacement = Axes::Displacement;
        match self {
            Self::Ground => (acceleration, Titles::AccelerationOfTheGround),
            Self::Top(axis) => (displacement, Titles::TopFloorAlong(AXES[axis].to_owned())),
            Self::Rotation => (Axes::Rotation, Titles::RotationOfTheTopFloor),
            Self::BaseShear => (Axes::BaseShear, Titles::BaseShear),
            Self::Strokes => (Axes::Stroke, Titles::TravelOfTheDampers),
            Self::Point(i) => {
                let name = &simulation.points[i].name;
                let title = Titles::DisplacementOfPoint(name.clone());
                (displacement, title)
            }
            Self::Acceleration(i) => {
                let name = &simulation.points[i].name;
                let title = Titles::AccelerationOfPoint(name.clone());
                (acceleration, title)
            }
        }
    }

    fn series(self, simulation: &BuildingSimulation, language: Language) -> Vec<Series> {
        let history = &simulation.history;
        let top = 3 * (simulation.floors.len().max(1) - 1);
        match self {
            Self::Ground => acting(simulation),
            Self::Top(axis) => {
                let with = Signs::WithDampers;
                let without = Signs::WithoutDampers;
                match &simulation.without_dampers {
                    Some(other) => vec![
                        coordinate(other, top + axis, say(without, language)),
                        coordinate(history, top + axis, say(with, language)),
                    ],
                    None => vec![coordinate(history, top + axis, AXES[axis])],
                }
            }
            Self::Rotation => {
                let name = say(Signs::TopFloor, language);
                vec![coordinate(history, top + 2, name)]
            }
            Self::BaseShear => [0, 1]
                .map(|axis| {
                    let shear = |step: usize| 1e-3 * history.base[(axis, step)];
                    over_time(history, AXES[axis], shear)
                })
                .into(),
            Self::Strokes => {
                let names = simulation.stroke_names().into_iter().enumerate();
                names
                    .map(|(d, name)| coordinate(history, top + 3 + d, name))
                    .collect()
            }
            Self::Point(i) => {
                let along = &simulation.points[i].along;
                [0, 1]
                    .map(|axis| over_time(history, AXES[axis], |step| 1e3 * along[axis].displacement_m[step]))
                    .into()
            }
            Self::Acceleration(i) => {
                let along = &simulation.points[i].along;
                [0, 1]
                    .map(|axis| {
                        over_time(history, AXES[axis], |step| {
                            along[axis].acceleration_m_s2[step] / STANDARD_GRAVITY_M_S2
                        })
                    })
                    .into()
            }
        }
    }
}

const AXES: [&str; 2] = ["x", "y"];

/// The ground along each axis with motion.
fn acting(simulation: &BuildingSimulation) -> Vec<Series> {
    let motion = &simulation.motion.motion;
    let given = [Component::X, Component::Y].into_iter();
    given
        .filter(|component| motion.has(*component))
        .map(|component| Series {
            name: component.name().to_owned(),
            ..ground(motion, component)
        })
        .collect()
}

/// A coordinate of the building, mm or mrad.
fn coordinate(history: &BuildingHistory, row: usize, name: impl Into<String>) -> Series {
    over_time(history, name, |step| 1e3 * history.coordinates[(row, step)])
}

fn over_time(history: &BuildingHistory, name: impl Into<String>, value: impl Fn(usize) -> f64) -> Series {
    let steps = 0..history.length();
    Series {
        name: name.into(),
        points: steps.map(|step| [history.time_s(step), value(step)]).collect(),
    }
}

/// Whether nothing moves.
fn still(series: &[Series]) -> bool {
    let mut values = series
        .iter()
        .flat_map(|one| one.points.iter().map(|point| point[1]));
    values.all(|value| value == 0.0)
}

/// The figures of a simulation: ground, top, rotation, base shear, damper strokes, points.
pub fn building_histories(simulation: &BuildingSimulation, language: Language) -> Vec<Figure> {
    let all = BuildingPlot::all(simulation).into_iter();
    drawn(all.map(|plot| (plot.name(), plot.draw(simulation, language))))
}
